"""Body of the car: a few smooth surfaces, blended, as a field that is negative inside.

As in a styling studio: one surface each for the side, the top, the nose, the tail and the floor, each from
soft control polygons; fillets between them; and the greenhouse blended on top. |x| enters through x² or
a plain distance, so the car is exactly symmetric. Lengths in metres, see :mod:`meshes.car.proportions`.
"""

from __future__ import annotations

import numpy as np

from brdf_suite.arrays import Floats
from meshes.car.blends import Field, SoftPolyline, bell, ramp, smooth_max, smooth_min
from meshes.car.proportions import ARCH_RADIUS, FRONT_AXLE_Z, REAR_AXLE_Z, WHEEL_RADIUS

# --- side: half-width over z, inset over height ---
_PLAN = SoftPolyline(
    [
        (2.6, 0.720),
        (2.0, 0.905),
        (1.3, 0.968),
        (0.3, 0.912),
        (-0.5, 0.910),
        (-1.4, 0.978),
        (-2.0, 0.930),
        (-2.6, 0.770),
    ],
    [0.30, 0.45, 0.45, 0.45, 0.40, 0.35],
)
LINE = SoftPolyline([(2.3, 0.66), (1.2, 0.715), (-0.6, 0.785), (-1.6, 0.86), (-2.4, 0.88)], [0.5, 0.6, 0.5])
"""Height of the character line over z."""
ROCKER = SoftPolyline([(2.0, 0.30), (0.9, 0.300), (-0.8, 0.375), (-2.2, 0.42)], [0.3, 0.4])
"""Height of the lower feature line, between the wheels, over z."""
_ROCKER_CREASE = SoftPolyline(
    [(-0.3, 0.0), (0.0, 0.0), (0.085, 0.036), (0.34, 0.0), (0.5, 0.0)],
    [0.005, 0.07, 0.14],
)
_SILL = SoftPolyline(
    [(0.02, 0.16), (0.16, 0.040), (0.30, 0.008), (0.55, 0.0), (0.8, 0.0)], [0.05, 0.10, 0.14]
)
_TUMBLE = SoftPolyline([(-0.2, 0.0), (0.02, 0.0), (0.14, 0.045), (0.35, 0.22)], [0.10, 0.14])
_CREASE = SoftPolyline(
    [(-0.6, 0.0), (-0.42, 0.0), (-0.20, 0.012), (-0.055, 0.021), (0.0, 0.0), (0.06, 0.004), (0.3, 0.004)],
    [0.14, 0.14, 0.08, 0.006, 0.10],
)

# --- top: bonnet and rear deck ---
_TOP = SoftPolyline(
    [
        (2.5, 0.56),
        (2.1, 0.690),
        (1.45, 0.835),
        (0.75, 0.925),
        (-0.2, 0.955),
        (-1.6, 0.965),
        (-2.1, 0.925),
        (-2.5, 0.950),
    ],
    [0.30, 0.5, 0.4, 0.6, 0.5, 0.20],
)
_CREST_X = SoftPolyline([(2.4, 0.59), (1.4, 0.73), (0.4, 0.77)], [0.4])
_NOSE = SoftPolyline(
    [(0.05, 2.03), (0.20, 2.195), (0.36, 2.245), (0.56, 2.235), (0.68, 2.16), (0.85, 1.93)],
    [0.08, 0.12, 0.12, 0.08],
)
_TAIL = SoftPolyline(
    [(0.05, 1.98), (0.26, 2.19), (0.42, 2.285), (0.58, 2.295), (0.665, 2.235), (0.83, 2.215), (0.96, 2.275)],
    [0.10, 0.10, 0.05, 0.03, 0.10],
)
FLOOR = SoftPolyline([(2.6, 0.185), (1.9, 0.135), (1.2, 0.125), (-1.4, 0.130), (-2.6, 0.36)], [0.2, 0.3, 0.4])

# --- greenhouse ---
_ROOF = SoftPolyline(
    [
        (1.6, 0.62),
        (0.92, 0.890),
        (0.20, 1.330),
        (-0.34, 1.432),
        (-0.95, 1.330),
        (-1.60, 1.110),
        (-2.15, 0.942),
        (-2.6, 0.88),
    ],
    [0.10, 0.30, 0.42, 0.5, 0.5, 0.25],
)
_CABIN = SoftPolyline([(1.2, 0.69), (0.5, 0.785), (-0.5, 0.792), (-1.4, 0.68), (-2.2, 0.50)], [0.4, 0.5, 0.5])
"""Half-width of the greenhouse at the belt over z."""
_CABIN_LEAN = SoftPolyline([(0.75, -0.03), (0.93, 0.0), (1.15, 0.078), (1.38, 0.200)], [0.1, 0.2])

ARCH_LIP = (0.026, 0.033, 0.040)
"""Start, middle and end of the step at the edge of a wheel opening: distances from the edge, m."""

# --- fillets: widths as smooth_max takes them ---
_NOSE_WIDTH = 0.10
_TAIL_WIDTH = 0.05
_RAIL_WIDTH = 0.13


def _shoulder_width(z: Floats) -> Floats:
    return 0.08 + 0.10 * ramp(z, 0.4, 1.6) + 0.12 * ramp(z, -0.6, -1.5)


def _belt_width(z: Floats) -> Floats:
    return 0.035 + 0.08 * ramp(z, -0.8, -1.5) + 0.04 * ramp(z, 0.5, 0.9)


