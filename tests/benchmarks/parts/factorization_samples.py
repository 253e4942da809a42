"""The sample set of Table 1 of McCool, Ang and Ahmad 2001, as far as the paper describes it.

The paper names the model (Poulin and Fournier's cylinders), 57,600 pairs even over both hemispheres, their mean 0.3855
and, through RMS error and SNR, their RMS 0.421; it does not name the parameters. Those here give both within half a
percent: touching half cylinders (spacing 2, floor 0) with a broad gloss, and a scale, since a mean of 0.3855 is
brighter than a surface that keeps its energy.
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from brdf_suite.fitting.homomorphic.samples import FactorizationSamples, even_directions
from brdf_suite.reflectance.models.poulin_fournier import PoulinFournier

SEED = 2001
PAIRS = 57_600
MEAN, RMS = 0.3855, 0.421
"""What Table 1 implies, 1/sr; within 2 % is wanted."""
CYLINDERS = PoulinFournier(kd=0.2, ks=1.0, exponent=2.0, spacing=2.0, floor=0.0)
SCALE = 1.5741


class Cylinders:
    """The model, scaled."""

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> np.ndarray:
        """Return f_r (..., 3) in 1/sr."""
        return np.asarray(SCALE * CYLINDERS.eval(wi, wo))


def cylinders() -> FactorizationSamples:
    """Return the pairs and the model's values."""
    rng = np.random.default_rng(SEED)
    wi, wo = even_directions(PAIRS, rng), even_directions(PAIRS, rng)
    return FactorizationSamples(wi, wo, Cylinders().eval(wi, wo))
