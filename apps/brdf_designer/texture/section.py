"""The Texture section: readings of sparkle and graininess, what they should be, and the search for flakes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from brdf_qt.fields.form import Form, described, fill_column, row_of
from brdf_qt.fields.labels import plain_tip
from brdf_qt.fields.number import NumberField
from brdf_qt.program.translation import decimal, mark, tr
from PySide6.QtCore import Signal
from PySide6.QtWidgets import QPushButton, QTableWidgetItem, QWidget

from brdf_designer.standard_comparison.tables import WholeTable
from brdf_designer.window.widgets import wrapped
from brdf_suite.appearance.texture import LIGHTS_DEG, NO_TEXTURE, VISIBLE_CONTRAST, TextureReadings

TARGETS = (*(f"grade_{light:g}" for light in LIGHTS_DEG), "graininess")
"""Names of the numbers to aim at, in the order of ``TextureReadings.scales``."""
USUAL_TOLERANCE = 10.0
"""Per cent of the target."""

_ABOUT = mark(
    "Read from simulated pictures of the flakes, from 500 mm, by an eye that resolves one minute of arc, on a scale "
    "of BRDF Suite: not comparable with the indices of makers of instruments."
)
_GRADE = mark(
    "Contrast that sparkles add to the picture: root mean square of all places that are at least {contrast:.0%} "
    "brighter than the mean. The light comes from {light:g}° off the normal."
)
_GRAININESS = mark("Standard deviation of the picture in diffuse light, over its mean.")
_OPEN = mark("– leaves it open.")


@dataclass(frozen=True)
class Judged:
    """A reading over its target, minus 1, and whether that is within the tolerance."""

    deviation: float
    passes: bool


class TextureSection(QWidget):
    """The body of the section.

    Intents: ``targets_edited()``, ``tolerance_edited()``, ``take_requested()``, ``find_requested()``.
    """

    targets_edited = Signal()
    tolerance_edited = Signal()
    take_requested = Signal()
    find_requested = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        headings = (tr("Light"), tr("Grade"), tr("Area"), tr("Intensity"), tr("To target"))
        self.table = WholeTable(tr("Sparkle and graininess"), headings)
        self.table.setObjectName("texture_readings")
        self.table.setToolTip(plain_tip(tr(_ABOUT)))
        tips = (
            "",
            tr("What sparkles add to the contrast of the picture"),
            tr("Share of the picture that sparkles"),
            tr("Mean contrast of the sparkling points: 1 is twice as bright as the surface"),
            tr("Difference from the target; bold where it is beyond the tolerance"),
        )
        for column, tip in enumerate(tips):
            heading: QTableWidgetItem | None = self.table.horizontalHeaderItem(column)
            if heading is not None and tip:
                heading.setToolTip(plain_tip(tip))
        self.table.set_row_count(len(TARGETS))
        self.note = wrapped()
        self.note.setObjectName("texture_note")
        form = Form()
        self.targets: dict[str, NumberField] = {}
        for light, key in zip((*LIGHTS_DEG, None), TARGETS, strict=True):
            if light is None:
                label, tip, most, digits = tr("Target, diffuse"), tr(_GRAININESS), 100.0, 2
            else:
                label = tr("Target {angle:g}°").format(angle=light)
                tip = tr(_GRADE).format(contrast=VISIBLE_CONTRAST, light=light)
                most, digits = 5000.0, 1
            field = NumberField(label, "%", 0.0, most, 1.0 if light else 0.1, digits, 0.0)
            field.setSpecialValueText("–")
            field.edited.connect(lambda _value: self.targets_edited.emit())
            form.add_row(label, described(field, name=f"texture_{key}"), f"{tip} {tr(_OPEN)}")
            self.targets[key] = field
        self.tolerance = described(
            NumberField(tr("Tolerance"), "%", 0.5, 100.0, 1.0, 1, USUAL_TOLERANCE), name="texture_tolerance"
        )
        self.tolerance.edited.connect(lambda _value: self.tolerance_edited.emit())
        form.add_row(tr("Tolerance"), self.tolerance, tr("Of each target, to either side"))
        self.take = described(
            QPushButton(tr("Use Readings")), name="texture_take", tip=tr("Make the readings the targets.")
        )
        self.search = described(
            QPushButton(tr("Find Flakes")),
            name="texture_find",
            tip=tr("Look for density, size and roughness of flakes that have these readings, as one step."),
        )
        self.take.clicked.connect(lambda _=False: self.take_requested.emit())
        self.search.clicked.connect(lambda _=False: self.find_requested.emit())
        self.answer = wrapped(lines=1)
        self.answer.setObjectName("texture_answer")
        self.answer.hide()
        fill_column(self, self.table, self.note, form, row_of(None, self.take, self.search), self.answer)
        self._searching = False
        self.show_readings(None)

    def wanted(self) -> tuple[float | None, ...]:
        """Return the targets as shares of 1, None where one is left open."""
        values = (self.targets[key].value() for key in TARGETS)
        return tuple(value / 100.0 if value > 0.0 else None for value in values)

    def show_wanted(self, wanted: Sequence[float | None]) -> None:
        """Show targets."""
        for key, value in zip(TARGETS, wanted, strict=True):
            self.targets[key].set_value(100.0 * (value or 0.0))
        self._show_actions()

    def show_readings(self, readings: TextureReadings | None) -> None:
        """Show readings; None: they are not known yet, or there is no such paint."""
        none = readings == NO_TEXTURE
        self.note.setText(tr("This paint has no flakes: no sparkle, no graininess.") if none else "")
        self.note.setVisible(none)
        self.table.setVisible(not none)
        names = [*(f"{light:g}°" for light in LIGHTS_DEG), tr("diffuse")]
        rows = [["–"] * 3 for _ in TARGETS]
        if readings is not None:
            for row, one in zip(rows, readings.sparkle, strict=False):
                row[:] = (
                    decimal(f"{100 * one.grade:.1f} %"),
                    decimal(f"{100 * one.area:.1f} %"),
                    decimal(f"{one.intensity:.1f}"),
                )
            rows[-1] = [decimal(f"{100 * readings.graininess:.2f} %"), "", ""]
        for place, (name, row) in enumerate(zip(names, rows, strict=True)):
            tip = tr(_GRAININESS) if place == len(LIGHTS_DEG) else ""
            if readings is not None and place < len(LIGHTS_DEG):
                points = readings.sparkle[place].points_per_mm2
                tip = tr("{points:.2f} points/mm²").format(points=points)
            for column, text in enumerate((name, *row)):
                self.table.set_text(place, column, text, tip=tip)
        self.take.setEnabled(readings is not None and not none)

    def show_judged(self, judged: Sequence[Judged | None]) -> None:
        """Show how far readings are from targets; None where there is no target."""
        for row, one in enumerate(judged):
            text = "" if one is None else f"{round(100 * one.deviation):+d} %".replace("-", "−")
            verdict = "" if one is None else tr("within tolerance") if one.passes else tr("beyond tolerance")
            self.table.set_text(row, 4, text, bold=one is not None and not one.passes, tip=verdict)
        self._show_actions()

    def show_answer(self, text: str) -> None:
        """Say what came of the search; nothing: there is nothing to say."""
        self.answer.setText(text)
        self.answer.setVisible(bool(text))

    def show_searching(self, searching: bool) -> None:
        """Show whether flakes are looked for; one search runs at a time."""
        self._searching = searching
        self._show_actions()

    def show_old(self) -> None:
        """Show that the readings are of an earlier paint: they are no targets."""
        self.take.setEnabled(False)

    def _show_actions(self) -> None:
        self.search.setEnabled(not self._searching and any(value is not None for value in self.wanted()))
