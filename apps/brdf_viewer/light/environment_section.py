"""Which light, turned how far, how bright, and what it is in figures: brightness, sun, range, and a histogram."""

from __future__ import annotations

from brdf_qt.choosing.picker import SourceChooser
from brdf_qt.fields.choices import ChoiceBox, ColourButton, SliderField, note, set_note
from brdf_qt.fields.form import Form, fill_column
from brdf_qt.fields.labels import plain_tip
from brdf_qt.program.core_texts import tr_core
from brdf_qt.program.translation import decimal, mark, tr
from brdf_qt.window.section import Section
from brdf_qt.window.view_titles import BACKGROUND_TITLES
from PySide6.QtCore import QEvent, QRectF, QSize, Qt
from PySide6.QtGui import QHelpEvent, QPainter, QPaintEvent, QPalette
from PySide6.QtWidgets import QSizePolicy, QToolButton, QToolTip, QWidget

from brdf_suite.documents.view import PARAMETERS
from brdf_suite.lighting.statistics import EnvironmentStatistics, Histogram
from brdf_suite.pipeline.scene import PreparedEnvironment

_HEIGHT = 56
_LEAST_BAR = 3.0  # pixels: a sun is a millionth of the sphere, and still has to be seen

_LEAST_SUN = 0.005
_LINES = 5


class HistogramBars(QWidget):
    """Share of the sphere by luminance, a bar for each stop, the darkest at the left."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.histogram = Histogram(0.0, (), 0.0)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setFixedHeight(_HEIGHT + self.fontMetrics().height() + 2)
        self.setAccessibleName(tr("Histogram of the light"))

    def set_histogram(self, histogram: Histogram) -> None:
        """Show a histogram; one without bars leaves the place empty."""
        self.histogram = histogram
        words = [
            decimal(f"{self._edge(i):+.0f}: {100.0 * share:.3g} %")
            for i, share in enumerate(histogram.shares)
        ]
        text = tr("Share of the sphere by log2 of luminance; {shares}")
        self.setAccessibleDescription(text.format(shares=", ".join(words)))
        self.update()

    def sizeHint(self) -> QSize:
        return QSize(240, self.height())

    def paintEvent(self, _event: QPaintEvent) -> None:
        shares = self.histogram.shares
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
        painter.drawText(under, Qt.AlignmentFlag.AlignLeft, decimal(f"{2.0 ** self._edge(0):.3g}"))
        painter.drawText(under, Qt.AlignmentFlag.AlignRight, decimal(f"{2.0 ** self._edge(len(shares)):.3g}"))
        painter.drawText(under, Qt.AlignmentFlag.AlignHCenter, tr("luminance, by stops"))

    def event(self, event: QEvent) -> bool:
        if isinstance(event, QHelpEvent) and event.type() == QEvent.Type.ToolTip:
            index, shares, text = int(event.pos().x() / self._bar_width()), self.histogram.shares, ""
            if 0 <= index < len(shares):
                low, high = 2.0 ** self._edge(index), 2.0 ** self._edge(index + 1)
                text = tr("Luminance {low:.3g} to {high:.3g}: {share:.3g} % of the sphere")
                text = text.format(low=low, high=high, share=100.0 * shares[index])
            QToolTip.showText(event.globalPos(), plain_tip(text), self)
            return True
        return super().event(event)

    def _edge(self, index: int) -> float:
        return self.histogram.lowest_stop + index

    def _bar_width(self) -> float:
        return self.width() / max(len(self.histogram.shares), 1)


class EnvironmentFigures(QWidget):
    """The figures under the chooser; their place is empty until they are there."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.text, self.bars = note(lines=_LINES), HistogramBars()
        fill_column(self, self.text, self.bars, spacing=4)
        policy = self.sizePolicy()
        policy.setRetainSizeWhenHidden(True)
        self.setSizePolicy(policy)
        self.setVisible(False)

    def set_statistics(self, statistics: EnvironmentStatistics | None) -> None:
        """Show figures, or nothing while they are being counted."""
        self.setVisible(statistics is not None)
        if statistics is not None:
            set_note(self.text, "\n".join(lines(statistics)))
            self.bars.set_histogram(statistics.histogram)


def lines(statistics: EnvironmentStatistics) -> list[str]:
    """Return the figures as short lines.

    A brightest place that gives no half per cent of the light is no sun: an overcast sky has one as well.
    """
    stops = statistics.dynamic_range_stops
    reach = tr("partly black") if stops is None else tr("{stops:.1f} stops").format(stops=stops)
    sun = tr("No dominant light source")
    if statistics.sun_elevation_deg is not None and statistics.sun_share >= _LEAST_SUN:
        text = tr("Main light: elevation {elevation:.0f}°, azimuth {azimuth:.0f}°, {share:.0f} % of total")
        elevation, azimuth = statistics.sun_elevation_deg, statistics.sun_azimuth_deg
        sun = text.format(elevation=elevation, azimuth=azimuth, share=100.0 * statistics.sun_share)
    mean, largest = statistics.average_luminance, statistics.brightest_luminance
    return [
        tr("Luminance: mean {mean:.3g}, maximum {largest:.3g}").format(mean=mean, largest=largest),
        tr("Dynamic range {reach}").format(reach=reach),
        tr("Horizontal illuminance {value:.3g}").format(value=statistics.horizontal_illuminance),
        sun,
    ]


