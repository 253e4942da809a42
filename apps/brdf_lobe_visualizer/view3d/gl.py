"""What the view draws with OpenGL: buffers that are kept and written again, and the programs of its shaders.

pyqtgraph's own mesh item makes new arrays of every vertex and face for each change: from ``setMeshData`` with smooth
normals to the picture it takes 0.5 s for the lobe's grid of 32,896 points, where drawing alone takes 0.03 s (pyqtgraph
0.14, two cores, drawn in software). Here points, normals and colours go as they are into buffers that are made once.
"""

from __future__ import annotations

import ctypes
from pathlib import Path

import numpy as np
import numpy.typing as npt
from OpenGL import GL
from PySide6.QtGui import QMatrix4x4
from PySide6.QtOpenGL import QOpenGLShader, QOpenGLShaderProgram, QOpenGLVertexArrayObject

from brdf_suite.errors import GraphicsError

_SHADERS = Path(__file__).parent / "shaders"


class Program:
    """A vertex and a fragment shader of one name, from their files."""

    def __init__(self, name: str) -> None:
        self._program = QOpenGLShaderProgram()
        kinds = QOpenGLShader.ShaderTypeBit
        for kind, ending in ((kinds.Vertex, "vert"), (kinds.Fragment, "frag")):
            file = _SHADERS / f"{name}.{ending}.glsl"
            source = file.read_text("utf-8")
            # The language asks for the version first; the file says first what it is for.
            version = "#version 330 core\n"
            text = version + source.replace(version, "\n", 1)
            if not self._program.addShaderFromSourceCode(kind, text):
                raise GraphicsError(f"{file.name}: {self._program.log().strip()}")
        if not self._program.link():
            raise GraphicsError(f"{name}: {self._program.log().strip()}")
        self._number = self._program.programId()
        self._places: dict[str, int] = {}

    def use(self) -> None:
        """Draw with it from here on."""
        GL.glUseProgram(self._number)

    def set(self, **values: object) -> None:
        """Set uniforms: numbers, integers, tuples of 2 or 4 numbers, matrices."""
        for name, value in values.items():
            place = self._places.get(name)
            if place is None:
                place = self._places[name] = int(GL.glGetUniformLocation(self._number, name))
            if isinstance(value, QMatrix4x4):
                GL.glUniformMatrix4fv(place, 1, False, np.array(value.data(), np.float32))
            elif isinstance(value, int):
                GL.glUniform1i(place, value)
            elif isinstance(value, float):
                GL.glUniform1f(place, value)
            elif isinstance(value, tuple) and len(value) == 2:
                GL.glUniform2f(place, *value)
            elif isinstance(value, tuple) and len(value) == 4:
                GL.glUniform4f(place, *value)
            else:
                raise TypeError(f"{name} of a shader cannot be {value!r}")


class Buffer:
    """Memory of the card: made once for a size, written again for every change."""

    def __init__(self, target: int = GL.GL_ARRAY_BUFFER) -> None:
        self._target = target
        self._number = int(GL.glGenBuffers(1))
        self.size = 0

    def write(self, array: npt.NDArray[np.generic]) -> None:
        """Put the array's bytes there."""
        GL.glBindBuffer(self._target, self._number)
        array = np.ascontiguousarray(array)
        if array.nbytes != self.size:
            GL.glBufferData(self._target, array.nbytes, array, GL.GL_DYNAMIC_DRAW)
            self.size = array.nbytes
        else:
            GL.glBufferSubData(self._target, 0, array.nbytes, array)

    def bind(self) -> None:
        """Make it the one that calls mean."""
        GL.glBindBuffer(self._target, self._number)

    def free(self) -> None:
        """Give it back."""
        GL.glDeleteBuffers(1, [self._number])


class Arrays:
    """Which buffers feed which inputs of a program: a vertex array object."""

    def __init__(self) -> None:
        self._object = QOpenGLVertexArrayObject()
        if not self._object.create():
            raise GraphicsError("The graphics driver made no vertex array.")

    def bind(self) -> None:
        """Draw from it from here on."""
        self._object.bind()

    def feed(
        self,
        place: int,
        buffer: Buffer,
        count: int,
        *,
        bytes_: bool = False,
        stride: int = 0,
        offset: int = 0,
        instanced: bool = False,
    ) -> None:
        """Let input ``place`` take ``count`` numbers a vertex, or an instance, from ``buffer``."""
        buffer.bind()
        kind = GL.GL_UNSIGNED_BYTE if bytes_ else GL.GL_FLOAT
        GL.glVertexAttribPointer(place, count, kind, bytes_, stride, ctypes.c_void_p(offset))
        GL.glEnableVertexAttribArray(place)
        GL.glVertexAttribDivisor(place, int(instanced))

    def free(self) -> None:
        """Give it back."""
        self._object.destroy()
