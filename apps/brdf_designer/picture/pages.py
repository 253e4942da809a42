"""The tabs Light and Form: what the paint stands in and on, six choices each, and the rest in their folds."""

from __future__ import annotations

from functools import partial
from typing import Any

from brdf_qt.choosing.thumbnails import shipped_picture
from brdf_qt.fields.choice_button import ChoiceButton
from brdf_qt.fields.choices import ChoiceBox, ColourButton, SliderField
from brdf_qt.fields.form import Form, described
from brdf_qt.fields.number import NumberField, reach_of
from brdf_qt.program.names import title_of
from brdf_qt.program.translation import mark, tr
from brdf_qt.window.view_titles import (
    BACKGROUND_TITLES,
    FRESNEL_TIPS,
    FRESNEL_TITLES,
    LOOK_UP_TIPS,
    LOOK_UP_TITLES,
    PRESETS,
    TONE_TIPS,
    TONE_TITLES,
)
from PySide6.QtCore import QObject, QSize, Qt, Signal
from PySide6.QtGui import QIcon, QPainter, QPixmap
from PySide6.QtWidgets import QButtonGroup, QCheckBox, QGridLayout, QPushButton, QWidget

from brdf_suite.documents.view import PARAMETERS, View

LIGHTS = ("photo_studio", "street", "light_tunnel", "booth", "overcast", "sunny")
FORMS = ("car", "speed_form", "panel", "sphere")
_COLUMNS = 2
_PICTURE, _GAP = 40, 8
_MEANINGS = (mark("On a 36 mm sensor"), mark("Each step doubles the light"))


