"""Environment images: real files, every kind that is read, every fault that is named, every repair that is reported."""

import os
import struct
from pathlib import Path

import numpy as np
import OpenEXR
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from brdf_suite.errors import FileError
from brdf_suite.files.images.environments import read_environment_image, write_exr
from brdf_suite.files.images.primaries import REC709, REC2020, rgb_to_working

SHAPE = (16, 32)


def planes(seed: int = 1, dtype: type = np.float32, shape: tuple[int, int] = SHAPE) -> dict[str, np.ndarray]:
    rng = np.random.default_rng(seed)
    return {name: (rng.random(shape) * 4.0).astype(dtype) for name in "RGB"}


def save(path: Path, channels: dict[str, np.ndarray], **header: object) -> Path:
    settings = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage, **header}
    OpenEXR.File(settings, dict(channels)).write(str(path))
    return path


def rec709_to_working(pixels: np.ndarray) -> np.ndarray:
    """Return pixels by ITU-R BT.2087, the published matrix, to its four digits."""
    matrix = np.array([[0.6274, 0.3293, 0.0433], [0.0691, 0.9195, 0.0114], [0.0164, 0.0880, 0.8956]])
    return pixels @ matrix.T


def test_every_real_environment_is_read(shared_data: Path) -> None:
    files = sorted((shared_data / "environments").iterdir())
    assert len(files) >= 6
    for file in files:
        image = read_environment_image(file)
        height, width = image.pixels.shape[:2]
        assert (width, image.pixels.dtype, image.pixels.flags.c_contiguous) == (2 * height, np.float32, True)
        assert np.isfinite(image.pixels).all()
        assert image.pixels.min() >= 0.0
        assert image.pixels.mean() > 0.05


def test_real_negatives_and_nonsense_are_reported(shared_data: Path) -> None:
    folder = shared_data / "environments"
    assert any(
        "842 pixel" in n and "negative" in n for n in read_environment_image(folder / "warehouse.exr").notes
    )
    assert any("PRIMARIES" in n for n in read_environment_image(folder / "kiara_1_dawn_1k.hdr").notes)
    assert read_environment_image(folder / "autoshop_01_1k.hdr").notes == ()


def test_radiance_agrees_with_openimageio(shared_data: Path) -> None:
    import OpenImageIO

    for file in sorted((shared_data / "environments").glob("*.hdr")):
        theirs = OpenImageIO.ImageInput.open(str(file)).read_image()
        ours = read_environment_image(file).pixels
        truth = rec709_to_working(theirs)
        # Rounding of the shared exponent: half a step of 1/256 of the largest channel, per reader.
        assert (np.abs(ours - truth) / np.maximum(theirs.max(axis=2, keepdims=True), 1e-6)).max() < 0.0042


@pytest.mark.parametrize("dtype", [np.float16, np.float32])
@pytest.mark.parametrize(
    "compression",
    ["NO_COMPRESSION", "RLE_COMPRESSION", "ZIPS_COMPRESSION", "ZIP_COMPRESSION", "PIZ_COMPRESSION"],
)
def test_lossless_exr_in_working_primaries_comes_back_exactly(
    tmp_path: Path, dtype: type, compression: str
) -> None:
    channels = planes(dtype=dtype)
    file = save(
        tmp_path / "a.exr", channels, chromaticities=REC2020, compression=getattr(OpenEXR, compression)
    )
    image = read_environment_image(file)
    assert np.array_equal(image.pixels, np.stack([channels[c] for c in "RGB"], axis=-1).astype(np.float32))
    assert image.notes == ()


@pytest.mark.parametrize(
    "compression", ["PXR24_COMPRESSION", "B44_COMPRESSION", "B44A_COMPRESSION", "DWAA_COMPRESSION"]
)
def test_lossy_exr_comes_back_nearly(tmp_path: Path, compression: str) -> None:
    channels = {name: np.full(SHAPE, 0.5 + i, np.float16) for i, name in enumerate("RGB")}
    file = save(
        tmp_path / "a.exr", channels, chromaticities=REC2020, compression=getattr(OpenEXR, compression)
    )
    assert np.allclose(read_environment_image(file).pixels, [0.5, 1.5, 2.5], rtol=0.02)


def test_tiled_exr_with_alpha_and_without_chromaticities(tmp_path: Path) -> None:
    channels = planes(shape=(70, 140))
    file = save(
        tmp_path / "tiled.exr",
        {"A": np.ones((70, 140), np.float32), **channels},
        type=OpenEXR.tiledimage,
        tiles=OpenEXR.TileDescription(),
    )
    truth = rec709_to_working(np.stack([channels[c] for c in "RGB"], axis=-1))
    assert np.abs(read_environment_image(file).pixels - truth).max() < 1e-3


