"""The window: the view in three dimensions, the legend beside it, plots below, the inspector at the right."""

from __future__ import annotations

from functools import partial

from brdf_qt.fields.form import described, fill_column
from brdf_qt.fields.labels import PlainLabel
from brdf_qt.program.translation import mark, tr
from brdf_qt.window.main_window import SuiteWindow
from brdf_qt.window.shortcuts import sequences
from PySide6.QtCore import Qt
from PySide6.QtGui import QShortcut
from PySide6.QtWidgets import QSplitter, QWidget

from brdf_lobe_visualizer.plot_row import PlotRow

_VIEW_WIDTH = 400


class LobeWindow(SuiteWindow):
    """The window of Lobe Visualizer; parts add to it by the ``add_`` methods and :meth:`set_centre`."""

    def __init__(self) -> None:
        super().__init__("Lobe Visualizer")
        self.paint_menu.setTitle(tr("&Reflectance"))
        self.menus["reflectance"] = self.paint_menu
        absent = described(
            PlainLabel(tr("No 3-D view"), alignment=Qt.AlignmentFlag.AlignCenter), name="no_view"
        )
        self.plots = PlotRow()
        self.top_split = QSplitter(Qt.Orientation.Horizontal)
        self.centre_split = QSplitter(Qt.Orientation.Vertical)
        self.top_split.addWidget(absent)
        self.centre_split.addWidget(self.top_split)
        self.centre_split.addWidget(self.plots)
        self.centre_split.setStretchFactor(0, 3)
        self.centre_split.setStretchFactor(1, 2)
        for name, split in (("top_split", self.top_split), ("centre_split", self.centre_split)):
            split.setObjectName(name)
            split.setHandleWidth(8)
            split.setChildrenCollapsible(False)
        centre = QWidget()
        fill_column(centre, self.centre_split, margins=(8, 4, 8, 8))
        super().set_centre(centre)
        self.float_over(self.top_split)
        ask = partial(self.open_requested.emit, None)
        self.toolbar.addAction(self.add_action(self.file_menu, mark("&Open…"), ask, "open", "folder-open"))
        self.add_recent_menu()

    def set_centre(self, widget: QWidget, *, tab_hides_panels: bool = False) -> None:
        """Put the view in three dimensions into its place; with ``tab_hides_panels`` Tab on it toggles the panels."""
        before = self.top_split.replaceWidget(0, widget)
        if before is not None:
            before.deleteLater()
        self.top_split.setStretchFactor(0, 1)
        widget.show()
        if tab_hides_panels:
            shortcut = QShortcut(sequences("panels_of_picture")[0], widget)
            shortcut.setContext(Qt.ShortcutContext.WidgetWithChildrenShortcut)
            shortcut.activated.connect(self.toggle_panels)

    def complete(self) -> None:
        """Settle what depends on every part: size and place of the panels."""
        self._lay_out()
        self.restore_layout()

    def reset_layout(self) -> None:
        """Put panels, plots and their sizes back where a first start has them."""
        super().reset_layout()
        self.plots.reset()
        self._lay_out()

    def _lay_out(self) -> None:
        beside = [self.top_split.widget(place) for place in range(1, self.top_split.count())]
        widths = [widget.sizeHint().width() for widget in beside if widget is not None]
        self.top_split.setSizes([max(self.width() - sum(widths), _VIEW_WIDTH), *widths])
        self.centre_split.setSizes([3 * self.height() // 5, 2 * self.height() // 5])
        self.plots.even()
