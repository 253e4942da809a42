"""A slider with its number: drag for the feel of it, type for the exact value."""

from __future__ import annotations

from brdf_qt.fields.number import NumberField
from brdf_qt.fields.quiet import QuietSlider
from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QHBoxLayout, QWidget


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
        self.slider = QuietSlider(Qt.Orientation.Horizontal)
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
