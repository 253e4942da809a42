"""The paint nearest to one that cannot be: where no coat gives the gloss, or no sum of lobes the colours.

Some things stand in the way of a paint that a user has typed, and each has its nearest way round, tried in this order:

1. No clearcoat gives the gloss readings, or the coat alone reflects more than a colour does. Gloss is moved from one
   that can be towards the asked one, as far as it goes; a colour darker than its coat is lifted to the coat.
2. No lobes with non-negative weights give the colours at the readings: the nearest colours of their cone are taken
   (:mod:`brdf_suite.paint_design.feasible_colours`).
3. Under a rough coat dark colours may have no lobes, or only such as are far from what is asked: then the colours stay
   and the coat is moved instead, to the glossier one nearest to the asked one under which they can be.
4. The whole road (rule between the angles, coat, fit) does not quite give those: then what the fit does give is taken
   instead and fitted again, until asked and given agree.

Whatever is offered has been fitted: its ``fit`` says what it gives. Lobes know one light, the one that most readings
have; readings under another one (interference pigments) are neither judged nor changed. Nothing here is on the edit
path; it takes some tens of fits.
"""

from __future__ import annotations

import contextlib
import math
from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from brdf_suite.appearance.clearcoat_gloss import LOWEST_ROUGHNESS, USUAL_IOR
from brdf_suite.appearance.colour.colorimetry import lab_to_working, working_to_lab
from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.arrays import Floats
from brdf_suite.documents.paint import Gloss, Lab, Paint
from brdf_suite.errors import UnreachableError
from brdf_suite.geometry.directions import aspecular_view, illumination
from brdf_suite.paint_design.angle_sets import DIGITS
from brdf_suite.paint_design.feasible_colours import nearest_in_cone
from brdf_suite.pipeline.lobe_fit import LobeFit, PaintFitter
from brdf_suite.progress import Progress, report
from brdf_suite.reflectance.designed.build import DarkerThanCoatError, build_paint, gloss_of_coat
from brdf_suite.reflectance.models.cosine_lobes import lobe_sums

TOLERANCE_DELTA_E = 1.0
"""ΔE00 at the readings within which a fit gives what is asked: more is seen, patch beside patch."""

_MOST_FITS = 16
_HALVINGS = 18
_COAT_HALVINGS = 8
_GLOSS_DIGITS = 1
_STEPS_FROM_EDGE = 2
# Coats that are tried for one with which the colours can be: from the glossiest to the dullest.
_TRIED_ROUGHNESSES = (LOWEST_ROUGHNESS, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.4)
_MOST_LIFTS = 12
_FAR_DELTA_E = 3.0
"""ΔE00 beyond which a colour is another colour: rather than that, the coat is moved."""


@dataclass(frozen=True, eq=False)
class Feasible:
    """A paint that can be, near to one that cannot: its fit, and ΔE00 from the asked colours per reading (n,).

    ``gloss_changed``: whether the gloss readings differ too.
    """

    asked: Paint
    fit: LobeFit
    delta_e: tuple[float, ...]

    @property
    def paint(self) -> Paint:
        """The paint to take."""
        return self.fit.paint

    @property
    def worst_delta_e(self) -> float:
        """The largest ΔE00 between an asked colour and the offered one."""
        return max(self.delta_e)

    @property
    def gloss_changed(self) -> bool:
        """Whether the gloss is another."""
        return self.paint.gloss != self.asked.gloss


def judged(fit: LobeFit) -> list[int]:
    """Return the readings under the light that most have: the ones that lobes are fitted to."""
    main = fit.paint.main_light_deg
    return [index for index, row in enumerate(fit.readings) if row.illumination_deg == main]


def is_feasible(fit: LobeFit, tolerance: float = TOLERANCE_DELTA_E) -> bool:
    """Return whether the lobes give every judged colour within ``tolerance``, ΔE00."""
    return all(fit.readings[index].delta_e_2000 <= tolerance for index in judged(fit))


def nearest_feasible(
    paint: Paint,
    fitter: PaintFitter,
    tolerance: float = TOLERANCE_DELTA_E,
    progress: Progress | None = None,
) -> Feasible | None:
    """Return the nearest paint that the whole road gives within ``tolerance``, or None where none was found.

    ``fitter`` is one of the calling thread, patient: no exact fit is waited for. A paint that can be is its own
    nearest.

    Raises :class:`Cancelled`: the progress callback asked for it.
    """
    report(progress, 0.0, "looking for the nearest paint")
    found = []
    for start in _starts(paint):
        moved = _agreed(paint, start, fitter, tolerance, progress)
        if moved is not None and moved.worst_delta_e <= _FAR_DELTA_E:
            return moved
        found.append(moved)
    found.append(_under_glossier_coat(paint, fitter, tolerance, progress))
    offers = [offer for offer in found if offer is not None]
    return min(offers, key=lambda offer: offer.worst_delta_e, default=None)


