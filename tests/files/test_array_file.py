"""Files of named arrays: whatever is written is read, and what does not fit is refused by its place."""

from __future__ import annotations

import io
import zlib
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from brdf_suite.errors import FileError
from brdf_suite.files.array_file import (
    Layout,
    encode_arrays,
    read_arrays,
    read_header,
    read_next,
    write_arrays,
)

PLAIN = Layout(b"TESTFILE", 3, "test file", ("<f4", "|u1"), smallest=0)
DEFLATED = Layout(b"TESTFILE", 3, "test file", ("<f4", "|u1"), level=6)


@given(
    layout=st.sampled_from([PLAIN, DEFLATED]),
    lengths=st.lists(st.integers(1, 200), max_size=4),
    more=st.booleans(),
)
def test_what_is_written_is_read(
    tmp_path_factory: pytest.TempPathFactory, layout: Layout, lengths: list[int], more: bool
) -> None:
    rng = np.random.default_rng(len(lengths))
    arrays = {str(i): rng.random((n, 3)).astype(np.float32) for i, n in enumerate(lengths)}
    if more:
        arrays["large"] = rng.integers(0, 256, (1 << 20) + 7).astype(np.uint8)
    path = tmp_path_factory.getbasetemp() / "arrays"
    write_arrays(layout, path, {"name": "kiln"}, arrays)
    header, found = read_arrays(layout, path)
    assert header == {"name": "kiln"}
    assert read_header(layout, path)["name"] == "kiln"
    assert list(found) == list(arrays)
    for name, array in found.items():
        assert array.dtype == arrays[name].dtype
        assert np.array_equal(array, arrays[name])
        assert not array.flags.writeable


def test_several_follow_each_other_in_a_stream(tmp_path: Path) -> None:
    path = tmp_path / "log"
    parts = [b"".join(encode_arrays(PLAIN, path, {"n": n}, {"a": np.ones(n, np.float32)})) for n in (0, 5)]
    path.write_bytes(b"".join(parts))
    with path.open("rb") as stream:
        for n in (0, 5):
            header, arrays = read_next(PLAIN, path, stream, path.stat().st_size)
            assert (header["n"], len(arrays["a"])) == (n, n)
        assert stream.seek(0, io.SEEK_CUR) == path.stat().st_size
    with pytest.raises(FileError, match="belong to no array"):
        read_arrays(PLAIN, path)


def test_an_array_that_unpacks_to_more_than_its_shape_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "bomb"
    with monkeypatch.context() as patched:
        patched.setattr(zlib, "compress", lambda _data, _level: zlib.compressobj().flush())
        write_arrays(DEFLATED, path, {}, {"a": np.ones(4, np.float32)})
    with pytest.raises(FileError, match=r"array a.*another size"):
        read_arrays(DEFLATED, path)
    packed = zlib.compress(bytes(1 << 22))
    with monkeypatch.context() as patched:
        patched.setattr(zlib, "compress", lambda _data, _level: packed)
        write_arrays(DEFLATED, path, {}, {"a": np.ones(4, np.float32)})
    with pytest.raises(FileError, match=r"array a.*another size"):
        read_arrays(DEFLATED, path)


@pytest.mark.parametrize(
    ("other", "says"),
    [
        (Layout(b"TESTFILX", 3, "test file", ("<f4",)), "is no test file"),
        (Layout(b"TESTFILE", 4, "test file", ("<f4",)), "version 3; this program reads 4"),
        (Layout(b"TESTFILE", 3, "test file", ("|u1",)), r"arrays\[0\].*one of"),
        (Layout(b"TESTFILE", 3, "test file", ("<f4",), most=1), "more than 1"),
        (Layout(b"TESTFILE", 3, "test file", ("<f4",), whole=True), "checksum"),
    ],
)
def test_another_layout_is_refused(tmp_path: Path, other: Layout, says: str) -> None:
    path = tmp_path / "arrays"
    write_arrays(PLAIN, path, {}, {name: np.ones((2, 3), np.float32) for name in "ab"})
    with pytest.raises(FileError, match=says):
        read_arrays(other, path)
