"""The three kinds of things in the view: surfaces, segments and points, each in buffers that are written again.

Calls are made with the view's context current.
"""

from __future__ import annotations

import ctypes
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from OpenGL import GL
from PySide6.QtGui import QMatrix4x4

from brdf_lobe_visualizer.view3d.gl import Arrays, Buffer, Program
from brdf_lobe_visualizer.view3d.scene import Rgba, Style
from brdf_suite.inspection.lobe_surface.surface import LobeSurface, grid_faces

_STYLES: dict[Style, int] = {"solid": 0, "glass": 1, "lines": 2}

_SEGMENT = np.dtype(
    [("start", "f4", 3), ("end", "f4", 3), ("widths", "f4", 2), ("colour", "f4", 4)], align=False
)
_POINT = np.dtype([("point", "f4", 3), ("colour", "f4", 4)], align=False)


@dataclass(frozen=True)
class Sight:
    """From where things are seen: matrices, the viewport in device pixels, and device pixels per pixel."""

    to_clip: QMatrix4x4
    to_eye: QMatrix4x4
    viewport: tuple[float, float]
    ratio: float


class SurfaceItem:
    """A lobe surface on the card."""

    def __init__(self) -> None:
        self._arrays = Arrays()
        self._points, self._normals, self._colours = Buffer(), Buffer(), Buffer()
        self._faces = Buffer(GL.GL_ELEMENT_ARRAY_BUFFER)
        self._shape: tuple[int, int] | None = None
        self._count = 0
        self._whole = False
        self.surface: LobeSurface | None = None
        self._arrays.bind()
        self._arrays.feed(0, self._points, 3)
        self._arrays.feed(1, self._normals, 3)
        self._arrays.feed(2, self._colours, 3, bytes_=True)

    def write(self, surface: LobeSurface) -> None:
        """Hand a surface to the card; faces only where they are others, for most are the whole grid's."""
        if surface is self.surface:
            return
        self._arrays.bind()
        self._points.write(surface.points)
        self._normals.write(surface.normals)
        self._colours.write(surface.colours)
        whole = surface.holes == 0
        if not (whole and self._whole and surface.shape == self._shape):
            faces = grid_faces(*surface.shape) if whole else surface.faces
            self._faces.write(faces)
            self._count = faces.size
        self._whole, self._shape, self.surface = whole, surface.shape, surface

    def draw(
        self, program: Program, sight: Sight, style: Style, opacity: float, tint: Rgba, order: int = 0
    ) -> None:
        """Draw it; what is like glass hides its own far side. ``order``: its place among what is see-through."""
        if self._shape is None or not self._count:
            return
        self._arrays.bind()
        self._faces.bind()
        program.use()
        program.set(
            to_clip=sight.to_clip,
            to_eye=sight.to_eye,
            columns=self._shape[1],
            style=_STYLES[style],
            opacity=float(opacity),
            tint=tint,
            line_steps=(6.0, 16.0),
            line_width=1.3 * sight.ratio,
        )
        GL.glEnable(GL.GL_DEPTH_TEST)
        GL.glDepthFunc(GL.GL_LEQUAL)
        if style == "solid":
            GL.glDisable(GL.GL_BLEND)
            GL.glEnable(GL.GL_POLYGON_OFFSET_FILL)
            # A fit that lies on its target, and points on a surface, are to be seen.
            GL.glPolygonOffset(1.0, 2.0)
            self._elements()
            GL.glDisable(GL.GL_POLYGON_OFFSET_FILL)
            return
        # Shells that all but touch: the outer one is the later one, and nearer.
        GL.glEnable(GL.GL_POLYGON_OFFSET_FILL)
        GL.glPolygonOffset(-0.5 * order, -4.0 * order)
        GL.glEnable(GL.GL_BLEND)
        GL.glBlendFuncSeparate(
            GL.GL_SRC_ALPHA, GL.GL_ONE_MINUS_SRC_ALPHA, GL.GL_ONE, GL.GL_ONE_MINUS_SRC_ALPHA
        )
        if style == "glass":
            GL.glColorMask(False, False, False, False)
            self._elements()
            GL.glColorMask(True, True, True, True)
            self._elements()
        else:
            self._elements()
        GL.glDisable(GL.GL_POLYGON_OFFSET_FILL)

    def _elements(self) -> None:
        GL.glDrawElements(GL.GL_TRIANGLES, self._count, GL.GL_UNSIGNED_INT, ctypes.c_void_p(0))

    def free(self) -> None:
        """Give its memory back."""
        for buffer in (self._points, self._normals, self._colours, self._faces):
            buffer.free()
        self._arrays.free()


