"""Parameter panels that build themselves from a list of what each number is."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QWidget

from brdf_qt.fields.form import Form
from brdf_qt.fields.number import NumberField


@dataclass(frozen=True)
class FieldParameter:
    """One number: its key, name, unit, range, step, decimals, reset value and an explanation of the term."""

    key: str
    name: str
    unit: str
    minimum: float
    maximum: float
    step: float
    decimals: int
    default: float
    tip: str = ""


class ParameterPanel(Form):
    """One labelled :class:`NumberField` per parameter."""

    edited = Signal(str, float)
    gesture_started = Signal(str)
    gesture_finished = Signal(str)

    def __init__(self, parameters: Sequence[FieldParameter], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.fields: dict[str, NumberField] = {}
        for p in parameters:
            field = NumberField(p.name, p.unit, p.minimum, p.maximum, p.step, p.decimals, p.default)
            field.setObjectName(f"field_{p.key}")
            field.edited.connect(lambda value, key=p.key: self.edited.emit(key, value))
            field.gesture_started.connect(lambda key=p.key: self.gesture_started.emit(key))
            field.gesture_finished.connect(lambda key=p.key: self.gesture_finished.emit(key))
            self.add_row(p.name, field, p.tip)
            self.fields[p.key] = field

    def set_values(self, values: Mapping[str, float]) -> None:
        """Show values by key, without a signal; keys without a field are an error (KeyError)."""
        for key, value in values.items():
            self.fields[key].set_value(value)
