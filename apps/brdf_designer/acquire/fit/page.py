"""Step 8: Cook-Torrance lobes fitted to the table, drawn as Figure 5 of Günther et al. 2005, and taken as a paint."""

from __future__ import annotations

import math

import numpy as np
from brdf_qt.fields.form import Form
from brdf_qt.fields.quiet import QuietComboBox, QuietSpinBox
from brdf_qt.program.core_texts import tr_core
from brdf_qt.program.translation import decimal, tr
from PySide6.QtCore import QSignalBlocker, Signal

from brdf_designer.acquire.plots.lines_plot import CHANNELS, Axis, Curve, Kind, LinesPlot
from brdf_designer.acquire.step_page import AcquirePage, Facts
from brdf_designer.standard_comparison.tables import WholeTable
from brdf_designer.window.widgets import button, combo, wrapped
from brdf_suite.fitting.cook_torrance.reflectance_fit import FileFit, FitPlot
from brdf_suite.fitting.cook_torrance.result import CookTorranceFit

_LUMINANCE = np.array([0.2627, 0.6780, 0.0593])
"""Of Rec. 2020 primaries, ITU-R BT.2020."""
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
        self._plot: FitPlot | None = None
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
        self.model = combo(
            (
                (tr("Cook-Torrance"), "cook-torrance"),
                (tr("GGX lobes"), "ggx"),
                (tr("GGX lobes, clearcoat"), "ggx-clearcoat"),
            )
        )
        self.lobes = QuietSpinBox()
        self.lobes.setRange(LEAST_LOBES, MOST_LOBES)
        self.lobes.setValue(USUAL_LOBES)
        self.model.activated.connect(lambda _index: self.choice_edited.emit())
        self.lobes.valueChanged.connect(lambda _value: self.choice_edited.emit())
        form.add_row(
            tr("Model"), self.model, tr("Lobe model; only Cook-Torrance can be opened or saved as a paint")
        )
        form.add_row(tr("Lobes"), self.lobes, tr("Number of lobes; the last one models the sharp peak"))
        tip = tr("Fit the lobes to the table; takes several seconds")
        self.start = button(tr("Fit Lobes"), tip, self.fit_requested.emit)
        self.note = wrapped()
        self.add_part("model", tr("Model"), form, self.start, self.note)
        look = Form()
        self.angle = QuietComboBox()
        names = (tr("Luminance"), tr("Red"), tr("Green"), tr("Blue"), tr("All three"))
        self.channel = combo(zip(names, (-1, 0, 1, 2, 3), strict=True))
        for choice in (self.angle, self.channel):
            choice.currentIndexChanged.connect(lambda _index: self._draw())
        look.add_row(
            tr("θd"), self.angle, tr("Angle between light and half vector, along which the curves are drawn")
        )
        look.add_row(tr("Channel"), self.channel, tr("Linear Rec. 2020"))
        self.look = self.add_part("look", tr("Plot"), look)
        self.facts = Facts(tr("Fit errors"))
        self.errors = self.add_part("errors", tr("Errors"), self.facts)
        tip = tr("Start an unsaved design from this fit in a new tab")
        self.open = button(tr("Open as New Paint"), tip, self.open_requested.emit)
        tip = tr("Save the lobes as a .brdfpaint file for Viewer")
        self.save = button(tr("Save Paint…"), tip, self.save_requested.emit)
        self.kept = wrapped()
        self.result = self.add_part("result", tr("Result"), self.open, self.save, self.kept)
        self.show_fit(None)

    @property
    def chosen(self) -> tuple[str, int]:
        """The model and the number of lobes."""
        return str(self.model.currentData()), self.lobes.value()

    def show_fit(self, found: FileFit | None, *, has_table: bool = False) -> None:
        """Show a fit, or that there is none; ``has_table`` says whether one can be made."""
        self._plot = None if found is None else found.plot
        there = found is not None
        self.start.setEnabled(has_table or there)
        for part in (self.look, self.errors, self.table):
            part.setVisible(there)
        has_paint = found is not None and found.paint is not None
        self.open.setEnabled(has_paint)
        self.save.setEnabled(has_paint)
        self.kept.setText("")
        if found is None:
            self.note.setText("")
            self.plot.show_empty(
                tr("Not fitted yet.") if has_table else tr("No table yet. Run the reconstruction first.")
            )
            return
        self.note.setText(tr_core("\n".join(found.fit.notices)))
        # At first the curve with the most points.
        points = np.isfinite(found.plot.measured).any(axis=-1).sum(axis=-1)
        chosen = self.angle.currentIndex() if self.angle.count() else int(np.argmax(points))
        with QSignalBlocker(self.angle):
            self.angle.clear()
            self.angle.addItems([*(decimal(f"{angle:.3g}°") for angle in found.plot.theta_d_deg), tr("all")])
            self.angle.setCurrentIndex(min(chosen, self.angle.count() - 1))
        self.facts.show_rows(fit_facts(found))
        rows = fit_rows(found.fit)
        self.table.set_row_count(len(rows))
        for row, texts in enumerate(rows):
            for column, text in enumerate(texts):
                self.table.set_text(row, column, text, tip=text)
        self._draw()

    def _draw(self) -> None:
        shown = self._plot
        if shown is None:
            return
        chosen = self.angle.currentIndex()
        every = chosen >= len(shown.theta_d_deg)
        places = range(len(shown.theta_d_deg)) if every else (chosen,)
        channel = int(self.channel.currentData())
        looks: list[tuple[Kind, str]] = (
            [*CHANNELS] if channel == 3 else [("text", "solid") if channel < 0 else CHANNELS[channel]]
        )
        curves: list[Curve] = []
        for place in places:
            for number, (kind, _dash) in enumerate(looks):
                weights = _LUMINANCE if channel < 0 else np.eye(3)[number if channel == 3 else channel]
                named = place == places[0] and number == 0
                measured, fitted = shown.measured[place] @ weights, shown.fitted[place] @ weights
                names = (tr("measured"), tr("fitted")) if named else ("", "")
                curves += [
                    Curve(shown.theta_h_deg, measured, names[0], kind, mark="points", width=1.0),
                    Curve(shown.theta_h_deg, fitted, names[1], kind, width=2.2),
                ]
                if len(looks) == 1 and not every:
                    curves += _parts(shown, place, weights)
        known = np.concatenate([curve.y for curve in curves[:2]])
        known = known[np.isfinite(known) & (known > 0.0)]
        if known.size:
            self.plot.set_reach(x=(0.0, 90.0), y=(0.4 * float(known.min()), 2.0 * float(known.max())))
        self.plot.show_curves(curves)


