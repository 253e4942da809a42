from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import wait
from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from brdf_suite.errors import FittingError
from brdf_suite.fitting import LobeBasis
from brdf_suite.fitting.lobes.angles import AngleFit, AngleFitter, AngleGrid, AngleSamples
from brdf_suite.fitting.lobes.angles.program import Rows, joint_program
from brdf_suite.fitting.metrics import aspecular_delta_e
from brdf_suite.geometry.fresnel import fresnel_dielectric
from brdf_suite.pipeline.lobe_fit import PaintFitter
from brdf_suite.pipeline.material import load_document, load_shipped_paint
from brdf_suite.reflectance.designed.build import build_paint, build_reflectance
from brdf_suite.reflectance.designed.layers import depends_on_halfway, split_layers
from brdf_suite.reflectance.designed.paint_reflectance import PaintReflectance


@cache
def paint(name: str) -> PaintReflectance:
    return build_paint(load_shipped_paint(name))


def relative(fit: AngleFit) -> np.ndarray[Any, np.dtype[np.float64]]:
    """Base weights without what Fresnel's transmission does to all of them, (K, 1 + m, 3)."""
    weights = fit.weights
    passed = (1.0 - fresnel_dielectric(weights.cosines, weights.ior)) ** 2
    table = np.concatenate([weights.kd[:, None], weights.kdd], axis=1) / passed[:, None, None]
    return table * (2.0 * np.pi / (np.concatenate([[1.0], weights.exponents]) + 1.0))[:, None]


def there_and_back(table: np.ndarray[Any, np.dtype[np.float64]]) -> float:
    """How much weights rise and fall over the incidence beyond going from their first value to their last."""
    change = np.diff(table, axis=0)
    return float(
        (np.abs(change).sum(axis=0) - np.abs(change.sum(axis=0))).sum() / np.abs(table).sum(axis=1).mean()
    )


@pytest.mark.parametrize("name", ["blue", "fine_silver", "red_metallic", "solid_white"])
def test_true_at_measured_and_at_other_incidences(angle_fitter: AngleFitter, name: str) -> None:
    target = paint(name)
    fit = angle_fitter.fit(target)
    assert not fit.time_limited
    assert fit.exact is None
    assert aspecular_delta_e(target, fit.weights, [15, 45, 110]).max() <= 0.2
    for theta, gammas in (
        (45.0, (-15, 25, 75)),
        (20.0, (-15, 15, 25, 45, 75)),
        (65.0, (-15, 15, 25, 45, 75, 110)),
    ):
        assert aspecular_delta_e(target, fit.weights, gammas, theta).max() <= 2.5


def test_better_than_one_incidence_raised(angle_fitter: AngleFitter) -> None:
    target = paint("fine_silver")
    single = PaintFitter(time_limit_s=60.0).fit(load_shipped_paint("fine_silver")).weights
    several = angle_fitter.fit(target).weights
    for theta in (65.0, 75.0, 80.0):
        gammas = [15.0, 25.0, 45.0, 75.0]
        assert (
            aspecular_delta_e(target, several, gammas, theta).mean()
            < 0.5 * aspecular_delta_e(target, single, gammas, theta).mean()
        )


def test_the_coats_energy_is_kept_at_every_incidence(angle_fitter: AngleFitter) -> None:
    target = paint("blue")
    fit = angle_fitter.fit(target)
    reflected = fresnel_dielectric(fit.weights.cosines, target.ior)
    np.testing.assert_allclose(fit.weights.coat_energy()[:, 0], reflected, rtol=0.01)
    lobes = angle_fitter.coat_samples.lobe_energy(fit.weights.exponents)
    rings = angle_fitter.sample(target).rings
    wanted = np.einsum("knc,kn->kc", rings, angle_fitter.coat_samples.solid_angle)
    np.testing.assert_allclose(np.einsum("km,kmc->kc", lobes, fit.weights.kg), wanted, rtol=1e-6)


def test_an_edit_is_the_same_as_a_fresh_fit(angle_fitter: AngleFitter) -> None:
    angle_fitter.fit(paint("blue"))
    kept = angle_fitter.fit(paint("copper"))
    fresh = AngleFitter(time_limit_s=20.0).fit(paint("copper"))
    np.testing.assert_allclose(kept.base_error.absolute, fresh.base_error.absolute, rtol=1e-6, atol=1e-9)
    gammas = [-15, 15, 25, 45, 75, 110]
    assert aspecular_delta_e(fresh.weights, kept.weights, gammas, 60.0).max() < 0.2


