"""Gloss units of a clearcoat, and the clearcoat that gives a reading (ASTM D523, ISO 2813).

A glossmeter compares the light that a surface sends into a small receptor about the mirror direction with
that of polished black glass of index 1.567, which reads 100:

    GU = 100 F(θ; n) / F(θ; 1.567) · A(α),

A being the share of the mirrored light that still falls into the receptor, 1 for a smooth surface. Source image and
receptor are rectangles of half-widths s and r. Of light that is turned by an angle x along one side the share

    W(x) = |[-s, s] ∩ [-r - x, r - x]| / 2s

arrives: the convolution of the two rectangles, a trapezoid. A Beckmann lobe of roughness α turns mirror directions by
a Gaussian of variance σ² = 2α² in the plane of incidence and 2α² cos²θ across it, and A is the product over both
sides of the Gaussian's integral over W,

    (J(r + s) - J(r - s)) / 2s,   J(t) = t erf(t / √2σ) + σ √(2/π) exp(-t² / 2σ²).

The rectangles are those of ISO 2813 and ASTM D523, from expert memory.

The root finder uses plain floats: for three channels this is many times faster than arrays, and scipy's optimizers
would cost their import when a program starts.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from itertools import pairwise

from brdf_suite.errors import ValueRangeError
from brdf_suite.geometry.fresnel import fresnel_at


def bracketed_root(
    function: Callable[[float], float],
    low: float,
    high: float,
    *,
    tolerance: float = 1e-12,
    at_low: float | None = None,
    at_high: float | None = None,
) -> float:
    """Return x in [low, high] with f(x) = 0 to ``tolerance`` (in x); f must change its sign between them.

    Chandrupatla's method (Advances in Engineering Software 28, 1997, 145): inverse quadratic interpolation
    where it is safe, bisection otherwise. ``at_low`` and ``at_high`` are f there where already known.

    Raises
    ------
    ValueError
        f has the same sign at both ends.
    """
    a, b = low, high
    fa = function(a) if at_low is None else at_low
    fb = function(b) if at_high is None else at_high
    if fa == 0.0:
        return a
    if fb == 0.0:
        return b
    if (fa > 0.0) == (fb > 0.0):
        raise ValueError(f"no sign change between {low} and {high}: {fa} and {fb}")
    step = 0.5
    # Bisection alone would be done after about 50 steps; twice that is a bound, not a guess.
    for _ in range(120):
        x = a + step * (b - a)
        fx = function(x)
        if (fx > 0.0) == (fa > 0.0):
            c, fc = a, fa
        else:
            c, fc = b, fb
            b, fb = a, fa
        a, fa = x, fx
        best, f_best = (a, fa) if abs(fa) < abs(fb) else (b, fb)
        width = abs(b - a)
        if f_best == 0.0 or width <= 2.0 * tolerance:
            return best
        xi = (a - b) / (c - b)
        phi = (fa - fb) / (fc - fb)
        if phi * phi < xi and (1.0 - phi) ** 2 < 1.0 - xi:
            step = fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb)
        else:
            step = 0.5
        margin = tolerance / width
        step = min(1.0 - margin, max(margin, step))
    return best


BLACK_GLASS_IOR = 1.567
RECEPTORS_DEG = {20: (1.8, 3.6), 60: (4.4, 11.7), 85: (4.0, 6.0)}
"""Full widths of the receptor in the plane of incidence and across it, degrees, per gloss angle."""
SOURCE_DEG = (0.75, 2.5)
"""Full widths of the source's image, in the plane of incidence and across it, narrower than every receptor."""

USUAL_IOR = 1.5
LOWEST_IOR, HIGHEST_IOR = 1.3, 1.7
"""The indices a clear resin may have."""
LOWEST_ROUGHNESS, HIGHEST_ROUGHNESS = 0.002, 0.5
"""Below the lowest the lobe is narrower than any picture shows; above the highest it is no gloss."""

# Below it the whole lobe is in every receptor, to the last digit.
_SMOOTH = 1e-6
_PER_ROOT_PI = 1.0 / math.sqrt(math.pi)
_INSTRUMENT_TOLERANCE_GU = 0.5
# Cells of the search along the line of coats that share a 20° reading; it turns at most once.
_LINE_CELLS = 6


@dataclass(frozen=True)
class Coat:
    """A clearcoat: its index of refraction and its Beckmann roughness α."""

    ior: float
    roughness: float


