"""Scattered samples: met where they lie, smooth between them, in whatever order the pair is given."""

from __future__ import annotations

import numpy as np
import pytest

from brdf_suite.errors import ValueRangeError
from brdf_suite.geometry.directions import spherical
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples

Pair = tuple[np.ndarray, np.ndarray]


def turned(w: np.ndarray, by: float) -> np.ndarray:
    c, s = np.cos(by), np.sin(by)
    return w @ np.array([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]])


def colours(wi: np.ndarray, wo: np.ndarray) -> np.ndarray:
    """A reciprocal, isotropic, mirror-symmetric formula."""
    both = wi[..., 2] * wo[..., 2]
    apart = 1.0 + np.einsum("...i,...i", wi, wo)
    return np.stack((0.2 + both, 0.1 * apart, 0.3 + 0.2 * both * apart), axis=-1)


@pytest.mark.parametrize("isotropic", [True, False])
def test_each_sample_is_met(directions: Pair, isotropic: bool) -> None:
    wi, wo = (w[:500] for w in directions)
    samples = ScatteredSamples(wi, wo, colours(wi, wo), isotropic=isotropic)
    assert np.allclose(samples.eval(wi, wo), colours(wi, wo), rtol=1e-6)
    assert np.allclose(samples.eval(wo, wi), colours(wi, wo), rtol=1e-6)


def test_isotropic_samples_do_not_mind_a_turn_or_a_mirror(directions: Pair) -> None:
    wi, wo = (w[:300] for w in directions)
    samples = ScatteredSamples(wi, wo, colours(wi, wo))
    assert np.allclose(samples.eval(turned(wi, 1.1), turned(wo, 1.1)), samples.values, rtol=1e-5)
    flip = np.array([1.0, -1.0, 1.0])
    assert np.allclose(samples.eval(wi * flip, wo * flip), samples.values, rtol=1e-5)


def test_anisotropic_samples_do(directions: Pair) -> None:
    wi, wo = (w[:3000] for w in directions)
    value = np.repeat((1.0 + 0.5 * (wi + wo)[:, :1]), 3, axis=1)
    samples = ScatteredSamples(wi, wo, value, isotropic=False)
    ahead, across = spherical(0.6, 0.0), spherical(0.6, np.pi / 2)
    want = 1.0 + 0.5 * 2.0 * np.sin(0.6)
    assert samples.eval(ahead, ahead)[0] == pytest.approx(want, rel=0.06)
    assert samples.eval(across, across)[0] == pytest.approx(1.0, rel=0.06)


def test_between_samples_it_is_near(directions: Pair) -> None:
    wi, wo = directions
    samples = ScatteredSamples(wi[:3000], wo[:3000], colours(wi[:3000], wo[:3000]))
    error = samples.eval(wi[3000:], wo[3000:]) / colours(wi[3000:], wo[3000:]) - 1.0
    assert np.sqrt(np.mean(error**2)) < 0.03
    low, high = samples.values.min(axis=0), samples.values.max(axis=0)
    between = samples.eval(wi[3000:], wo[3000:])
    assert np.all((between >= low - 1e-9) & (between <= high + 1e-9))


def test_the_weights_are_those_of_franke_and_nielson() -> None:
    """Three samples of ten at hand-placed distances along θd; the ninth nearest bounds the weights."""
    theta = np.radians([10.0, 11.0, 12.0, 13.0, 14.0, 15.0, 16.0, 17.0, 18.0, 19.0])
    wi, wo = spherical(theta, 0.0), spherical(theta, np.pi)  # h = z, θd = θ
    value = np.arange(10.0) + 1.0
    samples = ScatteredSamples(wi, wo, np.repeat(value[:, None], 3, axis=1))
    at = np.radians(12.3)
    far = np.abs(np.degrees(theta) - 12.3)
    order = np.argsort(far)
    reach = far[order[8]]
    weight = ((reach - far[order[:8]]) / far[order[:8]]) ** 2
    want = (weight * value[order[:8]]).sum() / weight.sum()
    assert samples.eval(spherical(at, 0.0), spherical(at, np.pi))[0] == pytest.approx(want, rel=1e-5)


def test_samples_measured_twice_give_their_mean() -> None:
    wi, wo = spherical(np.full(4, 0.5), 0.0), spherical(np.full(4, 0.2), np.pi)
    value = np.repeat(np.array([1.0, 2.0, 3.0, 6.0])[:, None], 3, axis=1)
    assert ScatteredSamples(wi, wo, value).eval(wi[0], wo[0])[0] == pytest.approx(3.0)


def test_a_single_sample_holds_everywhere_above_the_horizon() -> None:
    samples = ScatteredSamples(spherical([0.1], 0.0), spherical([0.2], 0.0), np.array([[0.1, 0.2, 0.3]]))
    assert samples.eval(spherical(1.0, 2.0), spherical(0.4, 1.0)) == pytest.approx([0.1, 0.2, 0.3])
    assert np.array_equal(samples.eval(spherical(2.0, 2.0), spherical(0.4, 1.0)), np.zeros(3))


