"""The panel at the side of a picture: icon tabs, and behind each what is used daily and a fold for the rest."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from PySide6.QtCore import QRect, QSize, Qt, Signal
from PySide6.QtGui import QPainter, QPaintEvent
from PySide6.QtWidgets import QButtonGroup, QSizePolicy, QStackedWidget, QToolButton, QWidget

from brdf_qt.fields.form import described, fill_column, fill_row
from brdf_qt.program.icons import icon
from brdf_qt.program.settings import settings
from brdf_qt.program.translation import mark, tr
from brdf_qt.window.section import Inspector, Section, SomeSection

_LINE = 3
_ICON = 22
_LEAST_WIDTH = 372


@dataclass(frozen=True)
class Tab:
    """A tab: its key, title and tip (English, marked for translation), and the name of its icon."""

    key: str
    title: str
    icon: str
    tip: str


def standard_tabs(paint: str, light: str, form: str, compare: str, export: str) -> tuple[Tab, ...]:
    """Return the five tabs of a program with a picture, with its own tips (English, marked for translation)."""
    return (
        Tab("paint", mark("Paint"), "paint-brush", paint),
        Tab("light", mark("Light"), "sun", light),
        Tab("form", mark("Form"), "car", form),
        Tab("compare", mark("Compare"), "scales", compare),
        Tab("export", mark("Export"), "export", export),
    )


class Page(Inspector):
    """What is behind a tab: sections that are used daily, below them a fold *More*, made with its first section."""

    def __init__(self, key: str) -> None:
        super().__init__()
        self.setObjectName(f"page_{key}")
        self._key = key
        self.more: Section | None = None
        self.rest: list[Section] = []
        """The sections in the fold, from the top."""

    def add_section(self, section: SomeSection, after: Section | None = None) -> SomeSection:
        """Put ``section`` under the others and above the fold, or right under ``after``, also one in the fold."""
        if after is not None and after in self.rest:
            return self.add_more(section, after)
        if after is None and self.more is not None:
            daily = [one for one in self.sections if one is not self.more]
            return self._insert(section, len(daily))
        return super().add_section(section, after)

    def add_more(self, section: SomeSection, after: Section | None = None) -> SomeSection:
        """Put ``section`` into the fold, under the others there or right under ``after``, and return it."""
        if self.more is None:
            self.more = Section(tr("More"), f"more_{self._key}", is_open=False)
            self.more.body_layout.setContentsMargins(0, 0, 0, 0)
            self.more.body_layout.setSpacing(0)
            super().add_section(self.more)
        place = len(self.rest) if after is None else self.rest.index(after) + 1
        self.more.body_layout.insertWidget(place, section)
        self.rest.insert(place, section)
        return section

    @property
    def all_sections(self) -> tuple[Section, ...]:
        """The sections from the top, those of the fold behind the fold's own."""
        return (*self.sections, *self.rest)

    def bring_in_sight(self, section: Section) -> None:
        """Open the fold where ``section`` is in it, and scroll as little as shows it."""
        if self.more is not None and section in self.rest:
            self.more.set_open(True)
        super().bring_in_sight(section)


class _TabButton(QToolButton):
    """An icon over its title; the one in front has a line of the accent below it."""

    def __init__(self, tab: Tab) -> None:
        super().__init__()
        self.setIcon(icon(tab.icon))
        self.setIconSize(QSize(_ICON, _ICON))
        self.setText(tr(tab.title))
        self.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextUnderIcon)
        self.setCheckable(True)
        self.setAutoRaise(True)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        described(self, name=f"tab_{tab.key}", tip=tr(tab.tip))

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if self.isChecked():
            line = QRect(0, self.height() - _LINE, self.width(), _LINE)
            QPainter(self).fillRect(line, self.palette().highlight())


class TabPanel(QWidget):
    """Pages behind a bar of tabs, which is shown where there are several; the one in front is remembered.

    ``page_shown(key)``: another page is in front.
    """

    page_shown = Signal(str)

    def __init__(self, tabs: Sequence[Tab] = (), parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("tab_panel")
        self.tabs = tuple(tabs)
        self.pages: dict[str, Page] = {}
        self.buttons: dict[str, QToolButton] = {}
        self._stack = QStackedWidget()
        bar = described(QWidget(), name="tab_bar", spoken=tr("Tabs of the panel"))
        group = QButtonGroup(self)
        for tab in tabs:
            button = self.buttons[tab.key] = _TabButton(tab)
            button.clicked.connect(self._chooser(tab.key))
            group.addButton(button)
        fill_row(bar, *self.buttons.values(), spacing=0, even=True)
        bar.setVisible(len(tabs) > 1)
        fill_column(self, bar, self._stack, spacing=4)
        for key in self.buttons or ("inspector",):
            self.pages[key] = page = Page(key)
            self._stack.addWidget(page)
        kept = str(settings().value("panel/page", ""))
        self._show(kept if kept in self.pages else next(iter(self.pages)))

    @property
    def page(self) -> Page:
        """The page in front."""
        return self.pages[self._shown]

    @property
    def sections(self) -> tuple[Section, ...]:
        """The sections of all pages, from the first."""
        return tuple(section for page in self.pages.values() for section in page.all_sections)

    def focus_parts(self) -> list[QWidget]:
        """Return the tabs and the parts of all pages in the order in which Tab goes through them."""
        parts: list[QWidget] = list(self.buttons.values())
        for page in self.pages.values():
            for section in page.sections:
                parts += [section] if section is not page.more else [section.header, *page.rest]
        return parts

    def show_page(self, key: str) -> None:
        """Bring a page to the front, and remember it."""
        if key != self._shown:
            self._show(key)
            settings().setValue("panel/page", key)
            self.page_shown.emit(key)

    def bring_in_sight(self, section: Section) -> None:
        """Bring the page of ``section`` to the front, open it, and scroll as little as shows it."""
        for key, page in self.pages.items():
            if section in page.all_sections:
                self.show_page(key)
                section.set_open(True)
                page.bring_in_sight(section)

    def sizeHint(self) -> QSize:
        width = max(page.sizeHint().width() for page in self.pages.values())
        return QSize(max(width, self.minimumSizeHint().width()), 640)

    def minimumSizeHint(self) -> QSize:
        least = super().minimumSizeHint()
        # Wide enough for what is in a fold, too: nothing is moved by opening one.
        return least.expandedTo(QSize(_LEAST_WIDTH if self.tabs else 0, 0))

    def _chooser(self, key: str) -> Callable[[], None]:
        return lambda: self.show_page(key)

    def _show(self, key: str) -> None:
        self._shown = key
        self._stack.setCurrentWidget(self.pages[key])
        if key in self.buttons:
            self.buttons[key].setChecked(True)
