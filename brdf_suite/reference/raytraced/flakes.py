"""Sparkling flakes: normals from a texture in surface coordinates, faded with distance (section 5.2).

The counterpart of ``flake_texture.glsl``: the same hash, so the same flakes
as in the real-time picture's flake texture, and the same in every frame. Each light is multiplied by how bright the
flakes of the pixel are in it over their mean, for the share of the broad part that flakes which can be counted send;
its mean over the surface is 1, so flakes neither add light nor take it. The share is that of
``realtime/material/flake_share.py``,

    f = c R T(θi) T(θo) bell(δ) / (8π m² n² cosθi' cosθo'),

at both directions instead of the mirror direction alone (θ' below the coat), at most nine tenths of the broad part.
"""

from __future__ import annotations

from brdf_suite.reference.bsdfs import directions as d
from brdf_suite.reference.bsdfs.directions import Colour, Real, Vector
from brdf_suite.reference.flakes.population import FlakeLayer
from brdf_suite.reference.flakes.texture import FlakesSeen, seen_ratio
from brdf_suite.reference.mitsuba_modules import dr


def sparkling(
    layer: FlakeLayer, seen: FlakesSeen, light: Vector, view: Vector, light_spread: Real, base: Colour
) -> Colour:
    """Return the broad value ``base`` (1/sr) of a light as the flakes of a pixel send it.

    ``light_spread`` is the light's, radians along one axis.
    """
    # A light's spread moves the tilt by half of it, less what refraction takes.
    spread2 = dr.square(light_spread * d.number(0.5 / layer.ior)) + d.number(layer.waviness**2)
    ratio = seen_ratio(layer.flakes, seen, d.slope_between(light, view, layer.ior), spread2)
    return base + layer.visible_part(base, light, view) * (ratio - 1.0)
