"""Samples near a cut: which they are, where they lie, and that they are those of the line there."""

from __future__ import annotations

import numpy as np
import pytest

from brdf_suite.geometry.directions import from_half_angle_coordinates, illumination, spherical
from brdf_suite.inspection.slices.cuts import difference_slice, half_slice, light_at, plane_slice, view_at
from brdf_suite.inspection.slices.values import NEAR_DEG, points_near
from brdf_suite.reflectance.models.poulin_fournier import PoulinFournier
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples


def samples_at(wi: np.ndarray, wo: np.ndarray, *, isotropic: bool = True) -> ScatteredSamples:
    wi, wo = np.broadcast_arrays(wi, wo)
    return ScatteredSamples(wi, wo, PoulinFournier().eval(wi, wo), isotropic=isotropic)


@pytest.mark.parametrize("axis", ["gamma", "theta_o"])
def test_isotropic_samples_are_turned_into_the_plane(axis: str) -> None:
    theta_o = np.array([10.0, 30.0, 60.0])
    turn = np.radians([0.0, 75.0, -140.0])
    wi = spherical(np.radians([40.0, 41.0, 43.0]), turn + np.pi)  # the last is too far
    wo = spherical(np.radians(theta_o), turn)
    cut = plane_slice(40.0, 20.0).over(axis, 40.0)
    found = points_near(cut, samples_at(wi, wo), isotropic=True, cosine="none")
    # γ is kept, so that a peak stays at the mirror direction: 40 - 10 and 41 - 30.
    wanted = [11.0, 30.0] if axis == "gamma" else [10.0, 29.0]
    assert np.sort(found.angle_deg) == pytest.approx(wanted)


def test_a_pair_counts_for_its_swap() -> None:
    wi, wo = light_at(50.0, 0.0)[None], view_at(np.array([20.0]), 0.0)
    found = points_near(plane_slice(20.0, 0.0), samples_at(wi, wo), isotropic=True, cosine="light")
    assert found.angle_deg == pytest.approx([50.0])
    assert found.value == pytest.approx(PoulinFournier().eval(wi, wo) * np.cos(np.radians(20.0)))


def test_anisotropic_samples_are_of_their_azimuth() -> None:
    samples = samples_at(illumination(np.array([40.0])), spherical(np.radians([25.0]), 0.0), isotropic=False)
    for phi, count in ((0.0, 1), (90.0, 0), (180.0, 0)):
        found = points_near(plane_slice(40.0, phi), samples, isotropic=False, cosine="none")
        assert len(found.angle_deg) == count


@pytest.mark.parametrize("isotropic", [True, False])
def test_samples_near_the_half_angle_cuts(isotropic: bool) -> None:
    theta_h = np.radians([5.0, 20.0, 20.0, 20.0])
    theta_d = np.radians([30.0, 31.0, 36.0, 30.0])
    phi_d = np.radians([90.0, 90.0, 90.0, 20.0])
    wi, wo = from_half_angle_coordinates(theta_h, 0.0, theta_d, phi_d)
    samples = samples_at(wi, wo, isotropic=isotropic)
    over_h = points_near(half_slice(30.0, 90.0, 0.0), samples, isotropic=isotropic, cosine="none")
    assert set(np.round(over_h.angle_deg, 6)) == {5.0, 20.0}  # 36° and the azimuth of 20° are too far
    over_d = points_near(difference_slice(20.0, 90.0, 0.0), samples, isotropic=isotropic, cosine="none")
    assert set(np.round(over_d.angle_deg, 6)) == {31.0, 36.0}


def test_all_that_are_found_are_as_near_as_said() -> None:
    rng = np.random.default_rng(3)
    wi, wo = (
        spherical(np.arccos(rng.uniform(0.05, 1.0, 4000)), rng.uniform(-np.pi, np.pi, 4000)) for _ in range(2)
    )
    samples = samples_at(wi, wo)
    found = points_near(plane_slice(35.0, 0.0), samples, isotropic=True, cosine="none")
    assert 0 < len(found.angle_deg) < 400
    assert np.abs(found.angle_deg).max() <= 90.0 + NEAR_DEG
