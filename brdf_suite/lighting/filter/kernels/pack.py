"""Compiled packing of cube map faces as half floats: the formulas of :mod:`brdf_suite.lighting.filter.texel_values`
in one pass.

Imported by :mod:`brdf_suite.lighting.filter.kernels.compilation` alone. The machine's own conversion is not
available on every processor; that by whole
numbers gives the same bits.
"""

from __future__ import annotations

import numpy as np

from brdf_suite.compilation import Array, compiled


@compiled
def pack_rows(
    faces: Array, share: float, changes: Array, scale: float, first: int, end: int, halves: Array
) -> None:
    """Set rows ``first`` … ``end - 1`` of every face, first to last of 6·F rows counted through, as half floats.

    Parameters
    ----------
    faces
        (6, F, F, 3) float32.
    share
        How much of the second differences is taken off; 0 leaves the values as they are.
    changes
        (6, 4, F, 3) float32: taken off the columns 0 and F-1 and the rows 0 and F-1.
    scale
        What the values are divided by; negative ones become 0, and none may exceed 65,504 afterwards.
    halves
        (6, F, 3·F) uint16: the bits of the half floats.
    """
    size = faces.shape[1]
    count = 3 * size
    row = np.empty(count, dtype=np.float32)
    raised = np.empty(count, dtype=np.float32)
    bits = row.view(np.uint32)
    small = raised.view(np.uint32)
    inverse = np.float32(1.0 / scale)
    part = np.float32(share)
    zero = np.float32(0.0)
    half = np.float32(0.5)
    for index in range(first, end):
        face, j = index // size, index % size
        middle = min(max(j, 1), size - 2)  # at the rim the second difference is that of the next texel
        here = faces[face, j].reshape(count)
        above = faces[face, middle - 1].reshape(count)
        centre = faces[face, middle].reshape(count)
        below = faces[face, middle + 1].reshape(count)
        if part > zero:
            for k in range(count):
                row[k] = here[k] - part * (above[k] - centre[k] - centre[k] + below[k])
            for k in range(3, count - 3):
                row[k] -= part * (here[k - 3] - here[k] - here[k] + here[k + 3])
            for c in range(3):
                row[c] -= part * (here[c] - here[3 + c] - here[3 + c] + here[6 + c])
                k = count - 3 + c
                row[k] -= part * (here[k] - here[k - 3] - here[k - 3] + here[k - 6])
        else:
            for k in range(count):
                row[k] = here[k]
        for c in range(3):
            row[c] -= changes[face, 0, j, c]
            row[count - 3 + c] -= changes[face, 1, j, c]
        if j == 0:
            row -= changes[face, 2].reshape(count)
        if j == size - 1:
            row -= changes[face, 3].reshape(count)
        for k in range(count):
            row[k] = max(row[k] * inverse, zero)
            raised[k] = row[k] + half  # in this sum the last bit is the last bit of a small half float
        target = halves[face, j]
        for k in range(count):
            value = bits[k]
            normal = (value + np.uint32(0xFFF) + ((value >> np.uint32(13)) & np.uint32(1))) >> np.uint32(13)
            if value < np.uint32(0x38800000):  # below 2^-14
                target[k] = small[k] - np.uint32(0x3F000000)
            else:
                target[k] = normal - np.uint32(0x1C000)
