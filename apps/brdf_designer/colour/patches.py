"""The colours as large fields side by side, with their numbers, what the fit gives, and a standard."""

from __future__ import annotations

from collections.abc import Sequence

from brdf_qt.fields.labels import plain_tip, set_small
from brdf_qt.fields.marks import verdict_mark
from brdf_qt.program.translation import decimal, mark, tr
from brdf_qt.work.fit_error import fit_mark, is_large, large_error_tip
from PySide6.QtCore import QPointF, QRect, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QPen, QPolygonF
from PySide6.QtWidgets import QGridLayout, QSizePolicy, QWidget

from brdf_designer.session.state import AngleColour, Colours, GivenColour
from brdf_designer.standard_comparison.state import StandardPatch
from brdf_designer.window.caption import Caption
from brdf_designer.window.widgets import set_font

OUTSIDE_TIP = mark(
    "Outside sRGB: this screen shows the colour clipped to its gamut. The paint itself is not clipped."
)
CORNER = 14.0
_TALL = 64
"""Pixels of height: the colours are a strip below the picture."""
GIVEN_SHARE, GIVEN_MOST = 0.34, 64.0
"""How much of a field shows what the fit gives, and at most how many pixels of its height."""
_FIT_TIP = mark("Colour difference CIEDE2000 between the target and the fitted lobes.")


def paint_corner(painter: QPainter, rect: QRectF, size: float = CORNER) -> None:
    """Draw the mark of a colour that the screen cannot show, seen on any colour: a black corner, white edge."""
    top, left, below = rect.topRight(), rect.topRight() - QPointF(size, 0), rect.topRight() + QPointF(0, size)
    painter.save()
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(QColor(0, 0, 0))
    painter.drawPolygon(QPolygonF([top, left, below]))
    painter.setPen(QPen(QColor(255, 255, 255), 1.5))
    painter.drawLine(left, below)
    painter.restore()


