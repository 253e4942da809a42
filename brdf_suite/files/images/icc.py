"""ICC profiles: written for our picture colour spaces, read from monitors.

A display profile of the kind "matrix/TRC" (ICC.1:2022, section 8.4.3) has the colour of each channel as XYZ in the
profile's connection space, whose white is D50, and a curve for each channel. That is what we write, and what most
monitor profiles hold, beside tables that we leave alone.
"""

from __future__ import annotations

import struct
from collections.abc import Mapping

import numpy as np

from brdf_suite.appearance.colour.colorimetry import WORKING_TO_XYZ, adaptation, primaries_to_xyz
from brdf_suite.appearance.colour.spaces import DisplaySpace, inverse_codes
from brdf_suite.arrays import Floats
from brdf_suite.errors import FileError

D50_XYZ = (0.9642, 1.0, 0.8249)
"""The white of the connection space, as ICC.1 states it."""

LARGEST_PROFILE = 64 << 20
_SRGB_PARAMETERS = (2.4, 1.0 / 1.055, 0.055 / 1.055, 1.0 / 12.92, 0.04045)
_CURVE_STEPS = 4096
_PARAMETER_COUNTS = (1, 3, 4, 5, 7)


def profile_bytes(space: DisplaySpace) -> bytes:
    """Return the ICC profile, version 4.4, of a space that is defined by its primaries and the sRGB curve.

    Its colours are adapted from D65 to D50 by Bradford's transform, which the profile says too (``chad``).

    Raises :class:`ValueError`: the space is a monitor's.
    """
    if space.primaries is None or space.codes is not None:
        raise ValueError(f"{space.title} is not defined by primaries and the sRGB curve")
    to_xyz = primaries_to_xyz(space.primaries)
    adapt = adaptation(to_xyz.sum(axis=1), D50_XYZ, "Bradford")
    colours = adapt @ to_xyz
    curve = b"para" + struct.pack(">IHH", 0, 3, 0) + _fixed(_SRGB_PARAMETERS)
    tags = {
        b"desc": _text(space.title),
        b"cprt": _text("No copyright, use freely"),
        b"wtpt": b"XYZ \0\0\0\0" + _fixed(D50_XYZ),
        b"chad": b"sf32\0\0\0\0" + _fixed(adapt.ravel()),
        **{
            name: b"XYZ \0\0\0\0" + _fixed(colours[:, i])
            for i, name in enumerate((b"rXYZ", b"gXYZ", b"bXYZ"))
        },
        **dict.fromkeys((b"rTRC", b"gTRC", b"bTRC"), curve),
    }
    return _assemble(tags)


def _assemble(tags: Mapping[bytes, bytes]) -> bytes:
    start = 128 + 4 + 12 * len(tags)
    table, data, places = b"", b"", dict[bytes, int]()
    for name, content in tags.items():
        if content not in places:  # tags may share their data: the three curves do
            places[content] = start + len(data)
            data += content + b"\0" * (-len(content) % 4)
        table += struct.pack(">4sII", name, places[content], len(content))
    header = struct.pack(
        ">I4sI4s4s4s6H4s4sI4s4sQI3i4s44s",
        start + len(data),
        b"\0\0\0\0",
        0x04400000,
        b"mntr",
        b"RGB ",
        b"XYZ ",
        *(2024, 1, 1, 0, 0, 0),  # a fixed date: the same profile is the same bytes
        b"acsp",
        b"\0\0\0\0",
        0,
        b"\0\0\0\0",
        b"\0\0\0\0",
        0,
        1,  # media-relative colorimetric
        *(round(65536 * value) for value in D50_XYZ),
        b"\0\0\0\0",
        b"",
    )
    return header + struct.pack(">I", len(tags)) + table + data


def _text(text: str) -> bytes:
    encoded = text.encode("utf-16-be")
    return b"mluc" + struct.pack(">III4sII", 0, 1, 12, b"enUS", len(encoded), 28) + encoded


def _fixed(values: object) -> bytes:
    numbers = np.rint(np.asarray(values, float) * 65536.0).astype(">i4")
    return numbers.tobytes()


def read_display_profile(data: bytes, name: str) -> DisplaySpace:
    """Return the display space of an RGB monitor's profile; ``name`` is what messages call it.

    White goes to the monitor's white, as in a media-relative rendering: eyes adapt to the screen that they see.

    Raises :class:`FileError`: it is damaged, or not of an RGB device with a matrix and curves.
    """
    tags = _tags(data, name)
    wanted = [b"rXYZ", b"gXYZ", b"bXYZ", b"rTRC", b"gTRC", b"bTRC"]
    missing = [tag.decode() for tag in wanted if tag not in tags]
    if missing:
        raise FileError(
            name,
            f"has no {', '.join(missing)}: it describes the screen by tables alone; expected a matrix with curves",
        )
    colours = np.stack([_xyz(tags[tag], name, tag) for tag in wanted[:3]], axis=1)
    if abs(np.linalg.det(colours)) < 1e-6:
        raise FileError(name, "has channels whose colours are the same", "rXYZ, gXYZ, bXYZ")
    curves = np.stack([_curve(tags[tag], name, tag) for tag in wanted[3:]], axis=1)
    to_d50 = adaptation(WORKING_TO_XYZ.sum(axis=1), D50_XYZ, "Bradford") @ WORKING_TO_XYZ
    matrix = np.asarray(np.linalg.solve(colours, to_d50), np.float64)
    # The profile's rounding would tint white by a code; its sum is D50 by definition.
    matrix = np.asarray(matrix / matrix.sum(axis=1, keepdims=True))
    title = _title(tags.get(b"desc", b"")) or name
    return DisplaySpace(title, matrix, None, inverse_codes(curves))


