"""The readout of a plot: the angle under the mouse and the value of each line there, with its unit."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from brdf_qt.program.translation import tr
from PySide6.QtCore import Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QPalette
from PySide6.QtWidgets import QLabel, QWidget

from brdf_lobe_visualizer.cuts.lines import Kind, Lines
from brdf_lobe_visualizer.cuts.pens import colour_of
from brdf_lobe_visualizer.subjects.subjects import Srgb
from brdf_lobe_visualizer.words import number
from brdf_suite.foreign_text import escape_html

_MOST_ROWS = 12
_MARGIN = 6


@dataclass(frozen=True)
class Row:
    """One line at the crosshair: ``value`` is NaN where there is none."""

    title: str
    colour: Srgb
    kind: Kind
    value: float
    filled: bool = False


def rows_at(lines: Lines, angle_deg: float) -> tuple[float, tuple[Row, ...]]:
    """Return the angle of the cut that is nearest to ``angle_deg``, and the values of all lines there."""
    angles = lines.cut.angle_deg
    place = int(np.argmin(np.abs(angles - angle_deg)))
    rows = []
    for line in sorted(lines.lines, key=lambda line: not line.is_front):
        filled = line.filled is not None and bool(line.filled[place])
        rows.append(Row(line.title, line.colour, line.kind, float(line.value[place]), filled))
    return float(angles[place]), tuple(rows)


class Readout(QLabel):
    """Lies over a plot, in the corner away from the mouse; the mouse goes through it."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setObjectName("readout")
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.setTextFormat(Qt.TextFormat.RichText)
        self.setMargin(_MARGIN)
        self.hide()

    def show_rows(self, head: str, rows: Sequence[Row], unit: str, *, at_right: bool) -> None:
        """Show ``head``, the angle, and a row for each line; ``at_right``: in the right corner."""
        base = self.palette().color(QPalette.ColorRole.Base)
        shown = rows[:_MOST_ROWS]
        cells = []
        for row in shown:
            mark = f'<span style="color:{colour_of(row.colour, base).name()}">━</span>'
            value = number(row.value) + (" " + tr("(filled in)") if row.filled else "")
            kind = {"fit": " · " + tr("fit"), "difference": " · " + tr("difference"), "target": ""}[row.kind]
            title = row.title if len(row.title) <= 28 else row.title[:27] + "…"
            name = escape_html(title + kind)
            cells.append(
                f"<tr><td>{mark}&nbsp;{name}&nbsp;&nbsp;</td><td align='right'>{escape_html(value)}</td></tr>"
            )
        if len(rows) > len(shown):
            more = tr("and {count} more").format(count=len(rows) - len(shown))
            cells.append(f"<tr><td>{escape_html(more)}</td><td></td></tr>")
        self.setText(
            f"<b>{escape_html(head)}</b>&nbsp;&nbsp;<span>{escape_html(unit)}</span><table>{''.join(cells)}</table>"
        )
        self.adjustSize()
        parent = self.parentWidget()
        area = self.rect() if parent is None else parent.rect()
        left = area.right() - self.width() - _MARGIN if at_right else area.left() + 56
        self.move(max(0, left), area.top() + _MARGIN)
        self.show()
        self.raise_()

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        back = QColor(self.palette().color(QPalette.ColorRole.Base))
        back.setAlphaF(0.88)
        painter.fillRect(self.rect(), back)
        painter.end()
        super().paintEvent(event)
