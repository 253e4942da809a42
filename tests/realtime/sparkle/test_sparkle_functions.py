"""The sparkle's GLSL functions against their twins in numpy, flake by flake."""

from __future__ import annotations

import numpy as np
import pytest

from brdf_suite.appearance.flakes import tilt
from brdf_suite.appearance.flakes.footprint import flake_footprint
from tools.evaluation import flake_model as glints

N = 6000


def grid(seed, spread=0.25, reach=40.0):
    """Places (n, 2) mm and slopes (n, 2), as the shader gets them: rounded to single precision."""
    rng = np.random.default_rng(seed)
    x = np.concatenate([rng.uniform(-reach, reach, (N, 2)), rng.normal(0, spread, (N, 2))], 1)
    return x.astype(np.float32).astype(float)


def vector(values):
    return f"vec2({float(values[0])!r}, {float(values[1])!r})"


def test_hash_agrees_to_the_last_bit(evaluate):
    cells = np.array([[i, j] for i in (-70000, -3, -1, 0, 1, 2, 511, 70000) for j in (-9, 0, 1, 12345)])
    x = np.concatenate([cells, cells], 1).astype(float)
    got = evaluate(
        "sparkle_hash.glsl",
        "vec4(halves(cell_key(ivec2(x.xy), 77u)), halves(scrambled(uint(int(x.x)))))",
        x,
    )
    key = glints.cell_key(cells[:, 0], cells[:, 1], np.uint32(77))
    want = [*glints.halves(key), *glints.halves(glints.scramble(glints.wrap_words(cells[:, 0])))]
    np.testing.assert_array_equal(got, np.stack(want, -1).astype(np.float32))


@pytest.mark.parametrize("ior", [1.0, 1.5, 1.7])
def test_the_flake_between_light_and_eye(evaluate, ior):
    rng = np.random.default_rng(2)
    angles = rng.uniform(0, 1.5, (500, 2))
    wi = np.stack([np.sin(angles[:, 0]), 0 * angles[:, 0], np.cos(angles[:, 0])], -1)
    turn = rng.uniform(0, 6.28, 500)
    wo = np.stack(
        [np.sin(angles[:, 1]) * np.cos(turn), np.sin(angles[:, 1]) * np.sin(turn), np.cos(angles[:, 1])], -1
    )
    got = evaluate(
        "flake_tilt.glsl",
        "vec4(flake_slope(vec3(sin(x.x), 0.0, cos(x.x)),"
        f" vec3(sin(x.y) * cos(x.z), sin(x.y) * sin(x.z), cos(x.y)), {ior!r}), 0.0, 1.0)",
        np.stack([*angles.T, turn, turn], -1),
    )
    np.testing.assert_allclose(got[:, :2], tilt.flake_slope(wi, wo, ior), rtol=2e-3, atol=2e-6)


@pytest.mark.parametrize("roughness", [0.05, 0.17, 0.6])
def test_distributions(evaluate, roughness):
    slope = np.linspace(0, 4 * roughness, 200)
    x = np.stack([slope, 0.3 * slope, slope**2, slope], -1)
    r = repr(roughness)
    got = evaluate(
        "flake_tilt.glsl",
        f"vec4(beckmann_slopes(x.z, {r}), ggx_density(x.z, {r}), tilt_bell(x.z, {r}), 1.0)",
        x,
    )
    want = [f(slope**2, roughness) for f in (glints.beckmann_slopes, glints.ggx_density, tilt.tilt_bell)]
    np.testing.assert_allclose(got[:, :3], np.stack(want, -1), rtol=1e-4, atol=1e-6)
    got = evaluate("flake_tilt.glsl", f"vec4(tilt_place(x.xy, {r}), 1.0)", x)
    place, stretch = tilt.tilt_place(np.stack([slope, 0.3 * slope], -1), roughness)
    np.testing.assert_allclose(got[:, :2], place, atol=1e-6)
    np.testing.assert_allclose(got[:, 2], stretch, rtol=1e-4)


def test_footprint(evaluate):
    x = grid(3, 0.004, 0.06)
    across, down, size = (0.02, 0.005), (-0.01, 0.03), 0.02
    got = evaluate(
        "flake_footprint.glsl",
        f"vec4(flake_cover(flake_footprint(vec2(0.0), {vector(across)}, {vector(down)}, {size}), x.xy))",
        x,
    )
    places = np.zeros((len(x), 2))
    print_ = flake_footprint(places, places + across, places + down, size)
    want = print_.cover(x[:, 0], x[:, 1])
    assert (want > 0).mean() > 0.2
    np.testing.assert_allclose(got[:, 0], want, rtol=1e-4, atol=1e-3 * want.max())


@pytest.mark.parametrize("pixel_mm", [0.004, 0.03, 0.2, 2.0])
@pytest.mark.parametrize("spread", [0.02, 0.05])
def test_glints(evaluate, pixel_mm, spread):
    """The same flakes shine equally: a picture of glints is the same picture."""
    x = grid(5)
    across, down = (pixel_mm, 0.2 * pixel_mm), (-0.3 * pixel_mm, 1.4 * pixel_mm)
    numbers = "120.0, 0.02, 0.17, 0.02, 0.4"
    got = evaluate(
        "sparkle_glints.glsl",
        f"vec4(glint_ratio(glint_field(x.xy, {vector(across)}, {vector(down)}, {numbers}),"
        f" tilt_place(x.zw, 0.17), {spread}), 1.0)",
        x,
    )
    at = x[:, :2]
    field = glints.glint_field(
        at,
        0 * at + across,
        0 * at + down,
        density=120.0,
        size=0.02,
        roughness=0.17,
        waviness=0.02,
        colour_spread=0.4,
    )
    want = glints.glint_ratio(field, *tilt.tilt_place(x[:, 2:], 0.17), spread)
    assert want.std() > 1e-3
    # Rounding of a place in single precision moves a flake by 1e-5 of its distance from the origin.
    far = np.abs(got[:, :3] - want).max(-1) > 0.02 * (1 + want.max(-1))
    assert far.mean() < 0.004
    assert np.corrcoef(got[:, 0], want[:, 0])[0, 1] > 0.999


@pytest.mark.parametrize("pixel_mm", [0.004, 0.05, 0.15])
def test_flake_texture(evaluate, pixel_mm):
    x = grid(7)
    across, down = (pixel_mm, 0.0), (0.0, pixel_mm)
    got = evaluate(
        "flake_texture.glsl",
        f"vec4(flake_texture_ratio(flake_texture(x.xy, {vector(across)}, {vector(down)}, 120.0, 0.02, 0.17, 0.4),"
        " x.zw, 0.012), 1.0)",
        x,
    )
    at = x[:, :2]
    want = glints.flake_texture_ratio(
        at,
        0 * at + across,
        0 * at + down,
        x[:, 2:],
        0.012,
        density=120.0,
        size=0.02,
        roughness=0.17,
        colour_spread=0.4,
    )
    assert want.std() > 1e-3
    far = np.abs(got[:, :3] - want).max(-1) > 0.02 * (1 + want.max(-1))
    assert far.mean() < 0.004


def test_shown_share(evaluate):
    weight = np.linspace(0, 1, 201)
    got = evaluate("sparkle_glints.glsl", "vec4(shown_share(x.x))", np.tile(weight[:, None], 4))
    np.testing.assert_allclose(got[:, 0], glints.shown_share(weight), atol=1e-6)
