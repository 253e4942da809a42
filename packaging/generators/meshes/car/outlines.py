"""Outlines on the body: windows, lamps, openings, panels. Each is a region of space, negative inside.

What the region cuts out of the body's surface is the window, lamp or panel; its border is the edge or the shut
line. Only the half x ≥ 0 is ever cut, so x represents the distance from the middle.
"""

from __future__ import annotations

import numpy as np

from brdf_suite.arrays import Floats, Integers
from meshes.car.blends import SoftPolyline, rounded_max, smooth_min
from meshes.car.body import FLOOR, cabin_side, lower_body, roof_surface, screen_station
from meshes.car.proportions import ARCH_DEPTH_X, ARCH_RADIUS, AXLES, WHEEL_RADIUS

_BELT = SoftPolyline([(1.0, 0.926), (-0.2, 0.938), (-1.3, 0.972)], 0.4)
_DOOR_FRONT = SoftPolyline([(0.2, 0.70), (0.5, 0.655), (1.0, 0.615)], 0.2)
_DOOR_REAR = SoftPolyline([(0.2, -0.42), (0.42, -0.56), (0.8, -0.665), (1.3, -0.72)], [0.2, 0.2])
_BONNET_EDGE = SoftPolyline([(0.6, 0.715), (1.3, 0.675), (2.0, 0.545), (2.3, 0.44)], [0.4, 0.3])
_HATCH_EDGE = SoftPolyline([(-0.6, 0.500), (-1.3, 0.520), (-1.9, 0.535), (-2.3, 0.58)], [0.3, 0.3])
_LAMP_LOW = SoftPolyline([(0.4, 0.572), (0.9, 0.612), (1.3, 0.668)], 0.2)
_LAMP_HIGH = SoftPolyline([(0.4, 0.628), (0.75, 0.668), (1.3, 0.705)], 0.2)
_BUMPER = SoftPolyline([(0.0, 0.600), (0.5, 0.602), (1.22, 0.688), (1.9, 0.668)], [0.15, 0.1])

FLOOR_EDGE = 0.012
"""How far above the floor's surface the skin of the body ends, m."""


def round_nose(x: Floats, z: Floats) -> Floats:
    """Return a coordinate that grows from the middle of the nose round the corner to the side."""
    return x + 0.9 * (2.2 - z)


def _round_tail(x: Floats, z: Floats) -> Floats:
    """Return a coordinate that grows from the middle of the tail round the corner to the side."""
    return x + 0.9 * (2.25 + z)


def _inside_rail(x: Floats, y: Floats, z: Floats) -> Floats:
    """Return how far roof-ward of the cant rail a point is (negative), from the two surfaces that meet there."""
    return cabin_side(x, y, z) - roof_surface(x, y, z)


def arch(x: Floats, y: Floats, z: Floats) -> Floats:
    """Both wheel openings: cylinders about the axles, open to the side."""
    radial = np.minimum(*(np.sqrt((z - axle) ** 2 + (y - WHEEL_RADIUS) ** 2) for axle in AXLES)) - ARCH_RADIUS
    return np.maximum(radial, ARCH_DEPTH_X - x)


def floor(x: Floats, y: Floats, z: Floats) -> Floats:
    """What is seen only from below."""
    return y - FLOOR(z) - FLOOR_EDGE + 0.0 * x


def sill(x: Floats, y: Floats, z: Floats) -> Floats:
    """Black side skirt between the wheels."""
    return np.maximum(np.maximum(y - 0.195, np.abs(z) - 1.15), 0.5 - x)


def side_window(x: Floats, y: Floats, z: Floats) -> Floats:
    """Door glass and quarter glass together: belt, rail, and a forward-leaning rear end."""
    rear = (-z - 1.20) * 0.9 + (y - 1.0) * 0.42
    front = z - 0.66
    rail = -_inside_rail(x, y, z) + 0.036
    return rounded_max(0.022, _BELT(z) - y, rail, rear, front, 0.3 - x)


def windscreen(x: Floats, y: Floats, z: Floats) -> Floats:
    """The glass from the cowl to the roof."""
    station = screen_station(x, z)
    above_wings = 0.010 - lower_body(x, y, z)
    return rounded_max(
        0.035, _inside_rail(x, y, z) + 0.040, 0.24 - station, (station - 0.865) * 0.9, above_wings
    )


