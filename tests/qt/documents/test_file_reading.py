"""Files are read off the window's thread, in order, and can be cancelled; a pipe stands for a disk that hangs."""

from __future__ import annotations

import os
import threading
from pathlib import Path

import pytest
from brdf_qt.documents.file_reading import FileReading
from brdf_qt.window.progress_strip import ProgressStrip
from PySide6.QtWidgets import QPushButton

from brdf_suite.errors import FileError


class Asked:
    """Opens files of a :class:`FileReading`, and notes what came of them."""

    def __init__(self, strip: ProgressStrip) -> None:
        self.reading = FileReading(strip)
        self.found: list[object] = []
        self.threads: set[int] = set()

    def read(self, path: Path, _progress: object) -> bytes:
        self.threads.add(threading.get_ident())
        if not path.exists():
            raise FileError(path, "is missing")
        return path.read_bytes()

    def open(self, path: Path) -> None:
        self.reading.begin(path, self.read, self.found.append, self.found.append)


@pytest.fixture
def strip(qtbot) -> ProgressStrip:
    strip = ProgressStrip()
    qtbot.addWidget(strip)
    return strip


@pytest.fixture
def asked(strip):
    asked = Asked(strip)
    yield asked
    asked.reading.close()


def test_files_come_in_the_order_of_the_requests_on_another_thread(asked, strip, qtbot, tmp_path) -> None:
    for name in "abc":
        (tmp_path / name).write_text(name)
    for name in ("a", "missing", "b", "c"):
        asked.open(tmp_path / name)
    assert not asked.reading.is_idle
    assert not asked.found
    qtbot.waitUntil(lambda: asked.reading.is_idle)
    assert [one for one in asked.found if isinstance(one, bytes)] == [b"a", b"b", b"c"]
    assert isinstance(asked.found[1], FileError)
    assert threading.get_ident() not in asked.threads


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="named pipes are of POSIX")
def test_one_that_hangs_is_cancelled_and_the_next_is_read(asked, strip, qtbot, tmp_path) -> None:
    os.mkfifo(tmp_path / "slow")
    for name in ("waiting", "quick"):
        (tmp_path / name).write_text(name)
    for name in ("slow", "waiting", "quick"):
        asked.open(tmp_path / name)
    try:
        qtbot.waitUntil(lambda: len(strip.jobs) == 3)
        slow, waiting, _quick = strip.findChildren(QPushButton)
        waiting.click()
        assert not asked.found
        slow.click()
        qtbot.waitUntil(lambda: asked.reading.is_idle)
        assert asked.found == [b"quick"]
        assert not strip.jobs
    finally:
        with (tmp_path / "slow").open("wb"):
            pass


def test_a_failure_in_showing_one_keeps_no_other_waiting(asked, qtbot, tmp_path) -> None:
    (tmp_path / "a").write_text("a")

    def fail(_answer: object) -> None:
        raise RuntimeError("shown badly")

    asked.reading.begin(tmp_path / "a", asked.read, fail, asked.found.append)
    asked.open(tmp_path / "a")
    with qtbot.captureExceptions() as caught:
        qtbot.waitUntil(lambda: asked.reading.is_idle)
    assert "shown badly" in str(caught[0][1])
    assert asked.found == [b"a"]
