"""The other sections of the inspector: coat, flakes, model, and what is written about the paint."""

from __future__ import annotations

from brdf_qt.form import Form
from brdf_qt.parameters import Parameter, ParameterPanel
from brdf_qt.text_fields import TextLine, TextNotes
from PySide6.QtCore import Signal
from PySide6.QtWidgets import QCheckBox, QComboBox, QLabel, QVBoxLayout, QWidget

from brdf_designer.desk_state import FitState
from brdf_designer.fields import DEFAULT_FLAKES, Key
from brdf_suite.documents.paint import INTERPOLATIONS, PARAMETERS, Flakes, Paint

_STEPS = {
    "gloss.gu_20": (0.5, 1),
    "gloss.gu_60": (0.5, 1),
    "flakes.density_per_mm2": (5.0, 0),
    "flakes.size_um": (1.0, 1),
    "flakes.roughness": (0.005, 3),
    "flakes.colour_spread": (0.01, 2),
    "near_specular": (0.05, 2),
}
_LABELS = {
    "gloss.gu_20": "Gloss 20°",
    "gloss.gu_60": "Gloss 60°",
    "flakes.density_per_mm2": "Density",
    "flakes.size_um": "Size",
    "flakes.roughness": "Roughness",
    "flakes.colour_spread": "Colour spread",
    "near_specular": "Near-specular",
}
_RULES = {
    "flake": "Flake tilts (bell)",
    "monotone": "Monotone (PCHIP)",
    "polynomial": "Polynomial (2nd order)",
}


def _parameter(key: str) -> Parameter:
    known = PARAMETERS[key]
    step, decimals = _STEPS[key]
    unit = "×" if key == "near_specular" else known.unit
    return Parameter(
        key, _LABELS[key], unit, known.low, known.high, step, decimals, known.default, known.meaning
    )


def _computed() -> QLabel:
    """Return a label for a computed value: italic, as everywhere."""
    label = QLabel("–")
    font = label.font()
    font.setItalic(True)
    label.setFont(font)
    return label


class PaintSection(QWidget):
    """What the four sections share: intents out by field key."""

    edited = Signal(object, object)
    gesture_started = Signal(object)
    gesture_finished = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.box = QVBoxLayout(self)
        self.box.setContentsMargins(0, 0, 0, 0)
        self.box.setSpacing(8)

    def add_panel(self, *keys: str) -> ParameterPanel:
        """Add numbers of the document by their names in ``PARAMETERS``."""
        panel = ParameterPanel([_parameter(key) for key in keys])
        panel.edited.connect(lambda key, value: self.edited.emit(_key(key), value))
        panel.gesture_started.connect(lambda key: self.gesture_started.emit(_key(key)))
        panel.gesture_finished.connect(lambda _key: self.gesture_finished.emit())
        self.box.addWidget(panel)
        return panel


def _key(name: str) -> Key:
    return tuple(name.split("."))


