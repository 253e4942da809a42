"""A slider with its number: drag for the feel of it, type for the exact value."""

from __future__ import annotations

from brdf_qt.number_field import NumberField
from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QPaintEvent, QPalette, QWheelEvent
from PySide6.QtWidgets import QHBoxLayout, QSlider, QStyle, QStyleOptionSlider, QStylePainter, QWidget


class _QuietSlider(QSlider):
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


class SliderField(QWidget):
    """``edited(value)`` comes from the user alone; :meth:`set_value` is silent.

    Parameters
    ----------
    step
        What a key press or a notch of the wheel changes; the slider stands on whole steps.
    """

    edited = Signal(float)

    def __init__(
        self,
        name: str,
        unit: str,
        minimum: float,
        maximum: float,
        step: float,
        decimals: int,
        default: float,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._step = step
        self.slider = _QuietSlider(Qt.Orientation.Horizontal)
        self.slider.setRange(round(minimum / step), round(maximum / step))
        self.slider.setPageStep(max(1, round((maximum - minimum) / step / 12)))
        self.slider.setAccessibleName(name)
        self.slider.setMinimumWidth(72)
        self.number = NumberField(name, unit, minimum, maximum, step, decimals, default)
        self.number.setFixedWidth(76)
        self.slider.valueChanged.connect(self._slid)
        self.number.edited.connect(self._typed)
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(8)
        row.addWidget(self.slider, 1)
        row.addWidget(self.number)
        self.setFocusProxy(self.number)
        self.set_value(default)

    def value(self) -> float:
        """Return the number as it stands."""
        return self.number.value()

    def set_value(self, value: float) -> None:
        """Show ``value`` on both, without a signal."""
        self.number.set_value(value)
        self._set_slider(value)

    def _slid(self, steps: int) -> None:
        self.number.set_value(steps * self._step)
        self.edited.emit(self.number.value())

    def _typed(self, value: float) -> None:
        self._set_slider(value)
        self.edited.emit(value)

    def _set_slider(self, value: float) -> None:
        self.slider.blockSignals(True)
        self.slider.setValue(round(value / self._step))
        self.slider.blockSignals(False)
