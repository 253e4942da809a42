"""The window of Color Swatch: library at the left, swatches in one or two panes, inspector at the right."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from pathlib import Path

from brdf_qt.fields.form import described, fill_column, row_of
from brdf_qt.program.translation import mark, tr
from brdf_qt.window.main_window import SuiteWindow
from brdf_qt.work.pictures import Pictures
from PySide6.QtCore import QPoint, Qt, Signal
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QMenu, QSplitter, QToolButton, QWidget

from brdf_color_swatch.grid.pane import Pane
from brdf_color_swatch.library.tree import LibraryTree
from brdf_color_swatch.panels.palette import PalettePanel
from brdf_color_swatch.panels.swatch import SwatchPanel
from brdf_color_swatch.panels.top_bar import TopBar
from brdf_color_swatch.search.filters import FiltersPanel
from brdf_suite.foreign_text import make_visible


class SwatchWindow(SuiteWindow):
    """The window of Color Swatch. Signal: ``second_pane_requested(shown)``."""

    second_pane_requested = Signal(bool)

    def __init__(self, lights: list[str]) -> None:
        super().__init__("Color Swatch")
        self.tree = LibraryTree()
        self.bar = TopBar(lights)
        self.picture_of: Callable[[int, int], object] = lambda _pane, _row: None
        """Set by what draws pictures: a QPixmap or None for a row of a pane."""
        self.pictures = Pictures(self)
        self.panes = tuple(Pane(number, lambda pane, row: self.picture_of(pane, row)) for number in (0, 1))
        self.swatch, self.palette_panel, self.filters = SwatchPanel(), PalettePanel(), FiltersPanel()
        self.pane_split = described(QSplitter(Qt.Orientation.Horizontal), name="pane_split")
        self.pane_split.setHandleWidth(8)
        self.pane_split.setChildrenCollapsible(False)
        for pane in self.panes:
            self.pane_split.addWidget(pane)
        self.panes[1].hide()
        centre, library = QWidget(), QWidget()
        fill_column(centre, self.bar, self.pane_split, grows=self.pane_split, spacing=0)
        self.set_centre(centre)
        self.float_over(self.pane_split)
        self.library_buttons = row_of(margins=(8, 4, 8, 4))
        fill_column(library, self.library_buttons, self.tree, grows=self.tree, spacing=0)
        self.library_dock = self.add_panel(mark("Library"), library, Qt.DockWidgetArea.LeftDockWidgetArea)
        self.tree.setMinimumWidth(168)
        self.add_section("swatch", tr("Swatch"), self.swatch)
        self.add_section("filters", tr("Filters"), self.filters, is_open=False)
        self.add_section("palette", tr("Palette or Group"), self.palette_panel, is_open=False)
        cells = self.status
        self.count_cell = cells.cell(mark("Swatches"), tr("Swatches shown and selected"))
        self.picture_cell = cells.cell(mark("Pictures"), tr("Visible pictures still pending"))
        self.note_cell = cells.cell(mark("Note"), tr("Notes on the colours shown"), elastic=True)
        self.link_cell = cells.cell(mark("Link"), tr("Connected programs of the suite"), right=True)

    def complete(self) -> None:
        """End the File menu, and take up size and panels of the last time; after all parts are there."""
        self.add_quit()
        self.restore_layout()

    def show_title(self, title: str, path: Path | None, *, clean: bool) -> None:
        self.setWindowTitle(f"{make_visible(title)}[*]" if title else "[*]")
        self.setWindowFilePath(str(path) if path is not None else "")
        self.setWindowModified(not clean)

    @property
    def has_two_panes(self) -> bool:
        return not self.panes[1].isHidden()

    def show_second(self, shown: bool) -> None:
        self.panes[1].setVisible(shown)
        if shown:
            half = max(1, self.pane_split.width() // 2)
            self.pane_split.setSizes([half, half])

    def add_library_button(self, action: QAction) -> None:
        button = described(QToolButton(), spoken=action.text().replace("&", ""))
        button.setDefaultAction(action)
        button.setAutoRaise(True)
        button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonIconOnly)
        self.library_buttons.addWidget(button)

    def open_menu(self, keys: Iterable[str], point: QPoint, name: str = "") -> None:
        """Open a menu of commands by their keys at a point of the screen; an empty key is a line between groups."""
        menu = described(QMenu(self), name=name)
        for key in keys:
            action = self.command(key) if key else None
            if action is not None:
                menu.addAction(action)
            elif not key:
                menu.addSeparator()
        menu.popup(point)

    def fit_inspector(self) -> None:
        """Give the inspector what it wants, and the library a sixth of the window at most a fourth."""
        super().fit_inspector()
        wanted = max(160, min(240, round(0.18 * self.width())))
        self.resizeDocks([self.library_dock], [wanted], Qt.Orientation.Horizontal)
