"""Walks through all widgets that there are: what is drawn as HTML, and what a wheel changes. Loaded by conftest.py."""

from __future__ import annotations

from collections.abc import Iterator

from PySide6 import QtGui
from PySide6.QtCore import (
    QAbstractItemModel,
    QAbstractListModel,
    QAbstractTableModel,
    QModelIndex,
    QPoint,
    QPointF,
    Qt,
)
from PySide6.QtGui import QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractItemView,
    QAbstractSlider,
    QAbstractSpinBox,
    QApplication,
    QComboBox,
    QGraphicsTextItem,
    QGraphicsView,
    QLabel,
    QScrollBar,
    QTabBar,
    QWidget,
)

HOSTILE = '<img src="/nonexistent.png"><b>x</b>\u202egnp\u200b'
"""A name that Qt draws as a picture and a bold letter unless stated otherwise, with marks that are not seen."""
HOSTILE_FILE = '<img src="nonexistent.png"><b>x\u202egnp\u200b'
"""The same as a name that a file can have."""

_TAG = "<img"


def drawn_as_html() -> tuple[list[str], int]:
    """Return each place where a hostile name is drawn as HTML or with marks that are not seen; and their number."""
    wrong, seen = [], 0
    for widget in QApplication.allWidgets():
        place = f"{type(widget).__name__} {widget.objectName()!r}"
        for what, text, html in _texts(widget):
            if _TAG in text or "&lt;img" in text:
                seen += 1
            if (html and _TAG in text.lower()) or "\u202e" in text or "\u200b" in text:
                wrong.append(f"{place}, {what}: {text!r}")
    return wrong, seen


def widgets_of(window: QWidget) -> list[QWidget]:
    """Return a window and all widgets in it or opened from it; menus of libraries that nothing opens are not."""

    def is_inside(widget: QWidget | None) -> bool:
        while widget is not None and widget is not window:
            widget = widget.parentWidget()
        return widget is window

    return [widget for widget in QApplication.allWidgets() if is_inside(widget)]


def all_texts(window: QWidget) -> list[tuple[str, str]]:
    """Return the texts of a window's widgets, each with its place."""
    return [
        (f"{type(widget).__name__} {widget.objectName()!r}, {what}", text)
        for widget in widgets_of(window)
        for what, text, _ in _texts(widget)
        if text
    ]


def _texts(widget: QWidget) -> Iterator[tuple[str, str, bool]]:
    """Yield what kind of text it is, the text, and whether it is drawn as HTML."""
    if isinstance(widget, QLabel):
        form = widget.textFormat()
        rich = QtGui.Qt.mightBeRichText(widget.text()) and form is not Qt.TextFormat.PlainText
        yield "text", widget.text(), rich or form is Qt.TextFormat.RichText
    tips = [widget.toolTip(), widget.whatsThis(), *(action.toolTip() for action in widget.actions())]
    if isinstance(widget, QTabBar):
        tips += [widget.tabToolTip(place) for place in range(widget.count())]
        yield from (("tab", widget.tabText(place), False) for place in range(widget.count()))
    yield from (("entry", action.text(), False) for action in widget.actions())
    models = [widget.model()] if isinstance(widget, QAbstractItemView | QComboBox) else []
    for model in models:
        if model is not None:
            tips += _roles(model, Qt.ItemDataRole.ToolTipRole)
            yield from (("item", text, False) for text in _roles(model, Qt.ItemDataRole.DisplayRole))
    yield from (("tip", tip, QtGui.Qt.mightBeRichText(tip)) for tip in tips)
    if isinstance(widget, QGraphicsView) and widget.scene() is not None:
        for item in widget.scene().items():
            if isinstance(item, QGraphicsTextItem):
                yield "text in a plot", item.toHtml(), True
    if isinstance(widget, QAbstractSpinBox):
        yield "field", widget.text(), False


def _roles(model: QAbstractItemModel, role: Qt.ItemDataRole) -> list[str]:
    found, parents = [], [QModelIndex()]
    while parents:
        parent = parents.pop()
        columns = _columns(model, parent)
        for row in range(min(200, model.rowCount(parent))):
            found += [
                str(model.data(model.index(row, column, parent), role) or "") for column in range(columns)
            ]
            if not isinstance(model, QAbstractListModel | QAbstractTableModel):
                parents.append(model.index(row, 0, parent))
    for direction, count in (
        (Qt.Orientation.Horizontal, _columns(model, QModelIndex())),
        (Qt.Orientation.Vertical, min(200, model.rowCount())),
    ):
        found += [str(model.headerData(place, direction, role) or "") for place in range(count)]
    return found


def _columns(model: QAbstractItemModel, parent: QModelIndex) -> int:
    # A list's own method is private.
    return 1 if isinstance(model, QAbstractListModel) else model.columnCount(parent)


def turn_wheel(widget: QWidget, notches: int = 1) -> None:
    """Turn the wheel over the middle of a widget, as the window system reports it where the widget is visible."""
    window, middle = widget.window(), widget.rect().center()
    there = widget.mapTo(window, middle)
    seen = window.childAt(there) if widget.isVisible() and window.isVisible() else None
    if seen is not None and (seen is widget or widget.isAncestorOf(seen)):
        QTest.wheelEvent(window.windowHandle(), QPointF(there), QPoint(0, 120 * notches))
        return
    event = QWheelEvent(
        QPointF(middle),
        QPointF(widget.mapToGlobal(middle)),
        QPoint(0, 0),
        QPoint(0, 120 * notches),
        Qt.MouseButton.NoButton,
        Qt.KeyboardModifier.NoModifier,
        Qt.ScrollPhase.NoScrollPhase,
        False,
    )
    QApplication.sendEvent(widget, event)


def fields(window: QWidget) -> list[QWidget]:
    """Return the drop-down lists, numbers, sliders and tabs of a window, also of those that are not shown now."""
    return [
        widget
        for widget in window.findChildren(QWidget)
        if isinstance(widget, QComboBox | QAbstractSpinBox | QAbstractSlider | QTabBar)
        and not isinstance(widget, QScrollBar)
    ]


def changed_by_wheel(window: QWidget) -> tuple[list[str], int]:
    """Turn the wheel over every field of a window; return those that changed or took the focus, and the number of all.

    Drop-down lists and tabs are tried with the focus too.
    """
    wrong, all_fields = [], fields(window)
    for field in all_fields:
        name = f"{type(field).__name__} {field.objectName() or field.accessibleName()!r}"
        if field.focusPolicy() == Qt.FocusPolicy.WheelFocus:
            wrong.append(f"{name} takes the focus by the wheel")
        for focused in (False, True) if isinstance(field, QComboBox | QTabBar) else (False,):
            if focused:
                field.setFocus()
            elif (front := QApplication.focusWidget()) is not None:
                front.clearFocus()
            before = read_value(field)
            for over in (field, *field.findChildren(QWidget)):
                if not isinstance(field, QComboBox) or over is field:  # a list's own popup scrolls
                    turn_wheel(over, 1)
                    turn_wheel(over, -2)
            if read_value(field) != before:
                wrong.append(f"{name} changed{' with the focus' if focused else ''}")
    return wrong, len(all_fields)


def read_value(field: QWidget) -> object:
    if isinstance(field, QComboBox | QTabBar):
        return field.currentIndex()
    return field.text() if isinstance(field, QAbstractSpinBox) else field.value()
