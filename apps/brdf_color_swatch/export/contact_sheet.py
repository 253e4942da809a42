"""Contact sheets: what the pane shows or what is selected, as a file or on paper.

Files are written by the suite's command in a process of its own, as Designer's reports are: drawing holds the
interpreter.
"""

from __future__ import annotations

import tempfile
from dataclasses import dataclass, replace
from pathlib import Path

from brdf_qt.program.translation import mark, tr
from brdf_qt.window.message_bar import Message, message_of
from brdf_qt.work.command_process import run_command
from PySide6.QtGui import QPageLayout, QPageSize, QPainter
from PySide6.QtPrintSupport import QPrintDialog, QPrinter

from brdf_color_swatch.export.palette_export import suggested_file
from brdf_color_swatch.export.sheet_dialog import ENDINGS, SheetDialog, SheetSource
from brdf_color_swatch.export.sheet_page import paint_page
from brdf_color_swatch.feature import SwatchFeature
from brdf_color_swatch.session import PaletteSession
from brdf_color_swatch.window import SwatchWindow
from brdf_suite.documents.palette import Palette
from brdf_suite.documents.palette_store import PALETTE_ENDING, save_palette
from brdf_suite.errors import SuiteError
from brdf_suite.progress import Progress
from brdf_suite.reports.contact_sheet.page_layout import PageStyle

_KEY = "sheet"
_CELL = (512, 512)
_PAPERS = {
    "a4": QPageSize.PageSizeId.A4,
    "a3": QPageSize.PageSizeId.A3,
    "letter": QPageSize.PageSizeId.Letter,
}


@dataclass(frozen=True, eq=False)
class SheetRequest:
    """A sheet to be drawn: its paints and file, the light and form of the pictures, and the paper."""

    palette: Palette
    path: Path
    environment: str
    form: str
    style: PageStyle


def run_sheet(request: SheetRequest, progress: Progress) -> Path:
    """Draw a sheet and return its file.

    Raises
    ------
    SuiteError
        What the command printed, or its exit status.
    Cancelled
        The progress callback asked for it; an old file stays.
    """
    style = request.style
    with tempfile.TemporaryDirectory(prefix="brdf-sheet-") as folder:
        source = Path(folder) / f"palette{PALETTE_ENDING}"
        save_palette(request.palette, source)
        words = ["sheet", str(source), "-o", str(request.path), "--size", "x".join(map(str, _CELL))]
        words += ["--environment", request.environment, "--form", request.form, "--page", style.page]
        words += ["--columns", str(style.columns), f"--show={','.join(style.fields)}"]
        words += ["--landscape"] if style.landscape else []
        # Where a paint could not be drawn, its reason stands in its place.
        run_command(words, lambda fraction, _what: progress(fraction, request.path.name))
    return request.path


class ContactSheets(SwatchFeature):
    """Commands that make contact sheets of what the pane in front shows."""

    def __init__(self, session: PaletteSession, window: SwatchWindow) -> None:
        super().__init__(session, window)
        self._sheet = window.add_command(
            "file", mark("Contact S&heet…"), "print", self.open, "sheet", icon="printer",
            tip=mark("Save or print the visible or selected swatches with their figures"),
        )  # fmt: skip
        window.toolbar.addAction(self._sheet)
        self._dialog: SheetDialog | None = None
        self._enable_always()

    @property
    def dialog(self) -> SheetDialog:
        """The dialog, made when it is first opened."""
        if self._dialog is None:
            self._dialog = SheetDialog(self._window.pictures, self._window)
            self._dialog.save_requested.connect(self.save)
            self._dialog.print_requested.connect(self.print)
            self._dialog.folder_requested.connect(self.ask_folder)
        return self._dialog

    def open(self) -> None:
        """Show the dialog for what the pane in front shows and what is selected of it."""
        session = self._session
        palette, shown = session.palette, session.shown[session.front]
        if palette is None or not shown.places:
            return
        chosen = set(session.selected)
        selected = tuple(place for place in shown.places if shown.rows.ids[place] in chosen)
        grouped = session.state.keeps_order
        source = SheetSource(
            palette.name, shown.rows, tuple(shown.places), selected, grouped, session.look.booth
        )
        self.dialog.open_for(
            source, session.look.form, suggested_file(session.item, palette.name, ENDINGS[0])
        )

    def ask_folder(self) -> None:
        """Ask in which folder the sheet is saved."""
        path = self.dialog.path
        dialogs = self._session.library.dialogs.over(self.dialog)
        folder = dialogs.folder_path(
            tr("Folder of the Contact Sheet"), Path.home() if path is None else path.parent
        )
        if folder is not None:
            self.dialog.show_folder(folder.absolute())

    def palette(self) -> Palette | None:
        """Return what the dialog has chosen, as a palette in that order."""
        palette, dialog, shown = self._session.palette, self.dialog, self._session.shown[self._session.front]
        if palette is None:
            return None
        entries = [shown.rows.entries[place] for place in dialog.places]
        if not self._session.state.keeps_order:
            entries = [replace(entry, group=()) for entry in entries]
        name = dialog.title.text().strip() or palette.name
        return Palette(name, tuple(entries), notes=palette.notes)

    def save(self) -> None:
        """Write the sheet to the file that the dialog names."""
        chosen, path = self.palette(), self.dialog.path
        if chosen is not None and path is not None:
            self.dialog.accept()
            form, style = self.dialog.form.currentData(), self.dialog.style_
            self._submit(SheetRequest(chosen, path.absolute(), self._session.look.booth, form, style))

    def print(self) -> None:
        """Ask for a printer and print the pages of the preview."""
        printer = QPrinter(QPrinter.PrinterMode.HighResolution)
        printer.setDocName(self.dialog.title.text())
        style = self.dialog.style_
        ways = QPageLayout.Orientation
        printer.setPageSize(QPageSize(_PAPERS[style.page]))
        printer.setPageOrientation(ways.Landscape if style.landscape else ways.Portrait)
        dialog = QPrintDialog(printer, self.dialog)
        dialog.setWindowTitle(tr("Print Contact Sheet"))
        if dialog.exec() == QPrintDialog.DialogCode.Accepted:
            self.print_on(printer)
            self.dialog.accept()
        dialog.deleteLater()

    def print_on(self, printer: QPrinter) -> None:
        """Print the pages of the preview on a QPrinter."""
        layout = self.dialog.layout_
        if layout is None:
            return
        printer.setFullPage(True)
        painter = QPainter()
        if not painter.begin(printer):
            self._failed(SuiteError(tr("The printer did not respond. Check it and print again.")))
            return
        width, height = layout.style.size
        for page in range(layout.pages):
            if page:
                printer.newPage()
            room = painter.viewport()
            scale = min(room.width() / width, room.height() / height)
            painter.save()
            painter.translate(0.5 * (room.width() - scale * width), 0.5 * (room.height() - scale * height))
            painter.scale(scale, scale)
            paint_page(painter, layout, page, self.dialog.texts, self.dialog.picture)
            painter.restore()
        painter.end()
        self._done(tr("Printed: {count} pages").format(count=layout.pages), "")

    def _submit(self, request: SheetRequest) -> None:
        self._show(0.0, "")
        self._session.library.tasks.submit(
            _KEY,
            run_sheet,
            request,
            lambda path: self._done(tr("Saved: {name}").format(name=path.name), str(path)),
            self._failed,
            self._show,
        )

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
        self._sheet.setEnabled(bool(self._session.shown[self._session.front].places))
