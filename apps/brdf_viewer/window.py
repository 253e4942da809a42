"""The Viewer's window: the picture takes it, the inspector is at the right, a slim toolbar above."""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property, partial

from brdf_qt.fields.number import NumberField
from brdf_qt.gl.surface import Drawer, GlSurface
from brdf_qt.program.translation import mark, tr
from brdf_qt.window.main_window import SuiteWindow
from brdf_qt.work.timer import make_timer
from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QCloseEvent, QPalette
from PySide6.QtWidgets import QWidget

from brdf_suite.realtime.gl.context import Context
from brdf_viewer.camera.section import CameraSection
from brdf_viewer.commands import ViewerCommands
from brdf_viewer.compare.section import CompareSection
from brdf_viewer.light.environment_section import EnvironmentSection
from brdf_viewer.light.section import LightingSection
from brdf_viewer.light.studio.panel import StudioPanel
from brdf_viewer.overlay.overlay import PictureOverlay
from brdf_viewer.paint.section import PaintSection
from brdf_viewer.paint.sparkle_section import FresnelSection, SparkleSection
from brdf_viewer.scene.drawing import SceneDrawer
from brdf_viewer.surface.relief_section import ReliefSection
from brdf_viewer.surface.section import SurfaceSection
from brdf_viewer.tone.section import ToneSection
from brdf_viewer.tracing.section import RendererSection

_BUSY_AFTER_MS = 200
"""Work that is done sooner shows no progress: a strip that flashes up says nothing."""
_BUSY_EVERY_MS = 60
"""Work may report every hundredth of a second; each time that it is shown is a frame of a slow picture."""


class ViewerWindow(SuiteWindow):
    """Widgets only: the sections and ``commands`` carry the intents.

    Signals: ``busy_cancelled(kind)``; ``closing()`` when the window is about to close.
    """

    busy_cancelled = Signal(str)
    closing = Signal()

    def __init__(self, make_drawer: Callable[[Context], Drawer], parent: QWidget | None = None) -> None:
        super().__init__(tr("Viewer"), parent)
        self.setWindowTitle("BRDF Suite Viewer")
        # The renderer averages four samples a pixel by itself, in linear light as the eye does.
        self.picture = GlSurface(make_drawer, samples=0)
        self.picture.setAccessibleName(tr("Picture"))
        self.overlay = PictureOverlay(self.picture)
        self.set_centre(self.picture, tab_hides_panels=True)
        add = self.inspector.add_section
        self.environment = add(EnvironmentSection())
        self.lighting = add(LightingSection())
        self.surface = add(SurfaceSection())
        self.relief = add(ReliefSection())
        self.paint = add(PaintSection())
        self.fresnel = add(FresnelSection())
        self.sparkle = add(SparkleSection())
        self.tone = add(ToneSection())
        self.renderer = add(RendererSection())
        self.compare = add(CompareSection())
        self.camera = add(CameraSection())
        self.commands = ViewerCommands(self)
        self.studio_dock = self.add_panel(mark("Studio"), QWidget(), Qt.DockWidgetArea.LeftDockWidgetArea)
        self.studio_dock.hide()
        self.close_guards: list[Callable[[], bool]] = []
        for action in self.commands.on_picture:
            self.picture.addAction(action)
        self.busy: dict[str, tuple[float, str]] = {}
        self._busy_delay = make_timer(self, self._show_busy)
        names = (mark("frame"), mark("renderer"), mark("lobes"), mark("fit"), mark("exposure"))
        for name in (*names, mark("environment"), mark("palette")):
            self.status.cell(name, elastic=name in ("renderer", "fit", "environment", "palette"))
        for name, text in (("frame", "888.8 ms"), ("lobes", "88 lobes"), ("fit", "fit 88.88 ms · ΔE 88.88")):
            self.status.cell(name).reserve(text)
        for name in (mark("readout"), mark("link")):
            self.status.cell(name, right=True, elastic=name == "link")
        self.restore_layout()
        self.picture.setFocus()

    @cached_property
    def studio(self) -> StudioPanel:
        """The panel of the studio, built at first use: it has a third of the window's widgets."""
        panel = StudioPanel()
        self.studio_dock.widget().deleteLater()
        self.studio_dock.setWidget(panel)
        return panel

    @property
    def drawer(self) -> SceneDrawer | None:
        """What draws at present; None while nothing does: a lost context gets a new one."""
        drawer = self.picture.drawer
        return drawer if isinstance(drawer, SceneDrawer) else None

    def keep_opened(self) -> None:
        """Take what is shown for what the view had when it was opened: a double click on a number goes back to it."""
        for field in self.inspector.findChildren(NumberField):
            field.set_default(field.value())

    def surround(self) -> tuple[float, float, float]:
        """Return the theme's grey, R = G = B, 0…1, for a picture that has nothing to show yet."""
        colour = self.palette().color(QPalette.ColorRole.Window)
        return (colour.redF(), colour.greenF(), colour.blueF())

    def set_busy(self, kind: str, fraction: float, what: str) -> None:
        """Show how far the work of a kind is, once there has been work for a moment."""
        self.busy[kind] = (fraction, what)
        if not self._busy_delay.isActive():
            self._busy_delay.start(_BUSY_EVERY_MS if self.progress.jobs else _BUSY_AFTER_MS)

    def set_idle(self, kind: str) -> None:
        self.busy.pop(kind, None)
        self.progress.end_job(kind)
        if not self.busy:
            self._busy_delay.stop()

    def _show_busy(self) -> None:
        for kind, (fraction, what) in self.busy.items():
            self.progress.set_job(kind, fraction, what, partial(self.busy_cancelled.emit, kind))

    def may_close(self) -> bool:
        """Whether nothing that is unsaved is lost, or the user gives it up."""
        return all(guard() for guard in self.close_guards)

    def closeEvent(self, event: QCloseEvent) -> None:
        super().closeEvent(event)
        if event.isAccepted():
            self.closing.emit()
