"""Layouts of environment images: each is drawn from a known light by formulas of its own and converted back."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from brdf_suite.documents.view import Camera
from brdf_suite.errors import Cancelled, ValueRangeError
from brdf_suite.lighting.latlong import column_angles, direction, ring_angles
from brdf_suite.lighting.layouts import LAYOUTS, as_latlong, detect_layout


def light(d: np.ndarray) -> np.ndarray:
    """A smooth light that differs in every direction: three channels of low degree."""
    x, y, z = d[..., 0], d[..., 1], d[..., 2]
    return np.stack([1.5 + x + 0.3 * y * z, 1.5 + y - 0.2 * x * z, 1.5 + z + 0.1 * x], axis=-1)


def _normalised(d: np.ndarray) -> np.ndarray:
    return d / np.linalg.norm(d, axis=-1, keepdims=True)


def _grid(size: int) -> tuple[np.ndarray, np.ndarray]:
    """Places to the right and down, -1…1, of the pixels of a square image."""
    centres = (2.0 * np.arange(size) + 1.0) / size - 1.0
    return centres[None, :] + 0.0 * centres[:, None], centres[:, None] + 0.0 * centres[None, :]


def cube_face(look: str, size: int) -> np.ndarray:
    """What a camera with a square view of 90° sees, upright, as seen from inside; right of the front is -x."""
    a, b = _grid(size)
    one = np.ones_like(a)
    forward = {
        "front": (-a, -b, one),
        "back": (a, -b, -one),
        "right": (-one, -b, -a),
        "left": (one, -b, a),
        "up": (-a, one, b),
        "down": (-a, -one, -b),
    }[look]
    return light(_normalised(np.stack(forward, axis=-1))).astype(np.float32)


def drawn(layout: str, size: int) -> np.ndarray:
    """The light in a layout: ``size`` is the side of a face, or of the square."""
    if layout == "latlong":
        return light(direction(ring_angles(size)[:, None], column_angles(2 * size)[None, :])).astype(
            np.float32
        )
    if layout in ("angular", "mirror_ball", "dome"):
        a, b = _grid(size)
        radius, turn = np.hypot(a, b), np.arctan2(-b, a)
        inside = np.minimum(radius, 1.0)
        if layout == "dome":
            theta = inside * np.pi / 2
            d = np.stack(
                [-np.sin(theta) * np.cos(turn), np.cos(theta), -np.sin(theta) * np.sin(turn)], axis=-1
            )
        else:
            theta = inside * np.pi if layout == "angular" else 2.0 * np.arcsin(inside)
            d = np.stack(
                [-np.sin(theta) * np.cos(turn), np.sin(theta) * np.sin(turn), -np.cos(theta)], axis=-1
            )
        return light(d).astype(np.float32)
    faces = {look: cube_face(look, size) for look in ("front", "back", "right", "left", "up", "down")}
    order = ["right", "left", "up", "down", "front", "back"]
    if layout == "horizontal_strip":
        return np.concatenate([faces[look] for look in order], axis=1)
    if layout == "vertical_strip":
        return np.concatenate([faces[look] for look in order], axis=0)
    if layout == "exr_cube":
        return exr_cube(size)
    middle = {"up": (0, 1), "left": (1, 0), "front": (1, 1), "right": (1, 2), "down": (2, 1)}
    places = middle | {"back": (1, 3) if layout == "horizontal_cross" else (3, 1)}
    rows, columns = (3, 4) if layout == "horizontal_cross" else (4, 3)
    image = np.zeros((rows * size, columns * size, 3), np.float32)
    for look, (row, column) in places.items():
        face = faces[look][::-1, ::-1] if (layout, look) == ("vertical_cross", "back") else faces[look]
        image[row * size : (row + 1) * size, column * size : (column + 1) * size] = face
    return image


def exr_cube(size: int) -> np.ndarray:
    """OpenEXR's cube map: pixel centres reach the edges of a face, each face turned in its own way."""
    steps = np.linspace(-1.0, 1.0, size)
    column, row = np.meshgrid(steps, steps)
    one = np.ones_like(column)
    faces = [
        (one, -row, column),
        (-one, -row, -column),
        (column, one, -row),
        (column, -one, row),
        (-column, -row, one),
        (column, -row, -one),
    ]
    return np.concatenate([light(_normalised(np.stack(d, axis=-1))) for d in faces]).astype(np.float32)


