"""Lobe weights at many incidences in one fit, while a slider moves (seed, section 4, its second way of Fresnel)."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from brdf_suite.errors import FittingError
from brdf_suite.fitting.lobes.angles.grid import AngleGrid
from brdf_suite.fitting.lobes.angles.program import base_program, coat_program
from brdf_suite.fitting.lobes.angles.samples import AngleBaseSamples, AngleCoatSamples
from brdf_suite.fitting.lobes.angles.weights import AngleWeights, leaving
from brdf_suite.fitting.lobes.basis import LobeBasis, default_basis
from brdf_suite.fitting.lobes.fitter import CHANNELS, LayeredReflectance, PartError
from brdf_suite.fitting.lobes.limited import LimitedSolution, LimitedSolver
from brdf_suite.fitting.lobes.program import PartProgram
from brdf_suite.geometry.fresnel import fresnel_dielectric

if TYPE_CHECKING:  # 3 ms with the logging that it loads, on the start-up path of programs that may not fit
    from concurrent.futures import Future

FloatArray = NDArray[np.float64]

#: Weight of the change between neighbouring incidences; chosen by measurement (docs/incidence.md).
SMOOTHNESS = 0.1
TIME_LIMIT_S = 0.016
#: Limit of the first solve, made with the fitter itself: no edit waits for it.
WARM_UP_S = 2.0
#: Channels of a coat that differ by less than this share of it are one.
SAME = 1e-12


@dataclass(frozen=True, eq=False)
class AngleFit:
    """A fit at K incidences and how it went.

    ``base_error`` and ``coat_error`` sum over all incidences, in units of the largest incidence's target, and leave
    out what smoothness costs; ``seconds`` from samples in hand to weights; ``sampling_seconds`` that of evaluating the
    reflectance; ``time_limited``: the limit came first, and ``exact`` gets the optimum's AngleFit once it is found,
    cancelled where the next fit comes before.
    """

    weights: AngleWeights
    base_error: PartError
    coat_error: PartError
    seconds: float
    sampling_seconds: float
    time_limited: bool
    iterations: int
    exact: Future[AngleFit] | None = field(default=None, repr=False)


@dataclass(frozen=True, eq=False)
class _Targets:
    """Relative targets, weighted: base (N, 3), coat (M, 3); what they were divided by at each incidence (K,)."""

    base: FloatArray
    coat: FloatArray
    base_scale: FloatArray
    coat_scale: FloatArray
    grey: bool
    ior: float
    base_under_coat: bool


class AngleFitter:
    """Fits weights at K incidences by one joint L1 program per channel and part; keeps models and bases.

    Parameters
    ----------
    basis
        The fixed exponents; the default set if left out.
    grid
        Where along the incidence; 16 angles if left out.
    smoothness
        Weight μ ≥ 0 of the change between neighbouring incidences (see ``program``); 0: each for itself.
    time_limit_s
        Limit of a whole fit, samples in hand to weights, in seconds: hard, as that of the single fit.
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
        smoothness: float = SMOOTHNESS,
        time_limit_s: float = TIME_LIMIT_S,
        base_gammas_deg: tuple[float, ...] | None = None,
        base_weights: tuple[float, ...] | None = None,
    ) -> None:
        if not (np.isfinite(time_limit_s) and time_limit_s > 0.0):
            raise FittingError(f"The time limit of a fit is {time_limit_s:g} s; it must be more than 0.")
        self.basis = default_basis() if basis is None else basis
        self.grid = grid or AngleGrid()
        self.smoothness = float(smoothness)
        self.time_limit_s = float(time_limit_s)
        if (base_gammas_deg is None) != (base_weights is None):
            raise FittingError("Give the base's aspecular angles and their weights together.")
        if base_gammas_deg is None or base_weights is None:
            self.base_samples = AngleBaseSamples(self.grid)
        else:
            self.base_samples = AngleBaseSamples(self.grid, base_gammas_deg, base_weights)
        self.coat_samples = AngleCoatSamples(self.grid)
        exponents = self.basis.array()
        self.programs: tuple[PartProgram, PartProgram] = (
            base_program(self.base_samples, exponents, self.smoothness),
            coat_program(self.coat_samples, exponents, self.smoothness),
        )
        # A coat is the same in all channels, as a rule: its program is then solved once. Each channel of the base
        # is a part of its own here, so that all four are one model with one answer.
        base, coat = self.programs
        self._grey = LimitedSolver([base, base, base, coat], 1)
        # Sharp lobes of Cook-Torrance paints are coloured.
        self._coloured = LimitedSolver(self.programs, 3)
        self._warm_up()

    def close(self) -> None:
        """Drop what is in work and end the background thread."""
        self._grey.close()
        self._coloured.close()

    def _warm_up(self) -> None:
        """Fit a plain metallic look, so that the first edit starts from a basis."""
        base = 0.05 + 0.5 * np.clip(np.cos(self.base_samples.gamma_rad), 0.0, None) ** 6
        rings = np.exp(-20_000.0 * self.coat_samples.gamma_rad**2)
        for colour in ((1.0, 1.0, 1.0), (1.0, 0.9, 0.8)):
            targets = self._targets(
                base[:, None] * np.array(colour), rings[..., None] * np.array(colour), 1.5, True
            )
            self._solve(targets, time.perf_counter() + WARM_UP_S, None)

    def sample(self, reflectance: LayeredReflectance) -> tuple[FloatArray, FloatArray]:
        """Return the base's f_r ``(N, 3)`` and the coat's ring means of ``f_r·(N·L)`` ``(K, n, 3)``."""
        base = reflectance.base.eval(self.base_samples.lights, self.base_samples.views)
        samples = self.coat_samples
        coat = reflectance.coat.eval(samples.lights, samples.views)
        rings = np.einsum("knac,kna->knc", np.asarray(coat, np.float64), samples.cosines)
        return np.asarray(base, np.float64), rings

    def fit(self, reflectance: LayeredReflectance) -> AngleFit:
        """Fit ``reflectance``: base to KD and KDD, coat to KG, at every incidence of the grid.

        An attribute ``base_under_coat`` that is False says that the coat takes nothing from the base.

        Raises
        ------
        FittingError
            The reflectance is negative or not finite at a sample; the message names it.
        """
        start = time.perf_counter()
        base, coat = self.sample(reflectance)
        return self.fit_samples(
            base,
            coat,
            ior=float(reflectance.ior),
            base_under_coat=bool(getattr(reflectance, "base_under_coat", True)),
            sampling_seconds=time.perf_counter() - start,
        )

    def fit_samples(
        self,
        base: FloatArray,
        coat: FloatArray,
        *,
        ior: float,
        base_under_coat: bool = True,
        sampling_seconds: float = 0.0,
    ) -> AngleFit:
        """Fit given samples: f_r ``(N, 3)`` at ``base_samples``, ring means ``(K, n, 3)`` at ``coat_samples``.

        Raises :class:`FittingError` for a sample that is negative or not finite, and for an index below 1.
        """
        start = time.perf_counter()
        if not (np.isfinite(ior) and ior >= 1.0):
            raise FittingError(f"The refractive index of the coat is {ior:g}; it must be 1 or more.")
        samples = self.base_samples
        cosines = self.grid.cosines
        base = _checked("base", base, samples.gamma_rad, cosines[samples.angle])
        gammas = self.coat_samples.gamma_rad
        coat = _checked("coat", coat, gammas, np.broadcast_to(cosines[:, None], gammas.shape))
        targets = self._targets(base, coat, float(ior), base_under_coat)
        finish = partial(self._result, targets, start, sampling_seconds)
        return finish(self._solve(targets, start + self.time_limit_s, finish))

    def _targets(self, base: FloatArray, coat: FloatArray, ior: float, base_under_coat: bool) -> _Targets:
        samples, rings = self.base_samples, self.coat_samples
        count = self.grid.count
        # Relative targets: Fresnel's share of the incidence out of both, and of the view out of the base.
        base_scale = np.ones(count)
        relative = base
        if base_under_coat:
            base_scale = (1.0 - fresnel_dielectric(self.grid.cosines, ior)) ** 2
            beyond = leaving(samples.lights[:, 2], samples.views[:, 2], np.cos(samples.gamma_rad), ior)
            relative = base / (base_scale[samples.angle] * beyond)[:, None]
        energy = np.einsum("knc,kn->kc", coat, rings.solid_angle)
        mean = energy.mean(axis=1)
        # Where a coat reflects nothing at an angle, any scale will do for its zeros.
        coat_scale = np.where(mean > 1e-12 * max(float(mean.max()), 1e-300), mean, 1.0)
        joined = np.concatenate([coat, energy[:, None, :]], axis=1) / coat_scale[:, None, None]
        below = _weighted(self.programs[0], relative)
        above = _weighted(self.programs[1], joined.reshape(-1, 3))
        grey = bool(np.ptp(above, axis=1).max() <= SAME * above.max(initial=0.0))
        return _Targets(below, above, base_scale, coat_scale, grey, ior, base_under_coat)

    def _solve(
        self, targets: _Targets, deadline: float, then: Callable[[LimitedSolution], AngleFit] | None
    ) -> LimitedSolution:
        wanted: dict[str, Any] = {"finish": False} if then is None else {"then": then}
        if targets.grey:
            parts = [targets.base[:, k : k + 1] for k in range(3)] + [targets.coat[:, :1]]
            return self._grey.solve(parts, deadline, **wanted)
        return self._coloured.solve([targets.base, targets.coat], deadline, **wanted)

    def _result(
        self, targets: _Targets, start: float, sampling_seconds: float, answer: LimitedSolution
    ) -> AngleFit:
        base, coat, methods = _joined(answer)
        tables, errors = [], []
        for program, rows, solution, target, scale, method in zip(
            self.programs,
            (self.base_samples.gamma_rad.size, self.coat_samples.gamma_rad.size + self.grid.count),
            (base, coat),
            (targets.base, targets.coat),
            (targets.base_scale, targets.coat_scale),
            methods,
            strict=True,
        ):
            weights = (solution * program.column_scale[:, None]).reshape(self.grid.count, -1, 3)
            tables.append(weights * scale[:, None, None])
            errors.append(_error(program, solution, target, rows, method))
        return AngleFit(
            weights=AngleWeights(
                grid=self.grid,
                exponents=self.basis.array(),
                kd=tables[0][:, 0],
                kdd=tables[0][:, 1:],
                kg=tables[1],
                ior=targets.ior,
                base_under_coat=targets.base_under_coat,
                time_limited=not answer.optimal,
            ),
            base_error=errors[0],
            coat_error=errors[1],
            seconds=time.perf_counter() - start,
            sampling_seconds=sampling_seconds,
            time_limited=not answer.optimal,
            iterations=answer.iterations,
            exact=answer.exact,
        )


