"""One colour at a time by eye: its plane, the choice of the angle beside it, its L* below, and where it ends."""

from __future__ import annotations

import math
from collections.abc import Mapping

import numpy as np
from brdf_qt.fields.choice_button import ChoiceButton
from brdf_qt.fields.colour_slider import ColourSlider
from brdf_qt.fields.form import described, fill_column, row_of
from brdf_qt.fields.labels import PlainLabel, plain_tip, set_small
from brdf_qt.fields.number import NumberField
from brdf_qt.program.monitor_profile import monitor_of
from brdf_qt.program.translation import decimal, mark, tr
from brdf_qt.work.timer import make_timer
from PySide6.QtCore import QRect, QSize, Qt, Signal
from PySide6.QtGui import QColor, QIcon, QIconEngine, QPainter, QPixmap, QShowEvent
from PySide6.QtWidgets import QButtonGroup, QSizePolicy, QVBoxLayout, QWidget

from brdf_designer.colour.angle_editor import ROWS, add_slider_row, slider_grid
from brdf_designer.colour.display import component_tracks
from brdf_designer.colour.edit_choices import ColourHead
from brdf_designer.colour.patches import one_decimal, place_word
from brdf_designer.colour.plane_view import PlaneMark, PlaneView
from brdf_designer.session.edits import MoveInPlane, TurnHues, colour_edit
from brdf_designer.session.paint_session import PaintSession
from brdf_designer.session.state import AngleColour, Colours
from brdf_suite.appearance.colour.spaces import SRGB_SPACE, DisplaySpace, lab_to_lch
from brdf_suite.documents.paint import Lab
from brdf_suite.paint_design.colour_plane import ReachableBox, colour_plane, hue_codes, is_reachable

_FACE_DEG = 45.0
_PAUSE_MS = 30
"""Numbers and patches come first; the disc follows so often in a drag of L*."""
_HUES = 72
_CHIP, _CHIP_GAP = 12, 4
_EXTENTS = (40.0, 60.0, 90.0, 130.0, 180.0)
"""Chroma at the edge of the disc: the least that has room around every reading."""
_ROOM = 1.2
_REACH = {
    "": "",
    "inside": mark("thick line: what this paint can reach"),
    "outside": mark("outside what this paint can reach"),
}
_LEGEND_TIP = mark(
    "Thin line: the edge of the screen's colours ({screen}). Thick line: what the paint model can reach at this angle "
    "while the other angles stay. Colours beyond are faded."
)


class _Chip(QIconEngine):
    """A square of one colour, apart from the text behind it.

    Another colour needs no other icon, for which a button asks for a new layout.
    """

    def __init__(self) -> None:
        super().__init__()
        self.rgb = (0, 0, 0)

    def paint(self, painter: QPainter, rect: QRect, _mode: QIcon.Mode, _state: QIcon.State) -> None:
        painter.fillRect(QRect(rect.topLeft(), QSize(rect.height(), rect.height())), QColor(*self.rgb))

    def pixmap(self, size: QSize, mode: QIcon.Mode, state: QIcon.State) -> QPixmap:
        pixmap = QPixmap(size)
        pixmap.fill(Qt.GlobalColor.transparent)
        painter = QPainter(pixmap)
        self.paint(painter, pixmap.rect(), mode, state)
        painter.end()
        return pixmap

    def clone(self) -> QIconEngine:
        other = _Chip()
        other.rgb = self.rgb
        return other


