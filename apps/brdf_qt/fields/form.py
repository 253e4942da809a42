"""Rows of a label and a field: labels right-aligned to their fields, on an 8-pixel rhythm."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QGridLayout, QLabel, QLayout, QWidget

from brdf_qt.fields.labels import PlainLabel, plain_tip

LABEL_WIDTH = 96


class Form(QWidget):
    """A grid of labelled fields; every form of an inspector has the same column of labels."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._grid = QGridLayout(self)
        self._grid.setContentsMargins(0, 0, 0, 0)
        self._grid.setHorizontalSpacing(8)
        self._grid.setVerticalSpacing(8)
        self._grid.setColumnMinimumWidth(0, LABEL_WIDTH)
        self._grid.setColumnStretch(1, 1)
        self._grid.setSizeConstraint(QLayout.SizeConstraint.SetDefaultConstraint)

    def add_row(self, text: str, field: QWidget, tip: str = "") -> QLabel:
        """Add a row; ``tip`` explains the term and goes on both. Returns the label."""
        label = PlainLabel(text)
        label.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        label.setBuddy(field)
        if tip:
            label.setToolTip(plain_tip(tip))
            field.setToolTip(plain_tip(tip))
        if not field.accessibleName():
            field.setAccessibleName(text)
        row = self._grid.rowCount()
        self._grid.addWidget(label, row, 0)
        self._grid.addWidget(field, row, 1)
        return label

    def add_wide(self, widget: QWidget) -> QWidget:
        """Add a widget over both columns and return it."""
        self._grid.addWidget(widget, self._grid.rowCount(), 0, 1, 2)
        return widget
