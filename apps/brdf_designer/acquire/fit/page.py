"""Step 8: Cook-Torrance lobes fitted to the table, drawn as Figure 5 of Günther et al. 2005, and taken as a paint."""

from __future__ import annotations

import numpy as np
from brdf_qt.fields.form import Form
from brdf_qt.fields.quiet import QuietComboBox, QuietSpinBox
from brdf_qt.program.translation import tr
from PySide6.QtCore import Signal
from PySide6.QtWidgets import QComboBox

from brdf_designer.acquire.pictures.lines_plot import CHANNELS, Axis, Curve, Kind, LinesPlot
from brdf_designer.acquire.states import FitState
from brdf_designer.acquire.step_page import AcquirePage, Facts, button, wrapped
from brdf_designer.standard.tables import WholeTable

_LUMINANCE = np.array([0.2627, 0.6780, 0.0593])
"""Of Rec. 2020 primaries, ITU-R BT.2020."""
_DASHES = ("dot", "dash", "dash dot", "long dash")
LEAST_LOBES, MOST_LOBES, USUAL_LOBES = 1, 6, 3


class FitPage(AcquirePage):
    """The page of the fit.

    Intents: ``fit_requested()``, ``choice_edited()``, ``open_requested()``, ``save_requested()``.
    """

    fit_requested = Signal()
    choice_edited = Signal()
    open_requested = Signal()
    save_requested = Signal()

    def __init__(self) -> None:
        super().__init__(
            "fit",
            tr(
                "The table approximated by a few lobes: measured values as points, the fit as "
                "a line, its components dashed."
            ),
        )
        self._state: FitState | None = None
        self.plot = LinesPlot(
            tr("Measured reflectance and its fit"),
            Axis(tr("θh (degrees)"), root=True, reach=(0.0, 90.0)),
            Axis(tr("f_r (1/sr)"), log=True),
        )
        self.centre.addWidget(self.plot, 1)
        headings = (tr("Part"), tr("Red"), tr("Green"), tr("Blue"), "m", "r")
        self.table = WholeTable(tr("Parameters of the fit"), headings)
        self.table.setToolTip(
            tr(
                "Weights kd and ks per channel, slope m of the facets, reflectance r at the normal; "
                "± standard uncertainty"
            )
        )
        self.centre.addWidget(self.table)
        form = Form()
        self.model = QuietComboBox()
        for name, title in (
            ("cook-torrance", tr("Cook-Torrance")),
            ("ggx", tr("GGX lobes")),
            ("ggx-clearcoat", tr("GGX lobes, clearcoat")),
        ):
            self.model.addItem(title, name)
        self.model.setSizeAdjustPolicy(QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon)
        self.lobes = QuietSpinBox()
        self.lobes.setRange(LEAST_LOBES, MOST_LOBES)
        self.lobes.setValue(USUAL_LOBES)
        self.model.activated.connect(lambda _index: self.choice_edited.emit())
        self.lobes.valueChanged.connect(lambda _value: self.choice_edited.emit())
        form.add_row(
            tr("Model"), self.model, tr("Lobe model; only Cook-Torrance can be opened or saved as a paint")
        )
        form.add_row(tr("Lobes"), self.lobes, tr("Number of lobes; the last one models the sharp peak"))
        self.start = button(tr("Fit Lobes"), tr("Fit the lobes to the table; takes several seconds"))
        self.start.clicked.connect(lambda _=False: self.fit_requested.emit())
        self.note = wrapped("")
        self.add_part("model", tr("Model"), form, self.start, self.note)
        look = Form()
        self.angle, self.channel = QuietComboBox(), QuietComboBox()
        for name, key in (
            (tr("Luminance"), -1),
            (tr("Red"), 0),
            (tr("Green"), 1),
            (tr("Blue"), 2),
            (tr("All three"), 3),
        ):
            self.channel.addItem(name, key)
        for combo in (self.angle, self.channel):
            combo.currentIndexChanged.connect(lambda _index: self._draw())
        look.add_row(
            tr("θd"), self.angle, tr("Angle between light and half vector, along which the curves are drawn")
        )
        look.add_row(tr("Channel"), self.channel, tr("Linear Rec. 2020"))
        self.look = self.add_part("look", tr("Plot"), look)
        self.facts = Facts(tr("Fit errors"))
        self.errors = self.add_part("errors", tr("Errors"), self.facts)
        self.open = button(
            tr("Open as New Paint"),
            tr("Start an unsaved design from this fit in a new tab"),
        )
        self.save = button(tr("Save Paint…"), tr("Save the lobes as a .brdfpaint file for Viewer"))
        self.open.clicked.connect(lambda _=False: self.open_requested.emit())
        self.save.clicked.connect(lambda _=False: self.save_requested.emit())
        self.kept = wrapped("")
        self.add_part("result", tr("Result"), self.open, self.save, self.kept)
        self.show_fit(None)

    @property
    def chosen(self) -> tuple[str, int]:
        """The model and the number of lobes."""
        return str(self.model.currentData()), self.lobes.value()

    def show_fit(self, state: FitState | None, *, has_table: bool = False) -> None:
        """Show a fit, or that there is none; ``has_table`` says whether one can be made."""
        self._state = state
        there = state is not None
        self.start.setEnabled(has_table or there)
        for part in (self.look, self.errors, self.table):
            part.setVisible(there)
        has_paint = state is not None and state.has_paint
        self.open.setEnabled(has_paint)
        self.save.setEnabled(has_paint)
        if state is None:
            self.note.setText("")
            self.plot.show_empty(
                tr("Not fitted yet.") if has_table else tr("No table yet. Run the reconstruction first.")
            )
            return
        self.note.setText("\n".join(state.notices))
        self.angle.blockSignals(True)
        # At first the curve with the most points.
        points = np.isfinite(state.measured).any(axis=-1).sum(axis=-1)
        chosen = self.angle.currentIndex() if self.angle.count() else int(np.argmax(points))
        self.angle.clear()
        for angle in state.theta_d_deg:
            self.angle.addItem(f"{angle:.3g}°")
        self.angle.addItem(tr("all"))
        self.angle.setCurrentIndex(min(chosen, self.angle.count() - 1))
        self.angle.blockSignals(False)
        self.facts.show_rows(state.facts)
        self.table.set_row_count(len(state.rows))
        for row, texts in enumerate(state.rows):
            for column, text in enumerate(texts):
                self.table.set_text(row, column, text, tip=text)
        self._draw()

    def show_kept(self, text: str) -> None:
        """Say where the result is."""
        self.kept.setText(text)

    def _draw(self) -> None:
        state = self._state
        if state is None:
            return
        chosen = self.angle.currentIndex()
        every = chosen >= len(state.theta_d_deg)
        places = range(len(state.theta_d_deg)) if every else (chosen,)
        channel = int(self.channel.currentData())
        looks: list[tuple[Kind, str]] = (
            [*CHANNELS] if channel == 3 else [("text", "solid") if channel < 0 else CHANNELS[channel]]
        )
        curves: list[Curve] = []
        for place in places:
            for number, (kind, _dash) in enumerate(looks):
                weights = _LUMINANCE if channel < 0 else np.eye(3)[number if channel == 3 else channel]
                named = place == places[0] and number == 0
                measured, fitted = state.measured[place] @ weights, state.fitted[place] @ weights
                curves.append(
                    Curve(
                        state.theta_h_deg,
                        measured,
                        tr("measured") if named else "",
                        kind,
                        mark="points",
                        width=1.0,
                    )
                )
                curves.append(
                    Curve(state.theta_h_deg, fitted, tr("fitted") if named else "", kind, width=2.2)
                )
                if len(looks) == 1 and not every:
                    curves += _parts(state, place, weights)
        known = np.concatenate([curve.y for curve in curves[:2]])
        known = known[np.isfinite(known) & (known > 0.0)]
        if known.size:
            self.plot.set_reach(x=(0.0, 90.0), y=(0.4 * float(known.min()), 2.0 * float(known.max())))
        self.plot.show_curves(curves)


def _parts(state: FitState, place: int, weights: np.ndarray) -> list[Curve]:
    """The curves of the parts: the diffuse one dotted, the lobes dashed."""
    found = []
    for number, part in enumerate(state.parts[:, place] @ weights):
        name = tr("diffuse") if number == 0 else tr("lobe {number}").format(number=number)
        found.append(
            Curve(
                state.theta_h_deg,
                part,
                name,
                "faint",
                "dot" if number == 0 else "dash",
                width=1.0 + 0.4 * number,
            )
        )
    return found
