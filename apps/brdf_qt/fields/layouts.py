"""Rows and columns of widgets, and widgets with their names and tips, each made in one expression."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

from PySide6.QtWidgets import QBoxLayout, QHBoxLayout, QLayout, QToolButton, QVBoxLayout, QWidget

from brdf_qt.fields import form
from brdf_qt.fields.labels import plain_tip

Part = QWidget | QLayout | None
"""What stands in a row or a column; None is spare room."""
Margins = tuple[int, int, int, int]
SomeWidget = TypeVar("SomeWidget", bound=QWidget)


def column_in(
    owner: QWidget, *parts: Part, grows: Part = None, spacing: int = 8, margins: Margins = (0, 0, 0, 0)
) -> QVBoxLayout:
    """Lay out ``parts`` in ``owner`` from top to bottom; ``grows`` is the part that takes spare room."""
    box = QVBoxLayout(owner)
    _fill(box, parts, grows, spacing, margins)
    return box


def row_of(
    *parts: Part, grows: Part = None, spacing: int = 8, margins: Margins = (0, 0, 0, 0)
) -> QHBoxLayout:
    """Return ``parts`` from left to right; ``grows`` is the part that takes spare room."""
    box = QHBoxLayout()
    _fill(box, parts, grows, spacing, margins)
    return box


def described(widget: SomeWidget, *, name: str = "", spoken: str = "", tip: str = "") -> SomeWidget:
    """Return ``widget`` with an object name, a name for screen readers, and a tip that is drawn as it is."""
    if name:
        widget.setObjectName(name)
    if spoken:
        widget.setAccessibleName(spoken)
    if tip:
        widget.setToolTip(plain_tip(tip))
    return widget


def icon_button(name: str, text: str, act: Callable[[], object] | None = None) -> QToolButton:
    """Return a flat button with the icon of a name; ``text``, translated, is its tip and is read aloud."""
    button = form.icon_button(name, text, act)
    button.setAutoRaise(True)
    return button


def _fill(box: QBoxLayout, parts: tuple[Part, ...], grows: Part, spacing: int, margins: Margins) -> None:
    box.setContentsMargins(*margins)
    box.setSpacing(spacing)
    for part in parts:
        if part is None:
            box.addStretch(1)
        elif isinstance(part, QWidget):
            box.addWidget(part, int(part is grows))
        else:
            box.addLayout(part, int(part is grows))
