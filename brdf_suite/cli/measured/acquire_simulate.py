"""``brdf-suite acquire --simulate PAINT DIR`` and ``--template DIR``: folders of photographs to start from."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

from brdf_suite.acquisition.session.template import write_template
from brdf_suite.acquisition.simulator import SimulatorSettings, simulate
from brdf_suite.cli.output import print_json, progress_bar, size
from brdf_suite.errors import SuiteError
from brdf_suite.pipeline.material import load_material


def add_arguments(command: argparse.ArgumentParser) -> None:
    """Declare the options of a template and of a simulated rig on the command ``acquire``."""
    command.add_argument(
        "--template",
        action="store_true",
        help="write a session.json to fill in into the folder, for the photographs that lie there",
    )
    rig = command.add_argument_group("a simulated rig")
    rig.add_argument(
        "--simulate",
        metavar="PAINT",
        help="write the folder: photographs of a sphere of this paint (a name or a file), and truth.json beside them",
    )
    rig.add_argument("--size", metavar="WxH", type=size, help="of the photographs; default: 320x320")
    rig.add_argument("--positions", metavar="N", type=int, help="of the lamp, from 0° to 180°; default: 180")
    rig.add_argument("--exposures", metavar="N", type=int, help="at each position; default: 16")
    rig.add_argument("--shortest", metavar="S", type=float, help="exposure, seconds; default: 0.00025")
    rig.add_argument("--longest", metavar="S", type=float, help="exposure, seconds; default: 0.328")
    rig.add_argument("--bits", metavar="N", type=int, help="8 to 16; default: 12")
    rig.add_argument(
        "--curve", choices=("film", "linear", "srgb"), help="response of the camera; default: film"
    )
    rig.add_argument("--no-noise", action="store_true", help="a camera without noise and dark current")
    rig.add_argument(
        "--seed", metavar="N", type=int, help="of the noise and of the board's poses; default: 0"
    )
    rig.add_argument("--light-offset", metavar="DEG", type=float, help="the lamp stands off by this angle")
    rig.add_argument("--light-height-offset", metavar="M", type=float, help="and by this height, metres")
    rig.add_argument(
        "--centre-offset",
        metavar=("X", "Y"),
        type=float,
        nargs=2,
        help="the sphere stands off, pixels right and down",
    )
    rig.add_argument(
        "--moved",
        metavar=("K", "X", "Y"),
        type=float,
        nargs=3,
        help="from position K on (the first is 0) the sphere stands off by X, Y pixels more",
    )
    rig.add_argument("--arm", action="store_true", help="with the lamp's post, and the turntable mirrored")
    rig.add_argument("--profile", action="store_true", help="with a lamp that falls off to the sides")
    rig.add_argument("--colour-matrix", action="store_true", help="with a camera of channels of its own")
    rig.add_argument(
        "--stated", action="store_true", help="state irradiance and intrinsics: no white, no board"
    )
    rig.add_argument("--tiff", action="store_true", help="write TIFF instead of PNG")


def is_requested(options: argparse.Namespace) -> bool:
    """Return whether a template or a simulation is requested instead of a reconstruction."""
    return bool(options.template or options.simulate)


def run(options: argparse.Namespace) -> int:
    """Write the folder and print a summary."""
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
    print(f"{written.path}: written for {written.photographs:,} photographs")
    for note in written.notes:
        print(f"  {note}")
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
    print(
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
