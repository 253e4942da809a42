"""Command-line options for tolerances: limits per angle of a difference formula or its components; verdicts as text."""

from __future__ import annotations

import argparse
import math
from collections.abc import Sequence

from brdf_suite.appearance.difference.tolerance import AngleVerdict, Limits, Tolerances, find_difference
from brdf_suite.cli.arguments import add_arguments
from brdf_suite.command_parser import CommandParser
from brdf_suite.errors import SuiteError

_PARTS = {"E": "difference", "L": "lightness", "C": "chroma", "H": "hue"}


def add_tolerances(command: CommandParser) -> None:
    """Declare the tolerance options and the difference formula."""
    group = command.add_argument_group("tolerances")
    group.add_argument(
        "--tolerance",
        action="append",
        type=tolerance,
        default=[],
        metavar="[ANGLE=]LIMITS",
        help="what passes at one aspecular angle (15=1.2) or at all others (0.8): a number for the difference, or "
        "limits of its parts, as in 15=E1.2,L0.8,C0.5,H0.5 (E the difference, L ΔL*, C ΔC*, H ΔH*); repeatable",
    )
    add_arguments(
        group,
        {
            "--ellipsoid": "judge the limits of ΔL*, ΔC* and ΔH* together, as half axes of an ellipsoid",
            "--difference NAME=2000": "the formula that tolerances are for: 2000 (CIEDE2000, the default), 76, "
            "cmc21, cmc11, cam02ucs, or cmc:l:c with weights of your own",
        },
    )


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


def parse_tolerances(options: argparse.Namespace, read: Sequence[float]) -> Tolerances | None:
    """Return what the options ask for at the angles that are ``read``; ``None`` where nothing shall be judged.

    Raises :class:`SuiteError`: there is no such formula, a limit is no size, or an angle is not read.
    """
    find_difference(options.difference)
    if not options.tolerance:
        return None
    known = [(angle, Limits(**parts, ellipsoid=options.ellipsoid)) for angle, parts in options.tolerance]
    by_angle = {angle: limits for angle, limits in known if angle is not None}
    for angle in by_angle:  # it would judge nothing, and the sample would pass
        if not any(math.isclose(angle, one, abs_tol=1e-6) for one in read):
            angles = ", ".join(f"{one:g}" for one in dict.fromkeys(read))
            raise SuiteError(f"tolerance at {angle:g}°: nothing is read there; the geometry has {angles}°.")
    others = [limits for angle, limits in known if angle is None]
    return Tolerances(by_angle, others[-1] if others else None, options.difference)


def verdict_text(row: AngleVerdict) -> str:
    """Return the verdict as text: pass or fail, and the limits, the exceeded ones or all."""
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
