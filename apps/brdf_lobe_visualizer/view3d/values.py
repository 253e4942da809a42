"""Values over the lobe grid, kept per reflectance: nothing is worked out twice, and what is slow never holds a drag.

A reflectance whose last evaluation took longer than a frame may is worked out in the background from then on; until its
values are there, those of the incidence before are shown and marked as outdated.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
from brdf_qt.window.message_bar import message_of

from brdf_lobe_visualizer.session import LobeSession
from brdf_lobe_visualizer.subjects.subjects import Measured, PlottedMaterial
from brdf_suite.arrays import Singles
from brdf_suite.fitting.lobes.weights import LobeWeights
from brdf_suite.inspection.lobe_surface.grid import LobeGrid, lobe_grid
from brdf_suite.inspection.lobe_surface.parts import FitLobe, FitOnGrid, LobeSource
from brdf_suite.inspection.slices.values import Cosine, cosine_of
from brdf_suite.reflectance.protocol import Reflectance

SLOW_S = 0.025
"""Of the processor's time: what else the machine does, makes no reflectance slow."""


@dataclass
class _Kept:
    source: LobeSource
    grid: LobeGrid | None = None
    values: Singles | None = None
    seconds: float = 0.0
    before: Found | None = None
    """What another reflectance under the same key had: one that is edited is shown as it was, until it is there."""


@dataclass
class _KeptFit:
    weights: LobeWeights
    grid: LobeGrid
    fit: FitOnGrid
    sums: dict[tuple[FitLobe, ...], Singles] = field(default_factory=dict)


@dataclass(frozen=True, eq=False)
class Found:
    """f_r (rows, columns, 3) on a grid; ``stale`` where it is of another incidence or reflectance than is asked for."""

    grid: LobeGrid
    values: Singles
    stale: bool = False


class SpaceValues:
    """Evaluates the session's subjects; ``arrived()`` is called when values came from the background."""

    def __init__(self, session: LobeSession, arrived: Callable[[], None]) -> None:
        self._session, self._arrived = session, arrived
        self._grid: LobeGrid | None = None
        self.kept: dict[str, _Kept] = {}
        self._fits: dict[str, _KeptFit] = {}
        self._waiting: set[str] = set()

    @property
    def busy(self) -> bool:
        """Whether values are on their way."""
        return bool(self._waiting)

    def grid(self) -> LobeGrid:
        """Return the directions of the session's incidence, the same object as long as that stays."""
        light = self._session.light
        if self._grid is None or not np.array_equal(self._grid.wi, light):
            self._grid = lobe_grid(light)
        return self._grid

    def target(self, subject: PlottedMaterial) -> Found | None:
        """Return a subject's values; None where none have come yet, or it cannot be evaluated."""
        grid = self.grid()
        kept = self.kept.get(subject.key)
        if kept is None or not _same(kept.source, subject.reflectance, subject.measured):
            source = LobeSource(subject.reflectance, subject.measured)
            kept = self.kept[subject.key] = (
                _Kept(source, seconds=kept.seconds, before=_stale(kept)) if kept else _Kept(source)
            )
        if kept.grid is not grid:
            if kept.seconds <= SLOW_S:
                start = time.process_time()
                try:
                    kept.values, kept.grid = kept.source.brdf(grid), grid
                except Exception as error:  # noqa: BLE001 - an error of a model is reported and does not end the program
                    self._report(subject.key, error)
                    kept.values, kept.grid = np.full((*grid.shape, 3), np.nan, np.float32), grid
                # A hiccup of the machine does not send a fast one to the background for long.
                kept.seconds = 0.5 * kept.seconds + 0.5 * (time.process_time() - start)
            else:
                self._ask(subject.key, kept, grid)
        if kept.values is None or kept.grid is None:
            return kept.before
        return Found(kept.grid, kept.values, kept.grid is not grid)

    def fit(self, subject: PlottedMaterial, lobes: tuple[FitLobe, ...]) -> Found | None:
        """Return the values of some lobes of a subject's fit; None without a fit."""
        if subject.fit is None:
            return None
        grid, weights = self.grid(), subject.fit.weights
        kept = self._fits.get(subject.key)
        if kept is None or kept.weights is not weights or kept.grid is not grid:
            kept = self._fits[subject.key] = _KeptFit(weights, grid, FitOnGrid(weights, grid))
        if lobes not in kept.sums:
            kept.sums[lobes] = kept.fit.brdf(lobes)
        return Found(grid, kept.sums[lobes])

    def forget_others(self, keys: set[str]) -> None:
        """Keep nothing of subjects that have gone."""
        for table in (self.kept, self._fits):
            for key in [key for key in table if key not in keys]:
                del table[key]

    def _ask(self, key: str, kept: _Kept, grid: LobeGrid) -> None:
        # One at a time: while a light is dragged, the newest would cancel each before it has come to an end.
        if key in self._waiting:
            return
        self._waiting.add(key)

        def work(request: tuple[LobeSource, LobeGrid], _progress: object) -> tuple[Singles, float]:
            start = time.process_time()
            return request[0].brdf(request[1]), time.process_time() - start

        def done(answer: tuple[Singles, float]) -> None:
            self._waiting.discard(key)
            kept.values, kept.grid = answer[0], grid
            kept.seconds = 0.5 * (kept.seconds + answer[1])
            now = self.kept.get(key)
            if now is not None and now is not kept and now.values is None:
                now.before = _stale(kept)
            self._arrived()

        def failed(error: Exception) -> None:
            self._waiting.discard(key)
            kept.values, kept.grid = np.full((*grid.shape, 3), np.nan, np.float32), grid
            self._report(key, error)
            self._arrived()

        self._session.tasks.submit(f"space {key}", work, (kept.source, grid), done, failed)

    def _report(self, key: str, error: Exception) -> None:
        self._session.show_message(message_of(error, f"space {key}"))


def _stale(kept: _Kept) -> Found | None:
    if kept.values is None or kept.grid is None:
        return kept.before
    return Found(kept.grid, kept.values, stale=True)


def with_cosine(found: Found, cosine: Cosine) -> Singles:
    """Return the values multiplied with the cosines that the option says."""
    if cosine == "none":
        return found.values
    if cosine == "light":
        return found.values * np.float32(found.grid.wi[2])
    factor = cosine_of(cosine, found.grid.wi, found.grid.directions).astype(np.float32)
    return np.asarray(found.values * factor[..., None])


def _same(source: LobeSource, reflectance: Reflectance, measured: Measured | None) -> bool:
    return source.reflectance is reflectance and source.measured is measured
