"""A button that shows a colour and lets the user pick another, seen in the picture while it is picked."""

from __future__ import annotations

from brdf_qt.program.translation import tr
from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QColor, QIcon, QPixmap
from PySide6.QtWidgets import QColorDialog, QPushButton, QWidget

Colour = tuple[float, float, float]
_SWATCH = QSize(28, 14)


class ColourButton(QPushButton):
    """Holds one colour, encoded sRGB, 0 to 1; ``edited(colour)`` is emitted for each that the user picks."""

    edited = Signal(object)

    def __init__(self, title: str, parent: QWidget | None = None) -> None:
        super().__init__(tr("Pick a colour"), parent)
        self._title = title
        self._colour: Colour = (0.0, 0.0, 0.0)
        self.picker: QColorDialog | None = None
        self.setAccessibleName(title)
        self.setIconSize(_SWATCH)
        self.clicked.connect(self._pick)

    def set_colour(self, colour: Colour) -> None:
        """Show the present colour."""
        self._colour = colour
        swatch = QPixmap(_SWATCH)
        swatch.fill(QColor.fromRgbF(*colour))
        self.setIcon(QIcon(swatch))

    def _pick(self) -> None:
        if self.picker is not None:
            self.picker.activateWindow()
            return
        dialog = QColorDialog(QColor.fromRgbF(*self._colour), self.window())
        dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        dialog.setWindowTitle(self._title)
        dialog.setOptions(
            QColorDialog.ColorDialogOption.NoButtons | QColorDialog.ColorDialogOption.DontUseNativeDialog
        )
        self.picker = dialog
        dialog.currentColorChanged.connect(self._picked)
        dialog.finished.connect(self._ended)
        dialog.show()

    def _picked(self, code: QColor) -> None:
        self.edited.emit((code.redF(), code.greenF(), code.blueF()))

    def _ended(self) -> None:
        self.picker = None