def cowl(x: Floats, y: Floats, z: Floats) -> Floats:
    """Black panel with the wipers between bonnet and windscreen."""
    station = screen_station(x, z)
    return rounded_max(0.03, x - 0.71, 0.79 - station, station - 0.952, y - 1.1)


def rear_screen(x: Floats, y: Floats, z: Floats) -> Floats:
    """The glass in the tailgate."""
    station = screen_station(x, z)
    return rounded_max(0.07, _inside_rail(x, y, z) + 0.055, station + 0.88, -1.66 - station)


def headlamp(x: Floats, y: Floats, z: Floats) -> Floats:
    """The lamp's outer lens, from the nose round the corner."""
    q = round_nose(x, z)
    return rounded_max(0.012, 0.565 - q, (q - 1.22) * 0.7, _LAMP_LOW(q) - y, y - _LAMP_HIGH(q), 1.2 - z)


def headlamp_middle(q: Floats) -> Floats:
    """Return the height of the middle of the lens above the daytime running light, at a place round the nose."""
    return 0.5 * (_LAMP_LOW(q) + 0.024 + _LAMP_HIGH(q))


def daylight(x: Floats, y: Floats, z: Floats) -> Floats:
    """The daytime running light: a band along the lens's lower edge."""
    q = round_nose(x, z)
    return rounded_max(0.005, 0.60 - q, (q - 1.14) * 0.7, np.abs(y - _LAMP_LOW(q) - 0.017) - 0.0065, 1.2 - z)


def badge(x: Floats, y: Floats, z: Floats) -> Floats:
    """Round badges on nose and tail."""
    height = np.where(z > 0.0, 0.548, 0.705)
    return np.maximum(np.hypot(x, y - height) - 0.034, 1.0 - np.abs(z))


def splitter(x: Floats, y: Floats, z: Floats) -> Floats:
    """Black lip under the nose."""
    return rounded_max(0.01, y - 0.195 + 0.0 * x, 1.3 - z)


def grille(x: Floats, y: Floats, z: Floats) -> Floats:
    """The main intake."""
    half = 0.50 - 0.55 * np.maximum(y - 0.33, 0.0) - 0.9 * np.maximum(0.30 - y, 0.0)
    return rounded_max(0.03, (x - half) * 0.9, 0.235 - y, y - 0.475, 1.6 - z)


def intake(x: Floats, y: Floats, z: Floats) -> Floats:
    """The outer intake below the headlamp."""
    q = round_nose(x, z)
    return rounded_max(
        0.025, 0.72 - q + 0.35 * (y - 0.3), q - 1.02 - 0.2 * (y - 0.3), 0.245 - y, y - 0.43, 1.5 - z
    )


def tail_panel(x: Floats, y: Floats, z: Floats) -> Floats:
    """Dark glass across the tail that carries the light band."""
    q = _round_tail(x, z)
    top = 0.838 + 0.015 * q
    return rounded_max(0.016, q - 1.10, y - top, 0.735 + 0.045 * q - y, z + 1.6)


def tail_band(x: Floats, y: Floats, z: Floats) -> Floats:
    """The light band."""
    q = _round_tail(x, z)
    middle = 0.79 + 0.028 * q
    return rounded_max(0.004, q - 1.06, np.abs(y - middle) - 0.013, z + 1.6)


def diffuser(x: Floats, y: Floats, z: Floats) -> Floats:
    """Black lower part of the rear bumper."""
    q = _round_tail(x, z)
    return rounded_max(0.05, (q - 0.78 - 0.6 * (y - 0.3)) * 0.8, y - 0.392, z + 1.6)


def plate_recess(x: Floats, y: Floats, z: Floats) -> Floats:
    """The hollow for the rear number plate."""
    return rounded_max(0.02, x - 0.275 - 0.15 * (y - 0.55), y - 0.605, 0.465 - y, z + 1.6)


_SILL_TOP = 0.272
_ROOF_FRONT, _ROOF_REAR = 0.215, -0.860
"""Stations where the roof ends at the pillars."""


