"""``brdf-suite measure PAINT|PALETTE…``: readings of a virtual multi-angle spectrophotometer and glossmeter."""

from __future__ import annotations

import argparse
import csv
import sys
from itertools import chain
from pathlib import Path
from typing import NamedTuple

from brdf_suite.appearance.geometries import geometry_set
from brdf_suite.appearance.light.colour import ColourUnderLight
from brdf_suite.appearance.texture import NO_TEXTURE, TextureReadings
from brdf_suite.cli.arguments import PAINTS, add_arguments, add_json
from brdf_suite.cli.output import print_json, print_notes
from brdf_suite.command_parser import CommandParser
from brdf_suite.foreign_text import guard_formula
from brdf_suite.inspection.measuring import measured_row, measurement_json, read_material
from brdf_suite.pipeline.material import Material, load_material, paints_of
from brdf_suite.reflectance.instruments.aperture import aperture
from brdf_suite.reflectance.instruments.spectrophotometer import SUPPORT_DEG, InstrumentReport
from brdf_suite.reflectance.instruments.under_light import readings_under

GEOMETRY_HELP = (
    "e2194 (15, 45, 110°), five, six, e2539, or your own: LIGHT:ANGLE,ANGLE[;LIGHT:…] in degrees, as in "
    "45:15,45,110 (default: six)"
)
APERTURE_HELP = (
    "half-angle of the receptor's cone in degrees, or LIGHT,RECEPTOR, or point (0,0), narrow (1,2), wide (2,4) "
    "(default: point)"
)
# The chroma C* below which a hue is rounding alone.
_GREY = 0.005


def add(command: CommandParser) -> None:
    """Declare the command."""
    command.description = (
        "Read anything that reflects with a virtual multi-angle spectrophotometer (D65, 10° observer) "
        "and glossmeter (20, 60, 85°), and the sparkle and graininess of its flakes with a texture instrument of the "
        "suite's own scale (docs/method/texture.md). Of scattered samples the angle to the nearest one is printed "
        f"beside each reading; a reading without a sample within {SUPPORT_DEG:g}° has a star, as has a gloss without "
        "a sample in the receptor."
    )
    command.examples = (
        "brdf-suite measure blue copper --csv > readings.csv",
        "cat paint.cxf | brdf-suite measure - --geometry e2194",
    )
    add_arguments(command, {"sources PAINT|PALETTE...": PAINTS})
    add_instrument(command)
    command.add_argument(
        "--solve",
        action="store_true",
        help="take a designed paint's own colours as read through the aperture, and solve it so",
    )
    command.add_argument(
        "--illuminant",
        choices=("D65", "A", "F11"),
        default="D65",
        help="also the colours under A or F11 (TL84-like): recomputed from spectra where they are known, else adapted",
    )
    add_no_texture(command)
    add_json(command, csv=True)
    command.set_defaults(run=run)


def add_no_texture(command: CommandParser) -> None:
    """Declare ``--no-texture``."""
    command.add_argument(
        "--no-texture",
        action="store_false",
        dest="texture",
        help="do not read sparkle and graininess, which take most of the time of a paint with flakes",
    )


def add_instrument(command: CommandParser) -> None:
    """Declare the options of the virtual instrument."""
    instrument = command.add_argument_group("instrument")
    instrument.add_argument("--geometry", default="six", metavar="NAME", help=GEOMETRY_HELP)
    instrument.add_argument("--aperture", default="point", metavar="DEG", help=APERTURE_HELP)
    instrument.add_argument(
        "--observer",
        type=int,
        choices=(2, 10),
        default=10,
        help="the observer through which a measured file's spectra become colour (default: 10)",
    )


def run(options: argparse.Namespace) -> int:
    """Measure and print."""
    geometries, through = geometry_set(options.geometry), aperture(options.aperture)
    measured: list[_Measured] = []
    for what in chain.from_iterable(map(paints_of, options.sources)):
        item = load_material(
            what, observer_deg=options.observer, solved_through=through if options.solve else None
        )
        measured.append(_Measured(item, read_material(item, geometries, through, texture=options.texture)))
    if options.json:
        answers = [measurement_json(one.item, one.report, options.illuminant) for one in measured]
        print_json(answers[0] if len(answers) == 1 else {"paints": answers})
    elif options.csv:
        _print_csv(measured, options.illuminant)
    else:
        for one in measured:
            _print_table(one.item, one.report, options.illuminant)
    return 0


