"""A map file comes back as it was, and any change to it is noticed."""

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from brdf_suite.errors import FileError
from brdf_suite.files.array_file import read_header
from brdf_suite.lighting.filter.face_array import FaceArray
from brdf_suite.lighting.filter.lobe_maps import LobeMaps
from brdf_suite.lighting.lobe_map_cache import PLAIN, encode_maps, read_maps

KEY = "ab" * 32


def small_maps() -> LobeMaps:
    rng = np.random.default_rng(4)
    one, two, three, four = (
        FaceArray(rng.random((6, n, n, 3)).astype(np.float16), 2.0**-n) for n in (2, 3, 4, 5)
    )
    return LobeMaps((3.0, 50.5, 9e4), (two, three, three), one, four, three)


def decoded(data: bytes, folder: Path, key: str = KEY) -> LobeMaps:
    path = folder / "entry"
    path.write_bytes(data)
    return read_maps(path, key)


WHOLE = b"".join(encode_maps(small_maps(), KEY, "yard"))


def test_it_comes_back_as_it_was(tmp_path: Path) -> None:
    path = tmp_path / "entry"
    path.write_bytes(WHOLE)
    maps, back = small_maps(), read_maps(path, KEY)
    assert back.exponents == maps.exponents
    for one, other in zip(
        (maps.diffuse, maps.through_coat, maps.background, *maps.lobes),
        (back.diffuse, back.through_coat, back.background, *back.lobes),
        strict=True,
    ):
        assert one.scale == other.scale
        np.testing.assert_array_equal(one.faces, other.faces)
    assert back.lobes[1] is back.background  # stored once
    assert not back.diffuse.faces.flags.writeable
    assert read_header(PLAIN, path)["environment"] == "yard"


@settings(max_examples=4 * settings.default.max_examples)
@given(at=st.integers(0, len(WHOLE) - 1), bit=st.integers(0, 7))
def test_a_flipped_bit_anywhere_is_noticed(
    tmp_path_factory: pytest.TempPathFactory, at: int, bit: int
) -> None:
    data = bytearray(WHOLE)
    data[at] ^= 1 << bit
    with pytest.raises(FileError):
        decoded(bytes(data), tmp_path_factory.getbasetemp())


def test_damage_in_any_block_of_a_large_map_is_noticed(tmp_path: Path) -> None:
    """Maps of 1.8 MB: changed bits, and two equally long pieces that changed places."""
    rng = np.random.default_rng(5)
    large = FaceArray(rng.random((6, 224, 224, 3)).astype(np.float16), 1.0)
    small = small_maps().diffuse
    whole = b"".join(encode_maps(LobeMaps((3.0,), (large,), small, small, large), KEY))
    np.testing.assert_array_equal(decoded(whole, tmp_path).background.faces, large.faces)
    for at in (len(whole) - 1, len(whole) - 700_000, len(whole) - 1_500_000):
        damaged = bytearray(whole)
        damaged[at] ^= 0x10
        with pytest.raises(FileError, match="checksum of its arrays"):
            decoded(bytes(damaged), tmp_path)
    swapped = whole[:-8192] + whole[-4096:] + whole[-8192:-4096]
    with pytest.raises(FileError, match="checksum of its arrays"):
        decoded(swapped, tmp_path)


def test_a_changed_digit_of_a_scale_is_noticed(tmp_path: Path) -> None:
    changed = WHOLE.replace(b"0.25, ", b"0.75, ")
    assert changed != WHOLE
    with pytest.raises(FileError, match="checksum"):
        decoded(changed, tmp_path)


@pytest.mark.parametrize("length", [0, 7, 40, 56, 200, len(WHOLE) - 1])
def test_a_shorter_or_longer_file_is_refused(length: int, tmp_path: Path) -> None:
    path = tmp_path / "entry"
    for data in (WHOLE[:length], WHOLE + b"x" * (length + 1)):
        path.write_bytes(data)
        with pytest.raises(FileError):
            read_maps(path, KEY)


def test_another_entrys_name_is_refused(tmp_path: Path) -> None:
    with pytest.raises(FileError, match="another environment"):
        decoded(WHOLE, tmp_path, "cd" * 32)


def test_a_huge_file_is_refused_before_it_is_read(tmp_path: Path) -> None:
    """A hole of 1 TB behind a good start: reading it would need as much memory."""
    path = tmp_path / "entry"
    path.write_bytes(WHOLE)
    with path.open("r+b") as stream:
        stream.truncate(1 << 40)
    with pytest.raises(FileError, match="more than"):
        read_maps(path, KEY)
