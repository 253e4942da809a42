"""The fields that narrow a list of thumbnails: a word to search for, and where the entries come from."""

from __future__ import annotations

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QLineEdit, QWidget

from brdf_qt.choosing.sources import FilteredSources
from brdf_qt.fields.choices import ChoiceBox
from brdf_qt.fields.form import described
from brdf_qt.program.translation import mark, tr

GROUPS = {
    "": mark("All"),
    "recent": mark("Recent"),
    "shipped": mark("Shipped"),
    "palette": mark("Palette"),
}
WITHOUT_PALETTE = tuple(key for key in GROUPS if key != "palette")


class SourceSearch(QLineEdit):
    """A word to search for. Signals: ``left()``, Down was pressed; ``entered()``, Enter was."""

    left = Signal()
    entered = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        text = tr("Search by name")
        described(self, spoken=text)
        self.setPlaceholderText(text)
        self.setClearButtonEnabled(True)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Down:
            self.left.emit()
        elif event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self.entered.emit()
        else:
            super().keyPressEvent(event)


def filter_fields(sources: FilteredSources, groups: tuple[str, ...]) -> tuple[SourceSearch, ChoiceBox]:
    """Return the fields that narrow ``sources``, with a choice of these ``groups``."""
    search = SourceSearch()
    search.textChanged.connect(sources.set_text)
    origin = described(
        ChoiceBox({key: GROUPS[key] for key in groups}),
        spoken=tr("Origin"),
        tip=tr("Where the entries come from"),
    )
    origin.picked.connect(sources.set_group)
    return search, origin
