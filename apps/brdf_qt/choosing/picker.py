"""Choosing one thing by its picture: a field with the picture and name of the present one, and a grid under it."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from PySide6.QtCore import QPoint, QRect, QSignalBlocker, QSize, Qt, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QComboBox, QFrame, QWidget

from brdf_qt.choosing.filter_fields import GROUPS, WITHOUT_PALETTE, filter_fields
from brdf_qt.choosing.sources import FilteredSources, Source, SourceModel
from brdf_qt.choosing.thumbnails import Thumbnails
from brdf_qt.choosing.view import ThumbnailView
from brdf_qt.fields.form import fill_column, fill_row, icon_button, row_of
from brdf_qt.fields.quiet import QuietComboBox
from brdf_qt.program.translation import tr

_FACE = QSize(36, 36)
_POPUP = QSize(408, 360)
_MARGIN = 6


class GridPopup(QFrame):
    """A grid of thumbnails over the window, with search and origin. Signals: ``taken(key)``, and it has closed."""

    taken = Signal(str)

    def __init__(self, model: SourceModel, parent: QWidget) -> None:
        super().__init__(parent, Qt.WindowType.Popup)
        self.setFrameShape(QFrame.Shape.StyledPanel)
        self.sources = FilteredSources(model, self)
        self.view = ThumbnailView(self.sources, "grid", wraps=True)
        self.view.setAccessibleName(tr("Choices"))
        self.view.setDragEnabled(False)
        is_paint = model.thumbnails is not None and model.thumbnails.kind == "paint"
        self.search, self.origin = filter_fields(self.sources, tuple(GROUPS) if is_paint else WITHOUT_PALETTE)
        self.search.left.connect(self.view.go_in)
        self.search.entered.connect(self._take_first)
        self.view.taken.connect(lambda key, _shifted: self._take(key))
        head = row_of(self.search, self.origin, grows=self.search, spacing=4)
        fill_column(self, head, self.view, grows=self.view, spacing=4, margins=(_MARGIN,) * 4)

    def open_under(self, field: QWidget) -> None:
        """Show it under ``field``, or above where there is no room; the keyboard is in the search."""
        room = field.screen().availableGeometry()
        wide = max(_POPUP.width(), field.width())
        high = min(
            _POPUP.height(),
            self.sizeHint().height() - self.view.sizeHint().height() + self._grid_height(wide),
        )
        corner = field.mapToGlobal(QPoint(field.width() - wide, field.height()))
        place = QRect(corner, QSize(min(wide, room.width()), min(high, room.height())))
        if place.bottom() > room.bottom():
            place.moveBottom(field.mapToGlobal(QPoint(0, 0)).y())
        place.moveTop(max(place.top(), room.top()))
        place.moveLeft(min(max(place.left(), room.left()), room.right() - place.width()))
        self.search.clear()
        self.setGeometry(place)
        self.show()
        self.view.show_present(self.sources.model.present)
        self.search.setFocus(Qt.FocusReason.PopupFocusReason)

    def _grid_height(self, wide: int) -> int:
        """Return how high all the entries are in a popup of this width."""
        tile = self.view.tile
        columns = max(
            1, (wide - 2 * _MARGIN - self.view.verticalScrollBar().sizeHint().width()) // tile.width()
        )
        rows = -(-self.sources.model.rowCount() // columns)
        return max(rows, 1) * tile.height() + 2 * self.view.frameWidth() + 2

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape:
            self.close()
            return
        super().keyPressEvent(event)

    def _take_first(self) -> None:
        if self.sources.rowCount():
            key = self.sources.key_at(0)
            self.sources.model.note_taken(key)
            self._take(key)

    def _take(self, key: str) -> None:
        self.close()
        self.taken.emit(key)


class PictureBox(QuietComboBox):
    """A field with the picture and name of the present entry; it opens a :class:`GridPopup` in place of a list."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.sources = SourceModel(self)
        self.popup: GridPopup | None = None
        self.setModel(self.sources)
        self.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self.setMinimumContentsLength(14)
        self.setPlaceholderText(tr("Choose…"))
        self.currentIndexChanged.connect(lambda _row: self._show_present())

    def set_thumbnails(self, thumbnails: Thumbnails) -> None:
        """Show pictures from here."""
        self.setIconSize(_FACE)
        self.sources.set_thumbnails(thumbnails)
        self._show_present()

    def showPopup(self) -> None:
        if self.popup is None:
            self.popup = GridPopup(self.sources, self)
            self.popup.taken.connect(self._take)
        self.popup.open_under(self)

    def hidePopup(self) -> None:
        super().hidePopup()
        if self.popup is not None:
            self.popup.close()

    def _take(self, key: str) -> None:
        row = self.sources.row_of(key)
        self.setCurrentIndex(row)
        self.activated.emit(row)

    def _show_present(self) -> None:
        row = self.currentIndex()
        source = self.sources.source_at(row) if row >= 0 else None
        self.sources.set_present("" if source is None else source.key)
        if source is not None and self.sources.thumbnails is not None:
            self.sources.thumbnails.request(f"field {id(self)}", [(source.key, source.content)])


