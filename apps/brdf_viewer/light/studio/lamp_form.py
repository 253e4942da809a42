"""The fields of one lamp: where it is, how large it looks, how bright and of what colour."""

from __future__ import annotations

import dataclasses
from typing import Any

from brdf_qt.fields.form import Form
from brdf_qt.fields.labels import plain_tip
from brdf_qt.program.translation import mark, tr
from PySide6.QtWidgets import QVBoxLayout, QWidget

from brdf_suite.documents.studio import PARAMETERS, Point, Shape, StudioLamp
from brdf_viewer.light.studio.fields import Edits, TemperatureField
from brdf_viewer.light.studio.places import angle_of, facing_deg, moved, point_at, polar, size_at

SHAPE_TITLES = {"box": mark("Box"), "strip": mark("Strip"), "ring": mark("Ring")}
_SIZE_LABELS = {
    "box": (mark("Width"), mark("Height")),
    "strip": (mark("Length"), mark("Width")),
    "ring": (mark("Diameter"), mark("Band")),
}


class LampForm(QWidget):
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
        self.aimed = edits.tick(
            "aimed", tr("Face the centre"), tr("Off: the direction is set by the two angles")
        )
        self.facing_azimuth = edits.number("facing_azimuth", tr("Facing"), "°", -180.0, 180.0, 1.0, 1, 180.0)
        self.facing_azimuth.setWrapping(True)
        self.facing_elevation = edits.number("facing_elevation", tr("Up"), "°", -90.0, 90.0, 1.0, 1, -45.0)
        self.luminance = edits.of_document("luminance", 0.1, 2)
        self.colour = TemperatureField(edits)
        self.softness = edits.number("softness_cm", tr("Soft edge"), "cm", 0.01, 1000.0, 0.5, 2, 6.0)
        form = Form()
        form.add_row(
            tr("Shape"), self.shape, tr("A box is brightest in its middle; strips and rings are even")
        )
        form.add_row(tr("Azimuth"), self.azimuth, tr("Position: from the front (+z) towards the right (+x)"))
        form.add_row(tr("Elevation"), self.elevation, tr("Above the horizon at the centre of the scene"))
        form.add_row(
            tr("Distance"),
            self.distance,
            tr("Distance from the centre of the scene; the size in metres stays"),
        )
        size = tr("Angular size, seen face-on from the centre of the scene")
        self._first_label = form.add_row(tr("Width"), self.first, size)
        self._second_label = form.add_row(tr("Height"), self.second, size)
        form.add_row(tr("Roll"), self.roll, tr(PARAMETERS["roll_deg"].meaning))
        form.add_row("", self.aimed)
        self._facing_labels = [
            form.add_row(tr("Shines to"), self.facing_azimuth, tr("Azimuth of the direction of emission")),
            form.add_row(tr("and up"), self.facing_elevation, tr("Elevation of the direction of emission")),
        ]
        self._luminance_label = form.add_row(tr("Luminance"), self.luminance, tr("At its centre"))
        form.add_row(tr("Colour"), self.colour, tr("Planckian below 4,000 K, daylight above"))
        form.add_row(tr("Soft edge"), self.softness, tr("Width of the fade at its edge"))
        box = QVBoxLayout(self)
        box.setContentsMargins(0, 0, 0, 0)
        box.addWidget(form)

    def set_lamp(self, lamp: StudioLamp, unit: str) -> None:
        """Show a lamp of a studio in ``unit``, without a signal."""
        self.shape.show_choice(lamp.shape)
        azimuth, elevation, distance = polar(lamp.position_m)
        self.azimuth.set_value(azimuth)
        self.elevation.set_value(elevation)
        self.distance.set_value(distance)
        for field, label, text, size in zip(
            (self.first, self.second),
            (self._first_label, self._second_label),
            _SIZE_LABELS[lamp.shape],
            lamp.size_m,
            strict=True,
        ):
            field.set_value(angle_of(size, distance))
            label.setText(tr(text))
            metres = f"{size:.3g} m"
            tip = tr("{side}: {metres}; the angle is its face-on angular size")
            field.setToolTip(plain_tip(tip.format(side=tr(text), metres=metres)))
        self.roll.set_value(lamp.roll_deg)
        self.aimed.setChecked(lamp.facing is None)
        facing_azimuth, facing_elevation = facing_deg(lamp)
        self.facing_azimuth.set_value(facing_azimuth)
        self.facing_elevation.set_value(facing_elevation)
        for widget in (self.facing_azimuth, self.facing_elevation, *self._facing_labels):
            widget.setVisible(lamp.facing is not None)
        self.luminance.setSuffix("" if unit == "relative" else " kcd/m²")
        self.luminance.set_value(lamp.luminance)
        self.colour.set_value(lamp.colour_temperature_k)
        self.softness.set_value(100.0 * lamp.softness_m)


def changed_lamp(lamp: StudioLamp, name: str, value: Any) -> StudioLamp:
    """Return the lamp after an edit of a field of :class:`LampForm`; :class:`ValueRangeError` where it cannot be."""
    azimuth, elevation, distance = polar(lamp.position_m)
    if name in ("azimuth", "elevation", "distance"):
        place = {"azimuth": azimuth, "elevation": elevation, "distance": distance} | {name: _number(value)}
        return moved(lamp, point_at(place["azimuth"], place["elevation"], place["distance"]))
    if name in ("first", "second"):
        size = size_at(_number(value), distance)
        both = (size, lamp.size_m[1]) if name == "first" else (lamp.size_m[0], size)
        return dataclasses.replace(lamp, size_m=both)
    if name == "shape":
        return _shaped(lamp, value)
    if name == "aimed":
        x, y, z = lamp.position_m
        return dataclasses.replace(lamp, facing=None if value else (-x, -y, -z))
    if name in ("facing_azimuth", "facing_elevation"):
        now = facing_deg(lamp)
        angles = (_number(value), now[1]) if name == "facing_azimuth" else (now[0], _number(value))
        facing: Point = point_at(*angles, 1.0)
        return dataclasses.replace(lamp, facing=facing)
    if name == "softness_cm":
        return dataclasses.replace(lamp, softness_m=0.01 * _number(value))
    return dataclasses.replace(lamp, **{name: value})


def _shaped(lamp: StudioLamp, shape: Shape) -> StudioLamp:
    """Return the lamp in another shape, its sides brought to what that can have."""
    first, second = lamp.size_m
    if shape == "strip":
        first, second = max(first, second), min(first, second)
    elif shape == "ring":
        second = min(second, 0.5 * first)
    return dataclasses.replace(lamp, shape=shape, size_m=(first, second))


def _number(value: object) -> float:
    assert isinstance(value, (int, float))
    return float(value)
