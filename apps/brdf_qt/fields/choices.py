"""Fields of the inspector: choices, sliders with a number, shipped things and files, colours, small notes."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from PySide6.QtCore import QSignalBlocker, QSize, Qt, Signal
from PySide6.QtGui import QColor, QIcon, QPixmap
from PySide6.QtWidgets import QColorDialog, QComboBox, QLabel, QPushButton, QWidget

from brdf_qt.fields.form import fill_row, icon_button
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


@dataclass(frozen=True)
class Source:
    """One entry: ``key`` is what is loaded (a shipped name or a path), ``title`` what is shown."""

    key: str
    title: str


class SourceChooser(QWidget):
    """Emits ``chosen(key)`` when the user takes an entry and ``browse_requested()`` for the button."""

    chosen = Signal(str)
    browse_requested = Signal()

    def __init__(self, browse_tip: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.list = QuietComboBox()
        self.list.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self.list.setMinimumContentsLength(14)
        self.list.activated.connect(lambda index: self.chosen.emit(self.list.itemData(index)))
        self.button = icon_button("folder-open", browse_tip, self.browse_requested.emit)
        fill_row(self, self.list, self.button, spacing=4)
        self.setFocusProxy(self.list)

    def set_sources(self, shipped: Iterable[Source], files: Iterable[Source]) -> None:
        """Fill the list: shipped things, a line, files; keeps what is shown where it is still there."""
        current = self.list.currentData()
        with QSignalBlocker(self.list):
            self.list.clear()
            for source in shipped:
                self.list.addItem(source.title, source.key)
            files = tuple(files)
            if files:
                self.list.insertSeparator(self.list.count())
            for source in files:
                self._add_file(source)
        if current is not None:
            self.show_source(current, "")

    def show_source(self, key: str, title: str) -> None:
        """Show ``key`` as the present choice, without a signal; added to the list where it is not in it."""
        index = self.list.findData(key)
        if index < 0 and title:
            self._add_file(Source(key, title))
            index = self.list.count() - 1
        with QSignalBlocker(self.list):
            self.list.setCurrentIndex(index)

    def rename(self, key: str, title: str) -> None:
        """Give an entry another title; nothing where there is none."""
        index = self.list.findData(key)
        if index >= 0:
            self.list.setItemText(index, title)

    def _add_file(self, source: Source) -> None:
        self.list.addItem(source.title, source.key)
        self.list.setItemData(self.list.count() - 1, plain_tip(source.key), Qt.ItemDataRole.ToolTipRole)


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
