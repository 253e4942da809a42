"""Puts Lobe Visualizer together: window, session, sources, fits, legend, parts, link."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

from brdf_qt.documents.project_files import ProjectFiles
from brdf_qt.link.link import LiveLink
from brdf_qt.program.feature import Feature
from brdf_qt.program.program import Program
from brdf_qt.program.settings import settings
from brdf_qt.program.translation import mark, tr
from brdf_qt.window.dialogs import QtDialogs
from brdf_qt.window.fit_choice import FitChoice, FitCommand
from brdf_qt.work.timer import make_timer
from PySide6.QtCore import Qt, QTimer
from PySide6.QtWidgets import QFileDialog

from brdf_lobe_visualizer import remembered
from brdf_lobe_visualizer.cuts.panel import Slices
from brdf_lobe_visualizer.factor_maps.part import Factors
from brdf_lobe_visualizer.legend.control import LegendControl
from brdf_lobe_visualizer.lobe_basis.part import Basis
from brdf_lobe_visualizer.model_text.part import Models
from brdf_lobe_visualizer.session import LobeSession
from brdf_lobe_visualizer.statistics.panel import AskPath, Numbers
from brdf_lobe_visualizer.status import Status
from brdf_lobe_visualizer.subjects.fits import KEY as DESIGNER
from brdf_lobe_visualizer.subjects.fits import Fits, FollowedPaint
from brdf_lobe_visualizer.subjects.paint_strip import StripControl
from brdf_lobe_visualizer.subjects.project_part import LobesProject
from brdf_lobe_visualizer.subjects.reopening import Reopening
from brdf_lobe_visualizer.subjects.sources_control import Sources
from brdf_lobe_visualizer.subjects.sources_panel import SourcesPanel
from brdf_lobe_visualizer.view3d.panel import Space
from brdf_lobe_visualizer.window import LobeWindow
from brdf_suite.fitting.lobes.settings import FitSettings
from brdf_suite.pipeline.material import default_paint_name, load_document

_LOOK_EVERY_MS = 50
_FOLDER_KEY = "folder/open"
_ENDINGS = (
    "*.brdfpaint *.brdfpalette *.brdftable *.binary *.merl *.bsdf *.brdf *.py *.dat *.bin *.json *.astm *.alta *.txt "
    "*.ssdd *.mbsdf *.pbsdf *.mtlx "
    "*.ase *.aco *.acb *.act *.gpl *.kpl *.sbz *.soc *.cxf *.pal *.csv *.css"
)

MakePart = Callable[[LobeSession, LobeWindow], Feature]
PARTS: tuple[MakePart, ...] = (Space, Slices, Basis, Factors)
"""What makes each part beside the window's own, in the order of the inspector: called with session and window.

