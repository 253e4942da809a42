"""The picture follows the paint: drawn once the numbers are there, and never in their way."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from brdf_qt.gl.gestures import CameraGestures
from brdf_qt.program.feature import Feature
from brdf_qt.program.names import title_of
from brdf_qt.program.translation import mark, tr
from brdf_qt.window.message_bar import message_of
from brdf_qt.window.view_titles import PRESETS
from brdf_qt.work.tasks import TaskRunner
from brdf_qt.work.timer import make_timer
from PySide6.QtCore import QObject, QTimer, Signal
from PySide6.QtWidgets import QWidget

from brdf_designer.picture.contents import PictureContents, remember
from brdf_designer.picture.pace import PicturePace
from brdf_designer.picture.pages import ViewPages
from brdf_designer.picture.panel import PicturePanel
from brdf_designer.picture.three_lights import LightPane, ThreeLights
from brdf_designer.session.paint_session import PaintSession
from brdf_designer.window.window import DesignerWindow
from brdf_suite.documents.view import Camera, View
from brdf_suite.realtime.camera import Bounds, dolly_to, orbit, pan, resolve

if TYPE_CHECKING:
    from brdf_qt.gl.surface import GlSurface

    from brdf_designer.picture.drawer import PictureDrawer
    from brdf_designer.picture.lamps import PictureLamps
    from brdf_designer.picture.scene import PictureScene
    from brdf_suite.pipeline.lobe_fit import LobeFit
    from brdf_suite.pipeline.scene import PreparedEnvironment
    from brdf_suite.surface.mesh import Mesh
    from brdf_suite.surface.occlusion.rays import BakedMesh

_PREPARE_MS = 500
"""After the first picture, when the window is there: what edits need is compiled then."""
_MOVED_MS = 250
"""After the last step of a movement of camera or light the picture is drawn whole."""
_CLOSING_MS = 60_000
_LIGHT, _FORM, _BAKED = "environment", "surface", "occlusion"
_WORK = {
    _LIGHT: mark("Preparing the light: {name}"),
    _FORM: mark("Loading the form: {name}"),
    _BAKED: mark("Preparing the ground and shadows of the form"),
}


class PictureControl(Feature, QObject):
    """Loads light and form on threads, hands each fit over, and moves camera and light.

    ``view_changed(old, new)``: another :class:`View` is shown.
    """

    view_changed = Signal(object, object)

    def __init__(self, session: PaintSession, window: DesignerWindow) -> None:
        super().__init__(window)
        self._session, self._window = session, window
        self._tasks = TaskRunner(self, threads=2)
        self._loader: PictureScene | None = None
        self._contents = PictureContents()
        self._drawer: PictureDrawer | None = None
        self._pending: dict[str, str] = {}
        """What is being made, and for which light or form."""
        self._plan: list[tuple[int, bool]] = []
        self._whole = False
        self._asked: View | None = None
        """A view to be shown that came before there was a picture."""
        self.lamps: PictureLamps | None = None
        self.view = View()
        self.pace = PicturePace()
        self.panel = PicturePanel(self._new_surface)
        self.pages = ViewPages(self)
        self.lights = ThreeLights(self._make_pane, self._show_panes)
        self._add_pages()
        window.stage.set_picture(self.panel)
        self._add_three_lights()
        self._drawing = make_timer(self, self._draw)
        self._resting = make_timer(self, self._rest, _MOVED_MS)
        surface = self.panel.surface
        if surface is not None:
            surface.frame_drawn.connect(self._time)
            surface.about_to_grab.connect(self._draw_whole)
            surface.canvas_changed.connect(self._listen)
            self._listen(surface.canvas)
            session.fit_changed.connect(self._take)
            session.preview_changed.connect(self._take_preview)
            window.first_painted.connect(self._load_first)
        session.fit_changed.connect(lambda _fit: self.panel.show_state(stale=False))
        session.refused.connect(lambda _error: self.panel.show_state(stale=True))

    def close(self) -> None:
        """End the loading and free the picture."""
        if self._loader is not None:
            self._loader.stop()
            remember(self.view)
        self.lights.close()
        self._tasks.stop(_CLOSING_MS)
        self._drawing.stop()
        self._resting.stop()
        if self.panel.surface is not None:
            self.panel.surface.release()

    @property
    def drawn(self) -> LobeFit | None:
        """The fit of the last frame; ``None`` before there is one."""
        return None if self._drawer is None else self._drawer.drawn

    @property
    def is_idle(self) -> bool:
        """Whether the picture is of the newest fit and whole; also where there is no picture, and none to come."""
        surface = self.panel.surface
        if surface is None or surface.failure or not self.panel.isVisible():
            return True
        settled = not self._drawing.isActive() and not self._resting.isActive() and not self._plan
        shown = self._drawer is not None and self._drawer.shows(self._contents)
        return settled and shown and not self._pending and self._whole and self.lights.is_idle

    def choose_light(self, name: str) -> None:
        """Show the paint in another light; the old picture stays until it is there."""
        self._load(_LIGHT, name)

    def choose_form(self, name: str) -> None:
        """Show the paint on another form; the old picture stays until it is there."""
        self._load(_FORM, name)

    @property
    def has_scene(self) -> bool:
        """Whether there is a picture, whose scene the user may have changed."""
        return self._loader is not None

    def take_view(self, view: View) -> None:
        """Show camera, light and form of a view; the old picture stays until they are there."""
        self._asked = view
        if self._loader is not None:
            self._show(view)
            self._load(_FORM, view.surface)
            self._load(_LIGHT, view.environment)

    # The scene.

    def _load_first(self) -> None:
        # Deferred, as what it brings is not needed for the window.
        from brdf_designer.picture.scene import PictureScene

        loader = self._loader = PictureScene(self._tasks, self)
        loader.loaded.connect(self._loaded)
        loader.partly_loaded.connect(self._take_light)
        loader.failed.connect(lambda kind, _key, error: self._report(kind, error))
        loader.moved.connect(self._moved)
        loader.ended.connect(self._ended)
        self._three_lights.setEnabled(True)
        self._show(self._asked or loader.first)
        self._add_lamps()
        self._load(_FORM, self.view.surface)
        self._load(_LIGHT, self.view.environment)

    def _load(self, kind: str, name: str) -> None:
        if self._loader is None:
            return
        self._window.dismiss_message("picture")
        self._pending[kind] = name
        look = self.view.surface_look
        self._loader.load(kind, name, look=look, basis=self._session.fitting.basis)

    def _loaded(self, kind: str, name: str, value: object) -> None:
        # By kind and not by class: their modules are not imported for the window.
        if kind == _LIGHT:
            self._take_light(name, value)  # type: ignore[arg-type]
        else:
            self._take_form(name, value)  # type: ignore[arg-type]

    def _take_light(self, name: str, light: PreparedEnvironment) -> None:
        self._contents.light = light
        assert self._loader is not None
        self._show(self._loader.in_light(self.view, name))
        self._draw_later()

    def _take_form(self, name: str, form: Mesh) -> None:
        self._contents.form, self._contents.baked = form, None
        camera = self.view.camera
        if name != self.view.surface:
            camera = dataclasses.replace(camera, distance=None, target=None)
        self._show(dataclasses.replace(self.view, surface=name, camera=camera))
        self._bake()
        self._draw_later()

    def _bake(self) -> None:
        """Work out what the ground and the form's own shadows need, where the view shows them and it is not there."""
        form, loader = self._contents.form, self._loader
        if form is None or loader is None or self._contents.baked is not None:
            return
        if not loader.wants_baking(self.view.surface_look):
            return
        self._pending[_BAKED] = self.view.surface
        self._tasks.submit(
            _BAKED,
            loader.bake,
            form,
            lambda baked: self._take_baked(form, baked),
            lambda error: self._report(_BAKED, error),
            lambda fraction, what: self._moved(_BAKED, fraction, what),
        )

    def _take_baked(self, form: Mesh, baked: BakedMesh) -> None:
        self._ended(_BAKED)
        if form is self._contents.form:
            self._contents.baked = baked
            self._draw_later()

    def _moved(self, kind: str, fraction: float, _what: str) -> None:
        name = title_of(self._pending.get(kind, ""))
        self._window.progress.set_job(kind, fraction, tr(_WORK[kind]).format(name=name))

    def _ended(self, kind: str) -> None:
        self._pending.pop(kind, None)
        self._window.progress.end_job(kind)

    def _report(self, kind: str, error: Exception) -> None:
        self._ended(kind)
        self.pages.show_view(self.view)
        self._window.show_message(message_of(error, "picture", todo=tr("The picture is unchanged.")))

    # The paint.

    def _take(self, fit: LobeFit) -> None:
        self._contents.fit = fit
        self._draw_later()

    def _take_preview(self, fit: LobeFit | None) -> None:
        shown = fit or self._session.fit
        if shown is not None:
            self._take(shown)

    def _draw_later(self) -> None:
        """Plan the picture anew: while the hand moves, a slow one waits, and shows the newest when it rests."""
        # The first picture is for nothing but to be there soon: no coarser one before it.
        self._plan = list(self.pace.after_change()) if self.drawn is not None else [(0, False)]
        self._drawing.start(self._plan[0][0])

    def _draw(self) -> None:
        waited, coarse = self._plan.pop(0)
        surface = self.panel.surface
        if surface is None or not self.panel.isVisible():
            return
        if self._drawer is not None:
            if coarse:
                self._drawer.pace.move()
            else:
                self._drawer.pace.rest()
        surface.set_view(self.view)
        self._follow(coarse=coarse)
        if self._plan:
            self._drawing.start(self._plan[0][0] - waited)

    def _draw_whole(self) -> None:
        if self._drawer is not None:
            self._drawer.pace.rest()

    def _prepare_edits(self) -> None:
        drawer, surface = self._drawer, self.panel.surface
        if drawer is not None and surface is not None and not drawer.prepared:
            surface.with_context(drawer.prepare_edits)

    def _time(self, milliseconds: float, typical: bool) -> None:
        drawer = self._drawer
        if drawer is None or drawer.drawn is None:
            return
        if not drawer.prepared:
            QTimer.singleShot(_PREPARE_MS, self, self._prepare_edits)
        self._whole = drawer.is_whole
        if typical and self._whole:
            self.pace.note(milliseconds)
        if typical:
            drawer.pace.end_frame(milliseconds)

    def _new_surface(self) -> GlSurface:
        return self._surface_of(self._contents, self._take_drawer, self._draw_later)

    def _surface_of(
        self, contents: PictureContents, made: Callable[[PictureDrawer], None], better: Callable[[], None]
    ) -> GlSurface:
        # Deferred: it brings moderngl, which only a screen with OpenGL needs.
        from brdf_designer.picture.surface import make_surface

        return make_surface(contents, lambda: self.panel.grey(), made, better)

    def _add_lamps(self) -> None:
        # Deferred with the scene, whose lamps they are.
        from brdf_designer.picture.lamps import PictureLamps

        surface = self.panel.surface
        if surface is not None:
            page = self._window.panel.pages["light"]
            self.lamps = PictureLamps(
                self,
                self.view_changed,
                surface,
                page,
                lambda: self._contents.form,
                lambda: self._bounds_and_size()[0],
            )

    def _take_drawer(self, drawer: PictureDrawer) -> None:
        self._drawer = drawer

    # Three lights.

    def _add_three_lights(self) -> None:
        action = self._three_lights = self._window.add_command(
            "view",
            mark("Three L&ights"),
            "three_lights",
            self._set_three_lights,
            "three_lights",
            icon="sun-horizon",
            tip=mark("The paint in three lights at once: studio, street and sun"),
            checked=False,
        )
        action.setEnabled(False)  # until there is a picture
        self._window.stage.add_button(tr("Three Lights"), action)

    def _set_three_lights(self, on: bool) -> None:
        self.lights.set_on(on)
        self._draw_later()

    def _make_pane(self) -> LightPane:
        assert self._loader is not None
        pane = LightPane(self._surface_of, self._loader)
        pane.canvas_made.connect(self._listen)
        self._listen(pane.surface.canvas)
        job = f"{_LIGHT} {id(pane)}"
        text = tr(_WORK[_LIGHT])
        pane.moved.connect(
            lambda share, name: self._window.progress.set_job(job, share, text.format(name=title_of(name)))
        )
        pane.ended.connect(lambda: self._window.progress.end_job(job))
        pane.failed.connect(lambda error: self._report(_LIGHT, error))
        return pane

    def _show_panes(self, panes: tuple[LightPane, ...]) -> None:
        self.panel.show_beside(panes, self.view.environment)

    def _follow(self, *, coarse: bool) -> None:
        self.lights.follow(self.view, self._contents, self._session.fitting.basis, coarse=coarse)

    # The view: by the tabs Light and Form, and by hand.

    def _add_pages(self) -> None:
        pages, window = self.pages, self._window
        window.add_section("light", tr("Light"), pages.light, tab="light")
        window.add_section("light_more", tr("Rendering"), pages.light_more, tab="light", more=True)
        window.add_section("form", tr("Form"), pages.form, tab="form")
        window.add_section("form_more", tr("Camera and shadows"), pages.form_more, tab="form", more=True)
        pages.light_chosen.connect(self.choose_light)
        pages.form_chosen.connect(self.choose_form)
        pages.edited.connect(lambda field, value: self.move(dataclasses.replace(self.view, **{field: value})))
        pages.look_edited.connect(lambda field, value: self._edit_look({field: value}))
        pages.place_chosen.connect(self._look_from)
        pages.framed.connect(lambda: self._set_camera(Camera(focal_length_mm=self._lens)))
        pages.lens_edited.connect(
            lambda mm: self._set_camera(
                dataclasses.replace(self.view.camera, focal_length_mm=mm, distance=None)
            )
        )
        usable = self.panel.surface is not None
        for widget in (pages.light, pages.light_more, pages.form, pages.form_more):
            widget.setEnabled(usable)

    @property
    def _lens(self) -> float:
        return self.view.camera.focal_length_mm

    def _edit_look(self, change: dict[str, Any]) -> None:
        look = dataclasses.replace(self.view.surface_look, **change)
        self.move(dataclasses.replace(self.view, surface_look=look))
        self._bake()

    def _look_from(self, preset: str) -> None:
        _title, azimuth, elevation = PRESETS[preset]
        self._set_camera(Camera(azimuth_deg=azimuth, elevation_deg=elevation, focal_length_mm=self._lens))

    def _show(self, view: View) -> None:
        """Take a view and show it in the tabs."""
        old, self.view = self.view, view
        self.pages.show_view(view)
        self.panel.show_light(view.environment)
        self.view_changed.emit(old, view)

    def move(self, view: View) -> None:
        """Draw another view at once, coarser where a whole frame takes long, and whole when the hand rests."""
        self._show(view)
        surface = self.panel.surface
        if surface is None or self._drawer is None:
            return
        self._drawer.pace.move()
        surface.set_view(view)
        self._follow(coarse=True)
        self._resting.start()

    def _rest(self) -> None:
        self.lights.rest()
        surface = self.panel.surface
        if surface is not None and self._drawer is not None and self._drawer.pace.rest():
            surface.redraw()

    def _listen(self, canvas: QWidget) -> None:
        canvas.setAccessibleName(tr("The paint on the form"))
        gestures = CameraGestures(canvas)
        gestures.orbited.connect(self._orbit)
        gestures.panned.connect(self._pan)
        gestures.zoomed.connect(self._zoom)
        gestures.light_turned.connect(self._turn_light)
        gestures.framed.connect(lambda: self._set_camera(Camera(focal_length_mm=self._lens)))

    def _set_camera(self, camera: Camera) -> None:
        self.move(dataclasses.replace(self.view, camera=camera))

    def _orbit(self, azimuth_deg: float, elevation_deg: float) -> None:
        bounds, size = self._bounds_and_size()
        if bounds is not None:
            settled = resolve(self.view.camera, bounds, size)
            self._set_camera(orbit(settled, azimuth_deg, elevation_deg))

    def _pan(self, right: float, up: float) -> None:
        bounds, size = self._bounds_and_size()
        if bounds is not None:
            self._set_camera(pan(self.view.camera, bounds, size, right * size[1], -up * size[1]))

    def _zoom(self, factor: float, right: float, up: float) -> None:
        bounds, size = self._bounds_and_size()
        if bounds is not None:
            self._set_camera(dolly_to(self.view.camera, bounds, size, factor, (right, up)))

    def _turn_light(self, degrees: float) -> None:
        turned = (self.view.rotation_deg + degrees + 180.0) % 360.0 - 180.0
        self.move(dataclasses.replace(self.view, rotation_deg=turned))

    def _bounds_and_size(self) -> tuple[Bounds | None, tuple[int, int]]:
        surface = self.panel.surface
        size = (1, 1) if surface is None else surface.device_size
        return (None if self._drawer is None else self._drawer.bounds), size
