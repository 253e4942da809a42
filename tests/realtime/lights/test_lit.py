"""Surfaces in single lights, and flakes in them: what arrives, what is sent on, and that flakes add nothing."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from brdf_suite.appearance.light.matrix import lamp_colour
from brdf_suite.documents.paint import Flakes
from brdf_suite.documents.view import Camera, View
from brdf_suite.documents.view_settings import Lamp, Sparkle
from brdf_suite.realtime.lights.block import DistantLights
from brdf_suite.realtime.lights.single_lights import SingleLights
from brdf_suite.realtime.pictures.display import LINEAR
from brdf_suite.realtime.values import MeshPart

# 36 mm of picture to 60 mm of lens: from 0.2 m, 0.12 m across; 1 mm is 2 pixels of 240.
NEAR = View(Camera(0, 0, 0.2, (0.0, 0.0, 0.0), 60.0), fresnel="off", sparkle=Sparkle("off"))
SIZE = (240, 160)
FLAKES = Flakes(100.0, 30.0, 0.17)


def sheet(half=0.06, with_uv=True):
    """A square that looks along +z, with millimetres as texture coordinates."""
    corners = np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]) * half
    uvs = 1e3 * corners[:, :2] if with_uv else None
    normals = np.tile([0.0, 0.0, 1.0], (4, 1))
    return MeshPart("sheet", "paint", corners, normals, np.array([[0, 1, 2], [0, 2, 3]]), uvs)


def one_light(direction=(0.2, 0.1, 0.97), strength=4.0):
    unit = np.asarray(direction) / np.linalg.norm(direction)
    return DistantLights(unit[None], np.full((1, 3), strength), np.array([0.005]))


@pytest.fixture
def lit(renderer, scenes):
    """Return a function that draws a sheet in the dark, with lamps or with lights of the environment."""

    def draw(view, weights, *, lights=None, flakes=None, part=None, environment=0.0, size=SIZE):
        renderer.set_environment(scenes.constant(environment), *([] if lights is None else [lambda: lights]))
        renderer.set_mesh([part or sheet()])
        renderer.set_material("paint", weights)
        renderer.set_flakes("paint", flakes)
        return renderer.linear_image(view, size, samples=1)[..., :3].astype(float)

    return draw


def places(size=SIZE):
    """Where the sheet is seen (h, w, 3), metres."""
    x = (np.arange(size[0]) + 0.5) / size[0] - 0.5
    y = 0.5 - (np.arange(size[1]) + 0.5) / size[1]
    across = 0.2 * 36.0 / 60.0
    gx, gy = np.meshgrid(x * across, y * across * size[1] / size[0])
    return np.stack([gx, gy, 0 * gx], -1)


def test_a_point_lamp_lights_a_matt_sheet(lit, scenes):
    lamp = Lamp("point", (0.05, 0.02, 0.1), strength=0.5, temperature_k=4500.0)
    got = lit(replace(NEAR, lamps=(lamp,)), scenes.weights(kd=0.4))
    way = np.array(lamp.position) - places()
    squared = (way**2).sum(-1)
    # Strength is illuminance over pi at 1 m, so the radiance of a matt white there.
    want = 0.4 * 0.5 * way[..., 2] / squared**1.5
    np.testing.assert_allclose(got, want[..., None] * lamp_colour(4500.0), rtol=3e-3)


def test_a_directional_lamp_gives_the_lobe_sum(lit, scenes):
    lamp = Lamp("directional", azimuth_deg=20.0, elevation_deg=10.0, strength=2.0)
    weights = scenes.weights(kd=0.1, directional=0.5)
    got = lit(replace(NEAR, lamps=(lamp,)), weights)
    azimuth, elevation = np.radians([20.0, 10.0])
    light = np.array(
        [np.cos(elevation) * np.sin(azimuth), np.sin(elevation), np.cos(elevation) * np.cos(azimuth)]
    )
    view = np.array([0, 0, 0.2]) - places()
    view /= np.linalg.norm(view, axis=-1, keepdims=True)
    mirrored = light * [-1, -1, 1]
    cosine = (view @ mirrored).clip(0)
    f = weights.kd[0] + (cosine[..., None] ** np.asarray(weights.exponents)) @ weights.kdd[:, 0]
    np.testing.assert_allclose(got[..., 1], 2.0 * np.pi * light[2] * f * lamp_colour(6500.0)[1], rtol=6e-3)


def test_the_coats_highlight_is_where_the_lamp_is_mirrored(lit, scenes):
    lamp = Lamp("point", (0.02, 0.0, 0.2), strength=1.0)
    got = lit(replace(NEAR, lamps=(lamp,)), scenes.weights(gloss=0.04))[..., 1]
    row, column = np.unravel_index(int(np.argmax(got)), got.shape)
    np.testing.assert_allclose(places()[row, column], [0.01, 0.0, 0.0], atol=6e-4)
    # The gloss lobe holds its albedo: what the highlight sends in all.
    area = (0.12 / 240) ** 2
    squared = 0.04 + 0.01**2
    arriving = np.pi / squared  # of a lamp of strength 1, at the highlight
    # An even sheet turns the mirror direction by the angle to the lamp plus that to the eye: (1/0.2 + 1/0.2) per metre.
    solid_angle = area * (10.0 * np.sqrt(0.04 / squared)) ** 2 * 0.04 / squared
    assert got.sum() * solid_angle == pytest.approx(0.04 * arriving, rel=0.1)


def test_lamps_behind_the_sheet_do_nothing(lit, scenes):
    lamp = Lamp("point", (0.0, 0.0, -0.1), strength=5.0)
    assert not lit(replace(NEAR, lamps=(lamp,)), scenes.weights(kd=0.4, gloss=0.1, directional=0.2)).any()


@pytest.mark.parametrize("mode", ["texture", "glints"])
def test_flakes_move_light_about_and_add_none(lit, scenes, mode):
    weights = scenes.weights(kd=0.02, directional=0.5)
    # From near: the texture has faded where a pixel holds several flakes.
    near = replace(NEAR, camera=replace(NEAR.camera, distance=0.015, target=(0.0, 0.0, 0.0)))
    big = (450, 350)
    smooth = lit(near, weights, environment=1.0, size=big)
    sparkling = lit(
        replace(near, sparkle=Sparkle(mode, strength=2.0)),
        weights,
        lights=one_light(strength=0.5),
        flakes=FLAKES,
        environment=1.0,
        size=big,
    )
    change = (sparkling - smooth)[..., 1]
    assert change.max() > 3 * smooth.mean()
    assert change.min() < 0
    # The mean of many thousand flakes stays within the chance of so many.
    assert abs(change.mean()) < 0.25 * np.abs(change).mean()
    assert abs(change.mean()) < 4 * change.std() * np.sqrt(60.0 / change.size)


def test_flakes_in_a_lamp_that_lights_the_surface_too(lit, scenes):
    lamp = Lamp("point", (0.03, 0.02, 0.15), strength=1.0)
    weights = scenes.weights(kd=0.02, directional=0.5)
    smooth = lit(replace(NEAR, lamps=(lamp,)), weights, flakes=FLAKES)
    sparkling = lit(replace(NEAR, lamps=(lamp,), sparkle=Sparkle("glints")), weights, flakes=FLAKES)
    assert sparkling.max() > 1.5 * smooth.max()
    assert sparkling.mean() == pytest.approx(smooth.mean(), rel=0.05)
    coloured = lit(
        replace(NEAR, lamps=(lamp,), sparkle=Sparkle("glints")),
        weights,
        flakes=replace(FLAKES, colour_spread=1.0),
    )
    bright = sparkling[..., 1] > 1.2 * smooth[..., 1]
    hue = np.abs(coloured[bright].max(-1) - coloured[bright].min(-1)).mean()
    assert hue > 5 * np.abs(sparkling[bright].max(-1) - sparkling[bright].min(-1)).mean()


@pytest.mark.parametrize("mode", ["texture", "glints"])
def test_without_flakes_or_without_the_mode_nothing_sparkles(lit, scenes, mode):
    weights = scenes.weights(kd=0.02, directional=0.5)
    plain = lit(NEAR, weights, environment=1.0)
    np.testing.assert_array_equal(
        lit(replace(NEAR, sparkle=Sparkle(mode)), weights, lights=one_light(), environment=1.0), plain
    )
    np.testing.assert_array_equal(
        lit(NEAR, weights, lights=one_light(), flakes=FLAKES, environment=1.0), plain
    )


def test_strength_nought_is_smooth_and_more_is_more(lit, scenes):
    weights = scenes.weights(kd=0.02, directional=0.5)
    contrast = []
    for strength in (0.0, 1.0, 3.0):
        view = replace(NEAR, sparkle=Sparkle("glints", strength=strength))
        contrast.append(lit(view, weights, lights=one_light(), flakes=FLAKES, environment=1.0)[..., 1].std())
    assert contrast[1] > 3 * contrast[0]
    assert contrast[2] > 2 * contrast[1]


def test_lights_turn_with_the_environment(lit, scenes):
    weights = scenes.weights(kd=0.02, directional=0.5)
    view = replace(NEAR, sparkle=Sparkle("glints"))
    turned = replace(view, rotation_deg=180.0)
    away = lit(turned, weights, lights=one_light(), flakes=FLAKES, environment=1.0)
    grain = lit(view, weights, flakes=FLAKES, environment=1.0)
    np.testing.assert_allclose(away, grain, atol=1e-4)
    shown = lit(view, weights, lights=one_light(), flakes=FLAKES, environment=1.0)
    back = lit(turned, weights, lights=one_light((-0.2, 0.1, -0.97)), flakes=FLAKES, environment=1.0)
    assert np.abs(shown - grain).max() > 0.2
    # The map has no such light; what grain takes out of it for that depends on the direction by a little.
    assert np.corrcoef(back.ravel(), shown.ravel())[0, 1] > 0.9995


def test_lights_are_looked_for_only_where_flakes_are_drawn(renderer, scenes):
    asked = []
    renderer.set_environment(scenes.constant(1.0), lambda: asked.append(True) or one_light())
    renderer.set_mesh([sheet()])
    renderer.set_material("paint", scenes.weights(kd=0.02, directional=0.5))
    lit_too = replace(NEAR, sparkle=Sparkle("glints"), lamps=(Lamp("directional"),))
    renderer.linear_image(lit_too, (24, 16), samples=1)
    renderer.set_flakes("paint", FLAKES)
    renderer.linear_image(replace(lit_too, sparkle=Sparkle("off")), (24, 16), samples=1)
    assert asked == []
    renderer.linear_image(lit_too, (24, 16), samples=1)
    assert asked


def test_flakes_are_the_same_in_tiles_and_with_more_samples(renderer, lit, scenes):
    view = replace(NEAR, sparkle=Sparkle("glints"))
    whole = lit(
        view, scenes.weights(kd=0.02, directional=0.5), lights=one_light(), flakes=FLAKES, environment=1.0
    )
    tiles = np.concatenate(list(renderer.strips(view, SIZE, 1, display=LINEAR, largest_tile=64)))[..., :3]
    np.testing.assert_allclose(tiles.astype(float), whole, rtol=1e-3)
    several = renderer.linear_image(view, SIZE, samples=4)[..., :3]
    np.testing.assert_allclose(several, whole, rtol=2e-3)


def test_a_mesh_without_texture_coordinates_sparkles_too(lit, scenes):
    weights = scenes.weights(kd=0.02, directional=0.5)
    view = replace(NEAR, sparkle=Sparkle("glints"))
    bare = lit(view, weights, lights=one_light(), flakes=FLAKES, environment=1.0, part=sheet(with_uv=False))
    with_uv = lit(view, weights, lights=one_light(), flakes=FLAKES, environment=1.0)
    assert np.isfinite(bare).all()
    assert bare.std() == pytest.approx(with_uv.std(), rel=0.4)


def test_far_away_flakes_melt_into_the_smooth_light(lit, scenes):
    weights = scenes.weights(kd=0.02, directional=0.5)
    lamp = Lamp("directional", azimuth_deg=12.0, elevation_deg=6.0)
    contrast = []
    for distance in (0.05, 0.5, 5.0):
        camera = replace(NEAR.camera, distance=distance)
        smooth = replace(NEAR, camera=camera, lamps=(lamp,))
        sparkling = replace(smooth, sparkle=Sparkle("glints"))
        flat = lit(smooth, weights, flakes=FLAKES, part=sheet(half=distance))
        change = lit(sparkling, weights, flakes=FLAKES, part=sheet(half=distance)) - flat
        contrast.append(np.abs(change).max() / flat.mean())
    assert contrast[0] > 3 * contrast[1] > 0
    assert contrast[1] > 3 * contrast[2]


@pytest.mark.usefixtures("prepared")
def test_nothing_is_made_for_what_is_not_shown(renderer, lit, scenes):
    lit(NEAR, scenes.weights(kd=0.3), flakes=FLAKES)
    before = dict(renderer.counters.created)
    renderer.linear_image(replace(NEAR, exposure_ev=1.0), SIZE, samples=1)
    assert renderer.counters.created == before
    shown = replace(NEAR, sparkle=Sparkle("glints"))
    renderer.linear_image(shown, SIZE, samples=1)
    once, uploads = renderer.counters.total_created, renderer.counters.texture_uploads
    renderer.linear_image(shown, SIZE, samples=1)
    assert (renderer.counters.total_created, renderer.counters.texture_uploads) == (once, uploads)
    renderer.set_material("paint", scenes.weights(kd=0.31))
    renderer.linear_image(shown, SIZE, samples=1)
    assert renderer.counters.total_created == once


def test_only_a_material_with_flakes_is_drawn_with_what_they_need(renderer):
    """The shader of flakes costs a software renderer as much where there are none."""
    single = SingleLights(renderer.objects)
    single.set_flakes("paint", FLAKES)
    assert single.features(NEAR, "paint") == frozenset()
    for mode, word in (("glints", "SPARKLE_GLINTS"), ("texture", "SPARKLE_TEXTURE")):
        view = replace(NEAR, sparkle=Sparkle(mode))
        assert single.features(view, "paint") == {word}
        assert single.features(view, "chrome") == frozenset()
    single.set_flakes("paint", None)
    assert single.features(replace(NEAR, sparkle=Sparkle("glints")), "paint") == frozenset()
