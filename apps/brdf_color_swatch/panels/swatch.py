"""What is selected: name, code, tags and notes to be edited, and the figures of the paint with their units."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from datetime import datetime
from functools import partial
from operator import attrgetter, eq
from typing import TypeVar

import numpy as np
from brdf_qt.fields.form import described, fill_column
from brdf_qt.fields.labels import PlainLabel, plain_tip
from brdf_qt.program.translation import decimal, tr
from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QTextOption
from PySide6.QtWidgets import QFormLayout, QLineEdit, QPlainTextEdit, QWidget

from brdf_color_swatch.grid.rows import codes_of, group_title
from brdf_suite.appearance.colour.flat_colours import flat_labs
from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.paint import Paint
from brdf_suite.documents.palette import Entry

_VARIOUS = "…"
_Value = TypeVar("_Value")


class _Chips(QWidget):
    """The measured colours side by side, each with its angle and L*a*b*."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._readings: list[tuple[str, tuple[float, float, float], QColor]] = []
        self.setMinimumHeight(56)

    def show_readings(self, readings: Sequence[tuple[str, tuple[float, float, float]]]) -> None:
        codes = codes_of(np.array([lab for _, lab in readings])) if readings else np.zeros((0, 3))
        self._readings = [
            (name, lab, QColor(*(int(part) for part in code)))
            for (name, lab), code in zip(readings, codes, strict=True)
        ]
        lines = [
            decimal(f"{name} L* {lab[0]:.1f} a* {lab[1]:.1f} b* {lab[2]:.1f}")
            for name, lab, _ in self._readings
        ]
        self.setAccessibleName(tr("Measured colours"))
        self.setAccessibleDescription("; ".join(lines))
        self.setToolTip(plain_tip("\n".join(lines)))
        self.setVisible(bool(readings))
        self.update()

    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = QPainter(self)
        count = len(self._readings)
        for number, (name, lab, colour) in enumerate(self._readings):
            left, right = self.width() * number // count, self.width() * (number + 1) // count
            painter.fillRect(left, 0, right - left, self.height(), colour)
            if right - left >= 30:
                painter.setPen(QColor(235, 235, 235) if lab[0] < 55 else QColor(15, 15, 15))
                painter.drawText(
                    left, 0, right - left, self.height() - 4,
                    Qt.AlignmentFlag.AlignHCenter | Qt.AlignmentFlag.AlignBottom, name,
                )  # fmt: skip


class _Notes(QPlainTextEdit):
    """Multi-line text, emitted when the field loses focus: one undo step per edit."""

    finished = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setTabChangesFocus(True)
        self.setWordWrapMode(QTextOption.WrapMode.WordWrap)
        self.setMaximumHeight(96)
        self._shown = ""

    def show_text(self, text: str) -> None:
        if text != self._shown or not self.hasFocus():
            self._shown = text
            if self.toPlainText() != text:
                self.setPlainText(text)

    def focusOutEvent(self, event: object) -> None:
        super().focusOutEvent(event)  # type: ignore[arg-type]  # a QFocusEvent
        self.finish()

    def finish(self) -> None:
        """Emit the text if it has changed."""
        text = self.toPlainText()
        if text != self._shown:
            self._shown = text
            self.finished.emit(text)


