"""The clearcoat: as a glossmeter reads it or as index and roughness, in step; its haze and its orange peel."""

from __future__ import annotations

import math

from brdf_qt.fields.form import described
from brdf_qt.fields.number import NumberField
from brdf_qt.program.translation import mark, tr
from PySide6.QtCore import Signal
from PySide6.QtWidgets import QCheckBox

from brdf_designer.session.edits import DEFAULT_PEEL, SetCoat, SetField, SetNumber
from brdf_designer.session.paint_session import PaintSession
from brdf_designer.session.state import FitState
from brdf_designer.window.paint_sections import PaintSection, computed
from brdf_designer.window.widgets import wrapped
from brdf_suite.appearance.clearcoat_gloss import (
    HIGHEST_IOR,
    HIGHEST_ROUGHNESS,
    LOWEST_IOR,
    LOWEST_ROUGHNESS,
    haze_units,
)
from brdf_suite.documents.paint import OrangePeel, Paint

_IOR_TIP = mark(
    "Refractive index n of the clearcoat: a higher index reflects more. Resins "
    "have 1.45 to 1.55. Changing it changes both gloss readings."
)
_ROUGHNESS_TIP = mark(
    "Roughness α of the clearcoat: spread of the facet slopes (Beckmann). A new "
    "car has 0.003, satin 0.05. Changing it changes both gloss readings."
)
_HAZE_TIP = mark(
    "Haze index: gloss at 60° minus gloss at 20° (common practice for ASTM D4039), "
    "GU. Light scattered close to the mirror direction raises it and makes a "
    "glossy coat look milky. A smooth clearcoat has about 5 to 12."
)
_SLOPE_TIP = mark("Root mean square slope of the waves. A tenth of a degree is visible at arm's length.")