def test_one_channel_is_neutral_light(tmp_path: Path) -> None:
    image = read_environment_image(save(tmp_path / "y.exr", {"Y": np.full(SHAPE, 3.0, np.float32)}))
    assert np.allclose(image.pixels, 3.0, atol=1e-5)
    assert "neutral" in image.notes[0]


def test_a_layer_is_found(tmp_path: Path) -> None:
    channels = {f"light.{name}": plane for name, plane in planes().items()}
    image = read_environment_image(save(tmp_path / "layer.exr", channels, chromaticities=REC2020))
    assert np.array_equal(image.pixels[..., 2], channels["light.B"])
    assert "light" in image.notes[0]


def test_data_window_is_placed_in_the_display_window(tmp_path: Path) -> None:
    window = (np.array([3, -2], np.int32), np.array([34, 13], np.int32))
    display = (np.array([0, 0], np.int32), np.array([31, 15], np.int32))
    channels = planes()
    file = save(
        tmp_path / "w.exr", channels, dataWindow=window, displayWindow=display, chromaticities=REC2020
    )
    image = read_environment_image(file)
    assert image.pixels.shape == (16, 32, 3)
    assert np.array_equal(image.pixels[:14, 3:, 0], channels["R"][2:, :29])
    assert image.pixels[14:].max() == 0.0
    assert image.pixels[:, :3].max() == 0.0
    assert "data window" in image.notes[0]


def test_other_primaries_and_white_are_honoured(tmp_path: Path) -> None:
    p3_with_d50 = (0.68, 0.32, 0.265, 0.69, 0.15, 0.06, 0.3457, 0.3585)
    white = {name: np.ones(SHAPE, np.float32) for name in "RGB"}
    image = read_environment_image(save(tmp_path / "p3.exr", white, chromaticities=p3_with_d50))
    assert np.allclose(image.pixels, 1.0, atol=1e-5)  # white stays white
    red = {**white, "G": np.zeros(SHAPE, np.float32), "B": np.zeros(SHAPE, np.float32)}
    image = read_environment_image(save(tmp_path / "red.exr", red, chromaticities=p3_with_d50))
    assert 0.7 < image.pixels[0, 0, 0] < 0.9
    assert np.allclose(rgb_to_working(REC709), rec709_to_working(np.eye(3)).T, atol=1e-4)


def test_what_cannot_be_radiance_is_repaired_and_reported(tmp_path: Path) -> None:
    channels = {name: np.full(SHAPE, 2.0, np.float32) for name in "RGB"}
    channels["R"][4, 0] = np.nan
    channels["G"][8, 8] = np.inf
    channels["B"][2, 2:5] = -1.0
    image = read_environment_image(save(tmp_path / "bad.exr", channels, chromaticities=REC2020))
    assert np.allclose(image.pixels[4, 0], 2.0)
    assert image.pixels[8, 8, 1] == 65504.0
    assert image.pixels[2, 3].tolist() == [2.0, 2.0, 0.0]
    text = " | ".join(image.notes)
    for words in (
        "1 pixel(s) held no number",
        "1 pixel(s) held infinite",
        "3 pixel(s) (0.59 %) held negative",
    ):
        assert words in text


def test_an_image_of_nothing_but_nan_is_refused(tmp_path: Path) -> None:
    channels = {name: np.full(SHAPE, np.nan, np.float32) for name in "RGB"}
    with pytest.raises(FileError, match=r"nan\.exr: holds no number \(NaN\) in any pixel"):
        read_environment_image(save(tmp_path / "nan.exr", channels))


def test_each_repair_is_reported_as_what_it_is(tmp_path: Path) -> None:
    channels = {name: np.full(SHAPE, 2.0, np.float32) for name in "RGB"}
    channels["R"][:] = np.nan
    channels["G"][1, 1:3] = -np.inf
    channels["G"][3, 3:6] = 1e30
    channels["B"][5, 5:9] = -1e30
    image = read_environment_image(save(tmp_path / "bad.exr", channels, chromaticities=REC2020))
    assert image.pixels[..., 0].max() == 0.0
    assert image.pixels[1, 1, 1] == 0.0
    assert image.pixels[3, 3, 1] == 65504.0
    assert image.pixels[5, 5, 2] == 0.0
    assert image.notes == (
        "3 pixel(s) held radiance above 1e+15; it was set to 65504",
        "2 pixel(s) held minus infinity; it was set to 0",
        "4 pixel(s) held radiance below -1e+15; it was set to 0",
        "512 pixel(s) held no number (NaN), nor did their neighbours; they were set to 0",
    )


