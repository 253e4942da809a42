"""Exponents and errors over the number of lobes: figures 2 and 3 of the paper, and the selected paint's own error."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from brdf_qt.fields.form import fill_row
from brdf_qt.program.translation import tr
from PySide6.QtCore import QEvent, Qt
from PySide6.QtGui import QBrush, QColor, QPalette, QPen, QResizeEvent
from PySide6.QtWidgets import QBoxLayout, QWidget

from brdf_lobe_visualizer.cuts.crosshair import Readout, Row
from brdf_lobe_visualizer.cuts.lines import Line
from brdf_lobe_visualizer.subjects.subjects import DASHES, PlottedMaterial, Srgb

if TYPE_CHECKING:  # much to import for a start
    from brdf_suite.fitting.basis_search.document import StoredSearch
    from brdf_suite.inspection.basis_of_paint import ErrorsOverCount

MOST_LOBES = 11
"""The greatest number of lobes that a search tries."""
_BESIDE = 1.3
"""Wider than so many times the height, the plots stand beside each other."""
_ERROR_TICKS = (0.01, 0.1, 0.3, 1.0, 3.0, 10.0, 30.0, 100.0)
_MEAN_DASH, _WORST_DASH = DASHES[0], DASHES[1]


class BasisPlots(QWidget):
    """Both plots; :meth:`build` makes them."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.search: StoredSearch | None = None
        self.own: tuple[PlottedMaterial, ErrorsOverCount] | None = None
        self.exponents: Any = None
        self.errors: Any = None
        self._box = fill_row(self)

    def build(self) -> None:
        if self.exponents is not None:
            return
        from brdf_lobe_visualizer.cuts.plot_items import SlicePlot, band, rings, text

        self.exponents, self.errors = SlicePlot(with_axes=True), SlicePlot(with_axes=True)
        names = (tr("Exponents over the number of lobes"), tr("Errors over the number of lobes"))
        for plot, name in zip((self.exponents, self.errors), names, strict=True):
            plot.setAccessibleName(name)
            plot.setMouseEnabled(x=False, y=False)
            plot.setMinimumSize(120, 80)
            plot.setLabel("bottom", tr("Number of lobes"))
            plot.getAxis("bottom").setTicks([[(count, str(count)) for count in range(2, MOST_LOBES + 2, 2)]])
            self._box.addWidget(plot, 1)
        self.exponents.getAxis("left").setLogMode(y=True)
        # What is drawn is the logarithm; these numbers keep clear of each other where there is little room.
        self.errors.getAxis("left").setTicks(
            [[(float(np.log10(error)), f"{error:g}") for error in _ERROR_TICKS]]
        )
        self.exponents.setLabel("left", tr("Exponent"))
        self.errors.setLabel("left", tr("Error (1: just noticeable)"))
        self.dots, self._own_dots = rings(), rings()
        self._chosen = [band(), band()]
        for plot, chosen in zip((self.exponents, self.errors), self._chosen, strict=True):
            plot.addItem(chosen, ignoreBounds=True)
        self.exponents.addItem(self.dots)
        self.errors.addItem(self._own_dots)
        self._names = [text(anchor=(1.0, 1.0)) for _ in range(3)]
        for item in self._names:
            self.errors.addItem(item, ignoreBounds=True)
        self.readouts = (Readout(self.exponents), Readout(self.errors))
        self.exponents.moved_over.connect(lambda x, _y: self.read_exponents(x))
        self.errors.moved_over.connect(lambda x, _y: self.read_errors(x))
        self.exponents.left.connect(self.readouts[0].hide)
        self.errors.left.connect(self.readouts[1].hide)
        self._dress()
        self._draw()

    def show_search(self, search: StoredSearch | None) -> None:
        self.search = search
        self._draw()

    def show_own(self, subject: PlottedMaterial | None, errors: ErrorsOverCount | None) -> None:
        self.own = None if subject is None or errors is None else (subject, errors)
        self._draw()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        beside = self.width() >= _BESIDE * self.height()
        self._box.setDirection(
            QBoxLayout.Direction.LeftToRight if beside else QBoxLayout.Direction.TopToBottom
        )

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange and self.exponents is not None:
            self._dress()
            self._draw()

    def _draw(self) -> None:
        if self.exponents is None:
            return
        for readout in self.readouts:
            readout.hide()
        search = self.search
        results = () if search is None else search.results
        counts = np.array([result.count for result in results], float)
        x = np.repeat(counts, [result.count for result in results]) if len(counts) else np.zeros(0)
        y = np.concatenate([np.log10(result.exponents) for result in results]) if results else np.zeros(0)
        self.dots.setData(x=x, y=y)
        chosen = None if search is None else search.default_count
        for band in self._chosen:
            band.setVisible(chosen is not None)
            if chosen is not None:
                band.setRegion((chosen - 0.4, chosen + 0.4))
        top = float(counts.max()) if len(counts) else 11.0
        high = max(4.0, float(np.ceil(y.max()))) if y.size else 5.0
        self.exponents.setRange(xRange=(0.5, top + 0.5), yRange=(-0.1, high + 0.1), padding=0.0)
        self._draw_errors(counts, top)

    def _draw_errors(self, counts: Any, top: float) -> None:
        assert self.errors is not None
        results = () if self.search is None else self.search.results
        grey = self._grey()
        drawn = []
        if len(counts):
            mean = np.array([np.mean(result.errors) for result in results])
            worst = np.array([max(result.errors) for result in results])
            drawn.append((_line("mean", tr("mean"), grey, _MEAN_DASH, mean), counts, _log(mean)))
            drawn.append((_line("worst", tr("worst paint"), grey, _WORST_DASH, worst), counts, _log(worst)))
        own_x, own_y = np.zeros(0), np.zeros(0)
        if self.own is not None:
            subject, errors = self.own
            own_x, own_y = np.array(errors.counts, float), _log(np.array(errors.errors))
            line = _line(subject.key, subject.title, subject.colour, subject.dash, 10.0**own_y, front=True)
            drawn.append((line, own_x, own_y))
        self.errors.show_lines(drawn)
        self._own_dots.setData(x=own_x, y=own_y)
        for item, (line, x, y) in zip(self._names, drawn, strict=False):
            item.setText(line.title if len(line.title) <= 24 else line.title[:23] + "…")
            # The front's end lies among the others.
            end, anchor, shift = (0, 0.0, 0.1) if line.is_front else (-1, 1.0, 0.4)
            item.setAnchor((anchor, 1.0))
            item.setPos(float(x[end]) + shift, float(y[end]))
        for number_of, item in enumerate(self._names):
            item.setVisible(number_of < len(drawn))
        values = np.concatenate([y for _, _, y in drawn]) if drawn else np.zeros(0)
        low = float(np.floor(5.0 * values.min()) / 5.0) - 0.1 if values.size else -1.0
        high = float(np.ceil(5.0 * values.max()) / 5.0) + 0.1 if values.size else 2.0
        self.errors.setRange(xRange=(0.5, top + 0.5), yRange=(low, high), padding=0.0)

    def read_exponents(self, x: float) -> None:
        result = self._result_at(x)
        if result is None:
            self.readouts[0].hide()
            return
        rows = [
            Row(tr("lobe {number}").format(number=place + 1), self._grey(), "target", exponent)
            for place, exponent in enumerate(result.exponents)
        ]
        self.readouts[0].show_rows(_lobes(result.count), rows, tr("exponents"), at_right=False)

    def read_errors(self, x: float) -> None:
        result = self._result_at(x)
        rows: list[Row] = []
        if result is not None:
            assert self.search is not None
            worst = tr("worst: {name}").format(name=self.search.paints[int(np.argmax(result.errors))])
            figures = ((tr("mean"), float(np.mean(result.errors))), (worst, max(result.errors)))
            rows = [Row(title, self._grey(), "target", value) for title, value in figures]
        count = round(x)
        if self.own is not None and count in self.own[1].counts:
            subject, errors = self.own
            value = errors.errors[errors.counts.index(count)]
            rows.insert(0, Row(subject.title, subject.colour, "target", value))
        if not rows:
            self.readouts[1].hide()
            return
        self.readouts[1].show_rows(_lobes(count), rows, "", at_right=True)

    def _result_at(self, x: float) -> Any:
        results = () if self.search is None else self.search.results
        return next((result for result in results if result.count == round(x)), None)

    def _grey(self) -> Srgb:
        text = self.palette().color(QPalette.ColorRole.Text)
        return (text.redF(), text.greenF(), text.blueF())

    def _dress(self) -> None:
        text = self.palette().color(QPalette.ColorRole.Text)
        faint = QColor(text)
        faint.setAlphaF(0.12)
        for plot in (self.exponents, self.errors):
            plot.dress()
            plot.showGrid(x=True, y=True, alpha=0.12)
        ring = QPen(text, 1.2)
        ring.setCosmetic(True)
        for dots in (self.dots, self._own_dots):
            dots.setPen(ring)
            dots.setBrush(None)
        for band in self._chosen:
            band.setBrush(QBrush(faint))
            for edge in band.lines:
                edge.setPen(QPen(Qt.PenStyle.NoPen))
        for item in self._names:
            item.setColor(text)
        for readout in self.readouts:
            readout.setPalette(QPalette(self.palette()))


def _line(key: str, title: str, colour: Srgb, dash: Any, value: Any, *, front: bool = False) -> Line:
    return Line(key, title, "target", colour, dash, front, value)


def _log(values: Any) -> Any:
    # An error of 0, of a paint that is made of the lobes, is drawn at the foot.
    return np.log10(np.maximum(values, 1e-3))


def _lobes(count: int) -> str:
    return tr("1 lobe") if count == 1 else tr("{count} lobes").format(count=count)
