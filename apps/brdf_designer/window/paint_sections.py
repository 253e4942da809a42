"""What the sections of a paint share; the model between the readings, and what is written about the paint."""

from __future__ import annotations

from brdf_qt.fields.form import Form, fill_column
from brdf_qt.fields.labels import PlainLabel
from brdf_qt.fields.marks import Mark
from brdf_qt.fields.number import reach_of
from brdf_qt.fields.parameters import ParameterPanel
from brdf_qt.fields.text import TextLine, TextNotes
from brdf_qt.program.core_texts import tr_core
from brdf_qt.program.translation import mark, tr
from PySide6.QtWidgets import QLabel, QWidget

from brdf_designer.session.edits import SetField, SetNumber
from brdf_designer.session.paint_session import PaintSession
from brdf_designer.window.widgets import combo, set_font, wrapped
from brdf_suite.documents.paint import INTERPOLATIONS, PARAMETERS, Paint

_STEPS = {
    "gloss.gu_20": (0.5, 1),
    "gloss.gu_60": (0.5, 1),
    "orange_peel.amplitude_um": (0.05, 2),
    "orange_peel.wavelength_mm": (0.5, 1),
    "flakes.density_per_mm2": (5.0, 0),
    "flakes.size_um": (1.0, 1),
    "flakes.roughness": (0.005, 3),
    "flakes.colour_spread": (0.01, 2),
    "near_specular": (0.05, 2),
}
_LABELS = {
    "gloss.gu_20": mark("Gloss 20°"),
    "gloss.gu_60": mark("Gloss 60°"),
    "orange_peel.amplitude_um": mark("Height"),
    "orange_peel.wavelength_mm": mark("Wavelength"),
    "flakes.density_per_mm2": mark("Density"),
    "flakes.size_um": mark("Size"),
    "flakes.roughness": mark("Roughness"),
    "flakes.colour_spread": mark("Colour spread"),
    "near_specular": mark("Near-specular"),
}
_TIPS = {
    "gloss.gu_20": mark(
        "Gloss units at 20° (ASTM D523, ISO 2813): polished black glass of index 1.567 "
        "has 100. Coat and base together. The narrow 20° receptor distinguishes glossy "
        "coats."
    ),
    "gloss.gu_60": mark(
        "Gloss units at 60°, coat and base together: the wide receptor, for coats of "
        "any gloss. Both readings determine the index and roughness of the coat."
    ),
    "orange_peel.amplitude_um": mark(
        "Root mean square height of the waviness of the coat, µm. A good finish has a "
        "few tenths of a micrometre."
    ),
    "orange_peel.wavelength_mm": mark(
        "Typical distance from crest to crest, mm. Waves of 1 to 10 mm are visible at "
        "arm's length as orange peel. They blur the edges of reflections and lower the "
        "distinctness of image (DOI)."
    ),
    "flakes.density_per_mm2": mark(
        "Number of individually visible flakes per square millimetre. Most flakes of a "
        "paint lie too deep to be visible."
    ),
    "flakes.size_um": mark(
        "Mean diameter of a flake, µm; larger flakes are brighter and sparkle more coarsely."
    ),
    "flakes.roughness": mark(
        "Spread of the flake tilts as the root mean square slope m: about 0.15 to 0.19 "
        "for metallic paints. A wider spread sparkles at more angles, but less at each."
    ),
    "flakes.colour_spread": mark("Variation of the flake colours: 0 all equal, 1 all hues."),
    "near_specular": mark("Scale of the base in the mirror direction, where instruments do not measure."),
}
_RULES = {
    "flake": mark("Flake tilts (bell)"),
    "monotone": mark("Monotone (PCHIP)"),
    "polynomial": mark("Polynomial (2nd order)"),
}


def computed() -> QLabel:
    """Return a label for a computed value: italic, as everywhere."""
    label = PlainLabel("–")
    set_font(label, italic=True)
    return label


class PaintSection(QWidget):
    """What the sections share: the session whose paint they edit, and panels of its numbers."""

    def __init__(self, session: PaintSession) -> None:
        super().__init__()
        self.session = session
        self.box = fill_column(self)

    def add_panel(self, *keys: str) -> ParameterPanel:
        """Add numbers of the document by their names in ``PARAMETERS``."""
        panel = self.make_panel(*keys)
        self.box.addWidget(panel)
        return panel

    def make_panel(self, *keys: str) -> ParameterPanel:
        """Return numbers of the document by their names in ``PARAMETERS``, for another place than the section."""
        panel = ParameterPanel()
        for key in keys:
            unit, *reach = reach_of(PARAMETERS[key], *_STEPS[key])
            unit = "×" if key == "near_specular" else unit
            panel.add_parameter(key, tr(_LABELS[key]), unit, *reach, tip=tr(_TIPS[key]))
        panel.edited.connect(lambda key, value: self.session.edit(SetNumber(key, value)))
        panel.gesture_started.connect(self.session.begin_gesture)
        panel.gesture_finished.connect(self.session.end_gesture)
        return panel


