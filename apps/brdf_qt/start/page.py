"""The start page: paints to begin with, recent work, and what else one can begin. It imports nothing heavy, so that
it is on the screen while the program behind it is still being loaded.
"""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QSize, Qt, QTimer, Signal
from PySide6.QtGui import QKeyEvent, QKeySequence, QPainter, QPaintEvent, QPalette, QShortcut, QShowEvent
from PySide6.QtWidgets import (
    QApplication,
    QButtonGroup,
    QCheckBox,
    QFrame,
    QHBoxLayout,
    QListWidget,
    QListWidgetItem,
    QProgressBar,
    QPushButton,
    QScrollArea,
    QSizePolicy,
    QToolButton,
    QWidget,
)

from brdf_qt.documents.recent_files import RecentFiles, recent_projects
from brdf_qt.fields.choice_button import ChoiceButton
from brdf_qt.fields.form import described, fill_column, row_of
from brdf_qt.fields.labels import ElidedLabel, PlainLabel, plain_tip, set_bold, set_small
from brdf_qt.program.icons import icon
from brdf_qt.program.settings import SHARED, settings
from brdf_qt.program.translation import SYSTEM, language_in_use, language_names, tr
from brdf_qt.start.gallery import Gallery
from brdf_qt.window.shortcuts import SHORTCUTS
from brdf_suite.foreign_text import make_visible

_SHOW = "start/show"
_SIZE = QSize(1140, 752)
_SIDE = 252
_ROW = 32
_MOST_RECENT = 8
_HEAD = 1.5
"""Size of the page's title over the usual one."""
_PATH = Qt.ItemDataRole.UserRole
_KEYS = {"New": "new", "new_from_measurement": "new_from_measurement"}
"""What begins here by the name of its keys in the table of shortcuts."""


def is_wanted() -> bool:
    """Whether the page is to be shown when a program starts."""
    return bool(settings(SHARED).value(_SHOW, True, type=bool))


def set_wanted(wanted: bool) -> None:
    """Keep, for all programs, whether the page is shown when one starts."""
    settings(SHARED).setValue(_SHOW, wanted)


