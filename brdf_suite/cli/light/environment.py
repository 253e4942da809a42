"""``brdf-suite environment …``: facts about environment maps, and maps and lights made from them."""

from __future__ import annotations

import argparse
import dataclasses
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.cli.arguments import add_arguments, add_json, add_output, whole_number
from brdf_suite.cli.output import print_csv, print_done, print_json, print_notes, progress_bar
from brdf_suite.cli.picture.scene_options import add_environment
from brdf_suite.command_parser import CommandParser
from brdf_suite.documents.studio import SKY_MODELS, STUDIO_ENDING, LightDocument, Sky, load_light, save_light
from brdf_suite.errors import FileError, SuiteError
from brdf_suite.files.images.environments import write_exr
from brdf_suite.files.images.png import write_png
from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.latlong import angles, column_angles, direction, ring_angles, sample
from brdf_suite.lighting.lights import DirectionalLights, directional_lights
from brdf_suite.lighting.lights.extract import DEFAULT_METHOD, MAX_LIGHTS, METHODS
from brdf_suite.lighting.procedural.studio import BOOTH, EXAMPLE
from brdf_suite.lighting.statistics import EnvironmentStatistics, Histogram, environment_statistics
from brdf_suite.pipeline.environments import draw_light, read_environment, read_environment_file
from brdf_suite.pipeline.scene import find_environment
from brdf_suite.realtime.pictures.tone_curves import to_display
from brdf_suite.regular_files import exists


def add_light(actions: argparse._SubParsersAction[CommandParser]) -> None:
    """Declare both actions."""
    studio = actions.add_parser(
        "studio",
        help="write an editable studio, or draw one as a map",
        description="A .brdfstudio file describes a room or a backdrop and lamps: boxes, strips and rings, with place, "
        "size, luminance and colour temperature. It opens wherever an environment does.",
    )
    add_arguments(
        studio,
        {
            "description FILE": "a .brdfstudio file, to read or (--new) to write",
            "--new": "write an example to FILE, which must not exist yet",
            "--booth": "with --new: the shipped light booth instead of the example",
        },
    )
    studio.examples = (
        "brdf-suite environment studio mine.brdfstudio --new",
        "brdf-suite environment studio mine.brdfstudio -o mine.exr",
    )
    add_output(studio, "the map to write, 1024 × 512, as OpenEXR", stream=".exr", required=False)
    add_json(studio)
    studio.set_defaults(run=run_studio)

    sky = actions.add_parser(
        "sky",
        help="write a sky by haze and sun, as a description or as a map",
        description="A sky over a plain ground: Hošek-Wilkie (2012), Preetham (1999), or the CIE overcast sky. "
        "A .brdfstudio file is written as a description to edit, an .exr file as a map of 1024 × 512.",
    )
    add_arguments(
        sky,
        {
            f"--model={SKY_MODELS[0]}": f"(default: {SKY_MODELS[0]})",
            "--turbidity T=3.0": "haze: 2 very clear, 3 clear (default), 6 hazy",
            "--elevation DEG=40.0": "of the sun above the horizon (default: 40)",
            "--azimuth DEG=60.0": "of the sun, from +z towards +x (default: 60)",
            "--albedo A=0.2": "of the ground (default: 0.2)",
            "--no-disc": "leave the sun's disc out",
        },
        model=SKY_MODELS,
    )
    sky.examples = (
        "brdf-suite environment sky -o evening.exr --turbidity 4 --elevation 8",
        "brdf-suite environment sky -o overcast.brdfstudio --model overcast",
    )
    add_output(sky, "the .brdfstudio or .exr file to write", stream=STUDIO_ENDING)
    add_json(sky)
    sky.set_defaults(run=run_sky)


def run_studio(options: argparse.Namespace) -> int:
    """Write an example, or draw a description."""
    path: Path = options.description
    if options.new:
        if path.suffix.lower() != STUDIO_ENDING:
            raise FileError(path, f"must end in {STUDIO_ENDING}")
        if exists(path):
            raise FileError(path, "is there already, and --new writes over nothing")

        light: LightDocument = BOOTH if options.booth else EXAMPLE
        save_light(light, path)
        if options.output is None:
            _print_written(path, "written; edit it as text and open it as an environment", options)
    elif options.output is None:
        raise SuiteError("Nothing to do: give --new to write FILE, or -o MAP.exr to draw it.")
    else:
        light = load_light(path)
    if options.output is not None:
        _render(light, options.output, options)
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
        _render(light, path, options)
        return 0
    save_light(light, path)
    _print_written(path, "written", options)
    return 0


def _print_written(path: Path, line: str, options: argparse.Namespace, **facts: object) -> None:
    if options.json:
        print_json({"output": str(path), **facts})
    else:
        print_done(f"{path}: {line}")


def _render(light: LightDocument, path: Path, options: argparse.Namespace) -> None:
    if path.suffix.lower() != ".exr":
        raise FileError(path, "must end in .exr")
    with progress_bar("drawing", quiet=options.json) as progress:
        made = draw_light(light, progress)
    write_exr(path, made.stored(), metadata={"comments": made.comment})
    rows, columns = made.radiance.shape[:2]
    line = f"{columns} × {rows}, written. {made.comment}"
    _print_written(path, line, options, width=columns, height=rows, comment=made.comment)


