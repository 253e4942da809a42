"""The fields of a studio: of a lamp, of the room or backdrop around the lamps, and of a sky."""

from __future__ import annotations

import dataclasses
from typing import Any

from brdf_qt.fields.choices import ChoiceBox
from brdf_qt.fields.form import Form, fill_column, fill_row
from brdf_qt.fields.labels import plain_tip
from brdf_qt.fields.number import NumberField, reach_of
from brdf_qt.program.translation import decimal, mark, tr
from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QCheckBox, QWidget

from brdf_suite.documents.studio import PARAMETERS, Shape, Sky, Studio, StudioLamp
from brdf_suite.geometry.polar import point_at, polar
from brdf_viewer.light.studio.edits import with_room
from brdf_viewer.light.studio.places import angle_of, facing_deg, moved, size_at

NEUTRAL_K = 6504.0


class Edits(QObject):
    """Where the fields of a panel report: ``changed(name, value)``, and the gesture around several changes."""

    changed = Signal(str, object)
    gesture_started = Signal()
    gesture_finished = Signal()

    def number(self, name: str, label: str, *reach: Any) -> NumberField:
        """Return a number whose edits are changes of ``name``; ``reach`` as :class:`NumberField` takes it."""
        field = NumberField(label, *reach)
        field.setObjectName(f"studio_{name}")
        field.edited.connect(lambda value: self.changed.emit(name, value))
        field.gesture_started.connect(self.gesture_started)
        field.gesture_finished.connect(self.gesture_finished)
        return field

    def of_document(self, name: str, step: float, decimals: int, parameter: str = "") -> NumberField:
        """Return the number of a document's parameter, within its range."""
        known = PARAMETERS[parameter or name]
        return self.number(name, tr(known.label), *reach_of(known, step, decimals))

    def choice(self, name: str, titles: dict[str, str]) -> ChoiceBox:
        """Return a list whose choices are changes of ``name``."""
        box = ChoiceBox(titles)
        box.setObjectName(f"studio_{name}")
        box.picked.connect(lambda key: self.changed.emit(name, key))
        return box

    def tick(self, name: str, text: str, tip: str) -> QCheckBox:
        """Return a check box whose clicks are changes of ``name``."""
        box = QCheckBox(text)
        box.setToolTip(plain_tip(tip))
        box.setObjectName(f"studio_{name}")
        box.clicked.connect(lambda on: self.changed.emit(name, on))
        return box


class TemperatureField(QWidget):
    """A colour temperature, or neutral: the white of the picture, D65."""

    def __init__(self, edits: Edits, name: str = "colour_temperature_k") -> None:
        super().__init__()
        self._edits, self._name = edits, name
        self.kelvin = edits.of_document(name, 50.0, 0, "colour_temperature_k")
        self.neutral = QCheckBox(tr("Neutral"))
        self.neutral.setToolTip(tr("White of the picture, D65"))
        self.neutral.clicked.connect(self._clicked)
        fill_row(self, self.kelvin, self.neutral)
        self.setFocusProxy(self.kelvin)

    def set_value(self, kelvin: float | None) -> None:
        self.neutral.setChecked(kelvin is None)
        self.kelvin.setEnabled(kelvin is not None)
        if kelvin is not None:
            self.kelvin.set_value(kelvin)

    def _clicked(self, neutral: bool) -> None:
        value = self.kelvin.value() if self.kelvin.value() else NEUTRAL_K
        self._edits.changed.emit(self._name, None if neutral else value)


SHAPE_TITLES = {"box": mark("Box"), "strip": mark("Strip"), "ring": mark("Ring")}
_PLACE = ("azimuth", "elevation", "distance")
_SIZE_LABELS = {
    "box": (mark("Width"), mark("Height")),
    "strip": (mark("Length"), mark("Width")),
    "ring": (mark("Diameter"), mark("Band")),
}


