"""Between the desk and the window's own parts: edits by field in, what is shown out. No widget is named here."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any, Protocol

from brdf_qt.program.translation import tr
from brdf_qt.window.message_bar import Message, message_of
from PySide6.QtCore import QObject, QTimer

from brdf_designer.session.fields import Key, TooRoughError, apply_edit, step_name
from brdf_designer.session.paint_session import PaintSession
from brdf_designer.session.state import (
    Colours,
    Curves,
    FitState,
    TabState,
    colours_of,
    curves_of,
    fit_state_of,
)
from brdf_suite.documents.paint import Paint
from brdf_suite.errors import SuiteError, UnreachableError
from brdf_suite.pipeline.lobe_fit import LobeFit

_TYPED: tuple[Key, ...] = (("name",), ("source",), ("notes",))


class View(Protocol):
    """What the controller asks of a window."""

    def show_colours(self, colours: Colours) -> None:
        """Show the document."""

    def show_fit(self, state: FitState) -> None:
        """Show reflectance and fit, fresh; what lies between the angles comes by :meth:`show_curves`."""

    def show_curves(self, curves: Curves) -> None:
        """Show what model and lobes give over the aspecular angle, fresh."""

    def mark_fit_stale(self) -> None:
        """Say that what is drawn of reflectance and fit is of the last paint that could be."""

    def show_tabs(self, tabs: Sequence[TabState], front: int) -> None:
        """Show which documents are open, whether they are saved, and which one is in front."""

    def show_reopen(self, can: bool) -> None:
        """Show whether a closed tab can be reopened."""

    def show_history(self, undo: str, redo: str, *, can_undo: bool, can_redo: bool) -> None:
        """Show what Undo and Redo would do, by name."""

    def keep_opened(self) -> None:
        """Take what is shown for what the document had when it was opened: a double click goes back to it."""

    def close_pickers(self) -> None:
        """Close what was open for the document before."""

    def show_message(self, message: Message) -> None:
        """Show a message in the window."""

    def dismiss_message(self, key: str) -> None:
        """Take a message away."""


class Controller(QObject):
    """Keeps the window in step with the desk, and takes the edits of its fields."""

    def __init__(self, view: View, desk: PaintSession, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._view, self._desk, self._documents = view, desk, desk.documents
        self._refused = False
        self._in_hand: tuple[Key, int] | None = None
        # Numbers and patches are set and painted first; strip and curves follow in the next turn of the event loop,
        # once for all the edits of one turn.
        self._later = QTimer(self)
        self._later.setSingleShot(True)
        self._later.setInterval(0)
        self._later.timeout.connect(self._show_curves)
        self._uncurved: LobeFit | None = None
        desk.document_switched.connect(self._switch)
        desk.paint_changed.connect(self._show_paint)
        desk.fit_changed.connect(self._show_fit)
        desk.refused.connect(self._show_refusal)
        desk.gesture_ended.connect(self._settle)
        desk.history_changed.connect(self._show_history)
        self._documents.row_changed.connect(self._show_tabs)
        self._documents.front_changed.connect(self._show_tabs)
        self._documents.failed.connect(view.show_message)
        self._documents.succeeded.connect(view.dismiss_message)

    @property
    def is_idle(self) -> bool:
        """Whether strip and curves are of the paint that the numbers are of, or of the last one that can be."""
        return self._uncurved is None

    def start(self) -> None:
        """Show everything for the first time."""
        self._switch()
        self._desk.refresh()
        self._show_tabs()
        self._show_history()

    def edit(self, key: Key, value: Any) -> None:
        """Take one edit from the window; an edit of another field ends the gesture that runs.

        A hand that still holds a field of the document that was in front before moves nothing of this one.
        """
        if self._is_left_over(key):
            self._refused = True
            return
        paint = self._desk.paint
        try:
            after = apply_edit(paint, key, value)
        except SuiteError as error:
            message = message_of(error, "edit", todo=tr("The last valid value is kept."))
            if isinstance(error, TooRoughError):
                nearest = error.nearest
                text = tr("Use Roughness {roughness:.4f}").format(roughness=nearest[1])
                message = replace(message, actions=((text, lambda: self.edit(key, nearest)),))
            self._view.show_message(message)
            self._refused = True
            return
        self._accepted()
        self._desk.edit(after, step_name(paint, key))

    def begin_gesture(self, key: Key) -> None:
        """A drag, or another run of edits that is one step, begins on field ``key``."""
        self._in_hand = key, self._desk.document_key
        self._desk.begin_gesture(step_name(self._desk.paint, key))

    def end_gesture(self) -> None:
        """The run of edits is over; a field that holds a refused value shows the document again."""
        self._in_hand = None
        self._desk.end_gesture()
        # Where another document has come in front, its gesture was over before.
        self._settle()

    def undo(self) -> None:
        """Take the newest step back."""
        self._desk.undo()

    def redo(self) -> None:
        """Do again what was taken back last."""
        self._desk.redo()

    def open_shipped(self, load: Callable[[], Paint]) -> None:
        """Open a paint that comes with the program, as a document without a file."""
        try:
            paint = load()
        except SuiteError as error:
            self._view.show_message(message_of(error, "open"))
            return
        self._desk.open_paint(paint, clean=True)
        self._view.dismiss_message("open")

    def _accepted(self) -> None:
        self._refused = False
        self._view.dismiss_message("edit")

    def _is_left_over(self, key: Key) -> bool:
        """Whether the gesture that edits ``key`` began on another document; what is typed is of this one."""
        if self._in_hand is None or key in _TYPED:
            return False
        return self._in_hand[0] == key and self._in_hand[1] != self._desk.document_key

    def _settle(self) -> None:
        if self._refused:
            self._accepted()
            self._view.show_colours(colours_of(self._desk.paint))

    def _switch(self) -> None:
        self._accepted()
        self._view.close_pickers()
        # What was said of the document before is no longer so.
        self._view.dismiss_message("fit")
        self._view.show_colours(colours_of(self._desk.original))
        self._view.keep_opened()

    def _show_paint(self, paint: Paint) -> None:
        # A save that failed was of the document before: what is said of it is no longer so.
        self._view.dismiss_message("save")
        self._view.show_colours(colours_of(paint))

    def _show_fit(self, fit: LobeFit) -> None:
        self._view.dismiss_message("fit")
        self._view.show_fit(fit_state_of(fit))
        self._uncurved = fit
        if not self._later.isActive():
            self._later.start()

    def _show_curves(self) -> None:
        fit, self._uncurved = self._uncurved, None
        if fit is not None:
            self._view.show_curves(curves_of(fit))

    def _show_refusal(self, error: SuiteError) -> None:
        # What stays, as stale, is the last paint that could be.
        self._show_curves()
        self._view.mark_fit_stale()
        self._view.show_message(_refusal(error))

    def _show_tabs(self) -> None:
        row, front = self._documents.row, self._documents.front
        tabs = [TabState(item.title, item.store.path, item.store.is_clean) for item in row]
        self._view.show_tabs(tabs, row.index(front))
        self._view.show_reopen(self._documents.can_reopen)

    def _show_history(self) -> None:
        stack = self._documents.front.store.stack
        self._view.show_history(
            stack.undoText(), stack.redoText(), can_undo=stack.canUndo(), can_redo=stack.canRedo()
        )


def _refusal(error: SuiteError) -> Message:
    if isinstance(error, UnreachableError):
        return Message(
            "fit",
            str(error),
            todo=tr(
                "The numbers keep your edit. Curves, strip and the other programs show the "
                "last possible paint."
            ),
            severity="warning",
            closable=False,
        )
    return message_of(error, "fit")
