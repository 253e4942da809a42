"""The studio's panel: file and history, the panorama, the list of lamps, and the fields of what is chosen."""

from __future__ import annotations

from functools import partial

from brdf_qt.fields.labels import PlainLabel, plain_tip
from brdf_qt.fields.text import TextLine
from brdf_qt.program.icons import icon
from brdf_qt.program.translation import tr
from PySide6.QtCore import QEvent, QSize, Qt, Signal, SignalInstance
from PySide6.QtGui import QKeyEvent, QKeySequence
from PySide6.QtWidgets import (
    QFrame,
    QHBoxLayout,
    QListWidget,
    QMenu,
    QPushButton,
    QScrollArea,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from brdf_suite.documents.studio import MOST_LAMPS, LightDocument, Studio, StudioLamp
from brdf_viewer.fields.note import note, set_note
from brdf_viewer.light.studio.lamp_form import SHAPE_TITLES, LampForm
from brdf_viewer.light.studio.places import polar
from brdf_viewer.light.studio.preview import StudioPreview
from brdf_viewer.light.studio.surroundings_form import SkyForm, SurroundingsForm
from brdf_viewer.light.studio.templates import TEMPLATES

_LIST_ROWS = 6
_KEYS = QKeySequence.StandardKey


class StudioPanel(QScrollArea):
    """Widgets only; without a light it offers to begin one.

    Signals
    -------
    new_requested(template), edit_requested(), save_requested(), save_as_requested(), undo_requested(), redo_requested()
        Of the document.
    chosen(index), add_requested(shape)
        Of the lamps. The fields report their edits by the forms' ``edits``.
    """

    new_requested = Signal(str)
    edit_requested = Signal()
    save_requested = Signal()
    save_as_requested = Signal()
    undo_requested = Signal()
    redo_requested = Signal()
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
        self.list.currentRowChanged.connect(self._row_changed)
        self.lamp, self.around, self.sky = LampForm(), SurroundingsForm(), SkyForm()
        self._quiet = False
        self._light: LightDocument | None = None
        self.save = _tool("floppy-disk", tr("Save the studio (Ctrl+S in this panel)"), self.save_requested)
        self.save_as = _tool("copy", tr("Save the studio under another name"), self.save_as_requested)
        self.undo = _tool("arrow-counter-clockwise", tr("Undo (Ctrl+Z in this panel)"), self.undo_requested)
        self.redo = _tool("arrow-clockwise", tr("Redo"), self.redo_requested)
        self.add = _tool("plus", tr("Add a lamp"))
        menu = QMenu(self.add)
        for shape, title in SHAPE_TITLES.items():
            menu.addAction(tr(title), partial(self.add_requested.emit, shape))
        self.add.setMenu(menu)
        self.add.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self.double = _tool("copy-simple", tr("Duplicate this lamp"))
        self.remove = _tool("trash", tr("Remove this lamp"))
        self.relight = QPushButton(tr("Light the picture with this studio"))
        self._lamps = self._lamp_part()
        self._begin, self._open = self._begin_part(), self._open_part()
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
        self._quiet = True
        try:
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
        finally:
            self._quiet = False
        self.setMinimumWidth(self._inner_width())  # it never scrolls sideways

    def set_state(self, text: str, can_undo: bool, can_redo: bool) -> None:
        """Say whether it is saved, and where."""
        set_note(self.state, text)
        self.undo.setEnabled(can_undo)
        self.redo.setEnabled(can_redo)

    def set_mistake(self, text: str) -> None:
        """Say why an edit was not taken; empty where it was."""
        set_note(self.mistake, text)

    def set_lit(self, lit: bool) -> None:
        """Offer to light the picture with it where it is not."""
        self.relight.setVisible(not lit)

    def _show_lamps(self, light: Studio, index: int) -> None:
        lines = [lamp_line(i, lamp) for i, lamp in enumerate(light.lamps)]
        for row, line in enumerate(lines):
            if row < self.list.count():
                self.list.item(row).setText(line)
            else:
                self.list.addItem(line)
        while self.list.count() > len(lines):
            self.list.takeItem(self.list.count() - 1)
        self.list.setCurrentRow(index)
        there = 0 <= index < len(light.lamps)
        self.lamp.setVisible(there)
        self.double.setEnabled(there and len(light.lamps) < MOST_LAMPS)
        self.remove.setEnabled(there)
        self.add.setEnabled(len(light.lamps) < MOST_LAMPS)
        if there:
            self.lamp.set_lamp(light.lamps[index], light.unit)

    def _row_changed(self, row: int) -> None:
        if not self._quiet:
            self.chosen.emit(row)

    def _begin_part(self) -> QWidget:
        part = QWidget()
        box = QVBoxLayout(part)
        box.setContentsMargins(0, 0, 0, 0)
        text = PlainLabel(tr("No studio is open. Create one, or edit the current light."))
        text.setWordWrap(True)
        box.addWidget(text)
        for key, (title, _) in TEMPLATES.items():
            button = QPushButton(tr(title))
            button.clicked.connect(lambda _=False, key=key: self.new_requested.emit(key))
            box.addWidget(button)
        edit = QPushButton(tr("Edit current light"))
        edit.clicked.connect(self.edit_requested)
        box.addWidget(edit)
        return part

    def _lamp_part(self) -> QWidget:
        part = QWidget()
        box = QVBoxLayout(part)
        box.setContentsMargins(0, 0, 0, 0)
        row = QHBoxLayout()
        row.addWidget(PlainLabel(tr("Lamps")), 1)
        for button in (self.add, self.double, self.remove):
            row.addWidget(button)
        self.list.setFixedHeight(_LIST_ROWS * (self.fontMetrics().height() + 4) + 4)
        box.addLayout(row)
        box.addWidget(self.list)
        box.addWidget(self.lamp)
        return part

    def _open_part(self) -> QWidget:
        part = QWidget()
        box = QVBoxLayout(part)
        box.setContentsMargins(0, 0, 0, 0)
        box.setSpacing(8)
        row = QHBoxLayout()
        row.setSpacing(4)
        row.addWidget(self.name, 1)
        for button in (self.save, self.save_as, self.undo, self.redo):
            row.addWidget(button)
        box.addLayout(row)
        for widget in (self.state, self.mistake, self.relight, self.preview, self._lamps, self.sky):
            box.addWidget(widget)
        box.addWidget(self.around)
        return part

    def event(self, event: QEvent) -> bool:
        """Take the document's keys before the window's commands of the same keys."""
        if (
            isinstance(event, QKeyEvent)
            and event.type() == QEvent.Type.ShortcutOverride
            and self._signal(event)
        ):
            event.accept()
            return True
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        signal = self._signal(event)
        if signal is None:
            super().keyPressEvent(event)
        else:
            signal.emit()

    def _signal(self, event: QKeyEvent) -> SignalInstance | None:
        """Return what a key of the document asks for; None for another key, or where no document is open."""
        if self._light is None:
            return None
        for keys, signal in (
            (_KEYS.Undo, self.undo_requested),
            (_KEYS.Redo, self.redo_requested),
            (_KEYS.SaveAs, self.save_as_requested),
            (_KEYS.Save, self.save_requested),
        ):
            if event.matches(keys):
                return signal
        return None


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


def _tool(name: str, tip: str, signal: SignalInstance | None = None) -> QToolButton:
    button = QToolButton()
    button.setIcon(icon(name))
    button.setToolTip(plain_tip(tip))
    button.setAccessibleName(tip)
    button.setAutoRaise(True)
    if signal is not None:
        button.clicked.connect(lambda _=False: signal.emit())
    return button
