"""Simulated sensor: electrons with noise, full wells, the response curve, and codes.

A pixel's exposure of 1 fills its well. Electrons are shot (Poisson), dark current adds its own, reading adds noise;
the well clips; the response curve gives a code between the black level and full scale.
"""

from __future__ import annotations

import functools
import os
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from typing import Any

import numpy as np

from brdf_suite.acquisition.simulator.settings import Curve, SimulatorSettings
from brdf_suite.arrays import Codes, Floats, Singles
from brdf_suite.compilation import Array, compiled

_STEP = np.uint64(0x9E3779B97F4A7C15)
_FIRST, _SECOND = np.uint64(0xBF58476D1CE4E5B9), np.uint64(0x94D049BB133111EB)
_NORMAL_FROM = 40.0
"""Electrons from which on Poisson's distribution is taken for the normal one of its variance."""
_MOST_COUNTED = 400
CURVE_STEPS = 1 << 16
"""Cells of a curve's table, so many that linear steps between are no error of a 16-bit code."""
# A logarithm with a straight share: steep in the dark, with a shoulder, and different in each channel.
_FILM_STEEPNESS = np.array([9.0, 8.0, 10.0])
_FILM_STRAIGHT = np.array([0.25, 0.30, 0.22])
_BLACK_OF_12_BITS = 64
_HOT_SHARE = 2e-5
_HOT_FACTOR = 1000.0
"""The dark current of a hot pixel over the mean."""


@compiled(in_order=True)
def _mixed(state: Any) -> Any:
    state = (state ^ (state >> np.uint64(30))) * _FIRST
    state = (state ^ (state >> np.uint64(27))) * _SECOND
    return state ^ (state >> np.uint64(31))


@compiled(in_order=True)
def _uniform(state: Any) -> Any:
    """Return a number within 0…1, both excluded."""
    return (np.float64(_mixed(state) >> np.uint64(11)) + 0.5) * (1.0 / 9007199254740992.0)


@compiled(in_order=True)
def _electrons(mean: float, read: float, state: Any) -> Any:
    """Draw what is read of ``mean`` electrons: Poisson's number, and the read noise."""
    first, second = _uniform(state + _STEP), _uniform(state + _STEP + _STEP)
    normal = np.sqrt(-2.0 * np.log(first)) * np.cos(2.0 * np.pi * second)
    if mean > _NORMAL_FROM:
        return mean + normal * np.sqrt(mean + read * read)
    third = _uniform(state + _STEP + _STEP + _STEP)
    chance = np.exp(-mean)
    total, count = chance, 0
    while third > total and count < _MOST_COUNTED:
        count += 1
        chance *= mean / count
        total += chance
    return count + normal * read


@compiled(in_order=True)
def expose(
    rate: Array,
    sensor: Array,
    seconds: float,
    table: Array,
    black: float,
    white: float,
    key: Any,
    codes: Array,
) -> None:
    """Fill ``codes`` (h, w, 3) from ``rate`` (h, w, 3), fillings of the well per second.

    ``sensor``: gain and dark rate (h, w), electrons of a full well and of reading, whether there is noise; ``table``
    (3, n) is the response at even fillings from 0 to 1. Below black it goes on straight. Random numbers are
    hashes of the place of the sample (Steele, Lea and Flood 2014, "Fast splittable pseudorandom number generators"),
    so that they are the same in any order of work.
    """
    gain, dark_rate, well, read, noisy = sensor
    height, width, channels = rate.shape
    start = _mixed(key * _STEP + np.uint64(1))
    top = table.shape[1] - 1
    # From here on no noise brings a full well below its brim.
    brim = well + 12.0 * np.sqrt(well + read * read)
    for row in range(height):
        for column in range(width):
            for channel in range(channels):
                filled = rate[row, column, channel] * gain[row, column] * well
                mean = (filled + dark_rate[row, column]) * seconds
                if noisy and mean < brim:
                    place = np.uint64(4 * ((row * width + column) * channels + channel))
                    mean = _electrons(mean, read, start + place * _STEP)
                filling = min(mean / well, 1.0)
                at = filling * top
                cell = min(max(int(at), 0), top - 1)
                low = table[channel, cell]
                share = low + (at - cell) * (table[channel, cell + 1] - low)
                code = np.floor(black + share * (white - black) + 0.5)
                codes[row, column, channel] = min(max(code, 0.0), white)


