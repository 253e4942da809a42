"""The window of the assistant: the steps at the left, the page of one of them, messages and progress over it.

Closing it only hides it: what runs goes on, what was found stays, and nothing is asked.
"""

from __future__ import annotations

from typing import Literal

from brdf_qt.fields.form import fill_column, row_of
from brdf_qt.fields.labels import plain_tip
from brdf_qt.program.icons import icon
from brdf_qt.program.settings import settings
from brdf_qt.program.translation import mark, tr
from brdf_qt.window.message_bar import MessageBar
from brdf_qt.window.progress_strip import ProgressStrip
from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QCloseEvent, QDragEnterEvent, QDropEvent, QHideEvent, QKeySequence, QShortcut
from PySide6.QtWidgets import (
    QFrame,
    QListWidget,
    QListWidgetItem,
    QPushButton,
    QStackedWidget,
    QWidget,
)

from brdf_designer.acquire.camera_response.page import ResponsePage
from brdf_designer.acquire.exposures.page import ExposuresPage
from brdf_designer.acquire.fit.page import FitPage
from brdf_designer.acquire.geometry.page import GeometryPage
from brdf_designer.acquire.mask.page import MaskPage
from brdf_designer.acquire.reconstruction.coverage_page import CoveragePage
from brdf_designer.acquire.reconstruction.reconstruction_page import ReconstructionPage
from brdf_designer.acquire.session.page import SessionPage
from brdf_designer.acquire.step_page import AcquirePage

StepState = Literal["todo", "running", "done", "warning"]
_STATES: dict[StepState, tuple[tuple[str, str], str]] = {
    "todo": (("circle", ""), mark("pending")),
    "running": (("hourglass", ""), mark("running")),
    "done": (("check-circle-fill", "good"), mark("done")),
    "warning": (("warning-fill", "warning"), mark("check result")),
}
"""The sign of each state of a step with its colour, and its word."""
STEPS = {
    "session": mark("Session"),
    "exposures": mark("Exposures"),
    "response": mark("Response"),
    "geometry": mark("Geometry"),
    "mask": mark("Mask"),
    "reconstruction": mark("Reconstruction"),
    "coverage": mark("Coverage"),
    "fit": mark("Fit"),
}
KEYS = tuple(STEPS)
_GEOMETRY = "acquire/geometry"
_SIZE = QSize(1280, 820)
_LEAST = QSize(860, 560)
_RAIL = 172


