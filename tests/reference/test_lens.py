"""Depth of field and the blur of a turn: real time against geometry, and against the path tracer's thin lens."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from brdf_suite.documents.view import Camera, View
from brdf_suite.documents.view_settings import Lamp, Lens, Sparkle
from brdf_suite.files.images.environments import write_exr
from brdf_suite.fitting.lobes.basis import default_basis
from brdf_suite.fitting.lobes.weights import LobeWeights
from brdf_suite.lighting.latlong import column_angles, direction, ring_angles
from brdf_suite.output.exposures import exposures_of, focused
from brdf_suite.pipeline.material import Material
from brdf_suite.pipeline.paint_angles import material_weights
from brdf_suite.pipeline.picture import OffscreenScene
from brdf_suite.pipeline.scene import load_environment
from brdf_suite.realtime.camera import Bounds
from brdf_suite.realtime.pictures.display import LINEAR
from brdf_suite.reference.passes import trace
from brdf_suite.surface.mesh import Mesh, PartGeometry
from brdf_suite.tracing.reference.scene import build_reference

pytestmark = pytest.mark.usefixtures("variant")
SIZE = (72, 48)
LOBES = np.array(default_basis().exponents)
NONE = np.zeros((len(LOBES), 3))
GREY = Material("grey", LobeWeights(LOBES, np.full(3, 0.1), NONE, NONE, 0.0, 1.0))
VIEW = View(
    Camera(0.0, 0.0, 1.0, (0.0, 0.0, 0.0), 50.0), surface="sphere", fresnel="off", sparkle=Sparkle("off")
)


def sheet(name: str, left: float, right: float, half: float, depth: float) -> PartGeometry:
    """A sheet that looks along +z."""
    corners = np.array(
        [[left, -half, depth], [right, -half, depth], [right, half, depth], [left, half, depth]]
    )
    facing = np.tile([0.0, 0.0, 1.0], (4, 1))
    return PartGeometry(
        name, "paint", corners, facing, corners[:, :2] * 1e3, np.array([[0, 1, 2], [0, 2, 3]])
    )


NEAR_AND_FAR = Mesh("sheets", (sheet("near", -0.3, -0.02, 0.2, 0.0), sheet("far", 0.05, 0.9, 0.5, -1.0)))


@pytest.fixture(scope="module")
def light(tmp_path_factory):
    d = direction(ring_angles(32)[:, None], column_angles(64)[None])
    path = tmp_path_factory.mktemp("light") / "smooth.exr"
    write_exr(path, np.asarray(1.0 + 0.6 * d, np.float32))
    return load_environment(path)


@pytest.fixture(scope="module")
def draw(light):
    """Draw the sheets: linear radiance and coverage (h, w, 4)."""
    with OffscreenScene() as scene:
        scene.set_environment(light)
        scene.set_surface(NEAR_AND_FAR)
        scene.renderer.set_material("paint", material_weights(GREY.reflectance))

        def drawn(view: View, count: int = 96, size=SIZE, **more):
            shots = exposures_of(view, scene.renderer.bounds, size, count)
            return np.concatenate(list(scene.renderer.strips(view, size, **more, exposures=shots)))

        yield drawn


def test_without_blur_the_picture_is_the_same_to_the_last_bit(draw) -> None:
    assert exposures_of(VIEW, Bounds.of([]), SIZE, 64) == ()
    still = replace(VIEW, lens=Lens(0.0, 3.0))
    assert (draw(still) == draw(VIEW)).all()


def test_places_of_the_opening_and_moments_do_not_follow_each_other() -> None:
    blurred = replace(VIEW, lens=Lens(1.4, 1.0, 20.0))
    shots = exposures_of(blurred, Bounds.of([]), SIZE, 256)
    moments = np.array([shot.view.camera.azimuth_deg for shot in shots])
    places = np.array([(shot.lens.right, shot.lens.up) for shot in shots])
    assert np.ptp(moments) > 19.0
    angles = np.arctan2(places[:, 1], places[:, 0])
    for follows in (*places.T, np.cos(2.0 * angles), np.sin(2.0 * angles)):
        assert abs(np.corrcoef(moments, follows)[0, 1]) < 0.1


def test_a_transparent_picture_has_the_objects_colour_up_to_its_blurred_edges(draw) -> None:
    view = replace(VIEW, lens=Lens(2.0, 1.0), tone_curve="aces")
    picture = draw(view, 64, (720, 40), transparent=True).astype(float)[20] / 255.0
    alpha = picture[:, 3]
    edge, whole = (alpha > 0.2) & (alpha < 0.8), alpha > 0.99
    assert edge.sum() >= 4
    # The sheets are lit evenly along the row, but for the light's slow change.
    assert abs(picture[edge, :3].mean() / picture[whole, :3].mean() - 1.0) < 0.02


def test_the_focus_is_on_what_the_middle_shows() -> None:
    def focus(view: View) -> float | None:
        return focused(replace(view, lens=Lens(2.0)), NEAR_AND_FAR, SIZE).lens.focus_distance

    assert focus(replace(VIEW, camera=replace(VIEW.camera, target=(-0.1, 0.0, 0.0)))) == pytest.approx(1.0)
    assert focus(replace(VIEW, camera=replace(VIEW.camera, target=(0.3, 0.0, 0.0)))) == pytest.approx(2.0)
    assert focus(VIEW) == pytest.approx(1.0)  # between both: the target
    assert focused(VIEW, NEAR_AND_FAR, SIZE) is VIEW
    given = replace(VIEW, lens=Lens(2.0, 5.0))
    assert focused(given, NEAR_AND_FAR, SIZE) is given


def test_an_edge_is_as_blurred_as_the_circle_of_confusion(draw) -> None:
    """At twice the focused distance a place is spread over a disc, as wide as half the opening seen there."""
    f_number = 2.0
    view = replace(VIEW, lens=Lens(f_number, 1.0))
    size = (720, 40)
    coverage = draw(view, 256, size, display=LINEAR)[20, :, 3]
    width = 2.0 * 0.36
    x = (np.arange(size[0]) + 0.5) / size[0] * width - 0.5 * width  # at 1 m
    near = (x > -0.06) & (x < 0.0)
    np.testing.assert_allclose(coverage[near], x[near] < -0.02, atol=0.5)
    assert ((coverage[near] > 0.05) & (coverage[near] < 0.95)).sum() <= 2
    # The far edge, at 2 m and x = .05: seen at .025 of the sharp plane, spread over a radius of a half of the lens's.
    radius = 0.5 * 0.5 * 0.05 / f_number
    far = np.abs(x - 0.025) < 2.0 * radius
    beyond = np.clip((x[far] - 0.025) / radius, -1.0, 1.0)
    expected = 0.5 + (beyond * np.sqrt(1.0 - beyond**2) + np.arcsin(beyond)) / np.pi
    assert np.abs(coverage[far] - expected).max() < 0.06
    assert ((expected > 0.1) & (expected < 0.9)).sum() > 6


def test_the_lens_of_the_path_tracer_gives_the_same_picture(draw, light) -> None:
    view = replace(VIEW, lens=Lens(0.7, 1.0), background="environment")
    scene = build_reference(GREY, view, SIZE, light.environment, NEAR_AND_FAR)
    estimate = trace(scene.traced, samples=256, samples_per_pass=64)
    drawn = draw(view, 128, display=LINEAR)[..., :3]
    traced = scene.whole(estimate)
    sharp = draw(replace(view, lens=Lens()), display=LINEAR)[..., :3]
    error = np.sqrt(((drawn - traced) ** 2).mean()) / traced.mean()
    without = np.sqrt(((sharp - traced) ** 2).mean()) / traced.mean()
    assert error < 0.03
    assert without > 2.0 * error


def test_the_turn_of_the_path_tracer_gives_the_same_picture(draw, light) -> None:
    lamp = Lamp("point", position=(0.4, 0.8, 1.0), strength=1.0)
    sun = Lamp("directional", azimuth_deg=30.0, elevation_deg=40.0, strength=1.0)
    disc = replace(lamp, diameter=0.2)
    for lamps in ((), (lamp,), (sun, disc)):
        view = replace(VIEW, lens=Lens(turn_deg=8.0), background="environment", lamps=lamps)
        scene = build_reference(GREY, view, SIZE, light.environment, NEAR_AND_FAR)
        estimate = trace(scene.traced, samples=256)
        assert estimate.passes >= 64
        drawn = draw(view, 128, display=LINEAR)[..., :3]
        traced = scene.whole(estimate)
        still = draw(replace(view, lens=Lens()), display=LINEAR)[..., :3]
        error = np.sqrt(((drawn - traced) ** 2).mean()) / traced.mean()
        without = np.sqrt(((still - traced) ** 2).mean()) / traced.mean()
        assert error < 0.03
        assert without > 2.0 * error


def test_a_turn_blurs_what_moves_in_the_middle_of_the_exposure(draw) -> None:
    still = draw(VIEW, display=LINEAR)
    view = replace(VIEW, lens=Lens(turn_deg=8.0))
    blurred = draw(view, 64, display=LINEAR)
    shots = exposures_of(view, Bounds.of(part.positions for part in NEAR_AND_FAR.parts), SIZE, 64)
    turns = [shot.view.rotation_deg for shot in shots]
    assert np.mean(turns) == pytest.approx(0.0, abs=1e-9)
    assert max(turns) - min(turns) == pytest.approx(8.0 * 63 / 64)
    each = [draw(replace(shot.view, lens=Lens()), display=LINEAR) for shot in shots]
    np.testing.assert_allclose(blurred, np.mean(each, axis=0), atol=2e-3)
    assert np.abs(blurred - still).max() > 0.2


def test_tiles_make_no_difference_to_a_blurred_picture(draw) -> None:
    view = replace(VIEW, lens=Lens(0.7, 1.0), exposure_ev=1.0, glare="off")
    whole, tiled = draw(view, 16), draw(view, 16, largest_tile=32)
    assert np.abs(whole.astype(int) - tiled).max() <= 1
    assert whole.dtype == np.uint8
