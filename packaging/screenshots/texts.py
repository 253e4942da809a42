"""Find texts on a window that have less room than they need, and texts that lie on one another.

Measured is what Qt draws: the width of a text in its font against the place that the style gives it. A text that is
shortened on purpose has its whole in a tool tip and counts as whole. Of a plot the titles, legends and labels are seen,
which are items of its scene; numbers along its axes, and what a picture paints by itself, are not seen here.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import combinations

from brdf_qt.fields.labels import ElidedLabel
from PySide6.QtCore import QPoint, QRect, QRectF, Qt
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QAbstractScrollArea,
    QAbstractSpinBox,
    QComboBox,
    QFileDialog,
    QFrame,
    QGraphicsSimpleTextItem,
    QGraphicsTextItem,
    QGraphicsView,
    QGroupBox,
    QHeaderView,
    QLabel,
    QLineEdit,
    QListView,
    QMenuBar,
    QScrollArea,
    QStyle,
    QStyleOptionButton,
    QStyleOptionComboBox,
    QTabBar,
    QToolButton,
    QWidget,
)

SLACK = 1
"""Pixels that a text may lack: widths of text are rounded up."""
_BREAKS = re.compile(r"[\s\u200b]+|(?<=[/-])")
"""Where a line of text may break."""
_MOST_ROWS = 400
_LINE_MARGIN = 2
"""Pixels that a line of text keeps at its ends."""


@dataclass(frozen=True)
class Fault:
    """A text without room: the widget, its text, the pixels that it needs and has, and where it is in the window."""

    widget: str
    text: str
    needed: str
    given: str
    place: tuple[int, int]


def faults(window: QWidget) -> list[Fault]:
    """Return the texts of a window that are clipped, and those that overlap; none where all can be read."""
    shown = [widget for widget in (window, *window.findChildren(QWidget)) if _is_shown(widget, window)]
    found = [fault for widget in shown for fault in _clipped(widget, window)]
    for widget in shown:
        if _has_text(widget) or isinstance(widget, QAbstractScrollArea):
            found += _cut_by_parent(widget, window)
    return found + list(_overlapping(shown, window))


def _is_shown(widget: QWidget, window: QWidget) -> bool:
    return widget.isVisible() and widget.window() is window and not widget.size().isEmpty()


def _fault(widget: QWidget, window: QWidget, text: str, needed: object, given: object) -> Fault:
    corner = widget.mapTo(window, QPoint(0, 0))
    name = f"{type(widget).__name__} {widget.objectName()!r}"
    return Fault(name, text, str(needed), str(given), (corner.x(), corner.y()))


def _has_text(widget: QWidget) -> bool:
    return bool(_text(widget).strip())


def _text(widget: QWidget) -> str:
    if isinstance(widget, QLabel | QAbstractButton | QLineEdit | QAbstractSpinBox):
        return widget.text()
    return widget.currentText() if isinstance(widget, QComboBox) else ""


def _width(widget: QWidget, text: str) -> int:
    return max((widget.fontMetrics().horizontalAdvance(line) for line in text.split("\n")), default=0)


def _plain(text: str) -> str:
    return text.replace("&&", "\0").replace("&", "").replace("\0", "&")


def _clipped(widget: QWidget, window: QWidget) -> Iterator[Fault]:
    """Yield what a widget has no room for inside itself."""
    if isinstance(widget, QHeaderView):
        yield from _header(widget, window)
    elif isinstance(widget, QAbstractItemView):
        yield from _rows(widget, window)
    elif isinstance(widget, QGraphicsView):
        yield from _scene(widget, window)
    elif isinstance(widget, QTabBar):
        yield from _tabs(widget, window)
    elif isinstance(widget, QMenuBar):
        for action in widget.actions():
            wide = _width(widget, _plain(action.text()))
            room = widget.actionGeometry(action).intersected(widget.rect()).width()
            if action.isVisible() and wide > room:
                yield _fault(widget, window, action.text(), wide, room)
    elif isinstance(widget, QGroupBox):
        if _width(widget, _plain(widget.title())) > widget.width():
            yield _fault(
                widget, window, widget.title(), _width(widget, _plain(widget.title())), widget.width()
            )
    elif isinstance(widget, QLabel):
        yield from _label(widget, window)
    elif isinstance(widget, QLineEdit) and not widget.text():
        hint, room = widget.placeholderText(), widget.contentsRect().width() - 2 * _LINE_MARGIN
        if _width(widget, hint) > room + SLACK:
            yield _fault(widget, window, hint, _width(widget, hint), room)
    elif isinstance(widget, QAbstractButton | QComboBox | QAbstractSpinBox):
        text, given = _plain(_text(widget)), _room(widget)
        needed = _width(widget, text)
        if text and given is not None and needed > given + SLACK and not _told(widget, text):
            yield _fault(widget, window, text, needed, given)
        elif text and given is not None and widget.fontMetrics().height() > widget.height() + SLACK:
            yield _fault(
                widget, window, text, f"{widget.fontMetrics().height()} high", f"{widget.height()} high"
            )


def _scene(view: QGraphicsView, window: QWidget) -> Iterator[Fault]:
    """Yield the texts of a plot that end outside of it, and those that lie on one another."""
    area = QRectF(view.viewport().rect())
    found: list[tuple[str, QRectF]] = []
    for item in view.items():
        if not isinstance(item, QGraphicsTextItem | QGraphicsSimpleTextItem) or not item.isVisible():
            continue
        text = item.toPlainText() if isinstance(item, QGraphicsTextItem) else item.text()
        if not text.strip() or item.effectiveOpacity() == 0.0:
            continue
        margin = item.document().documentMargin() if isinstance(item, QGraphicsTextItem) else 0.0
        inner = item.boundingRect().adjusted(margin, margin, -margin, -margin)
        rect = view.mapFromScene(item.mapToScene(inner)).boundingRect().toRectF()
        inside = rect.intersected(area)
        if inside.width() < rect.width() - 2 * SLACK or inside.height() < rect.height() - 2 * SLACK:
            yield _fault(view, window, text, _size(rect.toRect()), _size(inside.toRect()))
        for other, place in found:
            common = rect.intersected(place)
            if common.width() > 2 * SLACK and common.height() > 2 * SLACK:
                yield _fault(view, window, f"{text} | {other}", "overlap", _size(common.toRect()))
        found.append((text, rect))


def _told(widget: QWidget, text: str) -> bool:
    """Whether a text may end in an ellipsis: a tip has the whole, or it is the list of endings in Qt's question."""
    return isinstance(widget, QComboBox) and (
        text in widget.toolTip() or widget.objectName() == "fileTypeCombo"
    )


