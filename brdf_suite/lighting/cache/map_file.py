"""File format of lobe maps: sizes and checksum, a JSON header, and raw half floats.

Little-endian: ``BRDFMAPS`` · u32 version · u32 length of the header · u64 length of the maps · SHA-256 of what
stands before and of the header · header (JSON, padded to 64 bytes) · maps one after the other. A map that
serves several exponents is stored once. The header holds a CRC-32 for each MiB of maps: on every machine
several times as fast as a SHA-256, done while the next MiB is read, and no change of up to 32 neighbouring
bits escapes it. The lengths come first, so that a damaged file is refused before it is read; the checksum
covers the header too, because a changed digit in a scale is wrong light.
"""

from __future__ import annotations

import hashlib
import io
import json
import os
import struct
import zlib
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any, TypeAlias

import numpy as np
from numpy.typing import NDArray

from brdf_suite.lighting.filter.face_array import FaceArray
from brdf_suite.lighting.filter.harmonics import worker_count
from brdf_suite.lighting.filter.prefilter import LobeMaps

FORMAT_VERSION = 3
_MAGIC = b"BRDFMAPS"
_SIZES = struct.Struct("<8sIIQ")
_DIGEST_BYTES = 32
_START = _SIZES.size + _DIGEST_BYTES
_ALIGN = 64
_BLOCK_BYTES = 1 << 20

_Stream: TypeAlias = io.BufferedReader | io.BytesIO
_MAX_HEADER = 1 << 20


class DamagedMapFileError(Exception):
    """A truncated or damaged map file, or one of another version; never shown to a user."""


def encode_maps(maps: LobeMaps, key: str, environment: str = "") -> list[bytes | memoryview]:
    """Return the parts of a map file, to be written one after the other.

    ``key`` names what the maps were made from; ``environment`` is what the user calls it, for listings only.
    """
    distinct, header = describe_maps(maps, key, environment)
    payload = [np.ascontiguousarray(m.faces, dtype="<f2").data.cast("B") for m in distinct]
    header["crc32"] = [zlib.crc32(block) for item in payload for block in _blocks(item)]
    text = json.dumps(header).encode()
    text += b" " * (-(_START + len(text)) % _ALIGN)
    sizes = _SIZES.pack(_MAGIC, FORMAT_VERSION, len(text), sum(len(item) for item in payload))
    return [sizes, hashlib.sha256(sizes + text).digest(), text, *payload]


def describe_maps(maps: LobeMaps, key: str, environment: str) -> tuple[list[FaceArray], dict[str, Any]]:
    """Return the distinct maps in the order of a file, and the header that says what each of them serves."""
    distinct = list({id(m): m for m in (maps.diffuse, maps.background, *maps.lobes)}.values())
    place = {id(m): index for index, m in enumerate(distinct)}
    header = {
        "key": key,
        "environment": environment,
        "exponents": maps.exponents,
        "lobes": [place[id(m)] for m in maps.lobes],
        "diffuse": place[id(maps.diffuse)],
        "background": place[id(maps.background)],
        "maps": [{"size": m.size, "scale": m.scale} for m in distinct],
    }
    return distinct, header


def decode_maps(data: bytes, key: str) -> LobeMaps:
    """Return the maps of a map file; the arrays are read-only.

    Raises
    ------
    DamagedMapFileError
        ``data`` is truncated, changed, of another version, or was made from something else than ``key``.
    """
    return _read(io.BytesIO(data), len(data), key)


def read_map_file(path: str | os.PathLike[str], key: str) -> LobeMaps:
    """Return the maps of the file ``path``; nothing is read of a file whose length does not fit.

    Raises
    ------
    DamagedMapFileError
        As for :func:`decode_maps`.
    OSError
        The file cannot be read.
    """
    with Path(path).open("rb") as stream:
        return _read(stream, os.fstat(stream.fileno()).st_size, key)


