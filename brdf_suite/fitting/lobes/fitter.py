"""Interactive fit of the lobe weights of a designed paint (Westlund and Meyer, section 4)."""

from __future__ import annotations

import time
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Generic, TypeVar

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.errors import FittingError
from brdf_suite.fitting.lobes.answers import LimitedSolution
from brdf_suite.fitting.lobes.basis import LobeBasis, default_basis
from brdf_suite.fitting.lobes.checks import check_ior, check_limit, check_targets
from brdf_suite.fitting.lobes.program import (
    Weighting,
    base_program,
    coat_program,
    relative_factors,
    ring_solid_angles,
    with_energy,
)
from brdf_suite.fitting.lobes.samples import BaseSamples, CoatSamples
from brdf_suite.fitting.lobes.settings import Diffuse, FitSettings
from brdf_suite.fitting.lobes.time_limit import LimitedSolver
from brdf_suite.fitting.lobes.weights import LobeWeights
from brdf_suite.reflectance.protocol import Layered

if TYPE_CHECKING:
    from concurrent.futures import Future  # see answers.py


#: Limit of the first solve, made with the fitter itself: no edit waits for it.
WARM_UP_S = 1.0
#: Where the measured diffuse term is read: beyond 90°, where no cosine lobe reaches.
DIFFUSE_GAMMA_DEG = 110.0

_Weights = TypeVar("_Weights")


@dataclass(frozen=True, eq=False)
class PartError:
    """L1 error of one part, per channel ``(3,)``.

    ``absolute`` is the objective ``Σ w·|M x - b|``; ``relative`` is it over ``Σ w·b`` (0 where that is 0);
    ``method`` names where each channel's weights came from: optimum, simplex, rescaled, least squares or zero.
    """

    absolute: Floats
    relative: Floats
    method: tuple[str, ...]


@dataclass(frozen=True, eq=False)
class TimedFit(Generic[_Weights]):
    """A fit and how it went.

    ``seconds`` is the time from target samples in hand to weights; ``sampling_seconds`` that of evaluating
    the reflectance at the samples (0 when samples were given); ``time_limited``: the limit came first.
    ``exact`` then holds the fit with the optimum once it is found in the background, unless the fitter's next
    fit comes first and cancels it; its callbacks run on the fitter's thread. ``None`` where this is the optimum.
    """

    weights: _Weights
    base_error: PartError
    coat_error: PartError
    seconds: float
    sampling_seconds: float
    time_limited: bool
    iterations: int
    exact: Future[TimedFit[_Weights]] | None = field(default=None, repr=False)

    def __getstate__(self) -> dict[str, object]:
        """Leave out ``exact``: another process cannot receive what this one's thread finds."""
        return {**self.__dict__, "exact": None}


LayersFit = TimedFit[LobeWeights]


