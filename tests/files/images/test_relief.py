from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from brdf_suite.errors import FileError
from brdf_suite.files.images import relief as relief_images
from brdf_suite.files.images.exr.image import write_exr
from brdf_suite.files.images.relief import read_mask, read_normal_map, read_tangent_map


def save(path: Path, pixels: np.ndarray) -> Path:
    Image.fromarray(pixels).save(path)
    return path


def encoded(normals: np.ndarray) -> np.ndarray:
    return np.round((normals + 1.0) * 127.5).astype(np.uint8)


def test_a_normal_map_becomes_slopes_from_the_lower_edge(tmp_path: Path) -> None:
    normals = np.zeros((4, 6, 3))
    normals[..., 2] = 1.0
    normals[0, 0] = [0.6, 0.0, 0.8]  # the upper left texel leans to the right: the surface falls along u
    normals[3, 5] = [0.0, -0.6, 0.8]
    slopes = read_normal_map(save(tmp_path / "map.png", encoded(normals)))
    assert slopes.shape == (4, 6, 2)
    assert slopes[3, 0] == pytest.approx([-0.75, 0.0], abs=0.02)
    assert slopes[0, 5] == pytest.approx([0.0, 0.75], abs=0.02)
    assert np.abs(slopes[1:3]).max() < 0.01


def test_signed_normals_in_exr(tmp_path: Path) -> None:
    normals = np.tile(np.array([0.6, 0.0, 0.8], np.float32), (2, 3, 1))
    normals[0, 0] = [-0.6, 0.0, 0.8]
    path = tmp_path / "map.exr"
    write_exr(path, normals)
    slopes = read_normal_map(path)
    assert slopes[0, 1] == pytest.approx([-0.75, 0.0], abs=1e-3)
    assert slopes[1, 0] == pytest.approx([0.75, 0.0], abs=1e-3)


def test_a_steep_texel_stays_finite(tmp_path: Path) -> None:
    normals = np.tile([0.0, 0.0, 1.0], (4, 4, 1))
    normals[1, 1] = [1.0, 0.0, 0.0]
    slopes = read_normal_map(save(tmp_path / "map.png", encoded(normals)))
    assert np.abs(slopes).max() <= 20.0


@pytest.mark.parametrize(
    ("pixels", "words"),
    [
        (np.full((4, 4), 200, np.uint8), "one channel"),
        (np.full((4, 4, 3), 40, np.uint8), "no normal map"),
    ],
)
def test_what_is_no_normal_map_is_refused(tmp_path: Path, pixels: np.ndarray, words: str) -> None:
    with pytest.raises(FileError, match=words):
        read_normal_map(save(tmp_path / "map.png", pixels))


def test_masks_of_several_kinds(tmp_path: Path) -> None:
    grey = np.zeros((2, 3), np.uint8)
    grey[0] = 255  # the upper row
    for name, pixels in (("grey", grey), ("colour", np.repeat(grey[..., None], 3, -1))):
        mask = read_mask(save(tmp_path / f"{name}.png", pixels))
        np.testing.assert_array_equal(mask, [[0, 0, 0], [1, 1, 1]])
    deep = np.array([[0, 32768], [65535, 0]], np.uint16)
    np.testing.assert_allclose(read_mask(save(tmp_path / "deep.png", deep)), [[1, 0], [0, 0.5]], atol=1e-3)
    path = tmp_path / "mask.exr"
    write_exr(path, np.full((2, 2, 3), 2.0, np.float32))
    assert (read_mask(path) == 1.0).all()


def test_large_images_are_averaged_down(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(relief_images, "LARGEST_SIDE", 4)
    pixels = np.zeros((8, 8), np.uint8)
    pixels[::2] = 255
    mask = read_mask(save(tmp_path / "mask.png", pixels))
    np.testing.assert_allclose(mask, np.full((4, 4), 0.5), atol=1e-6)


@pytest.mark.parametrize("content", [b"", b"not an image at all", b"\x89PNG\r\n\x1a\n" + bytes(40)])
def test_damaged_files_are_refused(tmp_path: Path, content: bytes) -> None:
    path = tmp_path / "image.png"
    path.write_bytes(content)
    for read in (read_mask, read_normal_map, read_tangent_map):
        with pytest.raises(FileError):
            read(path)


def test_a_missing_and_a_truncated_file(tmp_path: Path) -> None:
    with pytest.raises(FileError, match="cannot be read"):
        read_mask(tmp_path / "none.png")
    path = save(tmp_path / "mask.png", np.random.default_rng(0).integers(0, 255, (64, 64), np.uint8))
    path.write_bytes(path.read_bytes()[:900])
    with pytest.raises(FileError, match="damaged"):
        read_mask(path)


def test_a_tangent_map_becomes_unit_directions_from_the_lower_edge(tmp_path: Path) -> None:
    along = np.zeros((4, 6, 3))
    along[..., 0] = 1.0
    along[0, 0] = [0.0, -1.0, 0.0]
    turns = read_tangent_map(save(tmp_path / "map.png", encoded(along)))
    assert turns.shape == (4, 6, 2)
    assert turns[3, 0] == pytest.approx([0.0, -1.0], abs=0.01)
    assert turns[0, 0] == pytest.approx([1.0, 0.0], abs=0.01)
    np.testing.assert_allclose(np.linalg.norm(turns, axis=-1), 1.0, atol=1e-6)
    for pixels, words in (
        (np.full((4, 4), 200, np.uint8), "one channel"),
        (np.full((4, 4, 3), 128), "no tangent map"),
    ):
        with pytest.raises(FileError, match=words):
            read_tangent_map(save(tmp_path / "no.png", np.asarray(pixels, np.uint8)))


@pytest.mark.parametrize("shape", [(9000, 3), (2, 9000), (1, 1), (4097, 4096)])
def test_thin_images_keep_a_texel_and_whole_blocks_are_averaged(tmp_path: Path, shape) -> None:
    height, width = shape
    pixels = np.random.default_rng(1).integers(0, 256, (height, width), dtype=np.uint8)
    mask = read_mask(save(tmp_path / "mask.png", pixels))
    step = -(-max(shape) // relief_images.LARGEST_SIDE)
    down, across = min(step, height), min(step, width)
    assert mask.shape == (height // down, width // across)
    first = pixels[::-1][height % down :][:down, :across] / 255.0
    assert mask[0, 0] == pytest.approx(first.mean(), abs=1e-6)
    last = pixels[:down, -across - width % across :][:, :across] / 255.0
    assert mask[-1, -1] == pytest.approx(last.mean(), abs=1e-6)
