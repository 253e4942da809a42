"""What can be gripped on the flop strip: the travel of L*, C* and h at either end, the flop index at the face."""

from __future__ import annotations

import math
from dataclasses import dataclass

from brdf_qt.program.translation import decimal, mark, tr
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QPainter, QPalette, QPen

from brdf_designer.colour.flop_panel import DECIMALS, HANDLES, Handle
from brdf_suite.appearance.flop.edits import FlopValues, flop_ends, measure_flop
from brdf_suite.documents.paint import Paint
from brdf_suite.errors import ValueRangeError

RADIUS = 8.5
_APART = 20.0
_MARGIN = 20.0
"""Room at the ends of the strip, which has its mark of colours outside sRGB in a corner."""
_BY_KEY = {handle.key: handle for handle in HANDLES}
_LETTERS = {"index": "F", "lightness": "L", "chroma": "C", "hue": "h"}
_PER_PIXEL = {"index": 0.05, "lightness": 0.2, "chroma": 0.2, "hue": 0.5}
_PLACES = {-1: mark("near end"), 0: mark("face"), 1: mark("far end")}
_TIPS = {
    -1: mark(
        "Drag up or down, or press Up and Down (Shift: fine): this end follows, the "
        "far end moves the opposite way, the face stays. A double click restores the "
        "value of the opened document."
    ),
    0: mark(
        "Drag up for more flop and down for less, or press Up and Down (Shift: fine); "
        "the face stays. A double click restores the value of the opened document."
    ),
    1: mark(
        "Drag up or down, or press Up and Down (Shift: fine): this end follows, the "
        "near end moves the opposite way, the face stays. A double click restores the "
        "value of the opened document."
    ),
}


@dataclass(frozen=True)
class Grip:
    """One of them: what it moves, and the end it is at (-1 near, 0 face, 1 far), which gives a drag its sense."""

    handle: Handle
    end: int

    @property
    def key(self) -> str:
        """``index``, ``lightness``, ``chroma`` or ``hue``."""
        return self.handle.key

    def tip(self) -> str:
        """What it is and how it is used."""
        return f"{tr(self.handle.tip)}\n{tr(_TIPS[self.end])}"

    def dragged(self, amount: float, pixels: float) -> float:
        """Return the amount after a drag upwards by ``pixels``, as coarse as a number of it is set."""
        sense = -1.0 if self.end < 0 else 1.0
        return self._held(amount + sense * round(pixels * _PER_PIXEL[self.key], DECIMALS))

    def stepped(self, amount: float, steps: float) -> float:
        """Return the amount after steps upwards of the keys."""
        return self._held(amount + (-steps if self.end < 0 else steps) * self.handle.step)

    def _held(self, amount: float) -> float:
        return round(min(self.handle.high, max(self.handle.low, amount)), 3)


GRIPS = (
    *(Grip(_BY_KEY[key], -1) for key in ("lightness", "chroma", "hue")),
    Grip(_BY_KEY["index"], 0),
    *(Grip(_BY_KEY[key], 1) for key in ("lightness", "chroma", "hue")),
)
"""In the order in which they stand, from the near end to the far one."""


@dataclass(frozen=True)
class FlopOfPaint:
    """The flop of a paint as the grips move it, and the angles, degrees, of near end, face and far end."""

    now: FlopValues
    near_deg: float
    face_deg: float
    far_deg: float

    def amount(self, grip: Grip) -> float:
        """Return what a grip would set; NaN where the paint has none of it."""
        return float(getattr(self.now, "hue_deg" if grip.key == "hue" else grip.key))

    def describe(self, grip: Grip) -> tuple[str, str]:
        """Return what a grip stands at, in words and in short."""
        value = self.amount(grip)
        number = "–" if not math.isfinite(value) else decimal(f"{value:.{DECIMALS}f}").replace("-", "−")
        short = f"{tr(grip.handle.label)} {number}{grip.handle.unit}"
        return tr("{value}, from {near:g}° to {far:g}° ({place})").format(
            value=short, near=self.near_deg, far=self.far_deg, place=tr(_PLACES[grip.end])
        ), short


def flop_of(paint: Paint) -> FlopOfPaint | None:
    """Return the flop of a paint; ``None`` where its readings have no face between two ends."""
    angles = [m.aspecular_deg for m in paint.measurements]
    try:
        ends = flop_ends(angles)
        now = measure_flop(angles, [m.lab for m in paint.measurements])
    except ValueRangeError:
        return None
    return FlopOfPaint(now, angles[ends.near], angles[ends.face], angles[ends.far])


def centres(band: QRectF, face_part: float) -> list[QPointF]:
    """Return where the grips stand on ``band``, in their order; ``face_part`` is how far along it the face is."""
    y = band.center().y()
    least = band.left() + _MARGIN + 3 * _APART
    most = band.right() - _MARGIN - 3 * _APART
    face = min(most, max(least, band.left() + face_part * band.width()))
    near = [QPointF(band.left() + _MARGIN + i * _APART, y) for i in range(3)]
    far = [QPointF(band.right() - _MARGIN - (2 - i) * _APART, y) for i in range(3)]
    return [*near, QPointF(face, y), *far]


def paint_grip(
    painter: QPainter,
    centre: QPointF,
    grip: Grip,
    palette: QPalette,
    *,
    known: bool,
    near: bool,
    chosen: bool,
) -> None:
    """Draw a grip: a letter on a dark disc, seen on every colour.

    ``known``: it can be moved; ``near``: under the mouse; ``chosen``: the keys move it.
    """
    disc = QRectF(centre.x() - RADIUS, centre.y() - RADIUS, 2 * RADIUS, 2 * RADIUS)
    edge = palette.highlight().color() if chosen else QColor(255, 255, 255) if near else QColor(190, 190, 190)
    painter.setOpacity(1.0 if known else 0.45)
    painter.setPen(QPen(edge, 2.0 if chosen or near else 1.0))
    painter.setBrush(QColor(24, 24, 24, 235 if near or chosen else 190))
    painter.drawEllipse(disc)
    painter.setPen(QColor(255, 255, 255))
    painter.drawText(disc, Qt.AlignmentFlag.AlignCenter, _LETTERS[grip.key])
    if known and (near or chosen):
        # Arrows above and below: it goes up and down.
        for side in (-1.0, 1.0):
            tip = QPointF(centre.x(), centre.y() + side * (RADIUS + 5.5))
            foot = centre.y() + side * (RADIUS + 2.0)
            painter.setPen(QPen(QColor(0, 0, 0), 3.0))
            for _ in range(2):
                painter.drawLine(QPointF(centre.x() - 3.5, foot), tip)
                painter.drawLine(QPointF(centre.x() + 3.5, foot), tip)
                painter.setPen(QPen(QColor(255, 255, 255), 1.4))
    painter.setOpacity(1.0)
