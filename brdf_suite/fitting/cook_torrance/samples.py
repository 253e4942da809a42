"""Samples of a fit: checked, and thinned evenly over θh and θd.

Most bins of a table, and most samples of a gonioreflectometer, lie far from the peak; and θd alone determines the
lobes' Fresnel reflectance from their weight (section 4.2 of Günther et al. 2005 samples its table by θh for that
reason). So where there are more than a fit needs, they are taken by turns from the cells of a grid over √θh and θd.

Values of 0 or less have no logarithm. A few are left out. Many are no accident: the colour is outside of the working
space, so that a channel was cut at 0 (of Cayman nine tenths of the red ones), or the reading drowned in noise. Left
out, they would leave that channel to the few bright samples. So then a floor is added to the values and to the fit
alike: a hundredth of the sample's brightest channel, and a fiftieth of what the brightest channel is in the median.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Bools, Floats, Indices, Singles
from brdf_suite.errors import FittingError
from brdf_suite.fitting.cook_torrance.settings import Settings
from brdf_suite.geometry.directions import from_half_angle_coordinates
from brdf_suite.progress import Progress, report
from brdf_suite.reflectance.protocol import Reflectance
from brdf_suite.reflectance.tabulated.isotropic import PIXEL_FACT, IsotropicTable
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples

CELLS = (60, 30)
"""Cells along √θh and along θd."""
REGIONS = (12, 6)
"""The same of the regions within which errors are taken to agree."""
FLOOR_SHARE, FLOOR_DARK = 0.01, 0.02
"""Of the sample's brightest channel, and of its median over the samples."""
_MANY = 1e-3
MISFIT = 0.05
"""What a model misses of a measurement anyway, relative: bins known better than this count alike."""
ASKED = 60_000
"""Pairs at which what can be asked anywhere is judged."""
_BLOCK = 200_000


@dataclass(frozen=True)
class Floor:
    """Offset added to every value, and to the fit, before the logarithm.

    ``share`` of a sample's brightest channel, and ``dark``, 1/sr.
    """

    share: float = 0.0
    dark: float = 0.0

    @classmethod
    def of(cls, values: Floats) -> Floor:
        """Return the floor that values (n, 3) need: none, unless more than a thousandth are 0 or less."""
        seen = values[(values > 0.0).any(axis=1)]
        if np.count_nonzero(seen <= 0.0) <= _MANY * seen.size:
            return cls()
        return cls(FLOOR_SHARE, FLOOR_DARK * float(np.median(seen.max(axis=1))))

    def at(self, values: Floats) -> Floats:
        """Return what is added (n,) to values (n, 3), 1/sr."""
        return np.asarray(self.share * np.maximum(values.max(axis=1), 0.0) + self.dark)


@dataclass(frozen=True)
class Instrument:
    """Errors of measurement that more samples do not average out; 0 where nothing is known of them.

    ``pixel_rad``: the angle that a pixel in the middle of a photographed sphere covers of it, over which the normal
    turns. ``relative_error``: of the values, alike within a region of the samples, by geometry and response.
    """

    pixel_rad: float = 0.0
    relative_error: float = 0.0

    @classmethod
    def of(cls, table: IsotropicTable) -> Instrument:
        """Return what is known of the instrument of a table: something of those that were acquired from photographs."""
        pixel = table.facts.get(PIXEL_FACT, 0.0)
        known = isinstance(pixel, float) and 0.0 < pixel < 90.0
        return cls(math.radians(pixel), ACQUIRED_ERROR) if known else EXACT

    def tilt_rad(self, samples: LobeSamples) -> Floats:
        """Return the standard deviation (n,) of the normal's tilt over a pixel, along each of two axes, radians.

        A pixel covers more of a surface that is seen at an angle; which of the two directions is the view, a reciprocal
        table does not say.
        """
        slanted = 1.0 / (samples.wi[:, 2] * samples.wo[:, 2])
        return np.asarray(self.pixel_rad * np.sqrt((1.0 + slanted) / 24.0))


EXACT = Instrument()
ACQUIRED_ERROR = 0.02
"""As much as a reading of an acquisition is taken to be wrong by geometry
(:data:`brdf_suite.acquisition.table.sums.GEOMETRIC_ERROR`)."""


