"""Lamps moved in a picture: dragged by their handles, or put where their highlight is clicked; in every program."""

from __future__ import annotations

from typing import NamedTuple, Protocol

import numpy as np
from PySide6.QtCore import QEvent, QObject, QPointF, QRectF, Qt, Signal
from PySide6.QtGui import QColor, QGuiApplication, QKeyEvent, QMouseEvent
from PySide6.QtWidgets import QWidget

from brdf_qt.gl.aiming import (
    NEW_LAMP,
    direction_of,
    lamp_for_highlight,
    map_direction,
    map_place,
    polar_of,
    turned_to,
)
from brdf_qt.gl.lamp_layer import RADIUS, LampHandle, LampLayer
from brdf_qt.gl.surface import GlSurface
from brdf_qt.program.translation import decimal, mark, tr
from brdf_qt.work.timer import make_timer
from brdf_suite.appearance.colour.colorimetry import working_to_display
from brdf_suite.appearance.light.matrix import lamp_colour
from brdf_suite.arrays import Floats
from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import Lamp
from brdf_suite.realtime.camera import Bounds, axes, matrices

_SHARE = 0.24
"""Radius of the circle between front and back over the shorter edge of the picture: what is behind fits around it."""
_GRIP = RADIUS + 4.0
_ASK = mark("Click on the surface where the highlight is to be – Esc cancels")
_TURNED = mark("Light turned to {angle:.0f}° – in the picture, drag with Alt or with the right button")
_TURNED_MS = 1200
_WHERE = mark("Lamp {number}: azimuth {azimuth:.0f}°, elevation {elevation:.0f}°")


class SeenPlace(NamedTuple):
    """A place of the surface that is seen: position (3,) m, unit normal (3,), and where the eye (3,) m is."""

    position: Floats
    normal: Floats
    eye: Floats


class LampScene(Protocol):
    """The scene whose lamps are moved."""

    @property
    def view(self) -> View:
        """The view on show."""

    @property
    def chosen(self) -> int:
        """The place of the lamp that is chosen; -1: none."""

    @property
    def wants_handles(self) -> bool:
        """Whether the lamps are to be seen as handles now."""

    @property
    def box(self) -> QRectF:
        """Where the picture is, as shares of the canvas."""

    def seen_at(self, place: QPointF) -> SeenPlace | None:
        """Return what of the surface is seen at a place of the canvas, logical pixels; None: nothing."""

    def choose(self, index: int) -> None:
        """Choose a lamp."""

    def begin_drag(self) -> None:
        """All changes until :meth:`end_drag` are one."""

    def end_drag(self) -> None:
        """The drag has ended."""

    def set_lamps(self, lamps: tuple[Lamp, ...]) -> None:
        """Light the scene with these."""


