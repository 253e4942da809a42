"""Read Radiance pictures (.hdr, .pic): RGBE and XYZE, flat, old and new run-length coding.

Format: G. Ward, "Real Pixels", Graphics Gems II (1991), and the Radiance reference manual, "File Formats".
A pixel is four bytes: three mantissas and a shared exponent e; a channel is (mantissa + 1/2)·2^(e - 136), and
0 where e is 0. ``EXPOSURE`` and ``COLORCORR`` lines state the factors applied to the stored values; they are
divided out, so that the result is radiance.
"""

from __future__ import annotations

import re

import numpy as np
from numpy.typing import NDArray

from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.images.area_reduction import check_reducible, read_reduced
from brdf_suite.files.images.exr.header import MAX_PIXELS
from brdf_suite.files.images.primaries import REC709, Chromaticities, rgb_to_xyz
from brdf_suite.regular_files import read_bytes

_SIZE = re.compile(rb"([-+])([XY]) +(\d{1,9}) +([-+])([XY]) +(\d{1,9})\s*$")
_MAX_HEADER = 65536
_MAX_EXPOSURE = 1e12


def read_radiance(
    path: PathLike,
) -> tuple[NDArray[np.float32], Chromaticities, tuple[str, ...]]:
    """Return pixels (h, w, 3) float32 in the file's own primaries, those primaries, and notes.

    Raises :class:`FileError`: the file is damaged, truncated or not a Radiance picture.
    """
    data = read_bytes(path)
    if not data.startswith((b"#?RADIANCE", b"#?RGBE", b"#?AUTOPANO")):
        raise FileError(path, "is not a Radiance picture (it does not begin with #?RADIANCE)", "byte 0")
    fields, size_line, start = _header(path, data)
    signs, axes, sizes = _size(path, size_line, start)
    width, height = sizes[1], sizes[0]
    check_reducible(path, height, width, f"byte {start - len(size_line) - 1}")
    lines = _Lines(path, data, start, height, width, _gain(path, fields))
    pixels, reduced = read_reduced(height, width, lines.read, strip_rows=16)  # few lines stay in the cache
    pixels = _orient(pixels, signs, axes)
    if fields.get("FORMAT") == "32-bit_rle_xyze":
        to_rgb = np.linalg.inv(rgb_to_xyz(REC709)).astype(np.float32)
        return pixels @ to_rgb.T, REC709, ("stored as XYZ", *reduced)
    primaries, notes = _primaries(fields)
    return pixels, primaries, (*notes, *reduced)


def _header(path: PathLike, data: bytes) -> tuple[dict[str, str], bytes, int]:
    """Return the fields, the size line and the place of the pixels; repeated fields are joined by ';'."""
    fields: dict[str, str] = {}
    at, blank = 0, False
    while True:
        end = data.find(b"\n", at, at + 4096)
        if end < 0 or at > _MAX_HEADER:
            raise FileError(path, "is cut off or damaged within its header", f"byte {at}")
        line = data[at:end].rstrip(b"\r")
        at = end + 1
        if blank:
            return fields, line, at
        blank = not line
        key, found, value = line.decode("latin-1").partition("=")
        if found:
            key = key.strip().upper()
            several = key in ("EXPOSURE", "COLORCORR") and key in fields
            fields[key] = f"{fields[key]};{value.strip()}" if several else value.strip()
            if key == "FORMAT" and fields[key] not in ("32-bit_rle_rgbe", "32-bit_rle_xyze"):
                raise FileError(
                    path, f"has the pixel format {value.strip()[:40]!r}, which is not read", "line FORMAT"
                )


def _size(
    path: PathLike, line: bytes, start: int
) -> tuple[tuple[bytes, bytes], tuple[bytes, bytes], tuple[int, int]]:
    match = _SIZE.match(line)
    if match is None or match[2] == match[5]:
        raise FileError(path, "has no size line such as '-Y 512 +X 1024'", f"byte {start - len(line) - 1}")
    sizes = int(match[3]), int(match[6])
    if 0 in sizes or sizes[0] * sizes[1] > MAX_PIXELS:
        shape = f"{sizes[1]:,} × {sizes[0]:,} pixels"
        raise FileError(
            path, f"claims {shape}; 1 to {MAX_PIXELS:,} are read", f"byte {start - len(line) - 1}"
        )
    return (match[1], match[4]), (match[2], match[5]), sizes


