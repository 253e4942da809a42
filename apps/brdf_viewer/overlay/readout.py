"""The readout under the cursor, the frame time, and the figures over the picture (H), which have both in full.

The readout is read when hand and picture have come to rest for a moment, never while something is dragged, so it
costs no frame of an interaction.
"""

from __future__ import annotations

from collections import deque
from statistics import median

from brdf_qt.program.settings import settings
from brdf_qt.program.translation import decimal, mark, tr
from brdf_qt.window.status_line import StatusCell
from brdf_qt.window.view_titles import TONE_TITLES
from brdf_qt.work.timer import make_timer
from PySide6.QtCore import QEvent, QObject, QPointF, Qt, Signal
from PySide6.QtGui import QGuiApplication, QMouseEvent
from PySide6.QtWidgets import QWidget

from brdf_suite.documents.view import View
from brdf_viewer.feature import ViewerFeature
from brdf_viewer.light.dominant import dominant_light
from brdf_viewer.overlay.pixel_reading import CursorReading, long_lines, read_pixel, short_words
from brdf_viewer.scene.viewer_state import ViewerState
from brdf_viewer.tracing.trace_input import first_size
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
        text, tip = "", None
        if reading is not None:
            light = tr("no dominant light source") if reading.light is None else reading.light.words
            text, tip = short_words(reading), "\n".join((tr(_TIP).format(light=light), *self.lines))
        self._window.status.cell("readout", right=True).set(text, tip)
        self.changed.emit(reading)


_KEY = "figures"
_FRAMES = 15
_SHOW_EVERY_MS = 250
SPARKLE_WORDS = {"off": mark("no sparkle"), "texture": mark("flake texture"), "glints": mark("glints")}
FRESNEL_WORDS = {
    "off": mark("no Fresnel"),
    "raised": mark("Fresnel raised"),
    "multi_angle": mark("Fresnel by angle"),
}


def _rounded(milliseconds: float) -> str:
    """Return milliseconds, below 100 with one decimal."""
    return decimal(f"{milliseconds:.1f}" if milliseconds < 100.0 else f"{milliseconds:.0f}")


class FrameMeter(QObject):
    """Shows the median of the last frames' milliseconds: one that changes with each frame could not be read.

    ``shown()`` is emitted each time that the status bar was renewed.
    """

    shown = Signal()

    def __init__(self, cell: StatusCell, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._cell = cell
        self._frames: deque[float] = deque(maxlen=_FRAMES)
        self._timer = make_timer(self, self._show, _SHOW_EVERY_MS)

    def add(self, milliseconds: float) -> None:
        self._frames.append(milliseconds)
        if not self._timer.isActive():
            self._timer.start()

    def clear(self) -> None:
        """There is no picture: show no time."""
        self._frames.clear()
        self._timer.stop()
        self._cell.set("")

    def _show(self) -> None:
        tip = tr("Frame time: median of the last {count}; slowest {slowest:.1f} ms")
        tip = tip.format(count=len(self._frames), slowest=max(self._frames))
        self._cell.set(tr("Frame {ms} ms").format(ms=_rounded(median(self._frames))), tip)
        self.shown.emit()


class FiguresOverlay(ViewerFeature):
    """Shows and hides the figures; remembers which."""

    def __init__(self, state: ViewerState, window: ViewerWindow, meter: FrameMeter, readout: Readout) -> None:
        super().__init__(state, window)
        self._readout = readout
        self._action = window.commands.figures
        self._action.setChecked(bool(settings().value(_KEY, False, type=bool)))
        self._action.toggled.connect(self._toggle)
        meter.shown.connect(self._show)
        readout.changed.connect(self._show)
        state.view_changed.connect(self._show)
        state.contents_changed.connect(self._show)

    def _toggle(self, on: bool) -> None:
        settings().setValue(_KEY, on)
        self._show()

    def _show(self, *_: object) -> None:
        lines = self._lines() if self._action.isChecked() and self._state.is_complete else []
        self._window.overlay.show_figures(tuple(lines))

    def _lines(self) -> list[str]:
        state, size = self._state, self._window.picture.device_size
        lines = [f"{self._window.status.cell('frame').text() or '–'}   {size[0]} × {size[1]}"]
        if state.fit is not None:
            lines[0] += "   " + tr("{count} lobes").format(count=len(state.fit.weights.exponents))
        return [*lines, how(state.exposed_view), *self._readout.lines]


def how(view: View) -> str:
    """Return in one line how a view is drawn.

    >>> how(View(fresnel="off"))
    'Faithful, soft highlights   +0.0 EV   no Fresnel   glints, 8 lights'
    """
    sparkle = tr(SPARKLE_WORDS[view.sparkle.mode])
    if view.sparkle.mode != "off":
        sparkle = tr("{sparkle}, {count} lights").format(sparkle=sparkle, count=view.sparkle.light_count)
    tone, fresnel = tr(TONE_TITLES[view.tone_curve]), tr(FRESNEL_WORDS[view.fresnel])
    return "   ".join((tone, decimal(f"{view.exposure_ev:+.1f} EV"), fresnel, sparkle))
