"""A widget that shows what a renderer draws with OpenGL, or says why it cannot.

The widget owns the context and the frame buffer (3.3 core, multisampled, device pixels) and knows nothing of
what is drawn: a factory makes the :class:`Drawer` for a context, and again for a new context after a loss.
"""

from __future__ import annotations

import logging
import time
from collections.abc import Callable
from typing import Any, Protocol

from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtGui import QImage, QShowEvent
from PySide6.QtOpenGLWidgets import QOpenGLWidget
from PySide6.QtWidgets import QPushButton, QStackedLayout, QVBoxLayout, QWidget

from brdf_qt.fields.labels import PlainLabel
from brdf_qt.program.application import surface_format
from brdf_qt.program.core_texts import tr_core
from brdf_qt.program.translation import mark, tr
from brdf_qt.work.timer import make_timer
from brdf_suite.errors import SuiteError
from brdf_suite.realtime.gl.context import Context, adopt_context

log = logging.getLogger(__name__)

_NO_CONTEXT = mark(
    "OpenGL 3.3 is not available, so the picture cannot be shown. Update the graphics driver, "
    "or set LIBGL_ALWAYS_SOFTWARE=1 to draw in software."
)

_LOST_AGAIN = mark(
    "The graphics driver was reset several times within a minute. Close other programs that use the graphics card, "
    "update its driver, or choose a smaller environment or surface."
)
SLOW_MS = 100.0
"""A frame that takes longer, as of a software renderer, holds up what is painted with it: fields that come and go."""
_GIVE_WAY_MS = 15
"""Longer than Qt waits before it paints what has changed (5 ms)."""

_MOST_LOSSES = 3
_LOSSES_WITHIN_S = 60.0


class Drawer(Protocol):
    """What draws the picture; every call is made with its context current."""

    def draw(self, framebuffer: Any, size: tuple[int, int], view: object) -> bool:
        """Draw ``view`` into ``framebuffer`` of ``size`` (width, height) device pixels.

        Return whether the time that it took is that of a frame; False where it began with an upload, or drew
        nothing yet.
        """

    def release(self) -> None:
        """Free what was made in the context."""


