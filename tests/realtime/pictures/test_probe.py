"""One pixel of the picture, and the point of the surface that it shows."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from brdf_suite.documents.view import Camera, View
from brdf_suite.documents.view_settings import PartMaterial, SurfaceLook
from brdf_suite.geometry.directions import angle_between
from brdf_suite.realtime.pictures.probe import PixelProbe, SurfacePoint, geometry_picture

SIZE = (61, 40)
CAMERA = Camera(azimuth_deg=20.0, elevation_deg=15.0, distance=0.6, target=(0.0, 0.0, 0.0))
VIEW = View(camera=CAMERA, exposure_ev=1.0)


@pytest.fixture
def probe(renderer, scenes) -> PixelProbe:
    renderer.set_environment(
        scenes.from_function(lambda d: 0.3 + 0.25 * np.stack([d[..., 0], d[..., 1], -d[..., 0]], -1))
    )
    ground = scenes.sheet("neutral", half=0.4, centre=(0.0, 0.0, -0.3))
    renderer.set_mesh([ground, scenes.sphere(rings=96)])
    renderer.set_material("paint", scenes.weights(kd=0.7, gloss=0.05))
    renderer.set_material("paint_b", scenes.weights(kd=0.2))
    return PixelProbe(renderer)


PIXELS = [(0, 0), (60, 39), (30, 20), (27, 12), (36, 27), (33, 20), (31, 31)]


@pytest.mark.parametrize("pixel", PIXELS)
def test_the_radiance_is_that_of_the_whole_picture(probe, renderer, pixel) -> None:
    whole = renderer.linear_image(VIEW, SIZE)
    found = probe.at(VIEW, SIZE, pixel)
    np.testing.assert_allclose(found.radiance, whole[pixel[1], pixel[0], :3], rtol=2e-3, atol=1e-5)
    assert found.coverage == pytest.approx(whole[pixel[1], pixel[0], 3], abs=1e-3)


def test_the_point_and_its_normal_are_those_of_the_sphere(probe, renderer, scenes) -> None:
    normals, to_viewer = scenes.sphere_normals(renderer, VIEW, SIZE)
    seen = 0
    for pixel in PIXELS[2:]:
        exact = normals[pixel[1], pixel[0]]
        if not np.isfinite(exact).all():
            continue
        point = probe.at(VIEW, SIZE, pixel).point
        assert (point.part, point.material) == ("paint sphere", "paint")
        np.testing.assert_allclose(point.position, 0.1 * exact, atol=1e-3)
        np.testing.assert_allclose(point.normal, exact, atol=2e-2)
        np.testing.assert_allclose(point.to_viewer, to_viewer[pixel[1], pixel[0]], atol=1e-3)
        assert point.view_angle_deg == pytest.approx(
            np.degrees(angle_between(exact, to_viewer[pixel[1], pixel[0]])), abs=1.0
        )
        seen += 1
    assert seen >= 3


def test_beside_the_surface_there_is_a_radiance_and_no_point(probe) -> None:
    view = replace(VIEW, camera=replace(VIEW.camera, distance=3.0, target=(0.0, 0.0, 0.0)))
    found = probe.at(view, SIZE, (1, 1))
    assert found.point is None
    assert found.coverage == 0.0
    assert min(found.radiance) > 0.0


def test_the_nearest_part_is_named(probe) -> None:
    behind = probe.at(replace(VIEW, camera=Camera(azimuth_deg=180.0)), SIZE, (30, 20)).point
    assert behind.material == "neutral"
    assert behind.normal == pytest.approx((0.0, 0.0, -1.0), abs=1e-6)


def test_the_material_is_the_one_that_the_view_gives_the_part(probe) -> None:
    look = SurfaceLook(materials=(PartMaterial("paint sphere", "chrome"),))
    assert probe.at(replace(VIEW, surface_look=look), SIZE, (30, 20)).point.material == "chrome"


def test_the_second_paint_is_read_with_its_own_weights(probe) -> None:
    first = probe.at(VIEW, SIZE, (30, 20))
    second = probe.at(VIEW, SIZE, (30, 20), materials={"paint": "paint_b"})
    assert second.radiance[1] < 0.5 * first.radiance[1]
    assert second.point == first.point


def test_a_pixel_outside_is_the_nearest_one_inside(probe) -> None:
    assert probe.at(VIEW, SIZE, (-5, 400)) == probe.at(VIEW, SIZE, (0, 39))


def test_reading_makes_no_objects_after_the_first_time(probe, renderer) -> None:
    probe.at(VIEW, SIZE, (30, 20))
    made = renderer.counters.total_created
    for pixel in PIXELS:
        probe.at(VIEW, SIZE, pixel)
    assert renderer.counters.total_created == made


def test_aspecular_angles() -> None:
    up = (0.0, 0.0, 1.0)
    half = 0.5**0.5
    point = SurfacePoint((0.0, 0.0, 0.0), up, (0.0, half, half), "hood", "paint")
    assert point.view_angle_deg == pytest.approx(45.0)
    assert point.aspecular_deg((0.0, -half, half)) == pytest.approx(0.0, abs=1e-6)
    assert point.aspecular_deg(up) == pytest.approx(45.0)
    assert point.aspecular_deg((0.0, half, half)) == pytest.approx(90.0)
    assert point.aspecular_deg((0.0, 0.0, -1.0)) is None


def test_the_parts_of_a_picture_are_those_of_its_geometry(probe, renderer) -> None:
    found = probe.parts(VIEW, SIZE)
    np.testing.assert_array_equal(found, geometry_picture(renderer, VIEW, SIZE).parts)
    assert set(np.unique(found)) == {-1, 0, 1}
