"""Contact sheets: what the pane shows, each with its figures, as a file or on paper.

They are drawn by the suite's command in a process of its own, as Designer's reports are: drawing holds the interpreter.
"""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from brdf_qt.program.translation import mark, tr
from brdf_qt.window.message_bar import Message, message_of
from brdf_qt.work.command_process import run_command
from brdf_qt.work.tasks import Work
from PySide6.QtCore import QRectF
from PySide6.QtGui import QImage, QPainter
from PySide6.QtPrintSupport import QPrintDialog, QPrinter

from brdf_color_swatch.export.palette_export import suggested_file
from brdf_color_swatch.feature import SwatchFeature
from brdf_color_swatch.session import PaletteSession
from brdf_color_swatch.window import SwatchWindow
from brdf_suite.documents.palette import Palette
from brdf_suite.documents.palette_store import PALETTE_ENDING, save_palette
from brdf_suite.errors import SuiteError
from brdf_suite.progress import Progress

Done = Callable[[Any], None]

_KEY = "sheet"
_CELL = (240, 180)
_PRINTED_COLUMNS, _PRINTED_ROWS = 4, 5


@dataclass(frozen=True, eq=False)
class SheetRequest:
    """Pages to be drawn: the palette of each, its file, and the light and form of all."""

    pages: tuple[tuple[Palette, Path], ...]
    environment: str
    surface: str
    columns: int | None = None


def run_sheets(request: SheetRequest, progress: Progress) -> tuple[Path, ...]:
    """Draw the pages one after the other and return their files.

    Raises
    ------
    SuiteError
        What the command printed, or its exit status.
    Cancelled
        The progress callback asked for it; old files stay.
    """
    for number, (palette, path) in enumerate(request.pages):
        with tempfile.TemporaryDirectory(prefix="brdf-sheet-") as folder:
            source = Path(folder) / f"palette{PALETTE_ENDING}"
            save_palette(palette, source)
            words = ["sheet", str(source), "-o", str(path), "--size", "x".join(map(str, _CELL))]
            words += ["--environment", request.environment, "--mesh", request.surface]
            if request.columns is not None:
                words += ["--columns", str(request.columns)]

            def page(fraction: float, _what: str, number: int = number, name: str = path.name) -> None:
                progress((number + fraction) / len(request.pages), name)

            # Where a paint could not be drawn, its reason stands in its place.
            run_command(words, page)
    return tuple(path for _, path in request.pages)


def draw_pages(request: SheetRequest, progress: Progress) -> tuple[bytes, ...]:
    """Render pages and return the content of their files; errors as :func:`run_sheets`.

    The files are temporary and are removed in any case.
    """
    with tempfile.TemporaryDirectory(prefix="brdf-print-") as folder:
        pages = tuple((palette, Path(folder) / path.name) for palette, path in request.pages)
        return tuple(path.read_bytes() for path in run_sheets(replace(request, pages=pages), progress))


class ContactSheets(SwatchFeature):
    """Commands that make contact sheets of what the pane in front shows."""

    def __init__(self, session: PaletteSession, window: SwatchWindow) -> None:
        super().__init__(session, window)
        self._sheet = window.add_command(
            "file", mark("Contact S&heet…"), None, self.export, "sheet",
            tip=mark("Save the visible or selected swatches with figures as PDF or PNG"),
        )  # fmt: skip
        self._print = window.add_command(
            "file", mark("&Print Contact Sheet…"), "print", self.print_sheet, "print", icon="printer"
        )
        self._enable_always()

    def export(self) -> None:
        shown = self.shown_palette()
        if shown is None:
            return
        path = self._session.library.dialogs.save_path(
            suggested_file(self._session.item, shown.name, ".pdf"), tr("Sheets (*.pdf *.png)")
        )
        if path is not None:
            self.draw(shown, path.absolute())

    def draw(self, palette: Palette, path: Path) -> None:
        self._submit(
            run_sheets,
            ((palette, path),),
            None,
            lambda _paths: self._done(tr("Saved: {name}").format(name=path.name), str(path)),
        )

    def shown_palette(self) -> Palette | None:
        """Return what the pane in front shows, or what is selected of it, as a palette in that order."""
        session = self._session
        palette, shown = session.palette, session.shown[session.front]
        if palette is None or not shown.places:
            return None
        chosen = set(session.selected)
        entries = [shown.rows.entries[place] for place in shown.places]
        if len(chosen) > 1:
            entries = [entry for entry in entries if entry.id in chosen]
        if not session.state.keeps_order:
            entries = [replace(entry, group=()) for entry in entries]
        return Palette(palette.name, tuple(entries), notes=palette.notes)

    def print_sheet(self) -> None:
        shown = self.shown_palette()
        if shown is None:
            return
        printer = QPrinter(QPrinter.PrinterMode.HighResolution)
        printer.setDocName(shown.name)
        dialog = QPrintDialog(printer, self._window)
        dialog.setWindowTitle(tr("Print Contact Sheet"))
        if dialog.exec() == QPrintDialog.DialogCode.Accepted:
            self.print_on(shown, printer)
        dialog.deleteLater()

    def print_on(self, palette: Palette, printer: QPrinter) -> None:
        """Draw a palette in pages and print them on a QPrinter."""
        each = _PRINTED_COLUMNS * _PRINTED_ROWS
        pages = []
        for number, start in enumerate(range(0, len(palette), each), 1):
            part = palette.entries[start : start + each]
            pages.append((replace(palette, entries=part, groups=()), Path(f"page{number}.png")))
        self._submit(draw_pages, tuple(pages), _PRINTED_COLUMNS, lambda drawn: self._printed(drawn, printer))

    def _printed(self, pages: tuple[bytes, ...], printer: QPrinter) -> None:
        painter = QPainter()
        if not painter.begin(printer):
            self._failed(SuiteError(tr("The printer did not respond. Check it and print again.")))
            return
        for number, page in enumerate(pages):
            if number:
                printer.newPage()
            picture = QImage.fromData(page)
            room = QRectF(painter.viewport())
            scale = min(room.width() / picture.width(), room.height() / picture.height())
            wide, high = picture.width() * scale, picture.height() * scale
            painter.drawImage(QRectF((room.width() - wide) / 2, 0, wide, high), picture)
        painter.end()
        self._done(tr("Printed: {count} pages").format(count=len(pages)), "")

    def _submit(
        self, work: Work, pages: tuple[tuple[Palette, Path], ...], columns: int | None, done: Done
    ) -> None:
        look = self._session.look
        surface = look.form if look.form in ("sphere", "panel") else "panel"
        self._show(0.0, "")
        request = SheetRequest(pages, look.booth, surface, columns)
        self._session.library.tasks.submit(_KEY, work, request, done, self._failed, self._show)

    def _show(self, share: float, what: str) -> None:
        text = (
            tr("Rendering contact sheet: {name}").format(name=what) if what else tr("Rendering contact sheet")
        )
        self._window.progress.set_job(_KEY, share, text, lambda: self._session.library.tasks.cancel(_KEY))

    def _done(self, what: str, where: str) -> None:
        self._window.progress.end_job(_KEY)
        self._window.show_message(Message(_KEY, what, where=where))

    def _failed(self, error: Exception) -> None:
        self._window.progress.end_job(_KEY)
        self._window.show_message(message_of(error, _KEY, todo=tr("The palette is unchanged.")))

    def _enable(self) -> None:
        for action in (self._sheet, self._print):
            action.setEnabled(bool(self._session.shown[self._session.front].places))
