"""An environment of few texels as the background: enlarged smoothly, and as it is where it is not enlarged."""

from __future__ import annotations

import numpy as np
import pytest

from brdf_suite.documents.view import Camera, View

SIZE = (320, 240)
TEXELS = 16


def chequered(directions):
    """Every texel black or white, at random: all of its frequencies at once."""
    random = np.random.default_rng(4)
    return np.repeat(random.integers(0, 2, (*directions.shape[:-1], 1)).astype(float), 3, axis=-1)


def drawn(renderer, view):
    return renderer.linear_image(view, SIZE, 1)[..., 0].astype(float)


@pytest.mark.parametrize("azimuth", [0.0, 44.0, 90.0])  # the middle of two faces, and the edge between them
def test_an_enlarged_map_has_no_corners(renderer, scenes, azimuth):
    """Between texels brightness bends evenly: its slope never jumps, as it does at each texel of a bilinear picture."""
    renderer.set_environment(scenes.from_function(chequered, TEXELS))
    view = View(Camera(azimuth, 3.0), tone_curve="linear")
    tangents = renderer.camera_matrices(view, SIZE).half_tangents
    assert SIZE[1] / (tangents[1] * TEXELS) > 8.0  # pixels a texel
    picture = drawn(renderer, view)
    slope = np.diff(picture, axis=1)
    jump = np.abs(np.diff(slope, axis=1))
    assert np.abs(slope).max() > 0.01  # there is something to see
    # Over p pixels a texel the B-spline's slope turns by some 2/p of itself in each; a straight line's at once.
    assert jump.max() < 0.3 * np.abs(slope).max()
    assert picture.min() >= 0.0
    assert picture.max() <= 1.001


def test_the_light_of_a_lamp_stays(renderer, scenes):
    """One bright texel gets no dark rim, and its sum is that of the texel."""
    place = (4, 7, 8)  # on +z

    def lamp(directions):
        made = np.full(directions.shape, 0.5)
        made[place] = 100.5
        return made

    renderer.set_environment(scenes.from_function(lamp, TEXELS))
    toward = scenes.directions(TEXELS)[place]
    view = View(
        Camera(np.degrees(np.arctan2(-toward[0], -toward[2])), np.degrees(np.arcsin(-toward[1]))),
        tone_curve="linear",
    )
    picture = drawn(renderer, view)
    assert picture.min() >= 0.499
    rays = scenes.rays(renderer.camera_matrices(view, SIZE), SIZE)
    tangents = renderer.camera_matrices(view, SIZE).half_tangents
    # Area on the face at distance 1 of each pixel, in texels: cos³ to the picture's middle over cos³ to the face's.
    middle = rays[SIZE[1] // 2, SIZE[0] // 2]
    pixel = 4.0 * tangents[0] * tangents[1] / (SIZE[0] * SIZE[1])
    area = pixel * (rays @ middle) ** 3 / np.abs(rays[..., 2]) ** 3
    assert ((picture - 0.5) * area).sum() * (TEXELS / 2) ** 2 == pytest.approx(100.0, rel=0.02)


def test_a_fine_map_stays_sharp(renderer, scenes):
    """With a texel or more in each pixel a step between texels stays a step."""

    def step(directions):
        return np.where(directions[..., :1] > 0.0, 1.0, 0.0) * np.ones(3)

    renderer.set_environment(scenes.from_function(step, 1024))
    picture = drawn(renderer, View(Camera(180.0, 0.0), tone_curve="linear"))
    width = [np.count_nonzero((row > 0.02) & (row < 0.98)) for row in picture]
    assert max(width) <= 2
