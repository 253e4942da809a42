"""The weights of the fixed lobes for a designed paint, while a slider moves (seed, section 4)."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from brdf_suite.errors import FittingError
from brdf_suite.fitting.lobes.basis import LobeBasis, default_basis
from brdf_suite.fitting.lobes.fallback import FallbackSolver
from brdf_suite.fitting.lobes.program import PartProgram, build_program
from brdf_suite.fitting.lobes.samples import BaseSamples, CoatSamples
from brdf_suite.fitting.lobes.solver import BlockSolver
from brdf_suite.fitting.lobes.weights import LobeWeights

FloatArray = NDArray[np.float64]

CHANNELS = ("red", "green", "blue")
#: Weight of the row that holds the coat's energy against the rings' (columns sum to about 1): above 1 the
#: optimum keeps the energy exactly, because no gain on the rings can pay for losing it.
ENERGY_WEIGHT = 2.0
#: Time kept back from the solver for the fallback, and the smallest budget it is called with.
FALLBACK_RESERVE_S = 0.0006
SMALLEST_BUDGET_S = 0.0002
#: Limit of the first solve, made with the fitter itself: no edit waits for it.
WARM_UP_S = 1.0


class SampledReflectance(Protocol):
    """One layer: ``eval`` gives f_r in 1/sr without the cosine, ``(..., 3)``, linear Rec. 2020."""

    def eval(self, wi: FloatArray, wo: FloatArray) -> FloatArray:
        """Return f_r for unit directions ``(..., 3)``."""
        ...


class LayeredReflectance(Protocol):
    """What a fit needs of a designed paint: its two layers apart, and the coat's index of refraction."""

    @property
    def base(self) -> SampledReflectance:
        """Flakes and pigment, seen through the coat."""
        ...

    @property
    def coat(self) -> SampledReflectance:
        """The clearcoat's own reflection."""
        ...

    @property
    def ior(self) -> float:
        """Refractive index of the coat."""
        ...


@dataclass(frozen=True, eq=False)
class PartError:
    """L1 error of one part, per channel ``(3,)``.

    ``absolute`` is the objective ``Σ w·|M x - b|``; ``relative`` is it over ``Σ w·b`` (0 where that is 0);
    ``method`` names where each channel's weights came from: optimum, simplex, rescaled or least squares.
    """

    absolute: FloatArray
    relative: FloatArray
    method: tuple[str, ...]


@dataclass(frozen=True, eq=False)
class LobeFit:
    """A fit and how it went.

    ``seconds`` is the time from target samples in hand to weights; ``sampling_seconds`` that of evaluating
    the reflectance at the samples (0 when samples were given); ``time_limited``: the limit came first.
    """

    weights: LobeWeights
    base_error: PartError
    coat_error: PartError
    seconds: float
    sampling_seconds: float
    time_limited: bool
    iterations: int


