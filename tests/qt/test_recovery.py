"""What a kill loses: at most the last second, whatever the hand does; on a clock that the test moves."""

from __future__ import annotations

import json

from brdf_qt.documents.files import DocumentFormat
from brdf_qt.documents.open_document import DocumentStore
from brdf_qt.documents.recovery import Recovery
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

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
