"""Pictures to compare with: read, or refused with a message whatever the file holds."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from PIL import Image, PngImagePlugin

from brdf_suite.errors import FileError
from brdf_suite.output.compared import read_compared_picture


def test_a_damaged_png_is_refused_and_never_a_traceback(tmp_path: Path) -> None:
    file = tmp_path / "a.png"
    metadata = PngImagePlugin.PngInfo()
    metadata.add_itxt("Comment", "what the picture shows " * 9, zip=True)
    pixels = np.random.default_rng(1).integers(0, 256, (24, 32, 3), np.uint8)
    Image.fromarray(pixels).save(file, pnginfo=metadata)
    assert np.array_equal(read_compared_picture(file).pixels, pixels)
    sound = file.read_bytes()
    rng = np.random.default_rng(2)
    refused = 0
    for number in range(300):
        damaged = bytearray(sound[: None if number % 3 else rng.integers(1, len(sound))])
        for place in rng.integers(0, min(len(damaged), 400), 3):
            damaged[place] = rng.integers(0, 256)
        file.write_bytes(damaged)
        try:
            read_compared_picture(file)
        except FileError:
            refused += 1
    assert refused > 100
    file.write_bytes(b"no picture")
    with pytest.raises(FileError, match="is no PNG picture that can be read"):
        read_compared_picture(file)
    with pytest.raises(FileError, match=r"missing\.png: cannot be read \(No such file"):
        read_compared_picture(tmp_path / "missing.png")
