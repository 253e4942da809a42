"""The list of all that comes with the program and of opened palettes, with pictures of the paints: found by a word, put
in the session by Enter.
"""

from __future__ import annotations

from collections.abc import Sequence

from brdf_qt.choosing.thumbnails import Thumbnails
from brdf_qt.fields.form import described, fill_column, row_of
from brdf_qt.fields.labels import PlainLabel, plain_tip
from brdf_qt.program.translation import mark, tr
from brdf_qt.work.timer import make_timer
from PySide6.QtCore import QEvent, QObject, QSize, Qt, Signal
from PySide6.QtGui import QIcon, QKeyEvent, QShowEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QLineEdit,
    QPushButton,
    QTreeWidget,
    QTreeWidgetItem,
    QWidget,
)

from brdf_suite.foreign_text import make_visible

_ORIGIN = Qt.ItemDataRole.UserRole
PICTURE = 40
"""Width and height of a picture in the list, points."""
_SOON_MS = 30
"""After the last step of a scroll; what only flies by is not drawn."""
_GROUPS = {
    "paints": mark("Sample paints"),
    "table_1": mark("Measured paints of Table 1"),
    "models": mark("Models"),
}


class SourcesPanel(QWidget):
    """Groups of names. Signals: ``open_requested(list[str])`` with what :func:`open_source` takes."""

    open_requested = Signal(object)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._filled = False
        self._thumbnails: Thumbnails | None = None
        self._soon = make_timer(self, self._request, _SOON_MS)
        self.names: dict[str, Sequence[tuple[str, str]]] = {}
        """Title and name of what comes with the program, by group; empty until it is filled."""
        text = tr("Search paints and models by name")
        self.query = described(QLineEdit(placeholderText=text), spoken=text)
        self.query.setClearButtonEnabled(True)
        self.query.textChanged.connect(self._filter)
        self.query.returnPressed.connect(self._take)
        self.tree = described(QTreeWidget(), spoken=tr("Available reflectances"))
        self.tree.setHeaderHidden(True)
        self.tree.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        self.tree.setIconSize(QSize(PICTURE, PICTURE))
        self.tree.verticalScrollBar().valueChanged.connect(lambda _value: self._soon.start())
        self.tree.viewport().installEventFilter(self)
        for folded in (self.tree.itemExpanded, self.tree.itemCollapsed):
            folded.connect(lambda _item: self._soon.start())
        self.tree.itemActivated.connect(lambda item, _column: self._ask([item]))
        tip = tr("Add the selected reflectances to the legend (Enter or double click)")
        add = described(QPushButton(tr("Show")), tip=tip)
        add.clicked.connect(self._take)
        self.no_match = PlainLabel(tr("No reflectance matches."), margin=8)
        self.no_match.hide()
        parts = (self.query, self.no_match, self.tree, row_of(None, add))
        fill_column(self, *parts, grows=self.tree, margins=(8, 8, 8, 8))
        self.setMinimumWidth(180)

    def set_thumbnails(self, thumbnails: Thumbnails) -> None:
        """Show pictures from here; those in sight are made first."""
        self._thumbnails = thumbnails
        thumbnails.arrived.connect(self._show_pictures)
        for group in self._groups():
            self._add_pictures(group)
        self._soon.start()

    def fill(self) -> None:
        if self._filled:
            return
        self._filled = True
        # Deferred: with it come the tables and models, and the list is hidden at a first start.
        from brdf_lobe_visualizer.subjects.sources import names

        self.names = names()
        for key, group in self.names.items():
            self._add_group(tr(_GROUPS[key]), group)

    def add_plugin_models(self, models: Sequence[tuple[str, str]]) -> None:
        """Put in the models of plug-ins, each a title and a name."""
        if models:
            self._add_group(tr("Models of plug-ins"), models)

    def add_palette(self, title: str, entries: Sequence[tuple[str, str]]) -> None:
        """Put in the entries of a palette, in the place of one of the same title; each a name and an origin."""
        self.fill()
        for place in reversed(range(self.tree.topLevelItemCount())):
            group = self.tree.topLevelItem(place)
            if group is not None and group.text(0) == title:
                self.tree.takeTopLevelItem(place)
        self._add_group(title, entries)

    def showEvent(self, event: QShowEvent) -> None:
        self.fill()
        self._soon.start()
        super().showEvent(event)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Have the pictures made that come in sight as the list grows."""
        if event.type() == QEvent.Type.Resize:
            self._soon.start()
        return super().eventFilter(watched, event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Go from the field into the list by the arrow keys."""
        if event.key() == Qt.Key.Key_Down and self.query.hasFocus():
            self.tree.setFocus()
            return
        super().keyPressEvent(event)

    def _add_group(self, title: str, names: Sequence[tuple[str, str]]) -> None:
        group = QTreeWidgetItem([make_visible(title)])
        group.setFlags(Qt.ItemFlag.ItemIsEnabled)
        for name, origin in names:
            item = QTreeWidgetItem([make_visible(name)])
            item.setData(0, _ORIGIN, origin)
            item.setToolTip(0, plain_tip(origin))
            group.addChild(item)
        self.tree.addTopLevelItem(group)
        self._add_pictures(group)
        group.setExpanded(True)
        self._filter(self.query.text())

    def _filter(self, text: str) -> None:
        words = text.casefold().split()
        found = 0
        for group in self._groups():
            shown = 0
            for item in _children(group):
                name = f"{item.text(0)} {item.data(0, _ORIGIN)}".casefold()
                item.setHidden(not all(word in name for word in words))
                shown += not item.isHidden()
            group.setHidden(shown == 0)
            found += shown
        self._soon.start()
        self.no_match.setVisible(self._filled and found == 0)

    def _add_pictures(self, group: QTreeWidgetItem) -> None:
        """Give each line its place for a picture, with what stands for it until it is there."""
        if self._thumbnails is not None:
            for item in _children(group):
                item.setIcon(0, QIcon(self._thumbnails.picture(str(item.data(0, _ORIGIN)))))

    def _in_sight(self) -> list[QTreeWidgetItem]:
        area = self.tree.viewport().rect()
        lines = [item for group in self._groups() if group.isExpanded() for item in _children(group)]
        return [
            item for item in lines if not item.isHidden() and self.tree.visualItemRect(item).intersects(area)
        ]

    def _request(self) -> None:
        if self._thumbnails is not None:
            seen = self._in_sight() if self.isVisible() else []
            self._thumbnails.request("list", [(str(item.data(0, _ORIGIN)), None) for item in seen])
            self._show_pictures()

    def _show_pictures(self) -> None:
        if self._thumbnails is not None and self.isVisible():
            for item in self._in_sight():
                item.setIcon(0, QIcon(self._thumbnails.picture(str(item.data(0, _ORIGIN)))))

    def _take(self) -> None:
        chosen = [item for item in self.tree.selectedItems() if not item.isHidden()]
        visible = (item for group in self._groups() for item in _children(group) if not item.isHidden())
        self._ask(chosen or list(visible)[:1])

    def _groups(self) -> list[QTreeWidgetItem]:
        rows = [self.tree.topLevelItem(place) for place in range(self.tree.topLevelItemCount())]
        return [row for row in rows if row is not None]

    def _ask(self, items: Sequence[QTreeWidgetItem]) -> None:
        origins = [item.data(0, _ORIGIN) for item in items if item.data(0, _ORIGIN)]
        if origins:
            self.open_requested.emit(origins)


def _children(group: QTreeWidgetItem) -> list[QTreeWidgetItem]:
    rows = [group.child(index) for index in range(group.childCount())]
    return [row for row in rows if row is not None]