def recent_work() -> list[Path]:
    """Return the newest projects and files of this program, projects first."""
    projects = [Path(path) for path in recent_projects().paths()]
    files = [Path(path) for key in ("recent", "recent/files") for path in RecentFiles(key).paths()]
    kept = projects[: _MOST_RECENT // 2]
    return [*kept, *(file for file in files if file not in kept)][:_MOST_RECENT]


class StartWindow(QWidget):
    """A window of its own, which waits for nothing and hinders nothing.

    Signals
    -------
    painted()
        It was painted for the first time.
    paint_chosen(name)
        A paint of the gallery is to be opened.
    file_chosen(Path)
        Recent work is to be opened.
    command_chosen(key)
        A command of the program is to be done: ``New``, ``new_from_measurement``, ``acquire_sample``,
        ``open_project``, ``manual`` or ``tour``.
    language_chosen(code)
        The program is to start again in a language (ISO 639 code), which is not the one in use.
    """

    painted = Signal()
    paint_chosen = Signal(str)
    file_chosen = Signal(Path)
    command_chosen = Signal(str)
    language_chosen = Signal(str)

    def __init__(self, program: str, parent: QWidget | None = None) -> None:
        super().__init__(parent, Qt.WindowType.Window)
        self.setObjectName("start_page")
        self.setWindowTitle(tr("Start"))
        self._was_painted = False
        room = self.screen().availableSize()
        self.resize(_SIZE.boundedTo(QSize(round(0.94 * room.width()), round(0.92 * room.height()))))
        head = PlainLabel(f"BRDF Suite {program}")
        font = head.font()
        font.setPointSizeF(_HEAD * font.pointSizeF())
        head.setFont(font)
        set_bold(head, True)
        self.gallery = Gallery()
        self.gallery.chosen.connect(self.paint_chosen)
        scroll = described(QScrollArea(), name="start_gallery", spoken=tr("Paints to begin with"))
        scroll.setWidget(self.gallery)
        scroll.setWidgetResizable(True)
        scroll.setFrameShape(QFrame.Shape.NoFrame)
        scroll.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        side = QWidget()
        side.setFixedWidth(_SIDE)
        work = QWidget()
        fill_column(work, *self._recent(), None, spacing=6).setStretchFactor(self.recent, 20)
        fill_column(side, *self._begin(), work, *self._help(), grows=work, spacing=4)
        right = QWidget()
        fill_column(right, _heading(tr("Begin with a paint")), scroll, grows=scroll, spacing=8)
        middle = row_of(side, right, grows=right, spacing=24)
        top = row_of(head, None, self._languages())
        fill_column(self, top, middle, self._foot(), spacing=14, margins=(24, 18, 16, 14)).setStretch(1, 1)
        self._add_keys()
        self.gallery.tiles[next(iter(self.gallery.tiles))].setFocus()

    def show_loading(self, what: str) -> None:
        """Show that the program behind the page is being loaded; "": it is there."""
        self._loading.setText(what)
        self._bar.setVisible(bool(what))

    def refresh(self) -> None:
        """Show recent work and choices as they are now."""
        self.recent.clear()
        for path in recent_work():
            item = QListWidgetItem(make_visible(path.name))
            item.setToolTip(plain_tip(str(path)))
            item.setData(_PATH, str(path))
            self.recent.addItem(item)
        self._nothing.setVisible(not self.recent.count())
        self.recent.setVisible(bool(self.recent.count()))
        self.wanted.setChecked(is_wanted())
        self.languages[language_in_use(QApplication.instance())].setChecked(True)

    def showEvent(self, event: QShowEvent) -> None:
        self.refresh()
        super().showEvent(event)

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        # An edge of its own: over the program's window it has the same grey.
        painter = QPainter(self)
        painter.setPen(self.palette().color(QPalette.ColorRole.Light))
        painter.drawRect(self.rect().adjusted(0, 0, -1, -1))
        painter.end()
        if not self._was_painted:
            self._was_painted = True
            QTimer.singleShot(0, self, self.painted.emit)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape:
            self.close()
            return
        super().keyPressEvent(event)

    def _begin(self) -> list[QWidget]:
        rows = (
            ("New", "file-plus", tr("New Paint"), tr("Begin with a grey metallic paint")),
            (
                "new_from_measurement",
                "folder-open",
                tr("Open a Measurement…"),
                tr("Start a design from a measured reflectance or spectrophotometer readings"),
            ),
            (
                "acquire_sample",
                "camera",
                tr("Try a Simulated Acquisition"),
                tr("Photographs of a simulated sphere, from which a paint is reconstructed step by step"),
            ),
            (
                "open_project",
                "archive",
                tr("Open a Project…"),
                tr("Paints, standard, views and lights of one design"),
            ),
        )
        return [_heading(tr("Begin")), *(self._button(*row) for row in rows), _gap()]

    def _recent(self) -> list[QWidget]:
        self.recent = described(QListWidget(), name="start_recent", spoken=tr("Recent work"))
        self.recent.setFrameShape(QFrame.Shape.NoFrame)
        self.recent.setSpacing(3)
        self.recent.viewport().setAutoFillBackground(False)
        self.recent.setTextElideMode(Qt.TextElideMode.ElideMiddle)
        self.recent.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.recent.itemActivated.connect(self._open_recent)
        self.recent.itemClicked.connect(self._open_recent)
        self._nothing = PlainLabel(tr("Files and projects that you open are listed here."), wordWrap=True)
        set_small(self._nothing)
        return [_heading(tr("Recent work")), self.recent, self._nothing]

    def _help(self) -> list[QWidget]:
        tour = self._button("tour", "map-trifold", tr("Tour"), tr("Three steps through the window"))
        manual = self._button("manual", "book-open", tr("Manual"), tr("All documents, without a network"))
        return [_gap(), _heading(tr("Learn")), tour, manual]

    def _languages(self) -> QHBoxLayout:
        """Return a button for each language, in its own words: who reads another one finds it there."""
        self.languages: dict[str, ChoiceButton] = {}
        group = QButtonGroup(self)
        for code, name in language_names().items():
            if code == SYSTEM:
                continue
            button = described(ChoiceButton(name), name=f"start_language_{code}", spoken=name)
            button.setToolTip(plain_tip(tr("Start again in {language}").format(language=name)))
            button.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
            button.setChecked(code == language_in_use(QApplication.instance()))
            button.clicked.connect(lambda _=False, code=code: self._choose_language(code))
            group.addButton(button)
            self.languages[code] = button
        return row_of(*self.languages.values(), spacing=4)

    def _choose_language(self, code: str) -> None:
        if code != language_in_use(QApplication.instance()):
            self.language_chosen.emit(code)

    def _add_keys(self) -> None:
        """Give what begins here the keys that it has in the window."""
        for key, shortcut in _KEYS.items():
            press = QShortcut(QKeySequence(SHORTCUTS[shortcut].keys[0]), self)
            press.activated.connect(lambda key=key: self.command_chosen.emit(key))

    def _foot(self) -> QWidget:
        self.wanted = described(QCheckBox(tr("Show at start")), name="start_wanted")
        self.wanted.setToolTip(
            plain_tip(tr("Also in View ▸ Settings; Help ▸ Start Page shows it at any time"))
        )
        self.wanted.clicked.connect(set_wanted)
        self._loading, self._bar = ElidedLabel(), QProgressBar()
        self._bar.setRange(0, 0)  # how far an import is cannot be known
        self._bar.setTextVisible(False)
        self._bar.setFixedSize(160, 10)
        self._bar.setAccessibleName(tr("Loading"))
        self._bar.hide()
        close = described(QPushButton(tr("Close")), name="start_close")
        close.clicked.connect(self.close)
        foot = QWidget()
        row = row_of(self.wanted, None, self._loading, self._bar, close, spacing=10)
        foot.setLayout(row)
        return foot

    def _button(self, key: str, sign: str, text: str, tip: str) -> QToolButton:
        button = described(QToolButton(), name=f"start_{key}", tip=tip)
        button.setText(text)
        button.setIcon(icon(sign))
        button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        button.setAutoRaise(True)
        button.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        button.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        button.setMinimumHeight(_ROW)
        button.clicked.connect(lambda: self.command_chosen.emit(key))
        return button

    def _open_recent(self, item: QListWidgetItem) -> None:
        self.file_chosen.emit(Path(item.data(_PATH)))


def _gap() -> QWidget:
    gap = QWidget()
    gap.setFixedHeight(_ROW // 3)
    return gap


def _heading(text: str) -> PlainLabel:
    label = PlainLabel(text)
    set_bold(label, True)
    return label
