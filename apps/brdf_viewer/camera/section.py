"""From where the surface is seen."""

from __future__ import annotations

from brdf_qt.fields.form import Form
from brdf_qt.fields.labels import plain_tip
from brdf_qt.fields.number import NumberField
from brdf_qt.program.translation import tr
from brdf_qt.window.section import Section
from PySide6.QtCore import Signal
from PySide6.QtWidgets import QButtonGroup, QGridLayout, QToolButton, QWidget

from brdf_suite.documents.view import PARAMETERS, Camera


class CameraSection(Section):
    """From where the surface is seen, by preset or by number, through which lens, and how fast it turns."""

    preset_chosen = Signal(str)

    def __init__(self, presets: dict[str, str], parent: QWidget | None = None) -> None:
        super().__init__(tr("Camera"), "camera", parent)
        buttons = QWidget()
        row = QGridLayout(buttons)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(4)
        self.presets = QButtonGroup(self)
        self.presets.setExclusive(False)
        for index, (key, title) in enumerate(presets.items()):
            button = QToolButton()
            button.setText(tr(title))
            button.setObjectName(f"preset_{key}")
            button.setToolTip(
                plain_tip(tr("View: {view} ({key})").format(view=tr(title).lower(), key=index + 1))
            )
            button.setSizePolicy(button.sizePolicy().Policy.Expanding, button.sizePolicy().Policy.Fixed)
            button.clicked.connect(lambda _=False, key=key: self.preset_chosen.emit(key))
            self.presets.addButton(button)
            row.addWidget(button, 0, index)
        start = Camera()
        self.azimuth = NumberField(tr("Azimuth"), "°", -180.0, 180.0, 1.0, 1, start.azimuth_deg)
        self.azimuth.setWrapping(True)
        self.elevation = NumberField(tr("Elevation"), "°", -89.0, 89.0, 1.0, 1, start.elevation_deg)
        focal_length = start.focal_length_mm
        self.focal_length = NumberField(tr("Focal length"), "mm", 12.0, 400.0, 1.0, 0, focal_length)
        speed = PARAMETERS["turntable_deg_s"]
        self.turntable = NumberField(
            tr("Turntable"), speed.unit, speed.low, speed.high, 1.0, 1, speed.default
        )
        form = Form()
        form.add_wide(buttons)
        form.add_row(tr("Azimuth"), self.azimuth, tr(PARAMETERS["camera.azimuth_deg"].meaning))
        form.add_row(tr("Elevation"), self.elevation, tr(PARAMETERS["camera.elevation_deg"].meaning))
        form.add_row(tr("Focal length"), self.focal_length, tr(PARAMETERS["camera.focal_length_mm"].meaning))
        tip = tr("{meaning}; negative reverses. Space on the picture starts and stops it")
        form.add_row(tr("Turntable"), self.turntable, tip.format(meaning=tr(speed.meaning)))
        self.add(form)
