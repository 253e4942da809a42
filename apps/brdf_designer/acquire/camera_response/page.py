"""Step 3: what exposure each code of the camera stands for."""

from __future__ import annotations

import numpy as np
from brdf_qt.program.translation import tr
from PySide6.QtCore import Qt, Signal

from brdf_designer.acquire.plots.lines_plot import CHANNELS, Axis, Curve, LinesPlot
from brdf_designer.acquire.states import ResponseState
from brdf_designer.acquire.step_page import AcquirePage, Facts
from brdf_designer.window.widgets import button, combo, split, wrapped


class ResponsePage(AcquirePage):
    """Page of the response curve. Intents: ``recover_requested()``, ``kind_chosen(name)``: ``auto`` or ``linear``."""

    recover_requested = Signal()
    kind_chosen = Signal(str)

    def __init__(self) -> None:
        super().__init__(
            "response",
            tr(
                "The response curve is estimated from photographs of the same light with different exposures."
            ),
        )
        self.plot = LinesPlot(
            tr("Camera response"),
            Axis(tr("Code")),
            Axis(tr("Exposure (half at the middle code)"), log=True),
            rising=True,
        )
        self.times = LinesPlot(
            tr("Stated exposure times compared with estimates from the photographs"),
            Axis(tr("Stated time (ms)"), log=True),
            Axis(tr("Difference (%)")),
        )
        self.centre.addWidget(split(Qt.Orientation.Vertical, (self.plot, 5), (self.times, 2)), 1)
        self.kind = combo(
            ((tr("From session.json"), "auto"), (tr("Linear camera"), "linear")),
            tr("Response type"),
            tr(
                "From session.json: estimated from the photographs if session.json names no "
                "curve. Linear camera: no curve"
            ),
        )
        self.kind.activated.connect(lambda _index: self.kind_chosen.emit(str(self.kind.currentData())))
        tip = tr("Estimate the response curve from photographs of several positions")
        self.start = button(tr("Find Response"), tip, self.recover_requested.emit)
        self.note = wrapped()
        self.add_part("find", tr("Response"), self.kind, self.start, self.note)
        self.facts = Facts(tr("Quality of the response curve"))
        self.known = self.add_part("known", tr("Quality"), self.facts)
        self.show_response(None)

    def show_response(self, state: ResponseState | None) -> None:
        """Show a curve, or that there is none yet."""
        self.known.setVisible(state is not None)
        if state is None:
            self.note.setText(tr("Not found yet."))
            self.plot.show_empty(tr("Not found yet."))
            self.times.hide()
            return
        self.note.setText(
            tr("The camera is linear.")
            if state.linear
            else tr("Codes outside the thick lines are not reliable.")
        )
        channels, codes = state.exposure.shape
        code = np.arange(codes, dtype=float)
        names = (tr("red"), tr("green"), tr("blue")) if channels == 3 else (tr("grey"),)
        looks = CHANNELS if channels == 3 else (("text", "solid"),)
        curves = []
        for values, low, high, name, (kind, dash) in zip(
            state.exposure, state.lowest, state.highest, names, looks, strict=True
        ):
            trusted = (code >= low) & (code <= high)
            curves.append(Curve(code, values, "", kind, "solid", width=0.8))
            curves.append(Curve(code, np.where(trusted, values, np.nan), name, kind, dash, width=2.4))
        # The floor of a logarithmic axis: what the lowest trusted code stands for, and a decade below.
        floor = [row[low] for row, low in zip(state.exposure, state.lowest, strict=True) if row[low] > 0.0]
        top = float(np.nanmax(state.exposure))
        if floor and top > 0.0:
            self.plot.set_reach(x=(0.0, float(codes)), y=(0.2 * float(min(floor)), 1.5 * top))
        self.plot.show_curves(curves)
        self.facts.show_rows(state.facts)
        if state.times:
            stated, off = (np.array(column) for column in zip(*state.times, strict=True))
            zero = Curve(1e3 * stated, np.zeros_like(off), "", "faint", "dash")
            name = tr("estimated − stated")
            self.times.show_curves([zero, Curve(1e3 * stated, 100.0 * off, name, mark="points", width=3.0)])
        self.times.setVisible(bool(state.times))
        self.plot.setAccessibleDescription("; ".join(f"{name}: {value}" for name, value, _ in state.facts))
