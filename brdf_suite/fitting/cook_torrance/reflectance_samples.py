"""Samples for a fit of lobes from anything that reflects, and the errors of the fit over all of it.

A table gives the bins that were measured, at their centres, and the better known ones count more; scattered samples are
taken as they are, the rarer ones counting more; whatever can be asked anywhere (a material of RGL, a paint) is asked at
pairs even over √θh, θd and φd.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from brdf_suite.arrays import Bools, Floats, Singles
from brdf_suite.fitting.cook_torrance.samples import Floor, LobeSamples, check_samples, even_weights, spread
from brdf_suite.fitting.cook_torrance.settings import Settings
from brdf_suite.geometry.directions import from_half_angle_coordinates
from brdf_suite.progress import Progress, report
from brdf_suite.reflectance.protocol import Reflectance
from brdf_suite.reflectance.tabulated.isotropic import IsotropicTable
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples

MISFIT = 0.05
"""What a model misses of a measurement anyway, relative: bins known better than this count alike."""
ASKED = 60_000
"""Pairs at which what can be asked anywhere is judged."""
_BLOCK = 200_000


@dataclass(frozen=True)
class FitErrors:
    """Errors of a fit over ``values`` single values (of one channel), of which ``compared`` have a logarithm.

    ``l1_mean``: mean |ln(fit/measured)|, both with the floor of the fit where it has one; ``log_rms``: its RMS;
    ``median_relative``: median of |fit/measured - 1|, likewise; ``relative_rms``: RMS of the differences over the RMS
    of the values.
    """

    values: int
    compared: int
    l1_mean: float
    log_rms: float
    median_relative: float
    relative_rms: float


def samples_of(reflectance: Reflectance, settings: Settings) -> LobeSamples:
    """Return the samples that a fit looks at, no more than it asks for, spread over θh and θd.

    Raises
    ------
    FittingError
        There is nothing that can be fitted.
    """
    if isinstance(reflectance, IsotropicTable):
        return _of_table(reflectance, settings)
    if isinstance(reflectance, ScatteredSamples):
        wi, wo = reflectance.wi, reflectance.wo
        weights = even_weights(wi, wo) if len(wi) <= settings.samples else None
        found = check_samples(wi, wo, reflectance.values, weights, settings.grazing_deg)
        return found.fewer(settings.samples, settings.seed)
    wi, wo = even_pairs(settings.samples, settings.seed, settings.grazing_deg)
    return check_samples(wi, wo, reflectance.eval(wi, wo), None, settings.grazing_deg)


def even_pairs(count: int, seed: int, grazing_deg: float) -> tuple[Floats, Floats]:
    """Return wi, wo (count, 3), even over √θh, θd, φd and φh, neither beyond ``grazing_deg``."""
    rng = np.random.default_rng(seed)
    lowest = math.cos(math.radians(grazing_deg))
    light, view = np.empty((0, 3)), np.empty((0, 3))
    while len(light) < count:
        h, d, turn, around = rng.random((4, 3 * count))
        wi, wo = from_half_angle_coordinates(
            0.5 * math.pi * h**2, 2.0 * math.pi * around, 0.5 * math.pi * d, math.pi * turn
        )
        seen = (wi[:, 2] >= lowest) & (wo[:, 2] >= lowest)
        light, view = np.concatenate((light, wi[seen])), np.concatenate((view, wo[seen]))
    return light[:count], view[:count]


def errors_of(
    fit: Reflectance,
    reflectance: Reflectance,
    grazing_deg: Sequence[float],
    floor: Floor | None = None,
    progress: Progress | None = None,
) -> list[FitErrors]:
    """Return the errors over every measured bin or sample (or :data:`ASKED` pairs), once for each angle.

    ``grazing_deg``: errors are over pairs whose light and view are not beyond this angle from the normal.
    """
    floor = floor or Floor()
    sums = [_Sums(math.cos(math.radians(angle))) for angle in grazing_deg]
    for fraction, wi, wo, measured in _everything(reflectance, max(grazing_deg)):
        report(progress, fraction, "errors")
        lower = np.minimum(wi[:, 2], wo[:, 2])
        # At the horizon itself, to rounding, there is no f_r.
        seen = (lower > 0.0) & np.isfinite(measured).all(axis=1)
        data = np.maximum(measured[seen].astype(np.float64), 0.0)
        found, added = fit.eval(wi[seen], wo[seen]), floor.at(data)[:, None]
        for one in sums:
            one.add(data, found, added, lower[seen] >= one.lowest)
    return [one.errors() for one in sums]


class _Sums:
    """Sums of the errors of pairs with both cosines at least ``lowest``."""

    def __init__(self, lowest: float) -> None:
        self.lowest = lowest
        self._values = self._compared = 0
        self._total = self._squares = self._missed = self._size = 0.0
        self._relative: list[Singles] = []

    def add(self, data: Floats, found: Floats, added: Floats, mask: Bools) -> None:
        if not mask.all():
            data, found, added = data[mask], found[mask], added[mask]
        self._values += data.size
        self._missed += float(((found - data) ** 2).sum())
        self._size += float((data**2).sum())
        both = (data + added > 0.0) & (found + added > 0.0)
        ratio = (found + added)[both] / (data + added)[both]
        logs = np.log(ratio)
        self._compared += logs.size
        self._total += float(np.abs(logs).sum())
        self._squares += float((logs**2).sum())
        self._relative.append(np.abs(ratio - 1.0).astype(np.float32))

    def errors(self) -> FitErrors:
        count = self._compared
        if count == 0:
            return FitErrors(self._values, 0, 0.0, 0.0, 0.0, 0.0)
        return FitErrors(
            self._values,
            count,
            self._total / count,
            math.sqrt(self._squares / count),
            float(np.median(np.concatenate(self._relative))),
            math.sqrt(self._missed / self._size) if self._size > 0.0 else 0.0,
        )


def _everything(
    reflectance: Reflectance, grazing_deg: float
) -> Iterator[tuple[float, Floats, Floats, Floats]]:
    """Yield (share done, wi, wo, values) of all that there is."""
    if isinstance(reflectance, IsotropicTable):
        mask = reflectance.measured_mask()
        count = len(mask)
        for h in range(count):
            if mask[h].any():
                wi, wo = reflectance.grid.pairs(h)
                yield h / count, wi[mask[h]], wo[mask[h]], reflectance.values[h][mask[h]]
    elif isinstance(reflectance, ScatteredSamples):
        for start in range(0, len(reflectance.wi), _BLOCK):
            part = slice(start, start + _BLOCK)
            yield (
                start / len(reflectance.wi),
                reflectance.wi[part],
                reflectance.wo[part],
                reflectance.values[part],
            )
    else:
        wi, wo = even_pairs(ASKED, 1, grazing_deg)
        yield 0.0, wi, wo, reflectance.eval(wi, wo)


def _of_table(table: IsotropicTable, settings: Settings) -> LobeSamples:
    grid = table.grid
    theta_h, theta_d, phi_d = grid.centres()
    # z of the two directions is cos θh cos θd ∓ sin θh sin θd cos φd.
    along = np.outer(np.cos(theta_h), np.cos(theta_d))
    across = np.outer(np.sin(theta_h), np.sin(theta_d))
    lower = along[:, :, None] - across[:, :, None] * np.abs(np.cos(phi_d))
    mask = table.measured_mask() & (lower >= math.cos(math.radians(settings.grazing_deg)))
    # A value that has no logarithm in any channel would only take another's turn.
    mask &= (table.values > 0.0).any(axis=-1)
    h, d, p = np.nonzero(mask)
    chosen = spread(theta_h[h], theta_d[d], settings.samples, settings.seed)
    h, d, p = h[chosen], d[chosen], p[chosen]
    wi, wo = from_half_angle_coordinates(theta_h[h], 0.0, theta_d[d], phi_d[p])
    weights = None
    if table.coverage is not None:
        weights = 1.0 / np.hypot(table.coverage.deviation[h, d, p].astype(np.float64), MISFIT)
    return check_samples(wi, wo, table.values[h, d, p], weights)
