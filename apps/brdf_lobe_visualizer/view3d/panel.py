"""The part of the window that shows lobes in three dimensions: view, gestures, commands and their sections.

The view takes a quarter of a second to import with pyqtgraph's OpenGL, so it is built after the window's first paint; a
widget of Qt's own holds its place, so that the window is one for OpenGL from the start and is not made again.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from brdf_qt.fields.labels import PlainLabel
from brdf_qt.gl.gestures import CameraGestures
from brdf_qt.program.feature import Feature
from brdf_qt.program.settings import settings
from brdf_qt.program.translation import mark, tr
from brdf_qt.work.timer import make_timer
from PySide6.QtCore import QObject, Qt
from PySide6.QtGui import QGuiApplication, QImage, QPalette
from PySide6.QtOpenGLWidgets import QOpenGLWidget
from PySide6.QtWidgets import QStackedLayout, QWidget

from brdf_lobe_visualizer.incidence.drag import IncidenceDrag
from brdf_lobe_visualizer.incidence.section import IncidenceSection, SweepControl
from brdf_lobe_visualizer.session import LobeSession
from brdf_lobe_visualizer.subjects.parts_section import PartsSection
from brdf_lobe_visualizer.view3d.camera import (
    PRESETS,
    Camera,
    format_camera,
    frame_hemisphere,
    parse_camera,
    preset,
)
from brdf_lobe_visualizer.view3d.save import SaveSurface
from brdf_lobe_visualizer.view3d.section import SpaceState, SurfaceSection
from brdf_lobe_visualizer.window import LobeWindow

if TYPE_CHECKING:
    from brdf_lobe_visualizer.view3d.layers import SceneMaker
    from brdf_lobe_visualizer.view3d.values import SpaceValues
    from brdf_lobe_visualizer.view3d.view import LobeView


_CAMERA_KEY = "lobes/camera"


class Space(Feature, QObject):
    """Lobes in three dimensions."""

    def __init__(self, session: LobeSession, window: LobeWindow) -> None:
        super().__init__(window)
        self.session, self._window = session, window
        self.state = SpaceState(self)
        self.camera = parse_camera(str(settings().value(_CAMERA_KEY, "")))
        self.view: LobeView | None = None
        self.values: SpaceValues | None = None
        self._maker: SceneMaker | None = None
        self._holder = _Holder()
        self.sweep = SweepControl(session, self.state, self)
        self.incidence = IncidenceSection(session, self.state, self.sweep)
        self.surface = SurfaceSection(session, self.state)
        self.parts = PartsSection(session, self.state)
        self._timer = make_timer(self, self.draw_now)
        # Numbers that follow the picture wait until it rests: setting one costs as much as a surface's colours.
        self._full = 0.0
        self._settle = make_timer(self, lambda: self.surface.hold(self._full), 150)
        window.set_centre(self._holder, tab_hides_panels=True)
        for signal in session.changes:
            signal.connect(self._stale)
        self.state.changed.connect(self._stale)
        session.view_reset.connect(self.reset_view)
        window.add_section("incidence", tr("Incidence"), self.incidence)
        window.add_section("radius", tr("Radius"), self.surface)
        window.add_section("parts", tr("Parts"), self.parts)
        self.save = SaveSurface(self.draw_now, lambda: self.view, session, window)
        self._add_commands()
        window.first_painted.connect(self._build)

    @property
    def is_idle(self) -> bool:
        """Whether all that is asked for is drawn, or cannot be."""
        if self._holder.notice.text():
            return True
        return self.view is not None and not self._timer.isActive() and not (self.values and self.values.busy)

    def run_script(self, key: str, value: str) -> bool:
        """Take an option that a script sets: one of ``SpaceOptions`` by name, or ``camera`` by a preset's name."""
        if key != "camera":
            return self.state.set_from_text(key, value)
        if value in dict(PRESETS):
            self.go_to(value)
        return value in dict(PRESETS)

    def set_camera(self, camera: Camera) -> None:
        self.camera = camera
        if self.view is not None:
            self.view.set_camera(camera)

    def go_to(self, key: str) -> None:
        self.set_camera(preset(key, *self.session.incidence))

    def frame(self) -> None:
        self.set_camera(frame_hemisphere(self.camera))

    def close(self) -> None:
        self.sweep.set_running(False)
        self._timer.stop()
        self._settle.stop()
        settings().setValue(_CAMERA_KEY, format_camera(self.camera))

    def reset_view(self) -> None:
        self.sweep.set_running(False)
        self.state.reset()
        self.set_camera(Camera())

    def draw_now(self) -> None:
        self._timer.stop()
        if self.view is not None and self._maker is not None:
            scene = self._maker.scene(self.state.options)
            self.view.set_scene(scene)
            self._full = scene.scale.full
            self._settle.start()

    def picture(self, width: int, height: int) -> QImage:
        return QImage() if self.view is None else self.view.picture(width, height)

    def _stale(self, *_: object) -> None:
        self._timer.start()

    def _build(self) -> None:
        if self.view is not None:
            return
        if QGuiApplication.platformName() in ("offscreen", "minimal"):
            self._holder.show_notice(tr("OpenGL is not available, so the lobes cannot be drawn."))
            return
        # With the view comes pyqtgraph's OpenGL: a quarter of a second of the processor's time.
        from brdf_lobe_visualizer.view3d import layers, values
        from brdf_lobe_visualizer.view3d.view import LobeView, SpaceProbe

        self.values = values.SpaceValues(self.session, self._stale)
        self._maker = layers.SceneMaker(self.session, self.values)
        self.view = view = LobeView()
        view.set_camera(self.camera)
        failure = tr("The lobes cannot be drawn: {reason}")
        view.failed.connect(lambda reason: self._holder.show_notice(failure.format(reason=reason)))
        gestures = CameraGestures(view)
        gestures.orbited.connect(lambda a, e: self.set_camera(self.camera.orbit(a, e)))
        gestures.panned.connect(lambda r, u: self.set_camera(self.camera.pan(r, u)))
        gestures.zoomed.connect(lambda f, r, u: self.set_camera(self.camera.zoom(f, r, u)))
        gestures.framed.connect(self.frame)
        drag = IncidenceDrag(view)
        drag.dragged.connect(self.session.set_incidence)
        drag.turned.connect(
            lambda theta, phi: self.session.set_incidence(
                self.session.incidence[0] + theta, self.session.incidence[1] + phi
            )
        )
        drag.reset.connect(self.session.reset_incidence)
        SpaceProbe(view)
        self._holder.show_view(view)
        self.draw_now()

    def _add_commands(self) -> None:
        add = self._window.add_command
        for number, (key, title) in enumerate(PRESETS, 1):
            add("view", title, f"preset_{number}", lambda key=key: self.go_to(key))
        add("view", mark("Frame the Hemisphere"), None, self.frame)
        sweep = add("view", mark("Sweep the Incidence"), "play", self.sweep.set_running, checked=False)
        self.sweep.running_changed.connect(sweep.setChecked)
        # In the view alone: elsewhere the space bar presses buttons.
        sweep.setShortcutContext(Qt.ShortcutContext.WidgetWithChildrenShortcut)
        self._holder.addAction(sweep)


