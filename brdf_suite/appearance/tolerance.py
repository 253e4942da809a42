"""Batches against a standard: a colour difference per angle, each with its own tolerance, pass or fail.

The car makers' own tolerance equations (DIN 6175, AUDI2000) were not obtainable, so the tolerances are the user's.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from brdf_suite.appearance.cam02ucs import delta_e_cam02ucs
from brdf_suite.appearance.difference import delta_e_76, delta_e_2000, delta_e_cmc
from brdf_suite.errors import ValueRangeError
from brdf_suite.geometry.directions import Floats

Difference = Callable[[npt.ArrayLike, npt.ArrayLike], Floats]

DIFFERENCES: dict[str, Difference] = {
    "2000": delta_e_2000,
    "76": delta_e_76,
    "cmc21": delta_e_cmc,
    "cmc11": lambda reference, sample: delta_e_cmc(reference, sample, 1.0, 1.0),
    "cam02ucs": delta_e_cam02ucs,
}
"""Colour differences of (reference, sample) by name: CIEDE2000, ΔE*ab, CMC(2:1), CMC(1:1), CAM02-UCS."""

_SAME_DEG = 1e-6


@dataclass(frozen=True)
class Tolerances:
    """The largest difference that passes, per aspecular angle in degrees; ``otherwise`` for angles not named.

    ``otherwise`` is ``None`` where an angle that is not named shall not be judged.
    """

    by_angle: Mapping[float, float]
    otherwise: float | None = None
    difference: str = "2000"

    def __post_init__(self) -> None:
        if self.difference not in DIFFERENCES:
            raise ValueRangeError(
                "difference", f"one of {', '.join(DIFFERENCES)} is wanted, not {self.difference!r}"
            )
        named = [(f"tolerance at {angle:g}°", value) for angle, value in self.by_angle.items()]
        if self.otherwise is not None:
            named.append(("tolerance", self.otherwise))
        for place, value in named:
            if not (math.isfinite(value) and value >= 0.0):
                raise ValueRangeError(place, f"a number from 0 is wanted, not {value:g}")

    def at(self, aspecular_deg: float) -> float | None:
        """Return the tolerance at an angle; ``None`` where there is none."""
        for angle, value in self.by_angle.items():
            if abs(angle - aspecular_deg) <= _SAME_DEG:
                return value
        return self.otherwise


@dataclass(frozen=True)
class AngleVerdict:
    """One angle: the difference, its tolerance, and whether it passes (``None``: not judged).

    ``lightness``, ``chroma`` and ``hue`` are ΔL*, ΔC*ab and ΔH*ab, sample minus reference.
    """

    aspecular_deg: float
    difference: float
    tolerance: float | None
    passes: bool | None
    lightness: float
    chroma: float
    hue: float


@dataclass(frozen=True)
class Verdict:
    """All angles; ``passes`` is true where every judged angle passes, ``None`` where none is judged."""

    angles: tuple[AngleVerdict, ...]
    difference: str

    @property
    def passes(self) -> bool | None:
        """Return the verdict on the whole."""
        judged = [row.passes for row in self.angles if row.passes is not None]
        return all(judged) if judged else None


def judge(
    aspecular_deg: Sequence[float], reference: npt.ArrayLike, sample: npt.ArrayLike, tolerances: Tolerances
) -> Verdict:
    """Return the differences and the verdict of L*a*b* readings (k, 3) at angles (k,), degrees.

    >>> verdict = judge([15.0], [[50.0, 0.0, 0.0]], [[51.0, 0.0, 0.0]], Tolerances({15.0: 0.9}, difference="76"))
    >>> verdict.passes, verdict.angles[0].lightness
    (False, 1.0)
    """
    first, second = np.asarray(reference, float), np.asarray(sample, float)
    if first.shape != (len(aspecular_deg), 3) or second.shape != first.shape:
        raise ValueRangeError(
            "readings",
            f"{len(aspecular_deg)} L*a*b* values of each are wanted, not shapes {first.shape} and {second.shape}",
        )
    differences = DIFFERENCES[tolerances.difference](first, second)
    return Verdict(
        tuple(
            _row(angle, float(differences[i]), tolerances.at(angle), first[i], second[i])
            for i, angle in enumerate(aspecular_deg)
        ),
        tolerances.difference,
    )


def _row(
    angle: float, difference: float, tolerance: float | None, first: Floats, second: Floats
) -> AngleVerdict:
    c1, c2 = math.hypot(first[1], first[2]), math.hypot(second[1], second[2])
    # ΔH = 2 √(C1 C2) sin(Δh/2) written without angles, so that its sign is right also across hue 0.
    cross, dot = first[1] * second[2] - first[2] * second[1], first[1] * second[1] + first[2] * second[2]
    hue = math.copysign(math.sqrt(max(2.0 * (c1 * c2 - dot), 0.0)), cross) if cross or dot < 0.0 else 0.0
    passes = None if tolerance is None else bool(difference <= tolerance)
    return AngleVerdict(angle, difference, tolerance, passes, float(second[0] - first[0]), c2 - c1, hue)
