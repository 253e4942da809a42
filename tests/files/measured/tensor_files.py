"""Tensor files, the container of RGL and of polarimetric BRDFs, written byte by byte."""

from __future__ import annotations

import struct

import numpy as np

KINDS = {np.dtype(np.uint16): 3, np.dtype(np.float32): 10, np.dtype(np.float64): 11, np.dtype(np.uint8): 1}


def tensor_file(
    fields: dict[str, np.ndarray], *, aligned: int = 8, version: tuple[int, int] = (1, 0)
) -> bytes:
    """The container: a table of fields with absolute offsets, then their bytes."""
    size = 18 + sum(13 + len(name) + 8 * array.ndim for name, array in fields.items())
    table, data = b"", b""
    for name, array in fields.items():
        data += b"\0" * (-(size + len(data)) % aligned)
        table += struct.pack("<H", len(name)) + name.encode()
        table += struct.pack("<HBQ", array.ndim, KINDS[array.dtype], size + len(data))
        table += struct.pack(f"<{array.ndim}Q", *array.shape)
        data += array.tobytes()
    return b"tensor_file\0" + struct.pack("<BBI", *version, len(fields)) + table + data
