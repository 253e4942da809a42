"""How fields stand in a window: forms, rows and columns, and widgets with their names and tips."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TypeVar

from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QBoxLayout,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QLayout,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from brdf_qt.fields.labels import PlainLabel, plain_tip
from brdf_qt.fields.number import NumberField, reach_of
from brdf_qt.program.icons import icon
from brdf_qt.program.translation import tr
from brdf_suite.documents.parameter import Parameter

LABEL_WIDTH = 96
Part = QWidget | QLayout | None
"""What stands in a row or a column; None is spare room."""
Margins = tuple[int, int, int, int]
SomeWidget = TypeVar("SomeWidget", bound=QWidget)


def fill_row(place: QWidget, *widgets: QWidget, spacing: int = 8, even: bool = False) -> QHBoxLayout:
    """Put widgets side by side into ``place``; the first, or with ``even`` each alike, takes the room that is left."""
    row = QHBoxLayout(place)
    _fill(row, widgets, widgets if even else widgets[:1], spacing, (0, 0, 0, 0))
    return row


def fill_column(
    place: QWidget, *parts: Part, grows: Part = None, spacing: int = 8, margins: Margins = (0, 0, 0, 0)
) -> QVBoxLayout:
    """Put ``parts`` one below the other into ``place``; ``grows`` is the part that takes spare room."""
    column = QVBoxLayout(place)
    _fill(column, parts, (grows,), spacing, margins)
    return column


def row_of(
    *parts: Part, grows: Part = None, spacing: int = 8, margins: Margins = (0, 0, 0, 0)
) -> QHBoxLayout:
    """Return ``parts`` from left to right; ``grows`` is the part that takes spare room."""
    row = QHBoxLayout()
    _fill(row, parts, (grows,), spacing, margins)
    return row


def _fill(
    box: QBoxLayout, parts: Sequence[Part], grow: Sequence[Part], spacing: int, margins: Margins
) -> None:
    box.setContentsMargins(*margins)
    box.setSpacing(spacing)
    for part in parts:
        if part is None:
            box.addStretch(1)
        elif isinstance(part, QWidget):
            box.addWidget(part, int(part in grow))
        else:
            box.addLayout(part, int(part in grow))


def described(widget: SomeWidget, *, name: str = "", spoken: str = "", tip: str = "") -> SomeWidget:
    """Return ``widget`` with an object name, a name for screen readers, and a tip that is drawn as it is."""
    if name:
        widget.setObjectName(name)
    if spoken:
        widget.setAccessibleName(spoken)
    if tip:
        widget.setToolTip(plain_tip(tip))
    return widget


def icon_button(
    name: str, tip: str, act: Callable[[], object] | None = None, *, flat: bool = False
) -> QToolButton:
    """Return a button with the icon of a name; ``tip``, translated, says what it does and is read aloud."""
    button = described(QToolButton(), spoken=tip, tip=tip)
    button.setIcon(icon(name))
    button.setAutoRaise(flat)
    if act is not None:
        button.clicked.connect(lambda _=False: act())
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
