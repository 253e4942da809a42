"""Sky from its description: one of three published models over a plain ground, with the sun's disc.

The sun is that of Hošek and Wilkie (2013) for both clear skies: it knows the haze, and the papers of Preetham et al.
give theirs only through tables of absorption. The ground is even and matt and lit by all that is above it.
"""

from __future__ import annotations

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.documents.studio import Sky
from brdf_suite.lighting.procedural.daylight import overcast_sky
from brdf_suite.lighting.procedural.hosek_wilkie import HosekWilkieSky
from brdf_suite.lighting.procedural.panorama import (
    ProceduralEnvironment,
    Radiance,
    centres,
    directions,
    draw,
    edge,
    finish,
    mix,
    solid_angles,
)
from brdf_suite.lighting.procedural.preetham import sky_radiance
from brdf_suite.lighting.procedural.sun import LimbDisc, Sun
from brdf_suite.progress import Progress, subrange

CITATIONS = {
    "hosek_wilkie": "Hošek and Wilkie 2012 and 2013",
    "preetham": "Preetham, Shirley and Smits 1999; sun of Hošek and Wilkie 2013",
    "overcast": "CIE S 011, type 16 (Moon and Spencer 1942)",
}
_HORIZON = 0.004


def build_sky(description: Sky) -> Radiance:
    """Return the radiance of the sky alone, without ground and disc, kcd/m²."""
    sun = Sun(description.sun_elevation_deg, description.sun_azimuth_deg).direction
    if description.model == "hosek_wilkie":
        return HosekWilkieSky(sun, description.turbidity, description.ground_albedo).radiance
    if description.model == "preetham":
        return lambda toward: sky_radiance(toward, sun, description.turbidity)
    return overcast_sky


def sky(
    description: Sky, height: int = 512, samples: int = 2, progress: Progress | None = None
) -> ProceduralEnvironment:
    """Return the map of a sky, ``height`` rows, the mean of ``samples``² directions in each pixel.

    Raises
    ------
    Cancelled
        The progress callback asked for it.
    """
    above = build_sky(description)
    sun = Sun(description.sun_elevation_deg, description.sun_azimuth_deg)
    clear = description.model != "overcast"
    disc = LimbDisc(sun, description.turbidity) if clear else None
    toward = directions(centres(128)[:64], centres(256))
    cosine = toward[..., 1] * solid_angles(128)[:64]
    light = np.einsum("rc,rck->k", cosine, above(toward))
    if disc is not None:
        # The ground is lit whether or not the disc is drawn.
        light += disc.illuminance() * sun.direction[1]
    ground = light * description.ground_albedo / np.pi

    def radiance(toward: Floats) -> Floats:
        up = toward[..., 1]
        if up.max() < -_HORIZON:
            return np.broadcast_to(ground, toward.shape)
        return mix(np.broadcast_to(ground, toward.shape), above(toward), edge(up, _HORIZON))

    picture = draw(radiance, height, samples, subrange(progress, 0.0, 0.9))
    if disc is not None and description.sun_disc:
        picture = disc.add_to(picture)
    haze = (
        f", turbidity {description.turbidity:g}, sun {description.sun_elevation_deg:g}° high" if clear else ""
    )
    note = f"A sky: {CITATIONS[description.model]}{haze}, ground albedo {description.ground_albedo:g}."
    return finish(description.name, picture, note)
