"""The readout under the cursor: in the status bar, and in full among the figures over the picture.

It is read when hand and picture have come to rest for a moment, never while something is dragged, so it costs no
frame of an interaction.
"""

from __future__ import annotations

from brdf_qt.program.translation import mark, tr
from brdf_qt.work.timer import make_timer
from PySide6.QtCore import QEvent, QObject, QPointF, Qt, Signal
from PySide6.QtGui import QGuiApplication, QMouseEvent
from PySide6.QtWidgets import QWidget

from brdf_viewer.feature import ViewerFeature
from brdf_viewer.light.dominant import dominant_light
from brdf_viewer.overlay.pixel_reading import CursorReading, long_lines, read_pixel, short_words
from brdf_viewer.scene.viewer_state import ViewerState
from brdf_viewer.traced.trace_input import first_size
from brdf_viewer.window import ViewerWindow

REST_MS = 60
_TIP = mark(
    "The pixel under the cursor. L*a*b*: exposed light before the tone curve, D65 and 10°, a white of radiance 1 has "
    "L* 100. View: angle to the surface's normal. Aspecular: angle from the mirror direction of {light}."
)


class Readout(ViewerFeature):
    """Signals: ``changed(reading)`` with a :class:`CursorReading`, or None where the cursor is elsewhere."""

    changed = Signal(object)

    def __init__(self, state: ViewerState, window: ViewerWindow) -> None:
        super().__init__(state, window)
        self._place: QPointF | None = None
        self.reading: CursorReading | None = None
        self._rest = make_timer(self, self._read, REST_MS)
        window.picture.canvas_changed.connect(self._listen)
        window.picture.frame_drawn.connect(self._later)
        self._listen(window.picture.canvas)

    @property
    def lines(self) -> list[str]:
        """The reading in full, line by line; none where the cursor is elsewhere."""
        return [] if self.reading is None else long_lines(self.reading)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        kind = event.type()
        if kind == QEvent.Type.MouseMove and isinstance(event, QMouseEvent):
            self._place = event.position()
            self._later()
        elif kind in (QEvent.Type.Leave, QEvent.Type.Hide):
            self._place = None
            self._show(None)
        return super().eventFilter(watched, event)

    def _listen(self, canvas: QWidget) -> None:
        canvas.installEventFilter(self)

    def _later(self, *_: object) -> None:
        if self._place is not None:
            self._rest.start()

    def _read(self) -> None:
        drawer, place, state = self._window.drawer, self._place, self._state
        if QGuiApplication.mouseButtons() != Qt.MouseButton.NoButton:
            self._rest.start()
            return
        if drawer is None or place is None or not drawer.is_complete:
            return
        picture = self._window.picture
        size, ratio = picture.device_size, picture.canvas.devicePixelRatioF()
        pixel = (int(place.x() * ratio), int(place.y() * ratio))
        light = dominant_light(state.view, state.light_figures)
        second = None if state.compared is None or state.view.compare.mode == "off" else state.compared.value
        traced = drawer.traced_light(first_size(state.view, size))
        view, shows_second = state.exposed_view, state.shows_second

        def read() -> None:
            reading = read_pixel(
                drawer.probe, view, size, pixel, second, light, shows_second=shows_second, traced=traced
            )
            self._show(reading)

        picture.with_context(read, redraw=False)

    def _show(self, reading: CursorReading | None) -> None:
        if reading == self.reading:
            return
        self.reading = reading
        cell = self._window.status.cell("readout", right=True)
        if reading is None:
            cell.set("")
        else:
            light = tr("no dominant light source") if reading.light is None else reading.light.words
            cell.set(
                short_words(reading), f"{tr(_TIP).format(light=light)}\n" + "\n".join(long_lines(reading))
            )
        self.changed.emit(reading)
