"""The car's main dimensions, metres, world axes (``y`` up, ``+z`` forward, ``x`` to the car's left).

A two-door fastback: long bonnet, cabin set back, short rear. Everything else is placed relative to these.
"""

from __future__ import annotations

FRONT_AXLE_Z = 1.375
REAR_AXLE_Z = -1.375
WHEEL_RADIUS = 0.345
TYRE_WIDTH = 0.255
ARCH_RADIUS = 0.372
"""Radius of the wheel opening: the gap over the tyre is what a sports suspension shows."""
ARCH_DEPTH_X = 0.56
"""Where the wheel well ends on the inside, distance from the middle of the car."""
FRONT_FACE_X = 0.903
REAR_FACE_X = 0.918
"""Distance of the tyre's outer face from the middle, front and rear."""
AXLES = (FRONT_AXLE_Z, REAR_AXLE_Z)