Parts are made before the window is shown: what is heavy to import or to make waits for ``window.first_painted``.
"""
AskFiles = Callable[[LobeWindow, str, str], Sequence[str]]
"""``(window, folder, filters) -> paths``: asks which files to open; tests answer for the user."""


class LobeVisualizer(Program):
    """The running Lobe Visualizer.

    ``parts`` are what makes views, plots and sections: all, unless others are given; ``asked``: names and files that
    the start opens, or the default paint where there are none; ``fit``: how lobes are fitted in this run, by default as
    was last chosen. :class:`SuiteError` where its basis cannot be read.

    Milestones: ``shown``, the reflectances are; ``complete``, fits and figures too.
    """

    is_complete_when_started = False
    window: LobeWindow

    def __init__(
        self,
        parts: Sequence[MakePart] = PARTS,
        *,
        asked: Sequence[str] = (),
        ask_files: AskFiles | None = None,
        ask_path: AskPath | None = None,
        fit: FitChoice | None = None,
    ) -> None:
        super().__init__(LobeWindow())
        self.session = LobeSession(self.window, self.window)
        note = tr("Takes effect here at once, in Viewer and Designer at their next start.")
        self.fit = FitCommand(self.window, note, fit)
        self.session.fitting = self.fit.settings
        self.sources = Sources(self.session, self.window)
        self.fits = Fits(self.session, self.window)
        self.legend = LegendControl(self.session, self.window)
        self.link = LiveLink("lobes", parent=self.window)
        self.followed = FollowedPaint(self.session, self.window, self.sources, self.fits)
        self.status = Status(self.session, self.window)
        self.panel = SourcesPanel()
        self.panel_dock = self.window.add_dock(
            "reflectances", mark("Reflectances"), self.panel, Qt.DockWidgetArea.LeftDockWidgetArea
        )
        self.strip = StripControl(self.session, self.window, self.sources)
        self.reopening = Reopening(self.session, self.window, self.sources, self.drop_default)
        self._ask_files = ask_files or _ask_files
        self._asked = asked
        self._default = ""
        self._build_commands()
        self.features += (
            self.sources,
            self.fits,
            self.legend.errors,
            self.followed,
            self.strip,
            self.reopening,
        )
        # Before the parts: its section comes first in the inspector.
        self.models = Models(self.session, self.window, self.sources)
        self.features += (part(self.session, self.window) for part in parts)
        self.numbers = Numbers(self.session, self.window, ask_path=ask_path)
        self.projects = ProjectFiles(
            self.window, LobesProject(self.session, self.sources), QtDialogs(self.window)
        )
        self.sources.open_project = self._open_project
        self.features += (self.models, self.numbers, self.projects, self.link)
        self.fit.add_to_menu()
        self.window.toolbar.addAction(self.numbers.action)
        self.window.add_quit()
        self.window.complete()
        remembered.recall(self.session, self.window)
        self._join()

    @property
    def is_idle(self) -> bool:
        """Whether all that follows by itself is there: files, fits, errors, figures, pictures."""
        return not self.session.tasks.busy and super().is_idle

    def start(self) -> None:
        """Open what was asked for, or the default paint where nothing was, and look for the other programs."""
        self.sources.idle.connect(self._show_start, Qt.ConnectionType.SingleShotConnection)
        self.sources.open_many(self._asked)
        if not self._asked and not self.session.subjects:
            self._default = self.reopening.default = default_paint_name()
            self.sources.open(self._default, remember=False)
        self.window.show_recent(self.sources.recent())
        super().start()
        self.panel.fill()
        shipped = [*self.panel.names["paints"], *self.panel.names["table_1"]]
        self.panel.set_thumbnails(self.strip.fill(shipped, load_document))
        self.sources.find_plugin_models(self.panel.add_plugin_models)

    def _show_start(self) -> None:
        self._look = make_timer(self, self._look_idle, _LOOK_EVERY_MS)
        # Handed to every view; painted in the turn of the event loop that follows.
        QTimer.singleShot(0, self, lambda: self.reached.emit("shown"))
        self._look.start()

    def _look_idle(self) -> None:
        if self.is_idle:
            self.reached.emit("complete")
        else:
            self._look.start()

    def close(self) -> None:
        """Leave the link and end what runs; only the first call acts."""
        super().close()
        self.session.tasks.stop()

    def _open_project(self, path: Path) -> bool:
        self.projects.open(path)
        return True

    def ask_files(self) -> None:
        folder = str(settings().value(_FOLDER_KEY, ""))
        filters = tr("Paints, palettes and measured files") + f" ({_ENDINGS});;" + tr("All files (*)")
        paths = self._ask_files(self.window, folder, filters)
        if paths:
            settings().setValue(_FOLDER_KEY, str(Path(paths[0]).parent))
            self.sources.open_many(paths)

    def show_list(self) -> None:
        self.panel_dock.show()
        self.panel_dock.raise_()
        self.panel.query.setFocus()
        self.panel.query.selectAll()

    def _join(self) -> None:
        window, sources = self.window, self.sources
        window.open_requested.connect(
            lambda path: self.ask_files() if path is None else sources.open_many([path])
        )
        window.files_dropped.connect(sources.open_many)
        window.recent_cleared.connect(sources.clear_recent)
        window.close_requested.connect(lambda _question: remembered.remember(self.session, window))
        sources.recent_changed.connect(lambda: window.show_recent(sources.recent()))
        sources.palette_opened.connect(self.panel.add_palette)
        self.panel.open_requested.connect(sources.open_many)
        self.legend.legend.open_requested.connect(self.ask_files)
        self.legend.legend.list_requested.connect(self.show_list)
        self.link.received.connect(self.followed.receive)
        self.fit.changed.connect(self._refit)
        self.link.peers_changed.connect(lambda _count: self.status.show_peers(self.link.peers))
        self.followed.arrived.connect(self.drop_default)
        sources.opened.connect(self._opened)

    def _build_commands(self) -> None:
        add = self.window.add_command
        tip = mark("Sample paints, measured paints of Table 1, models, opened palettes")
        listed = add(
            "file", mark("Add from &Library…"), "add_from_library", self.show_list, icon="list-plus", tip=tip
        )
        tip, act = (
            mark("Restore the default incidence, channel, radius, cosine and lobes"),
            self.session.reset_view,
        )
        title, sign = mark("Reset &View Options"), "arrow-counter-clockwise"
        reset = add("view", title, "reset_view", act, icon=sign, tip=tip)
        tip = mark(
            "Add it as cosine lobes, Cook-Torrance lobes and homomorphic factors, each fitted to the same data"
        )
        add("reflectance", mark("Add Re&presentations"), None, self.add_representations, tip=tip)
        for action, text in ((listed, mark("List")), (reset, mark("Reset View"))):
            action.setIconText(tr(text))
            self.window.toolbar.addAction(action)

    def _refit(self, fitting: FitSettings) -> None:
        self.followed.forget_fitter()
        self.fits.set_fitting(fitting)

    def _opened(self, asked: str, keys: Sequence[str]) -> None:
        if asked == self._default and keys:
            self._default = keys[0]
            if self.session.subject(DESIGNER) is not None:
                self.drop_default()

    def add_representations(self) -> None:
        """Show the selected reflectance in its three compact representations too, once they are fitted."""
        if self.session.front is not None:
            self.sources.add_representations(self.session.front)

    def drop_default(self) -> None:
        """Take the paint of an empty start away: Designer's has come in its place."""
        if self._default and self.session.subject(self._default) is not None:
            self.session.remove(self._default)
            self._default = ""


def _ask_files(window: LobeWindow, folder: str, filters: str) -> Sequence[str]:
    paths, _ = QFileDialog.getOpenFileNames(window, tr("Open"), folder, filters)
    return paths