class LampForm(Form):
    """Shows a lamp; ``edits`` reports what was changed, :func:`changed_lamp` makes a lamp of it."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.edits = edits = Edits(self)
        self.shape = edits.choice("shape", SHAPE_TITLES)
        self.azimuth = edits.number("azimuth", tr("Azimuth"), "°", -180.0, 180.0, 1.0, 1, 0.0)
        self.azimuth.setWrapping(True)
        self.elevation = edits.number("elevation", tr("Elevation"), "°", -90.0, 90.0, 1.0, 1, 45.0)
        self.distance = edits.number("distance", tr("Distance"), "m", 0.1, 100.0, 0.1, 2, 3.0)
        self.first = edits.number("first", tr("Width"), "°", 0.05, 170.0, 1.0, 2, 30.0)
        self.second = edits.number("second", tr("Height"), "°", 0.05, 170.0, 1.0, 2, 30.0)
        self.roll = edits.of_document("roll_deg", 1.0, 1)
        tip = tr("Off: the direction is set by the two angles")
        self.aimed = edits.tick("aimed", tr("Face the centre"), tip)
        self.facing_azimuth = edits.number("facing_azimuth", tr("Facing"), "°", -180.0, 180.0, 1.0, 1, 180.0)
        self.facing_azimuth.setWrapping(True)
        self.facing_elevation = edits.number("facing_elevation", tr("Up"), "°", -90.0, 90.0, 1.0, 1, -45.0)
        self.luminance = edits.of_document("luminance", 0.1, 2)
        self.colour = TemperatureField(edits)
        self.softness = edits.number("softness_cm", tr("Soft edge"), "cm", 0.01, 1000.0, 0.5, 2, 6.0)
        add = self.add_row
        add(tr("Shape"), self.shape, tr("A box is brightest in its middle; strips and rings are even"))
        add(tr("Azimuth"), self.azimuth, tr("Position: from the front (+z) towards the right (+x)"))
        add(tr("Elevation"), self.elevation, tr("Above the horizon at the centre of the scene"))
        tip = tr("Distance from the centre of the scene; the size in metres stays")
        add(tr("Distance"), self.distance, tip)
        size = tr("Angular size, seen face-on from the centre of the scene")
        self._size_labels = [add(tr("Width"), self.first, size), add(tr("Height"), self.second, size)]
        add(tr("Roll"), self.roll, tr(PARAMETERS["roll_deg"].meaning))
        add("", self.aimed)
        self._facing_labels = [
            add(tr("Shines to"), self.facing_azimuth, tr("Azimuth of the direction of emission")),
            add(tr("and up"), self.facing_elevation, tr("Elevation of the direction of emission")),
        ]
        add(tr("Luminance"), self.luminance, tr("At its centre"))
        add(tr("Colour"), self.colour, tr("Planckian below 4,000 K, daylight above"))
        add(tr("Soft edge"), self.softness, tr("Width of the fade at its edge"))

    def set_lamp(self, lamp: StudioLamp, unit: str) -> None:
        self.shape.show_choice(lamp.shape)
        place = polar(lamp.position_m)
        for field, value in zip((self.azimuth, self.elevation, self.distance), place, strict=True):
            field.set_value(value)
        tip = tr("{side}: {metres}; the angle is its face-on angular size")
        for field, label, text, size in zip(
            (self.first, self.second), self._size_labels, _SIZE_LABELS[lamp.shape], lamp.size_m, strict=True
        ):
            field.set_value(angle_of(size, place[2]))
            label.setText(tr(text))
            field.setToolTip(plain_tip(tip.format(side=tr(text), metres=decimal(f"{size:.3g} m"))))
        self.roll.set_value(lamp.roll_deg)
        self.aimed.setChecked(lamp.facing is None)
        for field, value in zip((self.facing_azimuth, self.facing_elevation), facing_deg(lamp), strict=True):
            field.set_value(value)
        for widget in (self.facing_azimuth, self.facing_elevation, *self._facing_labels):
            widget.setVisible(lamp.facing is not None)
        self.luminance.setSuffix("" if unit == "relative" else " kcd/m²")
        self.luminance.set_value(lamp.luminance)
        self.colour.set_value(lamp.colour_temperature_k)
        self.softness.set_value(100.0 * lamp.softness_m)


def changed_lamp(lamp: StudioLamp, name: str, value: Any) -> StudioLamp:
    """Return the lamp after an edit of a field of :class:`LampForm`; :class:`ValueRangeError` where it cannot be."""
    place = list(polar(lamp.position_m))
    if name in _PLACE:
        place[_PLACE.index(name)] = value
        azimuth, elevation, distance = place
        return moved(lamp, point_at(azimuth, elevation, distance))
    if name in ("first", "second"):
        size = size_at(value, place[2])
        both = (size, lamp.size_m[1]) if name == "first" else (lamp.size_m[0], size)
        return dataclasses.replace(lamp, size_m=both)
    if name == "shape":
        return _shaped(lamp, value)
    if name == "aimed":
        x, y, z = lamp.position_m
        return dataclasses.replace(lamp, facing=None if value else (-x, -y, -z))
    if name in ("facing_azimuth", "facing_elevation"):
        now = facing_deg(lamp)
        azimuth, elevation = (value, now[1]) if name == "facing_azimuth" else (now[0], value)
        return dataclasses.replace(lamp, facing=point_at(azimuth, elevation, 1.0))
    if name == "softness_cm":
        return dataclasses.replace(lamp, softness_m=0.01 * value)
    return dataclasses.replace(lamp, **{name: value})


def _shaped(lamp: StudioLamp, shape: Shape) -> StudioLamp:
    """Return the lamp in another shape, its sides brought to what that can have."""
    first, second = lamp.size_m
    if shape == "strip":
        first, second = max(first, second), min(first, second)
    elif shape == "ring":
        second = min(second, 0.5 * first)
    return dataclasses.replace(lamp, shape=shape, size_m=(first, second))


AROUND_TITLES = {"backdrop": mark("Plain backdrop"), "room": mark("Room")}
UNIT_TITLES = {"kcd/m2": "kcd/m²", "relative": mark("Relative")}
SKY_TITLES = {
    "hosek_wilkie": mark("Clear (Hošek-Wilkie)"),
    "preetham": mark("Clear (Preetham)"),
    "overcast": mark("Overcast (CIE)"),
}
_ROOM = {
    "width_m": (mark("Width"), "size", 0.1),
    "length_m": (mark("Length"), "size", 0.1),
    "height_m": (mark("Height"), "size", 0.1),
    "eye_height_m": (mark("Eye height"), "eye_height_m", 0.05),
    "floor_albedo": (mark("Floor"), "albedo", 0.01),
    "wall_albedo": (mark("Walls"), "albedo", 0.01),
    "ceiling_albedo": (mark("Ceiling"), "albedo", 0.01),
}


class SurroundingsForm(QWidget):
    """The studio's unit, and its room or its backdrop."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.edits = edits = Edits(self)
        self.unit = edits.choice("unit", UNIT_TITLES)
        self.around = edits.choice("around", AROUND_TITLES)
        self.backdrop_luminance = edits.of_document("backdrop.luminance", 0.01, 3, "luminance")
        self.backdrop_colour = TemperatureField(edits, "backdrop.colour_temperature_k")
        self.room: dict[str, NumberField] = {
            name: edits.of_document(f"room.{name}", step, 2, parameter)
            for name, (_, parameter, step) in _ROOM.items()
        }
        form = Form()
        form.add_row(tr("Unit"), self.unit, tr("Unit of luminances; the exposure is set for a white card"))
        form.add_row(tr("Surroundings"), self.around, tr("Visible where there is no lamp"))
        self._backdrop, self._room = Form(), Form()
        self._backdrop.add_row(tr("Luminance"), self.backdrop_luminance, tr("Uniform; 0 is black"))
        self._backdrop.add_row(tr("Colour"), self.backdrop_colour, tr("Colour of the backdrop"))
        for name, (label, parameter, _) in _ROOM.items():
            self._room.add_row(tr(label), self.room[name], tr(PARAMETERS[parameter].meaning))
        fill_column(self, form, self._backdrop, self._room)

    def set_studio(self, studio: Studio) -> None:
        self.unit.show_choice(studio.unit)
        self.around.show_choice("backdrop" if studio.room is None else "room")
        self._backdrop.setVisible(studio.backdrop is not None)
        self._room.setVisible(studio.room is not None)
        if studio.backdrop is not None:
            self.backdrop_luminance.setSuffix("" if studio.unit == "relative" else " kcd/m²")
            self.backdrop_luminance.set_value(studio.backdrop.luminance)
            self.backdrop_colour.set_value(studio.backdrop.colour_temperature_k)
        if studio.room is not None:
            for name, field in self.room.items():
                field.set_value(getattr(studio.room, name))


