"""Between the document and the window: edits in, what the desk shows out. No widget is named here."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Protocol

from brdf_qt.document_files import DocumentFiles
from brdf_qt.document_store import DocumentStore
from brdf_qt.exact_fit import ExactFit
from brdf_qt.link_messages import BadMessageError
from brdf_qt.message_bar import Message, message_of
from brdf_qt.recovery import Recovered, Recovery
from PySide6.QtCore import QObject, QTimer

from brdf_designer.desk_state import Colours, FitState, colours_of, fit_state_of
from brdf_designer.fields import Key, edited, step_name
from brdf_suite.documents.paint import Paint
from brdf_suite.documents.store import paint_to_json
from brdf_suite.errors import SuiteError, UnreachableError
from brdf_suite.pipeline.paint import PaintFit


class View(Protocol):
    """What the controller asks of a window."""

    def show_colours(self, colours: Colours) -> None:
        """Show the document."""

    def show_fit(self, state: FitState) -> None:
        """Show reflectance and fit, fresh."""

    def mark_fit_stale(self) -> None:
        """Say that what is drawn of reflectance and fit is of the last paint that could be."""

    def show_document(self, title: str, path: Path | None, clean: bool) -> None:
        """Show which file is open and whether it is saved."""

    def show_message(self, message: Message) -> None:
        """Show a message in the window."""

    def dismiss_message(self, key: str) -> None:
        """Take a message away."""


class Fitter(Protocol):
    """What turns a paint into weights: :class:`brdf_suite.pipeline.paint.PaintFitter`."""

    def fit(self, paint: Paint) -> PaintFit:
        """Return the fit, or raise :class:`UnreachableError`."""


@dataclass(frozen=True)
class Parts:
    """What a controller works with."""

    store: DocumentStore[Paint]
    files: DocumentFiles[Paint]
    recovery: Recovery[Paint]
    fitter: Fitter
    publish: Callable[[str, dict[str, Any]], None]


class Controller(QObject):
    """Keeps window, document, fit and link in step."""

    def __init__(self, view: View, parts: Parts, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._view = view
        self._store, self._files, self._recovery = parts.store, parts.files, parts.recovery
        self._fitter, self._publish = parts.fitter, parts.publish
        self._gesture: Key | None = None
        self._refused = False
        self._reachable = parts.store.value
        self._exact = ExactFit(self)
        self._exact.arrived.connect(self._show_exact)
        # The same fit again: it no longer says that an exact one follows.
        self._exact.failed.connect(lambda fit, _error: self._show_exact(fit))
        # Several changes in one turn of the event loop are told to the other programs once, the newest.
        self._publishing = QTimer(self)
        self._publishing.setSingleShot(True)
        self._publishing.setInterval(0)
        self._publishing.timeout.connect(self._publish_now)
        self._store.changed.connect(lambda _old, _new: self.refresh())
        # A save that failed was of the document before: what is said of it is no longer so.
        self._store.changed.connect(lambda _old, _new: view.dismiss_message("save"))
        self._store.replaced.connect(lambda: view.dismiss_message("save"))
        self._store.replaced.connect(self._replaced)
        self._store.path_changed.connect(lambda _path: self._show_document())
        self._store.clean_changed.connect(lambda _clean: self._show_document())
        self._files.failed.connect(view.show_message)
        self._files.succeeded.connect(view.dismiss_message)

    def refresh(self) -> None:
        """Work out everything that is shown of the document, and tell the other programs."""
        paint = self._store.value
        self._view.show_colours(colours_of(paint))
        try:
            fit = self._fitter.fit(paint)
        except SuiteError as error:
            self._exact.forget()
            self._view.mark_fit_stale()
            self._view.show_message(_refusal(error))
        else:
            self._view.dismiss_message("fit")
            self._exact.watch(fit)
            self._view.show_fit(fit_state_of(fit))
            self._reachable = paint
            self._publishing.start()
        self._show_document()

    def _show_exact(self, fit: PaintFit) -> None:
        """Show the optimum where the time limit came first; the other programs fit the paint themselves."""
        self._view.show_fit(fit_state_of(fit))

    def edit(self, key: Key, value: Any) -> None:
        """Take one edit from the window; an edit of another field ends the gesture that runs."""
        if self._gesture is not None and self._gesture != key:
            self.end_gesture()
        paint = self._store.value
        try:
            after = edited(paint, key, value)
        except SuiteError as error:
            self._view.show_message(message_of(error, "edit", todo="The paint keeps its last valid value."))
            self._refused = True
            return
        self._accepted()
        self._store.set(after, step_name(paint, key))

    def begin_gesture(self, key: Key) -> None:
        """A drag, or another run of edits that is one step, begins on field ``key``."""
        self._gesture = key
        self._store.begin_gesture(step_name(self._store.value, key))

    def end_gesture(self) -> None:
        """The run of edits is over; a field that holds a refused value shows the document again."""
        self._gesture = None
        self._store.end_gesture()
        if self._refused:
            self._accepted()
            self._view.show_colours(colours_of(self._store.value))

    def _accepted(self) -> None:
        self._refused = False
        self._view.dismiss_message("edit")

    def undo(self) -> None:
        """Take the newest step back."""
        self.end_gesture()
        self._store.undo()

    def redo(self) -> None:
        """Do again what was taken back last."""
        self.end_gesture()
        self._store.redo()

    def open_shipped(self, load: Callable[[], Paint]) -> None:
        """Open a paint that comes with the program, as a document without a file."""
        try:
            paint = load()
        except SuiteError as error:
            self._view.show_message(message_of(error, "open"))
            return
        if self._files.open_value(paint):
            self._view.dismiss_message("open")

    def offer_recovery(self) -> None:
        """Offer the unsaved work of runs that were ended, one after the other; nothing is opened unasked."""
        self._offer(self._recovery.found())

    def may_close(self) -> bool:
        """Ask about unsaved changes; True where the window may go, and the autosave with it."""
        if not self._files.may_discard():
            return False
        self._recovery.close(keep=False)
        return True

    def _offer(self, items: list[Recovered[Paint]]) -> None:
        if not items:
            return
        item, rest = items[0], items[1:]

        def take() -> None:
            if self._files.may_discard():
                self._recovery.take(item)
                self._offer(rest)
            else:
                self._offer(items)

        def drop() -> None:
            self._recovery.drop(item)
            self._offer(rest)

        name = item.path.name if item.path else item.value.name
        more = f" ({len(rest)} more)" if rest else ""
        message = Message(
            "recovery",
            f"Unsaved work on “{name}” was found, from {item.when:%d %B, %H:%M}{more}.",
            todo="An earlier run ended before it was saved. Recover opens it; the file on disk is unchanged.",
            actions=(("Recover", take), ("Discard", drop)),
        )
        self._view.show_message(message)

    def _replaced(self) -> None:
        self._gesture = None
        self._accepted()
        self.refresh()

    def _publish_now(self) -> None:
        try:
            self._publish("paint", paint_to_json(self._reachable))
        except BadMessageError as error:
            what = f"The paint cannot be told to the other programs: {error}."
            self._view.show_message(
                Message("link", what, todo="They keep the paint before.", severity="warning")
            )
        else:
            self._view.dismiss_message("link")

    def _show_document(self) -> None:
        self._view.show_document(self._files.title(), self._store.path, self._store.is_clean)


def _refusal(error: SuiteError) -> Message:
    if isinstance(error, UnreachableError):
        return Message(
            "fit",
            str(error),
            todo="The numbers keep your edit; curve, strip and the other programs show the last paint that can be.",
            severity="warning",
            closable=False,
        )
    return message_of(error, "fit")
