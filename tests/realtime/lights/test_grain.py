"""Grain of a full population of flakes: what it needs of an environment, and that it follows the light."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from brdf_suite.documents.paint import Flakes
from brdf_suite.documents.view import Camera, View
from brdf_suite.documents.view_settings import LightColour, Sparkle
from brdf_suite.realtime.lights.block import NO_LIGHTS
from brdf_suite.realtime.lights.mosaic import thinned_contrast
from brdf_suite.realtime.lights.tilt_light import EXPONENTS, SIZE, tilt_light
from brdf_suite.realtime.values import MeshPart

SILVER = Flakes(900.0, 38.0, 0.153)
SIZE_PX = (200, 200)


def test_even_light_has_no_variance(scenes):
    moments = tilt_light(scenes.constant(3.0), NO_LIGHTS)
    assert moments.shape == (len(EXPONENTS), SIZE, SIZE, 2)
    np.testing.assert_allclose(moments[..., 0], 3.0, rtol=2e-3)
    np.testing.assert_allclose(moments[..., 1], 9.0, rtol=4e-3)


def test_half_a_room_has_the_variance_of_two_even_halves(scenes):
    maps = scenes.constant(1.0)
    dark = [replace(faces, faces=faces.faces.copy()) for faces in maps.lobes]
    for faces in dark:
        faces.faces[3] = 0.0  # below
        for side in (0, 1, 4, 5):
            faces.faces[side, faces.size // 2 :] = 0.0
    moments = tilt_light(replace(maps, lobes=tuple(dark)), NO_LIGHTS)
    middle = SIZE // 2
    # At the horizon, the edge of the octahedral square's diamond: +x.
    mean, square = moments[2, middle, SIZE - 1]
    assert mean == pytest.approx(0.5, abs=0.05)
    assert square == pytest.approx(0.5, abs=0.05)
    np.testing.assert_allclose(moments[4, middle, middle], 1.0, rtol=0.02)  # above


def test_few_flakes_have_more_contrast_than_many():
    assert thinned_contrast(1.0) == 1.0
    assert thinned_contrast(0.25) > 2.0


@pytest.fixture
def sheet(renderer, scenes):
    """Return a function that draws grain near a sheet over the smooth picture, minus 1."""
    corners = np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]]) * 0.05
    part = MeshPart(
        "sheet",
        "paint",
        corners,
        np.tile([0.0, 0.0, 1.0], (4, 1)),
        np.array([[0, 1, 2], [0, 2, 3]]),
        1e3 * corners[:, :2],
    )
    renderer.set_environment(scenes.constant(1.0))
    renderer.set_mesh([part])
    renderer.set_material("paint", scenes.weights(kd=0.02, directional=0.5))

    def draw(distance=0.03, flakes=SILVER, **changes):
        renderer.set_flakes("paint", flakes)
        view = View(Camera(0, 0, distance, (0.0, 0.0, 0.0), 60.0), fresnel="off", **changes)
        grain, smooth = (
            renderer.linear_image(replace(view, sparkle=Sparkle(mode)), SIZE_PX, samples=1)[..., :3]
            for mode in ("glints", "off")
        )
        return grain.astype(float) / smooth - 1.0

    return draw


def test_an_even_sky_leaves_the_grain_of_depths_and_areas(sheet):
    change = sheet()
    assert 0.05 < change.std() < 0.5
    assert abs(change.mean()) < 0.02
    assert sheet(distance=1.0).std() < 0.1 * change.std()
    assert sheet(flakes=None).std() == 0.0


def test_grain_takes_brightness_and_colour_of_the_light(sheet):
    plain = sheet()
    bright = sheet(light_colour=LightColour(brightness=3.0))
    np.testing.assert_allclose(bright, plain, atol=2e-3)
    warm = sheet(light_colour=LightColour("A", adapted=False))
    np.testing.assert_allclose(warm, plain, atol=0.02 + 0.1 * np.abs(plain).max())
