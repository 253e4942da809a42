"""``brdf-suite acquire FOLDER -o FILE``: photographs of a painted sphere as a table of its reflectance."""

from __future__ import annotations

import argparse
import re
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from brdf_suite.acquisition.reconstruction.options import AcquireOptions
from brdf_suite.acquisition.reconstruction.output import acquire, acquire_partial
from brdf_suite.acquisition.reconstruction.reconstruction import Acquisition
from brdf_suite.acquisition.reconstruction.table import Acquired, figures_of
from brdf_suite.acquisition.session.template import write_template
from brdf_suite.acquisition.simulator import SimulatorSettings, simulate
from brdf_suite.cli.arguments import add_arguments, add_json, add_output
from brdf_suite.cli.output import print_done, print_json, print_notes, progress_bar
from brdf_suite.command_parser import CommandParser
from brdf_suite.errors import SuiteError
from brdf_suite.pipeline.material import load_material


def add_simulated(command: CommandParser) -> None:
    """Declare the options of a template and of a simulated rig on the command ``acquire``."""
    command.add_argument(
        "--template",
        action="store_true",
        help="write a session.json to fill in into the folder, for the photographs that lie there",
    )
    rig = command.add_argument_group("a simulated rig")
    add_arguments(
        rig,
        {
            "--simulate PAINT": "write the folder: photographs of a sphere of this paint (a name or a file), and "
            "truth.json beside them",
            "--size WxH": "of the photographs; default: 320x320",
            "--positions N": "of the lamp, from 0° to 180°; default: 180",
            "--exposures N": "at each position; default: 16",
            "--shortest S": "exposure, seconds; default: 0.00025",
            "--longest S": "exposure, seconds; default: 0.328",
            "--bits N": "8 to 16; default: 12",
            "--curve {film,linear,srgb}": "response of the camera; default: film",
            "--no-noise": "a camera without noise and dark current",
            "--seed N": "of the noise and of the board's poses; default: 0",
            "--light-offset DEG": "the lamp stands off by this angle",
            "--light-height-offset M": "and by this height, metres",
            "--centre-offset X Y": "the sphere stands off, pixels right and down",
            "--moved K X Y": "from position K on (the first is 0) the sphere stands off by X, Y pixels more",
            "--arm": "with the lamp's post, and the turntable mirrored",
            "--profile": "with a lamp that falls off to the sides",
            "--colour-matrix": "with a camera of channels of its own",
            "--stated": "state irradiance and intrinsics: no white, no board",
            "--tiff": "write TIFF instead of PNG",
        },
        moved=float,
    )


def run_simulated(options: argparse.Namespace) -> int:
    """Write the folder of a template or of a simulation and print a summary."""
    if options.template and options.simulate:
        raise SuiteError("Give either --template or --simulate, not both.")
    return _template(options) if options.template else _simulate(options)


def _template(options: argparse.Namespace) -> int:
    written = write_template(Path(options.folder))
    if options.json:
        print_json(
            {"file": str(written.path), "photographs": written.photographs, "notes": list(written.notes)}
        )
        return 0
    print_done(f"{written.path}: written for {written.photographs:,} photographs")
    print_notes(written.notes)
    return 0


