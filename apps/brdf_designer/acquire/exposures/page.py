"""Step 2: one position's photographs side by side, with what is clipped, their histogram and their times."""

from __future__ import annotations

import numpy as np
from brdf_qt.fields.labels import plain_tip
from brdf_qt.program.translation import decimal, tr
from PySide6.QtCore import QSignalBlocker, QSize, Qt
from PySide6.QtGui import QIcon, QPainter, QPixmap, QTransform
from PySide6.QtWidgets import QListView, QListWidget, QListWidgetItem

from brdf_designer.acquire.plots.lines_plot import CHANNELS, Axis, Curve, LinesPlot
from brdf_designer.acquire.plots.marks import Area, draw_mark
from brdf_designer.acquire.plots.tone import Tones, area_of, drawn
from brdf_designer.acquire.plots.view import PictureView
from brdf_designer.acquire.session.page import fill_problems, problem_list
from brdf_designer.acquire.states import Series, Shot
from brdf_designer.acquire.step_page import Facts, PositionPage
from brdf_designer.standard_comparison.tables import WholeTable
from brdf_designer.window.widgets import split, wrapped
from brdf_suite.foreign_text import make_visible

THUMB = 84
_HARDLY = 0.02
_SAME_TIME = 0.05
"""A time of a file's own that differs by less is the stated one: cameras write rounded fractions."""


class ExposuresPage(PositionPage):
    """The page of the exposures."""

    def __init__(self) -> None:
        super().__init__(
            "exposures",
            tr(
                "Each position was photographed with several exposures: a short one for the "
                "highlight, a long one for the flank."
            ),
            least_ev=-6.0,
        )
        self._series: Series | None = None
        self._chosen = -1
        self.picture = PictureView(tr("Selected photograph"), tr("Open a session first."))
        self.strip = QListWidget()
        self.strip.setAccessibleName(tr("Photographs of this position"))
        self.strip.setToolTip(
            tr("Exposure time, and the share of clipped pixels, which are hatched; Left and Right choose")
        )
        self.strip.setViewMode(QListView.ViewMode.IconMode)
        self.strip.setFlow(QListView.Flow.LeftToRight)
        self.strip.setWrapping(False)
        self.strip.setMovement(QListView.Movement.Static)
        self.strip.setIconSize(QSize(THUMB, THUMB))
        self.strip.setUniformItemSizes(True)
        self.strip.setSpacing(2)
        self.strip.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.strip.setFixedHeight(THUMB + 3 * self.fontMetrics().height() + 24)
        self.strip.currentRowChanged.connect(self._choose)
        self.histogram = LinesPlot(
            tr("Histogram of the photograph"), Axis(tr("Code")), Axis(tr("Pixels"), log=True)
        )
        self.histogram.show_empty("")
        self.centre.addWidget(split(Qt.Orientation.Vertical, (self.picture, 3), (self.histogram, 2)), 1)
        self.problems = problem_list(tr("Problems of this position"))
        self.problems.hide()
        self.centre.addWidget(self.problems)
        self.centre.addWidget(self.strip)
        self.position.setAccessibleName(tr("Position of the lamp"))
        self.brightness.edited.connect(lambda _value: self._draw())
        form = self.position_form(tr("Position of the displayed photographs"))
        self.add_part("position", tr("Position"), form)
        self.pixel = Facts(tr("The pixel under the cursor"))
        self.table = WholeTable(
            tr("Exposure times and clipped pixels"),
            (tr("Time, ms"), tr("EXIF, ms"), tr("Clipped"), tr("Dark")),
        )
        self.table.setToolTip(
            tr(
                "Stated in session.json; in the file (EXIF); share of pixels clipped in a channel; share "
                "within the noise"
            )
        )
        self.table.currentCellChanged.connect(lambda row, *_: self._choose(row))
        self.times = wrapped()
        self.add_part("times", tr("Exposure Times"), self.table, self.times)
        self.add_part("pixel", tr("Under the Cursor"), self.pixel)
        self.differing = 0
        """Number of displayed files whose exposure time differs from the session."""
        self._read(-1.0, -1.0)
        self.picture.hovered.connect(self._read)
        self.picture.left_picture.connect(lambda: self._read(-1.0, -1.0))

    def show_series(self, series: Series | None) -> None:
        """Show a position's photographs; the same exposure stays chosen."""
        self._series = series
        problems = () if series is None else series.problems
        fill_problems(self.problems, problems)
        self.problems.setVisible(bool(problems))
        with QSignalBlocker(self.strip):
            self.strip.clear()
        if series is None or not series.shots:
            self.picture.show_empty(
                tr("Open a session first.")
                if series is None
                else tr("No photograph of this position can be read. The page Session lists the reasons.")
            )
            self.histogram.show_empty("")
            self.table.set_row_count(0)
            return
        # At first the longest exposure that is hardly clipped; it shows most.
        if self._chosen < 0:
            self._chosen = max(
                (k for k, shot in enumerate(series.shots) if shot.clipped < _HARDLY), default=0
            )
        self._chosen = min(self._chosen, len(series.shots) - 1)
        with QSignalBlocker(self.strip):
            for shot in series.shots:
                text = tr("{time:.4g} ms\n{clipped}").format(
                    time=1e3 * shot.exposure_s, clipped=percent(shot.clipped)
                )
                small = _thumb(shot)
                sign = QIcon(small)
                # The style tints what is chosen; a photograph keeps its colours.
                sign.addPixmap(small, QIcon.Mode.Selected)
                item = QListWidgetItem(sign, make_visible(text))
                item.setToolTip(plain_tip(shot.file))
                item.setTextAlignment(Qt.AlignmentFlag.AlignHCenter)
                self.strip.addItem(item)
            self.strip.setCurrentRow(self._chosen)
        self._fill_table(series)
        self._draw()

    def choose(self, exposure: int) -> None:
        """Show this exposure."""
        self.strip.setCurrentRow(exposure)

    def _fill_table(self, series: Series) -> None:
        self.differing = 0
        with QSignalBlocker(self.table):
            self.table.set_row_count(len(series.shots))
            for row, shot in enumerate(series.shots):
                other = shot.exif_s is not None and bool(
                    abs(shot.exif_s / shot.exposure_s - 1.0) > _SAME_TIME
                )
                self.differing += other
                read = "–" if shot.exif_s is None else decimal(f"{1e3 * shot.exif_s:.4g}")
                texts = (
                    decimal(f"{1e3 * shot.exposure_s:.4g}"),
                    read,
                    percent(shot.clipped),
                    percent(shot.dark),
                )
                for column, text in enumerate(texts):
                    self.table.set_text(row, column, text, bold=column == 1 and other, tip=shot.file)
            self.table.selectRow(self._chosen)
        text = tr("The times in the files match session.json.")
        if all(shot.exif_s is None for shot in series.shots):
            text = tr("The files contain no exposure times. The times in session.json are used.")
        elif self.differing:
            text = tr("The times of {count} files differ from session.json.").format(count=self.differing)
        self.times.setText(text)

    def position_text(self, index: int) -> str:
        text = tr("Lamp at {angle:g}°, position {number} of {count}")
        return text.format(angle=self._angles[index], number=index + 1, count=len(self._angles))

    def _choose(self, row: int) -> None:
        if self._series is None or not 0 <= row < len(self._series.shots) or row == self._chosen:
            return
        self._chosen = row
        with QSignalBlocker(self.strip), QSignalBlocker(self.table):
            self.strip.setCurrentRow(row)
            self.table.selectRow(row)
        self._draw()

    def _draw(self) -> None:
        if self._series is None or not self._series.shots:
            return
        shot = self._series.shots[self._chosen]
        self.picture.show_image(drawn(shot.tones, self.brightness.value()))
        self.picture.show_marks(
            [Area(area_of(shot.clipped_area), tr("clipped"))] if shot.clipped > 0.0 else []
        )
        middles = 0.5 * (shot.edges[1:] + shot.edges[:-1])
        looks = CHANNELS if len(shot.histogram) == 3 else (("text", "solid"),)
        names = (tr("red"), tr("green"), tr("blue")) if len(shot.histogram) == 3 else (tr("grey"),)
        curves = [
            Curve(middles, np.where(counts > 0, counts, np.nan), name, kind, dash)
            for counts, name, (kind, dash) in zip(shot.histogram, names, looks, strict=True)
        ]
        self.histogram.set_reach(x=(0.0, 1.02 * shot.top))
        self.histogram.show_curves(curves, ((shot.top, tr("clipped")),))

    def _read(self, x: float, y: float) -> None:
        if self._series is None or not self._series.shots or x < 0.0:
            self.pixel.show_rows(((tr("Pixel"), "–", tr("Column and row under the cursor")),))
            return
        codes = self._series.shots[self._chosen].tones.codes
        row, column = min(int(y), codes.shape[0] - 1), min(int(x), codes.shape[1] - 1)
        found = " ".join(str(int(code)) for code in np.atleast_1d(codes[row, column]))
        where = (tr("Pixel"), f"{column}, {row}", tr("Column and row under the cursor"))
        self.pixel.show_rows((where, (tr("Codes"), found, tr("Red, green and blue codes in the file"))))


