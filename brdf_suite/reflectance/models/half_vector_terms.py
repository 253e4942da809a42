"""Half-vector terms of a direction pair, shared by all lobes of microfacet models."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from brdf_suite.arrays import Floats

# Keeps tan⁴ of a half vector at the horizon finite; no lobe reaches there.
_TINY = 1e-60


@dataclass(frozen=True)
class HalfVectorTerms:
    """Terms (n,) of direction pairs; where ``above`` is False the others are finite but meaningless."""

    cos_i: Floats
    cos_o: Floats
    cos_d: Floats
    """wi·h = wo·h."""
    cos_h: Floats
    tan2_h: Floats
    """tan² of the half vector's polar angle, exact also where its cosine is 1 but for rounding."""
    above: np.ndarray[tuple[int, ...], np.dtype[np.bool_]]

    @classmethod
    def of(cls, wi: Floats, wo: Floats) -> HalfVectorTerms:
        """Return the terms for directions (n, 3)."""
        cos_i, cos_o = wi[:, 2], wo[:, 2]
        x, y, z = wi[:, 0] + wo[:, 0], wi[:, 1] + wo[:, 1], cos_i + cos_o
        across = x * x + y * y
        up = np.maximum(z * z, _TINY)
        above = (cos_i > 0.0) & (cos_o > 0.0)
        # |wi + wo| = 2 wi·h.
        cos_d = 0.5 * np.sqrt(across + up)
        cos_h = 0.5 * z / cos_d
        return cls(cos_i, cos_o, cos_d, cos_h, across / up, above)
