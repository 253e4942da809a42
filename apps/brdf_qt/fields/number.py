"""A number with its unit: typed, dragged sideways, wheeled, stepped by keys, copied and pasted, reset.

Signals
-------
edited(float)
    The user changed the value; never emitted by :meth:`NumberField.set_value`.
gesture_started, gesture_finished
    Around a drag and around a burst of wheel turns or key steps, so that the owner makes one undo step of it.
    A typed value and a reset come without them: each is a step of its own.
limited(text)
    A typed or pasted number lies beyond the range; the text says which end was taken instead. It is shown beside
    the field, too.
"""

from __future__ import annotations

import math
import re

from PySide6.QtCore import QEvent, QLocale, QObject, QPointF, QSignalBlocker, Qt, Signal
from PySide6.QtGui import (
    QFocusEvent,
    QGuiApplication,
    QHelpEvent,
    QKeyEvent,
    QKeySequence,
    QMouseEvent,
    QPalette,
    QValidator,
    QWheelEvent,
)
from PySide6.QtWidgets import QAbstractSpinBox, QDoubleSpinBox, QToolTip, QWidget

from brdf_qt.fields.burst import Burst
from brdf_qt.fields.labels import plain_tip
from brdf_qt.fields.text import is_of_window
from brdf_qt.program.translation import decimal, tr
from brdf_suite.documents.parameter import Parameter

_NUMBER = re.compile(r"[-+−]?(?:\d+[.,]?\d*|[.,]\d+)(?:[eE][-+]?\d+)?")
_UNFINISHED = re.compile(r"^\s*[-+−]?[.,]?\s*$")
LONGEST = 64
"""Characters of a number that are looked at: with a million of them a field would be busy for seconds."""
DRAG_START_PX = 4
PX_PER_STEP = 4
_TIP_MS = 6000


def parse_number(text: str) -> float | None:
    """Return the first number in ``text`` (a decimal comma and a true minus sign pass), or ``None``.

    >>> parse_number("12,5 GU")
    12.5
    """
    found = _NUMBER.search(text[:LONGEST])
    number = float(found.group().replace(",", ".").replace("−", "-")) if found else math.nan
    return number if math.isfinite(number) else None


def reach_of(parameter: Parameter, step: float, decimals: int) -> tuple[str, float, float, float, int, float]:
    """Return unit, range, step, decimals and default of a document's number, as a field takes them after its name."""
    return parameter.unit, parameter.low, parameter.high, step, decimals, parameter.default


def _suffix(unit: str) -> str:
    """Return a unit as it stands behind a number: the degree without a space, others with one."""
    return unit if unit in ("", "°") else f" {unit}"