class _Lines:
    """Lines of a picture, decoded in order on demand, times the gain of each channel."""

    def __init__(
        self,
        path: PathLike,
        data: bytes,
        start: int,
        height: int,
        width: int,
        gain: NDArray[np.float32],
    ) -> None:
        # A line of n pixels cannot be stored in fewer than these bytes, whichever coding: refuse before
        # allocating.
        left = len(data) - start
        if left < height * (4 + 8 * -(-width // 127)) and left < height * 4:
            raise FileError(path, f"is cut off: {height} lines do not fit into it", f"byte {len(data)}")
        self._path, self._data, self._at = path, data, start
        self._height, self._width, self._gain = height, width, gain
        self._flat = left == height * width * 4 and data[start : start + 2] != b"\x02\x02"

    def read(self, first: int, last: int) -> NDArray[np.float32]:
        """Return the next lines, first … last - 1, as (last - first, width, 3) float32."""
        if self._flat:
            count = (last - first) * self._width * 4
            rgbe = np.frombuffer(self._data, np.uint8, count, self._at).reshape(-1, self._width, 4)
            self._at += count
        else:
            rgbe = np.stack([self._line(row) for row in range(first, last)])
        return _to_float(rgbe) * self._gain

    def _line(self, row: int) -> NDArray[np.uint8]:
        path, data, at, width = self._path, self._data, self._at, self._width
        head = data[at : at + 4]
        if len(head) < 4:
            raise FileError(path, f"is cut off at line {row + 1} of {self._height}", f"byte {len(data)}")
        if 8 <= width < 32768 and head[0] == head[1] == 2 and head[2] < 128:
            if (head[2] << 8) + head[3] != width:
                raise FileError(path, f"is damaged: line {row + 1} is not {width} pixels long", f"byte {at}")
            line, self._at = _new_line(path, data, at + 4, width, row)
        else:
            line, self._at = _old_line(path, data, at, width, row)
        return line


def _new_line(path: PathLike, data: bytes, at: int, width: int, row: int) -> tuple[NDArray[np.uint8], int]:
    """Decode one line of the adaptive coding: the four bytes apart, each in runs and literals."""
    out = bytearray()
    last = len(data) - 1
    for channel in range(1, 5):
        end = channel * width
        while (filled := len(out)) < end:
            if at >= last:
                raise FileError(path, f"is cut off at line {row + 1}", f"byte {len(data)}")
            count = data[at]
            if count > 128:
                out += data[at + 1 : at + 2] * (count - 128)
                at += 2
            else:
                out += data[at + 1 : at + 1 + count]
                at += 1 + count
            if len(out) == filled or len(out) > end:
                raise FileError(path, f"is damaged: a run of line {row + 1} does not fit", f"byte {at}")
    return np.frombuffer(bytes(out), np.uint8).reshape(4, width).T, at


def _old_line(path: PathLike, data: bytes, at: int, width: int, row: int) -> tuple[NDArray[np.uint8], int]:
    """Decode one line of plain pixels, among which (1, 1, 1, n) repeats the last pixel n times."""
    out = bytearray()
    end, shift = 4 * width, 0
    while len(out) < end:
        pixel = data[at : at + 4]
        if len(pixel) < 4:
            raise FileError(path, f"is cut off at line {row + 1}", f"byte {len(data)}")
        at += 4
        if pixel[:3] != b"\1\1\1":
            out += pixel
            shift = 0
            continue
        count = pixel[3] << shift
        if not out or shift > 16 or len(out) + 4 * count > end:
            raise FileError(path, f"is damaged: a run of line {row + 1} does not fit", f"byte {at - 4}")
        out += out[-4:] * count
        shift += 8
    return np.frombuffer(bytes(out), np.uint8).reshape(width, 4), at


def _to_float(rgbe: NDArray[np.uint8]) -> NDArray[np.float32]:
    exponents = np.arange(256, dtype=np.float64) - 136.0
    scales = np.exp2(exponents).astype(np.float32)
    scales[0] = 0.0
    scale = scales[rgbe[..., 3]]
    result = np.empty((*scale.shape, 3), np.float32)
    for channel in range(3):  # a product of rows of three numbers takes several times as long
        np.multiply(rgbe[..., channel] + np.float32(0.5), scale, out=result[..., channel])
    return result


def _gain(path: PathLike, fields: dict[str, str]) -> NDArray[np.float32]:
    """Return what the stored channels are multiplied by to be radiance."""
    gain = np.ones(3)
    for key, count in (("EXPOSURE", 1), ("COLORCORR", 3)):
        for text in fields.get(key, "").split(";"):
            if not text:
                continue
            try:
                values = np.array([float(word) for word in text.split()])
            except ValueError as error:
                raise FileError(path, f"has {text[:40]!r} where a number belongs", f"line {key}") from error
            if (
                values.size != count
                or not (np.abs(np.log(np.maximum(values, 1e-300))) < np.log(_MAX_EXPOSURE)).all()
            ):
                raise FileError(
                    path, f"has {text[:40]!r} where {count} positive number(s) belong", f"line {key}"
                )
            gain /= values
    return gain.astype(np.float32)


def _orient(
    pixels: NDArray[np.float32], signs: tuple[bytes, bytes], axes: tuple[bytes, bytes]
) -> NDArray[np.float32]:
    """Turn the stored order into rows from the top, columns from the left."""
    if axes[0] == b"X":
        pixels = pixels.transpose(1, 0, 2)
        signs = signs[1], signs[0]
    if signs[0] == b"+":
        pixels = pixels[::-1]
    if signs[1] == b"-":
        pixels = pixels[:, ::-1]
    return np.ascontiguousarray(pixels)


def _primaries(fields: dict[str, str]) -> tuple[Chromaticities, tuple[str, ...]]:
    """Return the primaries of the PRIMARIES line, or Rec. 709 where there is none or it makes no sense."""
    if "PRIMARIES" not in fields:
        return REC709, ()
    try:
        values = [float(word) for word in fields["PRIMARIES"].split()]
        rx, ry, gx, gy, bx, by, wx, wy = values
        rgb_to_xyz((rx, ry, gx, gy, bx, by, wx, wy))
    except ValueError:
        return REC709, (f"the line PRIMARIES={fields['PRIMARIES'][:80]} makes no sense; Rec. 709 was taken",)
    return (rx, ry, gx, gy, bx, by, wx, wy), ()
