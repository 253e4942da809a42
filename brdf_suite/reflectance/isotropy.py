"""Whether a reflectance changes where the surface is turned about its normal."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.reflectance.protocol import Reflectance

_TURNS = (0.4, 1.3, 2.9)
_SAME_TURNED = 0.01
_PAIRS_SEED = 9


def is_isotropic(reflectance: Reflectance) -> bool:
    """Return whether turning light and view together changes nothing, as far as 512 pairs of directions show.

    A change of 1 % of a value, or of a hundredth of the median, counts: tables are not even to the last digit.
    """
    wi, wo = (pairs[:512] for pairs in even_pairs())
    still = np.nan_to_num(np.asarray(reflectance.eval(wi, wo)))
    floor = _SAME_TURNED * float(np.median(still)) + 1e-12
    turned = np.array([np.nan_to_num(Turned(reflectance, turn).eval(wi, wo)) for turn in _TURNS])
    return bool((np.abs(turned - still) <= _SAME_TURNED * still + floor).all())


@dataclass(frozen=True, eq=False)
class Turned:
    """A reflectance whose surface is turned about its normal by ``turn`` radians."""

    inner: Reflectance
    turn: float

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., 3) in 1/sr of the directions turned about the normal."""
        c, s = math.cos(self.turn), math.sin(self.turn)
        about_z = np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]])
        return self.inner.eval(np.asarray(wi, float) @ about_z, np.asarray(wo, float) @ about_z)


def even_pairs() -> tuple[Floats, Floats]:
    """Return wi, wo (n, 3), even over both hemispheres, always the same."""
    random = np.random.default_rng(_PAIRS_SEED)
    z = random.uniform(0.02, 1.0, (2, 2048))
    phi = random.uniform(-np.pi, np.pi, (2, 2048))
    flat = np.sqrt(1.0 - z * z)
    directions = np.stack((flat * np.cos(phi), flat * np.sin(phi), z), axis=-1)
    return directions[0], directions[1]
