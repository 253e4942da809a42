"""Search by colour: the nearest to a swatch, to the paint being edited, or to numbers; and similar ones at once."""

from __future__ import annotations

from dataclasses import replace

from brdf_qt.program.translation import mark, tr
from PySide6.QtGui import QGuiApplication

from brdf_color_swatch.editing.paint_files import take_data
from brdf_color_swatch.editing.transfer import Carried
from brdf_color_swatch.feature import SwatchFeature
from brdf_color_swatch.grid.view_state import Near
from brdf_color_swatch.session import PaletteSession
from brdf_color_swatch.window import SwatchWindow
from brdf_suite.documents.palette import Entry
from brdf_suite.errors import SuiteError
from brdf_suite.palettes.columns import Columns


def near_of(entry: Entry) -> Near:
    """Return what is searched for where the nearest to an entry are wanted."""
    lab = Columns.of((entry,)).main[0]
    rows = [tuple(float(value) for value in reading) for reading in lab]
    return Near(entry.name or entry.code or tr("(no name)"), tuple(rows))  # type: ignore[arg-type]  # three by three


class ColourSearch(SwatchFeature):
    """Commands that search by colour. They search the whole palette that is shown, without its groups."""

    def __init__(self, session: PaletteSession, window: SwatchWindow) -> None:
        super().__init__(session, window)
        add = window.add_command
        self._near = add(
            "paint", mark("Find &Nearest"), "find_nearest", self.find, "nearest", icon="crosshair",
            tip=mark("Sort by mean ΔE00 over 15°, 45° and 110° to the selected swatch"),
        )  # fmt: skip
        self._other = add(
            "paint", mark("Find Nearest in &Other Pane"), None, self.find_other, "nearest_other",
            tip=mark("Sort the other pane by mean ΔE00 to the swatch selected here"),
        )  # fmt: skip
        self._clipboard = add(
            "paint", mark("Find Nearest to Clip&board"), None, self.find_clipboard, "nearest_clipboard",
            tip=mark("Sort by mean ΔE00 to the paint, colour or L*a*b* values on the clipboard"),
        )  # fmt: skip
        window.menus["paint"].addSeparator()
        window.toolbar.addAction(self._near)
        self._enable_always()

    def find(self) -> None:
        entries = self._session.selected_entries
        if entries:
            self.find_near(near_of(entries[0]))

    def find_other(self) -> None:
        entries = self._session.selected_entries
        if entries and self._window.has_two_panes:
            self.find_near(near_of(entries[0]), 1 - self._session.front)

    def find_clipboard(self) -> None:
        pane = self._session.front

        def failed(error: Exception) -> None:
            self._session.library.fails(error, "edit", tr("The order is unchanged."))

        def take(carried: Carried) -> None:
            if carried.entries:
                self.find_near(near_of(carried.entries[0]), pane)
            else:
                failed(SuiteError(tr("The clipboard contains no swatch, paint or colour.")))

        take_data(QGuiApplication.clipboard().mimeData(), self._session.reading, take, failed)

    def find_near(self, near: Near, pane: int | None = None) -> None:
        pane = self._session.front if pane is None else pane
        state = self._session.states[pane]
        self._session.set_state(replace(state, near=near, duplicates=None, sort="nearest"), pane)
        view = self._window.panes[pane]
        if pane == self._session.front and view.model.rowCount():
            self._session.reveal((view.model.id_at(0),), pane)

    def _enable(self) -> None:
        some = bool(self._session.selected)
        self._near.setEnabled(some)
        self._other.setEnabled(some and self._window.has_two_panes)
        self._clipboard.setEnabled(self._session.palette is not None)
