"""Random pairs of directions at which tables of real materials are looked at."""

from __future__ import annotations

import numpy as np

from brdf_suite.geometry.directions import spherical


def hemisphere(n: int, seed: int = 1) -> np.ndarray:
    rng = np.random.default_rng(seed)
    return spherical(np.arccos(rng.random(n)), rng.uniform(0.0, 2.0 * np.pi, n))


def pairs(n: int) -> tuple[np.ndarray, np.ndarray]:
    """Random directions above the horizon; half of the views near the mirror direction."""
    wi, wo = hemisphere(n), hemisphere(n, 2)
    near = wi[: n // 2] * (-1.0, -1.0, 1.0) + 0.1 * np.random.default_rng(3).normal(size=(n // 2, 3))
    wo[: n // 2] = near / np.linalg.norm(near, axis=1)[:, None]
    # In single precision, as the renderer sees them: near the horizon the rounding of a direction counts.
    return wi.astype(np.float32).astype(float), wo.astype(np.float32).astype(float)
