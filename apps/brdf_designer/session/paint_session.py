"""The paint in front, for every part of Designer: read it, edit it by named steps, follow its changes.

A section is a widget (intents out, setters in) and a control that joins it to the :class:`PaintSession`. No section
knows which tab is in front, or another section.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from time import monotonic
from typing import Any

from brdf_qt.link.messages import BadMessageError
from brdf_qt.program.translation import tr
from brdf_qt.window.main_window import SuiteWindow
from brdf_qt.window.message_bar import Message, message_of
from brdf_qt.work.exact_fit import ExactFit
from brdf_qt.work.timer import make_timer
from PySide6.QtCore import QObject, Signal

from brdf_designer.documents.tabs import Documents, OpenDocument
from brdf_designer.session.edits import Edit, TooRoughError
from brdf_suite.documents.paint import Paint
from brdf_suite.documents.store import paint_to_json
from brdf_suite.errors import SuiteError
from brdf_suite.pipeline.lobe_fit import LobeFit, PaintFitter

QUIET_MS = 40
LONGEST_WAIT_MS = 250
"""A drag that never pauses is followed this often; what cannot keep up with it should run as a task."""
LONGEST_UNFITTED_S = 0.02
"""An edit of a gesture that finds the one before waiting longer than this for its fit is fitted at once."""


class IdleWork(QObject):
    """Runs slow work once the edits pause, or every quarter of a second during a drag: never before the numbers.

    Work is asked for by key; asking again replaces it. One piece runs per turn of the event loop, so that input
    and painting come between two of them.
    """

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._work: dict[str, Callable[[], None]] = {}
        self._since = 0.0
        self._timer = make_timer(self, self._run_one)

    @property
    def waiting(self) -> tuple[str, ...]:
        """The keys of what is still to be done."""
        return tuple(self._work)

    def ask(self, key: str, work: Callable[[], None]) -> None:
        """Do ``work`` when there is time; it takes the place of what was asked under the same key."""
        if not self._work:
            self._since = monotonic()
        self._work[key] = work
        waited = 1000.0 * (monotonic() - self._since)
        self._timer.start(max(0, min(QUIET_MS, round(LONGEST_WAIT_MS - waited))))

    def _run_one(self) -> None:
        if not self._work:
            return
        key = next(iter(self._work))
        work = self._work.pop(key)
        if self._work:
            self._timer.start(0)
        work()


@dataclass
class _Gesture:
    """A run of edits by a field that is held.

    ``document``: key of the one that was in front; ``start``: the paint with which it began, ``None`` where its
    undo step has ended and the field is still held; ``step``: what Undo calls it, as its first edit is called.
    """

    document: int
    start: Paint | None
    step: str = ""


class PaintSession(QObject):
    """The document in front, whichever tab it is.

    Signals
    -------
    paint_changed(Paint)
        The paint is another: by an edit, undo, redo, or because another document is in front.
    fit_changed(LobeFit)
        Reflectance and weights of it, in a gesture in the next turn of the event loop; once more where the exact fit
        follows a time-limited one.
    refused(SuiteError)
        No reflectance or fit can be had of the paint; ``fit`` is ``None``.
    document_switched()
        Another document is in front, or another value was put in its place; comes before ``paint_changed``.
    document_closed(int)
        The document of that ``document_key`` was closed: what was kept for it can go (it comes back with the
        same key where its tab is reopened).
    history_changed()
        Undo or Redo would do something else than before.
    gesture_ended()
        A run of edits that is one step is over, or its field is let go.
    edit_refused()
        A field holds what the paint cannot have.
    preview_changed(LobeFit | None)
        Another paint is to be seen for a moment, or, None, the paint itself again. An edit ends it without a signal:
        all that shows the paint follows it anyway.
    """

    paint_changed = Signal(object)
    fit_changed = Signal(object)
    refused = Signal(object)
    document_switched = Signal()
    document_closed = Signal(int)
    history_changed = Signal()
    gesture_ended = Signal()
    edit_refused = Signal()
    preview_changed = Signal(object)

    def __init__(
        self,
        documents: Documents,
        fitter: PaintFitter,
        publish: Callable[[str, dict[str, Any]], None],
        messages: SuiteWindow,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self.documents = documents
        self._fitter, self._publish, self._messages = fitter, publish, messages
        self._idle = IdleWork(self)
        self._fit: LobeFit | None = None
        # In a gesture numbers and patches are set and painted first: what is under the hand never waits for the fit,
        # and of several edits in one turn of the event loop the newest is fitted.
        self._fitting_later = make_timer(self, self.fit_now)
        self._unfitted_since = 0.0
        self.in_preview = False
        """Whether another paint is seen for a moment."""
        self._gesture: _Gesture | None = None
        self._shown_history: tuple[str, str, bool, bool] | None = None
        self._reachable = documents.front.store.value
        self.fitting = fitter.settings
        """How lobes are fitted in this run."""
        self._exact = ExactFit(self)
        self._exact.arrived.connect(self._take_exact)
        # The same fit again: it no longer says that an exact one follows.
        self._exact.failed.connect(lambda fit, _error: self._take_exact(fit))
        # Several changes in one turn of the event loop are sent to the other programs once, the newest.
        self._publishing = make_timer(self, self._publish_now)
        self._watched: set[int] = set()
        for document in documents.row:
            self._watch(document)
        documents.opened.connect(self._watch)
        documents.closed.connect(lambda document: self.document_closed.emit(document.key))
        documents.front_changed.connect(self._switched)

    # What is in front.

    @property
    def paint(self) -> Paint:
        """The paint as it is now."""
        return self.documents.front.store.value

    @property
    def original(self) -> Paint:
        """The paint as it was when its tab was opened: what a double click on a number goes back to."""
        return self.documents.front.original

    @property
    def document_key(self) -> int:
        """A number of the document's own, to keep something for it beside the paint."""
        return self.documents.front.key

    @property
    def fit(self) -> LobeFit | None:
        """The fit of the paint as it is now, made if it is still to come; ``None`` while no such paint can be."""
        if self.is_fitting:
            self.fit_now()
        return self._fit

    @property
    def is_fitting(self) -> bool:
        """Whether the fit of the paint is still to come."""
        return self._fitting_later.isActive()

    @property
    def in_gesture(self) -> bool:
        """Whether a gesture runs."""
        return self._gesture is not None and self._gesture.start is not None

    # Editing.

    def edit(self, edit: Edit) -> None:
        """Apply ``edit``; what the paint refuses is shown as a message and reported by :attr:`edit_refused`.

        The edits of a gesture are applied to the paint with which it began: a drag there and back ends where it
        began, also where it passed a limit on the way. A field that is held since another document was in front
        changes nothing of this one.
        """
        paint, gesture = self.paint, self._gesture
        if gesture is not None and gesture.document != self.document_key and edit.is_dragged:
            self.edit_refused.emit()
            return
        step = edit.step(paint)
        if gesture is not None and gesture.start is not None and gesture.step == step:
            paint = gesture.start
        try:
            after = edit.apply(paint)
        except SuiteError as error:
            message = message_of(error, "edit", todo=tr("The last valid value is kept."))
            if isinstance(error, TooRoughError):
                nearest = error.nearest
                text = tr("Use Roughness {roughness:.4f}").format(roughness=nearest.roughness)
                message = replace(message, actions=((text, lambda: self.edit(nearest)),))
            self.show_message(message)
            self.edit_refused.emit()
            return
        self.dismiss_message("edit")
        self.set_paint(after, step)

    def set_paint(self, paint: Paint, step: str) -> None:
        """Make ``paint`` the document, undone as ``step``; nothing where it is the same already.

        Part of the running gesture where that has no other name; the edit of anything else ends that gesture first.
        """
        store, gesture = self.documents.front.store, self._gesture
        if gesture is not None and gesture.start is not None:
            if not gesture.step:
                gesture.step = step
                store.begin_gesture(step)
            elif gesture.step != step:
                self._end_step()
        store.set(paint, step)

    def begin_gesture(self) -> None:
        """Merge the edits that follow into one step, which has the name of the first, until :meth:`end_gesture`."""
        self.end_gesture()
        self._gesture = _Gesture(self.document_key, self.paint)

    def end_gesture(self) -> None:
        """End the gesture, as its field is let go; nothing where none runs."""
        self._end_step(let_go=True)

    def undo(self) -> None:
        """Take the newest step back."""
        self._end_step()
        self.documents.front.store.undo()

    def redo(self) -> None:
        """Do again what was taken back last."""
        self._end_step()
        self.documents.front.store.redo()

    def go_to(self, place: int) -> None:
        """Go to a state of the history by its place in :meth:`DocumentStore.states`; nothing of it is lost."""
        self._end_step()
        self.documents.front.store.go_to(place)

    def _end_step(self, *, let_go: bool = False) -> None:
        self.documents.front.store.end_gesture()
        gesture = self._gesture
        if gesture is None:
            return
        if self.is_fitting:
            self.fit_now()
        ended = let_go or gesture.start is not None
        gesture.start = None
        if let_go:
            self._gesture = None
        if ended:
            self.gesture_ended.emit()

    def open_paint(self, paint: Paint, title: str = "", *, clean: bool = False) -> None:
        """Open ``paint`` in a tab of its own, in front, without a file; ``title`` becomes its name.

        It is unsaved work, which closing asks about, unless ``clean`` says that it can be had again.
        """
        self._end_step()
        self.documents.add(replace(paint, name=title) if title else paint, clean=clean)

    # Seeing without editing.

    def preview(self, paint: Paint) -> None:
        """Let ``paint`` be seen in the picture and the patches, until :meth:`end_preview` or an edit.

        Nothing is seen of a paint that cannot be.
        """
        try:
            fit = self._fitter.fit(paint)
        except SuiteError:
            self.end_preview()
            return
        self.in_preview = True
        self.preview_changed.emit(fit)

    def end_preview(self) -> None:
        """Let the paint itself be seen again."""
        if self.in_preview:
            self.in_preview = False
            self.preview_changed.emit(None)

    # Notifications.

    def show_message(self, message: Message) -> None:
        """Show a message in the window."""
        self._messages.show_message(message)

    def dismiss_message(self, key: str) -> None:
        """Take a message away."""
        self._messages.dismiss_message(key)

    def at_idle(self, key: str, work: Callable[[], None]) -> None:
        """Do slow ``work`` (some milliseconds) once the edits pause; see :class:`IdleWork`.

        What takes longer than a frame belongs on a thread (:class:`brdf_qt.work.tasks.TaskRunner`), submitted from
        here.
        """
        self._idle.ask(key, work)

    @property
    def is_quiet(self) -> bool:
        """Whether all work that was asked for at idle is done."""
        return not self._idle.waiting

    def refresh(self) -> None:
        """Notify all parts and the other programs of the paint."""
        paint = self.paint
        self.in_preview = False
        self.paint_changed.emit(paint)
        if paint is not self.paint:
            # A listener has changed it, and the later ones were notified of the newer one.
            return
        if not self.in_gesture:
            self.fit_now()
        elif not self.is_fitting:
            self._exact.forget()
            self._unfitted_since = monotonic()
            self._fitting_later.start()
        elif monotonic() - self._unfitted_since > LONGEST_UNFITTED_S:
            self.fit_now()  # the next turn does not come: events come faster than they are worked at

    def fit_now(self) -> None:
        """Fit the paint as it is, also where that was to come in the next turn of the event loop."""
        self._fitting_later.stop()
        paint = self.paint
        try:
            fit = self._fitter.fit(paint)
        except SuiteError as error:
            self._fit = None
            self._exact.forget()
            self.refused.emit(error)
        else:
            self._fit = fit
            self._exact.watch(fit)
            self._reachable = paint
            self.fit_changed.emit(fit)
            self._publishing.start()

    def _take_exact(self, fit: LobeFit) -> None:
        # The other programs fit the paint themselves.
        self._fit = fit
        self.fit_changed.emit(fit)

    def _watch(self, document: OpenDocument) -> None:
        if document.key in self._watched:
            return  # it was closed and reopened
        self._watched.add(document.key)
        store = document.store

        def when_in_front(action: Callable[[], None]) -> Callable[..., None]:
            return lambda *_: action() if document is self.documents.front else None

        store.changed.connect(when_in_front(self.refresh))
        store.replaced.connect(when_in_front(self._switched))
        store.history_changed.connect(when_in_front(self._history_changed))

    def _history_changed(self) -> None:
        # The stack reports every push, also where a drag goes on and nothing reads otherwise.
        stack = self.documents.front.store.stack
        now = (stack.undoText(), stack.redoText(), stack.canUndo(), stack.canRedo())
        if now != self._shown_history:
            self._shown_history = now
            self.history_changed.emit()

    def _switched(self) -> None:
        if self._gesture is not None:
            self._gesture.start = None
        self._shown_history = None
        self.document_switched.emit()
        self.refresh()
        self.history_changed.emit()

    def _publish_now(self) -> None:
        try:
            self._publish("paint", paint_to_json(self._reachable))
        except BadMessageError as error:
            what = tr("The paint could not be sent to the other programs: {reason}.").format(reason=error)
            self.show_message(
                Message("link", what, todo=tr("They keep the previous paint."), severity="warning")
            )
        else:
            self.dismiss_message("link")
