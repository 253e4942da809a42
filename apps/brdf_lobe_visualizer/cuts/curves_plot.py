"""Values over an angle: all visible subjects as lines, a crosshair with a readout, log axes, samples and holes."""

from __future__ import annotations

from types import ModuleType
from typing import Any, get_args

import numpy as np
from brdf_qt.fields.choice_button import ChoiceButton
from brdf_qt.fields.form import described, row_of
from brdf_qt.fields.labels import plain_tip
from brdf_qt.program.translation import decimal, tr
from PySide6.QtCore import Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QWidget

from brdf_lobe_visualizer.cuts.crosshair import rows_at
from brdf_lobe_visualizer.cuts.line_plot import LinePlot
from brdf_lobe_visualizer.cuts.lines import Lines, largest
from brdf_lobe_visualizer.cuts.section import SliceOptions, SliceState
from brdf_lobe_visualizer.options import Options
from brdf_lobe_visualizer.words import AXIS_LETTERS, AXIS_TIPS, AXIS_TITLES, UNIT, degrees, number, quantity
from brdf_suite.arrays import Bools, Floats
from brdf_suite.inspection.slices.cuts import FINEST_DEG, Axis
from brdf_suite.inspection.slices.values import SliceError, nice_above

_DECADES = 7.0
"""A logarithmic axis reaches no further down than this below its top."""


