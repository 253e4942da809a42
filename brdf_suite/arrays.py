"""The types of arrays, named once: an annotation says the element type, its docstring the shape and the unit."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.float64]
Singles = NDArray[np.float32]
Reals = NDArray[np.floating[Any]]  # any precision
Complexes = NDArray[np.complex128]

Bools = NDArray[np.bool_]
Integers = NDArray[np.int64]
Indices = NDArray[np.intp]  # places in another array, labels of its rows
AnyIntegers = NDArray[np.integer[Any]]
Words = NDArray[np.uint32]  # hashes, and indices as OpenGL takes them

Bytes = NDArray[np.uint8]
Codes = NDArray[np.uint8] | NDArray[np.uint16]  # the values in an image file

AnyArray = NDArray[Any]

Triple = tuple[float, float, float]  # one colour or place as a document has it


def triple(values: ArrayLike) -> Triple:
    """Return three numbers (3,) as a tuple of floats."""
    x, y, z = np.asarray(values, float).tolist()
    return x, y, z
