"""The end of the tab Export: one button for all files, one for the clipboard."""

from __future__ import annotations

from brdf_qt.fields.form import Form
from brdf_qt.fields.labels import plain_tip
from brdf_qt.program.icons import icon
from brdf_qt.program.translation import tr
from brdf_qt.window.section import Section
from PySide6.QtWidgets import QPushButton, QWidget


class ExportSection(Section):
    """``export`` opens the dialog of all exports, ``copy`` takes the picture to the clipboard."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(tr("Export"), "export", parent, titled=False)
        self.export = _button(
            "export", tr("Export…"), tr("A picture, a turntable or a contact sheet, with a preview")
        )
        self.copy = _button(
            "copy", tr("Copy Picture"), tr("Copy the picture to the clipboard at full resolution")
        )
        form = self.add(Form())
        form.add_row(tr("File"), self.export)
        form.add_row(tr("Clipboard"), self.copy)


def _button(name: str, text: str, tip: str) -> QPushButton:
    button = QPushButton(icon(name), text)
    button.setToolTip(plain_tip(tip))
    button.setAccessibleName(text)
    return button
