"""The colours edited through their real widgets: other angles, L*a*b* and LCh, all in step, the flop alone."""

from __future__ import annotations

from collections.abc import Iterator
from unittest.mock import create_autospec

import numpy as np
import pytest
from brdf_designer.assembly import paint_format
from brdf_designer.colour.flop_panel import HANDLES
from brdf_designer.colour.section import ColourEditors
from brdf_designer.documents.tabs import Documents
from brdf_designer.session.edits import RemoveAngle, SetFlop
from brdf_designer.session.paint_session import PaintSession
from brdf_designer.session.state import colours_of
from brdf_qt.documents.file_reading import FileReading
from brdf_qt.window.dialogs import QtDialogs
from brdf_qt.window.main_window import SuiteWindow
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from brdf_suite.appearance.colour.spaces import lab_to_lch
from brdf_suite.appearance.flop.edits import measure_flop
from brdf_suite.appearance.flop.travel import flop_index
from brdf_suite.documents.paint import Gloss, Measurement, Paint
from brdf_suite.errors import UnreachableError
from brdf_suite.pipeline.lobe_fit import PaintFitter

LABS = ((62.0, -4.0, -45.0), (25.0, 4.0, -38.0), (9.0, 8.0, -28.0))
BLUE = Paint(
    "Blue",
    tuple(Measurement(45.0, a, lab) for a, lab in zip((15.0, 45.0, 110.0), LABS, strict=True)),
    Gloss(90.0),
)
GROOVE = 5
"""Pixels before the groove of a slider."""
GREY = Paint("Grey", tuple(Measurement(45.0, a, (50.0, 0.0, 0.0)) for a in (15.0, 45.0, 110.0)), Gloss(90.0))


class Host:
    """The editors on a paint session, as the window has them."""

    def __init__(self, paint: Paint) -> None:
        fitter, window = (
            create_autospec(PaintFitter, instance=True),
            create_autospec(SuiteWindow, instance=True),
        )
        fitter.fit.side_effect = UnreachableError("What the paint is fitted to does not matter here.")
        self.documents = Documents(
            paint,
            paint_format(),
            create_autospec(QtDialogs, instance=True),
            create_autospec(FileReading, instance=True),
            pytest.fail,
        )
        self.session = PaintSession(self.documents, fitter, lambda *_: None, window)
        self.store = self.documents.front.store
        self.refused: list[str] = []
        window.show_message.side_effect = lambda message: self.refused.append(message.what)
        self.editors = ColourEditors(self.session, lambda _index: None)
        self.editors.numbers.set_open(True)
        self.session.paint_changed.connect(lambda new: self.editors.show_colours(colours_of(new)))
        self.editors.show_colours(colours_of(paint))

    def close(self) -> None:
        self.documents.front.recovery.close(keep=False)

    def steps(self) -> list[str]:
        return [self.store.stack.text(i) for i in range(self.store.stack.count())]

    def labs(self) -> np.ndarray:
        return np.array([m.lab for m in self.store.value.measurements])

    def field(self, index: int, component: int):
        return self.editors.editors[index].fields[component]

    def slider(self, index: int, component: int):
        return self.editors.editors[index].sliders[component]


def shown(paint: Paint, qtbot) -> Iterator[Host]:
    made = Host(paint)
    qtbot.addWidget(made.editors)
    made.editors.resize(420, 700)
    made.editors.show()
    yield made
    made.close()


@pytest.fixture
def host(qtbot) -> Iterator[Host]:
    yield from shown(BLUE, qtbot)


@pytest.fixture
def grey_host(qtbot) -> Iterator[Host]:
    yield from shown(GREY, qtbot)


def type_in(number, text: str) -> None:
    number.setFocus()
    number.selectAll()
    QTest.keyClicks(number, text)
    QTest.keyClick(number, Qt.Key.Key_Return)


def move_to(slider, amount: float) -> None:
    """Move the slider as a drag does."""
    slider.set_amount(amount)
    slider.edited.emit(amount)


def choose(host: Host, name: str) -> None:
    head = host.editors.head
    {**head.spaces.buttons, **head.modes.buttons}[name].click()


def test_lch_shows_the_same_colour_and_sets_it(host: Host) -> None:
    choose(host, "lch")
    lch = lab_to_lch(LABS[1])
    assert [host.field(1, c).value() for c in range(3)] == pytest.approx(lch, abs=0.06)
    assert host.field(1, 2).text().endswith("°")
    assert "h at 45°" in host.slider(1, 2).accessibleName()
    type_in(host.field(1, 2), "10")
    after = lab_to_lch(host.labs()[1])
    assert after == pytest.approx([lch[0], lch[1], 10.0], abs=0.01)
    assert host.steps() == ["Change h at 45°"]
    type_in(host.field(1, 1), "20")
    assert lab_to_lch(host.labs()[1])[1] == pytest.approx(20.0, abs=1e-3)
    # A double click goes back to the colour with which the document was opened, in either space.
    host.store.undo()
    host.store.undo()
    assert host.store.value == BLUE
    choose(host, "lab")
    assert [host.field(1, c).value() for c in range(3)] == list(LABS[1])


