"""The controller with a real fitter and a window that only notes what it is shown."""

from __future__ import annotations

from concurrent.futures import Future
from dataclasses import replace
from time import sleep
from unittest.mock import create_autospec

import numpy as np
import pytest
from brdf_designer.assembly import paint_format
from brdf_designer.colour.patches import PatchRow
from brdf_designer.controller import Controller
from brdf_designer.documents.tabs import Documents
from brdf_designer.session.edits import SetField, SetLab, SetNumber
from brdf_designer.session.paint_session import LONGEST_UNFITTED_S, PaintSession
from brdf_designer.session.state import curves_of
from brdf_designer.window.status import PaintStatus
from brdf_designer.window.window import DesignerWindow
from brdf_qt.documents.file_reading import FileReading
from brdf_qt.link.messages import BadMessageError, encode
from brdf_qt.window.progress_strip import ProgressStrip
from brdf_qt.window.status_line import StatusLine

from brdf_suite.documents.store import paint_from_json
from brdf_suite.errors import FittingError
from brdf_suite.pipeline.lobe_fit import PaintFitter
from brdf_suite.pipeline.material import load_shipped_paint


@pytest.fixture(scope="module")
def fitter() -> PaintFitter:
    return PaintFitter(time_limit_s=60.0)  # exact, however busy the machine is


class LosingFitter(PaintFitter):
    """A fitter out of time, whose solver then loses the optimum: no paint is known that does this."""

    def __init__(self) -> None:
        super().__init__(time_limit_s=1e-6)
        self.optimum: Future = Future()

    def fit(self, paint):
        return replace(super().fit(paint), exact=self.optimum)


class Parts:
    """A controller and all that it works with."""

    def __init__(self, fitter, dialogs) -> None:
        self.view = create_autospec(DesignerWindow, instance=True)
        self.strip = ProgressStrip()
        reading = FileReading(self.strip)
        self.documents = Documents(load_shipped_paint("blue"), paint_format(), dialogs, reading, pytest.fail)
        self.published = []
        self.publish = lambda *message: self.published.append(message)
        self.session = PaintSession(
            self.documents, fitter, lambda *message: self.publish(*message), self.view
        )
        self.controller = Controller(self.view, self.session)

    @property
    def store(self):
        return self.documents.front.store

    def close(self) -> None:
        for document in self.documents.row:
            document.recovery.close(keep=False)


@pytest.fixture
def parts(qapp, fitter, dialogs) -> Parts:
    made = Parts(fitter, dialogs)
    yield made
    made.close()


def test_an_edit_reaches_document_view_and_link(parts, qtbot):
    parts.session.edit(SetLab(1, 0, 30.0))
    assert parts.store.value.lab_at(45.0)[0] == 30.0
    assert parts.view.show_colours.call_args.args[0].paint == parts.store.value
    assert parts.view.show_fit.call_args.args[0].worst_delta_e < 0.5
    qtbot.waitUntil(lambda: len(parts.published) >= 1)
    assert len(parts.published) == 1
    topic, value = parts.published[0]
    assert (topic, paint_from_json(value)) == ("paint", parts.store.value)


def test_many_changes_of_one_turn_are_published_once_the_newest(parts, qtbot):
    for lightness in (30.0, 31.0, 32.0):
        parts.session.edit(SetLab(1, 0, lightness))
    qtbot.waitUntil(lambda: len(parts.published) >= 1)
    qtbot.wait(20)
    assert len(parts.published) == 1
    assert parts.published[0][1]["measurements"][1]["lab"][0] == 32.0


def test_the_curves_follow_the_numbers_once_a_turn(parts, qtbot):
    for lightness in (30.0, 31.0, 32.0):
        parts.session.edit(SetLab(1, 0, lightness))
    assert parts.view.show_fit.call_count == 3
    parts.view.show_curves.assert_not_called()
    qtbot.waitUntil(lambda: parts.view.show_curves.called)
    parts.view.show_curves.assert_called_once()
    shown, due = parts.view.show_curves.call_args.args[0], curves_of(parts.session.fit)
    assert np.array_equal(shown.strip_rgb, due.strip_rgb)
    assert np.array_equal(shown.fitted, due.fitted)