class LobeFitter:
    """Fits non-negative lobe weights by L1 linear programming; keeps its model and last basis between fits.

    Parameters
    ----------
    basis
        The fixed exponents; the default set if left out.
    time_limit_s
        Limit of a whole fit, samples in hand to weights, in seconds. On the limit the best feasible weights
        at hand are returned, marked ``time_limited``. The solver looks at the clock only now and then, so
        that a hopelessly large program may return a few milliseconds late.
    base_samples, coat_samples
        The fixed sample directions; the measured default sets if left out. Both are for one incidence.

    One fitter serves one thread; programs that fit in several threads make one each. ``programs`` are the
    scaled systems of base (columns KD, KDD_1 …) and coat (columns KG_1 …; its last row is the coat's energy).
    """

    def __init__(
        self,
        basis: LobeBasis | None = None,
        *,
        time_limit_s: float = 0.004,
        base_samples: BaseSamples | None = None,
        coat_samples: CoatSamples | None = None,
    ) -> None:
        if not (np.isfinite(time_limit_s) and time_limit_s > 0.0):
            raise FittingError(f"The time limit of a fit is {time_limit_s:g} s; it must be more than 0.")
        self.basis = default_basis() if basis is None else basis
        self.time_limit_s = float(time_limit_s)
        self.base_samples = base_samples or BaseSamples()
        self.coat_samples = coat_samples or CoatSamples()
        exponents = self.basis.array()
        self._cosine = float(np.cos(self.base_samples.theta_rad))
        self.programs = (self._base_program(exponents), self._coat_program(exponents))
        self._solver = BlockSolver(self.programs)
        self._fallbacks = tuple(FallbackSolver(program) for program in self.programs)
        self._last = tuple(np.zeros((program.shape[1], 3)) for program in self.programs)
        self._warm_up()

    def _base_program(self, exponents: FloatArray) -> PartProgram:
        samples = self.base_samples
        columns = np.concatenate(
            [np.ones((samples.gamma_rad.size, 1)), samples.cosine_lobes(exponents)], axis=1
        )
        return build_program(self._cosine * columns, samples.weights)

    def _coat_program(self, exponents: FloatArray) -> PartProgram:
        samples = self.coat_samples
        matrix = np.concatenate(
            [samples.cosine_lobes(exponents), samples.lobe_energy(exponents)[None, :]], axis=0
        )
        return build_program(matrix, np.concatenate([samples.solid_angle, [ENERGY_WEIGHT]]))

    def _warm_up(self) -> None:
        """Solve once for a plain metallic look, so that the first edit starts from a basis."""
        base = 0.05 + 0.5 * np.clip(np.cos(self.base_samples.gamma_rad), 0.0, None) ** 6
        coat = np.exp(-20_000.0 * self.coat_samples.gamma_rad**2)
        self._run(
            [np.repeat(base[:, None], 3, 1), np.repeat(self._with_energy(coat[:, None]), 3, 1)],
            time.perf_counter() + WARM_UP_S,
        )

    def _with_energy(self, rings: FloatArray) -> FloatArray:
        energy = self.coat_samples.solid_angle @ rings
        result: FloatArray = np.concatenate([rings, energy[None, :]], axis=0)
        return result

    def sample(self, reflectance: LayeredReflectance) -> tuple[FloatArray, FloatArray]:
        """Return ``f_r·(N·L)`` at the base's samples ``(n, 3)`` and the coat's rings ``(k, 3)``."""
        base = reflectance.base.eval(self.base_samples.light, self.base_samples.views)
        coat = reflectance.coat.eval(self.coat_samples.lights, self.coat_samples.view)
        rings = (np.asarray(coat, np.float64) * self.coat_samples.cosines[..., None]).mean(axis=1)
        return self._cosine * np.asarray(base, np.float64), rings

    def fit(self, reflectance: LayeredReflectance) -> LobeFit:
        """Fit ``reflectance``: base to KD and KDD, coat to KG.

        Raises
        ------
        FittingError
            The reflectance is negative or not finite at a sample; the message names it.
        """
        start = time.perf_counter()
        base, coat = self.sample(reflectance)
        return self.fit_samples(
            base, coat, ior=float(reflectance.ior), sampling_seconds=time.perf_counter() - start
        )

    def fit_samples(
        self, base: FloatArray, coat: FloatArray, *, ior: float, sampling_seconds: float = 0.0
    ) -> LobeFit:
        """Fit given samples of ``f_r·(N·L)``: ``(n, 3)`` at ``base_samples``, ``(k, 3)`` at ``coat_samples``.

        Same result as :meth:`fit` on a reflectance with those samples; the way in for data that were
        measured. Raises :class:`FittingError` for a negative or not finite sample.
        """
        start = time.perf_counter()
        base = _checked("base", base, self.base_samples.gamma_rad)
        coat = _checked("coat", coat, self.coat_samples.gamma_rad)
        solutions, errors, optimal, iterations = self._run(
            [base, self._with_energy(coat)], start + self.time_limit_s
        )
        exponents = self.basis.array()
        weights = LobeWeights(
            exponents=exponents,
            kd=solutions[0][0],
            kdd=solutions[0][1:],
            kg=solutions[1],
            theta_fit_rad=self.base_samples.theta_rad,
            ior=ior,
            time_limited=not optimal,
        )
        return LobeFit(
            weights=weights,
            base_error=errors[0],
            coat_error=errors[1],
            seconds=time.perf_counter() - start,
            sampling_seconds=sampling_seconds,
            time_limited=not optimal,
            iterations=iterations,
        )

    def _run(
        self, targets: Sequence[FloatArray], deadline: float
    ) -> tuple[list[FloatArray], list[PartError], bool, int]:
        """Solve for unweighted ``targets`` until ``deadline`` of the performance counter.

        Returns lobe weights and errors per part, whether optimal, and iterations.
        """
        weighted = [p.row_weights[:, None] * t for p, t in zip(self.programs, targets, strict=True)]
        # The program is linear in its target: each channel is solved at a size of 1 and scaled back, so that
        # the solver's absolute tolerances are relative ones. A channel of zeros stays zeros.
        sizes = [w.sum(axis=0) for w in weighted]
        scaled = [w / np.where(s > 0.0, s, 1.0) for w, s in zip(weighted, sizes, strict=True)]
        budget = deadline - time.perf_counter() - FALLBACK_RESERVE_S
        answer = self._solver.solve(scaled, max(budget, SMALLEST_BUDGET_S))
        solutions, errors = [], []
        kept = []
        for k, program in enumerate(self.programs):
            best, objective, method = self._best(k, answer.solutions[k], answer.optimal, scaled[k], deadline)
            kept.append(best)
            solutions.append(best * program.column_scale[:, None] * sizes[k])
            relative = np.where(sizes[k] > 0.0, objective, 0.0)
            errors.append(PartError(objective * sizes[k], relative, method))
        self._last = tuple(kept)
        return solutions, errors, answer.optimal, answer.iterations

    def _best(
        self, part: int, simplex: FloatArray, optimal: bool, target: FloatArray, deadline: float
    ) -> tuple[FloatArray, FloatArray, tuple[str, ...]]:
        """Return one part's scaled solution of least L1 error per channel, that error, and its origin."""
        program, fallback = self.programs[part], self._fallbacks[part]
        if optimal:
            return simplex, program.residual_l1(simplex, target), ("optimum",) * target.shape[1]
        last = fallback.rescaled(self._last[part], target)
        candidates = {
            "simplex": simplex,
            "rescaled": last,
            "least squares": fallback.least_squares(last, target, deadline=deadline),
            "zero": np.zeros_like(simplex),
        }
        names = list(candidates)
        stack = np.stack([candidates[name] for name in names])
        objectives = np.stack([program.residual_l1(x, target) for x in stack])
        winner = np.argmin(objectives, axis=0)
        channels = np.arange(target.shape[1])
        best: FloatArray = stack[winner, :, channels].T
        return best, objectives[winner, channels], tuple(names[w] for w in winner)


def _checked(part: str, values: FloatArray, gamma_rad: FloatArray) -> FloatArray:
    """Return ``values`` as float64 ``(n, 3)``, or raise a FittingError that names the first bad sample."""
    array = np.asarray(values, dtype=np.float64)
    if array.shape != (gamma_rad.size, 3):
        raise FittingError(f"The {part} has samples of shape {array.shape}, not {(gamma_rad.size, 3)}.")
    bad = ~(np.isfinite(array) & (array >= 0.0))
    if bad.any():
        sample, channel = np.argwhere(bad)[0]
        value = array[sample, channel]
        what = "is not finite" if not np.isfinite(value) else f"is negative ({value:g} 1/sr)"
        raise FittingError(
            f"The {part} cannot be fitted: its {CHANNELS[channel]} channel {what} at the aspecular angle "
            f"{np.rad2deg(gamma_rad[sample]):.4g}°."
        )
    return array
