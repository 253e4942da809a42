"""Contact sheets from the window: what is shown goes in, page by page on paper, and failures are reported."""

from __future__ import annotations

import tempfile
from dataclasses import replace
from pathlib import Path
from time import sleep

import pytest
from brdf_color_swatch.export import sheet_part
from brdf_color_swatch.export.sheet_part import SheetPart, SheetRequest, run_sheets
from PySide6.QtGui import QImage
from PySide6.QtPrintSupport import QPrinter

from brdf_suite.documents.palette import Palette
from brdf_suite.errors import SuiteError


@pytest.fixture
def part(swatch):
    return swatch.feature(SheetPart)


def test_what_is_shown_goes_in_in_its_order_or_the_several_selected(swatch, part, select) -> None:
    swatch.window.bar.sort_chosen.emit("lightness")
    whole = part.shown_palette()
    assert [entry.name for entry in whole] == ["Black", "Blue", "Red", "Silver", "Orange", "Ice"]
    select(swatch, "Red", "Ice")
    assert [entry.name for entry in part.shown_palette()] == ["Red", "Ice"]


def test_pages_are_printed_one_after_the_other(swatch, part, tmp_path, monkeypatch, qtbot) -> None:
    asked: list[SheetRequest] = []

    def draw(request: SheetRequest, _progress) -> tuple[Path, ...]:
        asked.append(request)
        for _, path in request.pages:
            image = QImage(40, 30, QImage.Format.Format_RGB32)
            image.fill(0xFF336699)
            image.save(str(path))
        return tuple(path for _, path in request.pages)

    # The drawing itself is the command's, and tested with it.
    monkeypatch.setattr(sheet_part, "run_sheets", draw)
    monkeypatch.setattr(sheet_part, "_PRINTED_ROWS", 1)
    printer = QPrinter(QPrinter.PrinterMode.ScreenResolution)
    printer.setOutputFormat(QPrinter.OutputFormat.PdfFormat)
    printer.setOutputFileName(str(tmp_path / "out.pdf"))
    part.print_on(swatch.session.palette, printer)
    assert swatch.window.progress.jobs == ("sheet",)
    qtbot.waitUntil(lambda: "sheet" in swatch.window.messages.shown())
    assert "2 pages" in swatch.window.messages.shown()["sheet"].what
    assert swatch.window.progress.jobs == ()
    assert [len(palette) for palette, _ in asked[0].pages] == [4, 2]
    assert (tmp_path / "out.pdf").read_bytes().startswith(b"%PDF")
    assert not any(path.exists() for _, path in asked[0].pages)


@pytest.mark.parametrize("cancelled", [False, True])
def test_nothing_of_the_pages_stays_where_they_are_not_printed(
    swatch, part, tmp_path, monkeypatch, qtbot, cancelled: bool
) -> None:
    made: list[Path] = []

    def draw(request: SheetRequest, progress) -> tuple[Path, ...]:
        path = request.pages[0][1]
        path.write_bytes(b"half")
        made.append(path)
        while cancelled:
            progress(0.5, "")
            sleep(0.005)
        raise SuiteError("no ink")

    monkeypatch.setattr(sheet_part, "run_sheets", draw)
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    part.print_on(swatch.session.palette, QPrinter(QPrinter.PrinterMode.ScreenResolution))
    qtbot.waitUntil(lambda: bool(made))
    if cancelled:
        swatch.library.tasks.cancel("sheet")
        swatch.window.progress.end_job("sheet")
    else:
        qtbot.waitUntil(lambda: "sheet" in swatch.window.messages.shown())
    qtbot.waitUntil(lambda: not made[0].parent.exists())
    assert list(tmp_path.glob("brdf-print-*")) == []


def test_a_palette_whose_name_has_a_slash_is_a_file_and_no_folder(swatch, part, dialogs, monkeypatch) -> None:
    swatch.session.edit("Rename", lambda palette: replace(palette, name="Cars/Trucks"))
    suggested: list[Path] = []
    monkeypatch.setattr(dialogs, "save_path", lambda path, _filters: suggested.append(path), raising=False)
    part.export()
    assert suggested == [Path.home() / "Cars_Trucks.pdf"]


def test_what_the_command_refuses_is_said(tmp_path: Path, qapp) -> None:
    request = SheetRequest(((Palette("Empty"), tmp_path / "out.png"),), "nowhere", "sphere")
    with pytest.raises(SuiteError, match="nowhere"):
        run_sheets(request, lambda _share, _what: None)
    assert not (tmp_path / "out.png").exists()
