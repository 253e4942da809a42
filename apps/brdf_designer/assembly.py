"""Puts Designer together: window, document, files, autosave, fitter, link."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path

from brdf_qt.documents.file_reading import FileReading
from brdf_qt.documents.files import DocumentFiles, DocumentFormat
from brdf_qt.documents.open_document import DocumentStore
from brdf_qt.documents.open_tabs import TabsLeft
from brdf_qt.documents.project_files import ProjectFiles
from brdf_qt.documents.projects import is_project
from brdf_qt.documents.recovery_offer import offer_recovery
from brdf_qt.link.link import LiveLink
from brdf_qt.program.application import error_relay
from brdf_qt.program.feature import Feature
from brdf_qt.program.program import Program
from brdf_qt.program.translation import mark, tr
from brdf_qt.window.dialogs import QtDialogs
from brdf_qt.window.fit_choice import FitCommand
from brdf_qt.window.message_bar import Message, message_of
from PySide6.QtGui import QCloseEvent

from brdf_designer.acquire.control import AcquireControl
from brdf_designer.coat_flakes.control import CoatControl
from brdf_designer.colour.commands import ColourCommands
from brdf_designer.colour.nearest_offer import NearestOffer
from brdf_designer.colour.reach import ReachControl
from brdf_designer.controller import Controller
from brdf_designer.documents.paint_drawer import PaintDrawer
from brdf_designer.documents.paint_offer import PaintOffer
from brdf_designer.documents.project_part import DesignerProject
from brdf_designer.documents.tabs import Documents
from brdf_designer.export.control import HandoverControl
from brdf_designer.from_measurement.control import MeasuredControl
from brdf_designer.history.control import HistoryControl
from brdf_designer.lobes.control import LobesControl
from brdf_designer.picture.control import PictureControl
from brdf_designer.session.paint_session import PaintSession
from brdf_designer.standard_comparison.control import StandardControl
from brdf_designer.texture.control import TextureControl
from brdf_designer.variations.control import VariationsControl
from brdf_designer.variations.interpolation_control import InterpolationControl
from brdf_designer.window.window import DesignerWindow
from brdf_suite.documents.paint import Flakes, Gloss, Measurement, Paint
from brdf_suite.documents.store import (
    PAINT_ENDING,
    AnyPaint,
    load_paint,
    paint_from_json,
    paint_to_json,
    save_paint,
)
from brdf_suite.pipeline.lobe_fit import PaintFitter
from brdf_suite.pipeline.material import load_document, load_shipped_paint, paint_names
from brdf_suite.regular_files import is_file

FIRST_PAINT = "blue"
NEW_READINGS = tuple(
    Measurement(45.0, angle, (lightness, 0.0, 0.0))
    for angle, lightness in ((15.0, 75.0), (45.0, 50.0), (110.0, 30.0))
)
PARTS: tuple[Callable[[PaintSession, DesignerWindow], Feature], ...] = (
    ColourCommands,
    ReachControl,
    CoatControl,
    TextureControl,
    NearestOffer,
    PictureControl,
    LobesControl,
    HistoryControl,
    PaintDrawer,
    StandardControl,
    VariationsControl,
    HandoverControl,
    InterpolationControl,
    MeasuredControl,
    AcquireControl,
)
"""The sections, docks and commands, in the order of the inspector.

