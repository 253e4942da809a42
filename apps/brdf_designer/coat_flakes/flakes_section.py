"""The flakes that sparkle."""

from __future__ import annotations

from brdf_qt.fields.form import described
from brdf_qt.program.translation import mark, tr
from PySide6.QtWidgets import QCheckBox

from brdf_designer.session.edits import DEFAULT_FLAKES, SetField
from brdf_designer.session.paint_session import PaintSession
from brdf_designer.window.paint_sections import PaintSection
from brdf_suite.documents.paint import Flakes, Paint

_DRAWN = mark(
    "Viewer renders these flakes individually in the brightest lights. The mean "
    "colour still matches the readings."
)


class FlakesSection(PaintSection):
    """The flakes of the document; ``daily`` are their density and size."""

    _DAILY, _KEYS = ("density_per_mm2", "size_um"), ("roughness", "colour_spread")

    def __init__(self, session: PaintSession) -> None:
        super().__init__(session)
        self._last = DEFAULT_FLAKES
        self.has_flakes = described(QCheckBox(tr("Visible flakes")), tip=tr(_DRAWN))
        self.has_flakes.clicked.connect(
            lambda on: session.edit(SetField("flakes", self._last if on else None))
        )
        self.daily = self.make_panel(*(f"flakes.{key}" for key in self._DAILY))
        self.panel = self.add_panel(*(f"flakes.{key}" for key in self._KEYS))

    def part_of(self, paint: Paint) -> object:
        """Return what of a paint is shown here."""
        return paint.flakes

    def show_paint(self, paint: Paint) -> None:
        """Show the flakes; without any, the numbers that switching on would give, disabled."""
        self.has_flakes.setChecked(paint.flakes is not None)
        for panel in (self.daily, self.panel):
            panel.setEnabled(paint.flakes is not None)
        flakes: Flakes = paint.flakes or self._last
        self._last = flakes
        for panel, keys in ((self.daily, self._DAILY), (self.panel, self._KEYS)):
            panel.set_values({f"flakes.{key}": getattr(flakes, key) for key in keys})
