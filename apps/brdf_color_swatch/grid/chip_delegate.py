"""The name of a swatch in the list, with its colours from the face to the flop before it."""

from __future__ import annotations

from PySide6.QtCore import QModelIndex, QPersistentModelIndex, QRect
from PySide6.QtGui import QColor, QPainter
from PySide6.QtWidgets import QStyledItemDelegate, QStyleOptionViewItem, QWidget

from brdf_color_swatch.grid.model import SwatchModel

_CHIP = 18


class ChipDelegate(QStyledItemDelegate):
    """Draws three chips, or one for a flat colour, and then the text."""

    def paint(
        self, painter: QPainter, option: QStyleOptionViewItem, index: QModelIndex | QPersistentModelIndex
    ) -> None:
        model = index.model()
        assert isinstance(model, SwatchModel)
        inside = QStyleOptionViewItem(option)
        inside.rect = option.rect.adjusted(3 * _CHIP + 8, 0, 0, 0)
        super().paint(painter, inside, index)
        place = model.shown.places[index.row()]
        top, height = option.rect.top() + 3, option.rect.height() - 6
        for number, code in enumerate(model.shown.rows.codes[place]):
            chip = QRect(option.rect.left() + 4 + number * _CHIP, top, _CHIP, height)
            painter.fillRect(chip, QColor(*(int(part) for part in code)))

    def updateEditorGeometry(
        self, editor: QWidget, option: QStyleOptionViewItem, _index: QModelIndex | QPersistentModelIndex
    ) -> None:
        editor.setGeometry(option.rect.adjusted(3 * _CHIP + 8, 0, 0, 0))
