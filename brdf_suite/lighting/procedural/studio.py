"""Studio from its description: lamps before the walls of a room or a plain backdrop; two described ones.

The booth is a neutral room with large soft boxes, as paint is judged and photographed in: closed, 9 × 14 m and 4.2 m
high, seen from 0.9 m above the middle of its floor. All lamps and surfaces are neutral (D65); the walls are Munsell N7.
Long boxes along the room draw the lines that show a form; a broad box above gives the flop its highlight, and two tall
ones at the sides and one in front separate the flanks. The example is what ``brdf-suite environment studio --new``
writes: one lamp of each kind, to be edited.
"""

from __future__ import annotations

import dataclasses
import math

import numpy as np

from brdf_suite.appearance.light.matrix import lamp_colour
from brdf_suite.arrays import Floats
from brdf_suite.documents.studio import Backdrop, BoothRoom, Studio, StudioLamp
from brdf_suite.lighting.procedural.lamps import LampSurface, LitRoom
from brdf_suite.lighting.procedural.panorama import ProceduralEnvironment, draw, finish
from brdf_suite.progress import Progress


def studio(
    description: Studio, height: int = 512, samples: int = 4, progress: Progress | None = None
) -> ProceduralEnvironment:
    """Return the map of a studio, ``height`` rows, the mean of ``samples``² directions in each pixel.

    Raises
    ------
    Cancelled
        The progress callback asked for it.
    """
    # Nearer lamps are drawn over farther ones.
    lamps = sorted(
        (LampSurface.of(lamp) for lamp in description.lamps),
        key=lambda lamp: -float(lamp.centre @ lamp.centre),
    )
    room = None if description.room is None else LitRoom(description.room, lamps)
    backdrop = description.backdrop
    plain = np.zeros(3)
    if backdrop is not None:
        kelvin = backdrop.colour_temperature_k
        plain = backdrop.luminance * (np.ones(3) if kelvin is None else lamp_colour(kelvin))

    cones = [(lamp, lamp.centre / np.linalg.norm(lamp.centre), lamp.cone_cosine()) for lamp in lamps]

    def radiance(toward: Floats) -> Floats:
        light = room.radiance(toward) if room is not None else np.broadcast_to(plain, toward.shape).copy()
        places, flat = toward.reshape(-1, 3), light.reshape(-1, 3)  # of the same memory
        for lamp, middle, cosine in cones:
            near = np.flatnonzero(places @ middle >= cosine)
            covered, bright = lamp.seen(places[near])
            share = covered[:, None]
            flat[near] = flat[near] * (1.0 - share) + bright[:, None] * share * lamp.colour
        return light

    note = f"A studio: {description.name}; {len(lamps)} lamps."
    picture = draw(radiance, height, samples, progress)
    return finish(description.name, picture, note, absolute=description.unit == "kcd/m2")


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


EXAMPLE = Studio(
    name="My studio",
    backdrop=Backdrop(luminance=0.15),
    lamps=(
        StudioLamp(
            "box", (0.0, 3.0, 0.0), (2.0, 4.0), luminance=5.0, colour_temperature_k=5500.0, softness_m=0.2
        ),
        StudioLamp(
            "strip", (-2.5, 1.0, 1.5), (2.4, 0.25), roll_deg=90.0, luminance=8.0, colour_temperature_k=6500.0
        ),
        StudioLamp(
            "ring", (2.2, 1.2, 2.2), (1.2, 0.12), luminance=10.0, colour_temperature_k=3200.0, softness_m=0.02
        ),
    ),
)
