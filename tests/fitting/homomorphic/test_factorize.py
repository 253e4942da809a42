"""Homomorphic factorization: what is a product is found, what is not is approximated, and nothing bad comes out."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from brdf_suite.errors import FittingError, ValueRangeError
from brdf_suite.fitting.homomorphic.factorization import accuracy
from brdf_suite.fitting.homomorphic.peak import factorize_with_peak
from brdf_suite.fitting.homomorphic.product_fit import factorize
from brdf_suite.fitting.homomorphic.samples import FactorizationSamples, even_directions, sample_reflectance
from brdf_suite.fitting.homomorphic.solve import MapLayout, constraints, smoothness
from brdf_suite.geometry import warps
from brdf_suite.geometry.factor_words import (
    DEFAULT_FACTORS,
    PROJECTIONS,
    parse_factors,
)
from brdf_suite.geometry.parabolic import bilinear
from brdf_suite.reflectance.models.cook_torrance import CookTorrance
from brdf_suite.reflectance.models.table_1 import TABLE_1
from tools.evaluation.factor_storage import compression, quantize_maps
from tools.evaluation.separable_expansion import separate


def pairs(count: int = 4000, seed: int = 1) -> tuple[np.ndarray, np.ndarray]:
    rng = np.random.default_rng(seed)
    return even_directions(count, rng), even_directions(count, rng)


def product(wi: np.ndarray, wo: np.ndarray) -> np.ndarray:
    """A reciprocal product of smooth functions of wo, h and wi: α p(wo) q(h) p(wi), coloured."""

    def p(w: np.ndarray) -> np.ndarray:
        return np.exp(0.8 * w[:, :1] * w[:, 1:2] + np.array([0.3, 0.0, -0.3]) * w[:, 2:])

    def q(h: np.ndarray) -> np.ndarray:
        return np.exp(3.0 * (h[:, 2:] - 1.0) - 1.5 * h[:, :1] ** 2)

    return 0.2 * p(wo) * q(warps.half_vector(wi, wo)) * p(wi)


class Shiny:
    """A product with a peak over the half vector, isotropic, brighter at grazing: a smooth stand-in for a paint."""

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> np.ndarray:
        light, view = np.broadcast_arrays(np.asarray(wi, float), np.asarray(wo, float))
        h = warps.half_vector(light, view)
        across = np.sum(light * h, axis=-1, keepdims=True)
        body = np.exp(2.0 * (light[..., 2:] + view[..., 2:]) - 2.0) * np.array([0.02, 0.05, 0.2])
        return body + (1.0 + 3.0 * (1.0 - across) ** 2) * np.exp(-np.maximum(1.0 - h[..., 2:], 0.0) / 0.02)


def relative(found: np.ndarray, wanted: np.ndarray) -> float:
    return float(np.sqrt(np.mean((found / wanted - 1.0) ** 2)))


@pytest.mark.parametrize("solver", ["direct", "iterative"])
def test_a_product_is_found_also_where_no_sample_was(solver: str) -> None:
    wi, wo = pairs(6000)
    found = factorize(wi, wo, product(wi, wo), resolution=16, smooth=0.02, solver=solver)
    new = pairs(2000, seed=2)
    assert relative(found.product.eval(*new), product(*new)) < 0.03
    assert found.solver == solver
    assert found.product.reciprocal
    np.testing.assert_allclose(found.product.eval(*new), found.product.eval(*new[::-1]), rtol=1e-12)
    for logs in found.product.logs.values():
        np.testing.assert_allclose(logs.reshape(-1, 3).mean(axis=0), 0.0, atol=1e-12)


def test_the_energy_is_kept_in_each_channel() -> None:
    samples = sample_reflectance(CookTorrance(TABLE_1["table1_polaris_silver"]), 8000)
    found = factorize(samples.wi, samples.wo, samples.values, resolution=16)
    cosines = (samples.wi[:, 2] * samples.wo[:, 2])[:, None]
    sent = (cosines * found.product.eval(samples.wi, samples.wo)).mean(axis=0)
    np.testing.assert_allclose(sent, (cosines * samples.values).mean(axis=0), rtol=1e-9)
    plain = factorize(samples.wi, samples.wo, samples.values, resolution=16, keep_mean=False)
    np.testing.assert_allclose(plain.product.alpha * found.mean_correction, found.product.alpha)
    assert (plain.mean_correction == 1.0).all()


def test_equation_14_sums_coefficients_that_coincide() -> None:
    layout = MapLayout.of(parse_factors(DEFAULT_FACTORS), 8)
    wi = np.array([[0.0, 0.6, 0.8]])
    matrix = constraints(layout, wi, wi)  # light and view are one: p is read twice in the same texels
    assert matrix.nnz == 8
    np.testing.assert_allclose(matrix.sum(), 3.0, rtol=1e-6)
    texels, weights = bilinear(PROJECTIONS["wi"].places(wi, wi), (8, 8))
    np.testing.assert_allclose(matrix.toarray()[0, texels[0]], 2.0 * weights[0], rtol=1e-6)


def test_the_masks_of_figure_3() -> None:
    laplacian = smoothness(MapLayout.of(parse_factors("p:wi"), 4)).toarray().reshape(4, 4, 4, 4)
    assert laplacian[1, 2, 1, 2] == 4
    assert laplacian[0, 2, 0, 2] == 3
    assert laplacian[0, 0, 0, 0] == 2
    assert laplacian[0, 0, 0, 1] == laplacian[0, 0, 1, 0] == -1
    assert laplacian[1, 1, 2, 2] == 0
    np.testing.assert_allclose(laplacian.sum(axis=(2, 3)), 0.0)


@pytest.mark.parametrize(
    "factors", [DEFAULT_FACTORS, "p:w.h,h.n q:wi.n,wo.n", "p:|wo| q:|h| p:|wi|", "a:h b:w.h", "a:wi.wo b:h"]
)
def test_every_projection_comes_near_an_isotropic_paint(factors: str) -> None:
    samples = sample_reflectance(Shiny(), 6000)
    found = factorize(samples.wi, samples.wo, samples.values, factors=factors, resolution=16)
    near = accuracy(samples.values, found.product.eval(samples.wi, samples.wo))
    flat = accuracy(samples.values, np.broadcast_to(samples.values.mean(axis=0), samples.values.shape))
    assert near.snr_db > flat.snr_db + 1.0
    assert near.mean_relative < 0.6 * flat.mean_relative


def test_more_smoothness_is_smoother() -> None:
    wi, wo = pairs(1500)
    values = product(wi, wo) * np.exp(0.3 * np.random.default_rng(3).standard_normal((1500, 1)))
    rough, calm = (factorize(wi, wo, values, resolution=16, smooth=s).product for s in (0.01, 3.0))

    def bend(found) -> float:
        return sum(float(np.square(np.diff(logs, axis=0)).sum()) for logs in found.logs.values())

    assert bend(calm) < 0.5 * bend(rough)


def test_a_weight_draws_the_fit() -> None:
    wi, wo = pairs(3000)
    values = product(wi, wo)
    values[::2] *= 3.0
    heavy = np.where(np.arange(3000) % 2 == 0, 10.0, 0.1)
    found = factorize(wi, wo, values, resolution=8, weights=heavy, keep_mean=False).product.eval(wi, wo)
    assert relative(found[::2], values[::2]) < 0.1 < relative(found[1::2], values[1::2])


@settings(max_examples=settings.default.max_examples // 2)
@given(
    count=st.integers(1, 12),
    seed=st.integers(0, 1000),
    bad=st.sampled_from([None, "zero", "negative", "nan", "inf", "one direction", "huge", "tiny"]),
    solver=st.sampled_from(["direct", "iterative"]),
)
def test_few_and_bad_samples_give_positive_finite_maps_or_a_named_error(count, seed, bad, solver) -> None:
    wi, wo = pairs(count, seed)
    values = product(wi, wo)
    if bad == "zero":
        values[:] = 0.0
    elif bad == "negative":
        values[0] = -1.0
    elif bad == "nan":
        values[0, 1] = np.nan
    elif bad == "inf":
        values[0] = np.inf
    elif bad == "one direction":
        wi[:], wo[:] = wi[0], wo[0]
    elif bad == "huge":
        values *= 1e12
    elif bad == "tiny":
        values *= 1e-12
    try:
        found = factorize(wi, wo, values, resolution=8, solver=solver)
    except FittingError:
        assert bad == "zero" or count == 1
        return
    everywhere = found.product.eval(*pairs(200, seed=seed + 1))
    assert np.isfinite(everywhere).all()
    assert (everywhere > 0.0).all()
    assert (found.product.alpha > 0.0).all()


def test_gaps_take_the_smoothest_answer() -> None:
    wi, wo = pairs(4000)
    keep = (wi[:, 0] < 0.2) | (wi[:, 1] < 0.0)  # a quarter of the lights was not measured
    keep &= (wo[:, 0] < 0.2) | (wo[:, 1] < 0.0)
    found = factorize(wi[keep], wo[keep], product(wi, wo)[keep], resolution=16).product
    missed = ~keep
    assert relative(found.eval(wi[missed], wo[missed]), product(wi, wo)[missed]) < 0.4


@pytest.mark.parametrize(
    ("change", "place"),
    [
        ({"resolution": 1}, "resolution"),
        ({"smooth": -1.0}, "smoothness"),
        ({"smooth": float("nan")}, "smoothness"),
        ({"bias": 0.0}, "bias"),
        ({"factors": "p:somewhere"}, "factors"),
        ({"factors": ""}, "factors"),
        ({"factors": "p:wi p:w.h"}, "factors"),
        ({"weights": np.full(10, -1.0)}, "weights"),
    ],
)
def test_wrong_settings_are_named(change: dict, place: str) -> None:
    wi, wo = pairs(10)
    with pytest.raises(ValueRangeError) as caught:
        factorize(wi, wo, product(wi, wo), **change)
    assert caught.value.place == place


def test_the_peak_apart_comes_nearer_than_a_product_alone() -> None:
    samples = sample_reflectance(Shiny(), 8_000)
    whole = factorize(samples.wi, samples.wo, samples.values, resolution=16).product
    apart, _ = factorize_with_peak(samples, resolution=16)
    errors = [accuracy(samples.values, one.eval(samples.wi, samples.wo)) for one in (whole, apart)]
    assert errors[1].snr_db > errors[0].snr_db + 1.0
    assert apart.peak is not None
    assert apart.reciprocal


def test_more_terms_of_the_expansion_come_nearer_on_its_grid() -> None:
    reflectance = Shiny()
    whole = separate(reflectance, 8, half_size=12, difference_size=8)
    samples = sample_reflectance(reflectance, 3000)
    found = [
        accuracy(samples.values, whole.first(terms).eval(samples.wi, samples.wo)).rms for terms in (1, 3, 8)
    ]
    assert found[0] > found[1] > found[2]
    assert (whole.eval(*pairs(2000)) < 0.0).any() or (whole.u < 0.0).any()  # signed, unlike the product


def test_textures_cost_what_their_bits_cost() -> None:
    wi, wo = pairs(6000)
    found = factorize(wi, wo, product(wi, wo), resolution=16).product
    truth = found.eval(wi, wo)
    errors = {
        (store, log): relative(quantize_maps(found, store, logarithmic=log).product.eval(wi, wo), truth)
        for store in ("8-bit", "half", "float")
        for log in (False, True)
    }
    assert errors["float", False] < 1e-6 < errors["half", False] < 1e-3 < errors["8-bit", False]
    # Of a factor of wide range the dark texels keep few of eight bits; its logarithm keeps them all.
    assert errors["8-bit", True] < errors["8-bit", False]
    assert compression(found, 6000) == pytest.approx(6000 / (2 * 16 * 16))
    assert quantize_maps(found, "half").texture_bytes == 2 * 3 * 2 * 16 * 16


def test_measured_samples_are_taken_and_turned() -> None:
    from brdf_suite.reflectance.tabulated.half_angle_grid import HalfAngleGrid
    from brdf_suite.reflectance.tabulated.isotropic import IsotropicTable

    table = IsotropicTable.from_reflectance(CookTorrance(TABLE_1["table1_blue"]), HalfAngleGrid(12, 8, 12))
    samples = sample_reflectance(table)
    assert len(samples) == int(table.measured_mask().sum())
    np.testing.assert_allclose(table.eval(samples.wi, samples.wo), samples.values, rtol=1e-4, atol=1e-6)
    around = np.arctan2(samples.wi[:, 1], samples.wi[:, 0])
    assert np.histogram(around, 8, (-np.pi, np.pi))[0].min() > 0.06 * len(samples)
    fit, held = samples.held_out(0.2)
    assert len(fit) + len(held) == len(samples)
    assert isinstance(fit, FactorizationSamples)
