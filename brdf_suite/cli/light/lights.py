"""``brdf-suite environment lights FILE``: approximation of an environment by directional lights."""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np

from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.cli.light.layout import add_layout
from brdf_suite.cli.output import print_json
from brdf_suite.errors import FileError
from brdf_suite.files.images.png import write_png
from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.lights import DirectionalLights, directional_lights
from brdf_suite.lighting.lights.extract import DEFAULT_METHOD, MAX_LIGHTS, METHODS
from brdf_suite.output.light_map import picture_of_lights
from brdf_suite.pipeline.environments import read_environment
from brdf_suite.pipeline.scene import find_environment


def add(actions: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Declare the action."""
    action = actions.add_parser(
        "lights",
        help="the lights from infinitely far away that represent the map",
        description="Divide the sphere into cells and give each a light of the cell's whole energy. The strongest "
        "comes first; strengths are ∫L dω over the cell, linear Rec. 2020, in the file's own units.",
    )
    action.add_argument(
        "environment",
        metavar="FILE",
        help="an .exr, .hdr or .brdfstudio environment, or booth, sunny, overcast",
    )
    action.add_argument(
        "-n",
        "--count",
        type=_count,
        default=16,
        metavar="N",
        help=f"how many, 1 to {MAX_LIGHTS:,} (default: 16)",
    )
    action.add_argument(
        "--method",
        choices=tuple(METHODS),
        default=DEFAULT_METHOD,
        help="relaxed errs least; structured and median-cut keep a sun apart even with few lights "
        f"(default: {DEFAULT_METHOD})",
    )
    add_layout(action)
    action.add_argument("--json", action="store_true", help="print one JSON object")
    action.add_argument(
        "--image", metavar="OUT.png", type=Path, help="write the map with a ring around each light, as PNG"
    )
    action.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Find the lights and print them."""
    if options.image is not None and options.image.suffix.lower() != ".png":
        raise FileError(options.image, "must end in .png")
    name, path = find_environment(options.environment)
    environment = read_environment(path, options.layout)
    lights = directional_lights(environment, options.count, options.method)
    if options.image is not None:
        _write_image(options.image, name, environment, lights)
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
    for note in environment.notes:
        print(f"note: {note}")
    whole = max(float(luminous.sum()), 1e-300)
    print(f"{name}: {len(lights)} lights by {options.method}; azimuth from +z towards +x")
    print("  elevation   azimuth     share   solid angle   strength (linear Rec. 2020)")
    for i in range(len(lights)):
        red, green, blue = lights.strengths[i]
        print(
            f"  {elevations[i]:8.2f}° {azimuths[i]:8.2f}° {100.0 * luminous[i] / whole:8.3f} % "
            f"{lights.solid_angles[i]:10.3g} sr   {red:.5g} {green:.5g} {blue:.5g}"
        )
    if options.image is not None:
        print(f"{options.image}: written")
    return 0


def _count(text: str) -> int:
    """Parse a number of lights (an argparse type)."""
    if not (text.isascii() and text.isdecimal()) or not 1 <= int(text[:9]) <= MAX_LIGHTS or len(text) > 9:
        raise argparse.ArgumentTypeError(f"{text!r} is not a number of lights from 1 to {MAX_LIGHTS:,}")
    return int(text)


def _write_image(path: Path, name: str, environment: Environment, lights: DirectionalLights) -> None:
    write_png(
        path, picture_of_lights(environment, lights), {"Title": f"{name}: {len(lights)} directional lights"}
    )
