"""The row of tabs over the window: a paint each, its mark of unsaved work, and the order that the user gives them."""

from __future__ import annotations

from collections.abc import Sequence

from brdf_qt.fields.labels import plain_tip
from brdf_qt.program.icons import icon
from brdf_qt.program.translation import tr
from PySide6.QtCore import QEvent, QSignalBlocker, QSize, Qt, Signal
from PySide6.QtGui import QMouseEvent, QWheelEvent
from PySide6.QtWidgets import QTabBar, QToolButton, QWidget

from brdf_designer.session.state import TabState
from brdf_suite.foreign_text import make_visible

MARK = "•"
"""Before the title of a paint that is not saved."""


class DocumentTabs(QTabBar):
    """Tabs that are clicked, dragged into another order, and closed by their cross or the middle button.

    Signals: ``chosen(place)``, ``close_requested(place)``, ``dragged(before, after)``, ``new_requested()`` on a double
    click beside them.
    """

    chosen = Signal(int)
    close_requested = Signal(int)
    dragged = Signal(int, int)
    new_requested = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        self._hints: dict[str, QSize] = {}
        super().__init__(parent)
        self.setObjectName("document_tabs")
        self.setAccessibleName(tr("Open paints"))
        self.setMovable(True)
        self.setExpanding(False)
        self.setDocumentMode(True)
        self.setDrawBase(False)
        self.setUsesScrollButtons(True)
        self.setElideMode(Qt.TextElideMode.ElideMiddle)
        self.setSelectionBehaviorOnRemove(QTabBar.SelectionBehavior.SelectPreviousTab)
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self._shown: tuple[tuple[TabState, ...], int] = ((), -1)
        self.currentChanged.connect(lambda place: self.chosen.emit(place) if place >= 0 else None)
        self.tabMoved.connect(self._report_moved)

    def tabSizeHint(self, index: int) -> QSize:
        """Return the size with the mark of what is not saved, so that none moves when that comes."""
        # Asked for every tab whenever one of them changes.
        text = self.tabText(index)
        hint = self._hints.get(text)
        if hint is None:
            hint = super().tabSizeHint(index)
            if not text.startswith(MARK):
                hint.setWidth(hint.width() + self.fontMetrics().horizontalAdvance(f"{MARK} "))
            if self.tabButton(index, QTabBar.ButtonPosition.RightSide) is not None:
                self._hints[text] = hint
        return hint

    def changeEvent(self, event: QEvent) -> None:
        self._hints.clear()
        super().changeEvent(event)

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Leave the paint in front where it is."""
        event.ignore()

    def show_tabs(self, tabs: Sequence[TabState], front: int) -> None:
        """Show the tabs; nothing is emitted.

        Only what is another is changed: each change of a tab lays the whole row out anew.
        """
        if (tuple(tabs), front) == self._shown:
            return
        row, kept = list(self._shown[0]), {tab.key for tab in tabs}
        self._shown = (tuple(tabs), front)
        with QSignalBlocker(self):
            for place in reversed(range(len(row))):
                if row[place].key not in kept:
                    self.removeTab(place)
                    del row[place]
            places = {tab.key: place for place, tab in enumerate(row)}
            for place, tab in enumerate(tabs):
                if tab.key not in places:
                    self._insert(place, tab)
                    row.insert(place, tab)
                    continue
                if row[place].key != tab.key:
                    before = next(at for at in range(place, len(row)) if row[at].key == tab.key)
                    self.moveTab(before, place)
                    row.insert(place, row.pop(before))
                if row[place] != tab:
                    self._fill(place, tab)
            self.setCurrentIndex(front)

    def _insert(self, place: int, tab: TabState) -> None:
        self.insertTab(place, _text_of(tab))
        close = QToolButton()
        close.setIcon(icon("x"))
        close.setIconSize(QSize(12, 12))
        close.setAutoRaise(True)
        close.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        close.clicked.connect(lambda: self.close_requested.emit(self._place_of(close)))
        self.setTabButton(place, QTabBar.ButtonPosition.RightSide, close)
        self._fill(place, tab)

    def _fill(self, place: int, tab: TabState) -> None:
        if self.tabText(place) != _text_of(tab):
            self.setTabText(place, _text_of(tab))
        where = str(tab.path) if tab.path else tr("No file yet")
        state = "" if tab.clean else tr("Not saved")
        self.setTabToolTip(place, plain_tip("\n".join(part for part in (where, state) if part)))
        spoken = tab.title if tab.clean else tr("{title}, not saved").format(title=tab.title)
        self.setAccessibleTabName(place, spoken)
        button = self.tabButton(place, QTabBar.ButtonPosition.RightSide)
        if button is not None:
            text = tr("Close {title}").format(title=tab.title)
            button.setToolTip(plain_tip(text))
            button.setAccessibleName(text)

    def _place_of(self, button: QWidget) -> int:
        side = QTabBar.ButtonPosition.RightSide
        return next(place for place in range(self.count()) if self.tabButton(place, side) is button)

    def _report_moved(self, before: int, after: int) -> None:
        tabs = list(self._shown[0])
        tabs.insert(after, tabs.pop(before))
        self._shown = (tuple(tabs), self.currentIndex())
        self.dragged.emit(before, after)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        place = self.tabAt(event.position().toPoint())
        if event.button() == Qt.MouseButton.MiddleButton and place >= 0:
            self.close_requested.emit(place)
            return
        super().mouseReleaseEvent(event)

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        if self.tabAt(event.position().toPoint()) < 0:
            self.new_requested.emit()
            return
        super().mouseDoubleClickEvent(event)


def _text_of(tab: TabState) -> str:
    title = make_visible(tab.title).replace("&", "&&")
    return title if tab.clean else f"{MARK} {title}"
