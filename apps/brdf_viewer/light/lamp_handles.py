"""Lamps moved in the picture: dragged by their handles, or put where their highlight is clicked."""

from __future__ import annotations

import numpy as np
from brdf_qt.program.settings import settings
from brdf_qt.program.translation import decimal, mark, tr
from brdf_qt.work.timer import make_timer
from PySide6.QtCore import QEvent, QObject, QPointF, Qt
from PySide6.QtGui import QColor, QGuiApplication, QKeyEvent, QMouseEvent
from PySide6.QtWidgets import QWidget

from brdf_suite.appearance.colour.colorimetry import working_to_display
from brdf_suite.appearance.light.matrix import lamp_colour
from brdf_suite.arrays import Floats
from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import Lamp
from brdf_suite.realtime.camera import axes
from brdf_viewer.feature import ViewerFeature
from brdf_viewer.light.aiming import (
    NEW_LAMP,
    direction_of,
    lamp_for_highlight,
    map_direction,
    map_place,
    turned_to,
)
from brdf_viewer.light.lamp_layer import RADIUS, LampHandle, LampLayer
from brdf_viewer.light.section import polar
from brdf_viewer.overlay.seen_parts import SeenParts
from brdf_viewer.scene.viewer_state import ViewerState
from brdf_viewer.window import ViewerWindow

_KEY = "lamp_handles"
_SHARE = 0.24
"""Radius of the circle between front and back over the shorter edge of the picture: what is behind fits around it."""
_GRIP = RADIUS + 4.0
_ASK = mark("Click on the surface where the highlight is to be – Esc cancels")
_TURNED = mark("Light turned to {angle:.0f}° – in the picture, drag with Alt or with the right button")
_TURNED_MS = 1200
_WHERE = mark("Lamp {number}: azimuth {azimuth:.0f}°, elevation {elevation:.0f}°")


