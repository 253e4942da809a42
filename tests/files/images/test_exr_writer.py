"""EXR writing in strips, read back by the OpenEXR library."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import OpenEXR
import pytest

from brdf_suite.errors import Cancelled, FileError
from brdf_suite.files.images.environments import write_exr_strips
from brdf_suite.files.images.exr.image import read_exr
from brdf_suite.files.images.primaries import REC709, REC2020


@pytest.mark.parametrize("height", [1, 15, 16, 50])
@pytest.mark.parametrize("channels", [3, 4])
@pytest.mark.parametrize("half", [False, True])
def test_strips_come_back(tmp_path: Path, height: int, channels: int, half: bool) -> None:
    pixels = np.random.default_rng(2).normal(1.0, 3.0, (height, 33, channels)).astype(np.float32)
    strips = [pixels[:7], pixels[7:30], pixels[30:]]
    file = tmp_path / "a.exr"
    write_exr_strips(file, (33, height), [s for s in strips if len(s)], REC2020, {"owner": "Blåt"}, half=half)
    with OpenEXR.File(str(file)) as read:
        name = "RGB" + "A" * (channels == 4)
        back = read.channels()[name].pixels.copy()
        header = dict(read.header())
    assert np.array_equal(back, pixels.astype(np.float16) if half else pixels)
    assert header["owner"] == "Blåt"
    assert header["chromaticities"] == pytest.approx(REC2020, abs=1e-6)
    assert read_exr(file).chromaticities == pytest.approx(REC2020, abs=1e-6)


def test_smooth_pictures_are_packed_and_halves_are_held(tmp_path: Path) -> None:
    pixels = np.full((64, 64, 3), 1e9, np.float32)
    file = tmp_path / "a.exr"
    write_exr_strips(file, (64, 64), [pixels], REC709, half=True)
    assert file.stat().st_size < 64 * 64
    assert np.unique(read_exr(file).pixels).tolist() == [65504.0]


def test_strips_that_end_early_leave_the_old_file(tmp_path: Path) -> None:
    file = tmp_path / "old.exr"
    file.write_bytes(b"old")
    strip = np.zeros((20, 8, 3), np.float32)

    def cancelled() -> Iterator[np.ndarray]:
        yield strip
        raise Cancelled

    with pytest.raises(Cancelled):
        write_exr_strips(file, (8, 40), cancelled(), REC2020)
    for strips in ([strip], [strip, strip[:, :5]], []):
        with pytest.raises(ValueError, match="strips must"):
            write_exr_strips(file, (8, 40), strips, REC2020)
    with pytest.raises(ValueError, match="31 letters"):
        write_exr_strips(file, (8, 20), [strip], REC2020, {"a" * 32: "x"})
    with pytest.raises(FileError, match="cannot be written"):
        write_exr_strips(tmp_path / "no" / "folder.exr", (8, 20), [strip], REC2020)
    assert file.read_bytes() == b"old"
    assert [path.name for path in tmp_path.iterdir()] == ["old.exr"]
