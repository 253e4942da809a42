"""GLSL functions against their twins in numpy, on grids."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from brdf_suite.appearance.colour.colorimetry import REC709_TO_WORKING, WORKING_TO_SRGB
from brdf_suite.errors import ValueRangeError
from brdf_suite.geometry.fresnel import fresnel_dielectric
from brdf_suite.realtime.pictures import tone_curves as tc


def colours():
    levels = np.array([0.0, 0.003, 0.02, 0.05, 0.081, 0.18, 0.5, 0.76, 0.81, 1.0, 3.0, 40.0])
    grid = np.stack(np.meshgrid(levels, levels, levels), -1).reshape(-1, 3)
    return np.concatenate([grid, np.ones((len(grid), 1))], 1)


@pytest.mark.parametrize("kind", list(tc.TONE_CURVE_NUMBERS))
def test_tone_curves(evaluate, kind):
    x = colours()
    number = tc.TONE_CURVE_NUMBERS[kind]
    got = evaluate("tone_curve.glsl", f"vec4(tone_curve(x.rgb, {number}), 1.0)", x)
    # AgX's log2 and its power 2.2 cost a software renderer a digit more.
    rtol, atol = (2e-4, 2e-5) if kind == "agx" else (2e-5, 2e-6)
    np.testing.assert_allclose(got[:, :3], tc.tone_curve(x[:, :3], kind), rtol=rtol, atol=atol)


def test_infinite_radiance_is_white_not_nan(evaluate):
    x = np.array([[np.inf, np.inf, np.inf, 1.0]])
    for kind, number in tc.TONE_CURVE_NUMBERS.items():
        got = evaluate("tone_curve.glsl", f"vec4(tone_curve(x.rgb, {number}), 1.0)", x)
        assert np.isfinite(got).all()
        assert got[0, 0] > 0.99, kind


def test_srgb(evaluate):
    x = np.tile(np.linspace(0, 1, 501)[:, None], 4)
    got = evaluate("transfer.glsl", "vec4(srgb_encode(x.rgb), 1.0)", x)
    np.testing.assert_allclose(got[:, 0], tc.srgb_encode(x[:, 0]), atol=2e-6)


def test_dither_is_unbiased_and_at_most_half_a_step(evaluate):
    values = np.linspace(0.02, 0.98, 4000)
    got = evaluate(
        "transfer.glsl", "vec4(quantize(x.rgb, vec2(gl_FragCoord.x, 7.0)), 1.0)", np.tile(values[:, None], 4)
    )
    codes = got[:, 0] * 255
    assert np.abs(codes - np.rint(codes)).max() < 1e-3
    error = codes - values * 255
    assert np.abs(error).max() <= 1.001
    assert abs(error.mean()) < 0.02
    whole = evaluate(
        "transfer.glsl", "vec4(quantize(x.rgb, vec2(gl_FragCoord.x, 7.0)), 1.0)", np.tile([[0.0], [1.0]], 4)
    )
    assert whole[:, 0].tolist() == [0.0, 1.0]


def test_fresnel(evaluate):
    cos, ior = (g.ravel() for g in np.meshgrid(np.linspace(0, 1, 91), [1.0, 1.3, 1.5, 1.52, 1.7, 2.4]))
    x = np.stack([cos, ior, cos, cos], 1)
    got = evaluate("fresnel.glsl", "vec4(fresnel_dielectric(x.x, x.y))", x)
    keep = ~((ior == 1.0) & (cos < 1e-3))  # no interface, seen edge-on: 0/0
    np.testing.assert_allclose(
        got[keep, 0],
        [float(fresnel_dielectric(c, n)) for c, n in zip(cos[keep], ior[keep], strict=True)],
        atol=2e-6,
    )


def test_the_faithful_curve_changes_nothing_up_to_its_shoulder():
    colour = np.array([[0.04, 0.02, 0.8], [0.001, 0.0, 0.002], [0.79, 0.4, 0.1]])
    np.testing.assert_array_equal(tc.tone_faithful(colour), colour)
    bright = tc.tone_faithful(np.array([[0.801, 0.5, 0.1], [5.0, 2.0, 1.0]]))
    assert bright[0] == pytest.approx([0.801, 0.5, 0.1], abs=2e-3)
    assert bright.max() < 1.0


@example([0.0, 0.0, 4.0], "agx")
@given(
    st.lists(st.floats(0, 1e4), min_size=3, max_size=3),
    st.sampled_from(["faithful", "neutral", "characteristic", "agx"]),
)
def test_curves_stay_in_range_and_rise(rgb, kind):
    low, high = tc.tone_curve(rgb, kind), tc.tone_curve(np.asarray(rgb) * 1.1 + 1e-3, kind)
    assert (low >= -1e-9).all()
    assert (high <= 1 + 1e-9).all()
    assert high.max() >= low.max() - 1e-12


def test_aces_with_rec709_has_the_published_matrices():
    into, back = tc.aces_matrices()
    published_into = [[0.59719, 0.35458, 0.04823], [0.07600, 0.90834, 0.01566], [0.02840, 0.13383, 0.83777]]
    published_back = [
        [1.60475, -0.53108, -0.07367],
        [-0.10208, 1.10813, -0.00605],
        [-0.00327, -0.07276, 1.07602],
    ]
    np.testing.assert_allclose(into @ REC709_TO_WORKING, published_into, atol=6e-6)
    np.testing.assert_allclose(WORKING_TO_SRGB @ back, published_back, atol=6e-6)


def test_aces_on_greys():
    grey = np.repeat(np.array([0.0, 0.18, 25.67, 1e9])[:, None], 3, axis=1)
    got = tc.tone_curve(grey, "aces")
    np.testing.assert_allclose(got[:, 0], [0.0, 0.10559, 1.0, 1.01654], atol=2e-5)
    np.testing.assert_allclose(got, got[:, :1] * np.ones(3), atol=1e-9)  # greys stay grey


def test_agx_sigmoid_is_the_one_that_others_fit_a_polynomial_to():
    x = np.linspace(0.0, 1.0, 501)
    polynomial = (
        15.5 * x**6 - 40.14 * x**5 + 31.96 * x**4 - 6.868 * x**3 + 0.4298 * x**2 + 0.1191 * x - 0.00232
    )
    np.testing.assert_allclose(tc.agx_sigmoid(x), polynomial, atol=6e-3)
    ends = tc.agx_sigmoid([0.0, 20.0 / 33.0, 1.0])
    np.testing.assert_allclose(ends, [0.0, 0.5, 1.0], atol=1e-12)
    slope = np.diff(tc.agx_sigmoid([20.0 / 33.0 - 1e-6, 20.0 / 33.0 + 1e-6]))[0] / 2e-6
    assert slope == pytest.approx(2.0, abs=1e-4)


def test_agx_on_greys_and_saturated_light():
    grey = 0.18 * 2.0 ** np.array([-10.0, 0.0, 6.5, 12.0])
    got = tc.tone_agx(np.repeat(grey[:, None], 3, axis=1))
    np.testing.assert_allclose(got, np.array([0.0, 0.5**2.2, 1.0, 1.0])[:, None] * np.ones(3), atol=1e-5)
    spread = [np.ptp(tc.tone_agx(np.array([4.0, 0.1, 0.1]) * 2.0**ev)) for ev in (0.0, 4.0, 8.0)]
    assert spread == sorted(spread, reverse=True)  # brighter light goes to white, as on film


def test_middle_grey_and_contrast_of_the_characteristic_curve():
    assert float(tc.tone_characteristic(np.full(3, 0.18))[0]) == pytest.approx(0.18)
    up, down = (float(tc.tone_characteristic(np.full(3, 0.18 * f))[0]) for f in (1.001, 1 / 1.001))
    assert np.log(up / down) / np.log(1.001**2) == pytest.approx(1.0, abs=1e-4)


def test_unknown_curve():
    with pytest.raises(ValueRangeError, match="tone_curve"):
        tc.tone_curve(np.zeros(3), "filmic")
