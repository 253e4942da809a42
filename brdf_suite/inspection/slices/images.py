"""Cuts through a reflectance along two angles, as images: the hemisphere of views, and the half-angle slice.

- **Unrolled** (Westlund and Meyer, figure 4): every view of one light on the unit square, by the concentric map
  (:mod:`brdf_suite.geometry.concentric`): equal areas are equal solid angles. The middle is the normal, the edge the
  horizon; the right is the mirror direction's side of the plane of incidence at azimuth 0, up is +y.
- **Half-angle** (the image slice of Burley 2012): θh to the right, either evenly or by its root, as measured tables
  have it, θd upwards, at one φd. Left is the mirror configuration, the top left grazing reflection.

Images are (rows, columns, 3) f_r in 1/sr, row 0 at the top, one value for each pixel's middle. The pixel that holds the
mirror direction is taken at that direction itself: a spike narrower than a pixel would be missed as a rule.

A reflectance spans five decades, a screen two. Two ways to show one: **gamma** shows what lies below a white value with
the screen's curve, so that ratios near white look as they are; **log** shows the decades below it evenly, and keeps the
ratios of the channels.
"""

from __future__ import annotations

import functools
from dataclasses import dataclass
from typing import Literal

import numpy as np
import numpy.typing as npt

from brdf_suite.appearance.colour.colorimetry import LUMINANCE, WORKING_TO_SRGB, srgb_decode, srgb_encode
from brdf_suite.arrays import Bools, Bytes, Floats
from brdf_suite.geometry.concentric import hemisphere_to_square, square_to_hemisphere
from brdf_suite.geometry.directions import from_half_angle_coordinates, mirror
from brdf_suite.inspection.slices.cuts import light_at
from brdf_suite.inspection.slices.values import Cosine, Evaluated, cosine_of

SEED_INCIDENCES_DEG = (10.0, 40.0, 70.0)
"""Those of the paper's figure 4."""


@dataclass(frozen=True, eq=False)
class Pairs:
    """Pairs of an image: ``wi`` (..., 3) and ``wo`` (rows, columns, 3), and ``above`` (rows, columns)."""

    wi: Floats
    wo: Floats
    above: Bools


def unrolled_pairs(theta_deg: float, phi_deg: float, size: int) -> Pairs:
    """Return the pairs of the unrolled hemisphere of views, ``size`` pixels square, for one light."""
    wi = light_at(theta_deg, phi_deg)
    wo = _views(size).copy()
    there = mirror(wi)
    column, row = place_of(there, size)
    wo[row, column] = there
    return Pairs(wi, wo, np.ones((size, size), np.bool_))


def place_of(view: Floats, size: int) -> tuple[int, int]:
    """Return (column, row) of the pixel that holds the direction ``view`` (3,)."""
    u, v = np.clip((hemisphere_to_square(view) * size).astype(int), 0, size - 1).tolist()
    return u, size - 1 - v


def view_of(x: float, y: float) -> Floats:
    """Return the view (3,) at a place of the unrolled image, x to the right and y **down**, both 0…1."""
    return square_to_hemisphere([x, 1.0 - y])


def half_angle_pairs(phi_d_deg: float, phi_deg: float, size: int, *, by_root: bool) -> Pairs:
    """Return the pairs of the half-angle slice at φd, the half vector in the plane of azimuth ``phi_deg``."""
    middle = (np.arange(size) + 0.5) / size
    theta_h = theta_h_at(middle, by_root=by_root)
    # The first column is the mirror configuration itself.
    theta_h[0] = 0.0
    theta_d = 0.5 * np.pi * middle[::-1]
    wi, wo = from_half_angle_coordinates(
        theta_h[None, :], np.radians(phi_deg), theta_d[:, None], np.radians(phi_d_deg)
    )
    return Pairs(wi, wo, (wi[..., 2] > 0.0) & (wo[..., 2] > 0.0))


def theta_h_at(share: npt.ArrayLike, *, by_root: bool) -> Floats:
    """Return θh, radians, at shares (...) of the image's width; ``by_root``: as measured tables space it."""
    share = np.asarray(share, float)
    return np.asarray(0.5 * np.pi * (share * share if by_root else share))


