"""ICC profiles: written for our picture colour spaces, read from monitors.

A display profile of the kind "matrix/TRC" (ICC.1:2022, section 8.4.3) has the colour of each channel as XYZ in the
profile's connection space, whose white is D50, and a curve for each channel. That is what we write, and what most
monitor profiles hold. One of the kind "N-component LUT-based" (8.4.2) has tables from device codes to the connection
space and back (``A2B0``, ``B2A0``), which are preferred where both kinds are in one profile. littleCMS (as Pillow has
it) applies them, once: to the points of a table of our own. It gets the profile's header and these tables alone, and
only after their sizes were checked.
"""

from __future__ import annotations

import struct
from collections.abc import Mapping
from io import BytesIO

import numpy as np

from brdf_suite.appearance.colour.colorimetry import (
    WORKING_TO_XYZ,
    adaptation,
    primaries_to_xyz,
    srgb_decode,
)
from brdf_suite.appearance.colour.spaces import DisplaySpace, inverse_codes
from brdf_suite.arrays import Bytes, Floats
from brdf_suite.errors import FileError

D50_XYZ = (0.9642, 1.0, 0.8249)
"""The white of the connection space, as ICC.1 states it."""

LARGEST_PROFILE = 64 << 20
_SRGB_PARAMETERS = (2.4, 1.0 / 1.055, 0.055 / 1.055, 1.0 / 12.92, 0.04045)
_CURVE_STEPS = 4096
_PARAMETER_COUNTS = (1, 3, 4, 5, 7)

TABLE_POINTS = 33
"""Points on each axis of the table that a profile with tables is applied to."""

# A triangle of chromaticities somewhat wider than Rec. 2020's, which holds those of the screens that there are.
_WIDE_PRIMARIES = ((0.73, 0.27), (0.13, 0.86), (0.12, 0.02))
_WIDE_TO_WORKING = np.linalg.solve(WORKING_TO_XYZ, primaries_to_xyz(_WIDE_PRIMARIES))
_WIDE_SPACE = DisplaySpace("Wide", np.linalg.inv(_WIDE_TO_WORKING), _WIDE_PRIMARIES)

_LEAST_DETERMINANT = 1e-6
_LARGEST_COLORANT = 4.0
_LARGEST_EXPONENT = 60.0  # what a curve may raise to it, up to 65,536, stays a number


def profile_bytes(space: DisplaySpace) -> bytes:
    """Return the ICC profile, version 4.4, of a space that is defined by its primaries and the sRGB curve.

    Its colours are adapted from D65 to D50 by Bradford's transform, which the profile says too (``chad``).

    Raises :class:`ValueError`: the space is a monitor's.
    """
    if space.primaries is None or space.codes is not None:
        raise ValueError(f"{space.title} is not defined by primaries and the sRGB curve")
    to_xyz = primaries_to_xyz(space.primaries)
    adapt = adaptation(to_xyz.sum(axis=1), D50_XYZ, "Bradford")
    curve = b"para" + struct.pack(">IHH", 0, 3, 0) + _fixed(_SRGB_PARAMETERS)
    return _assemble(_matrix_tags(space.title, adapt @ to_xyz, adapt, curve))


def _matrix_tags(title: str, colours: Floats, adapt: Floats, curve: bytes) -> dict[bytes, bytes]:
    """Return the tags of a profile whose channels have the colours (3, 3), XYZ by column, and one curve."""
    return {
        b"desc": _text(title),
        b"cprt": _text("No copyright, use freely"),
        b"wtpt": b"XYZ \0\0\0\0" + _fixed(D50_XYZ),
        b"chad": b"sf32\0\0\0\0" + _fixed(adapt.ravel()),
        **{
            name: b"XYZ \0\0\0\0" + _fixed(colours[:, i])
            for i, name in enumerate((b"rXYZ", b"gXYZ", b"bXYZ"))
        },
        **dict.fromkeys((b"rTRC", b"gTRC", b"bTRC"), curve),
    }