class NumberField(QDoubleSpinBox):
    """One number; double click resets it to ``default``, Shift drags finely, Ctrl coarsely.

    ``default`` is what was given first, until :meth:`set_default` makes it the value of the document that is open.
    """

    edited = Signal(float)
    gesture_started = Signal()
    gesture_finished = Signal()
    limited = Signal(str)

    def __init__(
        self,
        name: str,
        unit: str = "",
        minimum: float = 0.0,
        maximum: float = 1.0,
        step: float = 0.1,
        decimals: int = 2,
        default: float | None = None,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self.default = minimum if default is None else default
        self._press: QPointF | None = None
        self._press_value = 0.0
        self._dragging = False
        self._typing = False
        self._beyond: float | None = None
        self.setLocale(QLocale.c())
        self.setButtonSymbols(QAbstractSpinBox.ButtonSymbols.NoButtons)
        self.setKeyboardTracking(False)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setAlignment(Qt.AlignmentFlag.AlignRight)
        # Filled behind its round corners too, it is drawn without the window behind it.
        self.setBackgroundRole(QPalette.ColorRole.Window)
        self.setAutoFillBackground(True)
        self.set_reach(name, unit, minimum, maximum, step, decimals, wrapping=False)
        self.set_value(self.default)
        self._burst = Burst(self)
        self._burst.started.connect(self.gesture_started)
        self._burst.finished.connect(self.gesture_finished)
        self.valueChanged.connect(self.edited)
        self.editingFinished.connect(self._report_limit)
        self.lineEdit().installEventFilter(self)
        self.lineEdit().setCursor(Qt.CursorShape.SizeHorCursor)
        self.lineEdit().setMaxLength(LONGEST)

    def set_reach(
        self,
        name: str,
        unit: str,
        minimum: float,
        maximum: float,
        step: float,
        decimals: int,
        *,
        wrapping: bool,
    ) -> None:
        """Become the number ``name`` of another range, without a signal; ``wrapping``: its ends are one."""
        self.unit = unit
        self._set: tuple[float, float] | None = None
        self.setAccessibleName(f"{name}, {unit}" if unit else name)
        with QSignalBlocker(self):
            self.setSuffix(_suffix(unit))
            self.setWrapping(wrapping)
            self.setDecimals(decimals)
            self.setRange(minimum, maximum)
            self.setSingleStep(step)

    def set_value(self, value: float) -> None:
        """Show ``value`` without a signal."""
        if self._press is not None and not self._dragging:
            # A drag goes on from what is shown, also where that has changed under the button.
            self._press_value = value
        # A drag sets every number a hundred times a second: what it shows already is not set and drawn anew. Only
        # where it has the focus may its text be another than its value says.
        if (value, self.value()) == self._set and not self.hasFocus():
            return
        # The field itself keeps no more decimals than it shows.
        same = round(value, self.decimals()) == self.value()
        if not (same and self.text() == self.textFromValue(value) + self.suffix()):
            with QSignalBlocker(self):
                self.setValue(value)
        self._set = (value, self.value())

    def set_default(self, value: float) -> None:
        """Take ``value``, within the range, as what a reset goes back to."""
        self.default = min(self.maximum(), max(self.minimum(), value))

    def reset(self) -> None:
        """Go back to the default, as one edit."""
        self.setValue(self.default)

    def textFromValue(self, value: float) -> str:
        text = f"{value:.{self.decimals()}f}"
        return decimal(text[1:] if float(text) == 0.0 and text.startswith("-") else text)

    def valueFromText(self, text: str) -> float:
        number = parse_number(text)
        return self.value() if number is None else self._within(number)

    def _within(self, number: float) -> float:
        """Return the number, or the end of the range that it lies beyond; which is reported once editing is over."""
        if self.wrapping():
            return self.minimum() + (number - self.minimum()) % (self.maximum() - self.minimum())
        kept = min(self.maximum(), max(self.minimum(), number))
        # What is shown has fewer decimals than the ends of a range may have.
        beyond = abs(kept - number) > 0.5 * 10.0 ** -self.decimals()
        self._beyond = number if beyond else None
        return kept

    def _report_limit(self) -> None:
        number, self._beyond = self._beyond, None
        if number is None:
            return
        low = number < self.minimum()
        end = self.textFromValue(self.minimum() if low else self.maximum())
        unit = _suffix(self.unit)
        below = tr("{number} is below the minimum; the value was set to {end}.")
        above = tr("{number} is above the maximum; the value was set to {end}.")
        text = (below if low else above).format(number=f"{decimal(f'{number:g}')}{unit}", end=f"{end}{unit}")
        place = self.mapToGlobal(self.rect().bottomLeft())
        QToolTip.showText(place, plain_tip(text), self, self.rect(), _TIP_MS)
        self.limited.emit(text)

    def validate(self, text: str, position: int) -> tuple[QValidator.State, str, int]:
        body = text.removesuffix(self.suffix()).strip()
        if len(text) > LONGEST + len(self.suffix()):
            return QValidator.State.Invalid, text[:LONGEST], position
        if _NUMBER.fullmatch(body) or (self.unit and _NUMBER.fullmatch(body.removesuffix(self.unit).strip())):
            return QValidator.State.Acceptable, text, position
        if not body or _UNFINISHED.match(body):
            return QValidator.State.Intermediate, text, position
        return QValidator.State.Invalid, text, position

    def stepBy(self, steps: int) -> None:
        self._burst.touch()
        super().stepBy(steps)

    def event(self, event: QEvent) -> bool:
        """Leave undo and redo to the document: the line's own history would undo something else."""
        if is_of_window(event):
            event.ignore()
            return False
        if event.type() == QEvent.Type.ToolTip and isinstance(event, QHelpEvent):
            QToolTip.showText(event.globalPos(), plain_tip(self._tip()), self)
            return True
        return super().event(event)

    def _tip(self) -> str:
        """What the number is, its range, and what a double click gives."""
        unit = _suffix(self.unit)
        low, high, default = (self.textFromValue(v) for v in (self.minimum(), self.maximum(), self.default))
        text = tr("{low} to {high}; double click: {default}")
        reach = text.format(low=low, high=f"{high}{unit}", default=f"{default}{unit}")
        return f"{self.toolTip()}\n{reach}" if self.toolTip() else reach

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Turn only the field that has the focus: a wheel that scrolls the inspector changes no value."""
        if self.hasFocus():
            super().wheelEvent(event)
        else:
            event.ignore()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        line = self.lineEdit()
        clipboard = QGuiApplication.clipboard()
        whole = line.selectedText() in ("", line.text(), self.cleanText())
        if event.matches(QKeySequence.StandardKey.Copy) and whole:
            clipboard.setText(self.text())
        elif event.matches(QKeySequence.StandardKey.Paste):
            number = parse_number(clipboard.text())
            if number is not None:
                self.setValue(self._within(number))
                self.selectAll()
                self._report_limit()
        elif event.key() == Qt.Key.Key_Escape and line.isModified():
            self.set_value(self.value())
            line.setText(self.text())
            self.selectAll()
        else:
            self._typing = self._typing or bool(event.text())
            super().keyPressEvent(event)
            if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
                self._typing = False
                self.selectAll()

    def focusOutEvent(self, event: QFocusEvent) -> None:
        self._typing = False
        self._burst.end()
        super().focusOutEvent(event)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if watched is self.lineEdit() and isinstance(event, QMouseEvent) and self.isEnabled():
            return self._mouse(event)
        return super().eventFilter(watched, event)

    def _mouse(self, event: QMouseEvent) -> bool:
        kind = event.type()
        if kind == QEvent.Type.MouseButtonDblClick and event.button() == Qt.MouseButton.LeftButton:
            self._typing = False
            self._press = None
            self.reset()
            self.selectAll()
            return True
        if self._typing:
            return False
        if kind == QEvent.Type.MouseButtonPress and event.button() == Qt.MouseButton.LeftButton:
            self._burst.end()
            self._press, self._press_value, self._dragging = event.globalPosition(), self.value(), False
            self.setFocus(Qt.FocusReason.MouseFocusReason)
            return True
        if kind == QEvent.Type.MouseMove and self._press is not None:
            self._drag(event)
            return True
        if kind == QEvent.Type.MouseButtonRelease and self._press is not None:
            self._press = None
            if self._dragging:
                self._dragging = False
                self.gesture_finished.emit()
            else:
                self._typing = True
                self.selectAll()
            return True
        return False

    def _drag(self, event: QMouseEvent) -> None:
        assert self._press is not None
        moved = event.globalPosition().x() - self._press.x()
        if not self._dragging:
            if abs(moved) < DRAG_START_PX:
                return
            self._dragging = True
            self.gesture_started.emit()
        keys = event.modifiers()
        scale = 0.1 if keys & Qt.KeyboardModifier.ShiftModifier else 1.0
        scale = 10.0 if keys & Qt.KeyboardModifier.ControlModifier else scale
        steps = round(moved / PX_PER_STEP * 10) / 10 if scale < 1 else round(moved / PX_PER_STEP)
        self.setValue(self._press_value + steps * scale * self.singleStep())
