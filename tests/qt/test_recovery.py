"""What a kill loses: at most the last second, whatever the hand does; on a clock that the test moves."""

from __future__ import annotations

import json
import os
import threading

from brdf_qt.documents.files import DocumentFormat
from brdf_qt.documents.open_document import DocumentStore
from brdf_qt.documents.open_tabs import OpenTab, TabsRecord
from brdf_qt.documents.recovery import MOST_STATES, Recovery, force
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from PySide6.QtCore import QThreadPool

NUMBERS = DocumentFormat(
    kind="number",
    ending=".number",
    new=lambda: 0,
    load=lambda path: int(path.read_text()),
    save=lambda value, path: path.write_text(str(value)),
    to_json=lambda value: {"number": value},
    from_json=lambda value, _path: value["number"],
    name_of=str,
)


def fail(error: BaseException) -> None:
    raise AssertionError(error)


class Clock:
    """Stands for the timer of a recovery: single shot, of the same interval, on a time of its own."""

    def __init__(self, recovery: Recovery[int]) -> None:
        self._fire, self._interval = recovery.write, recovery.timer.interval()
        assert recovery.timer.isSingleShot()
        self.now = 0
        self._due: int | None = None

    def isActive(self) -> bool:  # noqa: N802 - the name is Qt's
        return self._due is not None

    def start(self) -> None:
        self._due = self.now + self._interval

    def stop(self) -> None:
        self._due = None

    def wait(self, milliseconds: int) -> None:
        end = self.now + milliseconds
        while self._due is not None and self._due <= end:
            self.now, self._due = self._due, None
            self._fire()
        self.now = end


