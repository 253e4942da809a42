"""The Variations section: the neighbours of the paint that are asked for daily in a row, the others in a fold."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from brdf_qt.choosing.thumbnails import shipped_picture
from brdf_qt.fields.form import Form, fill_column, fill_row
from brdf_qt.fields.labels import plain_tip, set_small
from brdf_qt.fields.number import NumberField
from brdf_qt.program.names import ENVIRONMENTS, title_of
from brdf_qt.program.translation import mark, tr
from brdf_qt.window.section import Section
from brdf_qt.work.timer import make_timer
from PySide6.QtCore import QEvent, QObject, QSize, Qt, Signal
from PySide6.QtGui import QEnterEvent, QHideEvent, QIcon, QKeyEvent, QPixmap
from PySide6.QtWidgets import QSizePolicy, QToolButton, QWidget

from brdf_designer.window.widgets import combo, wrapped
from brdf_suite.paint_design.variations import LEAST_STEP, MOST_STEP, USUAL_STEP, Direction

PICTURE = 44
"""Width and height of a picture on the screen, points."""

DAILY: dict[Direction, str] = {
    "lighter": mark("lighter"),
    "deeper": mark("deeper"),
    "more_flop": mark("flop +"),
    "cleaner": mark("cleaner"),
    "warmer": mark("warmer"),
    "finer_flakes": mark("finer"),
    "coarser_flakes": mark("coarser"),
}
"""The row that is always seen, and what stands under its pictures."""
REST: tuple[Direction, ...] = ("darker", "dirtier", "less_flop", "hue_back", "hue_forward")
_HOVER_MS = 120
"""A pointer that only passes over a picture shows nothing."""
FORMS = ("sphere", "speed_form")
_CHOICE = QSize(28, 28)


@dataclass(frozen=True)
class NeighbourState:
    """What is shown of a neighbour; ``there`` is false where it cannot be taken."""

    direction: Direction
    text: str
    tip: str
    there: bool


class PictureButton(QToolButton):
    """A small picture with a word below, to be clicked or taken by the keyboard.

    ``hovered(on)``: the pointer rests on it, or has left it again.
    """

    hovered = Signal(bool)

    def __init__(self, name: str, points: int = PICTURE, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextUnderIcon)
        self.setIconSize(QSize(points, points))
        self.setAutoRaise(True)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setObjectName(name)
        set_small(self)
        self.image = QPixmap()
        """What is shown."""
        self._resting = make_timer(self, lambda: self.hovered.emit(True), _HOVER_MS)

    def enterEvent(self, event: QEnterEvent) -> None:
        super().enterEvent(event)
        if self.isEnabled():
            self._resting.start()

    def leaveEvent(self, event: QEvent) -> None:
        super().leaveEvent(event)
        self._resting.stop()
        self.hovered.emit(False)

    def hideEvent(self, event: QHideEvent) -> None:
        super().hideEvent(event)
        self._resting.stop()
        self.hovered.emit(False)

    def show_picture(self, image: QPixmap) -> None:
        """Show a picture; nothing where it is shown already."""
        if image.cacheKey() != self.image.cacheKey():
            self.image = image
            icon = QIcon(image)
            # What cannot be taken is still seen as what it would be; the words say so.
            icon.addPixmap(image, QIcon.Mode.Disabled)
            self.setIcon(icon)


class _PictureRow(QWidget):
    """Pictures side by side: one stop for Tab, from which the arrow keys go on."""

    def __init__(self, buttons: Sequence[PictureButton]) -> None:
        super().__init__()
        self._buttons = buttons
        fill_row(self, *buttons, spacing=0, even=True)
        for button in buttons:
            button.setMinimumWidth(40)
            button.installEventFilter(self)
            if button is not buttons[0]:
                button.setFocusPolicy(Qt.FocusPolicy.ClickFocus)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Go to the next picture that can be taken by Left and Right."""
        if isinstance(event, QKeyEvent) and event.type() == QEvent.Type.KeyPress:
            step = {Qt.Key.Key_Right: 1, Qt.Key.Key_Left: -1}.get(Qt.Key(event.key()), 0)
            place = next(number for number, one in enumerate(self._buttons) if one is watched)
            count = len(self._buttons)
            others = [self._buttons[(place + step * far) % count] for far in range(1, count)]
            reached = next((one for one in others if one.isEnabled()), None)
            if step and reached is not None:
                reached.setFocus(Qt.FocusReason.TabFocusReason)
                return True
        return super().eventFilter(watched, event)


