"""Decoder of meshopt compression, as glTF's ``EXT_meshopt_compression`` and ``KHR_meshopt_compression`` define it.

Source: Khronos Group, EXT_meshopt_compression, appendices A (bitstreams) and B (filters), and KHR_meshopt_compression
for version 1 of the vertex bitstream. Vertices are stored in blocks; each byte of a vertex is a stream of differences
in groups of 16, packed in as few bits as they need. Triangles refer to recent edges and corners.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

_Bytes = NDArray[np.uint8]

_GROUP = 16
_LARGEST_BLOCK, _BLOCK_BYTES, _WIDEST = 256, 8192, 256
_BITS = {0: (0, 2, 4, 8), 1: (0, 1, 2, 4, 8)}
_SMALLEST_TAIL = {0: 32, 1: 24}
_NO_TABLE_NEXT, _NO_TABLE = 0xFE, 0xFF
_RECENT = 15


def decode_view(data: memoryview, count: int, stride: int, mode: str, filter_name: str = "NONE") -> bytes:
    """Return the ``count`` elements of ``stride`` bytes that a compressed buffer view holds.

    Parameters
    ----------
    mode
        ``ATTRIBUTES``, ``TRIANGLES`` or ``INDICES``.
    filter_name
        ``NONE``, ``OCTAHEDRAL`` or ``EXPONENTIAL``; others occur with animations and colours alone.

    Raises
    ------
    ValueError, LookupError
        The data are damaged, or of a kind that the specification does not have.
    """
    if mode == "ATTRIBUTES":
        decoded = _vertices(np.frombuffer(data, np.uint8), count, stride)
        return _filtered(decoded, filter_name).tobytes()
    if stride not in (2, 4):
        raise ValueError(f"indices of {stride} bytes")
    if mode == "TRIANGLES":
        indices = _triangles(bytes(data), count)
    elif mode == "INDICES":
        indices = _sequence(bytes(data), count)
    else:
        raise ValueError(f"the mode {mode}")
    return np.asarray(indices, np.uint32).astype(f"<u{stride}").tobytes()


def _version(first: int, kind: int, newest: int) -> int:
    if first & 0xF0 != kind or first & 0x0F > newest:
        raise ValueError("not the bitstream that the file announces")
    return first & 0x0F


def _vertices(data: _Bytes, count: int, stride: int) -> _Bytes:
    """Return vertices (count, stride)."""
    if stride % 4 or not 0 < stride <= _WIDEST:
        raise ValueError(f"vertices of {stride} bytes")
    version = _version(int(data[0]), 0xA0, 1)
    tail = stride + (stride // 4 if version else 0)
    end = len(data) - max(tail, _SMALLEST_TAIL[version])
    if end < 1:
        raise ValueError("cut off")
    tail_bytes = data[len(data) - tail :]
    last, channels = tail_bytes[:stride].copy(), tail_bytes[stride:]
    result = np.empty((count, stride), np.uint8)
    block = min(_BLOCK_BYTES // stride // _GROUP * _GROUP, _LARGEST_BLOCK)
    at = 1
    for first in range(0, count, block):
        size = min(block, count - first)
        control = data[at : at + stride // 4] if version else np.zeros(stride // 4, np.uint8)
        at += stride // 4 if version else 0
        planes = np.empty((stride, size), np.uint8)
        for k in range(stride):
            how = int(control[k // 4]) >> (k % 4 * 2) & 3
            if how == 3:
                planes[k], at = data[at : at + size], at + size
            elif how == 2:
                planes[k] = 0
            else:
                bits = _BITS[version][how : how + 4]
                planes[k], at = _plane(data, at, end, size, bits)
        if at > end:
            raise ValueError("cut off")
        for k in range(0, stride, 4):
            channel = int(channels[k // 4]) if version else 0
            word = _undone(planes[k : k + 4], last[k : k + 4], channel)
            result[first : first + size, k : k + 4] = word
        last = result[first + size - 1]
    if at != end:
        raise ValueError("holds more than its vertices")
    return result


def _plane(data: _Bytes, at: int, end: int, size: int, bits: tuple[int, ...]) -> tuple[_Bytes, int]:
    """Return the stream of one byte (size,) and where the next begins."""
    groups = -(-size // _GROUP)
    header = data[at : at + -(-groups // 4)]
    at += len(header)
    widths = [bits[int(header[g >> 2]) >> (g % 4 * 2) & 3] for g in range(groups)]
    plane = np.zeros((groups, _GROUP), np.uint8)
    for number, width in enumerate(widths):
        if width == 0:
            continue
        packed = data[at : at + 2 * width]
        at += 2 * width
        if at > end:
            raise ValueError("cut off")
        if width == 8:
            plane[number] = packed
            continue
        values = _unpacked(packed, width)
        whole = values == (1 << width) - 1
        longer = int(np.count_nonzero(whole))
        if longer:
            values[whole] = data[at : at + longer]
            at += longer
        plane[number] = values
    return plane.reshape(-1)[:size], at


def _unpacked(packed: _Bytes, width: int) -> _Bytes:
    """Return 16 values of 2 or 4 bits, the highest bits of a byte first, or of 1 bit, the lowest first."""
    shifts = np.arange(8) if width == 1 else np.arange(8 - width, -1, -width)
    return (packed[:, None] >> shifts.astype(np.uint8) & np.uint8((1 << width) - 1)).reshape(-1)


def _undone(planes: _Bytes, last: _Bytes, channel: int) -> _Bytes:
    """Return four bytes of vertices (n, 4) from their differences (4, n) to the vertex before."""
    kind = channel & 3
    if kind == 0:
        steps = _unzigzag(planes.T)
        return np.asarray((np.cumsum(steps, axis=0, dtype=np.uint8) + last).astype(np.uint8))
    rows = np.ascontiguousarray(planes.T)
    if kind == 1:
        halves = np.cumsum(_unzigzag(rows.view("<u2")), axis=0, dtype=np.uint16)
        return np.ascontiguousarray((halves + last.view("<u2")).astype("<u2")).view(np.uint8)
    if kind != 2:
        raise ValueError("a channel of an unknown kind")
    words = rows.view("<u4")[:, 0].astype(np.uint32)
    turn = np.uint32((32 - (channel >> 4)) & 31)
    if turn:
        words = words << turn | words >> np.uint32(32 - turn)
    words[0] ^= last.view("<u4")[0]
    return np.bitwise_xor.accumulate(words).astype("<u4").view(np.uint8).reshape(-1, 4)


def _unzigzag(values: NDArray[Any]) -> NDArray[Any]:
    one = values.dtype.type(1)
    return np.asarray((values >> one) ^ (values.dtype.type(0) - (values & one)))


def _filtered(vertices: _Bytes, filter_name: str) -> NDArray[Any]:
    stride = vertices.shape[1]
    if filter_name == "NONE":
        return vertices
    if filter_name == "EXPONENTIAL":
        words = vertices.view("<i4")
        with np.errstate(over="ignore"):
            return np.asarray(np.ldexp((words << 8 >> 8).astype(np.float32), words >> 24), "<f4")
    if filter_name != "OCTAHEDRAL" or stride not in (4, 8):
        raise ValueError(f"the filter {filter_name} on vertices of {stride} bytes")
    kind = np.dtype("i1" if stride == 4 else "<i2")
    largest = float(np.iinfo(kind).max)
    stored = vertices.view(kind).astype(np.float32)
    x, y = stored[:, 0], stored[:, 1]
    z = stored[:, 2] - np.abs(x) - np.abs(y)
    fold = np.minimum(z, 0.0)
    vectors = np.stack([x + np.where(x >= 0.0, fold, -fold), y + np.where(y >= 0.0, fold, -fold), z], axis=1)
    length = np.linalg.norm(vectors, axis=1, keepdims=True)
    stored[:, :3] = np.rint(vectors * (largest / np.maximum(length, 1e-20)))
    return stored.astype(kind)


def _leb128(data: bytes, at: int, end: int) -> tuple[int, int]:
    value = 0
    for shift in range(0, 35, 7):
        if at >= end:
            raise ValueError("cut off")
        byte = data[at]
        at += 1
        value |= (byte & 127) << shift
        if byte < 128:
            break
    return value & 0xFFFFFFFF, at


def _stepped(last: int, value: int) -> int:
    return (last + ((value >> 1) ^ -(value & 1))) & 0xFFFFFFFF


def _sequence(data: bytes, count: int) -> list[int]:
    _version(data[0], 0xD0, 1)
    end, at, last, result = len(data) - 4, 1, [0, 0], []
    for _ in range(count):
        value, at = _leb128(data, at, end)
        which = value & 1
        last[which] = _stepped(last[which], value >> 1)
        result.append(last[which])
    if at != end:
        raise ValueError("holds more than its indices")
    return result


def _triangles(data: bytes, count: int) -> list[int]:
    """Return ``count`` indices, three a triangle."""
    if count % 3:
        raise ValueError("the indices are no whole triangles")
    version = _version(data[0], 0xE0, 1)
    farthest = 13 if version else 15
    end, at = len(data) - 16, 1 + count // 3
    if at > end:
        raise ValueError("cut off")
    table = data[end:]
    edges: list[tuple[int, int]] = [(0, 0)] * 16
    corners = [0] * 16
    edge, corner, fresh, last = 0, 0, 0, 0
    result: list[int] = []
    for code in data[1 : 1 + count // 3]:
        far = code & 15
        if code < 0xF0:
            a, b = edges[(edge - 1 - (code >> 4)) & 15]
            if far == 0:
                c, fresh = fresh, fresh + 1
            elif far < farthest:
                c = corners[(corner - 1 - far) & 15]
            elif far != _RECENT:
                c = last = (last + (far - (far ^ 3))) & 0xFFFFFFFF
            else:
                value, at = _leb128(data, at, end)
                c = last = _stepped(last, value)
            if far == 0 or far >= farthest:
                corners[corner] = c
                corner = (corner + 1) & 15
            result += (a, b, c)
            edges[edge] = (c, b)
            edges[(edge + 1) & 15] = (a, c)
            edge = (edge + 2) & 15
            continue
        if code < _NO_TABLE_NEXT:
            both, first = table[far], 0
        else:
            if at >= end:
                raise ValueError("cut off")
            both, first = data[at], 0 if code == _NO_TABLE_NEXT else _RECENT
            at += 1
            if both == 0:
                fresh = 0
        explicit = code >= _NO_TABLE_NEXT  # only then 15 means that an index follows
        found = []
        for place in (first, both >> 4, both & 15):
            if place == 0:
                found.append(fresh)
                fresh += 1
            else:
                found.append(-1 if explicit and place == _RECENT else corners[(corner - place) & 15])
        for k, index in enumerate(found):
            if index < 0:
                value, at = _leb128(data, at, end)
                last = _stepped(last, value)
                found[k] = last
        a, b, c = found
        for place, index in ((0, a), (both >> 4, b), (both & 15, c)):
            if place == 0 or (explicit and place == _RECENT):
                corners[corner] = index
                corner = (corner + 1) & 15
        result += found
        for pair in ((b, a), (c, b), (a, c)):
            edges[edge] = pair
            edge = (edge + 1) & 15
    if at != end:
        raise ValueError("holds more than its triangles")
    return result
