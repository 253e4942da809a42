"""The work file of a reconstruction: whole records, whatever happens to its end."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from brdf_suite.acquisition.reconstruction.work_file import CALIBRATION, LAYOUT, POSITION, open_work
from brdf_suite.errors import FileError

PLACES = np.arange(5, dtype=np.int32)
SUMS = np.linspace(0.0, 1.0, 15, dtype=np.float32).reshape(5, 3)


@pytest.fixture
def path(tmp_path: Path) -> Path:
    """A file with a calibration and two positions."""
    path = tmp_path / "a.work"
    with open_work(path) as work:
        work.add(CALIBRATION, {"key": "k", "times": [0.1, 1e-300]}, {})
        work.add(POSITION, {"position": 0}, {"places": PLACES, "sums": SUMS})
        work.add(POSITION, {"position": 1}, {"places": PLACES[:0], "sums": SUMS[:0]})
    return path


def positions(path: Path) -> list[int]:
    with open_work(path) as work:
        return [record.values["position"] for record in work.records if record.tag == POSITION]


def test_what_goes_in_comes_out(path: Path) -> None:
    with open_work(path) as work:
        assert work.records[0].values == {"key": "k", "times": [0.1, 1e-300]}
        arrays = work.arrays(work.records[1])
        assert np.array_equal(arrays["places"], PLACES)
        assert np.array_equal(arrays["sums"], SUMS)
        assert work.arrays(work.records[2])["sums"].shape == (0, 3)
    assert positions(path) == [0, 1]
    assert [file.name for file in path.parent.iterdir()] == ["a.work"]


def test_a_half_written_record_is_cut_off_at_any_byte(path: Path) -> None:
    whole = path.read_bytes()
    with open_work(path) as work:
        last = work.records[2].start
    for end in (last, last + 1, last + 16, last + 48, len(whole) - 1):
        path.write_bytes(whole[:end])
        assert positions(path) == [0]
        assert path.stat().st_size == last
        with open_work(path) as work:
            work.add(POSITION, {"position": 7}, {})
        assert positions(path) == [0, 7]
    path.write_bytes(whole[: len(LAYOUT.magic) - 3])
    assert positions(path) == []


def test_a_changed_byte_ends_what_is_believed(path: Path) -> None:
    whole = bytearray(path.read_bytes())
    with open_work(path) as work:
        whole[work.records[1].start + 30] ^= 1
    path.write_bytes(whole)
    with open_work(path) as work:
        assert [record.tag for record in work.records] == [CALIBRATION]


def test_another_file_is_left_as_it_is(tmp_path: Path) -> None:
    path = tmp_path / "letter.work"
    path.write_text("Dear colleague")
    with pytest.raises(FileError, match="no work file"), open_work(path):
        pass
    assert path.read_text() == "Dear colleague"


def test_one_program_at_a_time(path: Path) -> None:
    with open_work(path), pytest.raises(FileError, match="in use"), open_work(path):
        pass
    assert positions(path) == [0, 1]


def test_emptied(path: Path) -> None:
    with open_work(path) as work:
        work.empty()
        work.add(POSITION, {"position": 3}, {"sums": SUMS})
    assert positions(path) == [3]


def test_a_full_disk_is_reported_with_the_file_and_leaves_what_was_whole(path: Path) -> None:
    resource = pytest.importorskip("resource")
    whole = path.stat().st_size
    old = resource.getrlimit(resource.RLIMIT_FSIZE)
    # A file that may not grow refuses as a full disk does: in the middle of a record.
    resource.setrlimit(resource.RLIMIT_FSIZE, (whole + 100, old[1]))
    try:
        with pytest.raises(FileError, match=r"a\.work.*cannot be written"), open_work(path) as work:
            work.add(POSITION, {"position": 2}, {"sums": np.ones((100, 3), np.float32)})
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, old)
    assert path.stat().st_size == whole
    assert positions(path) == [0, 1]