def _tags(data: bytes, name: str) -> dict[bytes, bytes]:
    if len(data) < 132 or data[36:40] != b"acsp":
        raise FileError(name, "is not an ICC profile", "byte 36")
    if len(data) > LARGEST_PROFILE:
        raise FileError(name, f"is larger than {LARGEST_PROFILE >> 20} MB")
    if data[16:20] != b"RGB ":
        raise FileError(
            name, f"is of a device in {data[16:20].decode('latin-1').strip()!r}, not RGB", "byte 16"
        )
    if data[20:24] != b"XYZ ":
        raise FileError(name, "connects by Lab, not by XYZ", "byte 20")
    (count,) = struct.unpack_from(">I", data, 128)
    if not 0 < count <= 100 or 132 + 12 * count > len(data):
        raise FileError(name, f"says that it has {count} entries, which it is too short for", "byte 128")
    tags = {}
    for i in range(count):
        tag, offset, size = struct.unpack_from(">4sII", data, 132 + 12 * i)
        if offset + size > len(data):
            raise FileError(name, f"is cut off in its entry {tag.decode('latin-1')!r}", f"byte {len(data)}")
        tags[tag] = data[offset : offset + size]
    return tags


def _xyz(content: bytes, name: str, tag: bytes) -> Floats:
    if len(content) < 20 or content[:4] != b"XYZ ":
        raise FileError(name, "holds no XYZ colour", tag.decode())
    return np.asarray(np.frombuffer(content, ">i4", 3, 8) / 65536.0)


def _curve(content: bytes, name: str, tag: bytes) -> Floats:
    """Return the linear light (4096,), up to 1 and never falling, of evenly spaced codes."""
    codes = np.linspace(0.0, 1.0, _CURVE_STEPS)
    place = tag.decode()
    if content[:4] == b"curv" and len(content) >= 12:
        (count,) = struct.unpack_from(">I", content, 8)
        if len(content) < 12 + 2 * count:
            raise FileError(name, "is cut off in a curve", place)
        values = np.frombuffer(content, ">u2", count, 12).astype(float)
        if count == 0:
            light = codes
        elif count == 1:
            light = codes ** (values[0] / 256.0)
        else:
            light = np.interp(codes, np.linspace(0.0, 1.0, count), values / 65535.0)
    elif content[:4] == b"para" and len(content) >= 16:
        (kind,) = struct.unpack_from(">H", content, 8)
        if kind >= len(_PARAMETER_COUNTS) or len(content) < 12 + 4 * _PARAMETER_COUNTS[kind]:
            raise FileError(name, f"has a curve of a kind ({kind}) that is not known, or cut off", place)
        values = np.frombuffer(content, ">i4", _PARAMETER_COUNTS[kind], 12).astype(float) / 65536.0
        if values[0] <= 0.0:
            raise FileError(
                name, f"has a curve with the exponent {values[0]:g}, which is not positive", place
            )
        light = _parametric(codes, kind, values)
    else:
        raise FileError(name, "has a curve of a kind that is not known", place)
    light = np.maximum.accumulate(np.clip(np.nan_to_num(light), 0.0, 1.0))
    if light[-1] - light[0] < 0.5:
        raise FileError(name, "has a curve that does not rise from black to white", place)
    # What a screen gives at its first and last code stays: what is darker or brighter is then that, and the rest
    # is not moved.
    return np.asarray(light, np.float64)


def _parametric(x: Floats, kind: int, values: Floats) -> Floats:
    """ICC.1:2022, table 68: a power with, from kind to kind, an offset, a straight start and offsets of both."""
    g = values[0]
    a, b = (values[1], values[2]) if kind else (1.0, 0.0)
    power = np.maximum(a * x + b, 0.0) ** g
    if kind <= 1:
        return np.asarray(np.where(a * x + b >= 0.0, power, 0.0))
    if kind == 2:
        return np.asarray(np.where(a * x + b >= 0.0, power, 0.0) + values[3])
    c, d = values[3], values[4]
    e, f = (values[5], values[6]) if kind == 4 else (0.0, 0.0)
    return np.asarray(np.where(x >= d, power + e, c * x + f))


def _title(content: bytes) -> str:
    """Return the text of a description of version 2 (``desc``) or 4 (``mluc``); empty where it has none."""
    if content[:4] == b"desc" and len(content) >= 12:
        (length,) = struct.unpack_from(">I", content, 8)
        text = content[12 : 12 + length].decode("latin-1")
    elif content[:4] == b"mluc" and len(content) >= 28:
        length, offset = struct.unpack_from(">II", content, 20)
        text = content[offset : offset + length].decode("utf-16-be", errors="replace")
    else:
        return ""
    return "".join(character for character in text if character.isprintable())[:100].strip()