def _room(widget: QWidget) -> int | None:
    """Return how wide a text of a button, a list or a number may be; None where no text is drawn."""
    if isinstance(widget, QAbstractSpinBox):
        return widget.lineEdit().contentsRect().width()
    if isinstance(widget, QComboBox):
        option = QStyleOptionComboBox()
        option.initFrom(widget)
        option.editable = widget.isEditable()
        field = QStyle.SubControl.SC_ComboBoxEditField
        icon = 0 if widget.itemIcon(widget.currentIndex()).isNull() else widget.iconSize().width() + 4
        return (
            widget.style().subControlRect(QStyle.ComplexControl.CC_ComboBox, option, field, widget).width()
            - icon
        )
    if isinstance(widget, QToolButton):
        look = widget.toolButtonStyle()
        if look is Qt.ToolButtonStyle.ToolButtonIconOnly and not widget.icon().isNull():
            return None
        beside = look is Qt.ToolButtonStyle.ToolButtonTextBesideIcon and not widget.icon().isNull()
        return widget.width() - (widget.iconSize().width() + 4 if beside else 0)
    if isinstance(widget, QAbstractButton) and type(widget).__name__ in (
        "QPushButton",
        "QCheckBox",
        "QRadioButton",
    ):
        icon = 0 if widget.icon().isNull() else widget.iconSize().width() + 4
        style, look_of = widget.style(), QStyleOptionButton()
        look_of.initFrom(widget)
        parts = {
            "QCheckBox": QStyle.SubElement.SE_CheckBoxContents,
            "QRadioButton": QStyle.SubElement.SE_RadioButtonContents,
        }
        part = parts.get(type(widget).__name__)
        wide = widget.width() if part is None else style.subElementRect(part, look_of, widget).width()
        return wide - icon
    return None


def _label(label: QLabel, window: QWidget) -> Iterator[Fault]:
    text = label.text()
    if not text.strip() or isinstance(label, ElidedLabel):
        return
    if not label.pixmap().isNull():
        return
    if label.wordWrap():
        high = QLabel.heightForWidth(label, label.width())
        longest = max((_width(label, word) for word in _BREAKS.split(text)), default=0)
        if high > label.height() + SLACK:
            yield _fault(label, window, text, f"{high} high", f"{label.height()} high")
        elif longest > label.contentsRect().width() + SLACK and label.textFormat() is Qt.TextFormat.PlainText:
            yield _fault(label, window, text, longest, label.contentsRect().width())
        return
    needed, given = QLabel.sizeHint(label), label.size()
    if label.textFormat() is Qt.TextFormat.PlainText:
        if _width(label, text) > label.contentsRect().width() + SLACK:
            yield _fault(label, window, text, _width(label, text), label.contentsRect().width())
    elif needed.width() > given.width() + SLACK:
        yield _fault(label, window, text, needed.width(), given.width())
    if label.fontMetrics().height() > given.height() + SLACK:
        yield _fault(label, window, text, f"{label.fontMetrics().height()} high", f"{given.height()} high")


