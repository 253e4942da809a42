"""The colour pickers beside the window, and the menus that name readings, files and steps."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial

from brdf_qt.fields.labels import plain_tip
from brdf_qt.fields.quiet import quieten
from brdf_qt.program.translation import tr
from brdf_qt.window.shortcuts import PRESETS, give_keys
from PySide6.QtCore import QObject, Qt
from PySide6.QtGui import QAction, QColor
from PySide6.QtWidgets import QColorDialog, QMenu, QWidget

from brdf_designer.session.edits import MakeSolid, PickColour
from brdf_designer.session.paint_session import PaintSession
from brdf_designer.session.state import AngleColour
from brdf_suite.appearance.colour.colorimetry import display_to_lab
from brdf_suite.foreign_text import make_visible


class ColourPickers(QObject):
    """One picker for a reading at most, each a single step however long it is used."""

    def __init__(self, session: PaintSession, window: QWidget) -> None:
        super().__init__(window)
        self._session, self._window = session, window
        self.dialogs: dict[int, QColorDialog] = {}

    def open(self, colour: AngleColour) -> None:
        """Open the picker of a measurement, or bring it to the front."""
        index = colour.index
        if index in self.dialogs:
            self.dialogs[index].activateWindow()
            return
        dialog = QColorDialog(QColor(*colour.rgb), self._window)
        dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        dialog.setWindowTitle(tr("Colour at {angle}").format(angle=colour.text))
        dialog.setOptions(
            QColorDialog.ColorDialogOption.NoButtons | QColorDialog.ColorDialogOption.DontUseNativeDialog
        )
        quieten(dialog)
        self.dialogs[index] = dialog

        def picked(code: QColor) -> None:
            # An sRGB code has a step of about 0.4 units; two decimals keep all of it.
            lab = display_to_lab([code.redF(), code.greenF(), code.blueF()])
            lightness, a, b = (round(float(value), 2) + 0.0 for value in lab)
            self._session.edit(PickColour(index, (lightness, a, b)))

        def ended() -> None:
            self.dialogs.pop(index, None)
            self._session.end_gesture()

        self._session.begin_gesture()
        dialog.currentColorChanged.connect(picked)
        dialog.finished.connect(ended)
        dialog.show()

    def close(self) -> None:
        """Close every one."""
        for dialog in tuple(self.dialogs.values()):
            dialog.close()


class ReadingMenus(QObject):
    """Paint ▸ Pick Colour and Make Solid From, an entry for each reading; ``pick(index)`` opens its picker."""

    def __init__(self, menu: QMenu, session: PaintSession, pick: Callable[[int], None]) -> None:
        super().__init__(menu)
        self._session, self._open_picker = session, pick
        self._pick, self._solid = menu.addMenu(tr("&Pick Colour")), menu.addMenu(tr("Make S&olid From"))
        self._shown: list[tuple[int, str]] | None = None

    def show_angles(self, angles: Sequence[AngleColour]) -> bool:
        """Name these readings; True where they are others than before."""
        texts = [(angle.index, angle.text) for angle in angles]
        if texts == self._shown:
            return False
        self._shown = texts
        self._pick.clear()
        self._solid.clear()
        for number, (index, text) in enumerate(texts, 1):
            name = tr("At {angle}…").format(angle=text)
            pick = self._pick.addAction(name, partial(self._open_picker, index))
            if number <= PRESETS:
                give_keys(pick, f"pick_{number}")
            self._solid.addAction(text, partial(self._session.edit, MakeSolid(index)))
        return True


def name_step(action: QAction, word: str, name: str, *, can: bool) -> None:
    """Let Undo or Redo say what it would do."""
    action.setText(f"{word} {make_visible(name)}".rstrip())
    action.setIconText(word.replace("&", ""))
    action.setToolTip(plain_tip(f"{action.text().replace('&', '')} ({action.shortcut().toString()})"))
    action.setEnabled(can)
