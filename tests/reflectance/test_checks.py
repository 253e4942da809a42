"""The checks find what is wrong, measure it, and hold nothing against what is only disclaimed."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import pytest

from brdf_suite.geometry.directions import illumination
from brdf_suite.geometry.fresnel import fresnel_at
from brdf_suite.reflectance.albedo import directional_albedo, hemispherical_albedo, white_furnace
from brdf_suite.reflectance.checks import CheckReport, check_reflectance
from brdf_suite.reflectance.designed.coat_lobe import CoatLobe
from brdf_suite.reflectance.isotropy import is_isotropic
from brdf_suite.reflectance.models.lambertian import Lambertian
from brdf_suite.reflectance.registry import MODELS


@dataclass(frozen=True)
class Tilted:
    """f = (a + b cosθi)/π: not reciprocal, and with a = -1 negative."""

    a: float
    b: float

    def eval(self, wi, wo):
        wi, wo = np.broadcast_arrays(wi, wo)
        above = (wi[..., 2] > 0.0) & (wo[..., 2] > 0.0)
        return np.repeat(
            np.where(above, (self.a + self.b * wi[..., 2]) / math.pi, 0.0)[..., None], 3, axis=-1
        )


def finding(report: CheckReport, check: str):
    return next(f for f in report.findings if f.check == check)


def test_a_matt_surface_sends_back_its_albedo_at_every_angle() -> None:
    wi = illumination(np.array([0.0, 45.0, 80.0, 89.0]))
    np.testing.assert_allclose(
        directional_albedo(Lambertian((1.0, 0.5, 0.1)), wi), [[1.0, 0.5, 0.1]] * 4, atol=3e-4
    )


@pytest.mark.parametrize("roughness", [0.002, 0.01])
@pytest.mark.parametrize("angle", [0.0, 30.0, 60.0, 80.0])
def test_a_narrow_coat_sends_back_fresnels_share(roughness: float, angle: float) -> None:
    found = directional_albedo(CoatLobe(1.5, roughness), illumination(angle))
    np.testing.assert_allclose(found, fresnel_at(angle, 1.5), rtol=3e-3)


def test_light_and_view_are_distinguished() -> None:
    """f = cosθi/π: with the light at θ all of it is cosθ; with the view at θ it is ∫ cos²/π = 2/3."""
    wi = illumination(np.array([0.0, 60.0]))
    np.testing.assert_allclose(directional_albedo(Tilted(0.0, 1.0), wi)[:, 0], [1.0, 0.5], atol=1e-3)
    np.testing.assert_allclose(white_furnace(Tilted(0.0, 1.0), wi)[:, 0], 2.0 / 3.0, atol=1e-3)


def test_the_mean_over_even_light() -> None:
    """∫ cosθ dsin²θ = 2/3."""
    np.testing.assert_allclose(hemispherical_albedo(Tilted(0.0, 1.0)), 2.0 / 3.0, atol=1e-3)


def test_a_broken_claim_is_a_fault_with_its_size() -> None:
    report = check_reflectance(Tilted(0.0, 1.5), "tilted", reciprocal=True, energy_conserving=True)
    assert not report.passed
    assert finding(report, "reciprocity").outcome == "violated"
    energy = finding(report, "directional_albedo")
    assert energy.outcome == "violated"
    assert energy.size == pytest.approx(0.5, abs=2e-3)
    assert energy.where == "light at 0°, red"
    # With the view fixed this one sends back 1.5 · 2/3.
    assert finding(report, "white_furnace").outcome == "held"


def test_what_is_disclaimed_is_listed_and_passes() -> None:
    report = check_reflectance(Tilted(0.0, 1.5), "tilted", reciprocal=False, energy_conserving=False)
    assert report.passed
    assert finding(report, "reciprocity").outcome == "known violator"
    assert finding(report, "white_furnace").outcome == "declared, not seen"


def test_what_declares_nothing_is_only_measured() -> None:
    report = check_reflectance(Tilted(0.0, 0.5), "table")
    assert report.passed
    assert finding(report, "reciprocity").outcome == "measured"
    assert finding(report, "reciprocity").size > 0.5


def test_nothing_may_be_negative_or_not_finite() -> None:
    report = check_reflectance(Tilted(-0.2, 1.0), "dark")
    assert finding(report, "non_negativity").outcome == "violated"
    assert finding(report, "non_negativity").size == pytest.approx(0.2 / math.pi, rel=1e-2)
    broken = check_reflectance(Tilted(math.nan, 1.0), "broken")
    assert not broken.passed
    assert finding(broken, "non_negativity").size == math.inf


def test_the_median_distinguishes_a_common_violation_from_a_rare_one() -> None:
    """For f = cosθi/π the relative difference is |cosθi - cosθo| / max; over even pairs its median is 1 - 1/√2.

    cosθ is √u with u even, so the smaller over the larger cosine is the root of an even number.
    """
    found = finding(check_reflectance(Tilted(0.0, 1.0), "cosine"), "reciprocity")
    assert found.typical == pytest.approx(1.0 - math.sqrt(0.5), abs=0.02)
    assert finding(check_reflectance(Lambertian(0.5), "matt"), "reciprocity").typical == 0.0


class BackToTheLamp:
    """Light sent back to where it came from, in a lobe of exponent n: the furnace of a view is k·2π/(n+1)."""

    n, share = 3000.0, 0.4

    def eval(self, wi: np.ndarray, wo: np.ndarray) -> np.ndarray:
        wi, wo = np.broadcast_arrays(np.asarray(wi, float), np.asarray(wo, float))
        above = (wi[..., 2] > 0.0) & (wo[..., 2] > 0.0)
        lobe = np.clip((wi * wo).sum(axis=-1), 0.0, 1.0) ** self.n * (self.n + 1.0) / (2.0 * math.pi)
        value = np.where(above, self.share * lobe / np.maximum(wi[..., 2], 1e-9), 0.0)
        return np.repeat(value[..., None], 3, axis=-1)


def test_a_peak_away_from_the_mirror_direction_is_not_missed() -> None:
    report = check_reflectance(BackToTheLamp(), "tape", incidence_deg=(15.0, 30.0, 60.0))
    np.testing.assert_allclose(report.furnace[:, 1], 0.4, rtol=5e-3)


def test_a_brushed_metal_is_not_isotropic() -> None:
    assert not is_isotropic(MODELS["poulin_fournier"].default)
    assert is_isotropic(MODELS["cook_torrance"].default)
