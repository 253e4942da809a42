"""``brdf-suite compare A B``: how two reflectances differ, per angle and over all directions."""

from __future__ import annotations

import argparse
import math
from collections.abc import Iterable, Sequence

from brdf_suite.cli.measure import ANYTHING, add_instrument
from brdf_suite.cli.output import print_json
from brdf_suite.errors import SuiteError


def add(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Declare the command."""
    command = commands.add_parser(
        "compare",
        help="compare two paints or measured files: colour differences per angle, RMS and log error",
        description="Compare B with the reference A. With tolerances the exit status is 1 where B fails.",
    )
    command.add_argument("a", metavar="A", help=f"the reference: {ANYTHING}")
    command.add_argument("b", metavar="B", help="the sample, likewise")
    add_instrument(command)
    command.add_argument(
        "--tolerance",
        action="append",
        type=tolerance,
        default=[],
        metavar="[ANGLE=]DELTA_E",
        help="the largest difference that passes, at one aspecular angle (15=1.2) or at all others (0.8); repeatable",
    )
    command.add_argument(
        "--difference",
        choices=("2000", "76", "cmc21", "cmc11", "cam02ucs"),
        default="2000",
        help="the formula that tolerances are for (default: 2000, CIEDE2000)",
    )
    command.add_argument("--json", action="store_true", help="print one JSON object")
    command.set_defaults(run=run)


def tolerance(text: str) -> tuple[float | None, float]:
    """Parse ``ANGLE=DELTA_E`` or ``DELTA_E`` (an argparse type)."""
    angle, _equals, value = text.rpartition("=")
    try:
        return (float(angle) if _equals else None), float(value)
    except ValueError:
        raise argparse.ArgumentTypeError(
            f"{text!r} is not a tolerance; write a number, or ANGLE=NUMBER as in 15=1.2"
        ) from None


def _check_angles(wanted: Iterable[float], read: Sequence[float]) -> None:
    """Refuse a tolerance at an angle that is not read: it would judge nothing, and the sample would pass."""
    for angle in wanted:
        if not any(math.isclose(angle, one, abs_tol=1e-6) for one in read):
            angles = ", ".join(f"{one:g}" for one in dict.fromkeys(read))
            raise SuiteError(f"tolerance at {angle:g}°: nothing is read there; the geometry has {angles}°.")


def run(options: argparse.Namespace) -> int:
    """Compare and print; 1 where a tolerance is exceeded."""
    from brdf_suite.appearance.geometries import geometry_set
    from brdf_suite.appearance.tolerance import Tolerances
    from brdf_suite.pipeline.measuring import compare, load_measurable
    from brdf_suite.reflectance.aperture import aperture

    geometry = geometry_set(options.geometry)
    tolerances = None
    if options.tolerance:
        by_angle = {angle: value for angle, value in options.tolerance if angle is not None}
        _check_angles(by_angle, [one.aspecular_deg for one in geometry.geometries])
        others = [value for angle, value in options.tolerance if angle is None]
        tolerances = Tolerances(by_angle, others[-1] if others else None, options.difference)
    first, second = (load_measurable(what, observer_deg=options.observer) for what in (options.a, options.b))
    result = compare(first, second, geometry, aperture(options.aperture), tolerances)
    failed = result.verdict is not None and result.verdict.passes is False
    if options.json:
        notices = {"a": list(first.notices), "b": list(second.notices)}
        print_json({"a": first.name, "b": second.name, **result.to_json(), "notices": notices})
        return 1 if failed else 0
    names = [first.name, second.name]
    if names[0] == names[1]:  # two paints of one name, or one paint twice: what was typed tells them apart
        names = [f"{name} ({typed})" for name, typed in zip(names, (options.a, options.b), strict=True)]
    print(f"{names[1]} against {names[0]}: {result.first.geometry_set.title}; {result.first.aperture.title}")
    print(
        f"{'geometry':>10} {'ΔE00':>8} {'ΔE*ab':>8} {'CMC 2:1':>8} {'CMC 1:1':>8} {'CAM02':>8}"
        + ("  verdict" if result.verdict else "")
    )
    for k, reading in enumerate(result.first.readings):
        numbers = "".join(f" {values[k]:8.3f}" for values in result.differences.values())
        row = None if result.verdict is None else result.verdict.angles[k]
        words = (
            ""
            if row is None or row.passes is None
            else f"  {'pass' if row.passes else 'FAIL'} (≤ {row.tolerance:g})"
        )
        print(f"{reading.geometry.name:>10}{numbers}{words}")
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
    for measurable, name in zip((first, second), names, strict=True):
        for notice in measurable.notices:
            print(f"note: {name}: {notice}")
    return 1 if failed else 0
