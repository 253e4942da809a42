"""``brdf-suite design``: a paint from a measurement, as a variation, between two others, or with flakes by texture."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from brdf_suite.appearance.geometries import geometry_set
from brdf_suite.appearance.texture import LIGHTS_DEG
from brdf_suite.cli.arguments import PAINT, add_json, add_output
from brdf_suite.cli.measured.measure import GEOMETRY_HELP
from brdf_suite.cli.output import print_json, print_notes, progress_bar
from brdf_suite.command_parser import CommandParser
from brdf_suite.documents.paint import SCATTERINGS, Paint, TextureTargets
from brdf_suite.documents.store import PAINT_ENDING, paint_to_json, save_paint
from brdf_suite.errors import SuiteError
from brdf_suite.inspection.texture.inverse import SCALES, find_flakes
from brdf_suite.inspection.texture.readings import paint_light
from brdf_suite.paint_design.measured_start import load_paint_or_start, load_start
from brdf_suite.paint_design.mix import mixed, second_end
from brdf_suite.paint_design.standard_files import load_standards
from brdf_suite.paint_design.variations import DIRECTIONS, examined, variations
from brdf_suite.pipeline.lobe_fit import PATIENT_TIME_LIMIT_S, PaintFitter, fit_material
from brdf_suite.pipeline.material import material_of
from brdf_suite.reflectance.instruments.spectrophotometer import support_notice


def add(command: CommandParser) -> None:
    """Declare the command and its own commands."""
    command.description = (
        "Make a paint: from a measurement, a step away from another, between two, or with flakes."
    )
    command.examples = (
        "brdf-suite design start paint.brdf -o paint.brdfpaint",
        "brdf-suite design step --help",
    )
    kinds = command.add_subparsers(dest="kind", metavar="start|step|between|flakes", required=True)
    start = kinds.add_parser(
        "start",
        help="from anything that reflects, read by the virtual instruments",
        description="Read colours and gloss, write the paint, and report how far it is from the original at angles "
        "that were not read.",
    )
    start.examples = ("brdf-suite design start paint.brdf -o paint.brdfpaint",)
    start.add_argument("what", metavar="PAINT", help=PAINT)
    start.add_argument(
        "--geometry", default="e2194", metavar="NAME", help=GEOMETRY_HELP.replace(": six)", ": e2194)")
    )
    start.set_defaults(run=run_start)
    step = kinds.add_parser("step", help="a step away from a paint: lighter, cleaner, with more flop …")
    step.examples = ("brdf-suite design step blue lighter --step 3 -o lighter.brdfpaint",)
    step.add_argument("what", metavar="PAINT", help=PAINT)
    step.add_argument("direction", choices=DIRECTIONS, metavar="DIRECTION", help=", ".join(DIRECTIONS))
    step.add_argument(
        "--step",
        type=float,
        default=2.0,
        metavar="UNITS",
        help="ΔL*, ΔC* or ΔH* (default: 2); flakes have a factor of their own",
    )
    step.set_defaults(run=run_step)
    between = kinds.add_parser("between", help="between two paints, or a little beyond them")
    between.examples = ("brdf-suite design between blue copper --share 0.3 -o mixed.brdfpaint",)
    between.add_argument("first", metavar="FIRST-PAINT", help=PAINT)
    between.add_argument("second", metavar="SECOND-PAINT", help="likewise")
    between.add_argument(
        "--share",
        type=float,
        default=0.5,
        metavar="S",
        help="0 is the first, 1 the second; -0.5 to 1.5 (default: 0.5)",
    )
    between.set_defaults(run=run_between)
    flakes = kinds.add_parser(
        "flakes",
        help="with flakes whose sparkle and graininess are wanted",
        description="Look for density, size and roughness of flakes that have the readings of the texture instrument; "
        "the colours stay. What cannot be reached is said, with the nearest.",
    )
    flakes.examples = ("brdf-suite design flakes blue --sparkle 45=20 --graininess 3 -o flaked.brdfpaint",)
    flakes.add_argument("what", metavar="PAINT", help=PAINT)
    flakes.add_argument(
        "--sparkle",
        action="append",
        default=[],
        type=_grade,
        metavar="LIGHT=PERCENT",
        help="the grade under light from 15, 45 or 75°, as in 45=80; once for each",
    )
    flakes.add_argument("--graininess", type=float, metavar="PERCENT", help="in diffuse light")
    flakes.set_defaults(run=run_flakes)
    for kind in (start, step, between, flakes):
        add_output(kind, "the .brdfpaint file to write", stream=PAINT_ENDING, required=False)
        kind.add_argument(
            "--scattering",
            choices=SCATTERINGS,
            help="whether light that meets several facets of the paint's coat counts (multiple) or is lost, as papers "
            "have it (single); default: as it was",
        )
        add_json(kind)


def run_start(options: argparse.Namespace) -> int:
    """Read, write, and print the report."""
    geometry = geometry_set(options.geometry)
    _check_output(options.output)
    with progress_bar("measuring", quiet=options.json) as progress:
        start = load_start(options.what, geometry, progress)
    facts: dict[str, object] = {
        "gloss_read": {f"gu_{angle}": value for angle, value in start.gloss.readings.items()},
        "gloss_used": start.gloss_used,
        "nearest_sample_deg": {reading.geometry.name: reading.sample_deg for reading in start.readings},
        "held_out": [
            {
                "illumination_deg": row.illumination_deg,
                "aspecular_deg": row.aspecular_deg,
                "lab_original": list(row.original),
                "lab_design": list(row.design),
                "delta_e_2000": row.delta_e_2000,
                "nearest_sample_deg": row.sample_deg,
            }
            for row in start.held_out
        ],
        "delta_e_2000_mean": start.mean_delta_e,
        "delta_e_2000_worst": None if start.worst is None else start.worst.delta_e_2000,
        "notices": list(start.notices),
    }
    lines = [*support_notice((reading.geometry, reading.sample_deg) for reading in start.readings)]
    if start.worst is not None:
        lines.append(
            f"ΔE00 to the original at {len(start.held_out)} angles that were not read: mean "
            f"{start.mean_delta_e:.2f}, at most {start.worst.delta_e_2000:.2f} ({start.worst.aspecular_deg:g}°, light "
            f"{start.worst.illumination_deg:g}°)"
        )
    return _done(
        _scattering(start.paint, options),
        options,
        facts,
        lines,
        start.notices,
    )


def run_step(options: argparse.Namespace) -> int:
    """Take a step, write, and print."""
    _check_output(options.output)
    found = {one.direction: one for one in variations(_design(options.what, options), options.step)}
    fitter = PaintFitter(time_limit_s=PATIENT_TIME_LIMIT_S)
    try:
        one = examined(found[options.direction], fitter)
    finally:
        fitter.close()
    if one.paint is None:
        raise SuiteError(
            f"{options.what}: there is no neighbour that is {one.word} by this step: {one.reason}"
        )
    lines = [f"{one.word}; the lobes give it within ΔE00 {one.missed:.2f}"]
    return _done(one.paint, options, {"word": one.word, "delta_e_2000_missed": one.missed}, lines)


def run_between(options: argparse.Namespace) -> int:
    """Mix, write, and print."""
    _check_output(options.output)
    first = _design(options.first, options)
    second = second_end(first, load_standards(options.second)[0])
    return _done(mixed(first, second, options.share), options, {"share": options.share}, [])


def run_flakes(options: argparse.Namespace) -> int:
    """Find flakes, write, and print."""
    _check_output(options.output)
    grades = dict(options.sparkle)
    if len(grades) < len(options.sparkle):
        raise SuiteError("--sparkle: each light can be named once.")
    wanted = [grades.get(light) for light in LIGHTS_DEG]
    wanted.append(None if options.graininess is None else options.graininess / 100.0)
    paint = _design(options.what, options)
    if all(value is None for value in wanted):
        if paint.texture is None:
            raise SuiteError(
                "Name at least one reading: --sparkle LIGHT=PERCENT or --graininess PERCENT; the paint has no targets."
            )
        wanted = list(paint.texture.wanted)
    fit = fit_material(material_of(paint, options.what))
    with progress_bar("flakes", quiet=options.json) as progress:
        found = find_flakes(paint_light(fit.weights), wanted, paint.flakes, progress)
    flakes = found.flakes
    lines = [
        f"flakes: {flakes.density_per_mm2:g} /mm², {flakes.size_um:g} µm, roughness {flakes.roughness:g}",
        "expected: "
        + ", ".join(
            f"{name} {100.0 * value:.3g} %" for name, value in zip(SCALES, found.scales, strict=True)
        ),
    ]
    notes = () if found.reached else (found.sentence(),)
    facts: dict[str, object] = {
        "reached": found.reached,
        "expected": dict(zip(SCALES, found.scales, strict=True)),
        "relative_errors": dict(zip(SCALES, found.errors, strict=True)),
    }
    return _done(
        replace(paint, flakes=flakes, texture=TextureTargets.of(wanted)), options, facts, lines, notes
    )


def _grade(text: str) -> tuple[float, float]:
    light, _, value = text.partition("=")
    try:
        found = float(light), float(value) / 100.0
    except ValueError:
        raise argparse.ArgumentTypeError(f"expected LIGHT=PERCENT, as in 45=80, not {text!r}") from None
    if found[0] not in LIGHTS_DEG:
        lights = ", ".join(f"{one:g}" for one in LIGHTS_DEG)
        raise argparse.ArgumentTypeError(f"the light comes from one of {lights}°, not {light}°")
    return found


def _design(name_or_path: str, options: argparse.Namespace) -> Paint:
    """Return the designed paint of a name or file, its coat scattering as the options ask for.

    Of anything else it is the design that is started from its readings.
    """
    found = load_paint_or_start(name_or_path)
    return _scattering(found if isinstance(found, Paint) else load_start(name_or_path).paint, options)


def _scattering(paint: Paint, options: argparse.Namespace) -> Paint:
    return paint if options.scattering is None else replace(paint, scattering=options.scattering)


def _check_output(path: Path | None) -> None:
    if path is not None and path.suffix.lower() != PAINT_ENDING:
        raise SuiteError(f"{path}: a paint is written to a file that ends in {PAINT_ENDING}.")


def _done(
    paint: Paint,
    options: argparse.Namespace,
    facts: dict[str, object],
    lines: list[str],
    notes: Sequence[str] = (),
) -> int:
    if options.output is not None:
        save_paint(paint, options.output)
    if options.json:
        written = None if options.output is None else str(options.output)
        print_json({"paint": paint_to_json(paint), "output": written, **facts})
        return 0
    print_notes(notes)
    print(paint.name if options.output is None else f"{options.output}: {paint.name}")
    for m in paint.measurements:
        light = "" if m.illumination_deg == 45.0 else f", light {m.illumination_deg:g}°"
        print(f"{m.aspecular_deg:8g}°{light}  L*a*b* " + " ".join(f"{value:7.2f}" for value in m.lab))
    gloss = f"{paint.gloss.gu_20:g} GU at 20°"
    if paint.gloss.gu_60 is not None:
        gloss += f", {paint.gloss.gu_60:g} GU at 60°"
    print(f"  gloss: {gloss}")
    for line in lines:
        print(f"  {line}")
    return 0