class _Holder(QWidget):
    """The view, or what is in its place: an empty widget until it is built, words where it cannot be."""

    def __init__(self) -> None:
        super().__init__()
        self.setMinimumSize(200, 160)
        self.notice = PlainLabel(wordWrap=True, alignment=Qt.AlignmentFlag.AlignCenter)
        self.notice.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.notice.setMargin(32)
        self._layout = QStackedLayout(self)
        self._layout.addWidget(self.notice)
        if QGuiApplication.platformName() not in ("offscreen", "minimal"):
            self._layout.addWidget(_Ground())
            self._layout.setCurrentIndex(1)

    def show_view(self, view: QWidget) -> None:
        self._layout.addWidget(view)
        self._layout.setCurrentWidget(view)
        self.setFocusProxy(view)
        ground = self._layout.widget(1)
        if ground is not None and ground is not view:
            self._layout.removeWidget(ground)
            ground.deleteLater()

    def show_notice(self, text: str) -> None:
        self.notice.setText(text)
        self._layout.setCurrentWidget(self.notice)


class _Ground(QOpenGLWidget):
    """An empty ground in the theme's colour."""

    def paintGL(self) -> None:
        colour = self.palette().color(QPalette.ColorRole.Base)
        functions = self.context().functions()
        functions.glClearColor(colour.redF(), colour.greenF(), colour.blueF(), 1.0)
        functions.glClear(0x4000)  # GL_COLOR_BUFFER_BIT
