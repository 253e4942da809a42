"""The plots of a report, as strokes on a sheet that knows no file format: SVG and PDF draw the same ones.

Coordinates are points with y down, from the plot's upper left corner.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Literal

import numpy as np

from brdf_suite.appearance.colour.spaces import lab_to_lch
from brdf_suite.arrays import Floats
from brdf_suite.reports.paint_report.document import Report

Anchor = Literal["start", "middle", "end"]

INK, SOFT, GRID = "#1a1a1a", "#5c5c5c", "#d9d9d9"
STYLES: dict[str, tuple[str, float, tuple[float, ...]]] = {
    "paint": (INK, 1.4, ()),
    "fitted lobes": ("#0072b2", 1.0, (4.0, 2.0)),
    "standard": ("#d55e00", 1.2, (1.0, 2.0)),
}
"""Colour, width and dashes of each curve: distinguishable without colour, too."""

_GREY_CHROMA = 1.0
_LEFT, _RIGHT, _TOP, _BOTTOM = 26.0, 6.0, 14.0, 22.0
_TEXT = 6.5


@dataclass(frozen=True)
class PlotLine:
    """A line through points."""

    points: tuple[tuple[float, float], ...]
    colour: str
    width: float
    dashes: tuple[float, ...] = ()


@dataclass(frozen=True)
class Mark:
    """A reading: a filled circle; of the standard an open square."""

    x: float
    y: float
    colour: str
    filled: bool


@dataclass(frozen=True)
class Text:
    """A short text."""

    x: float
    y: float
    text: str
    size: float
    anchor: Anchor = "start"
    colour: str = SOFT
    bold: bool = False


Stroke = PlotLine | Mark | Text


@dataclass(frozen=True)
class Plot:
    """One plot: its size, its name for who cannot see it, and its strokes in the order of drawing."""

    width: float
    height: float
    title: str
    strokes: tuple[Stroke, ...]


def plots_of(report: Report, width: float, height: float) -> tuple[Plot, ...]:
    """Return L*, C* and h over the aspecular angle, each of this size."""
    return tuple(
        _plot(report, component, title, width, height)
        for component, title in enumerate(("Lightness L*", "Chroma C*", "Hue h, degrees"))
    )


def _plot(report: Report, component: int, title: str, width: float, height: float) -> Plot:
    around = None
    if component == 2:  # the direction in which the colours lie on the whole
        _, a, b = np.array([row.lab for row in report.rows]).sum(axis=0)
        around = float(np.degrees(np.arctan2(b, a))) % 360.0
    curves = [
        (curve.title, curve.angles_deg, _component(curve.lch, component, around)) for curve in report.curves
    ]
    own = [(row.geometry, np.array(row.lch)) for row in report.rows]
    others = [
        (row.geometry, lab_to_lch(row.standard.standard))
        for row in report.rows
        if row.standard is not None and row.standard.standard is not None
    ]
    marks = [
        (geometry.aspecular_deg, float(_component(lch[None], component, around)[0]), name)
        for name, group in (("standard", others), ("paint", own))
        for geometry, lch in group
        if geometry.illumination_deg == report.light_deg
    ]
    known = [value for _, _, values in curves for value in values[np.isfinite(values)].tolist()]
    known += [value for _, value, _ in marks if math.isfinite(value)]
    low, high = _range(known, component)
    first, last = float(report.curves[0].angles_deg[0]), float(report.curves[0].angles_deg[-1])

    def x_of(angle: float) -> float:
        return _LEFT + (width - _LEFT - _RIGHT) * (angle - first) / max(last - first, 1e-9)

    def y_of(value: float) -> float:
        return height - _BOTTOM - (height - _TOP - _BOTTOM) * (value - low) / (high - low)

    strokes: list[Stroke] = [Text(_LEFT, _TOP - 6.0, title, 7.5, colour=INK, bold=True)]
    strokes += _frame(x_of, y_of, low, high, [m.aspecular_deg for m in report.item.paint.measurements], width)
    for name, angles, values in reversed(curves):
        strokes += _curve(
            name, [(x_of(a), y_of(v)) for a, v in zip(angles.tolist(), values.tolist(), strict=True)]
        )
    strokes += [
        Mark(x_of(angle), y_of(value), STYLES[name][0], name == "paint")
        for angle, value, name in marks
        if math.isfinite(value)
    ]
    strokes.append(Text(width - _RIGHT, height - 3.0, "aspecular angle, degrees", _TEXT, "end"))
    return Plot(width, height, f"{title} over the aspecular angle", tuple(strokes))


def _frame(
    x_of: Callable[[float], float],
    y_of: Callable[[float], float],
    low: float,
    high: float,
    angles: list[float],
    width: float,
) -> list[Stroke]:
    strokes: list[Stroke] = []
    step = _step(high - low)
    for index in range(math.ceil(low / step - 1e-9), math.floor(high / step + 1e-9) + 1):
        y = y_of(index * step)
        strokes.append(PlotLine(((_LEFT, y), (width - _RIGHT, y)), GRID, 0.5))
        strokes.append(Text(_LEFT - 3.0, y + 2.2, f"{index * step:g}", _TEXT, "end"))
    bottom, last_x = y_of(low), -math.inf
    for angle in sorted(set(angles)):
        x = x_of(angle)
        if not _LEFT - 0.1 <= x <= width - _RIGHT + 0.1 or x - last_x < 13.0:
            continue
        last_x = x
        strokes.append(PlotLine(((x, bottom), (x, bottom + 2.5)), SOFT, 0.6))
        strokes.append(Text(x, bottom + 9.0, f"{angle:g}", _TEXT, "middle"))
    strokes.append(PlotLine(((_LEFT, bottom), (width - _RIGHT, bottom)), SOFT, 0.6))
    return strokes


def _curve(name: str, points: list[tuple[float, float]]) -> list[Stroke]:
    """A line for each run of points that can be drawn."""
    colour, width, dashes = STYLES[name]
    runs: list[list[tuple[float, float]]] = [[]]
    for point in points:
        if math.isfinite(point[1]):
            runs[-1].append(point)
        elif runs[-1]:
            runs.append([])
    return [PlotLine(tuple(run), colour, width, dashes) for run in runs if len(run) > 1]


def _component(lch: Floats, component: int, around: float | None) -> Floats:
    """One column; hue within half a turn of ``around``, and none where the colour is grey."""
    values = np.array(lch[:, component], float)
    if around is None:
        return values
    turned = (values - around + 180.0) % 360.0 - 180.0 + around
    return np.where(lch[:, 1] < _GREY_CHROMA, np.nan, turned)


def _range(values: list[float], component: int) -> tuple[float, float]:
    if not values:
        return 0.0, 360.0 if component == 2 else 100.0
    least = 10.0 if component else 20.0
    low, high = min(values), max(values)
    if high - low < least:
        middle = 0.5 * (low + high)
        low, high = middle - 0.5 * least, middle + 0.5 * least
    step = _step(high - low)
    low, high = step * math.floor(low / step - 0.2), step * math.ceil(high / step + 0.2)
    return (low, high) if component == 2 else (max(low, 0.0), high)


def _step(span: float) -> float:
    """A round step of which four or so fill ``span``."""
    rough = span / 4.0
    power = 10.0 ** math.floor(math.log10(rough))
    return next(power * nice for nice in (1.0, 2.0, 5.0, 10.0) if rough <= power * nice * 1.0001)