def _assemble(tags: Mapping[bytes, bytes], header: bytes | None = None) -> bytes:
    """Return a profile of tags: of our own kind, or under another one's ``header`` (128 bytes)."""
    start = 128 + 4 + 12 * len(tags)
    table, data, places = b"", b"", dict[bytes, int]()
    for name, content in tags.items():
        if content not in places:  # tags may share their data: the three curves do
            places[content] = start + len(data)
            data += content + b"\0" * (-len(content) % 4)
        table += struct.pack(">4sII", name, places[content], len(content))
    size = struct.pack(">I", start + len(data))
    rest = _own_header() if header is None else header[4:128]
    return size + rest + struct.pack(">I", len(tags)) + table + data


def _own_header() -> bytes:
    """Return what follows the size in the header of a profile that we write."""
    return struct.pack(
        ">4sI4s4s4s6H4s4sI4s4sQI3i4s44s",
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


def _text(text: str) -> bytes:
    encoded = text.encode("utf-16-be")
    return b"mluc" + struct.pack(">III4sII", 0, 1, 12, b"enUS", len(encoded), 28) + encoded


def _fixed(values: object) -> bytes:
    numbers = np.rint(np.asarray(values, float) * 65536.0).astype(">i4")
    return numbers.tobytes()


def read_display_profile(data: bytes, name: str) -> DisplaySpace:
    """Return the display space of an RGB monitor's profile; ``name`` is what messages call it.

    White goes to the monitor's white, as in a media-relative rendering: eyes adapt to the screen that they see. Through
    tables black goes to the monitor's black as well.

    Raises :class:`FileError`: it is damaged, or not of an RGB device with tables, or a matrix and curves.
    """
    tags = _tags(data, name)
    if b"A2B0" in tags and b"B2A0" in tags:
        return _table_space(data[:128], tags, name)
    if data[20:24] != b"XYZ ":
        raise FileError(name, "connects by Lab, not by XYZ", "byte 20")
    wanted = [b"rXYZ", b"gXYZ", b"bXYZ", b"rTRC", b"gTRC", b"bTRC"]
    missing = [tag.decode() for tag in wanted if tag not in tags]
    if missing:
        raise FileError(
            name,
            f"has no {', '.join(missing)}; expected a matrix with curves, or the tables A2B0 and B2A0",
        )
    colours = np.stack([_xyz(tags[tag], name, tag) for tag in wanted[:3]], axis=1)
    if abs(np.linalg.det(colours)) < _LEAST_DETERMINANT:
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


def _table_space(header: bytes, tags: Mapping[bytes, bytes], name: str) -> DisplaySpace:
    """Return the space of a monitor that tables describe.

    Its primaries, by which colours are found to be out of gamut, are those of its full channels. Their linear light,
    sRGB-encoded, spans our table, whose points are taken to the monitor's codes: relative colorimetric, black to black.
    """
    if header[12:16] != b"mntr":
        raise FileError(name, "is not of a monitor", "byte 12")
    kept = {}
    for default, colorimetric in ((b"A2B0", b"A2B1"), (b"B2A0", b"B2A1")):
        tag = colorimetric if colorimetric in tags else default
        _check_table(tags[tag], name, tag)
        # The default one is for each intent that has none; littleCMS looks for a black point only where one is there.
        kept[colorimetric] = tags[tag]
    monitor = _assemble(kept, header)
    full = 255 * np.eye(3, dtype=np.uint8)
    wide = srgb_decode(_transform(monitor, profile_bytes(_WIDE_SPACE), full, name) / 255.0)
    working = wide @ _WIDE_TO_WORKING.T
    if abs(np.linalg.det(working)) < _LEAST_DETERMINANT:
        raise FileError(name, "has channels whose colours are the same", "A2B0")
    matrix = np.linalg.inv(working.T)
    sums = matrix.sum(axis=1, keepdims=True)
    if sums.min() < _LEAST_DETERMINANT:
        raise FileError(name, "has channels that do not add up to white", "A2B0")
    matrix = np.asarray(matrix / sums)
    adapt = adaptation(WORKING_TO_XYZ.sum(axis=1), D50_XYZ, "Bradford")
    colours = np.asarray(adapt @ WORKING_TO_XYZ @ np.linalg.inv(matrix))
    if np.abs(colours).max() > _LARGEST_COLORANT:
        raise FileError(name, "has channels of impossible colours", "A2B0")
    # Pillow passes 8 bits, in which the table's points have no exact place: so the curve of this profile has the light
    # of the table's i-th point at the code i.
    light = srgb_decode(np.minimum(np.arange(256) / (TABLE_POINTS - 1.0), 1.0))
    steps = np.rint(65535.0 * light).astype(">u2").tobytes()
    curve = b"curv" + struct.pack(">II", 0, 256) + steps
    source = _assemble(_matrix_tags("Table", colours, adapt, curve))
    axis = np.arange(TABLE_POINTS, dtype=np.uint8)
    points = np.stack(np.meshgrid(axis, axis, axis, indexing="ij"), axis=-1)
    codes = _transform(source, monitor, points.reshape(-1, 3), name)
    table = (codes.reshape(points.shape) / 255.0).astype(np.float32)
    return DisplaySpace(_title(tags.get(b"desc", b"")) or name, matrix, table=table)


def _transform(source: bytes, target: bytes, codes: Bytes, name: str) -> Bytes:
    """Return the target's codes (n, 3) for the source's, by littleCMS, evaluated at each colour by itself."""
    # 25 ms at the start of each program, and few monitors need it.
    from PIL import Image, ImageCms

    picture = Image.frombytes("RGB", (len(codes), 1), codes.tobytes())
    try:
        transform = ImageCms.buildTransform(
            ImageCms.ImageCmsProfile(BytesIO(source)),
            ImageCms.ImageCmsProfile(BytesIO(target)),
            "RGB",
            "RGB",
            renderingIntent=ImageCms.Intent.RELATIVE_COLORIMETRIC,
            flags=ImageCms.Flags.NOOPTIMIZE | ImageCms.Flags.BLACKPOINTCOMPENSATION,
        )
        made = ImageCms.applyTransform(picture, transform)
    except (ImageCms.PyCMSError, OSError, ValueError) as error:
        raise FileError(name, f"has tables that cannot be used ({str(error)[:80]})") from error
    assert made is not None  # only where it is done in place
    return np.frombuffer(made.tobytes(), np.uint8).reshape(-1, 3)


def _check_table(content: bytes, name: str, tag: bytes) -> None:
    """Raise :class:`FileError` where a table is not of three channels to three, or larger than its entry.

    ICC.1:2022: lut16Type (10.10), lut8Type (10.11), lutAToBType (10.12), lutBToAType (10.13).
    """
    place, kind = tag.decode(), content[:4]
    if kind not in (b"mft1", b"mft2", b"mAB ", b"mBA ") or len(content) < 52:
        raise FileError(name, "has a table of a kind that is not known", place)
    if content[8:10] != b"\3\3":
        raise FileError(name, f"has a table of {content[8]} channels to {content[9]}, not 3 to 3", place)
    if kind in (b"mAB ", b"mBA "):
        offsets = struct.unpack_from(">5I", content, 12)
        at = offsets[3]
        needed = max(offsets)
        if at:
            if at + 20 > len(content):
                raise FileError(name, "is cut off in a table", place)
            points, width = tuple(content[at : at + 3]), content[at + 16]
            needed = max(needed, at + 20 + 3 * points[0] * points[1] * points[2] * width)
            if min(points) < 2 or width not in (1, 2):
                raise FileError(name, "has a table without points", place)
    else:
        grid = content[10]
        ends = (256, 256) if kind == b"mft1" else struct.unpack_from(">HH", content, 48)
        if min(grid, *ends) < 2 or max(ends) > 4096:
            raise FileError(name, "has a table without points", place)
        numbers = 3 * (grid**3 + sum(ends))
        needed = 48 + numbers if kind == b"mft1" else 52 + 2 * numbers
    if needed > len(content):
        raise FileError(name, "is cut off in a table", place)


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
        if not 0.0 < values[0] <= _LARGEST_EXPONENT:
            raise FileError(
                name,
                f"has a curve with the exponent {values[0]:g}; expected above 0 and up to {_LARGEST_EXPONENT:g}",
                place,
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
