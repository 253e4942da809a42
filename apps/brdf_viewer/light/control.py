"""The lighting section: presets, the lamps' colour, lamps beside the environment, and the exposure's meter."""

from __future__ import annotations

import dataclasses
from pathlib import Path

from brdf_qt.gl.aiming import placed, polar_of
from brdf_qt.program.translation import decimal, tr
from brdf_qt.work.timer import make_timer

from brdf_suite.documents.view import View
from brdf_suite.pipeline.exposure import exposed
from brdf_suite.pipeline.scene import environment_names
from brdf_viewer.camera.section import signed_deg
from brdf_viewer.camera.turntable import Turntable
from brdf_viewer.feature import ViewerFeature
from brdf_viewer.light.section import preset_of, with_preset
from brdf_viewer.paint.relit import RelitPaint
from brdf_viewer.scene.viewer_state import ViewerState
from brdf_viewer.window import ViewerWindow

METER_AFTER_MS = 150
"""The meter waits for things to come to rest: an exposure that follows every step of a drag would pump."""

_UNMETERED = (
    "exposure_ev",
    "tone_curve",
    "glare",
    "background",
    "background_colour",
    "clipping_marks",
    "gamut_marks",
)


class LightingControl(ViewerFeature):
    """Puts the section's edits into the view, and measures the exposure where it is automatic."""

    def __init__(self, state: ViewerState, window: ViewerWindow) -> None:
        super().__init__(state, window)
        self._meter = make_timer(self, self._measure, METER_AFTER_MS)
        self._round = Turntable(state.history, tr("Move Lamps"), 45.0, self)
        self._round.turned.connect(self._move_lamps)
        self._relit = RelitPaint(state, self)
        self._relit.state_changed.connect(self._show_colour)
        self._second_relit = RelitPaint(state, self, second=True)
        section = window.lighting
        self._round.running_changed.connect(section.lamps.moving.setChecked)
        section.preset_chosen.connect(self.choose)
        for field, signal in (
            ("illuminant", section.illuminant.picked),
            ("adapted", section.adapted.clicked),
            ("brightness", section.brightness.edited),
        ):
            signal.connect(lambda value, field=field: state.change_part("light_colour", **{field: value}))
        section.exposure_mode.picked.connect(self.set_exposure_mode)
        section.lamps.edited.connect(lambda lamps: state.change_view(lamps=lamps))
        section.lamps.shading.picked.connect(lambda key: state.change_view(lamp_shading=key))
        section.lamps.moving.clicked.connect(self._round.set_running)
        state.view_changed.connect(self._changed)
        state.contents_changed.connect(self._contents_changed)
        self._show(state.view)

    def choose(self, key: str) -> None:
        self._state.set_view(with_preset(self._state.view, key))

    def close(self) -> None:
        self._relit.close()
        self._second_relit.close()

    def set_exposure_mode(self, mode: str) -> None:
        """Lock the exposure as it is, or have it measured from now on."""
        view = self._state.view
        if mode == view.exposure_mode:
            return
        if mode == "locked":
            self._state.set_view(exposed(view, self._state.metered_ev))  # the picture stays as it is
        else:
            self._state.metered_ev = None
            self._state.change_view(exposure_mode="automatic", exposure_ev=0.0)

    def _move_lamps(self, degrees: float) -> None:
        moved = []
        for lamp in self._state.view.lamps:
            azimuth, elevation, distance = polar_of(lamp)
            moved.append(placed(lamp, signed_deg(azimuth + degrees), elevation, distance))
        if moved:
            self._state.follow_view(lamps=tuple(moved))
        else:
            self._round.set_running(False)

    def _changed(self, old: View, new: View) -> None:
        self._show(new)
        if new.exposure_mode == "automatic" and metered_part(old) != metered_part(new):
            self._meter.start()

    def _show_colour(self) -> None:
        self._window.lighting.show_colour(self._state.view.light_colour, self._relit.state)

    def _show_preset(self) -> None:
        """A light that is edited is none of the presets, whatever the view goes on to name."""
        view, present = self._state.view, self._state.environment
        # A view can name a shipped light or a file, not one that is edited and in no file yet.
        named = present is None or present.key in environment_names() or Path(present.key).is_absolute()
        self._window.lighting.show_preset(preset_of(view) if named else "")

    def _contents_changed(self) -> None:
        self._show_preset()
        self._show_colour()
        if self._state.view.exposure_mode == "automatic":
            self._meter.start()

    def _measure(self) -> None:
        drawer = self._window.drawer
        if drawer is not None and self._state.view.exposure_mode == "automatic":
            picture = self._window.picture
            picture.with_context(lambda: drawer.meter(self._state.view, picture.device_size))
            self._show_exposure(self._state.view)

    def _show(self, view: View) -> None:
        section = self._window.lighting
        self._show_preset()
        self._show_colour()
        section.exposure_mode.show_choice(view.exposure_mode)
        section.lamps.set_lamps(view.lamps)
        section.lamps.shading.show_choice(view.lamp_shading)
        self._show_exposure(view)

    def _show_exposure(self, view: View) -> None:
        text, tip = decimal(f"{view.exposure_ev:+.1f} EV"), tr("Exposure, locked")
        if view.exposure_mode == "automatic":
            total = exposed(view, self._state.metered_ev).exposure_ev
            text = tr("{total:+.1f} EV automatic").format(total=total)
            tip = tr("Exposure: automatic value plus {value:+.1f} EV").format(value=view.exposure_ev)
        self._window.status.cell("exposure").set(text, tip)


def metered_part(view: View) -> View:
    """Return the view without what the meter does not look at."""
    return dataclasses.replace(view, **{name: getattr(_PLAIN, name) for name in _UNMETERED})


_PLAIN = View()