_GREY = 0.18
_LEAST_TEXELS, _MOST_TEXELS = 2.5, 26.0


def picture_of_lights(
    environment: Environment, lights: DirectionalLights, width: int = 1024
) -> NDArray[np.uint8]:
    """Return the map (width/2, width, 3), sRGB, exposed for its mean, a ring about each light.

    The area of a ring goes with the light's share, from the smallest to the largest that can be distinguished; a black
    and a white line make it visible on anything.
    """
    height = width // 2
    theta, phi = ring_angles(height), column_angles(width)
    light = sample(environment.radiance, direction(theta[:, None], phi[None, :]))
    mean = float(environment.average() @ LUMINANCE)
    picture = to_display(light, float(np.log2(_GREY / mean)) if mean > 0.0 else 0.0)
    luminous = lights.strengths @ LUMINANCE
    shares = luminous / max(float(luminous.sum()), 1e-300)
    radii = np.clip(_MOST_TEXELS * np.sqrt(shares * 8.0), _LEAST_TEXELS, _MOST_TEXELS)
    at_theta, at_phi = angles(lights.directions)
    rows = at_theta * height / np.pi - 0.5
    columns = (at_phi + np.pi) * width / (2.0 * np.pi) - 0.5
    across = np.arange(width)
    for row, column, radius in zip(rows, columns, radii, strict=True):
        top, bottom = max(0, int(row - radius - 3)), min(height, int(row + radius + 4))
        apart = np.abs(across - column)
        apart = np.minimum(apart, width - apart)
        distance = np.hypot(apart[None, :], np.arange(top, bottom)[:, None] - row)
        strip = picture[top:bottom]
        strip[np.abs(distance - radius) < 1.6] = 0
        strip[np.abs(distance - radius) < 0.8] = 255
    return np.asarray(picture, dtype=np.uint8)


def add_lights(actions: argparse._SubParsersAction[CommandParser]) -> None:
    """Declare the action."""
    action = actions.add_parser(
        "lights",
        help="the lights from infinitely far away that represent the map",
        description="Divide the sphere into cells and give each a light of the cell's whole energy. The strongest "
        "comes first; strengths are ∫L dω over the cell, linear Rec. 2020, in the file's own units.",
    )
    add_environment(action)
    add_arguments(
        action,
        {
            "-n/--count N=16": f"how many, 1 to {MAX_LIGHTS:,} (default: 16)",
            f"--method={DEFAULT_METHOD}": "relaxed errs least; structured and median-cut keep a sun apart even with "
            f"few lights (default: {DEFAULT_METHOD})",
        },
        count=whole_number(1, MAX_LIGHTS),
        method=tuple(METHODS),
    )
    action.examples = (
        "brdf-suite environment lights sunny -n 8 --csv",
        "brdf-suite environment lights booth -o rings.png",
    )
    add_output(
        action, "also write the map with a ring around each light, as PNG", stream=".png", required=False
    )
    add_json(action, csv=True)
    action.set_defaults(run=run_lights)


def run_lights(options: argparse.Namespace) -> int:
    """Find the lights and print them."""
    if options.output is not None and options.output.suffix.lower() != ".png":
        raise FileError(options.output, "must end in .png")
    name, path = find_environment(options.environment)
    environment = read_environment(path, options.layout)
    lights = directional_lights(environment, options.count, options.method)
    if options.output is not None:
        title = f"{name}: {len(lights)} directional lights"
        write_png(options.output, picture_of_lights(environment, lights), {"Title": title})
    luminous = lights.strengths @ LUMINANCE
    elevations = np.degrees(np.arcsin(np.clip(lights.directions[:, 1], -1.0, 1.0)))
    azimuths = np.degrees(np.arctan2(lights.directions[:, 0], lights.directions[:, 2]))
    if options.json:
        print_json(
            {
                "environment": name,
                "method": options.method,
                "count": len(lights),
                "total": [float(value) for value in lights.strengths.sum(axis=0)],
                "notes": list(environment.notes),
                "lights": [
                    {
                        "direction": [float(value) for value in lights.directions[i]],
                        "elevation_deg": float(elevations[i]),
                        "azimuth_deg": float(azimuths[i]),
                        "strength": [float(value) for value in lights.strengths[i]],
                        "solid_angle_sr": float(lights.solid_angles[i]),
                    }
                    for i in range(len(lights))
                ],
            }
        )
        return 0
    print_notes(environment.notes)
    if options.csv:
        print_csv(
            {
                "elevation_deg": float(elevations[i]),
                "azimuth_deg": float(azimuths[i]),
                "solid_angle_sr": float(lights.solid_angles[i]),
                **dict(zip(("red", "green", "blue"), lights.strengths[i].tolist(), strict=True)),
            }
            for i in range(len(lights))
        )
        return 0
    whole = max(float(luminous.sum()), 1e-300)
    print(f"{name}: {len(lights)} lights by {options.method}; azimuth from +z towards +x")
    print("  elevation   azimuth     share   solid angle   strength (linear Rec. 2020)")
    for i in range(len(lights)):
        red, green, blue = lights.strengths[i]
        print(
            f"  {elevations[i]:8.2f}° {azimuths[i]:8.2f}° {100.0 * luminous[i] / whole:8.3f} % "
            f"{lights.solid_angles[i]:10.3g} sr   {red:.5g} {green:.5g} {blue:.5g}"
        )
    if options.output is not None:
        print_done(f"{options.output}: written")
    return 0


