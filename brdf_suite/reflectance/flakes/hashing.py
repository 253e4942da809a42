"""Hash that generates flakes: 32-bit integers only, the same as in ``sparkle_hash.glsl``.

A bijection of two rounds of multiplication and shift, with constants of Chris Wellons's search ("Hash function
prospector"); each bit in changes each bit out with a chance near one half.
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats, Words

GOLDEN = np.uint32(0x9E3779B9)


def scramble(x: npt.ArrayLike) -> Words:
    """Return words (...) for words (...) of 32 bits.

    >>> hex(int(scramble(np.uint32(1))))
    '0x6d3fa73'
    """
    # At least one axis: numpy wraps whole numbers silently in arrays, but warns for a single one.
    words = np.atleast_1d(np.asarray(x, np.uint32))
    words = (words ^ (words >> np.uint32(16))) * np.uint32(0x21F0AAAD)
    words = (words ^ (words >> np.uint32(15))) * np.uint32(0xD35A2D97)
    return np.asarray(words ^ (words >> np.uint32(15))).reshape(np.shape(x))


def cell_key(x: npt.ArrayLike, y: npt.ArrayLike, salt: npt.ArrayLike) -> Words:
    """Return a word (...) for whole numbers ``x``, ``y`` (...) of either sign, and a salt (...)."""
    return scramble(wrap_words(x) + scramble(wrap_words(y) + np.asarray(salt, np.uint32)))


def wrap_words(whole: npt.ArrayLike) -> Words:
    """Return whole numbers (...) modulo 2³²."""
    return np.asarray(whole).astype(np.int64).astype(np.uint32)


def halves(word: Words) -> tuple[Floats, Floats]:
    """Return two even numbers (...) in (0, 1) of 16 bits each."""
    low = (word & np.uint32(0xFFFF)).astype(float)
    high = (word >> np.uint32(16)).astype(float)
    return (low + 0.5) / 65536.0, (high + 0.5) / 65536.0
