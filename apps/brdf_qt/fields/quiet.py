"""Fields for an inspector that leave it the wheel: nothing changes because the pointer passed over it.

All drop-down lists, whole numbers and sliders of the programs are of these classes; numbers with a unit are
:class:`brdf_qt.fields.number.NumberField`. Those in Qt's own dialogs are made quiet by :func:`quieten`.
"""

from __future__ import annotations

from typing import Any

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtGui import QPaintEvent, QPalette, QWheelEvent
from PySide6.QtWidgets import (
    QAbstractSpinBox,
    QComboBox,
    QSlider,
    QSpinBox,
    QStyle,
    QStyleOptionSlider,
    QStylePainter,
    QTabBar,
    QWidget,
)


class _WheelGuard(QObject):
    """Takes the wheel from what it watches, but for numbers and sliders with the focus."""

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() != QEvent.Type.Wheel:
            return False
        if isinstance(watched, QAbstractSpinBox | QSlider) and watched.hasFocus():
            return False
        event.ignore()  # what lies below scrolls
        return True


def quieten(dialog: QWidget) -> None:
    """Let the fields of a dialog that Qt has made leave the wheel, too."""
    guard = _WheelGuard(dialog)
    for kind in (QComboBox, QAbstractSpinBox, QSlider, QTabBar):
        for field in dialog.findChildren(kind):
            field.installEventFilter(guard)
            if field.focusPolicy() == Qt.FocusPolicy.WheelFocus:
                field.setFocusPolicy(Qt.FocusPolicy.StrongFocus)


class QuietComboBox(QComboBox):
    """A drop-down list that never takes the wheel, also with the focus: what it holds is seldom a scale."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)  # the default would take the focus by the wheel

    def wheelEvent(self, event: QWheelEvent) -> None:
        event.ignore()


class QuietSpinBox(QSpinBox):
    """A whole number that takes the wheel with the focus only."""

    def __init__(self, parent: QWidget | None = None, **options: Any) -> None:
        super().__init__(parent, **options)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)  # the default would take the focus by the wheel

    def wheelEvent(self, event: QWheelEvent) -> None:
        if self.hasFocus():
            super().wheelEvent(event)
        else:
            event.ignore()


class QuietSlider(QSlider):
    """A slider that leaves the wheel to the scrolling inspector, and the accent to focus.

    Fusion fills the groove left of the handle with the accent. That colour is for focus and selection alone, and
    a fill from the left end says nothing of a value whose middle is zero.
    """

    def paintEvent(self, _event: QPaintEvent) -> None:
        option = QStyleOptionSlider()
        self.initStyleOption(option)
        option.subControls = QStyle.SubControl.SC_SliderGroove | QStyle.SubControl.SC_SliderHandle
        if not self.hasFocus():
            groove = option.palette.color(QPalette.ColorRole.Base)
            option.palette.setColor(QPalette.ColorRole.Highlight, groove)
        QStylePainter(self).drawComplexControl(QStyle.ComplexControl.CC_Slider, option)

    def wheelEvent(self, event: QWheelEvent) -> None:
        if self.hasFocus():
            super().wheelEvent(event)
        else:
            event.ignore()