class ColourField(QWidget):
    """One colour, edge to edge, or beside a standard's; a corner mark where the screen cannot show it."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._rgb = QColor(0, 0, 0)
        self._in_gamut = True
        self._shown: AngleColour | None = None
        self.given: QColor | None = None
        self.standard: QColor | None = None
        self._standard_in_gamut = True
        self.setMinimumSize(48, _TALL)
        # It covers all of its place: what lies behind need not be drawn.
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)

    def show_colour(self, colour: AngleColour) -> None:
        """Show the colour of one measurement."""
        if colour == self._shown:
            return
        self._shown = colour
        self._rgb = QColor(*colour.rgb)
        if colour.in_gamut != self._in_gamut:
            self._in_gamut = colour.in_gamut
            self.setToolTip("" if colour.in_gamut else tr(OUTSIDE_TIP))
        numbers = lab_text(colour.lab)
        name = tr("Colour at {angle}: {lab}")
        self.setAccessibleName(name.format(angle=colour.text, lab=numbers))
        self.update(self._halves()[0])

    def show_standard(self, patch: StandardPatch | None) -> None:
        """Show a standard's colour in the right half, without a gap between them; ``None`` for the whole field."""
        rgb = None if patch is None else patch.rgb
        self.standard = None if rgb is None else QColor(*rgb)
        self._standard_in_gamut = patch is None or patch.in_gamut
        self.update()

    def show_given(self, given: GivenColour | None) -> None:
        """Show what the fit gives along the lower edge, without a gap; ``None`` where there is no fit."""
        rgb = None if given is None else QColor(*given.rgb)
        if rgb != self.given:
            came_or_went = rgb is None or self.given is None
            self.given = rgb
            self.update(self.rect() if came_or_went else self._halves()[1])

    def sizeHint(self) -> QSize:
        return QSize(260, _TALL)

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        upper, lower = self._halves()
        painter.fillRect(upper, self._rgb)
        batch = self.rect()
        if self.standard is not None:
            batch.setWidth(self.width() // 2)
            upper, lower = upper & batch, lower & batch
            other = self.rect().adjusted(batch.width(), 0, 0, 0)
            painter.fillRect(other, self.standard)
            if not self._standard_in_gamut:
                paint_corner(painter, QRectF(other), 2 * CORNER)
            _write(painter, upper, tr("batch"), self._rgb)
            _write(painter, other, tr("standard"), self.standard)
        elif self.given is not None and event.rect().intersects(upper):
            _write(painter, upper, tr("target"), self._rgb)
        if self.given is not None and event.rect().intersects(lower):
            painter.fillRect(lower, self.given)
            _write(painter, lower, tr("fit"), self.given, rows=1)
        if not self._in_gamut:
            paint_corner(painter, QRectF(batch), 2 * CORNER)
        # A hairline, so that a colour like the surround is still seen as a field.
        painter.setPen(self.palette().dark().color())
        painter.drawRect(self.rect().adjusted(0, 0, -1, -1))

    def _halves(self) -> tuple[QRect, QRect]:
        """The part that shows what is asked, and below it the one that shows what the fit gives."""
        rect = self.rect()
        band = 0 if self.given is None else round(min(GIVEN_SHARE * rect.height(), GIVEN_MOST))
        return rect.adjusted(0, 0, 0, -band), rect.adjusted(0, rect.height() - band, 0, 0)


def _write(painter: QPainter, rect: QRect, text: str, ground: QColor, rows: int = 2) -> None:
    """Write what a part is at its lower edge, in black or white, where it has the room of some ``rows``."""
    inner = rect.adjusted(6, 1, -6, -2)
    metrics = painter.fontMetrics()
    if metrics.horizontalAdvance(text) > inner.width() or rows * metrics.height() > inner.height():
        return
    light = 0.2126 * ground.redF() + 0.7152 * ground.greenF() + 0.0722 * ground.blueF() > 0.45
    painter.setPen(QColor(0, 0, 0) if light else QColor(255, 255, 255))
    painter.drawText(inner, Qt.AlignmentFlag.AlignBottom | Qt.AlignmentFlag.AlignLeft, text)


def lab_text(lab: tuple[float, float, float]) -> str:
    """Return L*a*b* as text with true minus signs, one decimal."""
    return "   ".join(
        f"{name} {one_decimal(value)}" for name, value in zip(("L*", "a*", "b*"), lab, strict=True)
    )


def one_decimal(value: float) -> str:
    """Return a number with one decimal, a true minus sign, and none where it rounds to 0."""
    return decimal(f"{round(value, 1) + 0.0:.1f}").replace("-", "−")


class ColourPatch:
    """A measurement in the row: its colour, and below it its angle, its numbers, the fit, and a standard."""

    def __init__(self) -> None:
        self.field = ColourField()
        self.angle, self.numbers, self.fit, self.against, self.words = (Caption() for _ in range(5))
        for caption in (self.numbers, self.fit, self.against, self.words):
            set_small(caption)
        set_font(self.angle, bold=True)
        set_font(self.fit, italic=True)
        self.fit.setToolTip(tr(_FIT_TIP))
        self._shown_fit: tuple[object, ...] | None = None
        self.show_standard(None)

    def widgets(self) -> tuple[QWidget, ...]:
        """Return its parts from top to bottom."""
        return self.field, self.angle, self.numbers, self.fit, self.against, self.words

    def show_colour(self, colour: AngleColour) -> None:
        """Show the measurement."""
        self.field.show_colour(colour)
        self.angle.set_forms(f"{colour.text}  {place_word(colour.aspecular_deg)}".rstrip(), colour.text)
        self.numbers.set_forms(lab_text(colour.lab), "  ".join(map(one_decimal, colour.lab)))

    def show_fit(
        self, error: float | None, given: GivenColour | None, time_limited: bool, exact_follows: bool
    ) -> None:
        """Show what the fit gives and its ΔE00, a large one with a mark; ``None``: there is no fit."""
        shown = _fit_text(error, given, time_limited, exact_follows)
        if shown == self._shown_fit:
            return
        self._shown_fit = shown
        large = error is not None and is_large(error)
        self.field.show_given(given)
        set_font(self.fit, bold=large, italic=True)
        self.fit.set_mark(fit_mark(error, time_limited and error is not None))
        tip = f"{tr(_FIT_TIP)}\n{large_error_tip(time_limited, exact_follows)}" if large else tr(_FIT_TIP)
        if given is not None:
            tip = f"{lab_text(given.lab)}\n{tip}"
        if self.fit.toolTip() != tip:
            self.fit.setToolTip(plain_tip(tip))
        if error is None:
            self.fit.set_forms(tr("fit: none"))
            return
        short = tr("fit ΔE00 {error:.2f}").format(error=error)
        if time_limited:
            short = tr("{fit}, time-limited").format(fit=short)
        forms = [short]
        if given is not None:
            forms = [f"{short}:   {lab_text(given.lab)}", short]
        self.fit.set_forms(*forms)

    def show_standard(self, patch: StandardPatch | None) -> None:
        """Show a standard in and under the field; ``None``: there is none."""
        self.field.show_standard(patch)
        for caption in (self.against, self.words):
            caption.setVisible(patch is not None)
            if patch is not None:
                caption.setToolTip(plain_tip(patch.tip))
        if patch is not None:
            self.against.set_forms(*patch.forms)
            set_font(self.against, bold=patch.passes is False)
            self.against.set_mark(verdict_mark(patch.passes))
            self.words.set_forms(*patch.words)


class PatchRow(QWidget):
    """A :class:`ColourPatch` for each measurement."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._grid = QGridLayout(self)
        self._grid.setContentsMargins(0, 0, 0, 0)
        self._grid.setHorizontalSpacing(8)
        self._grid.setVerticalSpacing(2)
        self._grid.setRowStretch(0, 1)
        self.patches: list[ColourPatch] = []

    def show_colours(self, colours: Colours) -> None:
        """Show every measurement; makes or drops patches where their number changes."""
        while len(self.patches) < len(colours.angles):
            column, patch = len(self.patches), ColourPatch()
            for row, widget in enumerate(patch.widgets()):
                self._grid.addWidget(widget, row, column)
            self._grid.setColumnStretch(column, 1)
            self.patches.append(patch)
        while len(self.patches) > len(colours.angles):
            self._grid.setColumnStretch(len(self.patches) - 1, 0)
            for widget in self.patches.pop().widgets():
                self._grid.removeWidget(widget)
                widget.hide()
                widget.deleteLater()
        for patch, colour in zip(self.patches, colours.angles, strict=True):
            patch.show_colour(colour)

    def show_differences(
        self,
        delta_e: list[float] | None,
        given: list[GivenColour] | None = None,
        *,
        time_limited: bool = False,
        exact_follows: bool = False,
    ) -> None:
        """Show what the fit gives in and under each field, in their order; ``None``: there is no fit."""
        for number, patch in enumerate(self.patches):
            error = None if delta_e is None else delta_e[number]
            colour = None if given is None else given[number]
            patch.show_fit(error, colour, time_limited, exact_follows)

    def show_standard(self, patches: Sequence[StandardPatch] | None) -> None:
        """Show the standard in and under each field, in the order of the fields; ``None``: there is none."""
        for number, patch in enumerate(self.patches):
            patch.show_standard(None if patches is None else patches[number])


def _fit_text(
    error: float | None, given: GivenColour | None, time_limited: bool, exact_follows: bool
) -> tuple[object, ...]:
    """What is seen of a fit under a field: where that is as it was, nothing is written anew."""
    lab = None if given is None else tuple(round(value, 3) for value in given.lab)
    rgb = None if given is None else given.rgb
    return None if error is None else round(error, 4), lab, rgb, time_limited, exact_follows


def place_word(aspecular_deg: float) -> str:
    """Return the trade's word for the view at an aspecular angle; empty where there is none."""
    words = {15.0: mark("near-specular"), 45.0: mark("face"), 110.0: mark("flop")}
    return tr(words[aspecular_deg]) if aspecular_deg in words else ""
