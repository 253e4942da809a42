"""The studio that is edited: its document, its panel, and the picture that follows."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from functools import cached_property, partial
from pathlib import Path
from typing import Any

from brdf_qt.documents.file_reading import FileReading
from brdf_qt.documents.open_document import DocumentStore
from brdf_qt.documents.recovery import Recovered, Recovery
from brdf_qt.documents.stamp import FileStamp
from brdf_qt.fields.choices import set_note
from brdf_qt.program.core_texts import tr_core
from brdf_qt.program.translation import mark, tr
from brdf_qt.window.dialogs import QtDialogs

from brdf_suite.documents.studio import STUDIO_ENDING, LightDocument, Sky, Studio
from brdf_suite.documents.view import View
from brdf_suite.errors import SuiteError, ValueRangeError
from brdf_suite.geometry.polar import point_at, polar
from brdf_suite.pipeline.scene import PreparedEnvironment
from brdf_viewer.feature import ViewerFeature
from brdf_viewer.light.studio import edits
from brdf_viewer.light.studio.document import FORMAT, TEMPLATES, StudioFiles
from brdf_viewer.light.studio.forms import Edits, changed_lamp, changed_surroundings
from brdf_viewer.light.studio.live_light import LiveLight
from brdf_viewer.light.studio.panel import StudioPanel
from brdf_viewer.scene.control import SceneControl
from brdf_viewer.scene.viewer_state import LoadedAsset, ViewerState
from brdf_viewer.window import ViewerWindow

_BUSY = "studio"


class StudioControl(ViewerFeature):
    """Begins, opens and saves studios; puts the panel's edits into the document, and the document into the picture.

    ``dialogs`` asks where to save, and about unsaved changes.
    """

    def __init__(
        self, state: ViewerState, window: ViewerWindow, scene: SceneControl, dialogs: QtDialogs
    ) -> None:
        super().__init__(state, window)
        self._scene = scene
        self.store: DocumentStore[LightDocument] = DocumentStore(TEMPLATES["empty"][1], self)
        self.files = StudioFiles(self.store, FORMAT, dialogs, self)
        report = partial(self._report, key="autosave")
        self.recovery: Recovery[LightDocument] = Recovery(
            self.store, FORMAT, report, self, keeps_history=True
        )
        self._reading = FileReading(window.progress, self)
        self._open = False
        self._index = 0
        self._shown: PreparedEnvironment | None = None
        self._seen: LoadedAsset[PreparedEnvironment] | None = None
        self._live = LiveLight(state.fitting.basis, self)
        self._live.drawn.connect(self._drawn)
        self._live.failed.connect(self._not_drawn)
        self._live.moved.connect(
            lambda fraction, what: window.set_busy(_BUSY, fraction, f"{self.store.value.name}: {what}")
        )
        self._live.ended.connect(lambda: window.set_idle(_BUSY))
        window.busy_cancelled.connect(self._cancelled)
        window.close_guards.append(self.may_close)
        self._connect_document()
        window.environment.edit.clicked.connect(self.edit)
        window.studio_dock.visibilityChanged.connect(lambda visible: visible and self._panel)
        self._add_commands()
        self._show_state()
        self._contents_changed()

    def new(self, template: str) -> bool:
        """Begin a studio from a template, after asking about unsaved changes of the present one."""
        if self._open and not self.files.may_discard():
            return False
        light = TEMPLATES[template][1]
        self.store.replace(_changed(light, "name", tr(light.name)), None)  # clean: it is no work to be lost
        self._show_opened()
        return True

    def edit(self) -> bool:
        """Edit the light of the picture, where it has a description; otherwise say what can be done."""
        key = self._state.view.environment
        if key == "booth":
            return self.new("booth")
        if not key.lower().endswith(STUDIO_ENDING):
            what = tr("The current light is an image, which has no lamps to edit.")
            todo = tr("Create a studio with File ▸ Studio ▸ New, or choose the light booth.")
            self._refuse(_BUSY, what, todo)
            return False
        return self._edit_file(Path(key))

    def _edit_file(self, path: Path, then: Callable[[], None] | None = None) -> bool:
        """Read a studio on a thread and open it; ``then`` is called once it is."""
        if self._open and self.store.path == path:
            self._show_panel()
            return True

        asked = self._state.view.environment, self.store.value

        def done(answer: tuple[LightDocument, FileStamp | None]) -> None:
            if asked != (self._state.view.environment, self.store.value):
                return  # another light was chosen, or another studio opened, meanwhile
            if not self._open or self.files.may_discard():
                self.files.take(path, *answer)
                self._show_read(path)
                if then is not None:
                    then()

        self._live.stop()  # a draft of the studio that was open would take the place of the light to be edited
        failed = partial(self.files.report_unread, path)
        self._reading.begin(path, lambda file, _progress: self.files.read(file), done, failed)
        return True

    def _show_read(self, path: Path) -> None:
        present = self._state.environment
        if present is not None and present.key == str(path) and present.value.is_final:
            # The picture shows it already; nothing is drawn until it is edited.
            self._live.stop()  # at a studio that was open before
            self._shown = present.value
            self._panel.preview.set_radiance(present.value.environment.radiance)
            self._show_opened(draw=False)
        else:
            self._shown = None
            self._show_opened()

    @property
    def is_idle(self) -> bool:
        return self._reading.is_idle

    def may_close(self) -> bool:
        """Ask about unsaved changes, where there are any."""
        return not self._open or self.files.may_discard()

    def close(self) -> None:
        self._reading.close()
        self._live.close()
        self.recovery.close(keep=True)

    def recover(self, item: Recovered[LightDocument]) -> None:
        """Open what an earlier run left, with its history."""
        self._open = False  # until it is there: what is replaced is not drawn
        self.recovery.take(item)
        self._show_opened()

    def restore_saved(self, item: Recovered[LightDocument]) -> None:
        """Open a saved studio of an earlier run, with its history where that ends at what the file holds."""
        if item.path is None or self._open:
            return

        def restore() -> None:
            history, store = item.history, self.store
            if history is not None and item.value == store.value:
                store.restore(
                    history.states, history.place, store.path, saved=history.place, stamp=store.stamp
                )

        self._edit_file(item.path, restore)

    def _show_opened(self, *, draw: bool = True) -> None:
        self._open, self._index = True, 0
        self._window.messages.dismiss(_BUSY)
        self._show_panel()
        if draw:
            self._live.show(self.store.value)
        self._show()

    def _show_panel(self) -> None:
        _ = self._panel  # built before the dock is shown, which takes its width
        self._window.studio_dock.show()
        self._window.studio_dock.raise_()

    def _connect_document(self) -> None:
        self.store.changed.connect(self._changed)
        for signal in (self.store.clean_changed, self.store.path_changed, self.store.history_changed):
            signal.connect(lambda *_: self._show_state())
        self.files.failed.connect(self._window.messages.show_message)
        self.files.succeeded.connect(self._written)
        self._state.contents_changed.connect(self._contents_changed)
        self._state.view_changed.connect(lambda _old, new: self._show_editable(new))

    @cached_property
    def _panel(self) -> StudioPanel:
        """The window's panel, connected; without an open studio it keeps the state in which it is built."""
        panel, store = self._window.studio, self.store
        panel.new_requested.connect(self.new)
        for signal, slot in (
            (panel.edit.clicked, self.edit),
            (panel.save.clicked, self.files.save),
            (panel.save_as.clicked, self.files.save_as),
            (panel.undo.clicked, store.undo),
            (panel.redo.clicked, store.redo),
            (panel.relight.clicked, lambda: self._live.show(store.value)),
            (panel.double.clicked, self._double),
            (panel.remove.clicked, self._remove),
        ):
            signal.connect(slot)
        panel.name.edited.connect(
            lambda text: self._do(tr("Rename"), lambda light: _changed(light, "name", text))
        )
        panel.chosen.connect(self._choose)
        panel.add_requested.connect(self._add)
        panel.lamp.edits.changed.connect(self._edit_lamp)
        panel.around.edits.changed.connect(
            lambda name, value: self._do(
                tr("Change Surroundings"), lambda light: changed_surroundings(_studio(light), name, value)
            )
        )
        panel.sky.edits.changed.connect(
            lambda name, value: self._do(tr("Change Sky"), lambda light: _changed(light, name, value))
        )
        for source in (panel.lamp.edits, panel.around.edits, panel.sky.edits, panel.preview, panel.name):
            step = tr("Change Lamp") if isinstance(source, Edits) else tr("Move Lamp")
            source.gesture_started.connect(partial(store.begin_gesture, step))
            source.gesture_finished.connect(store.end_gesture)
        panel.preview.picked.connect(self._choose)
        panel.preview.dragged.connect(self._drag)
        panel.preview.scaled.connect(self._scale)
        return panel

    def _add_commands(self) -> None:
        window, menu = self._window, self._window.commands.studio
        for key, (title, _) in TEMPLATES.items():
            text = tr("New Studio: {template}").format(template=tr(title))
            window.add_action(menu, f"New Studio: {title}", partial(self.new, key), tip=text).setText(text)
        menu.addSeparator()
        window.add_action(menu, mark("&Edit Current Light"), self.edit, icon="pencil-simple")
        self._save = window.add_action(menu, mark("&Save Studio"), self.files.save, icon="floppy-disk")
        self._save_as = window.add_action(menu, mark("Save Studio &As…"), self.files.save_as)

    def _do(self, name: str, edit: Callable[[LightDocument], LightDocument]) -> None:
        """Make an edit; an invalid edit is reported in the panel, and the fields go back to what is."""
        try:
            value = edit(self.store.value)
        except ValueRangeError as error:
            text = tr("Not applied: {place}: {reason}").format(
                place=error.place, reason=tr_core(error.reason)
            )
            set_note(self._panel.mistake, text)
            self._show()
            return
        set_note(self._panel.mistake, "")
        if not self.store.set(value, name):
            self._show()

    def _edit_lamp(self, name: str, value: object) -> None:
        index = self._index

        def edit(light: LightDocument) -> Studio:
            studio = _studio(light)
            lamp = changed_lamp(studio.lamps[index], name, value)
            if name in ("azimuth", "elevation", "distance"):
                return edits.placed(studio, index, lamp.position_m)
            return edits.with_lamp(studio, index, lamp)

        self._do(tr("Change Lamp"), edit)

    def _drag(self, index: int, azimuth_deg: float, elevation_deg: float) -> None:
        def edit(light: LightDocument) -> LightDocument:
            if isinstance(light, Sky):
                return edits.with_sun(light, azimuth_deg, elevation_deg)
            distance = polar(light.lamps[index].position_m)[2]
            return edits.placed(light, index, point_at(azimuth_deg, elevation_deg, distance))

        self._do(tr("Move Lamp"), edit)

    def _scale(self, index: int, factor: float) -> None:
        def edit(light: LightDocument) -> LightDocument:
            studio = _studio(light)
            return edits.with_lamp(studio, index, edits.scaled(studio.lamps[index], factor))

        self._choose(index)
        self._do(tr("Scale Lamp"), edit)

    def _add(self, shape: str) -> None:
        self._index = len(_studio(self.store.value).lamps)
        self._do(tr("Add Lamp"), lambda light: edits.added(_studio(light), shape))

    def _double(self) -> None:
        index = self._index
        self._index = index + 1
        self._do(tr("Duplicate Lamp"), lambda light: edits.doubled(_studio(light), index))

    def _remove(self) -> None:
        index = self._index
        self._do(tr("Remove Lamp"), lambda light: edits.removed(_studio(light), index))

    def _choose(self, index: int) -> None:
        if index != self._index:
            self._index = index
            self._show()

    def _changed(self, _old: LightDocument, new: LightDocument) -> None:
        self._index = min(self._index, len(new.lamps) - 1) if isinstance(new, Studio) else 0
        if self._open:
            self._live.show(new)
        self._show()

    def _drawn(self, light: LightDocument, prepared: PreparedEnvironment) -> None:
        if not self._open:
            return
        self._shown = prepared
        if type(light) is type(self.store.value):
            self._panel.preview.set_radiance(prepared.environment.radiance)
        path = self.store.path
        self._scene.show_edited(light.name if path is None else str(path), prepared)
        if path is not None and self.store.is_clean and prepared.is_final:
            self._scene.name_edited(str(path))

    def _not_drawn(self, error: Exception) -> None:
        if not isinstance(error, SuiteError):
            raise error
        self._report(error, _BUSY, tr("The picture shows the last valid light."))

    def _cancelled(self, kind: str) -> None:
        if kind == _BUSY:
            self._live.stop()

    def _written(self, what: str) -> None:
        if what == "save" and self.store.path is not None and self.is_lit():
            self._scene.name_edited(str(self.store.path))

    def _contents_changed(self) -> None:
        """Another light came into the picture: stop drawing this one, and offer it again."""
        present = self._state.environment
        if present is self._seen:
            return  # it was the paint or the surface that changed
        self._seen = present
        if self._open and not self.is_lit():
            self._live.stop()
        if self._open and present is not None and present.key == str(self.store.path) and self.store.is_clean:
            self._shown = present.value  # read from the file that holds the same
        self._show_editable(self._state.view)
        if self._open:
            self._panel.relight.setVisible(not self.is_lit())

    def _show_editable(self, view: View) -> None:
        key = view.environment
        self._window.environment.set_editable(key == "booth" or key.lower().endswith(STUDIO_ENDING))

    def is_lit(self) -> bool:
        """Return whether the picture is lit by the open studio."""
        present = self._state.environment
        return present is not None and present.value is self._shown

    def _show(self) -> None:
        if self._open:
            self._panel.set_light(self.store.value, self._index)
            self._panel.relight.setVisible(self._shown is not None and not self.is_lit())
        self._show_state()

    def _show_state(self) -> None:
        where = tr("Not saved to a file yet") if self.store.path is None else self.store.path.name
        changed = "" if self.store.is_clean else ", " + tr("changed") if self.store.path is not None else ""
        stack = self.store.stack
        if self._open:
            self._panel.set_state(f"{where}{changed}", stack.canUndo(), stack.canRedo())
        for action in (self._save, self._save_as):
            action.setEnabled(self._open)


def _studio(light: LightDocument) -> Studio:
    assert isinstance(light, Studio)
    return light


def _changed(light: LightDocument, name: str, value: Any) -> LightDocument:
    changed: LightDocument = dataclasses.replace(light, **{name: value})
    return changed