def test_what_stays_of_a_refused_paint_is_the_last_one_that_can_be(parts):
    parts.session.edit(SetLab(1, 0, 30.0))
    due = curves_of(parts.session.fit)
    parts.session.edit(SetNumber("gloss.gu_20", 199.0))
    names = [call[0] for call in parts.view.method_calls]
    assert names.index("show_curves") < names.index("mark_fit_stale")
    assert np.array_equal(parts.view.show_curves.call_args.args[0].strip_rgb, due.strip_rgb)


def test_a_paint_that_the_link_refuses_is_reported(parts, qtbot):
    parts.publish = lambda topic, value: encode(topic, value, "me", 1)
    parts.session.edit(SetField("source", "\u20ac" * 10_000))
    qtbot.wait(20)
    parts.view.show_message.assert_not_called()
    parts.publish = refuse
    parts.session.edit(SetLab(1, 0, 30.0))
    qtbot.waitUntil(lambda: parts.view.show_message.called)
    assert parts.view.show_message.call_args.args[0].key == "link"


def refuse(topic, value) -> None:
    raise BadMessageError("longer than a message may be")


def test_an_unreachable_gloss_is_reported_and_the_last_state_stays(parts, qtbot):
    parts.session.refresh()
    qtbot.waitUntil(lambda: len(parts.published) >= 1)
    assert len(parts.published) == 1
    fits = parts.view.show_fit.call_count
    parts.session.edit(SetNumber("gloss.gu_20", 199.0))
    message = parts.view.show_message.call_args.args[0]
    assert message.key == "fit"
    assert "199 GU" in message.what
    assert parts.view.show_fit.call_count == fits
    parts.view.mark_fit_stale.assert_called_once()
    assert parts.store.value.gloss.gu_20 == 199.0
    qtbot.wait(20)
    assert len(parts.published) == 1
    parts.session.edit(SetNumber("gloss.gu_20", 88.0))
    parts.view.dismiss_message.assert_any_call("fit")
    assert parts.view.show_fit.call_count == fits + 1


def test_an_edit_of_another_field_ends_the_gesture(parts):
    parts.session.begin_gesture()
    parts.session.edit(SetLab(0, 0, 63.0))
    parts.session.edit(SetNumber("gloss.gu_20", 85.0))
    parts.session.edit(SetLab(0, 0, 64.0))
    assert [parts.store.stack.text(i) for i in range(parts.store.stack.count())] == [
        "Change L* at 15°",
        "Change Gloss 20°",
        "Change L* at 15°",
    ]


def test_in_a_gesture_the_fit_follows_once_for_all_edits_of_a_turn(parts, qtbot):
    fits = []
    parts.session.fit_changed.connect(lambda fit: fits.append(fit.paint))
    parts.session.begin_gesture()
    for lightness in (30.0, 31.0, 32.0):
        parts.session.edit(SetLab(1, 0, lightness))
        # The numbers are there at once.
        assert parts.view.show_colours.call_args.args[0].paint is parts.store.value
    assert (fits, parts.session.is_fitting, parts.controller.is_idle) == ([], True, False)
    parts.view.show_fit.assert_not_called()
    qtbot.waitUntil(lambda: parts.controller.is_idle)
    assert fits == [parts.store.value]
    assert parts.store.value.measurements[1].lab[0] == 32.0
    # Nothing is left to a further turn: with the fit, what lies between the angles is shown.
    parts.view.show_fit.assert_called_once()
    parts.view.show_curves.assert_called_once()


def test_a_fit_that_is_asked_for_in_a_gesture_is_of_the_paint_as_it_is(parts):
    parts.session.begin_gesture()
    parts.session.edit(SetLab(1, 0, 30.0))
    assert parts.session.fit.paint is parts.store.value
    assert not parts.session.is_fitting
    parts.session.edit(SetLab(1, 0, 31.0))
    ended = []
    parts.session.gesture_ended.connect(lambda: ended.append(parts.session.is_fitting))
    parts.session.end_gesture()
    assert ended == [False]
    assert parts.view.show_fit.call_count == 2
    assert parts.session.fit.paint.measurements[1].lab[0] == 31.0


