"""Compiled merge of an exposure series into a radiance image, row by row to stay in cache."""

from __future__ import annotations

import math

import numpy as np

from brdf_suite.compilation import Array, compiled

OUTSIDE = 0
GOOD = 1
DARK = 2
CLIPPED = 3

# Squared: how many standard deviations a predicted exposure must stay below saturation.
_ROOM = 9.0
_CLEAR = 225.0  # squared: how many times its noise an exposure must be to inform the exposure times
_EVERY = 5  # of the pixels are used for the exposure times: a logarithm takes longer than all else


@compiled
def merge_rows(
    stack: Array,
    times: Array,
    table: Array,
    rounding: Array,
    read: Array,
    shot: Array,
    highest: Array,
    top: Array,
    offset: Array,
    rate: Array,
    flat: Array,
    mask: Array,
    first: int,
    end: int,
    dark_signal: float,
    radiance: Array,
    variance: Array,
    state: Array,
    pairs: Array,
    clipped: Array,
    dark: Array,
) -> None:
    """Merge rows ``first`` … ``end - 1`` of ``stack`` (n, h, w, channels) of codes.

    ``table`` and ``rounding`` (channels, codes) are exposure and variance by rounding of a code; ``read`` is a
    standard deviation, ``shot`` a variance over exposure, ``highest`` the last code that is not clipped, ``top`` its
    exposure (channels,). ``offset`` and ``rate`` are the dark frame (1 or h, 1 or w, channels), ``flat`` the flat
    field, ``mask`` (1 or h, 1 or w) what may be used. Filled are ``radiance``, ``variance`` and ``state``
    (h, w, channels); added to, for these rows, are ``pairs`` (n - 1, 3) of the logarithm of the ratio of exposures
    next to each other (count, sum, how many fell), ``clipped`` (n,) and ``dark`` (n + 1,): pixels of each exposure,
    and in the last place all.
    """
    exposures, _, width, channels = stack.shape
    sum_z = np.zeros((width, channels), np.float32)
    sum_t = np.zeros((width, channels), np.float32)
    sum_w = np.zeros((width, channels), np.float32)
    sum_wz = np.zeros((width, channels), np.float32)
    columns = np.zeros(width, np.int64)
    for row in range(first, end):
        dark_row = row if offset.shape[0] > 1 else 0
        flat_row = row if flat.shape[0] > 1 else 0
        mask_row = row if mask.shape[0] > 1 else 0
        used = 0
        for x in range(width):
            if mask[mask_row, x if mask.shape[1] > 1 else 0]:
                columns[used] = x
                used += 1
        for x in range(width):
            for c in range(channels):
                sum_z[x, c] = sum_t[x, c] = sum_w[x, c] = sum_wz[x, c] = 0.0
                radiance[row, x, c] = 0.0
                variance[row, x, c] = 0.0
                state[row, x, c] = OUTSIDE
        # What all exposures that are not clipped say together: a first guess, free of the noise of weights.
        for i in range(exposures):
            t = times[i]
            for c in range(channels):
                black = dark_signal * read[c]
                limit = highest[c]
                above = 0
                below = 0
                for k in range(used):
                    x = columns[k]
                    y = stack[i, row, x, c]
                    if y <= limit:
                        z = table[c, y] - offset[dark_row, x if offset.shape[1] > 1 else 0, c]
                        sum_z[x, c] += z
                        sum_t[x, c] += t
                        below += z < black
                    else:
                        above += 1
                clipped[i] += above
                dark[i] += below
        dark[exposures] += used * channels
        for k in range(used):
            for c in range(channels):
                x = columns[k]
                if sum_t[x, c] > 0.0:
                    sum_z[x, c] /= sum_t[x, c]
        # Weights from the guess, not from each code: a code that noise made small would weigh more, and bend the mean.
        for i in range(exposures):
            t = times[i]
            for c in range(channels):
                limit = highest[c]
                square = read[c] * read[c]
                for k in range(used):
                    x = columns[k]
                    y = stack[i, row, x, c]
                    if y <= limit:
                        expected = max(t * sum_z[x, c], np.float32(0.0))
                        noise = square + shot[c] * expected + rounding[c, y]
                        # Predicted within its noise of saturation, only the low ones of such codes would be taken.
                        room = top[c] - expected
                        if room > 0.0 and room * room > _ROOM * noise:
                            z = table[c, y] - offset[dark_row, x if offset.shape[1] > 1 else 0, c]
                            weight = t / noise
                            sum_w[x, c] += weight * t
                            sum_wz[x, c] += weight * z
        for k in range(used):
            x = columns[k]
            for c in range(channels):
                if sum_w[x, c] > 0.0:
                    value = sum_wz[x, c] / sum_w[x, c]
                    spread = np.float32(1.0) / sum_w[x, c]
                    state[row, x, c] = GOOD
                else:
                    # The shortest exposure is within its noise of saturation, or clipped as all are.
                    y = stack[0, row, x, c]
                    z = table[c, y] - offset[dark_row, x if offset.shape[1] > 1 else 0, c]
                    value = z / times[0]
                    noise = read[c] * read[c] + shot[c] * max(z, np.float32(0.0)) + rounding[c, y]
                    spread = noise / (times[0] * times[0])
                    state[row, x, c] = GOOD if y <= highest[c] else CLIPPED
                value -= rate[dark_row, x if rate.shape[1] > 1 else 0, c]
                if state[row, x, c] == GOOD and value < dark_signal * math.sqrt(spread):
                    state[row, x, c] = DARK
                gain = flat[flat_row, x if flat.shape[1] > 1 else 0, c]
                radiance[row, x, c] = value / gain
                variance[row, x, c] = spread / (gain * gain)
        for k in range(row % _EVERY, used, _EVERY):
            x = columns[k]
            for c in range(channels):
                black = offset[dark_row, x if offset.shape[1] > 1 else 0, c]
                _add_pairs(stack, row, x, c, table, read, shot, highest, rounding, black, pairs)


@compiled
def _add_pairs(
    stack: Array,
    row: int,
    x: int,
    c: int,
    table: Array,
    read: Array,
    shot: Array,
    highest: Array,
    rounding: Array,
    offset: float,
    pairs: Array,
) -> None:
    before = -1.0
    for i in range(stack.shape[0]):
        y = stack[i, row, x, c]
        z = table[c, y] - offset
        noise = read[c] * read[c] + shot[c] * max(z, 0.0) + rounding[c, y]
        clear = y <= highest[c] and z > 0.0 and z * z > _CLEAR * noise
        if clear and before > 0.0:
            pairs[i - 1, 0] += 1.0
            pairs[i - 1, 1] += math.log(z / before)
            if z < before:
                pairs[i - 1, 2] += 1.0
        before = z if clear else -1.0