def _weighted(program: PartProgram, values: FloatArray) -> FloatArray:
    """Return the target (n, 3) of ``program``: weighted ``values`` of the data rows, 0 for those of smoothness."""
    target = np.zeros((program.shape[0], 3))
    target[: len(values)] = program.row_weights[: len(values), None] * values
    return target


def _joined(answer: LimitedSolution) -> tuple[FloatArray, FloatArray, tuple[tuple[str, ...], ...]]:
    """Base and coat (unknowns, 3) and the origins of their channels, from either form of the model."""
    if len(answer.solutions) == 2:
        return answer.solutions[0], answer.solutions[1], answer.methods
    red, green, blue, grey = answer.solutions
    origins = tuple(method[0] for method in answer.methods)
    return (
        np.concatenate([red, green, blue], axis=1),
        np.repeat(grey, 3, axis=1),
        (origins[:3], (origins[3],) * 3),
    )


def _error(
    program: PartProgram, solution: FloatArray, target: FloatArray, rows: int, method: tuple[str, ...]
) -> PartError:
    """L1 error of the data, the first ``rows``: those of smoothness have no target, and come after."""
    absolute = np.abs(program.matrix[:rows] @ solution - target[:rows]).sum(axis=0)
    size = target.sum(axis=0)
    return PartError(absolute, np.where(size > 0.0, absolute / np.where(size > 0.0, size, 1.0), 0.0), method)


def _checked(part: str, values: FloatArray, gamma_rad: FloatArray, cosines: FloatArray) -> FloatArray:
    """Return ``values`` as float64 (..., 3), or raise a FittingError that names the first bad sample."""
    array = np.asarray(values, dtype=np.float64)
    if array.shape != (*gamma_rad.shape, 3):
        raise FittingError(f"The {part} has samples of shape {array.shape}, not {(*gamma_rad.shape, 3)}.")
    bad = ~(np.isfinite(array) & (array >= 0.0))
    if bad.any():
        place = tuple(np.argwhere(bad)[0])
        value, sample = array[place], place[:-1]
        what = "is not finite" if not np.isfinite(value) else f"is negative ({value:g} 1/sr)"
        raise FittingError(
            f"The {part} cannot be fitted: its {CHANNELS[place[-1]]} channel {what} at the aspecular angle "
            f"{np.rad2deg(gamma_rad[sample]):.4g}° under light at {np.rad2deg(np.arccos(cosines[sample])):.4g}°."
        )
    return array