class ModelSection(PaintSection):
    """How colours between and beyond the readings are found."""

    def __init__(self, session: PaintSession) -> None:
        super().__init__(session)
        form = Form()
        self.rule = combo((tr(_RULES[name]), name) for name in INTERPOLATIONS)
        self.rule.activated.connect(
            lambda row: session.edit(SetField("interpolation", self.rule.itemData(row)))
        )
        form.add_row(
            tr("Between angles"),
            self.rule,
            tr(
                "Interpolation between the measured angles: a bell of flake tilts, a monotone "
                "curve through L*a*b*, or a parabola."
            ),
        )
        self.changed = wrapped(lines=1)
        self.changed.set_mark(Mark.CHANGED)
        self.changed.hide()
        self._opened = ""
        form.add_wide(self.changed)
        self.box.addWidget(form)
        self.panel = self.add_panel("near_specular")
        self.note = wrapped(tr("Not measured: instruments with three angles do not measure below 15°."))
        self.notices = wrapped(lines=2)
        self.box.addWidget(self.note)
        self.box.addWidget(self.notices)
        self.notices.hide()

    def part_of(self, paint: Paint) -> object:
        """Return what of a paint is shown here."""
        return paint.interpolation, paint.near_specular, [m.aspecular_deg for m in paint.measurements]

    def show_paint(self, paint: Paint) -> None:
        """Show the rule and the factor."""
        self.rule.setCurrentIndex(self.rule.findData(paint.interpolation))
        self._opened = self._opened or paint.interpolation
        self.changed.setText(tr("Opened with: {rule}").format(rule=tr(_RULES[self._opened])))
        self.changed.setVisible(self.has_changed)
        self.panel.set_values({"near_specular": paint.near_specular})
        nearest = min(abs(m.aspecular_deg) for m in paint.measurements)
        note = tr("Not measured: no reading is closer to the mirror direction than {angle:g}°.")
        self.note.setText(note.format(angle=nearest))

    @property
    def has_changed(self) -> bool:
        """Whether the rule is another than that of the paint as it was opened."""
        return self._opened not in ("", self.rule.currentData())

    def keep_opened(self) -> None:
        """Take the rule that is shown for that of the paint as it was opened."""
        self._opened = str(self.rule.currentData())
        self.changed.hide()

    def show_notices(self, notices: tuple[str, ...]) -> None:
        """Show what the model has to say about this paint."""
        self.notices.setText(
            "\n".join(f"{text[:1].upper()}{text[1:].rstrip('.')}." for text in map(tr_core, notices))
        )
        self.notices.setVisible(bool(notices))


class TextSection(PaintSection):
    """Source and notes; ``name`` stands elsewhere, in ``daily``."""

    def __init__(self, session: PaintSession) -> None:
        super().__init__(session)
        form, self.daily = Form(), Form()
        self.name = TextLine(tr("Name"), 200)
        self.source = TextNotes(tr("Source"), 2)
        self.notes = TextNotes(tr("Notes"))
        self.illuminant = PlainLabel()
        for field, key, label, tip in (
            (self.name, "name", tr("Name"), tr("Name of the paint")),
            (self.source, "source", tr("Source"), tr("Source of the readings")),
            (self.notes, "notes", tr("Notes"), ""),
        ):
            field.edited.connect(lambda text, key=key: session.edit(SetField(key, text)))
            field.gesture_started.connect(session.begin_gesture)
            field.gesture_finished.connect(session.end_gesture)
            (self.daily if field is self.name else form).add_row(label, field, tip)
        form.add_row(tr("Readings"), self.illuminant, tr("Illuminant and observer of all L*a*b* values"))
        self.box.addWidget(form)

    def part_of(self, paint: Paint) -> object:
        """Return what of a paint is shown here."""
        return paint.name, paint.source, paint.notes, paint.illuminant, paint.observer_deg

    def show_paint(self, paint: Paint) -> None:
        """Show the texts."""
        self.name.set_text(paint.name)
        self.source.set_text(paint.source)
        self.notes.set_text(paint.notes)
        text = tr("{illuminant}, {observer}° observer")
        self.illuminant.setText(text.format(illuminant=paint.illuminant, observer=paint.observer_deg))