def test_maps_that_give_no_light_are_reported(tmp_path: Path) -> None:
    dark = "every pixel is black: nothing is lit by this environment"
    for value, reported in ((0.0, (dark,)), (-1.0, ("512 pixel(s) (all of them) held negative", dark))):
        channels = {name: np.full(SHAPE, value, np.float32) for name in "RGB"}
        image = read_environment_image(save(tmp_path / "dark.exr", channels, chromaticities=REC2020))
        assert image.pixels.max() == 0.0
        assert [note.startswith(words) for note, words in zip(image.notes, reported, strict=True)] == [
            True for _ in reported
        ]


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="needs named pipes")
def test_what_is_no_plain_file_is_refused_before_it_is_opened(tmp_path: Path) -> None:
    pipe = tmp_path / "pipe.exr"
    os.mkfifo(pipe)
    for path in (pipe, tmp_path, Path("/dev/zero")):
        with pytest.raises(FileError, match="is not a plain file"):
            read_environment_image(path)


@pytest.mark.parametrize("dtype", [np.float16, np.float32])
def test_write_exr_round_trip_with_metadata(tmp_path: Path, dtype: type) -> None:
    pixels = np.stack([planes(dtype=dtype)[c] for c in "RGB"], axis=-1)
    file = tmp_path / "out.exr"
    write_exr(file, pixels, metadata={"comments": "a test"})
    assert np.array_equal(read_environment_image(file).pixels, pixels.astype(np.float32))
    header = OpenEXR.File(str(file)).header()
    assert header["comments"] == "a test"
    assert np.allclose(header["chromaticities"], REC2020)
    assert [path.name for path in tmp_path.iterdir()] == ["out.exr"]


# --- faults ---------------------------------------------------------------------------------------------------------


def refuse(path: Path, data: bytes, *words: str) -> None:
    path.write_bytes(data)
    with pytest.raises(FileError) as caught:
        read_environment_image(path)
    assert str(path) in str(caught.value)
    for word in words:
        assert word in str(caught.value), caught.value


def exr_bytes(tmp_path: Path, **header: object) -> bytes:
    return save(tmp_path / "base.exr", planes(), **header).read_bytes()


def patched_window(data: bytes, name: bytes, box: tuple[int, int, int, int]) -> bytes:
    at = data.index(name + b"\0box2i\0") + len(name) + 1 + 6 + 4
    return data[:at] + struct.pack("<4i", *box) + data[at + 16 :]


def test_missing_file_is_named(tmp_path: Path) -> None:
    with pytest.raises(FileError, match=r"nothing\.exr: cannot be read \(No such file"):
        read_environment_image(tmp_path / "nothing.exr")


def test_faulty_exr_files_are_refused(tmp_path: Path) -> None:
    good = exr_bytes(tmp_path)
    file = tmp_path / "bad.exr"
    refuse(file, b"", "is empty")
    refuse(file, b"only text, whatever the name says", "neither an OpenEXR")
    refuse(file, b"\x89PNG\r\n\x1a\n----", "PNG")
    refuse(file, good[:100], "cut off", "header", "byte 9")
    refuse(file, good[:80], "cut off within its header", "byte 80")
    refuse(file, good[:-40], "cut off")
    refuse(file, good[:4] + struct.pack("<i", 2 | 0x800) + good[8:], "deep")
    refuse(file, good[:4] + struct.pack("<i", 2 | 0x1000) + good[8:], "header attribute")
    for name in (b"dataWindow", b"displayWindow"):
        refuse(file, patched_window(good, name, (0, 0, 99999, 49999)), name.decode(), "5", "limit")
        refuse(file, patched_window(good, name, (0, 0, -1, 15)), name.decode(), "0 × 16")
        refuse(file, patched_window(good, name, (-(2**31), 0, 2**31 - 1, 15)), name.decode())
    refuse(file, patched_window(good, b"dataWindow", (0, 0, 31, 8191)), "bad.exr")
    channels = {name: np.ones((1, 32), np.float32) for name in "RGB"}
    refuse(file, save(tmp_path / "line.exr", channels).read_bytes(), "32 × 1", "too small")
    refuse(file, save(tmp_path / "z.exr", {"Z": np.ones(SHAPE, np.float32)}).read_bytes(), "Z", "expected")
    integers = {name: np.ones(SHAPE, np.uint32) for name in "RGB"}
    refuse(file, save(tmp_path / "uint.exr", integers).read_bytes(), "integers")
    refuse(file, exr_bytes(tmp_path, chromaticities=(0.3,) * 8), "unusable primaries")


@settings(max_examples=3 * settings.default.max_examples)
@given(st.data())
def test_mutated_exr_never_crashes(tmp_path_factory: pytest.TempPathFactory, data: st.DataObject) -> None:
    folder = tmp_path_factory.mktemp("mutated")
    content = bytearray(exr_bytes(folder))
    for _ in range(data.draw(st.integers(1, 8))):
        content[data.draw(st.integers(0, len(content) - 1))] = data.draw(st.integers(0, 255))
    file = folder / "m.exr"
    file.write_bytes(bytes(content[: data.draw(st.integers(0, len(content)))]))
    try:
        image = read_environment_image(file)
    except FileError as error:
        message = str(error)
    else:
        message = str(file)
        assert np.isfinite(image.pixels).all()
    assert str(file) in message
