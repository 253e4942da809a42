"""Camera matrices and movements."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from brdf_suite.documents.view import Camera
from brdf_suite.realtime import camera as cam

BOX = cam.Bounds((-0.9, 0.0, -2.3), (0.9, 1.4, 2.2))
SIZE = (640, 360)

cameras = st.builds(
    Camera,
    azimuth_deg=st.floats(-360, 360),
    elevation_deg=st.floats(-89, 89),
    focal_length_mm=st.floats(15, 300),
)


def project(matrix, point):
    x = matrix @ np.append(point, 1.0)
    return x[:3] / x[3]


@given(cameras, st.sampled_from([(640, 360), (360, 640), (100, 100)]))
def test_framed_object_is_wholly_seen_and_fills_the_picture(camera, size):
    m = cam.matrices(camera, BOX, size)
    seen = np.array([project(m.world_to_clip, c) for c in BOX.corners])
    assert np.abs(seen).max() <= 1.0
    assert np.abs(seen[:, :2]).max() == pytest.approx(1 / cam.MARGIN)


@given(cameras)
@settings(max_examples=settings.default.max_examples // 2)
def test_axes_are_right_handed_and_the_target_is_in_the_middle(camera):
    axes = cam.axes(camera)
    np.testing.assert_allclose(axes.T @ axes, np.eye(3), atol=1e-12)
    assert np.linalg.det(axes) == pytest.approx(1.0)
    m = cam.matrices(camera, BOX, SIZE)
    np.testing.assert_allclose(project(m.world_to_clip, BOX.centre)[:2], 0, atol=1e-9)
    assert axes[1, 1] >= 0


def test_azimuth_and_elevation():
    """At azimuth 0 on +z, at 90 on +x; upwards with elevation; +x is to the right of a camera on +z."""
    for azimuth, elevation, direction in ((0, 0, (0, 0, 1)), (90, 0, (1, 0, 0)), (0, 90, (0, 1, 0))):
        m = cam.matrices(Camera(azimuth, elevation, distance=3.0, target=(0, 0, 0)), BOX, SIZE)
        np.testing.assert_allclose(m.eye, 3 * np.array(direction), atol=1e-12)
    m = cam.matrices(Camera(0, 0), BOX, SIZE)
    assert project(m.world_to_clip, np.add(BOX.centre, (0.5, 0, 0)))[0] > 0
    assert project(m.world_to_clip, np.add(BOX.centre, (0, 0.5, 0)))[1] > 0


def test_field_of_view():
    """50 mm on a 36 mm sensor: 39.6 degrees across."""
    m = cam.matrices(Camera(), BOX, (1600, 900))
    assert 2 * np.degrees(np.arctan(m.half_tangents[0])) == pytest.approx(39.6, abs=0.01)
    assert m.half_tangents[1] == pytest.approx(m.half_tangents[0] * 9 / 16)


@given(st.floats(1e-3, 1e3), st.floats(1e-3, 30))
def test_depth_range_holds_the_object_at_any_scale_and_distance(scale, distance):
    box = cam.Bounds((-scale, -scale, -scale), (scale, scale, scale))
    camera = Camera(distance=float(np.clip(distance * scale, 1e-4, 1e6)))
    m = cam.matrices(camera, box, SIZE)
    assert 0 < m.near < m.far
    assert m.far / m.near <= 5000.1
    depth = (m.eye - box.corners) @ m.view_to_world[:, 2]
    assert depth.max() <= m.far
    assert m.near <= max(depth.min(), m.far / 5000 + 1e-12)


def test_crop_cuts_out_a_tile():
    tile = cam.crop((640, 360), (128, 64), (64, 32))
    corner = np.array([128 / 640 * 2 - 1, 64 / 360 * 2 - 1, 0.3, 1.0])
    np.testing.assert_allclose(tile @ corner, [-1, -1, 0.3, 1], atol=1e-12)
    np.testing.assert_allclose(cam.crop(SIZE, (0, 0), SIZE), np.eye(4))


@given(cameras, st.floats(-200, 200), st.floats(-200, 200))
@settings(max_examples=settings.default.max_examples // 2)
def test_pan_follows_the_cursor(camera, right, down):
    old = cam.resolve(camera, BOX, SIZE)
    new = cam.pan(camera, BOX, SIZE, right, down)
    m = cam.matrices(new, BOX, SIZE)
    x, y, _ = project(m.world_to_clip, old.target)
    assert x * SIZE[0] / 2 == pytest.approx(right, abs=1e-6)
    assert -y * SIZE[1] / 2 == pytest.approx(down, abs=1e-6)


def test_orbit_keeps_distance_and_stops_below_the_pole():
    camera = cam.resolve(Camera(350, 10), BOX, SIZE)
    turned = cam.orbit(camera, 20, 300)
    assert turned.azimuth_deg == pytest.approx(10)
    assert turned.elevation_deg == cam.HIGHEST_ELEVATION_DEG
    assert (turned.distance, turned.target) == (camera.distance, camera.target)


def test_dolly_has_limits_and_is_undone_by_its_inverse():
    start = cam.resolve(Camera(), BOX, SIZE)
    near = cam.dolly(start, BOX, SIZE, 0.5)
    assert near.distance == pytest.approx(start.distance / 2)
    assert cam.dolly(near, BOX, SIZE, 2.0).distance == pytest.approx(start.distance)
    assert cam.dolly(start, BOX, SIZE, 1e-9).distance == pytest.approx(BOX.radius / 50)
    assert cam.dolly(start, BOX, SIZE, 1e9).distance == pytest.approx(BOX.radius * 50)


def test_frame_forgets_where_it_was():
    moved = cam.pan(Camera(10, 20), BOX, SIZE, 100, 30)
    assert cam.frame(moved) == Camera(10, 20)


def test_bounds():
    points = np.array([[0, 1, 2], [3, -1, 5]], np.float32)
    box = cam.Bounds.of([points, points + 1])
    assert box == cam.Bounds((0.0, -1.0, 2.0), (4.0, 2.0, 6.0))
    assert cam.Bounds.of([]).radius > 0
    assert box.corners.min(0).tolist() == list(box.minimum)
    assert len({tuple(c) for c in box.corners}) == 8


def test_bounds_know_the_outline_of_what_is_in_them() -> None:
    turn = np.random.default_rng(5).normal(size=(4000, 3))
    ball = (turn / np.linalg.norm(turn, axis=1, keepdims=True)).astype(np.float32)
    bounds = cam.Bounds.of([ball[:2000], ball[2000:]])
    assert bounds.minimum == tuple(ball.min(axis=0))
    assert bounds.maximum == tuple(ball.max(axis=0))
    resolved = cam.resolve(Camera(elevation_deg=30), bounds, (800, 800))
    boxed = cam.resolve(Camera(elevation_deg=30), cam.Bounds(bounds.minimum, bounds.maximum), (800, 800))
    assert resolved.distance is not None
    assert boxed.distance is not None
    # A ball is framed as a ball, nearer than its box: its rim keeps the margin.
    assert resolved.distance < 0.75 * boxed.distance
    clip = cam.matrices(resolved, bounds, (800, 800)).world_to_clip @ np.c_[ball, np.ones(len(ball))].T
    extent = float(np.abs(clip[:2] / clip[3]).max())
    assert 0.98 / cam.MARGIN < extent < 1.02 / cam.MARGIN


@pytest.mark.parametrize("size", [(1280, 720), (600, 900)])
def test_a_composed_picture_has_the_object_in_its_middle(size: tuple[int, int]) -> None:
    points = (
        np.random.default_rng(6).uniform((-0.9, 0.0, -2.3), (0.9, 1.4, 2.2), (5000, 3)).astype(np.float32)
    )
    bounds = cam.Bounds.of([points])
    composed = cam.compose(Camera(), bounds, size)
    clip = cam.matrices(composed, bounds, size).world_to_clip @ np.c_[points, np.ones(len(points))].T
    picture = clip[:2] / clip[3]
    low, high = picture.min(axis=1), picture.max(axis=1)
    assert np.abs(low + high).max() < 0.02
    assert max(-low.min(), high.max()) == pytest.approx(1 / cam.MARGIN, abs=0.02)
    own = Camera(distance=7.0, target=(0.1, 0.2, 0.3))
    assert cam.compose(own, bounds, size) == own


@given(cameras, st.floats(0.3, 3.0), st.floats(-0.8, 0.8), st.floats(-0.5, 0.5))
def test_a_dolly_keeps_what_is_under_the_cursor_there(camera, factor, right, up):
    start = cam.resolve(camera, BOX, SIZE)
    axes = cam.axes(start)
    height = 2 * cam.half_tangents(start, SIZE)[1] * start.distance
    point = np.asarray(start.target) + height * (right * axes[:, 0] + up * axes[:, 1])
    nearer = cam.dolly_to(start, BOX, SIZE, factor, (right, up))
    before = project(cam.matrices(start, BOX, SIZE).world_to_clip, point)[:2]
    after = project(cam.matrices(nearer, BOX, SIZE).world_to_clip, point)[:2]
    np.testing.assert_allclose(after, before, atol=1e-6)
    np.testing.assert_allclose(before, (2 * right * SIZE[1] / SIZE[0], 2 * up), atol=1e-6)
    back = cam.dolly_to(nearer, BOX, SIZE, 1 / factor, (right, up))
    np.testing.assert_allclose(back.target, start.target, atol=1e-6)


def test_a_dolly_that_has_reached_its_limit_does_not_slide_sideways():
    nearest = cam.dolly(cam.resolve(Camera(), BOX, SIZE), BOX, SIZE, 1e-9)
    again = cam.dolly_to(nearest, BOX, SIZE, 0.5, (0.4, 0.2))
    np.testing.assert_allclose(again.target, nearest.target, atol=1e-12)
