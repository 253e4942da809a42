"""The gallery of the start page: shipped pictures of paints on the car, each of which opens its paint.

The pictures are made by ``packaging/generators/gallery.py``. Nothing here reads a paint.
"""

from __future__ import annotations

import json

from PySide6.QtCore import QPoint, QRect, QSize, Qt, Signal
from PySide6.QtGui import QIcon, QPixmap, QResizeEvent
from PySide6.QtWidgets import QLayout, QLayoutItem, QSizePolicy, QToolButton, QWidget

from brdf_qt.fields.form import described
from brdf_qt.fields.labels import plain_tip
from brdf_qt.program.translation import tr
from brdf_suite.errors import FileError
from brdf_suite.resources import resource

TILE = QSize(190, 119)
"""A picture as it is shown, about; its file has twice the pixels each way, for screens of 200 %."""
_SMALLEST = QSize(96, 60)
_GAP = 10


def gallery() -> dict[str, str]:
    """Return the titles of the paints of the gallery by their names, in their order.

    Raises :class:`FileError` where the install is damaged.
    """
    file = resource("gallery", "gallery.json")
    try:
        return dict(json.loads(file.read_text("utf-8")))
    except (OSError, ValueError, TypeError) as error:
        raise FileError(file, f"the list of the gallery cannot be read ({error})") from error


class _Rows(QLayout):
    """Tiles of one size that fill the width, in as many columns as bring their pictures nearest to :data:`TILE`."""

    def __init__(self, place: QWidget) -> None:
        super().__init__(place)
        self._items: list[QLayoutItem] = []
        self.setContentsMargins(0, 0, 0, 0)

    def addItem(self, item: QLayoutItem) -> None:
        self._items.append(item)

    def count(self) -> int:
        return len(self._items)

    def itemAt(self, index: int) -> QLayoutItem | None:
        return self._items[index] if 0 <= index < len(self._items) else None

    def takeAt(self, index: int) -> QLayoutItem | None:
        return self._items.pop(index) if 0 <= index < len(self._items) else None

    def hasHeightForWidth(self) -> bool:
        return True

    def heightForWidth(self, width: int) -> int:
        columns, picture, frame = self._grid(width)
        rows = -(-len(self._items) // columns)
        return rows * (picture.height() + frame.height() + _GAP) - _GAP

    def sizeHint(self) -> QSize:
        return self.minimumSize()

    def minimumSize(self) -> QSize:
        return _SMALLEST + self._grid(0)[2]

    def setGeometry(self, area: QRect) -> None:
        super().setGeometry(area)
        columns, picture, frame = self._grid(area.width())
        tile = picture + frame
        for number, item in enumerate(self._items):
            row, column = divmod(number, columns)
            corner = QPoint(column * (tile.width() + _GAP), row * (tile.height() + _GAP))
            button = item.widget()
            if isinstance(button, QToolButton):
                button.setIconSize(picture)
            item.setGeometry(QRect(area.topLeft() + corner, tile))

    def _grid(self, width: int) -> tuple[int, QSize, QSize]:
        """Return the number of columns, the size of a picture, and what its tile has around it."""
        frame = QSize(0, 0)
        for item in self._items:
            button = item.widget()
            if isinstance(button, QToolButton):
                frame = frame.expandedTo(button.sizeHint() - button.iconSize())
        frame.setWidth(min(frame.width(), _GAP))
        wanted = TILE.width() + frame.width() + _GAP
        columns = max(1, round((width + _GAP) / wanted))
        wide = max(_SMALLEST.width(), (width + _GAP) // columns - _GAP - frame.width())
        return columns, QSize(wide, round(wide * TILE.height() / TILE.width())), frame


class Gallery(QWidget):
    """The pictures in rows. Signal ``chosen(name)``: the paint of that name is to be opened."""

    chosen = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        rows = self._rows = _Rows(self)
        policy = self.sizePolicy()
        policy.setHeightForWidth(True)
        policy.setVerticalPolicy(QSizePolicy.Policy.Minimum)
        self.setSizePolicy(policy)
        self.tiles: dict[str, QToolButton] = {}
        for name, title in gallery().items():
            button = described(QToolButton(), name=f"gallery_{name}", spoken=title)
            button.setToolTip(plain_tip(tr("Open {name}").format(name=title)))
            button.setText(title)
            button.setIcon(QIcon(QPixmap(str(resource("gallery", f"{name}.jpg")))))
            button.setIconSize(TILE)
            button.setAutoRaise(True)
            button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextUnderIcon)
            button.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
            button.clicked.connect(lambda _=False, name=name: self.chosen.emit(name))
            rows.addWidget(button)
            self.tiles[name] = button

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self.setMinimumHeight(self._rows.heightForWidth(self.width()))
