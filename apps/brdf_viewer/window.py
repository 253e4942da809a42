"""The Viewer's window: the picture takes the middle, five tabs are at the right, a slim toolbar above."""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property, partial

from brdf_qt.choosing.scenes import SceneThumbnails
from brdf_qt.choosing.strip import PaintStrip
from brdf_qt.choosing.thumbnails import PaintThumbnails, ThumbnailWork
from brdf_qt.fields.focus_order import order_focus
from brdf_qt.fields.form import fill_column
from brdf_qt.fields.number import NumberField
from brdf_qt.gl.surface import Drawer, GlSurface
from brdf_qt.program.translation import decimal, mark, tr
from brdf_qt.window.main_window import SuiteWindow
from brdf_qt.window.section import Section
from brdf_qt.window.tab_panel import standard_tabs
from brdf_qt.work.pictures import Pictures
from brdf_qt.work.timer import make_timer
from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QCloseEvent, QPalette
from PySide6.QtWidgets import QWidget

from brdf_suite.pipeline.material import load_document
from brdf_suite.realtime.gl.context import Context
from brdf_viewer.camera.section import CameraSection
from brdf_viewer.commands import ViewerCommands
from brdf_viewer.compare.section import CompareSection
from brdf_viewer.export.section import ExportSection
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

TABS = standard_tabs(
    paint=mark("Which paint, its flakes, orange peel and second colour"),
    light=mark("The light that the paint stands in, and what is behind it"),
    form=mark("The form that carries the paint, and from where it is seen"),
    compare=mark("A second paint or picture beside the first"),
    export=mark("The renderer, and files of what is seen"),
)
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
        super().__init__("Viewer", parent, TABS)
        self.setWindowTitle("BRDF Suite Viewer")
        # The renderer averages four samples a pixel by itself, in linear light as the eye does.
        self.picture = GlSurface(make_drawer, samples=0)
        self.picture.setAccessibleName(tr("Picture"))
        self.overlay = PictureOverlay(self.picture)
        self.set_centre(self.picture, tab_hides_panels=True)
        self._fill_panel()
        self._add_thumbnails()
        self.commands = ViewerCommands(self)
        self.studio_dock = self.add_panel(mark("Studio"), QWidget(), Qt.DockWidgetArea.LeftDockWidgetArea)
        self.studio_dock.hide()
        self.close_guards: list[Callable[[], bool]] = []
        for action in self.commands.on_picture:
            self.picture.addAction(action)
        self.busy: dict[str, tuple[float, str]] = {}
        self._busy_delay = make_timer(self, self._show_busy)
        for name in (mark("frame"), mark("fit"), mark("exposure"), mark("environment"), mark("palette")):
            self.status.cell(name, elastic=name in ("environment", "palette"))
        for name, text in (("frame", tr("Frame {ms} ms")), ("fit", tr("Fit ΔE00 {worst}"))):
            self.status.cell(name).reserve(text.format(ms=decimal("888.8"), worst=decimal("88.88")))
        for name in (mark("readout"), mark("link")):
            self.status.cell(name, right=True, elastic=name == "link")
        self.restore_layout()
        order_focus([self.toolbar, self.picture, *self.panel.focus_parts()])
        self.picture.setFocus()

    def _fill_panel(self) -> None:
        """Put what is used daily behind its tab, and the rest into the folds."""
        self.paint, self.sparkle, self.relief = PaintSection(), SparkleSection(), ReliefSection()
        self.environment, self.lighting, self.tone = EnvironmentSection(), LightingSection(), ToneSection()
        self.fresnel, self.surface, self.camera = FresnelSection(), SurfaceSection(), CameraSection()
        self.compare, self.renderer, self.export = CompareSection(), RendererSection(), ExportSection()
        self.paint.complete(self.sparkle.daily, self.relief.daily)
        light = Section(tr("Light"), "light", titled=False)
        fill_column(light.add(QWidget()), self.environment.daily, self.lighting.daily)
        form = Section(tr("Form"), "form", titled=False)
        fill_column(form.add(QWidget()), self.surface.daily, self.camera.daily)
        for key, daily, rest in (
            ("paint", (self.paint,), (self.sparkle, self.relief)),
            ("light", (light,), (self.lighting, self.tone, self.environment, self.fresnel)),
            ("form", (form,), (self.camera, self.surface)),
            ("compare", (self.compare,), (self.compare.rest,)),
            ("export", (self.renderer, self.export), (self.renderer.rest,)),
        ):
            page = self.panel.pages[key]
            for section in daily:
                page.add_section(section)
            for section in rest:
                page.add_more(section)

    def _add_thumbnails(self) -> None:
        pictures = Pictures(self)
        self.paint_thumbnails = PaintThumbnails(pictures, load_document)
        lights, forms = SceneThumbnails("environments", pictures), SceneThumbnails("meshes", pictures)
        self.thumbnails = ThumbnailWork(pictures, (self.paint_thumbnails, lights, forms))
        for chooser in (self.paint.chooser, self.compare.chooser, self.relief.paint):
            chooser.list.set_thumbnails(self.paint_thumbnails)
        self.environment.chooser.list.set_thumbnails(lights)
        self.surface.chooser.set_thumbnails(forms)
        self.strip = PaintStrip(self.paint.chooser.sources, second=True)
        self.add_strip(self.strip)

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
        for field in self.panel.findChildren(NumberField):
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