class PlaneEditor(QWidget):
    """Edits the chroma, hue and lightness of one reading, or with All of every one alike.

    ``index_chosen(index)``: another reading is edited. ``angles_made()``: the buttons of the angles are new ones.
    """

    index_chosen = Signal(int)
    angles_made = Signal()

    def __init__(self, session: PaintSession, head: ColourHead) -> None:
        super().__init__()
        self._session, self._head = session, head
        self.index = -1
        """The reading that is edited, in the document."""
        self._colours: Colours | None = None
        self._box: ReachableBox | None = None
        self._space, self._screen = SRGB_SPACE, "sRGB"
        self._most = _EXTENTS[-1]
        self._drawn: tuple[float, float, ReachableBox | None, DisplaySpace] | None = None
        self._tracked: tuple[float, float] | None = None
        self.view = PlaneView()
        self.angles = QWidget()
        self._angles_box = QVBoxLayout(self.angles)
        self._angles_box.setContentsMargins(0, 0, 0, 0)
        self._angles_box.setSpacing(2)
        self.buttons: dict[int, ChoiceButton] = {}
        self._group = QButtonGroup(self)
        self._chips: dict[int, _Chip] = {}
        self.values, self.legend, self.standard = PlainLabel(), PlainLabel(), PlainLabel()
        self._standards: Mapping[int, Lab] = {}
        for words in (self.legend, self.standard):
            set_small(words)
        self.values.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        grid, row = slider_grid(), ROWS["lab"][0]
        self.slider, self.field = ColourSlider(""), NumberField("")
        self.slider.set_reach(*row.slider, row.slider_step)
        self.field.set_reach(row.name, row.unit, *row.number, row.step, row.decimals, wrapping=False)
        label = PlainLabel(row.name)
        for widget in (label, self.slider, self.field):
            widget.setToolTip(tr(row.tip))
        described(self.slider, name="plane_lightness", spoken=tr("Lightness of the plane"))
        add_slider_row(grid, 0, session, label, self.slider, self.field, self._edit_lightness)
        beside = QWidget()
        fill_column(beside, self.angles, self.values, self.standard, None, spacing=8)
        top = row_of(self.view, beside, grows=beside, spacing=8)
        fill_column(self, top, grid, self.legend, spacing=4, margins=(0, 0, 0, 4))
        self._later = make_timer(self, self._draw, _PAUSE_MS)
        self.view.moved.connect(self._move)
        self.view.turned.connect(lambda degrees: session.edit(TurnHues(degrees)))
        self.view.chosen.connect(self.choose)
        self.view.gesture_started.connect(session.begin_gesture)
        self.view.gesture_finished.connect(session.end_gesture)
        session.gesture_ended.connect(self._fit_extent)

    @property
    def is_idle(self) -> bool:
        """Whether the disc is of the reading as it is."""
        return not self._later.isActive()

    def choose(self, index: int) -> None:
        """Edit another reading."""
        if index != self.index and self._colours is not None:
            self.index, self._box = index, None
            if index in self.buttons:
                self.buttons[index].setChecked(True)
            self._show()
            self.index_chosen.emit(index)

    def take(self, index: int) -> None:
        """Edit a reading, as one whose button was pressed; its L* can be typed at once."""
        self.choose(index)
        self.field.setFocus(Qt.FocusReason.TabFocusReason)

    def show_colours(self, colours: Colours) -> None:
        """Show every reading; while it is not seen, when it is."""
        self._colours = colours
        if all(angle.index != self.index for angle in colours.angles):
            face = min(colours.angles, key=lambda angle: abs(angle.aspecular_deg - _FACE_DEG))
            self.index, self._box = face.index, None
            self.index_chosen.emit(self.index)
        if self.isVisible():
            self._fit_extent()
            self._show()

    def show_reachable(self, box: ReachableBox | None) -> None:
        """Show what the paint reaches at the reading that is edited; None: that is not known."""
        if box != self._box:
            self._box = box
            self._show()

    def show_standard(self, labs: Mapping[int, Lab]) -> None:
        """Show the L*a*b* of a standard by its readings beside those that are edited; none where there is none."""
        self._standards = labs
        self._show_target()

    def _show_target(self) -> None:
        lab = self._standards.get(self.index)
        text = ""
        if lab is not None:
            chroma, hue = (one_decimal(float(value)) for value in lab_to_lch(lab)[1:])
            text = tr("Standard:\nL* {lightness}\nC* {chroma}\nh {hue}°").format(
                lightness=decimal(f"{lab[0]:.2f}"), chroma=chroma, hue=hue
            )
        if text != self.standard.text():
            self.standard.setText(text)

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        monitor = monitor_of(self)
        self._space, self._screen = monitor.space, monitor.space.title
        self.view.show_hues(hue_codes(_HUES, self._space))
        self._tracked = None
        self._fit_extent()
        if self._colours is not None:
            self._show()

    # Edits.

    def _move(self, index: int, a: float, b: float) -> None:
        self._session.edit(MoveInPlane(index, a, b, at_all_angles=self._head.mode == "all"))

    def _edit_lightness(self, value: float) -> None:
        at_all_angles = self._head.mode == "all"
        self._session.edit(colour_edit("lab", self.index, 0, value, 0.0, at_all_angles=at_all_angles))

    # Showing.

    def _now(self) -> AngleColour:
        assert self._colours is not None
        return next(angle for angle in self._colours.angles if angle.index == self.index)

    def _show(self) -> None:
        """Show L* at once, and the disc where it is dragged; all else follows with the next picture of it."""
        assert self._colours is not None
        lightness, a, b = self._now().lab
        self.slider.set_amount(lightness)
        self.field.set_value(lightness)
        self._show_target()
        if (a, b) != self._tracked:
            self._tracked = (a, b)
            lab = np.array([[lightness, a, b]])
            ((track, _, _),) = component_tracks(lab, [self.slider.positions(), *_NOWHERE])
            self.slider.set_track(*track)
        if self.view.is_held:
            self._show_marks()
        if not self._later.isActive():
            self._later.start()

    def _show_marks(self) -> None:
        assert self._colours is not None
        angles = self._colours.angles
        marks = tuple(PlaneMark(one.index, one.text, one.lab[1], one.lab[2], one.rgb) for one in angles)
        self.view.show_marks(marks, self.index)

    def _show_words(self, lab: Lab) -> None:
        _, chroma, hue = (float(value) for value in lab_to_lch(lab))
        text = f"C* {one_decimal(chroma)}\nh {one_decimal(hue)}°"
        if text != self.values.text():
            self.values.setText(text)
        state = "" if self._box is None else "inside" if is_reachable(self._box, lab) else "outside"
        words = [tr("thin line: {screen}").format(screen=self._screen)]
        if state:
            words.append(tr(_REACH[state]))
        legend = "; ".join(words)
        if legend != self.legend.text():
            self.legend.setText(legend)
            self.legend.setToolTip(plain_tip(tr(_LEGEND_TIP).format(screen=self._screen)))

    def _show_angles(self, angles: tuple[AngleColour, ...]) -> None:
        if [angle.index for angle in angles] != list(self.buttons):
            for button in self.buttons.values():
                self._group.removeButton(button)
                self._angles_box.removeWidget(button)
                button.hide()
                button.deleteLater()
            self.buttons, self._chips = {}, {}
            for angle in angles:
                self._add_button(angle.index)
            self.angles_made.emit()
        for angle in angles:
            button = self.buttons[angle.index]
            text = f"{angle.text} {place_word(angle.aspecular_deg)}".rstrip()
            if text != button.text():
                button.setText(text)
                button.setToolTip(plain_tip(tr("Edit the colour at {angle}").format(angle=angle.text)))
            chip = self._chips[angle.index]
            if chip.rgb != angle.rgb:
                chip.rgb = angle.rgb
                button.update()
            if angle.index == self.index and not button.isChecked():
                button.setChecked(True)

    def _add_button(self, index: int) -> None:
        button = ChoiceButton("")
        button.setObjectName(f"plane_angle_{index}")
        button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        button.setIconSize(QSize(_CHIP + _CHIP_GAP, _CHIP))
        self._chips[index] = _Chip()
        button.setIcon(QIcon(self._chips[index]))
        button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        button.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        set_small(button)
        button.clicked.connect(lambda: self.take(index))
        self._group.addButton(button)
        self._angles_box.addWidget(button)
        self.buttons[index] = button

    def _fit_extent(self) -> None:
        """Let the disc reach as far as the readings need; not under the hand that drags one."""
        if self._colours is None or self._session.in_gesture or not self.isVisible():
            return
        chroma = max(math.hypot(*angle.lab[1:]) for angle in self._colours.angles)
        most = next((extent for extent in _EXTENTS if extent >= _ROOM * chroma), _EXTENTS[-1])
        if most != self._most:
            self._most = most
            if not self._later.isActive():
                self._later.start()

    def _draw(self) -> None:
        if self._colours is None or not self.isVisible():
            return
        lab = self._now().lab
        self._show_angles(self._colours.angles)
        self._show_marks()
        self._show_words(lab)
        wanted = (lab[0], self._most, self._box, self._space)
        if wanted != self._drawn:
            self._drawn = wanted
            self.view.show_plane(colour_plane(*wanted), lab[0], self._most)


_NOWHERE = [np.zeros(0), np.zeros(0)]
