"""``brdf-suite environment lights FILE``: approximation of an environment by directional lights."""

from __future__ import annotations

import argparse

import numpy as np
from numpy.typing import NDArray

from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.cli.output import add_arguments, print_json, print_notes, whole_number
from brdf_suite.cli.picture.scene_options import add_environment
from brdf_suite.errors import FileError
from brdf_suite.files.images.png import write_png
from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.latlong import angles, column_angles, direction, ring_angles, sample
from brdf_suite.lighting.lights import DirectionalLights, directional_lights
from brdf_suite.lighting.lights.extract import DEFAULT_METHOD, MAX_LIGHTS, METHODS
from brdf_suite.pipeline.environments import read_environment
from brdf_suite.pipeline.scene import find_environment
from brdf_suite.realtime.pictures.tone_curves import to_display

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
