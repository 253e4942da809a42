"""Edits of a studio as values: lamps added, doubled, removed, moved; a room exchanged for a backdrop."""

from __future__ import annotations

import dataclasses

from brdf_suite.documents.studio import Backdrop, BoothRoom, Point, Sky, Studio, StudioLamp
from brdf_suite.geometry.polar import point_at, polar
from brdf_viewer.light.studio.document import NEW_LAMPS
from brdf_viewer.light.studio.places import angle_of, held_in, moved, size_at

LARGEST_DEG = 170.0
_BESIDE_DEG = 20.0


def with_lamp(studio: Studio, index: int, lamp: StudioLamp) -> Studio:
    """Return the studio with one lamp replaced; :class:`ValueRangeError` where it cannot be so."""
    lamps = (*studio.lamps[:index], lamp, *studio.lamps[index + 1 :])
    return dataclasses.replace(studio, lamps=lamps)


def added(studio: Studio, shape: str) -> Studio:
    """Return the studio with a new lamp at the end of the list, within its room."""
    lamp = NEW_LAMPS[shape]
    lamp = dataclasses.replace(lamp, position_m=held_in(studio.room, lamp.position_m))
    return dataclasses.replace(studio, lamps=(*studio.lamps, lamp))


def doubled(studio: Studio, index: int) -> Studio:
    """Return the studio with another lamp like one of its own, beside it and after it in the list."""
    lamp = studio.lamps[index]
    azimuth, elevation, distance = polar(lamp.position_m)
    position = held_in(studio.room, point_at(azimuth + _BESIDE_DEG, elevation, distance))
    lamps = (*studio.lamps[: index + 1], moved(lamp, position), *studio.lamps[index + 1 :])
    return dataclasses.replace(studio, lamps=lamps)


def removed(studio: Studio, index: int) -> Studio:
    """Return the studio without one of its lamps; the last light cannot go."""
    return dataclasses.replace(studio, lamps=studio.lamps[:index] + studio.lamps[index + 1 :])


def placed(studio: Studio, index: int, position: Point) -> Studio:
    """Return the studio with a lamp moved to a position, or as far towards it as its room goes."""
    return with_lamp(studio, index, moved(studio.lamps[index], held_in(studio.room, position)))


def scaled(lamp: StudioLamp, factor: float) -> StudioLamp:
    """Return the lamp with both of its angles a factor larger, up to 170°."""
    distance = polar(lamp.position_m)[2]
    angles = (min(LARGEST_DEG, angle_of(size, distance) * factor) for size in lamp.size_m)
    first, second = (size_at(angle, distance) for angle in angles)
    return dataclasses.replace(lamp, size_m=(first, second))


def with_room(studio: Studio, has_room: bool) -> Studio:
    """Return the studio in a room around its lamps, or before a backdrop; as it is where it has that already."""
    if has_room == (studio.room is not None):
        return studio
    if not has_room:
        return dataclasses.replace(studio, room=None, backdrop=Backdrop())
    room = BoothRoom()
    lamps = tuple(moved(lamp, held_in(room, lamp.position_m)) for lamp in studio.lamps)
    return dataclasses.replace(studio, room=room, backdrop=None, lamps=lamps)


def with_sun(sky: Sky, azimuth_deg: float, elevation_deg: float) -> Sky:
    """Return the sky with its sun elsewhere, above the horizon."""
    elevation_deg = min(89.9, max(1.0, elevation_deg))
    return dataclasses.replace(sky, sun_azimuth_deg=azimuth_deg, sun_elevation_deg=elevation_deg)
