"""Directions on the map of handles, and lamps whose mirror image is where it was asked for."""

from __future__ import annotations

import numpy as np
import pytest
from brdf_qt.gl.aiming import (
    direction_of,
    lamp_for_highlight,
    map_direction,
    map_place,
    mirror_direction,
    turned_to,
)
from hypothesis import assume, given
from hypothesis import strategies as st

from brdf_suite.documents.view import Camera
from brdf_suite.documents.view_settings import Lamp
from brdf_suite.realtime.camera import axes

ANGLES = st.tuples(st.floats(-180.0, 180.0), st.floats(-89.0, 89.0))
UNIT = st.tuples(*[st.floats(-1.0, 1.0)] * 3).filter(lambda v: np.linalg.norm(v) > 0.1)


def unit(vector) -> np.ndarray:
    return np.asarray(vector) / np.linalg.norm(vector)


@given(ANGLES, UNIT)
def test_every_direction_has_a_place_on_the_map(angles, direction) -> None:
    basis, direction = axes(Camera(*angles)), unit(direction)
    assume(direction @ basis[:, 2] > np.cos(np.radians(174.0)))
    place = map_place(direction, basis)
    angle = np.degrees(np.arccos(np.clip(direction @ basis[:, 2], -1.0, 1.0)))
    assert np.hypot(*place) == pytest.approx(angle / 90.0, abs=1e-6)
    np.testing.assert_allclose(map_direction(place, basis), direction, atol=1e-7)


def test_up_in_the_picture_is_up() -> None:
    basis = axes(Camera(0.0, 0.0))
    np.testing.assert_allclose(map_place(np.array([0.0, 1.0, 0.0]), basis), [0.0, 1.0], atol=1e-12)
    np.testing.assert_allclose(map_place(np.array([0.0, 0.0, 1.0]), basis), [0.0, 0.0], atol=1e-12)


@given(UNIT, UNIT)
def test_a_mirrored_direction_is_on_the_other_side_of_the_normal(normal, eye) -> None:
    normal, eye = unit(normal), unit(eye)
    mirrored = mirror_direction(normal, eye)
    assert mirrored @ normal == pytest.approx(eye @ normal, abs=1e-9)
    if abs(eye @ normal) >= 1e-3:  # else both lie in the surface, and their sum says nothing
        assert np.linalg.norm(np.cross(unit(mirrored + eye), normal)) < 1e-5


@given(st.sampled_from(["point", "directional"]), UNIT, UNIT, UNIT)
def test_a_lamp_for_a_highlight_lies_on_the_mirrored_ray(kind, place, normal, eye) -> None:
    lamp = Lamp(kind, position=(0.0, 3.0, 3.0))
    position, normal, eye = 0.5 * unit(place), unit(normal), unit(eye)
    found = lamp_for_highlight(lamp, position, normal, eye)
    wanted = mirror_direction(normal, eye)
    if kind == "point":
        assert np.linalg.norm(found.position) == pytest.approx(np.hypot(3.0, 3.0), abs=1e-6)
        np.testing.assert_allclose(unit(np.array(found.position) - position), wanted, atol=1e-6)
    else:
        np.testing.assert_allclose(direction_of(found), wanted, atol=1e-6)


def test_a_point_lamp_too_near_for_its_circle_goes_along_the_ray() -> None:
    lamp = Lamp("point", position=(0.0, 0.1, 0.0))
    found = lamp_for_highlight(
        lamp, np.array([2.0, 0.0, 0.0]), np.array([1.0, 0.0, 0.0]), np.array([1.0, 0.0, 0.0])
    )
    np.testing.assert_allclose(found.position, [2.1, 0.0, 0.0], atol=1e-9)


@given(UNIT)
def test_a_turned_lamp_keeps_its_distance(direction) -> None:
    lamp = Lamp("point", position=(1.0, 2.0, 2.0))
    assert np.linalg.norm(turned_to(lamp, unit(direction)).position) == pytest.approx(3.0)
