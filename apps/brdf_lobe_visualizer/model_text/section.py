"""The section Model of the inspector: a slider and a number for each declared number of the selected model."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING

from brdf_qt.fields.form import Form, described, fill_column
from brdf_qt.fields.number import NumberField
from brdf_qt.fields.quiet import QuietSlider
from brdf_qt.program.translation import mark, tr
from PySide6.QtCore import QObject, QSignalBlocker, Qt, Signal
from PySide6.QtWidgets import QCheckBox, QWidget

if TYPE_CHECKING:
    from brdf_suite.documents.parameter import Parameter
    from brdf_suite.reflectance.adjusting import Adjustable

WORDS = (
    *(mark("Index"), mark("Roughness"), mark("Spread"), mark("Diffuse"), mark("Flop"), mark("Flop exponent")),
    *(
        mark("Coat exponent"),
        mark("Scale"),
        mark("Metal"),
        mark("Albedo"),
        mark("Specular"),
        mark("Exponent"),
    ),
    *(mark("Spacing"), mark("Floor"), mark("GGX width α")),
    mark("KD, f_r of the diffuse part, linear Rec. 2020"),
    mark("Matt reflectance of a facet, linear Rec. 2020"),
    mark("Glossy reflectance of a facet, linear Rec. 2020"),
    mark("Sharpness n of a facet's gloss"),
    mark("Index of refraction of the clearcoat"),
    mark("Beckmann α of the clearcoat"),
    mark("How far the base spreads light: 0 mirror, 1 matt"),
    mark("Diffuse reflectance of the base, linear Rec. 2020"),
    mark("Share in the base's lobe, linear Rec. 2020"),
    mark("Sharpness n of the base's lobe"),
    mark("Sharpness N of the coat's lobe"),
    mark("What the product of the maps is multiplied by"),
    mark("Fresnel reflectance along the normal, linear Rec. 2020"),
    mark("Diffuse reflectance, linear Rec. 2020"),
    mark("Share of the light reflected, linear Rec. 2020"),
    mark("Share in the lobe along the normal, linear Rec. 2020"),
    mark("Sharpness n of the lobe"),
    mark("Distance between the cylinders' axes"),
    mark("Height of the floor above the axes"),
)
"""What the models that are built in declare of their numbers, for the collection of texts; a test compares them."""
_STEPS = 1000
_MANY_TIMES = 1000.0


def to_value(share: float, low: float, high: float) -> float:
    """Return the value at a share, 0 to 1, of a slider: even steps, or fine ones near 0 where the range is wide.

    >>> to_value(0.5, 0.0, 1.0), to_value(0.5, 0.0, 8000.0)
    (0.5, 1000.0)
    """
    return low + (high - low) * (share * share * share if _is_wide(low, high) else share)


def to_share(value: float, low: float, high: float) -> float:
    """Return the inverse of :func:`to_value`."""
    share = min(max((value - low) / (high - low), 0.0), 1.0)
    return math.cbrt(share) if _is_wide(low, high) else share


def _is_wide(low: float, high: float) -> bool:
    return low >= 0.0 and high - low >= _MANY_TIMES


def decimals_of(low: float, high: float) -> int:
    """Return how many decimals show a thousandth of a range, and its lower end.

    >>> decimals_of(0.0, 1.0), decimals_of(0.001, 1.0), decimals_of(0.0, 5000.0)
    (3, 4, 1)
    """
    span = high - low
    count = 3 - math.floor(math.log10(span)) if span < _MANY_TIMES else 1
    if 0.0 < low < 1.0:
        count = max(count, 1 - math.floor(math.log10(low)))
    return min(max(count, 1), 8)


class NumberSlider(QObject):
    """A number with its slider; ``edited(float)`` by the user alone."""

    edited = Signal(float)

    def __init__(self, title: str, parameter: Parameter, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._low, self._high = parameter.low, parameter.high
        step = (self._high - self._low) / 100.0 if not _is_wide(self._low, self._high) else 1.0
        self.number = NumberField(
            title,
            parameter.unit,
            self._low,
            self._high,
            step,
            decimals_of(self._low, self._high),
            parameter.default,
        )
        spoken = tr("{name}, slider").format(name=title)
        self.slider = described(QuietSlider(Qt.Orientation.Horizontal), spoken=spoken)
        self.slider.setRange(0, _STEPS)
        self.slider.setPageStep(_STEPS // 10)
        self.slider.setSingleStep(_STEPS // 100)
        self.slider.valueChanged.connect(self._slid)
        self.number.edited.connect(self._typed)

    def set_value(self, value: float) -> None:
        """Show a value without a signal."""
        if not self.number.hasFocus() or self.number.value() != value:
            self.number.set_value(value)
        self._place(value)

    def _place(self, value: float) -> None:
        if not self.slider.isSliderDown():
            with QSignalBlocker(self.slider):
                self.slider.setValue(round(_STEPS * to_share(value, self._low, self._high)))

    def _slid(self, place: int) -> None:
        value = to_value(place / _STEPS, self._low, self._high)
        self.number.set_value(value)
        self.edited.emit(self.number.value())

    def _typed(self, value: float) -> None:
        self._place(value)
        self.edited.emit(value)


class ModelNumbers(QWidget):
    """One row for each number. Signal: ``edited(key, value)`` by the user alone."""

    edited = Signal(str, float)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("model_section")
        self._declared: dict[str, tuple[Parameter, bool]] = {}
        self.rows: dict[str, NumberSlider | QCheckBox] = {}
        self._form = Form()
        fill_column(self, self._form)

    def show_numbers(self, numbers: Mapping[str, Adjustable]) -> None:
        """Show these numbers: other rows where other numbers are declared."""
        declared = {key: (one.parameter, one.is_switch) for key, one in numbers.items()}
        if declared != self._declared:
            self._declared = declared
            self._build(numbers)
        for key, one in numbers.items():
            row = self.rows[key]
            if isinstance(row, NumberSlider):
                row.set_value(one.value)
            else:
                with QSignalBlocker(row):
                    row.setChecked(bool(one.value))

    def _build(self, numbers: Mapping[str, Adjustable]) -> None:
        old = self._form
        self._form = Form()
        self.rows = {}
        for key, one in numbers.items():
            title = _title(one)
            tip = tr(one.parameter.meaning) if one.parameter.meaning else ""
            if one.is_switch:
                switch = described(QCheckBox(), name=f"model_{key}")
                switch.toggled.connect(lambda on, key=key: self.edited.emit(key, float(on)))
                self.rows[key] = switch
                self._form.add_row(title, switch, tip)
            else:
                row = NumberSlider(title, one.parameter, self._form)
                row.number.setObjectName(f"model_{key}")
                row.slider.setObjectName(f"model_{key}_slider")
                row.edited.connect(lambda value, key=key: self.edited.emit(key, value))
                self.rows[key] = row
                self._form.add_row(title, row.number, tip)
                self._form.add_wide(row.slider)
        layout = self.layout()
        assert layout is not None
        layout.replaceWidget(old, self._form)
        old.deleteLater()


def _title(one: Adjustable) -> str:
    """Return the label in the user's language, with the channel where it is one of a colour."""
    if one.channel is None:
        return tr(one.parameter.label)
    channel = (tr("red"), tr("green"), tr("blue"))[one.channel]
    return tr("{name}, {channel}").format(name=tr(one.parameter.label), channel=channel)