@pytest.mark.parametrize("space", ["lab", "lch"])
def test_a_track_shows_the_colour_that_each_place_gives(host: Host, space: str) -> None:
    choose(host, space)
    for component in range(3):
        slider = host.slider(0, component)
        amount, (low, high) = slider.amount(), slider.positions()[[0, -1]]
        x, y = GROOVE + (amount - low) / (high - low) * (slider.width() - 2 * GROOVE), slider.height() // 2
        slider.set_amount(low if amount > 0.5 * (low + high) else high)  # its handle is out of the way
        seen = slider.grab().toImage().pixelColor(round(x), y)
        asked = colours_of(host.store.value).angles[0].rgb
        assert max(abs(a - b) for a, b in zip(seen.getRgb()[:3], asked, strict=True)) < 14


def test_the_hue_goes_round(host: Host) -> None:
    choose(host, "lch")
    type_in(host.field(0, 2), "359.5")
    slider = host.slider(0, 2)
    slider.setFocus()
    QTest.keyClick(slider, Qt.Key.Key_Right)
    assert lab_to_lch(host.labs()[0])[2] == pytest.approx(0.0, abs=0.6)
    QTest.keyClick(slider, Qt.Key.Key_Left)
    QTest.keyClick(slider, Qt.Key.Key_Left)
    assert lab_to_lch(host.labs()[0])[2] > 358.0


def test_a_grey_keeps_the_hue_that_it_is_given(grey_host: Host) -> None:
    host = grey_host
    choose(host, "lch")
    type_in(host.field(1, 2), "90")
    assert host.store.value == GREY, "a grey has no hue"
    type_in(host.field(1, 1), "30")
    assert host.labs()[1] == pytest.approx([50.0, 0.0, 30.0], abs=1e-3)
    type_in(host.field(1, 1), "0")
    assert host.field(1, 2).value() == pytest.approx(90.0, abs=0.1)
    type_in(host.field(1, 1), "10")
    assert lab_to_lch(host.labs()[1])[2] == pytest.approx(90.0, abs=0.1)


def test_all_angles_move_in_step_and_a_drag_back_ends_where_it_began(host: Host) -> None:
    choose(host, "all")
    slider = host.slider(1, 0)
    slider.gesture_started.emit()
    for amount in (28.0, 10.0, 30.0):
        move_to(slider, amount)
    assert host.labs()[:, 0] == pytest.approx([67.0, 30.0, 14.0])
    # On the way the flop had run into black; that is forgotten.
    move_to(slider, 25.0)
    assert host.store.value == BLUE
    move_to(slider, 27.0)
    slider.gesture_finished.emit()
    assert host.steps() == ["Change L* at All Angles"]
    assert host.labs()[:, 1:].tolist() == [list(lab[1:]) for lab in LABS]
    choose(host, "lch")
    type_in(host.field(0, 1), "50")
    before = lab_to_lch(LABS)
    assert lab_to_lch(host.labs())[:, 1] == pytest.approx(before[:, 1] + 50.0 - before[0, 1], abs=2e-3)
    host.store.undo()
    host.store.undo()
    assert host.store.value == BLUE


def test_the_flop_alone_is_moved_by_its_handles(host: Host) -> None:
    choose(host, "flop")
    panel = host.editors.flop
    assert panel.isVisible()
    assert not host.editors.angles.isVisible()
    now = measure_flop([15.0, 45.0, 110.0], LABS)
    assert panel.fields["index"].value() == pytest.approx(now.index, abs=0.06)
    assert panel.fields["hue"].value() == pytest.approx(now.hue_deg, abs=0.06)
    for what, text, name in (
        ("index", "8", "Change Flop Index"),
        ("lightness", "-20", "Change Lightness Travel"),
        ("chroma", "5", "Change Chroma Travel"),
        ("hue", "-30", "Change Hue Travel"),
    ):
        type_in(panel.fields[what], text)
        assert host.labs()[1].tolist() == list(LABS[1]), "the face stays"
        assert host.steps()[-1] == name
        moved = measure_flop([15.0, 45.0, 110.0], host.labs())
        got = {
            "index": moved.index,
            "lightness": moved.lightness,
            "chroma": moved.chroma,
            "hue": moved.hue_deg,
        }
        assert got[what] == pytest.approx(float(text), abs=1e-2)
        if what == "index":
            assert flop_index(*host.labs()[:, 0]).value == pytest.approx(8.0, abs=1e-2)
    for _ in range(4):
        host.store.undo()
    assert host.store.value == BLUE