@pytest.mark.parametrize("layout", list(LAYOUTS))
def test_every_layout_gives_the_light_back(layout):
    size = 64
    result = as_latlong(drawn(layout, size), layout)
    height = result.shape[0]
    truth = light(direction(ring_angles(height)[:, None], column_angles(2 * height)[None, :]))
    error = np.abs(result - truth).max(axis=2)
    if layout == "dome":
        assert (result[height // 2 :] == 0.0).all()
        error = error[: height // 2 - 1]
    if layout in ("angular", "mirror_ball"):
        # Behind a mirror ball a wide ring of directions shares the last pixels of the rim.
        behind = direction(ring_angles(height)[:, None], column_angles(2 * height)[None, :])[..., 2] > 0.95
        assert np.percentile(error[behind], 99) < (0.35 if layout == "mirror_ball" else 0.08)
        error = error[~behind]
    assert error.max() < (0.06 if layout == "mirror_ball" else 0.04)
    assert np.median(error) < 0.002


@pytest.mark.parametrize("layout", ["angular", "mirror_ball"])
def test_the_default_camera_looks_away_from_the_rim(layout):
    image = np.zeros((64, 64, 3), np.float32)
    image[28:36, 28:36] = 1.0
    result = as_latlong(image, layout)[..., 0]
    height = len(result)
    towards = direction(ring_angles(height)[:, None], column_angles(2 * height)[None, :])
    lit = (towards * result[..., None]).sum(axis=(0, 1))
    camera = Camera()
    azimuth, elevation = np.radians(camera.azimuth_deg), np.radians(camera.elevation_deg)
    away = np.array(
        [np.sin(azimuth) * np.cos(elevation), np.sin(elevation), np.cos(azimuth) * np.cos(elevation)]
    )
    # Not the middle of a probe, and still less its rim, lies behind the default camera.
    assert lit / np.linalg.norm(lit) @ -away > np.cos(np.radians(45.0))


@pytest.mark.parametrize("layout", [name for name in LAYOUTS if name not in ("latlong", "dome")])
def test_constant_light_stays_constant(layout):
    image = np.full(drawn(layout, 16).shape, 0.25, np.float32)
    assert np.allclose(as_latlong(image, layout), 0.25, atol=1e-6)


@pytest.mark.parametrize("layout", ["horizontal_cross", "vertical_cross", "horizontal_strip", "exr_cube"])
def test_no_seam_at_the_edges_of_a_cube(layout):
    result = as_latlong(drawn(layout, 64), layout)
    step = np.abs(np.diff(result, axis=1)).max()
    assert step < 3.0 * np.pi / result.shape[0]  # no jump beyond what the light itself does in a texel


def test_shape_gives_the_layout_where_it_can():
    for layout in (
        "latlong",
        "horizontal_cross",
        "vertical_cross",
        "horizontal_strip",
        "vertical_strip",
        "angular",
    ):
        rows, columns = drawn(layout, 16).shape[:2]
        found, notes = detect_layout(columns, rows)
        assert found == layout
        assert bool(notes) == (layout != "latlong")


def test_a_square_says_what_was_assumed():
    assert "mirror ball" in detect_layout(512, 512)[1][0]


@example(96, 72)
@example(60, 10)
@example(9, 9)
@given(st.integers(1, 100), st.integers(1, 100))
def test_any_shape_is_known_or_refused_in_words(width, height):
    unfolded = ((4, 3), (3, 4), (6, 1), (1, 6))
    cube = any(width * rows == height * columns and width >= 2 * columns for columns, rows in unfolded)
    if cube or (abs(width - 2 * height) <= 1 and height >= 4) or width == height >= 8:
        result = as_latlong(np.ones((height, width, 3), np.float32), detect_layout(width, height)[0])
        assert abs(result.shape[1] - 2 * result.shape[0]) <= 1
        return
    with pytest.raises(ValueRangeError, match=f"{width} × {height}"):
        detect_layout(width, height)


@pytest.mark.parametrize("layout", list(LAYOUTS))
def test_a_layout_that_cannot_be_is_refused(layout):
    with pytest.raises(ValueRangeError, match=layout):
        as_latlong(np.ones((31, 50, 3), np.float32), layout)


def test_cancel():
    def cancel(*_: object) -> None:
        raise Cancelled("enough")

    with pytest.raises(Cancelled):
        as_latlong(drawn("angular", 64), "angular", cancel)