class LampHandles(ViewerFeature):
    """Shows the handles while the tab of the light is open, unless the user has put them away."""

    def __init__(self, state: ViewerState, window: ViewerWindow, seen: SeenParts) -> None:
        super().__init__(state, window)
        self._seen = seen
        self._fields = window.lighting.lamps
        self.layer = LampLayer(window.picture)
        self._grip: tuple[int, QPointF] | None = None
        self._over = self._asks = False
        self._turned = make_timer(self, self._end_turned, _TURNED_MS)
        kept = bool(settings().value(_KEY, True, type=bool))
        add = window.add_command
        tip = mark(
            "Lamps as handles in the picture while their settings are in sight; drag one to move its lamp"
        )
        self.shown = add(
            "view", mark("&Lamps in the Picture"), _KEY, self._toggle, _KEY, tip=tip, checked=kept
        )
        tip = mark("The next click on the surface moves the lamp to where its reflection is seen there")
        self.asking = add(
            "view",
            mark("Put the &Highlight Here"),
            "put_highlight",
            self.ask,
            "put_highlight",
            tip=tip,
            checked=False,
        )
        for action in (self.shown, self.asking):
            action.setShortcutContext(Qt.ShortcutContext.WidgetWithChildrenShortcut)
            window.picture.addAction(action)
        self._fields.highlight.clicked.connect(self.ask)
        self._fields.list.currentIndexChanged.connect(lambda _index: self._show())
        window.panel.pages["light"].installEventFilter(self)
        window.picture.installEventFilter(self)
        window.picture.canvas_changed.connect(self._listen)
        self._listen(window.picture.canvas)
        state.view_changed.connect(self._view_changed)
        state.contents_changed.connect(self._show)
        self._show()

    def ask(self, wanted: bool) -> None:
        """Wait for the click on the surface, or no more."""
        if wanted == self._asks:
            return
        self._asks = wanted
        self.asking.setChecked(wanted)
        self._fields.highlight.setChecked(wanted)
        self._show_cursor()
        self.layer.show_words(tr(_ASK) if wanted else "")

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        kind = event.type()
        if watched is not self._window.picture.canvas:
            if kind in (QEvent.Type.Show, QEvent.Type.Hide, QEvent.Type.Resize):
                self._show()
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

    def _listen(self, canvas: QWidget) -> None:
        canvas.installEventFilter(self)

    def _toggle(self, on: bool) -> None:
        settings().setValue(_KEY, on)
        self._show()

    # The mouse.

    def _press(self, event: QMouseEvent) -> bool:
        if event.button() != Qt.MouseButton.LeftButton or event.modifiers() != Qt.KeyboardModifier.NoModifier:
            return False
        if self._asks:
            self.put(event.position())
            return True
        handle = self._handle_at(event.position())
        if handle is None:
            return False
        self._grip = (handle.number - 1, handle.place - event.position())
        self._fields.choose(handle.number - 1)
        self._state.history.begin()
        self._show_cursor()
        self._say()
        return True

    def _move(self, event: QMouseEvent) -> bool:
        if self._grip is None:
            if event.buttons() == Qt.MouseButton.NoButton:
                over = self._handle_at(event.position()) is not None
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
        lamps = self._state.view.lamps
        if index < len(lamps):
            self._replace(index, turned_to(lamps[index], map_direction(place, self._axes())))
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
            self._state.history.end()
            self.layer.show_words("")
            self._show_cursor()

    def put(self, place: QPointF) -> None:
        """Put the chosen lamp, or a new one, where it is mirrored at a place of the canvas, logical pixels."""
        hit = self._seen.hit_at(place)
        if hit is None:
            return  # what is asked stays in sight
        eye, _ = self._seen.ray_at(place)
        to_eye = (eye - hit.position) / np.linalg.norm(eye - hit.position)
        lamps = self._state.view.lamps
        index = min(max(0, self._fields.list.currentIndex()), len(lamps))
        lamp = lamps[index] if index < len(lamps) else NEW_LAMP
        moved = lamp_for_highlight(lamp, hit.position, hit.normal, to_eye)
        self._state.step_view(lamps=(*lamps[:index], moved, *lamps[index + 1 :]))
        self.ask(False)

    def _replace(self, index: int, lamp: Lamp) -> None:
        lamps = self._state.view.lamps
        self._state.change_view(lamps=(*lamps[:index], lamp, *lamps[index + 1 :]))

    # What is shown.

    def _view_changed(self, old: View, new: View) -> None:
        self._show()
        held = QGuiApplication.mouseButtons() != Qt.MouseButton.NoButton
        if old.rotation_deg != new.rotation_deg and held and self._grip is None and not self._asks:
            self.layer.show_words(decimal(tr(_TURNED).format(angle=new.rotation_deg).replace("-", "−")))
            self._turned.start()

    def _end_turned(self) -> None:
        if self._grip is None and not self._asks:
            self.layer.show_words("")

    def _axes(self) -> Floats:
        return axes(self._state.view.camera)

    def _handle_at(self, place: QPointF) -> LampHandle | None:
        """Return the handle under a place of the canvas, the chosen one first."""
        if not self.layer.isVisible():
            return None
        for handle in sorted(self.layer.handles, key=lambda handle: not handle.chosen):
            away = handle.place - place
            if np.hypot(away.x(), away.y()) <= _GRIP:
                return handle
        return None

    def _show(self) -> None:
        lamps = self._state.view.lamps
        wanted = (
            self.shown.isChecked()
            and self._window.panel.pages["light"].isVisible()
            and self._state.surface is not None
        )
        box, canvas = self._seen.boxes[0], self._window.picture.canvas
        width, height = box.width() * canvas.width(), canvas.height()
        centre, reach = QPointF(0.5 * width, 0.5 * height), _SHARE * min(width, height)
        handles = []
        for number, lamp in enumerate(lamps if wanted else (), 1):
            right, up = map_place(direction_of(lamp), self._axes())
            place = centre + QPointF(float(right), -float(up)) * reach
            chosen = number - 1 == self._fields.list.currentIndex()
            behind = bool(np.hypot(right, up) > 1.0)
            handles.append(LampHandle(number, place, _colour(lamp), behind, chosen))
        self.layer.show_handles(tuple(handles), centre, reach)

    def _say(self) -> None:
        assert self._grip is not None
        index = self._grip[0]
        azimuth, elevation, _ = polar(self._state.view.lamps[index])
        words = tr(_WHERE).format(number=index + 1, azimuth=azimuth, elevation=elevation)
        self.layer.show_words(decimal(words.replace("-", "−")), dragged=True)

    def _show_cursor(self) -> None:
        canvas = self._window.picture.canvas
        if self._asks:
            canvas.setCursor(Qt.CursorShape.CrossCursor)
        elif self._grip is not None:
            canvas.setCursor(Qt.CursorShape.ClosedHandCursor)
        elif self._over:
            canvas.setCursor(Qt.CursorShape.OpenHandCursor)
        else:
            canvas.unsetCursor()


def _colour(lamp: Lamp) -> QColor:
    """Return the colour of a lamp's light on the screen, as bright as it gets there."""
    light = lamp_colour(lamp.temperature_k)
    red, green, blue = (float(v) for v in np.clip(working_to_display(light / light.max()), 0.0, 1.0))
    return QColor.fromRgbF(red, green, blue)
