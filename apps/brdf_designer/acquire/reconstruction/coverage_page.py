"""Step 7: which directions the table was measured at, and how well."""

from __future__ import annotations

from typing import Literal

import numpy as np
from brdf_qt.program.translation import decimal, tr
from numpy.typing import NDArray
from PySide6.QtCore import Signal

from brdf_designer.acquire.plots.map_plot import AngleMap, MapPlot
from brdf_designer.acquire.states import CoverageState
from brdf_designer.acquire.step_page import AcquirePage, Facts
from brdf_designer.window.widgets import button, combo, wrapped

What = Literal["share", "pixels", "error"]
_TICKS_DEG = (0.0, 2.0, 10.0, 30.0, 60.0, 90.0)


class CoveragePage(AcquirePage):
    """The page of the coverage. Intents: ``save_requested()``."""

    save_requested = Signal()

    def __init__(self) -> None:
        super().__init__(
            "coverage",
            tr(
                "Coverage over the half-vector angles: θh from the normal, θd between light "
                "and half vector. Hatched cells are filled from neighbours."
            ),
        )
        self._state: CoverageState | None = None
        self.map = MapPlot(tr("Coverage of the table"))
        self.centre.addWidget(self.map, 1)
        self.what = combo(
            (
                (tr("Share of the φd bins measured"), "share"),
                (tr("Pixels per cell"), "pixels"),
                (tr("Relative standard error"), "error"),
            ),
            tr("Quantity on the map"),
            tr("Quantity that the grey of a cell represents"),
        )
        self.what.currentIndexChanged.connect(lambda _index: self._draw())
        self.cell = Facts(tr("The cell under the cursor"))
        self.add_part("map", tr("Map"), self.what, self.cell)
        self.facts = Facts(tr("The table"))
        self.known = self.add_part("table", tr("Table"), self.facts)
        self.save = button(
            tr("Save Table…"),
            tr("Save as .brdftable with the coverage, or as .binary in the MERL layout"),
            self.save_requested.emit,
        )
        self.kept = wrapped()
        self.add_part("save", tr("Save"), self.save, self.kept)
        self.map.hovered.connect(self._read)
        self.show_coverage(None)

    def show_coverage(self, state: CoverageState | None) -> None:
        """Show a table's coverage, or that there is no table yet."""
        self._state = state
        if state is None:
            self.kept.setText("")
        self.save.setEnabled(state is not None)
        self.known.setVisible(state is not None)
        if state is None:
            self.map.clear(tr("No table yet. Run the previous step first."))
        else:
            self.facts.show_rows(state.facts)
        self._draw()
        self._read(-1, -1)

    def _draw(self) -> None:
        if self._state is not None:
            self.map.show_map(coverage_map(self._state, self.what.currentData()))

    def _read(self, row: int, column: int) -> None:
        state = self._state
        if state is None or row < 0:
            self.cell.show_rows([(tr("Cell"), "–", tr("θh and θd under the cursor"))])
            return
        share, error = state.share[row, column], state.error[row, column]
        where = decimal(f"θh {state.theta_h_deg[column]:.3g}°, θd {state.theta_d_deg[row]:.3g}°")
        known = np.isfinite(share) and share > 0.0
        measured = f"{100.0 * share:.0f} %" if known else tr("no")
        pixels = decimal(f"{state.pixels[row, column]:.0f}") if known else "–"
        spread = decimal(f"{100.0 * error:.2g} %") if known and np.isfinite(error) else "–"
        self.cell.show_rows(
            [
                (tr("Cell"), where, tr("θh and θd under the cursor")),
                (tr("Measured"), measured, tr("Share of measured φd bins")),
                (tr("Pixels"), pixels, tr("Pixels in this cell")),
                (tr("Error"), spread, tr("Relative standard error of the mean")),
            ]
        )


def coverage_map(state: CoverageState, what: What) -> AngleMap:
    """Return the map of ``what``, θd over θh, as bins lie in the table (θh is finer towards the highlight)."""
    measured = np.isfinite(state.share) & (state.share > 0.0)
    ticks: tuple[tuple[float, str], ...]
    if what == "share":
        values, low, high, scale = 100.0 * state.share, 0.0, 100.0, tr("φd bins measured (%)")
        ticks = ((0.0, "0"), (0.25, "25"), (0.5, "50"), (0.75, "75"), (1.0, "100"))
    elif what == "pixels":
        values = np.log10(np.maximum(state.pixels, 1.0))
        low, high, scale = 0.0, max(1.0, np.ceil(float(values[measured].max(initial=1.0)))), tr("pixels")
        ticks = tuple((k / high, f"{10.0**k:g}") for k in range(int(high) + 1))
    else:
        values = np.log10(np.clip(100.0 * state.error, 1e-2, 1e2))
        low, high, scale = -2.0, 2.0, tr("relative standard error (%)")
        ticks = tuple(((k + 2.0) / 4.0, f"{10.0**k:g}") for k in range(-2, 3))
    return AngleMap(
        np.where(measured, values, np.nan),
        tr("θh (degrees)"),
        tr("θd (degrees)"),
        _ticks(state.theta_h_deg),
        _ticks(state.theta_d_deg),
        scale,
        float(low),
        float(high),
        ticks,
    )


def _ticks(centres_deg: NDArray[np.floating]) -> tuple[tuple[float, str], ...]:
    """Where round angles lie along bins with these centres."""
    places = (np.arange(len(centres_deg)) + 0.5) / len(centres_deg)
    whole_x, whole_y = np.r_[0.0, places, 1.0], np.r_[0.0, centres_deg, 90.0]
    return tuple((float(np.interp(at, whole_y, whole_x)), f"{at:g}") for at in _TICKS_DEG)
