"""The light that aspecular angles refer to: the strongest one there is."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from brdf_qt.program.translation import tr

from brdf_suite.documents.view import View
from brdf_suite.geometry.polar import point_at
from brdf_suite.lighting.statistics import EnvironmentStatistics

Vector = tuple[float, float, float]


@dataclass(frozen=True)
class DominantLight:
    """``words`` names it for the user; ``towards`` is a unit vector in the world, or None for ``position`` (m)."""

    words: str
    towards: Vector | None
    position: Vector | None = None

    def seen_from(self, point: Vector) -> Vector:
        """Return the unit vector from a point to the light."""
        if self.towards is not None:
            return self.towards
        assert self.position is not None
        away = np.subtract(self.position, point)
        x, y, z = (float(v) for v in away / max(float(np.linalg.norm(away)), 1e-12))
        return (x, y, z)


def dominant_light(view: View, figures: EnvironmentStatistics | None) -> DominantLight | None:
    """Return the strongest lamp of the view, or the environment's sun or lamp where that is stronger.

    They are compared by the illuminance of a surface that faces them, a point lamp at 1 m. None where the
    environment is even, or not yet known, and there is no lamp.
    """
    sun = 0.0
    if figures is not None and figures.sun_direction is not None:
        sun = figures.sun_share * 4.0 * math.pi * figures.average_luminance
    lamps = [(math.pi * lamp.strength, number, lamp) for number, lamp in enumerate(view.lamps, 1)]
    strongest = max(lamps, key=lambda item: item[0], default=None)
    if strongest is not None and strongest[0] >= sun and strongest[0] > 0.0:
        _, number, lamp = strongest
        if lamp.kind == "point":
            return DominantLight(tr("point lamp {number}").format(number=number), None, lamp.position)
        towards = point_at(lamp.azimuth_deg, lamp.elevation_deg, 1.0)
        words = tr("lamp {number}, elevation {elevation:.0f}°")
        return DominantLight(words.format(number=number, elevation=lamp.elevation_deg), towards)
    if figures is None or figures.sun_direction is None or figures.sun_elevation_deg is None:
        return None
    turned = (figures.sun_azimuth_deg or 0.0) + view.rotation_deg
    words = tr(
        "the main light, elevation {elevation:.0f}°, azimuth {azimuth:.0f}° ({share:.0f} % of the environment)"
    ).format(elevation=figures.sun_elevation_deg, azimuth=turned % 360.0, share=100.0 * figures.sun_share)
    return DominantLight(words, point_at(turned, figures.sun_elevation_deg, 1.0))