def test_linear_in_its_target(angle_fitter: AngleFitter) -> None:
    samples = angle_fitter.sample(paint("red"))
    one = angle_fitter.fit_samples(samples)
    other = angle_fitter.fit_samples(
        replace(samples, base=1e-5 * samples.base, coat=1e-5 * samples.coat, rings=1e-5 * samples.rings)
    )
    np.testing.assert_allclose(other.base_error.relative, one.base_error.relative, rtol=1e-6)
    np.testing.assert_allclose(other.weights.coat_energy(), 1e-5 * one.weights.coat_energy(), rtol=1e-6)


def test_smoothness_calms_the_lobes_over_the_angles() -> None:
    target = paint("gold_metallic")
    rough = AngleFitter(smoothness=0.0, time_limit_s=20.0).fit(target)
    smooth = AngleFitter(time_limit_s=20.0).fit(target)
    assert there_and_back(relative(smooth)) < 0.5 * there_and_back(relative(rough))
    for fit in (rough, smooth):
        assert aspecular_delta_e(target, fit.weights, [15, 45, 110]).max() <= 0.2


def test_the_gloss_of_a_satin_coat_is_calmer_than_at_each_angle_for_itself(angle_fitter: AngleFitter) -> None:
    """Its lobes change places as the highlight widens towards grazing: half of that is none of the paint's doing."""

    def gloss(fitter: AngleFitter) -> float:
        weights = fitter.fit(paint("satin_white")).weights
        holds = 2.0 * np.pi / (weights.exponents + 1.0)
        return there_and_back(weights.kg * holds[:, None] / weights.coat_energy()[:, None])

    calm = gloss(angle_fitter)
    rough = AngleFitter(smoothness=0.0, time_limit_s=20.0)
    assert calm < 0.6 * gloss(rough)
    rough.close()


