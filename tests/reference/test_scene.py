"""One scene for both renderers: orientation, exposure, lamps, backdrops; each against the real-time picture."""

from __future__ import annotations

import numpy as np
import pytest

from brdf_suite.documents.view import Camera, View
from brdf_suite.documents.view_settings import Lamp, LightColour, PartMaterial, SurfaceLook
from brdf_suite.errors import UnreachableError
from brdf_suite.files.images.environments import write_exr
from brdf_suite.fitting.lobes.weights import LobeWeights
from brdf_suite.geometry.directions import aspecular_view, illumination
from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.latlong import column_angles, direction, ring_angles, sample
from brdf_suite.pipeline.material import Material, load_material, under_illuminant
from brdf_suite.pipeline.paint_angles import material_weights
from brdf_suite.reflectance.designed.coat_lobe import CoatLobe
from brdf_suite.reflectance.models.lambertian import Lambertian
from brdf_suite.tracing.reference.scene import ReferenceScene, build_reference

pytestmark = pytest.mark.usefixtures("variant")
SIZE = (48, 40)


def coloured(height: int = 32) -> Environment:
    """A smooth light that differs in every direction: red along x, green along y, blue along z."""
    d = direction(ring_angles(height)[:, None], column_angles(2 * height)[None])
    return Environment("coloured", (1.0 + 0.8 * d).astype(np.float32))


def even(value: float = 1.0) -> Environment:
    return Environment("even", np.full((8, 16, 3), value, np.float32))


def scene(reflectance, environment, sphere, **changes) -> ReferenceScene:
    view = View(surface="sphere", **changes)
    return build_reference(Material("test", reflectance), view, SIZE, environment, sphere)


