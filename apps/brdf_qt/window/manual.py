"""Help ▸ Manual: the documents of the suite, read without a network; contents at the left, links between the pages."""

from __future__ import annotations

import re
from pathlib import Path

from PySide6.QtCore import Qt, QUrl
from PySide6.QtGui import QDesktopServices, QImage, QResizeEvent, QTextDocument
from PySide6.QtWidgets import QDialog, QSplitter, QTextBrowser, QTreeWidget, QTreeWidgetItem, QWidget

from brdf_qt.fields.form import fill_column
from brdf_qt.fields.labels import plain_tip
from brdf_qt.program.translation import tr
from brdf_suite.library.reference import expand_reference, heading_anchor, list_pages
from brdf_suite.resources import document_root

_REMARK = re.compile(r"<!--.*?-->", re.DOTALL)
_FIRST = {
    "designer": "colourist",
    "viewer": "stylist",
    "lobe_visualizer": "researcher",
    "color_swatch": "palettes",
}
"""The page on which each program's manual opens."""
_PATH = Qt.ItemDataRole.UserRole
_SIZE = (1080, 760)


class _Page(QTextBrowser):
    """Shows a page of Markdown; pictures are never wider than it, and links to other places open in the browser."""

    def __init__(self) -> None:
        super().__init__()
        self.setOpenLinks(False)
        self.anchorClicked.connect(self.follow)
        self.page: Path | None = None

    def follow(self, link: QUrl) -> None:
        """Go to a page, or to a place in this one; show what is no page with the program that the system has for it."""
        if link.scheme() in ("http", "https"):
            QDesktopServices.openUrl(link)
            return
        if link.path() and self.page is not None:
            page = (self.page.parent / link.path()).resolve()
            if page.suffix != ".md" or not page.is_file():
                return
            self.show_page(page)
        if link.fragment():
            self._scroll_to(link.fragment(QUrl.ComponentFormattingOption.FullyDecoded))

    def _scroll_to(self, anchor: str) -> None:
        """Bring the heading of an anchor to the top."""
        block = self.document().begin()
        while block.isValid():
            if block.blockFormat().headingLevel() and heading_anchor(block.text()) == anchor:
                place = self.document().documentLayout().blockBoundingRect(block).top()
                self.verticalScrollBar().setValue(int(place))
                return
            block = block.next()

    def show_page(self, page: Path) -> None:
        """Show a page from its beginning."""
        self.page = page
        # A new document each time: on one that was shown before, Qt writes text in the format of its first heading.
        shown = QTextDocument(self)
        shown.setDefaultFont(self.font())
        shown.setMarkdown(expand_reference(_REMARK.sub("", page.read_text("utf-8"))))
        self.setDocument(shown)  # deletes the one before
        self.verticalScrollBar().setValue(0)

    def loadResource(self, kind: int, name: QUrl | str) -> object:
        if kind == QTextDocument.ResourceType.ImageResource.value and self.page is not None:
            picture = QImage(str(self.page.parent / QUrl(name).path()))
            room = max(200, self.viewport().width() - 40)
            if picture.width() > room:
                return picture.scaledToWidth(room, Qt.TransformationMode.SmoothTransformation)
            return picture
        return super().loadResource(kind, name)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        if self.page is not None and event.oldSize().width() != event.size().width():
            place = self.verticalScrollBar().value()
            self.show_page(self.page)
            self.verticalScrollBar().setValue(place)


class Manual(QDialog):
    """The documents; a window that stays open beside the work. ``program`` says at which page it opens."""

    def __init__(self, parent: QWidget, program: str) -> None:
        super().__init__(parent)
        self.setObjectName("manual")
        self.setWindowTitle(tr("Manual"))
        self.resize(*_SIZE)
        self.chapters, self.text = QTreeWidget(), _Page()
        self.chapters.setHeaderHidden(True)
        self.chapters.setAccessibleName(tr("Contents"))
        self.chapters.currentItemChanged.connect(self._show)
        split = QSplitter(Qt.Orientation.Horizontal)
        split.addWidget(self.chapters)
        split.addWidget(self.text)
        split.setStretchFactor(1, 1)
        split.setSizes([340, 740])
        fill_column(self, split, margins=(8, 8, 8, 8))
        for chapter, pages in list_pages(document_root()).items():
            head = QTreeWidgetItem([chapter])
            self.chapters.addTopLevelItem(head)
            for title, about, page in pages:
                entry = QTreeWidgetItem([title])
                entry.setToolTip(0, plain_tip(about))
                entry.setData(0, _PATH, str(page))
                head.addChild(entry)
                if page.stem == _FIRST.get(program) or self.chapters.currentItem() is None:
                    self.chapters.setCurrentItem(entry)

    def _show(self, item: QTreeWidgetItem | None) -> None:
        page = None if item is None else item.data(0, _PATH)
        if page:
            self.text.show_page(Path(page))
