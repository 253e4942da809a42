"""What a pane lets pass by its figures: hue, lightness, chroma, flop, gloss; and duplicates."""

from __future__ import annotations

import numpy as np
from brdf_qt.fields.labels import plain_tip
from brdf_qt.fields.number import NumberField
from brdf_qt.program.translation import mark, tr
from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QCheckBox, QHBoxLayout, QPushButton, QVBoxLayout, QWidget

from brdf_color_swatch.grid.columns import codes_of
from brdf_color_swatch.grid.view_state import RANGES, PaneState
from brdf_color_swatch.panels.range_slider import RangeField

DEFAULT_TOLERANCE = 1.0
_FIELDS = {
    "hue": (
        mark("Hue"),
        "°",
        1.0,
        0,
        mark("CIE hue angle at 45°. A range from 330° to 30° passes through 0°"),
    ),
    "lightness": (mark("Lightness"), "", 1.0, 0, mark("CIE L* at 45°")),
    "chroma": (mark("Chroma"), "", 1.0, 0, mark("CIE C* at 45°")),
    "flop": (mark("Flop"), "", 0.5, 1, mark("Flop index from 15°, 45° and 110° (0: solid)")),
    "gloss": (mark("Gloss"), "GU", 1.0, 0, mark("Gloss at 20° in gloss units")),
}


class FiltersPanel(QWidget):
    """Signals: ``range_edited(key, low, high)``, ``duplicates_requested(tolerance or None)``, ``cleared()``."""

    range_edited = Signal(str, float, float)
    duplicates_requested = Signal(object)
    cleared = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        box = QVBoxLayout(self)
        box.setContentsMargins(0, 0, 0, 0)
        box.setSpacing(8)
        self.fields: dict[str, RangeField] = {}
        for key, (name, unit, step, decimals, tip) in _FIELDS.items():
            colour = {"hue": _hue_colour, "lightness": _lightness_colour}.get(key)
            field = RangeField(
                tr(name), unit, RANGES[key], step, decimals, colour, wraps=key == "hue", tip=tr(tip)
            )
            field.setObjectName(f"filter_{key}")
            field.edited.connect(lambda low, high, key=key: self.range_edited.emit(key, low, high))
            self.fields[key] = field
            box.addWidget(field)
        self.duplicates = QCheckBox(tr("Duplicates within"))
        self.duplicates.setObjectName("duplicates")
        tip = tr("Show only swatches within this ΔE00 of another at every angle, by group")
        self.duplicates.setToolTip(plain_tip(tip))
        self.tolerance = NumberField(tr("Duplicate tolerance"), "ΔE00", 0.0, 20.0, 0.1, 2, DEFAULT_TOLERANCE)
        self.tolerance.setToolTip(plain_tip(tip))
        row = QHBoxLayout()
        row.addWidget(self.duplicates, 1)
        row.addWidget(self.tolerance)
        box.addLayout(row)
        self.clear = QPushButton(tr("Clear Filters"))
        self.clear.setObjectName("clear_filters")
        self.clear.clicked.connect(self.cleared)
        box.addWidget(self.clear, 0, Qt.AlignmentFlag.AlignRight)
        self.duplicates.clicked.connect(lambda _on: self._request_duplicates())
        self.tolerance.edited.connect(
            lambda _value: self._request_duplicates() if self.duplicates.isChecked() else None
        )

    def show_state(self, state: PaneState) -> None:
        """Show what the pane in front lets pass."""
        for key, field in self.fields.items():
            field.set_range(*state.range_of(key))
        self.duplicates.setChecked(state.duplicates is not None)
        if state.duplicates is not None:
            self.tolerance.set_value(state.duplicates)
        self.clear.setEnabled(bool(state.is_filtered or state.near is not None))

    def _request_duplicates(self) -> None:
        self.duplicates_requested.emit(self.tolerance.value() if self.duplicates.isChecked() else None)


def _hue_colour(hue: float) -> QColor:
    angle = np.radians(hue)
    return QColor(*(int(v) for v in codes_of(np.array([65.0, 45.0 * np.cos(angle), 45.0 * np.sin(angle)]))))


def _lightness_colour(lightness: float) -> QColor:
    return QColor(*(int(v) for v in codes_of(np.array([min(100.0, lightness), 0.0, 0.0]))))