def _flare(y: Floats, z: Floats, axle: float, amount: float) -> Floats:
    """Return the swelling of the side round a wheel opening, and a turned lip at its edge."""
    r = np.sqrt((z - axle) ** 2 + (y - WHEEL_RADIUS) ** 2 + 1e-9) - ARCH_RADIUS
    return amount * bell(r, 0.15) + 0.005 * ramp(r, ARCH_LIP[2], ARCH_LIP[0])


def side_half_width(y: Floats, z: Floats) -> Floats:
    """Return |x| of the body side without fillets."""
    v = y - LINE(z)
    crease = ramp(z, 1.9, 1.1) * ramp(z, -2.25, -1.7)
    inset = _SILL(y) + _TUMBLE(v) + crease * _CREASE(v)
    between = ramp(z, 1.15, 0.65) * ramp(z, -1.25, -0.7)
    inset = inset + between * _ROCKER_CREASE(y - ROCKER(z))
    flares = _flare(y, z, FRONT_AXLE_Z, 0.020) + _flare(y, z, REAR_AXLE_Z, 0.020)
    return _PLAN(z) - inset + flares


def top_height(x: Floats, z: Floats) -> Floats:
    """Return y of bonnet, wing crests and rear deck without fillets."""
    crest = 0.050 * ramp(z, 0.2, 1.2) * ramp(z, 2.6, 1.5) * bell(x - _CREST_X(z), 0.15)
    return _TOP(z) - 0.085 * x * x + crest


def tail_face(x: Floats, y: Floats, z: Floats) -> Floats:
    """Return the field of the half space in front of the tail."""
    x2 = x * x
    return -z - _TAIL(y) + 0.10 * x2 + 0.24 * x2 * x2


def nose_face(x: Floats, y: Floats, z: Floats) -> Floats:
    """Return the field of the half space behind the nose."""
    x2 = x * x
    return z - _NOSE(y) + 0.10 * x2 + 0.36 * x2 * x2


def side_face(x: Floats, y: Floats, z: Floats) -> Floats:
    """Return the field inside the body sides."""
    return np.sqrt(x * x + 1e-6) - side_half_width(y, z)


def top_face(x: Floats, y: Floats, z: Floats) -> Floats:
    """Return the field below bonnet and deck."""
    return y - top_height(np.sqrt(x * x + 1e-6), z)


def _hull(x: Floats, y: Floats, z: Floats) -> Floats:
    return smooth_max(side_face(x, y, z), top_face(x, y, z), _shoulder_width(z))


def lower_body(x: Floats, y: Floats, z: Floats) -> Floats:
    """Return the field of everything below the belt, the tail not yet cut off."""
    body = smooth_max(_hull(x, y, z), nose_face(x, y, z), _NOSE_WIDTH)
    return smooth_max(body, FLOOR(z) - y, 0.05)


def screen_station(x: Floats, z: Floats) -> Floats:
    """Return z along the roof line, m. The screens are arcs seen from above, so lines of equal station are too."""
    x2 = x * x
    return z + 0.34 * x2 * ramp(z, -0.6, 0.6) - 0.42 * x2 * ramp(z, -0.2, -1.4)


def roof_surface(x: Floats, y: Floats, z: Floats) -> Floats:
    """Return the field below windscreen, roof and rear screen."""
    x2 = x * x
    return (y - _ROOF(screen_station(x, z)) + 0.075 * x2 + 0.25 * x2 * x2) * 0.93


def cabin_side(x: Floats, y: Floats, z: Floats) -> Floats:
    """Return the field inside the side windows' surface."""
    return (np.sqrt(x * x + 1e-6) - _CABIN(z) + _CABIN_LEAN(y)) * 0.95


def greenhouse(x: Floats, y: Floats, z: Floats) -> Floats:
    """Return the field of cabin and fastback, the tail not yet cut off."""
    cabin = smooth_max(roof_surface(x, y, z), cabin_side(x, y, z), _RAIL_WIDTH)
    return smooth_max(cabin, 0.55 - y, 0.05)


def _uncut(x: Floats, y: Floats, z: Floats) -> Floats:
    return smooth_min(lower_body(x, y, z), greenhouse(x, y, z), _belt_width(z))


def body(x: Floats, y: Floats, z: Floats) -> Floats:
    """Return the field of the whole body, wheel openings not yet cut."""
    return smooth_max(_uncut(x, y, z), tail_face(x, y, z), _TAIL_WIDTH)


def fillets() -> tuple[Field, ...]:
    """Return for each fillet a coordinate across it: from -1 at one edge over 0 in the middle to 1.

    A mesh whose edges follow lines of equal coordinate carries a highlight along the fillet without a waver.
    """
    return (
        lambda x, y, z: (side_face(x, y, z) - top_face(x, y, z)) / _shoulder_width(z),
        lambda x, y, z: (_hull(x, y, z) - nose_face(x, y, z)) / _NOSE_WIDTH,
        lambda x, y, z: (cabin_side(x, y, z) - roof_surface(x, y, z)) / _RAIL_WIDTH,
        lambda x, y, z: (lower_body(x, y, z) - greenhouse(x, y, z)) / _belt_width(z),
        lambda x, y, z: (_uncut(x, y, z) - tail_face(x, y, z)) / _TAIL_WIDTH,
    )