class CoatSection(PaintSection):
    """Gloss readings, and the clearcoat that gives them."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.panel = self.add_panel("gloss.gu_20", "gloss.gu_60")
        self.has_60 = QCheckBox("A 60° reading is known")
        self.has_60.setToolTip("With both readings the refractive index is solved too; otherwise it is 1.5.")
        self.has_60.clicked.connect(self._switch_60)
        self.panel.add_row("", self.has_60)
        self.ior, self.roughness = _computed(), _computed()
        self.panel.add_row("Index n", self.ior, "Refractive index of the clearcoat, solved from the gloss")
        self.panel.add_row("Roughness α", self.roughness, "Width of the coat's facets, solved from the gloss")

    def show_paint(self, paint: Paint) -> None:
        """Show the readings."""
        field = self.panel.fields["gloss.gu_60"]
        known = paint.gloss.gu_60 is not None
        self.panel.set_values({"gloss.gu_20": paint.gloss.gu_20})
        if paint.gloss.gu_60 is not None:
            field.set_value(paint.gloss.gu_60)
        field.setEnabled(known)
        self.has_60.setChecked(known)

    def show_fit(self, state: FitState) -> None:
        """Show the coat that was solved."""
        self.ior.setText(f"{state.ior:.3f}, computed")
        self.roughness.setText(f"{state.roughness:.4f}, computed")

    def mark_stale(self) -> None:
        """Say that no coat gives these readings."""
        for label in (self.ior, self.roughness):
            label.setText("–, no such coat")

    def _switch_60(self, on: bool) -> None:
        value = self.panel.fields["gloss.gu_60"].value() if on else None
        self.edited.emit(("gloss", "gu_60"), value)


NOT_DRAWN = "Kept with the paint; the picture does not draw flakes yet."


class FlakesSection(PaintSection):
    """The flakes that will sparkle; part of the document."""

    _KEYS = ("density_per_mm2", "size_um", "roughness", "colour_spread")

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.has_flakes = QCheckBox("Flakes that can be seen")
        self.has_flakes.setToolTip(NOT_DRAWN)
        self.has_flakes.clicked.connect(self._switch)
        self.box.addWidget(self.has_flakes)
        self.note = QLabel(NOT_DRAWN)
        self.note.setWordWrap(True)
        self.box.addWidget(self.note)
        self.panel = self.add_panel(*(f"flakes.{key}" for key in self._KEYS))
        self._last = DEFAULT_FLAKES

    def show_paint(self, paint: Paint) -> None:
        """Show the flakes; without any, the numbers that switching on would give, disabled."""
        self.has_flakes.setChecked(paint.flakes is not None)
        self.panel.setEnabled(paint.flakes is not None)
        flakes: Flakes = paint.flakes or self._last
        self._last = flakes
        self.panel.set_values({f"flakes.{key}": getattr(flakes, key) for key in self._KEYS})

    def _switch(self, on: bool) -> None:
        self.edited.emit(("flakes",), self._last if on else None)


class ModelSection(PaintSection):
    """How colours between and beyond the readings are found."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        form = Form()
        self.rule = QComboBox()
        for name in INTERPOLATIONS:
            self.rule.addItem(_RULES[name], name)
        self.rule.activated.connect(lambda row: self.edited.emit(("interpolation",), self.rule.itemData(row)))
        form.add_row(
            "Between angles",
            self.rule,
            "The rule between the measured angles: a bell of flake tilts, a monotone curve through L*a*b*, or a "
            "parabola.",
        )
        self.box.addWidget(form)
        self.panel = self.add_panel("near_specular")
        self.note = QLabel("Not measured: no instrument of three angles looks below 15°.")
        self.notices = QLabel()
        for label in (self.note, self.notices):
            label.setWordWrap(True)
            self.box.addWidget(label)
        self.notices.hide()

    def show_paint(self, paint: Paint) -> None:
        """Show the rule and the factor."""
        self.rule.setCurrentIndex(self.rule.findData(paint.interpolation))
        self.panel.set_values({"near_specular": paint.near_specular})
        nearest = min(abs(m.aspecular_deg) for m in paint.measurements)
        self.note.setText(f"Not measured: no reading lies nearer to the mirror direction than {nearest:g}°.")

    def show_notices(self, notices: tuple[str, ...]) -> None:
        """Show what the model has to say about this paint."""
        self.notices.setText("\n".join(f"{text[:1].upper()}{text[1:].rstrip('.')}." for text in notices))
        self.notices.setVisible(bool(notices))


class TextSection(PaintSection):
    """Name, source and notes."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        form = Form()
        self.name = TextLine("Name", 200)
        self.source = TextNotes("Source", 2)
        self.notes = TextNotes("Notes")
        self.illuminant = QLabel()
        for field, key, label, tip in (
            (self.name, "name", "Name", "What the paint is called"),
            (self.source, "source", "Source", "Where the readings come from"),
            (self.notes, "notes", "Notes", ""),
        ):
            field.edited.connect(lambda text, key=key: self.edited.emit((key,), text))
            field.gesture_started.connect(lambda key=key: self.gesture_started.emit((key,)))
            field.gesture_finished.connect(self.gesture_finished)
            form.add_row(label, field, tip)
        form.add_row("Readings", self.illuminant, "Illuminant and observer of all L*a*b* values")
        self.box.addWidget(form)

    def show_paint(self, paint: Paint) -> None:
        """Show the texts."""
        self.name.set_text(paint.name)
        self.source.set_text(paint.source)
        self.notes.set_text(paint.notes)
        self.illuminant.setText(f"{paint.illuminant}, {paint.observer_deg}° observer")
