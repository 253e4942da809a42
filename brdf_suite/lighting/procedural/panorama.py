"""Rendering of radiance as a function of direction to a latitude-longitude map, with its illuminances.

Inside this folder luminances are in kcd/m² and colours linear in the working space, scaled so that their
luminance (:data:`~brdf_suite.appearance.colour.colorimetry.LUMINANCE`) is that figure. The picture is then scaled so
that 1 is the luminance of a perfectly white card that lies flat in the middle of the scene: as an incident-light
meter would expose it, so that every environment suits exposure 0. The scale is kept as ``white_luminance``.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from brdf_suite.appearance.colour.colorimetry import LUMINANCE, WORKING_TO_XYZ
from brdf_suite.arrays import Floats
from brdf_suite.progress import Progress, report

Radiance = Callable[[Floats], Floats]
"""Unit directions (..., 3) in, linear working-space radiance (..., 3) in kcd/m² out."""

_LARGEST_HALF = 65504.0


@dataclass(frozen=True, eq=False)
class ProceduralEnvironment:
    """A generated environment.

    Attributes
    ----------
    name
        Its name among the packaged environments.
    radiance
        (h, 2h, 3) float32, linear Rec. 2020 with D65 white; row 0 is up, the centre column looks along +z.
    white_luminance
        cd/m² of the value (1, 1, 1), which is a white card lying flat; ``None`` where it was drawn in no unit.
    description
        What it shows and what its luminances come from.
    """

    name: str
    radiance: NDArray[np.float32]
    white_luminance: float | None
    description: str

    @property
    def comment(self) -> str:
        """The description and the scale, for the file."""
        if self.white_luminance is None:
            return self.description
        return f"{self.description} The value 1.0 is {self.white_luminance:,.0f} cd/m²."

    def stored(self) -> NDArray[np.floating]:
        """Return the radiance as it is stored: half precision where all of it fits, the sun too."""
        if float(self.radiance.max()) < 0.9 * _LARGEST_HALF:
            return self.radiance.astype(np.float16)
        return self.radiance


def directions(rows: Floats, columns: Floats) -> Floats:
    """Return unit directions (r, c, 3) at places (0…1) down and across a latitude-longitude map."""
    theta = np.pi * rows[:, None]
    phi = 2.0 * np.pi * (columns[None, :] - 0.5)
    y = np.broadcast_to(np.cos(theta), np.broadcast_shapes(theta.shape, phi.shape))
    return np.stack([-np.sin(theta) * np.sin(phi), y, np.sin(theta) * np.cos(phi)], axis=-1)


def centres(count: int) -> Floats:
    """Return the places of ``count`` pixel centres along a side of length 1."""
    return (np.arange(count) + 0.5) / count


def solid_angles(height: int) -> Floats:
    """Return the solid angle of a pixel in each row, (height, 1), sr; over the map they sum to 4π."""
    edges = np.cos(np.pi * np.arange(height + 1) / height)
    return np.asarray((edges[:-1] - edges[1:])[:, None] * np.pi / height)


def draw(radiance: Radiance, height: int, samples: int = 4, progress: Progress | None = None) -> Floats:
    """Return the map (height, 2·height, 3): the mean of ``samples``² directions in each pixel."""
    width = 2 * height
    across = centres(width * samples)
    down = centres(height * samples).reshape(height, samples)
    picture = np.empty((height, width, 3))
    for row in range(height):
        if row % 16 == 0:
            report(progress, row / height, "drawing the light")
        fine = radiance(directions(down[row], across)).reshape(samples, width, samples, 3)
        # Added one by one: a mean along short axes takes several times as long.
        picture[row] = sum(fine[i, :, j] for i in range(samples) for j in range(samples)) / samples**2
    return picture


def horizontal_illuminance(picture: NDArray[np.floating]) -> float:
    """Return the illuminance from above on a flat card: kilolux for a picture in kcd/m²."""
    height, width = picture.shape[:2]
    cosine = np.maximum(directions(centres(height), centres(width))[..., 1], 0.0)
    luminance = picture.astype(np.float64) @ LUMINANCE
    return float((luminance * cosine * solid_angles(height)).sum())


def finish(name: str, picture: Floats, description: str, *, absolute: bool = True) -> ProceduralEnvironment:
    """Scale a picture in kcd/m², or without unit where it is not ``absolute``, so that a white card is 1.

    Where next to nothing falls on a flat card, as with one lamp below it, the mean over the sphere counts instead.
    """
    white = horizontal_illuminance(picture) / np.pi
    mean = float((picture @ LUMINANCE * solid_angles(len(picture))).sum()) / (4.0 * np.pi)
    white = white if white > 1e-3 * mean else mean
    shown = (picture / white).astype(np.float32)
    return ProceduralEnvironment(name, shown, white * 1000.0 if absolute else None, description)


def colour_from_chromaticity(x: float | Floats, y: float | Floats) -> Floats:
    """Return the working-space colour (..., 3) of unit luminance with CIE 1931 chromaticity (x, y)."""
    x, y = np.asarray(x, dtype=np.float64), np.asarray(y, dtype=np.float64)
    xyz = np.stack([x / y, np.ones_like(y), (1.0 - x - y) / y], axis=-1)
    return np.asarray(xyz @ np.linalg.inv(WORKING_TO_XYZ).T)


def mix(first: Floats, second: Floats, share: Floats) -> Floats:
    """Return colours (..., 3) that go from ``first`` to ``second`` as ``share`` (...) goes from 0 to 1."""
    part = np.asarray(share)[..., None]
    return np.asarray(first * (1.0 - part) + second * part)


def edge(x: Floats, width: float) -> Floats:
    """Return a soft step: 0 below -width/2, 1 above width/2, smooth between."""
    t = np.clip(x / width + 0.5, 0.0, 1.0)
    return np.asarray(t * t * (3.0 - 2.0 * t))
