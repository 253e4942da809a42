"""A list of few choices, each with a key, a title and maybe a tip."""

from __future__ import annotations

from collections.abc import Mapping

from brdf_qt.fields.labels import plain_tip
from brdf_qt.fields.quiet import QuietComboBox
from brdf_qt.program.translation import tr
from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QWidget


class ChoiceBox(QuietComboBox):
    """Emits ``picked(key)`` when the user takes a choice, and not when it is shown."""

    picked = Signal(str)

    def __init__(
        self, titles: Mapping[str, str], tips: Mapping[str, str] | None = None, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        for key, title in titles.items():
            self.addItem(tr(title), key)
            if tips is not None:
                self.setItemData(self.count() - 1, plain_tip(tr(tips[key])), Qt.ItemDataRole.ToolTipRole)
        self.activated.connect(lambda index: self.picked.emit(self.itemData(index)))

    def show_choice(self, key: str) -> None:
        """Show ``key`` as the present choice, without a signal."""
        self.setCurrentIndex(self.findData(key))