class CurvesPlot(LinePlot):
    """The curves."""

    with_axes = True

    def __init__(self, state: SliceState, parent: QWidget | None = None) -> None:
        super().__init__("curves_plot", tr("Curves: values over an angle"), parent)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self._state = state
        self._free = False
        self._named: tuple[Any, ...] | None = None
        self._view: tuple[Any, ...] | None = None
        self.axis_buttons: dict[Axis, ChoiceButton] = {}
        for axis in get_args(Axis):
            title = tr(AXIS_TITLES[axis])
            button, tip = ChoiceButton(AXIS_LETTERS[axis]), f"{title}\n{tr(AXIS_TIPS[axis])}"
            described(button, name=f"axis_{axis}", spoken=title, tip=tip)
            button.clicked.connect(lambda _on=False, axis=axis: self._choose(axis))
            self.axis_buttons[axis] = button
        tip = tr("Logarithmic value axis. Differences are signed and stay linear.")
        self.log_value = described(ChoiceButton(tr("log y")), tip=tip)
        self.log_value.clicked.connect(lambda on: state.set(log_value=on))
        tip = tr("Logarithmic angle axis, for peaks. For γ, only the side towards the normal is shown.")
        self.log_angle = described(ChoiceButton(tr("log x")), tip=tip)
        self.log_angle.clicked.connect(lambda on: state.set(log_angle=on))
        head = row_of(*self.axis_buttons.values(), self.log_value, self.log_angle, None, spacing=4)
        head.insertSpacing(len(self.axis_buttons), 8)
        self._box.insertLayout(0, head)
        self.show_options(state.options)

    def make_items(self, items: ModuleType) -> None:
        self.plot.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.bands = items.HoleBands()
        self._mirror, self._normal, self._cross = (items.upright() for _ in range(3))
        for item in (self.bands, self._mirror, self._normal, self._cross):
            self.plot.addItem(item, ignoreBounds=True)
        self.plot.framed.connect(self.frame)
        self.plot.zoomed.connect(self._set_free)

    def show_options(self, options: SliceOptions) -> None:
        for axis, button in self.axis_buttons.items():
            button.setChecked(axis == options.axis)
        self.log_value.setChecked(options.log_value)
        self.log_angle.setChecked(options.log_angle)
        self.log_angle.setEnabled(options.axis != "theta_o")

    def show_lines(self, lines: Lines, theta_deg: float, options: Options) -> None:
        """Draw the lines of the chosen axis; the light is at ``theta_deg``."""
        self.lines, self._theta_deg, self._options = lines, theta_deg, options
        if self.plot is not None:
            self.draw()

    def frame(self) -> None:
        self._free = False
        if self.plot is not None:
            self.draw()

    @property
    def logs(self) -> tuple[bool, bool]:
        signed = self.lines is not None and self.lines.signed
        options = self._state.options
        return options.log_angle and options.axis != "theta_o", options.log_value and not signed

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_F:
            self.frame()
        else:
            super().keyPressEvent(event)

    def _choose(self, axis: Axis) -> None:
        self._free = False
        self._state.set(axis=axis)
        self.show_options(self._state.options)

    def draw(self) -> None:
        lines = self.lines
        if self.show_empty() or lines is None:
            return
        log_x, log_y = self.logs
        drawn = []
        for line in lines.lines:
            y = line.value if line.filled is None else np.where(line.filled, np.nan, line.value)
            drawn.append((line, *_logs(lines.cut.angle_deg, y, log_x, log_y)))
        self.plot.show_lines(drawn)
        drawn = []
        for line, points in self.sampled_lines():
            x, y = _logs(points.angle_deg, points.value, log_x, log_y)
            known = np.isfinite(x) & np.isfinite(y)
            drawn.append((line, x[known], y[known]))
        self.plot.show_points(drawn)
        front = next((line for line in lines.lines if line.is_front and line.filled is not None), None)
        bands = [] if front is None else bands_of(lines.cut.angle_deg, front.filled, log_x)
        self.bands.show_bands(bands, self.palette())
        self._name_axes(lines, log_x, log_y)
        self._place_marks(lines.cut.axis, log_x)
        if not self._free:
            self._frame(lines, log_x, log_y)
        self._show_residual(lines, bool(bands))

    def _name_axes(self, lines: Lines, log_x: bool, log_y: bool) -> None:
        named = (lines.cut.axis, quantity(self._options), log_x, log_y)
        if self._named == named:
            return
        self._named = named
        self.plot.setLabel("bottom", tr(AXIS_TITLES[lines.cut.axis]))
        self.plot.setLabel("left", quantity(self._options))
        self.plot.getAxis("bottom").setLogMode(x=log_x)
        self.plot.getAxis("left").setLogMode(y=log_y)
        self.plot.showGrid(x=True, y=True, alpha=0.12)

    def _place_marks(self, axis: Axis, log_x: bool) -> None:
        theta = self._theta_deg
        places = {
            "gamma": (0.0, theta),
            "theta_o": (theta, 0.0),
            "theta_h": (0.0, None),
            "theta_d": (None, None),
        }[axis]
        for item, place in zip((self._mirror, self._normal), places, strict=True):
            shown = place is not None and (not log_x or place >= FINEST_DEG)
            item.setVisible(shown)
            if shown and place is not None:
                item.setPos(np.log10(place) if log_x else place)

    def _frame(self, lines: Lines, log_x: bool, log_y: bool) -> None:
        angles = lines.cut.angle_deg
        x = (np.log10(FINEST_DEG), np.log10(max(90.0, float(angles[-1]))))
        if not log_x:
            x = (15.0 * np.floor(angles[0] / 15.0 + 1e-9), 15.0 * np.ceil(angles[-1] / 15.0 - 1e-9))
        y = _value_range(lines, log_y)
        view = (x, y)
        if self._view != view or self.plot.viewRange() != [list(x), list(y)]:
            self._view = view
            self.plot.setRange(xRange=x, yRange=y, padding=0.0, disableAutoRange=True)

    def _show_residual(self, lines: Lines, holes: bool) -> None:
        """Write the residual of the selected fit and what is missing; the tooltip has all fits."""
        errors: dict[str, str] = {}
        for line in lines.lines:
            error = lines.errors.get(line.key)
            if error is not None and line.key not in errors:
                errors[line.key] = tr(
                    "{name}: RMS {rms} {unit} ({share} %), maximum {worst} {unit} at {angle}"
                ).format(
                    name=line.title,
                    rms=number(error.rms),
                    unit=UNIT,
                    share=decimal(f"{100.0 * error.relative:.1f}") if np.isfinite(error.relative) else "–",
                    worst=number(error.worst),
                    angle=degrees(lines.cut.axis, error.worst_deg),
                )
        rest = [tr("hatched: not measured")] if holes else []
        silent = {line.title for line in lines.lines if not np.isfinite(line.value).any()}
        rest.extend(tr("{name}: no values here").format(name=name) for name in sorted(silent))
        black = {line.title for line in lines.lines if line.kind != "difference" and _is_zero(line.value)}
        rest.extend(tr("{name}: 0 everywhere").format(name=name) for name in sorted(black))
        front = next((line for line in lines.lines if line.is_front), lines.lines[-1])
        # In few words, for there is little room; the tip has all figures.
        shown = [_short(lines, lines.errors[front.key])] if front.key in errors else []
        self.note.setText(" · ".join([*shown, *rest]))
        self.note.setToolTip(plain_tip("\n".join([*errors.values(), *rest])))

    def read(self, x: float, _y: float) -> None:
        if self.lines is None or not self.lines.lines:
            return
        angle, rows = rows_at(self.lines, 10.0**x if self.logs[0] else x)
        self._cross.setPos(np.log10(max(angle, FINEST_DEG)) if self.logs[0] else angle)
        self._cross.setVisible(True)
        low, high = self.plot.viewRange()[0]
        head, at_right = degrees(self.lines.cut.axis, angle), x < 0.5 * (low + high)
        self.readout.show_rows(head, rows, quantity(self._options), at_right=at_right)

    def _set_free(self) -> None:
        self._free = True

    def dress(self) -> None:
        dashes = (Qt.PenStyle.DashLine, Qt.PenStyle.DotLine, Qt.PenStyle.SolidLine)
        for item, alpha, style in zip(
            (self._mirror, self._normal, self._cross), (0.5, 0.4, 0.8), dashes, strict=True
        ):
            item.setPen(self.pen(alpha, style))
        self._named = None


