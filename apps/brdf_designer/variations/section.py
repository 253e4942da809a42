"""The Variations section: the paint in the middle of its eight neighbours, as small pictures."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from brdf_qt.fields.form import Form, fill_column
from brdf_qt.fields.labels import plain_tip
from brdf_qt.fields.number import NumberField
from brdf_qt.program.names import ENVIRONMENTS, title_of
from brdf_qt.program.translation import tr
from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QIcon, QPixmap
from PySide6.QtWidgets import QGridLayout, QSizePolicy, QToolButton, QWidget

from brdf_designer.window.widgets import combo, wrapped
from brdf_suite.paint_design.variations import LEAST_STEP, MOST_STEP, USUAL_STEP, Direction

PICTURE = 72
"""Width and height of a picture on the screen, points."""

PLACES: dict[Direction, tuple[int, int]] = {
    "more_flop": (0, 0),
    "lighter": (0, 1),
    "hue_forward": (0, 2),
    "dirtier": (1, 0),
    "cleaner": (1, 2),
    "hue_back": (2, 0),
    "darker": (2, 1),
    "less_flop": (2, 2),
}
FORMS = ("sphere", "speed_form")


@dataclass(frozen=True)
class NeighbourState:
    """What is shown of a neighbour; ``there`` is false where it cannot be taken."""

    direction: Direction
    text: str
    tip: str
    there: bool


class PictureButton(QToolButton):
    """A small picture with a word below, to be clicked or taken by the keyboard."""

    def __init__(self, name: str, points: int = PICTURE, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextUnderIcon)
        self.setIconSize(QSize(points, points))
        self.setAutoRaise(True)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setObjectName(name)
        self.image = QPixmap()
        """What is shown."""

    def show_picture(self, image: QPixmap) -> None:
        """Show a picture; nothing where it is shown already."""
        if image.cacheKey() != self.image.cacheKey():
            self.image = image
            icon = QIcon(image)
            # What cannot be taken is still seen as what it would be; the words say so.
            icon.addPixmap(image, QIcon.Mode.Disabled)
            self.setIcon(icon)


class VariationsSection(QWidget):
    """The body of the section.

    Intents: ``taken(direction)``, ``step_edited(value)``, ``scene_chosen(environment, surface)``.
    """

    taken = Signal(str)
    step_edited = Signal(float)
    scene_chosen = Signal(str, str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        neighbours = QWidget()
        grid = QGridLayout(neighbours)
        grid.setContentsMargins(0, 0, 0, 0)
        grid.setSpacing(2)
        self.present = PictureButton("variation_present")
        self.present.setText(tr("current"))
        self.present.setToolTip(tr("Current paint among its neighbours"))
        self.present.setEnabled(False)
        grid.addWidget(self.present, 1, 1)
        self.buttons: dict[Direction, PictureButton] = {}
        for direction, (row, column) in PLACES.items():
            button = PictureButton(f"variation_{direction}")
            button.clicked.connect(lambda _=False, direction=direction: self.taken.emit(direction))
            grid.addWidget(button, row, column)
            self.buttons[direction] = button
        for column in range(3):
            grid.setColumnStretch(column, 1)
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
        form.add_row(tr("Light"), self.environment, tr("Light of the thumbnails"))
        form.add_row(tr("Form"), self.surface, tr("Shape that the thumbnails show"))
        for choice in (self.environment, self.surface):
            choice.activated.connect(
                lambda _index: self.scene_chosen.emit(
                    self.environment.currentData(), self.surface.currentData()
                )
            )
        fill_column(self, neighbours, self.note, form)

    def show_choices(self, step: float, environment: str, surface: str) -> None:
        """Show which step, light and form are chosen."""
        self.step.set_value(step)
        self.environment.setCurrentIndex(max(0, self.environment.findData(environment)))
        self.surface.setCurrentIndex(max(0, self.surface.findData(surface)))

    def show_neighbours(self, states: Sequence[NeighbourState]) -> None:
        """Show words, and whether each neighbour can be taken."""
        for state in states:
            button = self.buttons[state.direction]
            button.setText(state.text)
            button.setToolTip(plain_tip(state.tip))
            button.setAccessibleName(state.text)
            button.setAccessibleDescription(state.tip)
            button.setEnabled(state.there)

    def show_note(self, text: str) -> None:
        """Say something of all the pictures; an empty text says nothing."""
        self.note.setText(text)
        self.note.setVisible(bool(text))
