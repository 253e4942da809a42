"""Glare: the veil of light that the eye scatters around what is brighter than a screen can show.

The general disability glare function of the CIE (Vos and van den Berg, CIE 135/1, 1999; CIE 146:2002 has it too) gives
the light that an eye spreads from a point, per steradian. Within a tenth of a degree it is the sharpness of the eye,
which the viewer of the screen has. Beyond it is scatter in cornea, lens and on the fundus, which a screen cannot
cause, since it shows nothing brighter than its white. So it is applied to the light above white alone, and what is
spread is taken from there: no light is added.
"""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.errors import ValueRangeError

SHARP_DEG = 0.1
"""Within this angle the function is held at its value there."""
AGE_YEARS = 35.0
PIGMENTATION = 0.5
"""Of the eye: 0 for very dark ones, 0.5 for brown, 1 for blue-green, 1.2 for light blue Caucasian eyes."""
WHITE = 1.0
"""Exposed radiance above which light glares: that of a diffuse white at the exposure of the picture."""
WIDEST_DEG = 30.0
"""Beyond it nothing is spread: a picture is hardly wider, and the veil there is below 1e-5 of its source."""
_PLACES, _ROUNDS = 200, 400
_MOST_PIXELS, _MOST_BLOCKS = 600, 1280


def scattered_light(
    angle_deg: npt.ArrayLike, age_years: float = AGE_YEARS, pigmentation: float = PIGMENTATION
) -> Floats:
    """Return the light (...), 1/sr, that is scattered by angles (...), 0 to 90°, from a point of light.

    >>> scattered_light([0.1, 1.0, 10.0]).round(2).tolist()
    [11675.23, 19.56, 0.06]
    """
    angle = np.maximum(np.asarray(angle_deg, float), SHARP_DEG)
    aged = (age_years / 70.0) ** 4
    sharp = 9.2e6 / (1.0 + (angle / 0.0046) ** 2) ** 1.5 + 1.5e5 / (1.0 + (angle / 0.045) ** 2) ** 1.5
    wide = 1.0 + (angle / 0.1) ** 2
    fundus = 1300.0 / wide**1.5 + 0.8 / np.sqrt(wide)
    lens = 400.0 / wide + 3e-8 * angle**2
    return np.asarray(
        (1.0 - 0.08 * aged) * sharp
        + (1.0 + 1.6 * aged) * (lens + pigmentation * fundus)
        + 2.5e-3 * pigmentation
    )


def pixel_angle(focal_length_mm: float, width: int, sensor_width_mm: float) -> float:
    """Return the angle, degrees, that a pixel in the middle of a picture of ``width`` pixels covers."""
    return math.degrees(sensor_width_mm / (focal_length_mm * width))


@lru_cache(maxsize=64)
def gaussian_shares(spreads_deg: tuple[float, ...]) -> tuple[float, ...]:
    """Return the shares of the light that Gaussians of these standard deviations spread as the eye does.

    Their sum approximates :func:`scattered_light` from the narrowest standard deviation to :data:`WIDEST_DEG`, in the
    least squares of relative errors, by shares above 0 (Lee and Seung's multiplicative updates).
    """
    spreads = np.radians(spreads_deg)
    angle = np.geomspace(min(spreads_deg), WIDEST_DEG, _PLACES)
    squared = (np.radians(angle)[:, None] / spreads) ** 2
    bells = np.exp(-0.5 * squared) / (2.0 * math.pi * spreads**2)
    relative = bells / scattered_light(angle)[:, None]
    wanted, square = relative.sum(axis=0), relative.T @ relative
    shares = np.full(len(spreads), 1.0 / float(wanted.sum()))
    for _ in range(_ROUNDS):
        shares *= wanted / (square @ shares)
    return tuple(shares.tolist())


