"""Construction of a paint's reflectance.

Colour readings are of the whole paint, and gloss readings too, so coat and base depend on each other: the
coat's own share is taken out of the colours, the base that is left adds its flux to the gloss, and what gloss
remains is the coat's. The two are solved in turn; a glossy coat has no share in the colours and is done after
one correction.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from brdf_suite.appearance.clearcoat_gloss import LOWEST_ROUGHNESS, USUAL_IOR, nearest_coat
from brdf_suite.appearance.colour.colorimetry import lab_to_working, working_to_lab
from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.arrays import Floats
from brdf_suite.documents.cook_torrance import CookTorrancePaint
from brdf_suite.documents.paint import Gloss, Paint
from brdf_suite.errors import UnreachableError
from brdf_suite.geometry.directions import aspecular_view, illumination
from brdf_suite.reflectance.albedo import normal_albedo
from brdf_suite.reflectance.designed.aspecular_base import AspecularBase, BorrowedRule, Rule, SeveralLights
from brdf_suite.reflectance.designed.coat_lobe import CoatLobe
from brdf_suite.reflectance.designed.paint_reflectance import PaintReflectance
from brdf_suite.reflectance.designed.rules import FlakeRule, MonotoneRule, PolynomialRule, squared_tilt
from brdf_suite.reflectance.facet_albedo import entering
from brdf_suite.reflectance.factored.model import factored_paint_reflectance
from brdf_suite.reflectance.instruments.glossmeter import base_gloss, total_gloss
from brdf_suite.reflectance.models.coated import Coated
from brdf_suite.reflectance.models.cook_torrance import CookTorrance
from brdf_suite.reflectance.protocol import Reflectance

if TYPE_CHECKING:
    from brdf_suite.documents.store import AnyPaint
    from brdf_suite.reflectance.factored.model import Factored

_CHANNELS = ("red", "green", "blue")
# Gloss units: far finer than any reading. A glossy coat settles in one turn, a satin one in a few.
_SETTLED_GU = 0.003
_FULL_TURNS, _MOST_TURNS = 8, 24
_SAME_ANGLE_DEG = 1e-6
# The smallest base that is refused as negative; anything nearer to 0 is rounding.
_ROUNDING = 1e-7
# The spreads found for real flake paints are .146 to .191; far outside, the readings deserve a second look.
_USUAL_SPREAD = (0.08, 0.35)


@dataclass(frozen=True)
class _Readings:
    """The colours of one light angle, sorted by unsigned aspecular angle; ρ ≥ 0 of the whole paint."""

    illumination_deg: float
    aspecular_deg: Floats
    rho: Floats
    wo: Floats
    notices: tuple[str, ...]


class DarkerThanCoatError(UnreachableError):
    """A colour darker than its clearcoat alone.

    ``measurement`` (light and aspecular angle, degrees) and ``share`` (the coat's ρ there) are for a search. Made of
    the message alone, as every error of the suite, it can be reported again under a name, or by another process.
    """

    measurement: tuple[float, float] = (math.nan, math.nan)
    share: float = math.nan


def gloss_of_coat(paint: Paint, ior: float, roughness: float) -> Gloss:
    """Return what a glossmeter reads at 20 and 60° of the paint's colours under a coat of ``ior`` and ``roughness``.

    The base is what is left of the colours under that very coat, so :func:`build_paint` of the paint with this gloss
    solves for the same coat again, unless two coats give the same readings.

    Raises
    ------
    UnreachableError
        The coat alone reflects more than a colour reading; the message names the reading.
    """
    coat = CoatLobe(ior, roughness, paint.scattering)
    lights = _collect(paint)
    shares = _coat_shares(lights, coat)
    _refuse_negative(lights, shares)
    at_20, at_60 = total_gloss(_base_under(paint, lights, coat, shares)[0], coat)
    return Gloss(at_20, at_60)


def build_paint(paint: Paint) -> PaintReflectance:
    """Return the reflectance of a designed paint.

    Raises
    ------
    UnreachableError
        No clearcoat gives the gloss, or the coat alone reflects more than a colour reading; the message
        names the reading.
    """
    lights = _collect(paint)
    gu_20, gu_60 = paint.gloss.gu_20, paint.gloss.gu_60
    coat = CoatLobe(USUAL_IOR, LOWEST_ROUGHNESS, paint.scattering)
    base, notices = _base_under(paint, lights, coat, _coat_shares(lights, coat))
    added = base_gloss(base)
    for turn in range(_MOST_TURNS):
        solved, refusal = nearest_coat(gu_20, gu_60, *added)
        coat = CoatLobe(solved.ior, solved.roughness, paint.scattering)
        shares = _coat_shares(lights, coat)
        base, notices = _base_under(paint, lights, coat, shares)
        found = base_gloss(base)
        change = max(abs(found[0] - added[0]), abs(found[1] - added[1]))
        # A rough coat and its base can answer each other by turns; half steps then meet in the middle.
        step = 1.0 if turn < _FULL_TURNS else 0.5
        added = (added[0] + step * (found[0] - added[0]), added[1] + step * (found[1] - added[1]))
        if change <= _SETTLED_GU:
            break
    else:
        refusal = (
            f"No clearcoat was found that gives {gu_20:g} GU at 20° over the measured colours; "
            "change the gloss, or the colour nearest to the mirror direction."
        )
    _refuse_negative(lights, shares)
    if refusal is not None:
        raise UnreachableError(refusal)
    notices_of_lights = tuple(notice for readings in lights for notice in readings.notices)
    albedo = float(normal_albedo(base).max()) + 1.0 - float(_entering(1.0, coat))
    if albedo > 1.0:
        notices += (f"This paint would reflect {albedo:.2f} times the light that falls on it.",)
    return PaintReflectance(base, coat, notices_of_lights + notices)


def build_reflectance(paint: AnyPaint) -> PaintReflectance | CookTorrance | Factored | Coated:
    """Return the reflectance of a paint of any kind; errors as :func:`build_paint`, and those of reading textures."""
    if isinstance(paint, Paint):
        return build_paint(paint)
    base = CookTorrance(paint) if isinstance(paint, CookTorrancePaint) else factored_paint_reflectance(paint)
    coat = paint.clearcoat
    return base if coat is None else Coated(base, coat.ior, coat.roughness, scattering=coat.scattering)


def _collect(paint: Paint) -> tuple[_Readings, ...]:
    """Return the readings of each light angle, the largest group first."""
    angles = [measurement.illumination_deg for measurement in paint.measurements]
    ordered = sorted(set(angles), key=lambda angle: (-angles.count(angle), angle))
    most = angles.count(ordered[0])
    if most < 3:
        raise UnreachableError(
            f"{paint.name}: at least 3 readings with the same light angle are needed, "
            f"there are at most {most} (at {max(angles, key=angles.count):g}°)."
        )
    return tuple(_under_light(paint, angle, several=len(ordered) > 1) for angle in ordered)


def _under_light(paint: Paint, light_deg: float, *, several: bool) -> _Readings:
    """Return the readings of one light angle, sorted, with colours clamped to the space."""
    notices: list[str] = []
    used = [m for m in paint.measurements if m.illumination_deg == light_deg]
    used.sort(key=lambda measurement: (abs(measurement.aspecular_deg), measurement.aspecular_deg))
    aspecular_deg, _, wo = _directions(light_deg, tuple(measurement.aspecular_deg for measurement in used))
    lab = np.array([measurement.lab for measurement in used])
    rho = lab_to_working(lab)
    if rho.min() < 0.0:
        inside = np.maximum(rho, 0.0)
        error = delta_e_2000(lab, working_to_lab(inside))
        under = f" with the light at {light_deg:g}°" if several else ""
        for index in np.flatnonzero(rho.min(axis=-1) < 0.0).tolist():
            notices.append(
                f"The colour at {aspecular_deg[index]:g}°{under} is more saturated than the working space holds; "
                f"it is shown with ΔE00 {error[index]:.2f}."
            )
        rho = inside
    return _Readings(light_deg, aspecular_deg, rho, wo, tuple(notices))


@lru_cache(maxsize=32)
def _directions(light_deg: float, aspecular_deg: tuple[float, ...]) -> tuple[Floats, Floats, Floats]:
    """Return angles (n,), wi (3,) and wo (n, 3), not to be written: the same from edit to edit."""
    angles = np.array(aspecular_deg)
    found = angles, illumination(light_deg), aspecular_view(light_deg, angles)
    for part in found:
        part.flags.writeable = False
    return found


def _base_under(
    paint: Paint, lights: tuple[_Readings, ...], coat: CoatLobe, shares: list[Floats]
) -> tuple[AspecularBase | SeveralLights, tuple[str, ...]]:
    """Return the base under ``coat`` and its ``shares``; negative values become 0 here and are refused at the end."""
    first, notices = _base_of_light(paint, lights[0], coat, shares[0], None)
    if len(lights) == 1:
        return first, notices
    bases = [first]
    for readings, share in zip(lights[1:], shares[1:], strict=True):
        base, more = _base_of_light(paint, readings, coat, share, first)
        bases.append(base)
        notices += tuple(f"Light at {readings.illumination_deg:g}°: {notice}" for notice in more)
    bases.sort(key=lambda base: base.illumination)
    return SeveralLights(tuple(bases)), notices


def _base_of_light(
    paint: Paint, readings: _Readings, coat: CoatLobe, share: Floats, lent: AspecularBase | None
) -> tuple[AspecularBase, tuple[str, ...]]:
    """Return the base from one light's readings; fewer than three borrow the rule of ``lent``, another light's base."""
    left = np.maximum(readings.rho - share, 0.0)
    by_half_vector = paint.out_of_plane == "half_vector"
    light = math.radians(readings.illumination_deg)
    gamma, joined, weight = _by_unsigned_angle(readings, left, coat)
    tilted = (
        _through_own_tilts(readings, left, coat)
        if by_half_vector and paint.interpolation == "flake"
        else None
    )
    rule: Rule
    notices: tuple[str, ...]
    nearest, farthest = float(gamma[0]), float(gamma[-1])
    if lent is not None and len(gamma) < 3:
        rule, notices = BorrowedRule.through(lent.rule, gamma, joined, lent.illumination + light), ()
        # Up to the steepest view that the other light was read at: nearer to grazing a reading would say nothing.
        farthest = max(farthest, light + lent.farthest - lent.illumination)
    elif tilted is not None:
        rule, notices = tilted, _spread_notice(tilted)
    else:
        rule, notices = _rule(paint, gamma, joined, weight, light, coat.ior)
    if by_half_vector and not isinstance(rule, FlakeRule):
        by_half_vector = False
        notices += (
            "The tilt of the half vector belongs to the flake rule; here the aspecular angle is used.",
        )
    crossing = (coat.ior, by_half_vector, coat.crossing_roughness)
    return AspecularBase(rule, nearest, farthest, paint.near_specular, light, *crossing), notices


def _coat_shares(lights: tuple[_Readings, ...], coat: CoatLobe) -> list[Floats]:
    """π f_r of the coat (n, 1) at the directions of each light's readings."""
    return [_coat_share(coat, r.illumination_deg, tuple(r.aspecular_deg.tolist())) for r in lights]


@lru_cache(maxsize=32)
def _coat_share(coat: CoatLobe, light_deg: float, aspecular_deg: tuple[float, ...]) -> Floats:
    """Return the same for one light, not to be written: every edit begins with the usual coat."""
    _, wi, wo = _directions(light_deg, aspecular_deg)
    share = math.pi * coat.eval_grey(wi, wo)[:, None]
    share.flags.writeable = False
    return share


def _refuse_negative(lights: tuple[_Readings, ...], shares: list[Floats]) -> None:
    for readings, share in zip(lights, shares, strict=True):
        left = readings.rho - share
        if left.min() >= -_ROUNDING:
            continue
        index, channel = np.unravel_index(int(np.argmin(left)), left.shape)
        where = float(readings.aspecular_deg[index])
        error = DarkerThanCoatError(
            f"At {where:g}° the clearcoat of this gloss alone reflects "
            f"{share[index, 0]:.4f} (reflectance factor), more than the {readings.rho[index, channel]:.4f} that "
            f"the colour has in the {_CHANNELS[channel]} channel, so the base would be negative. Raise the gloss "
            "or the lightness."
        )
        error.measurement = (readings.illumination_deg, where)
        error.share = float(share[index, 0])
        raise error


def _entering(cosine: npt.ArrayLike, coat: CoatLobe) -> Floats:
    return entering(cosine, coat.ior, coat.crossing_roughness)


def _share_beyond(readings: _Readings, coat: CoatLobe) -> Floats:
    """What the coat lets out (n,) to each view, as a share of that to the view at +|γ|: 1 on the normal's side.

    A view beyond the mirror direction is nearer to grazing, so less light leaves the coat to it.
    """
    towards = np.cos(math.radians(readings.illumination_deg) - np.radians(np.abs(readings.aspecular_deg)))
    return np.asarray(_entering(readings.wo[:, 2], coat) / _entering(towards, coat))


def _by_unsigned_angle(readings: _Readings, rho: Floats, coat: CoatLobe) -> tuple[Floats, Floats, Floats]:
    """Rising |γ|, radians, one ρ (n, 3) each for the view on the normal's side, and its weight (n,).

    Of readings r on both sides that ρ is taken which misses the r by least squares, Σ s r / Σ s² with the share s
    that the coat lets out; so a view at grazing, which says little of the base, counts little.
    """
    size = np.abs(readings.aspecular_deg)
    gamma = np.radians(size)
    if readings.aspecular_deg.min() >= 0.0:
        return gamma, rho, np.ones(len(gamma))
    share = _share_beyond(readings, coat)
    keep = np.concatenate(([True], np.diff(size) > _SAME_ANGLE_DEG))
    group = np.cumsum(keep) - 1
    weight = np.asarray(np.bincount(group, share * share), np.float64)
    total = np.zeros((len(weight), 3))
    np.add.at(total, group, share[:, None] * rho)
    return gamma[keep], total / weight[:, None], weight


def _through_own_tilts(readings: _Readings, rho: Floats, coat: CoatLobe) -> FlakeRule | None:
    """The flake rule through readings on both sides, each at the tilt of the flakes that it sees, or None.

    The two sides see flakes of different tilts, which matters where the rule is taken at the tilt.
    """
    if len(rho) < 3 or readings.aspecular_deg.min() >= 0.0:
        return None
    light = math.radians(readings.illumination_deg)
    x = squared_tilt(np.radians(readings.aspecular_deg), light, coat.ior)
    order = np.argsort(x)
    share = _share_beyond(readings, coat)
    referred = rho / share[:, None]
    return FlakeRule.through_tilts(x[order], referred[order], light, coat.ior, (share * share)[order])


def _rule(
    paint: Paint, gamma: Floats, rho: Floats, weight: Floats, light: float, ior: float
) -> tuple[Rule, tuple[str, ...]]:
    """Return the paint's rule through the base's readings, with notices."""
    if len(gamma) < 3:
        return MonotoneRule.through(gamma, rho), (
            "There are fewer than three different aspecular angles: straight lines in L*a*b* join them.",
        )
    if paint.interpolation == "polynomial":
        polynomial = PolynomialRule.through(gamma, rho)
        angles = np.linspace(0.0, float(gamma[-1]), 45)
        below = angles[polynomial(angles).min(axis=-1) < 0.0]
        if below.size == 0:
            return polynomial, ()
        low, high = np.degrees(below[[0, -1]])
        return polynomial, (
            f"The polynomial turns negative between {low:.0f}° and {high:.0f}°; the base is black there.",
        )
    if paint.interpolation == "monotone":
        return MonotoneRule.through(gamma, rho), ()
    flakes = FlakeRule.through_tilts(squared_tilt(gamma, light, ior), rho, light, ior, weight)
    if flakes is None:
        return MonotoneRule.through(gamma, rho), (
            "No spread of flakes gives these colours: between the angles the monotone rule is used.",
        )
    return flakes, _spread_notice(flakes)


def _spread_notice(rule: FlakeRule) -> tuple[str, ...]:
    low, high = _USUAL_SPREAD
    odd = [spread for spread in rule.spread if spread is not None and not low <= spread <= high]
    if not odd:
        return ()
    return (
        f"The colours need flake tilts spread by {odd[0]:.3f}; real flake paints have about 0.15 to 0.19.",
    )


TOLERANCE_DELTA_E = 0.05
"""The largest ΔE00 that counts as passing through a reading."""


def interpolation_notices(paint: Paint, reflectance: Reflectance) -> tuple[str, ...]:
    """Return the notice that names every missed reading of ``paint``, or nothing where all are met.

    A rule with fewer numbers than there are readings passes near them only; and readings on both sides of the mirror
    direction may contradict each other. A colour that the working space does not hold is compared as it is shown;
    another notice reports it.
    """
    if len(paint.measurements) <= 3:
        # Every rule passes through three readings.
        return ()
    light = [m.illumination_deg for m in paint.measurements]
    view = aspecular_view(light, [m.aspecular_deg for m in paint.measurements])
    shown = working_to_lab(np.maximum(lab_to_working([m.lab for m in paint.measurements]), 0.0))
    return format_interpolation_notice(
        paint, delta_e_2000(shown, working_to_lab(math.pi * reflectance.eval(illumination(light), view)))
    )


def format_interpolation_notice(paint: Paint, missed: npt.ArrayLike) -> tuple[str, ...]:
    """Return the notice for ΔE00 ``missed`` (n,) of the paint's readings, in their order, or nothing."""
    several = len({m.illumination_deg for m in paint.measurements}) > 1
    named = [
        f"{delta:.2f} at {m.aspecular_deg:g}°"
        + (f" with the light at {m.illumination_deg:g}°" if several else "")
        for m, delta in zip(paint.measurements, np.asarray(missed, float).tolist(), strict=True)
        if delta > TOLERANCE_DELTA_E
    ]
    if not named:
        return ()
    return (f"The rule does not pass through every reading of this paint: ΔE00 {', '.join(named)}.",)
