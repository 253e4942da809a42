"""Lamps on factored materials: the shader's products of maps against those of the reflectance itself."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from brdf_suite.appearance.light.matrix import lamp_colour
from brdf_suite.documents.view import Camera, View
from brdf_suite.documents.view_settings import Lamp, Relief, Sparkle, TwoTone
from brdf_suite.errors import ValueRangeError
from brdf_suite.geometry.factor_words import PROJECTIONS
from brdf_suite.pipeline.factored_maps import factored_maps, maps_of
from brdf_suite.realtime.factors.values import FactoredMaps, FactorMap, FactorTerm
from brdf_suite.realtime.pictures.display import LINEAR
from brdf_suite.realtime.pictures.probe import geometry_picture
from brdf_suite.realtime.relief.values import MaskImage, TangentMap
from brdf_suite.realtime.values import MeshPart
from brdf_suite.reflectance.factored.map import MapFactor
from brdf_suite.reflectance.factored.model import Factored
from brdf_suite.reflectance.models.coated import Coated
from tools.evaluation.direct_lamps import half_angles_deg, lamp_radiance

SIZE = (60, 40)
NEARLY = 5e-3
"""Graphics cards place a look-up between texels in steps of 1/256; a software renderer comes to 2e-3."""
# 36 mm of picture to 60 mm of lens, from 0.2 m: 0.12 m across, views to 21 degrees from the middle's.
NEAR = View(Camera(20, 30, 0.2, (0.0, 0.0, 0.0), 60.0), fresnel="off", sparkle=Sparkle("off"))
LAMPS = (
    Lamp("point", position=(-0.15, 0.1, 0.12), strength=0.1, temperature_k=3000.0),
    Lamp("directional", azimuth_deg=-20.0, elevation_deg=-35.0, strength=2.0),
    Lamp("point", position=(0.02, -0.05, 0.2), strength=0.3),
)


def sheet(turn_deg=0.0, with_uv=True, half=0.12):
    """A square that looks along +z; its u grows along x turned by an angle."""
    corners = np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]) * half
    c, s = np.cos(np.radians(turn_deg)), np.sin(np.radians(turn_deg))
    uvs = 1e3 * corners[:, :2] @ np.array([[c, -s], [s, c]]) if with_uv else None
    normals = np.tile([0.0, 0.0, 1.0], (4, 1))
    return MeshPart("sheet", "paint", corners, normals, np.array([[0, 1, 2], [0, 2, 3]]), uvs)


def waves(*shape, seed, low=0.2, high=2.0):
    """A smooth map over places (x, y) or x, three channels unlike each other."""
    rng = np.random.default_rng(seed)
    along = np.meshgrid(*[(np.arange(n) + 0.5) / n for n in reversed(shape)])
    phase, slope = rng.uniform(0, 6, (3,)), rng.uniform(3, 6, (3, len(shape)))
    values = np.stack(
        [np.sin(phase[k] + sum(slope[k, a] * x for a, x in enumerate(along))) for k in range(3)], axis=-1
    )
    return (low + (high - low) * 0.5 * (values + 1.0)).astype(np.float32)


@pytest.fixture
def lit(renderer, scenes):
    """Return a function that draws factored maps in the dark and gives radiance (h, w, 3)."""
    renderer.set_environment(scenes.constant(0.0))
    renderer.set_material("paint", scenes.weights(0.3))

    def draw(maps, lamps=LAMPS, part=None, view=NEAR):
        renderer.set_mesh([part or sheet()])
        renderer.factors.set("paint", maps)
        shown = replace(view, lamps=tuple(lamps))
        return renderer.render_image(shown, SIZE, 1, display=LINEAR)[..., :3].astype(np.float64)

    yield draw
    renderer.factors.release()


@pytest.fixture
def wanted(renderer, scenes):
    """Return a function that gives the radiance that a reflectance has there, in numpy."""

    def give(evaluate, lamps=LAMPS, turn_deg=0.0):
        camera = renderer.camera_matrices(NEAR, SIZE)
        rays = scenes.rays(camera, SIZE)
        place = camera.eye - camera.eye[2] / rays[..., 2:] * rays
        c, s = np.cos(np.radians(turn_deg)), np.sin(np.radians(turn_deg))
        to_local = np.array([[c, s, 0], [-s, c, 0], [0, 0, 1.0]])
        total = np.zeros((*SIZE[::-1], 3))
        for lamp in lamps:
            if lamp.kind == "point":
                way = np.asarray(lamp.position) - place
                squared = (way**2).sum(-1, keepdims=True)
            else:
                a, e = np.radians([lamp.azimuth_deg, lamp.elevation_deg])
                way = np.broadcast_to([np.cos(e) * np.sin(a), np.sin(e), np.cos(e) * np.cos(a)], place.shape)
                squared = np.ones_like(place[..., :1])
            wi = way / np.linalg.norm(way, axis=-1, keepdims=True)
            f = evaluate(wi @ to_local.T, -rays @ to_local.T)
            irradiance = np.pi * lamp.strength * lamp_colour(lamp.temperature_k) / squared
            total += irradiance * f * np.maximum(wi[..., 2:], 0.0)
        return total

    return give


def relative(got, truth):
    return np.abs(got - truth) / truth.mean()


def test_the_default_product_with_a_peak_is_that_of_the_reflectance(lit, wanted):
    peak = (
        MapFactor("sqrt|h|", waves(64, seed=3, low=0.01, high=8.0), True),
        MapFactor("w.h", waves(16, seed=4)),
    )
    value = Factored(waves(24, 24, seed=1), waves(32, 32, seed=2), 0.3, peak=peak, logarithmic=True)
    truth = wanted(value.eval)
    error = relative(lit(factored_maps(value)), truth)
    assert truth.max() / truth.min() > 3
    # In the middle of a highlight a pixel covers several rings of such a map, and shows their mean.
    assert np.quantile(error, 0.99) < 2e-3
    assert error.max() < 0.05


@pytest.mark.parametrize("projection", list(PROJECTIONS))
def test_every_projection_finds_its_place(lit, wanted, projection):
    shape = (24,) * PROJECTIONS[projection].axes
    flat = np.ones((2, 3), np.float32)
    for logarithmic in (True, False):
        more = (MapFactor(projection, waves(*shape, seed=7), logarithmic),)
        value = Factored(flat, flat, 0.5, more=more)
        assert relative(lit(factored_maps(value)), wanted(value.eval)).max() < NEARLY


def test_maps_that_say_nothing_need_no_texture_and_too_many_leave_the_lamps_to_the_lobes(lit, wanted):
    names = ("|wi|", "|wo|", "wi.wo", "w.h", "sqrt|h|", "|h|")
    more = tuple(MapFactor(name, waves(8, seed=seed), True) for seed, name in enumerate(names))
    two = np.broadcast_to(np.float32(2.0), (2, 3))
    value = Factored(two, two, 0.1, more=more)
    maps = maps_of(value)
    assert len(maps.maps) == 6
    assert relative(lit(maps), wanted(value.eval)).max() < 2.0 * NEARLY  # the steps of six maps
    # Darker than the shader's numbers can resolve.
    black = replace(
        value, more=(MapFactor("|h|", np.full((8, 3), 1e-37, np.float32) * waves(8, seed=1), True),)
    )
    assert lit(maps_of(black)).max() < 1e-20
    seventh = (MapFactor("|h|", waves(8, seed=9), True),)
    assert maps_of(replace(value, more=more + seventh)) is None
    assert maps_of(Coated(replace(value, more=more + seventh), ior=1.5, spread=0.7)) is None
    # All the same everywhere: still something to draw.
    flat = Factored(two, two, 0.1)
    assert relative(lit(maps_of(flat)), wanted(flat.eval)).max() < NEARLY


def test_lamps_add_up_in_one_pass_and_one_below_the_horizon_adds_nothing(lit):
    maps = factored_maps(Factored(waves(16, 16, seed=1), waves(16, 16, seed=2), 0.3))
    together = lit(maps)
    np.testing.assert_allclose(sum(lit(maps, [one]) for one in LAMPS), together, rtol=1e-4, atol=1e-5)
    below = Lamp("directional", azimuth_deg=180.0, elevation_deg=20.0, strength=50.0)
    np.testing.assert_array_equal(lit(maps, [*LAMPS, below]), together)


def soft_clip(values, ceiling):
    """Values (..., 3) as the shader bends them: what is above ``ceiling`` comes to it."""
    given = np.asarray(values, float)
    return given / (1.0 + (given.max(axis=-1, keepdims=True) / ceiling) ** 4) ** 0.25


def test_what_is_beyond_the_ceiling_bends_to_it_and_keeps_its_colour(lit, wanted):
    bright = np.full((2, 3), 1.0, np.float32)
    more = (MapFactor("|h|", waves(32, seed=5, low=0.01, high=30.0), True),)
    value = Factored(bright, bright, (1.0, 0.5, 0.25), more=more, facts={"largest": 2.0})
    maps = factored_maps(value)
    assert maps.ceiling == 8.0
    truth = wanted(lambda wi, wo: soft_clip(value.eval(wi, wo), 8.0), LAMPS[1:2])
    assert relative(lit(maps, LAMPS[1:2]), truth).max() < NEARLY
    assert soft_clip([1e30, 1e30, 1e29], 8.0) == pytest.approx([8.0, 8.0, 0.8])


def test_values_that_are_not_maps_are_refused():
    log = FactorMap(np.zeros((4, 3)))
    for wrong in (np.full((4, 3), np.nan), np.full((4, 3), 90.0), np.zeros((4, 2)), np.zeros((0, 3))):
        with pytest.raises(ValueRangeError):
            FactorMap(wrong)
    with pytest.raises(ValueRangeError):
        FactorMap(np.full((4, 3), -1.0), logarithmic=False)
    for maps, term in (
        ({"a": log}, FactorTerm(1.0, (("b", "|h|"),))),
        ({"a": log}, FactorTerm(1.0, (("a", "h"),))),
        ({"a": log, "b": log}, FactorTerm(1.0, (("a", "|h|"),))),
    ):
        with pytest.raises(ValueRangeError):
            FactoredMaps(maps, (term,))


def test_below_a_clearcoat_the_base_loses_what_the_coat_takes(lit, wanted):
    base = Factored(waves(16, 16, seed=1), waves(16, 16, seed=2), 0.1, logarithmic=True)
    coated = Coated(base, ior=1.5, spread=0.7)
    # The fit has no gloss, so what is drawn is the base alone.
    truth = wanted(lambda wi, wo: base.eval(wi, wo) * coated.base_factor(wi, wo))
    got = lit(maps_of(coated))
    assert relative(got, truth).max() < NEARLY
    assert (got < 0.99 * lit(maps_of(base))).all()


@pytest.mark.parametrize(("store", "bound"), [("float", 2e-3), ("half", 5e-3), ("8-bit", 0.03)])
@pytest.mark.parametrize("layout", ["parabolic", "cube"])
def test_textures_of_every_kind_come_near(renderer, lit, wanted, layout, store, bound):
    peak = (MapFactor("|h|", waves(64, seed=3, low=0.01, high=2.0), False),)
    value = Factored(waves(24, 24, seed=1), waves(32, 32, seed=2), 0.3, peak=peak, logarithmic=True)
    renderer.factors.layout, renderer.factors.store = layout, store
    error = relative(lit(factored_maps(value)), wanted(value.eval))
    # A cube map is looked up between other texels than its source.
    assert error.max() < bound + (0.02 if layout == "cube" else 0.0)


def test_the_tangent_is_where_u_grows(lit, wanted):
    value = Factored(waves(16, 16, seed=1), waves(16, 16, seed=2), 0.3)
    for turn in (0.0, 40.0, -110.0):
        drawn = lit(factored_maps(value), part=sheet(turn))
        assert relative(drawn, wanted(value.eval, turn_deg=turn)).max() < NEARLY
    # Maps over radii know no tangent.
    radial = Factored(waves(16, seed=1), waves(16, seed=2), 0.3)
    np.testing.assert_allclose(
        lit(factored_maps(radial)), lit(factored_maps(radial), part=sheet(70.0)), rtol=1e-4
    )
    assert not factored_maps(radial).has_directions


def test_a_reflectance_ball_stands_for_all_lamps_far_away(renderer, lit, scenes):
    maps = factored_maps(Factored(waves(16, seed=1), waves(16, seed=2), 0.3))
    far = [LAMPS[1], Lamp("point", position=(-900.0, 500.0, 700.0), strength=9e5)]
    view = replace(NEAR, camera=Camera(20, 30, 4.0, (0.0, 0.0, 0.0), 1200.0))
    ball = replace(view, lamp_shading="ball")
    part = scenes.sphere(radius=0.04)
    each, one = (lit(maps, far, part, seen) for seen in (view, ball))
    assert each.max() > 3 * each[each > 0].mean()
    assert np.abs(one - each).mean() < 0.03 * each.mean()
    writes = renderer.counters.buffer_writes
    np.testing.assert_array_equal(lit(maps, far, part, ball), one)
    assert renderer.counters.buffer_writes == writes


def test_a_ball_is_drawn_anew_where_another_surface_stands_elsewhere(renderer, lit, scenes):
    maps = factored_maps(Factored(waves(16, seed=1), waves(16, seed=2), 0.3))
    ball = replace(NEAR, lamp_shading="ball")
    lamp = [Lamp("point", position=(0.1, 0.0, 0.1), strength=0.1)]
    aside = scenes.sphere(radius=0.03, centre=(-0.06, 0.0, 0.0))
    lit(maps, lamp, scenes.sphere(radius=0.03), ball)
    renderer.set_mesh([aside])
    kept = renderer.render_image(replace(ball, lamps=tuple(lamp)), SIZE, 1, display=LINEAR)[..., :3]
    np.testing.assert_array_equal(kept, lit(maps, lamp, aside, ball))


def test_on_a_round_surface_the_picture_is_the_one_of_the_reflectance_itself(renderer, lit, scenes):
    peak = (MapFactor("sqrt|h|", waves(64, seed=3, low=0.01, high=8.0), True),)
    value = Factored(waves(32, seed=1), waves(32, seed=2), 0.3, peak=peak, logarithmic=True)
    drawn = lit(factored_maps(value), part=scenes.sphere(radius=0.03))
    seen = geometry_picture(renderer, NEAR, SIZE)
    truth = lamp_radiance(value, seen, LAMPS)
    there = seen.parts == 0
    assert 0.1 < there.mean() < 0.9
    assert (truth[~there] == 0.0).all()
    np.testing.assert_allclose(np.linalg.norm(seen.positions[there], axis=-1), 0.03, rtol=0.01)
    # Maps are averaged over a pixel where they change within one; at the rim the middle may be another triangle's.
    off = np.abs(drawn - truth)[there] / truth.mean()
    assert np.median(off) < 0.02
    assert off.mean() < 0.05
    angle = half_angles_deg(seen, LAMPS[1:2])
    assert angle[there].min() < 5.0
    assert (angle[~there] == 90.0).all()
    released = renderer.counters.live
    geometry_picture(renderer, NEAR, SIZE)
    assert renderer.counters.live == released


def test_a_mask_blends_two_factored_materials(renderer, lit, scenes):
    first, second = (
        factored_maps(Factored(waves(16, 16, seed=s), waves(16, 16, seed=9), 0.3)) for s in (1, 5)
    )
    alone = [lit(maps) for maps in (first, second)]
    renderer.set_material("second_paint", scenes.weights(0.3))
    renderer.factors.set("second_paint", second)
    renderer.relief.set_mask(MaskImage(np.full((4, 4), 51 / 255)))
    try:
        both = lit(first, view=replace(NEAR, two_tone=TwoTone("second", "/mask.png")))
    finally:
        renderer.relief.set_mask(None)
    np.testing.assert_allclose(both, 0.8 * alone[0] + 0.2 * alone[1], rtol=2e-3, atol=2e-3)


def test_a_tangent_map_turns_the_grain(renderer, lit):
    maps = factored_maps(Factored(waves(16, 16, seed=1), waves(16, 16, seed=2), 0.3))
    turn = np.radians(40.0)
    renderer.relief.set_tangent_map(TangentMap(np.tile([np.cos(turn), np.sin(turn)], (4, 4, 1))))
    try:
        by_map = lit(maps, view=replace(NEAR, relief=Relief(tangent_map="/turns.png")))
        without = lit(maps)
    finally:
        renderer.relief.set_tangent_map(None)
    np.testing.assert_allclose(by_map, lit(maps, part=sheet(40.0)), rtol=5e-3, atol=1e-3)
    assert np.abs(by_map - without).mean() > 0.1 * without.mean()


def test_with_the_environment_dark_the_lamps_are_alone(renderer, lit, scenes):
    maps = factored_maps(Factored(waves(16, seed=1), waves(16, seed=2), 0.3))
    dark = lit(maps)
    renderer.set_environment(scenes.constant(1.0))
    lamps_alone = replace(NEAR.light_colour, brightness=0.0)
    np.testing.assert_array_equal(lit(maps, view=replace(NEAR, light_colour=lamps_alone)), dark)
    half, whole = (
        lit(maps, view=replace(NEAR, light_colour=replace(lamps_alone, brightness=b))) for b in (0.5, 1.0)
    )
    np.testing.assert_allclose(half - dark, 0.5 * (whole - dark), rtol=1e-2, atol=1e-3)
    assert (whole > dark).all()


@pytest.mark.parametrize(("projection", "width", "bound"), [("|h|", 0.02, 0.2), ("sqrt|h|", 0.2, 0.35)])
def test_a_highlight_smaller_than_a_pixel_keeps_its_light(renderer, lit, scenes, projection, width, bound):
    ring = (np.arange(64) + 0.5) / 64
    peak = (500.0 * np.exp(-((ring / width) ** 4))[:, None] * np.ones(3)).astype(np.float32)
    flat = np.full((2, 3), 0.02, np.float32)
    value = Factored(flat, flat, 1.0, peak=(MapFactor(projection, peak),))
    maps = replace(factored_maps(value), ceiling=1e6)
    part = scenes.sphere(radius=0.015)
    seen = None
    for azimuth in (-33.0, -25.0, -17.0):
        lamps = (Lamp("directional", azimuth_deg=azimuth, elevation_deg=0.7 * azimuth - 30.0, strength=2.0),)
        drawn = lit(maps, lamps, part).sum(axis=(0, 1))
        seen = seen or geometry_picture(renderer, NEAR, (6 * SIZE[0], 6 * SIZE[1]))
        truth = lamp_radiance(value, seen, lamps).sum(axis=(0, 1)) / 36
        # Of pixels' middles alone, some have all of it and some nothing.
        assert drawn == pytest.approx(truth, rel=bound)