@dataclass(frozen=True, eq=False)
class LobeSamples:
    """Samples of a fit.

    ``wi``, ``wo`` (n, 3) unit directions; ``logs`` (3, n) natural logarithms of f_r in 1/sr and what is added to it,
    ``added`` (n,) by the ``floor``; 0 where ``known`` (3, n) is false; ``weights`` (n,) > 0 with mean 1.
    ``left_out``: how many were not finite, beyond the grazing angle, of no weight or black; ``black``: how many values
    (of one channel) of the others are not positive, and ``black_share`` which share. ``instrument``: what they were
    measured with.
    """

    wi: Floats
    wo: Floats
    logs: Floats
    known: Bools
    weights: Floats
    added: Floats
    floor: Floor
    left_out: int
    black: int
    black_share: float
    instrument: Instrument = field(default_factory=lambda: EXACT)

    def __len__(self) -> int:
        return len(self.wi)

    @property
    def channels(self) -> Bools:
        """Return (3,): in which channels there is anything."""
        return np.asarray(self.known.any(axis=1))

    @property
    def regions(self) -> Indices:
        """Return (n,) in which region of √θh and θd each sample lies, numbered from 0 without gaps."""
        cell = _cells(*half_and_difference(self.wi, self.wo), *REGIONS)
        return np.asarray(np.unique(cell, return_inverse=True)[1])

    def part(self, keep: npt.ArrayLike) -> LobeSamples:
        """Return some of them: a mask (n,) or indices."""
        at = np.asarray(keep)
        rows = {name: getattr(self, name)[at] for name in ("wi", "wo", "weights", "added")}
        return replace(self, logs=self.logs[:, at], known=self.known[:, at], **rows)

    def fewer(self, most: int, seed: int) -> LobeSamples:
        """Return at most ``most`` of them, spread over θh and θd."""
        if len(self) <= most:
            return self
        return self.part(spread(*half_and_difference(self.wi, self.wo), most, seed))


def check_samples(
    wi: npt.ArrayLike,
    wo: npt.ArrayLike,
    values: npt.ArrayLike,
    weights: npt.ArrayLike | None = None,
    grazing_deg: float = 90.0,
    floor: Floor | None = None,
) -> LobeSamples:
    """Return the samples that a fit of logarithms can use.

    Parameters
    ----------
    wi, wo
        (n, 3) unit directions, local frame.
    values
        (n, 3) f_r in 1/sr. Samples that are not finite are left out; negative values are taken for 0.
    weights
        (n,) how much each counts, at least 0; all alike if left out.
    floor
        What is added; what the values themselves need, if left out.

    Raises
    ------
    FittingError
        A shape does not fit, directions are not finite unit vectors, weights are negative or not finite, or nothing
        is left.
    """
    light, view = _directions("wi", wi), _directions("wo", wo)
    data = np.asarray(values, np.float64)
    if len(light) != len(view) or data.shape != (len(light), 3):
        shapes = f"wi {light.shape}, wo {view.shape}, values {data.shape}"
        raise FittingError(f"The samples do not fit together: {shapes}; expected (n, 3) of each.")
    share = np.ones(len(light)) if weights is None else np.asarray(weights, np.float64)
    if share.shape != (len(light),) or not np.all(np.isfinite(share)) or np.any(share < 0.0):
        raise FittingError(f"The weights must be {len(light)} finite numbers, none negative.")
    lowest = max(np.cos(np.radians(grazing_deg)), 1e-6)
    seen = (light[:, 2] >= lowest) & (view[:, 2] >= lowest) & (share > 0.0)
    seen &= np.isfinite(data).all(axis=1)
    found = np.maximum(data[seen], 0.0)
    floor = Floor.of(data[seen]) if floor is None else floor
    raised = found + floor.at(found)[:, None]
    # A channel of nothing at all is none, whatever the floor.
    known = (raised > 0.0) & (found > 0.0).any(axis=0)
    used = known.any(axis=1)
    count = int(used.sum())
    if count == 0:
        raise FittingError(
            f"None of the {len(light):,} samples can be fitted: they are black, not finite, without weight, or seen "
            f"at more than {grazing_deg:g}° from the normal."
        )
    kept = known[used].T
    logs = np.zeros(kept.shape)
    np.log(raised[used].T, out=logs, where=kept)
    chosen = share[seen][used]
    black = int(np.count_nonzero(found[used] <= 0.0))
    return LobeSamples(
        light[seen][used],
        view[seen][used],
        logs,
        np.ascontiguousarray(kept),
        chosen / chosen.mean(),
        floor.at(found[used]),
        floor,
        len(light) - count,
        black,
        black / (3 * count),
    )


