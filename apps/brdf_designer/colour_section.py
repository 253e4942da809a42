"""L*, a* and b* of every measurement: sliders that show the colours they would give, numbers, and a picker."""

from __future__ import annotations

from brdf_qt.colour_slider import ColourSlider
from brdf_qt.number_field import NumberField
from PySide6.QtCore import QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QAbstractButton, QGridLayout, QHBoxLayout, QLabel, QVBoxLayout, QWidget

from brdf_designer.desk_state import AngleColour, Colours
from brdf_designer.display import component_tracks
from brdf_designer.fields import COMPONENTS
from brdf_designer.patches import OUTSIDE_TIP, paint_corner, place_word
from brdf_suite.documents.paint import PARAMETERS, Lab

# Where the sliders reach; the numbers reach as far as the document. No paint known lies outside.
SLIDER_RANGES = ((0.0, 150.0), (-100.0, 100.0), (-100.0, 100.0))
_TIPS = (
    "Lightness L* (CIE 1976, D65, 10°). A perfect white diffuser has 100; a metallic may pass it near the mirror "
    "direction.",
    "a*: from green (negative) to red (positive).",
    "b*: from blue (negative) to yellow (positive).",
)


class Swatch(QAbstractButton):
    """A small field of the colour that opens the picker."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._colour = QColor()
        self._in_gamut = True
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)

    def show_colour(self, colour: AngleColour) -> None:
        """Show the colour of a measurement."""
        self._colour, self._in_gamut = QColor(*colour.rgb), colour.in_gamut
        tip = f"Pick the colour at {colour.text}"
        self.setAccessibleName(tip)
        self.setToolTip(tip if colour.in_gamut else f"{tip}\n{OUTSIDE_TIP}")
        self.update()

    def sizeHint(self) -> QSize:
        return QSize(56, 24)

    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = QPainter(self)
        rect = QRectF(self.rect()).adjusted(1, 1, -1, -1)
        painter.fillRect(rect, self._colour)
        if not self._in_gamut:
            paint_corner(painter, rect, 10.0)
        focus = self.hasFocus() or self.underMouse()
        edge = self.palette().highlight().color() if focus else self.palette().dark().color()
        painter.setPen(QPen(edge, 2.0 if focus else 1.0))
        painter.drawRect(rect)


class AngleEditor(QWidget):
    """One measurement: its angle, its swatch and three rows of slider and number."""

    edited = Signal(int, int, float)
    gesture_started = Signal(int, int)
    gesture_finished = Signal()
    pick_asked = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.index = 0
        self._lab: Lab | None = None
        self._title = QLabel()
        font = self._title.font()
        font.setBold(True)
        self._title.setFont(font)
        self.swatch = Swatch()
        self.swatch.clicked.connect(lambda: self.pick_asked.emit(self.index))
        head = QHBoxLayout()
        head.setContentsMargins(0, 0, 0, 0)
        head.addWidget(self._title, 1)
        head.addWidget(self.swatch)
        grid = QGridLayout()
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setHorizontalSpacing(8)
        grid.setVerticalSpacing(4)
        grid.setColumnMinimumWidth(0, 20)
        grid.setColumnStretch(1, 1)
        self.sliders: list[ColourSlider] = []
        self.fields: list[NumberField] = []
        for component, name in enumerate(COMPONENTS):
            self._add_row(grid, component, name)
        box = QVBoxLayout(self)
        box.setContentsMargins(0, 0, 0, 4)
        box.setSpacing(4)
        box.addLayout(head)
        box.addLayout(grid)

    def _add_row(self, grid: QGridLayout, component: int, name: str) -> None:
        low, high = SLIDER_RANGES[component]
        known = PARAMETERS[f"lab[{component}]"]
        slider = ColourSlider(name, "", low, high, 0.1)
        field = NumberField(name, "", known.low, known.high, 0.5, 2, known.default)
        field.setFixedWidth(72)
        for source in (slider, field):
            source.setToolTip(_TIPS[component])
            source.edited.connect(lambda value, c=component: self.edited.emit(self.index, c, value))
            source.gesture_started.connect(lambda c=component: self.gesture_started.emit(self.index, c))
            source.gesture_finished.connect(self.gesture_finished)
        label = QLabel(name)
        label.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        label.setToolTip(_TIPS[component])
        label.setBuddy(field)
        grid.addWidget(label, component, 0)
        grid.addWidget(slider, component, 1)
        grid.addWidget(field, component, 2)
        self.sliders.append(slider)
        self.fields.append(field)

    def show_colour(self, colour: AngleColour) -> None:
        """Show one measurement; nothing is drawn anew where it is the same."""
        if colour.index != self.index or not self._title.text():
            self.setObjectName(f"angle_{colour.index}")
            for name, slider, field in zip(COMPONENTS, self.sliders, self.fields, strict=True):
                slider.setAccessibleName(f"{name} at {colour.text}")
                field.setAccessibleName(f"{name} at {colour.text}, number")
        self.index = colour.index
        self._title.setText(f"{colour.text}  {place_word(colour.aspecular_deg)}".rstrip())
        if colour.lab == self._lab:
            return
        self._lab = colour.lab
        self.swatch.show_colour(colour)
        tracks = component_tracks(colour.lab, [slider.positions() for slider in self.sliders])
        for value, slider, field, track in zip(colour.lab, self.sliders, self.fields, tracks, strict=True):
            slider.set_amount(value)
            slider.set_track(*track)
            field.set_value(value)


class ColourEditors(QWidget):
    """An :class:`AngleEditor` for each measurement, in the order in which they are shown."""

    edited = Signal(int, int, float)
    gesture_started = Signal(int, int)
    gesture_finished = Signal()
    pick_asked = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._box = QVBoxLayout(self)
        self._box.setContentsMargins(0, 0, 0, 0)
        self._box.setSpacing(8)
        self.editors: list[AngleEditor] = []

    def show_colours(self, colours: Colours) -> None:
        """Show every measurement."""
        while len(self.editors) > len(colours.angles):
            editor = self.editors.pop()
            self._box.removeWidget(editor)
            editor.deleteLater()
        while len(self.editors) < len(colours.angles):
            editor = AngleEditor()
            for name in ("edited", "gesture_started", "gesture_finished", "pick_asked"):
                getattr(editor, name).connect(getattr(self, name))
            self._box.addWidget(editor)
            self.editors.append(editor)
        for editor, colour in zip(self.editors, colours.angles, strict=True):
            editor.show_colour(colour)