def _simulate(options: argparse.Namespace) -> int:
    given: dict[str, Any] = {
        "size": options.size,
        "positions": options.positions,
        "exposures": options.exposures,
        "shortest_s": options.shortest,
        "longest_s": options.longest,
        "bit_depth": options.bits,
        "curve": options.curve,
        "seed": options.seed,
        "light_offset_deg": options.light_offset,
        "light_height_offset_m": options.light_height_offset,
        "centre_offset_px": options.centre_offset and tuple(options.centre_offset),
        "moved": options.moved and _moved(options.moved),
        "noise": False if options.no_noise else None,
        "arm": options.arm or None,
        "profile": options.profile or None,
        "colour_matrix": options.colour_matrix or None,
        "white": False if options.stated else None,
        "board": False if options.stated else None,
        "file_kind": "tiff" if options.tiff else None,
    }
    settings = SimulatorSettings(**{name: value for name, value in given.items() if value is not None})
    paint = load_material(options.simulate)
    with progress_bar("simulating", quiet=options.json) as progress:
        session = simulate(paint.reflectance, options.folder, settings, paint.name, progress)
    count = len(session.files())
    if options.json:
        print_json(
            {
                "folder": str(options.folder),
                "paint": paint.name,
                "photographs": count,
                "positions": len(session.positions),
                "exposures_s": list(session.exposures_s),
            }
        )
        return 0
    print_done(
        f"{options.folder}: {count:,} photographs of {paint.name} at {len(session.positions)} positions of the lamp, "
        f"{len(session.exposures_s)} exposures each; what is true stands in truth.json"
    )
    return 0


def _moved(given: list[float]) -> tuple[int, float, float]:
    """Return the position, which must be a whole number, and the shift."""
    position, right, down = given
    if not position.is_integer():
        raise SuiteError(f"--moved: a position is a whole number, the first is 0; {position:g} is none.")
    return int(position), right, down


_MOST_ALIKE = 6


def add(command: CommandParser) -> None:
    """Declare the command."""
    command.description = (
        "Reconstruct a table of half-angle bins (Günther et al. 2005) from a folder with session.json and "
        "photographs: the camera's response, the sphere and the light are found from the photographs themselves. What "
        "is done is kept in FILE.work: stopped or killed, the same command resumes where it stopped, with the same "
        "table. docs/formats/session.md describes the folder."
    )
    command.examples = (
        "brdf-suite acquire session --template",
        "brdf-suite acquire session -o paint.brdftable",
        "brdf-suite acquire rig --simulate blue --positions 18",
    )
    add_arguments(command, {"folder FOLDER": "the session's folder, or its session.json"})
    add_output(command, "the .brdftable (with coverage) or .binary (MERL) to write", required=False)
    add_arguments(
        command,
        {
            "--check": "only report what is wrong with the files",
            "--overwrite": "replace FILE where it exists",
            "--restart": "forget what an earlier run left in FILE.work",
            "--partial": "write what is done so far in FILE.work as it is, and read no more",
            "--linear": "the camera is linear: recover no response",
            "--no-refine": "take light and sphere as stated; the outline alone corrects",
            "--grazing DEG=80.0": "leave readings out whose light or view is further from the normal; default: 80",
        },
    )
    add_json(command)
    add_simulated(command)
    command.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Reconstruct, write the table and print a summary."""
    if options.template or options.simulate:
        return run_simulated(options)
    chosen = AcquireOptions(
        grazing_deg=options.grazing,
        refine=not options.no_refine,
        response="linear" if options.linear else "auto",
    )
    road = Acquisition.open(options.folder, chosen)
    if options.check:
        findings = road.source.findings(None)
        if options.json:
            print_json({"session": road.session.name, "findings": [one.to_json() for one in findings]})
        else:
            for one in findings:
                print(f"{one.severity}: {one.path}: {one.reason}")
            print(f"{road.session.name}: {len(road.session.positions)} positions, {len(findings)} findings")
        return 1 if any(one.severity == "fatal" for one in findings) else 0
    if options.output is None:
        raise SuiteError(
            "Say where the table goes: -o FILE.brdftable or -o FILE.binary (or --check the folder only)."
        )
    with progress_bar("acquiring", quiet=options.json) as progress:
        step = acquire_partial if options.partial else acquire
        found = step(road, options.output, progress, overwrite=options.overwrite, restart=options.restart)
    if options.json:
        print_json({"file": str(options.output), **figures_of(found)})
    else:
        _print_summary(found, options.output)
    return 0


def _print_summary(found: Acquired, output: Path) -> None:
    summary = figures_of(found)
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
    print_notes(_summed_up(found.notices))
    print_done(f"written to {output}")


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
