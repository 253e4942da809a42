"""``brdf-suite acquire DIR -o OUT``: photographs of a painted sphere as a table of its reflectance."""

from __future__ import annotations

import argparse
import re
from collections.abc import Sequence
from pathlib import Path

from brdf_suite.acquisition.reconstruction.options import AcquireOptions
from brdf_suite.acquisition.reconstruction.output import acquire, acquire_partial
from brdf_suite.acquisition.reconstruction.reconstruction import Acquisition
from brdf_suite.acquisition.reconstruction.table import Acquired
from brdf_suite.cli.measured import acquire_simulate
from brdf_suite.cli.output import print_json, progress_bar
from brdf_suite.errors import SuiteError

_MOST_ALIKE = 6
"""Return one notice for each kind of finding, where findings differ in names and numbers alone."""


def add(command: argparse.ArgumentParser) -> None:
    """Declare the command."""
    command.description = (
        "Reconstruct a table of half-angle bins (Günther et al. 2005) from a folder with session.json and "
        "photographs: the camera's response, the sphere and the light are found from the photographs themselves. What "
        "is done is kept in OUT.work: stopped or killed, the same command resumes where it stopped, with the same "
        "table. docs/use/acquisition.md describes the folder."
    )
    command.add_argument("folder", metavar="DIR", type=Path, help="the session's folder, or its session.json")
    command.add_argument(
        "-o",
        "--output",
        metavar="OUT",
        type=Path,
        help="the .brdftable (with coverage) or .binary (MERL) to write",
    )
    command.add_argument("--check", action="store_true", help="only report what is wrong with the files")
    command.add_argument("--overwrite", action="store_true", help="replace OUT where it exists")
    command.add_argument("--restart", action="store_true", help="forget what an earlier run left in OUT.work")
    command.add_argument(
        "--partial",
        action="store_true",
        help="write what is done so far in OUT.work as it is, and read no more",
    )
    command.add_argument("--linear", action="store_true", help="the camera is linear: recover no response")
    command.add_argument(
        "--no-refine", action="store_true", help="take light and sphere as stated; the outline alone corrects"
    )
    command.add_argument(
        "--grazing",
        metavar="DEG",
        type=float,
        default=80.0,
        help="leave readings out whose light or view is further from the normal; default: 80",
    )
    command.add_argument("--json", action="store_true", help="print one JSON object")
    acquire_simulate.add_arguments(command)
    command.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Reconstruct, write the table and print a summary."""
    if acquire_simulate.is_requested(options):
        return acquire_simulate.run(options)

    chosen = AcquireOptions(
        grazing_deg=options.grazing,
        refine=not options.no_refine,
        response="linear" if options.linear else "auto",
    )
    road = Acquisition.open(options.folder, chosen)
    if options.check:
        return _check(road, options.json)
    if options.output is None:
        raise SuiteError(
            "Say where the table goes: -o OUT.brdftable or -o OUT.binary (or --check the folder only)."
        )
    with progress_bar("acquiring", quiet=options.json) as progress:
        step = acquire_partial if options.partial else acquire
        found = step(road, options.output, progress, overwrite=options.overwrite, restart=options.restart)
    if options.json:
        print_json({"file": str(options.output), **found.to_json()})
    else:
        _print_summary(found, options.output)
    return 0


def _check(road: Acquisition, as_json: bool) -> int:
    findings = road.source.findings(None)
    if as_json:
        print_json({"session": road.session.name, "findings": [one.to_json() for one in findings]})
    else:
        for one in findings:
            print(f"{one.severity}: {one.path}: {one.reason}")
        print(f"{road.session.name}: {len(road.session.positions)} positions, {len(findings)} findings")
    return 1 if any(one.severity == "fatal" for one in findings) else 0


def _print_summary(found: Acquired, output: Path) -> None:
    summary = found.to_json()
    coverage = summary["coverage"]
    again = f" ({found.resumed} taken up from {output.name}.work)" if found.resumed else ""
    print(f"{len(found.positions_done)} positions{again}, {found.readings:,} readings")
    print(
        f"{coverage['bins']:,} bins measured, {coverage['share_below_75_deg']:.0%} of those below 75°; "
        f"median deviation {coverage['median_deviation']:.2%}"
    )
    for name, value in summary["calibration"].items():
        print(
            f"{name.replace('_', ' ')}: {value:.4g}"
            if isinstance(value, float)
            else f"{name.replace('_', ' ')}: {value}"
        )
    for one in found.positions_failed:
        print(f"left out: position {one.position}: {one.reason}")
    for sentence in _summed_up(found.notices):
        print(f"note: {sentence}")
    print(f"written to {output}")


def _summed_up(notices: Sequence[str]) -> list[str]:
    """Return the notices; of many that differ in names and numbers alone, the first and how many more there are."""
    alike: dict[str, list[str]] = {}
    for sentence in notices:
        _, colon, reason = sentence.partition(": ")
        alike.setdefault(re.sub(r"\d[\d.]*", "#", reason) if colon else sentence, []).append(sentence)
    lines: list[str] = []
    for same in alike.values():
        if len(same) <= _MOST_ALIKE:
            lines += same
        else:
            lines.append(f"{same[0]} And {len(same) - 1} more photographs alike (--json names all).")
    return lines