class SwatchPanel(QWidget):
    """Signal ``edited(key, text)`` with ``name``, ``code``, ``tags`` or ``notes``, for all that is selected."""

    edited = Signal(str, str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.title = PlainLabel(wordWrap=True)
        self.chips = _Chips()
        self.fields: dict[str, QLineEdit] = {}
        self._shown: dict[str, str] = {}
        form = QFormLayout()
        form.setLabelAlignment(Qt.AlignmentFlag.AlignRight)
        form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.ExpandingFieldsGrow)
        labels = {"name": tr("Name"), "code": tr("Code"), "tags": tr("Tags")}
        for key, label in labels.items():
            field = described(QLineEdit(), name=f"swatch_{key}", spoken=label)
            field.setMinimumWidth(60)
            field.editingFinished.connect(lambda key=key: self._finished(key))
            field.installEventFilter(self)
            self.fields[key] = field
            form.addRow(label, field)
        self.fields["name"].setMaxLength(200)
        self.fields["code"].setMaxLength(200)
        self.fields["tags"].setPlaceholderText(tr("comma-separated"))
        tip = tr("Search terms, comma-separated. With several swatches, +word adds and -word removes a tag.")
        described(self.fields["tags"], tip=tip)
        self.notes = described(_Notes(), name="swatch_notes", spoken=tr("Notes"))
        self.notes.finished.connect(lambda text: self.edited.emit("notes", text))
        form.addRow(tr("Notes"), self.notes)
        self.figures = PlainLabel(wordWrap=True)
        self.figures.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        fill_column(self, self.title, self.chips, form, self.figures)
        self.show_entries([], "")

    def show_entries(self, entries: Sequence[Entry], figures: str, *, read_only: bool = False) -> None:
        """Show what is selected; fields in which they differ are marked by an ellipsis."""
        one = entries[0] if len(entries) == 1 else None
        if not entries:
            title = tr("No swatch selected. Click one, or drag around several.")
        elif one is not None:
            title = group_title(one.group) if one.group else ""
        else:
            title = tr("{count} swatches selected. Edits apply to all.").format(count=len(entries))
            if read_only:
                title = tr("{count} swatches selected.").format(count=len(entries))
        self.title.setText(title)
        self.title.setVisible(bool(title))
        tags = _common(map(attrgetter("tags"), entries))
        values = {
            "name": _common(map(attrgetter("name"), entries)),
            "code": _common(map(attrgetter("code"), entries)),
            "tags": None if tags is None else ", ".join(tags),
        }
        for key, field in self.fields.items():
            text = values[key] or ""
            self._shown[key] = text
            if not (field.hasFocus() and field.isModified()):
                field.setText(text)
                field.setCursorPosition(0)
            if key != "tags":
                field.setPlaceholderText(_VARIOUS if entries and values[key] is None else "")
            field.setEnabled(bool(entries))
            field.setReadOnly(read_only)
        notes = _common(map(attrgetter("notes"), entries))
        self.notes.show_text(notes or "")
        self.notes.setPlaceholderText(_VARIOUS if entries and notes is None else "")
        self.notes.setEnabled(bool(entries))
        self.notes.setReadOnly(read_only)
        self.chips.show_readings(readings_of(one) if one is not None else [])
        self.figures.setText(figures)
        self.figures.setVisible(bool(figures))

    def focus(self, key: str) -> None:
        field = self.notes if key == "notes" else self.fields[key]
        field.setFocus(Qt.FocusReason.ShortcutFocusReason)
        field.selectAll()

    def _finished(self, key: str) -> None:
        field = self.fields[key]
        text = field.text().strip()
        if field.isModified() and text != self._shown.get(key, ""):
            field.setModified(False)
            self._shown[key] = text
            self.edited.emit(key, text)
        field.setModified(False)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.KeyPress and isinstance(watched, QLineEdit):
            key = watched.objectName().removeprefix("swatch_")
            if event.key() == Qt.Key.Key_Escape:  # type: ignore[attr-defined]  # a QKeyEvent
                watched.setText(self._shown.get(key, ""))
                watched.setModified(False)
                return True
        return super().eventFilter(watched, event)


def _common(values: Iterable[_Value]) -> _Value | None:
    """Return the value that all are; None where they differ, or where there are none. The first other one ends it."""
    found = iter(values)
    first = next(found, None)
    return first if all(map(partial(eq, first), found)) else None


def readings_of(entry: Entry) -> list[tuple[str, tuple[float, float, float]]]:
    """Return the readings of an entry by what they are called, in the order of their angles."""
    content = entry.content
    if isinstance(content, FlatColour):
        lab = flat_labs([content])[0]
        return [("", (float(lab[0]), float(lab[1]), float(lab[2])))]
    if isinstance(content, Paint):
        light = content.main_light_deg
        found = sorted(
            (one.aspecular_deg, one.lab) for one in content.measurements if one.illumination_deg == light
        )
        return [(f"{angle:g}°", lab) for angle, lab in found]
    return []


def today() -> str:
    """Return the moment in ISO 8601, to the second, with the offset from UTC."""
    return datetime.now().astimezone().isoformat(timespec="seconds")
