"""The colour of every measurement: sliders that show the colours they would give, numbers, and a picker."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import numpy as np
from brdf_qt.fields.colour_slider import ColourSlider
from brdf_qt.fields.focus_order import Ordered
from brdf_qt.fields.form import fill_column, icon_button, row_of
from brdf_qt.fields.labels import PlainLabel, plain_tip
from brdf_qt.fields.number import NumberField
from brdf_qt.program.translation import mark, tr
from PySide6.QtCore import QRectF, QSize, Qt
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QPen, QShowEvent
from PySide6.QtWidgets import (
    QAbstractButton,
    QGridLayout,
    QLabel,
    QWidget,
)

from brdf_designer.colour.display import component_tracks
from brdf_designer.colour.edit_choices import ColourHead
from brdf_designer.colour.patches import OUTSIDE_TIP, paint_corner, place_word
from brdf_designer.session.edits import COMPONENTS, LCH_COMPONENTS, RemoveAngle, Space, colour_edit
from brdf_designer.session.paint_session import PaintSession
from brdf_designer.session.state import AngleColour, Colours
from brdf_designer.window.widgets import set_font
from brdf_suite.appearance.colour.spaces import lab_to_lch, lch_to_lab
from brdf_suite.appearance.flop.edits import GREY_CHROMA
from brdf_suite.arrays import Bools, Bytes
from brdf_suite.documents.paint import PARAMETERS, Lab


@dataclass(frozen=True)
class Row:
    """One component: its name, where its slider and its number reach, an explanation, unit, steps, decimals."""

    name: str
    slider: tuple[float, float]
    number: tuple[float, float]
    tip: str
    unit: str = ""
    slider_step: float = 0.1
    step: float = 0.5
    decimals: int = 2
    wrapping: bool = False


_LIMITS = [(PARAMETERS[f"lab[{k}]"].low, PARAMETERS[f"lab[{k}]"].high) for k in range(3)]
_LIGHTNESS_TIP = mark(
    "Lightness L* (CIE 1976, D65, 10°). A perfect white diffuser has 100; a "
    "metallic can exceed it near the mirror direction."
)
_CHROMA_TIP = mark(
    "Chroma C*ab: how far the colour is from grey, the distance from 0 in the plane of a* and b*."
)
_HUE_TIP = mark(
    "Hue angle hab: 0° red, 90° yellow, 180° green, 270° blue. A grey has no hue; "
    "this value is used as soon as it has chroma."
)
# Where the sliders reach; the numbers reach as far as the document. No paint known lies outside.
_LIGHTNESS = Row(COMPONENTS[0], (0.0, 150.0), _LIMITS[0], _LIGHTNESS_TIP)
_TURN = (0.0, 360.0)
ROWS: dict[str, tuple[Row, Row, Row]] = {
    "lab": (
        _LIGHTNESS,
        Row(COMPONENTS[1], (-100.0, 100.0), _LIMITS[1], mark("a*: from green (negative) to red (positive).")),
        Row(
            COMPONENTS[2], (-100.0, 100.0), _LIMITS[2], mark("b*: from blue (negative) to yellow (positive).")
        ),
    ),
    "lch": (
        _LIGHTNESS,
        Row(LCH_COMPONENTS[1], (0.0, 140.0), (0.0, _LIMITS[1][1]), _CHROMA_TIP),
        Row(LCH_COMPONENTS[2], _TURN, _TURN, _HUE_TIP, "°", 0.5, 1.0, 1, wrapping=True),
    ),
}


def add_slider_row(
    grid: QGridLayout,
    row: int,
    session: PaintSession,
    label: QLabel,
    slider: ColourSlider,
    field: NumberField,
    edited: Callable[[float], None],
) -> None:
    """Put a label, a slider and a number for one value into a row of ``grid``; an edit of either is ``edited``."""
    field.setFixedWidth(72)
    # Tab goes from number to number, whose keys do what the slider's do.
    slider.setFocusPolicy(Qt.FocusPolicy.ClickFocus)
    for source in (slider, field):
        source.edited.connect(edited)
        source.gesture_started.connect(session.begin_gesture)
        source.gesture_finished.connect(session.end_gesture)
    label.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
    label.setBuddy(field)
    for column, widget in enumerate((label, slider, field)):
        grid.addWidget(widget, row, column)


def slider_grid() -> QGridLayout:
    """Return the grid for :func:`add_slider_row`."""
    grid = QGridLayout()
    grid.setContentsMargins(0, 0, 0, 0)
    grid.setHorizontalSpacing(8)
    grid.setVerticalSpacing(4)
    grid.setColumnStretch(1, 1)
    return grid


class Swatch(QAbstractButton):
    """A small field of the colour that opens the picker."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._colour = QColor()
        self._in_gamut = True
        self._named: tuple[str, bool] | None = None
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.setAutoFillBackground(True)

    def show_colour(self, colour: AngleColour) -> None:
        """Show the colour of a measurement."""
        self._colour, self._in_gamut = QColor(*colour.rgb), colour.in_gamut
        self.update()
        if (colour.text, colour.in_gamut) == self._named:
            return
        self._named = (colour.text, colour.in_gamut)
        tip = tr("Pick the colour at {angle}").format(angle=colour.text)
        self.setAccessibleName(tip)
        self.setToolTip(plain_tip(tip if colour.in_gamut else f"{tip}\n{tr(OUTSIDE_TIP)}"))

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
    """One measurement: its angle, its swatch and three rows of slider and number, in L*a*b* or LCh.

    ``head`` has the colour space, and what an edit moves; ``pick(index)`` opens the colour picker.
    """

    def __init__(self, session: PaintSession, head: ColourHead, pick: Callable[[int], None]) -> None:
        super().__init__()
        self._session, self._head = session, head
        self.index = 0
        self.space: Space = head.space
        self.hue = 0.0
        self._lab: Lab | None = None
        self._text = ""
        self._title = PlainLabel()
        set_font(self._title, bold=True)
        self.swatch = Swatch()
        self.swatch.clicked.connect(lambda: pick(self.index))
        self.remove = icon_button("x", "", lambda: session.edit(RemoveAngle(self.index)), flat=True)
        top = row_of(self._title, self.swatch, self.remove, grows=self._title)
        grid = slider_grid()
        grid.setColumnMinimumWidth(0, 20)
        self.labels = [PlainLabel() for _ in range(3)]
        self.sliders = [ColourSlider("") for _ in range(3)]
        self.fields = [NumberField("") for _ in range(3)]
        for component, parts in enumerate(zip(self.labels, self.sliders, self.fields, strict=True)):
            add_slider_row(grid, component, session, *parts, partial(self._edited, component))
        fill_column(self, top, grid, spacing=4, margins=(0, 0, 0, 4))
        self._reach()

    def _edited(self, component: int, value: float) -> None:
        if self.space == "lch" and component == 2:
            # Also of a grey, whose colour it does not change: it is the hue that chroma will bring out.
            self.hue = value
        at_all_angles = self._head.mode == "all"
        self._session.edit(
            colour_edit(self.space, self.index, component, value, self.hue, at_all_angles=at_all_angles)
        )

    def set_space(self, space: Space) -> None:
        """Edit in ``lab`` or ``lch``; the colour, and the one that a double click goes back to, stay."""
        if space == self.space:
            return
        opened = np.array([field.default for field in self.fields])
        opened = lab_to_lch(opened) if space == "lch" else lch_to_lab(opened)
        self.space = space
        self._reach()
        for field, value in zip(self.fields, opened.tolist(), strict=True):
            field.set_default(value)
        self._lab = None

    def _reach(self) -> None:
        for row, slider, field, label in zip(
            ROWS[self.space], self.sliders, self.fields, self.labels, strict=True
        ):
            slider.set_reach(*row.slider, row.slider_step, wrapping=row.wrapping)
            field.set_reach(row.name, row.unit, *row.number, row.step, row.decimals, wrapping=row.wrapping)
            label.setText(row.name)
            for widget in (slider, field, label):
                widget.setToolTip(tr(row.tip))
        self._name()

    def _name(self) -> None:
        for row, slider, field in zip(ROWS[self.space], self.sliders, self.fields, strict=True):
            name = tr("{name} at {angle}").format(name=row.name, angle=self._text)
            slider.setAccessibleName(name)
            field.setAccessibleName(tr("{name}, number").format(name=name))

    def needs(self, colour: AngleColour) -> bool:
        """Return whether showing the colour would change anything but the title."""
        return colour.lab != self._lab

    def values(self, lab: Lab) -> tuple[float, float, float]:
        """Return a colour in the editor's space, a grey with the hue that it had last."""
        if self.space == "lab":
            return lab
        lightness, chroma, hue = (float(value) for value in lab_to_lch(lab))
        if chroma >= GREY_CHROMA:
            self.hue = hue
        return lightness, chroma, self.hue

    def show_place(self, colour: AngleColour) -> None:
        """Show which measurement this is."""
        if colour.index == self.index and colour.text == self._text:
            return
        self.index, self._text = colour.index, colour.text
        self.setObjectName(f"angle_{colour.index}")
        self._title.setText(f"{colour.text}  {place_word(colour.aspecular_deg)}".rstrip())
        self._title.setToolTip(
            tr("Angle from the mirror direction of the light to the view: the aspecular angle.")
        )
        self.remove.setAccessibleName(tr("Remove the reading at {angle}").format(angle=colour.text))
        self.remove.setToolTip(plain_tip(tr("Remove the reading at {angle}").format(angle=colour.text)))
        self._name()

    def show_colour(
        self, colour: AngleColour, values: tuple[float, float, float], tracks: list[tuple[Bytes, Bools]]
    ) -> None:
        """Show a measurement: its ``values`` in the editor's space and the tracks of its sliders."""
        self._lab = colour.lab
        self.swatch.show_colour(colour)
        for value, slider, field, track in zip(values, self.sliders, self.fields, tracks, strict=True):
            slider.set_amount(value)
            slider.set_track(*track)
            field.set_value(value)