def _is_zero(value: Floats) -> bool:
    known = value[np.isfinite(value)]
    return bool(known.size and not known.any())


def _logs(x: Floats, y: Floats, log_x: bool, log_y: bool) -> tuple[Floats, Floats]:
    with np.errstate(divide="ignore", invalid="ignore"):
        if log_x:
            x, y = np.log10(np.where(x > 0.0, x, FINEST_DEG)), np.where(x > 0.0, y, np.nan)
        if log_y:
            y = np.where(y > 0.0, np.log10(np.where(y > 0.0, y, 1.0)), np.nan)
    return x, y


def bands_of(angle_deg: Floats, holes: Bools | None, log_x: bool) -> list[tuple[float, float]]:
    """Return the spans (from, to) of the angles at which ``holes`` is set, half way to their neighbours."""
    if holes is None or not holes.any():
        return []
    edges = np.concatenate((angle_deg[:1], 0.5 * (angle_deg[1:] + angle_deg[:-1]), angle_deg[-1:]))
    steps = np.diff(np.concatenate(([0], holes.astype(np.int8), [0])))
    bands = np.column_stack((edges[np.flatnonzero(steps == 1)], edges[np.flatnonzero(steps == -1)]))
    if log_x:
        bands = np.log10(np.maximum(bands[bands[:, 1] > FINEST_DEG], FINEST_DEG))
    return [(low, high) for low, high in bands.tolist()]


def _short(lines: Lines, error: SliceError) -> str:
    size = (
        decimal(f"{100.0 * error.relative:.1f} %")
        if np.isfinite(error.relative)
        else f"{number(error.rms)} {UNIT}"
    )
    return tr("Fit: RMS {rms}, worst {worst} {unit} at {angle}").format(
        rms=size, worst=number(error.worst), unit=UNIT, angle=degrees(lines.cut.axis, error.worst_deg)
    )


def _value_range(lines: Lines, log_y: bool) -> tuple[float, float]:
    top = largest(lines.lines)
    if lines.signed:
        end = nice_above(top)
        return -end, end
    if not log_y:
        return 0.0, nice_above(1.02 * top)
    values = np.concatenate([line.value for line in lines.lines])
    least = values[(values > 0.0) & np.isfinite(values)]
    high = np.ceil(2.0 * np.log10(1.02 * top)) / 2.0
    low = np.floor(np.log10(least.min())) if least.size else high - _DECADES
    return float(max(low, high - _DECADES)), float(high)
