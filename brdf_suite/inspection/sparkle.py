"""The suite's own sparkle figure: spots per mm² above a stated contrast, and how bright they are.

It is ours, worked out from the model of single flakes that the Viewer draws; it is no reading of an instrument.
Instruments report figures of their own (their ways are not published), with which these numbers must not be compared.
The picture itself shows as many from near; from farther away, where one drawn flake stands for several, it shows fewer
and brighter ones.

Looked at is a paint in the sun (half a degree wide, 45° off its normal, no other light), by an eye 500 mm away that
takes in one minute of arc at once, 0.145 mm. A spot is a flake that is at least half as bright again there as the
surface around it: contrast 0.5.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.appearance.flakes.glints import Spots, spots
from brdf_suite.appearance.flakes.tilt import flake_slope, tilt_place
from brdf_suite.appearance.flakes.visible import FLAKE_WAVINESS, visible_density
from brdf_suite.documents.paint import Flakes
from brdf_suite.fitting.lobes.weights import LobeWeights
from brdf_suite.geometry.directions import aspecular_view, illumination
from brdf_suite.realtime.lights.block import visible_flake_lobe
from brdf_suite.reflectance.models.cosine_lobes import lobe_sums

ANGLES_DEG = (15.0, 45.0, 75.0)
"""Aspecular angles at which the figure is reported."""
CONTRAST = 0.5
DISTANCE_MM = 500.0
RESOLVED_MM = DISTANCE_MM * math.tan(math.radians(1.0 / 60.0))
"""One minute of arc from that distance."""
CROWDED = 0.3
"""Spots in one footprint above which they run together and are not counted one by one any more."""

_LIGHT_DEG = 45.0
# Of a disc 0.53° wide, along one axis: a quarter of its diameter.
_SUN_SPREAD = math.radians(0.53) / 4.0


@dataclass(frozen=True)
class SparkleReadings:
    """The figure at one aspecular angle; ``crowded``: spots overlap, and what is seen is a grain, not spots."""

    aspecular_deg: float
    spots_per_mm2: float
    mean_contrast: float
    crowded: bool


def sparkle(weights: LobeWeights, flakes: Flakes | None) -> tuple[SparkleReadings, ...]:
    """Return the figure of a paint at each of :data:`ANGLES_DEG`, from its fit; zeros without flakes."""
    if flakes is None:
        return tuple(SparkleReadings(angle, 0.0, 0.0, False) for angle in ANGLES_DEG)
    # What visible flakes reflect of all light, by luminance, at each of the angles.
    wi, wo = illumination(_LIGHT_DEG), aspecular_view(_LIGHT_DEG, np.array(ANGLES_DEG))
    sums = lobe_sums(wi, wo, weights.exponents, weights.kd, weights.kdd, weights.kg)
    gamma = np.radians(ANGLES_DEG)
    base = sums.base
    single = visible_flake_lobe(flakes, gamma, base, weights.theta_fit_rad, weights.ior)
    whole = np.maximum(sums.brdf() @ LUMINANCE, 1e-12)
    shares = np.asarray(np.minimum(single @ LUMINANCE / whole, 1.0))
    found = []
    for angle, share in zip(ANGLES_DEG, shares.tolist(), strict=True):
        one = _spots(angle, share, weights.ior, flakes)
        found.append(SparkleReadings(angle, one.per_mm2, one.mean_contrast, one.per_footprint > CROWDED))
    return tuple(found)


def _spots(angle_deg: float, share: float, ior: float, flakes: Flakes) -> Spots:
    slope = flake_slope(illumination(_LIGHT_DEG), aspecular_view(_LIGHT_DEG, angle_deg), ior)
    _, stretch = tilt_place(slope, flakes.roughness)
    # A light's extent, seen by a mirror below the coat, is a spread of the mirror's tilt of 1 / (2 n) of it.
    spread = math.hypot(FLAKE_WAVINESS, _SUN_SPREAD / (2.0 * ior))
    return spots(
        density=visible_density(flakes),
        size=flakes.size_um * 1e-3,
        stretch=float(stretch),
        spread=spread,
        share=share,
        footprint=RESOLVED_MM,
        contrast=CONTRAST,
    )
