"""The small picture follows the paint: drawn once the numbers are there, and never in their way."""

from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING

from brdf_qt.gl.gestures import CameraGestures
from brdf_qt.program.feature import Feature
from brdf_qt.program.settings import settings
from brdf_qt.program.translation import tr
from brdf_qt.window.message_bar import message_of
from brdf_qt.work.tasks import TaskRunner
from brdf_qt.work.timer import make_timer
from PySide6.QtCore import QObject, QTimer
from PySide6.QtWidgets import QWidget

from brdf_designer.preview.drawer import PreviewContents, PreviewDrawer
from brdf_designer.preview.pace import PreviewPace
from brdf_designer.preview.panel import PreviewPanel
from brdf_designer.preview.scene import LIGHTS, PreviewScene, load_scene
from brdf_designer.session.paint_session import PaintSession
from brdf_designer.window.window import DesignerWindow
from brdf_suite.documents.view import Camera, View
from brdf_suite.realtime.camera import Bounds, dolly_to, orbit, pan, resolve

if TYPE_CHECKING:
    from brdf_qt.gl.surface import GlSurface

    from brdf_suite.pipeline.lobe_fit import LobeFit
    from brdf_suite.realtime.gl.context import Context

_PREPARE_MS = 500
"""After the first picture, when the window is there: what edits need is compiled then."""
_LIGHT, _SHOWN = "preview/light", "preview/shown"


