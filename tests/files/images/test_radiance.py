"""The Radiance reader: codings made here byte by byte, tags, orientations, faults."""

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from brdf_suite.errors import FileError
from brdf_suite.files.images.environments import read_environment_image
from brdf_suite.files.images.primaries import REC709, rgb_to_working
from brdf_suite.files.images.radiance import read_radiance

HEIGHT, WIDTH = 8, 16


def rgbe(seed: int = 4, runs: bool = True) -> np.ndarray:
    """Return (HEIGHT, WIDTH, 4) bytes with runs in them; the exponent stays near 1."""
    rng = np.random.default_rng(seed)
    pixels = rng.integers(2, 256, (HEIGHT, WIDTH, 4)).astype(np.uint8)
    pixels[..., 3] = rng.integers(126, 132, (HEIGHT, WIDTH))
    if runs:
        pixels[:, 4:11] = pixels[:, 4:5]
    return pixels


def to_float(pixels: np.ndarray) -> np.ndarray:
    return (pixels[..., :3] + 0.5) * 2.0 ** (pixels[..., 3:].astype(float) - 136.0)


def header(size: str = f"-Y {HEIGHT} +X {WIDTH}", *lines: str, form: str = "32-bit_rle_rgbe") -> bytes:
    return ("\n".join(["#?RADIANCE", "# a comment", *lines, f"FORMAT={form}", "", size]) + "\n").encode()


def new_coding(pixels: np.ndarray) -> bytes:
    out = bytearray()
    for line in pixels:
        out += bytes([2, 2, line.shape[0] >> 8, line.shape[0] & 255])
        for channel in line.T:
            at = 0
            while at < channel.size:
                same = 1
                while at + same < channel.size and channel[at + same] == channel[at] and same < 127:
                    same += 1
                out += bytes([128 + same, channel[at]]) if same > 2 else bytes([1, channel[at]])
                at += same if same > 2 else 1
    return bytes(out)


def old_coding(pixels: np.ndarray) -> bytes:
    out = bytearray()
    for line in pixels:
        at = 0
        while at < line.shape[0]:
            out += line[at].tobytes()
            same = 1
            while at + same < line.shape[0] and (line[at + same] == line[at]).all():
                same += 1
            if same > 1:
                out += bytes([1, 1, 1, same - 1])
            at += same
    return bytes(out)


@pytest.mark.parametrize("coding", [new_coding, old_coding, np.ndarray.tobytes])
def test_every_coding_gives_the_same_pixels(tmp_path: Path, coding: object) -> None:
    pixels = rgbe()
    file = tmp_path / "a.hdr"
    file.write_bytes(header() + coding(pixels))  # type: ignore[operator]  # three functions of one shape
    got, primaries, notes = read_radiance(file)
    assert primaries == REC709
    assert notes == ()
    assert np.allclose(got, to_float(pixels), rtol=1e-6)
    working = to_float(pixels) @ rgb_to_working(REC709).T
    assert np.allclose(read_environment_image(file).pixels, np.maximum(working, 0.0), rtol=1e-4, atol=1e-5)


def test_long_old_runs_use_several_counts(tmp_path: Path) -> None:
    width = 1000
    data = bytes([9, 8, 7, 128]) + bytes([1, 1, 1, 999 & 255]) + bytes([1, 1, 1, 999 >> 8])
    file = tmp_path / "long.hdr"
    file.write_bytes(header(f"-Y 1 +X {width}") + data)
    got, _, _ = read_radiance(file)
    assert got.shape == (1, width, 3)
    assert np.ptp(got[..., 0]) == 0.0


def test_zero_exponent_is_black_and_exposure_is_divided_out(tmp_path: Path) -> None:
    pixels = rgbe()
    pixels[0, 0] = (5, 6, 7, 0)
    file = tmp_path / "e.hdr"
    file.write_bytes(
        header(f"-Y {HEIGHT} +X {WIDTH}", "EXPOSURE=4", "EXPOSURE= 0.5", "COLORCORR=1 2 1") + pixels.tobytes()
    )
    got, _, _ = read_radiance(file)
    assert got[0, 0].tolist() == [0.0, 0.0, 0.0]
    assert np.allclose(got[1], to_float(pixels)[1] / np.array([2.0, 4.0, 2.0]), rtol=1e-6)


