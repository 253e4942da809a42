"""Mesh value: named parts of indexed triangles, with a material word each.

Metres, world axes (right-handed, ``y`` up, front along ``+z``), triangles counter-clockwise seen from
outside. Texture coordinates are lengths on the surface in **millimetres**, since flakes are counted per
square millimetre. The material word names the material of a part for the renderer; only ``paint`` takes the paint
being edited.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from brdf_suite.arrays import AnyIntegers, Reals
from brdf_suite.documents.view_settings import MATERIALS
from brdf_suite.errors import ValueRangeError

# Any width is accepted and converted; what a Part holds is float32 and uint32.

_T = TypeVar("_T", bound=np.generic)

_NORMAL_TOLERANCE = 1e-3


@dataclass(frozen=True, eq=False)
class PartGeometry:
    """One part of a mesh. Arrays are converted to the types below, checked, and kept read-only.

    Attributes
    ----------
    name
        What the part is called, not empty; errors name it.
    material
        One of :data:`MATERIALS`.
    positions
        (n, 3) float32, metres, finite.
    normals
        (n, 3) float32, unit length to 1e-3, outwards.
    uvs
        (n, 2) float32, millimetres on the surface, finite.
    triangles
        (k, 3) uint32, k ≥ 1, indices below n.

    Raises
    ------
    ValueRangeError
        A wrong shape, type, index or number; the message names the part and the array.
    """

    name: str
    material: str
    positions: Reals
    normals: Reals
    uvs: Reals
    triangles: AnyIntegers

    def __post_init__(self) -> None:
        if not self.name:
            raise ValueRangeError("part", "the name is empty")
        if self.material not in MATERIALS:
            known = ", ".join(MATERIALS)
            raise ValueRangeError(self._place("material"), f"{self.material!r} is none of {known}")
        for field, width in (("positions", 3), ("normals", 3), ("uvs", 2)):
            object.__setattr__(self, field, self._floats(field, width))
        object.__setattr__(self, "triangles", self._indices())
        if not len(self.positions) == len(self.normals) == len(self.uvs):
            counts = f"{len(self.positions)}, {len(self.normals)} and {len(self.uvs)}"
            reason = f"{counts} positions, normals and uvs, which must be equal in number"
            raise ValueRangeError(self._place("positions"), reason)
        length = np.sqrt(np.einsum("ij,ij->i", self.normals, self.normals))
        bad = np.flatnonzero(np.abs(length - 1.0) > _NORMAL_TOLERANCE)
        if bad.size:
            raise ValueRangeError(self._place(f"normals[{bad[0]}]"), f"length {length[bad[0]]:.4g}, not 1")

    def bounds(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Return the lowest and the highest corner, (3,) each, metres, of the vertices that triangles use."""
        is_used = np.zeros(len(self.positions), bool)
        is_used[self.triangles.ravel()] = True
        used = self.positions[is_used].astype(np.float64)
        return used.min(axis=0), used.max(axis=0)

    def _place(self, field: str) -> str:
        return f"part {self.name!r}, {field}"

    def _floats(self, field: str, width: int) -> NDArray[np.float32]:
        given: ArrayLike = getattr(self, field)
        array = np.asarray(given)
        if array.dtype.kind not in "fiu":
            raise ValueRangeError(self._place(field), f"type {array.dtype}, not real numbers")
        if array.ndim != 2 or array.shape[1] != width or array.shape[0] < 3:
            reason = f"shape {array.shape}, not (n, {width}) with n of at least 3"
            raise ValueRangeError(self._place(field), reason)
        largest = np.finfo(np.float32).max
        if not -largest <= array.min() <= array.max() <= largest:  # NaN is in neither
            bad = np.flatnonzero(~(np.abs(array) <= largest).all(axis=1))
            raise ValueRangeError(self._place(f"{field}[{bad[0]}]"), "not a finite single-precision number")
        return _read_only(array, np.float32)

    def _indices(self) -> NDArray[np.uint32]:
        array = np.asarray(self.triangles)
        if array.dtype.kind not in "iu":
            raise ValueRangeError(self._place("triangles"), f"type {array.dtype}, not integers")
        if array.ndim != 2 or array.shape[1] != 3 or array.shape[0] < 1:
            reason = f"shape {array.shape}, not (k, 3) with k of at least 1"
            raise ValueRangeError(self._place("triangles"), reason)
        if not 0 <= array.min() <= array.max() < len(self.positions):
            bad = np.flatnonzero((array < 0).any(axis=1) | (array >= len(self.positions)).any(axis=1))
            reason = f"an index outside 0 to {len(self.positions) - 1}"
            raise ValueRangeError(self._place(f"triangles[{bad[0]}]"), reason)
        return _read_only(array, np.uint32)


@dataclass(frozen=True, eq=False)
class Mesh:
    """A named surface of at least one part; ``notes`` say what was repaired or assumed, for the user.

    ``metres_per_unit`` is what a unit of the file's numbers was taken for; None where unit and axes are known.
    ``was_turned``: the z axis of a file that does not say which one is up was taken as up.

    >>> import numpy as np
    >>> corner = np.eye(3)
    >>> part = PartGeometry("facet", "paint", corner, np.tile([0.0, 0.0, 1.0], (3, 1)), corner[:, :2], [[0, 1, 2]])
    >>> Mesh("facet", (part,)).triangle_count
    1
    """

    name: str
    parts: tuple[PartGeometry, ...]
    notes: tuple[str, ...] = ()
    metres_per_unit: float | None = None
    was_turned: bool = False

    def __post_init__(self) -> None:
        object.__setattr__(self, "parts", tuple(self.parts))
        object.__setattr__(self, "notes", tuple(self.notes))
        if not self.parts:
            raise ValueRangeError(f"mesh {self.name!r}", "no part")

    @property
    def triangle_count(self) -> int:
        """How many triangles all parts have."""
        return sum(len(part.triangles) for part in self.parts)

    def bounds(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Return the lowest and the highest corner of all parts, (3,) each, metres."""
        corners = [part.bounds() for part in self.parts]
        low = np.min([corner[0] for corner in corners], axis=0)
        high = np.max([corner[1] for corner in corners], axis=0)
        return low, high


def _read_only(array: NDArray[Any], kind: type[_T]) -> NDArray[_T]:
    """Return a contiguous view or copy of the wanted type that cannot be written through."""
    result = np.ascontiguousarray(array, dtype=kind).view()
    result.flags.writeable = False
    return result
