"""How lobes follow the angle of view and are looked up; how flakes are drawn, and what the paint says of them."""

from __future__ import annotations

from brdf_qt.fields.choices import ChoiceBox, SliderField, note
from brdf_qt.fields.form import Form
from brdf_qt.fields.number import reach_of
from brdf_qt.program.translation import mark, tr
from brdf_qt.window.section import Section
from brdf_qt.window.view_titles import FRESNEL_TIPS, FRESNEL_TITLES, LOOK_UP_TIPS, LOOK_UP_TITLES
from PySide6.QtWidgets import QWidget

from brdf_suite.documents.paint import Flakes
from brdf_suite.documents.view_settings import PARAMETERS, Sparkle


class FresnelSection(Section):
    """The Fresnel mode and the form of the look-up, words of :class:`documents.view.View`."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(tr("Lobes"), "fresnel", parent, is_open=False)
        self.mode = ChoiceBox(FRESNEL_TITLES, FRESNEL_TIPS)
        self.look_up = ChoiceBox(LOOK_UP_TITLES, LOOK_UP_TIPS)
        form = self.add(Form())
        form.add_row(tr("Coat and base"), self.mode, tr("Dependence on the viewing angle"))
        tip = tr("Direction in which a lobe is looked up in the filtered light")
        form.add_row(tr("Look-up"), self.look_up, tip)


SPARKLE_TITLES = {
    "glints": mark("Glints, at any distance"),
    "texture": mark("Flake texture, near only"),
    "off": mark("Off, mean of all flakes"),
}
SPARKLE_TIPS = {
    "glints": mark("Individual flakes sparkle in the brightest lights and blend into the mean with distance"),
    "texture": mark("One flake per texture cell (Günther et al. 2005); fades with distance"),
    "off": mark("No individual flakes, only their mean"),
}
NO_FLAKES = mark("This paint has no flake data; no flakes are drawn.")


class SparkleSection(Section):
    """Lights and strength; below them the flakes of the paint on show, which Designer edits; ``daily`` is the mode."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(tr("Sparkle"), "sparkle", parent)
        self.daily = Form()
        self.mode = ChoiceBox(SPARKLE_TITLES, SPARKLE_TIPS)
        lights, strength = PARAMETERS["sparkle.light_count"], PARAMETERS["sparkle.strength"]
        self.lights = SliderField(tr("Lights"), *reach_of(lights, 1.0, 0))
        self.strength = SliderField(tr("Strength"), *reach_of(strength, 0.1, 1))
        form = self.add(Form())
        self.daily.add_row(tr("Flakes"), self.mode, tr("Drawing of individual flakes"))
        form.add_row(tr("Lights"), self.lights, tr(lights.meaning))
        form.add_row(tr("Strength"), self.strength, tr(strength.meaning))
        self.facts = note(tr(NO_FLAKES))
        self.add(self.facts)

    def set_sparkle(self, sparkle: Sparkle) -> None:
        self.mode.show_choice(sparkle.mode)
        self.lights.set_value(float(sparkle.light_count))
        self.strength.set_value(sparkle.strength)
        for field in (self.lights, self.strength):
            field.setEnabled(sparkle.mode != "off")


def flake_facts(flakes: Flakes | None) -> str:
    """Return the flakes in words.

    >>> flake_facts(Flakes(120.0, 20.0, 0.17, 0.0))
    '120 flakes per mm² of 20 µm, tilts spread by 0.17, of one colour'
    """
    if flakes is None or flakes.density_per_mm2 == 0.0:
        return tr(NO_FLAKES)
    spread = tr("colours spread by {spread:.2g}").format(spread=flakes.colour_spread)
    text = tr("{density:,.4g} flakes per mm² of {size:.4g} µm, tilts spread by {roughness:.2g}, {colour}")
    return text.format(
        density=flakes.density_per_mm2,
        size=flakes.size_um,
        roughness=flakes.roughness,
        colour=tr("of one colour") if flakes.colour_spread == 0.0 else spread,
    )