def _starts(paint: Paint) -> Iterator[Paint]:
    """Yield the nearest paint that can be; of one with another gloss also some a little further from the gloss asked.

    At the very edge of what can be next to nothing of a dark channel is left to the base, which lobes may not meet.
    """
    possible = nearest_reachable(paint)
    if possible is None:
        return
    yield possible
    gloss, asked = possible.gloss, paint.gloss.gu_20
    if gloss.gu_20 == asked:
        return
    for steps in range(1, _STEPS_FROM_EDGE + 1):
        away = math.copysign(steps * 10.0**-_GLOSS_DIGITS, gloss.gu_20 - asked)
        inside = replace(possible, gloss=replace(gloss, gu_20=round(gloss.gu_20 + away, _GLOSS_DIGITS)))
        if _refusal(inside) is None:
            yield inside


def _agreed(
    paint: Paint, possible: Paint, fitter: PaintFitter, tolerance: float, progress: Progress | None
) -> Feasible | None:
    """The paint whose fit gives what it asks, from a ``possible`` one on; None where asked and given never agree."""
    fit = fitter.fit(possible)
    if not is_feasible(fit, tolerance):
        nearest = _fitted(_with_labs(possible, _in_cone(fit)), fitter)
        fit = fit if nearest is None else nearest
    for turn in range(_MOST_FITS):
        report(progress, turn / _MOST_FITS, "looking for the nearest paint")
        if is_feasible(fit, tolerance):
            labs = [np.array([item.lab for item in one.measurements]) for one in (paint, fit.paint)]
            return Feasible(paint, fit, tuple(delta_e_2000(*labs).tolist()))
        given = np.array([row.lab for row in fit.readings])
        rows = judged(fit)
        given[rows] = [fit.readings[index].lab_fitted for index in rows]
        if turn >= _MOST_FITS // 2:
            # Rule and fit can answer each other by turns: half steps meet in the middle.
            given = 0.5 * (given + np.array([row.lab for row in fit.readings]))
        following = _fitted(_with_labs(fit.paint, given), fitter)
        if following is None:
            return None
        fit = following
    return None


def _under_glossier_coat(
    paint: Paint, fitter: PaintFitter, tolerance: float, progress: Progress | None
) -> Feasible | None:
    """The paint's own colours, or ones near to them, under the nearest glossier coat with which they can be, or None.

    A smoother coat mirrors less beside the mirror direction, which leaves more of a dark colour to the base.
    """

    def under(gloss: Gloss) -> Feasible | None:
        glossier = replace(paint, gloss=gloss)
        if _refusal(glossier) is not None:
            return None
        found = _agreed(paint, glossier, fitter, tolerance, progress)
        return found if found is not None and found.worst_delta_e <= _FAR_DELTA_E else None

    good: Feasible | None = None
    for gloss in reversed(_tried_coats(paint)):
        if gloss.gu_20 > paint.gloss.gu_20 and (good := under(_mixed(gloss, gloss, 0.0))) is not None:
            break
    if good is None:
        return None
    best, low, high = good, 0.0, 1.0
    for _ in range(_COAT_HALVINGS):
        middle = 0.5 * (low + high)
        found = under(_mixed(good.paint.gloss, paint.gloss, middle))
        if found is None:
            high = middle
        else:
            low, best = middle, found
    return best


def nearest_reachable(paint: Paint) -> Paint | None:
    """Return the paint, with gloss and the colours that are darker than the coat moved as little as it takes.

    It has a reflectance; whether lobes give its colours is another matter. None where no coat was found at all.
    """
    if _refusal(paint) is None:
        return paint
    lifted = _lifted(paint)
    if lifted is not None:
        return lifted
    starts = [gloss for gloss in _tried_coats(paint) if _refusal(replace(paint, gloss=gloss)) is None]
    if not starts:
        return None
    start = min(starts, key=lambda gloss: _gloss_apart(gloss, paint.gloss))
    return replace(paint, gloss=_towards(paint, start))


def _tried_coats(paint: Paint) -> list[Gloss]:
    """The gloss of each tried coat that the paint can have, in the readings that it has."""
    found = []
    for roughness in _TRIED_ROUGHNESSES:
        with contextlib.suppress(UnreachableError):
            gloss = gloss_of_coat(paint, USUAL_IOR, roughness)
            found.append(gloss if paint.gloss.gu_60 is not None else Gloss(gloss.gu_20))
    return found


def _refusal(paint: Paint) -> UnreachableError | None:
    try:
        build_paint(paint)
    except UnreachableError as error:
        return error
    return None


