"""The bar over the swatches: search, order, form, size, light; all for the pane in front or for all panes."""

from __future__ import annotations

from brdf_qt.fields.choice_button import ChoiceButton
from brdf_qt.fields.form import described, row_of
from brdf_qt.fields.quiet import QuietComboBox, QuietSlider
from brdf_qt.program.icons import icon
from brdf_qt.program.names import title_of
from brdf_qt.program.translation import mark, tr
from brdf_qt.work.timer import make_timer
from PySide6.QtCore import QEvent, QSignalBlocker, QSize, Qt, Signal
from PySide6.QtGui import QKeyEvent, QPalette, QResizeEvent
from PySide6.QtWidgets import (
    QBoxLayout,
    QButtonGroup,
    QComboBox,
    QLineEdit,
    QSizePolicy,
    QToolButton,
    QWidget,
)

from brdf_color_swatch.grid.view_state import SIZES, Look, PaneState

_SEARCH_AFTER_MS = 120
_SEARCH_PX = 208
"""Width that the search field always has: three words and its two signs."""
_ONE_LINE_PX = 720
"""Narrower, the bar has two lines: search and order above, form and light below."""
SORT_TITLES = {
    "own": mark("Palette order"),
    "hue": mark("Hue path"),
    "lightness": mark("Lightness"),
    "flop": mark("Flop"),
    "gloss": mark("Gloss"),
    "name": mark("Name"),
    "code": mark("Code"),
    "date": mark("Date"),
    "tags": mark("Tags"),
    "nearest": mark("Nearest first"),
}
_FORM_TITLES = {
    "sphere": (mark("Sphere"), "circle", mark("Sphere in the light booth")),
    "panel": (mark("Panel"), "rectangle", mark("Curved panel in the light booth")),
    "flop_strip": (mark("Flop"), "square-half", mark("Flop from 15° (left) to 110° (right)")),
    "chips": (mark("Chips"), "columns", mark("Measured colours at 15°, 45° and 110° as flat chips")),
}