def above_belt(x: Floats, y: Floats, z: Floats) -> Floats:
    """Below the line where pillars stand on wings; not a number where there are none."""
    inside = (x > 0.4) & (z > -2.0) & (z < 1.0)
    return np.where(inside, _BELT(z) - 0.008 - y, np.nan)


def above_sill(x: Floats, y: Floats, z: Floats) -> Floats:
    """Below the line where wings stand on the painted sill; not a number ahead of the wheels and behind."""
    return np.where((x > 0.5) & (np.abs(z) < 1.15), y - _SILL_TOP, np.nan)


def _beside_roof(x: Floats, y: Floats, z: Floats, station: float) -> Floats:
    inside = (y > 1.0) & (_inside_rail(x, y, z) < 0.03)
    return np.where(inside, screen_station(x, z) - station, np.nan)


def ahead_of_roof(x: Floats, y: Floats, z: Floats) -> Floats:
    """Ahead of where the roof begins; not a number beside the rails and below them."""
    return _beside_roof(x, y, z, _ROOF_FRONT)


def before_roof_ends(x: Floats, y: Floats, z: Floats) -> Floats:
    """Ahead of where the roof ends; not a number beside the rails and below them."""
    return _beside_roof(x, y, z, _ROOF_REAR)


JOINTS = (above_belt, above_sill, ahead_of_roof, before_roof_ends)
"""Where parts of the painted body meet without a gap."""
BODY_PARTS = ("roof", "a_pillar", "c_pillar", "sill_panel", "front_wing", "rear_wing")
"""Of the painted body without the panels that open; they join without a gap."""


def body_part(x: Floats, y: Floats, z: Floats) -> Integers:
    """Return for each place (n,) of the painted body which of :data:`BODY_PARTS` it belongs to."""
    station = screen_station(x, z)
    high = y > np.where(z < 1.0, _BELT(z) - 0.008, np.inf)
    roof = high & (station < _ROOF_FRONT) & (station > _ROOF_REAR)
    pillar = high & (x > 0.4)
    sill_panel = (y < _SILL_TOP) & (np.abs(z) < 1.15)
    names = [roof, pillar & (z > 0.0), pillar, sill_panel, z > 0.0]
    return np.asarray(np.select(names, list(range(len(names))), len(names)), np.int64)


def door(x: Floats, y: Floats, z: Floats) -> Floats:
    """The door below the belt."""
    return rounded_max(
        0.045, z - _DOOR_FRONT(y), _DOOR_REAR(y) - z, _SILL_TOP - y, y - _BELT(z) + 0.008, 0.4 - x
    )


def window_split(x: Floats, y: Floats, z: Floats) -> Floats:
    """Ahead of the line between door glass and quarter glass."""
    return np.maximum(_DOOR_REAR(y) - z, 0.3 - x)


def handle(x: Floats, y: Floats, z: Floats) -> Floats:
    """A handle flush with the door."""
    slope = 0.05 * (z + 0.45)
    return rounded_max(0.011, np.abs(z + 0.47) - 0.105, np.abs(y - 0.832 + slope) - 0.0125, 0.4 - x)


def front_bumper(x: Floats, y: Floats, z: Floats) -> Floats:
    """Below bonnet and lamps, ahead of the wheel opening."""
    return np.maximum(y - _BUMPER(round_nose(x, z)), 1.35 - z)


def bonnet(x: Floats, y: Floats, z: Floats) -> Floats:
    """The bonnet, down to the bumper."""
    station = screen_station(x, z)
    above = _BUMPER(round_nose(x, z)) - y
    return rounded_max(0.03, x - _BONNET_EDGE(z), 0.945 - station, above)


def tailgate(x: Floats, y: Floats, z: Floats) -> Floats:
    """The hatch: a margin round the rear screen, and the lid below it down to the bumper."""
    lid = rounded_max(0.05, x - _HATCH_EDGE(z), screen_station(x, z) + 1.55, 0.672 - y)
    return smooth_min(rear_screen(x, y, z) - 0.034, lid, 0.06)


def rear_bumper(x: Floats, y: Floats, z: Floats) -> Floats:
    """Below the lamps, behind the wheel opening."""
    return np.maximum(y - 0.672 + 0.0 * x, z + 1.5)
