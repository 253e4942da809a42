"""Tolerances of batches against a standard: a colour difference per angle, with limits, pass or fail.

The car makers' own tolerance equations (DIN 6175, AUDI2000) were not obtainable, so the tolerances are the user's: at
each angle a limit for the whole difference, for ΔL*, ΔC*ab and ΔH*ab, or for any of them.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, fields

import numpy as np
import numpy.typing as npt

from brdf_suite.appearance.difference.cam02ucs import delta_e_cam02ucs
from brdf_suite.appearance.difference.formulas import delta_e_76, delta_e_2000, delta_e_cmc
from brdf_suite.arrays import Floats
from brdf_suite.errors import ValueRangeError

Difference = Callable[[npt.ArrayLike, npt.ArrayLike], Floats]

DIFFERENCES: dict[str, Difference] = {
    "2000": delta_e_2000,
    "76": delta_e_76,
    "cmc21": delta_e_cmc,
    "cmc11": lambda reference, sample: delta_e_cmc(reference, sample, 1.0, 1.0),
    "cam02ucs": delta_e_cam02ucs,
}
"""Colour differences of (reference, sample) by name: CIEDE2000, ΔE*ab, CMC(2:1), CMC(1:1), CAM02-UCS."""

TITLES = {
    "2000": "ΔE00",
    "76": "ΔE*ab",
    "cmc21": "CMC(2:1)",
    "cmc11": "CMC(1:1)",
    "cam02ucs": "CAM02-UCS",
}
"""What a difference is called beside its number; symbols alike in every language."""

_CMC = re.compile(r"cmc:(\d{1,3}(?:\.\d{1,6})?):(\d{1,3}(?:\.\d{1,6})?)")
_SAME_DEG = 1e-6


def find_difference(name: str) -> Difference:
    """Return the formula called ``name``: a key of :data:`DIFFERENCES`, or ``cmc:l:c`` with weights of one's own.

    >>> float(find_difference("cmc:2:1")([50.0, 0.0, 0.0], [51.0, 0.0, 0.0])) == float(
    ...     find_difference("cmc21")([50.0, 0.0, 0.0], [51.0, 0.0, 0.0])
    ... )
    True

    Raises
    ------
    ValueRangeError
        There is none of that name, or a weight is not positive.
    """
    if name in DIFFERENCES:
        return DIFFERENCES[name]
    lightness, chroma = _cmc_weights(name)
    return lambda reference, sample: delta_e_cmc(reference, sample, lightness, chroma)


def difference_title(name: str) -> str:
    """Return what stands beside the number: ``ΔE00``, ``CMC(1.4:1)``; errors as :func:`find_difference`."""
    if name in TITLES:
        return TITLES[name]
    lightness, chroma = _cmc_weights(name)
    return f"CMC({lightness:g}:{chroma:g})"


def _cmc_weights(name: str) -> tuple[float, float]:
    found = _CMC.fullmatch(name)
    if found is None:
        raise ValueRangeError(
            "difference", f"expected one of {', '.join(DIFFERENCES)} or cmc:l:c, not {name!r}"
        )
    lightness, chroma = float(found[1]), float(found[2])
    if not (lightness > 0.0 and chroma > 0.0):
        raise ValueRangeError("difference", f"CMC({lightness:g}:{chroma:g}) needs two positive weights")
    return lightness, chroma


def _checked(place: str, value: float | Limits | None) -> None:
    if isinstance(value, float | int) and not (math.isfinite(value) and value >= 0.0):
        raise ValueRangeError(place, f"expected a number from 0, not {value:g}")


@dataclass(frozen=True)
class Limits:
    """The largest differences that pass at one angle; ``None`` where a component is not judged.

    ``difference`` is by the formula of the :class:`Tolerances`; ``lightness``, ``chroma`` and ``hue`` are for the
    sizes of ΔL*, ΔC*ab and ΔH*ab. With ``ellipsoid`` these three are its half axes and are judged together:
    ``(ΔL/l)² + (ΔC/c)² + (ΔH/h)² <= 1``; without it each is judged alone.
    """

    difference: float | None = None
    lightness: float | None = None
    chroma: float | None = None
    hue: float | None = None
    ellipsoid: bool = False

    def __post_init__(self) -> None:
        for entry in fields(self)[:4]:
            _checked(f"tolerance of the {entry.name}", getattr(self, entry.name))

    @property
    def judges(self) -> bool:
        """Whether any component has a limit."""
        return any(value is not None for value in (self.difference, self.lightness, self.chroma, self.hue))

    def exceeded(self, difference: float, lightness: float, chroma: float, hue: float) -> tuple[str, ...]:
        """Return which limits a difference with these components goes beyond, by name.

        >>> Limits(1.0, lightness=0.5).exceeded(0.9, -0.6, 0.1, 0.1)
        ('lightness',)
        """
        alone = [("difference", difference, self.difference)]
        parts = [
            ("lightness", lightness, self.lightness),
            ("chroma", chroma, self.chroma),
            ("hue", hue, self.hue),
        ]
        found: tuple[str, ...] = ()
        if self.ellipsoid:
            judged = [(value, limit) for _, value, limit in parts if limit is not None]
            if sum(_share(value, limit) ** 2 for value, limit in judged) > 1.0:
                found = ("ellipsoid",)
        else:
            alone += parts
        return (
            tuple(name for name, value, limit in alone if limit is not None and not abs(value) <= limit)
            + found
        )


def _share(value: float, limit: float) -> float:
    """Return a component in units of its half axis; for zero width only 0 is inside."""
    if limit > 0.0:
        return value / limit
    return 0.0 if value == 0.0 else math.inf


NO_LIMITS = Limits()


@dataclass(frozen=True)
class Tolerances:
    """The largest differences that pass, per aspecular angle in degrees; ``otherwise`` for angles not named.

    A bare number is the limit of the whole difference. ``otherwise`` is ``None`` where an angle that is not named
    shall not be judged. ``difference`` names the formula (:func:`find_difference`).
    """

    by_angle: Mapping[float, float | Limits]
    otherwise: float | Limits | None = None
    difference: str = "2000"

    def __post_init__(self) -> None:
        find_difference(self.difference)
        for angle, value in self.by_angle.items():
            _checked(f"tolerance at {angle:g}°", value)
        _checked("tolerance", self.otherwise)

    def limits_at(self, aspecular_deg: float) -> Limits:
        """Return the limits at an angle; none of them set where it is not judged."""
        near = (value for angle, value in self.by_angle.items() if abs(angle - aspecular_deg) <= _SAME_DEG)
        value = next(near, self.otherwise)
        return value if isinstance(value, Limits) else Limits(value)

    def at(self, aspecular_deg: float) -> float | None:
        """Return the limit of the whole difference at an angle; ``None`` where there is none."""
        return self.limits_at(aspecular_deg).difference


@dataclass(frozen=True)
class AngleVerdict:
    """Verdict at one angle: the difference, its tolerance, and whether it passes (``None``: not judged).

    ``lightness``, ``chroma`` and ``hue`` are ΔL*, ΔC*ab and ΔH*ab, sample minus reference; ``exceeded`` names the
    limits that are gone beyond (:meth:`Limits.exceeded`).
    """

    aspecular_deg: float
    difference: float
    tolerance: float | None
    passes: bool | None
    lightness: float
    chroma: float
    hue: float
    limits: Limits = NO_LIMITS
    exceeded: tuple[str, ...] = ()


@dataclass(frozen=True)
class Verdict:
    """Verdict of all angles; ``passes`` is true where every judged angle passes, ``None`` where none is judged."""

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
            f"expected {len(aspecular_deg)} L*a*b* values of each, not shapes {first.shape} and {second.shape}",
        )
    differences = find_difference(tolerances.difference)(first, second).tolist()
    rows = []
    for angle, difference, one, other in zip(aspecular_deg, differences, first, second, strict=True):
        limits, parts = tolerances.limits_at(angle), difference_parts(one, other)
        exceeded = limits.exceeded(difference, *parts)
        passes = not exceeded if limits.judges else None
        rows.append(AngleVerdict(angle, difference, limits.difference, passes, *parts, limits, exceeded))
    return Verdict(tuple(rows), tolerances.difference)


def difference_parts(
    reference: Sequence[float] | Floats, sample: Sequence[float] | Floats
) -> tuple[float, float, float]:
    """Return ΔL*, ΔC*ab and ΔH*ab of two L*a*b* values (3,), sample minus reference.

    ΔH is positive where the hue turns from red towards yellow.

    >>> difference_parts((50.0, 3.0, 4.0), (52.0, 6.0, 8.0))
    (2.0, 5.0, 0.0)
    """
    (l1, a1, b1), (l2, a2, b2) = ([float(value) for value in lab] for lab in (reference, sample))
    c1, c2 = math.hypot(a1, b1), math.hypot(a2, b2)
    # ΔH = 2 √(C1 C2) sin(Δh/2) written without angles, so that its sign is right also across hue 0.
    cross, dot = a1 * b2 - b1 * a2, a1 * a2 + b1 * b2
    hue = math.copysign(math.sqrt(max(2.0 * (c1 * c2 - dot), 0.0)), cross) if cross or dot < 0.0 else 0.0
    return l2 - l1, c2 - c1, hue
