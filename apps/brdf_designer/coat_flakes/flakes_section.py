"""The flakes that sparkle, and our own figure of how much they do."""

from __future__ import annotations

from brdf_qt.fields.form import Form, described
from brdf_qt.program.translation import mark, tr
from PySide6.QtWidgets import QCheckBox, QLabel

from brdf_designer.session.edits import DEFAULT_FLAKES, SetField
from brdf_designer.session.paint_session import PaintSession
from brdf_designer.window.paint_sections import PaintSection, computed
from brdf_suite.documents.paint import Flakes, Paint
from brdf_suite.inspection.sparkle import ANGLES_DEG, CONTRAST, DISTANCE_MM, RESOLVED_MM, SparkleReadings

_DRAWN = mark(
    "Viewer renders these flakes individually in the brightest lights. The mean "
    "colour still matches the readings."
)
_FIGURE = mark(
    "Sparkle (BRDF Suite metric), computed from the flake model: spots per mm² "
    "that are at least {contrast:.0%} brighter than their surroundings, and their "
    "mean contrast. In the sun at 45° from the normal, seen from {distance:g} mm "
    "by an eye that resolves {resolved:.3f} mm. Not comparable with the readings "
    "of an instrument."
)


class FlakesSection(PaintSection):
    """The flakes of the document, and what they do."""

    _KEYS = ("density_per_mm2", "size_um", "roughness", "colour_spread")

    def __init__(self, session: PaintSession) -> None:
        super().__init__(session)
        self._last = DEFAULT_FLAKES
        self.has_flakes = described(QCheckBox(tr("Visible flakes")), tip=tr(_DRAWN))
        self.has_flakes.clicked.connect(
            lambda on: session.edit(SetField("flakes", self._last if on else None))
        )
        self.box.addWidget(self.has_flakes)
        self.panel = self.add_panel(*(f"flakes.{key}" for key in self._KEYS))
        form = Form()
        tip = tr(_FIGURE).format(contrast=CONTRAST, distance=DISTANCE_MM, resolved=RESOLVED_MM)
        self.figures: dict[float, QLabel] = {}
        for angle in ANGLES_DEG:
            label = described(computed(), name=f"sparkle_{angle:g}")
            form.add_row(tr("Sparkle {angle:g}°").format(angle=angle), label, tip)
            self.figures[angle] = label
        self.box.addWidget(form)

    def part_of(self, paint: Paint) -> object:
        """Return what of a paint is shown here."""
        return paint.flakes

    def show_paint(self, paint: Paint) -> None:
        """Show the flakes; without any, the numbers that switching on would give, disabled."""
        self.has_flakes.setChecked(paint.flakes is not None)
        self.panel.setEnabled(paint.flakes is not None)
        flakes: Flakes = paint.flakes or self._last
        self._last = flakes
        self.panel.set_values({f"flakes.{key}": getattr(flakes, key) for key in self._KEYS})

    def show_sparkle(self, rows: tuple[SparkleReadings, ...]) -> None:
        """Show our own figure per aspecular angle; nothing: it is not known."""
        for label in self.figures.values():
            label.setText("–")
        for row in rows:
            self.figures[row.aspecular_deg].setText(_text(row))


def _text(row: SparkleReadings) -> str:
    if row.spots_per_mm2 == 0.0:
        return tr("no spots")
    if row.crowded:
        return tr("grain: spots run together")
    return tr("{spots:.2f} spots/mm², contrast {contrast:.1f}").format(
        spots=row.spots_per_mm2, contrast=row.mean_contrast
    )
