"""Shadow of the environment's sun: where it falls, how soft it is, what light it takes, and when there is none."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from brdf_suite.documents.view import Camera, View
from brdf_suite.documents.view_settings import LightColour, SurfaceLook
from brdf_suite.geometry.low_harmonics import low_harmonics
from brdf_suite.realtime.environment.ground import ground_ratio
from brdf_suite.realtime.lights.block import NO_LIGHTS, DistantLights
from brdf_suite.realtime.lights.sun import find_sun
from brdf_suite.realtime.values import GroundField

SIZE = (161, 161)
FLOOR, ROOF, HEIGHT = 0.5, 0.1, 0.2
STRENGTH, KD = 1.5, 0.6
VIEW = View(Camera(25.0, 10.0, 1.2, (0.0, 0.0, 0.0), 40.0), background="grey", fresnel="off")


def lights(direction=(0.0, 0.0, 1.0), spread: float = 0.004, strength: float = STRENGTH) -> DistantLights:
    """A broad strong light, and a small one."""
    aside = (1.0, 0.0, 0.0)
    return DistantLights(
        np.array([aside, direction]), np.array([[9.0] * 3, [strength] * 3]), np.array([0.4, spread])
    )


def light_of(part, open_share: float = 1.0):
    """The part with a known share of the light that arrives."""
    one = np.concatenate([part.normals * (2.0 / 3.0), np.full((len(part.normals), 1), open_share)], axis=1)
    return replace(part, light=np.concatenate([one, one], axis=1).astype(np.float16))


def floor_radiance(renderer, scenes, found: DistantLights, view: View = VIEW, open_share: float = 1.0):
    """Radiance of the floor's visible pixels, and their places (n, 2) there."""
    renderer.set_environment(scenes.constant(1.0), lambda: found)
    floor = light_of(scenes.sheet("paint", FLOOR), open_share)
    roof = light_of(scenes.sheet("roof", ROOF, (0.0, 0.0, HEIGHT)))
    renderer.set_mesh([floor, roof])
    renderer.set_material("paint", scenes.weights(kd=KD))
    renderer.set_material("roof", scenes.weights(kd=0.0))
    picture = renderer.linear_image(view, SIZE, 1)
    camera = renderer.camera_matrices(view, SIZE)
    rays = scenes.rays(camera, SIZE)
    at = camera.eye + rays * (-camera.eye[2] / rays[..., 2])[..., None]
    over = camera.eye + rays * ((HEIGHT - camera.eye[2]) / rays[..., 2])[..., None]
    hidden = (np.abs(over[..., :2]) < ROOF + 0.01).all(axis=-1)
    on_floor = (np.abs(at[..., :2]) < FLOOR - 0.02).all(axis=-1) & ~hidden & (picture[..., 3] > 0.99)
    return picture[on_floor][:, 0], at[on_floor][:, :2]


def test_what_the_sun_does_not_see_lacks_its_light(renderer, scenes) -> None:
    radiance, at = floor_radiance(renderer, scenes, lights())
    inside, outside = (np.abs(at).max(axis=1) < 0.09), (np.abs(at).max(axis=1) > 0.11)
    assert inside.sum() > 100
    np.testing.assert_allclose(radiance[outside], KD, rtol=2e-3)
    np.testing.assert_allclose(radiance[inside], KD * (1.0 - STRENGTH / np.pi), rtol=2e-3)


def test_a_slanting_sun_and_a_turned_one(renderer, scenes) -> None:
    slant = np.array([0.6, 0.0, 0.8])
    for found, view in (
        (lights(slant), VIEW),
        (lights(np.array([0.8, 0.0, -0.6])), replace(VIEW, rotation_deg=-90.0)),
    ):
        radiance, at = floor_radiance(renderer, scenes, found, view)
        across = at - (slant[:2] / slant[2] * -HEIGHT)
        inside, outside = (np.abs(across).max(axis=1) < 0.09), (np.abs(across).max(axis=1) > 0.11)
        np.testing.assert_allclose(radiance[outside], KD, rtol=2e-3)
        np.testing.assert_allclose(radiance[inside], KD * (1.0 - slant[2] * STRENGTH / np.pi), rtol=2e-3)


def test_a_broad_sun_has_a_soft_shadow(renderer, scenes) -> None:
    spread = 0.05
    radiance, at = floor_radiance(renderer, scenes, lights(spread=spread))
    seen = 1.0 - (KD - radiance) / (KD * STRENGTH / np.pi)
    beyond = np.abs(at[:, 0]) - ROOF
    edge = np.abs(at[:, 1]) < ROOF - 0.04
    radius = 2.0 * spread * HEIGHT
    # Of an even disc: the share on one side of a chord.
    x = np.clip(beyond[edge] / radius, -1.0, 1.0)
    expected = 0.5 + (x * np.sqrt(1.0 - x**2) + np.arcsin(x)) / np.pi
    assert np.abs(seen[edge] - expected).mean() < 0.03
    assert np.abs(seen[edge] - expected).max() < 0.2
    assert (np.abs(beyond[edge]) < 0.5 * radius).sum() > 20


def test_where_occlusion_darkens_the_sun_is_put_back(renderer, scenes) -> None:
    share = 0.4
    radiance, at = floor_radiance(renderer, scenes, lights(), open_share=share)
    outside, inside = (np.abs(at).max(axis=1) > 0.11), (np.abs(at).max(axis=1) < 0.09)
    sun = STRENGTH / np.pi
    np.testing.assert_allclose(radiance[outside], KD * (share * (1.0 - sun) + sun), rtol=4e-3)
    np.testing.assert_allclose(radiance[inside], KD * share * (1.0 - sun), rtol=4e-3)


