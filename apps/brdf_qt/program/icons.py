"""Icons of one family (Phosphor), drawn from the packaged icon font.

The glyphs take the palette's text colour when painted, so a change of theme needs no new icons.
"""

from __future__ import annotations

import json
from functools import cache

from PySide6.QtCore import QPoint, QRect, QSize, Qt
from PySide6.QtGui import (
    QColor,
    QFont,
    QFontDatabase,
    QIcon,
    QIconEngine,
    QPainter,
    QPalette,
    QPixmap,
)
from PySide6.QtWidgets import QApplication

from brdf_qt.program.theme import state_colour
from brdf_suite.errors import FileError
from brdf_suite.resources import resource


@cache
def _family() -> tuple[str, dict[str, str]]:
    """Return the font family and {name: character}; once a process, after the application is made."""
    font = resource("icons", "phosphor.ttf")
    families = QFontDatabase.applicationFontFamilies(QFontDatabase.addApplicationFont(str(font)))
    if not families:
        raise FileError(font, "is not a font that can be loaded; install brdf-suite again")
    names = json.loads(resource("icons", "phosphor.json").read_text(encoding="utf-8"))
    return families[0], {name: chr(int(code, 16)) for name, code in names.items()}


class _GlyphEngine(QIconEngine):
    """Paints one character, in the colour that the palette gives to text where it has none of its own."""

    def __init__(self, character: str, family: str, state: str) -> None:
        super().__init__()
        self._character = character
        self._font_family = family
        self._state = state

    def paint(self, painter: QPainter, rect: QRect, mode: QIcon.Mode, _state: QIcon.State) -> None:
        group = QPalette.ColorGroup.Disabled if mode == QIcon.Mode.Disabled else QPalette.ColorGroup.Active
        role = (
            QPalette.ColorRole.HighlightedText
            if mode == QIcon.Mode.Selected
            else QPalette.ColorRole.ButtonText
        )
        font = QFont(self._font_family)
        font.setPixelSize(max(1, rect.height()))
        painter.save()
        shown = QApplication.palette()
        ground = shown.color(QPalette.ColorRole.Window)
        # On the accent a colour of state is not seen; its shape is.
        own = self._state and mode != QIcon.Mode.Selected
        painter.setPen(QColor(state_colour(self._state, ground)) if own else shown.color(group, role))
        painter.setFont(font)
        painter.drawText(rect, Qt.AlignmentFlag.AlignCenter, self._character)
        painter.restore()

    def pixmap(self, size: QSize, mode: QIcon.Mode, state: QIcon.State) -> QPixmap:
        pixmap = QPixmap(size)
        if pixmap.isNull():  # a view that is squeezed to nothing
            return pixmap
        pixmap.fill(QColor(0, 0, 0, 0))
        painter = QPainter(pixmap)
        self.paint(painter, QRect(QPoint(0, 0), size), mode, state)
        painter.end()
        return pixmap

    def clone(self) -> QIconEngine:
        return _GlyphEngine(self._character, self._font_family, self._state)


@cache
def icon(name: str, state: str = "") -> QIcon:
    """Return the icon of that Phosphor name, as in ``icon("folder-open")``; KeyError for an unknown name.

    ``state``, one of :func:`~brdf_qt.program.theme.state_colour`, gives its colour; others have that of the text.
    """
    family, characters = _family()
    return QIcon(_GlyphEngine(characters[name], family, state))
