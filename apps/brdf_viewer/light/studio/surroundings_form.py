"""What is around the lamps: a room or a plain backdrop; and the fields of a sky."""

from __future__ import annotations

import dataclasses
from typing import Any

from brdf_qt.fields.form import Form
from brdf_qt.fields.number import NumberField
from brdf_qt.program.translation import mark, tr
from PySide6.QtWidgets import QVBoxLayout, QWidget

from brdf_suite.documents.studio import PARAMETERS, Sky, Studio
from brdf_viewer.light.studio.edits import with_room
from brdf_viewer.light.studio.fields import Edits, TemperatureField

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
        box = QVBoxLayout(self)
        box.setContentsMargins(0, 0, 0, 0)
        box.setSpacing(8)
        for part in (form, self._backdrop, self._room):
            box.addWidget(part)

    def set_studio(self, studio: Studio) -> None:
        """Show a studio's surroundings, without a signal."""
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
        return dataclasses.replace(
            studio, **{part: dataclasses.replace(getattr(studio, part), **{field: value})}
        )
    return dataclasses.replace(studio, **{name: value})


class SkyForm(QWidget):
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
        form = Form()
        form.add_row(tr("Model"), self.model, tr("Published sky model"))
        self._clear = [
            form.add_row(tr("Turbidity"), self.turbidity, tr(PARAMETERS["turbidity"].meaning)),
            form.add_row(tr("Elevation"), self.elevation, tr(PARAMETERS["sun_elevation_deg"].meaning)),
            form.add_row(tr("Azimuth"), self.azimuth, tr(PARAMETERS["sun_azimuth_deg"].meaning)),
            self.turbidity,
            self.elevation,
            self.azimuth,
            self.disc,
        ]
        form.add_row(tr("Ground"), self.ground, tr(PARAMETERS["ground_albedo"].meaning))
        form.add_row("", self.disc)
        box = QVBoxLayout(self)
        box.setContentsMargins(0, 0, 0, 0)
        box.addWidget(form)

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