class AcquireWindow(QWidget):
    """All pages, and the way between them.

    Intents: ``step_shown(key)``, ``undo_requested()``, ``redo_requested()``, ``folder_dropped(str)``,
    ``all_requested()``, ``hidden()``, ``brought()``.
    """

    step_shown = Signal(str)
    undo_requested = Signal()
    redo_requested = Signal()
    folder_dropped = Signal(str)
    all_requested = Signal()
    hidden = Signal()
    brought = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent, Qt.WindowType.Window)
        self.setObjectName("AcquireWindow")
        self.setAcceptDrops(True)
        self.setMinimumSize(_LEAST)
        self.session, self.exposures, self.response = SessionPage(), ExposuresPage(), ResponsePage()
        self.geometry_page, self.mask_page = GeometryPage(), MaskPage()
        self.reconstruction, self.coverage, self.fit = ReconstructionPage(), CoveragePage(), FitPage()
        taking = (self.session, self.exposures, self.response, self.geometry_page, self.mask_page)
        pages: tuple[AcquirePage, ...] = (*taking, self.reconstruction, self.coverage, self.fit)
        self.pages = {page.key: page for page in pages}
        self.messages, self.progress = MessageBar(), ProgressStrip()
        self.rail = QListWidget()
        self.rail.setAccessibleName(tr("Steps"))
        self.rail.setToolTip(tr("Steps; Alt+1 to Alt+8, Ctrl+PgUp and Ctrl+PgDown move between them"))
        self.rail.setFixedWidth(_RAIL)
        self.rail.setFrameShape(QFrame.Shape.NoFrame)
        self.rail.setIconSize(QSize(18, 18))
        self.rail.setSpacing(2)
        self.rail.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.stack = QStackedWidget()
        for number, key in enumerate(KEYS, 1):
            item = QListWidgetItem()
            item.setToolTip(plain_tip(tr("Alt+{number}").format(number=number)))
            self.rail.addItem(item)
            self.stack.addWidget(self.pages[key])
            self.show_step(key, "todo", "")
        self.rail.currentRowChanged.connect(self._changed)
        self._build()
        self._shortcuts()
        self.show_title("")
        self.rail.setCurrentRow(0)
        self.resize(_SIZE.boundedTo(self.screen().availableSize() * 0.9))
        kept = settings().value(_GEOMETRY)
        if kept is not None:
            self.restoreGeometry(kept)

    def _build(self) -> None:
        self.back, self.next = QPushButton(tr("Back")), QPushButton(tr("Next"))
        self.back.setIcon(icon("arrow-left"))
        self.next.setIcon(icon("arrow-right"))
        self.back.setToolTip(tr("Previous step (Ctrl+PgUp)"))
        self.next.setToolTip(tr("Next step (Ctrl+PgDown)"))
        self.back.clicked.connect(lambda: self.go(-1))
        self.next.clicked.connect(lambda: self.go(1))
        self.all = QPushButton(tr("Do All Steps"))
        self.all.setToolTip(tr("Run response, geometry, reconstruction and fit in order"))
        self.all.clicked.connect(lambda: self.all_requested.emit())
        foot = row_of(None, self.all, self.back, self.next, margins=(8, 8, 8, 8))
        line = QFrame()
        line.setFrameShape(QFrame.Shape.HLine)
        line.setFrameShadow(QFrame.Shadow.Plain)
        line.setForegroundRole(line.foregroundRole().Mid)
        inside = QWidget()
        fill_column(inside, self.stack, line, foot, grows=self.stack, spacing=0)
        self._inside = inside
        self.setLayout(row_of(self.rail, inside, grows=inside, spacing=0))

    def _shortcuts(self) -> None:
        for keys, slot in (
            ("Ctrl+Z", self.undo_requested.emit),
            ("Ctrl+Shift+Z", self.redo_requested.emit),
            ("Ctrl+Y", self.redo_requested.emit),
            ("Ctrl+PgUp", lambda: self.go(-1)),
            ("Ctrl+PgDown", lambda: self.go(1)),
            ("Ctrl+W", self.close),
            *((f"Alt+{n}", lambda n=n: self.show_page(KEYS[n - 1])) for n in range(1, len(KEYS) + 1)),
        ):
            QShortcut(QKeySequence(keys), self).activated.connect(slot)

    # What is shown.

    @property
    def step(self) -> str:
        """The key of the step that is shown."""
        return KEYS[max(0, self.rail.currentRow())]

    def show_page(self, key: str) -> None:
        """Show the page of a step."""
        self.rail.setCurrentRow(KEYS.index(key))

    def go(self, by: int) -> None:
        """Go ``by`` steps on, or back."""
        self.rail.setCurrentRow(min(len(KEYS) - 1, max(0, self.rail.currentRow() + by)))

    def show_step(self, key: str, state: StepState, text: str) -> None:
        """Show the state of a step, and a few words of what came of it."""
        number, (sign, word) = KEYS.index(key) + 1, _STATES[state]
        item, title = self.rail.item(number - 1), tr(STEPS[key])
        item.setIcon(icon(*sign))
        item.setText(f"{number}  {title}\n{text or tr(word)}")
        spoken = tr("Step {number}, {title}: {state}").format(
            number=number, title=title, state=f"{tr(word)} {text}".strip()
        )
        item.setData(Qt.ItemDataRole.AccessibleTextRole, spoken)

    def show_title(self, name: str) -> None:
        """Show whose photographs these are."""
        self.setWindowTitle(tr("Acquire: {name}").format(name=name) if name else tr("Acquire"))

    def _changed(self, row: int) -> None:
        if row < 0:
            return
        self.stack.setCurrentIndex(row)
        for part in (self.messages, self.progress):
            part.float_over(self.pages[KEYS[row]].middle, self._inside)
        self.back.setEnabled(row > 0)
        self.next.setEnabled(row < len(KEYS) - 1)
        self.step_shown.emit(KEYS[row])

    # Coming and going.

    def bring(self) -> None:
        """Show the window, in front."""
        self.show()
        self.brought.emit()
        self.setWindowState(self.windowState() & ~Qt.WindowState.WindowMinimized)
        self.raise_()
        self.activateWindow()

    def closeEvent(self, event: QCloseEvent) -> None:
        settings().setValue(_GEOMETRY, self.saveGeometry())
        event.accept()

    def hideEvent(self, event: QHideEvent) -> None:
        super().hideEvent(event)
        if not event.spontaneous():
            self.hidden.emit()

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        urls = event.mimeData().urls()
        if len(urls) == 1 and urls[0].isLocalFile():
            event.acceptProposedAction()

    def dropEvent(self, event: QDropEvent) -> None:
        event.acceptProposedAction()
        self.folder_dropped.emit(event.mimeData().urls()[0].toLocalFile())
