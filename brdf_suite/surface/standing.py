"""Whether a mesh stands as it was meant to: which axis is up in its file, and which unit its lengths are in.

Files of meshes say little about either: OBJ, STL and PLY nothing at all. Where an object lies says more, since most
stand on a ground at 0, and with their middle over the origin.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.documents.view_settings import LengthUnit, UpAxis
from brdf_suite.surface.mesh import Mesh

UNITS: dict[LengthUnit, float] = {"m": 1.0, "mm": 0.001, "in": 0.0254, "cm": 0.01}
"""Metres of each unit, the usual ones first."""
PLAUSIBLE_M = (0.05, 10.0)
"""Across what is painted: from a mirror's cap to a van."""
_NEAR = 0.02
"""Of the size: what is so near to 0 is meant to be there."""


@dataclass(frozen=True)
class Standing:
    """How a mesh is best taken; ``is_doubtful`` where that is other than it was, or nothing speaks for it."""

    up: UpAxis
    unit: LengthUnit
    is_doubtful: bool


def find_standing(mesh: Mesh) -> Standing | None:
    """Return how a mesh that was read without a word about axes and unit stands best; None where both are known."""
    taken = mesh.metres_per_unit
    if taken is None:
        return None
    points = np.concatenate([part.positions for part in mesh.parts]).astype(np.float64)
    unit, sure = find_unit(float(np.ptp(points, axis=0).max()) / taken)
    up: UpAxis = "z" if mesh.was_turned or lies_on_its_side(points) else "y"
    return Standing(up, unit, is_doubtful=up == "z" or not sure)


def find_unit(size: float) -> tuple[LengthUnit, bool]:
    """Return the first unit in which an object ``size`` units across is a plausible one, and whether it is metres.

    >>> find_unit(4.5), find_unit(4500.0), find_unit(180.0)
    (('m', True), ('mm', False), ('mm', False))
    """
    low, high = PLAUSIBLE_M
    fitting = [unit for unit, metres in UNITS.items() if low <= size * metres <= high]
    return (fitting[0], fitting[0] == "m") if fitting else ("m", False)


def guess_up(points: Floats, usual: str) -> UpAxis:
    """Return the axis along which points (n, 3) of a silent file stand upright; else the ``usual`` one."""
    if not len(points):
        return "y"
    if lies_on_its_side(points):
        return "z"
    # With the axes changed over, what stands on y lies on its side.
    return "z" if usual == "z" and not lies_on_its_side(points[:, [0, 2, 1]]) else "y"


def lies_on_its_side(points: Floats) -> bool:
    """Whether points (n, 3) stand upright with z up rather than y.

    They do where they stand on 0 along z, and along y reach as far to one side of 0 as to the other.
    """
    low, high = points.min(axis=0), points.max(axis=0)
    near = _NEAR * float((high - low).max())
    stands, is_centred = np.abs(low) <= near, 0.5 * np.abs(low + high) <= near
    return bool(stands[2] and is_centred[1] and not stands[1])
