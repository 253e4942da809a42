"""Contact sheets from the window: what is shown or selected goes in, as the preview has it; failures are reported."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from brdf_color_swatch.export import contact_sheet
from brdf_color_swatch.export.contact_sheet import ContactSheets, SheetRequest, run_sheet
from brdf_color_swatch.export.sheet_dialog import SheetDialog
from brdf_qt.work.pictures import Pictures
from pypdf import PdfReader
from PySide6.QtCore import Qt
from PySide6.QtPrintSupport import QPrinter
from PySide6.QtTest import QTest

from brdf_suite.documents.palette import Palette
from brdf_suite.errors import SuiteError
from brdf_suite.reports.contact_sheet.page_layout import PageStyle


@pytest.fixture
def part(swatch):
    made = swatch.feature(ContactSheets)
    for box in made.dialog.fields.values():
        box.setChecked(True)
    yield made
    made.dialog.reject()


def names_of(palette: Palette) -> list[str]:
    return [entry.name for entry in palette]


def test_what_is_shown_goes_in_in_its_order_or_what_is_selected(swatch, part, select, command) -> None:
    swatch.window.bar.sort_chosen.emit("lightness")
    command(swatch, "sheet")
    dialog = part.dialog
    assert dialog.shown.isChecked()
    assert dialog.shown.text() == "All 6 shown"
    assert not dialog.selected.isEnabled()
    assert names_of(part.palette()) == ["Black", "Blue", "Red", "Silver", "Orange", "Ice"]
    dialog.reject()
    select(swatch, "Red", "Ice")
    command(swatch, "sheet")
    assert dialog.selected.isChecked()
    assert dialog.selected.text() == "2 selected"
    assert names_of(part.palette()) == ["Red", "Ice"]
    dialog.shown.click()
    assert len(part.palette()) == 6


def test_the_preview_shows_what_is_chosen(swatch, part, command) -> None:
    command(swatch, "sheet")
    dialog = part.dialog
    seen = []

    def changed() -> bool:
        seen.append(dialog.preview.grab().toImage())
        return len(seen) == 1 or seen[-1] != seen[-2]

    assert changed()
    dialog.columns.setFocus()
    dialog.columns.selectAll()
    QTest.keyClicks(dialog.columns, "1")
    assert changed()
    assert dialog.layout_.pages > 1
    assert dialog.count.text() == f"Page 1 of {dialog.layout_.pages}"
    dialog.forward.click()
    assert changed()
    QTest.keyClick(dialog.fields["lab"], Qt.Key.Key_Space)
    assert "lab" not in dialog.style_.fields
    assert changed()
    QTest.keyClicks(dialog.title, " of spring")
    dialog.back.click()
    assert changed()
    assert dialog.layout_.title.endswith("of spring")
    place = dialog.way.findData("landscape")
    dialog.way.setCurrentIndex(place)
    assert changed()


def test_paper_and_content_are_those_of_the_last_sheet(swatch, part, command, qtbot) -> None:
    command(swatch, "sheet")
    part.dialog.page.setCurrentIndex(part.dialog.page.findData("letter"))
    part.dialog.columns.setValue(3)
    part.dialog.fields["figures"].setChecked(False)
    again = SheetDialog(Pictures(part.dialog), part.dialog)
    assert again.style_ == PageStyle("letter", part.dialog.style_.landscape, 3, ("code", "colours", "lab"))
    part.dialog.fields["figures"].setChecked(True)


def test_the_pages_of_the_preview_are_printed(swatch, part, command, tmp_path) -> None:
    command(swatch, "sheet")
    part.dialog.columns.setValue(1)
    pages = part.dialog.layout_.pages
    assert pages > 1
    printer = QPrinter(QPrinter.PrinterMode.HighResolution)
    printer.setOutputFormat(QPrinter.OutputFormat.PdfFormat)
    printer.setOutputFileName(str(tmp_path / "out.pdf"))
    part.print_on(printer)
    assert f"{pages} pages" in swatch.window.messages.shown()["sheet"].what
    assert len(PdfReader(tmp_path / "out.pdf").pages) == pages


def test_a_sheet_is_saved_as_it_was_chosen(
    swatch, part, dialogs, command, tmp_path, monkeypatch, qtbot
) -> None:
    asked: list[SheetRequest] = []

    def draw(request: SheetRequest, _progress) -> Path:
        asked.append(request)
        return request.path

    # The drawing itself is the command's, and tested with it.
    monkeypatch.setattr(contact_sheet, "run_sheet", draw)
    command(swatch, "sheet")
    part.dialog.form.setCurrentIndex(part.dialog.form.findData("panel"))
    dialog = part.dialog
    dialogs.path = tmp_path
    dialog.folder_requested.emit()
    dialog.file.selectAll()
    QTest.keyClicks(dialog.file, "spring")
    assert dialog.path == tmp_path / "spring.pdf"
    dialog.save.click()
    qtbot.waitUntil(lambda: "sheet" in swatch.window.messages.shown())
    (request,) = asked
    assert (request.form, request.path, request.style) == ("panel", tmp_path / "spring.pdf", dialog.style_)
    assert sorted(names_of(request.palette)) == sorted(names_of(swatch.session.palette))
    assert not part.dialog.isVisible()


def test_a_file_that_is_there_is_replaced_only_by_a_button_that_says_so(
    swatch, part, dialogs, command, tmp_path
) -> None:
    (tmp_path / "spring.png").write_bytes(b"old")
    command(swatch, "sheet")
    dialog = part.dialog
    dialog.show_folder(tmp_path)
    for name, word, names in (
        ("summer.png", "Save", tmp_path / "summer.png"),
        ("spring.png", "Replace", tmp_path / "spring.png"),
        ("spring", "Save", tmp_path / "spring.pdf"),
        ("", "Save", None),
        ("..", "Save", None),
        ("sub/spring.pdf", "Save", None),
    ):
        dialog.file.selectAll()
        QTest.keyClick(dialog.file, Qt.Key.Key_Delete)
        QTest.keyClicks(dialog.file, name)
        assert dialog.path == names
        assert dialog.save.text() == word
        assert dialog.save.isEnabled() is (names is not None)
        assert ("replaced" in dialog.note.text()) is (word == "Replace")


def test_a_palette_whose_name_has_a_slash_is_a_file_and_no_folder(swatch, part, command) -> None:
    swatch.session.edit("Rename", lambda palette: replace(palette, name="Cars/Trucks"))
    command(swatch, "sheet")
    assert part.dialog.path == Path.home() / "Cars_Trucks.pdf"


def test_the_command_draws_what_the_window_asks_for(swatch, tmp_path: Path) -> None:
    path, style = tmp_path / "out.pdf", PageStyle("letter", True, 6, ("code", "lab"))
    run_sheet(SheetRequest(swatch.session.palette, path, "booth", "chips", style), lambda _share, _what: None)
    pages = PdfReader(path).pages
    assert (float(pages[0].mediabox.width), float(pages[0].mediabox.height)) == (792.0, 612.0)
    text = "".join(page.extract_text() for page in pages)
    assert "C2" in text
    assert "flop" not in text


def test_what_the_command_refuses_is_said(tmp_path: Path, qapp) -> None:
    request = SheetRequest(Palette("Empty"), tmp_path / "out.png", "nowhere", "sphere", PageStyle())
    with pytest.raises(SuiteError, match="nowhere"):
        run_sheet(request, lambda _share, _what: None)
    assert not (tmp_path / "out.png").exists()
