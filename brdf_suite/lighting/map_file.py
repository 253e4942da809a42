"""Lobe maps as one block of bytes: sizes and checksum, a header of JSON, then the half floats as they are.

Little-endian: ``BRDFMAPS`` · u32 version · u32 length of the header · u64 length of the maps · SHA-256 of all
that stands before and after it · header (JSON, padded to 64 bytes) · maps one after the other. A map that
serves several exponents is stored once. The lengths come first, so that a damaged file is refused before it
is read; the checksum covers the header too, because a changed digit in a scale is wrong light.
"""

from __future__ import annotations

import hashlib
import json
import os
import struct
from pathlib import Path
from typing import Any

import numpy as np

from brdf_suite.lighting.face_array import FaceArray
from brdf_suite.lighting.prefilter import LobeMaps

FORMAT_VERSION = 2
_MAGIC = b"BRDFMAPS"
_SIZES = struct.Struct("<8sIIQ")
_DIGEST_BYTES = 32
_START = _SIZES.size + _DIGEST_BYTES
_ALIGN = 64
_MAX_HEADER = 1 << 20


class DamagedMapFileError(Exception):
    """The bytes are not a whole and unchanged map file of this version; never shown to a user."""


def encode_maps(maps: LobeMaps, key: str, environment: str = "") -> list[bytes | memoryview]:
    """Return the parts of a map file, to be written one after the other.

    ``key`` names what the maps were made from; ``environment`` is what the user calls it, for listings only.
    """
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
    text = json.dumps(header).encode()
    text += b" " * (-(_START + len(text)) % _ALIGN)
    payload = [np.ascontiguousarray(m.faces, dtype="<f2").data.cast("B") for m in distinct]
    sizes = _SIZES.pack(_MAGIC, FORMAT_VERSION, len(text), sum(len(item) for item in payload))
    checksum = hashlib.sha256(sizes + text)
    for item in payload:
        checksum.update(item)
    return [sizes, checksum.digest(), text, *payload]


def decode_maps(data: bytes, key: str) -> LobeMaps:
    """Return the maps of a map file; the arrays are read-only views of ``data``.

    Raises
    ------
    DamagedMapFileError
        ``data`` is truncated, changed, of another version, or was made from something else than ``key``.
    """
    length = _header_length(data[:_START], len(data))
    view = memoryview(data)
    checksum = hashlib.sha256(view[: _SIZES.size])
    checksum.update(view[_START:])
    if checksum.digest() != view[_SIZES.size : _START]:
        raise DamagedMapFileError("its checksum does not fit")
    try:
        header = json.loads(bytes(view[_START : _START + length]))
        return _maps_of(header, view[_START + length :], key)
    except (ValueError, KeyError, TypeError, IndexError, OverflowError, RecursionError) as error:
        raise DamagedMapFileError(f"its header is damaged ({error})") from error


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
        total = os.fstat(stream.fileno()).st_size
        start = stream.read(_START)
        _header_length(start, total)
        stream.seek(0)
        data = stream.read(total)  # one that grows or shrinks meanwhile fails its checksum
    return decode_maps(data, key)


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


def _maps_of(header: dict[str, Any], payload: memoryview, key: str) -> LobeMaps:
    if header["key"] != key:
        raise DamagedMapFileError("made from another environment, or for other lobes")
    sizes = [int(entry["size"]) for entry in header["maps"]]
    lengths = [6 * size * size * 3 * 2 for size in sizes]
    if sum(lengths) != len(payload):
        raise DamagedMapFileError("its maps have other sizes than its header says")
    maps = []
    at = 0
    for entry, size, length in zip(header["maps"], sizes, lengths, strict=True):
        faces = np.frombuffer(payload[at : at + length], dtype="<f2").reshape(6, size, size, 3)
        maps.append(FaceArray(faces, float(entry["scale"])))
        at += length
    exponents = tuple(float(exponent) for exponent in header["exponents"])
    lobes = tuple(maps[index] for index in header["lobes"])
    if len(lobes) != len(exponents):
        raise DamagedMapFileError("its header is damaged")
    return LobeMaps(exponents, lobes, maps[header["diffuse"]], maps[header["background"]])
