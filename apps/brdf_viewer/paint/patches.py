"""The paint's colours at its measured angles, each beside what the fitted lobes give."""

from __future__ import annotations

import itertools
from collections.abc import Sequence

import numpy as np
from brdf_qt.fields.labels import plain_tip
from brdf_qt.fields.marks import SIZE, draw_mark
from brdf_qt.program.translation import decimal, tr
from brdf_qt.work.fit_error import fit_mark, is_large, large_error_tip
from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QHelpEvent, QPainter, QPaintEvent, QPalette
from PySide6.QtWidgets import QSizePolicy, QToolTip, QWidget

from brdf_suite.appearance.colour.colorimetry import in_srgb_gamut, lab_to_working, working_to_display
from brdf_suite.documents.paint import Lab
from brdf_suite.fitting.metrics import AngleError

_GAP = 8
_HEIGHT = 84
_MOST = 6


class PaintPatches(QWidget):
    """A row of patches: the upper part as measured, the lower strip as fitted, the angle under each.

    Readings under several lights stand light by light, with the light's angle under its patches. An angle that the
    fit misses by much stands out: bold and marked.
    """

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.patches: tuple[AngleError, ...] = ()
        self.time_limited = self.exact_follows = False
        self._colours: list[tuple[QColor, QColor, bool]] = []
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setMinimumHeight(_HEIGHT)
        self.setAccessibleName(tr("Colours at the measured angles"))

    def set_patches(
        self, patches: Sequence[AngleError], time_limited: bool = False, exact_follows: bool = False
    ) -> None:
        """Show ``patches``, by light and from the smallest aspecular angle on; many angles are thinned.

        ``time_limited``: the limit of the fit came before the optimum; ``exact_follows``: which is still looked for.
        """
        self.time_limited, self.exact_follows = time_limited, exact_follows
        ordered = sorted(patches, key=lambda patch: (patch.illumination_deg, patch.aspecular_deg))
        keep = np.unique(np.linspace(0, len(ordered) - 1, min(_MOST, len(ordered))).round().astype(int))
        self.patches = tuple(ordered[i] for i in keep) if ordered else ()
        self.setMinimumHeight(_HEIGHT + (self._line() if self.names_lights else 0))
        self.updateGeometry()
        self._colours = [
            (_screen(p.lab), _screen(p.lab_fitted), bool(in_srgb_gamut(np.array(p.lab))))
            for p in self.patches
        ]
        self.setAccessibleDescription("; ".join(map(self._words, self.patches)))
        self.update()

    @property
    def names_lights(self) -> bool:
        """Whether there are readings under more than one light, which are then named."""
        return len({patch.illumination_deg for patch in self.patches}) > 1

    def sizeHint(self) -> QSize:
        return QSize(240, self.minimumHeight())

    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        label = self.fontMetrics().height()
        below = label + 4 + (self._line() if self.names_lights else 0)
        for patch, (asked, fitted, inside), box in zip(
            self.patches, self._colours, self._boxes(), strict=True
        ):
            body = box.adjusted(0, 0, 0, -below)
            split = round(body.height() * 0.7)  # whole pixels: no seam where both colours are one
            painter.fillRect(QRectF(body.left(), body.top(), body.width(), split), asked)
            below_split = QRectF(body.left(), body.top() + split, body.width(), body.height() - split)
            painter.fillRect(below_split, fitted)
            if not inside:
                _mark_out_of_gamut(painter, body, asked)
            painter.setPen(self.palette().color(QPalette.ColorRole.WindowText))
            under = QRectF(box.left(), body.bottom() + 4, box.width(), label)
            font = painter.font()
            font.setBold(is_large(patch.delta_e_2000))
            painter.setFont(font)
            angle = f"{patch.aspecular_deg:g}°"
            painter.drawText(under, Qt.AlignmentFlag.AlignCenter, angle)
            sign = fit_mark(patch.delta_e_2000)
            if sign is not None:
                wide = painter.fontMetrics().horizontalAdvance(angle)
                left = max(box.left(), under.center().x() - wide / 2 - SIZE - 2)
                draw_mark(painter, sign, left, under.center().y())
        if self.names_lights:
            self._paint_lights(painter, label)

    def _paint_lights(self, painter: QPainter, label: int) -> None:
        """Write each light's angle under its patches, with a line over it from the first to the last."""
        font = painter.font()
        font.setBold(False)
        painter.setFont(font)
        placed = zip(self.patches, self._boxes(), strict=True)
        for degrees, group in itertools.groupby(placed, key=lambda item: item[0].illumination_deg):
            boxes = [box for _, box in group]
            area = QRectF(boxes[0].left(), self.height() - label, boxes[-1].right() - boxes[0].left(), label)
            painter.fillRect(QRectF(area.left(), area.top() - 1, area.width(), 1), painter.pen().color())
            forms = (tr("light {angle:g}°").format(angle=degrees), f"{degrees:g}°")
            fitting = (form for form in forms if self.fontMetrics().horizontalAdvance(form) <= area.width())
            painter.drawText(area, Qt.AlignmentFlag.AlignCenter, next(fitting, forms[-1]))

    def _line(self) -> int:
        return self.fontMetrics().height() + 3

    def event(self, event: QEvent) -> bool:
        if isinstance(event, QHelpEvent) and event.type() == QEvent.Type.ToolTip:
            for patch, box in zip(self.patches, self._boxes(), strict=True):
                if box.contains(QPointF(event.pos())):
                    QToolTip.showText(event.globalPos(), plain_tip(self._words(patch)), self)
                    return True
            QToolTip.hideText()
            return True
        return super().event(event)

    def _words(self, patch: AngleError) -> str:
        lab = "L* {:.1f}  a* {:.1f}  b* {:.1f}"
        angles = tr("Light {light:g}°, aspecular {aspecular:g}°")
        lines = [
            angles.format(light=patch.illumination_deg, aspecular=patch.aspecular_deg),
            tr("target") + " " + lab.format(*patch.lab),
            tr("fit") + " " + lab.format(*patch.lab_fitted),
            decimal(f"ΔE00 {patch.delta_e_2000:.2f}"),
        ]
        if is_large(patch.delta_e_2000):
            lines.append(large_error_tip(self.time_limited, self.exact_follows))
        if not in_srgb_gamut(np.array(patch.lab)):
            lines.append(tr("Outside this screen's colours: shown clipped"))
        return "\n".join(lines)

    def _boxes(self) -> list[QRectF]:
        count = max(1, len(self.patches))
        lefts = [round(i * (self.width() + _GAP) / count) for i in range(count + 1)]
        return [
            QRectF(left, 0, right - _GAP - left, self.height()) for left, right in itertools.pairwise(lefts)
        ][: len(self.patches)]


def _screen(lab: Lab) -> QColor:
    red, green, blue = np.clip(working_to_display(lab_to_working(np.array(lab))), 0.0, 1.0)
    return QColor.fromRgbF(float(red), float(green), float(blue))


def _mark_out_of_gamut(painter: QPainter, body: QRectF, asked: QColor) -> None:
    """A small triangle in the corner, black or white against the colour: this screen cannot show it."""
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(Qt.GlobalColor.black if asked.lightnessF() > 0.5 else Qt.GlobalColor.white)
    corner = body.topRight()
    painter.drawPolygon([corner, corner + QPointF(-9, 0), corner + QPointF(0, 9)])
    painter.setBrush(Qt.BrushStyle.NoBrush)
