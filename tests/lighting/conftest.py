"""Small environments for the lighting tests, and the truth that the prefilter is tested with."""

from __future__ import annotations

import zlib
from collections.abc import Callable

import numpy as np
import pytest

from brdf_suite.lighting.filter.kernels.compilation import compile_now
from brdf_suite.lighting.latlong import column_angles, direction, fejer_weights, ring_angles


@pytest.fixture(scope="session")
def kernels_compiled() -> None:
    """Compile the kernels, where that has not been done on this machine."""
    assert compile_now() is not None


@pytest.fixture(scope="session")
def rough_map() -> np.ndarray:
    """A map (256, 512, 3) of noise with lights, as hard on a filter as real ones."""
    rng = np.random.default_rng(11)
    pixels = rng.random((256, 512, 3)).astype(np.float32)
    pixels[100:104, 300:305] += np.float32(500.0)
    pixels[3, 40] += np.float32(2000.0)
    return pixels


@pytest.fixture(scope="session")
def double_sum() -> Callable[[np.ndarray, np.ndarray, float], np.ndarray]:
    """The defining integral as a plain double sum in float64.

    P_E(R) = (E+1)/(2π) · Σ_texels L · max(0, R·ω)^E · weight,   weight = Fejér ring weight × longitude step
    """
    known: dict[tuple[int, bytes, float], np.ndarray] = {}

    def remembered(radiance: np.ndarray, directions: np.ndarray, exponent: float) -> np.ndarray:
        # Tests of several ways to the same map ask for the same sums.
        key = (zlib.crc32(radiance.tobytes()), directions.tobytes(), exponent)
        if key not in known:
            known[key] = _double_sum(radiance, directions, exponent)
        return known[key]

    return remembered


def _double_sum(radiance: np.ndarray, directions: np.ndarray, exponent: float) -> np.ndarray:
    """Return the lobe map's values (n, 3) along unit directions (n, 3)."""
    height, width = radiance.shape[:2]
    towards = direction(ring_angles(height)[:, None], column_angles(width)[None, :]).reshape(-1, 3)
    weights = np.repeat(fejer_weights(height) * (2.0 * np.pi / width), width)
    flux = radiance.reshape(-1, 3).astype(np.float64) * weights[:, None]
    values = []
    least = np.exp(-745.0 / exponent)  # the power of a smaller cosine is 0
    for wanted in directions:
        above = np.flatnonzero(towards @ wanted > least - 1e-9)
        # 1 - cosδ from the chord: a dot product near 1 would lose exponent·1e-16.
        chord = towards[above] - wanted
        cosine = 1.0 - 0.5 * np.einsum("ij,ij->i", chord, chord)
        values.append(np.maximum(cosine, 0.0) ** exponent @ flux[above])
    return np.array(values) * (exponent + 1.0) / (2.0 * np.pi)
