"""Result of a fit of lobes: parameters and their errors, a reflectance, and a paint."""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.documents.cook_torrance import CookTorranceLobe, CookTorrancePaint
from brdf_suite.errors import FittingError
from brdf_suite.fitting.cook_torrance.model import LobeModel, Vector
from brdf_suite.fitting.cook_torrance.settings import Settings
from brdf_suite.fitting.cook_torrance.shapes import Terms
from brdf_suite.fitting.cook_torrance.solve import FitProblem
from brdf_suite.fitting.cook_torrance.uncertainty import StandardErrors
from brdf_suite.reflectance.blocks import in_blocks

if TYPE_CHECKING:
    from brdf_suite.documents.cook_torrance import CookTorrancePaint

# Relative standard errors above this are reported.
_POORLY_DETERMINED = 0.5


@dataclass(frozen=True, eq=False)
class CookTorranceFit:
    """Lobes fitted to samples; a reflectance itself, reciprocal and never negative.

    ``dropped`` are the lobes that the samples did not ask for: their weight is 0.
    """

    model: LobeModel
    vector: Vector
    settings: Settings
    standard_errors: StandardErrors
    problem: FitProblem
    dropped: tuple[int, ...] = ()

    @cached_property
    def _values(self) -> tuple[Floats, Floats, Floats, Floats]:
        return self.model.values(self.vector)

    @property
    def kd(self) -> Floats:
        """Diffuse reflectance (3,)."""
        return self._values[0]

    @property
    def ks(self) -> Floats:
        """Weights (N, 3) of the lobes, the sharp one last; a clearcoat has ¼."""
        return self._values[1]

    @property
    def m(self) -> Floats:
        """Slopes (N,); α of GGX."""
        return self._values[2]

    @property
    def r(self) -> Floats:
        """Fresnel reflectances (N,) along the normal."""
        return self._values[3]

    @cached_property
    def energy_mean(self) -> float:
        """Mean of |log(fit/measured)| over the values that the solver saw: equation 2 over its number of terms."""
        return self.problem.energy(self.vector)

    @property
    def energy(self) -> float:
        """Equation 2 of Günther et al. 2005 itself, a sum; Ψ is 0, since every parameter is plausible."""
        return self.energy_mean * self.problem.counted

    @cached_property
    def log_rms(self) -> float:
        """RMS of log(fit/measured) over the values that the solver saw, by their weights."""
        squares = self.problem.residuals(self.vector) ** 2 * self.problem.samples.weights
        return math.sqrt(float(squares.sum()) / self.problem.counted)

    @property
    def samples(self) -> int:
        """How many samples the solver saw."""
        return len(self.problem.samples)

    @property
    def left_out(self) -> int:
        """How many samples could not be used."""
        return self.problem.samples.left_out

    @property
    def notices(self) -> tuple[str, ...]:
        """Notices for the user."""
        notices = []
        used = self.problem.samples
        if used.left_out:
            notices.append(
                f"{used.left_out:,} samples are left out: black, not finite, not weighted, or seen at more than "
                f"{self.settings.grazing_deg:g}° from the normal."
            )
        if used.black and not used.floor.share:
            notices.append(f"{used.black:,} values of 0 or less have no logarithm and are left out.")
        elif used.black:
            notices.append(
                f"{100.0 * used.black_share:.1f} % of the values are 0 or less: colours outside of the working space, "
                f"or noise. To all, and to the fit, {100.0 * used.floor.share:g} % of the sample's brightest channel "
                f"and {used.floor.dark:.2g} /sr are added before the logarithm."
            )
        for channel, name in enumerate(("red", "green", "blue")):
            if not used.channels[channel]:
                notices.append(f"There is nothing in the {name} channel; its weights are 0.")
        if self.dropped:
            left, count = self.model.lobes - len(self.dropped), len(self.dropped)
            does = {0: "No lobe does", 1: "One lobe does"}.get(left, f"{left} lobes do")
            has = "the first has" if count == 1 else f"the first {count} have"
            notices.append(f"{does} as well as {self.model.lobes}; {has} no weight.")
        notices += self._poorly_determined()
        return tuple(notices)

    def _poorly_determined(self) -> list[str]:
        words = []
        for lobe in range(self.model.lobes):
            if lobe in self.dropped:
                continue
            error = float(self.standard_errors.r[lobe])
            if not math.isfinite(error) and self.r[lobe] < 0.999:
                words.append(
                    f"The Fresnel reflectance of lobe {lobe + 1} is not determined by these samples."
                )
            elif math.isfinite(error) and error > _POORLY_DETERMINED * float(self.r[lobe]):
                words.append(
                    f"Of lobe {lobe + 1} only ks times r is known: r is {self.r[lobe]:.2g} ± {error:.1g}."
                )
        return words

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., 3) in 1/sr, without the cosine; 0 below the horizon."""

        def block(light: Floats, view: Floats) -> Floats:
            return np.asarray(self._parts(light, view).sum(axis=0))

        return in_blocks(block, wi, wo)

    def parts(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return (1 + N, ..., 3): f_r of the diffuse part and of each lobe, which sum to :meth:`eval`."""
        light, view = np.broadcast_arrays(np.asarray(wi, float), np.asarray(wo, float))
        found = self._parts(light.reshape(-1, 3), view.reshape(-1, 3))
        return found.reshape(len(found), *light.shape)

    def _parts(self, light: Floats, view: Floats) -> Floats:
        above = (light[:, 2] > 0.0) & (view[:, 2] > 0.0)
        found = np.zeros((1 + self.model.lobes, len(light), 3))
        if above.any():
            terms = Terms.of(light[above], view[above])
            found[:, above] = self.model.parts(self.vector, terms).transpose(0, 2, 1)
        # What stands at the least weight is 0 here too.
        found[0] *= self.kd > 0.0
        found[1:] *= self.ks[:, None, :] > 0.0
        return found

    def paint(self, name: str, source: str = "", notes: str = "") -> CookTorrancePaint:
        """Return the lobes, but for those without weight, as a paint that every program opens.

        Raises
        ------
        FittingError
            The lobes are not of Cook and Torrance's kind, for which alone there are documents.
        ValueRangeError
            The data reflect so much that a parameter leaves a paint's range.
        """
        if self.model.name != "cook-torrance":
            raise FittingError(
                f"Lobes of the model {self.model.name} cannot be saved as a paint; fit cook-torrance, or write a table."
            )
        lobes = tuple(
            CookTorranceLobe(_three(ks), float(m), float(r))
            for number, (ks, m, r) in enumerate(zip(self.ks, self.m, self.r, strict=True))
            if number not in self.dropped
        )
        return CookTorrancePaint(name, _three(self.kd), lobes, notes=notes, source=source)

    def to_json(self) -> dict[str, object]:
        """Return everything as plain values; undetermined values are null."""
        errors = self.standard_errors
        return {
            "model": self.model.name,
            "settings": asdict(self.settings),
            "kd": self.kd.tolist(),
            "kd_standard_error": _plain(errors.kd),
            "lobes": [
                {
                    "ks": self.ks[lobe].tolist(),
                    "ks_standard_error": _plain(errors.ks[lobe]),
                    "m": float(self.m[lobe]),
                    "m_standard_error": _plain(errors.m[lobe]),
                    "r": float(self.r[lobe]),
                    "r_standard_error": _plain(errors.r[lobe]),
                    "correlation_ks_r": _plain(errors.correlation_ks_r[lobe]),
                }
                for lobe in range(self.model.lobes)
            ],
            "energy": self.energy,
            "energy_mean": self.energy_mean,
            "log_rms": self.log_rms,
            "samples": self.samples,
            "left_out": self.left_out,
            "lobes_without_weight": len(self.dropped),
            "notices": list(self.notices),
        }


def _three(values: Floats) -> tuple[float, float, float]:
    return float(values[0]), float(values[1]), float(values[2])


def _plain(values: npt.ArrayLike) -> object:
    """Return numbers as JSON data; None for non-finite ones."""
    array = np.asarray(values, np.float64)
    if array.ndim == 0:
        return float(array) if math.isfinite(float(array)) else None
    return [_plain(one) for one in array]
