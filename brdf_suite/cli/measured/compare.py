"""``brdf-suite compare REFERENCE SAMPLE``: differences of two reflectances, per angle and over all directions."""

from __future__ import annotations

import argparse

from brdf_suite.appearance.difference.tolerance import difference_title
from brdf_suite.appearance.geometries import geometry_set
from brdf_suite.cli.arguments import PAINT, add_arguments, add_json
from brdf_suite.cli.measured.measure import add_instrument
from brdf_suite.cli.output import print_csv, print_json, print_notes
from brdf_suite.cli.paint.tolerances import add_tolerances, parse_tolerances, verdict_text
from brdf_suite.command_parser import CommandParser
from brdf_suite.inspection.measuring import compare
from brdf_suite.pipeline.material import load_material
from brdf_suite.reflectance.instruments.aperture import aperture
from brdf_suite.reflectance.instruments.spectrophotometer import support_notice


def add(command: CommandParser) -> None:
    """Declare the command."""
    command.description = (
        "Compare a sample with a reference. With tolerances the exit status is 1 where the sample fails."
    )
    command.examples = (
        "brdf-suite compare blue batch.cxf --tolerance 1.5",
        "brdf-suite compare blue copper --csv > differences.csv",
    )
    add_arguments(
        command,
        {"reference REFERENCE-PAINT": PAINT, "sample SAMPLE-PAINT": "likewise"},
    )
    add_instrument(command)
    add_tolerances(command)
    add_json(command, csv=True)
    command.set_defaults(run=run)


_SHORT = {"cmc21": "CMC 2:1", "cmc11": "CMC 1:1", "cam02ucs": "CAM02"}


def run(options: argparse.Namespace) -> int:
    """Compare and print; 1 where a tolerance is exceeded."""
    geometry = geometry_set(options.geometry)
    tolerances = parse_tolerances(options, [one.aspecular_deg for one in geometry.geometries])
    first, second = (
        load_material(what, observer_deg=options.observer) for what in (options.reference, options.sample)
    )
    result = compare(first, second, geometry, aperture(options.aperture), tolerances)
    failed = result.verdict is not None and result.verdict.passes is False
    if options.json:
        notices = {"a": list(first.notices), "b": list(second.notices)}
        print_json({"a": first.name, "b": second.name, **result.to_json(), "notices": notices})
        return 1 if failed else 0
    if options.csv:
        print_csv(
            {
                "geometry": reading.geometry.name,
                **{name: values[k] for name, values in result.differences.items()},
                "passes": "" if result.verdict is None else result.verdict.angles[k].passes,
            }
            for k, reading in enumerate(result.first.readings)
        )
        return 1 if failed else 0
    names = [first.name, second.name]
    if names[0] == names[1]:  # two paints of one name, or one paint twice: the typed names distinguish them
        names = [
            f"{name} ({typed})"
            for name, typed in zip(names, (options.reference, options.sample), strict=True)
        ]
    print(f"{names[1]} against {names[0]}: {result.first.geometry_set.title}; {result.first.aperture.title}")
    titles = [_SHORT.get(name) or difference_title(name) for name in result.differences]
    columns = "".join(f" {title:>{max(8, len(title))}}" for title in titles)
    print(f"{'geometry':>10}{columns}" + ("  verdict" if result.verdict else ""))
    for k, reading in enumerate(result.first.readings):
        numbers = "".join(
            f" {values[k]:{max(8, len(title))}.3f}"
            for title, values in zip(titles, result.differences.values(), strict=True)
        )
        row = None if result.verdict is None else result.verdict.angles[k]
        verdict = "" if row is None or row.passes is None else f"  {verdict_text(row)}"
        mark = "" if reading.supported and result.second.readings[k].supported else "  *"
        print(f"{reading.geometry.name:>10}{numbers}{verdict}{mark}")
    print(f"  in words: {result.sentence}")
    gloss = ", ".join(
        f"{value:.1f} and {result.second.gloss[angle]:.1f} at {angle}°"
        for angle, value in result.first.gloss.items()
    )
    print(f"  gloss (GU): {gloss}")
    for title, figures in (("all directions", result.figures), ("5° off the mirror", result.away)):
        print(
            f"  {title:>18}: cosine RMS {figures.cosine_rms:.5g} 1/sr, cube-root RMS {figures.cube_root_rms:.5g}, "
            f"log error {figures.log_rms:.5g}"
        )
    for light, values in (result.metamerism or {}).items():
        print(f"  metamerism index, D65 to {light}: " + ", ".join(f"{value:.2f}" for value in values))
    for measurable, name, readings in zip(
        (first, second), names, (result.first.readings, result.second.readings), strict=True
    ):
        far = support_notice((reading.geometry, reading.sample_deg) for reading in readings)
        more = (*measurable.notices, *(f"* {text}" for text in far))
        print_notes(f"{name}: {notice}" for notice in more)
    return 1 if failed else 0
