"""Interactive fit of lobe weights at many incidences (the second way of Fresnel).

Westlund and Meyer, section 4.
"""

from __future__ import annotations

import threading
import time
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.errors import FittingError
from brdf_suite.fitting.lobes.angles.program import (
    AngleBaseSamples,
    AngleCoatSamples,
    AngleSamples,
    base_program,
    base_target,
    check_samples,
    coat_program,
    coat_target,
)
from brdf_suite.fitting.lobes.angles.weights import DEFAULT_COUNT, AngleGrid, AngleWeights
from brdf_suite.fitting.lobes.background import chain_futures
from brdf_suite.fitting.lobes.basis import LobeBasis, default_basis
from brdf_suite.fitting.lobes.checks import check_ior, check_limit
from brdf_suite.fitting.lobes.fitter import PartError, TimedFit
from brdf_suite.fitting.lobes.program import PartProgram
from brdf_suite.fitting.lobes.samples import BASE_GAMMAS_DEG, BASE_WEIGHTS
from brdf_suite.fitting.lobes.time_limit import LimitedSolution, LimitedSolver
from brdf_suite.reflectance.protocol import Layered

if TYPE_CHECKING:  # 3 ms with the logging that it loads, on the start-up path of programs that may not fit
    from concurrent.futures import Future


#: Weight of the base's change between neighbouring incidences, and how many times as much the coat's counts: its
#: shape hardly changes, so that calm costs it nothing. Chosen by measurement (docs/method/incidence.md).
SMOOTHNESS = 0.03
COAT_FACTOR = 10.0
#: Angles for a base that is looked up halfway: the pairs of instruments lie between them.
HALFWAY_COUNT = 20
TIME_LIMIT_S = 0.016
#: Limit of the first solve, made with the fitter itself: no edit waits for it.
WARM_UP_S = 2.0
#: Share of the limit after which the coat's answer is taken as it is.
COAT_SHARE = 0.5
#: Kept of the limit for making the weights and their errors.
RESERVE_S = 0.0005
#: Channels of a coat that differ by less than this share of it are one.
SAME = 1e-12


AngleFit = TimedFit[AngleWeights]
"""Its errors sum over all incidences, in units of the largest incidence's target, and leave out what smoothness costs.
"""


@dataclass(frozen=True, eq=False)
class _Solved:
    """One part: weights (K, terms, 3), error, whether optimal, iterations."""

    table: Floats
    error: PartError
    optimal: bool
    iterations: int