def test_spectra_are_looked_up_as_the_colours_are(directions: Pair) -> None:
    wi, wo = (w[:400] for w in directions)
    bands = np.linspace(400.0, 700.0, 31)
    spectra = colours(wi, wo)[:, :1] * np.linspace(0.5, 1.0, 31)
    samples = ScatteredSamples(wi, wo, colours(wi, wo), spectra, bands)
    seen = samples.eval_spectra(wi[:20, None], wo[None, :20])
    assert seen.shape == (20, 20, 31)
    assert np.allclose(seen[3, 3], spectra[3], rtol=1e-6)
    assert np.allclose(seen[..., 30], samples.eval(wi[:20, None], wo[None, :20])[..., 0])


@pytest.mark.parametrize(
    ("change", "place"),
    [
        ({"wi": np.zeros((2, 3))}, r"wi\[0\]"),
        ({"wi": -spherical([0.1, 0.2], 0.0)}, r"wi\[0\]"),
        ({"wo": spherical([0.1], 0.0)}, "wo"),
        ({"wi": np.empty((0, 3))}, "wi"),
        ({"values": np.ones((2, 4))}, "values"),
        ({"values": np.array([[0.0, 0.0, -1.0], [0.0, 0.0, 0.0]])}, r"values\[0, 2\]"),
        ({"values": np.full((2, 3), np.nan)}, "values"),
        ({"spectra": np.ones((2, 3))}, "spectra"),
        ({"spectra": np.ones((2, 3)), "wavelengths_nm": [500.0, 400.0, 600.0]}, "wavelengths_nm"),
        ({"spectra": np.ones((2, 2)), "wavelengths_nm": [400.0, 500.0, 600.0]}, "spectra"),
    ],
)
def test_what_is_no_sample_is_refused_by_name(change: dict[str, object], place: str) -> None:
    sound = {"wi": spherical([0.1, 0.2], 0.0), "wo": spherical([0.3, 0.2], 1.0), "values": np.ones((2, 3))}
    with pytest.raises(ValueRangeError, match=place):
        ScatteredSamples(**{**sound, **change})


def test_asking_for_spectra_that_are_not_there_is_reported() -> None:
    samples = ScatteredSamples(spherical([0.1], 0.0), spherical([0.2], 0.0), np.ones((1, 3)))
    with pytest.raises(ValueRangeError, match="no spectra"):
        samples.eval_spectra(spherical(0.1, 0.0), spherical(0.1, 0.0))


FLIP = np.array([1.0, -1.0, 1.0])


@pytest.mark.parametrize("isotropic", [True, False])
def test_the_distance_to_a_sample_is_0_where_it_counts(directions: Pair, isotropic: bool) -> None:
    wi, wo = (w[:40] for w in directions)
    samples = ScatteredSamples(wi, wo, colours(wi, wo), isotropic=isotropic)
    for pair in ((wi, wo), (wo, wi)):
        np.testing.assert_allclose(samples.nearest_sample_deg(*pair), 0.0, atol=1e-5)
    for pair in ((turned(wi, 1.1), turned(wo, 1.1)), (wi * FLIP, wo * FLIP)):
        assert bool(samples.nearest_sample_deg(*pair).max() < 1e-5) is isotropic


def test_the_distance_is_the_angle_of_the_direction_that_moves() -> None:
    wi, wo = spherical([0.6], 0.0), spherical([0.6], np.pi)
    for isotropic in (True, False):
        samples = ScatteredSamples(wi, wo, np.ones((1, 3)), isotropic=isotropic)
        # In the plane of incidence no turn about the normal brings the pair nearer.
        moved = samples.nearest_sample_deg(wi[0], spherical(0.6 + np.radians([1.0, 7.0, 20.0]), np.pi))
        np.testing.assert_allclose(moved, [1.0, 7.0, 20.0], rtol=1e-9)


def test_the_distance_is_the_least_over_all_turns(directions: Pair) -> None:
    wi, wo = (w[:6] for w in directions)
    samples = ScatteredSamples(wi, wo, np.ones((6, 3)))
    turns = np.radians(np.arange(0.0, 360.0, 0.25))
    for i, o in zip(*(w[100:110] for w in directions), strict=True):
        least = min(
            np.linalg.norm(turned(a * flip, by) - i) ** 2 + np.linalg.norm(turned(b * flip, by) - o) ** 2
            for one, two in ((wi, wo), (wo, wi))
            for a, b in zip(one, two, strict=True)
            for flip in (1.0, FLIP)
            for by in turns
        )
        chord = 2.0 * np.degrees(np.arcsin(min(1.0, 0.5 * np.sqrt(least))))
        assert samples.nearest_sample_deg(i, o) == pytest.approx(chord, abs=0.02)