def test_the_tracks_of_the_flop_show_the_far_end(host: Host, qtbot) -> None:
    choose(host, "flop")
    panel = host.editors.flop
    track = panel.sliders["lightness"]
    assert all(handle.key in panel.sliders for handle in HANDLES)

    def lightness_at(x: int) -> int:
        return track.grab().toImage().pixelColor(x, track.height() // 2).lightness()

    qtbot.waitUntil(lambda: lightness_at(2 * GROOVE) < lightness_at(track.width() - 2 * GROOVE))


def test_a_paint_without_a_hue_has_no_hue_to_travel(grey_host: Host) -> None:
    host = grey_host
    choose(host, "flop")
    assert not host.editors.flop.fields["hue"].isEnabled()
    assert host.editors.flop.fields["index"].isEnabled()
    type_in(host.editors.flop.fields["index"], "10")
    assert flop_index(*host.labs()[:, 0]).value == pytest.approx(10.0, abs=1e-2)


def test_another_set_of_angles_is_one_step_and_keeps_the_look(host: Host) -> None:
    sets = host.editors.head.sets
    assert sets.currentData() == "e2194"
    row = sets.findData("six")
    sets.setCurrentIndex(row)
    sets.activated.emit(row)
    assert sets.currentData() == "six"
    assert len(host.editors.editors) == 6
    assert host.steps() == ["Change Angles"]
    assert [host.store.value.lab_at(a) for a in (15.0, 45.0, 110.0)] == list(LABS)
    between = host.store.value.lab_at(25.0)[0]
    assert LABS[1][0] < between < LABS[0][0]
    host.store.undo()
    assert host.store.value == BLUE
    assert len(host.editors.editors) == 3


def test_angles_are_added_and_removed(host: Host) -> None:
    head = host.editors.head
    type_in(head.angle, "75")
    head.add.click()
    assert [m.aspecular_deg for m in host.store.value.measurements] == [15.0, 45.0, 75.0, 110.0]
    assert head.sets.currentText() == "Custom angles"
    assert host.editors.editors[2].remove.isEnabled()
    head.add.click()
    assert "already" in host.refused[-1]
    host.editors.editors[2].remove.click()
    assert host.store.value == BLUE
    assert not host.editors.editors[0].remove.isEnabled(), "three readings are the least"
    assert host.steps() == ["Add Angle", "Remove Angle"]


@pytest.fixture(scope="module")
def kept_host(qapp) -> Iterator[Host]:
    made = Host(BLUE)
    yield made
    made.close()


moves = st.one_of(
    st.tuples(st.just("set"), st.sampled_from(["e2194", "five", "six"])),
    st.tuples(st.just("add"), st.sampled_from([30.0, 60.0, 90.0])),
    st.tuples(st.just("remove"), st.integers(0, 3)),
    st.tuples(st.just("space"), st.sampled_from(["lab", "lch"])),
    st.tuples(st.just("mode"), st.sampled_from(["one", "all", "flop"])),
    st.tuples(st.just("edit"), st.integers(0, 2), st.integers(0, 2), st.floats(0.0, 90.0)),
    st.tuples(st.just("flop"), st.sampled_from([h.key for h in HANDLES]), st.floats(0.0, 30.0)),
)


@settings(
    max_examples=settings.default.max_examples // 2,
    suppress_health_check=[HealthCheck.function_scoped_fixture],
)
@given(way=st.lists(moves, min_size=1, max_size=8))
def test_any_edits_and_as_many_undos_give_the_identical_paint(kept_host: Host, way: list[tuple]) -> None:
    host = kept_host
    host.store.replace(BLUE, None)
    host.editors.show_colours(colours_of(BLUE))
    for what, *rest in way:
        if what == "set":
            host.editors.head.set_chosen.emit(rest[0])
        elif what == "add":
            host.editors.head.angle_added.emit(rest[0])
        elif what == "remove":
            host.session.edit(RemoveAngle(rest[0]))
        elif what in ("space", "mode"):
            choose(host, rest[0])
        elif what == "edit":
            host.field(rest[0], rest[1]).setValue(rest[2])
        else:
            host.session.edit(SetFlop(*rest))
    while host.store.stack.canUndo():
        host.store.undo()
    assert host.store.value == BLUE
    assert [editor.index for editor in host.editors.editors] == [0, 1, 2]
