"""From gestures, presets and numbers to the camera and the turn of the light."""

from __future__ import annotations

import dataclasses
from typing import Any

from brdf_qt.gl.gestures import CameraGestures
from brdf_qt.program.translation import tr
from PySide6.QtWidgets import QWidget

from brdf_suite.documents.view import Camera, View
from brdf_suite.output.turning import turned
from brdf_suite.realtime.camera import dolly_to, frame, orbit, pan, resolve
from brdf_suite.realtime.pictures.comparison import sides
from brdf_viewer.camera.section import look_from, signed_deg
from brdf_viewer.camera.turntable import Turntable
from brdf_viewer.feature import ViewerFeature
from brdf_viewer.scene.viewer_state import ViewerState
from brdf_viewer.window import ViewerWindow


class CameraControl(ViewerFeature):
    """Moves the viewer state's camera; shows where it is."""

    def __init__(self, state: ViewerState, window: ViewerWindow) -> None:
        super().__init__(state, window)
        commands, section = window.commands, window.camera
        self.turntable = Turntable(state.history, tr("Turntable"), state.view.turntable_deg_s, self)
        self.turntable.turned.connect(self._turn)
        self.turntable.running_changed.connect(commands.turntable.setChecked)
        window.picture.canvas_changed.connect(self._listen)
        self._listen(window.picture.canvas)
        for signal in (commands.frame.triggered, section.frame.clicked):
            signal.connect(self._frame)
        commands.turntable.triggered.connect(self.turntable.set_running)
        # Each a step of its own, also close after another.
        for signal in (commands.preset_requested, section.preset_chosen):
            signal.connect(lambda preset: state.step_view(camera=look_from(self._camera, preset)))
        section.azimuth.edited.connect(lambda value: self._aim(azimuth_deg=value % 360.0))
        section.elevation.edited.connect(lambda value: self._aim(elevation_deg=value))
        section.focal_length.edited.connect(self._set_focal_length)
        section.turntable.edited.connect(lambda value: state.change_view(turntable_deg_s=value))
        state.view_changed.connect(self._show)
        self._show(None, state.view)

    @property
    def _camera(self) -> Camera:
        return self._state.view.camera

    @property
    def picture_size(self) -> tuple[int, int]:
        """The size of one picture: side by side there are two."""
        size, compare = self._window.picture.device_size, self._state.view.compare
        both = compare.mode == "side" and self._state.second is not None
        return (sides(size)[0][2], size[1]) if both else size

    def _listen(self, canvas: QWidget) -> None:
        gestures = CameraGestures(canvas)
        gestures.orbited.connect(
            lambda azimuth, elevation: self._state.change_view(
                camera=orbit(self._settled(), azimuth, elevation)
            )
        )
        gestures.panned.connect(self.pan)
        gestures.zoomed.connect(self._zoom)
        gestures.light_turned.connect(
            lambda by: self._state.change_view(rotation_deg=signed_deg(self._state.view.rotation_deg + by))
        )
        gestures.framed.connect(self._frame)
        gestures.started.connect(self._state.history.begin)
        gestures.finished.connect(self._state.history.end)

    def _frame(self) -> None:
        self._state.step_view(camera=frame(self._camera))

    def pan(self, right: float, up: float) -> None:
        """Pan by fractions of the picture's height."""
        size = self.picture_size
        camera = pan(self._camera, self._state.bounds, size, right * size[1], -up * size[1])
        self._state.change_view(camera=camera)

    def _zoom(self, factor: float, right: float, up: float) -> None:
        whole, size = self._window.picture.device_size, self.picture_size
        # From the middle of the picture that the cursor is in.
        offset = (whole[0] - size[0]) / 2 / size[1]
        place = (right - offset if right >= 0.0 else right + offset, up)
        self._state.change_view(camera=dolly_to(self._camera, self._state.bounds, size, factor, place))

    def _turn(self, degrees: float) -> None:
        settled = dataclasses.replace(self._state.view, camera=self._settled())
        self._state.history.amend(turned(settled, degrees, self._state.bounds.centre))

    def _aim(self, **angles: Any) -> None:
        self._state.change_view(camera=dataclasses.replace(self._settled(), **angles))

    def _set_focal_length(self, millimetres: float) -> None:
        """Another lens keeps the size of the surface in the picture: the distance grows with it."""
        changed: dict[str, Any] = {"focal_length_mm": millimetres}
        if self._camera.distance is not None:
            changed["distance"] = self._camera.distance * millimetres / self._camera.focal_length_mm
        self._state.change_part("camera", **changed)

    def _settled(self) -> Camera:
        """Return the camera with its distance fixed, so that the surface keeps its size while it turns."""
        if self._state.surface is None:
            return self._camera
        return resolve(self._camera, self._state.bounds, self.picture_size)

    def _show(self, old: View | None, new: View) -> None:
        section = self._window.camera
        if old is None or old.turntable_deg_s != new.turntable_deg_s:
            self.turntable.deg_per_second = new.turntable_deg_s
            section.turntable.set_value(new.turntable_deg_s)
        if old is None or old.camera != new.camera:
            section.azimuth.set_value(signed_deg(new.camera.azimuth_deg))
            section.elevation.set_value(new.camera.elevation_deg)
            section.focal_length.set_value(new.camera.focal_length_mm)