def spread_glare(exposed: npt.ArrayLike, pixel_deg: float) -> Floats:
    """Return exposed radiance (h, w, 3), 1 being white, with the glare of what is above white.

    ``pixel_deg`` is the angle that a pixel covers, degrees, above 0. Light is spread over :data:`WIDEST_DEG`; that
    which would leave the picture is lost to it. Of pictures with more than 1,280 pixels along an edge, light is spread
    between blocks of pixels.

    Raises
    ------
    ValueRangeError
        The array has another shape, or the angle is not between 0 and :data:`WIDEST_DEG`.
    """
    light = np.asarray(exposed, float)
    if light.ndim != 3 or light.shape[2] != 3:
        raise ValueRangeError("exposed", f"shape {light.shape}, not (h, w, 3)")
    if not 0.0 < pixel_deg < WIDEST_DEG:
        raise ValueRangeError("pixel_deg", f"expected an angle of 0 to {WIDEST_DEG:g}°, not {pixel_deg:g}")
    excess = np.maximum(light - WHITE, 0.0)
    if not excess.any():
        return light
    height, width = light.shape[:2]
    block = -(-max(height, width) // _MOST_BLOCKS)
    if block * pixel_deg >= WIDEST_DEG:
        return light
    rows, columns = -(-height // block), -(-width // block)
    padded = np.pad(excess, ((0, rows * block - height), (0, columns * block - width), (0, 0)))
    blocks = padded.reshape(rows, block, columns, block, 3).mean(axis=(1, 3))
    spread = _convolve(blocks, block * pixel_deg)
    if block > 1:
        spread = _drawn_out(_drawn_out(spread, block, height).swapaxes(0, 1), block, width).swapaxes(0, 1)
    return np.asarray(light - _scattered_share(block * pixel_deg) * excess + spread)


def _convolve(light: Floats, pixel_deg: float) -> Floats:
    """Return light (h, w, 3) spread between pixels of ``pixel_deg``, without what stays in its own."""
    height, width = light.shape[:2]
    reach = math.ceil(WIDEST_DEG / pixel_deg)
    down, right = min(height - 1, reach), min(width - 1, reach)
    # Of a kernel that ends with the picture, both halves fit beside each other.
    shape = (height + down, width + right)
    y = np.minimum(np.arange(shape[0]), shape[0] - np.arange(shape[0]))[:, None]
    x = np.minimum(np.arange(shape[1]), shape[1] - np.arange(shape[1]))[None]
    angle = pixel_deg * np.hypot(y, x)
    within = (y <= down) & (x <= right) & (angle <= WIDEST_DEG) & (angle > 0.0)
    spread = np.where(within, scattered_light(np.minimum(angle, WIDEST_DEG)), 0.0)
    kernel = np.fft.rfft2(spread * math.radians(pixel_deg) ** 2)
    found = [np.fft.irfft2(np.fft.rfft2(light[..., c], s=shape) * kernel, s=shape) for c in range(3)]
    # The transform leaves numerical noise of either sign.
    return np.maximum(np.stack(found, axis=-1)[:height, :width], 0.0)


def _drawn_out(blocks: Floats, block: int, length: int) -> Floats:
    """Return rows (n, ...) of blocks as ``length`` rows, linear between the blocks' middles."""
    at = np.clip((np.arange(length) + 0.5) / block - 0.5, 0.0, len(blocks) - 1.0)
    first = np.minimum(at.astype(int), max(len(blocks) - 2, 0))
    part = (at - first).reshape(-1, *[1] * (blocks.ndim - 1))
    return np.asarray(blocks[first] * (1.0 - part) + blocks[np.minimum(first + 1, len(blocks) - 1)] * part)


@lru_cache(maxsize=64)
def _scattered_share(pixel_deg: float) -> float:
    """Return the sum of the kernel of pixels over all that it reaches, whether that is in the picture or not."""
    reach = math.ceil(WIDEST_DEG / pixel_deg)
    if reach <= _MOST_PIXELS:
        x = np.arange(-reach, reach + 1)
        angle = pixel_deg * np.hypot(x[:, None], x)
        own = scattered_light(angle[(angle > 0.0) & (angle <= WIDEST_DEG)])
        return float(own.sum()) * math.radians(pixel_deg) ** 2
    # So many small pixels are the plane, but for a disc of the area of one; per step of the logarithm 2 pi a^2 f(a).
    logarithm = np.linspace(math.log(pixel_deg / math.sqrt(math.pi)), math.log(WIDEST_DEG), 4001)
    angle = np.exp(logarithm)
    rings = 2.0 * math.pi * np.radians(angle) ** 2 * scattered_light(angle)
    return float(np.sum(0.5 * (rings[1:] + rings[:-1]) * np.diff(logarithm)))
