"""GLSL functions against their twins in numpy, on grids."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from brdf_suite.errors import ValueRangeError
from brdf_suite.geometry.fresnel import fresnel_dielectric
from brdf_suite.realtime import tone_curves as tc


def colours():
    levels = np.array([0.0, 0.003, 0.02, 0.05, 0.081, 0.18, 0.5, 0.76, 0.81, 1.0, 3.0, 40.0])
    grid = np.stack(np.meshgrid(levels, levels, levels), -1).reshape(-1, 3)
    return np.concatenate([grid, np.ones((len(grid), 1))], 1)


@pytest.mark.parametrize("kind", ["faithful", "neutral", "characteristic", "linear"])
def test_tone_curves(evaluate, kind):
    x = colours()
    number = tc.TONE_CURVE_NUMBERS[kind]
    got = evaluate("tone_curve.glsl", f"vec4(tone_curve(x.rgb, {number}), 1.0)", x)
    np.testing.assert_allclose(got[:, :3], tc.tone_curve(x[:, :3], kind), rtol=2e-5, atol=2e-6)


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


@given(
    st.lists(st.floats(0, 1e4), min_size=3, max_size=3),
    st.sampled_from(["faithful", "neutral", "characteristic"]),
)
@settings(max_examples=60, deadline=None)
def test_curves_stay_in_range_and_rise(rgb, kind):
    low, high = tc.tone_curve(rgb, kind), tc.tone_curve(np.asarray(rgb) * 1.1 + 1e-3, kind)
    assert (low >= -1e-9).all()
    assert (high <= 1 + 1e-9).all()
    assert high.max() >= low.max() - 1e-12


def test_middle_grey_and_contrast_of_the_characteristic_curve():
    assert float(tc.tone_characteristic(np.full(3, 0.18))[0]) == pytest.approx(0.18)
    up, down = (float(tc.tone_characteristic(np.full(3, 0.18 * f))[0]) for f in (1.001, 1 / 1.001))
    assert np.log(up / down) / np.log(1.001**2) == pytest.approx(1.0, abs=1e-4)


def test_unknown_curve():
    with pytest.raises(ValueRangeError, match="tone_curve"):
        tc.tone_curve(np.zeros(3), "filmic")