class _Measured(NamedTuple):
    item: Material
    report: InstrumentReport


def _under(item: Material, report: InstrumentReport, illuminant: str) -> tuple[ColourUnderLight, ...]:
    return readings_under(item.reflectance, report, illuminant, item.observer_deg)


def _print_table(item: Material, report: InstrumentReport, illuminant: str) -> None:
    # Two paints may share a name, as the shipped blue and that of Table 1 do.
    plain = Path(item.origin).name.replace("_", " ").lower()
    named = "" if plain in ("", item.name.replace("_", " ").lower()) else f" ({item.origin})"
    print(f"{item.name}{named}: {report.geometry_set.title}; {report.aperture.title}; D65, 10°")
    sampled = any(report.gloss_sample_deg.values())
    print(
        f"{'geometry':>10} {'L*':>8} {'a*':>8} {'b*':>8} {'C*':>8} {'h °':>7} {'X':>8} {'Y':>8} {'Z':>8}  factor"
        + ("  nearest sample" if sampled else "")
    )
    for reading in report.readings:
        # Adding 0 turns the -0 of a grey into 0.
        numbers = "".join(f" {round(value, 2) + 0.0:8.2f}" for value in (*reading.lab, reading.lch[1]))
        tristimulus = "".join(f" {value:8.3f}" for value in reading.xyz)
        hue = f"{reading.lch[2]:7.1f}" if reading.lch[1] >= _GREY else f"{'–':>7}"
        support = f" {reading.sample_deg:14.1f}°{'' if reading.supported else '*'}" if sampled else ""
        print(f"{reading.geometry.name:>10}{numbers} {hue}{tristimulus} {reading.factor:7.4f}{support}")
    gloss = ", ".join(
        f"{value:.1f}{'' if report.gloss_supported(angle) else '*'} at {angle}°"
        for angle, value in report.gloss.items()
    )
    print(f"  gloss (GU, coat and base): {gloss}; haze {report.haze:.1f}")
    if report.texture is not None:
        _print_texture(report.texture)
    if report.flop is not None:
        print(f"  flop index: {report.flop.value:.2f}")
    if report.travel is not None:
        path = report.travel
        print(
            f"  travel, 15 to 110°: {path.length:.1f} in a*b*; hue {path.hue_deg:+.1f}° "
            f"(path {path.hue_path_deg:.1f}°); chroma {path.chroma:+.1f}"
        )
    if illuminant != "D65":
        colours = _under(item, report, illuminant)
        print(f"  {colours[0].label}")
        for reading, colour in zip(report.readings, colours, strict=True):
            print(f"{reading.geometry.name:>10}" + "".join(f" {value:8.2f}" for value in colour.lab.tolist()))
    print_notes((*item.notices, *report.notices))


def _print_texture(texture: TextureReadings) -> None:
    if texture == NO_TEXTURE:
        print("  texture: none, it has no flakes")
        return
    print("  texture        points/mm²   area %  intensity  grade %")
    for one in texture.sparkle:
        print(
            f"    sparkle {one.light_deg:2g}° {one.points_per_mm2:12.3f} {100.0 * one.area:8.2f} "
            f"{one.intensity:10.2f} {100.0 * one.grade:8.1f}"
        )
    print(f"    graininess {100.0 * texture.graininess:.2f} %")


def _print_csv(measured: list[_Measured], illuminant: str) -> None:
    rows = [measured_row(one.item, one.report, illuminant) for one in measured]
    writer = csv.DictWriter(sys.stdout, list(rows[0]), lineterminator="\n")
    writer.writeheader()
    for row in rows:
        writer.writerow({key: guard_formula(v) if isinstance(v, str) else v for key, v in row.items()})
