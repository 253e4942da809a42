"""Baked occlusion as a file: a JSON header, arrays, a checksum. For cache and package, not for exchange.

All numbers are little-endian::

    0   8   BRDFOCCL
    8   4   u32, length of the header in bytes
    12  4   u32, version of this layout
    16  32  SHA-256 of everything from byte 48 on
    48  …   deflated (zlib): the header,
            {"ground": [height, x0, z0, x1, z1], "arrays": [{"name", "dtype", "shape"}, …]}, UTF-8,
            and the arrays, C order, one after the other

Of each part only what is not in the mesh itself is held: the light, and triangles and the vertices on its edges where
it was cut.
"""

from __future__ import annotations

import hashlib
import json
import math
import os
import struct
import zlib
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from brdf_suite.documents.atomic import replacing
from brdf_suite.errors import FileError
from brdf_suite.surface.mesh import Mesh
from brdf_suite.surface.occlusion.baked import BakedMesh, BakedPart, GroundLight

FORMAT_VERSION = 2

_MAGIC = b"BRDFOCCL"
_START = struct.Struct("<8sII32s")
_DTYPES = ("<f2", "<f4", "<u4")
_FASTEST = 1
_CUT = ("positions", "normals", "uvs")


def write_baked(path: str | os.PathLike[str], mesh: Mesh, baked: BakedMesh) -> None:
    """Write what was baked for ``mesh``, whole or not at all; :class:`FileError` where that cannot be."""
    ground = baked.ground
    arrays: dict[str, NDArray[Any]] = {"ground": ground.transfer.astype("<f2")}
    for number, (part, original) in enumerate(zip(baked.parts, mesh.parts, strict=True)):
        arrays[f"{number}.light"] = part.light.astype("<f2")
        if len(part.triangles) > len(original.triangles):
            arrays[f"{number}.triangles"] = part.triangles.astype("<u4")
            for name in _CUT:
                added = getattr(part, name)[len(original.positions) :]
                arrays[f"{number}.{name}"] = added.astype("<f4")
    header = {
        "ground": [ground.height, *ground.low, *ground.high],
        "arrays": [{"name": n, "dtype": a.dtype.str, "shape": list(a.shape)} for n, a in arrays.items()],
    }
    text = json.dumps(header).encode()
    content = text + b"".join(np.ascontiguousarray(array).tobytes() for array in arrays.values())
    body = zlib.compress(content, _FASTEST)
    start = _START.pack(_MAGIC, len(text), FORMAT_VERSION, hashlib.sha256(body).digest())
    with replacing(path) as temporary:
        temporary.write_bytes(start + body)


def read_baked(path: str | os.PathLike[str], mesh: Mesh) -> BakedMesh:
    """Return what was baked for ``mesh``.

    Raises
    ------
    FileError
        It is not there, damaged, of another version, or was baked for another mesh.
    """
    data, length = _checked(path)
    try:
        header = json.loads(data[:length])
        arrays = _arrays(data, length, header["arrays"])
        height, x0, z0, x1, z1 = (float(number) for number in header["ground"])
        transfer = arrays["ground"].astype(np.float32)
        parts = tuple(_part(original, number, arrays) for number, original in enumerate(mesh.parts))
    except (ValueError, KeyError, TypeError, IndexError) as error:
        raise FileError(path, f"does not fit the mesh ({error})") from error
    return BakedMesh(parts, GroundLight(height, (x0, z0), (x1, z1), transfer))


def check_baked(path: str | os.PathLike[str]) -> None:
    """Read the file and compare its checksum; :class:`FileError` where it is damaged, or not to be read."""
    _checked(path)


def _checked(path: str | os.PathLike[str]) -> tuple[bytes, int]:
    """Return header and arrays of the sound file, and the length of the header."""
    try:
        data = Path(path).read_bytes()
    except OSError as error:
        raise FileError(path, f"cannot be read: {error.strerror or error}") from error
    if len(data) < _START.size or data[:8] != _MAGIC:
        raise FileError(path, "is no baked occlusion", "byte 0")
    _, length, version, checksum = _START.unpack_from(data)
    if version != FORMAT_VERSION or hashlib.sha256(data[_START.size :]).digest() != checksum:
        raise FileError(path, "is damaged, or of another version", "byte 8")
    try:
        return zlib.decompress(data[_START.size :]), length
    except zlib.error as error:
        raise FileError(path, f"cannot be unpacked ({error})", f"byte {_START.size}") from error


def _arrays(data: bytes, at: int, entries: list[dict[str, Any]]) -> dict[str, NDArray[Any]]:
    found = {}
    for entry in entries:
        if entry["dtype"] not in _DTYPES:
            raise ValueError(f"type {entry['dtype']!r}")
        shape = tuple(int(n) for n in entry["shape"])
        count = math.prod(shape)
        found[entry["name"]] = np.frombuffer(data, entry["dtype"], count, at).reshape(shape)
        at += found[entry["name"]].nbytes
    return found


def _part(original: Any, number: int, arrays: dict[str, NDArray[Any]]) -> BakedPart:
    values = {name: getattr(original, name) for name in (*_CUT, "triangles")}
    if f"{number}.triangles" in arrays:
        values["triangles"] = arrays[f"{number}.triangles"]
        for name in _CUT:
            values[name] = np.concatenate([values[name], arrays[f"{number}.{name}"]])
    light = arrays[f"{number}.light"]
    if light.shape != (len(values["positions"]), 8):
        raise ValueError(f"part {number} has {len(values['positions'])} vertices, not {len(light)}")
    return BakedPart(**values, light=light)
