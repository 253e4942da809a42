"""Step 4: where the sphere lies in the picture and where the lamp really was, with the residuals."""

from __future__ import annotations

import numpy as np
from brdf_qt.fields.form import Form
from brdf_qt.fields.number import NumberField
from brdf_qt.program.core_texts import tr_core
from brdf_qt.program.translation import tr
from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QCheckBox

from brdf_designer.acquire.plots.lines_plot import Axis, Curve, LinesPlot
from brdf_designer.acquire.plots.marks import Differences, Mark, Outline, Points
from brdf_designer.acquire.plots.tone import drawn
from brdf_designer.acquire.plots.view import PictureView
from brdf_designer.acquire.states import GeometryState
from brdf_designer.acquire.step_page import AcquirePage, Facts
from brdf_designer.window.widgets import button, split, wrapped

_HALF = 0.5
"""From pixels whose centres lie at whole numbers to those of a picture's corner."""


class GeometryPage(AcquirePage):
    """The page of the geometry. Intents: ``find_requested()``, ``refine_chosen(on)``."""

    find_requested = Signal()
    refine_chosen = Signal(bool)

    def __init__(self) -> None:
        super().__init__(
            "geometry",
            tr(
                "The outline gives the centre of the sphere; the positions of the highlights "
                "give the error of the lamp position."
            ),
        )
        self._state: GeometryState | None = None
        self.picture = PictureView(tr("Sphere and highlights"), tr("Not found yet."))
        self.residuals = LinesPlot(
            tr("Residuals: found and expected highlights"),
            Axis(tr("Lamp angle (degrees)")),
            Axis(tr("Residual (px)")),
        )
        self.centre.addWidget(split(Qt.Orientation.Vertical, (self.picture, 3), (self.residuals, 1)), 1)
        tip = tr("Find the outline and the highlights of many positions, and fit the geometry to them")
        self.start = button(tr("Find Sphere and Lamp"), tip, self.find_requested.emit)
        self.refined = QCheckBox(tr("Refine from highlights"))
        self.refined.setChecked(True)
        self.refined.setToolTip(
            tr("Correct the angle and height of the lamp and the centre of the sphere from the highlights")
        )
        self.refined.toggled.connect(self.refine_chosen)
        self.note = wrapped()
        self.add_part("find", tr("Geometry"), self.start, self.refined, self.note)
        self.facts = Facts(tr("Residuals"))
        self.left = self.add_part("left", tr("Residuals"), self.facts)
        self.found = Facts(tr("Refined parameters"))
        self.refinement = self.add_part("refined", tr("Refinement"), self.found)
        form = Form()
        self.gain = NumberField(tr("Magnification"), "×", 1.0, 500.0, 10.0, 0, 50.0)
        self.gain.edited.connect(lambda _value: self._draw_marks())
        self.brightness = NumberField(tr("Brightness"), "EV", -10.0, 12.0, 0.5, 1, 0.0)
        self.brightness.edited.connect(lambda _value: self._draw_picture())
        form.add_row(
            tr("Magnification"), self.gain, tr("Factor by which the drawn differences are magnified")
        )
        form.add_row(
            tr("Brightness"), self.brightness, tr("Brightness of the displayed picture only, in stops")
        )
        self.look = self.add_part("look", tr("Picture"), form)
        self.show_geometry(None)

    def show_geometry(self, state: GeometryState | None) -> None:
        """Show what was found, or that nothing was yet."""
        self._state = state
        there = state is not None
        for part in (self.left, self.refinement, self.look):
            part.setVisible(there)
        if state is None:
            self.note.setText(tr("Not found yet."))
            self.picture.show_empty(tr("Not found yet."))
            self.residuals.hide()
            return
        self.residuals.show()
        self.note.setText(tr_core("\n".join(problem.reason for problem in state.problems)))
        self.note.setVisible(bool(state.problems))
        self.facts.show_rows(state.facts)
        self.found.show_rows(state.parameters)
        self.refinement.setVisible(bool(state.parameters))
        self._draw_picture()
        self._draw_marks()
        angles, residuals, off = state.angles_deg, state.residual_px, state.outliers
        kept = ~off
        curves = [Curve(angles[kept], residuals[kept], tr("highlights"), mark="points", width=3.0)]
        if off.any():
            name = tr("excluded")
            curves.append(Curve(angles[off], residuals[off], name, "faint", mark="points", width=2.0))
        largest = float(np.nanmax(residuals[kept], initial=0.0))
        self.residuals.set_reach(y=(0.0, max(0.1, 1.8 * largest)))
        if kept.any() or off.any():
            self.residuals.show_curves(curves)
        else:
            self.residuals.show_empty(tr("No highlight was found."))

    def _draw_picture(self) -> None:
        if self._state is not None:
            self.picture.show_image(drawn(self._state.picture, self.brightness.value()))

    def _draw_marks(self) -> None:
        state = self._state
        if state is None:
            return
        gain = self.gain.value()
        expected, found = state.predicted + _HALF, state.found + _HALF
        marks: list[Mark] = [
            Outline(state.outline + _HALF, tr("fitted outline")),
            Points(expected, tr("highlight, expected"), "ring"),
            Points(found, tr("highlight, found"), "cross"),
            Differences(expected, found, tr("difference × {gain:g}").format(gain=gain), gain),
        ]
        rejected = state.edge[~state.edge_used]
        if len(rejected):
            marks.append(Points(rejected + _HALF, tr("excluded edge"), "dot"))
        self.picture.show_marks(marks)
