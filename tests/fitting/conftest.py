"""A small analytic paint for the tests of the fit: a power lobe over a floor, under a Beckmann coat."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import pytest

from brdf_suite.arrays import Floats
from brdf_suite.fitting import LobeFitter


@dataclass(frozen=True)
class Layer:
    function: Callable[[Floats, Floats], Floats]

    def eval(self, wi: Floats, wo: Floats) -> Floats:
        wi, wo = np.broadcast_arrays(wi, wo)
        above = (wi[..., 2] > 0.0) & (wo[..., 2] > 0.0)
        return np.where(above[..., None], self.function(wi, wo), 0.0)


@dataclass(frozen=True)
class AnalyticPaint:
    base: Layer
    coat: Layer
    ior: float
    base_under_coat: bool = True


def analytic_paint(
    floor: tuple[float, float, float] = (0.02, 0.03, 0.05),
    face: tuple[float, float, float] = (0.3, 0.4, 0.5),
    exponent: float = 6.0,
    roughness: float = 0.004,
    reflected: float = 0.05,
) -> AnalyticPaint:
    """``reflected``: the coat's Fresnel factor, taken as the same for all directions."""

    def base(wi: Floats, wo: Floats) -> Floats:
        dot = wi[..., 2] * wo[..., 2] - wi[..., 0] * wo[..., 0] - wi[..., 1] * wo[..., 1]
        return np.array(floor) + np.array(face) * np.clip(dot, 0.0, 1.0)[..., None] ** exponent

    def coat(wi: Floats, wo: Floats) -> Floats:
        half = wi + wo
        tan2 = (half[..., 0] ** 2 + half[..., 1] ** 2) / np.maximum(half[..., 2] ** 2, 1e-30)
        facets = np.exp(-tan2 / roughness**2) * (1.0 + tan2) ** 2 / (np.pi * roughness**2)
        cosines = np.where((wi[..., 2] > 0) & (wo[..., 2] > 0), wi[..., 2] * wo[..., 2], 1.0)
        return (reflected * facets / (4.0 * cosines))[..., None] * np.ones(3)

    return AnalyticPaint(Layer(base), Layer(coat), 1.5)


@pytest.fixture(scope="session")
def make_paint() -> Callable[..., AnalyticPaint]:
    return analytic_paint


@pytest.fixture(scope="session")
def fitter() -> LobeFitter:
    """One kept fitter; its generous limit keeps a loaded machine out of tests of values."""
    return LobeFitter(time_limit_s=5.0)