@pytest.mark.parametrize(
    "view",
    [
        replace(VIEW, surface_look=SurfaceLook(occlusion=False)),
        replace(VIEW, light_colour=LightColour(brightness=0.0)),
    ],
)
def test_without_occlusion_or_light_there_is_no_shadow(renderer, scenes, view: View) -> None:
    radiance, _ = floor_radiance(renderer, scenes, lights(), view)
    assert np.ptp(radiance) < 1e-3


def test_which_light_is_a_sun() -> None:
    mean = np.ones(3)
    sun = find_sun(lights(), mean)
    assert sun is not None
    np.testing.assert_array_equal(sun.direction, [0.0, 0.0, 1.0])
    assert find_sun(lights(spread=0.1), mean) is None
    assert find_sun(lights(strength=0.1), mean) is None
    assert find_sun(NO_LIGHTS, mean) is None


def test_a_captured_form_has_the_same_shadow(renderer, scenes) -> None:
    floor_radiance(renderer, scenes, lights())
    whole = renderer.render_image(VIEW, (80, 80), 1)
    from brdf_suite.realtime.pictures.captured import CapturedPaint

    with_shadow = renderer.capture(VIEW, (80, 80), 1)
    try:
        (found,) = with_shadow.draw([CapturedPaint(scenes.weights(kd=KD), None)])
    finally:
        with_shadow.release()
    assert np.abs(found.astype(int) - whole).max() <= 2
    assert whole.std() > 5


def test_the_ground_knows_the_share_of_its_sun() -> None:
    degree = 6
    up = np.array([0.0, 1.0, 0.0])
    d = np.random.default_rng(0).normal(size=(200_000, 3))
    d /= np.linalg.norm(d, axis=1, keepdims=True)
    one = 4 * np.pi * (np.maximum(d[:, 1], 0.0)[:, None] * low_harmonics(d, degree)).mean(axis=0)
    transfer = np.broadcast_to(one, (4, 4, len(one))).astype(np.float32).copy()
    transfer[2, 2] *= 0.25
    sun = low_harmonics(up, degree)[:, None] * np.full(3, STRENGTH)
    sky = np.zeros_like(sun)
    sky[0] = np.sqrt(4 * np.pi)
    rest, share, full = ground_ratio(transfer, sky + sun, sun)
    assert share == pytest.approx(np.full(3, STRENGTH / (STRENGTH + np.pi)), rel=0.1)
    np.testing.assert_allclose(rest[0, 0] + share, 1.0)
    np.testing.assert_allclose(full, np.pi + STRENGTH, rtol=0.1)
    np.testing.assert_allclose(rest[2, 2] / rest[0, 0], 0.25, rtol=1e-5)
    whole, none, _ = ground_ratio(transfer, sky + sun)
    np.testing.assert_allclose(none, 0.0, atol=1e-12)
    assert whole[0, 0] == pytest.approx(1.0)


@pytest.mark.parametrize("elevation_deg", [12.0, 50.0])
def test_a_shadow_on_the_ground_ends_where_that_of_the_form_does(
    renderer, scenes, elevation_deg: float
) -> None:
    """A ball over open ground: the ground is dark within its shadow, however long, and nowhere else."""
    radius, low, high = 0.1, (-0.3, -0.3), (0.3, 0.3)
    tall = np.radians(elevation_deg)
    towards = np.array([np.cos(tall), np.sin(tall), 0.0])
    d = np.random.default_rng(0).normal(size=(100_000, 3))
    d /= np.linalg.norm(d, axis=1, keepdims=True)
    harmonics = low_harmonics(d, 6)
    one = 4 * np.pi * (np.maximum(d[:, 1], 0.0)[:, None] * harmonics).mean(axis=0)
    transfer = np.broadcast_to(one, (8, 8, len(one))).astype(np.float32)
    renderer.set_environment(scenes.constant(1.0), lambda: lights(towards, strength=8.0))
    renderer.set_mesh([light_of(scenes.sphere("paint", radius))])
    renderer.set_ground(GroundField(-radius, low, high, transfer))
    renderer.set_material("paint", scenes.weights(kd=KD))
    camera = Camera(20.0, 60.0, 3.0, (-0.2, -0.1, 0.0), 40.0)
    view = View(camera, surface_look=SurfaceLook(ground=True))
    size = (200, 140)
    picture = renderer.linear_image(view, size, 1)
    matrices = renderer.camera_matrices(view, size)
    rays = scenes.rays(matrices, size)
    at = matrices.eye + rays * ((-radius - matrices.eye[1]) / rays[..., 1])[..., None]
    ground = picture[..., 3] < 0.01
    # A ball's shadow: places whose ray to the sun comes nearer than its radius to its middle.
    along = at @ towards
    far = np.sqrt(np.maximum((at**2).sum(axis=-1) - along**2, 0.0))
    inside = ground & (far < 0.9 * radius) & (along < 0.0)
    outside = ground & ((far > 1.1 * radius) | (along > 0.0))
    assert inside.sum() > 40
    assert picture[inside][:, 0].max() < 0.8
    np.testing.assert_allclose(picture[outside][:, 0], 1.0, atol=0.01)
