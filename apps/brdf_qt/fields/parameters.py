"""Panels of labelled numbers, each known by a key."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QWidget

from brdf_qt.fields.form import Form
from brdf_qt.fields.number import NumberField


class ParameterPanel(Form):
    """One labelled :class:`NumberField` per parameter, reported by its key."""

    edited = Signal(str, float)
    gesture_started = Signal(str)
    gesture_finished = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.fields: dict[str, NumberField] = {}

    def add_parameter(self, key: str, name: str, *reach: Any, tip: str) -> None:
        """Add a number; ``reach`` as :class:`NumberField` takes it after its name, ``tip`` explains the term."""
        self.fields[key] = field = NumberField(name, *reach)
        field.setObjectName(f"field_{key}")
        field.edited.connect(lambda value: self.edited.emit(key, value))
        field.gesture_started.connect(lambda: self.gesture_started.emit(key))
        field.gesture_finished.connect(lambda: self.gesture_finished.emit(key))
        self.add_row(name, field, tip)

    def set_values(self, values: Mapping[str, float]) -> None:
        """Show values by key, without a signal; keys without a field are an error (KeyError)."""
        for key, value in values.items():
            self.fields[key].set_value(value)
