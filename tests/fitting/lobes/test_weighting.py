from __future__ import annotations

import numpy as np
import pytest

from brdf_suite.errors import FittingError
from brdf_suite.fitting import LobeFitter
from brdf_suite.fitting.lobes.program import relative_factors, ring_solid_angles
from brdf_suite.fitting.lobes.samples import BaseSamples


def test_relative_weights_are_one_over_the_target_and_bounded() -> None:
    target = np.array([[2.0, 0.0], [1.0, 0.0], [0.5, 0.0], [0.01, 0.0], [0.0, 0.0]])
    factors = relative_factors(target)
    np.testing.assert_allclose(factors[:, 0], [1.0, 2.0, 4.0, 20.0, 20.0])
    np.testing.assert_allclose(factors[:, 1], 1.0)


def test_solid_angles_fill_the_sphere_around_the_mirror_direction() -> None:
    gamma = np.linspace(-np.pi, np.pi, 721)
    assert ring_solid_angles(gamma)[1:-1].sum() == pytest.approx(4 * np.pi, rel=1e-3)
    # Far from the mirror direction a half ring is as wide as its sine.
    wide = ring_solid_angles(np.array([0.4, 0.5, 0.6]))[1]
    assert wide == pytest.approx(np.pi * np.sin(0.5) * 0.1, rel=1e-3)
    assert (ring_solid_angles(BaseSamples().gamma_rad) > 0.0).all()
    assert ring_solid_angles(np.array([0.3])) == 1.0


def targets(fitter: LobeFitter) -> tuple[np.ndarray, np.ndarray]:
    gamma = fitter.base_samples.gamma_rad
    # A curve that no sum of lobes follows, so that something must give.
    base = 0.01 + 0.5 * np.clip(np.cos(gamma), 0, None)[:, None] ** np.array([5.0, 6.0, 7.0])
    base *= np.exp(np.random.default_rng(4).normal(0.0, 0.5, base.shape))
    coat = 300.0 * np.exp(-np.outer(fitter.coat_samples.gamma_rad**2, np.full(3, 9_000.0)))
    return base, coat


@pytest.mark.parametrize("weighting", ["absolute", "relative", "solid angle"])
def test_each_weighting_is_best_by_its_own_measure_and_keeps_the_energy(weighting: str) -> None:
    fitters = {
        name: LobeFitter(time_limit_s=5.0, weighting=name)  # type: ignore[arg-type]  # parametrized by name
        for name in ("absolute", "relative", "solid angle")
    }
    base, coat = targets(fitters["absolute"])
    fits = {name: fitter.fit_samples(base, coat, ior=1.5) for name, fitter in fitters.items()}
    samples = fitters["absolute"].base_samples
    weights = {
        "absolute": samples.weights[:, None],
        "relative": samples.weights[:, None] * relative_factors(base),
        "solid angle": ring_solid_angles(samples.gamma_rad)[:, None],
    }[weighting]
    lobes = samples.cosine_lobes(fitters["absolute"].basis.array())

    def error(name: str) -> np.ndarray:
        fitted = np.cos(samples.theta_rad) * (fits[name].weights.kd + lobes @ fits[name].weights.kdd)
        return (weights * np.abs(fitted - base)).sum(axis=0)

    own = error(weighting)
    np.testing.assert_allclose(own, fits[weighting].base_error.absolute, rtol=1e-6)
    np.testing.assert_allclose(
        own / (weights * base).sum(axis=0), fits[weighting].base_error.relative, rtol=1e-6
    )
    for name in fitters:
        assert (own <= error(name) * (1 + 1e-7)).all()
    wanted = fitters[weighting].coat_samples.solid_angle @ coat
    # The part of wide lobes below the horizon is the difference.
    np.testing.assert_allclose(fits[weighting].weights.coat_energy(), wanted, rtol=5e-3)


def test_the_weightings_differ() -> None:
    base, coat = targets(LobeFitter(time_limit_s=5.0))
    found = [
        LobeFitter(time_limit_s=5.0, weighting=name).fit_samples(base, coat, ior=1.5).weights.kdd
        for name in ("absolute", "relative", "solid angle")
    ]
    assert not np.allclose(found[0], found[1], rtol=1e-3)
    assert not np.allclose(found[0], found[2], rtol=1e-3)


def test_relative_weights_follow_the_target() -> None:
    """A kept model must not keep the weights of the paint before."""
    kept = LobeFitter(time_limit_s=5.0, weighting="relative")
    base, coat = targets(kept)
    kept.fit_samples(base[::-1].copy(), coat, ior=1.5)
    fresh = LobeFitter(time_limit_s=5.0, weighting="relative").fit_samples(base, coat, ior=1.5)
    again = kept.fit_samples(base, coat, ior=1.5)
    np.testing.assert_allclose(again.base_error.absolute, fresh.base_error.absolute, rtol=1e-7)


def test_an_unknown_weighting_is_named() -> None:
    with pytest.raises(FittingError, match=r"'heavy'.*'relative'"):
        LobeFitter(weighting="heavy")  # type: ignore[arg-type]  # what a caller without types may write
