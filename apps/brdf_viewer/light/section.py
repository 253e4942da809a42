"""The light booth's buttons, the colour of its lamps, how the eye takes it, and how the exposure is found."""

from __future__ import annotations

from typing import Literal

from brdf_qt.fields.form import Form
from brdf_qt.fields.labels import plain_tip
from brdf_qt.fields.number import NumberField
from brdf_qt.program.translation import mark, tr
from brdf_qt.window.section import Section
from PySide6.QtCore import Signal
from PySide6.QtWidgets import QButtonGroup, QCheckBox, QGridLayout, QToolButton, QWidget

from brdf_suite.documents.view_settings import PARAMETERS, LightColour
from brdf_viewer.fields.choice_box import ChoiceBox
from brdf_viewer.fields.note import note, set_note
from brdf_viewer.light.lamps_section import LampFields
from brdf_viewer.light.presets import PRESETS, is_tinted

ILLUMINANT_TITLES = {
    "environment": mark("From environment"),
    "D65": mark("D65, daylight"),
    "D50": mark("D50, warm daylight"),
    "A": mark("A, incandescent"),
    "TL84": mark("TL84 (CIE F11)"),
    "CWF": mark("Cool white (CIE F2)"),
    "LED": mark("LED (CIE LED-B3)"),
}
EXPOSURE_TITLES = {"locked": mark("Locked"), "automatic": mark("Automatic")}
_COLUMNS = 3
Spectra = Literal["unknown", "in work", "used"]
"""What is known of a paint's colour in another light."""


class LightingSection(Section):
    """Presets of a light booth; light colour; exposure locked or automatic; lamps beside the environment.

    ``preset_chosen(key)`` is emitted where a preset's button is pressed.
    """

    preset_chosen = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(tr("Lighting"), "lighting", parent)
        self.presets = QButtonGroup(self)
        # None is pressed where the light is another.
        self.presets.setExclusive(False)
        self.preset_buttons: dict[str, QToolButton] = {}
        self.illuminant = ChoiceBox(ILLUMINANT_TITLES)
        self.adapted = QCheckBox(tr("Chromatic adaptation"))
        self.adapted.setToolTip(
            tr(
                "On: white looks white, as to an eye adapted to this light. "
                "Off: the tint that a daylight-adapted eye sees"
            )
        )
        self.metamerism = note()
        self.exposure_mode = ChoiceBox(EXPOSURE_TITLES)
        light = PARAMETERS["light_colour.brightness"]
        self.brightness = NumberField(
            tr("Environment"), light.unit, light.low, light.high, 0.05, 2, light.default
        )
        self.lamps = LampFields()
        form = Form()
        form.add_wide(self._preset_buttons())
        form.add_row(tr("Illuminant"), self.illuminant, tr("Illuminant assumed for the environment's white"))
        form.add_row("", self.adapted)
        form.add_wide(self.metamerism)
        form.add_row(tr("Environment"), self.brightness, tr(light.meaning))
        form.add_row(
            tr("Exposure mode"),
            self.exposure_mode,
            tr(
                "Locked: the exposure is the same in every light. Automatic: the object's median luminance becomes "
                "18 %, and the exposure value is added"
            ),
        )
        self.add(form)
        self.add(self.lamps)

    def _preset_buttons(self) -> QWidget:
        inside = QWidget()
        grid = QGridLayout(inside)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setSpacing(4)
        for index, (key, preset) in enumerate(PRESETS.items()):
            button = QToolButton()
            button.setText(tr(preset.title))
            button.setToolTip(plain_tip(tr(preset.tip)))
            button.setCheckable(True)
            button.setObjectName(f"lighting_{key}")
            button.setSizePolicy(button.sizePolicy().Policy.Expanding, button.sizePolicy().Policy.Fixed)
            button.clicked.connect(lambda _=False, key=key: self._pressed(key))
            self.presets.addButton(button)
            self.preset_buttons[key] = button
            grid.addWidget(button, index // _COLUMNS, index % _COLUMNS)
        return inside

    def _pressed(self, key: str) -> None:
        self.preset_buttons[key].setChecked(True)  # a second press leaves it pressed
        self.preset_chosen.emit(key)

    def show_preset(self, key: str) -> None:
        """Press the button of the present light; none where the key is empty."""
        for name, button in self.preset_buttons.items():
            button.setChecked(name == key)
            font = button.font()
            font.setBold(name == key)  # the choice is shown by more than a shade of grey
            button.setFont(font)

    def show_colour(self, colour: LightColour, spectra: Spectra) -> None:
        """Show the light's colour, and what it can say about the paint."""
        self.illuminant.show_choice(colour.illuminant)
        self.adapted.setChecked(colour.adapted)
        self.brightness.set_value(colour.brightness)
        self.adapted.setEnabled(is_tinted(colour))
        set_note(self.metamerism, colour_note(colour, spectra))


def colour_note(colour: LightColour, spectra: Spectra) -> str:
    """Return what is to be known about a paint's colour in the light; empty where nothing is assumed."""
    if not is_tinted(colour):
        return ""
    if spectra != "unknown":
        if spectra == "in work":
            return tr("Colours are being computed from the paint's spectra.")
        return tr("Colours were computed from the paint's spectra.")
    if colour.adapted:
        return tr(
            "No metamerism: the paint's spectrum is unknown. Assuming chromatic adaptation, it is shown as in D65."
        )
    return tr("No metamerism: the paint's spectrum is unknown. Its colours are tinted by the light (CAT16).")
