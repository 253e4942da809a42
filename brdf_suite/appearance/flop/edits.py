"""Edits of a paint's readings in a colourist's terms: all angles together, or the flop about a fixed face.

An edit takes L*a*b* readings (n, 3) at aspecular angles (n,), degrees, in any order, and gives new ones. The *face* is
the reading nearest to 45°, the *near* end the one nearest to the mirror direction, the *far* end the one farthest from
it; flop and travel run from near to far. Where there is no flop yet, near and far diverge in the proportions of a
typical metallic (0.7 of the travel of L* before the face, 0.3 after it; chroma and hue half and half).

L* and C*ab never fall below 0: what one end cannot take, the other end takes, so that the travel is still the requested
one; the face never changes. A grey has no hue, and a hue travel leaves it grey.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from brdf_suite.appearance.colour.spaces import lab_to_lch, lch_to_lab
from brdf_suite.appearance.flop.travel import flop_index
from brdf_suite.arrays import Floats
from brdf_suite.errors import ValueRangeError

FACE_DEG = 45.0
GREY_CHROMA = 0.05
"""C*ab below which a reading counts as grey, without a hue: far below the resolution of an instrument."""

_NEAR_SHARE = {0: 0.7, 1: 0.5, 2: 0.5}
"""Fraction of a new travel of L*, C* and h before the face."""
_STILL = 0.05


@dataclass(frozen=True)
class FlopEnds:
    """Indices of the readings at the near end, the face and the far end."""

    near: int
    face: int
    far: int


def flop_ends(aspecular_deg: npt.ArrayLike) -> FlopEnds:
    """Return near end, face and far end of readings at angles (n,).

    Raises
    ------
    ValueRangeError
        They are not three different readings on rising sides of the face.
    """
    size = np.abs(np.asarray(aspecular_deg, float))
    near, far = int(np.argmin(size)), int(np.argmax(size))
    face = int(np.argmin(np.abs(np.asarray(aspecular_deg, float) - FACE_DEG)))
    if not size[near] < size[face] < size[far]:
        raise ValueRangeError("aspecular_deg", "a flop needs a reading before the face and one beyond it")
    return FlopEnds(near, face, far)


def hue_difference(from_deg: float, to_deg: float) -> float:
    """Return the signed difference of two hues, the short way round, -180 to 180°."""
    return float((to_deg - from_deg + 180.0) % 360.0 - 180.0)


def unwrap_hues(lab: npt.ArrayLike) -> Floats:
    """Return hues (n,), degrees, of readings (n, 3) in their order, without jumps of 360°: NaN for a grey.

    The first is 0 to 360; each further one lies within 180° of the one before it that has a hue.

    >>> unwrap_hues([[50.0, 9.0, -1.0], [50.0, 0.0, 0.0], [50.0, 9.0, 1.0]]).round(1).tolist()
    [353.7, nan, 366.3]
    """
    lch = lab_to_lch(np.asarray(lab, float))
    hues = np.where(lch[:, 1] < GREY_CHROMA, np.nan, lch[:, 2])
    known = np.flatnonzero(np.isfinite(hues))
    if len(known):
        hues[known] = np.degrees(np.unwrap(np.radians(hues[known])))
    return np.asarray(hues)


def shift_labs(lab: npt.ArrayLike, delta: npt.ArrayLike) -> Floats:
    """Return readings shifted by ΔL*, Δa*, Δb* (3,) each; L* stops at 0."""
    moved: Floats = np.asarray(lab, float) + np.asarray(delta, float)
    moved[:, 0] = np.maximum(moved[:, 0], 0.0)
    return moved


def shift_lchs(lab: npt.ArrayLike, delta: npt.ArrayLike, grey_hue_deg: float = 0.0) -> Floats:
    """Return readings shifted by ΔL*, ΔC*, Δh° (3,) each; L* and C* stop at 0, and a grey gets ``grey_hue_deg``."""
    step = np.asarray(delta, float)
    lch = lab_to_lch(lab)
    lch[:, 2] = np.where(lch[:, 1] < GREY_CHROMA, grey_hue_deg, lch[:, 2]) + step[2]
    lch[:, :2] = np.maximum(lch[:, :2] + step[:2], 0.0)
    return lch_to_lab(lch)


@dataclass(frozen=True)
class FlopValues:
    """Flop and travel from the near to the far end; ``index`` is NaN where it is not defined, ``hue`` with a grey."""

    index: float
    lightness: float
    chroma: float
    hue_deg: float


def measure_flop(aspecular_deg: npt.ArrayLike, lab: npt.ArrayLike) -> FlopValues:
    """Return the values that :func:`with_flop_travel` and :func:`with_flop_index` set; errors as :func:`flop_ends`."""
    ends, lab = flop_ends(aspecular_deg), np.asarray(lab, float)
    lch = lab_to_lch(lab)
    order = [ends.near, ends.face, ends.far]
    hues = unwrap_hues(lab[order])
    found = dict(zip(np.asarray(aspecular_deg, float).tolist(), lab[:, 0].tolist(), strict=True))
    three = [found.get(angle, math.nan) for angle in (15.0, 45.0, 110.0)]
    return FlopValues(
        index=flop_index(*three).value if not any(map(math.isnan, three)) else math.nan,
        lightness=float(lch[ends.far, 0] - lch[ends.near, 0]),
        chroma=float(lch[ends.far, 1] - lch[ends.near, 1]),
        hue_deg=float(hues[2] - hues[0]),
    )


def with_flop_index(aspecular_deg: npt.ArrayLike, lab: npt.ArrayLike, index: float) -> Floats:
    """Return readings whose flop index is ``index`` ≥ 0, with the same face: L* at 15° and 110° move away from it.

    The travel follows from 2.69 (L15 - L110)^1.11 / L45^0.86.

    Raises
    ------
    ValueRangeError
        There are no readings at 15, 45 and 110°; the face is black; or the index is not a number of at least 0.
    """
    lab = np.asarray(lab, float)
    if not (math.isfinite(index) and index >= 0.0):
        raise ValueRangeError("flop_index", f"expected a number of at least 0, not {index:g}")
    angles = np.asarray(aspecular_deg, float).tolist()
    if not {15.0, 45.0, 110.0} <= set(angles):
        raise ValueRangeError("flop_index", "the flop index needs readings at 15, 45 and 110°")
    face = float(lab[angles.index(45.0), 0])
    if face <= 0.0:
        raise ValueRangeError("flop_index", "L* at 45° is 0: there is no flop index")
    fall = (index * face**0.86 / 2.69) ** (1.0 / 1.11)
    ends = FlopEnds(angles.index(15.0), angles.index(45.0), angles.index(110.0))
    return _moved(aspecular_deg, lab, ends, 0, -fall)


def with_flop_travel(
    aspecular_deg: npt.ArrayLike, lab: npt.ArrayLike, component: int, travel: float
) -> Floats:
    """Return readings whose L* (``component`` 0), C* (1) or h° (2) changes by ``travel`` from near to far.

    L* keeps the proportions of its course; chroma and hue are sheared about the face. Errors as :func:`flop_ends`.
    """
    return _moved(aspecular_deg, np.asarray(lab, float), flop_ends(aspecular_deg), component, travel)


def _moved(
    aspecular_deg: npt.ArrayLike, lab: Floats, ends: FlopEnds, component: int, travel: float
) -> Floats:
    """Return the readings with another travel; the other components keep their last digit."""
    lch = lab_to_lch(lab)
    grey = lch[:, 1] < GREY_CHROMA
    if component == 2:
        now = measure_flop(aspecular_deg, lab).hue_deg
        if not math.isfinite(now):
            raise ValueRangeError("hue", "a reading is grey: there is no hue to travel from or to")
        lch[:, 2] += (travel - now) * _shear(aspecular_deg, ends, 2)
    else:
        # A grey that gets chroma gets it in the hue of the face.
        lch[:, 2] = np.where(grey, lch[ends.face, 2], lch[:, 2])
        lch = _parted(aspecular_deg, lch, ends, component, travel)
    moved = lch_to_lab(lch)
    if component == 0:
        moved[:, 1:] = lab[:, 1:]
    elif component == 2:
        moved[grey] = lab[grey]
    moved[ends.face] = lab[ends.face]
    return moved


def _parted(
    aspecular_deg: npt.ArrayLike, lch: Floats, ends: FlopEnds, component: int, travel: float
) -> Floats:
    """Return LCh with a travel of L* or C* from near to far, the face kept and nothing below 0."""
    values = lch[:, component]
    face = values[ends.face]
    near, far = values[ends.near] - face, values[ends.far] - face
    if component == 0 and abs(far - near) > _STILL and near * far <= 0.0:
        # A course that falls, or rises, through the face keeps its proportions.
        wanted_near, wanted_far = (travel / (far - near) * end for end in (near, far))
    else:
        share = _NEAR_SHARE[component]
        change = travel - (far - near)
        wanted_near, wanted_far = near - share * change, far + (1.0 - share) * change
    if face + wanted_far < 0.0:
        wanted_far = -face
        wanted_near = wanted_far - travel
    elif face + wanted_near < 0.0:
        wanted_near = -face
        wanted_far = wanted_near + travel
    moved = lch.copy()
    shear = _shear(aspecular_deg, ends, component)
    before = shear < 0.0
    # Between face and end a reading takes part as far as it lies towards the end.
    part = np.where(before, shear / shear[ends.near], shear / shear[ends.far])
    moved[:, component] = np.maximum(
        values + part * np.where(before, wanted_near - near, wanted_far - far), 0.0
    )
    moved[ends.face, component] = face
    return moved


def _shear(aspecular_deg: npt.ArrayLike, ends: FlopEnds, component: int) -> Floats:
    """Return the fraction of a travel between face and each reading: negative before the face, 1 from near to far."""
    size = np.abs(np.asarray(aspecular_deg, float))
    near, face, far = size[[ends.near, ends.face, ends.far]]
    share = _NEAR_SHARE[component]
    before = -share * (face - size) / (face - near)
    beyond = (1.0 - share) * (size - face) / (far - face)
    return np.asarray(np.where(size < face, before, beyond))