class AngleEditors(QWidget, Ordered):
    """An :class:`AngleEditor` for each measurement, in the order in which they are shown."""

    def __init__(self, session: PaintSession, head: ColourHead, pick: Callable[[int], None]) -> None:
        super().__init__()
        self._session, self._head, self._pick = session, head, pick
        self._box = fill_column(self)
        self.editors: list[AngleEditor] = []
        self._colours: Colours | None = None
        head.space_chosen.connect(self._set_space)

    def focus_order(self) -> list[QWidget]:
        """Return what Tab stops at: the numbers of all angles, then the buttons that pick a colour or remove one."""
        numbers = [field for editor in self.editors for field in editor.fields]
        return [*numbers, *(button for editor in self.editors for button in (editor.swatch, editor.remove))]

    def _set_space(self, space: Space) -> None:
        for editor in self.editors:
            editor.set_space(space)
        if self._colours is not None:
            self.show_now(self._colours)

    def hue_of(self, index: int) -> float:
        """Return the hue, degrees, that a grey at that measurement would get."""
        return next((editor.hue for editor in self.editors if editor.index == index), 0.0)

    def show_colours(self, colours: Colours) -> None:
        """Show every measurement; while it is not seen, when it is."""
        self._colours = colours
        if self.isVisible() or len(colours.angles) != len(self.editors):
            self.show_now(colours)

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        if self._colours is not None:
            self.show_now(self._colours)

    def show_now(self, colours: Colours) -> None:
        """Show every measurement; only what is another is worked out and drawn."""
        self._colours = colours
        self._make(len(colours.angles))
        rows: list[tuple[AngleEditor, AngleColour, tuple[float, float, float]]] = []
        for editor, colour in zip(self.editors, colours.angles, strict=True):
            editor.show_place(colour)
            editor.remove.setEnabled(len(colours.angles) > 3)
            if editor.needs(colour):
                rows.append((editor, colour, editor.values(colour.lab)))
        if not rows:
            return
        positions = [slider.positions() for slider in self.editors[0].sliders]
        values = np.array([row for _, _, row in rows])
        tracks = component_tracks(values, positions, in_lch=self._head.space == "lch")
        for (editor, colour, row), of_editor in zip(rows, tracks, strict=True):
            editor.show_colour(colour, row, of_editor)

    def _make(self, count: int) -> None:
        while len(self.editors) > count:
            editor = self.editors.pop()
            self._box.removeWidget(editor)
            editor.hide()
            editor.deleteLater()
        while len(self.editors) < count:
            editor = AngleEditor(self._session, self._head, self._pick)
            self._box.addWidget(editor)
            self.editors.append(editor)
