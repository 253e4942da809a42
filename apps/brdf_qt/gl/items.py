"""Segments and discs for :class:`brdf_qt.gl.space.SpaceView`, as items of pyqtgraph with shaders of our own.

Buffers, states and calls are those of pyqtgraph's items. Their shaders are not used, for what they draw is not as good:
in a core profile (all that macOS has past OpenGL 2.1) their lines are one device pixel wide whatever is asked, and
do not taper; their discs have jagged edges, no rim, and a size in device pixels.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
from OpenGL import GL
from OpenGL.GL import shaders
from pyqtgraph.opengl import GLLinePlotItem, GLScatterPlotItem  # pyqtgraph has no types
from PySide6.QtGui import QMatrix4x4
from PySide6.QtOpenGL import QOpenGLBuffer

from brdf_qt.gl.segments import Rgba, Segments
from brdf_suite.errors import GraphicsError

_SHADERS = Path(__file__).parent / "shaders"
_KINDS = {"vert": GL.GL_VERTEX_SHADER, "geom": GL.GL_GEOMETRY_SHADER, "frag": GL.GL_FRAGMENT_SHADER}
_BLENDED = {
    GL.GL_BLEND: True,
    "glBlendFuncSeparate": (GL.GL_SRC_ALPHA, GL.GL_ONE_MINUS_SRC_ALPHA, GL.GL_ONE, GL.GL_ONE_MINUS_SRC_ALPHA),
    "glDepthFunc": (GL.GL_LEQUAL,),
    "glDepthMask": (False,),  # what is see-through hides nothing
}
BEHIND = {**_BLENDED, GL.GL_DEPTH_TEST: True}
"""GL options of what surfaces hide."""
BEFORE = {**_BLENDED, GL.GL_DEPTH_TEST: False}
"""GL options of what nothing hides."""
OPAQUE = {
    GL.GL_DEPTH_TEST: True,
    GL.GL_BLEND: False,
    GL.GL_SAMPLE_ALPHA_TO_COVERAGE: True,
    GL.GL_SAMPLE_ALPHA_TO_ONE: True,
    "glDepthFunc": (GL.GL_LEQUAL,),
    "glDepthMask": (True,),
}
"""GL options of discs that hide one another in any order: edges are smooth by the samples that they cover."""


def compile_program(folder: Path, name: str) -> Any:
    """Return the program of ``NAME.vert.glsl``, ``NAME.frag.glsl`` and, where there is one, ``NAME.geom.glsl``.

    Raises :class:`GraphicsError` with what the driver says.
    """
    files = [(folder / f"{name}.{ending}.glsl", kind) for ending, kind in _KINDS.items()]
    try:
        parts = [
            shaders.compileShader(file.read_text("utf-8"), kind) for file, kind in files if file.is_file()
        ]
        return shaders.compileProgram(*parts, validate=False)
    except RuntimeError as error:
        raise GraphicsError(f"shaders of {name}: {error}") from None


def set_uniforms(program: Any, **values: float | tuple[float, ...] | QMatrix4x4) -> None:
    """Set uniforms of a program that is in use: integers, numbers, tuples of 2 or 4 numbers, matrices."""
    for name, value in values.items():
        place = GL.glGetUniformLocation(program, name)
        if isinstance(value, QMatrix4x4):
            GL.glUniformMatrix4fv(place, 1, False, np.array(value.data(), np.float32))
        elif isinstance(value, tuple):
            (GL.glUniform2f if len(value) == 2 else GL.glUniform4f)(place, *value)
        else:
            (GL.glUniform1i if isinstance(value, int) else GL.glUniform1f)(place, value)


def write_buffer(buffer: Any, array: npt.NDArray[Any]) -> None:
    """Put an array's bytes into a QOpenGLBuffer: memory is asked for once for a size, and written again after that.

    PySide6 takes arrays there, which its types do not say.
    """
    if not buffer.isCreated():
        buffer.create()
    buffer.bind()
    array = np.ascontiguousarray(array)
    if buffer.size() != array.nbytes:
        buffer.allocate(array, array.nbytes)
    else:
        buffer.write(0, array, array.nbytes)


class SegmentItem(GLLinePlotItem):  # type: ignore[misc]  # pyqtgraph has no types
    """Segments of any widths, also tapering, with smooth edges; surfaces hide them."""

    def __init__(self) -> None:
        super().__init__(mode="lines", glOptions=BEHIND)
        self._buffer = QOpenGLBuffer(QOpenGLBuffer.Type.VertexBuffer)
        self._widths: npt.NDArray[np.float32] | None = None

    def set_segments(self, rows: Segments) -> None:
        """Show ``rows`` from the next frame on."""
        self._widths = rows["widths"].ravel()
        self.setData(pos=rows["ends"].reshape(-1, 3), color=np.repeat(rows["colour"], 2, axis=0))

    def getShaderProgram(self) -> Any:
        return self.view().program(_SHADERS, "segment")

    def paint(self) -> None:
        if self.pos is None or not len(self.pos):
            return
        if self._widths is not None:
            write_buffer(self._buffer, self._widths)
            self._widths = None
        self._buffer.bind()
        GL.glVertexAttribPointer(2, 1, GL.GL_FLOAT, False, 0, None)
        GL.glEnableVertexAttribArray(2)
        program = self.getShaderProgram()
        with program:
            set_uniforms(program, viewport=self.view().viewport, ratio=self.view().ratio)
        super().paint()
        GL.glDisableVertexAttribArray(2)


class DiscItem(GLScatterPlotItem):  # type: ignore[misc]  # pyqtgraph has no types
    """Discs of a size in logical pixels with smooth edges and a rim; ``shine``: how much shows through surfaces."""

    def __init__(self, options: dict[Any, Any], rim: Rgba = (0.0, 0.0, 0.0, 0.0), shine: float = 0.0) -> None:
        super().__init__(glOptions=options)
        self.rim, self._shine = rim, shine

    def getShaderProgram(self) -> Any:
        return self.view().program(_SHADERS, "disc")

    def paint(self) -> None:
        if self.pos is None or not len(self.pos):
            return
        if self._shine:
            self.updateGLOptions({GL.GL_DEPTH_TEST: False})
            self._paint(self._shine)
            self.updateGLOptions({GL.GL_DEPTH_TEST: True})
        self._paint(1.0)

    def _paint(self, opacity: float) -> None:
        program = self.getShaderProgram()
        with program:
            set_uniforms(program, rim=self.rim, opacity=opacity, ratio=self.view().ratio)
        super().paint()
