"""``brdf-suite compare A B``: how two reflectances differ, per angle and over all directions."""

from __future__ import annotations

import argparse
import math
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

from brdf_suite.cli.measure import ANYTHING, add_instrument
from brdf_suite.cli.output import print_json
from brdf_suite.errors import SuiteError

if TYPE_CHECKING:
    from brdf_suite.appearance.tolerance import AngleVerdict


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
        metavar="[ANGLE=]LIMITS",
        help="what passes at one aspecular angle (15=1.2) or at all others (0.8): a number for the difference, or "
        "limits of its parts, as in 15=E1.2,L0.8,C0.5,H0.5 (E the difference, L ΔL*, C ΔC*, H ΔH*); repeatable",
    )
    command.add_argument(
        "--ellipsoid",
        action="store_true",
        help="judge the limits of ΔL*, ΔC* and ΔH* together, as half axes of an ellipsoid",
    )
    command.add_argument(
        "--difference",
        default="2000",
        metavar="NAME",
        help="the formula that tolerances are for: 2000 (CIEDE2000, the default), 76, cmc21, cmc11, cam02ucs, or "
        "cmc:l:c with weights of your own",
    )
    command.add_argument("--json", action="store_true", help="print one JSON object")
    command.set_defaults(run=run)


_PARTS = {"E": "difference", "L": "lightness", "C": "chroma", "H": "hue"}


def tolerance(text: str) -> tuple[float | None, dict[str, float]]:
    """Parse ``[ANGLE=]LIMITS`` (an argparse type): the angle, and the limits by the names that they have in the core.

    >>> tolerance("15=E1.2,L0.8")
    (15.0, {'difference': 1.2, 'lightness': 0.8})
    """
    angle, _equals, limits = text.rpartition("=")
    found: dict[str, float] = {}
    try:
        at = float(angle) if _equals else None
        for item in limits.split(","):
            letter = item.strip()[:1].upper()
            part = _PARTS.get(letter)
            name, number = ("difference", item) if part is None else (part, item.strip()[1:])
            if name in found:
                raise ValueError(name)
            found[name] = float(number)
    except ValueError:
        raise argparse.ArgumentTypeError(
            f"{text!r} is not a tolerance; write a number, ANGLE=NUMBER as in 15=1.2, or limits of the parts as in "
            "15=E1.2,L0.8,C0.5,H0.5"
        ) from None
    return at, found


def _check_angles(wanted: Iterable[float], read: Sequence[float]) -> None:
    """Refuse a tolerance at an angle that is not read: it would judge nothing, and the sample would pass."""
    for angle in wanted:
        if not any(math.isclose(angle, one, abs_tol=1e-6) for one in read):
            angles = ", ".join(f"{one:g}" for one in dict.fromkeys(read))
            raise SuiteError(f"tolerance at {angle:g}°: nothing is read there; the geometry has {angles}°.")


_SHORT = {"cmc21": "CMC 2:1", "cmc11": "CMC 1:1", "cam02ucs": "CAM02"}


def _verdict(row: AngleVerdict) -> str:
    """Pass or fail, and the limits: those that are exceeded, or all."""
    known = {
        name: f"{'Δ' if letter != 'E' else ''}{letter} ≤ {getattr(row.limits, name):g}"
        for letter, name in _PARTS.items()
        if getattr(row.limits, name) is not None
    }
    if list(known) == ["difference"]:
        known["difference"] = known["difference"].removeprefix("E ")
    if row.limits.ellipsoid:
        known["ellipsoid"] = "as an ellipsoid"
    shown = [known[name] for name in row.exceeded] or list(known.values())
    return f"{'pass' if row.passes else 'FAIL'} ({', '.join(shown)})"


def run(options: argparse.Namespace) -> int:
    """Compare and print; 1 where a tolerance is exceeded."""
    from brdf_suite.appearance.geometries import geometry_set
    from brdf_suite.appearance.tolerance import Limits, Tolerances, difference_named, difference_title
    from brdf_suite.pipeline.measuring import compare, load_measurable
    from brdf_suite.reflectance.aperture import aperture

    geometry = geometry_set(options.geometry)
    difference_named(options.difference)
    tolerances = None
    if options.tolerance:
        by_angle = {
            angle: Limits(**parts, ellipsoid=options.ellipsoid)
            for angle, parts in options.tolerance
            if angle is not None
        }
        _check_angles(by_angle, [one.aspecular_deg for one in geometry.geometries])
        others = [
            Limits(**parts, ellipsoid=options.ellipsoid)
            for angle, parts in options.tolerance
            if angle is None
        ]
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
    titles = [_SHORT.get(name) or difference_title(name) for name in result.differences]
    columns = "".join(f" {title:>{max(8, len(title))}}" for title in titles)
    print(f"{'geometry':>10}{columns}" + ("  verdict" if result.verdict else ""))
    for k, reading in enumerate(result.first.readings):
        numbers = "".join(
            f" {values[k]:{max(8, len(title))}.3f}"
            for title, values in zip(titles, result.differences.values(), strict=True)
        )
        row = None if result.verdict is None else result.verdict.angles[k]
        verdict = "" if row is None or row.passes is None else f"  {_verdict(row)}"
        print(f"{reading.geometry.name:>10}{numbers}{verdict}")
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
    for measurable, name in zip((first, second), names, strict=True):
        for notice in measurable.notices:
            print(f"note: {name}: {notice}")
    return 1 if failed else 0
