"""``brdf-suite palette``: convert palettes between common formats, describe and search them."""

from __future__ import annotations

import argparse
import math
from pathlib import Path

import numpy as np

from brdf_suite.appearance.colour.colorimetry import working_to_lab
from brdf_suite.appearance.colour.flat_colours import display_notes, flat_labs, lab_to_hex
from brdf_suite.arrays import Floats
from brdf_suite.cli.output import print_json, print_notes, whole_number
from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.paint import Paint
from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.documents.palette_store import flat_to_json
from brdf_suite.files.palettes import (
    FORMATS,
    find_format,
    format_for,
    losses,
    read_palette,
    split_angles,
    write_palette,
)
from brdf_suite.files.palettes.conversions import face_lab
from brdf_suite.palettes.columns import MAIN_ANGLES_DEG, Columns, labs_of
from brdf_suite.palettes.search import nearest
from brdf_suite.palettes.swatches.look import colours_at
from brdf_suite.pipeline.material import load_document, load_material

_MOST = 1000


def add_find(parts: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
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
    find.add_argument(
        "--count", metavar="N", type=whole_number(1, _MOST), default=10, help="how many (default: 10)"
    )
    find.add_argument(
        "--combine",
        choices=("mean", "worst"),
        default="mean",
        help="what orders them: the mean of the angles' ΔE00, or the worst (default: mean)",
    )
    find.add_argument("--json", action="store_true", help="print one JSON object")
    find.set_defaults(run=run_find)


def run_find(options: argparse.Namespace) -> int:
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
    print_notes(found.notes)
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


_FORMATS = tuple(known.name for known in FORMATS if known.write is not None)
_SHOWN = 20


def add(command: argparse.ArgumentParser) -> None:
    """Declare the command and its parts."""
    command.description = (
        "Read palettes of every format that people have, known by their content: .brdfpalette, ASE, ACO, "
        "ACB, GPL, KPL, Scribus XML, SOC, PAL, ACT, SBZ, CxF3, CSS, JSON, CSV."
    )
    parts = command.add_subparsers(dest="part", metavar="PART", required=True)
    convert = parts.add_parser(
        "convert",
        help="write a palette in another format",
        description="Read a palette and write it in the format that the ending of OUT names. What that format cannot "
        "hold is reported; OUT is written whole or not at all.",
    )
    convert.add_argument("source", metavar="IN", type=Path, help="a palette of any format")
    convert.add_argument("target", metavar="OUT", type=Path, help="the file to write")
    convert.add_argument(
        "--format", choices=_FORMATS, help="the format (default: what the ending of OUT names)"
    )
    convert.add_argument(
        "--list-losses", action="store_true", help="list what the format cannot hold, and write nothing"
    )
    convert.add_argument(
        "--three-angles",
        action="store_true",
        help="write each paint as three colours, at 15, 45 and 110°: for formats of one colour an entry",
    )
    convert.add_argument("--json", action="store_true", help="print what was done as one JSON object")
    convert.set_defaults(run=run_convert)
    info = parts.add_parser(
        "info",
        help="describe a palette",
        description="Print a palette's format, groups and entries, each with its own numbers and what it looks like.",
    )
    info.add_argument("file", metavar="FILE", type=Path, help="a palette of any format")
    info.add_argument("--json", action="store_true", help="print everything as one JSON object")
    info.set_defaults(run=run_info)
    add_find(parts)


def run_convert(options: argparse.Namespace) -> int:
    """Convert and print lines or a JSON object."""
    found = read_palette(options.source)
    known = format_for(options.target) if options.format is None else find_format(options.format)
    palette = split_angles(found.palette) if options.three_angles else found.palette
    shown = _display_notes(palette)
    if options.list_losses:
        lost, size = losses(palette, known, options.target), None
    else:
        written = write_palette(palette, options.target, known)
        lost, size = written.losses, written.size
    if options.json:
        print_json(
            {
                "input": str(options.source),
                "input_format": found.format.name,
                "output": None if size is None else str(options.target),
                "output_format": known.name,
                "entries": len(palette),
                "bytes": size,
                "losses": list(lost),
                "notes": [*found.notes, *shown],
            }
        )
        return 0
    print_notes((*found.notes, *shown))
    print_notes(lost, "lost")
    if size is None:
        print(f"{known.title} would hold all of {len(palette):,} entries." if not lost else known.title)
    else:
        print(f"{options.target}: {len(palette):,} entries, {known.title}, {size:,} bytes")
    return 0


def run_info(options: argparse.Namespace) -> int:
    """Print what is in a palette."""
    found = read_palette(options.file)
    palette = found.palette
    notes = [*found.notes, *_display_notes(palette)]
    if options.json:
        print_json(
            {
                "file": str(options.file),
                "format": found.format.name,
                "name": palette.name,
                "notes": palette.notes,
                "colour": palette.colour,
                "columns": palette.columns,
                "groups": [
                    {"path": list(group.path), "notes": group.notes, "colour": group.colour}
                    for group in palette.groups
                ],
                "entries": [
                    _entry_to_json(entry, shown)
                    for entry, shown in zip(palette, _shown(palette), strict=True)
                ],
                "messages": notes,
            }
        )
        return 0
    print(
        f"{options.file}: {palette.name}, {found.format.title}, {len(palette):,} entries, {len(palette.groups)} groups"
    )
    print_notes(notes)
    left = _SHOWN
    for group, entries in palette.sections():
        if group is not None and left > 0:
            print(f"[{' / '.join(group.path)}]")
        for entry in entries[: max(left, 0)]:
            print(f"  {_line(entry)}")
        left -= len(entries)
    if left < 0:
        print(f"  … and {-left:,} more; --json prints all")
    return 0


def _display_notes(palette: Palette) -> tuple[str, ...]:
    return display_notes([entry.content for entry in palette if isinstance(entry.content, FlatColour)])


def _shown(palette: Palette) -> list[dict[str, object]]:
    """Return each entry's appearance: L*a*b* (D65, 10°) of its one angle, or of its measured angles."""
    flat = [entry.content for entry in palette if isinstance(entry.content, FlatColour)]
    labs = iter(flat_labs(flat).tolist())
    rows: list[dict[str, object]] = []
    for entry in palette:
        face = next(labs) if isinstance(entry.content, FlatColour) else list(face_lab(entry.content))
        row: dict[str, object] = {"lab": [round(value, 4) for value in face], "hex": lab_to_hex(face)}
        if isinstance(entry.content, Paint):
            row["readings"] = [
                {"illumination_deg": m.illumination_deg, "aspecular_deg": m.aspecular_deg, "lab": list(m.lab)}
                for m in entry.content.measurements
            ]
        rows.append(row)
    return rows


def _entry_to_json(entry: Entry, shown: dict[str, object]) -> dict[str, object]:
    content = entry.content
    kind = "flat" if isinstance(content, FlatColour) else type(content).__name__
    found: dict[str, object] = {
        "name": entry.name,
        "kind": {
            "flat": "flat",
            "Paint": "aspecular",
            "CookTorrancePaint": "cook_torrance",
            "FactoredPaint": "factored",
        }[kind],
        "group": list(entry.group),
        "code": entry.code,
        "tags": list(entry.tags),
        "notes": entry.notes,
        "usage": entry.usage,
        "date": entry.date,
    }
    if isinstance(content, FlatColour):
        found["flat"] = flat_to_json(content)
    return {**found, **shown}


def _line(entry: Entry) -> str:
    content = entry.content
    if isinstance(content, FlatColour):
        values = content.values if len(content.values) < 5 else content.values[:1]
        numbers = " ".join(f"{value:.4g}" for value in values) + (" …" if len(content.values) > 4 else "")
        kind = f"{content.model} {numbers}"
    elif isinstance(content, Paint):
        kind = "paint, " + ", ".join(f"{m.aspecular_deg:g}°" for m in content.measurements)
    else:
        kind = "paint, Cook-Torrance"
    code = f" ({entry.code})" if entry.code else ""
    usage = f", {entry.usage}" if entry.usage != "process" else ""
    return f"{entry.name or '(no name)'}{code}: {kind}{usage}"
