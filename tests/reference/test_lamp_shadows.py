"""Shadows of lamps: real time and both tracers against what a ball hides of an even disc, and against each other."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from brdf_suite.documents.view import Camera, View
from brdf_suite.documents.view_settings import Lamp, Sparkle, SurfaceLook
from brdf_suite.files.images.environments import write_exr
from brdf_suite.files.meshes.occlusion_cache import baked_occlusion
from brdf_suite.fitting.lobes.basis import default_basis
from brdf_suite.fitting.lobes.weights import LobeWeights
from brdf_suite.pipeline.material import Material
from brdf_suite.pipeline.paint_angles import material_weights
from brdf_suite.pipeline.picture import OffscreenScene
from brdf_suite.pipeline.scene import load_environment
from brdf_suite.realtime.camera import Bounds, matrices
from brdf_suite.reference.passes import trace
from brdf_suite.surface.mesh import Mesh, PartGeometry
from brdf_suite.tracing.raytraced.picture import Quality, RaytracedSession
from brdf_suite.tracing.reference.scene import build_reference

pytestmark = pytest.mark.usefixtures("variant")
SIZE = (72, 54)
BALL = np.array([0.0, 0.35, 0.0])
RADIUS = 0.15
POINT = Lamp("point", position=(0.5, 1.6, 0.0), strength=2.0, diameter=0.3)
DISTANT = Lamp("directional", azimuth_deg=90.0, elevation_deg=60.0, strength=1.0, angle_deg=12.0)
LAMPS = {
    "point": replace(POINT, diameter=0.0),
    "ball": POINT,
    "direction": replace(DISTANT, angle_deg=0.0),
    "disc": DISTANT,
}
VIEW = View(
    Camera(0.0, 60.0, 2.4, (0.0, 0.0, 0.0), 50.0),
    surface="sphere",
    background="grey",
    sparkle=Sparkle("off"),
    fresnel="off",
)
LOBES = np.array(default_basis().exponents)
NONE = np.zeros((len(LOBES), 3))
GREY = Material("grey", LobeWeights(LOBES, np.full(3, 0.1 / np.pi), NONE, NONE, 0.0, 1.0))


def floor_and_ball(sphere: Mesh) -> Mesh:
    """A grey floor at y = 0, and a ball over it."""
    part = sphere.parts[0]
    points = part.positions.astype(float)
    middle, size = 0.5 * (points.min(0) + points.max(0)), np.ptp(points, axis=0).max()
    ball = replace(part, positions=(points - middle) * (2.0 * RADIUS / size) + BALL, material="paint")
    corners = np.array([[-1, 0, -1], [-1, 0, 1], [1, 0, 1], [1, 0, -1]]) * 0.8
    up = np.tile([0.0, 1.0, 0.0], (4, 1))
    flat = PartGeometry("floor", "paint", corners, up, corners[:, [0, 2]] * 1e3, [[0, 1, 2], [0, 2, 3]])
    return Mesh("floor and ball", (flat, ball))


def floor_places(size=SIZE, height: float = 0.0):
    """Where a level at some height is seen (h, w, 3), and which pixels see nothing else (h, w)."""
    bounds = Bounds.of([np.array([[-0.8, 0.0, -0.8], [0.8, 0.5, 0.8]])])
    m = matrices(VIEW.camera, bounds, size)
    x, y = np.meshgrid(
        (np.arange(size[0]) + 0.5) * 2 / size[0] - 1, 1 - (np.arange(size[1]) + 0.5) * 2 / size[1]
    )
    rays = (
        np.stack([x * m.half_tangents[0], y * m.half_tangents[1], -np.ones_like(x)], -1) @ m.view_to_world.T
    )
    at = m.eye - rays * ((m.eye[1] - height) / rays[..., 1])[..., None]
    to_ball = BALL - m.eye
    along = (rays @ to_ball) / np.linalg.norm(rays, axis=-1)
    apart = np.sqrt(np.maximum(to_ball @ to_ball - along**2, 0.0))
    return at, (np.abs(at[..., [0, 2]]) < 0.75).all(axis=-1) & (apart > RADIUS + 0.03)


def seen_share(lamp: Lamp, at):
    """What places (n, 3) see of an even disc past the ball: the mean over many places of the disc."""
    k = np.arange(4000) + 0.5
    radius, turn = np.sqrt(k / len(k)), k * np.pi * (3 - np.sqrt(5))
    found = []
    for place in at:
        if lamp.kind == "point":
            way = np.array(lamp.position) - place
            extent = 0.5 * lamp.diameter
        else:
            a, e = np.radians([lamp.azimuth_deg, lamp.elevation_deg])
            way = np.array([np.cos(e) * np.sin(a), np.sin(e), np.cos(e) * np.cos(a)])
            extent = np.radians(0.5 * lamp.angle_deg)
        right = np.cross([0.0, 0.0, 1.0], way)
        right /= np.linalg.norm(right)
        up = np.cross(way, right) / np.linalg.norm(way)
        to = way + extent * radius[:, None] * (np.cos(turn)[:, None] * right + np.sin(turn)[:, None] * up)
        to /= np.linalg.norm(to, axis=1, keepdims=True)
        middle = BALL - place
        along = to @ middle
        hidden = (along > 0.0) & (middle @ middle - along**2 < RADIUS**2)
        found.append(1.0 - hidden.mean())
    return np.array(found)


@pytest.fixture(scope="module")
def scene_mesh(sphere) -> Mesh:
    return floor_and_ball(sphere)


@pytest.fixture(scope="module")
def dark(tmp_path_factory):
    """A light so dim that lamps are alone, prepared for real time."""
    path = tmp_path_factory.mktemp("dark") / "dark.exr"
    write_exr(path, np.full((16, 32, 3), 1e-6, np.float32))
    return load_environment(path)


@pytest.fixture(scope="module")
def drawn(scene_mesh, dark):
    """Draw the floor and the ball in a view, radiance and coverage (h, w, 4)."""
    with OffscreenScene() as scene:
        scene.set_environment(dark)
        scene.set_surface(scene_mesh, baked_occlusion(scene_mesh))
        scene.renderer.set_material("paint", material_weights(GREY.reflectance))
        yield lambda view: scene.renderer.linear_image(view, SIZE)


@pytest.mark.parametrize("kind", LAMPS)
def test_the_shadow_of_a_ball_on_a_floor(drawn, dark, scene_mesh, kind: str) -> None:
    lamp = LAMPS[kind]
    view = replace(VIEW, lamps=(lamp,))
    at, floor = floor_places()
    expected = seen_share(lamp, at[floor])
    assert (expected < 0.05).sum() > 20
    open_view = replace(view, surface_look=SurfaceLook(occlusion=False))
    with_shadow, without = (drawn(v)[floor][:, 1] for v in (view, open_view))
    scene = build_reference(GREY, view, SIZE, dark.environment, scene_mesh)
    traced = trace(scene.traced, samples=128, samples_per_pass=64).radiance[floor][:, 1]
    session = RaytracedSession()
    session.show(GREY, view, SIZE, Quality(1, 16, 1), environment=dark.environment, mesh=scene_mesh)
    rays = session.frame().sums.radiance[floor][:, 1]
    for found in (with_shadow / without, traced / without, rays / without):
        error = np.abs(found - expected)
        assert error.mean() < 0.006
        # The edge of a sharp shadow crosses pixels.
        assert np.sqrt((error**2).mean()) < (0.02 if kind in ("ball", "disc") else 0.045)


@pytest.mark.parametrize("kind", ["ball", "disc"])
def test_the_ground_is_lit_by_lamps_and_in_their_shadow(scene_mesh, dark, kind: str) -> None:
    """The ball alone over a ground: beside the lamp the environment is nothing, and all of its light is the lamp's."""
    lamp = LAMPS[kind]
    look = SurfaceLook(ground=True)
    view = replace(VIEW, lamps=(lamp,), surface_look=look, background="environment")
    ball = Mesh("ball", (scene_mesh.parts[1],))
    height = BALL[1] - RADIUS
    at, floor = floor_places(height=height)
    expected = seen_share(lamp, at[floor])
    assert (expected < 0.1).sum() > 20
    with OffscreenScene() as scene:
        scene.set_environment(dark)
        scene.set_surface(ball, baked_occlusion(ball))
        scene.renderer.set_material("paint", material_weights(GREY.reflectance))
        real_time = scene.renderer.linear_image(view, SIZE)[floor][:, 1] / 1e-6
        assert scene.renderer.mesh.hides_nothing
    path = build_reference(GREY, view, SIZE, dark.environment, ball)
    session = RaytracedSession()
    shown = session.show(GREY, view, SIZE, Quality(16, 16, 1), environment=dark.environment, mesh=ball)
    rays = shown.behind[floor][:, 1] / 1e-6 * (1.0 - session.frame().sums.darkness[floor][:, 1])
    for found, bound in ((real_time, 0.01), (path.behind[floor][:, 1] / 1e-6, 0.03), (rays, 0.01)):
        assert np.abs(found - expected).mean() < bound