class LampHandles(QObject):
    """Shows the lamps of ``scene`` over ``picture``; :meth:`show` follows what has changed.

    ``asking(wanted)``: a click on the surface is waited for now, or no more.
    """

    asking = Signal(bool)

    def __init__(self, picture: GlSurface, scene: LampScene) -> None:
        super().__init__(picture)
        self._picture, self._scene = picture, scene
        self.layer = LampLayer(picture)
        self._grip: tuple[int, QPointF] | None = None
        self._over = self._asks = False
        self._turned = make_timer(self, self._end_turned, _TURNED_MS)
        picture.installEventFilter(self)
        picture.canvas_changed.connect(self._listen)
        self._listen(picture.canvas)

    def ask(self, wanted: bool) -> None:
        """Wait for the click on the surface, or no more."""
        if wanted != self._asks:
            self._asks = wanted
            self.asking.emit(wanted)
            self._show_cursor()
            self.layer.show_words(tr(_ASK) if wanted else "")

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        kind = event.type()
        if watched is not self._picture.canvas:
            if kind in (QEvent.Type.Show, QEvent.Type.Hide, QEvent.Type.Resize):
                self.show()
            return False
        if isinstance(event, QMouseEvent):
            if kind == QEvent.Type.MouseButtonPress:
                return self._press(event)
            if kind == QEvent.Type.MouseMove:
                return self._move(event)
            if kind == QEvent.Type.MouseButtonRelease:
                return self._release(event)
        elif isinstance(event, QKeyEvent) and kind == QEvent.Type.KeyPress and self._asks:
            if event.key() == Qt.Key.Key_Escape:
                self.ask(False)
                return True
        elif kind in (QEvent.Type.Hide, QEvent.Type.WindowDeactivate):
            self._end()
        return False

    def put(self, place: QPointF) -> None:
        """Put the chosen lamp, or a new one, where it is mirrored at a place of the canvas, logical pixels."""
        seen = self._scene.seen_at(place)
        if seen is None:
            return  # what is asked stays in sight
        to_eye = (seen.eye - seen.position) / np.linalg.norm(seen.eye - seen.position)
        lamps = self._scene.view.lamps
        index = min(max(0, self._scene.chosen), len(lamps))
        lamp = lamps[index] if index < len(lamps) else NEW_LAMP
        moved = lamp_for_highlight(lamp, seen.position, seen.normal, to_eye)
        self._scene.begin_drag()
        self._scene.set_lamps((*lamps[:index], moved, *lamps[index + 1 :]))
        self._scene.end_drag()
        self.ask(False)

    def handle_at(self, place: QPointF) -> LampHandle | None:
        """Return the handle under a place of the canvas, the chosen one first."""
        if not self.layer.isVisible():
            return None
        for handle in sorted(self.layer.handles, key=lambda handle: not handle.chosen):
            away = handle.place - place
            if np.hypot(away.x(), away.y()) <= _GRIP:
                return handle
        return None

    def show(self) -> None:
        """Show the handles where the lamps are now."""
        scene, canvas = self._scene, self._picture.canvas
        width, height = scene.box.width() * canvas.width(), canvas.height()
        centre, reach = QPointF(0.5 * width, 0.5 * height), _SHARE * min(width, height)
        handles = []
        for number, lamp in enumerate(scene.view.lamps if scene.wants_handles else (), 1):
            right, up = map_place(direction_of(lamp), self._axes())
            place = centre + QPointF(float(right), -float(up)) * reach
            behind = bool(np.hypot(right, up) > 1.0)
            handles.append(LampHandle(number, place, _colour(lamp), behind, number - 1 == scene.chosen))
        self.layer.show_handles(tuple(handles), centre, reach)

    def follow_view(self, old: View, new: View) -> None:
        """Show the handles in another view, and say for a moment how far its light is turned."""
        self.show()
        if old.rotation_deg != new.rotation_deg:
            self._show_turned()

    def _show_turned(self) -> None:
        """Say for a moment how far the light is turned, while the hand turns it."""
        held = QGuiApplication.mouseButtons() != Qt.MouseButton.NoButton
        if held and self._grip is None and not self._asks:
            words = tr(_TURNED).format(angle=self._scene.view.rotation_deg)
            self.layer.show_words(decimal(words.replace("-", "−")))
            self._turned.start()

    def _listen(self, canvas: QWidget) -> None:
        canvas.installEventFilter(self)

    def _press(self, event: QMouseEvent) -> bool:
        if event.button() != Qt.MouseButton.LeftButton or event.modifiers() != Qt.KeyboardModifier.NoModifier:
            return False
        if self._asks:
            self.put(event.position())
            return True
        handle = self.handle_at(event.position())
        if handle is None:
            return False
        self._grip = (handle.number - 1, handle.place - event.position())
        self._scene.choose(handle.number - 1)
        self._scene.begin_drag()
        self._show_cursor()
        self._say()
        return True

    def _move(self, event: QMouseEvent) -> bool:
        if self._grip is None:
            if event.buttons() == Qt.MouseButton.NoButton:
                over = self.handle_at(event.position()) is not None
                if over != self._over:  # other gestures have cursors of their own
                    self._over = over
                    self._show_cursor()
            return self._asks
        if not event.buttons() & Qt.MouseButton.LeftButton:  # released outside the widget, without an event
            self._end()
            return False
        index, offset = self._grip
        away = event.position() + offset - self.layer.centre
        place = np.array([away.x(), -away.y()]) / max(self.layer.reach, 1.0)
        lamps = self._scene.view.lamps
        if index < len(lamps):
            moved = turned_to(lamps[index], map_direction(place, self._axes()))
            self._scene.set_lamps((*lamps[:index], moved, *lamps[index + 1 :]))
            self._say()
        return True

    def _release(self, event: QMouseEvent) -> bool:
        if self._grip is None or event.button() != Qt.MouseButton.LeftButton:
            return False
        self._end()
        return True

    def _end(self) -> None:
        if self._grip is not None:
            self._grip = None
            self._scene.end_drag()
            self.layer.show_words("")
            self._show_cursor()

    def _end_turned(self) -> None:
        if self._grip is None and not self._asks:
            self.layer.show_words("")

    def _axes(self) -> Floats:
        return axes(self._scene.view.camera)

    def _say(self) -> None:
        assert self._grip is not None
        index = self._grip[0]
        azimuth, elevation, _ = polar_of(self._scene.view.lamps[index])
        words = tr(_WHERE).format(number=index + 1, azimuth=azimuth, elevation=elevation)
        self.layer.show_words(decimal(words.replace("-", "−")), dragged=True)

    def _show_cursor(self) -> None:
        canvas = self._picture.canvas
        if self._asks:
            canvas.setCursor(Qt.CursorShape.CrossCursor)
        elif self._grip is not None:
            canvas.setCursor(Qt.CursorShape.ClosedHandCursor)
        elif self._over:
            canvas.setCursor(Qt.CursorShape.OpenHandCursor)
        else:
            canvas.unsetCursor()


def ray_through(view: View, bounds: Bounds, size: tuple[int, int], share: QPointF) -> tuple[Floats, Floats]:
    """Return the eye (m) and the unit direction (3,) of what is seen at a place of a picture.

    ``size`` is the picture's in pixels, ``share`` the place in it, 0…1 from the left and from above.
    """
    camera = matrices(view.camera, bounds, size)
    right = (2.0 * share.x() - 1.0) * camera.half_tangents[0]
    up = (1.0 - 2.0 * share.y()) * camera.half_tangents[1]
    ray = camera.view_to_world @ np.array([right, up, -1.0])
    return camera.eye, ray / np.linalg.norm(ray)


def _colour(lamp: Lamp) -> QColor:
    """Return the colour of a lamp's light on the screen, as bright as it gets there."""
    light = lamp_colour(lamp.temperature_k)
    red, green, blue = (float(v) for v in np.clip(working_to_display(light / light.max()), 0.0, 1.0))
    return QColor.fromRgbF(red, green, blue)
