"""The choices of the colours: which angles there are, in which terms they are edited, and what an edit moves."""

from __future__ import annotations

from brdf_qt.fields.choice_button import ChoiceButton
from brdf_qt.fields.form import Form, described, fill_row, row_of
from brdf_qt.fields.labels import PlainLabel, plain_tip
from brdf_qt.fields.number import NumberField
from brdf_qt.fields.quiet import QuietComboBox
from brdf_qt.program.settings import settings
from brdf_qt.program.translation import mark, tr
from PySide6.QtCore import Signal
from PySide6.QtWidgets import QButtonGroup, QPushButton, QWidget

from brdf_designer.session.edits import Space
from brdf_suite.documents.paint import PARAMETERS

_SETS = {
    "e2194": mark("3 angles: 15, 45, 110°"),
    "five": mark("5 angles: 15, 25, 45, 75, 110°"),
    "six": mark("6 angles: −15, 15, 25, 45, 75, 110°"),
    "e2539": mark("8 geometries, two lights (E2539)"),
}
_OWN = mark("Custom angles")
_SETS_TIP = mark(
    "Aspecular angles at which the colour is specified. Another set is filled with "
    "the colours of this paint at the new angles, so the appearance is kept."
)
_SPACES = {
    "lab": (mark("L*a*b*"), mark("Lightness, green to red, blue to yellow (CIE 1976, D65, 10°).")),
    "lch": (mark("LCh°"), mark("Lightness, chroma and hue angle (CIE 1976, D65, 10°).")),
}
_MODES = {
    "one": (mark("Angle"), mark("An edit changes the colour at one angle only.")),
    "all": (mark("All"), mark("An edit adds the same difference at all angles.")),
    "flop": (
        mark("Flop"),
        mark(
            "Flop: change of colour from the view near the mirror direction to the grazing "
            "view. An edit keeps the face (45°) and moves the angles on either side."
        ),
    ),
}


class ColourHead(QWidget):
    """Emits ``set_chosen(name)``, ``angle_added(degrees)``, ``space_chosen(lab | lch)`` and ``mode_chosen(one | all |
    flop)``. The space is remembered; a program begins with one angle, so that no first edit moves more than it says.
    """

    set_chosen = Signal(str)
    angle_added = Signal(float)
    space_chosen = Signal(str)
    mode_chosen = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.sets = described(QuietComboBox(), name="angle_set")
        for name, text in _SETS.items():
            self.sets.addItem(tr(text), name)
        self.sets.addItem(tr(_OWN), None)
        self.sets.activated.connect(self._chosen)
        self._set: str | None = ""  # none of them yet
        known = PARAMETERS["aspecular_deg"]
        self.angle = NumberField(tr("New angle"), "°", known.low, 134.0, 5.0, 1, 60.0)
        self.angle.setObjectName("new_angle")
        self._light_deg: float | None = None
        self.add = QPushButton(tr("Add"))
        self.add.setToolTip(tr("Add a reading at this angle with the current colour of the paint."))
        self.add.clicked.connect(lambda: self.angle_added.emit(self.angle.value()))
        further = QWidget()
        fill_row(further, self.angle, self.add)
        self.rest = Form()
        """Which angles there are; it stands elsewhere."""
        self.rest.add_row(tr("Angles"), self.sets, tr(_SETS_TIP))
        self.rest.add_row(tr("Add angle"), further)
        self.spaces = _Choice(_SPACES, "designer/space", tr("Colour space"))
        """For the numbers; it stands with them."""
        self.modes = _Choice(_MODES, None, tr("Angles that an edit changes"))
        self.spaces.chosen.connect(self.space_chosen)
        self.modes.chosen.connect(self.mode_chosen)
        self.setLayout(row_of(PlainLabel(tr("Edit")), self.modes, None, margins=(0, 0, 0, 4)))

    @property
    def space(self) -> Space:
        """In which colour space an edit is made: ``lab`` or ``lch``."""
        return "lch" if self.spaces.value == "lch" else "lab"

    @property
    def mode(self) -> str:
        """What an edit moves: ``one`` angle, ``all`` of them, or the ``flop``."""
        return self.modes.value

    def show_set(self, name: str | None, light_deg: float | None = None) -> None:
        """Show which set the paint's angles are, ``None``: none of them; and where a view can be, by its light."""
        if name != self._set:
            self._set = name
            self._select()
        if light_deg is not None and light_deg != self._light_deg:
            self._light_deg = light_deg
            known = PARAMETERS["aspecular_deg"]
            # A view at grazing sees nothing; one degree above it is enough.
            self.angle.setRange(max(known.low, light_deg - 89.0), min(known.high, light_deg + 89.0))
            tip = tr("Aspecular angle of the new reading, with the light at {light:g}°.")
            self.angle.setToolTip(plain_tip(tip.format(light=light_deg)))

    def _chosen(self, row: int) -> None:
        name = self.sets.itemData(row)
        # "Own angles" says what is, and cannot be asked for: angles are added and removed one by one.
        self._select()
        if name is not None:
            self.choose_set(name)

    def _select(self) -> None:
        self.sets.setCurrentIndex(self.sets.findData(self._set))

    def choose_set(self, name: str) -> None:
        """Ask for a set, as the list does."""
        if name != self._set:
            self.set_chosen.emit(name)


class _Choice(QWidget):
    """Buttons of which one is down."""

    chosen = Signal(str)

    def __init__(self, choices: dict[str, tuple[str, str]], key: str | None, name: str) -> None:
        super().__init__()
        self._key = key
        self.setAccessibleName(name)
        self.buttons: dict[str, ChoiceButton] = {}
        group = QButtonGroup(self)
        for choice, (text, tip) in choices.items():
            button = described(ChoiceButton(tr(text)), spoken=f"{name}: {tr(text)}", tip=tr(tip))
            button.clicked.connect(lambda _=False, choice=choice: self._choose(choice))
            group.addButton(button)
            self.buttons[choice] = button
        self.setLayout(row_of(*self.buttons.values(), None, spacing=0))
        first = next(iter(choices))
        kept = str(settings().value(key, first)) if key else first
        self.value = kept if kept in choices else first
        self.buttons[self.value].setChecked(True)

    def _choose(self, choice: str) -> None:
        if choice != self.value:
            self.value = choice
            if self._key:
                settings().setValue(self._key, choice)
            self.chosen.emit(choice)
