"""What the texture instrument is: its light, its eye, its scales, and what it sees of a paint's flakes.

All of it is the suite's own definition (docs/method/texture.md). The quantities are those that the preliminary scales
of Ferrero et al. (Optics Express 29, 2021) are made of: density and contrast of points in directed light, variance in
diffuse light. Makers' indices (Si, Sa, G) are proprietary, and nothing here is one of them.

The eye looks along the normal. Directed light comes from 15, 45 and 75° and is as wide as the sun; diffuse light is
even over the hemisphere, and the coat mirrors the eye, which is dark. The picture is luminance over its mean:

    1 + φ (X - 1),

φ the share of the surface's light that visible flakes send, X their light over the mean of all.
"""

from __future__ import annotations

import math
from dataclasses import asdict, dataclass
from functools import cached_property

import numpy as np

from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.appearance.flakes.tilt import flake_slope, tilt_bell, tilt_place
from brdf_suite.appearance.flakes.visible import (
    ASPECULAR,
    FLAKE_WAVINESS,
    LARGEST_SHARE,
    flake_dimming,
    full_density,
    mirrored_by_flakes,
    visible_density,
)
from brdf_suite.arrays import Floats
from brdf_suite.documents.paint import Flakes

LIGHTS_DEG = (15.0, 45.0, 75.0)
"""Polar angles of the directed lights; the eye is on the normal."""
DISTANCE_MM = 500.0
MINUTE_MM = DISTANCE_MM * math.radians(1.0 / 60.0)
"""One minute of arc on the surface."""
PIXEL_MM = 0.5 * MINUTE_MM
"""Pitch of the picture's pixels: half a minute of arc, as of the eye's cones."""
PUPIL_MM = 4.0
LIGHT_DEG = 0.53
"""Width of the directed light."""
VISIBLE_CONTRAST = 0.5
"""Over the mean of the picture; a place that is brighter by so much sparkles."""

# Standard deviations along an axis: one minute of arc at half height, and a pixel's square.
_EYE_MM = MINUTE_MM / math.sqrt(8.0 * math.log(2.0))
_SQUARE_MM = PIXEL_MM / math.sqrt(12.0)

BRIGHTNESS_2 = 1.5625
"""Mean square of a flake's brightness 2.5 u^1.5 (its depth), u even; its mean is 1."""
AREA_2 = 1.152
"""Mean square over squared mean of the polygons' areas, of the mosaic of flakes."""
AREA_SHAPE = 1.0 / (AREA_2 - 1.0)
"""Of the gamma distribution that stands for that of the areas."""


SCALE = "BRDF Suite texture 1"
"""Name in files of the definition: of optics, scales and threshold."""


@dataclass(frozen=True)
class Sparkle:
    """Reading in one directed light.

    Parameters
    ----------
    light_deg
        Polar angle of the light.
    points_per_mm2
        Local maxima of at least :data:`VISIBLE_CONTRAST`.
    area
        Share of the picture of at least that contrast, 0 to 1.
    intensity
        Mean contrast of the points; 0 without any.
    grade
        Root of the mean over the picture of the squared contrast, where it is at least that one: what sparkles add to
        the picture's contrast.
    """

    light_deg: float
    points_per_mm2: float
    area: float
    intensity: float
    grade: float


@dataclass(frozen=True)
class TextureReadings:
    """Sparkle in each of :data:`LIGHTS_DEG`; graininess: standard deviation over mean in diffuse light."""

    sparkle: tuple[Sparkle, ...]
    graininess: float

    def scales(self) -> Floats:
        """Return (4,) the grades, and graininess: what flakes are looked for by."""
        return np.array([*(one.grade for one in self.sparkle), self.graininess])

    def by_name(self) -> dict[str, float]:
        """Return every number by its name in files, as ``sparkle_15.grade``, and ``graininess``."""
        found = {
            f"sparkle_{one.light_deg:g}.{part}": value
            for one in self.sparkle
            for part, value in asdict(one).items()
            if part != "light_deg"
        }
        return found | {"graininess": self.graininess}

    def to_json(self) -> dict[str, object]:
        """Return plain values; areas, grades and graininess as shares of 1."""
        sparkle = [asdict(one) for one in self.sparkle]
        return {"scale": SCALE, "sparkle": sparkle, "graininess": self.graininess}


NO_TEXTURE = TextureReadings(tuple(Sparkle(light, 0.0, 0.0, 0.0, 0.0) for light in LIGHTS_DEG), 0.0)
"""Of a paint without flakes."""


@dataclass(frozen=True)
class Speckle:
    """What one directed light makes of the flakes: a picture 1 + φ (X - 1).

    Parameters
    ----------
    share
        φ.
    per_mm2
        Flakes that mirror any of the light to the eye.
    spread_mm
        Standard deviation along an axis of one flake's image.
    """

    share: float
    per_mm2: float
    spread_mm: float

    @property
    def crowding(self) -> float:
        """The flakes within the area 4π spread² of one image."""
        return 4.0 * math.pi * self.spread_mm**2 * self.per_mm2