def receptor_deg(angle_deg: int) -> tuple[float, float]:
    """Return the receptor's full widths, degrees; raise :class:`ValueRangeError` for an unknown angle."""
    if angle_deg not in RECEPTORS_DEG:
        raise ValueRangeError("angle_deg", f"gloss is measured at 20, 60 or 85°, not {angle_deg}°")
    return RECEPTORS_DEG[angle_deg]


@cache
def black_glass(angle_deg: int) -> float:
    """Return F of the black glass standard: .04908, .10006 and .61915 at 20, 60 and 85°."""
    return fresnel_at(angle_deg, BLACK_GLASS_IOR)


@cache
def half_widths(angle_deg: int) -> tuple[tuple[float, float], tuple[float, float]]:
    """Return the half-widths (receptor, source), radians, in the plane of incidence and across it."""
    (p, q), (s, t) = ((0.5 * math.radians(w) for w in pair) for pair in (receptor_deg(angle_deg), SOURCE_DEG))
    return (p, s), (q, t)


@cache
def _edges(angle_deg: int) -> tuple[float, float, float, float, float]:
    """(r ± s)/√2 over σ/α of both sides, and what their differences of J are divided by."""
    (p, s), (q, t) = half_widths(angle_deg)
    turn = 2.0 * math.cos(math.radians(angle_deg))
    return (p + s) / 2.0, (p - s) / 2.0, (q + t) / turn, (q - t) / turn, s * t / (0.5 * turn)


def receptor_fraction(angle_deg: int, roughness: float) -> float:
    """Return A, the share of the lobe in the receptor, 0 to 1; 1 for a smooth surface."""
    p1, p0, q1, q0, widths = _edges(angle_deg)
    if roughness < _SMOOTH:
        return 1.0
    in_plane = _ramp(p1 / roughness) - _ramp(p0 / roughness)
    return in_plane * (_ramp(q1 / roughness) - _ramp(q0 / roughness)) * roughness * roughness / widths


def _ramp(x: float) -> float:
    """J of t = √2 σ x in units of √2 σ."""
    return x * math.erf(x) + math.exp(-x * x) * _PER_ROOT_PI


def gloss_units(angle_deg: int, ior: float, roughness: float) -> float:
    """Return the gloss units of a coat alone at 20, 60 or 85°.

    >>> round(gloss_units(20, 1.53, 0.0), 1)
    90.0
    """
    return (
        100.0 * fresnel_at(angle_deg, ior) / black_glass(angle_deg) * receptor_fraction(angle_deg, roughness)
    )


def nearest_coat(
    gu_20: float, gu_60: float | None = None, base_gu_20: float = 0.0, base_gu_60: float = 0.0
) -> tuple[Coat, str | None]:
    """Return the coat whose gloss and the base's flux together give the readings; or the nearest, and a refusal.

    With ``gu_20`` alone, the index stays 1.5 and the roughness is solved, down to .002; a higher gloss keeps
    that roughness and raises the index. With ``gu_60`` both are solved. The refusal is a sentence that names the
    reading and what can be reached; it may be lifted where a search's base is not final yet.

    Parameters
    ----------
    base_gu_20, base_gu_60
        What the base alone sends into the receptors, gloss units.
    """
    if gu_60 is not None:
        return _from_two(gu_20, gu_60, base_gu_20, base_gu_60)
    wanted = gu_20 - base_gu_20
    lowest = gloss_units(20, USUAL_IOR, HIGHEST_ROUGHNESS)
    highest = gloss_units(20, HIGHEST_IOR, LOWEST_ROUGHNESS)
    if wanted < lowest:
        return Coat(USUAL_IOR, HIGHEST_ROUGHNESS), _refusal(gu_20, base_gu_20, lowest, highest)
    if wanted <= gloss_units(20, USUAL_IOR, LOWEST_ROUGHNESS):
        return Coat(USUAL_IOR, _roughness_for(wanted, USUAL_IOR)), None
    coat = Coat(_ior_for(wanted, LOWEST_ROUGHNESS, USUAL_IOR), LOWEST_ROUGHNESS)
    return coat, None if wanted <= highest else _refusal(gu_20, base_gu_20, lowest, highest)


