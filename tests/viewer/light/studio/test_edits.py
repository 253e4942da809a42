"""Places in degrees and metres, and edits of studios as values."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from brdf_viewer.light.studio.document import NEW_LAMPS, TEMPLATES
from brdf_viewer.light.studio.edits import added, doubled, placed, removed, with_lamp, with_room, with_sun
from brdf_viewer.light.studio.places import (
    angle_of,
    covers,
    facing_deg,
    held_in,
    moved,
    outline,
    panorama_direction,
    panorama_place,
    size_at,
)
from hypothesis import given
from hypothesis import strategies as st

from brdf_suite.documents.studio import (
    SHAPES,
    BoothRoom,
    Sky,
    Studio,
    StudioLamp,
    light_from_json,
    light_to_json,
)
from brdf_suite.errors import ValueRangeError
from brdf_suite.geometry.polar import point_at, polar
from brdf_suite.lighting.procedural import BOOTH, studio
from brdf_suite.lighting.procedural.panorama import centres, directions

AZIMUTHS = st.floats(-179.0, 179.0)
ELEVATIONS = st.floats(-85.0, 85.0)


@given(AZIMUTHS, ELEVATIONS, st.floats(0.2, 50.0))
def test_a_place_in_degrees_is_the_place_in_metres(azimuth: float, elevation: float, distance: float) -> None:
    assert polar(point_at(azimuth, elevation, distance)) == pytest.approx((azimuth, elevation, distance))
    place = panorama_place(np.array(point_at(azimuth, elevation, distance)))
    back = panorama_direction(float(place[0]), float(place[1]))
    assert back == pytest.approx(np.array(point_at(azimuth, elevation, 1.0)), abs=1e-9)


@given(st.floats(0.01, 20.0), st.floats(0.2, 50.0))
def test_an_angle_is_a_size(size: float, distance: float) -> None:
    angle = angle_of(size, distance)
    if angle < 175.0:
        assert size_at(angle, distance) == pytest.approx(size)


def test_the_panorama_has_the_directions_of_the_maps() -> None:
    towards = directions(centres(8), centres(16))
    for row, column in ((1, 3), (6, 12), (4, 8)):
        place = panorama_place(towards[row, column])
        assert place == pytest.approx([(column + 0.5) / 16, (row + 0.5) / 8])


@given(AZIMUTHS, ELEVATIONS, st.sampled_from(range(8)))
def test_a_lamp_that_is_moved_faces_the_scene_as_before(azimuth: float, elevation: float, index: int) -> None:
    lamp = BOOTH.lamps[index]
    there = moved(lamp, point_at(azimuth, elevation, 2.0))

    def inwards(item: StudioLamp) -> float:
        facing, position = np.array(item.facing), np.array(item.position_m)
        return float(-facing @ position / np.linalg.norm(facing) / np.linalg.norm(position))

    assert inwards(there) == pytest.approx(inwards(lamp), abs=1e-9)
    assert there.size_m == lamp.size_m


def test_a_lamp_that_is_moved_and_moved_back_is_the_same() -> None:
    lamp = BOOTH.lamps[3]
    back = moved(moved(lamp, (0.5, 2.0, -1.0)), lamp.position_m)
    assert back.facing == pytest.approx(lamp.facing)


@given(AZIMUTHS, ELEVATIONS, st.floats(0.3, 60.0))
def test_a_lamp_stays_in_its_room(azimuth: float, elevation: float, distance: float) -> None:
    position = held_in(BoothRoom(), point_at(azimuth, elevation, distance))
    assert BoothRoom().holds(position)
    assert polar(position)[:2] == pytest.approx((azimuth, elevation))
    assert held_in(None, (60.0, 0.0, 0.0)) == (60.0, 0.0, 0.0)
    placed(BOOTH, 0, point_at(azimuth, elevation, distance))


@pytest.mark.parametrize("key", TEMPLATES)
def test_templates_are_documents(key: str) -> None:
    title, light = TEMPLATES[key]
    assert title
    assert light_from_json(light_to_json(light)) == light


@pytest.mark.parametrize("shape", SHAPES)
def test_an_outline_is_where_the_lamp_is_seen(shape: str) -> None:
    lamp = dataclasses.replace(NEW_LAMPS[shape], softness_m=0.001)
    alone = Studio("one", (lamp,), backdrop=TEMPLATES["empty"][1].backdrop)
    picture = studio(alone, 128, 1).radiance[..., 1]
    edge = panorama_place(outline(lamp))
    rows, columns = np.nonzero(picture > 0.5 * picture.max())
    low, high = edge.min(axis=0), edge.max(axis=0)
    assert (columns.min() / 256, columns.max() / 256) == pytest.approx((low[0], high[0]), abs=0.02)
    assert (rows.min() / 128, rows.max() / 128) == pytest.approx((low[1], high[1]), abs=0.03)
    middle = np.array(lamp.position_m) / np.linalg.norm(lamp.position_m)
    assert covers(lamp, middle)
    assert not covers(lamp, -middle)
    assert facing_deg(lamp)[1] == pytest.approx(-polar(lamp.position_m)[1])


def test_lamps_are_added_doubled_and_removed() -> None:
    light = TEMPLATES["empty"][1]
    for shape in SHAPES:
        light = added(light, shape)
    assert [lamp.shape for lamp in light.lamps] == ["box", "box", "strip", "ring"]
    more = doubled(light, 2)
    assert [lamp.shape for lamp in more.lamps] == ["box", "box", "strip", "strip", "ring"]
    assert more.lamps[3].position_m != more.lamps[2].position_m
    assert removed(more, 3) == light
    for shape in SHAPES:
        assert BOOTH.room.holds(added(BOOTH, shape).lamps[-1].position_m)
    with pytest.raises(ValueRangeError, match="room"):
        with_lamp(BOOTH, 0, dataclasses.replace(BOOTH.lamps[0], position_m=(50.0, 0.0, 0.0)))


def test_a_room_is_put_around_the_lamps() -> None:
    light = placed(TEMPLATES["empty"][1], 0, (20.0, 1.0, 0.0))
    inside = with_room(light, True)
    assert inside.room is not None
    assert inside.room.holds(inside.lamps[0].position_m)
    assert with_room(inside, True) is inside
    assert with_room(inside, False).backdrop is not None


def test_the_sun_stays_above_the_horizon() -> None:
    sky = with_sun(Sky("s"), 30.0, -20.0)
    assert (sky.sun_azimuth_deg, sky.sun_elevation_deg) == (30.0, 1.0)
    assert with_sun(sky, 0.0, 90.0).sun_elevation_deg == 89.9
