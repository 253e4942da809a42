"""Lobe maps as files; see :mod:`brdf_suite.files.array_file` for the bytes.

An array (6, size, size, 3) of half floats a map; one that serves several exponents is stored once. The header says
which of them serves what, their scales, the environment's name, and what they were made from.

In the maps that come with the programs each array (1 or 3, 6, size, size) holds the bits of the half floats as 16-bit
integers, each less its left neighbour in the row, one channel after the other; of a grey map only the first. Filtered
light is smooth, so the differences are small, often equal, and deflate to a thirtieth of the bytes.
"""

from __future__ import annotations

from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import numpy as np
from numpy.typing import NDArray

from brdf_suite.arrays import AnyArray
from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.array_file import Layout, encode_arrays, read_arrays
from brdf_suite.lighting.filter.face_array import FaceArray
from brdf_suite.lighting.filter.harmonics import worker_count
from brdf_suite.lighting.filter.prefilter import LobeMaps

PLAIN = Layout(b"BRDFMAPS", 4, "map file", ("<f2",))
PACKED = Layout(b"BRDFPACK", 2, "file of packed maps", ("<u2",), level=9)


def encode_maps(maps: LobeMaps, key: str, environment: str = "") -> list[bytes | memoryview]:
    """Return the parts of a map file, to be written one after the other.

    ``key`` names what the maps were made from; ``environment`` is what the user calls it, for listings only.
    """
    distinct, header = _described(maps, key, environment)
    arrays = {str(number): np.asarray(item.faces, "<f2") for number, item in enumerate(distinct)}
    return encode_arrays(PLAIN, key, header, arrays)


def pack_maps(maps: LobeMaps, key: str, environment: str) -> bytes:
    """Return the bytes of a packed file; arguments as for :func:`encode_maps`."""
    distinct, header = _described(maps, key, environment)
    arrays: dict[str, AnyArray] = {}
    for number, item in enumerate(distinct):
        bits = np.moveaxis(np.asarray(item.faces, "<f2").view("<u2"), -1, 0)
        grey = np.array_equal(bits[0], bits[1]) and np.array_equal(bits[0], bits[2])
        arrays[str(number)] = np.diff(bits[:1] if grey else bits, axis=-1, prepend=np.uint16(0))
    return b"".join(encode_arrays(PACKED, key, header, arrays))


def read_maps(path: PathLike, key: str) -> LobeMaps:
    """Return the maps of a file whose parts :func:`encode_maps` returned; the arrays are read-only.

    Raises
    ------
    FileError
        The file is missing, truncated, changed, of another version, or was made from something else than ``key``.
    """
    header, arrays = read_arrays(PLAIN, path)
    return _maps(path, key, header, list(arrays.values()))


def read_packed_maps(path: PathLike, key: str) -> LobeMaps:
    """Return the maps of a file of :func:`pack_maps`; otherwise as :func:`read_maps`."""
    header, arrays = read_arrays(PACKED, path)
    with ThreadPoolExecutor(worker_count()) as pool:
        return _maps(path, key, header, list(pool.map(_unpacked, arrays.values())))


def _described(maps: LobeMaps, key: str, environment: str) -> tuple[list[FaceArray], dict[str, Any]]:
    """Return the distinct maps in the order of a file, and the header that says what each of them serves."""
    distinct = list({id(m): m for m in (maps.diffuse, maps.background, *maps.lobes)}.values())
    place = {id(m): index for index, m in enumerate(distinct)}
    return distinct, {
        "key": key,
        "environment": environment,
        "exponents": maps.exponents,
        "lobes": [place[id(m)] for m in maps.lobes],
        "diffuse": place[id(maps.diffuse)],
        "background": place[id(maps.background)],
        "scales": [m.scale for m in distinct],
    }


def _maps(path: PathLike, key: str, header: dict[str, Any], faces: Sequence[AnyArray]) -> LobeMaps:
    if header.get("key") != key:
        raise FileError(path, "was made from another environment, or for other lobes", "header, key")
    try:
        maps = [FaceArray(item, float(scale)) for item, scale in zip(faces, header["scales"], strict=True)]
        lobes = tuple(maps[index] for index in header["lobes"])
        exponents = tuple(float(exponent) for exponent in header["exponents"])
        if len(lobes) != len(exponents):
            raise ValueError("as many lobes as exponents belong there")
        return LobeMaps(exponents, lobes, maps[header["diffuse"]], maps[header["background"]])
    except (ValueError, KeyError, TypeError, IndexError, OverflowError) as error:
        raise FileError(path, f"is damaged ({error})", "header") from error


def _unpacked(differences: NDArray[np.uint16]) -> NDArray[np.float16]:
    _, count, size, _ = differences.shape
    faces = np.empty((count, size, size, 3), dtype="<f2")
    bits = faces.view("<u2")
    for face in range(count):
        planes = np.cumsum(differences[:, face], axis=-1, dtype=np.uint16)
        bits[face] = np.moveaxis(planes, 0, -1)
    faces.flags.writeable = False
    return faces
