"""Products of textures: parabolic maps, look-up, what is refused. The common checks go over the registry."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from brdf_suite.errors import ValueRangeError
from brdf_suite.geometry.directions import spherical
from brdf_suite.geometry.factor_words import parse_factors
from brdf_suite.geometry.parabolic import parabolic_direction, parabolic_place, texel_directions
from brdf_suite.geometry.warps import half_vector
from brdf_suite.reflectance.factored.map import MapFactor, direction_density, map_density
from brdf_suite.reflectance.factored.model import Factored, build_factored


def look_up(values: np.ndarray, w: np.ndarray) -> np.ndarray:
    """Read a parabolic map at directions (..., 3)."""
    flat = np.asarray(w, float).reshape(-1, 3)
    return MapFactor("wi", values).at(flat, flat).reshape(w.shape)


@settings(max_examples=settings.default.max_examples // 2)
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


def _bumpy(size: int = 16) -> np.ndarray:
    rng = np.random.default_rng(6)
    return np.exp(rng.normal(0.0, 1.0, (size, size, 3))).astype(np.float32)


_RING = np.exp(-((np.arange(12)[:, None] / 5.0) ** 2) * np.ones(3)).astype(np.float32)
_FLAT = np.ones((2, 2, 3), np.float32)


@pytest.mark.parametrize(
    "model",
    [
        Factored(_FLAT, _bumpy()),
        Factored(_bumpy(), _FLAT),
        Factored(_RING, _RING),
        Factored(_FLAT, _FLAT, 0.1, peak=(MapFactor("sqrt|h|", _RING),)),
        Factored(_FLAT, _FLAT, 0.1, more=(MapFactor("w.h,h.n", _bumpy(8)),)),
    ],
    ids=["q of h", "p of wi", "radial", "peak", "two cosines"],
)
@pytest.mark.parametrize("theta", [0.3, 1.2])
def test_samples_fall_as_the_density_says(model: Factored, theta: float) -> None:
    """A χ² test over cells of the upper hemisphere and one more: what was lost below the horizon."""
    from scipy.stats import chi2

    count, rows, columns, fine = 20_000, 8, 16, 24
    wo = spherical(theta, 0.4)
    wi = model.sample(np.broadcast_to(wo, (count, 3)), np.random.default_rng(8).random((count, 3)))
    up = wi[:, 2] > 0.0
    turn = np.mod(np.arctan2(wi[up, 1], wi[up, 0]), 2.0 * np.pi)
    seen, _, _ = np.histogram2d(wi[up, 2], turn, (rows, columns), ((0.0, 1.0), (0.0, 2.0 * np.pi)))
    height = (np.arange(rows * fine) + 0.5) / (rows * fine)
    around = 2.0 * np.pi * (np.arange(columns * fine) + 0.5) / (columns * fine)
    where = spherical(*np.meshgrid(np.arccos(height), around, indexing="ij"))
    cell = 2.0 * np.pi / (rows * columns * fine * fine)
    density = model.pdf(where, np.broadcast_to(wo, where.shape)) * cell
    wanted = count * density.reshape(rows, fine, columns, fine).sum(axis=(1, 3))
    observed = np.append(seen.ravel(), count - up.sum())
    expected = np.append(wanted.ravel(), max(count - wanted.sum(), 0.0))
    # Cells of few samples are put together, as the test wants.
    few = expected < 8.0
    observed = np.append(observed[~few], observed[few].sum())
    expected = np.append(expected[~few], expected[few].sum())
    statistic = float(((observed - expected) ** 2 / np.maximum(expected, 8.0)).sum())
    assert chi2.sf(statistic, len(expected) - 1) > 1e-4


def test_a_map_that_stands_twice_is_one_array_and_maps_between_logarithms_hold_no_zero() -> None:
    model = Factored(_bumpy(), _RING, logarithmic=True)
    ((_, (first, second, third)),) = model.terms
    assert first.values is second.values
    assert (first.projection, second.projection, third.projection) == ("wi", "wo", "|h|")
    middle = parabolic_direction(0.0, 0.0)[None]
    around = model.p[7:9, 7:9].astype(float)
    np.testing.assert_allclose(
        first.at(middle, middle)[0], np.exp(np.log(around).mean(axis=(0, 1))), rtol=1e-6
    )
    with pytest.raises(ValueRangeError, match="p"):
        Factored(np.zeros((4, 4, 3)), _RING, logarithmic=True)
    with pytest.raises(ValueRangeError, match="projection"):
        MapFactor("nowhere", _RING)
    with pytest.raises(ValueRangeError, match="h"):
        MapFactor("h", _RING)


def test_a_factor_of_the_light_alone_is_not_reciprocal() -> None:
    assert Factored(_bumpy(), _RING).reciprocal
    assert not Factored(_bumpy(), _RING, more=(MapFactor("|wi|", _RING),)).reciprocal
    assert Factored(_bumpy(), _RING, more=(MapFactor("|wi|", _RING), MapFactor("|wo|", _RING))).reciprocal


@pytest.mark.parametrize(
    "words", ["p:wo p:wi p:wo p:wi q:h q:h", "p:wo p:wo p:wi", "q:|h| p:|wo| p:|wo| p:|wi|"]
)
def test_no_factor_is_lost_however_often_a_map_is_read(words: str) -> None:
    factors = parse_factors(words)
    rng = np.random.default_rng(6)
    maps = {
        one.name: (0.5 + rng.random((6,) * one.projection.axes + (3,))).astype(np.float32) for one in factors
    }
    wi, wo = (spherical(np.arccos(rng.random(50)), rng.uniform(0, 6, 50)) for _ in "ab")
    wanted = np.prod([MapFactor(one.projection.name, maps[one.name]).at(wi, wo) for one in factors], axis=0)
    found = build_factored(factors, maps, 1.0, logarithmic=False)
    np.testing.assert_allclose(found.eval(wi, wo), wanted, rtol=1e-6)
