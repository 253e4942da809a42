"""Glare of drawn pictures: as the eye scatters it, without new light, and not where light is measured."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from brdf_suite.appearance.colour.colorimetry import srgb_encode
from brdf_suite.appearance.glare import pixel_angle, scattered_light, spread_glare
from brdf_suite.documents.view import SENSOR_WIDTH_MM, Camera, View
from brdf_suite.realtime.pictures.display import LINEAR, Display
from brdf_suite.realtime.pictures.glare import GlarePass
from brdf_suite.realtime.pictures.tone_curves import display_light

EXACT = Display(dithered=False)
VIEW = View(Camera(30, 15), tone_curve="linear", glare="eye")


def light_of(renderer, pixels: np.ndarray):
    """A texture of exposed light (h, w, 3), top row first."""
    height, width = pixels.shape[:2]
    texture = renderer.objects.texture((width, height), "f4")
    padded = np.concatenate([pixels, np.ones((height, width, 1))], axis=-1)
    texture.write(np.ascontiguousarray(padded[::-1], np.float32).tobytes())
    return texture


def finished(renderer, pixels: np.ndarray, view: View, region=None) -> np.ndarray:
    height, width = pixels.shape[:2]
    framebuffer = renderer.objects.framebuffer(renderer.objects.texture((width, height), "f4"))
    framebuffer.clear()
    renderer.finish(
        view, light_of(renderer, pixels), framebuffer, (width, height), region=region, display=EXACT
    )
    read = np.frombuffer(framebuffer.read(components=3, dtype="f4"), np.float32)
    return read.reshape(height, width, 3)[::-1]


def test_what_is_spread_is_what_is_taken(renderer) -> None:
    pixels = np.full((512, 512, 3), 0.3)
    pixels[250:253, 260:262] = [4000.0, 2000.0, 100.0]
    view = replace(VIEW, camera=replace(VIEW.camera, focal_length_mm=8.0))
    veil = GlarePass(renderer.objects).spread(light_of(renderer, pixels), view)
    read = np.frombuffer(veil.texture.read(), np.float32).reshape(-1, 4)[:, :3]
    pixels_each = veil.size[0] * veil.size[1] / len(read)
    spread = read.sum(axis=0) * pixels_each
    taken = veil.share * np.maximum(pixels - 1.0, 0.0).sum(axis=(0, 1))
    np.testing.assert_allclose(spread, taken, rtol=1e-3)
    assert 0.05 < veil.share < 0.5


def test_the_veil_is_that_of_the_eye(renderer) -> None:
    pixels = np.zeros((360, 640, 3))
    pixels[180, 200] = 8000.0
    angle = pixel_angle(50.0, 640, SENSOR_WIDTH_MM)
    found = finished(renderer, pixels, VIEW)
    expected = srgb_encode(display_light(spread_glare(pixels, angle), 0.0, "linear"))
    far = np.hypot(*(np.indices((360, 640)) - np.array([180, 200])[:, None, None])) * angle
    for low, high in ((0.6, 1.0), (1.0, 2.0), (2.0, 5.0), (5.0, 15.0)):
        ring = (far >= low) & (far < high)
        assert found[ring].mean() == pytest.approx(expected[ring].mean(), rel=0.12), low
    assert found[180, 200].min() > 0.9999
    assert scattered_light(0.6) * np.radians(angle) ** 2 * 8000.0 > 0.05  # the rings are not black


def test_where_light_is_measured_or_marked_there_is_none(renderer, scenes) -> None:
    renderer.set_environment(scenes.constant(4.0))
    renderer.set_mesh([scenes.sphere()])
    renderer.set_material("paint", scenes.weights(kd=0.02))
    plain = replace(VIEW, glare="off")
    size = (120, 80)
    without, with_glare = (renderer.render_image(view, size) for view in (plain, VIEW))
    paint = without.max(axis=-1) < 200
    assert paint.any()
    assert (with_glare[paint].astype(int) >= without[paint]).all()
    assert with_glare[paint].mean() > without[paint].mean() + 5.0  # the background dazzles
    lines = [renderer.render_image(view, size, display=LINEAR) for view in (plain, VIEW)]
    np.testing.assert_array_equal(*lines)
    marked = [renderer.render_image(replace(view, clipping_marks=True), size) for view in (plain, VIEW)]
    np.testing.assert_array_equal(*marked)
    clear = [renderer.render_image(view, size, transparent=True) for view in (plain, VIEW)]
    np.testing.assert_array_equal(*clear)


def test_tiles_share_one_veil(renderer, scenes) -> None:
    renderer.set_environment(scenes.constant(3.0))
    renderer.set_mesh([scenes.sphere()])
    renderer.set_material("paint", scenes.weights(kd=0.02))
    size = (240, 150)
    whole = renderer.render_image(VIEW, size)
    tiled = renderer.render_image(VIEW, size, largest_tile=64)
    away = np.abs(tiled.astype(int) - whole)
    assert away.mean() < 1.0  # from a smaller picture
    assert np.quantile(away, 0.99) <= 4


def test_light_outside_a_region_does_not_dazzle_in_it(renderer) -> None:
    pixels = np.full((80, 120, 3), 0.1)
    pixels[40, 100] = 5000.0
    left = finished(renderer, pixels, VIEW, region=(0, 0, 60, 80))[:, :60]
    np.testing.assert_allclose(left, srgb_encode(0.1 * np.ones((80, 60, 3))), atol=1e-4)
    right = finished(renderer, pixels, VIEW, region=(60, 0, 60, 80))[:, 60:]
    assert right.min() > srgb_encode(np.full(3, 0.1))[0] + 0.001


@pytest.mark.parametrize("size", [(1, 1), (2, 1), (3, 2), (5, 40)])
def test_pictures_of_a_few_pixels_are_drawn(renderer, scenes, size) -> None:
    renderer.set_environment(scenes.constant(3.0))
    renderer.set_mesh([])
    assert renderer.render_image(VIEW, size).shape == (size[1], size[0], 3)