class GlSurface(QWidget):
    """The picture's widget.

    ``canvas_changed(canvas)`` reports which widget gets the mouse and keys, after :meth:`retry` made a new one.

    Parameters
    ----------
    make_drawer
        Called with the context once it is there (and current), and again after :meth:`retry`.
    samples
        Samples per pixel of the frame buffer; 0 for a drawer that averages samples by itself.

    Signals: ``frame_drawn(ms, typical)`` after each frame, with the time that it took until the GPU was done and
    what :meth:`Drawer.draw` returned; ``failed(text)`` when the picture had to give way to a message;
    ``about_to_grab()`` before :meth:`grab_image` draws a frame.
    """

    frame_drawn = Signal(float, bool)
    failed = Signal(str)
    about_to_grab = Signal()
    canvas_changed = Signal(QWidget)
    _finished = Signal(float, bool)

    def __init__(
        self,
        make_drawer: Callable[[Context], Drawer],
        samples: int = 4,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._samples = samples
        self._make_drawer = make_drawer
        self._view: object = None
        self.drawer: Drawer | None = None
        """What draws in the present context; None before there is one, and after it was released."""
        self._context: Context | None = None
        self._framebuffer: Any = None
        self.failure = ""
        """Why there is no picture; empty where there is one."""
        self._losses: list[float] = []
        self.frame_ms = 0.0
        self._give_way = make_timer(self, lambda: self.canvas.update(), _GIVE_WAY_MS)
        # Queued: what listens may grab a frame, which must not happen inside the paint that it reports.
        self._finished.connect(self.frame_drawn, Qt.ConnectionType.QueuedConnection)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMinimumSize(160, 120)
        self._notice = _Notice(self.retry)
        self._layout = QStackedLayout(self)
        self._layout.addWidget(self._notice)
        self._add_canvas()

    @property
    def device_size(self) -> tuple[int, int]:
        """Width and height of the picture in device pixels."""
        size = self.canvas.size() * self.canvas.devicePixelRatioF()
        return (max(1, size.width()), max(1, size.height()))

    @property
    def is_lost(self) -> bool:
        """Whether the driver has taken the context away: it was reset, or the card changed."""
        if self.drawer is None:
            return False
        context = self.canvas.context()
        return context is None or not context.isValid()

    def set_view(self, view: object) -> None:
        """Draw ``view`` from the next frame on."""
        self._view = view
        self.redraw()

    def redraw(self, *, at_once: bool = False) -> None:
        """Draw again: something other than the view has changed. Where frames are slow, the other widgets go first.

        With ``at_once`` they do not: the picture and what is drawn over it change together.
        """
        if self.is_lost:
            self._recover()  # Qt asks a widget whose context is gone for no frame, so this is where it is noticed
        elif at_once or self.frame_ms < SLOW_MS:
            self.canvas.update()
        elif not self._give_way.isActive():
            self._give_way.start()

    def with_context(self, work: Callable[[], None], *, redraw: bool = True) -> None:
        """Run ``work`` (an upload) with the context current, and show why it failed if it does.

        ``redraw`` is False for what only reads. Without a context nothing is done: the factory will be asked for a
        drawer when there is one.
        """
        if self.failure or not self.canvas.isValid() or self.drawer is None:
            return
        self.canvas.makeCurrent()
        try:
            work()
        except Exception as error:  # noqa: BLE001 - whatever went wrong, the user must see it
            self._fail(_failure_text(error, tr("The picture could not be prepared")))
            return
        finally:
            self.canvas.doneCurrent()
        if redraw:
            self.redraw()

    def grab_image(self) -> QImage:
        """Draw a frame now and return it, in device pixels; a null image where there is no picture."""
        if self.failure or not self.canvas.isValid():
            return QImage()
        self.about_to_grab.emit()
        return self.canvas.grabFramebuffer().convertToFormat(QImage.Format.Format_RGB32)

    def retry(self) -> None:
        """Try again with a new context."""
        self.release()
        self._layout.removeWidget(self.canvas)
        self.canvas.deleteLater()
        self.failure = ""
        self._add_canvas()
        self.canvas_changed.emit(self.canvas)

    def release(self) -> None:
        """Free the drawer and all that it holds; the last thing before the widget goes."""
        if self.drawer is None:
            return
        lost = self.is_lost
        drawer, self.drawer = self.drawer, None
        self._context = self._framebuffer = None
        if lost:
            return  # all that it made went with the context
        self.canvas.makeCurrent()
        drawer.release()
        self.canvas.doneCurrent()

    def prepare(self, canvas: QOpenGLWidget) -> None:
        """Have what draws made for the canvas's new context, which is current. Failures are never raised into Qt."""
        qt_context = canvas.context()
        try:
            self._context = adopt_context(lambda name: int(qt_context.getProcAddress(name.encode()) or 0))
            self.drawer = self._make_drawer(self._context)
        except Exception as error:  # noqa: BLE001 - raised into Qt it would be lost, and the picture black
            self._defer_failure(_failure_text(error, tr("The picture cannot be drawn")))

    def draw_frame(self) -> None:
        """Draw a frame into the canvas, whose context is current. Failures are never raised into Qt."""
        if self.is_lost:
            QTimer.singleShot(0, self, self._recover)
            return
        if self.drawer is None or self._context is None or self._view is None:
            return
        start = time.perf_counter()
        size = self.device_size
        try:
            target = self._target(self._context, size)
            target.use()
            typical = self.drawer.draw(target, size, self._view)
            self._context.finish()
            problem = self._context.error
        except Exception as error:  # noqa: BLE001 - as above
            if self.is_lost:
                QTimer.singleShot(0, self, self._recover)
                return
            self._defer_failure(_failure_text(error, tr("The picture could not be drawn")))
            return
        if problem != "GL_NO_ERROR":
            self._defer_failure(
                tr("The graphics driver reported {problem} while drawing.").format(problem=problem)
            )
            return
        milliseconds = (time.perf_counter() - start) * 1000.0
        if typical:
            self.frame_ms = milliseconds
        self._finished.emit(milliseconds, typical)

    def _target(self, context: Context, size: tuple[int, int]) -> Any:
        """Return Qt's frame buffer, which changes with the size; a number that is gone must not stay bound."""
        number = self.canvas.defaultFramebufferObject()
        known = self._framebuffer
        if known is None or known.glo != number or known.size != size:
            self._framebuffer = known = context.detect_framebuffer(number)
        return known

    def _defer_failure(self, text: str) -> None:
        """Change the widgets only after Qt has finished with this paint."""
        QTimer.singleShot(0, self, lambda: self._fail(text))

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        QTimer.singleShot(0, self, self._check_context)

    def _add_canvas(self) -> None:
        self.canvas: QOpenGLWidget = _Canvas(self, self._samples)
        """The widget that gets the mouse; replaced by :meth:`retry`, see ``canvas_changed``."""
        self._layout.addWidget(self.canvas)
        self._layout.setCurrentWidget(self.canvas)
        self.setFocusProxy(self.canvas)
        if self.isVisible():
            QTimer.singleShot(0, self, self._check_context)

    def _recover(self) -> None:
        """Begin anew with another context after the driver has taken this one away; not without end."""
        if self.failure:
            return
        now = time.monotonic()
        self._losses = [*(then for then in self._losses if now - then < _LOSSES_WITHIN_S), now]
        log.warning("picture: the graphics context was lost")
        if len(self._losses) > _MOST_LOSSES:
            self._losses = []
            self._fail(tr(_LOST_AGAIN))
        else:
            self.retry()

    def _check_context(self) -> None:
        if not self.failure and self.isVisible() and not self.canvas.isValid():
            self._fail(tr(_NO_CONTEXT))

    def _fail(self, text: str) -> None:
        if self.failure:
            return
        log.error("picture: %s", text)
        self.failure = text
        self._notice.text.setText(text)
        self._layout.setCurrentWidget(self._notice)
        self.failed.emit(text)


class _Canvas(QOpenGLWidget):
    """Qt's widget with the context; what Qt asks of it, the surface does while this is its canvas."""

    def __init__(self, surface: GlSurface, samples: int) -> None:
        super().__init__(surface)
        self.setFormat(surface_format(samples))
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMouseTracking(True)
        self._surface = surface

    def initializeGL(self) -> None:
        self.context().aboutToBeDestroyed.connect(self._release)
        if self._surface.canvas is self:
            self._surface.prepare(self)

    def paintGL(self) -> None:
        if self._surface.canvas is self:
            self._surface.draw_frame()

    def _release(self) -> None:
        if self._surface.canvas is self:
            self._surface.release()


class _Notice(QWidget):
    """The message in the picture's place."""

    def __init__(self, retry: Callable[[], None]) -> None:
        super().__init__()
        self.text = PlainLabel(wordWrap=True, alignment=Qt.AlignmentFlag.AlignCenter)
        self.text.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        again = QPushButton(tr("Try again"))
        again.clicked.connect(retry)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(32, 32, 32, 32)
        layout.setSpacing(16)
        layout.addStretch()
        layout.addWidget(self.text)
        layout.addWidget(again, alignment=Qt.AlignmentFlag.AlignCenter)
        layout.addStretch()


def _failure_text(error: Exception, what: str) -> str:
    """Return the text for the user; a fault of ours goes to the log with its traceback."""
    if isinstance(error, SuiteError):
        return tr_core(str(error))
    log.error("%s", what, exc_info=error)
    return f"{what}: {error}"
