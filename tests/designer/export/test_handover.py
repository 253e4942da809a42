"""The section that hands the paint over: losses before, files by a process of its own, errors in the window."""

from __future__ import annotations

import re
import shutil
import sys
from dataclasses import replace
from pathlib import Path
from threading import Event

import pytest
from brdf_designer.assembly import Designer
from brdf_designer.export.control import KEY, NAMES, HandoverControl, file_name
from brdf_designer.export.process import Request, run_export, tolerance_words
from brdf_designer.export.section import DAILY, TITLES
from brdf_designer.standard_comparison.control import StandardControl
from brdf_qt.program.settings import settings
from PySide6.QtCore import QPoint, Qt

from brdf_suite.appearance.difference.tolerance import Limits, Tolerances
from brdf_suite.documents.paint import Gloss
from brdf_suite.errors import Cancelled, SuiteError
from brdf_suite.files.exports.format import ExportItem
from brdf_suite.paint_design.standard import standard_of
from brdf_suite.reports import handover
from brdf_suite.reports.handover import format_named, formats, read_paints


@pytest.fixture
def designer(program) -> Designer:
    """The Designer of the module: a window of its own for each test would take most of the time."""
    return program


@pytest.fixture
def dialogs(asked) -> object:
    """What its questions for files are answered with."""
    return asked


@pytest.fixture
def control(designer) -> HandoverControl:
    found = designer.window.findChild(HandoverControl)
    found.open()
    return found


def settled(qtbot, control: HandoverControl) -> None:
    qtbot.waitUntil(lambda: control.section.losses.text().startswith(("Losses:", "No losses.")))


@pytest.fixture
def settings_of_an_earlier_version(own_session: Path) -> None:
    """Version 0.1.0 exported to one format, and kept its name."""
    own_session.mkdir()
    kept = Path(__file__).resolve().parents[2] / "documents" / "old" / "0.1.0" / "settings" / "Designer.ini"
    shutil.copy(kept, settings().fileName())


def test_the_format_of_an_earlier_version_is_taken_over(settings_of_an_earlier_version, own_designer) -> None:
    assert own_designer.feature(HandoverControl).section.chosen == ("csv",)


def test_the_list_is_that_of_the_core() -> None:
    assert [(known.name, known.ending) for known in formats()] == list(NAMES)
    assert list(TITLES) == [name for name, _ in NAMES]


def test_a_paint_is_handed_over_from_the_window(qtbot, designer, dialogs, control, tmp_path: Path) -> None:
    settled(qtbot, control)
    assert designer.window.section(KEY).is_open
    assert control.section.losses.text().startswith("Losses:")
    control.section.choose("csv")
    control.section.formats_chosen.emit()
    qtbot.waitUntil(lambda: control.section.losses.text() == "No losses.")
    dialogs.path = tmp_path / "blue.csv"
    control.section.export.click()
    qtbot.waitUntil(lambda: KEY in designer.window.messages.shown())
    assert designer.window.messages.shown()[KEY].where == str(dialogs.path)
    assert read_paints(dialogs.path).paints == (designer.session.paint,)
    # Where it cannot be written, the window says why, and that nothing else changed.
    designer.window.dismiss_message(KEY)
    control.export(tmp_path / "no folder" / "blue.csv")
    qtbot.waitUntil(lambda: KEY in designer.window.messages.shown())
    assert "cannot be written" in designer.window.messages.shown()[KEY].what
    # A report against the standard: what the section Standard judges by goes along.
    paint = designer.session.paint
    designer.window.findChild(StandardControl).set_standards([standard_of(replace(paint, name="the aim"))])
    control.section.choose("html")
    control.section.formats_chosen.emit()
    qtbot.waitUntil(control.section.compared.isEnabled)
    control.section.pictures.setChecked(False)
    designer.window.dismiss_message(KEY)
    control.export(tmp_path / "blue.html")
    qtbot.waitUntil(lambda: KEY in designer.window.messages.shown())
    text = (tmp_path / "blue.html").read_text(encoding="utf-8")
    assert re.search(r"Against the aim: [a-z ]+; passes\.", text)
    # A paint that cannot be: formats of how it reflects are refused before there is a file.
    designer.session.set_paint(replace(paint, gloss=Gloss(150.0)), "Gloss")
    control.section.choose("gltf")
    control.section.formats_chosen.emit()
    qtbot.waitUntil(lambda: "150 GU" in control.section.losses.text())
    assert not control.section.export.isEnabled()


def test_losses_of_formats_that_are_no_longer_ticked_are_not_shown(qtbot, control, monkeypatch) -> None:
    begun, over = Event(), Event()

    def slow(item: ExportItem) -> tuple[str, ...]:
        begun.set()
        over.wait(60.0)
        return ("slow",)

    known = {"gltf": replace(format_named("gltf"), losses=slow), "csv": format_named("csv")}
    monkeypatch.setattr(handover, "format_named", known.__getitem__)
    control.section.choose("gltf")
    control.section.formats_chosen.emit()
    qtbot.waitUntil(begun.is_set)
    control.section.choose("csv")
    control.section.formats_chosen.emit()
    assert control.is_idle
    assert not control.section.export.isEnabled()
    over.set()
    qtbot.waitUntil(control.section.export.isEnabled)
    assert control.section.losses.text() == "No losses."


