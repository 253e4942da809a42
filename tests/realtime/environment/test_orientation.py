"""Where the light comes from: one bright spot, seen directly and in a mirror, turned and not."""

from __future__ import annotations

import numpy as np
import pytest

from brdf_suite.documents.view import Camera, View

SIZE = (192, 144)


def spot(direction):
    d = np.asarray(direction) / np.linalg.norm(direction)
    return lambda w: np.where((w @ d)[..., None] > np.cos(np.radians(4)), 1.0, 0.0) * np.ones(3)


def turned(direction, degrees):
    """Counter-clockwise seen from above: +z goes to +x."""
    a = np.radians(degrees)
    x, y, z = np.asarray(direction) / np.linalg.norm(direction)
    return np.array([np.cos(a) * x + np.sin(a) * z, y, np.cos(a) * z - np.sin(a) * x])


def brightest(image):
    level = image.astype(float).sum(-1)
    rows, columns = np.nonzero(level > 0.5 * level.max())
    return rows.mean(), columns.mean()


@pytest.mark.parametrize("rotation", [0.0, 90.0, -35.0])
@pytest.mark.parametrize("direction", [(0, 0, 1), (1, 0.2, 0.1), (-0.4, -0.3, -1), (0.1, 0.9, 0.3)])
def test_background(renderer, scenes, direction, rotation):
    """A camera that looks at where the spot must be sees it in the middle of its picture."""
    renderer.set_environment(scenes.from_function(spot(direction), 128))
    expected = turned(direction, rotation)
    # The camera looks against its own direction: a little off, so that left and right, up and down count.
    azimuth = np.degrees(np.arctan2(-expected[0], -expected[2])) + 6
    elevation = np.degrees(np.arcsin(-expected[1])) + 4
    view = View(Camera(azimuth, elevation), rotation_deg=rotation, tone_curve="linear")
    row, column = brightest(renderer.render_image(view, SIZE))
    ray = scenes.rays(renderer.camera_matrices(view, SIZE), SIZE)[round(row), round(column)]
    assert np.degrees(np.arccos(min(1.0, ray @ expected))) < 1.0


@pytest.mark.parametrize("rotation", [0.0, 90.0, -35.0])
@pytest.mark.parametrize("direction", [(0, 0, 1), (1, 0.2, 0.1), (0.1, 0.9, 0.3)])
def test_mirror(renderer, scenes, direction, rotation):
    """The brightest point of a mirror ball reflects the view into the direction of the spot."""
    renderer.set_environment(scenes.from_function(spot(direction), 256))
    renderer.set_mesh([scenes.sphere()])
    renderer.set_material("paint", scenes.weights(gloss=0.9, coat="none"))
    expected = turned(direction, rotation)
    azimuth = np.degrees(np.arctan2(expected[0], expected[2])) + 40
    view = View(Camera(azimuth, 10), rotation_deg=rotation, tone_curve="linear", background="grey")
    n, v = scenes.sphere_normals(renderer, view, SIZE)
    image = renderer.render_image(view, SIZE)
    image[~np.isfinite(n[..., 0])] = 0
    row, column = (round(c) for c in brightest(image))
    normal, to_viewer = n[row, column], v[row, column]
    reflected = 2 * (normal @ to_viewer) * normal - to_viewer
    assert np.degrees(np.arccos(min(1.0, reflected @ expected))) < 3.0


def test_first_row_is_the_top(renderer, scenes):
    renderer.set_environment(scenes.from_function(lambda d: np.where(d[..., 1:2] > 0, 1.0, 0.0) * np.ones(3)))
    image = renderer.render_image(View(Camera(0, 0), tone_curve="linear"), (64, 48))
    assert image[:20].min() > 200
    assert image[-20:].max() < 10


def test_no_seams_between_faces(renderer, scenes):
    """A smooth sky drawn from tiny faces stays smooth across their edges: filtering does not stop at an edge."""
    renderer.set_environment(
        scenes.from_function(lambda d: (0.5 + 0.4 * d[..., 0:1] + 0.05 * d[..., 2:3]) * np.ones(3), 4)
    )
    image = renderer.render_image(View(Camera(45, 0, focal_length_mm=20), tone_curve="linear"), (256, 64))
    step = np.abs(np.diff(image[32].astype(int), axis=0)).max()
    assert step <= 4
