"""From where the surface is seen; azimuth 0 is in front (+z), growing counter-clockwise seen from above."""

from __future__ import annotations

from dataclasses import replace

from brdf_qt.fields.form import Form, described, fill_row
from brdf_qt.fields.labels import plain_tip
from brdf_qt.fields.number import NumberField, reach_of
from brdf_qt.program.translation import tr
from brdf_qt.window.section import Section
from brdf_qt.window.view_titles import PRESETS
from PySide6.QtCore import Signal
from PySide6.QtWidgets import QPushButton, QToolButton, QWidget

from brdf_suite.documents.view import PARAMETERS, Camera


def look_from(camera: Camera, preset: str) -> Camera:
    """Return the camera at a preset, framing the whole object with its present lens."""
    _, azimuth, elevation = PRESETS[preset]
    return replace(camera, azimuth_deg=azimuth, elevation_deg=elevation, distance=None, target=None)


def signed_deg(angle_deg: float) -> float:
    """Return the same angle from -180 (excluded) to 180.

    >>> signed_deg(350.0), signed_deg(180.0)
    (-10.0, 180.0)
    """
    return 180.0 - (180.0 - angle_deg) % 360.0


class CameraSection(Section):
    """The camera by numbers, and how fast the surface turns; ``daily``: the presets, and framing."""

    preset_chosen = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(tr("Camera"), "camera", parent)
        self.daily, buttons = Form(), QWidget()
        self.frame = described(
            QPushButton(tr("Frame")), name="frame", tip=tr("Fill the picture with the surface (F)")
        )
        self.presets = [self._preset_button(number, key) for number, key in enumerate(PRESETS, 1)]
        fill_row(buttons, *self.presets, spacing=4, even=True)
        start, speed = Camera(), PARAMETERS["turntable_deg_s"]
        self.azimuth = NumberField(tr("Azimuth"), "°", -180.0, 180.0, 1.0, 1, start.azimuth_deg)
        self.azimuth.setWrapping(True)
        self.elevation = NumberField(tr("Elevation"), "°", -89.0, 89.0, 1.0, 1, start.elevation_deg)
        self.focal_length = NumberField(tr("Focal length"), "mm", 12.0, 400.0, 1.0, 0, start.focal_length_mm)
        self.turntable = NumberField(tr("Turntable"), *reach_of(speed, 1.0, 1))
        self.daily.add_row(tr("View from"), buttons)
        self.daily.add_row("", self.frame)
        form = self.add(Form())
        form.add_row(tr("Azimuth"), self.azimuth, tr(PARAMETERS["camera.azimuth_deg"].meaning))
        form.add_row(tr("Elevation"), self.elevation, tr(PARAMETERS["camera.elevation_deg"].meaning))
        form.add_row(tr("Focal length"), self.focal_length, tr(PARAMETERS["camera.focal_length_mm"].meaning))
        tip = tr("{meaning}; negative reverses. Space on the picture starts and stops it")
        form.add_row(tr("Turntable"), self.turntable, tip.format(meaning=tr(speed.meaning)))

    def _preset_button(self, number: int, key: str) -> QToolButton:
        title = tr(PRESETS[key][0])
        button = QToolButton()
        button.setText(title)
        button.setObjectName(f"preset_{key}")
        button.setToolTip(plain_tip(tr("View: {view} ({key})").format(view=title.lower(), key=number)))
        button.setSizePolicy(button.sizePolicy().Policy.Expanding, button.sizePolicy().Policy.Fixed)
        button.clicked.connect(lambda _=False: self.preset_chosen.emit(key))
        return button