Each is called with session and window, adds itself to the window and follows the session.
Parts are made before the window is shown. What costs time at a start belongs into :meth:`PaintSession.at_idle`.
"""


def new_paint() -> Paint:
    """Return what New opens: a grey metallic with flakes under a glossy coat, since most paints made here have both."""
    return Paint("Untitled", NEW_READINGS, Gloss(90.0), flakes=Flakes())


def paint_format() -> DocumentFormat[Paint]:
    """Return how paints are made, read and written."""
    return DocumentFormat(
        kind=mark("paint"),
        ending=PAINT_ENDING,
        new=new_paint,
        load=load_paint,
        save=save_paint,
        to_json=paint_to_json,
        from_json=paint_from_json,
        name_of=lambda paint: paint.name,
    )


class Designer(Program):
    """The running Designer."""

    window: DesignerWindow

    def __init__(self, dialogs: Callable[[DesignerWindow], QtDialogs] = QtDialogs) -> None:
        names = paint_names()
        first = load_shipped_paint(FIRST_PAINT) if FIRST_PAINT in names else new_paint()
        super().__init__(DesignerWindow())
        self.reading = FileReading(self.window.progress, self.window)
        self.documents = Documents(
            first,
            paint_format(),
            dialogs(self.window),
            self.reading,
            lambda error: error_relay().report(error, "autosave"),
            self.window,
        )
        self.link = LiveLink("designer", parent=self.window)
        note = tr("Takes effect in Viewer and Designer at their next start, in Lobe Visualizer at once.")
        self.fit = FitCommand(self.window, note)
        self.fitter = PaintFitter(self.fit.settings)
        self.session = PaintSession(self.documents, self.fitter, self.link.publish, self.window, self.window)
        self.window.build(self.session, names)
        self.controller = Controller(self.window, self.session, self.window)
        self._has_closed_documents = False
        self._join()
        self.features += (*(part(self.session, self.window) for part in PARTS), self.link, self.reading)
        part = DesignerProject(self.session, self.feature(PictureControl), self.feature(StandardControl))
        self.projects = ProjectFiles(self.window, part, self.documents.dialogs)
        self.features.append(self.projects)
        measured = self.feature(MeasuredControl)
        self.documents.find_opener = lambda path: (
            partial(self.projects.open, path) if is_project(path) else measured.find_opener(path)
        )
        self.fit.add_to_menu()
        self.window.complete()
        self.controller.start()
        self.window.show_recent(self.files.recent())
        self.start_when_painted()

    @property
    def store(self) -> DocumentStore[Paint]:
        """The store of the paint in front."""
        return self.documents.front.store

    @property
    def files(self) -> DocumentFiles[Paint]:
        """The file work of the paint in front."""
        return self.documents.front.files

    @property
    def is_idle(self) -> bool:
        """Whether all that follows by itself is there: slow work after the last edit, pictures, small and large."""
        return self.controller.is_idle and self.session.is_quiet and super().is_idle

    def start(self) -> None:
        """Do what can wait until the window is painted: plot, link, and unsaved work of earlier runs."""
        self.window.plot.build()
        self.window.order_focus()  # the plots are there now
        # The first fit paid for everything that is done once; its time says nothing about the next ones.
        self.session.refresh()
        super().start()
        self.offer_recovery()

    def offer_recovery(self) -> None:
        """Show a message with the unsaved work and the tabs of earlier runs; nothing where there are none."""
        found, tabs = self.documents.front.recovery.found(), self.documents.record.left()
        if not found and tabs is not None:
            self._offer_tabs(tabs)
        offer_recovery(
            self.window.show_message,
            found,
            self.documents.recover,
            lambda item: self.documents.front.recovery.drop(item),
            tr("Designer closed unexpectedly. Recover your unsaved work on “{name}” of {when}?"),
            tr(
                "Designer closed unexpectedly. Recover unsaved work on {count} paints (newest: {when}): {names}?"
            ),
            lambda taken: self._end_recovery(tabs, taken=taken),
        )

    def _end_recovery(self, tabs: TabsLeft | None, *, taken: bool) -> None:
        """Bring the other tabs back too, where unsaved work was recovered."""
        if tabs is None:
            return
        if taken:
            self.documents.restore_tabs(tabs)
        else:
            self.documents.drop_tabs(tabs)

    def _offer_tabs(self, tabs: TabsLeft) -> None:
        """Offer the saved paints that were open when a run was ended."""
        names = [name for name in map(self.documents.title_of_left, tabs.tabs) if name]
        if not names:
            self.documents.drop_tabs(tabs)
            return
        text = tr("Designer closed unexpectedly. Reopen the paints that were open: {names}?")
        actions = (
            (tr("Reopen"), lambda: self.documents.restore_tabs(tabs)),
            (tr("Discard"), lambda: self.documents.drop_tabs(tabs)),
        )
        what = text.format(names=", ".join(tr("“{name}”").format(name=name) for name in names[:8]))
        self.window.show_message(Message("recovery", what, actions=actions))

    def open(self, name_or_path: str) -> None:
        """Open a paint by name or file; from any other material, named or in a file, a design is started."""
        # As the command has it: a shipped name is that paint, also where a file is called the same.
        if name_or_path in paint_names():
            self.controller.open_shipped(lambda: load_shipped_paint(name_or_path))
            return
        if is_file(name_or_path):
            self.documents.open(Path(name_or_path))
            return

        def show(document: AnyPaint | None) -> None:
            if isinstance(document, Paint):
                self.session.open_paint(document)
            else:
                self.feature(MeasuredControl).open(name_or_path)

        def failed(error: Exception) -> None:
            self.window.show_message(message_of(error, "open", todo=tr("The open paint is unchanged.")))

        # A swatch of a palette's file, or a model.
        self.reading.begin(
            Path(name_or_path), lambda _path, _progress: load_document(name_or_path), show, failed
        )

    def _open_files(self, paths: Sequence[Path]) -> None:
        for path in paths:
            self.documents.open(path)

    def close(self) -> None:
        """Leave the link; unsaved work of a program that has to end is kept for the next start. Only once."""
        if self.closed:
            return
        super().close()
        self.window.pictures.close()
        self.fitter.close()
        if not self._has_closed_documents:
            self.documents.keep_unsaved()

    def _join(self) -> None:
        window, controller, documents = self.window, self.controller, self.documents
        window.new_requested.connect(documents.new)
        window.open_requested.connect(documents.open)
        window.files_dropped.connect(self._open_files)
        window.shipped_requested.connect(
            lambda name: controller.open_shipped(lambda: load_shipped_paint(name))
        )
        window.tabs.chosen.connect(lambda place: documents.show(documents.row[place]))
        window.tabs.close_requested.connect(lambda place: documents.close(documents.row[place]))
        window.tabs.dragged.connect(documents.move)
        window.recent_cleared.connect(lambda: self.files.clear_recent())
        window.close_requested.connect(self._may_close)
        documents.recent_changed.connect(lambda: window.show_recent(self.files.recent()))
        self.paint_offer = PaintOffer(documents, self.session)
        self.link.received.connect(self.paint_offer.received)
        self.link.peers_changed.connect(lambda _count: window.paint_status.show_peers(self.link.peers))

    def _may_close(self, question: QCloseEvent) -> None:
        if self.documents.may_close_all():
            self._has_closed_documents = True
            self.link.close()
            question.accept()
        else:
            question.ignore()