def _from_two(gu_20: float, gu_60: float, base_20: float, base_60: float) -> tuple[Coat, str | None]:
    """Solve for both readings: each roughness and the 20° reading give an index; the 60° reading selects one coat.

    The 60° gloss rises along the line while the lobe fits the wide receptor. Past that both receptors lose
    alike and it may fall again: of two coats the one nearest to the usual index is taken.
    """
    wanted_20, wanted_60 = gu_20 - base_20, gu_60 - base_60
    highest = gloss_units(20, HIGHEST_IOR, LOWEST_ROUGHNESS)
    lowest = gloss_units(20, LOWEST_IOR, HIGHEST_ROUGHNESS)
    if wanted_20 < lowest:
        return Coat(LOWEST_IOR, HIGHEST_ROUGHNESS), _refusal(gu_20, base_20, lowest, highest)
    if wanted_20 > highest:
        return Coat(HIGHEST_IOR, LOWEST_ROUGHNESS), _refusal(gu_20, base_20, lowest, highest)
    start = math.log(_roughness_for(wanted_20, LOWEST_IOR))
    end = math.log(_roughness_for(wanted_20, HIGHEST_IOR))

    def excess(x: float) -> float:
        roughness = math.exp(x)
        return gloss_units(60, _ior_for(wanted_20, roughness, LOWEST_IOR), roughness) - wanted_60

    def coat_at(x: float) -> Coat:
        return Coat(_ior_for(wanted_20, math.exp(x), LOWEST_IOR), math.exp(x))

    steps = [start + (end - start) * k / _LINE_CELLS for k in range(_LINE_CELLS + 1)]
    values = [excess(x) for x in steps]
    coats = [
        coat_at(bracketed_root(excess, *steps[k : k + 2], tolerance=1e-8, at_low=low, at_high=high))
        for k, (low, high) in enumerate(pairwise(values))
        if low * high <= 0.0
    ]
    if coats:
        return min(coats, key=lambda coat: abs(coat.ior - USUAL_IOR)), None
    size, x = min((abs(value), x) for value, x in zip(values, steps, strict=True))
    coat = coat_at(x)
    # A reading is no surer than this, and smooth coats lie on the very edge of what can be reached.
    if size <= _INSTRUMENT_TOLERANCE_GU:
        return coat, None
    least, most = min(values) + gu_60, max(values) + gu_60
    return coat, (
        f"With {gu_20:g} GU at 20°, a coat over this base (which gives {base_60:.1f} GU itself at 60°) reads "
        f"from {least:.1f} to {most:.1f} GU at 60°; {gu_60:g} GU cannot be reached."
    )


def _ior_for(wanted_20: float, roughness: float, lowest: float) -> float:
    """Return the index that gives ``wanted_20`` at this roughness, clamped to the range."""
    target = wanted_20 / 100.0 * black_glass(20) / receptor_fraction(20, roughness)
    if target <= fresnel_at(20, lowest):
        return lowest
    if target >= fresnel_at(20, HIGHEST_IOR):
        return HIGHEST_IOR
    return bracketed_root(lambda n: fresnel_at(20, n) - target, lowest, HIGHEST_IOR, tolerance=1e-10)


def _roughness_for(wanted_20: float, ior: float) -> float:
    """Return the roughness that gives ``wanted_20`` with this index, clamped to the range."""
    share = wanted_20 / gloss_units(20, ior, 0.0)
    if share >= receptor_fraction(20, LOWEST_ROUGHNESS):
        return LOWEST_ROUGHNESS
    if share <= receptor_fraction(20, HIGHEST_ROUGHNESS):
        return HIGHEST_ROUGHNESS
    # In logarithms the curve is close to a line, which the root finder likes.
    return math.exp(
        bracketed_root(
            lambda x: math.log(receptor_fraction(20, math.exp(x)) / share),
            math.log(LOWEST_ROUGHNESS),
            math.log(HIGHEST_ROUGHNESS),
            tolerance=1e-10,
        )
    )


def _refusal(gu_20: float, base: float, lowest: float, highest: float) -> str:
    return (
        f"A gloss of {gu_20:g} GU at 20° cannot be reached: over this base, which gives {base:.1f} GU "
        f"itself, a clearcoat reads from {base + lowest:.1f} to {base + highest:.1f} GU."
    )


def haze_units(gu_20: float, gu_60: float) -> float:
    """Return the haze index G60 - G20, gloss units.

    The difference of the two gloss readings, as practice reads ASTM D4039; from expert memory, not read in the
    standard. It grows where the narrow 20° receptor loses light that the wide 60° receptor still sees; a smooth
    clear coat of index 1.5 already has about 12, because its 60° reading is higher.

    >>> haze_units(82.0, 94.0)
    12.0
    """
    return gu_60 - gu_20
