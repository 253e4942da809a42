"""Damage that once ended in an error without words: each is refused with a sentence, or read."""

from __future__ import annotations

import struct
import zlib
from pathlib import Path

import numpy as np
import pytest

from brdf_suite.acquisition.photographs.reading import read_photograph
from brdf_suite.documents.store import load_paint
from brdf_suite.errors import FileError
from brdf_suite.paint_design.standard_files import load_standards


@pytest.mark.parametrize(
    "text",
    ['name,"L_15,a_15\n1,2,3\n', '"name,L_15,a_15,b_15\nx,1,2,3\n', 'name,L_15,a_15,b_15\n"x,1,2,3\n'],
)
def test_an_unbalanced_quote_in_a_table_is_refused(text: str, tmp_path: Path) -> None:
    path = tmp_path / "standard.csv"
    path.write_text(text)
    with pytest.raises(FileError):
        load_standards(path)


@pytest.mark.parametrize("kind", range(5))
@pytest.mark.parametrize("bits", [8, 16])
def test_a_png_of_one_row_is_read_with_every_filter(kind: int, bits: int, tmp_path: Path) -> None:
    """PNG 1.2, section 6: None, Sub, Up, Average and Paeth; there is no row above the first."""
    codes = (np.array([[10, 200, 30, 77]]) * (1 if bits == 8 else 250)).astype(f">u{bits // 8}")
    size = bits // 8
    raw = np.frombuffer(codes.tobytes(), np.uint8).astype(int)
    left = np.concatenate([np.zeros(size, int), raw[:-size]])
    row = raw - {0: 0 * left, 1: left, 2: 0 * left, 3: left // 2, 4: left}[kind]
    packed = zlib.compress(bytes([kind]) + (row % 256).astype(np.uint8).tobytes())

    def chunk(name: bytes, data: bytes) -> bytes:
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))

    header = struct.pack(">IIBBBBB", codes.shape[1], 1, bits, 0, 0, 0, 0)
    path = tmp_path / "row.png"
    path.write_bytes(
        b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", packed) + chunk(b"IEND", b"")
    )
    np.testing.assert_array_equal(read_photograph(path).codes[..., 0], codes)


def test_a_message_is_short_whatever_the_file_holds(tmp_path: Path) -> None:
    path = tmp_path / "a.brdfpaint"
    path.write_text('{"format": "brdfpaint", "version": 1, "' + "x" * 500_000 + '": 1}')
    with pytest.raises(FileError) as refused:
        load_paint(path)
    assert len(str(refused.value)) < 3000
    error = FileError("a", "holds " + "y" * 100_000, "z" * 100_000)
    assert len(str(error)) < 2300
    assert error.reason.endswith("…")