class AngleFitter:
    """Fits weights at K incidences by one joint L1 program per channel and part; keeps models and bases.

    Parameters
    ----------
    basis
        The fixed exponents; the default set if left out.
    grid
        Where along the incidence; 16 angles if left out, 20 of a base that is looked up ``halfway``.
    smoothness
        Weight μ ≥ 0 of the base's change between neighbouring incidences (see ``program``), ten times that for the
        coat's; 0: each incidence for itself.
    time_limit_s
        Limit of a whole fit, samples in hand to weights, in seconds: hard, as that of the single fit.
    halfway
        For bases that depend on the angle between light and view, which are looked up there: wide facet lobes
        (Cook-Torrance), and paints read under several lights. See ``program``.
    base_gammas_deg, base_weights
        Aspecular angles of the base's samples and their weights; those of the single fit if left out.

    One fitter serves one thread; :meth:`close` ends its background thread, as does losing the last reference.
    Raises :class:`FittingError` for settings out of range.
    """

    def __init__(
        self,
        basis: LobeBasis | None = None,
        grid: AngleGrid | None = None,
        *,
        halfway: bool = False,
        smoothness: float = SMOOTHNESS,
        time_limit_s: float = TIME_LIMIT_S,
        base_gammas_deg: tuple[float, ...] | None = None,
        base_weights: tuple[float, ...] | None = None,
    ) -> None:
        self.basis = default_basis() if basis is None else basis
        self.grid = grid or AngleGrid(HALFWAY_COUNT if halfway else DEFAULT_COUNT)
        self.smoothness = float(smoothness)
        self.time_limit_s = check_limit(time_limit_s)
        if (base_gammas_deg is None) != (base_weights is None):
            raise FittingError("Give the base's aspecular angles and their weights together.")
        gammas, weights = base_gammas_deg or BASE_GAMMAS_DEG, base_weights or BASE_WEIGHTS
        self.base_samples = AngleBaseSamples(self.grid, gammas, weights, halfway)
        self.coat_samples = AngleCoatSamples(self.grid)
        exponents = self.basis.array()
        self.programs: tuple[PartProgram, PartProgram] = (
            base_program(self.base_samples, exponents, self.smoothness),
            coat_program(self.coat_samples, exponents, COAT_FACTOR * self.smoothness),
        )
        base, coat = self.programs
        # A coat is the same in all channels, as a rule, and its program is then solved once; sharp lobes of
        # Cook-Torrance paints are coloured.
        self.grey_coat = LimitedSolver([coat], 1)
        self.coloured_coat = LimitedSolver([coat], 3, fallbacks=self.grey_coat.fallbacks)
        self.base_solver = LimitedSolver([base], 3)
        # A base that has to wait for the optimum of its coat is begun from the coat's thread: held meanwhile, so that
        # the next fit either finds it begun, and supersedes it, or keeps it from being begun.
        self._late = threading.Lock()
        self._exact: Future[AngleFit] | None = None
        self._warm_up()

    def close(self) -> None:
        """Drop what is in work and end the background threads, each at most one slice of its solver later."""
        self.supersede()
        for solver in (self.grey_coat, self.coloured_coat, self.base_solver):
            solver.close()

    def supersede(self) -> None:
        """Cancel the background work of the last fit."""
        with self._late:
            if self._exact is not None:
                self._exact.cancel()
                self._exact = None

    def _warm_up(self) -> None:
        """Fit a plain metallic look, so that the first edit starts from a basis."""
        base = 0.05 + 0.5 * np.clip(np.cos(self.base_samples.gamma_rad), 0.0, None) ** 6
        rings = np.exp(-20_000.0 * self.coat_samples.gamma_rad**2)
        look = np.repeat(base[:, None], 3, 1)
        samples = AngleSamples(look, 0.0 * look, np.repeat(rings[..., None], 3, 2), 1.5)
        self._fit(samples, time.perf_counter(), 2.0 * WARM_UP_S)

    def sample(self, reflectance: Layered) -> AngleSamples:
        """Evaluate ``reflectance`` at the samples of the fit."""
        start = time.perf_counter()
        flat, rings = self.base_samples, self.coat_samples
        base = np.asarray(reflectance.base.eval(flat.lights, flat.views), np.float64)
        coat = np.asarray(reflectance.coat.eval(flat.lights, flat.views), np.float64)
        around = np.asarray(reflectance.coat.eval(rings.lights, rings.views), np.float64)
        return AngleSamples(
            base,
            coat,
            np.einsum("knac,kna->knc", around, rings.cosines),
            float(reflectance.ior),
            bool(reflectance.base_under_coat),
            time.perf_counter() - start,
        )

    def fit(self, reflectance: Layered) -> AngleFit:
        """Fit ``reflectance``: coat to KG, base to KD and KDD, at every incidence of the grid.

        Raises
        ------
        FittingError
            The reflectance is negative or not finite at a sample; the message names it.
        """
        return self.fit_samples(self.sample(reflectance))

    def fit_samples(self, samples: AngleSamples) -> AngleFit:
        """Fit given samples.

        Raises :class:`FittingError` for a sample that is negative or not finite, and for an index below 1.
        """
        start = time.perf_counter()
        check_ior(samples.ior)
        checked = check_samples(samples, self.base_samples, self.coat_samples)
        return self._fit(checked, start, self.time_limit_s)

    def _fit(self, samples: AngleSamples, start: float, limit_s: float) -> AngleFit:
        self.supersede()
        target, scale = coat_target(self.programs[1], self.coat_samples, samples)
        grey = bool(np.ptp(target, axis=1).max() <= SAME * target.max(initial=0.0))
        # The base takes what is left of the coat in the plane, so the coat comes first, and half of the time is its.
        answer = (self.grey_coat if grey else self.coloured_coat).solve(
            [target[:, :1] if grey else target],
            start + COAT_SHARE * limit_s,
            then=lambda exact: self._coat(exact, target, scale),
        )
        coat = self._coat(answer, target, scale)
        below, below_scale = self.base_target(samples, coat)
        answered = self.base_solver.solve(
            [below],
            start + limit_s - min(RESERVE_S, 0.25 * limit_s),
            finish=answer.optimal,
            then=lambda exact: self._result(samples, self._part(0, exact, below, below_scale), coat, start),
        )
        found = self._result(samples, self._part(0, answered, below, below_scale), coat, start)
        self._exact = answered.exact
        if answer.exact is not None:
            self._exact = chain_futures(
                answer.exact, lambda coat, whole: self._begin_base(samples, coat, start, whole)
            )
        return replace(found, exact=self._exact)

    def _begin_base(
        self, samples: AngleSamples, coat: _Solved, start: float, whole: Future[AngleFit]
    ) -> Future[AngleFit] | None:
        """Begin the base of a fit whose coat met the limit and has its optimum now; on the coat's thread."""
        below, scale = self.base_target(samples, coat)
        with self._late:
            if whole.cancelled():
                return None
            return self.base_solver.begin(
                [below],
                then=lambda exact: self._result(samples, self._part(0, exact, below, scale), coat, start),
            )

    def _coat(self, answer: LimitedSolution, target: Floats, scale: Floats) -> _Solved:
        if answer.solutions[0].shape[1] == 1:
            answer = replace(
                answer, solutions=(np.repeat(answer.solutions[0], 3, 1),), methods=(3 * answer.methods[0],)
            )
        return self._part(1, answer, target, scale)

    def base_target(self, samples: AngleSamples, coat: _Solved) -> tuple[Floats, Floats]:
        """Return the base's target under a solved coat, and its scale."""
        return base_target(self.programs[0], self.base_samples, samples, self.basis.array(), coat.table)

    def _part(self, part: int, answer: LimitedSolution, target: Floats, scale: Floats) -> _Solved:
        program = self.programs[part]
        rows = (self.base_samples.gamma_rad.size, self.coat_samples.gamma_rad.size + self.grid.count)[part]
        solution = answer.solutions[0]
        # Of the data rows; those of smoothness follow and have no target.
        absolute = np.abs(program.matrix[:rows] @ solution - target[:rows]).sum(axis=0)
        size = target.sum(axis=0)
        relative = np.where(size > 0.0, absolute / np.where(size > 0.0, size, 1.0), 0.0)
        table = (solution * program.column_scale[:, None]).reshape(self.grid.count, -1, 3)
        return _Solved(
            table * scale[:, None, None],
            PartError(absolute, relative, answer.methods[0]),
            answer.optimal,
            answer.iterations,
        )

    def _result(self, samples: AngleSamples, base: _Solved, coat: _Solved, start: float) -> AngleFit:
        limited = not (base.optimal and coat.optimal)
        return TimedFit(
            weights=AngleWeights(
                grid=self.grid,
                exponents=self.basis.array(),
                kd=base.table[:, 0],
                kdd=base.table[:, 1:],
                kg=coat.table,
                ior=samples.ior,
                base_under_coat=samples.base_under_coat,
                base_at_halfway=self.base_samples.halfway,
                time_limited=limited,
            ),
            base_error=base.error,
            coat_error=coat.error,
            seconds=time.perf_counter() - start,
            sampling_seconds=samples.seconds,
            time_limited=limited,
            iterations=base.iterations + coat.iterations,
        )
