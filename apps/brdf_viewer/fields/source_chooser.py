"""A choice among shipped things and files: a list, and a button for a file that is not in it."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from brdf_qt.fields.labels import plain_tip
from brdf_qt.fields.quiet import QuietComboBox
from brdf_qt.program.icons import icon
from brdf_qt.program.translation import tr
from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QComboBox, QHBoxLayout, QToolButton, QWidget


@dataclass(frozen=True)
class Source:
    """One entry: ``key`` is what is loaded (a shipped name or a path), ``title`` what is shown."""

    key: str
    title: str


def title_of(key: str, titles: dict[str, str]) -> str:
    """Return what a source is called: the title of a shipped one, the file's name of a path."""
    return tr(titles.get(key, "")) or (Path(key).name if "/" in key or "\\" in key else key.replace("_", " "))


class SourceChooser(QWidget):
    """Emits ``chosen(key)`` when the user takes an entry and ``browse_requested()`` for the button."""

    chosen = Signal(str)
    browse_requested = Signal()

    def __init__(self, browse_tip: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.list = QuietComboBox()
        self.list.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self.list.setMinimumContentsLength(14)
        self.list.activated.connect(lambda index: self.chosen.emit(self.list.itemData(index)))
        self.button = QToolButton()
        self.button.setIcon(icon("folder-open"))
        self.button.setToolTip(plain_tip(browse_tip))
        self.button.setAccessibleName(browse_tip)
        self.button.clicked.connect(self.browse_requested)
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(4)
        row.addWidget(self.list, 1)
        row.addWidget(self.button)
        self.setFocusProxy(self.list)

    def set_sources(self, shipped: Iterable[Source], files: Iterable[Source]) -> None:
        """Fill the list: shipped things, a line, files; keeps what is shown where it is still there."""
        current = self.list.currentData()
        self.list.blockSignals(True)
        self.list.clear()
        for source in shipped:
            self.list.addItem(source.title, source.key)
        files = tuple(files)
        if files:
            self.list.insertSeparator(self.list.count())
        for source in files:
            self._add_file(source)
        self.list.blockSignals(False)
        if current is not None:
            self.show_source(current, "")

    def show_source(self, key: str, title: str) -> None:
        """Show ``key`` as the present choice, without a signal; added to the list where it is not in it."""
        index = self.list.findData(key)
        if index < 0 and title:
            self._add_file(Source(key, title))
            index = self.list.count() - 1
        self.list.blockSignals(True)
        self.list.setCurrentIndex(index)
        self.list.blockSignals(False)

    def rename(self, key: str, title: str) -> None:
        """Give an entry another title; nothing where there is none."""
        index = self.list.findData(key)
        if index >= 0:
            self.list.setItemText(index, title)

    def _add_file(self, source: Source) -> None:
        self.list.addItem(source.title, source.key)
        self.list.setItemData(self.list.count() - 1, plain_tip(source.key), Qt.ItemDataRole.ToolTipRole)
