"""Environment and surface: chosen, dropped or opened, loaded in the background, and reported when they fail."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from pathlib import Path

from brdf_qt.choosing.picker import SourceField
from brdf_qt.choosing.sources import Source
from brdf_qt.documents.recent_files import RecentFiles
from brdf_qt.documents.watch import FileWatch
from brdf_qt.fields.choices import set_note
from brdf_qt.program.core_texts import tr_core
from brdf_qt.program.names import title_of
from brdf_qt.program.translation import decimal, tr
from brdf_qt.work.scene_loading import ENVIRONMENT, SURFACE, SceneLoader
from brdf_qt.work.tasks import TaskRunner
from PySide6.QtCore import Signal

from brdf_suite.documents.studio import STUDIO_ENDING
from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import SurfaceLook
from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.statistics import EnvironmentStatistics
from brdf_suite.pipeline.environments import AUTOMATIC
from brdf_suite.pipeline.scene import (
    PreparedEnvironment,
    default_view,
    environment_names,
    in_environment,
    surface_names,
)
from brdf_suite.realtime.camera import frame
from brdf_suite.surface.mesh import Mesh
from brdf_viewer.feature import ViewerFeature
from brdf_viewer.light.environment_section import environment_facts
from brdf_viewer.scene.viewer_state import ViewerState
from brdf_viewer.window import ViewerWindow


class SceneControl(ViewerFeature):
    """Loads what the view names; the view changes only once that is there.

    Signals: ``failed(kind, text)`` where something could not be loaded.
    """

    failed = Signal(str, str)

    def __init__(self, state: ViewerState, window: ViewerWindow, runner: TaskRunner) -> None:
        super().__init__(state, window)
        self.loader = SceneLoader(runner, self)
        self._choosers: dict[str, SourceField] = {
            ENVIRONMENT: window.environment.chooser,
            SURFACE: window.surface.chooser,
        }
        self._names = {ENVIRONMENT: environment_names(), SURFACE: surface_names()}
        self._recent = {kind: RecentFiles(f"recent/{kind}") for kind in self._choosers}
        self._loading: dict[str, str] = {}
        self._layout = state.view.environment_layout
        self._watch = FileWatch(self)
        self._watch.changed.connect(self._changed_on_disk)
        for kind, chooser in self._choosers.items():
            group = window.commands.sources[kind]
            group.add({name: title_of(name) for name in self._names[kind]})
            for signal in (chooser.chosen, group.picked):
                signal.connect(partial(self.open, kind))
            self._list(kind)
            self._show(kind)
        self.loader.loaded.connect(self._loaded)
        self.loader.partly_loaded.connect(self._partly_loaded)
        self.loader.failed.connect(self._not_loaded)
        self.loader.moved.connect(self._moved)
        self.loader.ended.connect(self._ended)
        self.loader.counted.connect(self._counted)
        window.environment.layout_list.picked.connect(self.set_layout)
        window.busy_cancelled.connect(self.cancel)
        state.view_changed.connect(self._view_changed)

    @property
    def is_idle(self) -> bool:
        return not self._loading

    def start(self) -> None:
        self.open(SURFACE, self._state.view.surface)
        self._open_environment(self._state.view.environment, self._state.view.environment_layout)

    def open(self, kind: str, key: str) -> None:
        """Load a shipped name or a file of a kind; the old picture stays until it is there."""
        if kind == ENVIRONMENT:
            self._layout = AUTOMATIC
        self._begin(kind, key)

    def set_layout(self, layout: str) -> None:
        """Read the present environment's file again as an image of another layout."""
        self._open_environment(self._state.view.environment, layout)

    def _open_environment(self, key: str, layout: str) -> None:
        self._layout = layout
        self._begin(ENVIRONMENT, key)

    def _changed_on_disk(self, path: str) -> None:
        """A description was edited: draw it again, unless another environment is on its way."""
        if ENVIRONMENT not in self._loading or self._loading[ENVIRONMENT] == path:
            self._open_environment(path, self._layout)

    def _begin(self, kind: str, key: str, *, keep_message: bool = False) -> None:
        if not keep_message:
            self._window.messages.dismiss(kind)
        if key not in self._names[kind]:
            key = str(Path(key).absolute())
        self._loading[kind] = key
        self._show_facts()
        self._show_choice(kind, key)
        basis = self._state.fitting.basis
        self.loader.load(kind, key, self._layout, self._look_of(key), basis)

    def _look_of(self, surface: str) -> SurfaceLook:
        """Return the look of a surface: axes and unit are those of a file, and another one is taken as it says."""
        look = self._state.view.surface_look
        return look if surface == self._state.view.surface else replace(look, unit="file", up="file")

    def close(self) -> None:
        self.loader.stop()

    def cancel(self, kind: str) -> None:
        """Stop loading. A whole picture that was shown comes back; where there was none, what is there stays."""
        if kind not in self._choosers:
            return  # the work of another
        self.loader.cancel(kind)
        if kind == ENVIRONMENT:
            self._take_partial_back()

    def refused(self, kind: str, error: Exception) -> None:
        """The graphics card did not take what was loaded; the view goes back to what is drawn."""
        if kind in self._loading:
            self.cancel(kind)  # the rest of it would be refused as well
        drawn = self._drawn_key(kind)
        if drawn:
            self._state.change_view(**{kind: drawn})
        if kind == ENVIRONMENT:
            self._forget_figures()  # of the one that was refused, counted or not
            self._count_again()
        self._complain(kind, error)

    def _loaded(self, kind: str, key: str, value: PreparedEnvironment | Mesh) -> None:
        if isinstance(value, PreparedEnvironment):
            first = not self._drawn_key(ENVIRONMENT)
            self._state.edited_light = ""
            self._state.set_environment(key, value)
            change = self._state.follow_view if first else self._state.step_view
            new = in_environment(self._state.view, key)
            change(
                environment=key,
                environment_layout=self._layout,
                background=new.background,
                exposure_ev=new.exposure_ev,
            )
            self._show_facts()
            self._forget_figures()
            self._count_again()
        else:
            first = self._state.surface is None
            self._state.set_surface(key, value)
            if first:
                self._state.follow_view(surface=key)
            elif key != self._state.view.surface:  # otherwise a view brought its own camera with it
                look, camera = self._look_of(key), frame(self._state.view.camera)
                self._state.step_view(surface=key, surface_look=look, camera=camera)
            set_note(self._window.surface.facts, _surface_facts(value))
        if key not in self._names[kind]:
            self._recent[kind].add(key)
            self._list(kind)
        self._show(kind)

    def show_edited(self, key: str, prepared: PreparedEnvironment) -> None:
        """Show a light that is being edited: under its file's path, or under its name while it has none.

        The view goes on to name what it did; it cannot name what no file holds.
        """
        if ENVIRONMENT in self._loading:
            self.loader.cancel(ENVIRONMENT)
        self._state.edited_light = key
        self._state.set_environment(key, prepared)
        self._show_facts()
        self._show(ENVIRONMENT)
        if prepared.is_final:
            self.loader.count(key, prepared.environment)

    def name_edited(self, path: str) -> None:
        """The light that was edited is now what a file holds: the view names it."""
        present = self._state.environment
        if present is not None and self._state.edited_light:
            self._state.set_environment(path, present.value)
        self._state.edited_light = ""
        self._layout = AUTOMATIC
        self._recent[ENVIRONMENT].add(path)
        self._list(ENVIRONMENT)
        self._watch.watch(path)  # what it holds now is what is shown: only a later change is one
        self._state.change_view(environment=path, environment_layout=AUTOMATIC)
        self._show(ENVIRONMENT)

    def _partly_loaded(self, key: str, prepared: PreparedEnvironment) -> None:
        """Show what there is of an environment that is on its way; the view names it when it is whole."""
        self._state.edited_light = ""
        present = self._state.environment
        if present is None or present.value.environment.content_hash != prepared.environment.content_hash:
            self._forget_figures()  # they are of another light than the one on show
        self._state.set_environment(key, prepared)
        self._show_facts()
        self._show_environment_cell()

    def _forget_figures(self) -> None:
        self._state.light_figures = None
        self._window.environment.figures.set_statistics(None)

    def _count_again(self) -> None:
        """Count the figures of the light on show where those of another were dropped."""
        present = self._state.environment
        if present is not None and self._state.light_figures is None:
            self.loader.count(present.key, present.value.environment)

    def _take_partial_back(self) -> None:
        self._state.take_partial_back()
        self._count_again()
        self._show_facts()
        self._show(ENVIRONMENT)

    def _show_facts(self) -> None:
        present = self._state.environment
        text = "" if present is None else environment_facts(present.value, ENVIRONMENT in self._loading)
        section = self._window.environment
        set_note(section.facts, text)
        # While another light is on its way they are of the one that is still on show, not of the one that is named;
        # and of one that is being edited the figures are counted when it is as it will stay.
        loading = self._loading.get(ENVIRONMENT)
        old = present is not None and loading is not None and loading != present.key
        section.facts.setEnabled(not old)
        section.figures.setEnabled(not old and (present is None or not present.value.draft))

    def _counted(self, environment: Environment, statistics: EnvironmentStatistics) -> None:
        # By what it is and not by its name, which an edited light changes when it becomes a file.
        present = self._state.environment
        if present is not None and present.value.environment.content_hash == environment.content_hash:
            self._state.light_figures = statistics
            self._window.environment.figures.set_statistics(statistics)

    def _not_loaded(self, kind: str, key: str, error: Exception) -> None:
        if kind == ENVIRONMENT:
            self._take_partial_back()
        self._complain(kind, error)
        drawn = self._drawn_key(kind)
        if drawn and getattr(self._state.view, kind) == key:
            self._state.follow_view(**{kind: drawn})  # the view names again what is drawn
        self._show(kind)
        default = getattr(default_view(), kind)
        if not self._drawn_key(kind) and key != default:
            self._layout = AUTOMATIC
            self._begin(kind, default, keep_message=True)  # a picture with a message beats a message alone

    def _complain(self, kind: str, error: Exception) -> None:
        shown = title_of(self._drawn_key(kind) or getattr(default_view(), kind))
        todo = tr(
            "The picture shows {shown}. Choose another one in the inspector, or drop a file on the picture."
        )
        self._report(error, kind, todo.format(shown=shown))
        self.failed.emit(kind, str(error))

    def _moved(self, kind: str, fraction: float, what: str) -> None:
        title = title_of(self._loading.get(kind, ""))
        self._window.set_busy(kind, fraction, f"{title}: {what}")

    def _ended(self, kind: str) -> None:
        self._loading.pop(kind, None)
        self._window.set_idle(kind)
        self._show_facts()
        self._show(kind)

    def _drawn_key(self, kind: str) -> str:
        if kind == ENVIRONMENT and self._state.edited_light:
            return self._state.view.environment
        present = self._state.environment if kind == ENVIRONMENT else self._state.surface
        return "" if present is None else present.key

    def _list(self, kind: str) -> None:
        shipped = [Source(name, title_of(name)) for name in self._names[kind]]
        files = self._recent[kind].paths()
        self._choosers[kind].set_sources(shipped, [Source(p, title_of(p)) for p in files])
        self._window.commands.set_recent(kind, files)

    def _show(self, kind: str) -> None:
        edited = self._state.edited_light if kind == ENVIRONMENT else ""
        self._show_choice(kind, self._loading.get(kind) or edited or getattr(self._state.view, kind))

    def _show_choice(self, kind: str, key: str) -> None:
        if kind == ENVIRONMENT:
            on_disk = key.lower().endswith(STUDIO_ENDING)
            described = on_disk or key == self._state.edited_light
            loading = ENVIRONMENT in self._loading
            layout = self._layout if loading else self._state.view.environment_layout
            self._window.environment.set_layout(layout, not described and key not in self._names[kind])
            # An edit that makes it faulty keeps picture and watch: the next save may put it right.
            if (key if on_disk else "") != self._watch.path and (on_disk or not loading):
                self._watch.watch(key if on_disk else "")
        self._choosers[kind].show_source(key, title_of(key))
        self._window.commands.sources[kind].show_choice(key)
        self._show_environment_cell()

    def _view_changed(self, old: View, new: View) -> None:
        for kind in self._choosers:
            if getattr(old, kind) != getattr(new, kind):
                self._show(kind)
        # What a view names that was undone or opened is loaded, unless it is drawn or on its way.
        layout = new.environment_layout
        if (old.environment, old.environment_layout) != (new.environment, layout) and not (
            self._is_there(ENVIRONMENT, new.environment) and layout == self._layout
        ):
            self._open_environment(new.environment, layout)
        if old.surface != new.surface and not self._is_there(SURFACE, new.surface):
            self.open(SURFACE, new.surface)

    def _is_there(self, kind: str, key: str) -> bool:
        """Whether this is loaded, or drawn and nothing else loaded."""
        return self._loading.get(kind, self._drawn_key(kind)) == key

    def _show_environment_cell(self) -> None:
        loading = self._loading.get(ENVIRONMENT)
        title = title_of(loading or self._state.edited_light or self._state.view.environment)
        cell, present = self._window.status.cell("environment"), self._state.environment
        if present is None or present.value.is_final:
            cell.set(title, tr("Loading") if loading else tr("Environment"), "stale" if loading else "fresh")
            return
        text, tip = tr("{title}, draft"), tr("Full quality follows after editing")
        made, wanted = present.value.wanted - present.value.missing, present.value.wanted
        if not present.value.draft:
            text = tr("{title}, maps {made} of {wanted}")
            tip = tr("Refining reflections") if loading else tr("Stopped; select the light again to finish")
        title = title_of(present.key)
        cell.set(text.format(title=title, made=made, wanted=wanted), tip, "stale")


def _surface_facts(mesh: Mesh) -> str:
    low, high = mesh.bounds()
    size = " × ".join(decimal(f"{edge:.3g}") for edge in high - low)
    one, many = tr("{triangles:,} triangles, 1 part"), tr("{triangles:,} triangles, {parts} parts")
    text = one if len(mesh.parts) == 1 else many
    count = text.format(triangles=mesh.triangle_count, parts=len(mesh.parts))
    return "\n".join([count, f"{size} m", *map(tr_core, mesh.notes)])