def response(curve: Curve, filling: Floats) -> Floats:
    """Return (..., 3): the share of the scale for a filling (..., 3) from 0 to 1."""
    x = np.asarray(filling, dtype=float)
    if curve == "linear":
        return x * np.ones(3)
    if curve == "srgb":
        bent = 1.055 * np.maximum(x, 0.0031308) ** (1.0 / 2.4) - 0.055
        return np.where(x <= 0.0031308, 12.92 * x, bent) * np.ones(3)
    bent = np.log1p(_FILM_STEEPNESS * x) / np.log1p(_FILM_STEEPNESS)
    return np.asarray((1.0 - _FILM_STRAIGHT) * bent + _FILM_STRAIGHT * x)


@functools.cache
def curve_table(curve: Curve) -> Floats:
    """Return (3, steps + 1): the curve at even fillings from 0 to 1."""
    table = np.ascontiguousarray(response(curve, np.linspace(0.0, 1.0, CURVE_STEPS + 1)[:, None]).T)
    table.flags.writeable = False
    return table


@dataclass(frozen=True, eq=False)
class Sensor:
    """A sensor of ``shape`` (h, w); ``gain`` and ``dark_rate`` (h, w) float32 differ from pixel to pixel."""

    settings: SimulatorSettings
    gain: Singles
    dark_rate: Singles

    @classmethod
    def made(cls, settings: SimulatorSettings) -> Sensor:
        """Return the sensor of this seed."""
        width, height = settings.size
        gain, dark = np.ones((height, width)), np.zeros((height, width))
        if settings.noise:
            random = np.random.default_rng([settings.seed, 1])
            gain += settings.gain_spread * random.standard_normal(gain.shape)
            dark = settings.dark_current * random.gamma(4.0, 0.25, gain.shape)
            dark[random.random(gain.shape) < _HOT_SHARE] = _HOT_FACTOR * settings.dark_current
        return cls(settings, gain.astype(np.float32), dark.astype(np.float32))

    @property
    def black(self) -> int:
        """The code without light; 0 of a camera that writes sRGB pictures."""
        bits = self.settings.bit_depth
        return 0 if self.settings.curve == "srgb" else round(_BLACK_OF_12_BITS * 2.0 ** (bits - 12))

    def unit_rgb(self) -> Floats:
        """Return the full well's exposure in the photographs' unit, (3,): half of full scale counts as 0.5."""
        white = 2**self.settings.bit_depth - 1
        middle = (2 ** (self.settings.bit_depth - 1) - self.black) / (white - self.black)
        places = np.linspace(0.0, 1.0, CURVE_STEPS + 1)
        return 0.5 / np.array([np.interp(middle, row, places) for row in curve_table(self.settings.curve)])

    def expose(self, rate: Singles, exposures_s: tuple[float, ...], shot: int) -> Codes:
        """Return the codes (e, h, w, 3) of a picture (h, w, 3), full wells per second, at each exposure time.

        ``shot`` distinguishes photographs, so that each has noise of its own.
        """
        settings = self.settings
        codes = np.empty((len(exposures_s), *rate.shape), np.uint16)
        table = curve_table(settings.curve)
        read = settings.read_noise if settings.noise else 0.0
        white = float(2**settings.bit_depth - 1)

        sensor = (self.gain, self.dark_rate, settings.full_well, read, settings.noise)

        def one(k: int) -> None:
            key = np.uint64((settings.seed << 32) ^ (shot << 8) ^ k)
            expose(rate, sensor, exposures_s[k], table, float(self.black), white, key, codes[k])

        with ThreadPoolExecutor(os.cpu_count()) as pool:
            list(pool.map(one, range(len(exposures_s))))
        return codes.astype(np.uint8) if settings.bit_depth == 8 else codes
