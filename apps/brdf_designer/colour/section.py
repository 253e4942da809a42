"""The section of the colours: by eye in the plane of one angle, by numbers in a fold, or by the handles of the flop."""

from __future__ import annotations

from collections.abc import Callable

from brdf_qt.fields.form import fill_column
from brdf_qt.program.translation import tr
from brdf_qt.window.section import Section
from PySide6.QtWidgets import QWidget

from brdf_designer.colour.angle_editor import AngleEditors
from brdf_designer.colour.edit_choices import ColourHead
from brdf_designer.colour.flop_panel import FlopPanel
from brdf_designer.colour.plane_editor import PlaneEditor
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
        self.plane = PlaneEditor(session, self.head)
        self.angles = AngleEditors(session, self.head, pick)
        self.editors = self.angles.editors
        self.numbers = Section(tr("Numbers"), "numbers", is_open=False)
        self.numbers.add(self.head.spaces)
        self.numbers.add(self.angles)
        fill_column(self, self.head, self.flop, self.plane, self.numbers, spacing=4)
        self._colours: Colours | None = None
        self._show_mode()
        self.head.set_chosen.connect(lambda name: session.edit(UseAngles(name)))
        self.head.angle_added.connect(
            lambda angle: session.edit(AddAngle(Geometry(session.paint.main_light_deg, angle)))
        )
        self.head.mode_chosen.connect(self._show_mode)

    def show_colours(self, colours: Colours) -> None:
        """Show every measurement, in the parts that are seen."""
        self._colours = colours
        self.head.show_set(set_name(colours.paint), colours.paint.main_light_deg)
        self.plane.show_colours(colours)
        self.angles.show_colours(colours)
        if self.head.mode == "flop":
            self.flop.show_colours(colours)

    def show_all(self, colours: Colours) -> None:
        """Show every measurement also in the parts that are not seen."""
        self.flop.show_colours(colours)
        self.angles.show_now(colours)

    def edit_in_lch(self, index: int, component: int, value: float) -> None:
        """Set L*, C* or h at an angle, or move all angles with it."""
        hue, at_all_angles = self.angles.hue_of(index), self.head.mode == "all"
        self._session.edit(colour_edit("lch", index, component, value, hue, at_all_angles=at_all_angles))

    def _show_mode(self) -> None:
        flop = self.head.mode == "flop"
        self.flop.setVisible(flop)
        self.plane.setVisible(not flop)
        self.numbers.setVisible(not flop)
        if self._colours is not None:
            self.show_colours(self._colours)
