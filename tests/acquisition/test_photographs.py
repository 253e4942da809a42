"""Photographs of every kind are read as the codes that they hold; damage and truncation are reported with the file."""

from __future__ import annotations

import contextlib
import functools
import io
import os
import struct
import sys
import tempfile
import zlib
from pathlib import Path

import numpy as np
import pytest
import tifffile
from hypothesis import given
from hypothesis import strategies as st
from PIL import Image

from brdf_suite.acquisition.photographs import tiff as tiff_pixels
from brdf_suite.acquisition.photographs.png import FileContent, png_parts
from brdf_suite.acquisition.photographs.reading import photograph_facts, read_photograph
from brdf_suite.acquisition.simulator.folder import exif, write_photograph
from brdf_suite.errors import FileError
from brdf_suite.files.images.exr.image import write_exr
from brdf_suite.files.images.png import write_png

RANDOM = np.random.default_rng(3)
CODES_8 = RANDOM.integers(0, 256, (11, 7, 3)).astype(np.uint8)
CODES_16 = RANDOM.integers(0, 65536, (11, 7, 3)).astype(np.uint16)


@pytest.mark.parametrize("ending", [".png", ".tif"])
@pytest.mark.parametrize("codes", [CODES_8, CODES_16], ids=["8", "16"])
def test_codes_and_time_come_back(tmp_path: Path, ending: str, codes: np.ndarray) -> None:
    path = tmp_path / f"a{ending}"
    write_photograph(path, codes, 0.0125)
    found = read_photograph(path)
    np.testing.assert_array_equal(found.codes, codes)
    assert found.codes.dtype == codes.dtype
    assert (found.facts.width, found.facts.height, found.facts.bits) == (7, 11, 8 * codes.itemsize)
    assert photograph_facts(path).exposure_s == pytest.approx(0.0125, rel=1e-6)


def test_filtered_pngs_of_others_are_read(tmp_path: Path) -> None:
    smooth = np.add.outer(np.arange(40), np.arange(30))[..., None] * np.array([3, 2, 1])
    for pixels, name in ((smooth.astype(np.uint8), "pillow"), (smooth[..., :1].astype(np.uint8), "grey")):
        Image.fromarray(pixels.squeeze()).save(tmp_path / f"{name}.png", optimize=True)
        np.testing.assert_array_equal(
            read_photograph(tmp_path / f"{name}.png").codes, np.broadcast_to(pixels, smooth.shape)
        )
    deep = (smooth * 300).astype(np.uint16)
    write_png(tmp_path / "suite.png", deep)
    np.testing.assert_array_equal(read_photograph(tmp_path / "suite.png").codes, deep)


