"""What the light does not reach is dark, by the share that was baked; and the shadow on the ground."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from brdf_suite.arrays import AnyArray
from brdf_suite.documents.view import Camera, View
from brdf_suite.documents.view_settings import PartMaterial, SurfaceLook
from brdf_suite.errors import ValueRangeError
from brdf_suite.geometry.low_harmonics import low_harmonics
from brdf_suite.realtime.environment.ground import environment_harmonics, ground_ratio
from brdf_suite.realtime.pictures.renderer import Renderer
from brdf_suite.realtime.values import CubeFaces, GroundField, MeshPart

SIZE = (96, 64)
FRONT = Camera(azimuth_deg=0.0, elevation_deg=0.0)
LIT = SurfaceLook(occlusion=True)
PLAIN = SurfaceLook(occlusion=False)


def with_light(part: MeshPart, alone: float, grounded: float, towards: AnyArray | None = None) -> MeshPart:
    """The part with the same share of light everywhere, coming from ``towards`` (the normals by default)."""
    mean = part.normals * (2 / 3) if towards is None else np.broadcast_to(towards, part.normals.shape)
    count = len(part.positions)
    columns = [mean, np.full((count, 1), alone), mean, np.full((count, 1), grounded)]
    return replace(part, light=np.concatenate(columns, axis=1))


def view(look: SurfaceLook, **fields: object) -> View:
    return View(camera=FRONT, surface_look=look, background="grey", fresnel="off", **fields)  # type: ignore[arg-type]


def test_the_function_is_the_one_in_the_docs(evaluate: Callable[..., AnyArray]) -> None:
    rng = np.random.default_rng(2)
    cosine, ao = rng.uniform(0.001, 1, 500), rng.uniform(0, 1, 500)
    exponent = 10 ** rng.uniform(0, 5, 500)
    x = np.stack([cosine, ao, exponent, np.zeros(500)], axis=1)
    found = evaluate("occlusion.glsl", "vec4(specular_occlusion(x.x, x.y, x.z))", x)[:, 0]
    r = np.minimum((2 * exponent) ** -0.5, 1.0)
    wanted = np.clip((cosine + ao) ** 2.0 ** (-16 * r - 1) - 1 + ao, 0, 1)
    np.testing.assert_allclose(found, wanted, atol=2e-5)
    # An open place loses nothing, at any roughness.
    x[:, 1] = 1.0
    found = evaluate("occlusion.glsl", "vec4(specular_occlusion(x.x, x.y, x.z))", x)[:, 0]
    np.testing.assert_allclose(found, 1.0, atol=1e-5)


@pytest.mark.parametrize(("ground", "share"), [(False, 0.6), (True, 0.25)])
def test_a_diffuse_surface_is_as_much_darker(
    renderer: Renderer, scenes: Any, ground: bool, share: float
) -> None:
    renderer.set_environment(scenes.constant())
    renderer.set_material("paint", scenes.weights(kd=0.8))
    renderer.set_mesh([with_light(scenes.sheet(), 0.6, 0.25)])
    look = SurfaceLook(occlusion=True, ground=ground)
    found = renderer.linear_image(view(look), SIZE)[32, 48, :3]
    assert found == pytest.approx(0.8 * share, abs=2e-3)
    assert renderer.linear_image(view(PLAIN), SIZE)[32, 48, :3] == pytest.approx(0.8, abs=2e-3)


def test_the_diffuse_light_is_looked_up_where_it_comes_from(renderer: Renderer, scenes: Any) -> None:
    # Light grows upwards; a wall that sees only the sky is lit by the sky.
    renderer.set_environment(scenes.from_function(lambda d: np.repeat(1.0 + d[..., 1:2], 3, axis=-1)))
    renderer.set_material("paint", scenes.weights(kd=1.0))
    renderer.set_mesh([with_light(scenes.sheet(), 1.0, 1.0, np.array([0.0, 0.6, 0.1]))])
    bent = np.array([0.0, 0.6, 0.1]) / np.hypot(0.6, 0.1)
    found = renderer.linear_image(view(LIT), SIZE)[32, 48, :3]
    assert found == pytest.approx(1.0 + bent[1], rel=0.02)
    assert renderer.linear_image(view(PLAIN), SIZE)[32, 48, :3] == pytest.approx(1.0, rel=0.02)


def test_a_mirror_loses_less_than_a_matt_surface(renderer: Renderer, scenes: Any) -> None:
    renderer.set_environment(scenes.constant())
    renderer.set_mesh([with_light(scenes.sheet(), 0.5, 0.5)])
    shares = []
    for weights in (scenes.weights(gloss=0.5), scenes.weights(directional=0.5)):
        renderer.set_material("paint", weights)
        lit = renderer.linear_image(view(LIT), SIZE)[32, 48, 0]
        shares.append(lit / renderer.linear_image(view(PLAIN), SIZE)[32, 48, 0])
    assert shares[0] > shares[1] > 0.45
    # N.V = 1 and a mirror: sqrt(1.5) - 0.5.
    assert shares[0] == pytest.approx(np.sqrt(1.5) - 0.5, abs=0.03)


def test_switched_off_the_picture_is_the_same_to_the_last_bit(renderer: Renderer, scenes: Any) -> None:
    renderer.set_environment(scenes.from_function(lambda d: 0.5 + 0.5 * d))
    renderer.set_material("paint", scenes.weights(kd=0.4, gloss=0.04))
    ball = scenes.sphere(rings=24)
    renderer.set_mesh([ball])
    before = renderer.render_image(view(PLAIN), SIZE)
    assert np.array_equal(renderer.render_image(view(LIT), SIZE), before)  # nothing was baked
    renderer.set_mesh([with_light(ball, 0.3, 0.1)])
    assert np.array_equal(renderer.render_image(view(PLAIN), SIZE), before)
    assert not np.array_equal(renderer.render_image(view(LIT), SIZE), before)


def test_a_part_that_was_not_baked_counts_as_open(renderer: Renderer, scenes: Any) -> None:
    renderer.set_environment(scenes.constant())
    renderer.set_material("paint", scenes.weights(kd=0.8))
    left = with_light(scenes.sheet(half=0.04, centre=(-0.06, 0, 0)), 0.5, 0.5)
    right = replace(scenes.sheet(half=0.04, centre=(0.06, 0, 0)), name="right")
    renderer.set_mesh([left, right])
    row = renderer.linear_image(view(LIT), SIZE)[32, :, 0]
    assert row[24] == pytest.approx(0.4, abs=3e-3)
    assert row[72] == pytest.approx(0.8, abs=3e-3)


def test_the_back_of_a_sheet_sees_as_much(renderer: Renderer, scenes: Any) -> None:
    renderer.set_environment(scenes.from_function(lambda d: np.repeat(2.0 - d[..., 2:3], 3, axis=-1)))
    renderer.set_material("paint", scenes.weights(kd=1.0))
    renderer.set_mesh([with_light(scenes.sheet(), 0.5, 0.5)])
    behind = replace(view(LIT), camera=Camera(azimuth_deg=180.0, elevation_deg=0.0))
    assert renderer.linear_image(behind, SIZE)[32, 48, 0] == pytest.approx(0.5 * 3.0, rel=0.02)


def test_each_side_of_a_sheet_has_its_own_light(renderer: Renderer, scenes: Any) -> None:
    renderer.set_environment(scenes.constant(1.0))
    renderer.set_material("paint", scenes.weights(kd=1.0))
    front, back = (with_light(scenes.sheet(), share, share) for share in (0.8, 0.3))
    assert front.light is not None
    assert back.light is not None
    turned = back.light * np.array([-1, -1, -1, 1, -1, -1, -1, 1], np.float16)
    renderer.set_mesh([replace(front, light=np.concatenate([front.light, turned], axis=1))])
    for azimuth, share in ((0.0, 0.8), (180.0, 0.3)):
        seen = replace(view(LIT), camera=Camera(azimuth_deg=azimuth, elevation_deg=0.0))
        assert renderer.linear_image(seen, SIZE)[32, 48, 0] == pytest.approx(share, rel=0.01)
        with_places = renderer.capture(replace(seen, tone_curve="linear"), SIZE, 1)
        with_places.release()


def test_light_of_the_wrong_shape_is_refused(scenes: Any) -> None:
    with pytest.raises(ValueRangeError, match="light"):
        replace(scenes.sheet(), light=np.zeros((4, 7)))


def test_parts_take_the_material_that_the_view_gives_them(renderer: Renderer, scenes: Any) -> None:
    renderer.set_environment(scenes.constant())
    renderer.set_material("paint", scenes.weights(kd=0.8))
    renderer.set_material("glass", scenes.weights(kd=0.1))
    renderer.set_mesh([scenes.sheet()])
    look = replace(PLAIN, materials=(PartMaterial("paint sheet", "glass"), PartMaterial("none", "paint")))
    assert renderer.linear_image(view(look), SIZE)[32, 48, 0] == pytest.approx(0.1, abs=2e-3)
    assert renderer.linear_image(view(PLAIN), SIZE)[32, 48, 0] == pytest.approx(0.8, abs=2e-3)


def test_harmonics_of_a_cube_map(scenes: Any) -> None:
    light = np.random.default_rng(4).normal(size=(16, 3))

    def radiance(d: AnyArray) -> AnyArray:
        return 10.0 + low_harmonics(d, 3) @ light

    found = environment_harmonics(scenes.cube(radiance(scenes.directions(64)), 3.0), 4)
    light[0] += 10.0 * np.sqrt(4 * np.pi)
    np.testing.assert_allclose(found[:16], light, atol=0.03)
    np.testing.assert_allclose(found[16:], 0.0, atol=0.03)


def ground_field(hidden: float = 1.0, height: float = -0.1) -> GroundField:
    """Open ground around a middle that sees no light from the side of +x, or none at all."""
    rows, columns, degree = 16, 24, 6
    d = np.random.default_rng(0).normal(size=(40_000, 3))
    d /= np.linalg.norm(d, axis=1, keepdims=True)
    cosine = np.maximum(d[:, 1], 0.0)[:, None]
    harmonics = low_harmonics(d, degree)
    one = 4 * np.pi * (cosine * harmonics).mean(axis=0)
    from_left = 4 * np.pi * (cosine * harmonics * (d[:, :1] < 0)).mean(axis=0)
    transfer = np.broadcast_to(one, (rows, columns, len(one))).copy()
    transfer[4:12, 6:18] = one * (1 - hidden) + hidden * from_left
    return GroundField(height, (-0.6, -0.4), (0.6, 0.4), transfer)


def test_the_ground_in_light_from_one_side(scenes: Any) -> None:
    field = ground_field()
    for side, wanted in ((1.0, 0.1), (-1.0, 0.9)):
        faces = scenes.cube(np.repeat(1.0 * (scenes.directions(32)[..., :1] * side > 0), 3, axis=-1))
        ratio, _, _ = ground_ratio(field.transfer, environment_harmonics(faces, 6))
        assert ratio[0, 0] == pytest.approx(1.0)
        assert ratio[8, 12] == pytest.approx(wanted, abs=0.12)
    dark = CubeFaces(np.zeros((6, 8, 8, 3), np.float16))
    assert (ground_ratio(field.transfer, environment_harmonics(dark, 6))[0] == 1.0).all()


@pytest.fixture
def on_the_ground(renderer: Renderer, scenes: Any) -> Renderer:
    renderer.set_environment(scenes.constant())
    renderer.set_material("paint", scenes.weights(kd=0.8))
    renderer.set_mesh([scenes.sphere(rings=24)])
    return renderer


ABOVE = Camera(azimuth_deg=0.0, elevation_deg=30.0, distance=1.5, target=(0.0, 0.0, 0.0))


def test_the_shadow_on_the_ground(on_the_ground: Renderer) -> None:
    on_the_ground.set_ground(ground_field())
    open_view = replace(view(PLAIN), camera=ABOVE)
    shadow_view = replace(open_view, surface_look=replace(PLAIN, ground=True))
    before, after = (on_the_ground.linear_image(v, SIZE)[..., :3] for v in (open_view, shadow_view))
    ratio = after / before
    assert ratio.max() <= 1.002
    assert (np.abs(ratio[0] - 1.0) < 2e-3).all()  # the top of the picture is beyond the field
    camera = on_the_ground.camera_matrices(open_view, SIZE)
    for point, wanted in (((0.2, -0.1, 0.15), 0.5), ((0.35, -0.1, -0.35), 1.0), ((0.0, 0.1, 0.0), 1.0)):
        clip = camera.world_to_clip @ [*point, 1.0]
        x, y = clip[:2] / clip[3]
        pixel = ratio[int((1 - y) / 2 * SIZE[1]), int((x + 1) / 2 * SIZE[0])]
        assert pixel == pytest.approx(wanted, abs=0.02), point


def test_without_a_ground_and_from_below_nothing_is_darkened(on_the_ground: Renderer) -> None:
    wanted = replace(view(PLAIN), camera=ABOVE)
    asked = replace(wanted, surface_look=replace(PLAIN, ground=True))
    assert np.array_equal(on_the_ground.render_image(asked, SIZE), on_the_ground.render_image(wanted, SIZE))
    on_the_ground.set_ground(ground_field())
    below = replace(ABOVE, elevation_deg=-30.0)
    pictures = [on_the_ground.render_image(replace(v, camera=below), SIZE) for v in (asked, wanted)]
    assert np.array_equal(*pictures)
    on_the_ground.set_ground(None)
    assert np.array_equal(on_the_ground.render_image(asked, SIZE), on_the_ground.render_image(wanted, SIZE))


def test_the_texture_is_written_only_when_the_light_changes(on_the_ground: Renderer) -> None:
    on_the_ground.set_ground(ground_field())
    asked = replace(view(replace(PLAIN, ground=True)), camera=ABOVE)
    on_the_ground.render_image(asked, SIZE)
    made, written = on_the_ground.counters.total_created, on_the_ground.counters.texture_uploads
    on_the_ground.render_image(replace(asked, camera=replace(ABOVE, azimuth_deg=5.0)), SIZE)
    assert on_the_ground.counters.texture_uploads == written
    on_the_ground.render_image(replace(asked, rotation_deg=40.0), SIZE)
    assert on_the_ground.counters.texture_uploads == written + 1
    assert on_the_ground.counters.total_created == made


def test_a_ground_without_extent_is_refused() -> None:
    with pytest.raises(ValueRangeError, match="ground"):
        replace(ground_field(), high=(-0.6, 0.4))
    with pytest.raises(ValueRangeError, match="squared"):
        replace(ground_field(), transfer=np.zeros((4, 4, 5)))