def _lifted(paint: Paint) -> Paint | None:
    """The paint with each colour that is darker than its coat lifted to it, where that is all that is wrong."""
    for _ in range(_MOST_LIFTS):
        error = _refusal(paint)
        if error is None:
            return paint
        if not isinstance(error, DarkerThanCoatError):
            return None
        light, angle = error.measurement
        index = paint.index_of(angle, light)
        # A hundredth above the coat, so that rounding the numbers does not put the colour below it again.
        rho = np.maximum(lab_to_working(paint.measurements[index].lab), 1.01 * error.share + 1e-5)
        labs = [measurement.lab for measurement in paint.measurements]
        labs[index] = _lab(working_to_lab(rho))
        paint = _with_labs(paint, labs)
    return None


def _towards(paint: Paint, good: Gloss) -> Gloss:
    """The gloss nearest to the paint's own on the way from a ``good`` one: both readings, then each by itself."""
    wanted = paint.gloss
    both = _farthest(paint, good, wanted)
    if wanted.gu_60 is None or both.gu_60 is None:
        return both
    first = _farthest(paint, both, replace(wanted, gu_60=both.gu_60))
    return _farthest(paint, first, replace(wanted, gu_20=first.gu_20))


def _farthest(paint: Paint, start: Gloss, wanted: Gloss) -> Gloss:
    """The gloss nearest to the wanted one on the way from ``start`` with which the paint can be, as it can there."""
    if _refusal(replace(paint, gloss=_mixed(start, wanted, 1.0))) is None:
        return _mixed(start, wanted, 1.0)
    low, high, found = 0.0, 1.0, _mixed(start, wanted, 0.0)
    for _ in range(_HALVINGS):
        middle = 0.5 * (low + high)
        gloss = _mixed(start, wanted, middle)
        if _refusal(replace(paint, gloss=gloss)) is None:
            low, found = middle, gloss
        else:
            high = middle
    return found


def _mixed(start: Gloss, wanted: Gloss, share: float) -> Gloss:
    """The gloss at a share of the way, in tenths of a gloss unit; at 60° where both have it."""
    gu_20 = start.gu_20 + share * (wanted.gu_20 - start.gu_20)
    if start.gu_60 is None or wanted.gu_60 is None:
        return Gloss(round(gu_20, _GLOSS_DIGITS))
    gu_60 = start.gu_60 + share * (wanted.gu_60 - start.gu_60)
    return Gloss(round(gu_20, _GLOSS_DIGITS), round(gu_60, _GLOSS_DIGITS))


def _gloss_apart(one: Gloss, other: Gloss) -> float:
    at_60 = 0.0 if one.gu_60 is None or other.gu_60 is None else one.gu_60 - other.gu_60
    return abs(one.gu_20 - other.gu_20) + abs(at_60)


def cone_of_lobes(fit: LobeFit) -> tuple[Floats, Floats]:
    """Return what its lobes can give at the k judged readings: ρ (k, m) of each at weight 1, and of the coat (k,).

    The first column is the diffuse term, the others are the directional-diffuse lobes. With weights x ≥ 0 a channel
    is the coat's share plus the columns times x.
    """
    weights = fit.weights
    rows = [fit.readings[index] for index in judged(fit)]
    lights = np.array([row.illumination_deg for row in rows])
    wi = illumination(lights)
    wo = aspecular_view(lights, np.array([row.aspecular_deg for row in rows]))
    count = len(weights.exponents)
    nothing = np.zeros((count, 3))
    # One lobe at a time, as the three channels of sums; the fit's own gloss lobes are the coat's share.
    columns = [np.ones(len(rows))]
    for k in range(count):
        single = nothing.copy()
        single[k] = 1.0
        columns.append(lobe_sums(wi, wo, weights.exponents, np.zeros(3), single, nothing).base[:, 0])
    coat = lobe_sums(wi, wo, weights.exponents, np.zeros(3), nothing, weights.kg).brdf()[:, 0]
    return np.pi * np.stack(columns, axis=1), np.pi * coat


def _in_cone(fit: LobeFit) -> list[Lab]:
    """The colours nearest to the paint's own that its lobes can give at its readings."""
    columns, coat = cone_of_lobes(fit)
    reached = nearest_in_cone(columns, coat, [fit.readings[index].lab for index in judged(fit)])
    labs = [row.lab for row in fit.readings]
    for index, lab in zip(judged(fit), reached, strict=True):
        labs[index] = _lab(lab)
    return labs


def _lab(row: np.ndarray[tuple[int], np.dtype[np.float64]]) -> Lab:
    lightness, a, b = (round(float(value), DIGITS) + 0.0 for value in row)
    return max(lightness, 0.0), a, b


def _with_labs(paint: Paint, labs: object) -> Paint:
    rows = [_lab(np.asarray(row, float)) for row in np.asarray(labs, float)]
    changed = (replace(item, lab=lab) for item, lab in zip(paint.measurements, rows, strict=True))
    return replace(paint, measurements=tuple(changed))


def _fitted(paint: Paint, fitter: PaintFitter) -> LobeFit | None:
    try:
        return fitter.fit(paint)
    except UnreachableError:
        lifted = nearest_reachable(paint)
        return None if lifted is None else fitter.fit(lifted)