@pytest.mark.parametrize("filter_type", [0, 1, 2, 3, 4])
def test_every_filter_of_png_is_undone(tmp_path: Path, filter_type: int) -> None:
    rows = CODES_16.astype(">u2").view(np.uint8).reshape(11, -1).astype(int)
    left, above, corner = (np.zeros_like(rows) for _ in range(3))
    left[:, 6:], above[1:], corner[1:, 6:] = rows[:, :-6], rows[:-1], rows[:-1, :-6]
    estimate = left + above - corner
    distances = np.abs(np.stack([estimate - left, estimate - above, estimate - corner]))
    paeth = np.choose(np.argmin(distances, axis=0), [left, above, corner])
    guess = [np.zeros_like(rows), left, above, (left + above) // 2, paeth][filter_type]
    filtered = np.concatenate([np.full((11, 1), filter_type), (rows - guess) % 256], axis=1).astype(np.uint8)
    path = tmp_path / "a.png"
    path.write_bytes(_png(zlib.compress(filtered.tobytes())))
    np.testing.assert_array_equal(read_photograph(path).codes, CODES_16)


@pytest.mark.parametrize("filter_type", [0, 1, 2, 3, 4])
@pytest.mark.parametrize("bits", [8, 16])
def test_a_png_of_one_filtered_row_is_read(tmp_path: Path, filter_type: int, bits: int) -> None:
    codes = (CODES_16 if bits == 16 else CODES_8)[:1]
    row = codes.astype(f">u{bits // 8}").view(np.uint8).ravel().astype(int)
    step = 3 * bits // 8
    left = np.concatenate((np.zeros(step, int), row[:-step]))
    guess = [0 * row, left, 0 * row, left // 2, left][filter_type]
    packed = zlib.compress(bytes([filter_type]) + ((row - guess) % 256).astype(np.uint8).tobytes())
    path = tmp_path / "row.png"
    path.write_bytes(_png(packed, struct.pack(">IIBBBBB", 7, 1, bits, 2, 0, 0, 0)))
    found = read_photograph(path).codes
    np.testing.assert_array_equal(found, codes)
    assert found.dtype == codes.dtype


def _png(packed: bytes, header: bytes | None = None) -> bytes:
    head = header or struct.pack(">IIBBBBB", 7, 11, 16, 2, 0, 0, 0)
    chunks = ((b"IHDR", head), (b"IDAT", packed), (b"IEND", b""))
    return b"\x89PNG\r\n\x1a\n" + b"".join(
        struct.pack(">I", len(d)) + k + d + struct.pack(">I", zlib.crc32(k + d)) for k, d in chunks
    )


@pytest.mark.parametrize("order", ["<", ">"])
@pytest.mark.parametrize("packing", ["plain", "deflated", "predicted", "tiled", "planes", "floats", "grey"])
def test_tiffs_of_many_layouts_are_read(tmp_path: Path, order: str, packing: str) -> None:
    content, expected = _tiff(order, packing)
    path = tmp_path / "a.tiff"
    path.write_bytes(content)
    np.testing.assert_array_equal(read_photograph(path).codes, expected)


def _tiff(order: str, packing: str) -> tuple[bytes, np.ndarray]:
    """A TIFF as cameras and their programs write it, by the tables of the specification."""
    codes = CODES_16
    if packing == "floats":
        codes = RANDOM.random((11, 7, 3)).astype(np.float32)
    if packing == "grey":
        codes = codes[..., :1]
    stored = codes.astype(codes.dtype.newbyteorder(order))
    strips = [stored[i : i + 4].tobytes() for i in (0, 4, 8)]
    extra: list[tuple[int, int, tuple[int, ...]]] = [(278, 3, (4,))]
    compression = 1
    if packing in ("deflated", "predicted"):
        compression = 8
        if packing == "predicted":
            stored = stored.copy()
            stored[:, 1:] = codes[:, 1:] - codes[:, :-1]
            extra.append((317, 3, (2,)))
        strips = [zlib.compress(stored[i : i + 4].tobytes()) for i in (0, 4, 8)]
    if packing == "planes":
        strips = [stored[..., c].tobytes() for c in range(3)]
        extra = [(278, 3, (11,)), (284, 3, (2,))]
    places, sizes = 273, 279
    if packing == "tiled":
        padded = np.zeros((16, 16, 3), stored.dtype)
        padded[:11, :7] = stored
        strips, extra, places, sizes = [padded.tobytes()], [(322, 3, (16,)), (323, 3, (16,))], 324, 325
    channels = codes.shape[2]
    at, offsets = 8, []
    for strip in strips:
        offsets.append(at)
        at += len(strip)
    fields = [
        (256, 3, (7,)),
        (257, 3, (11,)),
        (258, 3, (8 * codes.itemsize,) * channels),
        (259, 3, (compression,)),
        (262, 3, (2 if channels == 3 else 1,)),
        (places, 4, tuple(offsets)),
        (277, 3, (channels,)),
        (sizes, 4, tuple(len(s) for s in strips)),
        (339, 3, (3 if packing == "floats" else 1,) * channels),
        *extra,
    ]
    fields.sort()
    after = at + 2 + 12 * len(fields) + 4
    entries, outside = b"", b""
    for tag, kind, values in fields:
        raw = struct.pack(f"{order}{len(values)}{'H' if kind == 3 else 'I'}", *values)
        if len(raw) > 4:
            entries += struct.pack(order + "HHII", tag, kind, len(values), after + len(outside))
            outside += raw
        else:
            entries += struct.pack(order + "HHI", tag, kind, len(values)) + raw.ljust(4, b"\0")
    head = (b"II" if order == "<" else b"MM") + struct.pack(order + "HI", 42, at)
    body = head + b"".join(strips) + struct.pack(order + "H", len(fields)) + entries + b"\0\0\0\0" + outside
    return body, np.broadcast_to(codes, (11, 7, 3))


def test_a_jpeg_and_its_time(tmp_path: Path) -> None:
    path = tmp_path / "a.jpg"
    Image.fromarray(np.full((20, 30, 3), 120, np.uint8)).save(path, exif=b"Exif\0\0" + exif(1 / 60))
    found = read_photograph(path)
    assert found.facts.kind == "jpeg"
    assert found.facts.exposure_s == pytest.approx(1 / 60, rel=1e-6)
    assert np.abs(found.codes.astype(int) - 120).max() <= 1


def test_times_in_the_exif_folder_of_a_tiff(tmp_path: Path) -> None:
    path = tmp_path / "a.tif"
    for tags, expected in (
        ({33434: 0.0125}, 0.0125),  # ExposureTime
        ({37377: 5.0}, 1 / 32),  # ShutterSpeedValue, to base 2
        ({33434: 0.0, 37377: 3.0}, 1 / 8),
        ({33437: 2.8}, None),  # an aperture
    ):
        reported = Image.Exif()
        reported[0x8769] = tags
        Image.fromarray(CODES_8).save(path, exif=reported.tobytes())
        assert photograph_facts(path).exposure_s == (
            None if expected is None else pytest.approx(expected, rel=1e-6)
        )


def test_a_strip_that_unpacks_to_more_than_its_pixels_is_reported(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "a.tif"
    bomb = zlib.compress(bytes(4_000_000))
    tifffile.imwrite(path, CODES_16, photometric="rgb", compression="zlib", rowsperstrip=11, metadata=None)
    content = bytearray(path.read_bytes())
    with tifffile.TiffFile(path) as tiff:
        for code, value in ((273, len(content)), (279, len(bomb))):
            tag = tiff.pages.first.tags[code]
            struct.pack_into("<I", content, tag.valueoffset, value)
    path.write_bytes(bytes(content) + bomb)
    monkeypatch.setattr(tiff_pixels, "_FREE_SIZE", 1 << 16)
    with pytest.raises(FileError, match="unpacks to more than its pixels"):
        read_photograph(path)


def test_a_strip_that_is_too_short_is_reported(tmp_path: Path) -> None:
    path = tmp_path / "a.tif"
    for packing, words in (("none", "too short"), ("zlib", "cannot be unpacked")):
        tifffile.imwrite(path, CODES_16, photometric="rgb", compression=packing, metadata=None)
        content = bytearray(path.read_bytes()) + bytes(600)  # so that there is something to read beyond
        with tifffile.TiffFile(path) as tiff:
            for code in (257, 278):  # taller than it is, as one strip
                tag = tiff.pages.first.tags[code]
                struct.pack_into("<H" if tag.dtype == 3 else "<I", content, tag.valueoffset, 20)
        path.write_bytes(content)
        with pytest.raises(FileError, match=words):
            read_photograph(path)


def test_float_pictures(tmp_path: Path) -> None:
    values = RANDOM.random((6, 5, 3)).astype(np.float32)
    write_exr(tmp_path / "a.exr", values)
    found = read_photograph(tmp_path / "a.exr")
    assert found.facts.bits is None
    np.testing.assert_allclose(found.codes, values, rtol=1e-6)
    rgbe = bytes([128, 64, 32, 129])
    (tmp_path / "a.hdr").write_bytes(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 2\n" + rgbe * 4)
    found = read_photograph(tmp_path / "a.hdr")
    np.testing.assert_allclose(found.codes[0, 0], [1.004, 0.504, 0.254], atol=1e-2)


def test_a_raw_file_is_linear_and_unbalanced(tmp_path: Path) -> None:
    pytest.importorskip("rawpy")
    path = tmp_path / "a.dng"
    path.write_bytes(_dng(np.full((64, 64), 64 + 1000), black=64, white=4095))
    found = read_photograph(path)
    assert (found.facts.kind, found.facts.bits) == ("raw", 16)
    assert found.facts.exposure_s == pytest.approx(0.02, rel=1e-3)
    expected = 65_535 * 1000 / (4095 - 64)
    np.testing.assert_allclose(found.codes.reshape(-1, 3).mean(axis=0), expected, rtol=0.01)
    path.write_bytes(path.read_bytes()[:3000])
    with pytest.raises(FileError, match=r"a\.dng.*raw file"):
        read_photograph(path)


def _dng(mosaic: np.ndarray, black: int, white: int) -> bytes:
    """A least DNG: a mosaic of red, green, green, blue in one plain strip."""
    height, width = mosaic.shape
    pixels = mosaic.astype("<u2").tobytes()
    matrix = (1, 1, 0, 1, 0, 1, 0, 1, 1, 1, 0, 1, 0, 1, 0, 1, 1, 1)
    fields: list[tuple[int, int, bytes]] = [
        (254, 4, struct.pack("<I", 0)),
        (256, 4, struct.pack("<I", width)),
        (257, 4, struct.pack("<I", height)),
        (258, 3, struct.pack("<H", 16)),
        (259, 3, struct.pack("<H", 1)),
        (262, 3, struct.pack("<H", 32803)),
        (271, 2, b"Maker\0"),
        (272, 2, b"Model\0"),
        (273, 4, struct.pack("<I", 8)),
        (274, 3, struct.pack("<H", 1)),
        (277, 3, struct.pack("<H", 1)),
        (278, 4, struct.pack("<I", height)),
        (279, 4, struct.pack("<I", len(pixels))),
        (33421, 3, struct.pack("<HH", 2, 2)),
        (33422, 1, bytes([0, 1, 1, 2])),
        (33434, 5, struct.pack("<II", 1, 50)),
        (50706, 1, bytes([1, 4, 0, 0])),
        (50708, 2, b"Maker Model\0"),
        (50714, 4, struct.pack("<I", black)),
        (50717, 4, struct.pack("<I", white)),
        (50721, 10, struct.pack("<18i", *matrix)),
        (50728, 5, struct.pack("<6I", 1, 1, 1, 1, 1, 1)),
        (50778, 3, struct.pack("<H", 21)),
    ]
    sizes = {1: 1, 2: 1, 3: 2, 4: 4, 5: 8, 10: 8}
    at = 8 + len(pixels)
    after = at + 2 + 12 * len(fields) + 4
    entries, outside = b"", b""
    for tag, kind, raw in fields:
        count = len(raw) // sizes[kind]
        if len(raw) > 4:
            entries += struct.pack("<HHII", tag, kind, count, after + len(outside))
            outside += raw + b"\0" * (len(raw) % 2)
        else:
            entries += struct.pack("<HHI", tag, kind, count) + raw.ljust(4, b"\0")
    folder = struct.pack("<H", len(fields)) + entries + b"\0\0\0\0" + outside
    return b"II*\0" + struct.pack("<I", at) + pixels + folder


def test_without_rawpy_the_way_to_it_is_reported(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "rawpy", None)
    (tmp_path / "a.nef").write_bytes(b"II*\0" + bytes(100))
    with pytest.raises(FileError, match=r"needs rawpy, which is not installed; `.*acquisition` installs it"):
        read_photograph(tmp_path / "a.nef")


def test_a_packing_that_opencv_reads(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / "lzw.tif"
    Image.fromarray(CODES_8).save(path, compression="tiff_lzw")
    pytest.importorskip("cv2")
    np.testing.assert_array_equal(read_photograph(path).codes, CODES_8)
    monkeypatch.setitem(sys.modules, "cv2", None)
    with pytest.raises(FileError, match=r"needs OpenCV, which is not installed; `.*acquisition` installs it"):
        read_photograph(path)


def _whole(kind: str, path: Path) -> Path:
    if kind == "jpg":
        Image.fromarray(RANDOM.integers(0, 256, (60, 60, 3)).astype(np.uint8)).save(path)
    elif kind == "exr":
        write_exr(path, RANDOM.random((40, 40, 3)).astype(np.float32))
    elif kind == "hdr":
        path.write_bytes(b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 8 +X 4\n" + bytes([9, 9, 9, 129]) * 32)
    else:
        write_photograph(path, CODES_16, 0.01)
    return path


@pytest.mark.parametrize("kind", ["png", "tif", "jpg", "exr", "hdr"])
@pytest.mark.parametrize("share", [0.0, 0.02, 0.5, 0.97])
def test_a_file_that_was_not_copied_whole_is_reported_before_its_pixels_are_used(
    tmp_path: Path, kind: str, share: float
) -> None:
    path = _whole(kind, tmp_path / f"a.{kind}")
    content = path.read_bytes()
    assert photograph_facts(path).width > 0
    path.write_bytes(content[: int(share * len(content))])
    with pytest.raises(FileError, match=rf"a\.{kind}"):
        photograph_facts(path)


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"GIF89a" + bytes(50), "no photograph that is read here"),
        (_png(b"no zlib"), "cannot be unpacked"),
        (_png(zlib.compress(bytes(30))), "fewer pixels"),
        (_png(zlib.compress(bytes([9]) * 473)), "filter 9"),
        (_png(b"x", struct.pack(">IIBBBBB", 1 << 30, 1 << 30, 16, 2, 0, 0, 0)), "are read"),
        (_png(b"x", struct.pack(">IIBBBBB", 7, 11, 8, 3, 0, 0, 0)), "palette"),
        (b"II*\0" + struct.pack("<I", 9999) + bytes(50), "ends before"),
        (b"II*\0" + struct.pack("<IH", 8, 0) + bytes(50), "lacks the field"),
        (b"II+\0" + bytes(50), "no photograph"),
    ],
    ids=["gif", "packed", "short", "filter", "huge", "palette", "offset", "fields", "big"],
)
def test_a_damaged_file_is_named(tmp_path: Path, content: bytes, words: str) -> None:
    path = tmp_path / "a.bin"
    path.write_bytes(content)
    with pytest.raises(FileError, match=words) as caught:
        read_photograph(path)
    assert caught.value.path == str(path)


def test_a_file_that_is_cut_off_while_it_is_read_is_reported(tmp_path: Path) -> None:
    path = tmp_path / "a.png"
    write_photograph(path, RANDOM.integers(0, 256, (60, 80, 3)).astype(np.uint8), 0.0125)
    with path.open("rb", buffering=0) as file:
        content = FileContent(file)
        assert content[:4] == path.read_bytes()[:4]
        os.truncate(path, 100)
        with pytest.raises(FileError, match="it was not copied whole"):
            png_parts(content, path)
        assert content[99:200] == content[99:100]


def test_a_missing_file_and_a_folder_are_reported(tmp_path: Path) -> None:
    with pytest.raises(FileError, match="is missing"):
        read_photograph(tmp_path / "a.png")
    with pytest.raises(FileError, match="not a plain file"):
        read_photograph(tmp_path)


def test_a_damaged_exif_block_is_no_reason_to_refuse_the_picture(tmp_path: Path) -> None:
    path = tmp_path / "a.jpg"
    picture = io.BytesIO()
    Image.fromarray(np.full((20, 30, 3), 120, np.uint8)).save(
        picture, "JPEG", exif=b"Exif\0\0II*\0\xff\xff\xff\xff"
    )
    path.write_bytes(picture.getvalue())
    assert photograph_facts(path).exposure_s is None


@given(kind=st.sampled_from(["png", "tif", "jpg", "hdr"]), data=st.data())
def test_whatever_is_damaged_is_read_or_reported(kind: str, data: st.DataObject) -> None:
    content = bytearray(_contents()[kind])
    for _ in range(data.draw(st.integers(1, 4))):
        content[data.draw(st.integers(0, min(len(content), 400) - 1))] = data.draw(st.integers(0, 255))
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"a.{kind}"
        path.write_bytes(content[: data.draw(st.sampled_from([len(content), 300, 40]))])
        with contextlib.suppress(FileError):
            assert read_photograph(path).codes.shape[2] == 3


@functools.cache
def _contents() -> dict[str, bytes]:
    with tempfile.TemporaryDirectory() as folder:
        return {
            kind: _whole(kind, Path(folder) / f"a.{kind}").read_bytes()
            for kind in ("png", "tif", "jpg", "hdr")
        }
