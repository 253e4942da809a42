"""Products of textures: parabolic maps, look-up, what is refused. The common checks go over the registry."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from brdf_suite.errors import ValueRangeError
from brdf_suite.geometry.directions import spherical
from brdf_suite.geometry.parabolic import parabolic_direction, parabolic_place, texel_directions
from brdf_suite.geometry.warps import half_vector
from brdf_suite.reflectance.factor_density import direction_density, map_density
from brdf_suite.reflectance.factor_map import MapFactor
from brdf_suite.reflectance.factored import Factored


def look_up(values: np.ndarray, w: np.ndarray) -> np.ndarray:
    """Read a parabolic map at directions (..., 3)."""
    flat = np.asarray(w, float).reshape(-1, 3)
    return MapFactor("wi", values).at(flat, flat).reshape(w.shape)


@settings(max_examples=30, deadline=None)
@given(st.floats(0.0, 1.57), st.floats(-3.1, 3.1))
def test_a_direction_comes_back_from_its_place(theta: float, phi: float) -> None:
    w = spherical(theta, phi)
    s, t = parabolic_place(w)
    np.testing.assert_allclose(parabolic_direction(s, t), w, atol=1e-12)
    # r = tan(θ/2): the horizon is the circle of radius 1.
    assert np.hypot(s, t) == pytest.approx(np.tan(0.5 * theta), abs=1e-12)


def test_a_look_up_gives_texels_at_their_centres_and_is_linear_between() -> None:
    rng = np.random.default_rng(1)
    values = rng.random((8, 8, 3)).astype(np.float32)
    where = texel_directions(8)
    inside = np.hypot(*parabolic_place(where)) < 0.999
    np.testing.assert_allclose(look_up(values, where)[inside], values[inside], rtol=1e-6)
    middle = parabolic_direction(0.0, 0.0)
    np.testing.assert_allclose(look_up(values, middle), values[3:5, 3:5].mean(axis=(0, 1)), rtol=1e-6)
    ramp = np.broadcast_to(np.arange(8, dtype=np.float32)[:, None], (8, 8))[..., None].repeat(3, -1)
    s, t = rng.uniform(-0.6, 0.6, (2, 50))
    np.testing.assert_allclose(
        look_up(ramp, parabolic_direction(s, t))[:, 0], 4.0 * (t + 1.0) - 0.5, rtol=1e-6
    )


def test_the_product_is_that_of_the_maps_and_reciprocal() -> None:
    rng = np.random.default_rng(2)
    p, q = rng.random((6, 6, 3)), rng.random((12, 12, 3))
    model = Factored(p, q, (0.5, 1.0, 2.0))
    wi, wo = (spherical(np.arccos(rng.random(200)), rng.uniform(0, 6, 200)) for _ in "ab")
    wanted = (
        look_up(model.p, wi) * look_up(model.p, wo) * look_up(model.q, half_vector(wi, wo)) * [0.5, 1.0, 2.0]
    )
    np.testing.assert_allclose(model.eval(wi, wo), wanted, rtol=1e-12)
    np.testing.assert_allclose(model.eval(wo, wi), wanted, rtol=1e-9)


def test_a_map_finer_by_half_is_nearer_to_its_function() -> None:
    def lobe(w: np.ndarray) -> np.ndarray:
        return np.exp(-8.0 * (1.0 - w[..., 2:])) * np.array([1.0, 0.5, 0.2])

    rng = np.random.default_rng(3)
    wi, wo = (spherical(np.arccos(rng.random(2000)), rng.uniform(0, 6, 2000)) for _ in "ab")
    wanted = lobe(wi) * lobe(wo) * lobe(half_vector(wi, wo))
    errors = [
        np.abs(Factored.from_functions(lobe, lobe, n).eval(wi, wo) - wanted).mean() / wanted.mean()
        for n in (16, 32, 64)
    ]
    assert errors[1] < 0.35 * errors[0]
    assert errors[2] < 0.35 * errors[1]
    assert errors[2] < 0.01


def test_the_density_of_a_map_is_one_over_the_hemisphere() -> None:
    rng = np.random.default_rng(4)
    density = map_density(rng.random((16, 16, 3)).astype(np.float32))
    assert density.sum() == pytest.approx(1.0)
    z, phi = np.meshgrid((np.arange(300) + 0.5) / 300, 2 * np.pi * np.arange(600) / 600, indexing="ij")
    w = spherical(np.arccos(z), phi)
    whole = direction_density(density, w).mean() * 2.0 * np.pi
    assert whole == pytest.approx(1.0, abs=0.04)  # texels on the horizon lie half below it


def test_a_black_product_can_be_sampled() -> None:
    black = Factored(np.zeros((4, 4, 3)), np.zeros((4, 4, 3)))
    wo = spherical(np.full(50, 0.4), 0.0)
    wi = black.sample(wo, np.random.default_rng(5).random((50, 3)))
    assert np.isfinite(wi).all()
    assert (black.pdf(wi, wo)[wi[:, 2] > 0] > 0.0).all()
    assert not black.eval(wi, wo).any()


@pytest.mark.parametrize(
    ("p", "q", "alpha", "place"),
    [
        (np.zeros((4, 5, 3)), np.zeros((4, 4, 3)), 1.0, "p"),
        (np.zeros((4, 4, 3)), np.zeros((4, 4)), 1.0, "q"),
        (np.zeros((1, 1, 3)), np.zeros((4, 4, 3)), 1.0, "p"),
        (np.full((4, 4, 3), -1.0), np.zeros((4, 4, 3)), 1.0, "p"),
        (np.zeros((4, 4, 3)), np.full((4, 4, 3), np.nan), 1.0, "q"),
        (np.zeros((4, 4, 3), complex), np.zeros((4, 4, 3)), 1.0, "p"),
        (np.zeros((4, 4, 3)), np.zeros((4, 4, 3)), -1.0, "alpha"),
    ],
)
def test_what_is_no_map_is_refused_by_name(p, q, alpha, place: str) -> None:
    with pytest.raises(ValueRangeError, match=place):
        Factored(p, q, alpha)