class SearchField(QLineEdit):
    """Search text, emitted shortly after the last key press; Escape clears it."""

    searched = Signal(str)
    left_downwards = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        tip = tr("Every word must occur in name, code, tags, notes or group (Ctrl+F)")
        described(self, name="search", spoken=tr("Search names, codes, tags and notes"), tip=tip)
        self.setPlaceholderText(tr("Search names, codes, tags, notes"))
        self.setClearButtonEnabled(True)
        self.addAction(icon("magnifying-glass"), QLineEdit.ActionPosition.LeadingPosition)
        self._timer = make_timer(self, lambda: self.searched.emit(self.text()), _SEARCH_AFTER_MS)
        self.textEdited.connect(lambda _text: self._timer.start())

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape and self.text():
            self.clear()
            self._timer.stop()
            self.searched.emit("")
            return
        if event.key() in (Qt.Key.Key_Down, Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self._timer.stop()
            self.searched.emit(self.text())
            self.left_downwards.emit()
            return
        super().keyPressEvent(event)


class TopBar(QWidget):
    """Signals: ``sort_chosen(key)``, ``turned()`` (the other way round), ``form_chosen(form)``,
    ``size_chosen(pixels)``, ``light_chosen(name)``, ``list_chosen(bool)``; and those of :attr:`search`.
    """

    sort_chosen = Signal(str)
    turned = Signal()
    form_chosen = Signal(str)
    size_chosen = Signal(int)
    light_chosen = Signal(str)
    list_chosen = Signal(bool)

    def __init__(self, lights: list[str], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.search = SearchField()
        tip = tr("Order of the swatches. Swatches can be moved by hand in palette order")
        self.sort = described(QuietComboBox(), name="sort", spoken=tr("Order of the swatches"), tip=tip)
        for key, title in SORT_TITLES.items():
            self.sort.addItem(tr(title), key)
        self.sort.activated.connect(lambda _place: self.sort_chosen.emit(self.sort.currentData()))
        tip = tr("Light for all swatches")
        self.light = described(QuietComboBox(), name="light", spoken=tip, tip=tip)
        for name in lights:
            self.light.addItem(title_of(name), name)
        self.light.activated.connect(lambda _place: self.light_chosen.emit(self.light.currentData()))
        self.way = described(QToolButton(), name="way")
        self.way.setAutoRaise(True)
        self.way.clicked.connect(self.turned)
        self.forms = QButtonGroup(self)
        # None of them is down while a list is shown.
        self.forms.setExclusive(False)
        self._box = QBoxLayout(QBoxLayout.Direction.LeftToRight, self)
        self._box.setContentsMargins(8, 6, 8, 2)
        self._box.setSpacing(8)
        self.search.setMinimumWidth(_SEARCH_PX)
        self.search.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        for box in (self.sort, self.light):
            # In a narrow window they give way; their lists are as wide as their texts.
            box.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
            box.setMinimumContentsLength(7)
            box.view().setMinimumWidth(box.view().sizeHintForColumn(0) + 32)
        for key, (title, sign, tip) in _FORM_TITLES.items():
            button = _form_button(sign, f"form_{key}", tr(title), f"{tr(title)}: {tr(tip)}")
            button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
            button.clicked.connect(lambda _=False, key=key: self.form_chosen.emit(key))
            button.setProperty("form", key)
            self.forms.addButton(button)
        self.list_button = _form_button(
            "rows", "as_list", tr("List with columns"), tr("List with columns (5)")
        )
        self.list_button.clicked.connect(self.list_chosen)
        self.size_slider = described(
            QuietSlider(Qt.Orientation.Horizontal), name="size", spoken=tr("Swatch size in pixels")
        )
        self.size_slider.setRange(*SIZES)
        self.size_slider.setMinimumWidth(48)
        self.size_slider.setMaximumWidth(140)
        self.size_slider.valueChanged.connect(self.size_chosen)
        self._paint_grey()
        buttons = (*self.forms.buttons(), self.list_button)
        self._rows = (
            row_of(self.search, self.sort, self.way, grows=self.search),
            row_of(*buttons, self.size_slider, self.light, grows=self.size_slider),
        )
        for row, share in zip(self._rows, (3, 1), strict=True):
            self._box.addLayout(row, share)

    def minimumSizeHint(self) -> QSize:
        """Return the room of two lines, also while there is one: a neighbour may take what is not needed."""
        margins = self._box.contentsMargins()
        wide = max(row.minimumSize().width() for row in self._rows) + margins.left() + margins.right()
        return QSize(wide, super().minimumSizeHint().height())

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        ways = QBoxLayout.Direction
        self._box.setDirection(ways.TopToBottom if self.width() < _ONE_LINE_PX else ways.LeftToRight)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange:
            self._paint_grey()

    def _paint_grey(self) -> None:
        """Fill the slider with grey: the accent is for focus and selection alone."""
        slider = getattr(self, "size_slider", None)
        if slider is not None:
            colours = QPalette(self.palette())
            colours.setColor(QPalette.ColorRole.Highlight, colours.color(QPalette.ColorRole.PlaceholderText))
            slider.setPalette(colours)

    def show_state(self, state: PaneState) -> None:
        with QSignalBlocker(self.search):
            if self.search.text().strip() != state.text.strip():
                self.search.setText(state.text)
        self.sort.setCurrentIndex(self.sort.findData(state.sort))
        self.way.setIcon(icon("sort-descending" if state.descending else "sort-ascending"))
        self.way.setEnabled(state.sort not in ("own", "nearest"))
        down, up = tr("Descending; click for ascending"), tr("Ascending; click for descending")
        direction = down if state.descending else up
        described(self.way, spoken=direction, tip=direction)

    def show_look(self, look: Look) -> None:
        for button in self.forms.buttons():
            button.setChecked(button.property("form") == look.form and not look.as_list)
        self.list_button.setChecked(look.as_list)
        with QSignalBlocker(self.size_slider):
            self.size_slider.setValue(look.size)
        self.size_slider.setEnabled(not look.as_list)
        described(self.size_slider, tip=tr("Swatch size: {size} pixels (Ctrl+wheel)").format(size=look.size))
        place = self.light.findData(look.booth)
        if place >= 0:
            self.light.setCurrentIndex(place)


def _form_button(sign: str, name: str, spoken: str, tip: str) -> ChoiceButton:
    button = described(ChoiceButton(""), name=name, spoken=spoken, tip=tip)
    button.setIcon(icon(sign))
    return button
