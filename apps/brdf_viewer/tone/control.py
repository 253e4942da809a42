"""The tone section: curve, marks, the count of what the screen cannot show, and the monitor's profile."""

from __future__ import annotations

from brdf_qt.fields.choices import set_note
from brdf_qt.program.monitor_profile import Monitor, monitor_of
from brdf_qt.program.settings import settings
from brdf_qt.program.translation import tr
from brdf_qt.work.timer import make_timer
from PySide6.QtCore import QEvent, QObject, QTimer
from PySide6.QtGui import QImage

from brdf_suite.appearance.colour.spaces import SRGB_SPACE
from brdf_suite.documents.view import View
from brdf_suite.realtime.pictures.display import SRGB, Display, Unshowable
from brdf_viewer.feature import ViewerFeature
from brdf_viewer.scene.viewer_state import ViewerState
from brdf_viewer.tone.section import describe_clipping
from brdf_viewer.window import ViewerWindow

COUNT_AFTER_MS = 300
"""Counting draws a picture of its own, so it waits until things have come to rest."""

_COUNTED_WIDTH = 480
_PROFILE_KEY = "tone/monitor_profile"


class ToneControl(ViewerFeature):
    """Puts the section's edits into the view, and the monitor's colours into the renderer."""

    def __init__(self, state: ViewerState, window: ViewerWindow) -> None:
        super().__init__(state, window)
        self._monitor = Monitor(SRGB_SPACE, "", False)
        self._used = bool(settings().value(_PROFILE_KEY, True, type=bool))
        self._marked_by_curve = False
        self.display: Display = SRGB
        self.counted: Unshowable | None = None
        self._count = make_timer(self, self._measure, COUNT_AFTER_MS)
        section = window.tone
        for box in (section.curve, window.commands.tone):
            box.picked.connect(self._set_curve)
        section.glare.clicked.connect(lambda on: state.change_view(glare="eye" if on else "off"))
        section.clipping.clicked.connect(lambda on: state.change_view(clipping_marks=on))
        section.gamut.clicked.connect(lambda on: state.change_view(gamut_marks=on))
        section.style_box.picked.connect(lambda key: state.change_view(mark_style=key))
        section.profile.clicked.connect(self._use_profile)
        section.seen.connect(self._count.start)
        state.view_changed.connect(self._changed)
        state.contents_changed.connect(self._count.start)
        state.traced_changed.connect(self._count.start)
        window.picture.frame_drawn.connect(self._first_frame)
        window.installEventFilter(self)
        self._show(state.view)

    def _set_curve(self, key: str) -> None:
        """Take a tone curve; the linear one comes with its clipping marked, and takes the marks along."""
        fields: dict[str, object] = {"tone_curve": key}
        if key == "linear" and not self._state.view.clipping_marks:
            fields["clipping_marks"] = self._marked_by_curve = True
        elif key != "linear" and self._marked_by_curve:
            fields["clipping_marks"] = self._marked_by_curve = False
        self._state.change_view(**fields)

    def _use_profile(self, used: bool) -> None:
        """Show the colours by the monitor's profile, or in sRGB; remembered."""
        self._used = used
        settings().setValue(_PROFILE_KEY, used)
        self._show_monitor()

    def _find(self) -> None:
        """Ask again what the window's screen is."""
        self._monitor = monitor_of(self._window)
        self._show_monitor()

    def grab_srgb(self) -> QImage:
        """Return the picture as it is on screen, in sRGB whatever the monitor is."""
        drawer = self._window.drawer
        if drawer is None or self.display is SRGB:
            return self._window.picture.grab_image()
        drawer.renderer.screen = SRGB
        try:
            return self._window.picture.grab_image()
        finally:
            drawer.renderer.screen = self.display

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """The window was shown, or went to another monitor."""
        if event.type() in (QEvent.Type.Show, QEvent.Type.ScreenChangeInternal):
            QTimer.singleShot(0, self, self._find)
        return super().eventFilter(watched, event)

    def _show_monitor(self) -> None:
        monitor = self._monitor
        used = self._used and monitor.is_measured
        space = monitor.space if used else SRGB_SPACE
        if space is not self.display.space:
            self.display = SRGB if space is SRGB_SPACE else Display(space)
            if (drawer := self._window.drawer) is not None:
                drawer.renderer.screen = self.display
                self._window.picture.redraw()
            self._count.start()
        text = monitor.description
        if monitor.is_measured and not used:
            text = tr("sRGB; {profile} is not used").format(profile=text)
        self._window.tone.set_profile(text, monitor.is_measured, used)

    def _changed(self, _old: View, new: View) -> None:
        self._show(new)
        self._count.start()

    def _first_frame(self) -> None:
        if self.counted is None and not self._count.isActive():
            self._count.start()

    def _show(self, view: View) -> None:
        section = self._window.tone
        for box in (section.curve, self._window.commands.tone):
            box.show_choice(view.tone_curve)
        section.glare.setChecked(view.glare == "eye")
        section.set_marks(view.clipping_marks, view.gamut_marks, view.mark_style)

    def _measure(self) -> None:
        drawer, picture = self._window.drawer, self._window.picture
        if drawer is None or not drawer.is_complete or not self._window.tone.isVisible():
            return
        width, height = picture.device_size
        scale = min(1.0, _COUNTED_WIDTH / width)
        size = (max(1, round(width * scale)), max(1, round(height * scale)))

        def count() -> None:
            view, whole = self._state.exposed_view, picture.device_size
            traced = drawer.traced_light(whole)
            if traced is not None:  # its pixels are there, and in no other size
                self.counted = traced.count_unshowable(view, whole, self.display)
            else:
                self.counted = drawer.renderer.count_unshowable(view, size, self.display)

        picture.with_context(count, redraw=False)
        text = "" if self.counted is None else describe_clipping(self.counted)
        set_note(self._window.tone.counted, text)