_BAR = 40
_ROWS = 20  # of the histogram; more stops than that are put together two by two, and so on


def add_info(actions: argparse._SubParsersAction[CommandParser]) -> None:
    """Declare the action."""
    action = actions.add_parser(
        "info",
        help="its size and layout, how bright and uneven it is, where its sun stands, a histogram",
        description="Print what an environment is. Radiances are in the file's own units, colours linear Rec. 2020.",
    )
    add_environment(action)
    action.examples = ("brdf-suite environment info sunny",)
    add_json(action)
    action.set_defaults(run=run_info)


def run_info(options: argparse.Namespace) -> int:
    """Read, count and print."""
    name, path = find_environment(options.environment)
    read = read_environment_file(path, options.layout)
    environment = read.environment
    statistics = environment_statistics(environment)
    rows, columns = environment.radiance.shape[:2]
    if options.json:
        print_json(
            {
                "environment": name,
                "layout": read.layout,
                "image_width": read.image_width,
                "image_height": read.image_height,
                "width": columns,
                "height": rows,
                "notes": list(environment.notes),
                "content_hash": environment.content_hash,
                **dataclasses.asdict(statistics),
            }
        )
        return 0
    unfolded = f", as a map {columns:,} × {rows:,}" if read.layout not in ("latlong", "studio", "sky") else ""
    print(f"{name}: {read.image_width:,} × {read.image_height:,} pixels, layout {read.layout}{unfolded}")
    print_notes(environment.notes)
    for title, value in facts(statistics):
        print(f"  {title:<24}{value}")
    print("\nshare of the sphere by luminance (log2)")
    for line in bars(statistics.histogram):
        print(f"  {line}")
    return 0


def facts(statistics: EnvironmentStatistics) -> list[tuple[str, str]]:
    """Return title and value of each figure, for a table."""
    red, green, blue = statistics.average_radiance
    front, right, back, left = statistics.vertical_illuminance
    stops = statistics.dynamic_range_stops
    if statistics.sun_elevation_deg is None:
        sun = "none: the light is even"
    else:
        sun = (
            f"{statistics.sun_elevation_deg:.2f}° above the horizon, azimuth {statistics.sun_azimuth_deg:.2f}° "
            f"from +z towards +x; {100.0 * statistics.sun_share:.1f} % of all light"
        )
    return [
        (
            "average radiance",
            f"{red:.4g} {green:.4g} {blue:.4g}   luminance {statistics.average_luminance:.4g}",
        ),
        ("illuminance from above", f"{statistics.horizontal_illuminance:.4g}"),
        ("illuminance of walls", f"+z {front:.4g}   -x {right:.4g}   -z {back:.4g}   +x {left:.4g}"),
        ("brightest", f"{statistics.brightest_luminance:.4g}"),
        ("dynamic range", "1 % of the sphere or more is black" if stops is None else f"{stops:.1f} stops"),
        ("sun or strongest lamp", sun),
    ]


def bars(histogram: Histogram) -> list[str]:
    """Return the histogram as lines: the lower edge of each step, a bar, its share; the brightest first."""
    shares = list(histogram.shares)
    together = -(-len(shares) // _ROWS) if shares else 1
    steps = [
        (histogram.lowest_stop + first, sum(shares[first : first + together]))
        for first in range(0, len(shares), together)
    ]
    most = max([share for _, share in steps] + [histogram.black, 1e-12])
    lines = []
    for stop, share in reversed(steps):
        bar = "#" * max(round(_BAR * share / most), 1 if share > 0.0 else 0)
        lines.append(f"{stop:+5.0f}  {bar:<{_BAR}} {_percent(share)}")
    if histogram.black > 0.0005:
        lines.append(
            f"black  {'#' * max(1, round(_BAR * histogram.black / most)):<{_BAR}} {_percent(histogram.black)}"
        )
    return lines


def _percent(share: float) -> str:
    return f"{100.0 * share:8.4f} %" if 0.0 < share < 0.001 else f"{100.0 * share:6.2f} %"


def add(command: CommandParser) -> None:
    """Declare the command and its actions."""
    command.description = (
        "Look into an environment: an .exr, .hdr or .brdfstudio file, or a shipped one (photo_studio, "
        "street, light_tunnel, booth, overcast, sunny); or make one."
    )
    command.examples = ("brdf-suite environment info studio.exr", "brdf-suite environment sky --help")
    actions = command.add_subparsers(dest="action", metavar="info|lights|studio|sky", required=True)
    for add_action in (add_info, add_lights, add_light):
        add_action(actions)
