"""``brdf-suite palette find PAINT --in FILE``: the palette entries nearest to a paint."""

from __future__ import annotations

import argparse
import math
from pathlib import Path

import numpy as np

from brdf_suite.appearance.colour.colorimetry import working_to_lab
from brdf_suite.arrays import Floats
from brdf_suite.cli.output import print_json
from brdf_suite.files.palettes import read_palette
from brdf_suite.palettes.columns import MAIN_ANGLES_DEG, Columns, labs_of
from brdf_suite.palettes.search import nearest
from brdf_suite.palettes.swatches.look import colours_at
from brdf_suite.pipeline.material import load_document, load_material

_MOST = 1000


def add(parts: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Declare ``find`` among the parts of ``palette``."""
    find = parts.add_parser(
        "find",
        help="find the entries of a palette that are nearest to a paint",
        description="Compare a paint with every entry of a palette at 15, 45 and 110° (light at 45°) by ΔE00 and "
        "report the nearest. A flat colour is the same at every angle.",
    )
    find.add_argument("paint", metavar="PAINT", help="a shipped paint, a paint's file, or a measured file")
    find.add_argument(
        "--in",
        dest="palette",
        metavar="FILE",
        type=Path,
        required=True,
        help="the palette, of any format that palette info reads",
    )
    find.add_argument("--count", metavar="N", type=_count, default=10, help="how many (default: 10)")
    find.add_argument(
        "--combine",
        choices=("mean", "worst"),
        default="mean",
        help="what orders them: the mean of the angles' ΔE00, or the worst (default: mean)",
    )
    find.add_argument("--json", action="store_true", help="print one JSON object")
    find.set_defaults(run=run)


def _count(text: str) -> int:
    if not text.isdecimal() or not 1 <= int(text) <= _MOST:
        raise argparse.ArgumentTypeError(f"expected a whole number from 1 to {_MOST:,}, not {text!r}")
    return int(text)


def run(options: argparse.Namespace) -> int:
    """Search and print a table or a JSON object."""
    name, lab = _labs(options.paint)
    found = read_palette(options.palette)
    columns = Columns.of(found.palette.entries)
    result = nearest(columns, lab, options.count, options.combine)
    rows = [
        (found.palette.entries[place], float(difference), per_angle.tolist())
        for place, difference, per_angle in zip(
            result.indices.tolist(), result.delta_e, result.per_angle, strict=True
        )
    ]
    if options.json:
        print_json(
            {
                "paint": name,
                "lab": {
                    f"{angle:g}": row if all(map(math.isfinite, row)) else None
                    for angle, row in zip(MAIN_ANGLES_DEG, lab.tolist(), strict=True)
                },
                "file": str(options.palette),
                "palette": found.palette.name,
                "entries": len(found.palette),
                "combine": options.combine,
                "found": [
                    {
                        "name": entry.name,
                        "id": entry.id,
                        "code": entry.code,
                        "group": list(entry.group),
                        "delta_e_2000": difference,
                        "per_angle": {
                            f"{angle:g}": value if math.isfinite(value) else None
                            for angle, value in zip(MAIN_ANGLES_DEG, per_angle, strict=True)
                        },
                    }
                    for entry, difference, per_angle in rows
                ],
                "messages": list(found.notes),
            }
        )
        return 0
    for note in found.notes:
        print(f"note: {note}")
    print(
        f"{name}: nearest of {len(found.palette):,} entries in {found.palette.name}, ΔE00 ({options.combine})"
    )
    print(f"{'ΔE00':>8}" + "".join(f"{f'{angle:g}°':>8}" for angle in MAIN_ANGLES_DEG) + "  entry")
    for entry, difference, per_angle in rows:
        where = f"  [{' / '.join(entry.group)}]" if entry.group else ""
        code = f" ({entry.code})" if entry.code else ""
        numbers = "".join(f"{value:8.2f}" for value in (difference, *per_angle))
        print(f"{numbers}  {entry.name or '(no name)'}{code}{where}")
    return 0


def _labs(name_or_path: str) -> tuple[str, Floats]:
    """The name and L*a*b* (3, 3) of what is looked for."""
    document = load_document(name_or_path)
    if document is not None:
        return document.name, labs_of(document)
    material = load_material(name_or_path)
    return material.name, working_to_lab(colours_at(material.reflectance, np.array(MAIN_ANGLES_DEG)))
