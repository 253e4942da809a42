"""Directions and a smooth reflectance that changes along every half-angle axis."""

from __future__ import annotations

import numpy as np
import pytest

from brdf_suite.geometry.directions import half_angle_coordinates


class SmoothReflectance:
    """f_r as a formula of (θh, θd, φd) that no two axes share, another in each channel; reciprocal on demand."""

    def __init__(self, lopsided: float = 0.0) -> None:
        self.lopsided = lopsided

    def of_angles(self, theta_h: np.ndarray, theta_d: np.ndarray, phi_d: np.ndarray) -> np.ndarray:
        turn = 1.0 + 0.2 * np.cos(2.0 * phi_d) + 0.1 * np.sin(2.0 * phi_d) + self.lopsided * np.cos(phi_d)
        lobe = np.exp(-((theta_h / 0.3) ** 2))
        return np.stack(
            (
                (0.3 + lobe) * turn * np.cos(0.5 * theta_d),
                0.2 * turn * (1.0 + theta_d),
                (0.1 + 0.5 * lobe) * (1.0 + 0.5 * theta_d) * turn,
            ),
            axis=-1,
        )

    def eval(self, wi: np.ndarray, wo: np.ndarray) -> np.ndarray:
        wi, wo = np.broadcast_arrays(wi, wo)
        theta_h, _, theta_d, phi_d = half_angle_coordinates(wi, wo)
        above = (wi[..., 2] > 0.0) & (wo[..., 2] > 0.0)
        return self.of_angles(theta_h, theta_d, phi_d) * above[..., None]


def upper_directions(rng: np.random.Generator, count: int, lowest: float = 0.0) -> np.ndarray:
    z = rng.uniform(lowest, 1.0, count)
    phi = rng.uniform(0.0, 2.0 * np.pi, count)
    s = np.sqrt(1.0 - z * z)
    return np.stack((s * np.cos(phi), s * np.sin(phi), z), axis=-1)


@pytest.fixture(scope="session")
def smooth() -> SmoothReflectance:
    return SmoothReflectance()


@pytest.fixture(scope="session")
def lopsided() -> SmoothReflectance:
    return SmoothReflectance(0.3)


@pytest.fixture
def directions() -> tuple[np.ndarray, np.ndarray]:
    rng = np.random.default_rng(5)
    return upper_directions(rng, 4000, 0.15), upper_directions(rng, 4000, 0.15)
