"""The colour pickers beside the desk: one for a measurement at most, each a single step however long it is used."""

from __future__ import annotations

from brdf_qt.translation import tr
from PySide6.QtCore import QObject, Qt, Signal
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QColorDialog, QWidget

from brdf_designer.desk_state import AngleColour
from brdf_designer.fields import Key
from brdf_suite.appearance.colorimetry import display_to_lab


class ColourPickers(QObject):
    """Opens and closes them; ``started(key)``, ``picked(key, L*a*b*)`` and ``finished()`` tell of their use."""

    started = Signal(object)
    picked = Signal(object, object)
    finished = Signal()

    def __init__(self, window: QWidget) -> None:
        super().__init__(window)
        self._window = window
        self.dialogs: dict[int, QColorDialog] = {}

    def open(self, colour: AngleColour) -> None:
        """Open the picker of a measurement, or bring it to the front."""
        index = colour.index
        if index in self.dialogs:
            self.dialogs[index].activateWindow()
            return
        key: Key = ("colour", index)
        dialog = QColorDialog(QColor(*colour.rgb), self._window)
        dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        dialog.setWindowTitle(tr("Colour at {angle}").format(angle=colour.text))
        dialog.setOptions(
            QColorDialog.ColorDialogOption.NoButtons | QColorDialog.ColorDialogOption.DontUseNativeDialog
        )
        self.dialogs[index] = dialog

        def picked(code: QColor) -> None:
            lab = display_to_lab([code.redF(), code.greenF(), code.blueF()])
            # An sRGB code has a step of about 0.4 units; two decimals keep all of it.
            self.picked.emit(key, tuple(round(float(value), 2) + 0.0 for value in lab))

        def ended() -> None:
            self.dialogs.pop(index, None)
            self.finished.emit()

        self.started.emit(key)
        dialog.currentColorChanged.connect(picked)
        dialog.finished.connect(ended)
        dialog.show()

    def close(self) -> None:
        """Close every one."""
        for dialog in tuple(self.dialogs.values()):
            dialog.close()
