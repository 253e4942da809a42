"""A light booth: a neutral room with large soft boxes, as paint is judged and photographed in.

A closed room, 9 × 14 m and 4.2 m high, seen from 0.9 m above the middle of its floor. All lamps and surfaces are
neutral (D65); the walls are Munsell N7. Long boxes along the room draw the lines that show a form; a broad box above
gives the flop its highlight, and two tall ones at the sides and one in front separate the flanks.
"""

from __future__ import annotations

import dataclasses
import math

from brdf_suite.documents.studio import BoothRoom, Studio, StudioLamp
from brdf_suite.lighting.procedural.panorama import ProceduralEnvironment
from brdf_suite.lighting.procedural.studio import studio

_LEFT, _RIGHT, _BACK, _FRONT = (1.0, 0.0, 0.0), (-1.0, 0.0, 0.0), (0.0, 0.0, 1.0), (0.0, 0.0, -1.0)
_DOWN = (0.0, -1.0, 0.0)
_TILTED_M = 2.0 * math.hypot(0.25, 0.08)

BOOTH = Studio(
    name="booth",
    room=BoothRoom(),
    lamps=(
        # Above: one broad box, and two long ones on either side of it, tilted outwards.
        StudioLamp("box", (0.0, 2.6, 0.6), (1.5, 3.8), _DOWN, luminance=4.5, softness_m=0.15),
        StudioLamp("box", (2.3, 2.5, 0.0), (10.0, _TILTED_M), (0.08, -0.25, 0.0), luminance=6.0),
        StudioLamp("box", (-2.3, 2.5, 0.0), (10.0, _TILTED_M), (-0.08, -0.25, 0.0), luminance=6.0),
        # Sides: tall banks, the one at +x larger, so that a form has a light side and a dark one.
        StudioLamp("box", (4.1, 0.95, 1.7), (4.0, 2.5), _RIGHT, luminance=4.5, softness_m=0.12),
        StudioLamp("box", (-4.1, 1.1, 1.6), (0.9, 2.6), _LEFT, luminance=5.5),
        StudioLamp("box", (-4.1, 1.1, -2.6), (0.9, 2.6), _LEFT, luminance=5.5),
        # In front and behind: low boxes across the room.
        StudioLamp("box", (0.0, 1.5, 6.6), (5.2, 0.8), _FRONT, luminance=5.0),
        StudioLamp("box", (0.0, 1.7, -6.6), (3.2, 0.44), _BACK, luminance=4.0),
    ),
)


def booth(height: int = 512, samples: int = 4) -> ProceduralEnvironment:
    """Return the light booth; ``height`` rows, everything in it neutral."""
    description = (
        "A light booth: a grey room, 9 × 14 × 4.2 m, with soft boxes of 4 to 6 kcd/m², all neutral (D65)."
    )
    return dataclasses.replace(studio(BOOTH, height, samples), description=description)