def percent(share: float) -> str:
    """Return a share 0…1 as text; what is more than nothing does not read as nothing.

    >>> percent(0.0001)
    '< 0.1 %'
    """
    return decimal("< 0.1 %" if 0.0 < share < 0.001 else f"{100.0 * share:.1f} %")


def _thumb(shot: Shot) -> QPixmap:
    """Return a small picture, from as many pixels as it can show: all of them would take a moment for each."""
    step = max(1, min(shot.tones.codes.shape[:2]) // (2 * THUMB))
    whole = drawn(Tones(np.ascontiguousarray(shot.tones.codes[::step, ::step]), shot.tones.values))
    clipped = area_of(shot.clipped_area[::step, ::step])
    small = whole.scaled(
        THUMB, THUMB, Qt.AspectRatioMode.KeepAspectRatio, Qt.TransformationMode.SmoothTransformation
    )
    scale = min(THUMB / whole.width(), THUMB / whole.height())
    left, top = 0.5 * (THUMB - small.width()), 0.5 * (THUMB - small.height())
    pixmap = QPixmap(THUMB, THUMB)
    pixmap.fill(Qt.GlobalColor.transparent)
    painter = QPainter(pixmap)
    painter.drawImage(int(left), int(top), small)
    draw_mark(painter, Area(clipped), QTransform().translate(left, top).scale(scale, scale))
    painter.end()
    return pixmap