def changed_surroundings(studio: Studio, name: str, value: Any) -> Studio:
    """Return the studio after an edit of a field; :class:`ValueRangeError` where it cannot be so."""
    if name == "around":
        return with_room(studio, value == "room")
    part, _, field = name.partition(".")
    if field:
        value = dataclasses.replace(getattr(studio, part), **{field: value})
    return dataclasses.replace(studio, **{part: value})


class SkyForm(Form):
    """The fields of a sky; ``edits`` reports them by the names of :class:`Sky`."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.edits = edits = Edits(self)
        self.model = edits.choice("model", SKY_TITLES)
        self.turbidity = edits.of_document("turbidity", 0.1, 1)
        self.elevation = edits.of_document("sun_elevation_deg", 1.0, 1)
        self.azimuth = edits.of_document("sun_azimuth_deg", 1.0, 1)
        self.ground = edits.of_document("ground_albedo", 0.01, 2)
        self.disc = edits.tick("sun_disc", tr("Sun in the picture"), tr("The solar disc, 0.53° in diameter"))
        self.add_row(tr("Model"), self.model, tr("Published sky model"))
        self._clear = [
            self.add_row(tr("Turbidity"), self.turbidity, tr(PARAMETERS["turbidity"].meaning)),
            self.add_row(tr("Elevation"), self.elevation, tr(PARAMETERS["sun_elevation_deg"].meaning)),
            self.add_row(tr("Azimuth"), self.azimuth, tr(PARAMETERS["sun_azimuth_deg"].meaning)),
            *(self.turbidity, self.elevation, self.azimuth, self.disc),
        ]
        self.add_row(tr("Ground"), self.ground, tr(PARAMETERS["ground_albedo"].meaning))
        self.add_row("", self.disc)

    def set_sky(self, sky: Sky) -> None:
        """Show a sky, without a signal; an overcast one knows no sun."""
        self.model.show_choice(sky.model)
        self.turbidity.set_value(sky.turbidity)
        self.elevation.set_value(sky.sun_elevation_deg)
        self.azimuth.set_value(sky.sun_azimuth_deg)
        self.ground.set_value(sky.ground_albedo)
        self.disc.setChecked(sky.sun_disc)
        for widget in self._clear:
            widget.setEnabled(sky.model != "overcast")