def test_a_lamp_with_an_extent_has_a_larger_highlight(sphere, dark) -> None:
    """A disc of 5 degrees, broader than the coat's lobe: as bright and as large as path traced."""
    gloss = NONE.copy()
    gloss[-4] = 0.04 * (LOBES[-4] + 1.0) / (2.0 * np.pi)
    coat = Material("coat", LobeWeights(LOBES, np.full(3, 0.01), NONE, gloss, 0.0, 1.0))
    lamp = Lamp("directional", azimuth_deg=30.0, elevation_deg=20.0, angle_deg=5.0)
    view = replace(VIEW, camera=Camera(0.0, 0.0), lamps=(lamp,))
    size = (160, 120)
    with OffscreenScene() as scene:
        scene.set_environment(dark)
        scene.set_surface(sphere)
        scene.renderer.set_material("paint", material_weights(coat.reflectance))
        one = replace(view, lamps=(replace(lamp, angle_deg=0.0),))
        drawn, sharp = (
            np.prod(scene.renderer.linear_image(v, size)[..., [1, 3]], axis=-1) for v in (view, one)
        )
    path = build_reference(coat, view, size, dark.environment, sphere)
    traced = trace(path.traced, samples=256, samples_per_pass=64).radiance[..., 1]
    assert drawn.max() < 0.7 * sharp.max()
    assert drawn.max() == pytest.approx(traced.max(), rel=0.1)
    assert drawn.sum() == pytest.approx(traced.sum(), rel=0.05)
