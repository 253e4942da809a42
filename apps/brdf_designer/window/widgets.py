"""Rows, labels, lists and buttons as all parts of Designer have them."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from brdf_qt.fields.form import described, fill_row
from brdf_qt.fields.labels import RoomyLabel, set_small
from brdf_qt.fields.quiet import QuietComboBox
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QComboBox, QPushButton, QSizePolicy, QSplitter, QWidget


def make_row(*widgets: QWidget, spacing: int = 8) -> QWidget:
    """Return widgets side by side, each as wide as the others."""
    made = QWidget()
    fill_row(made, *widgets, spacing=spacing, even=True)
    return made


def split(orientation: Qt.Orientation, *parts: tuple[QWidget, int]) -> QSplitter:
    """Return widgets with a handle between them, and the share of the room that each takes."""
    made = QSplitter(orientation)
    made.setHandleWidth(8)
    for place, (widget, stretch) in enumerate(parts):
        made.addWidget(widget)
        made.setStretchFactor(place, stretch)
    made.setChildrenCollapsible(False)
    return made


def wrapped(text: str = "", lines: int = 0) -> RoomyLabel:
    """Return a small label that breaks its lines and can be copied; it has room for ``lines`` also while hidden."""
    label = RoomyLabel(text, lines)
    set_small(label)
    label.setMinimumWidth(64)
    return label


def set_font(label: QWidget, *, bold: bool = False, italic: bool = False) -> None:
    """Set a text bold or italic; nothing where it is so already."""
    font = label.font()
    if (font.bold(), font.italic()) != (bold, italic):
        font.setBold(bold)
        font.setItalic(italic)
        label.setFont(font)


def button(text: str, tip: str, action: Callable[[], object] | None = None) -> QPushButton:
    """Return a button that gives way in a narrow column, and calls ``action``."""
    made = described(QPushButton(text), tip=tip)
    made.setAccessibleDescription(tip)
    made.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
    made.setMinimumWidth(48)
    if action is not None:
        made.clicked.connect(lambda: action())
    return made


def combo(choices: Iterable[tuple[str, object]], name: str = "", tip: str = "") -> QuietComboBox:
    """Return a list of (title, value) that is no wider than its place."""
    made = described(QuietComboBox(), spoken=name, tip=tip)
    for title, value in choices:
        made.addItem(title, value)
    made.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
    return made
