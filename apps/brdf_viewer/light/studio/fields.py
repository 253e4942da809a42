"""Fields of a studio that report edits as changes of one value, with the gestures around them."""

from __future__ import annotations

from brdf_qt.fields.labels import plain_tip
from brdf_qt.fields.number import NumberField
from brdf_qt.program.translation import tr
from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QCheckBox, QHBoxLayout, QWidget

from brdf_suite.documents.studio import PARAMETERS
from brdf_viewer.fields.choice_box import ChoiceBox

NEUTRAL_K = 6504.0


class Edits(QObject):
    """Where the fields of a panel report: ``changed(name, value)``, and the gesture around several changes."""

    changed = Signal(str, object)
    gesture_started = Signal()
    gesture_finished = Signal()

    def number(
        self,
        name: str,
        label: str,
        unit: str,
        low: float,
        high: float,
        step: float,
        decimals: int,
        default: float,
    ) -> NumberField:
        """Return a number whose edits are changes of ``name``."""
        field = NumberField(label, unit, low, high, step, decimals, default)
        field.setObjectName(f"studio_{name}")
        field.edited.connect(lambda value: self.changed.emit(name, value))
        field.gesture_started.connect(self.gesture_started)
        field.gesture_finished.connect(self.gesture_finished)
        return field

    def of_document(
        self, name: str, step: float, decimals: int, parameter: str | None = None, unit: str | None = None
    ) -> NumberField:
        """Return the number of a document's parameter, within its range."""
        known = PARAMETERS[parameter or name]
        unit = known.unit if unit is None else unit
        return self.number(name, tr(known.label), unit, known.low, known.high, step, decimals, known.default)

    def choice(self, name: str, titles: dict[str, str]) -> ChoiceBox:
        """Return a list whose choices are changes of ``name``."""
        box = ChoiceBox(titles)
        box.setObjectName(f"studio_{name}")
        box.picked.connect(lambda key: self.changed.emit(name, key))
        return box

    def tick(self, name: str, text: str, tip: str) -> QCheckBox:
        """Return a check box whose clicks are changes of ``name``."""
        box = QCheckBox(text)
        box.setToolTip(plain_tip(tip))
        box.setObjectName(f"studio_{name}")
        box.clicked.connect(lambda on: self.changed.emit(name, on))
        return box


class TemperatureField(QWidget):
    """A colour temperature, or neutral: the white of the picture, D65."""

    def __init__(self, edits: Edits, name: str = "colour_temperature_k") -> None:
        super().__init__()
        self._edits, self._name = edits, name
        self.kelvin = edits.of_document(name, 50.0, 0, "colour_temperature_k")
        self.neutral = QCheckBox(tr("Neutral"))
        self.neutral.setToolTip(tr("White of the picture, D65"))
        self.neutral.clicked.connect(self._clicked)
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(8)
        row.addWidget(self.kelvin, 1)
        row.addWidget(self.neutral)
        self.setFocusProxy(self.kelvin)

    def set_value(self, kelvin: float | None) -> None:
        """Show a temperature, None: neutral."""
        self.neutral.setChecked(kelvin is None)
        self.kelvin.setEnabled(kelvin is not None)
        if kelvin is not None:
            self.kelvin.set_value(kelvin)

    def _clicked(self, neutral: bool) -> None:
        value = self.kelvin.value() if self.kelvin.value() else NEUTRAL_K
        self._edits.changed.emit(self._name, None if neutral else value)
