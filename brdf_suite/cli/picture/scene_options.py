"""Command-line options for a scene (light, surface, camera and tone, over a view document) and for its picture file."""

from __future__ import annotations

import argparse
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from brdf_suite.cli.output import size
from brdf_suite.documents.view import BACKGROUNDS, ENVIRONMENT_LAYOUTS, FRESNEL_MODES, TONE_CURVES, View
from brdf_suite.documents.view_settings import ILLUMINANTS, SPARKLE_MODES, Lamp, LightColour
from brdf_suite.errors import ValueRangeError

if TYPE_CHECKING:
    from brdf_suite.output.picture_file import PictureSettings

_COLOUR_SPACES = ("srgb", "display-p3", "rec2020")


def add_scene(command: argparse.ArgumentParser, default_size: tuple[int, int] = (1280, 720)) -> None:
    """Declare the options read by :func:`parse_view`, and ``--size``."""
    command.add_argument(
        "--view", type=Path, default=None, metavar="FILE", help="a .brdfview file; other options change it"
    )
    command.add_argument(
        "--environment",
        default=None,
        metavar="FILE|NAME",
        help="an .exr or .hdr map, a .brdfstudio file, or booth, sunny, overcast (default: booth)",
    )
    add_layout(command)
    command.add_argument(
        "--mesh",
        default=None,
        metavar="FILE|NAME",
        help="a .glb, .gltf, .obj, .stl or .ply mesh in metres, or speed_form, sphere, panel, car "
        "(default: speed_form)",
    )
    width, height = default_size
    command.add_argument(
        "--ground",
        action=argparse.BooleanOptionalAction,
        default=None,
        help="put the mesh on a ground that takes its shadow (default: no ground)",
    )
    command.add_argument(
        "--occlusion",
        action=argparse.BooleanOptionalAction,
        default=None,
        help="darken what the light does not reach; baked once for each mesh (default: on)",
    )
    command.add_argument(
        "--size", type=size, default=default_size, metavar="WxH", help=f"pixels (default: {width}x{height})"
    )
    command.add_argument(
        "--exposure",
        type=float,
        default=None,
        metavar="EV",
        help="exposure in EV; +1 doubles the light (default: 0)",
    )
    command.add_argument(
        "--automatic-exposure",
        action="store_true",
        help="bring the object's median luminance to 0.18; --exposure counts from there",
    )
    command.add_argument(
        "--lamp",
        choices=ILLUMINANTS,
        default=None,
        help="take the environment's white for that of a light booth's lamp (default: environment, as it is)",
    )
    command.add_argument(
        "--unadapted",
        action="store_true",
        help="show the lamp's tint, as an eye used to daylight sees it at first",
    )
    command.add_argument(
        "--brightness",
        type=float,
        default=None,
        metavar="X",
        help="factor on the environment's light; 0: the view's lamps alone (default: 1)",
    )
    command.add_argument(
        "--point-light",
        type=_point_light,
        action="append",
        default=None,
        metavar="X,Y,Z,STRENGTH[,KELVIN]",
        help="a small lamp at a place in metres, y up, of a strength: illuminance at 1 m over pi; up to eight, in "
        "place of the view's. Before a number below 0 write an equals sign: --point-light=-1,2,1,4",
    )
    command.add_argument(
        "--rotation",
        type=float,
        default=None,
        metavar="DEG",
        help="turn the light by degrees about the vertical, counter-clockwise seen from above",
    )
    command.add_argument(
        "--azimuth", type=float, default=None, metavar="DEG", help="camera azimuth in degrees"
    )
    command.add_argument(
        "--elevation", type=float, default=None, metavar="DEG", help="camera elevation in degrees, -90 to 90"
    )
    command.add_argument(
        "--tone",
        choices=TONE_CURVES,
        default=None,
        help="tone curve: faithful (one to one up to 0.8, then a shoulder; the default), "
        "neutral (Khronos PBR Neutral), characteristic (film), aces, agx, linear (clipped)",
    )
    command.add_argument(
        "--fresnel",
        choices=FRESNEL_MODES,
        default=None,
        help=f"the coat's rise towards grazing (default: {View().fresnel})",
    )
    command.add_argument(
        "--background",
        choices=BACKGROUNDS,
        default=None,
        help="what is seen behind the object (default: environment)",
    )
    command.add_argument(
        "--sparkle",
        choices=SPARKLE_MODES,
        default=None,
        help=f"how the paint's flakes are drawn (default: {View().sparkle.mode}; docs/method/sparkle.md)",
    )
    command.add_argument(
        "--no-fresnel", action="store_const", const="off", dest="fresnel", help="the same as --fresnel off"
    )


