"""``brdf-suite environment lights FILE``: approximation of an environment by directional lights."""

from __future__ import annotations

import argparse

import numpy as np

from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.cli.output import add_arguments, print_json, print_notes, whole_number
from brdf_suite.cli.picture.scene_options import add_environment
from brdf_suite.errors import FileError
from brdf_suite.files.images.png import write_png
from brdf_suite.lighting.lights import directional_lights
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
    add_environment(action)
    add_arguments(
        action,
        {
            "-n/--count N=16": f"how many, 1 to {MAX_LIGHTS:,} (default: 16)",
            f"--method={DEFAULT_METHOD}": "relaxed errs least; structured and median-cut keep a sun apart even with "
            f"few lights (default: {DEFAULT_METHOD})",
            "--json": "print one JSON object",
            "--image OUT.png": "write the map with a ring around each light, as PNG",
        },
        count=whole_number(1, MAX_LIGHTS),
        method=tuple(METHODS),
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
        title = f"{name}: {len(lights)} directional lights"
        write_png(options.image, picture_of_lights(environment, lights), {"Title": title})
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
