"""Lobe maps as one block of bytes: a line of JSON with sizes and checksum, then the half floats as they are.

``BRDFMAPS`` · u32 length of the header · header (JSON) · padding to 64 bytes · maps one after the other. A
map that serves several exponents is stored once.
"""

from __future__ import annotations

import hashlib
import json
import struct
from typing import Any

import numpy as np

from brdf_suite.lighting.face_array import FaceArray
from brdf_suite.lighting.prefilter import LobeMaps

FORMAT_VERSION = 1
_MAGIC = b"BRDFMAPS"
_ALIGN = 64
_MAX_HEADER = 1 << 20


class DamagedMapFileError(Exception):
    """The bytes are not a whole and unchanged map file of this version; never shown to a user."""


def encode_maps(maps: LobeMaps, key: str) -> list[bytes | memoryview]:
    """Return the parts of a map file, to be written one after the other; ``key`` names what it was made from."""
    distinct = list({id(m): m for m in (maps.diffuse, maps.background, *maps.lobes)}.values())
    place = {id(m): index for index, m in enumerate(distinct)}
    checksum = hashlib.sha256()
    for item in distinct:
        checksum.update(item.faces.data)
    header = {
        "version": FORMAT_VERSION,
        "key": key,
        "exponents": maps.exponents,
        "lobes": [place[id(m)] for m in maps.lobes],
        "diffuse": place[id(maps.diffuse)],
        "background": place[id(maps.background)],
        "maps": [{"size": m.size, "scale": m.scale} for m in distinct],
        "sha256": checksum.hexdigest(),
    }
    text = json.dumps(header).encode()
    text += b" " * (-(len(_MAGIC) + 4 + len(text)) % _ALIGN)
    return [_MAGIC, struct.pack("<I", len(text)), text, *(m.faces.data.cast("B") for m in distinct)]


def decode_maps(data: bytes, key: str) -> LobeMaps:
    """Return the maps of a map file; the arrays are read-only views of ``data``.

    Raises
    ------
    DamagedMapFileError
        ``data`` is truncated, changed, of another version, or was made from something else than ``key``.
    """
    start = len(_MAGIC) + 4
    if data[: len(_MAGIC)] != _MAGIC or len(data) < start:
        raise DamagedMapFileError("not a map file")
    (length,) = struct.unpack_from("<I", data, len(_MAGIC))
    if length > _MAX_HEADER or start + length > len(data):
        raise DamagedMapFileError("cut off within its header")
    try:
        header = json.loads(data[start : start + length])
        return _maps_of(header, memoryview(data)[start + length :], key)
    except (ValueError, KeyError, TypeError, IndexError) as error:
        raise DamagedMapFileError(f"its header is damaged ({error})") from error


def _maps_of(header: dict[str, Any], payload: memoryview, key: str) -> LobeMaps:
    if header["version"] != FORMAT_VERSION or header["key"] != key:
        raise DamagedMapFileError("made by another version or from another environment")
    sizes = [int(entry["size"]) for entry in header["maps"]]
    lengths = [6 * size * size * 3 * 2 for size in sizes]
    if sum(lengths) != len(payload):
        raise DamagedMapFileError("cut off")
    if hashlib.sha256(payload).hexdigest() != header["sha256"]:
        raise DamagedMapFileError("its checksum does not fit")
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
