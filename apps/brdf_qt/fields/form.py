"""How fields stand in a window: forms of labels and fields, rows and columns without margins, buttons with a sign."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QGridLayout, QHBoxLayout, QLabel, QLayout, QToolButton, QVBoxLayout, QWidget

from brdf_qt.fields.labels import PlainLabel, plain_tip
from brdf_qt.fields.number import NumberField, reach_of
from brdf_qt.program.icons import icon
from brdf_qt.program.translation import tr
from brdf_suite.documents.parameter import Parameter

LABEL_WIDTH = 96


def fill_row(place: QWidget, *widgets: QWidget, spacing: int = 8, even: bool = False) -> QHBoxLayout:
    """Put widgets side by side into ``place``; the first, or with ``even`` each alike, takes the room that is left."""
    row = QHBoxLayout(place)
    row.setContentsMargins(0, 0, 0, 0)
    row.setSpacing(spacing)
    for number, widget in enumerate(widgets):
        row.addWidget(widget, int(even or number == 0))
    return row


def fill_column(place: QWidget, *widgets: QWidget, spacing: int = 8) -> QVBoxLayout:
    """Put widgets one below the other into ``place``."""
    column = QVBoxLayout(place)
    column.setContentsMargins(0, 0, 0, 0)
    column.setSpacing(spacing)
    for widget in widgets:
        column.addWidget(widget)
    return column


def icon_button(name: str, tip: str, clicked: Callable[[], object] | None = None) -> QToolButton:
    """Return a button with the icon of that name; ``tip`` says what it does."""
    button = QToolButton()
    button.setIcon(icon(name))
    button.setToolTip(plain_tip(tip))
    button.setAccessibleName(tip)
    if clicked is not None:
        button.clicked.connect(lambda _=False: clicked())
    return button


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

    def add_number(self, text: str, parameter: Parameter, step: float, decimals: int) -> NumberField:
        """Add the number of a document's ``parameter``, explained by its meaning, and return it."""
        field = NumberField(text, *reach_of(parameter, step, decimals))
        self.add_row(text, field, tr(parameter.meaning))
        return field

    def add_wide(self, *widgets: QWidget) -> None:
        """Add widgets over both columns, one below the other."""
        for widget in widgets:
            self._grid.addWidget(widget, self._grid.rowCount(), 0, 1, 2)
