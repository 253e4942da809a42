"""The palette or group that is shown: its name, its colour for the eye, its notes."""

from __future__ import annotations

from brdf_qt.fields.form import described, icon_button, row_of
from brdf_qt.fields.quiet import quieten
from brdf_qt.program.translation import tr
from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QColor, QPixmap
from PySide6.QtWidgets import QColorDialog, QFormLayout, QLineEdit, QPushButton, QWidget

from brdf_color_swatch.panels.swatch import _Notes


class PalettePanel(QWidget):
    """Signal ``edited(key, text)`` with ``name``, ``colour`` (``#rrggbb`` or empty) or ``notes``."""

    edited = Signal(str, str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._colour = ""
        self._name = ""
        self.name = described(QLineEdit(), name="palette_name", spoken=tr("Name of the palette or group"))
        self.name.setMaxLength(200)
        self.name.setMinimumWidth(60)
        self.name.editingFinished.connect(self._named)
        spoken = tr("Colour of the palette or group")
        tip = tr("Colour that marks the palette or group in the library")
        self.colour = described(QPushButton(), name="palette_colour", spoken=spoken, tip=tip)
        self.colour.clicked.connect(self._choose)
        self.none = icon_button("x", tr("No colour"), lambda: self.edited.emit("colour", ""), flat=True)
        self.notes = described(_Notes(), name="palette_notes", spoken=tr("Notes of the palette or group"))
        self.notes.finished.connect(lambda text: self.edited.emit("notes", text))
        form = QFormLayout(self)
        form.setContentsMargins(0, 0, 0, 0)
        form.setLabelAlignment(Qt.AlignmentFlag.AlignRight)
        form.addRow(tr("Name"), self.name)
        form.addRow(tr("Colour"), row_of(self.colour, self.none, grows=self.colour, spacing=6))
        form.addRow(tr("Notes"), self.notes)
        self.show_palette("", "", "", there=False)

    def show_palette(self, name: str, colour: str, notes: str, *, there: bool) -> None:
        self._name, self._colour = name, colour
        if not (self.name.hasFocus() and self.name.isModified()):
            self.name.setText(name)
            self.name.setCursorPosition(0)
        self.notes.show_text(notes)
        picture = QPixmap(48, 16) if colour else QPixmap()
        picture.fill(QColor(colour))
        self.colour.setIcon(picture)
        self.colour.setText(colour or tr("None"))
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
        quieten(dialog)
        dialog.open()
