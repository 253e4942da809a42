"""The questions that a program asks about its files; tests answer them with a script of their own."""

from __future__ import annotations

from enum import Enum
from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtGui import QIcon
from PySide6.QtWidgets import QDialog, QDialogButtonBox, QFileDialog, QLabel, QMessageBox, QWidget

from brdf_qt.fields.quiet import quieten
from brdf_qt.program.icons import icon
from brdf_qt.program.translation import tr
from brdf_suite.foreign_text import make_visible

_ICON = 32
"""Size of the sign in a question, pixels; our own signs, because those of the style have colour."""


class Answer(Enum):
    """What to do with unsaved changes."""

    SAVE = "save"
    DISCARD = "discard"
    CANCEL = "cancel"


class Overwrite(Enum):
    """What to do about a file that another program has changed."""

    OVERWRITE = "overwrite"
    SAVE_AS = "save as"
    CANCEL = "cancel"


def without_icons(dialog: QDialog) -> None:
    """Take the icons off a dialog's buttons: those of Qt are green and red, and the interface has no colour."""
    for row in dialog.findChildren(QDialogButtonBox):
        for button in row.buttons():
            button.setIcon(QIcon())


class QtDialogs:
    """The questions as dialogs over ``window``."""

    def __init__(self, window: QWidget) -> None:
        self._window = window

    def unsaved(self, name: str) -> Answer:
        """Ask what to do with the unsaved changes of document ``name``."""
        question = tr("Save changes to “{name}”?").format(name=name)
        more = tr("Your changes will be lost if you don't save them.")
        box = self._box("floppy-disk", tr("Unsaved Changes"), question, more)
        kinds = QMessageBox.StandardButton
        box.setStandardButtons(kinds.Save | kinds.Discard | kinds.Cancel)
        box.setDefaultButton(kinds.Save)
        without_icons(box)
        answers = {kinds.Save: Answer.SAVE, kinds.Discard: Answer.DISCARD}
        return answers.get(kinds(box.exec()), Answer.CANCEL)

    def changed_file(self, path: Path) -> Overwrite:
        """Ask what to do, on saving, about a file that holds something else than this program knows of."""
        text = tr("“{name}” was changed by another program since it was opened or saved here.")
        more = tr("Overwriting discards the changes of the other program.") + f"\n{path}"
        box = self._box("warning", tr("File Changed"), text.format(name=path.name), more)
        roles = QMessageBox.ButtonRole
        overwrite = box.addButton(tr("Overwrite"), roles.DestructiveRole)
        save_as = box.addButton(tr("Save As…"), roles.AcceptRole)
        box.setDefaultButton(save_as)
        box.setEscapeButton(box.addButton(QMessageBox.StandardButton.Cancel))
        without_icons(box)
        box.exec()
        clicked = box.clickedButton()
        if clicked is overwrite:
            return Overwrite.OVERWRITE
        return Overwrite.SAVE_AS if clicked is save_as else Overwrite.CANCEL

    def _box(self, sign: str, title: str, text: str, more: str) -> QMessageBox:
        box = QMessageBox(self._window)
        box.setIconPixmap(icon(sign).pixmap(_ICON, _ICON))
        box.setWindowTitle(make_visible(title))
        box.setText(make_visible(text))
        box.setInformativeText(make_visible(more))
        # Both drawn as they are: they hold names of files. The box's own text format is that of its first text alone.
        for label in box.findChildren(QLabel):
            label.setTextFormat(Qt.TextFormat.PlainText)
        return box

    def open_path(self, folder: Path, filters: str) -> Path | None:
        """Ask for a file to open; ``None`` where the user gives up."""
        dialog = QFileDialog(self._window, tr("Open"), str(folder), filters)
        dialog.setFileMode(QFileDialog.FileMode.ExistingFile)
        return _chosen(dialog)

    def folder_path(self, title: str, folder: Path) -> Path | None:
        """Ask for a folder, which the dialog can make; ``None`` where the user gives up."""
        dialog = QFileDialog(self._window, title, str(folder))
        dialog.setFileMode(QFileDialog.FileMode.Directory)
        dialog.setOption(QFileDialog.Option.ShowDirsOnly)
        return _chosen(dialog)

    def over(self, window: QWidget) -> QtDialogs:
        """Return the same questions over another window, which keeps the focus then."""
        return QtDialogs(window)

    def save_path(self, suggested: Path, filters: str) -> Path | None:
        """Ask for a file to write; ``None`` where the user gives up."""
        dialog = QFileDialog(self._window, tr("Save As"), str(suggested.parent), filters)
        dialog.setAcceptMode(QFileDialog.AcceptMode.AcceptSave)
        # Added by the dialog and not afterwards, so that it asks about the file that is really written.
        dialog.setDefaultSuffix(suggested.suffix)
        dialog.selectFile(suggested.name)
        return _chosen(dialog)


def _chosen(dialog: QFileDialog) -> Path | None:
    """Ask, and return the file that was named; ``None`` where the user gives up."""
    without_icons(dialog)
    quieten(dialog)
    accepted = dialog.exec() == QFileDialog.DialogCode.Accepted
    names = dialog.selectedFiles()
    dialog.deleteLater()
    return Path(names[0]) if accepted and names else None
