"""Lobe maps without loss in a thirtieth of the bytes, as the programs ship those of the default light.

Little-endian: ``BRDFPACK`` · u32 version · u32 length of the header · SHA-256 of all that follows · header (JSON, as
in :mod:`brdf_suite.lighting.cache.maps.map_file`) · one zlib stream per map. A stream holds the bits of the half
floats as 16-bit integers, each less its left neighbour in the row, one channel after the other; of a grey map only
the first channel. Filtered light is smooth, so the differences are small and often equal.
"""

from __future__ import annotations

import hashlib
import json
import os
import struct
import zlib
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from brdf_suite.lighting.cache.map_file import DamagedMapFileError, describe_maps, maps_of_header
from brdf_suite.lighting.filter.harmonics import worker_count
from brdf_suite.lighting.filter.prefilter import LobeMaps

FORMAT_VERSION = 1
_MAGIC = b"BRDFPACK"
_SIZES = struct.Struct("<8sII")
_DIGEST_BYTES = 32
_START = _SIZES.size + _DIGEST_BYTES
_LEVEL = 9


def pack_maps(maps: LobeMaps, key: str, environment: str) -> bytes:
    """Return the maps as the bytes of a file; ``key`` and ``environment`` as for
    :func:`brdf_suite.lighting.cache.maps.map_file.encode_maps`."""
    distinct, header = describe_maps(maps, key, environment)
    streams = []
    for entry, item in zip(header["maps"], distinct, strict=True):
        bits = np.moveaxis(np.asarray(item.faces, dtype="<f2").view("<u2"), -1, 0)
        grey = np.array_equal(bits[0], bits[1]) and np.array_equal(bits[0], bits[2])
        kept = bits[:1] if grey else bits
        streams.append(zlib.compress(np.diff(kept, axis=-1, prepend=np.uint16(0)).tobytes(), _LEVEL))
        entry |= {"channels": len(kept), "bytes": len(streams[-1])}
    text = json.dumps(header).encode()
    body = b"".join((text, *streams))
    return _SIZES.pack(_MAGIC, FORMAT_VERSION, len(text)) + hashlib.sha256(body).digest() + body


def read_packed_maps(path: str | os.PathLike[str], key: str) -> LobeMaps:
    """Return the maps of the file ``path``, which is one that comes with the programs; the arrays are read-only.

    Raises
    ------
    DamagedMapFileError
        The file is truncated, changed, of another version, or was made from something else than ``key``.
    OSError
        The file cannot be read.
    """
    data = Path(path).read_bytes()
    if len(data) < _START or data[: len(_MAGIC)] != _MAGIC:
        raise DamagedMapFileError("not a file of packed maps")
    _, version, length = _SIZES.unpack_from(data)
    if version != FORMAT_VERSION:
        raise DamagedMapFileError(f"of version {version}, not {FORMAT_VERSION}")
    body = memoryview(data)[_START:]
    if hashlib.sha256(body).digest() != data[_SIZES.size : _START]:
        raise DamagedMapFileError("its checksum does not fit")
    header: dict[str, Any] = json.loads(bytes(body[:length]))
    if header["key"] != key:
        raise DamagedMapFileError("made from another environment, or for other lobes")
    ends = length + np.cumsum([entry["bytes"] for entry in header["maps"]])
    streams = [body[end - entry["bytes"] : end] for end, entry in zip(ends, header["maps"], strict=True)]
    # The largest first: they come last in the file, and one of them is half of the work.
    order = sorted(range(len(streams)), key=lambda index: -int(header["maps"][index]["size"]))
    with ThreadPoolExecutor(worker_count()) as pool:
        found = {index: pool.submit(_unpacked, header["maps"][index], streams[index]) for index in order}
        faces = [found[index].result() for index in range(len(streams))]
    return maps_of_header(header, faces)


def _unpacked(entry: dict[str, Any], stream: memoryview) -> NDArray[np.float16]:
    size, channels = int(entry["size"]), int(entry["channels"])
    differences = np.frombuffer(zlib.decompress(stream), dtype="<u2").reshape(channels, 6, size, size)
    faces = np.empty((6, size, size, 3), dtype="<f2")
    bits = faces.view("<u2")
    for face in range(6):
        planes = np.cumsum(differences[:, face], axis=-1, dtype=np.uint16)
        bits[face] = np.moveaxis(planes, 0, -1)
    faces.flags.writeable = False
    return faces
