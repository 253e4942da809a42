"""Prefiltered maps, from disk where they were filtered before (:mod:`brdf_suite.files.cache.disk_cache`).

The key is a hash of the environment's pixels, the exponents, the versions of algorithm and file, and the largest face
size. The maps of the default light come with the programs (``packaging/generators/resources.py lobe_maps`` writes
them): they are looked for first, under the same key, and are never copied into the user's folder.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from brdf_suite.arrays import AnyArray
from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.array_file import Layout, encode_arrays, read_arrays
from brdf_suite.files.cache.disk_cache import DiskCache
from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.filter.face_array import FaceArray
from brdf_suite.lighting.filter.harmonics import worker_count
from brdf_suite.lighting.filter.lobe_maps import (
    ALGORITHM_VERSION,
    LobeMaps,
    Ready,
    background_size,
    prefilter,
)
from brdf_suite.progress import Progress, report
from brdf_suite.resources import resource_root

PLAIN = Layout(b"BRDFMAPS", 5, "map file", ("<f2",))
PACKED = Layout(b"BRDFPACK", 3, "file of packed maps", ("<u2",), level=9)
_ROWS = 64


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
    every = (maps.diffuse, maps.through_coat, maps.background, *maps.lobes)
    distinct = list({id(m): m for m in every}.values())
    place = {id(m): index for index, m in enumerate(distinct)}
    return distinct, {
        "key": key,
        "environment": environment,
        "exponents": maps.exponents,
        "lobes": [place[id(m)] for m in maps.lobes],
        "diffuse": place[id(maps.diffuse)],
        "through_coat": place[id(maps.through_coat)],
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
        others = (maps[header[name]] for name in ("diffuse", "through_coat", "background"))
        return LobeMaps(exponents, lobes, *others)
    except (ValueError, KeyError, TypeError, IndexError, OverflowError) as error:
        raise FileError(path, f"is damaged ({error})", "header") from error


def _unpacked(differences: NDArray[np.uint16]) -> NDArray[np.float16]:
    _, count, size, _ = differences.shape
    faces = np.empty((count, size, size, 3), dtype="<f2")
    bits = faces.view("<u2")
    # A plane at a time, of rows that stay in the processor's cache: in two thirds of the time.
    for face, top in product(range(count), range(0, size, _ROWS)):
        rows = slice(top, top + _ROWS)
        planes = np.cumsum(differences[:, face, rows], axis=-1, dtype=np.uint16)
        for channel in range(3):
            bits[face, rows, :, channel] = planes[channel % len(planes)]
    faces.flags.writeable = False
    return faces


PACKAGED = "lobe_maps"
"""The folder, among the resources, of the maps that come with the programs."""
PACKAGED_ENDING = ".packedmaps"


class MapCache(DiskCache):
    """The filtered maps on disk; arguments as for :class:`DiskCache`.

    >>> maps = MapCache().get_or_compute(environment, [3.0, 40.0])  # doctest: +SKIP
    """

    def __init__(
        self,
        root: PathLike | None = None,
        *,
        limit_bytes: int | None = None,
        lock_timeout_s: float = 600.0,
        silence_s: float = 60.0,
    ) -> None:
        super().__init__(
            "lobe_maps",
            "maps",
            PLAIN,
            ".lobemaps",
            root,
            limit_bytes=limit_bytes,
            lock_timeout_s=lock_timeout_s,
            silence_s=silence_s,
        )

    def holds(self, environment: Environment, exponents: Sequence[float]) -> bool:
        """Whether maps of an environment and exponents are on disk, or came with the programs."""
        key = cache_key(environment, exponents)
        return _shipped_path(key).is_file() or self.path(key).is_file()

    def shipped(self, environment: Environment, exponents: Sequence[float]) -> LobeMaps | None:
        """Return the maps that came with the programs; None where none did, or they are damaged."""
        key = cache_key(environment, exponents)
        return self.packaged(_shipped_path(key), lambda path: read_packed_maps(path, key))

    def get_or_compute(
        self,
        environment: Environment,
        exponents: Sequence[float],
        progress: Progress | None = None,
        ready: Ready | None = None,
    ) -> LobeMaps:
        """Return the maps of :func:`prefilter`, from disk where they are there; ``ready`` as there.

        Only an unsound request or a cancelled ``progress`` raises.
        """
        key = cache_key(environment, exponents)
        found = self.shipped(environment, exponents) or self.get_or_make(
            key,
            lambda path: read_maps(path, key),
            lambda watched: prefilter(environment, exponents, watched, ready),
            lambda maps: encode_maps(maps, key, environment.name),
            progress,
        )
        report(progress, 1.0, "the environment is filtered")
        return found


def _shipped_path(key: str) -> Path:
    return resource_root() / PACKAGED / f"{key}{PACKAGED_ENDING}"


def cache_key(environment: Environment, exponents: Sequence[float]) -> str:
    """Return the name of the maps of an environment and exponents: 64 hexadecimal digits."""
    parts = [
        environment.content_hash,
        [float(exponent) for exponent in exponents],
        ALGORITHM_VERSION,
        PLAIN.version,
        background_size(environment),
    ]
    return hashlib.sha256(json.dumps(parts).encode()).hexdigest()
