"""Normal at the light's reflection in the sphere, halfway between light and camera, from one photograph.

The brightest pixel is not that place. With f_r = D(n·h) F G / (cosθi cosθo) the radiance times cosθo is in proportion
to D alone, as F and G hardly change over a highlight that is seen and lit from nearly the same directions; and D of an
isotropic paint is even about the half vector. So the centre of gravity of radiance · cosθo above a share of its peak,
over the solid angle of the *normals* (a pixel covers 1/cosθo of it), is the half vector, whatever the width of the
lobes. The falling off of the light with the distance is taken out before.

How far that place wanders with the share shows how reliable it is. Near the outline a narrow highlight is
foreshortened to a pixel or two, and stands on the broader lobes' own brightness: then there is no other share to ask,
or few columns to weigh, and the standard error grows to that of a place of which nothing but the pixel is known.

A clipped peak keeps its place: all is cut off at the least that its clipped pixels show, so that what is left of it is
as even about the half vector as the whole.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt
from scipy.ndimage import binary_dilation, label, uniform_filter

from brdf_suite.acquisition.geometry.lens import lens_pixels
from brdf_suite.acquisition.geometry.sphere.placement import RigGeometry, unit
from brdf_suite.arrays import Bools, Floats

_WINDOW = 0.22  # half, in radii of the sphere
_LEAST_WINDOW = 8.0
_CLIMBS = 12
# The first is taken, how far the others differ is the doubt. A spot of few pixels is looked at further down.
_LEVELS = ((0.5, 0.3, 0.7), (0.2, 0.12, 0.3), (0.08, 0.05, 0.12))
_ENOUGH_PIXELS = 16
_LEAST_COSINE = 0.12
_LEAST_PIXELS = 4
_WIDEST_DEG = 20.0
_FLOOR_PX = 0.03
_ONE_PIXEL_PX = 1.0 / math.sqrt(12.0)  # standard deviation of a place of which only the pixel is known


@dataclass(frozen=True)
class Highlight:
    """The reflection of the light in the sphere at one position.

    Attributes
    ----------
    position
        Index of the light's position.
    pixel
        (2,) x and y of the sphere's point whose normal is the half vector.
    sigma_px
        Standard error, pixels.
    spread_deg
        Root mean square angle of the normals over the brighter half of the highlight to its centre.
    pixels
        How many pixels that is.
    """

    position: int
    pixel: tuple[float, float]
    sigma_px: float
    spread_deg: float
    pixels: int


def find_highlight(
    radiance: npt.NDArray[np.floating],
    geometry: RigGeometry,
    k: int,
    valid: Bools | None = None,
    clipped: Bools | None = None,
) -> Highlight | None:
    """Return the highlight of position ``k`` in its merged photograph (h, w, 3) or (h, w).

    ``valid`` (h, w) is False where the mask hides something. ``clipped`` (h, w) is True where the radiance is only a
    lower bound; such pixels are used where ``valid`` lets them.
    None where none is seen, where it reaches the outline, the lamp's shadow or what is masked, or where the paint has
    no highlight.
    """
    value = radiance if radiance.ndim == 2 else radiance.mean(axis=-1)
    light = geometry.light(geometry.angles_deg[k])
    start = geometry.highlights(geometry.angles_deg[k])
    if not np.all(np.isfinite(start)):
        return None
    half = max(_WINDOW * math.tan(geometry.outline_angle) * geometry.lens.fx, _LEAST_WINDOW)
    middle = start
    for _ in range(_CLIMBS):
        window = _Window.around(middle, half, value, geometry, light, valid, clipped)
        if window is None:
            return None
        peak = window.peak()
        if not window.at_border(peak):
            break
        middle = window.pixels[peak]
    else:
        return None
    window = window.levelled(peak)
    places: list[_Spot | None] = []
    for levels in _LEVELS:
        lower = [window.centre(peak, level) for level in levels]
        first = lower[0]
        if first is None:
            continue
        places = lower
        if first.pixels >= _ENOUGH_PIXELS:
            break
    if not places or places[0] is None:
        return None
    spread, count = places[0].spread, places[0].pixels
    seen = [place.normal for place in places if place is not None]
    pixel, *others = lens_pixels(geometry.lens, geometry.centre + geometry.radius_m * np.array(seen))
    wander = max((float(np.linalg.norm(other - pixel)) for other in others), default=0.0)
    # Without the others, cut by the outline or lost in a broader lobe, only the pixel is known; with one, something.
    alone = _ONE_PIXEL_PX * (1.0 - len(others) / (len(places) - 1)) ** 2
    if math.degrees(spread) > _WIDEST_DEG:
        return None
    return Highlight(
        position=k,
        pixel=(float(pixel[0]), float(pixel[1])),
        sigma_px=math.hypot(_FLOOR_PX, wander, alone, _ONE_PIXEL_PX / places[0].across ** 3),
        spread_deg=math.degrees(spread),
        pixels=count,
    )


@dataclass(frozen=True)
class _Window:
    """The pixels around a highlight: (h, w) each, with the sphere's normals."""

    pixels: Floats
    normals: Floats
    cos_o: Floats
    usable: Bools
    strength: Floats
    clipped: Bools

    @classmethod
    def around(
        cls,
        middle: Floats,
        half: float,
        value: npt.NDArray[np.floating],
        geometry: RigGeometry,
        light: Floats,
        valid: Bools | None,
        clipped: Bools | None,
    ) -> _Window | None:
        """Return the window of ``half`` pixels to each side, or None outside of the picture."""
        low = np.maximum(np.floor(middle - half), 0).astype(int)
        high = np.minimum(np.ceil(middle + half) + 1, value.shape[::-1]).astype(int)
        if np.any(high - low < 3):
            return None
        rows, columns = slice(low[1], high[1]), slice(low[0], high[0])
        pixels = np.stack(np.meshgrid(np.arange(low[0], high[0]), np.arange(low[1], high[1])), axis=-1)
        rays, points, rest = geometry.meet(pixels)
        normals = unit(points - geometry.centre)
        cos_o = np.einsum("...i,...i", normals, -rays)
        way = light - points
        distance2 = np.einsum("...i,...i", way, way)
        cos_i = np.einsum("...i,...i", normals, way) / np.sqrt(distance2)
        usable = (rest > 0.0) & (cos_o > _LEAST_COSINE) & (cos_i > _LEAST_COSINE)
        if valid is not None:
            usable &= valid[rows, columns]
        seen = value[rows, columns].astype(float)
        usable &= np.isfinite(seen)
        strength = np.where(usable, seen * cos_o * distance2, 0.0)
        bound = np.zeros(usable.shape, bool) if clipped is None else clipped[rows, columns] & usable
        return cls(pixels.astype(float), normals, cos_o, usable, strength, bound)

    def levelled(self, peak: tuple[int, int]) -> _Window:
        """Return the window cut off at the least that a clipped pixel of the peak at ``peak`` shows.

        A clipped pixel's strength is its cosθo, which falls to the outline: the peak would lean. Cut off at one height
        it is even about the half vector again.
        """
        labels, _ = label(self.clipped, np.ones((3, 3)))
        row, column = peak
        near = np.unique(labels[max(row - 1, 0) : row + 2, max(column - 1, 0) : column + 2])
        bound = np.isin(labels, near[near > 0])
        if not bound.any():
            return self
        return replace(self, strength=np.minimum(self.strength, self.strength[bound].min()))

    def peak(self) -> tuple[int, int]:
        """Return row and column of the brightest pixel where nine together are brightest."""
        smooth = uniform_filter(self.strength, 3, mode="constant")
        row, column = np.unravel_index(int(np.argmax(smooth)), smooth.shape)
        top, left = max(int(row) - 1, 0), max(int(column) - 1, 0)
        near = self.strength[top : int(row) + 2, left : int(column) + 2]
        row, column = np.unravel_index(int(np.argmax(near)), near.shape)
        return top + int(row), left + int(column)

    def at_border(self, place: tuple[int, int]) -> bool:
        """Return whether a place lies in the window's outer tenth."""
        rows, columns = self.strength.shape
        margin = max(2, min(rows, columns) // 10)
        return not (margin <= place[0] < rows - margin and margin <= place[1] < columns - margin)

    def centre(self, peak: tuple[int, int], level: float) -> _Spot | None:
        """Return what is brighter than ``level`` of the peak and touches it."""
        top = float(uniform_filter(self.strength, 3, mode="constant")[peak])
        top = max(top, 0.5 * float(self.strength[peak]))
        if not top > 0.0:
            return None
        labels, _ = label(self.strength > level * top)
        if labels[peak] == 0:
            return None
        spot = labels == labels[peak]
        around = binary_dilation(spot, np.ones((3, 3), bool))
        cut = spot[0].any() or spot[-1].any() or spot[:, 0].any() or spot[:, -1].any()
        if cut or not self.usable[around].all() or np.count_nonzero(spot) < _LEAST_PIXELS:
            return None
        # A pixel across the level counts by how far it is above: no jumps with the noise.
        weight = (self.strength[spot] - level * top) / self.cos_o[spot]
        weight /= weight.sum()
        normals = self.normals[spot]
        middle = unit(weight @ normals)
        off = np.linalg.norm(normals - middle, axis=-1)
        from_middle = self.pixels[spot] - weight @ self.pixels[spot]
        narrow = float(np.linalg.eigvalsh(from_middle.T @ (weight[:, None] * from_middle))[0])
        wide, across = math.sqrt(float(weight @ (off * off))), math.sqrt(1.0 + 12.0 * max(narrow, 0.0))
        return _Spot(middle, wide, int(np.count_nonzero(spot)), across)


@dataclass(frozen=True)
class _Spot:
    """The pixels above a level: mean normal (3,), RMS angle to it, count.

    ``across``: pixels side by side where the spot is narrowest, as wide as an even row of the same variance.
    """

    normal: Floats
    spread: float
    pixels: int
    across: float
