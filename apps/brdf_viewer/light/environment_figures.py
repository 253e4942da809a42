"""What the light is, in figures: brightness, sun, range, and a small histogram of its luminance."""

from __future__ import annotations

from brdf_qt.fields.labels import PlainLabel, plain_tip
from brdf_qt.program.translation import tr
from PySide6.QtCore import QEvent, QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QHelpEvent, QPainter, QPaintEvent, QPalette
from PySide6.QtWidgets import QSizePolicy, QToolTip, QVBoxLayout, QWidget

from brdf_suite.lighting.statistics import EnvironmentStatistics, Histogram
from brdf_suite.pipeline.scene import PreparedEnvironment

_HEIGHT = 56
_LEAST_BAR = 3.0  # pixels: a sun is a millionth of the sphere, and still has to be seen

_LEAST_SUN = 0.005


class HistogramBars(QWidget):
    """Share of the sphere by luminance, a bar for each stop, the darkest at the left."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._histogram = Histogram(0.0, (), 0.0)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setFixedHeight(_HEIGHT + self.fontMetrics().height() + 2)
        self.setAccessibleName(tr("Histogram of the light"))

    def set_histogram(self, histogram: Histogram) -> None:
        """Show a histogram; one without bars leaves the place empty."""
        self._histogram = histogram
        words = [f"{self._edge(i):+.0f}: {100.0 * share:.3g} %" for i, share in enumerate(histogram.shares)]
        self.setAccessibleDescription(
            tr("Share of the sphere by log2 of luminance; {shares}").format(shares=", ".join(words))
        )
        self.update()

    @property
    def histogram(self) -> Histogram:
        """What is shown."""
        return self._histogram

    def sizeHint(self) -> QSize:
        return QSize(240, self.height())

    def paintEvent(self, _event: QPaintEvent) -> None:
        shares = self._histogram.shares
        if not shares:
            return
        painter = QPainter(self)
        palette, width = self.palette(), self._bar_width()
        floor = float(_HEIGHT)
        painter.fillRect(QRectF(0.0, floor, self.width(), 1.0), palette.color(QPalette.ColorRole.Mid))
        # The square root shows a sun beside a sky; a linear scale would show the sky alone.
        most = max(shares) ** 0.5
        colour = palette.color(QPalette.ColorRole.WindowText)
        colour.setAlphaF(0.65)
        for i, share in enumerate(shares):
            if share > 0.0:
                tall = max(_LEAST_BAR, (floor - 2.0) * share**0.5 / most)
                painter.fillRect(QRectF(i * width, floor - tall, max(width - 1.0, 1.0), tall), colour)
        painter.setPen(palette.color(QPalette.ColorRole.WindowText))
        under = QRectF(0.0, floor + 1.0, self.width(), self.height() - floor - 1.0)
        painter.drawText(under, Qt.AlignmentFlag.AlignLeft, f"{2.0 ** self._edge(0):.3g}")
        painter.drawText(under, Qt.AlignmentFlag.AlignRight, f"{2.0 ** self._edge(len(shares)):.3g}")
        painter.drawText(under, Qt.AlignmentFlag.AlignHCenter, tr("luminance, by stops"))

    def event(self, event: QEvent) -> bool:
        if isinstance(event, QHelpEvent) and event.type() == QEvent.Type.ToolTip:
            index = self._at(QPointF(event.pos()))
            text = "" if index is None else self._words(index)
            QToolTip.showText(event.globalPos(), plain_tip(text), self)
            return True
        return super().event(event)

    def _words(self, index: int) -> str:
        low, high = 2.0 ** self._edge(index), 2.0 ** self._edge(index + 1)
        share = 100.0 * self._histogram.shares[index]
        text = tr("Luminance {low:.3g} to {high:.3g}: {share:.3g} % of the sphere")
        return text.format(low=low, high=high, share=share)

    def _edge(self, index: int) -> float:
        return self._histogram.lowest_stop + index

    def _bar_width(self) -> float:
        return self.width() / max(len(self._histogram.shares), 1)

    def _at(self, place: QPointF) -> int | None:
        index = int(place.x() / self._bar_width())
        return index if 0 <= index < len(self._histogram.shares) else None


class EnvironmentFigures(QWidget):
    """The figures under the chooser; hidden until they are there."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.text = PlainLabel()
        self.text.setWordWrap(True)
        self.text.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.bars = HistogramBars()
        box = QVBoxLayout(self)
        box.setContentsMargins(0, 0, 0, 0)
        box.setSpacing(4)
        box.addWidget(self.text)
        box.addWidget(self.bars)
        self.setVisible(False)

    def set_statistics(self, statistics: EnvironmentStatistics | None) -> None:
        """Show figures, or nothing while they are being counted."""
        self.setVisible(statistics is not None)
        if statistics is not None:
            self.text.setText("\n".join(lines(statistics)))
            self.bars.set_histogram(statistics.histogram)


def lines(statistics: EnvironmentStatistics) -> list[str]:
    """Return the figures as short lines.

    A brightest place that gives no half per cent of the light is no sun: an overcast sky has one as well.
    """
    stops = statistics.dynamic_range_stops
    reach = tr("partly black") if stops is None else tr("{stops:.1f} stops").format(stops=stops)
    if statistics.sun_elevation_deg is None or statistics.sun_share < _LEAST_SUN:
        sun = tr("No dominant light source")
    else:
        sun = tr(
            "Main light: elevation {elevation:.0f}°, azimuth {azimuth:.0f}°, {share:.0f} % of total"
        ).format(
            elevation=statistics.sun_elevation_deg,
            azimuth=statistics.sun_azimuth_deg,
            share=100.0 * statistics.sun_share,
        )
    return [
        tr("Luminance: mean {mean:.3g}, maximum {largest:.3g}").format(
            mean=statistics.average_luminance, largest=statistics.brightest_luminance
        ),
        tr("Dynamic range {reach}").format(reach=reach),
        tr("Horizontal illuminance {value:.3g}").format(value=statistics.horizontal_illuminance),
        sun,
    ]


def environment_facts(prepared: PreparedEnvironment, loading: bool) -> str:
    """Return the lines under the chooser; ``loading``: whether the missing maps are on their way."""
    rows, columns = prepared.environment.radiance.shape[:2]
    lines = [
        tr("{columns} × {rows} pixels").format(columns=columns, rows=rows),
        *map(_sentence, prepared.environment.notes),
    ]
    if prepared.draft:
        lines.append(tr("Draft; full quality follows after editing."))
    elif not prepared.is_final:
        made = prepared.wanted - prepared.missing
        what = f"({made}/{prepared.wanted})"
        if loading:
            lines.append(tr("Refining reflections {what}").format(what=what))
        else:
            text = tr("Reflections incomplete {what}. Select the light again to finish.")
            lines.append(text.format(what=what))
    return "\n".join([*lines, *prepared.notices])


def _sentence(text: str) -> str:
    """Return a note as a sentence: notes of files are phrases in lower case."""
    return text[:1].upper() + text[1:].rstrip(".") + "."
