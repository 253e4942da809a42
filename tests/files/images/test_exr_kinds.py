"""Kinds of OpenEXR files beside the plain one: several parts, luminance and chroma, cube maps; very large images."""

import io
import os
import struct
import tracemalloc
from pathlib import Path

import numpy as np
import OpenEXR
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from brdf_suite.errors import FileError
from brdf_suite.files.images.area_reduction import MOST_ROWS, read_reduced
from brdf_suite.files.images.environments import read_environment_image
from brdf_suite.files.images.exr import image as exr
from brdf_suite.files.images.exr.header import parse_headers
from brdf_suite.files.images.primaries import REC709, REC2020, rgb_to_xyz

SHAPE = (16, 32)


def planes(seed: int = 1, shape: tuple[int, int] = SHAPE) -> dict[str, np.ndarray]:
    rng = np.random.default_rng(seed)
    return {name: (rng.random(shape) * 4.0).astype(np.float32) for name in "RGB"}


def part(name: str, channels: dict[str, np.ndarray], **header: object) -> OpenEXR.Part:
    kept = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage, **header}
    return OpenEXR.Part(kept, dict(channels), name=name)


def several_parts(path: Path, light: dict[str, np.ndarray], kind: object) -> Path:
    depth = part("depth", {"Z": np.ones(SHAPE, np.float32)}, chromaticities=REC2020)
    extra = {"tiles": OpenEXR.TileDescription()} if kind == OpenEXR.tiledimage else {}
    beauty = part("beauty", light, type=kind, chromaticities=REC2020, **extra)
    OpenEXR.File([depth, beauty]).write(str(path))
    return path


@pytest.mark.parametrize("kind", [OpenEXR.scanlineimage, OpenEXR.tiledimage])
def test_the_part_that_holds_light_is_found(tmp_path: Path, kind: object) -> None:
    light = planes()
    image = read_environment_image(several_parts(tmp_path / "parts.exr", light, kind))
    assert np.array_equal(image.pixels, np.stack([light[name] for name in "RGB"], axis=2))
    assert any("part 2 of 2 ('beauty')" in note for note in image.notes)