def even_weights(wi: Floats, wo: Floats) -> Floats:
    """Return weights (n,) with mean 1 by which samples count alike all over √θh and θd.

    Each counts by how few share its cell, up to thirty times as much as where they are dense: what is measured at equal
    steps of the view has few samples in the peak, and a sum of logarithms would leave it out.
    """
    theta_h, theta_d = half_and_difference(wi, wo)
    cell = _cells(theta_h, theta_d, CELLS[0] / 3, CELLS[1] / 3)
    share = 1.0 / np.bincount(cell)[cell]
    share = np.minimum(share, 30.0 * float(share.min()))
    return np.asarray(share / share.mean())


def _cells(theta_h: Floats, theta_d: Floats, rows: float, columns: float) -> Indices:
    """Return the cells (n,) of a grid of so many rows over √θh and columns over θd."""
    row = np.minimum(np.sqrt(theta_h * (2.0 / np.pi)) * rows, rows - 1).astype(np.intp)
    column = np.minimum(theta_d * (2.0 / np.pi) * columns, columns - 1).astype(np.intp)
    return np.asarray(row * CELLS[1] + column)


def half_and_difference(wi: Floats, wo: Floats) -> tuple[Floats, Floats]:
    """Return θh and θd (n,), radians, exact also where they are tiny."""
    total, apart = wi + wo, wi - wo
    theta_h = np.arctan2(np.hypot(total[:, 0], total[:, 1]), total[:, 2])
    lengths = [np.sqrt(np.einsum("nk,nk->n", v, v)) for v in (apart, total)]
    return np.asarray(theta_h), np.asarray(np.arctan2(*lengths))


def spread(theta_h: Floats, theta_d: Floats, most: int, seed: int) -> Indices:
    """Return places, rising, of at most ``most`` pairs taken by turns from the cells over √θh and θd (radians)."""
    rng = np.random.default_rng(seed)
    # Ranking a million by cell takes longer than the fit; a few times as many as wanted fill the cells as well.
    chosen = np.arange(len(theta_h))
    if len(chosen) > 40 * most:
        chosen = rng.choice(len(chosen), 40 * most, replace=False)
    cell = _cells(theta_h[chosen], theta_d[chosen], *CELLS)
    order = np.lexsort((rng.random(len(chosen)), cell))
    ordered = cell[order]
    first = np.searchsorted(ordered, ordered)
    turn = np.arange(len(order)) - first
    best = np.lexsort((rng.random(len(order)), turn))[:most]
    return np.sort(chosen[order[best]])


def _directions(name: str, value: npt.ArrayLike) -> Floats:
    found = np.asarray(value, np.float64)
    if found.ndim != 2 or found.shape[1] != 3:
        raise FittingError(f"The directions {name} have the shape {found.shape}; expected (n, 3).")
    length = np.einsum("nk,nk->n", found, found)
    # A NaN fails the comparison, as it should.
    wrong = np.flatnonzero(~(np.abs(length - 1.0) < 1e-4))
    if wrong.size:
        raise FittingError(f"The direction {name}[{wrong[0]}] is not of unit length.")
    return found


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

    A table gives the bins that were measured, at their centres, and the better known ones count more; scattered samples
    are taken as they are, the rarer ones counting more; whatever can be asked anywhere (a material of RGL, a paint) is
    asked at pairs even over √θh, θd and φd.

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
        angles = (0.5 * math.pi * h**2, 2.0 * math.pi * around, 0.5 * math.pi * d, math.pi * turn)
        wi, wo = from_half_angle_coordinates(*angles)
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


def errors_at(measured: Floats, found: Floats, floor: Floor | None = None) -> FitErrors:
    """Return the errors of fitted values (n, 3) beside measured ones, both f_r in 1/sr."""
    sums = _Sums(0.0)
    sums.add(measured, found, (floor or Floor()).at(measured)[:, None], np.ones(len(measured), np.bool_))
    return sums.errors()


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
            part, share = slice(start, start + _BLOCK), start / len(reflectance.wi)
            yield share, reflectance.wi[part], reflectance.wo[part], reflectance.values[part]
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
    return replace(check_samples(wi, wo, table.values[h, d, p], weights), instrument=Instrument.of(table))
