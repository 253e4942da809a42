"""What a pane lets pass by its figures, each a range on a slider with two ends: hue … gloss; and duplicates."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from brdf_qt.fields.form import described, fill_column, row_of
from brdf_qt.fields.labels import PlainLabel, plain_tip
from brdf_qt.fields.number import NumberField
from brdf_qt.program.translation import mark, tr
from PySide6.QtCore import QRectF, QSize, Qt, Signal
from PySide6.QtGui import (
    QColor,
    QKeyEvent,
    QLinearGradient,
    QMouseEvent,
    QPainter,
    QPaintEvent,
    QPalette,
    QPen,
)
from PySide6.QtWidgets import QCheckBox, QPushButton, QWidget

from brdf_color_swatch.grid.rows import codes_of
from brdf_color_swatch.grid.view_state import RANGES, PaneState

_HANDLE = 6
_TRACK = 8


class _Track(QWidget):
    """The slider itself. ``moved(low, high)`` while dragged, ``released()`` at the end of it."""

    moved = Signal(float, float)

    def __init__(
        self,
        low: float,
        high: float,
        step: float,
        colour_at: Callable[[float], QColor] | None,
        *,
        wraps: bool,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._ends = (low, high)
        self.values = [low, high]
        self._step, self._colour_at, self._wraps = step, colour_at, wraps
        self._held: int | None = None
        self._keyed = 0
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMinimumHeight(22)

    def set_values(self, low: float, high: float) -> None:
        self.values = [low, high]
        self.update()

    def sizeHint(self) -> QSize:
        return QSize(160, 22)

    def x_of(self, value: float) -> float:
        low, high = self._ends
        return _HANDLE + (self.width() - 2 * _HANDLE) * (value - low) / (high - low)

    def _value(self, x: float) -> float:
        low, high = self._ends
        share = min(1.0, max(0.0, (x - _HANDLE) / max(1, self.width() - 2 * _HANDLE)))
        return round((low + share * (high - low)) / self._step) * self._step

    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        middle = self.height() / 2
        track = QRectF(_HANDLE, middle - _TRACK / 2, self.width() - 2 * _HANDLE, _TRACK)
        role = QPalette.ColorRole
        if self._colour_at is None:
            painter.fillRect(track, self.palette().color(role.Mid))
        else:
            ramp = QLinearGradient(track.topLeft(), track.topRight())
            low, high = self._ends
            for number in range(13):
                ramp.setColorAt(number / 12, self._colour_at(low + (high - low) * number / 12))
            painter.fillRect(track, ramp)
        shade = QColor(self.palette().color(role.Window))
        shade.setAlpha(200)
        first, last = self.x_of(self.values[0]), self.x_of(self.values[1])
        hidden = (
            [QRectF(track.left(), track.top() - 1, first - track.left(), _TRACK + 2),
             QRectF(last, track.top() - 1, track.right() - last, _TRACK + 2)]
            if first <= last
            else [QRectF(last, track.top() - 1, first - last, _TRACK + 2)]
        )  # fmt: skip
        for box in hidden:
            painter.fillRect(box, shade)
        for number, x in enumerate((first, last)):
            focused = self.hasFocus() and number == self._keyed
            colour = self.palette().color(role.Highlight if focused else role.WindowText)
            painter.setPen(QPen(colour, 2 if focused else 1))
            painter.setBrush(self.palette().color(role.Button))
            painter.drawRoundedRect(QRectF(x - 4, middle - 9, 8, 18), 2, 2)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        x = event.position().x()
        away = [abs(self.x_of(value) - x) for value in self.values]
        together = abs(away[0] - away[1]) < 1e-6
        first = x < self.x_of(self.values[0]) if together else away[0] < away[1]
        self._held = self._keyed = 0 if first else 1
        self._to(self._value(x))

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if self._held is not None:
            self._to(self._value(event.position().x()))

    def mouseReleaseEvent(self, _event: QMouseEvent) -> None:
        self._held = None

    def mouseDoubleClickEvent(self, _event: QMouseEvent) -> None:
        self._held = None
        self._set(*self._ends)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        keys = {Qt.Key.Key_Left: -1, Qt.Key.Key_Down: -1, Qt.Key.Key_Right: 1, Qt.Key.Key_Up: 1}
        way = keys.get(Qt.Key(event.key()))
        if event.key() in (Qt.Key.Key_Space, Qt.Key.Key_Return):
            self._keyed = 1 - self._keyed
            self.update()
        elif way is None:
            super().keyPressEvent(event)
        else:
            step = self._step * (10 if event.modifiers() & Qt.KeyboardModifier.ShiftModifier else 1)
            self._held = self._keyed
            self._to(self.values[self._keyed] + way * step)
            self._held = None

    def _to(self, value: float) -> None:
        assert self._held is not None
        low, high = self._ends
        values = list(self.values)
        values[self._held] = min(high, max(low, value))
        if not self._wraps and values[0] > values[1]:
            values[1 - self._held] = values[self._held]
        self._set(*values)

    def _set(self, low: float, high: float) -> None:
        if [low, high] != self.values:
            self.values = [low, high]
            self.update()
            self.moved.emit(low, high)


class RangeField(QWidget):
    """A name, two numbers with their unit, and a slider with two ends; a double click on it lets all pass again.

    ``wraps``: the first end may be past the last, as the hue's from red over 0° to violet. Signal
    ``edited(low, high)``.
    """

    edited = Signal(float, float)

    def __init__(
        self,
        name: str,
        unit: str,
        ends: tuple[float, float],
        step: float = 1.0,
        decimals: int = 0,
        colour_at: Callable[[float], QColor] | None = None,
        *,
        wraps: bool = False,
        tip: str = "",
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._ends = ends
        names = tr("{name}, from").format(name=name), tr("{name}, to").format(name=name)
        self.low, self.high = (
            NumberField(spoken, unit, *ends, step, decimals, end)
            for spoken, end in zip(names, ends, strict=True)
        )
        self.track = _Track(*ends, step, colour_at, wraps=wraps)
        keys = tr("Space switches the handle; double-click clears the filter.")
        described(self.track, spoken=name, tip=f"{tip}\n{keys}".strip())
        self._wraps = wraps
        label = described(PlainLabel(name), tip=tip)
        for field in (self.low, self.high):
            field.setMaximumWidth(84)
            field.edited.connect(lambda _value, field=field: self._typed(field))
        head = row_of(label, self.low, PlainLabel("–"), self.high, grows=label, spacing=4)
        fill_column(self, head, self.track, spacing=0)
        self.track.moved.connect(self._take)

    def set_range(self, low: float, high: float) -> None:
        """Show a range; nothing is emitted."""
        self.low.set_value(low)
        self.high.set_value(high)
        self.track.set_values(low, high)

    def _typed(self, field: NumberField) -> None:
        low, high = self.low.value(), self.high.value()
        if not self._wraps and low > high:
            low, high = (low, low) if field is self.low else (high, high)
        self._take(low, high)

    def _take(self, low: float, high: float) -> None:
        self.set_range(low, high)
        self.edited.emit(low, high)


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
        self.fields: dict[str, RangeField] = {}
        for key, (name, unit, step, decimals, tip) in _FIELDS.items():
            colour = {"hue": _hue_colour, "lightness": _lightness_colour}.get(key)
            field = RangeField(
                tr(name), unit, RANGES[key], step, decimals, colour, wraps=key == "hue", tip=tr(tip)
            )
            field.edited.connect(lambda low, high, key=key: self.range_edited.emit(key, low, high))
            self.fields[key] = described(field, name=f"filter_{key}")
        tip = tr("Show only swatches within this ΔE00 of another at every angle, by group")
        self.duplicates = described(QCheckBox(tr("Duplicates within")), name="duplicates", tip=tip)
        self.tolerance = NumberField(tr("Duplicate tolerance"), "ΔE00", 0.0, 20.0, 0.1, 2, DEFAULT_TOLERANCE)
        self.tolerance.setToolTip(plain_tip(tip))
        self.clear = described(QPushButton(tr("Clear Filters")), name="clear_filters")
        self.clear.clicked.connect(self.cleared)
        row = row_of(self.duplicates, self.tolerance, grows=self.duplicates)
        fill_column(self, *self.fields.values(), row, row_of(None, self.clear))
        self.duplicates.clicked.connect(lambda _on: self._request_duplicates())
        self.tolerance.edited.connect(
            lambda _value: self._request_duplicates() if self.duplicates.isChecked() else None
        )

    def show_state(self, state: PaneState) -> None:
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
