"""Shows the paint session in the window's own parts. No widget is named here."""

from __future__ import annotations

from collections.abc import Callable

from brdf_qt.program.translation import tr
from brdf_qt.window.message_bar import Message, message_of
from brdf_qt.work.timer import make_timer
from PySide6.QtCore import QObject

from brdf_designer.session.paint_session import PaintSession
from brdf_designer.session.state import TabState, colours_of, curves_of, fit_state_of
from brdf_designer.window.window import DesignerWindow
from brdf_suite.documents.paint import Paint
from brdf_suite.errors import SuiteError, UnreachableError
from brdf_suite.pipeline.lobe_fit import LobeFit


class Controller(QObject):
    """Keeps the window in step with the session."""

    def __init__(self, view: DesignerWindow, session: PaintSession, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._view, self._session, self._documents = view, session, session.documents
        self._refused = False
        # Numbers and patches are set and painted first; strip and curves follow in the next turn of the event loop,
        # once for all the edits of one turn; in a gesture so does the fit.
        self._later = make_timer(self, self._show_curves)
        self._uncurved: LobeFit | None = None
        session.document_switched.connect(self._switch)
        session.paint_changed.connect(self._show_paint)
        session.fit_changed.connect(self._show_fit)
        session.refused.connect(self._show_refusal)
        session.edit_refused.connect(self._note_refusal)
        session.gesture_ended.connect(self._settle)
        session.preview_changed.connect(self._show_preview)
        session.history_changed.connect(self._show_history)
        self._documents.row_changed.connect(self._show_tabs)
        self._documents.front_changed.connect(self._show_tabs)
        self._documents.failed.connect(view.show_message)
        self._documents.succeeded.connect(view.dismiss_message)

    @property
    def is_idle(self) -> bool:
        """Whether strip and curves are of the paint that the numbers are of, or of the last one that can be."""
        return self._uncurved is None and not self._session.is_fitting

    def start(self) -> None:
        """Show everything for the first time."""
        self._switch()
        self._session.refresh()
        self._show_tabs()
        self._show_history()

    def open_shipped(self, load: Callable[[], Paint]) -> None:
        """Open a paint that comes with the program, as a document without a file."""
        try:
            paint = load()
        except SuiteError as error:
            self._view.show_message(message_of(error, "open"))
            return
        self._session.open_paint(paint, clean=True)
        self._view.dismiss_message("open")

    def _accepted(self) -> None:
        self._refused = False
        self._view.dismiss_message("edit")

    def _note_refusal(self) -> None:
        self._refused = True

    def _settle(self) -> None:
        """Show the document again in a field that holds a refused value."""
        if self._refused:
            self._accepted()
            self._view.show_colours(colours_of(self._session.paint))

    def _switch(self) -> None:
        self._accepted()
        self._view.close_pickers()
        # What was said of the document before is no longer so.
        self._view.dismiss_message("fit")
        self._view.show_colours(colours_of(self._session.original))
        self._view.keep_opened()

    def _show_paint(self, paint: Paint) -> None:
        self._refused = False
        # A save that failed was of the document before: what is said of it is no longer so.
        self._view.dismiss_message("save")
        self._view.show_colours(colours_of(paint))

    def _show_fit(self, fit: LobeFit) -> None:
        self._view.dismiss_message("fit")
        self._view.show_fit(fit_state_of(fit))
        self._uncurved = fit
        if self._session.in_gesture:
            self._show_curves()
        elif not self._later.isActive():
            self._later.start()

    def _show_preview(self, fit: LobeFit | None) -> None:
        """Show another paint for a moment in patches and strip; None: the paint itself again."""
        self._view.show_patches(colours_of(self._session.paint if fit is None else fit.paint))
        shown = fit or self._session.fit
        if shown is None:
            self._view.patches.show_differences(None)
        else:
            self._view.show_given(fit_state_of(shown))
            self._view.strip.show_curves(curves_of(shown))

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
        tabs = [TabState(item.key, item.title, item.store.path, item.store.is_clean) for item in row]
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
