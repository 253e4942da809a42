"""Foreign pictures: which formats are opened, and what a file may cost before it is refused."""

from __future__ import annotations

import ast
import os
import subprocess
import sys
import zlib
from pathlib import Path

import numpy as np
import pytest
from PIL import EpsImagePlugin, Image

from brdf_suite.acquisition.photographs.jpeg import jpeg_pixels
from brdf_suite.errors import FileError
from brdf_suite.files.images.pictures import PICTURE_FORMATS, read_picture, read_rgb
from brdf_suite.files.images.relief import read_mask, read_normal_map, read_tangent_map
from brdf_suite.output.compared import read_compared_picture

CHECKOUT = Path(__file__).resolve().parents[3]
READERS = (
    read_picture,
    read_normal_map,
    read_tangent_map,
    read_mask,
    read_compared_picture,
    lambda path: read_rgb(path, ("PNG",)),
)
EPS = b"""%!PS-Adobe-3.0 EPSF-3.0
%%BoundingBox: 0 0 8 8
%%EndComments
0 0 8 8 rectfill showpage
%%EOF
"""


def test_pictures_are_opened_in_one_place() -> None:
    found = set()
    for path in [*(CHECKOUT / "brdf_suite").rglob("*.py"), *(CHECKOUT / "apps").rglob("*.py")]:
        text = path.read_text(encoding="utf-8")
        if not any(word in text for word in ("Image", "PIL", "QMovie", "loadFromData")):
            continue  # what is looked for holds one of them, and parsing takes long
        for node in ast.walk(ast.parse(text)):
            if (
                isinstance(node, ast.Attribute)
                and node.attr == "open"
                and ast.unparse(node.value).split(".")[-1] in ("Image", "PIL")
            ):
                found.add(path.relative_to(CHECKOUT).as_posix())
            if isinstance(node, ast.ImportFrom) and node.module == "PIL.Image":
                assert "open" not in {alias.name for alias in node.names}, path
            if isinstance(node, ast.Attribute | ast.Name):
                # Qt would choose a decoder by the content as Pillow does.
                name = node.attr if isinstance(node, ast.Attribute) else node.id
                assert name not in ("QImageReader", "QMovie", "loadFromData"), path
    assert found == {"brdf_suite/files/images/pictures.py"}