def segments(
    start: npt.ArrayLike, end: npt.ArrayLike, widths: npt.ArrayLike, colour: Rgba
) -> npt.NDArray[np.void]:
    """Return segments from ``start`` to ``end`` (n, 3), with the widths at both (2,) in pixels."""
    start, end = np.atleast_2d(np.asarray(start, np.float32)), np.atleast_2d(np.asarray(end, np.float32))
    rows = np.zeros(len(start), _SEGMENT)
    rows["start"], rows["end"], rows["widths"], rows["colour"] = start, end, widths, colour
    return rows


def polyline(points: npt.ArrayLike, width: float, colour: Rgba) -> npt.NDArray[np.void]:
    """Return the segments between neighbouring points (n, 3)."""
    points = np.asarray(points, np.float32)
    return segments(points[:-1], points[1:], (width, width), colour)


class SegmentItem:
    """Segments on the card."""

    def __init__(self) -> None:
        self._arrays, self._buffer, self._rows = Arrays(), Buffer(), np.zeros(0, _SEGMENT)
        self._written: object = None
        self._ratio = 0.0
        self._arrays.bind()
        for place, (name, count) in enumerate((("start", 3), ("end", 3), ("widths", 2), ("colour", 4))):
            offset = int(_SEGMENT.fields[name][1]) if _SEGMENT.fields is not None else 0
            self._arrays.feed(
                place, self._buffer, count, stride=_SEGMENT.itemsize, offset=offset, instanced=True
            )

    def draw(
        self, program: Program, sight: Sight, rows: npt.NDArray[np.void], *, behind: bool = True
    ) -> None:
        """Draw ``rows``; with ``behind`` surfaces before them hide them."""
        if not len(rows):
            return
        self._arrays.bind()
        if rows is not self._written or sight.ratio != self._ratio:
            scaled = rows.copy()
            scaled["widths"] *= sight.ratio
            self._buffer.write(scaled)
            self._written, self._ratio = rows, sight.ratio
        program.use()
        program.set(to_clip=sight.to_clip, viewport=sight.viewport)
        _blended(behind)
        GL.glDrawArraysInstanced(GL.GL_TRIANGLE_STRIP, 0, 4, len(rows))
        GL.glDepthMask(True)

    def free(self) -> None:
        """Give its memory back."""
        self._buffer.free()
        self._arrays.free()


def points(places: npt.ArrayLike, colour: npt.ArrayLike) -> npt.NDArray[np.void]:
    """Return points at ``places`` (n, 3) with colours (n, 4) or (4,), 0 to 1."""
    places = np.atleast_2d(np.asarray(places, np.float32))
    rows = np.zeros(len(places), _POINT)
    rows["point"], rows["colour"] = places, colour
    return rows


class PointItem:
    """Points on the card."""

    def __init__(self) -> None:
        self._arrays, self._buffer = Arrays(), Buffer()
        self._written: object = None
        self._arrays.bind()
        self._arrays.feed(0, self._buffer, 3, stride=_POINT.itemsize)
        self._arrays.feed(1, self._buffer, 4, stride=_POINT.itemsize, offset=12)

    def draw(
        self,
        program: Program,
        sight: Sight,
        rows: npt.NDArray[np.void],
        size: float,
        rim: Rgba,
        *,
        behind: bool = True,
        opacity: float = 1.0,
    ) -> None:
        """Draw ``rows`` as discs of ``size`` pixels with a rim; with ``behind`` surfaces before them hide them."""
        if not len(rows):
            return
        self._arrays.bind()
        if rows is not self._written:
            self._buffer.write(rows)
            self._written = rows
        program.use()
        program.set(to_clip=sight.to_clip, size=float(size * sight.ratio), rim=rim, opacity=float(opacity))
        GL.glEnable(GL.GL_PROGRAM_POINT_SIZE)
        _blended(behind)
        GL.glDrawArrays(GL.GL_POINTS, 0, len(rows))
        GL.glDepthMask(True)

    def free(self) -> None:
        """Give its memory back."""
        self._buffer.free()
        self._arrays.free()


def _blended(behind: bool) -> None:
    GL.glEnable(GL.GL_BLEND)
    GL.glBlendFuncSeparate(GL.GL_SRC_ALPHA, GL.GL_ONE_MINUS_SRC_ALPHA, GL.GL_ONE, GL.GL_ONE_MINUS_SRC_ALPHA)
    if behind:
        GL.glEnable(GL.GL_DEPTH_TEST)
        GL.glDepthFunc(GL.GL_LEQUAL)
    else:
        GL.glDisable(GL.GL_DEPTH_TEST)
    # What is see-through hides nothing.
    GL.glDepthMask(False)
