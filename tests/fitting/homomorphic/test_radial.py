"""Round maps are found and kept as their radius; the words of factors; the mean is restored."""

from __future__ import annotations

import numpy as np
import pytest

from brdf_suite.errors import ValueRangeError
from brdf_suite.fitting.homomorphic.factorization import Factorization, as_radial, asymmetries
from brdf_suite.fitting.homomorphic.product_fit import correct_mean
from brdf_suite.fitting.homomorphic.samples import even_directions
from brdf_suite.fitting.homomorphic.solve import MapLayout
from brdf_suite.geometry.factor_words import DEFAULT_FACTORS, MEASURED_FACTORS, factor_words, parse_factors
from brdf_suite.geometry.parabolic import parabolic_place, texel_directions


def product(size: int = 32) -> Factorization:
    """A round p and a q that is brushed along x."""
    s, t = parabolic_place(texel_directions(size))
    p = np.repeat((-1.5 * (s * s + t * t))[..., None], 3, axis=2)
    q = np.stack([-2.0 * s * s, -2.0 * s * s - 0.5 * t * t, -3.0 * s * s], axis=2)
    return Factorization(parse_factors(DEFAULT_FACTORS), {"p": p, "q": q}, np.array([0.5, 0.4, 0.3]))


def pairs(count: int = 2000) -> tuple[np.ndarray, np.ndarray]:
    rng = np.random.default_rng(3)
    return even_directions(count, rng), even_directions(count, rng)


def test_round_maps_are_reported_from_others_and_kept_as_their_radius() -> None:
    whole = product()
    found = asymmetries(whole)
    assert found["p"] < 0.01
    assert found["q"] > 0.2
    radial = as_radial(whole)
    assert factor_words(radial.factors) == "p:|wo| q:h p:|wi|"
    assert radial.logs["p"].shape == (32, 3)
    assert radial.logs["q"] is whole.logs["q"]
    np.testing.assert_allclose(radial.eval(*pairs()), whole.eval(*pairs()), rtol=0.08)
    # As coarse as it likes: nothing is taken for round that is not.
    assert factor_words(as_radial(whole, tolerance=0.0).factors) == DEFAULT_FACTORS
    assert radial.numbers < whole.numbers


def test_the_words_give_a_map_its_own_texels_and_come_back() -> None:
    factors = parse_factors("p:|wo| q:sqrt|h|@64 p:|wi|@8 d:w.h")
    assert [factor.size for factor in factors] == [8, 64, 8, None]
    assert MapLayout.of(factors, 16).shapes == {"p": (8,), "q": (64,), "d": (16,)}
    assert factor_words(factors, sizes=True) == "p:|wo|@8 q:sqrt|h|@64 p:|wi|@8 d:w.h"
    assert parse_factors(factor_words(factors, sizes=True)) == factors
    assert factor_words(parse_factors(MEASURED_FACTORS)) == "p:|wo| q:sqrt|h| p:|wi| d:w.h"


@pytest.mark.parametrize(
    "words", ["p:wi@1", "p:wi@", "p:wi@9999", "p:wi@-3", "p:|wi|@8 p:|wo|@9", "ü:wi", "p"]
)
def test_words_that_say_nothing_are_refused(words: str) -> None:
    with pytest.raises(ValueRangeError) as caught:
        parse_factors(words)
    assert caught.value.place == "factors"


def test_the_mean_is_restored_in_each_channel_and_reported() -> None:
    whole = product()
    wi, wo = pairs()
    values = whole.eval(wi, wo) * np.array([2.0, 1.0, 0.5])
    values[4, 1] = np.nan
    found, times = correct_mean(whole, wi, wo, values)
    np.testing.assert_allclose(times, [2.0, 1.0, 0.5], rtol=1e-9)
    np.testing.assert_allclose(found.alpha, whole.alpha * times)
