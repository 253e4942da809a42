"""Which part of the surface each place of the picture shows, and the ray through a place."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from brdf_qt.gl.lamp_handles import ray_through
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, QRectF

from brdf_suite.arrays import Floats
from brdf_suite.documents.view import Camera
from brdf_suite.realtime.pictures.comparison import sides
from brdf_suite.surface.picking import PickHit, pick
from brdf_viewer.overlay.part_layer import PartMark, mark_of
from brdf_viewer.scene.viewer_state import LoadedSurface, ViewerState
from brdf_viewer.window import ViewerWindow

_LONGEST_EDGE = 1600
"""Of the map of parts, pixels: its outlines are as sharp as the eye sees them, and it is read in a moment."""
Size = tuple[int, int]


@dataclass(frozen=True, eq=False)
class _PartMap:
    camera: Camera
    surface: LoadedSurface
    size: Size
    parts: NDArray[np.int32]


class SeenParts:
    """Looks at the picture on show."""

    def __init__(self, state: ViewerState, window: ViewerWindow) -> None:
        self._state, self._window = state, window
        self._map: _PartMap | None = None

    @property
    def boxes(self) -> list[QRectF]:
        """Where the pictures are that show the surface, as shares of the canvas: one, or two side by side."""
        whole, state = self._window.picture.device_size, self._state
        if state.view.compare.mode != "side" or state.compared is None:
            return [QRectF(0.0, 0.0, 1.0, 1.0)]
        return [QRectF(left / whole[0], 0.0, wide / whole[0], 1.0) for left, _, wide, _ in sides(whole)]

    def picture_at(self, place: QPointF) -> tuple[QRectF, QPointF]:
        """Return the picture that a place of the canvas (logical pixels) is in, and where in it, shares 0…1."""
        canvas = self._window.picture.canvas
        x, y = place.x() / max(1, canvas.width()), place.y() / max(1, canvas.height())
        box = next((box for box in self.boxes if box.left() <= x <= box.right()), self.boxes[0])
        return box, QPointF((x - box.x()) / box.width(), y)

    def size_of(self, box: QRectF) -> Size:
        """Return the size of a picture in device pixels."""
        width, height = self._window.picture.device_size
        return max(1, round(box.width() * width)), height

    def ray_at(self, place: QPointF) -> tuple[Floats, Floats]:
        """Return the eye (m) and the unit direction (3,) of what is seen at a place of the canvas."""
        box, at = self.picture_at(place)
        return ray_through(self._state.view, self._state.bounds, self.size_of(box), at)

    def hit_at(self, place: QPointF) -> PickHit | None:
        """Return what of the surface is met at a place of the canvas; None: nothing."""
        surface = self._state.surface
        return None if surface is None else pick(surface.value, *self.ray_at(place))

    def part_at(self, place: QPointF) -> str:
        """Return the name of the part at a place, looked up in the map; empty: none."""
        parts, surface = self._parts(), self._state.surface
        _, at = self.picture_at(place)
        if parts is None or surface is None or not (0.0 <= at.x() < 1.0 and 0.0 <= at.y() < 1.0):
            return ""
        rows, columns = parts.shape
        number = int(parts[int(at.y() * rows), int(at.x() * columns)])
        return "" if number < 0 else surface.value.parts[number].name

    def marks_of(self, names: list[str]) -> tuple[PartMark, ...]:
        """Return the outlines of parts as they are seen, in each picture; none where nothing is seen of them."""
        parts, surface = self._parts(), self._state.surface
        if not names or parts is None or surface is None:
            return ()
        numbers = [number for number, part in enumerate(surface.value.parts) if part.name in names]
        ratio = parts.shape[0] / max(1, self._window.picture.canvas.height())
        seen = np.isin(parts, numbers)
        marks = (mark_of(seen, box, ratio) for box in self.boxes)
        return tuple(mark for mark in marks if mark is not None)

    def _parts(self) -> NDArray[np.int32] | None:
        """Return the number of the part in each pixel of the (first) picture, drawn anew where it moved."""
        drawer, surface, view = self._window.drawer, self._state.surface, self._state.view
        if drawer is None or surface is None or not drawer.is_complete:
            return None
        size = self.size_of(self.boxes[0])
        shrink = min(1.0, _LONGEST_EDGE / max(size))
        size = max(1, round(size[0] * shrink)), max(1, round(size[1] * shrink))
        known = self._map
        if known and (known.camera, known.surface, known.size) == (view.camera, surface, size):
            return known.parts

        def read() -> None:
            self._map = _PartMap(view.camera, surface, size, drawer.probe.parts(view, size))

        self._map = None
        self._window.picture.with_context(read, redraw=False)
        found: _PartMap | None = self._map
        return None if found is None else found.parts
