"""``brdf-suite palette``: convert palettes between common formats, describe and search them."""

from __future__ import annotations

import argparse
import math
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from brdf_suite.appearance.colour.flat_colours import display_notes, flat_labs, lab_to_hex
from brdf_suite.arrays import Floats
from brdf_suite.cli.arguments import (
    PAINT,
    PAINTS,
    add_cmyk_profile,
    add_format,
    add_json,
    add_output,
    whole_number,
)
from brdf_suite.cli.output import print_csv, print_done, print_json, print_notes
from brdf_suite.command_parser import CommandParser
from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.paint import Paint
from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.documents.palette_store import flat_to_json
from brdf_suite.errors import FileError
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
from brdf_suite.files.palettes.format import OWN, ReadPalette
from brdf_suite.paint_design.measured_start import load_paint_or_start
from brdf_suite.palettes.columns import MAIN_ANGLES_DEG, labs_of
from brdf_suite.palettes.nearest_entries import colours_of_material, nearest_entries
from brdf_suite.pipeline.material import document_kind, load_document, load_material, paints_of
from brdf_suite.regular_files import is_file

_MOST = 1000


def add_find(parts: argparse._SubParsersAction[CommandParser]) -> None:
    """Declare ``find`` among the parts of ``palette``."""
    find = parts.add_parser(
        "find",
        help="find the entries of a palette that are nearest to a paint",
        description="Compare a paint with every entry of a palette at 15, 45 and 110° (light at 45°) by ΔE00 and "
        "report the nearest. A flat colour is the same at every angle.",
    )
    find.examples = ("brdf-suite palette find blue --in summer.brdfpalette --count 5",)
    find.add_argument("paint", metavar="PAINT", help=PAINT)
    find.add_argument(
        "--in",
        dest="palette",
        metavar="PALETTE",
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
    add_cmyk_profile(find)
    add_json(find, csv=True)
    find.set_defaults(run=run_find)


def run_find(options: argparse.Namespace) -> int:
    """Search and print a table or a JSON object."""
    name, lab = _labs(options.paint, options.cmyk_profile)
    found = read_palette(options.palette, cmyk_profile=options.cmyk_profile)
    near = nearest_entries(found.palette, lab, options.count, options.combine)
    rows = [(one.entry, one.delta_e, one.per_angle) for one in near]
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
    if options.csv:
        print_csv(
            {
                "name": entry.name,
                "id": entry.id,
                "code": entry.code,
                "group": "/".join(entry.group),
                "delta_e_2000": difference,
                **{
                    f"delta_e_{angle:g}": value
                    for angle, value in zip(MAIN_ANGLES_DEG, per_angle, strict=True)
                },
            }
            for entry, difference, per_angle in rows
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


def _labs(name_or_path: str, profile: Path | None) -> tuple[str, Floats]:
    """Return the name and L*a*b* (3, 3) of what is looked for; an entry of a palette is seen through the profile."""
    document = load_document(name_or_path, cmyk_profile=profile)
    if document is not None:
        return document.name, labs_of(document)
    material = load_material(name_or_path)
    return material.name, colours_of_material(material)


_FORMATS = {known.name: known.endings for known in FORMATS if known.write is not None}
_SHOWN = 20


def add(command: CommandParser) -> None:
    """Declare the command and its parts."""
    command.description = (
        "Read palettes of every format that people have, known by their content: .brdfpalette, ASE, ACO, "
        "ACB, GPL, KPL, Scribus XML, SOC, PAL, ACT, SBZ, CxF3, CSS, SCSS, LESS, JSON, CSV and TSV in any usual "
        "columns, hex lists, CorelDRAW XML and CPL, AutoCAD, Sketch, Apple; and samples of multi-angle instruments in "
        "tables, XML and CxF3."
    )
    command.examples = ("brdf-suite palette convert ral.sbz -o ral.ase", "brdf-suite palette info ral.ase")
    parts = command.add_subparsers(dest="part", metavar="convert|info|find", required=True)
    convert = parts.add_parser(
        "convert",
        help="write a palette in another format",
        description="Read a palette, or take paints, and write a palette in the format of --format, or that the ending "
        "of FILE names. What that format cannot hold is reported; FILE is written whole or not at all.",
    )
    convert.examples = (
        "brdf-suite palette convert ral.sbz -o ral.ase",
        "brdf-suite palette convert blue copper -o two.cxf",
        "brdf-suite palette convert fleet.brdfpalette -o - --format gpl > fleet.gpl",
    )
    convert.add_argument("sources", metavar="PAINT|PALETTE", nargs="+", help=PAINTS)
    add_output(convert, "the file to write; also the last word without -o", stream=_ending, or_last=True)
    add_format(convert, _FORMATS)
    convert.add_argument(
        "--list-losses", action="store_true", help="list what the format cannot hold, and write nothing"
    )
    convert.add_argument(
        "--three-angles",
        action="store_true",
        help="write each paint as three colours, at 15, 45 and 110°: for formats of one colour an entry",
    )
    add_cmyk_profile(convert)
    add_json(convert)
    convert.set_defaults(run=run_convert)
    info = parts.add_parser(
        "info",
        help="describe a palette",
        description="Print a palette's format, groups and entries, each with its own numbers and what it looks like.",
    )
    info.examples = ("brdf-suite palette info ral.ase --csv > ral.csv",)
    info.add_argument("sources", metavar="PAINT|PALETTE", nargs="+", help=PAINTS)
    add_cmyk_profile(info)
    add_json(info, csv=True)
    info.set_defaults(run=run_info)
    add_find(parts)


def run_convert(options: argparse.Namespace) -> int:
    """Convert and print lines or a JSON object."""
    found = _read(options.sources, options.cmyk_profile)
    if options.format is None and options.output is None:
        options.parser.error("-o FILE or --format is missing")
    known = format_for(options.output) if options.format is None else find_format(options.format)
    palette = split_angles(found.palette) if options.three_angles else found.palette
    shown = _display_notes(palette)
    if options.list_losses:
        lost, size = losses(palette, known, options.output or ""), None
    else:
        written = write_palette(palette, options.output, known)
        lost, size = written.losses, written.size
    if options.json:
        print_json(
            {
                "input": " ".join(options.sources),
                "input_format": found.format.name,
                "output": None if size is None else str(options.output),
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
        print_done(f"{options.output}: {len(palette):,} entries, {known.title}, {size:,} bytes")
    return 0


def run_info(options: argparse.Namespace) -> int:
    """Print what is in a palette."""
    found = _read(options.sources, options.cmyk_profile)
    name = " ".join(options.sources)
    palette = found.palette
    notes = [*found.notes, *_display_notes(palette)]
    if options.json:
        print_json(
            {
                "file": name,
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
    if options.csv:
        print_csv(_entry_to_row(entry, shown) for entry, shown in zip(palette, _shown(palette), strict=True))
        return 0
    print(
        f"{name}: {palette.name}, {found.format.title}, {len(palette):,} entries, {len(palette.groups)} groups"
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


def _read(sources: Sequence[str], profile: Path | None) -> ReadPalette:
    """Return the palette of one file; of several, of a folder or of paints one made of all of their entries."""
    found = [_read_one(source, profile) for source in sources]
    if len(found) == 1:
        return found[0]
    entries = tuple(replace(entry, id="") for one in found for entry in one.palette)
    notes = tuple(dict.fromkeys(note for one in found for note in one.notes))
    return ReadPalette(Palette("Paints", entries), notes, OWN)


def _read_one(source: str, profile: Path | None) -> ReadPalette:
    no_palette: FileError | None = None
    if is_file(source) and document_kind(source) != "paint":
        try:
            return read_palette(source, cmyk_profile=profile)
        except FileError as error:
            no_palette = error
    try:
        paints = [load_paint_or_start(name) for name in paints_of(source)]
    except FileError:
        if no_palette is not None:
            raise no_palette from None
        raise
    return ReadPalette(Palette(paints[0].name, tuple(map(Entry, paints))), (), OWN)


def _ending(options: argparse.Namespace) -> str:
    if options.format is None:
        options.parser.error("with -o - give --format too")
    return _FORMATS[options.format][0]


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


def _entry_to_row(entry: Entry, shown: dict[str, object]) -> dict[str, object]:
    facts = _entry_to_json(entry, shown)
    lab = dict(zip("Lab", facts["lab"], strict=True)) if isinstance(facts["lab"], list) else {}
    texts = {name: facts[name] for name in ("name", "kind", "code", "usage", "notes", "hex")}
    return {**texts, "group": "/".join(entry.group), "tags": " ".join(entry.tags), **lab}


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