@settings(suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(pauses=st.lists(st.integers(0, 1500), min_size=1, max_size=40), in_gesture=st.booleans())
def test_a_kill_at_any_moment_of_a_drag_loses_less_than_a_second(qapp, own_settings, pauses, in_gesture):
    store = DocumentStore(0)
    recovery = Recovery(store, NUMBERS, fail)
    clock = recovery.timer = Clock(recovery)
    made: list[int] = [0]
    if in_gesture:
        store.begin_gesture("Drag")
    for number, pause in enumerate(pauses, 1):
        store.set(number, "Drag")
        made.append(clock.now)
        clock.wait(pause)
        kept = json.loads(recovery.file.read_text())["document"]["number"] if recovery.file.exists() else 0
        # A kill now loses what was done after ``kept``: the first of that must be younger than a second.
        lost = made[kept + 1 :]
        assert not lost or clock.now - lost[0] < 1000
    recovery.close(keep=False)


def test_a_closed_one_writes_no_more(qapp, own_settings):
    store = DocumentStore(0)
    recovery = Recovery(store, NUMBERS, fail)
    recovery.close(keep=True)
    store.set(1, "After it")
    assert not recovery.timer.isActive()
    recovery.close(keep=True)
    assert list(own_settings.rglob("*.recovery.json")) == []


def test_what_was_written_last_is_offered_first_also_within_a_second(qapp, own_settings):
    ended = []
    for number in (1, 2, 3):
        store = DocumentStore(0)
        recovery = Recovery(store, NUMBERS, fail)
        store.set(number, "Work")
        ended.append(recovery)
    for recovery in (ended[1], ended[2], ended[0]):
        recovery.write()
    for recovery in ended:
        recovery.close(keep=True)
    # Closing has written each again, in the order of the numbers.
    other = Recovery(DocumentStore(0), NUMBERS, fail)
    assert [item.value for item in other.found()] == [3, 2, 1]
    other.close(keep=False)


@given(
    edits=st.lists(st.integers(0, 9), max_size=30),
    back=st.integers(0, 30),
    saved_after=st.none() | st.integers(0, 30),
)
@settings(suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_the_history_comes_back_with_its_place_and_what_was_saved(
    qapp, own_settings, tmp_path, edits, back, saved_after
):
    store = DocumentStore(-1)
    store.replace(-1, tmp_path / "a.number", clean=saved_after is not None)
    recovery = Recovery(store, NUMBERS, fail, keeps_history=True)
    for number, value in enumerate(edits):
        store.set(value, f"Step {number}")
        if number == saved_after:
            store.mark_clean(tmp_path / "a.number")
    for _ in range(back):
        store.undo()
    assert recovery.write()
    states, place, clean = store.states(), store.stack.index(), store.is_clean
    left = recovery.file.with_name(f"left_{recovery.file.name}")
    if clean:
        assert not recovery.file.exists()
        recovery.close(keep=False)
        return
    recovery.file.replace(left)
    recovery.close(keep=False)
    again = DocumentStore(0)
    other = Recovery(again, NUMBERS, fail, keeps_history=True)
    (item,) = [one for one in other.found() if one.file == left]
    heard = []
    again.changed.connect(lambda old, new: heard.append((old, new)))
    other.take(item)
    assert again.states() == states
    assert (again.stack.index(), again.value) == (place, states[place][1])
    assert not again.is_clean
    assert not left.exists()
    # What the file holds is clean again, where the history goes through it.
    seen = []
    while again.stack.canUndo():
        again.undo()
    for at in range(again.stack.count() + 1):
        again.go_to(at)
        seen.append(again.is_clean)
    store_seen = []
    for at in range(store.stack.count() + 1):
        store.go_to(at)
        store_seen.append(store.is_clean)
    assert seen == store_seen
    other.close(keep=False)


def test_a_damaged_history_leaves_the_work(qapp, own_settings):
    store = DocumentStore(0)
    recovery = Recovery(store, NUMBERS, fail, keeps_history=True)
    store.set(7, "Seven")
    recovery.write()
    whole = json.loads(recovery.file.read_text())
    recovery.close(keep=False)
    other = Recovery(DocumentStore(0), NUMBERS, fail, keeps_history=True)
    wrong = [
        None, 3, {}, {"states": [], "place": 0, "saved": -1}, {**whole["history"], "place": 9},
        {**whole["history"], "saved": -7}, {**whole["history"], "place": 0},
        {**whole["history"], "states": [["a", {}]]}, {**whole["history"], "place": "x"},
    ]  # fmt: skip
    for number, history in enumerate(wrong):
        file = other.folder / f"{number}.recovery.json"
        file.write_text(json.dumps({**whole, "history": history}))
        (item,) = other.found()
        assert item.history is None
        assert item.value == 7
        file.unlink()
    other.close(keep=False)


def test_a_long_history_is_kept_around_its_place(qapp, own_settings):
    store = DocumentStore(0)
    recovery = Recovery(store, NUMBERS, fail, keeps_history=True)
    for value in range(1, 2 * MOST_STATES):
        store.set(value, f"Step {value}")
    store.go_to(MOST_STATES)
    recovery.write()
    left = recovery.file.with_name(f"left_{recovery.file.name}")
    recovery.file.replace(left)
    recovery.close(keep=False)
    again = DocumentStore(0)
    other = Recovery(again, NUMBERS, fail, keeps_history=True)
    (item,) = other.found()
    other.take(item)
    assert again.value == MOST_STATES
    assert len(again.states()) == MOST_STATES
    again.undo()
    assert again.value == MOST_STATES - 1
    again.go_to(again.stack.count())
    assert again.value > MOST_STATES
    other.close(keep=False)


def test_the_tabs_of_an_ended_run_are_found_by_the_newest_record_alone(qapp, own_settings, tmp_path):
    def record(tabs, front):
        return TabsRecord(lambda: (tabs, front))

    mine = record([OpenTab(tmp_path / "now.number", "")], 0)
    mine.write()
    assert mine.left() is None
    tabs = [OpenTab(tmp_path / "a.number", "x.recovery.json"), OpenTab(None, "y.recovery.json")]
    older, newer = record([], 0), record(tabs, 1)
    for number, one in enumerate((older, newer)):
        one.close(keep=True)
        os.utime(one.file, (1000 + number, 1000 + number))
    damaged = mine.file.with_name("zz.tabs.json")
    damaged.write_text('{"front": 0, "tabs": [{"path": 3}]}')
    left = mine.left()
    assert (left.tabs, left.front) == (tuple(tabs), 1)
    assert not older.file.exists()
    assert not damaged.exists()
    mine.drop(left)
    assert mine.left() is None
    mine.close(keep=False)
    assert not mine.file.exists()


def test_an_autosave_reaches_the_disk_on_another_thread(qtbot, own_settings, monkeypatch):
    store = DocumentStore(0)
    recovery = Recovery(store, NUMBERS, fail)
    flushed: list[tuple[bool, int]] = []
    real = os.fsync

    def fsync(descriptor: int) -> None:
        is_window = threading.current_thread() is threading.main_thread()
        flushed.append((is_window, os.fstat(descriptor).st_ino))
        real(descriptor)

    monkeypatch.setattr(os, "fsync", fsync)
    store.set(5, "Step")
    assert recovery.write()
    wanted = {recovery.file.stat().st_ino, recovery.folder.stat().st_ino if os.name != "nt" else 0} - {0}
    qtbot.waitUntil(lambda: wanted <= {inode for _, inode in flushed})
    assert not any(is_window for is_window, _ in flushed)
    recovery.close(keep=False)


def test_a_power_loss_before_an_autosave_is_on_the_disk_leaves_the_one_before(
    qapp, own_settings, monkeypatch
):
    store = DocumentStore(0)
    ended = Recovery(store, NUMBERS, fail)
    store.set(5, "Step")
    assert ended.write()
    QThreadPool.globalInstance().waitForDone()
    force(ended.file)  # once more changes nothing
    assert sorted(one.suffix for one in ended.folder.glob("*.recovery.*")) == [".forced", ".json", ".lock"]
    monkeypatch.setattr(QThreadPool, "start", lambda *_: None)  # the power is lost before the disk is reached
    store.set(6, "Step")
    ended.close(keep=True)
    ended.file.write_bytes(b"")
    own = DocumentStore(0)
    mine = Recovery(own, NUMBERS, fail)
    (item,) = mine.found()
    assert item.value == 5
    mine.take(item)
    assert own.value == 5
    assert [file for file in mine.folder.iterdir() if file.name.startswith(item.file.stem)] == []
    mine.close(keep=False)
    assert list(mine.folder.iterdir()) == []


def test_a_second_name_of_what_was_saved_goes_with_the_next_start(qapp, own_settings):
    mine = Recovery(DocumentStore(0), NUMBERS, fail)
    (mine.folder / "x.recovery.forced").write_text("{}")
    assert mine.found() == []
    assert not (mine.folder / "x.recovery.forced").exists()
    mine.close(keep=False)


def test_work_on_a_file_whose_name_is_no_text_comes_back(qapp, own_settings, tmp_path):
    path = tmp_path / "\udce9.number"
    store = DocumentStore(0)
    store.replace(0, path)
    recovery = Recovery(store, NUMBERS, fail, keeps_history=True)
    store.set(7, "Work")
    assert recovery.write()
    recovery.close(keep=True)
    other = Recovery(DocumentStore(0), NUMBERS, fail)
    (item,) = other.found()
    assert (item.value, item.path) == (7, path)
    other.close(keep=False)
    record = TabsRecord(lambda: ([OpenTab(path, "x.recovery.json")], 0))
    record.close(keep=True)
    left = TabsRecord(lambda: ([], 0)).left()
    assert left.tabs == (OpenTab(path, "x.recovery.json"),)