@dataclass(frozen=True)
class Grain:
    """What diffuse light makes of the flakes: polygons, of which a share ``lit`` is a bright flake."""

    share: float
    cells_per_mm2: float
    lit: float
    spread_mm: float


@dataclass(frozen=True, eq=False)
class PaintLight:
    """What a paint sends beside which its flakes are seen, f_r in 1/sr, of directed lights over γ.

    Parameters
    ----------
    ior, theta
        Index of the coat, and the light's polar angle that the base holds for, radians.
    gamma
        (k,) radians, rising, of ``base``.
    base
        (k, 3) of the base below the coat, working space.
    whole
        (3, 3) of the whole paint in each of :data:`LIGHTS_DEG`.
    """

    ior: float
    theta: float
    gamma: Floats
    base: Floats
    whole: Floats

    @cached_property
    def lights(self) -> Floats:
        """The base (3, 3) in each of :data:`LIGHTS_DEG`."""
        return self._base_at(np.radians(LIGHTS_DEG))

    @cached_property
    def peak(self) -> float:
        """The base's largest channel at the angle that flakes are dimmed for."""
        return float(self._base_at(np.array([ASPECULAR])).max())

    @cached_property
    def diffuse(self) -> tuple[Floats, Floats, Floats]:
        """Of light from 0 to 90°: the slope (91,) of flakes that mirror it, the base (91, 3), and its luminance (91,)
        times the light there is.
        """
        theta = np.linspace(0.0, 0.5 * math.pi, 91)
        sine = np.sin(theta)
        slope = sine / (np.sqrt(self.ior**2 - sine**2) + self.ior)
        base = self._base_at(theta)
        return slope, base, base @ LUMINANCE * (sine * np.cos(theta))

    def _base_at(self, gamma: Floats) -> Floats:
        return np.stack([np.interp(gamma, self.gamma, self.base[:, k]) for k in range(3)], axis=-1)


def speckle(paint: PaintLight, flakes: Flakes, light_deg: float) -> Speckle:
    """Return what the light from ``light_deg``, one of :data:`LIGHTS_DEG`, makes of a paint's flakes."""
    theta = math.radians(light_deg)
    slope = flake_slope([-math.sin(theta), 0.0, math.cos(theta)], [0.0, 0.0, 1.0], paint.ior)
    _, stretch = tilt_place(slope, flakes.roughness)
    # What a mirror below the coat makes of an angle outside is 1 / (2n) of it as a tilt.
    widths = (math.radians(LIGHT_DEG), PUPIL_MM / DISTANCE_MM)
    outside = math.hypot(*(width / 4.0 for width in widths)) / (2.0 * paint.ior)
    sigma = float(stretch) * math.hypot(FLAKE_WAVINESS, outside)
    at = LIGHTS_DEG.index(light_deg)
    base, whole = paint.lights[at], paint.whole[at]
    part = _part_of(base.max(keepdims=True), (slope**2).sum(keepdims=True), paint, flakes)
    share = min(float(part[0] * (base @ LUMINANCE) / max(whole @ LUMINANCE, 1e-12)), 1.0)
    # Tilts are even over a disc of the area π/4; those within √8 σ of the mirroring one are lit.
    return Speckle(share, 32.0 * visible_density(flakes) * sigma**2, _image_mm(flakes))


def grain(paint: PaintLight, flakes: Flakes) -> Grain:
    """Return what diffuse light makes of a paint's flakes."""
    slope, base, light = paint.diffuse
    part = _part_of(base.max(axis=-1), slope**2, paint, flakes)
    share = min(float(part @ light) / max(float(light.sum()), 1e-12), 1.0)
    # A flake tilted beyond that mirrors nothing, or the dark below the horizon.
    above = -math.expm1(-((slope[-1] / flakes.roughness) ** 2))
    full = full_density(flakes.size_um)
    return Grain(
        share,
        full,
        min(visible_density(flakes) / full, 1.0) * above,
        _image_mm(flakes),
    )


def _image_mm(flakes: Flakes) -> float:
    """Spread of a flake's image: of eye and pixel, and of the disc itself."""
    return math.hypot(_EYE_MM, _SQUARE_MM, 0.25e-3 * flakes.size_um)


def _part_of(base: Floats, slope2: Floats, paint: PaintLight, flakes: Flakes) -> Floats:
    """Return the part (n,) of a base, f_r (n,) of its largest channel, that visible flakes send."""
    dimming = flake_dimming(flakes, paint.peak, paint.ior, paint.theta)
    peak = dimming * mirrored_by_flakes(flakes, paint.ior, paint.theta)
    wanted = peak * tilt_bell(slope2, flakes.roughness)
    return np.asarray(np.minimum(wanted / np.maximum(base, 1e-12), LARGEST_SHARE))
