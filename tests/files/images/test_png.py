"""PNG writing, read back by Pillow."""

import io
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from PIL import Image, ImageCms

from brdf_suite.appearance.colour.spaces import SPACES
from brdf_suite.errors import Cancelled, FileError
from brdf_suite.files.images.environments import write_png, write_png_strips


@pytest.mark.parametrize("channels", [3, 4])
def test_eight_bit_round_trip_with_text(tmp_path: Path, channels: int) -> None:
    pixels = np.random.default_rng(1).integers(0, 256, (33, 47, channels)).astype(np.uint8)
    file = tmp_path / "a.png"
    write_png(file, pixels, {"Paint": "Bleu nuit métallisé", "Exposure": "0.5 EV"})
    with Image.open(file) as image:
        image.load()
        assert np.array_equal(np.asarray(image), pixels)
        assert image.info["Paint"] == "Bleu nuit métallisé"
        assert image.info["Exposure"] == "0.5 EV"
        assert image.info["srgb"] == 0
    assert [path.name for path in tmp_path.iterdir()] == ["a.png"]


def test_sixteen_bit_round_trip(tmp_path: Path) -> None:
    import OpenImageIO

    pixels = np.random.default_rng(1).integers(0, 65536, (20, 31, 3)).astype(np.uint16)
    file = tmp_path / "a.png"
    write_png(file, pixels)
    back = OpenImageIO.ImageInput.open(str(file)).read_image(OpenImageIO.UINT16)
    assert np.array_equal(back, pixels)


def test_a_failed_write_leaves_the_old_file(tmp_path: Path) -> None:
    with pytest.raises(FileError, match="cannot be written"):
        write_png(tmp_path / "no" / "folder.png", np.zeros((2, 2, 3), np.uint8))
    file = tmp_path / "old.png"
    file.write_bytes(b"old")
    with pytest.raises(ValueError, match="key"):
        write_png(file, np.zeros((2, 2, 3), np.uint8), {"": "empty key"})
    assert file.read_bytes() == b"old"
    assert [path.name for path in tmp_path.iterdir()] == ["old.png"]


@pytest.mark.parametrize(
    "pixels", [np.zeros((2, 2), np.uint8), np.zeros((2, 2, 3), np.float32), np.zeros((0, 2, 3), np.uint8)]
)
def test_wrong_arrays_are_refused(tmp_path: Path, pixels: np.ndarray) -> None:
    with pytest.raises(ValueError, match="pixels must"):
        write_png(tmp_path / "a.png", pixels)


@pytest.mark.parametrize("name", list(SPACES))
def test_strips_with_a_profile(tmp_path: Path, name: str) -> None:
    pixels = np.random.default_rng(1).integers(0, 65536, (31, 20, 3)).astype(np.uint16)
    file = tmp_path / "a.png"
    write_png_strips(file, (20, 31), [pixels[:1], pixels[1:17], pixels[17:]], {"Paint": "x"}, SPACES[name])
    import OpenImageIO

    assert np.array_equal(OpenImageIO.ImageInput.open(str(file)).read_image(OpenImageIO.UINT16), pixels)
    with Image.open(file) as image:
        profile = ImageCms.ImageCmsProfile(io.BytesIO(image.info["icc_profile"]))
        assert ImageCms.getProfileDescription(profile).strip() == SPACES[name].title
        assert "srgb" not in image.info  # a picture has one or the other
    numbers = {"srgb": (1, 13, 0, 1), "display-p3": (12, 13, 0, 1)}[name]
    assert b"cICP" + bytes(numbers) in file.read_bytes()


def test_strips_that_end_early_leave_the_old_file(tmp_path: Path) -> None:
    file = tmp_path / "old.png"
    file.write_bytes(b"old")
    strip = np.zeros((4, 8, 3), np.uint8)

    def cancelled() -> Iterator[np.ndarray]:
        yield strip
        raise Cancelled

    with pytest.raises(Cancelled):
        write_png_strips(file, (8, 9), cancelled())
    for strips in ([strip], [strip, strip[:, :5]], [strip, strip.astype(np.uint16)], []):
        with pytest.raises(ValueError, match="pixels must"):
            write_png_strips(file, (8, 9), strips)
    assert file.read_bytes() == b"old"
    assert [path.name for path in tmp_path.iterdir()] == ["old.png"]