def traced(made: ReferenceScene, samples: int = 64):
    from brdf_suite.reference.passes import trace

    return trace(made.traced, samples=samples, samples_per_pass=samples // 2)


def test_mitsubas_look_up_of_a_map_is_ours(variant) -> None:
    """Random pixels, so that half a row or column of displacement would show, and the poles."""
    import mitsuba as mi

    from brdf_suite.reference.scene.scene import mitsuba_map

    rng = np.random.default_rng(3)
    pixels = rng.random((9, 18, 3)).astype(np.float32)
    light = mi.load_dict({"type": "envmap", "bitmap": mi.Bitmap(mitsuba_map(pixels))})
    world = rng.normal(size=(4000, 3))
    world /= np.linalg.norm(world, axis=1)[:, None]
    si = mi.SurfaceInteraction3f()
    si.wi = mi.Vector3f(np.ascontiguousarray(-world.T, np.float32))
    found = np.array(light.eval(si)).T
    # Single precision places the seam of the columns to 1e-6 of the map.
    assert np.abs(found - sample(pixels, world)).max() < 2e-4


@pytest.mark.parametrize(
    ("rotation", "camera"), [(0.0, Camera(0, 0)), (70.0, Camera(130, 35)), (-20.0, Camera(250, -40))]
)
def test_the_background_is_that_of_the_real_time_picture(sphere, rotation, camera) -> None:
    """The very light of each direction: what the camera sees through the middle of a pixel, by the view's own axes."""
    from brdf_suite.realtime.camera import Bounds, matrices

    environment = coloured()
    made = scene(Lambertian(0.5), environment, sphere, rotation_deg=rotation, camera=camera)
    m = matrices(made.view.camera, Bounds.of(p.positions for p in sphere.parts), SIZE)
    turn = np.radians(rotation)
    x, y = np.meshgrid(
        (np.arange(SIZE[0]) + 0.5) * 2 / SIZE[0] - 1, 1 - (np.arange(SIZE[1]) + 0.5) * 2 / SIZE[1]
    )
    local = np.stack([x * m.half_tangents[0], y * m.half_tangents[1], -np.ones_like(x)], -1)
    world = local @ m.view_to_world.T
    world /= np.linalg.norm(world, axis=-1)[..., None]
    inverse = np.array([[np.cos(turn), 0, -np.sin(turn)], [0, 1, 0], [np.sin(turn), 0, np.cos(turn)]])
    wanted = 1.0 + 0.8 * (world @ inverse.T)
    assert np.abs(made.behind - wanted).max() < 0.01


@pytest.mark.parametrize(("rotation", "camera"), [(0.0, Camera(35, 7)), (70.0, Camera(130, 35))])
def test_a_mirror_ball_shows_what_lies_in_the_mirror_direction(sphere, rotation, camera) -> None:
    """By geometry alone: the ball's normal at a pixel, the mirrored view, the light from there."""
    from brdf_suite.realtime.camera import Bounds, matrices

    made = scene(CoatLobe(3.0, 0.001), coloured(), sphere, rotation_deg=rotation, camera=camera)
    estimate = traced(made, 256)
    points = sphere.parts[0].positions.astype(float)
    centre, radius = 0.5 * (points.min(0) + points.max(0)), 0.5 * np.ptp(points, axis=0).max()
    m = matrices(made.view.camera, Bounds.of([sphere.parts[0].positions]), SIZE)
    turn = np.radians(rotation)
    checked = 0
    for row, column in ((12, 20), (20, 30), (28, 18), (20, 24), (15, 28)):
        local = np.array(
            [
                ((column + 0.5) * 2 / SIZE[0] - 1) * m.half_tangents[0],
                (1 - (row + 0.5) * 2 / SIZE[1]) * m.half_tangents[1],
                -1.0,
            ]
        )
        ray = m.view_to_world @ local
        ray /= np.linalg.norm(ray)
        to = m.eye - centre
        along = -ray @ to - np.sqrt((ray @ to) ** 2 - to @ to + radius**2)
        normal = (to + along * ray) / radius
        away = ray - 2 * (ray @ normal) * normal
        env = np.array(
            [
                np.cos(turn) * away[0] - np.sin(turn) * away[2],
                away[1],
                np.sin(turn) * away[0] + np.cos(turn) * away[2],
            ]
        )
        found = estimate.radiance[row, column]
        light = 1.0 + 0.8 * env
        # Fresnel scales all channels alike: the colour identifies the direction.
        np.testing.assert_allclose(found / found.sum(), light / light.sum(), atol=0.02)
        assert estimate.coverage[row, column] == 1.0
        checked += 1
    assert checked == 5


def test_a_matt_ball_in_even_light_has_its_albedo(sphere) -> None:
    estimate = traced(scene(Lambertian(np.array([0.2, 0.5, 0.8])), even(2.0), sphere))
    inside = estimate.coverage == 1.0
    np.testing.assert_allclose(estimate.radiance[inside].mean(axis=0), [0.4, 1.0, 1.6], rtol=0.01)
    assert inside.sum() > 300
    assert estimate.coverage[0, 0] == 0.0


def test_the_same_lobes_give_the_real_time_picture(sphere, tmp_path) -> None:
    """A material of broad lobes, drawn by both: what is left is the real-time look-up."""
    from brdf_suite.fitting.lobes.basis import default_basis
    from brdf_suite.pipeline.picture import OffscreenScene
    from brdf_suite.pipeline.scene import load_environment

    write_exr(tmp_path / "coloured.exr", coloured().radiance)
    prepared = load_environment(tmp_path / "coloured.exr")
    exponents = default_basis().exponents
    kdd = np.zeros((len(exponents), 3))
    kdd[1] = (0.3, 0.2, 0.1)
    weights = LobeWeights(np.array(exponents), np.array([0.1, 0.15, 0.2]), kdd, 0.0 * kdd, 0.0, 1.0)
    view = View(surface="sphere", rotation_deg=40.0, background="grey")
    made = build_reference(Material("lobes", weights), view, SIZE, prepared.environment, sphere)
    estimate = traced(made, 512)
    with OffscreenScene() as real:
        real.set_environment(prepared)
        real.set_surface(sphere)
        real.renderer.set_material("paint", material_weights(weights))
        drawn = real.renderer.linear_image(made.view, SIZE)
    inside = (estimate.coverage == 1.0) & (drawn[..., 3] == 1.0)
    ratio = drawn[inside][:, :3] / estimate.radiance[inside]
    assert abs(ratio.mean() - 1.0) < 0.02
    assert np.quantile(np.abs(ratio - 1.0), 0.9) < 0.04


def test_lamps_light_as_they_say(sphere) -> None:
    """A white matt surface that faces a lamp of strength 1, at 1 m from a point lamp, gets radiance 1."""
    from brdf_suite.appearance.light.matrix import lamp_colour

    camera = Camera(0, 0)
    points = sphere.parts[0].positions.astype(float)
    front = float(points[:, 2].max())
    for lamp in (
        Lamp("directional", azimuth_deg=0.0, elevation_deg=0.0, strength=1.0),
        Lamp("point", position=(0.0, float(points[:, 1].mean()), front + 1.0), strength=1.0),
    ):
        made = scene(Lambertian(1.0), even(0.0), sphere, camera=camera, lamps=(lamp,))
        middle = traced(made).radiance[
            SIZE[1] // 2 - 1 : SIZE[1] // 2 + 1, SIZE[0] // 2 - 1 : SIZE[0] // 2 + 1
        ]
        np.testing.assert_allclose(middle.mean(axis=(0, 1)), lamp_colour(lamp.temperature_k), rtol=0.02)


def test_exposure_tone_curve_and_light_colour_are_the_views(sphere) -> None:
    made = scene(Lambertian(0.5), even(), sphere, exposure_ev=-1.0, tone_curve="linear", background="grey")
    estimate = traced(made)
    codes = made.codes(estimate)
    assert abs(int(codes[SIZE[1] // 2, SIZE[0] // 2].mean()) - 137) <= 1  # 0.25 encoded
    assert codes[0, 0].tolist() == [118] * 3  # 18 % grey, whatever the exposure
    warm = scene(Lambertian(0.5), even(), sphere, light_colour=LightColour("A", adapted=False))
    red, _, blue = traced(warm).radiance[SIZE[1] // 2, SIZE[0] // 2]
    assert red > 2.5 * blue


def test_automatic_exposure_meters_the_object(sphere) -> None:
    made = scene(Lambertian(0.5), even(8.0), sphere, exposure_mode="automatic")
    estimate = traced(made)
    assert made.exposed_view(estimate).exposure_ev == pytest.approx(np.log2(0.18 / 4.0), abs=0.02)


def test_a_scene_is_reported_by_what_its_light_depends_on(sphere) -> None:
    first = scene(Lambertian(0.5), even(), sphere)
    assert first.key == scene(Lambertian(0.5), even(), sphere, exposure_ev=3.0, tone_curve="linear").key
    others = [
        scene(Lambertian(0.4), even(), sphere),
        scene(Lambertian(0.5), even(2.0), sphere),
        scene(Lambertian(0.5), even(), sphere, rotation_deg=5.0),
    ]
    assert len({first.key, *(other.key for other in others)}) == 4


def test_parts_are_of_the_material_that_the_view_gives_them(sphere) -> None:
    """Chrome instead of a black paint, and another scene for kept estimates."""
    look = SurfaceLook(materials=(PartMaterial(sphere.parts[0].name, "chrome"),))
    black = scene(Lambertian(0.0), even(), sphere)
    made = scene(Lambertian(0.0), even(), sphere, surface_look=look)
    assert made.key != black.key
    found = traced(made, 8)
    assert found.radiance[found.coverage > 0.999].mean() > 0.3


class Glowing:
    """Sends back three times the light that it gets."""

    def __init__(self, value: float) -> None:
        self.value = value

    def eval(self, wi, wo):
        wi, wo = np.broadcast_arrays(np.asarray(wi, float), np.asarray(wo, float))
        above = (wi[..., 2:] > 0.0) & (wo[..., 2:] > 0.0)
        return np.where(above, self.value / np.pi, 0.0) * np.array([0.1, 1.0, 0.2])


def test_a_paint_that_reflects_more_than_it_gets_is_reported_and_traced(sphere) -> None:
    made = scene(Glowing(3.0), even(), sphere)
    (reported,) = (notice for notice in made.notices if "sends back" in notice)
    assert "300 % of the green light" in reported
    found = traced(made, 8)
    assert found.radiance[found.coverage == 1.0][:, 1].mean() == pytest.approx(3.0, rel=0.02)
    assert not any("sends back" in notice for notice in scene(Lambertian(0.9), even(), sphere).notices)


def test_a_paint_without_numbers_is_refused(sphere) -> None:
    for value in (np.nan, -1.0):
        with pytest.raises(UnreachableError, match="brdf-suite check"):
            scene(Glowing(value), even(), sphere)


def test_what_is_drawn_otherwise_is_reported(sphere) -> None:
    view = View(surface="sphere", fresnel="off", surface_look=SurfaceLook(occlusion=False))
    notices = " ".join(build_reference(Material("t", Lambertian(0.5)), view, SIZE, even(), sphere).notices)
    assert "Fresnel" in notices
    assert "always shows the shadows" in notices
    assert not scene(Lambertian(0.5), even(), sphere).notices


def test_a_paint_with_spectra_is_traced_in_the_lamp(shared_data) -> None:
    material = load_material(shared_data / "brdf" / "krylon_blue.brdf")
    reflectance = material.reflectance
    assert under_illuminant(material, View().light_colour) is material
    under = under_illuminant(material, LightColour("A")).reflectance
    wi, wo = illumination(45.0), aspecular_view(45.0, 45.0)
    assert np.abs(under.eval(wi, wo) / reflectance.eval(wi, wo) - 1.0).max() > 0.01