class SourceField(QWidget):
    """Emits ``chosen(key)`` when the user takes an entry and ``browse_requested()`` for the button."""

    chosen = Signal(str)
    browse_requested = Signal()

    def set_sources(self, shipped: Iterable[Source], files: Iterable[Source]) -> None:
        """Show these entries: shipped things and those of a palette, then files."""
        raise NotImplementedError

    def show_source(self, key: str, title: str) -> None:
        """Show ``key`` as the present choice, without a signal; added to the entries where it is not among them."""
        raise NotImplementedError


class SourceChooser(SourceField):
    """The entries in a list with pictures that opens."""

    def __init__(self, browse_tip: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.list = PictureBox()
        self.list.activated.connect(lambda index: self.chosen.emit(self.list.itemData(index)))
        self.button = icon_button("folder-open", browse_tip, self.browse_requested.emit)
        fill_row(self, self.list, self.button, spacing=4)
        self.setFocusProxy(self.list)

    @property
    def sources(self) -> SourceModel:
        """The entries."""
        return self.list.sources

    def set_sources(self, shipped: Iterable[Source], files: Iterable[Source]) -> None:
        """Fill the list: shipped things and those of a palette, then files; keeps what is shown where it is there."""
        current = self.list.currentData()
        own = [replace(source, group="recent") for source in files]
        with QSignalBlocker(self.list):
            self.sources.set_sources([*shipped, *own])
        self.list.setCurrentIndex(-1 if current is None else self.sources.row_of(current))

    def show_source(self, key: str, title: str) -> None:
        """Show ``key`` as the present choice, without a signal; added to the list where it is not in it."""
        row = self.sources.row_of(key)
        if row < 0 and title:
            row = self.sources.add(Source(key, title, "recent"))
        if row != self.list.currentIndex():
            self.list.setCurrentIndex(row)

    def rename(self, key: str, title: str) -> None:
        """Give an entry another title; nothing where there is none."""
        self.sources.rename(key, title)


class SourceTiles(SourceField):
    """A few entries as tiles, to be taken by one click. Its room is two rows."""

    def __init__(self, owner: str, browse_tip: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.sources = SourceModel(self)
        self.view = ThumbnailView(FilteredSources(self.sources, self), owner, wraps=True)
        self.view.setDragEnabled(False)
        self.view.setFixedHeight(2 * self.view.tile.height() + 2 * self.view.frameWidth() + 2)
        self.view.taken.connect(lambda key, _shifted: self.chosen.emit(key))
        self.button = icon_button("folder-open", browse_tip, self.browse_requested.emit)
        fill_row(self, self.view, self.button, spacing=4).setAlignment(self.button, Qt.AlignmentFlag.AlignTop)
        self.setFocusProxy(self.view)

    def set_thumbnails(self, thumbnails: Thumbnails) -> None:
        """Show pictures from here."""
        self.sources.set_thumbnails(thumbnails)

    def set_sources(self, shipped: Iterable[Source], files: Iterable[Source]) -> None:
        """Show these tiles: shipped things, then files."""
        self.sources.set_sources([*shipped, *(replace(source, group="recent") for source in files)])

    def show_source(self, key: str, title: str) -> None:
        """Show ``key`` as the present choice, without a signal; added to the tiles where it is not among them."""
        if self.sources.row_of(key) < 0 and title:
            self.sources.add(Source(key, title, "recent"))
        self.sources.set_present(key)
