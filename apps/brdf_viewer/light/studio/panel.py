"""The studio's panel: file and history, the panorama, the list of lamps, and the fields of what is chosen."""

from __future__ import annotations

from functools import partial

from brdf_qt.fields.choices import note, set_note
from brdf_qt.fields.form import fill_column, fill_row, icon_button
from brdf_qt.fields.labels import PlainLabel
from brdf_qt.fields.text import TextLine
from brdf_qt.program.translation import tr
from PySide6.QtCore import QEvent, QSignalBlocker, QSize, Qt, Signal
from PySide6.QtGui import QKeyEvent, QKeySequence
from PySide6.QtWidgets import (
    QFrame,
    QListWidget,
    QMenu,
    QPushButton,
    QScrollArea,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from brdf_suite.documents.studio import MOST_LAMPS, LightDocument, Studio, StudioLamp
from brdf_suite.geometry.polar import polar
from brdf_viewer.light.studio.document import TEMPLATES
from brdf_viewer.light.studio.forms import SHAPE_TITLES, LampForm, SkyForm, SurroundingsForm
from brdf_viewer.light.studio.preview import StudioPreview

_LIST_ROWS = 6
_KEYS = QKeySequence.StandardKey


class StudioPanel(QScrollArea):
    """Widgets only; without a light it offers to begin one.

    Signals: ``new_requested(template)``; of the lamps ``chosen(index)`` and ``add_requested(shape)``. The fields report
    their edits by the forms' ``edits``; the keys of the document press its buttons.
    """

    new_requested = Signal(str)
    chosen = Signal(int)
    add_requested = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWidgetResizable(True)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOn)
        self.name = TextLine(tr("Name of the studio"), 200)
        self.state, self.mistake = note(), note()
        self.preview = StudioPreview()
        self.list = QListWidget()
        self.list.setAccessibleName(tr("Lamps of the studio"))
        self.list.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.list.setFixedHeight(_LIST_ROWS * (self.fontMetrics().height() + 4) + 4)
        self.list.currentRowChanged.connect(self.chosen)
        self.lamp, self.around, self.sky = LampForm(), SurroundingsForm(), SkyForm()
        self._light: LightDocument | None = None
        self.save = icon_button("floppy-disk", tr("Save the studio (Ctrl+S in this panel)"), flat=True)
        self.save_as = icon_button("copy", tr("Save the studio under another name"), flat=True)
        self.undo = icon_button("arrow-counter-clockwise", tr("Undo (Ctrl+Z in this panel)"), flat=True)
        self.redo = icon_button("arrow-clockwise", tr("Redo"), flat=True)
        self._keys = {
            _KEYS.Undo: self.undo,
            _KEYS.Redo: self.redo,
            _KEYS.SaveAs: self.save_as,
            _KEYS.Save: self.save,
        }
        self.add = icon_button("plus", tr("Add a lamp"), flat=True)
        menu = QMenu(self.add)
        for shape, title in SHAPE_TITLES.items():
            menu.addAction(tr(title), partial(self.add_requested.emit, shape))
        self.add.setMenu(menu)
        self.add.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self.double = icon_button("copy-simple", tr("Duplicate this lamp"), flat=True)
        self.remove = icon_button("trash", tr("Remove this lamp"), flat=True)
        self.edit = QPushButton(tr("Edit current light"))
        self.relight = QPushButton(tr("Light the picture with this studio"))
        self._lamps, self._begin, self._open = QWidget(), self._begin_part(), QWidget()
        row = QWidget()
        fill_row(row, PlainLabel(tr("Lamps")), self.add, self.double, self.remove, spacing=6)
        fill_column(self._lamps, row, self.list, self.lamp, spacing=6)
        row = QWidget()
        fill_row(row, self.name, self.save, self.save_as, self.undo, self.redo, spacing=4)
        parts = (self.state, self.mistake, self.relight, self.preview, self._lamps, self.sky, self.around)
        fill_column(self._open, row, *parts)
        self._inside = inside = QWidget()
        box = QVBoxLayout(inside)
        box.setContentsMargins(8, 8, 8, 8)
        box.addWidget(self._begin)
        box.addWidget(self._open)
        box.addStretch(1)
        self.setWidget(inside)
        self.set_light(None, -1)

    def sizeHint(self) -> QSize:
        return QSize(self._inner_width(), 640)

    def minimumSizeHint(self) -> QSize:
        return QSize(self._inner_width(), 120)

    def _inner_width(self) -> int:
        return self._inside.minimumSizeHint().width() + self.verticalScrollBar().sizeHint().width() + 2

    def set_light(self, light: LightDocument | None, index: int) -> None:
        """Show a light and its lamp of that index, without a signal; None offers to begin one."""
        self._light = light
        self._begin.setVisible(light is None)
        self._open.setVisible(light is not None)
        if light is None:
            return
        self.name.set_text(light.name)
        self.preview.set_light(light)
        is_studio = isinstance(light, Studio)
        self._lamps.setVisible(is_studio)
        self.around.setVisible(is_studio)
        self.sky.setVisible(not is_studio)
        if isinstance(light, Studio):
            self._show_lamps(light, index)
            self.around.set_studio(light)
        else:
            self.sky.set_sky(light)
        self.preview.set_chosen(index)
        self.setMinimumWidth(self._inner_width())  # it never scrolls sideways

    def set_state(self, text: str, can_undo: bool, can_redo: bool) -> None:
        """Say whether it is saved, and where."""
        set_note(self.state, text)
        self.undo.setEnabled(can_undo)
        self.redo.setEnabled(can_redo)

    def _show_lamps(self, light: Studio, index: int) -> None:
        with QSignalBlocker(self.list):
            while self.list.count() > len(light.lamps):
                self.list.takeItem(self.list.count() - 1)
            while self.list.count() < len(light.lamps):
                self.list.addItem("")
            for row, lamp in enumerate(light.lamps):
                self.list.item(row).setText(lamp_line(row, lamp))
            self.list.setCurrentRow(index)
        there = 0 <= index < len(light.lamps)
        self.lamp.setVisible(there)
        self.double.setEnabled(there and len(light.lamps) < MOST_LAMPS)
        self.remove.setEnabled(there)
        self.add.setEnabled(len(light.lamps) < MOST_LAMPS)
        if there:
            self.lamp.set_lamp(light.lamps[index], light.unit)

    def _begin_part(self) -> QWidget:
        part = QWidget()
        text = PlainLabel(tr("No studio is open. Create one, or edit the current light."), wordWrap=True)
        buttons = []
        for key, (title, _) in TEMPLATES.items():
            buttons.append(QPushButton(tr(title)))
            buttons[-1].clicked.connect(lambda _=False, key=key: self.new_requested.emit(key))
        fill_column(part, text, *buttons, self.edit, spacing=6)
        return part

    def event(self, event: QEvent) -> bool:
        """Take the document's keys before the window's commands of the same keys."""
        asked = event.type() == QEvent.Type.ShortcutOverride
        if asked and isinstance(event, QKeyEvent) and self._button(event):
            event.accept()
            return True
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        button = self._button(event)
        if button is None:
            super().keyPressEvent(event)
        else:
            button.click()

    def _button(self, event: QKeyEvent) -> QToolButton | None:
        """Return the button that a key of the document presses; None for another key, or where none is open."""
        pressed = (button for keys, button in self._keys.items() if event.matches(keys))
        return None if self._light is None else next(pressed, None)


def lamp_line(index: int, lamp: StudioLamp) -> str:
    """Return a lamp's line in the list.

    >>> lamp_line(0, StudioLamp("ring", (0.0, 2.0, 2.0), (1.0, 0.1), luminance=8.0, colour_temperature_k=3200.0))
    '1  Ring, 0° and 45° up, 8, 3200 K'
    """
    azimuth, elevation, _ = polar(lamp.position_m)
    kelvin = lamp.colour_temperature_k
    colour = tr("neutral") if kelvin is None else f"{kelvin:.0f} K"
    place = tr("{azimuth:.0f}° and {elevation:.0f}° up").format(azimuth=azimuth, elevation=elevation)
    return f"{index + 1}  {tr(SHAPE_TITLES[lamp.shape])}, {place}, {lamp.luminance:g}, {colour}"