def share_of_theta_h(theta_h: npt.ArrayLike, *, by_root: bool) -> Floats:
    """Return the share (...) of the image's width of θh, radians; the inverse of :func:`theta_h_at`."""
    share = np.asarray(theta_h, float) / (0.5 * np.pi)
    return np.asarray(np.sqrt(share) if by_root else share)


def image_of(reflectance: Evaluated, pairs: Pairs, *, cosine: Cosine) -> Floats:
    """Return f_r (rows, columns, 3) in 1/sr, times ``cosine``; NaN below the horizon and where not finite."""
    wi = np.broadcast_to(pairs.wi, pairs.wo.shape)
    with np.errstate(all="ignore"):  # holes of NaN are shown as holes
        value = np.array(reflectance.eval(wi, pairs.wo), np.float64)
    if cosine != "none":
        value *= cosine_of(cosine, wi, pairs.wo)[..., None]
    value[~(pairs.above & np.isfinite(value).all(axis=-1))] = np.nan
    return value


@dataclass(frozen=True)
class ImageError:
    """``rms`` in the image's unit over all pixels and channels, and ``relative`` to the target's own RMS."""

    rms: float
    relative: float


def image_error(target: Floats, fit: Floats) -> ImageError | None:
    """Return the error of ``fit`` against ``target``, (rows, columns, 3); None where no pixel is common.

    Pixels count the same: on the unrolled square that is by solid angle.
    """
    known = np.isfinite(target) & np.isfinite(fit)
    if not known.any():
        return None
    difference = (fit - target)[known]
    rms = float(np.sqrt(np.mean(difference**2)))
    own = float(np.sqrt(np.mean(target[known] ** 2)))
    return ImageError(rms, rms / own if own > 0.0 else (0.0 if rms == 0.0 else np.inf))


@functools.lru_cache(maxsize=4)
def _views(size: int) -> Floats:
    middle = (np.arange(size) + 0.5) / size
    u, v = np.meshgrid(middle, middle[::-1])
    views = square_to_hemisphere(np.stack((u, v), axis=-1))
    views.setflags(write=False)
    return views


Tone = Literal["gamma", "log"]
TONES: tuple[Tone, ...] = ("gamma", "log")
DECADES = 4.0
"""Decades below white that a logarithmic image shows."""


def share_of(value: npt.ArrayLike, tone: Tone, white: float) -> Floats:
    """Return the place (...), 0…1, of values on the scale that ends at ``white`` > 0; NaN stays NaN.

    The place is that along a scale bar and in a colour map: for gamma it is even in the value's lightness.
    """
    share = np.clip(np.asarray(value, float) / white, 0.0, 1.0)
    if tone == "gamma":
        return srgb_encode(share)
    with np.errstate(divide="ignore"):
        return np.maximum(1.0 + np.log10(share) / DECADES, 0.0)


def value_at(place: npt.ArrayLike, tone: Tone, white: float) -> Floats:
    """Return values (...) at places of the scale, 0…1; the inverse of :func:`share_of`."""
    place = np.asarray(place, float)
    if tone == "gamma":
        return np.asarray(white * srgb_decode(place))
    return np.asarray(white * 10.0 ** (DECADES * (place - 1.0)))


def colour_codes(value: Floats, tone: Tone, white: float) -> Bytes:
    """Return sRGB codes (rows, columns, 3) of values (rows, columns, 3) of the working space; not finite is 0."""
    known = np.nan_to_num(value, nan=0.0, posinf=0.0, neginf=0.0)
    if tone == "log":
        bright = known @ LUMINANCE
        # The channels keep their ratios; lightness is the place on the logarithmic scale.
        scale = np.zeros_like(bright)
        np.divide(srgb_decode(share_of(bright, "log", white)), bright, out=scale, where=bright > 0.0)
        rgb = (known * scale[..., None]) @ WORKING_TO_SRGB.T
    else:
        rgb = known @ WORKING_TO_SRGB.T / white
    rgb = np.clip(rgb, 0.0, 1.0)
    return np.asarray(np.rint(255.0 * srgb_encode(rgb)), np.uint8)


def mapped_codes(place: Floats, colours: Bytes) -> Bytes:
    """Return codes (..., 3) of places 0…1 in a table of colours (n, 3); NaN is the table's first."""
    last = len(colours) - 1
    rows = np.rint(np.nan_to_num(place, nan=0.0) * last).astype(np.intp)
    return np.asarray(colours[np.clip(rows, 0, last)])
