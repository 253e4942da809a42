"""Figures of several reflectances as one table: text to be pasted, CSV to be kept.

A row is a figure, a column a reflectance. Numbers are written with enough digits to be compared, with a decimal point
in every language; what is not there is left empty.
"""

from __future__ import annotations

import csv
import io
import math
import os
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

from brdf_suite.documents.atomic import write_atomically
from brdf_suite.foreign_text import guard_formula

if TYPE_CHECKING:  # the windows write figures, and only then measure
    from brdf_suite.inspection.figures.figures import ReflectanceFigures

_CHANNELS = ("red", "green", "blue")

Named = tuple[str, "ReflectanceFigures"]
Group = Literal["overview", "albedo", "colours", "errors"]
GROUPS: tuple[Group, ...] = ("overview", "albedo", "colours", "errors")


@dataclass(frozen=True)
class FigureRow:
    """One figure: what it is, its unit, and its value for each reflectance, None where it has none."""

    group: Group
    name: str
    unit: str
    values: tuple[float | None, ...]


def figure_rows(named: Sequence[Named]) -> tuple[FigureRow, ...]:
    """Return every figure of the reflectances, group by group; all must have the same geometries."""
    figures = [item for _, item in named]
    if not figures:
        return ()
    rows: list[FigureRow] = []

    def add(group: Group, name: str, unit: str, values: Iterable[float | None]) -> None:
        kept = (None if value is None or not math.isfinite(value) else float(value) for value in values)
        rows.append(FigureRow(group, name, unit, tuple(kept)))

    for c, channel in enumerate(_CHANNELS):
        add("overview", f"hemispherical albedo, {channel}", "", [f.curve.hemispherical[c] for f in figures])
    add("overview", "largest albedo of a channel", "", [f.curve.largest[0] for f in figures])
    add("overview", "its incidence", "°", [f.curve.largest[1] for f in figures])
    add("overview", "reciprocity error, worst", "", [f.reciprocity.worst for f in figures])
    add("overview", "reciprocity error, median", "", [f.reciprocity.typical for f in figures])
    add("overview", "directions without a number", "", [f.missing for f in figures])
    for k, incidence in enumerate(figures[0].curve.incidence_deg):
        add("albedo", f"albedo at {incidence:g}°", "", [f.curve.luminous[k] for f in figures])
        for c, channel in enumerate(_CHANNELS):
            add("albedo", f"albedo at {incidence:g}°, {channel}", "", [f.curve.albedo[k, c] for f in figures])
    for k, geometry in enumerate(g.name for g in figures[0].geometry_set.geometries):
        readings = [f.readings[k] for f in figures]
        for c, quantity in enumerate(("L*", "a*", "b*")):
            add("colours", f"{quantity} {geometry}", "", [r.lab and r.lab[c] for r in readings])
        add("colours", f"ΔE00 of the fit {geometry}", "", [reading.delta_e_fit for reading in readings])
        add(
            "colours",
            f"ΔE00 to the reference {geometry}",
            "",
            [reading.delta_e_reference for reading in readings],
        )
    for title, errors in (
        ("fit", [f.fit for f in figures]),
        ("difference", [f.reference for f in figures]),
    ):
        for where, sets in (
            ("", [None if e is None else e.whole for e in errors]),
            (", away from the mirror", [None if e is None else e.away for e in errors]),
        ):
            for name, unit, field in _ERRORS:
                add("errors", f"{title}, {name}{where}", unit, [getattr(one, field, None) for one in sets])
    return tuple(row for row in rows if any(value is not None for value in row.values))


def figures_text(named: Sequence[Named], groups: Sequence[Group] = GROUPS) -> str:
    """Return the table, or some groups of it, as lines with tabs between the columns, so that sheets take it."""
    # A tab or a line feed in a name would begin another cell.
    lines = [["", "unit", *(guard_formula(" ".join(name.split())) for name, _ in named)]]
    lines += [
        [row.name, row.unit, *map(_number, row.values)] for row in figure_rows(named) if row.group in groups
    ]
    return "\n".join("\t".join(line) for line in lines) + "\n"


def figures_csv(named: Sequence[Named]) -> str:
    """Return the table as CSV (RFC 4180): a line of titles, then a line per figure."""
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\r\n")
    writer.writerow(["figure", "unit", *(guard_formula(name) for name, _ in named)])
    for row in figure_rows(named):
        writer.writerow([row.name, row.unit, *map(_number, row.values)])
    return out.getvalue()


def save_figures(named: Sequence[Named], path: str | os.PathLike[str]) -> None:
    """Write the CSV, whole or not at all; raise :class:`~brdf_suite.errors.FileError` where that fails."""
    write_atomically(path, figures_csv(named).encode("utf-8"))


_ERRORS = (
    ("worst", "1/sr", "worst"),
    ("root mean square", "1/sr", "rms"),
    ("relative root mean square", "", "relative_rms"),
    ("root mean square of cube roots", "", "cube_root_rms"),
)


def _number(value: float | None) -> str:
    return "" if value is None else f"{value:.6g}"
