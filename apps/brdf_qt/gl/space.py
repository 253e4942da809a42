"""A view in three dimensions on pyqtgraph's, for the Lobe Visualizer and for Color Swatch's map.

The camera's matrices, the items and their order are pyqtgraph's. Added are: words painted over the picture, errors that
are reported instead of printed, and what a view needs that is moved to another window and gets another context there.
"""

from __future__ import annotations

import logging
import time
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
from OpenGL import GL
from pyqtgraph.opengl import GLViewWidget  # pyqtgraph has no types
from PySide6.QtCore import QRectF, QSize, Qt, QTimer, Signal
from PySide6.QtGui import QMatrix4x4, QPainter
from PySide6.QtOpenGL import QOpenGLPaintDevice, QOpenGLVertexArrayObject
from PySide6.QtWidgets import QWidget

from brdf_qt.gl.items import compile_program
from brdf_qt.program.application import surface_format
from brdf_qt.program.core_texts import tr_core
from brdf_suite.arrays import Floats
from brdf_suite.errors import SuiteError

log = logging.getLogger(__name__)

Region = tuple[int, int, int, int]
"""Left, bottom, width and height in device pixels."""


class SpaceView(GLViewWidget):  # type: ignore[misc]  # pyqtgraph has no types
    """The view; who derives from it has :meth:`make_items` and :meth:`paint_words`.

    Signals: ``failed(reason)`` where nothing can be drawn, ``drawn(ms)`` after each frame.
    """

    failed = Signal(str)
    drawn = Signal(float)
    _drawing = False  # pyqtgraph's constructor asks for a frame already

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setFormat(surface_format(4))
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMouseTracking(True)
        self.ratio = 1.0
        """Device pixels a logical one, in the picture that is drawn now."""
        self.viewport = (0.0, 0.0, 1.0, 1.0)
        """Left, bottom, width and height in device pixels of what is drawn now, in the frame buffer."""
        self._programs: dict[tuple[Path, str], Any] = {}
        self._has_context = False
        self._failure = ""

    def update(self) -> None:
        """Request another frame; nothing while one is drawn, whose items are given then what they show."""
        if not self._drawing:
            super().update()

    def make_items(self) -> None:
        """Add the items with all that they show: once at first, and again for each other context."""

    def paint_words(self, painter: QPainter, size: QSize) -> None:
        """Paint over a picture of ``size`` logical pixels."""

    def program(self, folder: Path, name: str) -> Any:
        """Return the program of :func:`compile_program` in the current context, compiled at its first use."""
        if (folder, name) not in self._programs:
            self._programs[folder, name] = compile_program(folder, name)
        return self._programs[folder, name]

    def initializeGL(self) -> None:
        # Programs and buffers belong to a context, which is another one where a panel was floated or docked.
        self._programs.clear()
        self._failure = ""
        try:
            if self._has_context:
                self.clear()
                self.default_vao = QOpenGLVertexArrayObject(self)
                self.make_items()
            self._has_context = True
            super().initializeGL()
        except Exception as error:  # noqa: BLE001 - raised into Qt it would be lost, and the picture black
            self._fail(error)

    def resizeGL(self, width: int, height: int) -> None:
        """Nothing depends on the size but what every frame asks anew."""

    def paintGL(self) -> None:
        if self._failure:
            return
        start = time.perf_counter()
        size = QSize(self.deviceWidth(), self.deviceHeight())
        self.ratio = self.devicePixelRatioF()
        whole = (0, 0, size.width(), size.height())
        try:
            self.paint(region=whole, viewport=whole)
            # Not on the widget itself, which a picture of the window (QWidget.grab) sends elsewhere.
            device = QOpenGLPaintDevice(size)
            device.setDevicePixelRatio(self.ratio)
            painter = QPainter(device)
            try:
                self.paint_words(painter, self.size())
            finally:
                painter.end()
        except Exception as error:  # noqa: BLE001 - as above
            self._fail(error)
            return
        self.drawn.emit((time.perf_counter() - start) * 1e3)

    def paint(self, *, region: Region, viewport: Region, **_pick: object) -> None:
        """Draw ``region`` of a picture as large as ``viewport`` into the bound frame buffer."""
        GL.glDepthMask(True)
        GL.glColorMask(True, True, True, True)
        for state in (GL.GL_SCISSOR_TEST, GL.GL_CULL_FACE, GL.GL_STENCIL_TEST):
            GL.glDisable(state)
        GL.glEnable(GL.GL_MULTISAMPLE)
        GL.glClearColor(*self.opts["bgcolor"])
        GL.glClear(GL.GL_COLOR_BUFFER_BIT | GL.GL_DEPTH_BUFFER_BIT)
        self._drawing = True
        try:
            self.draw_picture(region, viewport)
        finally:
            self._drawing = False
        GL.glUseProgram(0)
        GL.glDepthMask(True)
        for state in (
            GL.GL_DEPTH_TEST,
            GL.GL_BLEND,
            GL.GL_PROGRAM_POINT_SIZE,
            GL.GL_SAMPLE_ALPHA_TO_COVERAGE,
            GL.GL_SAMPLE_ALPHA_TO_ONE,
            GL.GL_POLYGON_OFFSET_FILL,
        ):
            GL.glDisable(state)

    def draw_picture(self, region: Region, viewport: Region) -> None:
        """Draw all items, from one camera."""
        (x, y, wide, high), (left, bottom, width, height) = region, viewport
        self.draw_items(self.items, (0, 0, wide, high), (left - x, bottom - y, width, height))

    def draw_items(self, items: Iterable[Any], region: Region, viewport: Region) -> None:
        """Draw items into ``region`` of the frame buffer, of a picture that would cover ``viewport`` of it.

        The order is that of their depth values. What goes wrong is raised, not printed as pyqtgraph does.
        """
        GL.glViewport(*region)
        x, y, wide, high = region
        self.viewport = float(x), float(y), float(wide), float(high)
        self.setProjection(region, viewport)
        self.setModelview()
        for item in sorted(items, key=lambda item: float(item.depthValue())):
            if item.visible():
                self.default_vao.bind()
                item.paint()

    def _fail(self, error: Exception) -> None:
        if not isinstance(error, SuiteError):
            log.error("the view in three dimensions", exc_info=error)
        self._failure = tr_core(str(error)) or type(error).__name__
        QTimer.singleShot(0, self, lambda: self.failed.emit(self._failure))


def project(matrix: QMatrix4x4, places: npt.ArrayLike, room: QRectF) -> tuple[Floats, Floats]:
    """Return where places (..., 3) lie in ``room`` (..., 2), NaN behind the eye, and how far before it they are (...).

    ``matrix`` leads to the clip coordinates of the room.
    """
    rows = np.array(matrix.copyDataTo()).reshape(4, 4)
    clip = np.asarray(places, float) @ rows[:, :3].T + rows[:, 3]
    depth = clip[..., 3]
    shares = clip[..., :2] / np.where(depth > 1e-4, depth, np.nan)[..., None]
    x = room.left() + 0.5 * (1.0 + shares[..., 0]) * room.width()
    y = room.top() + 0.5 * (1.0 - shares[..., 1]) * room.height()
    return np.stack((x, y), axis=-1), depth