def test_parts_that_are_cut_off_are_refused(tmp_path: Path) -> None:
    whole = several_parts(tmp_path / "parts.exr", planes(), OpenEXR.scanlineimage).read_bytes()
    for end in (len(whole) - 30, len(whole) // 2, 300, 60):
        path = tmp_path / "cut.exr"
        path.write_bytes(whole[:end])
        with pytest.raises(FileError, match="cut off"):
            read_environment_image(path)


def test_a_file_that_is_cut_off_while_it_is_read_is_refused(tmp_path: Path) -> None:
    class CutOff(io.BytesIO):
        def seek(self, offset: int, whence: int = os.SEEK_SET) -> int:
            at = super().seek(offset, whence)
            if whence == os.SEEK_END:
                self.truncate(300)
            return at

    path = several_parts(tmp_path / "parts.exr", planes(), OpenEXR.scanlineimage)
    assert len(parse_headers(path, io.BytesIO(path.read_bytes()))) == 2
    with pytest.raises(FileError, match="cut off"):
        parse_headers(path, CutOff(path.read_bytes()))


@pytest.mark.parametrize("kind", [OpenEXR.scanlineimage, OpenEXR.tiledimage])
def test_a_later_part_that_cannot_be_decoded_is_refused_in_silence(
    tmp_path: Path, kind: object, capfd: pytest.CaptureFixture[str]
) -> None:
    # Even light, which the codec really packs: damage then cannot pass for pixels.
    light = {name: np.full(SHAPE, 0.25, np.float32) for name in "RGB"}
    path = several_parts(tmp_path / "parts.exr", light, kind)
    whole = bytearray(path.read_bytes())
    whole[-24:-8] = b"\xff" * 16
    path.write_bytes(whole)
    with pytest.raises(FileError, match="damaged"):
        read_environment_image(path)
    assert capfd.readouterr().out == ""


def test_parts_that_are_too_large_together_are_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = several_parts(tmp_path / "parts.exr", planes(), OpenEXR.scanlineimage)
    whole = SHAPE[0] * SHAPE[1] * 4 * (1 + 3)
    monkeypatch.setattr(exr, "MOST_WHOLE_BYTES", whole)
    read_environment_image(path)
    monkeypatch.setattr(exr, "MOST_WHOLE_BYTES", whole - 1)
    with pytest.raises(FileError, match="a file of its own"):
        read_environment_image(path)


def test_chroma_that_is_no_number_is_repaired_and_reported(tmp_path: Path) -> None:
    light = np.full((16, 32, 3), 0.5)
    light[4, 6] = [np.inf, np.inf, np.inf]
    with np.errstate(invalid="ignore"):
        image = read_environment_image(chroma_file(tmp_path / "yc.exr", light))
    assert np.isfinite(image.pixels).all()
    assert any("NaN" in note or "infinite" in note for note in image.notes)


def test_a_gigapixel_header_is_refused_before_anything_is_allocated(tmp_path: Path) -> None:
    path = tmp_path / "giga.exr"
    OpenEXR.File({"type": OpenEXR.scanlineimage}, planes()).write(str(path))
    content = path.read_bytes()
    small, giga = struct.pack("<4i", 0, 0, 31, 15), struct.pack("<4i", 0, 0, 99_999, 49_999)
    assert content.count(small) == 2
    path.write_bytes(content.replace(small, giga))
    tracemalloc.start()
    try:
        with pytest.raises(FileError, match="100,000 × 50,000 pixels"):
            read_environment_image(path)
        assert tracemalloc.get_traced_memory()[1] < 8 << 20
    finally:
        tracemalloc.stop()


def test_huge_values_survive_the_reduction_by_area() -> None:
    def rows(first: int, last: int) -> np.ndarray:
        return np.full((last - first, 8, 3), 3e38, np.float32)

    pixels, _ = read_reduced(2 * MOST_ROWS, 8, rows)
    assert np.isinf(pixels).all(), "reported and repaired by the image reader"


def test_parts_without_light_are_refused_with_their_channels(tmp_path: Path) -> None:
    OpenEXR.File(
        [part("a", {"Z": np.ones(SHAPE, np.float32)}), part("b", {"U": np.ones(SHAPE, np.float32)})]
    ).write(str(tmp_path / "none.exr"))
    with pytest.raises(FileError, match="Z, U"):
        read_environment_image(tmp_path / "none.exr")


def attribute(name: bytes, kind: bytes, value: bytes) -> bytes:
    return name + b"\0" + kind + b"\0" + struct.pack("<i", len(value)) + value


def chroma_file(path: Path, rgb: np.ndarray) -> Path:
    """Write luminance and chroma of Rec. 709 light, uncompressed, byte for byte as the format's description has it."""
    height, width = rgb.shape[:2]
    y = rgb @ rgb_to_xyz(REC709)[1]
    ry, by = ((rgb[..., k] - y) / y for k in (0, 2))
    stored = [("BY", by[::2, ::2], 2), ("RY", ry[::2, ::2], 2), ("Y", y, 1)]
    listed = b"".join(n.encode() + b"\0" + struct.pack("<i4xii", 2, s, s) for n, _, s in stored) + b"\0"
    box = struct.pack("<4i", 0, 0, width - 1, height - 1)
    header = b"v/1\x01" + struct.pack("<i", 2)
    header += attribute(b"channels", b"chlist", listed) + attribute(b"compression", b"compression", b"\0")
    header += attribute(b"dataWindow", b"box2i", box) + attribute(b"displayWindow", b"box2i", box)
    header += attribute(b"lineOrder", b"lineOrder", b"\0")
    header += attribute(b"pixelAspectRatio", b"float", struct.pack("<f", 1.0))
    header += attribute(b"screenWindowCenter", b"v2f", struct.pack("<2f", 0.0, 0.0))
    header += attribute(b"screenWindowWidth", b"float", struct.pack("<f", 1.0)) + b"\0"
    chunks = []
    for row in range(height):
        data = b"".join(p[row // s].astype("<f4").tobytes() for _, p, s in stored if row % s == 0)
        chunks.append(struct.pack("<ii", row, len(data)) + data)
    place = len(header) + 8 * height
    table = b""
    for chunk in chunks:
        table += struct.pack("<Q", place)
        place += len(chunk)
    path.write_bytes(header + table + b"".join(chunks))
    return path


def test_luminance_and_chroma_become_colour(tmp_path: Path) -> None:
    # Colour that changes slowly, as chroma at half resolution can hold it; luminance that changes from pixel to pixel.
    rng = np.random.default_rng(3)
    rows, columns = np.mgrid[0:600, 0:64]
    hue = np.stack(
        [1.0 + 0.2 * np.cos(rows / 90.0), np.ones_like(rows), 1.0 - 0.2 * np.sin(columns / 15.0)], axis=2
    )
    rgb = hue * rng.uniform(0.5, 2.0, (600, 64, 1))
    image = read_environment_image(chroma_file(tmp_path / "yc.exr", rgb))
    from brdf_suite.files.images.primaries import rgb_to_working

    wanted = rgb @ rgb_to_working(REC709).T
    assert np.abs(image.pixels[:-1, :-1] / wanted[:-1, :-1] - 1.0).max() < 2e-3
    assert any("chroma" in note for note in image.notes)


def test_a_cube_map_says_what_it_is(tmp_path: Path) -> None:
    light = planes(shape=(96, 16))
    settings_ = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage}
    OpenEXR.File({**settings_, "envmap": OpenEXR.ENVMAP_CUBE}, dict(light)).write(str(tmp_path / "cube.exr"))
    image = read_environment_image(tmp_path / "cube.exr")
    assert image.layout == "exr_cube"
    assert image.pixels.shape == (96, 16, 3)


def test_a_very_large_image_is_reduced_by_area_as_it_is_read(tmp_path: Path) -> None:
    height, width = MOST_ROWS + 4, 2 * MOST_ROWS + 8
    grey = np.zeros((height, width), np.float16)
    grey[1::2] = 2.0
    header = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage}
    OpenEXR.File(header, {"Y": grey}).write(str(tmp_path / "large.exr"))
    image = read_environment_image(tmp_path / "large.exr")
    assert image.pixels.shape == (height // 2, width // 2, 3)
    assert np.allclose(image.pixels, 1.0, atol=1e-6)
    assert any("reduced by area" in note for note in image.notes)


@settings(max_examples=settings.default.max_examples // 4)
@given(st.integers(MOST_ROWS + 1, 3 * MOST_ROWS), st.integers(1, 9))
def test_strips_are_asked_for_once_and_in_order(height: int, width: int) -> None:
    asked = []

    def rows(first: int, last: int) -> np.ndarray:
        asked.append((first, last))
        return np.broadcast_to(
            np.arange(first, last, dtype=np.float32)[:, None, None], (last - first, width, 3)
        )

    by = -(-height // MOST_ROWS)
    if width < by:
        return
    pixels, notes = read_reduced(height, width, rows)
    assert [first for first, _ in asked[1:]] == [last for _, last in asked[:-1]]
    assert np.allclose(pixels[:, 0, 0], by * np.arange(height // by) + (by - 1) / 2.0)
    assert notes
