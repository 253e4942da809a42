"""Compiled loop from exposures to noisy codes.

Imported only where photographs are made: numba takes half a second to import. Random numbers are hashes of the place
of the sample (Steele, Lea and Flood 2014, "Fast splittable pseudorandom number generators"), so that they are the
same in any order of work.
"""

from __future__ import annotations

from typing import Any

import numpy as np

from brdf_suite.compilation import Array, compiled

_STEP = np.uint64(0x9E3779B97F4A7C15)
_FIRST, _SECOND = np.uint64(0xBF58476D1CE4E5B9), np.uint64(0x94D049BB133111EB)
_NORMAL_FROM = 40.0
"""Electrons from which on Poisson's distribution is taken for the normal one of its variance."""
_MOST_COUNTED = 400


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
    gain: Array,
    dark_rate: Array,
    seconds: float,
    well: float,
    read: float,
    noisy: bool,
    table: Array,
    black: float,
    white: float,
    key: Any,
    codes: Array,
) -> None:
    """Fill ``codes`` (h, w, 3) from ``rate`` (h, w, 3), fillings of the well per second.

    ``table`` (3, n) is the response at even fillings from 0 to 1. Below black it goes on straight.
    """
    height, width, channels = rate.shape
    start = _mixed(key * _STEP + np.uint64(1))
    top = table.shape[1] - 1
    # From here on no noise brings a full well below its brim.
    brim = well + 12.0 * np.sqrt(well + read * read)
    for row in range(height):
        for column in range(width):
            for channel in range(channels):
                mean = (
                    rate[row, column, channel] * gain[row, column] * well + dark_rate[row, column]
                ) * seconds
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