class VariationsSection(QWidget):
    """The body of the section.

    Intents: ``taken(direction)``, ``previewed(direction)`` where the pointer rests on one and an empty text where it
    has left, ``step_edited(value)``, ``scene_chosen(environment, surface)``.
    """

    taken = Signal(str)
    previewed = Signal(str)
    step_edited = Signal(float)
    scene_chosen = Signal(str, str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.buttons: dict[Direction, PictureButton] = {}
        for direction in (*DAILY, *REST):
            button = self.buttons[direction] = PictureButton(f"variation_{direction}")
            set_small(button)
            button.setText(tr(DAILY.get(direction, "")))
            button.clicked.connect(lambda _=False, direction=direction: self.taken.emit(direction))
            button.hovered.connect(
                lambda on, direction=direction: self.previewed.emit(direction if on else "")
            )
        daily, rest = (_PictureRow([self.buttons[key] for key in keys]) for keys in (DAILY, REST))
        self.more = Section(tr("More variations"), "variations_more", is_open=False)
        self.note = wrapped(lines=1)
        self.note.hide()
        form = Form()
        self.step = NumberField(tr("Step"), "", LEAST_STEP, MOST_STEP, 0.5, 1, USUAL_STEP)
        self.step.edited.connect(self.step_edited)
        form.add_row(
            tr("Step"), self.step, tr("Distance of the neighbours in ΔL*, ΔC* or ΔH*, approximately ΔE*ab")
        )
        self.environment, self.surface = (
            combo((title_of(key), key) for key in choices) for choices in (ENVIRONMENTS, FORMS)
        )
        for choice, kind in ((self.environment, "environments"), (self.surface, "meshes")):
            choice.setIconSize(_CHOICE)
            for row in range(choice.count()):
                choice.setItemIcon(row, QIcon(shipped_picture(kind, choice.itemData(row))))
        form.add_row(tr("Light"), self.environment, tr("Light of the thumbnails"))
        form.add_row(tr("Form"), self.surface, tr("Shape that the thumbnails show"))
        for choice in (self.environment, self.surface):
            choice.activated.connect(
                lambda _index: self.scene_chosen.emit(
                    self.environment.currentData(), self.surface.currentData()
                )
            )
        for part in (rest, self.note, form):
            self.more.add(part)
        fill_column(self, daily, self.more, spacing=4)

    def show_choices(self, step: float, environment: str, surface: str) -> None:
        """Show which step, light and form are chosen."""
        self.step.set_value(step)
        self.environment.setCurrentIndex(max(0, self.environment.findData(environment)))
        self.surface.setCurrentIndex(max(0, self.surface.findData(surface)))

    def show_neighbours(self, states: Sequence[NeighbourState]) -> None:
        """Show words, and whether each neighbour can be taken."""
        for state in states:
            button = self.buttons[state.direction]
            if state.direction not in DAILY:
                button.setText(state.text)
            button.setToolTip(plain_tip(f"{state.text}\n{state.tip}"))
            button.setAccessibleName(state.text)
            button.setAccessibleDescription(state.tip)
            button.setEnabled(state.there)

    def show_note(self, text: str) -> None:
        """Say something of all the pictures; an empty text says nothing."""
        self.note.setText(text)
        self.note.setVisible(bool(text))
