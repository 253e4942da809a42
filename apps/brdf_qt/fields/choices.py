"""Fields of the inspector: choices, sliders with a number, colours, small notes."""

from __future__ import annotations

from collections.abc import Mapping

from PySide6.QtCore import QSignalBlocker, QSize, Qt, Signal
from PySide6.QtGui import QColor, QIcon, QPixmap
from PySide6.QtWidgets import QColorDialog, QLabel, QPushButton, QWidget

from brdf_qt.fields.form import fill_row
from brdf_qt.fields.labels import RoomyLabel, plain_tip
from brdf_qt.fields.number import NumberField
from brdf_qt.fields.quiet import QuietComboBox, QuietSlider, quieten
from brdf_qt.program.translation import tr


class ChoiceBox(QuietComboBox):
    """Emits ``picked(key)`` when the user takes a choice, and not when it is shown."""

    picked = Signal(str)

    def __init__(
        self, titles: Mapping[str, str], tips: Mapping[str, str] | None = None, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        for key, title in titles.items():
            self.addItem(tr(title), key)
            if tips is not None:
                self.setItemData(self.count() - 1, plain_tip(tr(tips[key])), Qt.ItemDataRole.ToolTipRole)
        self.activated.connect(lambda index: self.picked.emit(self.itemData(index)))

    def show_choice(self, key: str) -> None:
        """Show ``key`` as the present choice, without a signal."""
        self.setCurrentIndex(self.findData(key))


def note(text: str = "", lines: int = 0) -> RoomyLabel:
    """Return a small label for facts under a field, hidden while it is empty; its room for ``lines`` is kept."""
    label = RoomyLabel(lines=lines)
    set_note(label, text)
    return label


def set_note(label: QLabel, text: str) -> None:
    """Show ``text``, or hide the label where it is empty."""
    label.setText(text)
    label.setVisible(bool(text))


class SliderField(QWidget):
    """``edited(value)`` comes from the user alone; :meth:`set_value` is silent. The slider stands on whole steps."""

    edited = Signal(float)

    def __init__(
        self,
        name: str,
        unit: str,
        minimum: float,
        maximum: float,
        step: float,
        decimals: int,
        default: float,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._step = step
        self.slider = QuietSlider(Qt.Orientation.Horizontal)
        self.slider.setRange(round(minimum / step), round(maximum / step))
        self.slider.setPageStep(max(1, round((maximum - minimum) / step / 12)))
        self.slider.setAccessibleName(name)
        self.slider.setMinimumWidth(72)
        self.number = NumberField(name, unit, minimum, maximum, step, decimals, default)
        self.number.setFixedWidth(76)
        self.slider.valueChanged.connect(self._slid)
        self.number.edited.connect(self._typed)
        fill_row(self, self.slider, self.number)
        self.setFocusProxy(self.number)
        self.set_value(default)

    def explain(self, tip: str) -> None:
        """Give slider and number a tip."""
        for part in (self.slider, self.number):
            part.setToolTip(plain_tip(tip))

    def value(self) -> float:
        return self.number.value()

    def set_value(self, value: float) -> None:
        """Show ``value`` on both, without a signal."""
        self.number.set_value(value)
        self._set_slider(value)

    def _slid(self, steps: int) -> None:
        self.number.set_value(steps * self._step)
        self.edited.emit(self.number.value())

    def _typed(self, value: float) -> None:
        self._set_slider(value)
        self.edited.emit(value)

    def _set_slider(self, value: float) -> None:
        with QSignalBlocker(self.slider):
            self.slider.setValue(round(value / self._step))


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
        options = QColorDialog.ColorDialogOption
        dialog.setOptions(options.NoButtons | options.DontUseNativeDialog)
        quieten(dialog)
        self.picker = dialog
        dialog.currentColorChanged.connect(
            lambda code: self.edited.emit((code.redF(), code.greenF(), code.blueF()))
        )
        dialog.finished.connect(self._ended)
        dialog.show()

    def _ended(self) -> None:
        self.picker = None
