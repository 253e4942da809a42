"""The choices over the colours as commands: in the menu Paint, by key, and by name with Ctrl+K."""

from __future__ import annotations

from collections.abc import Iterable
from functools import partial

from brdf_qt.fields.number import NumberField
from brdf_qt.program.feature import Feature
from brdf_qt.program.translation import mark
from brdf_qt.window.section import Section
from PySide6.QtCore import QObject, Qt

from brdf_designer.session.paint_session import PaintSession
from brdf_designer.window.window import DesignerWindow

_MODES = (
    ("one", mark("Edit &One Angle"), "edit_one"),
    ("all", mark("Edit &All Angles"), "edit_all"),
    ("flop", mark("Edit &Flop"), "edit_flop"),
)
_SPACES = (
    ("lab", mark("Colours in &L*a*b*"), "space_lab"),
    ("lch", mark("Colours in LC&h"), "space_lch"),
)
_SETS = (
    ("e2194", mark("Angles: &3 (15, 45, 110°)")),
    ("five", mark("Angles: &5 (15 to 110°)")),
    ("six", mark("Angles: &6 (−15 to 110°)")),
    ("e2539", mark("Angles: &8, Two Lights (E2539)")),
)


class ColourCommands(Feature, QObject):
    """Adds the commands; each does what the button or the list over the colours does."""

    def __init__(self, _session: PaintSession, window: DesignerWindow) -> None:
        super().__init__(window)
        head = window.editors.head
        self._window = window
        window.paint_menu.addSeparator()
        window.add_command(
            "paint", mark("&Go to First Value"), "first_value", self.type_numbers, "type_numbers"
        )
        # Who makes a new paint wants to say what it is.
        window.new_requested.connect(self.type_numbers)
        for mode, text, keys in _MODES:
            window.add_command("paint", text, keys, head.modes.buttons[mode].click, f"edit_{mode}")
        window.paint_menu.addSeparator()
        for space, text, keys in _SPACES:
            window.add_command("paint", text, keys, head.spaces.buttons[space].click, f"space_{space}")
        window.paint_menu.addSeparator()
        for name, text in _SETS:
            window.add_command("paint", text, None, partial(head.choose_set, name), f"angles_{name}")

    def type_numbers(self) -> None:
        """Go to the first number of the colour: of the first angle, or of the flop where that is edited."""
        editors = self._window.editors
        editors.numbers.set_open(True)
        numbers = [*editors.flop.fields.values(), *(field for one in editors.editors for field in one.fields)]
        focus_first_number(self._window.section("colour"), numbers)


def focus_first_number(section: Section, numbers: Iterable[NumberField]) -> None:
    """Let the next keys be typed into the first of ``numbers`` that is shown, in place of what it has."""
    section.set_open(True)
    for number in numbers:
        if number.isVisibleTo(section) and number.isEnabled():
            number.setFocus(Qt.FocusReason.ShortcutFocusReason)
            number.selectAll()
            return
