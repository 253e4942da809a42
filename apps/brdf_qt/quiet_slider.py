"""A slider for an inspector: grey, and no taker of the wheel that scrolls past it."""

from __future__ import annotations

from PySide6.QtGui import QPaintEvent, QPalette, QWheelEvent
from PySide6.QtWidgets import QSlider, QStyle, QStyleOptionSlider, QStylePainter


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
