"""The standard of a paint from one run to the next: with its file, with its autosave, and where a file has gone."""

from __future__ import annotations

import json
import shutil
from dataclasses import replace

import pytest
from brdf_designer.standard_comparison.control import StandardControl
from brdf_designer.standard_comparison.records import Record, kept, record_from_json
from brdf_qt.program.settings import state_folder

from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.documents.palette_store import save_palette
from brdf_suite.documents.store import save_paint
from brdf_suite.paint_design.standard import Standard, standard_of
from brdf_suite.pipeline.material import load_shipped_paint
from brdf_suite.reflectance.designed.build import build_paint


@pytest.fixture
def control(program) -> StandardControl:
    return program.feature(StandardControl)


@pytest.fixture
def file(tmp_path):
    path = tmp_path / "mine.brdfpaint"
    save_paint(load_shipped_paint("red"), path)
    return path


def open_and_wait(program, qtbot, path) -> None:
    program.documents.open(path)
    qtbot.waitUntil(lambda: program.reading.is_idle)


def open_anew(program, qtbot, path) -> None:
    """Close every tab, and open the file as a start of the program does: nothing is known of it but what was kept."""
    for document in program.documents.row:
        program.documents.close(document)
    open_and_wait(program, qtbot, path)


def test_a_file_has_its_standard_again_when_it_is_opened_the_next_time(program, control, file, qtbot) -> None:
    open_and_wait(program, qtbot, file)
    control.take_present()
    red = control.standard
    open_anew(program, qtbot, file)
    assert control.standard is not red
    assert control.standard.name == red.name
    assert control.standard.paint == red.paint
    assert control.section.verdict.text().startswith("pass")
    control.remove()
    open_anew(program, qtbot, file)
    assert control.standard is None


def test_a_paint_that_gets_a_file_takes_its_standard_along(program, control, fresh, tmp_path, qtbot) -> None:
    control.take_present()
    darker = program.session.paint.with_lab(110.0, (6.0, 8.0, -28.0))
    program.session.set_paint(darker, "Darken")
    fresh[1].path = tmp_path / "darker.brdfpaint"
    assert program.files.save_as()
    open_anew(program, qtbot, fresh[1].path)
    assert control.standard.paint == load_shipped_paint("blue")
    assert control.section.sentence.text() == "darker at 110°; slightly more flop"


def test_what_a_kill_leaves_has_its_standard(program, control) -> None:
    control.take_present()
    program.session.set_paint(program.session.paint.with_lab(110.0, (6.0, 8.0, -28.0)), "Darken")
    recovery = program.documents.front.recovery
    assert recovery.write()
    # No process holds what a killed one has written.
    left = recovery.file.with_name(f"left_{recovery.file.name}")
    shutil.copy(recovery.file, left)
    others = program.documents.add(load_shipped_paint("red"))
    (item,) = others.recovery.found()
    program.documents.recover(item)
    assert control.standard.paint == load_shipped_paint("blue")
    assert program.documents.front.store.value.lab_at(110.0)[0] == 6.0


def test_a_standard_out_of_a_palette_has_the_others_of_it_again(
    program, control, file, tmp_path, qtbot
) -> None:
    paints = [replace(load_shipped_paint(name), name=name.title()) for name in ("blue", "red", "pearl")]
    palette = tmp_path / "three.brdfpalette"
    save_palette(Palette("Three", tuple(Entry(paint) for paint in paints)), palette)
    open_and_wait(program, qtbot, file)
    control.load(palette)
    qtbot.waitUntil(lambda: control.standard is not None)
    control.choose(1)
    open_anew(program, qtbot, file)
    assert control.standard.name == "Red", "at once, before the palette is read"
    qtbot.waitUntil(lambda: control.section.choices.count() == 3)
    assert control.standard.name == "Red"
    # Another one is in its place now: the standard stays, and that is said.
    save_palette(Palette("Two", (Entry(paints[0]), Entry(paints[2]))), palette)
    open_anew(program, qtbot, file)
    qtbot.waitUntil(lambda: "standard" in program.window.messages.shown())
    assert "has changed" in program.window.messages.shown()["standard"].what
    assert control.standard.paint == paints[1]


def test_the_file_of_a_standard_may_be_gone(program, control, file, tmp_path, qtbot) -> None:
    other = tmp_path / "other.brdfpaint"
    save_paint(load_shipped_paint("pearl"), other)
    open_and_wait(program, qtbot, file)
    control.load(other)
    qtbot.waitUntil(lambda: control.standard is not None)
    other.unlink()
    open_anew(program, qtbot, file)
    qtbot.waitUntil(lambda: "standard" in program.window.messages.shown())
    assert "can no longer be read" in program.window.messages.shown()["standard"].what
    assert control.standard.paint == load_shipped_paint("pearl")


def test_a_measured_standard_keeps_what_was_read_of_it(tmp_path) -> None:
    blue = load_shipped_paint("blue")
    measured = Standard("Panel", "", (), blue.gloss, None, build_paint(blue))
    colour, computed = measured.lab_at(45.0, 60.0)
    assert computed
    plain = json.loads(json.dumps(Record(measured, "panel.binary", 0).to_json()))
    back = record_from_json(plain)
    assert (back.source, back.standard.name, back.standard.gloss) == ("panel.binary", "Panel", blue.gloss)
    assert back.standard.lab_at(45.0, 60.0) == (colour, False)
    assert back.standard.lab_at(45.0, 70.0) is None


@pytest.mark.parametrize("damage", ["{", "[]", '{"name": 1}', '{"name": "x", "origin": "", "notices": 5}'])
def test_a_damaged_record_is_as_good_as_none(program, control, file, damage, qtbot) -> None:
    open_and_wait(program, qtbot, file)
    control.take_present()
    (record,) = state_folder("standards").glob("*.json")
    record.write_text(damage, encoding="utf-8")
    assert kept(file) is None
    open_anew(program, qtbot, file)
    assert control.standard is None


def test_a_standard_in_plain_values_is_the_standard(program) -> None:
    one = standard_of(load_shipped_paint("red"), "somewhere")
    back = record_from_json(json.loads(json.dumps(Record(one).to_json()))).standard
    assert (back.name, back.origin, back.readings, back.paint) == (
        one.name,
        one.origin,
        one.readings,
        one.paint,
    )