class LobeFitter:
    """Fits non-negative lobe weights by L1 linear programming; keeps its model and last basis between fits.

    Parameters
    ----------
    basis
        The fixed exponents; the default set if left out.
    time_limit_s
        Hard limit of a whole fit, samples in hand to weights, in seconds. On the limit the best feasible weights
        at hand are returned, marked ``time_limited``, and the optimum follows in ``LayersFit.exact``.
    base_samples, coat_samples
        The fixed sample directions; the measured default sets if left out. Both are for one incidence.
    weighting
        How much each sample counts, see :data:`~brdf_suite.fitting.lobes.program.Weighting`. The coat's energy is kept
        exactly under each.
    diffuse
        Where KD comes from, see :data:`~brdf_suite.fitting.lobes.settings.Diffuse`; "measured" reads it at
        ``diffuse_gamma_deg``.
    diffuse_gamma_deg
        The sample at which "measured" reads the diffuse term, aspecular degrees.

    One fitter serves one thread; programs that fit in several threads make one each. ``programs`` are the
    scaled systems of base (columns KD, KDD_1 …, or without KD where that is measured) and coat (columns KG_1 …;
    its last row is the coat's energy). :meth:`close`, or losing the last reference, ends the fitter's thread.

    Raises
    ------
    FittingError
        A limit that is not a positive number, an unknown weighting or way for the diffuse term, or no sample at
        ``diffuse_gamma_deg``.
    """

    def __init__(
        self,
        basis: LobeBasis | None = None,
        *,
        time_limit_s: float = 0.004,
        base_samples: BaseSamples | None = None,
        coat_samples: CoatSamples | None = None,
        weighting: Weighting = "absolute",
        diffuse: Diffuse = "joint",
        diffuse_gamma_deg: float = DIFFUSE_GAMMA_DEG,
    ) -> None:
        self.time_limit_s = check_limit(time_limit_s)
        self.settings = FitSettings(default_basis() if basis is None else basis, weighting, diffuse)
        self.basis = self.settings.basis
        self.base_samples = base_samples or BaseSamples()
        self.coat_samples = coat_samples or CoatSamples()
        self.weighting = weighting
        self.diffuse = diffuse
        self._diffuse_sample: int | None = None
        if diffuse == "measured":
            distances = np.abs(np.array(self.base_samples.gammas_deg) - diffuse_gamma_deg)
            if not distances.min() < 1e-6:
                where = f"{diffuse_gamma_deg:g}°"
                raise FittingError(f"The base has no sample at {where} to read the diffuse term from.")
            self._diffuse_sample = int(np.argmin(distances))
        self._cosine = float(np.cos(self.base_samples.theta_rad))
        exponents = self.basis.array()
        weights = ring_solid_angles(self.base_samples.gamma_rad) if weighting == "solid angle" else None
        with_diffuse = self._diffuse_sample is None
        self.programs = (
            base_program(self.base_samples, exponents, weights=weights, with_diffuse=with_diffuse),
            coat_program(self.coat_samples, exponents),
        )
        self.solver = LimitedSolver(self.programs)
        # Solved once for a plain metallic look, so that the first edit starts from a basis.
        base = 0.05 + 0.5 * np.clip(np.cos(self.base_samples.gamma_rad), 0.0, None) ** 6
        coat = np.exp(-20_000.0 * self.coat_samples.gamma_rad**2)
        base, coat = base[:, None].repeat(3, 1), coat[:, None].repeat(3, 1)
        self._solve(base, coat, 1.5, True, time.perf_counter() + WARM_UP_S, finish=False)

    def close(self) -> None:
        """End the background thread, should there be one, and drop what it works at."""
        self.solver.close()

    def sample(self, reflectance: Layered) -> tuple[Floats, Floats]:
        """Return ``f_r·(N·L)`` at the base's samples ``(n, 3)`` and the coat's rings ``(k, 3)``."""
        base = reflectance.base.eval(self.base_samples.light, self.base_samples.views)
        coat = reflectance.coat.eval(self.coat_samples.lights, self.coat_samples.view)
        rings = (np.asarray(coat, np.float64) * self.coat_samples.cosines[..., None]).mean(axis=1)
        return self._cosine * np.asarray(base, np.float64), rings

    def fit(self, reflectance: Layered) -> LayersFit:
        """Fit ``reflectance``: base to KD and KDD, coat to KG.

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
            base_under_coat=reflectance.base_under_coat,
            sampling_seconds=time.perf_counter() - start,
        )

    def fit_samples(
        self,
        base: Floats,
        coat: Floats,
        *,
        ior: float,
        base_under_coat: bool = True,
        sampling_seconds: float = 0.0,
    ) -> LayersFit:
        """Fit given samples of ``f_r·(N·L)``: ``(n, 3)`` at ``base_samples``, ``(k, 3)`` at ``coat_samples``.

        Same result as :meth:`fit` on a reflectance with those samples; the way in for data that were
        measured. Raises :class:`FittingError` for a negative or not finite sample, and for an index below 1.
        """
        start = time.perf_counter()
        ior = check_ior(ior)
        base = _checked("The base", base, self.base_samples.gamma_rad)
        coat = _checked("The coat", coat, self.coat_samples.gamma_rad)
        deadline = start + self.time_limit_s
        return self._solve(base, coat, ior, base_under_coat, deadline, start, sampling_seconds)

    def _solve(
        self,
        base: Floats,
        coat: Floats,
        ior: float,
        base_under_coat: bool,
        deadline: float,
        start: float = 0.0,
        sampling_seconds: float = 0.0,
        *,
        finish: bool = True,
    ) -> LayersFit:
        """Fit checked samples until ``deadline``; what comes later comes by ``exact``."""
        kd = np.zeros(3)
        if self._diffuse_sample is not None:
            kd = base[self._diffuse_sample] / self._cosine
            base = base - base[self._diffuse_sample]
        targets = (base, with_energy(self.coat_samples, coat))
        factors = None
        if self.weighting == "relative":
            # The energy outbids every ring, as it does without factors.
            rings = relative_factors(coat)
            factors = (relative_factors(base), np.concatenate([rings, rings.max(axis=0, keepdims=True)]))
        weighted = [p.row_weights[:, None] * t for p, t in zip(self.programs, targets, strict=True)]

        def fit_of(answer: LimitedSolution) -> LayersFit:
            found, kg = (
                solution * program.column_scale[:, None]
                for solution, program in zip(answer.solutions, self.programs, strict=True)
            )
            joint = self._diffuse_sample is None
            weights = LobeWeights(
                exponents=self.basis.array(),
                kd=found[0] if joint else kd,
                kdd=found[1:] if joint else found,
                kg=kg,
                theta_fit_rad=self.base_samples.theta_rad,
                ior=ior,
                time_limited=not answer.optimal,
                base_under_coat=base_under_coat,
            )
            of_parts = zip(answer.objectives, answer.relative, answer.methods, strict=True)
            base_error, coat_error = (PartError(*error) for error in of_parts)
            return TimedFit(
                weights=weights,
                base_error=base_error,
                coat_error=coat_error,
                seconds=time.perf_counter() - start,
                sampling_seconds=sampling_seconds,
                time_limited=not answer.optimal,
                iterations=answer.iterations,
                exact=answer.exact,
            )

        return fit_of(self.solver.solve(weighted, deadline, factors=factors, finish=finish, then=fit_of))


def _checked(subject: str, values: Floats, gamma_rad: Floats) -> Floats:
    def where(sample: tuple[int, ...]) -> str:
        return f"at the aspecular angle {np.rad2deg(gamma_rad[sample]):.4g}°"

    return check_targets(subject, values, (gamma_rad.size, 3), where)