def _tabs(bar: QTabBar, window: QWidget) -> Iterator[Fault]:
    for place in range(bar.count()):
        text, given = _plain(bar.tabText(place)), bar.tabRect(place).width()
        whole = bar.elideMode() is Qt.TextElideMode.ElideNone or text in bar.tabToolTip(place)
        if not whole and _width(bar, text) > given:
            yield _fault(bar, window, text, _width(bar, text), given)


def _header(header: QHeaderView, window: QWidget) -> Iterator[Fault]:
    model = header.model()
    for section in range(header.count() if model is not None else 0):
        text = str(model.headerData(section, header.orientation()) or "")
        if header.isSectionHidden(section) or header.orientation() is Qt.Orientation.Vertical:
            continue
        tip = model.headerData(section, header.orientation(), Qt.ItemDataRole.ToolTipRole)
        if text and not tip and _width(header, text) > header.sectionSize(section):
            yield _fault(header, window, text, _width(header, text), header.sectionSize(section))


def _rows(view: QAbstractItemView, window: QWidget) -> Iterator[Fault]:
    """Yield the rows in sight whose text ends before its end, and that have no tip."""
    model = view.model()
    if model is None or view.horizontalScrollBar().maximum() > 0:
        return
    if isinstance(view.window(), QFileDialog):
        return  # Qt's own; its columns are as wide as the user makes them
    area = view.viewport().rect()
    for row in range(min(model.rowCount(view.rootIndex()), _MOST_ROWS)):
        for column in range(1 if isinstance(view, QListView) else model.columnCount(view.rootIndex())):
            index = model.index(row, column, view.rootIndex())
            text, rect = str(index.data() or ""), view.visualRect(index)
            if not text or not rect.intersects(area) or index.data(Qt.ItemDataRole.ToolTipRole):
                continue
            if (
                type(view.itemDelegate()).__module__.startswith("brdf_")
                or view.indexWidget(index) is not None
            ):
                continue
            icon = view.iconSize().width() if index.data(Qt.ItemDataRole.DecorationRole) is not None else 0
            given = rect.intersected(area).width() - max(icon, 0)
            needed = _width(view, text)
            if view.model() is not None and needed > given + SLACK:
                yield _fault(view, window, text, needed, given)


def _cut_by_parent(widget: QWidget, window: QWidget) -> Iterator[Fault]:
    """Yield a widget of which a part lies outside of what it is in, where nothing scrolls there."""
    parent, child = widget.parentWidget(), widget
    rect = widget.rect()
    while parent is not None and child is not window:
        rect = rect.translated(child.pos())
        scrolled = parent.parentWidget()
        if isinstance(scrolled, QAbstractScrollArea) and scrolled.viewport() is parent:
            fixed = scrolled.horizontalScrollBarPolicy() is Qt.ScrollBarPolicy.ScrollBarAlwaysOff
            if fixed and child.width() > parent.width() + SLACK and isinstance(scrolled, QScrollArea):
                yield _fault(widget, window, _text(widget), child.width(), f"{parent.width()} that scroll")
            return
        inside = rect.intersected(parent.rect())
        if inside.width() < rect.width() - SLACK or inside.height() < rect.height() - SLACK:
            if not inside.isEmpty():
                yield _fault(
                    widget, window, _text(widget), _size(rect), f"{_size(inside)} in {parent.objectName()!r}"
                )
            return
        child, parent = parent, parent.parentWidget()


def _overlapping(shown: list[QWidget], window: QWidget) -> Iterator[Fault]:
    """Yield the texts of one parent that lie on one another."""
    groups: dict[int, list[QWidget]] = {}
    for widget in shown:
        if _has_text(widget) and widget.parentWidget() is not None and widget is not window:
            groups.setdefault(id(widget.parentWidget()), []).append(widget)
    for group in groups.values():
        for one, other in combinations(group, 2):
            common = _drawn(one).intersected(_drawn(other))
            if common.width() > SLACK and common.height() > SLACK:
                text = f"{_text(one)} | {_text(other)}"
                yield _fault(one, window, text, "overlap", f"{_size(common)} with {type(other).__name__}")


def _drawn(widget: QWidget) -> QRect:
    """Return where a text lies in its parent: all of a control, the text itself of a label."""
    if not isinstance(widget, QLabel) or (isinstance(widget, QFrame) and widget.wordWrap()):
        return widget.geometry()
    hint, area = QLabel.sizeHint(widget), widget.geometry()
    size = hint.boundedTo(area.size())
    layout = widget.layoutDirection()
    return QStyle.alignedRect(layout, widget.alignment(), size, area)


def _size(rect: QRect) -> str:
    return f"{rect.width()}×{rect.height()}"