def test_edits_that_leave_no_turn_to_the_fit_do_not_starve_it(parts):
    parts.session.begin_gesture()
    parts.session.edit(SetLab(1, 0, 30.0))
    parts.view.show_fit.assert_not_called()
    sleep(2.0 * LONGEST_UNFITTED_S)
    parts.session.edit(SetLab(1, 0, 31.0))
    parts.view.show_fit.assert_called_once()
    assert not parts.session.is_fitting


def test_a_paint_that_cannot_be_is_refused_in_a_gesture_too(parts, qtbot):
    parts.session.begin_gesture()
    parts.session.edit(SetNumber("gloss.gu_20", 199.0))
    qtbot.waitUntil(lambda: parts.view.mark_fit_stale.called)
    assert parts.session.fit is None
    parts.session.edit(SetNumber("gloss.gu_20", 88.0))
    assert parts.session.fit is not None


def test_a_refused_value_is_reported_and_the_field_shows_the_document_again(parts):
    parts.session.begin_gesture()
    parts.session.edit(SetField("name", ""))
    assert parts.store.value.name == "Blue"
    assert "name" in parts.view.show_message.call_args.args[0].what
    shown = parts.view.show_colours.call_count
    parts.session.end_gesture()
    assert parts.view.show_colours.call_count == shown + 1
    parts.view.dismiss_message.assert_any_call("edit")


def test_the_optimum_replaces_a_time_limited_answer(qapp, dialogs, qtbot):
    hurried = PaintFitter(time_limit_s=1e-6)
    parts = Parts(hurried, dialogs)
    parts.session.edit(SetLab(1, 0, 30.0))
    limited = parts.view.show_fit.call_args.args[0]
    assert limited.time_limited
    qtbot.waitUntil(lambda: parts.view.show_fit.call_count >= 2)
    assert parts.view.show_fit.call_count == 2
    exact = parts.view.show_fit.call_args.args[0]
    assert not exact.time_limited
    assert exact.worst_delta_e < min(0.5, limited.worst_delta_e)
    # The paint was sent to the other programs once; its weights are theirs to find.
    qtbot.wait(20)
    assert len(parts.published) == 1
    hurried.close()
    parts.close()


def test_an_optimum_that_is_not_found_is_no_longer_promised(qapp, dialogs, qtbot):
    hurried = LosingFitter()
    parts = Parts(hurried, dialogs)
    parts.session.edit(SetLab(1, 0, 30.0))
    before = parts.view.show_fit.call_args.args[0]
    assert (before.time_limited, before.exact_follows) == (True, True)
    hurried.optimum.set_exception(FittingError("the solver gave up"))
    qtbot.waitUntil(lambda: parts.view.show_fit.call_count >= 2)
    assert parts.view.show_fit.call_count == 2
    qtbot.waitUntil(lambda: parts.view.show_curves.called)
    after = parts.view.show_fit.call_args.args[0]
    assert (after.time_limited, after.exact_follows) == (True, False)
    assert after.delta_e == before.delta_e
    line = StatusLine()
    qtbot.addWidget(line)
    status = PaintStatus(line)
    row = PatchRow()
    qtbot.addWidget(row)
    row.show_colours(parts.view.show_colours.call_args.args[0])
    large = [2.0] * len(after.delta_e)
    for state, words in ((before, "follows automatically"), (after, "no exact")):
        status.show_fit(state)
        status.show_curves(parts.view.show_curves.call_args.args[0])
        assert words in line.cell("Fit").toolTip()
        row.show_differences(large, time_limited=True, exact_follows=state.exact_follows)
        assert words in row.patches[0].fit.toolTip()
    hurried.close()
    parts.close()


def test_the_optimum_of_a_paint_that_is_no_longer_shown_stays_away(qapp, dialogs, qtbot):
    hurried = PaintFitter(time_limit_s=1e-6)
    parts = Parts(hurried, dialogs)
    parts.session.edit(SetLab(1, 0, 30.0))
    parts.session.edit(SetNumber("gloss.gu_20", 199.0))
    qtbot.wait(200)
    assert parts.view.show_fit.call_count == 1
    parts.view.mark_fit_stale.assert_called_once()
    hurried.close()
    parts.close()