def read_facts(path: str | os.PathLike[str]) -> dict[str, Any]:
    """Return the header of the file ``path`` as plain values, for listings; the checksum is not looked at.

    Raises
    ------
    DamagedMapFileError
        There is no header that can be read.
    OSError
        The file cannot be read.
    """
    with Path(path).open("rb") as stream:
        length = _header_length(stream.read(_START), os.fstat(stream.fileno()).st_size)
        text = stream.read(length)
    try:
        header = json.loads(text)
    except (ValueError, RecursionError) as error:
        raise DamagedMapFileError(f"its header is damaged ({error})") from error
    if not isinstance(header, dict):
        raise DamagedMapFileError("its header is damaged")
    return header


def _header_length(start: bytes, total: int) -> int:
    """Return the header's length of a file of ``total`` bytes that begins with ``start``."""
    if len(start) < _START or start[: len(_MAGIC)] != _MAGIC:
        raise DamagedMapFileError("not a map file")
    _, version, length, payload = _SIZES.unpack_from(start)
    if version != FORMAT_VERSION:
        raise DamagedMapFileError(f"of version {version}, not {FORMAT_VERSION}")
    if length > _MAX_HEADER or _START + length + payload != total:
        raise DamagedMapFileError("cut off, or longer than it should be")
    return int(length)


def _read(stream: _Stream, total: int, key: str) -> LobeMaps:
    """Return the maps of a stream of ``total`` bytes; one that grows or shrinks meanwhile is refused."""
    start = _exactly(stream, _START)
    length = _header_length(start, total)
    text = _exactly(stream, length)
    if hashlib.sha256(start[: _SIZES.size] + text).digest() != start[_SIZES.size :]:
        raise DamagedMapFileError("its checksum does not fit")
    try:
        header = json.loads(text)
        if header["key"] != key:
            raise DamagedMapFileError("made from another environment, or for other lobes")
        sizes = [int(entry["size"]) for entry in header["maps"]]
        sums = [int(number) for number in header["crc32"]]
        if sum(map(_map_bytes, sizes)) != total - _START - length:
            raise DamagedMapFileError("its maps have other sizes than its header says")
        return maps_of_header(header, _checked_maps(stream, sizes, sums))
    except (ValueError, KeyError, TypeError, IndexError, OverflowError, RecursionError) as error:
        raise DamagedMapFileError(f"its header is damaged ({error})") from error


def _exactly(stream: _Stream, count: int) -> bytes:
    data = stream.read(count)
    if len(data) != count:
        raise DamagedMapFileError("cut off")
    return data


def _map_bytes(size: int) -> int:
    return 6 * size * size * 3 * 2


def _blocks(data: memoryview) -> Iterator[memoryview]:
    return (data[at : at + _BLOCK_BYTES] for at in range(0, len(data), _BLOCK_BYTES))


def _checked_maps(stream: _Stream, sizes: list[int], sums: list[int]) -> list[NDArray[np.float16]]:
    """Return read-only faces (6, size, size, 3) for each size; sums are taken while the next block is read."""
    maps = []
    found = []
    with ThreadPoolExecutor(worker_count()) as pool:
        for size in sizes:
            faces = np.empty((6, size, size, 3), dtype="<f2")
            for block in _blocks(faces.data.cast("B")):
                if stream.readinto(block) != len(block):
                    raise DamagedMapFileError("cut off")
                found.append(pool.submit(zlib.crc32, block))
            faces.flags.writeable = False
            maps.append(faces)
        if [item.result() for item in found] != sums:
            raise DamagedMapFileError("a checksum of its maps does not fit")
    return maps


def maps_of_header(header: dict[str, Any], faces: list[NDArray[np.float16]]) -> LobeMaps:
    """Return the maps that a header of :func:`describe_maps` speaks of; ``faces`` in its order."""
    maps = [FaceArray(item, float(entry["scale"])) for item, entry in zip(faces, header["maps"], strict=True)]
    exponents = tuple(float(exponent) for exponent in header["exponents"])
    lobes = tuple(maps[index] for index in header["lobes"])
    if len(lobes) != len(exponents):
        raise DamagedMapFileError("its header is damaged")
    return LobeMaps(exponents, lobes, maps[header["diffuse"]], maps[header["background"]])
