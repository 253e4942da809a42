"""Puts Designer together: window, document, files, autosave, fitter, link."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path

from brdf_qt.application import error_relay
from brdf_qt.dialogs import Dialogs, QtDialogs
from brdf_qt.document_files import DocumentFiles, DocumentFormat
from brdf_qt.document_store import DocumentStore
from brdf_qt.link import LiveLink
from brdf_qt.message_bar import Message
from brdf_qt.recovery import Recovery
from PySide6.QtCore import QCoreApplication, QProcess, QTimer
from PySide6.QtGui import QCloseEvent

from brdf_designer.controller import Controller, Parts
from brdf_designer.window import DesignerWindow
from brdf_suite.documents.paint import Paint, solid_paint
from brdf_suite.documents.store import (
    PAINT_ENDING,
    load_paint,
    paint_from_json,
    paint_to_json,
    save_paint,
)
from brdf_suite.pipeline.paint import PaintFitter
from brdf_suite.resources import resource, resource_names

FIRST_PAINT = "blue"


def new_paint() -> Paint:
    """Return what New opens: a solid mid grey under a glossy coat."""
    return solid_paint("Untitled", (50.0, 0.0, 0.0))


def shipped_paint(name: str) -> Paint:
    """Return the packaged paint ``name``."""
    return load_paint(resource("paints", name + PAINT_ENDING))


def paint_format() -> DocumentFormat[Paint]:
    """Return how paints are made, read and written."""
    return DocumentFormat(
        kind="paint",
        ending=PAINT_ENDING,
        new=new_paint,
        load=load_paint,
        save=save_paint,
        to_json=paint_to_json,
        from_json=paint_from_json,
        name_of=lambda paint: paint.name,
    )


class Designer:
    """The program's parts, joined; ``window`` is not yet shown."""

    def __init__(self, dialogs: Callable[[DesignerWindow], Dialogs] = QtDialogs) -> None:
        form = paint_format()
        names = resource_names("paints", PAINT_ENDING)
        first = shipped_paint(FIRST_PAINT) if FIRST_PAINT in names else new_paint()
        self.window = DesignerWindow(names)
        self.store: DocumentStore[Paint] = DocumentStore(first, self.window)
        self.files = DocumentFiles(self.store, form, dialogs(self.window), self.window)
        self.recovery = Recovery(self.store, form, self._autosave_failed, self.window)
        self.link = LiveLink("designer", parent=self.window)
        self.fitter = PaintFitter()
        parts = Parts(self.store, self.files, self.recovery, self.fitter, self.link.publish)
        self.controller = Controller(self.window, parts, self.window)
        self._closed = False
        self._join()
        self.controller.refresh()
        self.window.keep_opened()
        self._show_history()
        self.window.show_recent(self.files.recent())

    def start(self) -> None:
        """Do what can wait until the window is painted: plot, link, and unsaved work of earlier runs."""
        self.window.plot.build()
        # The first fit paid for everything that is done once; its time says nothing about the next ones.
        self.controller.refresh()
        self.link.start()
        self.controller.offer_recovery()

    def open(self, name_or_path: str) -> None:
        """Open a file, or a shipped paint by its name."""
        # As the command has it: a shipped name is that paint, also where a file is called the same.
        if name_or_path in resource_names("paints", PAINT_ENDING):
            self.controller.open_shipped(lambda: shipped_paint(name_or_path))
        else:
            self.files.open(Path(name_or_path))

    def close(self) -> None:
        """Leave the link; unsaved work of a program that is told to end is kept for the next start."""
        self.link.close()
        self.fitter.close()
        if not self._closed:
            self._closed = True
            self.recovery.close(keep=True)

    def _join(self) -> None:
        window, controller, files = self.window, self.controller, self.files
        window.edited.connect(controller.edit)
        window.gesture_started.connect(controller.begin_gesture)
        window.gesture_finished.connect(controller.end_gesture)
        window.new_asked.connect(files.new)
        window.open_asked.connect(files.open)
        window.shipped_asked.connect(lambda name: controller.open_shipped(lambda: shipped_paint(name)))
        window.save_asked.connect(files.save)
        window.save_as_asked.connect(files.save_as)
        window.undo_asked.connect(controller.undo)
        window.redo_asked.connect(controller.redo)
        window.viewer_asked.connect(self._open_viewer)
        window.recent_cleared.connect(files.clear_recent)
        window.close_asked.connect(self._may_close)
        window.first_painted.connect(lambda: QTimer.singleShot(0, self.start))
        self.recovery.written_again.connect(lambda: window.dismiss_message("autosave"))
        files.recent_changed.connect(lambda: window.show_recent(files.recent()))
        self.store.history_changed.connect(self._show_history)
        self.store.replaced.connect(window.close_pickers)
        # After the controller, which has shown the document by then.
        self.store.replaced.connect(window.keep_opened)
        self.link.peers_changed.connect(lambda _count: window.desk_status.show_peers(self.link.peers))
        app = QCoreApplication.instance()
        if app is not None:
            app.aboutToQuit.connect(self.close)

    def _show_history(self) -> None:
        stack = self.store.stack
        self.window.show_history(
            stack.undoText(), stack.redoText(), can_undo=stack.canUndo(), can_redo=stack.canRedo()
        )

    def _may_close(self, question: QCloseEvent) -> None:
        if self.controller.may_close():
            self._closed = True
            self.link.close()
            question.accept()
        else:
            question.ignore()

    def _autosave_failed(self, error: BaseException) -> None:
        error_relay().report(error, "autosave")

    def _open_viewer(self) -> None:
        started, _ = QProcess.startDetached(sys.executable, ["-m", "brdf_viewer"])
        if not started:
            self.window.show_message(
                Message("viewer", "Viewer could not be started.", todo="Start it by hand: brdf-viewer.")
            )
