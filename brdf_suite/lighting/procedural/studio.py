"""Studio from its description: lamps before the walls of a room or a plain backdrop."""

from __future__ import annotations

import numpy as np

from brdf_suite.appearance.light.colour_temperature import lamp_colour
from brdf_suite.arrays import Floats
from brdf_suite.documents.studio import Studio
from brdf_suite.lighting.procedural.lamps import LampSurface
from brdf_suite.lighting.procedural.panorama import ProceduralEnvironment, draw, finish
from brdf_suite.lighting.procedural.room import LitRoom
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
        for lamp, middle, cosine in cones:
            near = toward @ middle >= cosine
            covered, bright = lamp.seen(toward[near])
            share = covered[:, None]
            light[near] = light[near] * (1.0 - share) + bright[:, None] * share * lamp.colour
        return light

    note = f"A studio: {description.name}; {len(lamps)} lamps."
    picture = draw(radiance, height, samples, progress)
    return finish(description.name, picture, note, absolute=description.unit == "kcd/m2")
