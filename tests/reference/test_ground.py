"""The ground and the backdrop of a traced picture."""

from __future__ import annotations

import numpy as np
import pytest

from brdf_suite.documents.view import Camera, View
from brdf_suite.documents.view_settings import SurfaceLook
from brdf_suite.geometry.cube_map import texel_directions
from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.latlong import column_angles, direction, ring_angles
from brdf_suite.pipeline.material import Material
from brdf_suite.reflectance.models.lambertian import Lambertian
from brdf_suite.tracing.reference.scene import build_reference

pytestmark = pytest.mark.usefixtures("variant")
SIZE = (40, 30)


def light_of(function) -> Environment:
    d = direction(ring_angles(16)[:, None], column_angles(32)[None])
    return Environment("light", np.asarray(function(d) * np.ones(3), np.float32))


def made(environment, sphere, *, ground: bool, reflectance=None, **changes):
    view = View(surface="sphere", surface_look=SurfaceLook(ground=ground), **changes)
    return build_reference(Material("test", reflectance or Lambertian(0.5)), view, SIZE, environment, sphere)


def test_the_shadow_of_a_sphere_in_even_light_is_its_form_factor(sphere) -> None:
    """Of a sphere of radius r that touches the ground, at a distance d: r³ / (d² + r²)^(3/2)."""
    scene = made(light_of(lambda d: 2.0 + 0.0 * d[..., :1]), sphere, ground=True)
    points = sphere.parts[0].positions.astype(float)
    low, high = points.min(0), points.max(0)
    centre, radius = 0.5 * (low + high), 0.5 * (high[1] - low[1])
    ground = scene.ground
    ground.trace(scene.traced.scene, 64)
    assert ground.height == pytest.approx(low[1])
    distance = radius * np.array([0.3, 0.7, 1.2, 2.0])
    eye = np.array([centre[0], low[1] + 5.0, centre[2]])
    down = np.stack([distance, np.full(4, -5.0), np.zeros(4)], axis=-1)
    found = ground.seen_from(eye, down)
    wanted = 1.0 - radius**3 / (distance**2 + radius**2) ** 1.5
    np.testing.assert_allclose(found, np.repeat(wanted[:, None], 3, 1), atol=0.04)
    # Above the horizon, and from below the ground, nothing is darkened.
    assert (ground.seen_from(eye, -down) == 1.0).all()
    assert (ground.seen_from(np.array([0.0, low[1] - 1.0, 0.0]), down) == 1.0).all()


def test_the_object_stands_in_its_shadow_and_the_camera_sees_no_plane(sphere) -> None:
    from brdf_suite.reference.passes import trace

    environment = light_of(lambda d: 1.0 + 0.0 * d[..., :1])
    camera = Camera(0.0, 2.0)
    with_ground = made(environment, sphere, ground=True, camera=camera)
    without = made(environment, sphere, ground=False, camera=camera)
    one, two = (trace(scene.traced, samples=32) for scene in (with_ground, without))
    np.testing.assert_allclose(one.coverage, two.coverage, atol=0.15)
    assert one.coverage[0, 0] == 0.0
    assert one.coverage[-1, 0] == 0.0
    inside = (one.coverage == 1.0) & (two.coverage == 1.0)
    rows = np.flatnonzero(inside.any(axis=1))
    top = inside & (np.arange(SIZE[1]) < rows[len(rows) // 4])[:, None]
    bottom = inside & (np.arange(SIZE[1]) > rows[-len(rows) // 6])[:, None]
    assert one.radiance[top].mean() == pytest.approx(two.radiance[top].mean(), rel=0.02)
    assert one.radiance[bottom].mean() < 0.8 * two.radiance[bottom].mean()
    # Behind the object too: darker below it, as it is far away.
    assert with_ground.behind[-1].min() < 0.9
    np.testing.assert_allclose(with_ground.behind[0], without.behind[0], rtol=1e-5)
    assert with_ground.key != without.key


def test_the_shadow_lies_where_no_light_comes_from(sphere) -> None:
    """A light from +x: dark on the side of -x, and the other way round where it is turned by half a turn."""
    environment = light_of(lambda d: np.exp(20.0 * (d @ np.array([0.8, 0.6, 0.0]) - 1.0))[..., None])
    dark = []
    for rotation in (0.0, 180.0):
        scene = made(environment, sphere, ground=True, rotation_deg=rotation)
        share = scene.ground.share.mean(axis=-1)
        middle = share.shape[1] // 2
        dark.append((share[:, :middle].mean(), share[:, middle:].mean()))
    assert dark[0][0] < dark[0][1] - 0.01
    assert dark[1][1] < dark[1][0] - 0.01


def test_a_blurred_backdrop_is_the_light_through_a_lobe(sphere) -> None:
    """A lobe of exponent E lowers the first harmonic by (E + 1)/(E + 2), and the second by that times E/(E + 3)."""
    camera = Camera(0.0, 0.0, 3.0, (0.0, 0.0, 0.0), 20.0)

    def light(d):
        y = d[..., 1:2]
        return 1.0 + 0.5 * y + 0.4 * (1.5 * y * y - 0.5)

    sharp = made(light_of(light), sphere, ground=False, camera=camera, background="environment").behind
    scene = made(light_of(light), sphere, ground=False, camera=camera, background="blurred")
    rows = (
        (0.5 - (np.arange(SIZE[1]) + 0.5) / SIZE[1]) * 2.0 * scene.eye.half_width_tangent * SIZE[1] / SIZE[0]
    )
    y = rows / np.sqrt(rows * rows + 1.0)
    wanted = 1.0 + 0.5 * y * 61 / 62 + 0.4 * (1.5 * y * y - 0.5) * 60 / 63
    np.testing.assert_allclose(scene.behind[:, SIZE[0] // 2, 1], wanted, atol=0.012)
    assert np.abs(sharp - scene.behind).max() > 0.005
    assert not any("blurred" in notice for notice in scene.notices)


def test_a_look_up_of_a_cube_gives_its_texels() -> None:
    from brdf_suite.reference.scene.backdrop import sample_cube

    faces = np.random.default_rng(1).random((6, 5, 5, 3)).astype(np.float32)
    np.testing.assert_allclose(sample_cube(faces, 3.0 * texel_directions(5)), faces, atol=1e-5)
