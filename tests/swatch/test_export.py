"""Export: in the format that was chosen, with its ending, and over no file that was not asked about."""

from __future__ import annotations

from pathlib import Path

import pytest
from brdf_color_swatch.export.dialog import QtExportDialogs, choices_of, with_ending
from brdf_color_swatch.export.palette_export import suggested_file
from PySide6.QtWidgets import QFileDialog, QWidget

from brdf_suite.appearance.colour.flat_colours import flat_labs
from brdf_suite.files.palettes import FORMATS, find_format, read_palette, sniff

CHOICES = choices_of(FORMATS, ".ase")


def choice(name: str):
    """Return the line of a format."""
    return next(one for one in CHOICES if one.form is not None and one.form.name == name)


def write(program, command, qtbot, path: Path) -> None:
    """Export, and write whatever is lost."""
    command(program, "export")
    qtbot.waitUntil(lambda: "export" in program.window.messages.shown())
    message = program.window.messages.shown()["export"]
    assert message.severity != "error", message.what
    dict(message.actions)["Export Anyway"]()
    qtbot.waitUntil(path.exists)
    qtbot.waitUntil(lambda: not program.library.tasks.busy)


@pytest.mark.parametrize(
    ("format_name", "typed", "written"),
    [
        ("jasc", "out.pal", "out.pal"),
        ("riff", "out.pal", "out.pal"),
        ("gpl", "out", "out.gpl"),
        ("gpl", "out.ase", "out.gpl"),
        ("gpl", "out v1.2", "out v1.2.gpl"),
        ("", "out", "out.ase"),
        ("", "out.gpl", "out.gpl"),
    ],
)
def test_the_chosen_format_is_written_with_its_ending(
    swatch, dialogs, tmp_path, qtbot, command, format_name: str, typed: str, written: str
) -> None:
    dialogs.path, dialogs.format = tmp_path / typed, format_name
    write(swatch, command, qtbot, tmp_path / written)
    wanted = format_name or Path(written).suffix[1:]
    assert sniff((tmp_path / written).read_bytes(), written) is find_format(wanted)
    assert [path.name for path in tmp_path.glob("out*")] == [written]


def test_a_file_of_the_name_with_its_ending_is_asked_about(
    swatch, dialogs, tmp_path, monkeypatch, command
) -> None:
    (tmp_path / "out.gpl").write_text("mine")
    answers = [(tmp_path / "out.ase", choice("gpl")), None]
    asked = []

    def export_path(suggested, choices, chosen):
        asked.append((suggested.name, chosen.form and chosen.form.name))
        return answers[len(asked) - 1]

    monkeypatch.setattr(dialogs, "export_path", export_path, raising=False)
    command(swatch, "export")
    assert asked == [("Sample.ase", None), ("out.gpl", "gpl")]
    assert (tmp_path / "out.gpl").read_text() == "mine"
    assert not swatch.library.tasks.busy


def test_the_dialog_adds_the_ending_of_the_chosen_line(qapp, qtbot, tmp_path, monkeypatch) -> None:
    window = QWidget()
    qtbot.addWidget(window)
    suffixes = []

    def exec_(dialog: QFileDialog) -> int:
        suffixes.append(dialog.defaultSuffix())
        # As a click on the line does.
        dialog.selectNameFilter(choice("jasc").line)
        dialog.filterSelected.emit(choice("jasc").line)
        suffixes.append(dialog.defaultSuffix())
        dialog.selectFile("out")
        return QFileDialog.DialogCode.Accepted

    monkeypatch.setattr(QFileDialog, "exec", exec_)
    found = QtExportDialogs(window).export_path(tmp_path / "Sample.ase", CHOICES, CHOICES[0])
    assert suffixes == ["ase", "pal"]
    assert found == (tmp_path / "out.pal", choice("jasc"))


def test_another_format_of_the_same_ending_keeps_the_name() -> None:
    assert with_ending(Path("a.PAL"), choice("jasc"), FORMATS) == Path("a.PAL")


@pytest.mark.parametrize(
    ("name", "wanted"),
    [("Sample", "Sample"), ("Cars/Trucks: 1.2", "Cars_Trucks_ 1.2"), ("../..", "_"), (" . ", "palette")],
)
def test_a_name_makes_no_folder(name: str, wanted: str) -> None:
    assert suggested_file(None, name, ".pdf") == Path.home() / f"{wanted}.pdf"


@pytest.mark.parametrize("format_name", ["ase", "gpl"])
def test_a_flat_format_can_have_three_swatches_of_each_paint(
    swatch, dialogs, tmp_path, qtbot, command, format_name: str
) -> None:
    path = tmp_path / f"out.{format_name}"
    dialogs.path, dialogs.format = path, format_name
    command(swatch, "export")
    qtbot.waitUntil(lambda: "export" in swatch.window.messages.shown())
    offered = dict(swatch.window.messages.shown()["export"].actions)
    offered["Three Swatches per Paint"]()
    qtbot.waitUntil(lambda: "6." in swatch.window.messages.shown()["export"].todo)
    message = swatch.window.messages.shown()["export"]
    assert "without gloss and flakes" in message.todo
    assert "Three Swatches per Paint" not in dict(message.actions)
    dict(message.actions)["Export Anyway"]()
    qtbot.waitUntil(path.exists)
    back = read_palette(path).palette
    three = [entry for entry in back if entry.name.startswith("Silver")]
    assert [entry.name for entry in three] == ["Silver 15°", "Silver 45°", "Silver 110°"]
    lightness = [flat_labs([entry.content])[0][0] for entry in three]
    assert lightness == pytest.approx([75.0, 65.0, 55.0], abs=0.6)
    assert len(back) == 18


def test_a_format_that_holds_paints_offers_no_three_swatches(
    swatch, dialogs, tmp_path, qtbot, command
) -> None:
    dialogs.path, dialogs.format = tmp_path / "out.csv", "csv"
    assert find_format("csv").paints
    command(swatch, "export")
    qtbot.waitUntil(lambda: "export" in swatch.window.messages.shown())
    assert "Three Swatches per Paint" not in dict(swatch.window.messages.shown()["export"].actions)
