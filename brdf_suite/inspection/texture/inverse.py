"""Flakes that have wanted readings: their density, size and spread of tilts.

The expected readings are matched by least squares of relative errors: from the given flakes, from a few others, and
after a search of the whole range. Where several flakes have the readings (what is seen of small ones depends on their
number alone, once the paint's colour limits their light), those nearest to the given ones are preferred.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import product

import numpy as np
import scipy  # its optimize is loaded when it is used: 0.2 s that the start of Designer is spared

from brdf_suite.appearance.flakes.visible import flake_coverage, full_density
from brdf_suite.appearance.texture import LIGHTS_DEG, PaintLight
from brdf_suite.arrays import Floats
from brdf_suite.documents.paint import Flakes
from brdf_suite.errors import ValueRangeError
from brdf_suite.inspection.texture.expectation import expected_scales
from brdf_suite.progress import Progress, report

SCALES = (*(f"sparkle grade {light:g}°" for light in LIGHTS_DEG), "graininess")
"""What is wanted, in the order of ``TextureReadings.scales``."""
REACHED = 0.05
"""Relative error of each expected reading up to which flakes have it."""
COVERAGE, SIZE_UM, ROUGHNESS = (5e-3, 1.0), (5.0, 100.0), (0.03, 0.6)
"""Ranges in which flakes are looked for."""

LEAST = np.array([0.02, 0.02, 0.02, 0.001])
"""Readings (4,) that are as good as none: errors are over the wanted ones, or over these where those are less."""
_NEARNESS = 1e-3
_EXACT, _MOST_STEPS = 0.01, 40
_CROWD, _GENERATIONS = 10, 30
_STARTS = ((0.3, 0.9, 0.03), (12.0, 30.0), (0.16, 0.22))


@dataclass(frozen=True)
class FoundFlakes:
    """Flakes nearest to what was wanted.

    ``scales`` (4,) are their expected readings, ``errors`` (4,) those over the wanted ones, minus 1; 0 where nothing
    was wanted.
    """

    flakes: Flakes
    scales: tuple[float, ...]
    errors: tuple[float, ...]

    @property
    def reached(self) -> bool:
        """Whether they have all the readings."""
        return max(abs(error) for error in self.errors) <= REACHED

    def sentence(self) -> str:
        """Return what cannot be reached, what is nearest, and by how much it differs; empty where all is reached."""
        if self.reached:
            return ""
        missed = "; ".join(
            f"{name}: nearest {100.0 * value:.3g} %, {100.0 * error:+.0f} %"
            for name, value, error in zip(SCALES, self.scales, self.errors, strict=True)
            if abs(error) > REACHED
        )
        return f"Not reachable with flakes in a paint of this colour: {missed}."


def find_flakes(
    paint: PaintLight,
    wanted: Sequence[float | None],
    start: Flakes | None = None,
    progress: Progress | None = None,
) -> FoundFlakes:
    """Return the flakes whose expected readings are nearest to the wanted ones.

    Parameters
    ----------
    wanted
        (4,) as :data:`SCALES`, ≥ 0; None where it is left open.
    start
        The flakes that the answer shall be near to where others would do as well; it keeps their colour spread.

    Raises
    ------
    ValueRangeError
        There are not four, none is given, or one is negative or not finite.
    Cancelled
        The progress callback asked for it.
    """
    if len(wanted) != len(SCALES) or all(value is None for value in wanted):
        raise ValueRangeError("wanted", f"expected up to {len(SCALES)} readings, at least one")
    for name, value in zip(SCALES, wanted, strict=True):
        if value is not None and not (math.isfinite(value) and value >= 0.0):
            raise ValueRangeError(name, f"expected a number of at least 0, not {value!r}")
    asked = np.array([value is not None for value in wanted])
    target = np.array([0.0 if value is None else value for value in wanted])
    near = start or Flakes()
    bounds = np.log(np.array([COVERAGE, SIZE_UM, ROUGHNESS]).T)
    at_start = np.clip(_place(near), *bounds)

    def errors(place: Floats) -> Floats:
        scales = expected_scales(paint, _flakes(place, near))
        return np.where(asked, (scales - target) / np.maximum(target, LEAST), 0.0)

    def residuals(place: Floats) -> Floats:
        # Large errors count by their logarithm, so that the way back from a far start is not a cliff.
        away = errors(place)
        return np.concatenate([np.sign(away) * np.log1p(np.abs(away)), _NEARNESS * (place - at_start)])

    def walked(place: Floats) -> tuple[float, Floats]:
        low, high = bounds
        place = np.clip(place, low + 1e-6, high - 1e-6)
        found = scipy.optimize.least_squares(
            residuals,
            place,
            bounds=(low, high),
            x_scale=0.1,
            diff_step=np.full(3, 1e-3),
            max_nfev=_MOST_STEPS,
        )
        return float(np.abs(errors(found.x)).max()), found.x

    def cost(place: Floats) -> float:
        return float((residuals(place) ** 2).sum())

    def watch(*_: object, **__: object) -> None:
        report(progress, 0.7, "looking for flakes")

    # Flakes of like readings lie in narrow valleys, which are walked down: that of the given ones first.
    starts = [at_start, *(np.log(place) for place in product(*_STARTS))]
    tried = []
    for k, place in enumerate(starts):
        report(progress, 0.5 * k / len(starts), "looking for flakes")
        tried.append(walked(place))
        if tried[-1][0] <= _EXACT:
            break
    else:
        coarse = scipy.optimize.differential_evolution(
            cost,
            scipy.optimize.Bounds(bounds[0], bounds[1]),
            popsize=_CROWD,
            maxiter=_GENERATIONS,
            rng=0,
            polish=False,
            callback=watch,
        )
        tried.append(walked(coarse.x))
    best = min(tried, key=lambda one: one[0])[1]
    exact = _flakes(best, near)
    flakes = replace(
        near,
        density_per_mm2=float(f"{exact.density_per_mm2:.4g}"),
        size_um=round(exact.size_um, 2),
        roughness=round(exact.roughness, 4),
    )
    scales = expected_scales(paint, flakes)
    away = np.where(asked, (scales - target) / np.maximum(target, LEAST), 0.0)
    return FoundFlakes(flakes, tuple(scales.tolist()), tuple(away.tolist()))


def _place(flakes: Flakes) -> Floats:
    return np.log([max(flake_coverage(flakes), 1e-9), flakes.size_um, flakes.roughness])


def _flakes(place: Floats, near: Flakes) -> Flakes:
    coverage, size, roughness = np.exp(place).tolist()
    density = min(coverage * full_density(size), 100_000.0)
    return replace(near, density_per_mm2=density, size_um=size, roughness=roughness)
