"""The curves as they are drawn, as comma-separated values."""

from __future__ import annotations

import numpy as np
from brdf_qt.program.translation import tr

from brdf_lobe_visualizer.cuts.lines import Line, Lines
from brdf_suite.geometry.directions import Floats
from brdf_suite.inspection.slices.text import slices_csv


def csv_of(lines: Lines, angle: str, quantity: str, incidence_deg: tuple[float, float]) -> str:
    """Return the lines over their angle; ``angle`` and ``quantity`` name columns, with their units."""
    columns: list[tuple[str, Floats]] = []
    for line in lines.lines:
        columns.append((f"{_name(line)}: {quantity}", line.value))
        if line.filled is not None and line.filled.any():
            measured = np.where(line.filled, 0.0, 1.0)
            columns.append((tr("{name}: measured (1) or filled in (0)").format(name=line.title), measured))
    theta, phi = incidence_deg
    told = tr("Lobe Visualizer, incidence {theta}°, azimuth {phi}°").format(
        theta=f"{theta:g}", phi=f"{phi:g}"
    )
    return slices_csv(angle, lines.cut.angle_deg, columns, told)


def _name(line: Line) -> str:
    if line.kind == "fit":
        return tr("{name}, fit").format(name=line.title)
    if line.kind == "difference":
        return tr("{name}, difference").format(name=line.title)
    return line.title
