"""Lamps beside the environment: a list, and the fields of the one that is chosen."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from math import hypot
from typing import Any

from brdf_qt.fields.form import Form
from brdf_qt.fields.labels import plain_tip
from brdf_qt.fields.number import NumberField
from brdf_qt.fields.quiet import QuietComboBox
from brdf_qt.program.icons import icon
from brdf_qt.program.translation import mark, tr
from PySide6.QtCore import Signal
from PySide6.QtWidgets import QCheckBox, QHBoxLayout, QToolButton, QVBoxLayout, QWidget

from brdf_suite.documents.view_settings import MOST_LAMPS, PARAMETERS, Lamp
from brdf_viewer.fields.choice_box import ChoiceBox
from brdf_viewer.light.studio import places

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
        self.add_button = _button("plus", tr("Add a lamp to the environment"), self._add)
        self.remove_button = _button("trash", tr("Remove this lamp"), self._remove)
        row = QWidget()
        inside = QHBoxLayout(row)
        inside.setContentsMargins(0, 0, 0, 0)
        inside.setSpacing(4)
        inside.addWidget(self.list, 1)
        inside.addWidget(self.add_button)
        inside.addWidget(self.remove_button)
        self.kind = ChoiceBox(KIND_TITLES)
        self.kind.picked.connect(lambda key: self._change(kind=key))
        self.azimuth = NumberField(tr("Azimuth"), "°", -180.0, 180.0, 1.0, 1, 30.0)
        self.azimuth.setWrapping(True)
        self.elevation = NumberField(tr("Elevation"), "°", -90.0, 90.0, 1.0, 1, 45.0)
        self.distance = NumberField(tr("Distance"), "m", 0.05, 1000.0, 0.05, 2, 2.0)
        for field in (self.azimuth, self.elevation, self.distance):
            field.edited.connect(self._placed)
        strength, kelvin = PARAMETERS["lamp.strength"], PARAMETERS["lamp.temperature_k"]
        self.strength = NumberField(tr("Strength"), "", 0.0, strength.high, 0.1, 2, strength.default)
        self.strength.edited.connect(lambda value: self._change(strength=value))
        self.temperature = NumberField(tr("Colour"), "K", kelvin.low, kelvin.high, 50.0, 0, kelvin.default)
        self.temperature.edited.connect(lambda value: self._change(temperature_k=value))
        self.moving = QCheckBox(tr("Moves round"))
        self.moving.setToolTip(tr("Rotate the lamps around the surface to see flakes and highlights move"))
        self.shading = ChoiceBox(SHADING_TITLES, SHADING_TIPS)
        form = Form()
        form.add_row(
            tr("Lamps"), row, tr("Small lamps in addition to the environment; flakes sparkle in their light")
        )
        self._fields = Form()
        self._fields.add_row(tr("Kind"), self.kind)
        self._fields.add_row(tr("Azimuth"), self.azimuth, tr(PARAMETERS["lamp.azimuth_deg"].meaning))
        self._fields.add_row(tr("Elevation"), self.elevation, tr(PARAMETERS["lamp.elevation_deg"].meaning))
        self._distance_label = self._fields.add_row(
            tr("Distance"), self.distance, tr("From the centre of the scene")
        )
        self._fields.add_row(tr("Strength"), self.strength, tr(strength.meaning))
        self._fields.add_row(tr("Colour"), self.temperature, tr(kelvin.meaning))
        self._fields.add_row("", self.moving)
        self._fields.add_row(tr("Factored"), self.shading, tr("Shading of factored paints by the lamps"))
        box = QVBoxLayout(self)
        box.setContentsMargins(0, 0, 0, 0)
        box.setSpacing(8)
        box.addWidget(form)
        box.addWidget(self._fields)
        self.set_lamps(())

    def set_lamps(self, lamps: tuple[Lamp, ...]) -> None:
        """Show lamps, without a signal; the one that was chosen stays so."""
        chosen = max(0, self.list.currentIndex())
        if [lamp.kind for lamp in lamps] != [lamp.kind for lamp in self.lamps] or not lamps:
            self.list.clear()
            self.list.addItems(
                [f"{i + 1}: {tr(KIND_TITLES[lamp.kind])}" for i, lamp in enumerate(lamps)] or [tr("None")]
            )
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
        azimuth, elevation, distance = polar(lamp)
        self.azimuth.set_value(azimuth)
        self.elevation.set_value(elevation)
        self.distance.set_value(distance)
        for widget in (self.distance, self._distance_label):
            widget.setVisible(lamp.kind == "point")
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
        lamp = self._chosen()
        if lamp is not None:
            place = (self.azimuth.value(), self.elevation.value(), self.distance.value())
            self._replace(placed(lamp, *place))

    def _change(self, **fields: Any) -> None:
        lamp = self._chosen()
        if lamp is not None:
            self._replace(dataclasses.replace(lamp, **fields))

    def _replace(self, lamp: Lamp) -> None:
        index = self.list.currentIndex()
        self.set_lamps((*self.lamps[:index], lamp, *self.lamps[index + 1 :]))
        self.edited.emit(self.lamps)


def polar(lamp: Lamp) -> tuple[float, float, float]:
    """Return azimuth and elevation in degrees and the distance in metres of where a lamp's light comes from.

    >>> [round(value, 3) for value in polar(Lamp(position=(0.0, 3.0, 3.0)))]
    [0.0, 45.0, 4.243]
    """
    if lamp.kind == "directional":
        return (lamp.azimuth_deg + 180.0) % 360.0 - 180.0, lamp.elevation_deg, hypot(*lamp.position)
    azimuth, elevation, distance = places.polar(lamp.position)
    return azimuth, elevation, max(0.05, distance)


def placed(lamp: Lamp, azimuth_deg: float, elevation_deg: float, distance: float) -> Lamp:
    """Return the lamp at another place; both forms of it are kept in step, so that a change of kind keeps it."""
    position = places.point_at(azimuth_deg, elevation_deg, distance)
    return dataclasses.replace(lamp, position=position, azimuth_deg=azimuth_deg, elevation_deg=elevation_deg)


def _button(name: str, tip: str, slot: Callable[[], object]) -> QToolButton:
    button = QToolButton()
    button.setIcon(icon(name))
    button.setToolTip(plain_tip(tip))
    button.setAccessibleName(tip)
    button.clicked.connect(lambda _=False: slot())
    return button
