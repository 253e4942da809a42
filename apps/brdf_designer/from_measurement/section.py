"""What was read of a measurement that the design started from, and how well the design stands for it elsewhere."""

from __future__ import annotations

from brdf_qt.fields.form import Form, fill_column
from brdf_qt.program.core_texts import tr_core
from brdf_qt.program.translation import decimal, mark, tr
from PySide6.QtCore import Signal
from PySide6.QtWidgets import QWidget

from brdf_designer.standard_comparison.tables import WholeTable
from brdf_designer.window.widgets import button, combo, wrapped
from brdf_suite.documents.store import PAINT_ENDING
from brdf_suite.paint_design.measured_start import HELD_OUT_LIGHTS_DEG, MeasuredStart
from brdf_suite.reflectance.instruments.spectrophotometer import SUPPORT_DEG

ANGLE_SETS = (
    ("e2194", mark("3 angles: 15, 45, 110°")),
    ("five", mark("5 angles: 15, 25, 45, 75, 110°")),
    ("six", mark("6 angles: −15, 15, 25, 45, 75, 110°")),
)


class MeasuredSection(QWidget):
    """The body of the section.

    Intents: ``again_requested(name)`` with a geometry set's name, ``standard_requested`` to judge against the original.
    """

    again_requested = Signal(str)
    standard_requested = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.origin, self.support, self.gloss, self.summary, self.notices = (wrapped() for _ in range(5))
        form = Form()
        self.angles = combo((tr(title), name) for name, title in ANGLE_SETS)
        self.angles.activated.connect(
            lambda _index: self.again_requested.emit(str(self.angles.currentData()))
        )
        form.add_row(
            tr("Read at"), self.angles, tr("Angles of the design; another set measures the original again")
        )
        headings = (tr("Angle"), *(tr("light {angle:g}°").format(angle=one) for one in HELD_OUT_LIGHTS_DEG))
        self.table = WholeTable(tr("ΔE00 between the design and the original"), headings)
        self.table.setToolTip(tr("ΔE00 between the design and the original at angles that were not used"))
        tip = tr("Compare the design with the measured original at every angle")
        self.standard = button(tr("Original as Standard"), tip, self.standard_requested.emit)
        fill_column(
            self,
            self.origin,
            form,
            self.support,
            self.gloss,
            self.summary,
            self.table,
            self.standard,
            self.notices,
        )

    def show_start(self, start: MeasuredStart) -> None:
        """Show what was read, and the differences at angles that were not."""
        self.origin.setText(tr_core(start.paint.source))
        self.angles.setCurrentIndex(self.angles.findData(start.geometry_set.name))
        self.support.setText(_support(start))
        self.support.setVisible(bool(self.support.text()))
        self.gloss.setText(_gloss(start))
        self.summary.setText(_summary(start))
        angles = sorted({row.aspecular_deg for row in start.held_out})
        known = {(row.illumination_deg, row.aspecular_deg): row for row in start.held_out}
        self.table.set_row_count(len(angles))
        for number, angle in enumerate(angles):
            self.table.set_text(number, 0, f"{angle:g}°")
            for place, light in enumerate(HELD_OUT_LIGHTS_DEG, 1):
                row = known.get((light, angle))
                text = (
                    "–"
                    if row is None
                    else decimal(f"{row.delta_e_2000:.1f}") + ("" if row.supported else "†")
                )
                self.table.set_text(number, place, text)
        self.table.setVisible(bool(angles))
        self.notices.setText(tr_core("\n".join(start.notices)))


def _support(start: MeasuredStart) -> str:
    """The readings, and the marked differences, that no sample of the original supports."""
    far = [one for one in start.readings if not one.supported]
    lines = []
    if far:
        angles = ", ".join(f"{one.geometry.label} ({one.sample_deg:.0f}°)" for one in far)
        lines.append(
            tr("Readings without a sample within {limit:g}° (nearest): {angles}").format(
                limit=SUPPORT_DEG, angles=angles
            )
        )
    if not all(row.supported for row in start.held_out):
        lines.append(tr("† No sample of the original within {limit:g}°").format(limit=SUPPORT_DEG))
    return "\n".join(lines)


def _gloss(start: MeasuredStart) -> str:
    readings = start.gloss.readings
    if not readings:
        return tr("Glossmeter: no reading; {gloss:g} GU at 20° is set, not measured").format(
            gloss=start.paint.gloss.gu_20
        )
    read = ", ".join(decimal(f"{value:.1f} GU {angle}°") for angle, value in readings.items())
    if start.gloss_used:
        return tr("Glossmeter: {readings}").format(readings=read)
    return tr("Glossmeter: {readings}; {gloss:g} GU at 20° is set instead").format(
        readings=read, gloss=start.paint.gloss.gu_20
    )


def _summary(start: MeasuredStart) -> str:
    worst, mean = start.worst, start.mean_delta_e
    if worst is None or mean is None:
        return tr("The design cannot be compared with the original: the paint is impossible.")
    return tr(
        "ΔE00 to the original at {count} angles that were not used: mean {mean:.1f}, at most {worst:.1f} "
        "({angle:g}°, light {light:g}°)"
    ).format(
        count=len(start.held_out),
        mean=mean,
        worst=worst.delta_e_2000,
        angle=worst.aspecular_deg,
        light=worst.illumination_deg,
    )


def patterns(*more: str) -> str:
    """Return the patterns of every measured format and of ``more`` endings: ``*.bsdf *.brdf …``."""
    # Every reader comes with the list of formats; a start that opens no such dialog does without.
    from brdf_suite.files.measured import FORMATS

    endings = dict.fromkeys((*more, *(ending for known in FORMATS for ending in known.endings)))
    return " ".join(f"*{ending}" for ending in endings)


def start_patterns() -> str:
    """Return the patterns of whatever may hold readings to start a design from."""
    from brdf_suite.files.palettes import FORMATS

    return patterns(PAINT_ENDING, *(ending for known in FORMATS if known.paints for ending in known.endings))


def standard_patterns() -> str:
    """Return the patterns of whatever may hold a standard."""
    from brdf_suite.files.palettes import FORMATS

    return patterns(PAINT_ENDING, *(ending for known in FORMATS for ending in known.endings))
