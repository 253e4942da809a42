"""A panel beside the picture: it docks, floats and hides; the signs in its title have the colour of the text."""

from __future__ import annotations

from PySide6.QtCore import QEvent
from PySide6.QtWidgets import QAbstractButton, QDockWidget, QWidget

from brdf_qt.program.icons import icon

_SIGNS = {"qt_dockwidget_floatbutton": "arrow-square-out", "qt_dockwidget_closebutton": "x"}


class Panel(QDockWidget):
    """A dock with the icons of the suite: those of the style are one brownish grey in every theme."""

    def __init__(self, title: str, parent: QWidget | None = None) -> None:
        super().__init__(title, parent)
        # The style's come back with every change of what may be done with the panel.
        self.featuresChanged.connect(lambda _features: self._draw_signs())
        self.topLevelChanged.connect(lambda _floats: self._draw_signs())
        self._draw_signs()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() in (QEvent.Type.StyleChange, QEvent.Type.PaletteChange):
            self._draw_signs()

    def _draw_signs(self) -> None:
        for button in self.findChildren(QAbstractButton):
            name = _SIGNS.get(button.objectName())
            if name is not None and button.parent() is self:
                button.setIcon(icon(name))
