"""Bins of the half-angle table: against the rotations they are defined by, and by hand."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from brdf_suite.errors import ValueRangeError
from brdf_suite.geometry.directions import from_half_angle_coordinates, half_angle_coordinates, spherical
from brdf_suite.reflectance.tabulated.half_angle_grid import HalfAngleGrid


def test_places_agree_with_the_rotations(directions: tuple[np.ndarray, np.ndarray]) -> None:
    wi, wo = directions
    theta_h, _, theta_d, phi_d = half_angle_coordinates(wi, wo)
    h, d, p = HalfAngleGrid(90, 90, 360, reciprocal=False).index_of(wi.T, wo.T)
    assert np.allclose(h, 90.0 * np.sqrt(theta_h / (np.pi / 2)), atol=1e-9)
    assert np.allclose(d, np.degrees(theta_d), atol=1e-9)
    turn = np.remainder(p - np.degrees(phi_d) + 180.0, 360.0) - 180.0
    assert np.allclose(turn, 0.0, atol=1e-7)


def test_swapping_light_and_view_turns_phi_by_half(directions: tuple[np.ndarray, np.ndarray]) -> None:
    wi, wo = directions
    whole = HalfAngleGrid(90, 90, 360, reciprocal=False)
    apart = np.remainder(whole.index_of(wi.T, wo.T)[2] - whole.index_of(wo.T, wi.T)[2], 360.0)
    assert np.allclose(apart, 180.0, atol=1e-6)
    half = HalfAngleGrid()
    for one, other in zip(half.index_of(wi.T, wo.T), half.index_of(wo.T, wi.T), strict=True):
        assert np.allclose(one, other, atol=1e-6)


@settings(max_examples=settings.default.max_examples // 2)
@given(st.integers(0, 89), st.integers(0, 89), st.integers(0, 179), st.floats(-3.0, 3.0))
def test_a_centre_lies_half_way_through_its_bin(h: int, d: int, p: int, azimuth: float) -> None:
    grid = HalfAngleGrid()
    theta_h, theta_d, phi_d = grid.centres()
    assert theta_h[h] == pytest.approx(((h + 0.5) / 90.0) ** 2 * np.pi / 2.0)
    wi, wo = from_half_angle_coordinates(theta_h[h], azimuth, theta_d[d], phi_d[p])
    found = [float(x[0]) for x in grid.index_of(wi[:, None], wo[:, None])]
    assert found == pytest.approx([h + 0.5, d + 0.5, p + 0.5], abs=1e-6)


def test_a_half_vector_near_the_normal_keeps_its_digits() -> None:
    tilt = 1e-9
    wi = spherical(0.7 + tilt, np.pi)[:, None]
    wo = spherical(0.7 - tilt, 0.0)[:, None]
    h, d, _ = HalfAngleGrid().index_of(wi, wo)
    assert float(h[0]) == pytest.approx(90.0 * np.sqrt(tilt / (np.pi / 2)), rel=1e-6)
    assert float(d[0]) == pytest.approx(np.degrees(0.7), abs=1e-9)


def test_a_mirror_pair_has_phi_zero_whatever_its_azimuth() -> None:
    azimuth = np.linspace(0.0, 6.0, 7)
    wi, wo = spherical(0.5, azimuth).T, spherical(0.5, azimuth).T * np.array([[-1.0], [-1.0], [1.0]])
    h, _, p = HalfAngleGrid().index_of(wi, wo)
    assert np.all(h < 1e-6)
    assert np.all(p == 0.0)


def test_the_mask_above_the_horizon_is_that_of_the_directions() -> None:
    grid = HalfAngleGrid(12, 10, 20)
    mask = grid.above_horizon()
    for h in range(12):
        wi, wo = grid.pairs(h)
        assert np.array_equal(mask[h], (wi[..., 2] > 0.0) & (wo[..., 2] > 0.0))


def test_every_bin_that_a_look_up_can_touch_is_named() -> None:
    grid = HalfAngleGrid(12, 10, 20)
    rng = np.random.default_rng(3)
    z, phi = rng.uniform(0.0, 1.0, (2, 200_000)) ** 2, rng.uniform(0.0, 2.0 * np.pi, (2, 200_000))
    wi, wo = (
        np.stack((np.sqrt(1 - c * c) * np.cos(a), np.sqrt(1 - c * c) * np.sin(a), c))
        for c, a in zip(z, phi, strict=True)
    )
    h, d, p = grid.index_of(wi, wo)
    reached = grid.reached()
    for a in (0, 1):
        for b in (0, 1):
            for c in (0, 1):
                at = (
                    np.clip(np.floor(h - 0.5).astype(int) + a, 0, 11),
                    np.clip(np.floor(d - 0.5).astype(int) + b, 0, 9),
                    (np.floor(p - 0.5).astype(int) + c) % 20,
                )
                assert reached[at].all()
    assert not reached.all()


@pytest.mark.parametrize("shape", [(1, 90, 180), (90, 0, 180), (4096, 4096, 4096)])
def test_sizes_that_cannot_be_are_refused(shape: tuple[int, int, int]) -> None:
    with pytest.raises(ValueRangeError, match="grid"):
        HalfAngleGrid(*shape)