def _point_light(text: str) -> Lamp:
    try:
        numbers = [float(word) for word in text.split(",")]
    except ValueError as error:
        raise argparse.ArgumentTypeError(f"{text!r} is not X,Y,Z,STRENGTH[,KELVIN]") from error
    if len(numbers) not in (4, 5):
        raise argparse.ArgumentTypeError(
            f"{text!r} has {len(numbers)} numbers; expected X,Y,Z,STRENGTH[,KELVIN]"
        )
    x, y, z, strength = numbers[:4]
    try:
        lamp = Lamp("point", (x, y, z), strength=strength)
        return replace(lamp, temperature_k=numbers[4]) if len(numbers) == 5 else lamp
    except ValueRangeError as error:
        raise argparse.ArgumentTypeError(f"{text!r}: {error}") from error


def parse_view(options: argparse.Namespace) -> View:
    """Return the view that the options ask for.

    Raises
    ------
    SuiteError
        The view, the environment or the mesh is not there, or a number out of its range.
    """
    from brdf_suite.documents.store import load_view
    from brdf_suite.pipeline.scene import (
        check_environment,
        check_surface,
        default_view,
        environment_names,
        name_in_view,
        surface_names,
    )

    view = default_view() if options.view is None else load_view(options.view)
    camera = {
        name: value
        for name, value in (("azimuth_deg", options.azimuth), ("elevation_deg", options.elevation))
        if value is not None
    }
    changed: dict[str, object] = {
        name: value
        for name, value in (
            ("rotation_deg", options.rotation),
            ("exposure_ev", options.exposure),
            ("tone_curve", options.tone),
            ("fresnel", options.fresnel),
            ("background", options.background),
        )
        if value is not None
    }
    if options.automatic_exposure:
        changed["exposure_mode"] = "automatic"
    if options.lamp is not None:
        changed["light_colour"] = replace(
            view.light_colour, illuminant=options.lamp, adapted=not options.unadapted
        )
    elif options.unadapted:
        changed["light_colour"] = replace(view.light_colour, adapted=False)
    if options.brightness is not None:
        colour = changed.get("light_colour", view.light_colour)
        assert isinstance(colour, LightColour)
        changed["light_colour"] = replace(colour, brightness=options.brightness)
    if options.point_light is not None:
        changed["lamps"] = tuple(options.point_light)
    if options.sparkle is not None:
        changed["sparkle"] = replace(view.sparkle, mode=options.sparkle)
    look = {name: getattr(options, name) for name in ("ground", "occlusion")}
    look = {name: on for name, on in look.items() if on is not None}
    if look:
        changed["surface_look"] = replace(view.surface_look, **look)
    if options.environment is not None:
        check_environment(options.environment)
        changed["environment"] = name_in_view(options.environment, environment_names())
        changed["environment_layout"] = options.layout
    elif options.layout != "auto":
        changed["environment_layout"] = options.layout
    if options.mesh is not None:
        check_surface(options.mesh)
        changed["surface"] = name_in_view(options.mesh, surface_names())
    view = replace(view, camera=replace(view.camera, **camera), **changed)  # type: ignore[arg-type]  # View checks them
    check_environment(view.environment)
    check_surface(view.surface)
    return view


def add_layout(command: argparse.ArgumentParser) -> None:
    """Declare ``--layout``."""
    command.add_argument(
        "--layout",
        choices=ENVIRONMENT_LAYOUTS,
        default="auto",
        metavar="LAYOUT",
        help="how the image is laid out, where its shape misleads: "
        + ", ".join(ENVIRONMENT_LAYOUTS[1:])
        + " (default: auto)",
    )


def add_picture(command: argparse.ArgumentParser, *, radiance: bool = True, sheet: bool = False) -> None:
    """Declare the options read by :func:`parse_settings`; ``radiance``: EXR beside PNG; ``sheet``: with text."""
    spaces = _COLOUR_SPACES if radiance else _COLOUR_SPACES[:2]
    exr = "; 16 or 32 of an EXR (default: 32)" if radiance else ""
    command.set_defaults(bits=None, transparent=False)
    if not sheet:
        command.add_argument(
            "--bits",
            type=int,
            choices=(8, 16, 32) if radiance else (8, 16),
            help=f"bits a channel: 8 or 16 of a PNG (default: 8){exr}",
        )
        command.add_argument(
            "--transparent",
            action="store_true",
            help="the object alone, with its share of each pixel as alpha",
        )
    rest = ", linear; rec2020 for EXR" if radiance else ""
    command.add_argument(
        "--colour-space",
        choices=spaces,
        default=None,
        help=f"colours of the file, its ICC profile within (default: srgb{rest})",
    )
    command.add_argument(
        "--samples",
        type=int,
        default=None,
        metavar="N",
        help="real time: samples per pixel, where the GPU has them (default: 4)",
    )


def parse_settings(options: argparse.Namespace) -> PictureSettings:
    """Return the settings that the options ask for."""
    from brdf_suite.output.picture_file import PictureSettings

    picture = PictureSettings(options.bits, options.colour_space, transparent=options.transparent)
    return picture if options.samples is None else replace(picture, samples=options.samples)
