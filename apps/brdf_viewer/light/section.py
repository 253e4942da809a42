"""The light booth: its presets, the colour of its lamps, lamps beside it, how the eye takes it, the exposure."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import Any, Literal

from brdf_qt.fields.choices import ChoiceBox, note, set_note
from brdf_qt.fields.form import Form, fill_column, fill_row, icon_button
from brdf_qt.fields.labels import plain_tip, set_bold
from brdf_qt.fields.number import NumberField, reach_of
from brdf_qt.fields.quiet import QuietComboBox
from brdf_qt.gl.aiming import polar_of
from brdf_qt.program.translation import mark, tr
from brdf_qt.window.section import Section
from PySide6.QtCore import Signal
from PySide6.QtWidgets import QButtonGroup, QCheckBox, QGridLayout, QPushButton, QToolButton, QWidget

from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import MOST_LAMPS, PARAMETERS, Illuminant, Lamp, LightColour
from brdf_suite.geometry.polar import point_at
from brdf_suite.pipeline.scene import in_environment


@dataclass(frozen=True)
class Preset:
    """What a button sets: environment, its lamps' colour and brightness, and lamps beside it; ``tip`` explains it."""

    title: str
    environment: str
    illuminant: Illuminant
    tip: str
    lamps: tuple[Lamp, ...] = ()
    brightness: float = 1.0


POINT = Lamp(kind="point", position=(0.9, 1.6, 1.1), strength=6.0, temperature_k=6500.0)
THREE = (
    Lamp(kind="point", position=(-1.3, 1.2, 0.7), strength=3.0, temperature_k=6500.0),
    Lamp(kind="point", position=(0.6, 1.7, 1.2), strength=4.0, temperature_k=5000.0),
    Lamp(kind="point", position=(1.5, 0.6, -0.4), strength=2.5, temperature_k=9000.0),
)
_MOVABLE = mark("Light booth with one small movable lamp, for sparkle")
_ONLY_LAMPS = mark("Three movable lamps, no environment – best for factored paints")

PRESETS: Mapping[str, Preset] = MappingProxyType(
    {
        "d65": Preset("D65", "booth", "D65", mark("Light booth, average daylight")),
        "d50": Preset("D50", "booth", "D50", mark("Light booth, warm daylight (graphic arts)")),
        "a": Preset("A", "booth", "A", mark("Light booth, incandescent lamps of 2,856 K")),
        "tl84": Preset("TL84", "booth", "TL84", mark("Light booth, three-band fluorescent lamps (CIE F11)")),
        "cwf": Preset("CWF", "booth", "CWF", mark("Light booth, cool white fluorescent lamps (CIE F2)")),
        "led": Preset("LED", "booth", "LED", mark("Light booth, white LEDs of 4,100 K (CIE LED-B3)")),
        "sun": Preset(mark("Sun and sky"), "sunny", "environment", mark("Clear sky with the sun")),
        "overcast": Preset(mark("Overcast"), "overcast", "environment", mark("Even, cloudy sky, no sun")),
        "point": Preset(mark("Point source"), "booth", "D65", _MOVABLE, (POINT,)),
        "three": Preset(mark("Three lamps"), "booth", "D65", _ONLY_LAMPS, THREE, 0.0),
    }
)


def with_preset(view: View, key: str) -> View:
    """Return the view in a preset's light; adaptation and rotation stay, and exposure where it was chosen.

    The environment is named; who shows the view loads it.
    """
    preset = PRESETS[key]
    return replace(
        in_environment(view, preset.environment),
        environment_layout="auto",
        light_colour=replace(view.light_colour, illuminant=preset.illuminant, brightness=preset.brightness),
        lamps=preset.lamps,
    )


def preset_of(view: View) -> str:
    """Return the preset that the view's light is, wherever its lamps stand; empty where it is another.

    >>> preset_of(View(environment="booth"))
    'd65'
    """
    illuminant = view.light_colour.illuminant
    if illuminant == "environment" and view.environment == "booth":
        illuminant = "D65"  # the booth's own lamps are neutral
    dark = view.light_colour.brightness == 0.0
    lamps = [lamp.kind for lamp in view.lamps]
    for key, preset in PRESETS.items():
        same_light = (view.environment, illuminant) == (preset.environment, preset.illuminant)
        same_lamps = lamps == [lamp.kind for lamp in preset.lamps]
        if same_light and same_lamps and dark == (preset.brightness == 0.0):
            return key
    return ""


