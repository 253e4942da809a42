"""Bad input, line by line: the smoothest consistent answer or a named error; every factor positive and finite."""

from __future__ import annotations

import numpy as np
import pytest

from brdf_suite.errors import FittingError
from brdf_suite.fitting.homomorphic.factorization import Factorization
from brdf_suite.fitting.homomorphic.peak import factorize_with_peak
from brdf_suite.fitting.homomorphic.product_fit import factorize
from brdf_suite.fitting.homomorphic.samples import FactorizationSamples, even_directions
from brdf_suite.geometry.factor_words import DEFAULT_FACTORS, MEASURED_FACTORS


def drawn(count: int, seed: int = 1) -> FactorizationSamples:
    """A smooth reflectance, brighter at the mirror direction."""
    rng = np.random.default_rng(seed)
    wi, wo = even_directions(count, rng), even_directions(count, rng)
    values = 0.2 + np.exp(-6.0 * (1.0 - (wi + wo)[:, 2:] / np.linalg.norm(wi + wo, axis=1, keepdims=True)))
    return FactorizationSamples(wi, wo, values * np.array([1.0, 0.6, 0.3]))


def good(product: Factorization) -> bool:
    maps = [np.exp(log) for log in product.logs.values()]
    return all((values > 0.0).all() and np.isfinite(values).all() for values in [*maps, product.alpha])


def roughness(product: Factorization) -> float:
    """The largest step between neighbours of any map."""
    return max(float(np.abs(np.diff(log, axis=0)).max()) for log in product.logs.values())


@pytest.mark.parametrize("factors", [DEFAULT_FACTORS, MEASURED_FACTORS])
@pytest.mark.parametrize("count", [2, 30])
def test_fewer_samples_than_texels_are_met_and_joined_smoothly(factors: str, count: int) -> None:
    samples = drawn(count)
    found = factorize(
        samples.wi, samples.wo, samples.values, factors=factors, resolution=12, smooth=0.01, keep_mean=False
    ).product
    assert good(found)
    np.testing.assert_allclose(found.eval(samples.wi, samples.wo), samples.values, rtol=0.15)
    whole = np.log(samples.values).max() - np.log(samples.values).min()
    assert roughness(found) < whole + 0.1
    anywhere = drawn(300, 2)
    assert found.eval(anywhere.wi, anywhere.wo).max() < 30.0 * samples.values.max()


def test_all_samples_in_one_direction_give_flat_maps_of_that_value() -> None:
    samples = drawn(50)
    same = FactorizationSamples(
        np.tile(samples.wi[:1], (50, 1)), np.tile(samples.wo[:1], (50, 1)), np.full((50, 3), 0.4)
    )
    found = factorize(same.wi, same.wo, same.values, resolution=8).product
    assert good(found)
    assert roughness(found) < 1e-3
    anywhere = drawn(100, 3)
    np.testing.assert_allclose(found.eval(anywhere.wi, anywhere.wo), 0.4, rtol=0.02)


def test_zeros_are_taken_for_as_dark_as_the_bias() -> None:
    samples = drawn(800)
    dark = samples.wi[:, 0] > 0.6
    values = np.where(dark[:, None], 0.0, samples.values)
    found = factorize(samples.wi, samples.wo, values, resolution=8, bias=1e-3, keep_mean=False).product
    assert good(found)
    assert np.median(found.eval(samples.wi[dark], samples.wo[dark])) < 0.05 * np.median(values[~dark])
    with pytest.raises(FittingError, match="Every sample is 0"):
        factorize(samples.wi, samples.wo, np.zeros_like(values))


def test_a_channel_without_light_gets_flat_maps_and_next_to_no_scale() -> None:
    samples = drawn(400)
    values = samples.values * np.array([1.0, 0.0, 1.0])
    found = factorize(samples.wi, samples.wo, values, resolution=8).product
    assert good(found)
    assert found.eval(samples.wi, samples.wo)[:, 1].max() < 1e-3