class ShippedChoice(QWidget):
    """A button with its picture for each thing that comes with the programs; ``picked(name)`` when one is taken."""

    picked = Signal(str)

    def __init__(self, names: tuple[str, ...], spoken: str, kind: str) -> None:
        super().__init__()
        self.setAccessibleName(spoken)
        self.buttons: dict[str, ChoiceButton] = {}
        group, grid = QButtonGroup(self), QGridLayout(self)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setSpacing(4)
        for place, name in enumerate(names):
            title = title_of(name)
            button = described(ChoiceButton(title), spoken=f"{spoken}: {title}", tip=f"{spoken}: {title}")
            button.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
            button.setIcon(QIcon(_before_text(shipped_picture(kind, name))))
            button.setIconSize(QSize(_PICTURE + _GAP, _PICTURE))
            button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
            button.setSizePolicy(button.sizePolicy().Policy.Expanding, button.sizePolicy().Policy.Fixed)
            button.clicked.connect(partial(self._picked, name))
            group.addButton(button)
            self.buttons[name] = button
            grid.addWidget(button, place // _COLUMNS, place % _COLUMNS)

    def show_choice(self, name: str) -> None:
        """Show which one is chosen, without a signal."""
        if name in self.buttons:
            self.buttons[name].setChecked(True)

    def _picked(self, name: str) -> None:
        self.picked.emit(name)


def _before_text(picture: QPixmap) -> QPixmap:
    """Return a square picture with an empty strip at its right, which keeps a button's text away from it."""
    side = picture.height()
    whole = QPixmap(side + side * _GAP // _PICTURE, side)
    whole.fill(Qt.GlobalColor.transparent)
    painter = QPainter(whole)
    painter.drawPixmap(0, 0, side, side, picture)
    painter.end()
    return whole


class ViewPages(QObject):
    """Makes the widgets of both tabs.

    Signals: ``edited(field, value)`` of the view, ``look_edited(field, value)`` of its surface look,
    ``light_chosen(name)``, ``form_chosen(name)``, ``place_chosen(preset)`` and ``framed()``.
    """

    edited = Signal(str, object)
    look_edited = Signal(str, object)
    light_chosen = Signal(str)
    form_chosen = Signal(str)
    place_chosen = Signal(str)
    framed = Signal()
    lens_edited = Signal(float)

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self.light, self.light_more = self._light(), self._light_more()
        self.form, self.form_more = self._form(), self._form_more()

    def show_view(self, view: View) -> None:
        """Show a view, without a signal."""
        self.lights.show_choice(view.environment)
        self.forms.show_choice(view.surface)
        self.rotation.set_value(view.rotation_deg)
        self.exposure.set_value(view.exposure_ev)
        self.background.show_choice(view.background)
        self.colour.set_colour(view.background_colour)
        self.colour.setEnabled(view.background == "colour")
        self.ground.setChecked(view.surface_look.ground)
        self.glare.setChecked(view.glare == "eye")
        self.tone.show_choice(view.tone_curve)
        self.fresnel.show_choice(view.fresnel)
        self.look_up.show_choice(view.look_up)
        self.occlusion.setChecked(view.surface_look.occlusion)
        self.lens.set_value(view.camera.focal_length_mm)

    def _edits(self, field: str) -> Any:
        return partial(self.edited.emit, field)

    def _light(self) -> QWidget:
        self.lights = ShippedChoice(LIGHTS, tr("Light"), "environments")
        self.lights.picked.connect(self.light_chosen)
        turn, stops = PARAMETERS["rotation_deg"], PARAMETERS["exposure_ev"]
        self.rotation = SliderField(tr("Rotation"), turn.unit, -180.0, 180.0, 1.0, 1, turn.default)
        self.exposure = SliderField(tr("Exposure"), stops.unit, -4.0, 4.0, 0.1, 2, stops.default)
        self.background = ChoiceBox(BACKGROUND_TITLES)
        self.rotation.edited.connect(self._edits("rotation_deg"))
        self.exposure.edited.connect(self._edits("exposure_ev"))
        self.background.picked.connect(self._edits("background"))
        form = Form()
        form.add_wide(self.lights)
        self.rotation.explain(tr("Rotates the light; also Alt drag in the picture"))
        self.exposure.explain(tr(stops.meaning))
        form.add_row(tr("Rotation"), self.rotation)
        form.add_row(tr("Exposure"), self.exposure)
        form.add_row(tr("Background"), self.background, tr("What is seen behind the form"))
        self.glare = described(QCheckBox(tr("Glare")), tip=tr("Bright highlights have a halo, as in the eye"))
        self.glare.clicked.connect(lambda on: self.edited.emit("glare", "eye" if on else "off"))
        form.add_row("", self.glare)
        return form

    def _light_more(self) -> QWidget:
        form = Form()
        self.colour = ColourButton(tr("Colour of the background"))
        self.colour.edited.connect(self._edits("background_colour"))
        form.add_row(tr("Colour"), self.colour, tr("Colour of a plain background"))
        self.tone = ChoiceBox(TONE_TITLES, TONE_TIPS)
        self.tone.picked.connect(self._edits("tone_curve"))
        form.add_row(tr("Tone curve"), self.tone, tr("Mapping of radiance to the screen"))
        self.fresnel = ChoiceBox(FRESNEL_TITLES, FRESNEL_TIPS)
        self.fresnel.picked.connect(self._edits("fresnel"))
        form.add_row(tr("Fresnel"), self.fresnel, tr("Reflectance towards grazing angles; for developers"))
        self.look_up = ChoiceBox(LOOK_UP_TITLES, LOOK_UP_TIPS)
        self.look_up.picked.connect(self._edits("look_up"))
        form.add_row(
            tr("Look-up"), self.look_up, tr("Direction in which a lobe is looked up; for developers")
        )
        return form

    def _form(self) -> QWidget:
        self.forms = ShippedChoice(FORMS, tr("Form"), "meshes")
        self.forms.picked.connect(self.form_chosen)
        places = QWidget()
        grid = QGridLayout(places)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setSpacing(4)
        self.places: dict[str, QPushButton] = {}
        for number, (key, (title, *_angles)) in enumerate(PRESETS.items()):
            button = self.places[key] = QPushButton(tr(title))
            described(button, name=f"place_{key}", tip=tr("Looks at the form from there"))
            button.clicked.connect(partial(self._place, key))
            grid.addWidget(button, number // _COLUMNS, number % _COLUMNS)
        self.frame = described(
            QPushButton(tr("Frame")), name="frame", tip=tr("Fill the picture with the form (F)")
        )
        self.frame.clicked.connect(lambda: self.framed.emit())
        self.ground = described(
            QCheckBox(tr("Ground with contact shadow")), tip=tr("The form stands on a ground")
        )
        self.ground.clicked.connect(lambda on: self.look_edited.emit("ground", on))
        form = Form()
        form.add_wide(self.forms)
        form.add_row(tr("View from"), places)
        form.add_row("", self.frame)
        form.add_wide(self.ground)
        return form

    def _form_more(self) -> QWidget:
        form = Form()
        known = PARAMETERS["camera.focal_length_mm"]
        self.lens = NumberField(tr("Focal length"), *reach_of(known, 1.0, 0))
        self.lens.edited.connect(self.lens_edited)
        form.add_row(tr("Focal length"), self.lens, tr(known.meaning))
        self.occlusion = described(
            QCheckBox(tr("Ambient occlusion")),
            tip=tr("Parts of the form darken each other where they are close"),
        )
        self.occlusion.clicked.connect(lambda on: self.look_edited.emit("occlusion", on))
        form.add_wide(self.occlusion)
        return form

    def _place(self, key: str) -> None:
        self.place_chosen.emit(key)
