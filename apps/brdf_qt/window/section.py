"""Collapsible sections, and the inspector that scrolls them."""

from __future__ import annotations

from typing import TypeVar

from PySide6.QtCore import QEvent, QObject, QPoint, QSize, Qt, Signal
from PySide6.QtWidgets import QFrame, QScrollArea, QSizePolicy, QToolButton, QVBoxLayout, QWidget

from brdf_qt.fields.form import fill_column
from brdf_qt.fields.labels import set_bold
from brdf_qt.program.settings import settings
from brdf_qt.program.translation import tr

SomeWidget = TypeVar("SomeWidget", bound=QWidget)


class Section(QWidget):
    """A titled part of the inspector that opens and closes; remembers which under ``key``.

    ``is_open`` is how it is shown until the user has opened or closed it. One that is not ``titled`` has no header and
    is always open: the tab that it is behind says what it is.
    """

    toggled = Signal(bool)
    seen = Signal()
    """Its body has come into view: it was opened, or what it is in was shown."""

    def __init__(
        self,
        title: str,
        key: str | None = None,
        parent: QWidget | None = None,
        *,
        is_open: bool = True,
        titled: bool = True,
    ) -> None:
        super().__init__(parent)
        self.title = title
        self._key = f"section/{key or title}"
        self.setObjectName(f"section_{key or title}")
        self.header = QToolButton()
        self.header.setText(title)
        self.header.setCheckable(True)
        self.header.setAutoRaise(True)
        self.header.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self.header.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.header.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.header.setAccessibleName(tr("Section {title}").format(title=title))
        self.header.setToolTip(tr("Show or hide this section"))
        set_bold(self.header, True)
        self.header.clicked.connect(self.set_open)
        self._body = QWidget()
        self.body_layout = QVBoxLayout(self._body)
        self.body_layout.setContentsMargins(8, 4, 8, 8)
        self.body_layout.setSpacing(8)
        line = QFrame()
        line.setFrameShape(QFrame.Shape.HLine)
        line.setFrameShadow(QFrame.Shadow.Plain)
        line.setForegroundRole(line.foregroundRole().Mid)
        fill_column(self, self.header, self._body, line, spacing=0)
        self._body.installEventFilter(self)
        if not titled:
            self.header.hide()
        self._show(not titled or bool(settings().value(self._key, is_open, type=bool)))

    def add(self, widget: SomeWidget) -> SomeWidget:
        """Put ``widget`` at the end of the body and return it."""
        self.body_layout.addWidget(widget)
        return widget

    @property
    def is_open(self) -> bool:
        return self.header.isChecked()

    @property
    def is_seen(self) -> bool:
        """Whether its body is on show: open, in a part of the window that is."""
        return self._body.isVisible()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Notice when the body is shown."""
        if event.type() == QEvent.Type.Show:
            self.seen.emit()
        return super().eventFilter(watched, event)

    def set_open(self, is_open: bool) -> None:
        """Open or close, and remember it."""
        if self._body.isVisibleTo(self) != is_open:
            self._show(is_open)
            settings().setValue(self._key, is_open)
            self.toggled.emit(is_open)

    def _show(self, is_open: bool) -> None:
        self.header.setChecked(is_open)
        self.header.setArrowType(Qt.ArrowType.DownArrow if is_open else Qt.ArrowType.RightArrow)
        self._body.setVisible(is_open)


SomeSection = TypeVar("SomeSection", bound=Section)


class Inspector(QScrollArea):
    """Sections one under the other; scrolls up and down, never sideways."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("inspector")
        self.setWidgetResizable(True)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOn)
        self._inside = QWidget()
        self._box = fill_column(self._inside, spacing=0)
        self._box.addStretch(1)
        self.setWidget(self._inside)
        self.sections: list[Section] = []
        self._followed: Section | None = None
        bar = self.verticalScrollBar()
        bar.rangeChanged.connect(lambda _low, _high: self._follow())
        bar.actionTriggered.connect(lambda _action: self._leave())

    def add_section(self, section: SomeSection, after: Section | None = None) -> SomeSection:
        """Put ``section`` under the others, or right under ``after``, and return it."""
        return self._insert(section, len(self.sections) if after is None else self.sections.index(after) + 1)

    def _insert(self, section: SomeSection, place: int) -> SomeSection:
        self._box.insertWidget(place, section)
        self.sections.insert(place, section)
        return section

    def bring_in_sight(self, section: Section) -> None:
        """Scroll as little as shows the whole of ``section``, or its beginning where it is longer than the room.

        A section that opens is laid out later, and its contents may come later still: it is kept in sight until
        the user scrolls or the keyboard goes elsewhere.
        """
        self._followed = section
        self._show_whole(section)

    def _follow(self) -> None:
        if self._followed is None:
            return
        focused = self.window().focusWidget()
        if focused is None or self._followed.isAncestorOf(focused):
            self._show_whole(self._followed)
        else:
            self._leave()

    def _show_whole(self, section: Section) -> None:
        bar = self.verticalScrollBar()
        top = section.mapTo(self._inside, QPoint(0, 0)).y()
        lowest = top + section.height() - self.viewport().height()
        bar.setValue(min(top, max(lowest, bar.value())))

    def _leave(self) -> None:
        self._followed = None

    def sizeHint(self) -> QSize:
        return QSize(self._inside.sizeHint().width() + self.verticalScrollBar().sizeHint().width() + 2, 640)

    def minimumSizeHint(self) -> QSize:
        width = self._inside.minimumSizeHint().width() + self.verticalScrollBar().sizeHint().width() + 2
        return QSize(width, 120)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Be as wide as the widest section needs, also once one has opened."""
        if watched is self._inside and event.type() == QEvent.Type.LayoutRequest:
            self.updateGeometry()
        return super().eventFilter(watched, event)
