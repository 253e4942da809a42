"""What a kill leaves of the Viewer: its view with the undo history, its paint, and the studio that was edited."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from brdf_qt.documents.files import DocumentFormat
from brdf_qt.documents.recovery import Recovered, Recovery
from brdf_qt.documents.recovery_offer import offer_recovery
from brdf_qt.program.translation import mark, moment, tr
from brdf_qt.window.message_bar import Message

from brdf_suite.documents.store import VIEW_ENDING, load_view, save_view, view_from_json, view_to_json
from brdf_suite.documents.studio import LightDocument
from brdf_suite.documents.view import View
from brdf_suite.pipeline.scene import default_view
from brdf_viewer.documents.view_files import ViewFiles
from brdf_viewer.feature import ViewerFeature
from brdf_viewer.light.studio.control import StudioControl
from brdf_viewer.paint.control import PaintControl
from brdf_viewer.scene.viewer_state import ViewerState
from brdf_viewer.window import ViewerWindow

_PAINT = "paint"
FORMAT: DocumentFormat[View] = DocumentFormat(
    kind=mark("view"),
    ending=VIEW_ENDING,
    new=default_view,
    load=load_view,
    save=save_view,
    to_json=view_to_json,
    from_json=view_from_json,
    name_of=lambda _view: "view",
)


class ViewRecovery(ViewerFeature):
    """Keeps the autosave of the view, and offers at the start what an ended run left, its studio first."""

    def __init__(
        self,
        state: ViewerState,
        window: ViewerWindow,
        paint: PaintControl,
        studio: StudioControl,
        views: ViewFiles,
    ) -> None:
        super().__init__(state, window)
        self._paint, self._studio, self._views = paint, studio, views
        self._kept_paint = self._first_paint = ""
        report = partial(self._report, key="autosave")
        self.recovery: Recovery[View] = Recovery(
            state.history, FORMAT, report, self, keeps_history=True, folder="autosave_views"
        )
        self.recovery.beside = lambda: {_PAINT: self._kept_paint}
        self._left: Recovered[View] | None = None
        self._when_lit: Callable[[], object] | None = None
        state.contents_changed.connect(self._contents_changed)
        window.closing.connect(self._forget)

    def start(self) -> None:
        """Offer what was left: each studio by its name, and with the first of them the view; or the view alone."""
        saved = [one for one in self.recovery.found_saved() if self._is_worth(one)]
        found = sorted([*self.recovery.found(), *saved], key=lambda item: item.when, reverse=True)
        for older in found[1:]:
            self.recovery.drop(older)
        self._left = found[0] if found else None
        studios = self._studio.recovery.found()
        if not studios and self._left is not None:
            text = tr("Viewer closed unexpectedly. Recover its view, paint and history of {when}?")
            actions = ((tr("Recover"), self._take_alone), (tr("Discard"), self._drop))
            what = text.format(when=moment(self._left.when))
            self._window.messages.show_message(Message("recovery", what, actions=actions))
        elif not studios:
            self._drop()
        offer_recovery(
            self._window.messages.show_message,
            studios,
            self._take_studio,
            self._studio.recovery.drop,
            tr("Viewer closed unexpectedly. Recover your unsaved work on the studio “{name}” of {when}?"),
            finish=lambda _taken: self._drop(),
        )

    def close(self) -> None:
        """Keep the view for the next start, where the program has to end."""
        self.recovery.close(keep=True)

    def _forget(self) -> None:
        """The user closes the window: what was unsaved has been asked about, and a view never is."""
        for recovery in (self.recovery, self._studio.recovery):
            recovery.close(keep=False)

    def _is_worth(self, item: Recovered[View]) -> bool:
        """Whether anything was done in a run: of an untouched one nothing is worth the question."""
        steps = item.history is not None and len(item.history.states) > 1
        return steps or item.path is not None or bool(_paint_of(item))

    def _contents_changed(self) -> None:
        key = self._paint.name_of(self._state.paint_key)
        if not self._first_paint:
            self._first_paint = key
        kept = "" if key == self._first_paint else key
        if kept != self._kept_paint:
            self._kept_paint = kept
            self.recovery.note()
        environment, then = self._state.environment, self._when_lit
        if then is not None and environment is not None and environment.key == self._state.view.environment:
            self._when_lit = None
            then()

    def _take_view(self) -> bool:
        """Show the view that was left; True where there was one."""
        item, self._left = self._left, None
        if item is None:
            return False
        if item.history is None:
            self._views.show(item.value)
        else:
            self._state.restore(item.history, item.path, item.stamp)
        if _paint_of(item):
            self._paint.open(_paint_of(item))
        if self.recovery.write():
            self.recovery.drop(item)
        return True

    def _take_alone(self) -> None:
        self._take_view()
        key = self._state.view.environment
        for studio in self._studio.recovery.found_saved():
            if str(studio.path) == key:
                self._after_light(partial(self._studio.restore_saved, studio))
                break
        self._drop()

    def _take_studio(self, item: Recovered[LightDocument]) -> bool:
        """Show the view and open a studio; False where the user keeps the present studio."""
        if not self._studio.may_close():
            return False
        if self._take_view():
            self._after_light(partial(self._studio.recover, item))
        else:
            self._studio.recover(item)
        return True

    def _after_light(self, then: Callable[[], object]) -> None:
        """Do what shows another light once that of the view is there: the last one that comes is shown."""
        self._when_lit = then
        self._contents_changed()

    def _drop(self) -> None:
        """Give up what is left."""
        item, self._left = self._left, None
        if item is not None:
            self.recovery.drop(item)
        self.recovery.sweep()
        self._studio.recovery.sweep()


def _paint_of(item: Recovered[View]) -> str:
    """Return the paint that was on show where it was not the first; empty where that is not known."""
    return str(item.beside.get(_PAINT, "")) if isinstance(item.beside, dict) else ""