class PreviewControl(Feature, QObject):
    """Loads the scene on a thread, hands each fit over, and moves camera and light."""

    def __init__(self, session: PaintSession, window: DesignerWindow) -> None:
        super().__init__(window)
        self._session, self._window = session, window
        self._tasks = TaskRunner(self, threads=1)
        self._contents = PreviewContents()
        self._drawer: PreviewDrawer | None = None
        self._view = View()
        self._plan: list[tuple[int, bool]] = []
        self.pace = PreviewPace()
        self._asked = ""
        light = settings().value(_LIGHT, LIGHTS[0], type=str)
        self.light = light if light in LIGHTS else LIGHTS[0]
        self.panel = PreviewPanel(self._new_surface)
        self.panel.show_light(self.light)
        self.panel.light_chosen.connect(self.choose_light)
        window.add_preview(self.panel)
        self._drawing = make_timer(self, self._draw)
        self.action = window.add_command(
            "view",
            tr("Previe&w"),
            "preview",
            self.show,
            "preview",
            tip=tr("Show or hide the preview on the speed form"),
            checked=bool(settings().value(_SHOWN, True, type=bool)),
        )
        self.panel.setVisible(self.action.isChecked())
        surface = self.panel.surface
        if surface is not None:
            surface.frame_drawn.connect(self._time)
            surface.canvas_changed.connect(self._listen)
            self._listen(surface.canvas)
            session.fit_changed.connect(self._take)
            window.first_painted.connect(self._load)
        session.fit_changed.connect(lambda _fit: self.panel.show_state(stale=False))
        session.refused.connect(lambda _error: self.panel.show_state(stale=True))

    def close(self) -> None:
        """End the loading and free the picture."""
        self._tasks.stop()
        self._drawing.stop()
        if self.panel.surface is not None:
            self.panel.surface.release()

    @property
    def drawn(self) -> LobeFit | None:
        """The fit of the last frame; ``None`` before there is one."""
        return None if self._drawer is None else self._drawer.drawn

    @property
    def is_idle(self) -> bool:
        """Whether the picture is of the newest fit; also where there is no picture, and none to come."""
        surface = self.panel.surface
        if surface is None or surface.failure or not self.panel.isVisible():
            return True
        settled = not self._drawing.isActive() and not self._plan
        return settled and self._contents.scene is not None and self.drawn is self._contents.fit

    def choose_light(self, name: str) -> None:
        """Show the paint in another light; the old picture stays until it is there."""
        self.light = name
        settings().setValue(_LIGHT, name)
        self.panel.show_light(name)
        self._load()

    def show(self, on: bool) -> None:
        """Show or hide the picture, and remember it."""
        self.action.setChecked(on)
        self.panel.setVisible(on)
        settings().setValue(_SHOWN, on)
        if on:
            self._load()
            self._draw_later()

    # The scene.

    def _load(self) -> None:
        if self.panel.surface is None or not self.action.isChecked() or self._asked == self.light:
            return
        self._asked = self.light
        request = (self.light, self._session.fitting.basis)
        self._tasks.submit("scene", load_scene, request, self._show_scene, self._report_failure)

    def _show_scene(self, scene: PreviewScene) -> None:
        old = self._contents.scene
        if old is not None:
            scene = dataclasses.replace(scene, surface=old.surface, baked=old.baked)
        self._contents.scene = scene
        self._window.dismiss_message("preview")
        first = scene.view
        self._set_view(
            dataclasses.replace(
                first,
                camera=self._view.camera if old is not None else first.camera,
                rotation_deg=self._view.rotation_deg,
            )
        )

    def _report_failure(self, error: Exception) -> None:
        self._asked = ""
        self._window.show_message(message_of(error, "preview", todo=tr("The picture is unchanged.")))

    # The paint.

    def _take(self, fit: LobeFit) -> None:
        self._contents.fit = fit
        self._draw_later()

    def _draw_later(self) -> None:
        """Plan the picture anew: while the hand moves, a slow one waits, and shows the newest when it rests."""
        # The first picture is for nothing but to be there soon: no draft before it.
        self._plan = list(self.pace.after_change()) if self.drawn is not None else [(0, False)]
        self._drawing.start(self._plan[0][0])

    def _draw(self) -> None:
        waited, draft = self._plan.pop(0)
        surface = self.panel.surface
        if surface is None or not self.panel.isVisible():
            return
        if self._drawer is not None:
            self._drawer.draft = draft
        surface.set_view(self._view)
        if self._plan:
            self._drawing.start(self._plan[0][0] - waited)

    def _prepare_edits(self) -> None:
        drawer, surface = self._drawer, self.panel.surface
        if drawer is not None and surface is not None and not drawer.prepared:
            surface.with_context(drawer.prepare_edits)

    def _time(self, milliseconds: float, typical: bool) -> None:
        if self._drawer is not None and self._drawer.drawn is not None and not self._drawer.prepared:
            QTimer.singleShot(_PREPARE_MS, self, self._prepare_edits)
        if typical and self._drawer is not None:
            self.pace.note(milliseconds, draft=self._drawer.draft)

    def _new_surface(self) -> GlSurface:
        # Deferred: the widget brings moderngl, which only a screen with OpenGL needs.
        from brdf_qt.gl.surface import GlSurface

        # The renderer averages its samples by itself, in linear light.
        surface = GlSurface(self._new_drawer, samples=0)
        surface.setMinimumSize(120, 80)
        return surface

    def _new_drawer(self, context: Context) -> PreviewDrawer:
        self._drawer = PreviewDrawer(context, self._contents, self.panel.grey, self._draw_later)
        return self._drawer

    # Camera and light.

    def _listen(self, canvas: QWidget) -> None:
        canvas.setAccessibleName(tr("The paint on the speed form"))
        gestures = CameraGestures(canvas)
        gestures.orbited.connect(self._orbit)
        gestures.panned.connect(self._pan)
        gestures.zoomed.connect(self._zoom)
        gestures.light_turned.connect(self._turn_light)
        gestures.framed.connect(lambda: self._set_camera(Camera()))

    def _set_view(self, view: View) -> None:
        self._view = view
        self._draw_later()

    def _set_camera(self, camera: Camera) -> None:
        self._set_view(dataclasses.replace(self._view, camera=camera))

    def _orbit(self, azimuth_deg: float, elevation_deg: float) -> None:
        bounds, size = self._bounds_and_size()
        if bounds is not None:
            settled = resolve(self._view.camera, bounds, size)
            self._set_camera(orbit(settled, azimuth_deg, elevation_deg))

    def _pan(self, right: float, up: float) -> None:
        bounds, size = self._bounds_and_size()
        if bounds is not None:
            self._set_camera(pan(self._view.camera, bounds, size, right * size[1], -up * size[1]))

    def _zoom(self, factor: float, right: float, up: float) -> None:
        bounds, size = self._bounds_and_size()
        if bounds is not None:
            self._set_camera(dolly_to(self._view.camera, bounds, size, factor, (right, up)))

    def _turn_light(self, degrees: float) -> None:
        turned = (self._view.rotation_deg + degrees + 180.0) % 360.0 - 180.0
        self._set_view(dataclasses.replace(self._view, rotation_deg=turned))

    def _bounds_and_size(self) -> tuple[Bounds | None, tuple[int, int]]:
        surface = self.panel.surface
        size = (1, 1) if surface is None else surface.device_size
        return (None if self._drawer is None else self._drawer.bounds), size