@pytest.mark.parametrize("reader", READERS)
def test_postscript_reaches_no_decoder(reader, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    started = []
    monkeypatch.setattr(EpsImagePlugin, "Ghostscript", lambda *_, **__: started.append(True))
    path = tmp_path / "normals.png"
    path.write_bytes(EPS)
    with pytest.raises(FileError, match=r"normals\.png: is no .*that can be read"):
        reader(path)
    assert started == []


@pytest.mark.parametrize("kind", ["GIF", "ICO", "PCX", "PPM", "SGI", "MSP", "XBM", "DDS", "BLP", "QOI"])
def test_formats_outside_the_list_are_refused(kind: str, tmp_path: Path) -> None:
    path = tmp_path / "map.png"
    picture = Image.new({"MSP": "1", "XBM": "1", "BLP": "P"}.get(kind, "RGB"), (32, 32))
    try:
        picture.save(path, kind)
    except KeyError:  # this version of Pillow reads the format and does not write it
        path.write_bytes(b"qoif\0\0\0\x20\0\0\0\x20\x03\0" + b"\xfe\0\0\0" * 1024)
    with pytest.raises(FileError, match="is no picture"):
        read_picture(path)


@pytest.mark.parametrize("kind", PICTURE_FORMATS)
def test_formats_that_are_used_are_read(kind: str, tmp_path: Path) -> None:
    path = tmp_path / "map"
    Image.new("RGB", (32, 16), (128, 128, 255)).save(path, kind)
    pixels = read_picture(path)
    assert pixels.shape == (16, 32, 3)
    assert np.abs(pixels.astype(int) - [128, 128, 255]).max() <= 3
    assert read_normal_map(path).shape == (16, 32, 2)


def test_pixels_are_those_of_pillow(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("brdf_suite.files.images.pictures._STRIP_BYTES", 4 * 40 * 7)
    random = np.random.default_rng(1)
    codes = random.integers(0, 256, (33, 40, 4), dtype=np.uint8)
    path = tmp_path / "a.png"
    for mode, shape in (("1", 1), ("L", 1), ("LA", 1), ("P", 3), ("RGB", 3), ("RGBA", 3)):
        picture = Image.fromarray(codes).convert(mode)
        picture.save(path)
        wanted = np.atleast_3d(np.asarray(picture.convert("L" if shape == 1 else "RGB")))
        np.testing.assert_array_equal(read_picture(path), wanted)
        np.testing.assert_array_equal(read_rgb(path, ("PNG",)), np.asarray(picture.convert("RGB")))
    deep = random.integers(0, 65536, (33, 40), dtype=np.uint16)
    Image.fromarray(deep).save(path)
    np.testing.assert_array_equal(read_picture(path)[..., 0], deep)


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="needs named pipes")
@pytest.mark.parametrize("reader", READERS)
def test_pipes_and_devices_are_refused_at_once(reader, tmp_path: Path) -> None:
    pipe = tmp_path / "pipe.png"
    os.mkfifo(pipe)
    for path in (pipe, Path("/dev/zero"), tmp_path):
        with pytest.raises(FileError, match="is not a plain file"):
            reader(path)


def chunk(kind: bytes, data: bytes) -> bytes:
    return len(data).to_bytes(4, "big") + kind + data + zlib.crc32(kind + data).to_bytes(4, "big")


def write_flat_png(path: Path, width: int, height: int) -> None:
    """Write a colour PNG of zeros: a thousandth of the size of its pixels."""
    rows = bytes(1 + 3 * width) * 100
    # A full flush makes a piece that may stand several times.
    packed = zlib.compressobj(9, wbits=-15)
    piece = packed.compress(rows) + packed.flush(zlib.Z_FULL_FLUSH)
    whole, rest = divmod(height, 100)
    last = zlib.compressobj(9, wbits=-15)
    tail = last.compress(rows[: rest * (1 + 3 * width)]) + last.flush()
    # Adler-32 of n zeros: sums of 1, and of n ones.
    check = (height * (1 + 3 * width) % 65521 << 16) | 1
    content = b"\x78\xda" + piece * whole + tail + check.to_bytes(4, "big")
    header = width.to_bytes(4, "big") + height.to_bytes(4, "big") + b"\x08\x02\0\0\0"
    path.write_bytes(
        b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", content) + chunk(b"IEND", b"")
    )


MEASURED = """
import sys
from brdf_suite.errors import FileError
from brdf_suite.files.images.relief import read_normal_map
try:
    read_normal_map(sys.argv[1])
except FileError as error:
    print(error)
# Of this process alone: getrusage begins with the peak of the process that started it.
with open("/proc/self/status") as status:
    print(next(line.split()[1] for line in status if line.startswith("VmHWM")))
"""


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="reads /proc")
@pytest.mark.parametrize(
    ("side", "words"), [(8192, "is no normal map: 0 %"), (9400, "pixels, too large to be read")]
)
def test_a_small_file_of_many_pixels_stays_below_a_gigabyte(side: int, words: str, tmp_path: Path) -> None:
    path = tmp_path / "normals.png"
    write_flat_png(path, side, side)
    assert path.stat().st_size < 300_000
    done = subprocess.run(
        [sys.executable, "-c", MEASURED, str(path)], capture_output=True, text=True, check=True
    )
    said, peak_kb = done.stdout.splitlines()
    assert words in said
    assert int(peak_kb) * 1024 < 1 << 30


def test_a_photograph_that_is_no_jpeg_reaches_no_other_decoder(tmp_path: Path) -> None:
    # A frame of 8 × 8 pixels and an end, as the segments are read, and nothing that a decoder could use between.
    content = (
        b"\xff\xd8\xff\xc0\0\x11\x08\0\x08\0\x08\x03\x01\x11\0\x02\x11\0\x03\x11\0\xff\xda\0\x02"
        + EPS
        + b"\xff\xd9"
    )
    with pytest.raises(FileError, match="JPEG"):
        jpeg_pixels(content, tmp_path / "a.jpg")