def _parts(shown: FitPlot, place: int, weights: np.ndarray) -> list[Curve]:
    """The curves of the parts: the diffuse one dotted, the lobes dashed."""
    names = [tr("diffuse"), *(tr("lobe {number}").format(number=k) for k in range(1, len(shown.parts)))]
    return [
        Curve(shown.theta_h_deg, part, name, "faint", "dash" if number else "dot", width=1.0 + 0.4 * number)
        for number, (part, name) in enumerate(zip(shown.parts[:, place] @ weights, names, strict=True))
    ]


def fit_facts(found: FileFit) -> list[tuple[str, str, str]]:
    """Return names, values and explanations of the errors of a fit."""
    fit, errors = found.fit, found.errors
    return [
        (
            tr("Mean |ln|"),
            decimal(f"{errors.l1_mean:.4f}"),
            tr(
                "Mean of |ln(fit/measured)| over all measured bins: the energy of equation 2 "
                "divided by its number of terms"
            ),
        ),
        (
            tr("RMS ln"),
            decimal(f"{errors.log_rms:.4f}"),
            tr("Root mean square of ln(fit/measured) over every measured bin"),
        ),
        (
            tr("Median"),
            decimal(f"{100.0 * errors.median_relative:.1f} %"),
            tr("Median relative difference over every measured bin"),
        ),
        (
            tr("Energy"),
            decimal(f"{fit.energy:.1f}"),
            tr("Equation 2 of Günther et al. 2005 over the samples of the solver"),
        ),
        (
            tr("Samples"),
            f"{fit.samples}",
            tr("Samples used by the solver; errors are computed over all measured bins"),
        ),
        (tr("Time"), tr("{seconds:.1f} s").format(seconds=found.seconds), tr("Duration of the fit")),
    ]


def fit_rows(fit: CookTorranceFit) -> list[tuple[str, ...]]:
    """Return (part, red, green, blue, slope m, reflectance r) with their uncertainties, the diffuse part first."""
    spread = fit.standard_errors
    return [
        (tr("diffuse"), *map(with_error, fit.kd, spread.kd), "", ""),
        *(
            (
                tr("lobe {number}").format(number=lobe + 1),
                *map(with_error, fit.ks[lobe], spread.ks[lobe]),
                with_error(fit.m[lobe], spread.m[lobe]),
                with_error(fit.r[lobe], spread.r[lobe]),
            )
            for lobe in range(len(fit.m))
        ),
    ]


def with_error(value: float, error: float) -> str:
    """Return a value with its standard uncertainty, to one digit of that.

    >>> with_error(0.31234, 0.0123)
    '0.31 ± 0.01'
    """
    value, error = float(value), float(error)
    if not math.isfinite(error):
        return decimal(f"{value:.3g} ± ?")
    if error <= 0.0:
        return decimal(f"{value:.4g}")
    digits = max(0, -math.floor(math.log10(error)))
    return decimal(f"{value:.{digits}f} ± {error:.{digits}f}")