def is_tinted(colour: LightColour) -> bool:
    """Whether the picture takes the lamp's colour on, or would to an eye that has not adapted."""
    return colour.illuminant not in ("environment", "D65")


SHADING_TITLES = {"each": mark("Exact, per pixel"), "ball": mark("Together, by a ball")}
SHADING_TIPS = {
    "each": mark("Each lamp is evaluated in the maps at every pixel: correct for point lamps and grain"),
    "ball": mark(
        "A ball of the paint is drawn in the light of all lamps, and looked up by the normal: one look-up for any "
        "number of lamps, as if they and the viewer were far away"
    ),
}
KIND_TITLES = {"point": mark("Point"), "directional": mark("Directional")}
_NEW = Lamp()


class LampFields(QWidget):
    """Every lamp in the same fields: direction and, for a point, distance; strength; colour.

    ``edited(lamps)`` is emitted with the whole new tuple. ``moving`` is checked where the lamps are to go round,
    ``shading`` is how factored paints are lit by them.
    """

    edited = Signal(tuple)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.lamps: tuple[Lamp, ...] = ()
        self.list = QuietComboBox()
        self.list.setAccessibleName(tr("Lamps"))
        self.list.activated.connect(lambda _index: self._show())
        self.add_button = icon_button("plus", tr("Add a lamp to the environment"), self._add)
        self.remove_button = icon_button("trash", tr("Remove this lamp"), self._remove)
        row = QWidget()
        fill_row(row, self.list, self.add_button, self.remove_button, spacing=4)
        self.kind = ChoiceBox(KIND_TITLES)
        self.kind.picked.connect(lambda key: self._change(kind=key))
        self.azimuth = NumberField(tr("Azimuth"), "°", -180.0, 180.0, 1.0, 1, 30.0)
        self.azimuth.setWrapping(True)
        self.elevation = NumberField(tr("Elevation"), "°", -90.0, 90.0, 1.0, 1, 45.0)
        self.distance = NumberField(tr("Distance"), "m", 0.05, 1000.0, 0.05, 2, 2.0)
        for field in (self.azimuth, self.elevation, self.distance):
            field.edited.connect(self._placed)
        self.moving = QCheckBox(tr("Moves round"))
        self.moving.setToolTip(tr("Rotate the lamps around the surface to see flakes and highlights move"))
        self.shading = ChoiceBox(SHADING_TITLES, SHADING_TIPS)
        form, self._fields = Form(), Form()
        tip = tr("Small lamps in addition to the environment; flakes sparkle in their light")
        form.add_row(tr("Lamps"), row, tip)
        self.highlight = QPushButton(tr("Put the Highlight Here"))
        self.highlight.setCheckable(True)
        self.highlight.setToolTip(
            plain_tip(tr("Then click on the surface: the lamp moves to where its reflection is seen there"))
        )
        form.add_row("", self.highlight)
        self._fields.add_row(tr("Kind"), self.kind)
        self._fields.add_row(tr("Azimuth"), self.azimuth, tr(PARAMETERS["lamp.azimuth_deg"].meaning))
        self._fields.add_row(tr("Elevation"), self.elevation, tr(PARAMETERS["lamp.elevation_deg"].meaning))
        tip = tr("From the centre of the scene")
        self._distance_label = self._fields.add_row(tr("Distance"), self.distance, tip)
        self.strength = self._fields.add_number(tr("Strength"), PARAMETERS["lamp.strength"], 0.1, 2)
        self.strength.edited.connect(lambda value: self._change(strength=value))
        self.temperature = self._fields.add_number(tr("Colour"), PARAMETERS["lamp.temperature_k"], 50.0, 0)
        self.temperature.edited.connect(lambda value: self._change(temperature_k=value))
        self.diameter = NumberField(tr("Diameter"), *reach_of(PARAMETERS["lamp.diameter"], 0.05, 2))
        self.diameter.edited.connect(lambda value: self._change(diameter=value))
        self.angle = NumberField(tr("Extent"), *reach_of(PARAMETERS["lamp.angle_deg"], 0.5, 2))
        self.angle.edited.connect(lambda value: self._change(angle_deg=value))
        self._sizes = (
            self._fields.add_row(tr("Diameter"), self.diameter, tr(PARAMETERS["lamp.diameter"].meaning)),
            self._fields.add_row(tr("Extent"), self.angle, tr(PARAMETERS["lamp.angle_deg"].meaning)),
        )
        self._fields.add_row("", self.moving)
        self._fields.add_row(tr("Factored"), self.shading, tr("Shading of factored paints by the lamps"))
        fill_column(self, form, self._fields)
        self.set_lamps(())

    def choose(self, index: int) -> None:
        """Show the fields of the lamp of this place in the list."""
        self.list.setCurrentIndex(index)
        self._show()

    def set_lamps(self, lamps: tuple[Lamp, ...]) -> None:
        """Show lamps, without a signal; the one that was chosen stays so."""
        chosen = max(0, self.list.currentIndex())
        if [lamp.kind for lamp in lamps] != [lamp.kind for lamp in self.lamps] or not lamps:
            self.list.clear()
            titles = [f"{number}: {tr(KIND_TITLES[lamp.kind])}" for number, lamp in enumerate(lamps, 1)]
            self.list.addItems(titles or [tr("None")])
            self.list.setCurrentIndex(min(chosen, self.list.count() - 1))
        self.lamps = lamps
        self._show()

    def _show(self) -> None:
        lamp = self._chosen()
        self._fields.setVisible(lamp is not None)
        self.list.setEnabled(lamp is not None)
        self.add_button.setEnabled(len(self.lamps) < MOST_LAMPS)
        self.remove_button.setEnabled(lamp is not None)
        if lamp is None:
            return
        self.kind.show_choice(lamp.kind)
        for field, value in zip((self.azimuth, self.elevation, self.distance), polar_of(lamp), strict=True):
            field.set_value(value)
        for widget in (self.distance, self._distance_label):
            widget.setVisible(lamp.kind == "point")
        for size, label in zip((self.diameter, self.angle), self._sizes, strict=True):
            for widget in (size, label):
                widget.setVisible((size is self.diameter) == (lamp.kind == "point"))
        self.diameter.set_value(lamp.diameter)
        self.angle.set_value(lamp.angle_deg)
        self.strength.set_value(lamp.strength)
        self.temperature.set_value(lamp.temperature_k)

    def _chosen(self) -> Lamp | None:
        index = self.list.currentIndex()
        return self.lamps[index] if 0 <= index < len(self.lamps) else None

    def _add(self) -> None:
        self.set_lamps((*self.lamps, _NEW))
        self.list.setCurrentIndex(len(self.lamps) - 1)
        self._show()
        self.edited.emit(self.lamps)

    def _remove(self) -> None:
        index = self.list.currentIndex()
        self.set_lamps(self.lamps[:index] + self.lamps[index + 1 :])
        self.edited.emit(self.lamps)

    def _placed(self, _value: float) -> None:
        azimuth, elevation = self.azimuth.value(), self.elevation.value()
        position = point_at(azimuth, elevation, self.distance.value())
        self._change(position=position, azimuth_deg=azimuth, elevation_deg=elevation)

    def _change(self, **fields: Any) -> None:
        lamp, index = self._chosen(), self.list.currentIndex()
        if lamp is not None:
            changed = dataclasses.replace(lamp, **fields)
            self.set_lamps((*self.lamps[:index], changed, *self.lamps[index + 1 :]))
            self.edited.emit(self.lamps)


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

    ``daily`` is the illuminant, and what it says of the paint.

    ``preset_chosen(key)`` is emitted where a preset's button is pressed.
    """

    preset_chosen = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(tr("Lighting"), "lighting", parent)
        self.daily = Form()
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
        self.metamerism = note(lines=2)
        self.exposure_mode = ChoiceBox(EXPOSURE_TITLES)
        self.lamps = LampFields()
        form = self.add(Form())
        form.add_wide(self._preset_buttons())
        tip = tr("Illuminant assumed for the environment's white")
        self.daily.add_row(tr("Illuminant"), self.illuminant, tip)
        self.daily.add_wide(self.metamerism)
        form.add_row("", self.adapted)
        light = PARAMETERS["light_colour.brightness"]
        self.brightness = form.add_number(tr("Environment"), light, 0.05, 2)
        form.add_row(
            tr("Exposure mode"),
            self.exposure_mode,
            tr(
                "Locked: the exposure is the same in every light. Automatic: the object's median luminance becomes "
                "18 %, and the exposure value is added"
            ),
        )
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
            set_bold(button, name == key)  # the choice is shown by more than a shade of grey

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
    if spectra == "in work":
        return tr("Colours are being computed from the paint's spectra.")
    if spectra == "used":
        return tr("Colours were computed from the paint's spectra.")
    if colour.adapted:
        return tr(
            "No metamerism: the paint's spectrum is unknown. Assuming chromatic adaptation, it is shown as in D65."
        )
    return tr("No metamerism: the paint's spectrum is unknown. Its colours are tinted by the light (CAT16).")