def test_several_formats_go_to_one_folder_beside_what_is_there(
    qtbot, designer, dialogs, control, tmp_path: Path
) -> None:
    section = control.section
    section.rest.set_open(False)
    section.choose("csv")
    section.formats_chosen.emit()
    assert not section.formats["json"].isVisibleTo(section)
    section.rest.header.click()
    qtbot.mouseClick(section.formats["json"], Qt.MouseButton.LeftButton, pos=QPoint(8, 10))
    assert section.chosen == ("csv", "json")
    qtbot.waitUntil(section.export.isEnabled)
    assert section.losses.text().count("No losses.") == 2
    assert section.losses.text().startswith(section.formats["csv"].text())
    (tmp_path / "Blue.csv").write_text("old")
    dialogs.path = tmp_path
    section.export.click()
    qtbot.waitUntil(lambda: KEY in designer.window.messages.shown())
    assert (tmp_path / "Blue.csv").read_text() == "old"
    for ending in (".csv", ".json"):
        assert read_paints(tmp_path / f"Blue 2{ending}").paints == (designer.session.paint,)
    shown = designer.window.messages.shown()[KEY]
    assert (shown.what, shown.where) == ("Blue 2.csv, Blue 2.json exported.", str(tmp_path))
    # What can be written is, where another cannot.
    designer.window.dismiss_message(KEY)
    control.export(tmp_path / "again.csv", tmp_path / "no folder" / "again.json")
    qtbot.waitUntil(lambda: KEY in designer.window.messages.shown())
    assert (tmp_path / "again.csv").exists()
    shown = designer.window.messages.shown()[KEY]
    assert "cannot be written" in shown.what
    assert "again.csv" in shown.todo
    section.choose()
    section.formats_chosen.emit()
    qtbot.waitUntil(lambda: section.losses.text() == "Tick the formats to export.")
    assert not section.export.isEnabled()
    section.choose("cxf")


def test_a_cancelled_export_leaves_the_old_file(designer, tmp_path: Path) -> None:
    path = tmp_path / "blue.csv"
    path.write_text("old")

    def stop(_fraction: float, _what: str) -> None:
        raise Cancelled

    with pytest.raises(Cancelled):
        run_export(Request(designer.store.value, "csv", path), stop)
    # Stopped at its first step, the process has either not written or written whole.
    assert path.read_text(encoding="utf-8-sig").startswith(("old", "name,"))
    assert [item.name for item in tmp_path.iterdir() if item.suffix == ".csv"] == ["blue.csv"]


def test_a_process_that_ends_without_a_word_is_reported(designer, tmp_path: Path, monkeypatch) -> None:
    monkeypatch.setattr(sys, "executable", _program(tmp_path))
    with pytest.raises(SuiteError, match="status 3"):
        run_export(Request(designer.store.value, "csv", tmp_path / "a.csv"), lambda *_: None)


def _program(folder: Path) -> str:
    path = folder / "program"
    path.write_text(f"#!{sys.executable}\nimport sys\nsys.exit(3)\n")
    path.chmod(0o755)
    return str(path)


def test_tolerances_become_options_of_the_command(designer) -> None:
    found = Tolerances(
        {15.0: Limits(1.2, lightness=0.5, ellipsoid=True), 20.0: Limits(1.0)}, Limits(0.8), "cmc21"
    )
    assert tolerance_words(found, designer.store.value) == [
        "--difference", "cmc21", "--tolerance", "15=E1.2,L0.5", "--tolerance", "E0.8", "--ellipsoid",
    ]  # fmt: skip
    assert tolerance_words(None, designer.store.value) == []


def test_names_of_files_fit_every_system() -> None:
    assert file_name('a/b:c*"d" ') == "a_b_c_d_"
    assert file_name(" .. ") == "paint"


def test_the_command_brings_its_tab_to_the_front_with_the_whole_section_in_sight(qtbot, designer) -> None:
    window = designer.window
    window.section(KEY).set_open(False)
    window.resize(1100, 700)
    assert window.inspector is window.panel.pages["paint"]
    control = window.findChild(HandoverControl)
    control.section.choose("csv")
    control.open()
    settled(qtbot, control)
    assert window.inspector is window.panel.pages["export"]
    export, view = control.section.export, window.inspector.viewport()

    def in_sight() -> bool:
        return all(
            view.rect().contains(part.mapTo(view, part.rect().center()))
            for part in (*map(control.section.formats.get, DAILY), export)
        )

    qtbot.waitUntil(in_sight)
