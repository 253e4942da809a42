"""``brdf-suite environment studio|sky``: light from a description, as a file to edit or as a map."""

from __future__ import annotations

import argparse
from pathlib import Path

from brdf_suite.cli.output import progress_bar
from brdf_suite.documents.light_store import STUDIO_ENDING, LightDocument, load_light, save_light
from brdf_suite.documents.studio import SKY_MODELS, Sky
from brdf_suite.errors import FileError, SuiteError
from brdf_suite.files.images.environments import write_exr
from brdf_suite.lighting.procedural.studio import BOOTH, EXAMPLE
from brdf_suite.pipeline.environments import draw_light


def add(actions: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Declare both actions."""
    studio = actions.add_parser(
        "studio",
        help="write an editable studio, or draw one as a map",
        description="A .brdfstudio file describes a room or a backdrop and lamps: boxes, strips and rings, with place, "
        "size, luminance and colour temperature. It opens wherever an environment does.",
    )
    studio.add_argument(
        "description", metavar="FILE", type=Path, help="a .brdfstudio file, to read or (--new) to write"
    )
    studio.add_argument(
        "--new", action="store_true", help="write an example to FILE, which must not exist yet"
    )
    studio.add_argument(
        "--booth", action="store_true", help="with --new: the shipped light booth instead of the example"
    )
    studio.add_argument(
        "--render", metavar="OUT.exr", type=Path, help="write the map, 1024 × 512, as OpenEXR"
    )
    studio.set_defaults(run=run_studio)

    sky = actions.add_parser(
        "sky",
        help="write a sky by haze and sun, as a description or as a map",
        description="A sky over a plain ground: Hošek-Wilkie (2012), Preetham (1999), or the CIE overcast sky. "
        "OUT.brdfstudio is written as a description to edit, OUT.exr as a map of 1024 × 512.",
    )
    sky.add_argument("output", metavar="OUT", type=Path, help="the .brdfstudio or .exr file to write")
    sky.add_argument("--model", choices=SKY_MODELS, default=SKY_MODELS[0], help=f"(default: {SKY_MODELS[0]})")
    sky.add_argument(
        "--turbidity",
        type=float,
        default=3.0,
        metavar="T",
        help="haze: 2 very clear, 3 clear (default), 6 hazy",
    )
    sky.add_argument(
        "--elevation",
        type=float,
        default=40.0,
        metavar="DEG",
        help="of the sun above the horizon (default: 40)",
    )
    sky.add_argument(
        "--azimuth",
        type=float,
        default=60.0,
        metavar="DEG",
        help="of the sun, from +z towards +x (default: 60)",
    )
    sky.add_argument("--albedo", type=float, default=0.2, metavar="A", help="of the ground (default: 0.2)")
    sky.add_argument("--no-disc", action="store_true", help="leave the sun's disc out")
    sky.set_defaults(run=run_sky)


def run_studio(options: argparse.Namespace) -> int:
    """Write an example, or draw a description."""
    path: Path = options.description
    if options.new:
        if path.suffix.lower() != STUDIO_ENDING:
            raise FileError(path, f"must end in {STUDIO_ENDING}")
        if path.exists():
            raise FileError(path, "is there already, and --new writes over nothing")

        light: LightDocument = BOOTH if options.booth else EXAMPLE
        save_light(light, path)
        print(f"{path}: written; edit it as text and open it as an environment")
    elif options.render is None:
        raise SuiteError("Nothing to do: give --new to write FILE, or --render OUT.exr to draw it.")
    else:
        light = load_light(path)
    if options.render is not None:
        _render(light, options.render)
    return 0


def run_sky(options: argparse.Namespace) -> int:
    """Write a sky."""
    path: Path = options.output
    if path.suffix.lower() not in (STUDIO_ENDING, ".exr"):
        raise FileError(path, f"must end in {STUDIO_ENDING} or .exr")
    light = Sky(
        name=path.stem or "sky",
        model=options.model,
        turbidity=options.turbidity,
        sun_elevation_deg=options.elevation,
        sun_azimuth_deg=options.azimuth,
        ground_albedo=options.albedo,
        sun_disc=not options.no_disc,
    )
    if path.suffix.lower() == ".exr":
        _render(light, path)
        return 0
    save_light(light, path)
    print(f"{path}: written")
    return 0


def _render(light: LightDocument, path: Path) -> None:
    if path.suffix.lower() != ".exr":
        raise FileError(path, "must end in .exr")
    with progress_bar("drawing") as progress:
        made = draw_light(light, progress)
    write_exr(path, made.stored(), metadata={"comments": made.comment})
    rows, columns = made.radiance.shape[:2]
    print(f"{path}: {columns} × {rows}, written. {made.comment}")
