"""A drop-down list of named choices with a default that Backspace or Delete restores."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from brdf_qt.fields.quiet import QuietComboBox
from brdf_qt.program.translation import tr
from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QComboBox, QWidget

_RESETS = (Qt.Key.Key_Backspace, Qt.Key.Key_Delete)


class ChoiceField(QuietComboBox):
    """Choices by key with titles (marked for translation); ``default`` is what Backspace or Delete goes back to.

    ``chosen(key)`` is never emitted by :meth:`set_choice`.
    """

    chosen = Signal(object)

    def __init__(self, titles: Mapping[Any, str], default: Any, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.default = default
        for key, title in titles.items():
            self.addItem(tr(title), key)
        self.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self.setMinimumContentsLength(8)
        self.activated.connect(lambda index: self.chosen.emit(self.itemData(index)))

    @property
    def choice(self) -> Any:
        return self.currentData()

    def set_choice(self, key: Any) -> None:
        """Show a choice without a signal."""
        self.setCurrentIndex(self.findData(key))

    def reset(self) -> None:
        """Go back to the default, as a choice of the user's."""
        if self.choice != self.default:
            self.set_choice(self.default)
            self.chosen.emit(self.default)

    def event(self, event: QEvent) -> bool:
        if isinstance(event, QKeyEvent) and event.type() == QEvent.Type.KeyPress and event.key() in _RESETS:
            self.reset()
            return True
        return super().event(event)