@given(step=st.floats(0.0, 1.0), channel=st.integers(0, 2))
@settings(max_examples=settings.default.max_examples // 6)
def test_no_lobe_flickers_over_the_angles_along_a_drag(
    angle_fitter: AngleFitter, step: float, channel: int
) -> None:
    samples = angle_fitter.sample(paint("blue"))
    bright = samples.base.copy()
    bright[:, channel] *= 1.0 + 3.0 * step
    fit = angle_fitter.fit_samples(replace(samples, base=bright))
    assert there_and_back(relative(fit)) < 0.15


def test_a_small_edit_is_a_small_change_of_the_look(angle_fitter: AngleFitter) -> None:
    samples = angle_fitter.sample(paint("blue"))
    last = None
    for step in range(12):
        fit = angle_fitter.fit_samples(replace(samples, base=samples.base * (1.0 + 0.01 * step)))
        if last is not None:
            for theta in (20.0, 45.0, 65.0):
                change = aspecular_delta_e(last.weights, fit.weights, [15.0, 25.0, 45.0, 75.0], theta)
                assert change.max() < 0.6
        last = fit


@given(st.integers(0, 2**32 - 1))
@settings(max_examples=settings.default.max_examples // 6)
def test_weights_are_never_negative_nor_nan(angle_fitter: AngleFitter, seed: int) -> None:
    rng = np.random.default_rng(seed)
    flat = (angle_fitter.base_samples.gamma_rad.size, 3)
    around = (*angle_fitter.coat_samples.gamma_rad.shape, 3)
    samples = AngleSamples(
        rng.lognormal(0.0, 3.0, flat), rng.lognormal(0.0, 3.0, flat), rng.lognormal(0.0, 3.0, around), 1.5
    )
    fit = angle_fitter.fit_samples(samples)
    for table in (fit.weights.kd, fit.weights.kdd, fit.weights.kg):
        assert np.isfinite(table).all()
        assert (table >= 0.0).all()


def test_a_coloured_coat_and_a_grey_one_agree(angle_fitter: AngleFitter) -> None:
    samples = angle_fitter.sample(paint("blue"))
    grey = angle_fitter.fit_samples(samples)
    tinted = angle_fitter.fit_samples(replace(samples, rings=samples.rings * np.array([1.0, 0.5, 0.25])))
    np.testing.assert_allclose(
        tinted.weights.coat_energy(), grey.weights.coat_energy() * np.array([1.0, 0.5, 0.25]), rtol=1e-6
    )


def test_zeros_and_one_zero_channel(angle_fitter: AngleFitter) -> None:
    samples = angle_fitter.sample(paint("blue"))
    nothing = 0.0 * samples.base
    black = angle_fitter.fit_samples(replace(samples, base=nothing, coat=nothing, rings=0.0 * samples.rings))
    assert not black.weights.kd.any()
    assert not black.weights.kdd.any()
    assert not black.weights.kg.any()
    no_green = samples.base * np.array([1.0, 0.0, 1.0])
    fit = angle_fitter.fit_samples(replace(samples, base=no_green, coat=nothing))
    assert not fit.weights.kdd[..., 1].any()
    assert fit.weights.kdd[..., 0].any()


def test_no_coat_and_no_transmission_to_divide_by(angle_fitter: AngleFitter) -> None:
    samples = angle_fitter.sample(paint("blue"))
    fit = angle_fitter.fit_samples(
        replace(samples, rings=0.0 * samples.rings, ior=1.0, base_under_coat=False)
    )
    assert not fit.weights.kg.any()
    assert not fit.weights.base_under_coat


def test_more_lobes_than_samples(angle_fitter: AngleFitter) -> None:
    fitter = AngleFitter(LobeBasis(tuple(1.5**k for k in range(26))), AngleGrid(4), time_limit_s=20.0)
    fit = fitter.fit(paint("blue"))
    assert (fit.weights.kdd >= 0.0).all()
    assert aspecular_delta_e(paint("blue"), fit.weights, [15, 45, 110]).max() <= 0.2


def test_bad_samples_are_named(angle_fitter: AngleFitter) -> None:
    samples = angle_fitter.sample(paint("blue"))
    broken = samples.base.copy()
    broken[3, 1] = np.nan
    with pytest.raises(
        FittingError, match=r"base cannot be fitted: its green channel is not finite .* under light at"
    ):
        angle_fitter.fit_samples(replace(samples, base=broken))
    broken = samples.rings.copy()
    broken[2, 5, 2] = -0.5
    with pytest.raises(FittingError, match=r"coat .* blue channel is negative"):
        angle_fitter.fit_samples(replace(samples, rings=broken))
    broken = samples.coat.copy()
    broken[0, 0] = np.inf
    with pytest.raises(FittingError, match=r"coat .* red channel is not finite"):
        angle_fitter.fit_samples(replace(samples, coat=broken))
    broken = samples.rings.copy()
    broken[1, 2, 0] = 1e305  # sums of such overflow
    with pytest.raises(
        FittingError, match=r"coat .* red channel is beyond any reflectance .* under light at"
    ):
        angle_fitter.fit_samples(replace(samples, rings=broken))
    with pytest.raises(FittingError, match="samples of shape"):
        angle_fitter.fit_samples(replace(samples, base=samples.base[1:]))
    for ior in (0.5, np.nan):
        with pytest.raises(FittingError, match="refractive index"):
            angle_fitter.fit_samples(replace(samples, ior=ior))


@pytest.mark.parametrize("name", ["matte_grey", "satin_white", "matte_white"])
def test_the_base_shows_what_round_lobes_lack_of_a_matte_coat_in_the_plane(
    angle_fitter: AngleFitter, name: str
) -> None:
    target = paint(name)
    fit = angle_fitter.fit(target)
    assert aspecular_delta_e(target, fit.weights, [15, 45, 110]).max() <= 0.2


@pytest.mark.parametrize(
    ("settings_", "words"),
    [
        ({"time_limit_s": 0.0}, "time limit"),
        ({"smoothness": -1.0}, "smoothness"),
        ({"base_gammas_deg": (15.0,)}, "together"),
    ],
)
def test_settings_out_of_range(settings_: dict[str, Any], words: str) -> None:
    with pytest.raises(FittingError, match=words):
        AngleFitter(**settings_)


def test_a_limit_that_nothing_can_meet_gives_the_best_at_hand_and_the_optimum_later() -> None:
    target = paint("violet_shift")
    fitter = AngleFitter(time_limit_s=1e-5)
    other = AngleFitter(time_limit_s=20.0)
    fit = fitter.fit(target)
    assert fit.time_limited
    assert fit.weights.time_limited
    assert np.isfinite(fit.weights.kg).all()
    assert fit.exact is not None
    exact = fit.exact.result(timeout=120.0)
    best = other.fit(target)
    assert not exact.time_limited
    np.testing.assert_allclose(exact.base_error.absolute, best.base_error.absolute, rtol=1e-5, atol=1e-8)
    fitter.close()


def test_a_base_that_met_the_limit_is_finished_with_its_coat(monkeypatch: pytest.MonkeyPatch) -> None:
    target = paint("violet_shift")
    fitter = AngleFitter(time_limit_s=20.0)
    solve = fitter.base_solver.solve
    monkeypatch.setattr(
        fitter.base_solver, "solve", lambda targets, deadline, **kept: solve(targets, 0.0, **kept)
    )
    fit = fitter.fit(target)
    assert fit.time_limited
    assert set(fit.coat_error.method) == {"optimum"}
    assert "optimum" not in fit.base_error.method
    assert fit.exact is not None
    exact = fit.exact.result(timeout=120.0)
    assert not exact.time_limited
    np.testing.assert_array_equal(exact.weights.kg, fit.weights.kg)
    assert (exact.base_error.absolute <= fit.base_error.absolute + 1e-9).all()
    fitter.close()


def test_a_newer_fit_cancels_the_older_ones_exact_answer() -> None:
    fitter = AngleFitter(time_limit_s=1e-5)
    first = fitter.fit(paint("blue"))
    second = fitter.fit(paint("copper"))
    assert second.exact is not None
    second.exact.result(timeout=120.0)
    assert first.exact is not None
    assert not wait([first.exact], timeout=120.0).not_done
    fitter.close()


def test_a_paint_without_transmission_is_flat_over_its_angles(
    angle_fitter: AngleFitter, make_paint: Callable[..., Any]
) -> None:
    target = make_paint()
    bare = replace(target, ior=1.0)
    weights = angle_fitter.fit(bare).weights
    assert np.ptp(weights.kdd, axis=0).max() < 0.02 * weights.kdd.max()


@pytest.mark.parametrize("name", ["table1_blue", "table1_polaris_silver"])
def test_wide_facet_lobes_are_true_on_both_sides_of_the_mirror(name: str) -> None:
    model = build_reflectance(load_document(name))
    layers = split_layers(model)
    assert layers is not None
    facets = AngleFitter(halfway=True, time_limit_s=20.0).fit(layers).weights
    plain = AngleFitter(time_limit_s=20.0).fit(layers).weights
    for theta in (45.0, 65.0):
        beyond = aspecular_delta_e(model, facets, [-15.0], theta)
        assert beyond.max() < 0.5 * aspecular_delta_e(model, plain, [-15.0], theta).max()
        assert aspecular_delta_e(model, facets, [15.0, 25.0, 45.0], theta).max() < 5.0


@pytest.mark.parametrize("name", ["gold_green_shift", "magenta_gold_shift"])
def test_a_paint_read_under_two_lights_is_met_where_it_was_read_and_elsewhere(name: str) -> None:
    layers = paint(name)
    assert depends_on_halfway(layers)
    weights = AngleFitter(halfway=True, time_limit_s=20.0).fit(layers).weights
    assert aspecular_delta_e(layers, weights, [15.0, 45.0, 110.0]).max() < 0.1
    for theta in (20.0, 65.0):
        assert aspecular_delta_e(layers, weights, [-15.0, 15.0, 25.0, 45.0, 75.0], theta).max() < 4.0


@pytest.mark.parametrize("name", ["matte_grey", "satin_blue"])
def test_rough_coats_are_met_on_both_sides_of_the_mirror_direction(name: str) -> None:
    """With round lobes, matte grey misses by 33 with the light at 65° and the view beyond the mirror direction."""
    layers = paint(name)
    weights = AngleFitter(time_limit_s=20.0).fit(layers).weights
    for theta in (20.0, 45.0, 65.0):
        assert aspecular_delta_e(layers, weights, [-15.0, 15.0, 25.0, 45.0], theta).max() < 3.0


def test_lobes_that_no_sample_of_an_incidence_sees_do_not_overflow() -> None:
    # At 15°, the nearest sample at 88°, cos^E of these is between 0 and the smallest normal number.
    fitter = AngleFitter(LobeBasis((2.0, 8.0, 20_450.0, 21_000.0)), AngleGrid(6), time_limit_s=20.0)
    assert np.isfinite(fitter.fit(paint("blue")).weights.kdd).all()


def test_systems_that_are_no_systems_are_refused() -> None:
    grid = AngleGrid(3)
    angle = np.repeat(np.arange(3), 2)
    good = Rows(np.ones((6, 2)), np.ones(6), angle, np.zeros(6))
    bad = good._replace(matrix=-good.matrix)
    with pytest.raises(FittingError, match="one incidence"):
        joint_program(bad, grid, 0.1)
    assert joint_program(good, grid, 0.1).shape == (10, 6)
    between = good._replace(share=np.array([0.0, 0.25, 0.0, 0.0, 0.0, 0.0]))
    row = joint_program(between, grid, 0.0).matrix[1].reshape(3, 2)
    np.testing.assert_allclose(row[1], row[0] / 3.0)
    assert not row[2].any()