def environment_facts(prepared: PreparedEnvironment, loading: bool) -> str:
    """Return the lines under the chooser; ``loading``: whether the missing maps are on their way."""
    rows, columns = prepared.environment.radiance.shape[:2]
    lines = [tr("{columns} × {rows} pixels").format(columns=columns, rows=rows)]
    # As sentences: notes of files are phrases in lower case.
    lines += [
        text[:1].upper() + text[1:].rstrip(".") + "." for text in map(tr_core, prepared.environment.notes)
    ]
    if prepared.draft:
        lines.append(tr("Draft; full quality follows after editing."))
    elif not prepared.is_final:
        going_on = tr("Refining reflections {what}")
        stopped = tr("Reflections incomplete {what}. Select the light again to finish.")
        what = f"({prepared.wanted - prepared.missing}/{prepared.wanted})"
        lines.append((going_on if loading else stopped).format(what=what))
    return "\n".join([*lines, *map(tr_core, prepared.notices)])


LAYOUT_TITLES = {
    "auto": mark("Auto"),
    "latlong": mark("Latitude-longitude"),
    "horizontal_cross": mark("Cube, horizontal cross"),
    "vertical_cross": mark("Cube, vertical cross"),
    "horizontal_strip": mark("Cube, faces side by side"),
    "vertical_strip": mark("Cube, faces one below another"),
    "exr_cube": mark("Cube of OpenEXR"),
    "angular": mark("Angular probe"),
    "mirror_ball": mark("Mirror ball"),
    "dome": mark("Dome, upper half"),
}


class EnvironmentSection(Section):
    """What the light is, and how its file is read; ``daily``: which light, turned how far, how bright, and seen or not.

    What is found out of a light has its place kept from the start: nothing moves when it comes.
    """

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(tr("Environment"), "environment", parent)
        self.daily = Form()
        self.chooser = SourceChooser(tr("Open an environment file (.exr, .hdr, .brdfstudio)"))
        self.rotation = SliderField(tr("Rotation"), "°", -180.0, 180.0, 1.0, 1, 0.0)
        self.exposure = SliderField(tr("Exposure"), "EV", -8.0, 8.0, 0.1, 2, 0.0)
        self.background = ChoiceBox(BACKGROUND_TITLES)
        self.background_colour = ColourButton(tr("Colour of the background"))
        self.layout_list = ChoiceBox(LAYOUT_TITLES)
        self.edit = QToolButton()
        self.edit.setText(tr("Edit Light"))
        self.edit.setToolTip(tr("Edit this studio or sky in its own panel"))
        self.facts = note(lines=2)
        self.figures = EnvironmentFigures()
        turned = tr("{meaning} (Alt + drag)").format(meaning=tr(PARAMETERS["rotation_deg"].meaning))
        tip = tr("High-dynamic-range panorama or studio that lights the surface")
        self.daily.add_row(tr("Light"), self.chooser, tip)
        self.daily.add_row(tr("Rotation"), self.rotation, turned)
        self.daily.add_row(tr("Exposure"), self.exposure, tr(PARAMETERS["exposure_ev"].meaning))
        tip = tr("Visible background; the light does not change")
        self.daily.add_row(tr("Background"), self.background, tip)
        form = self.add(Form())
        form.add_row(tr("Colour"), self.background_colour, tr("Colour of a plain background"))
        tip = tr("Projection of the image; choose it where detection fails")
        form.add_row(tr("Projection"), self.layout_list, tip)
        form.add_row("", self.edit)
        form.add_wide(self.facts, self.figures)

    def set_background(self, key: str, colour: tuple[float, float, float]) -> None:
        """Show the present background, and its ``colour`` (encoded sRGB, 0 to 1) where it has one."""
        self.background.show_choice(key)
        self.background_colour.set_colour(colour)
        self.background_colour.setEnabled(key == "colour")

    def set_layout(self, key: str, choosable: bool) -> None:
        """Show the present layout; only a file of pixels has a choice of it."""
        self.layout_list.show_choice(key)
        self.layout_list.setEnabled(choosable)

    def set_editable(self, editable: bool) -> None:
        """Offer to edit the light where it has a description."""
        self.edit.setEnabled(editable)
