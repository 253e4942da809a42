"""The palette or group that is shown: its name, its colour for the eye, its notes."""

from __future__ import annotations

from brdf_qt.program.icons import icon
from brdf_qt.program.translation import tr
from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QColor, QPixmap
from PySide6.QtWidgets import (
    QColorDialog,
    QFormLayout,
    QHBoxLayout,
    QLineEdit,
    QPushButton,
    QToolButton,
    QWidget,
)

from brdf_color_swatch.panels.swatch import _Notes


class PalettePanel(QWidget):
    """Signal ``edited(key, text)`` with ``name``, ``colour`` (``#rrggbb`` or empty) or ``notes``."""

    edited = Signal(str, str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._colour = ""
        self._name = ""
        self.name = QLineEdit()
        self.name.setObjectName("palette_name")
        self.name.setMaxLength(200)
        self.name.setMinimumWidth(60)
        self.name.setAccessibleName(tr("Name of the palette or group"))
        self.name.editingFinished.connect(self._named)
        self.colour = QPushButton()
        self.colour.setObjectName("palette_colour")
        self.colour.setToolTip(tr("Colour that marks the palette or group in the library"))
        self.colour.setAccessibleName(tr("Colour of the palette or group"))
        self.colour.clicked.connect(self._choose)
        self.none = QToolButton()
        self.none.setIcon(icon("x"))
        self.none.setAutoRaise(True)
        self.none.setToolTip(tr("No colour"))
        self.none.setAccessibleName(tr("No colour"))
        self.none.clicked.connect(lambda: self.edited.emit("colour", ""))
        self.notes = _Notes()
        self.notes.setObjectName("palette_notes")
        self.notes.setAccessibleName(tr("Notes of the palette or group"))
        self.notes.finished.connect(lambda text: self.edited.emit("notes", text))
        row = QHBoxLayout()
        row.addWidget(self.colour, 1)
        row.addWidget(self.none)
        form = QFormLayout(self)
        form.setContentsMargins(0, 0, 0, 0)
        form.setLabelAlignment(Qt.AlignmentFlag.AlignRight)
        form.addRow(tr("Name"), self.name)
        form.addRow(tr("Colour"), row)
        form.addRow(tr("Notes"), self.notes)
        self.show_palette("", "", "", there=False)

    def show_palette(self, name: str, colour: str, notes: str, *, there: bool) -> None:
        """Show a palette's or group's own fields."""
        self._name, self._colour = name, colour
        if not (self.name.hasFocus() and self.name.isModified()):
            self.name.setText(name)
            self.name.setCursorPosition(0)
        self.notes.show_text(notes)
        if colour:
            picture = QPixmap(48, 16)
            picture.fill(QColor(colour))
            self.colour.setIcon(picture)
            self.colour.setText(colour)
        else:
            self.colour.setIcon(QPixmap())
            self.colour.setText(tr("None"))
        self.none.setEnabled(bool(colour))
        self.setEnabled(there)

    def _named(self) -> None:
        text = self.name.text().strip()
        if not text:
            self.name.setText(self._name)
        elif text != self._name:
            self.name.setModified(False)
            self.edited.emit("name", text)

    def _choose(self) -> None:
        dialog = QColorDialog(QColor(self._colour or "#808080"), self)
        dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        dialog.setWindowTitle(tr("Colour of the Palette"))
        dialog.colorSelected.connect(lambda colour: self.edited.emit("colour", colour.name()))
        dialog.open()
