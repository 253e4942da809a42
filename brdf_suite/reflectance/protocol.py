"""What every reflectance can do."""

from __future__ import annotations

from typing import Protocol

import numpy.typing as npt

from brdf_suite.geometry.directions import Floats


class Reflectance(Protocol):
    """A BRDF of the working space, linear RGB with the primaries of Rec. 2020."""

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., 3) in 1/sr, without the cosine, never negative; 0 below the horizon.

        Parameters
        ----------
        wi, wo
            Unit directions (..., 3) to the light and to the viewer, local frame with z along the normal;
            they broadcast.
        """
        ...