@pytest.mark.parametrize(
    ("size", "turned"),
    [
        (f"+Y {HEIGHT} +X {WIDTH}", lambda p: p[::-1]),
        (f"-Y {HEIGHT} -X {WIDTH}", lambda p: p[:, ::-1]),
        (f"+X {HEIGHT} -Y {WIDTH}", lambda p: p.transpose(1, 0, 2)),
    ],
)
def test_orientations(tmp_path: Path, size: str, turned: object) -> None:
    pixels = rgbe()
    file = tmp_path / "o.hdr"
    file.write_bytes(header(size) + pixels.tobytes())
    got, _, _ = read_radiance(file)
    assert np.allclose(got, turned(to_float(pixels)), rtol=1e-6)  # type: ignore[operator]  # parametrized functions


def test_xyze_white_is_white(tmp_path: Path) -> None:
    pixels = np.zeros((HEIGHT, WIDTH, 4), np.uint8)
    pixels[...] = (121, 128, 139, 129)  # D65
    file = tmp_path / "xyz.hdr"
    file.write_bytes(header(form="32-bit_rle_xyze") + pixels.tobytes())
    got = read_environment_image(file).pixels
    assert np.allclose(got, 1.0, atol=0.02)


def test_primaries_are_honoured(tmp_path: Path) -> None:
    pixels = rgbe()
    file = tmp_path / "p.hdr"
    line = "PRIMARIES=.708 .292 .170 .797 .131 .046 .3127 .3290"
    file.write_bytes(header(f"-Y {HEIGHT} +X {WIDTH}", line) + pixels.tobytes())
    assert np.allclose(read_environment_image(file).pixels, to_float(pixels), rtol=1e-4)


@pytest.mark.parametrize(
    ("data", "words"),
    [
        (b"just text, named like a picture\n" * 30, "neither"),
        (b"#?RADIANCE", "cut off"),
        (b"#?RADIANCE\n" + b"x" * 100_000, "header"),
        (b"#?RADIANCE\n\nno size here\n", "size line"),
        (header("-Y 0 +X 0"), "claims 0 × 0"),
        (header("-Y 60000 +X 120000"), "claims 120,000 × 60,000"),
        (header("-Y 8192 +X 16384") + b"\2\2", "cut off"),
        (header("-Y 8 -Y 8"), "size line"),
        (header(form="16-bit_gold"), "pixel format"),
        (header(f"-Y {HEIGHT} +X {WIDTH}", "EXPOSURE=bright") + rgbe().tobytes(), "EXPOSURE"),
        (header(f"-Y {HEIGHT} +X {WIDTH}", "EXPOSURE=0") + rgbe().tobytes(), "EXPOSURE"),
        (header(f"-Y {HEIGHT} +X {WIDTH}", "EXPOSURE=nan") + rgbe().tobytes(), "EXPOSURE"),
        (header() + new_coding(rgbe())[:-30], "cut off"),
        (header() + old_coding(rgbe())[:-30], "cut off"),
        (header() + b"\2\2\0\x11" + b"\x00" * 600, "not 16 pixels"),
        (header() + (b"\2\2\0\x10" + b"\x00" * 60) * 10, "does not fit"),
        (header() + (b"\2\2\0\x10\xff\x00") * 100, "does not fit"),
        (header() + b"\1\1\1\5" * 200, "does not fit"),
    ],
)
def test_faults_are_named(tmp_path: Path, data: bytes, words: str) -> None:
    file = tmp_path / "bad.hdr"
    file.write_bytes(data)
    with pytest.raises(FileError, match=words) as caught:
        read_environment_image(file)
    assert str(file) in str(caught.value)


@settings(max_examples=4 * settings.default.max_examples)
@given(st.data())
def test_mutations_never_crash(tmp_path_factory: pytest.TempPathFactory, data: st.DataObject) -> None:
    coding = data.draw(st.sampled_from([new_coding, old_coding]))
    content = bytearray(header() + coding(rgbe()))
    for _ in range(data.draw(st.integers(1, 6))):
        content[data.draw(st.integers(0, len(content) - 1))] = data.draw(st.integers(0, 255))
    file = tmp_path_factory.mktemp("mutated") / "m.hdr"
    file.write_bytes(bytes(content[: data.draw(st.integers(0, len(content)))]))
    try:
        image = read_environment_image(file)
    except FileError as error:
        message = str(error)
    else:
        message = str(file)
        assert np.isfinite(image.pixels).all()
    assert str(file) in message
