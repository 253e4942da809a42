"""The section of the colours: what is edited, and in which terms; then the angles, or the handles of the flop."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QVBoxLayout, QWidget

from brdf_designer.colour.flop_panel import FlopPanel
from brdf_designer.colour.head import ColourHead
from brdf_designer.colour.section import AngleEditor, AngleEditors
from brdf_designer.session.fields import Key
from brdf_designer.session.state import Colours
from brdf_suite.appearance.geometries import Geometry
from brdf_suite.documents.paint import Paint
from brdf_suite.paint_design.angle_sets import set_name


class ColourEditors(QWidget):
    """Turns what the widgets say into edits by field key, as :mod:`brdf_designer.session.fields` names them.

    An edit of several readings, or in LCh, starts from the paint with which its gesture began: a drag there and back
    ends where it began, also where it passed a limit on the way.
    """

    edited = Signal(object, object)
    gesture_started = Signal(object)
    gesture_finished = Signal()
    pick_requested = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.head, self.angles, self.flop = ColourHead(), AngleEditors(), FlopPanel()
        box = QVBoxLayout(self)
        box.setContentsMargins(0, 0, 0, 0)
        box.setSpacing(4)
        for part in (self.head, self.flop, self.angles):
            box.addWidget(part)
        self._paint: Paint | None = None
        self._colours: Colours | None = None
        self._base: Paint | None = None
        self.angles.set_space(self.head.spaces.value)
        self._show_mode(self.head.modes.value)
        self.head.set_chosen.connect(lambda name: self.edited.emit(("angles", "set"), name))
        self.head.angle_added.connect(
            lambda angle: self.edited.emit(("angles", "add"), Geometry(self._from().main_light_deg, angle))
        )
        self.head.space_chosen.connect(self.angles.set_space)
        self.head.mode_chosen.connect(self._show_mode)
        self.angles.remove_requested.connect(lambda index: self.edited.emit(("angles", "remove"), index))
        self.angles.pick_requested.connect(self.pick_requested)
        self.angles.gesture_started.connect(
            lambda index, c: self._begin(self._key(self.angles.space, index, c))
        )
        self.angles.edited.connect(lambda index, c, value: self._edit(self.angles.space, index, c, value))
        self.angles.gesture_finished.connect(self._end)
        self.flop.gesture_started.connect(self.begin_flop)
        self.flop.edited.connect(self.edit_flop)
        self.flop.gesture_finished.connect(self._end)

    @property
    def editors(self) -> list[AngleEditor]:
        """The editors of the angles, in the order in which they are shown."""
        return self.angles.editors

    @property
    def mode(self) -> str:
        """What an edit moves: ``one`` angle, ``all`` of them, or the ``flop``."""
        return self.head.modes.value

    def show_colours(self, colours: Colours) -> None:
        """Show every measurement."""
        self._paint, self._colours = colours.paint, colours
        self.head.show_set(set_name(colours.paint), colours.paint.main_light_deg)
        self.angles.show_colours(colours)
        if self.mode == "flop":
            self.flop.show_colours(colours)

    def begin_in_lch(self, index: int, component: int) -> None:
        """A point of a plot is grabbed: see :meth:`edit_in_lch`."""
        self._begin(self._key("lch", index, component))

    def edit_in_lch(self, index: int, component: int, value: float) -> None:
        """Set L*, C* or h at an angle, or move all angles with it."""
        self._edit("lch", index, component, value)

    def begin_flop(self, what: str) -> None:
        """A handle of the flop is grabbed, here or on the strip: see :meth:`edit_flop`."""
        self._begin(("flop", what))

    def edit_flop(self, what: str, amount: float) -> None:
        """Set the flop index, or the travel of lightness, chroma or hue, whatever else an edit moves."""
        self.edited.emit(("flop", what), (self._from(), amount))

    def end(self) -> None:
        """The point, or the handle, is let go."""
        self._end()

    def _show_mode(self, mode: str) -> None:
        self.flop.setVisible(mode == "flop")
        self.angles.setVisible(mode != "flop")
        if self._colours is not None:
            self.show_colours(self._colours)

    def _key(self, space: str, index: int, component: int) -> Key:
        if self.mode == "all":
            return ("together", space, component)
        if component == 0:
            return ("lab", index, 0)
        return (space, index, component)

    def _edit(self, space: str, index: int, component: int, value: float) -> None:
        key = self._key(space, index, component)
        if key[0] == "together":
            self.edited.emit(key, (self._from(), index, value, self.angles.hue_of(index)))
        elif key[0] == "lch":
            self.edited.emit(key, (self._from(), value, self.angles.hue_of(index)))
        else:
            self.edited.emit(key, value)

    def _begin(self, key: Key) -> None:
        self._base = self._paint
        self.gesture_started.emit(key)

    def _end(self) -> None:
        self._base = None
        self.gesture_finished.emit()

    def _from(self) -> Paint:
        base = self._base if self._base is not None else self._paint
        assert base is not None
        return base
