"""A lobe surface in the view: solid, like glass, or as the lines of its grid.

pyqtgraph's own mesh item makes new arrays of every vertex and face for each change: from ``setMeshData`` with smooth
normals to the picture it takes 0.5 s for the lobe's grid of 32,896 points, where drawing alone takes 0.03 s (pyqtgraph
0.14, two cores, drawn in software). Here points, normals and colours go as they are into buffers that are made once.
"""

from __future__ import annotations

from pathlib import Path

from brdf_qt.gl.items import BEHIND, set_uniforms, write_buffer
from brdf_qt.gl.segments import Rgba
from OpenGL import GL
from pyqtgraph.opengl.GLGraphicsItem import GLGraphicsItem  # pyqtgraph has no types
from PySide6.QtOpenGL import QOpenGLBuffer

from brdf_lobe_visualizer.view3d.frame import Layer, Style
from brdf_suite.inspection.lobe_surface.surface import LobeSurface, grid_faces

_SHADERS = Path(__file__).parent / "shaders"
_STYLES: dict[Style, int] = {"solid": 0, "glass": 1, "lines": 2}
_SOLID = {
    GL.GL_DEPTH_TEST: True,
    GL.GL_BLEND: False,
    GL.GL_POLYGON_OFFSET_FILL: True,
    "glDepthFunc": (GL.GL_LEQUAL,),
    "glDepthMask": (True,),
    # A fit that lies on its target, and points on a surface, are to be seen.
    "glPolygonOffset": (1.0, 2.0),
}
SOLID_DEPTH, FRAME_DEPTH, POINTS_DEPTH, SHELL_DEPTH, ARROWS_DEPTH, HANDLE_DEPTH = range(0, 600, 100)
"""In which order things are drawn; shells by their place among what is see-through."""


class LobeItem(GLGraphicsItem):  # type: ignore[misc]  # pyqtgraph has no types
    """Shows one layer of a panel; its buffers are written again for each surface."""

    def __init__(self) -> None:
        super().__init__()
        self._inputs = [QOpenGLBuffer(QOpenGLBuffer.Type.VertexBuffer) for _ in range(3)]
        self._faces = QOpenGLBuffer(QOpenGLBuffer.Type.IndexBuffer)
        self._count = 0
        self._layer: Layer | None = None
        self._written: LobeSurface | None = None
        self._tint: Rgba = (0.0, 0.0, 0.0, 0.0)

    def set_layer(self, layer: Layer, order: int, ink: Rgba) -> None:
        """Show ``layer``; ``order``: its place among the layers of its panel, ``ink``: the theme's colour of text."""
        self._layer, self._tint = layer, (*ink[:3], float(layer.ink))
        if layer.style == "solid":
            self.setGLOptions(_SOLID)
            self.setDepthValue(SOLID_DEPTH)
            return
        # Shells that all but touch: the outer one is the later one, and nearer. They hide their own far side.
        offset = {GL.GL_POLYGON_OFFSET_FILL: True, "glPolygonOffset": (-0.5 * order, -4.0 * order)}
        self.setGLOptions({**BEHIND, **offset, "glDepthMask": (True,)})
        self.setDepthValue(SHELL_DEPTH + order)

    def upload(self) -> None:
        """Hand the surface to the card, with its context current; faces only where they are not the same ones."""
        assert self._layer is not None, "items are made for a layer"
        surface, before = self._layer.surface, self._written
        if surface is before:
            return
        write_buffer(self._inputs[0], surface.points)
        write_buffer(self._inputs[1], surface.normals)
        write_buffer(self._inputs[2], surface.colours)
        if before is None or surface.holes or before.holes or surface.shape != before.shape:
            faces = surface.faces if surface.holes else grid_faces(*surface.shape)
            write_buffer(self._faces, faces)
            self._count = faces.size
        self._written = surface

    def paint(self) -> None:
        assert self._layer is not None, "items are made for a layer"
        self.upload()
        if not self._count:
            return
        self.setupGLState()
        layer, program = self._layer, self.view().program(_SHADERS, "surface")
        for place, buffer in enumerate(self._inputs):
            buffer.bind()
            kind = GL.GL_UNSIGNED_BYTE if place == 2 else GL.GL_FLOAT
            GL.glVertexAttribPointer(place, 3, kind, place == 2, 0, None)
            GL.glEnableVertexAttribArray(place)
        self._faces.bind()
        with program:
            set_uniforms(
                program,
                to_clip=self.mvpMatrix(),
                to_eye=self.modelViewMatrix(),
                columns=layer.surface.shape[1],
                style=_STYLES[layer.style],
                opacity=float(layer.opacity),
                tint=self._tint,
                line_steps=(6.0, 16.0),
                line_width=1.3 * self.view().ratio,
            )
            if layer.style == "glass":
                GL.glColorMask(False, False, False, False)
                GL.glDrawElements(GL.GL_TRIANGLES, self._count, GL.GL_UNSIGNED_INT, None)
                GL.glColorMask(True, True, True, True)
            GL.glDrawElements(GL.GL_TRIANGLES, self._count, GL.GL_UNSIGNED_INT, None)
        for place in range(3):
            GL.glDisableVertexAttribArray(place)
        GL.glDisable(GL.GL_POLYGON_OFFSET_FILL)