def test_negatives_are_counted_and_taken_for_zero() -> None:
    samples = drawn(400)
    values = samples.values.copy()
    values[7] = -0.5
    found = factorize(samples.wi, samples.wo, values, resolution=8)
    zeroed = values.copy()
    zeroed[7] = 0.0
    same = factorize(samples.wi, samples.wo, zeroed, resolution=8)
    assert (found.raised, found.left_out) == (1, 0)
    np.testing.assert_array_equal(found.product.logs["p"], same.product.logs["p"])


@pytest.mark.parametrize("place", ["values", "wi", "wo"])
def test_one_nan_is_left_out_and_changes_nothing_else(place: str) -> None:
    samples = drawn(400)
    arrays = {"wi": samples.wi.copy(), "wo": samples.wo.copy(), "values": samples.values.copy()}
    arrays[place][11, 1] = np.nan
    found = factorize(**arrays, resolution=8)
    rest = np.arange(400) != 11
    same = factorize(samples.wi[rest], samples.wo[rest], samples.values[rest], resolution=8)
    assert found.left_out == 1
    np.testing.assert_array_equal(found.product.logs["q"], same.product.logs["q"])


def test_few_samples_that_reflect_among_zeros_are_not_taken_for_nothing() -> None:
    samples = drawn(800)
    values = np.zeros((800, 3))
    values[::15] = 0.3
    whole, _ = factorize_with_peak(
        FactorizationSamples(samples.wi, samples.wo, values), factors=MEASURED_FACTORS
    )
    assert good(whole.product)
    assert whole.eval(samples.wi, samples.wo).max() > 1e-3


def test_a_rise_at_grazing_is_no_peak() -> None:
    rng = np.random.default_rng(4)
    wi, wo = even_directions(3000, rng), even_directions(3000, rng)
    forward = (wi * wo)[:, :2].sum(axis=1) < -0.6
    rise = np.where(forward, 40.0 * np.exp(-wi[:, 2] * wo[:, 2] / 0.01), 0.0)
    values = np.repeat(0.3 * (1.0 + rise)[:, None], 3, axis=1)
    whole, _ = factorize_with_peak(FactorizationSamples(wi, wo, values), factors=MEASURED_FACTORS, smooth=1.0)
    assert values.max() > 5.0 * np.median(values)
    assert whole.peak is None
    # The same light in one direction is a peak.
    near = (wi + wo)[:, 2] > 0.97 * np.linalg.norm(wi + wo, axis=1)
    values = np.where(near[:, None], 30.0, 0.3) * np.ones((1, 3))
    whole, _ = factorize_with_peak(FactorizationSamples(wi, wo, values), factors=MEASURED_FACTORS, smooth=1.0)
    assert whole.peak is not None


@pytest.mark.parametrize("bad", ["few", "one direction", "zeros", "negative", "nan", "nothing"])
def test_the_peak_apart_stands_the_same(bad: str) -> None:
    samples = drawn(3 if bad == "few" else 300)
    wi, wo, values = samples.wi.copy(), samples.wo.copy(), samples.values.copy()
    if bad == "one direction":
        wi[:], wo[:] = wi[0], wo[0]
    elif bad == "zeros":
        values[::2] = 0.0
    elif bad == "negative":
        values[5] = -3.0
    elif bad == "nan":
        values[5, 2] = np.nan
    elif bad == "nothing":
        values[:] = np.nan
    # One sample as bright as a peak, so that there is one to be found.
    values[1] *= 1e4
    if bad == "nothing":
        with pytest.raises(FittingError, match="nothing to factor"):
            factorize_with_peak(FactorizationSamples(wi, wo, values), resolution=8)
        return
    found, reported = factorize_with_peak(
        FactorizationSamples(wi, wo, values), factors=MEASURED_FACTORS, resolution=8
    )
    assert good(found.product)
    assert found.peak is None or good(found.peak)
    assert (reported.left_out, reported.raised) == (int(bad == "nan"), int(bad == "negative"))
    anywhere = drawn(200, 9)
    evaluated = found.eval(anywhere.wi, anywhere.wo)
    assert np.isfinite(evaluated).all()
    assert (evaluated > 0.0).all()