class CoatSection(PaintSection):
    """Gloss readings, the clearcoat that gives them, and its waviness; ``daily`` is the gloss at 20°
    alone, and ``note``, which stands with it, why no coat has it.

    While index or roughness is edited, the other stays as it was at the start of the gesture. ``gloss_requested()``
    comes before a computed 60° reading is taken: it is shown at idle, and must be of this paint.
    """

    gloss_requested = Signal()

    def __init__(self, session: PaintSession) -> None:
        super().__init__(session)
        self._last_peel = DEFAULT_PEEL
        self.daily = self.make_panel("gloss.gu_20")
        self.panel = self.add_panel("gloss.gu_60")
        self.has_60 = QCheckBox(tr("Specify 60° gloss"))
        self.has_60.setToolTip(
            tr(
                "Both readings determine the refractive index. With 20° alone it is 1.5, or "
                "the value that the reading requires."
            )
        )
        self.has_60.clicked.connect(self._switch_60)
        self.panel.add_row("", self.has_60)
        self.ior = NumberField(tr("Index n"), "", LOWEST_IOR, HIGHEST_IOR, 0.005, 3, 1.5)
        self.roughness = NumberField(
            tr("Roughness of the coat"), "", LOWEST_ROUGHNESS, HIGHEST_ROUGHNESS, 0.001, 4, LOWEST_ROUGHNESS
        )
        for field, key, label, tip in (
            (self.ior, "ior", tr("Index n"), tr(_IOR_TIP)),
            (self.roughness, "roughness", tr("Roughness α"), tr(_ROUGHNESS_TIP)),
        ):
            self.panel.add_row(label, described(field, name=f"field_coat.{key}"), tip)
            field.edited.connect(lambda _value, key=key: self._set_coat(key))
            field.gesture_started.connect(self._begin_coat)
            field.gesture_finished.connect(self._end_coat)
        self.haze = computed()
        self.panel.add_row(tr("Haze"), self.haze, tr(_HAZE_TIP))
        self.note = wrapped(lines=2)
        self.note.hide()
        self.has_peel = QCheckBox(tr("Orange peel"))
        self.has_peel.setToolTip(tr("Waviness of a sprayed coat. Viewer renders it; a view can override it."))
        self.has_peel.clicked.connect(
            lambda on: session.edit(SetField("orange_peel", self._last_peel if on else None))
        )
        self.box.addWidget(self.has_peel)
        self.peel = self.add_panel("orange_peel.amplitude_um", "orange_peel.wavelength_mm")
        self.slope = computed()
        self.peel.add_row(tr("Slope"), self.slope, tr(_SLOPE_TIP))
        self._solved = (1.5, LOWEST_ROUGHNESS)
        self._held: tuple[float, float] | None = None
        self._asked: tuple[float, float] | None = None
        self._taken = False

    def part_of(self, paint: Paint) -> object:
        """Return what of a paint is shown here."""
        return paint.gloss, paint.orange_peel

    def show_paint(self, paint: Paint) -> None:
        """Show the readings and the orange peel."""
        field = self.panel.fields["gloss.gu_60"]
        known = paint.gloss.gu_60 is not None
        self.daily.set_values({"gloss.gu_20": paint.gloss.gu_20})
        if paint.gloss.gu_60 is not None:
            field.set_value(paint.gloss.gu_60)
            self._show_haze(haze_units(paint.gloss.gu_20, paint.gloss.gu_60), tr("from the readings"))
        field.setEnabled(known)
        self.has_60.setChecked(known)
        peel: OrangePeel = paint.orange_peel or self._last_peel
        self._last_peel = peel
        self.has_peel.setChecked(paint.orange_peel is not None)
        self.peel.setEnabled(paint.orange_peel is not None)
        self.peel.set_values(
            {"orange_peel.amplitude_um": peel.amplitude_um, "orange_peel.wavelength_mm": peel.wavelength_mm}
        )
        self.slope.setText(tr("{slope:.3f}° RMS, computed").format(slope=peel.slope_deg))

    def show_fit(self, state: FitState) -> None:
        """Show the coat that was solved."""
        self._taken = True
        self._solved = (state.ior, state.roughness)
        for field, value in zip((self.ior, self.roughness), self._solved, strict=True):
            field.setEnabled(True)
            field.set_value(value)
        self._show_note()

    def show_gloss(self, gu_20: float, gu_60: float) -> None:
        """Show the haze of a paint whose 60° reading is not known, from what its coat and base would read."""
        self._show_haze(haze_units(gu_20, gu_60), tr("computed"))
        field = self.panel.fields["gloss.gu_60"]
        if not field.isEnabled():
            field.set_value(gu_60)

    def mark_stale(self) -> None:
        """Say that no coat gives these readings."""
        self._asked, self._taken = None, True
        for field in (self.ior, self.roughness):
            field.setEnabled(False)
        self.haze.setText(tr("–, impossible coat"))

    def show_refusal(self, text: str) -> None:
        """Say why no coat gives the readings, with what could be reached."""
        self.note.setText(text)
        self.note.setVisible(bool(text))

    def _show_haze(self, haze: float, source: str) -> None:
        self.haze.setText(tr("{haze:.1f} GU, {source}").format(haze=haze, source=source).replace("-", "−"))

    def _show_note(self) -> None:
        """Show a note where another coat has the same readings."""
        text = ""
        if self._asked is not None:
            ior, roughness = self._asked
            if abs(ior - self._solved[0]) > 0.005 or abs(math.log(roughness / self._solved[1])) > 0.1:
                text = tr(
                    "A coat with n {ior:.3f} and α {roughness:.4f} has the same gloss at 20 and "
                    "60°. The paint stores the readings, and the coat with n closest to 1.5 is "
                    "used."
                ).format(ior=ior, roughness=roughness)
        self.show_refusal(text)

    def _begin_coat(self) -> None:
        self._held = self._solved
        self.session.begin_gesture()

    def _end_coat(self) -> None:
        self._held = None
        self.session.end_gesture()

    def _set_coat(self, key: str) -> None:
        held = self._held or self._solved
        ior, roughness = (self.ior.value(), held[1]) if key == "ior" else (held[0], self.roughness.value())
        self._asked, self._taken = (ior, roughness), False
        self.session.edit(SetCoat(key, ior, roughness))
        if self.session.is_fitting:
            self.session.fit_now()
        self._asked = None
        if not self._taken:
            # It was refused: what is shown is the coat that the paint has.
            for field, solved in zip((self.ior, self.roughness), self._solved, strict=True):
                field.set_value(solved)

    def _switch_60(self, on: bool) -> None:
        if on:
            self.gloss_requested.emit()
        value = self.panel.fields["gloss.gu_60"].value() if on else None
        self.session.edit(SetNumber("gloss.gu_60", value))
