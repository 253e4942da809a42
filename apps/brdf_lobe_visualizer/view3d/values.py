"""Values over the lobe grid, kept per reflectance, and measured samples as points.

Nothing is worked out twice, and what is slow never holds a drag:

A reflectance whose last evaluation took longer than a frame may is worked out in the background from then on; until its
values are there, those of the incidence before are shown and marked as outdated.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
from brdf_qt.program.translation import decimal, tr
from brdf_qt.window.message_bar import message_of

from brdf_lobe_visualizer.session import LobeSession
from brdf_lobe_visualizer.subjects.subjects import PlottedMaterial, SamplePoints
from brdf_lobe_visualizer.view3d.frame import CUT, Points
from brdf_lobe_visualizer.view3d.section import SpaceOptions
from brdf_suite.arrays import Floats, Singles
from brdf_suite.fitting.lobes.weights import LobeWeights
from brdf_suite.geometry.directions import angle_between
from brdf_suite.inspection.lobe_surface.colour import light_codes, scalar_of
from brdf_suite.inspection.lobe_surface.grid import LobeGrid, lobe_grid
from brdf_suite.inspection.lobe_surface.parts import FitLobe, FitOnGrid, LobeSource
from brdf_suite.inspection.lobe_surface.surface import RadiusScale
from brdf_suite.inspection.slices.values import Cosine, cosine_of

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
        return bool(self._waiting)

    def grid(self) -> LobeGrid:
        """Return the directions of the session's incidence, the same object as long as that stays."""
        light = self._session.light
        if self._grid is None or not np.array_equal(self._grid.wi, light):
            self._grid = lobe_grid(light)
        return self._grid

    def target(self, subject: PlottedMaterial) -> Found | None:
        """Return a subject's values; None where none have come yet, or it cannot be evaluated."""
        grid, reflectance = self.grid(), self._session.target_of(subject)
        kept = self.kept.get(subject.key)
        if (
            kept is None
            or kept.source.reflectance is not reflectance
            or kept.source.measured is not subject.measured
        ):
            source = LobeSource(reflectance, subject.measured)
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
        self._session.messages.show_message(message_of(error, f"space {key}"))


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


def sample_points(
    subject: PlottedMaterial, session: LobeSession, scale: RadiusScale, options: SpaceOptions
) -> tuple[Points | None, str]:
    """Return the points of a subject's samples near the session's incidence, and a note if there are none.

    Samples of an isotropic reflectance are turned about the normal into the session's plane of incidence, and stand on
    both sides of it: only the size of the azimuth between light and view matters. What is longer than the picture shows
    is at its end.
    """
    samples = subject.samples
    if samples is None:
        return None, ""
    wi, wo, values = samples_near(samples, session.light, options.within_deg)
    if not len(wi):
        polar = np.degrees(np.arccos(np.clip(samples.wi[:, 2], -1.0, 1.0)))
        nearest = polar[np.argmin(np.abs(polar - session.incidence[0]))]
        text = tr("No samples within {reach}° of this incidence; the nearest is at {angle}°.")
        return None, text.format(reach=decimal(f"{options.within_deg:g}"), angle=decimal(f"{nearest:.1f}"))
    values = values * np.maximum(cosine_of(session.options.cosine, wi, wo), 0.0)[:, None]
    shown = scalar_of(values.astype(np.float32), session.options.channel)
    places = wo * np.minimum(scale.radius(shown), CUT)[:, None]
    colours = np.ones((len(wo), 4), np.float32)
    colours[:, :3] = light_codes(values.astype(np.float32)) / 255.0
    return Points(places.astype(np.float32), colours), ""


def samples_near(samples: SamplePoints, light: Floats, within_deg: float) -> tuple[Floats, Floats, Floats]:
    """Return light, view and value, (n, 3) each, of samples whose light is within an angle of ``light`` (3,)."""
    wi, wo = samples.wi, samples.wo
    if not samples.isotropic:
        near = np.degrees(angle_between(wi, light)) <= within_deg
        return wi[near], wo[near], samples.values[near]
    polar = np.degrees(np.arctan2(np.hypot(wi[:, 0], wi[:, 1]), wi[:, 2]))
    wanted = np.degrees(np.arctan2(np.hypot(light[0], light[1]), light[2]))
    near = np.abs(polar - wanted) <= within_deg
    wi, wo, values = wi[near], wo[near], samples.values[near]
    # Into the plane of the x axis, where the other side is -y, then to the light's azimuth.
    back = -np.arctan2(wi[:, 1], wi[:, 0])
    wi, wo = _turned(wi, back), _turned(wo, back)
    other = wo * np.array([1.0, -1.0, 1.0])
    off = np.abs(wo[:, 1]) > 1e-6
    wi, wo = np.concatenate((wi, wi[off])), np.concatenate((wo, other[off]))
    turn = np.full(len(wi), np.arctan2(light[1], light[0]))
    return _turned(wi, turn), _turned(wo, turn), np.concatenate((values, values[off]))


def _turned(directions: Floats, angle: Floats) -> Floats:
    cosine, sine = np.cos(angle), np.sin(angle)
    x, y, z = directions.T
    return np.column_stack((cosine * x - sine * y, sine * x + cosine * y, z))
