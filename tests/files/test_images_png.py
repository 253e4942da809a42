"""PNG writing, read back by Pillow."""

from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from brdf_suite.errors import FileError
from brdf_suite.files.images import write_png


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
