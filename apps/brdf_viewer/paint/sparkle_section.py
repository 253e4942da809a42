"""Drawing of individual flakes, and what the paint says of its flakes."""

from __future__ import annotations

from brdf_qt.fields.form import Form
from brdf_qt.window.section import Section
from PySide6.QtWidgets import QWidget

from brdf_suite.documents.paint import Flakes
from brdf_suite.documents.view_settings import PARAMETERS, Sparkle
from brdf_viewer.fields.choice_box import ChoiceBox
from brdf_viewer.fields.note import note, set_note
from brdf_viewer.fields.slider import SliderField

SPARKLE_TITLES = {
    "glints": "Glints, at any distance",
    "texture": "Flake texture, near only",
    "off": "Off, mean of all flakes",
}
SPARKLE_TIPS = {
    "glints": "Individual flakes sparkle in the brightest lights and blend into the mean with distance",
    "texture": "One flake per texture cell (Günther et al. 2005); fades with distance",
    "off": "No individual flakes, only their mean",
}
NO_FLAKES = "This paint has no flake data; no flakes are drawn."


class SparkleSection(Section):
    """Mode, lights and strength; below them the flakes of the paint on show, which Designer edits."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__("Sparkle", "sparkle", parent)
        self.mode = ChoiceBox(SPARKLE_TITLES, SPARKLE_TIPS)
        lights, strength = PARAMETERS["sparkle.light_count"], PARAMETERS["sparkle.strength"]
        self.lights = SliderField("Lights", "", lights.low, lights.high, 1.0, 0, lights.default)
        self.strength = SliderField("Strength", "×", strength.low, strength.high, 0.1, 1, strength.default)
        self._form = Form()
        self._form.add_row("Flakes", self.mode, "Drawing of individual flakes")
        self._form.add_row("Lights", self.lights, lights.meaning)
        self._form.add_row("Strength", self.strength, strength.meaning)
        self.add(self._form)
        self.facts = note(NO_FLAKES)
        self.add(self.facts)

    def set_sparkle(self, sparkle: Sparkle) -> None:
        """Show the view's settings, without a signal."""
        self.mode.show_choice(sparkle.mode)
        self.lights.set_value(float(sparkle.light_count))
        self.strength.set_value(sparkle.strength)
        for field in (self.lights, self.strength):
            field.setEnabled(sparkle.mode != "off")

    def set_flakes(self, flakes: Flakes | None) -> None:
        """Show what the paint says of its flakes."""
        set_note(self.facts, flake_facts(flakes))


def flake_facts(flakes: Flakes | None) -> str:
    """Return the flakes in words.

    >>> flake_facts(Flakes(120.0, 20.0, 0.17, 0.0))
    '120 flakes per mm² of 20 µm, tilts spread by 0.17, of one colour'
    """
    if flakes is None or flakes.density_per_mm2 == 0.0:
        return NO_FLAKES
    colour = (
        "of one colour" if flakes.colour_spread == 0.0 else f"colours spread by {flakes.colour_spread:.2g}"
    )
    return (
        f"{flakes.density_per_mm2:,.4g} flakes per mm² of {flakes.size_um:.4g} µm, "
        f"tilts spread by {flakes.roughness:.2g}, {colour}"
    )
