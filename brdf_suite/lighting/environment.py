"""Environment: radiance from every direction, with an identity derived from its content."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from brdf_suite.errors import ValueRangeError
from brdf_suite.lighting.latlong import fejer_weights

SMALL_COLUMNS = 512
"""Columns of the light of small pictures: in one some 400 pixels wide, mirrored in a curved body, more are not seen."""


@dataclass(frozen=True, eq=False)
class Environment:
    """Light from infinitely far away, as a latitude-longitude map.

    Attributes
    ----------
    name
        What the user calls it.
    radiance
        (h, w, 3) float32, h ≥ 4, linear Rec. 2020 with D65 white, finite, not negative; row 0 is up (+y), the
        centre column looks along +z, u grows towards -x. The array is made read-only.
    notes
        What was assumed or repaired on reading.
    content_hash
        SHA-256 of shape and pixels, in hexadecimal: equal light has an equal hash, whatever its name.

    Raises
    ------
    ValueRangeError
        The radiance has another shape, is not finite, or negative.

    >>> import brdf_suite as bs, numpy as np
    >>> bs.Environment("grey", np.full((64, 128, 3), 0.5)).average().round(3).tolist()
    [0.5, 0.5, 0.5]
    """

    name: str
    radiance: NDArray[np.float32]
    notes: tuple[str, ...] = ()
    content_hash: str = field(init=False)

    def __post_init__(self) -> None:
        radiance = np.ascontiguousarray(self.radiance, dtype=np.float32)
        if radiance.ndim != 3 or radiance.shape[2] != 3 or radiance.shape[0] < 4 or radiance.shape[1] < 8:
            shape = radiance.shape
            raise ValueRangeError("radiance", f"must have shape (h, w, 3), at least (4, 8, 3), not {shape}")
        if not np.isfinite(radiance).all() or float(radiance.min()) < 0.0:
            raise ValueRangeError("radiance", "must be finite and never negative")
        if radiance is self.radiance:
            radiance = radiance.copy()
        radiance.flags.writeable = False
        digest = hashlib.sha256(repr(radiance.shape).encode())
        digest.update(radiance.data)
        object.__setattr__(self, "radiance", radiance)
        object.__setattr__(self, "content_hash", digest.hexdigest())

    def average(self) -> NDArray[np.float64]:
        """Return the mean radiance (3,) over the sphere, linear Rec. 2020.

        >>> import brdf_suite as bs, numpy as np
        >>> half = np.zeros((64, 128, 3))
        >>> half[:32] = 1.0  # the upper half of the sphere
        >>> bs.Environment("half", half).average().round(3).tolist()
        [0.5, 0.5, 0.5]
        """
        weights = fejer_weights(self.radiance.shape[0]) / 2.0
        rows = self.radiance.mean(axis=1, dtype=np.float64)
        return np.asarray(weights @ rows, dtype=np.float64)
