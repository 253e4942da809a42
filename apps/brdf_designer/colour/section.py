"""The section of the colours: what is edited, and in which terms; then the angles, or the handles of the flop."""

from __future__ import annotations

from collections.abc import Callable

from brdf_qt.fields.form import fill_column
from PySide6.QtWidgets import QWidget

from brdf_designer.colour.angle_editor import AngleEditors
from brdf_designer.colour.edit_choices import ColourHead
from brdf_designer.colour.flop_panel import FlopPanel
from brdf_designer.session.edits import AddAngle, UseAngles, colour_edit
from brdf_designer.session.paint_session import PaintSession
from brdf_designer.session.state import Colours
from brdf_suite.appearance.geometries import Geometry
from brdf_suite.paint_design.angle_sets import set_name


class ColourEditors(QWidget):
    """Edits the colours of the paint in ``session``; ``pick(index)`` opens the picker of a measurement."""

    def __init__(self, session: PaintSession, pick: Callable[[int], None]) -> None:
        super().__init__()
        self._session = session
        self.head, self.flop = ColourHead(), FlopPanel(session)
        self.angles = AngleEditors(session, self.head, pick)
        self.editors = self.angles.editors
        fill_column(self, self.head, self.flop, self.angles, spacing=4)
        self._colours: Colours | None = None
        self._show_mode()
        self.head.set_chosen.connect(lambda name: session.edit(UseAngles(name)))
        self.head.angle_added.connect(
            lambda angle: session.edit(AddAngle(Geometry(session.paint.main_light_deg, angle)))
        )
        self.head.mode_chosen.connect(self._show_mode)

    def show_colours(self, colours: Colours) -> None:
        """Show every measurement."""
        self._colours = colours
        self.head.show_set(set_name(colours.paint), colours.paint.main_light_deg)
        self.angles.show_colours(colours)
        if self.head.mode == "flop":
            self.flop.show_colours(colours)

    def edit_in_lch(self, index: int, component: int, value: float) -> None:
        """Set L*, C* or h at an angle, or move all angles with it."""
        hue, at_all_angles = self.angles.hue_of(index), self.head.mode == "all"
        self._session.edit(colour_edit("lch", index, component, value, hue, at_all_angles=at_all_angles))

    def _show_mode(self) -> None:
        self.flop.setVisible(self.head.mode == "flop")
        self.angles.setVisible(self.head.mode != "flop")
        if self._colours is not None:
            self.show_colours(self._colours)
