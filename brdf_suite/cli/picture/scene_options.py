"""Command-line options for a scene (light, surface, camera and tone, over a view document) and for its picture file."""

from __future__ import annotations

import argparse
from dataclasses import replace
from fnmatch import fnmatchcase
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

from brdf_suite.cli.arguments import add_arguments
from brdf_suite.command_parser import CommandParser
from brdf_suite.documents.view import (
    BACKGROUNDS,
    ENVIRONMENT_LAYOUTS,
    FRESNEL_MODES,
    GLARE_MODES,
    TONE_CURVES,
    View,
)
from brdf_suite.documents.view_settings import (
    ILLUMINANTS,
    LENGTH_UNITS,
    SECOND_PAINT,
    SPARKLE_MODES,
    UP_AXES,
    Lamp,
    Material,
    PartMaterial,
    SurfaceLook,
)
from brdf_suite.errors import ValueRangeError, did_you_mean

if TYPE_CHECKING:
    from brdf_suite.output.picture_file import PictureSettings

_LAYOUT = {
    "--layout LAYOUT=auto": "how the image is laid out, where its shape misleads: "
    f"{', '.join(ENVIRONMENT_LAYOUTS[1:])} (default: auto)"
}
_MOST_NAMES = 30
"""Parts that a message names."""
_COLOUR_SPACES = ("srgb", "display-p3", "rec2020")


def add_scene(command: CommandParser, default_size: tuple[int, int] = (1280, 720)) -> None:
    """Declare the options read by :func:`parse_view`, and ``--size``."""
    width, height = default_size
    command.add_argument(
        "--view", metavar="FILE", type=Path, help="a .brdfview file; other options change it"
    )
    light = command.add_argument_group("light")
    add_arguments(
        light,
        {
            "--environment FILE|NAME": "an .exr or .hdr map, a .brdfstudio file, or photo_studio, street, "
            "light_tunnel, booth, overcast, sunny (default: photo_studio)",
            **_LAYOUT,
            "--rotation DEG": "turn the light by degrees about the vertical, counter-clockwise seen from above",
            "--lamp": "take the environment's white for that of a light booth's lamp (default: environment, as it is)",
            "--unadapted": "show the lamp's tint, as an eye used to daylight sees it at first",
            "--brightness X": "factor on the environment's light; 0: the view's lamps alone (default: 1)",
        },
        layout=ENVIRONMENT_LAYOUTS,
        lamp=ILLUMINANTS,
    )
    light.add_argument(
        "--point-light",
        type=_point_light,
        action="append",
        metavar="X,Y,Z,STRENGTH[,KELVIN[,DIAMETER]]",
        help="a lamp at a place in metres, y up, of a strength: illuminance at 1 m over pi, and a diameter in metres; "
        "up to eight, in place of the view's. Before a number below 0 write an equals sign: --point-light=-1,2,1,4",
    )
    shown = command.add_argument_group("object and camera")
    add_arguments(
        shown,
        {
            "--mesh FILE|NAME": "a mesh (glTF, OBJ, STL, PLY; FBX, USD, STEP and others with the extra `meshes`), or "
            "speed_form, sphere, panel, car (default: speed_form)",
            "--unit": "unit of the mesh's lengths (default: as its file says, else metres)",
            "--up": "axis that points up in the mesh (default: as its file says, else as it seems to stand)",
            "--tessellation MM": "how near triangles come to the surfaces of a CAD file, in millimetres "
            f"(default: {SurfaceLook().tessellation_mm:g})",
            "--paint-parts NAMES": "the parts that the paint is on, divided by commas, * for any letters (default: as "
            "names, looks and areas suggest)",
            "--[no-]ground": "put the mesh on a ground that takes its shadow (default: on)",
            "--[no-]occlusion": "darken what the light does not reach; baked once for each mesh (default: on)",
            "--azimuth DEG": "camera azimuth in degrees",
            "--elevation DEG": "camera elevation in degrees, -90 to 90",
        },
        unit=LENGTH_UNITS[1:],
        up=UP_AXES[1:],
        tessellation=float,
    )
    picture = command.add_argument_group("picture")
    add_arguments(
        picture,
        {
            f"--size WxH={width}x{height}": f"pixels (default: {width}x{height})",
            "--exposure EV": "exposure in EV; +1 doubles the light (default: 0.5 in photo_studio, else 0)",
            "--automatic-exposure": "bring the object's median luminance to 0.18; --exposure counts from there",
            "--tone": "tone curve: faithful (one to one up to 0.8, then a shoulder; the default), "
            "neutral (Khronos PBR Neutral), characteristic (film), aces, agx, linear (clipped)",
            "--glare": "spread light above white as an eye scatters it (default: eye); never in an EXR",
            "--fresnel": f"the coat's rise towards grazing (default: {View().fresnel})",
            "--background": "what is seen behind the object (default: blurred in photo_studio, else environment)",
            "--sparkle": f"how the paint's flakes are drawn (default: {View().sparkle.mode}; docs/method/sparkle.md)",
        },
        tone=TONE_CURVES,
        glare=GLARE_MODES,
        fresnel=FRESNEL_MODES,
        background=BACKGROUNDS,
        sparkle=SPARKLE_MODES,
    )
    picture.add_argument(
        "--no-fresnel", action="store_const", const="off", dest="fresnel", help="the same as --fresnel off"
    )
    command.set_defaults(f_stop=None, focus_distance=None, turn_blur=None)


def add_lens(command: CommandParser, *, still: bool) -> None:
    """Declare the options of the lens; those of a ``still`` picture have the blur of a turn."""
    lens = command.add_argument_group("lens")
    add_arguments(
        lens,
        {
            "--f-stop N": "depth of field: focal length over the diameter of the lens's opening; 0: all is sharp "
            "(the default)",
            "--focus-distance M": "metres from the camera to the sharp plane (default: what the middle of the picture "
            "shows of the object)",
        },
        f_stop=float,
        focus_distance=float,
    )
    if still:
        blur = "motion blur: by how much the object turns while the shutter is open (default: 0)"
        add_arguments(lens, {"--turn-blur DEG": blur}, turn_blur=float)


def _point_light(text: str) -> Lamp:
    try:
        numbers = [float(word) for word in text.split(",")]
    except ValueError as error:
        raise argparse.ArgumentTypeError(f"{text!r} is not X,Y,Z,STRENGTH[,KELVIN[,DIAMETER]]") from error
    if len(numbers) not in (4, 5, 6):
        raise argparse.ArgumentTypeError(
            f"{text!r} has {len(numbers)} numbers; expected X,Y,Z,STRENGTH[,KELVIN[,DIAMETER]]"
        )
    defaults = Lamp()
    x, y, z, strength = numbers[:4]
    kelvin, diameter = (*numbers[4:], *(defaults.temperature_k, defaults.diameter)[len(numbers) - 4 :])
    try:
        return Lamp("point", (x, y, z), strength=strength, temperature_k=kelvin, diameter=diameter)
    except ValueRangeError as error:
        raise argparse.ArgumentTypeError(f"{text!r}: {error}") from error


def parse_view(options: argparse.Namespace) -> View:
    """Return the view that the options ask for.

    Raises :class:`SuiteError`: the view, the environment or the mesh is not there, or a number out of its range.
    """
    from brdf_suite.documents.store import load_view
    from brdf_suite.pipeline.scene import (
        default_view,
        environment_names,
        find_environment,
        find_surface,
        in_environment,
        name_in_view,
        surface_names,
    )

    view = default_view() if options.view is None else load_view(options.view)
    if options.environment is not None:
        find_environment(options.environment)
        view = in_environment(view, name_in_view(options.environment, environment_names()))

    def given(**values: Any) -> dict[str, Any]:
        return {name: value for name, value in values.items() if value is not None}

    light = given(illuminant=options.lamp, brightness=options.brightness)
    if options.lamp is not None or options.unadapted:
        light["adapted"] = not options.unadapted
    changed = given(
        rotation_deg=options.rotation,
        exposure_ev=options.exposure,
        exposure_mode="automatic" if options.automatic_exposure else None,
        tone_curve=options.tone,
        glare=options.glare,
        fresnel=options.fresnel,
        background=options.background,
        lamps=None if options.point_light is None else tuple(options.point_light),
    )
    changed["camera"] = replace(
        view.camera, **given(azimuth_deg=options.azimuth, elevation_deg=options.elevation)
    )
    lens = given(f_number=options.f_stop, focus_distance=options.focus_distance, turn_deg=options.turn_blur)
    changed["lens"] = replace(view.lens, **lens)
    changed["light_colour"] = replace(view.light_colour, **light)
    changed["sparkle"] = replace(view.sparkle, **given(mode=options.sparkle))
    look = given(
        ground=options.ground,
        occlusion=options.occlusion,
        unit=options.unit,
        up=options.up,
        tessellation_mm=options.tessellation,
    )
    if options.mesh is not None:
        # Axes, unit and parts are those of the view's own file.
        look = {"unit": "file", "up": "file", "materials": (), **look}
    changed["surface_look"] = replace(view.surface_look, **look)
    if options.environment is not None or options.layout != "auto":
        changed["environment_layout"] = options.layout
    if options.mesh is not None:
        find_surface(options.mesh)
        changed["surface"] = name_in_view(options.mesh, surface_names())
    view = replace(view, **changed)
    find_environment(view.environment)
    find_surface(view.surface)
    return view if options.paint_parts is None else _with_paint_on(view, options.paint_parts)


def _with_paint_on(view: View, patterns: str) -> View:
    """Return the view with its paint on the parts that ``patterns`` name, and on no others."""
    from brdf_suite.pipeline.surface import load_shaped

    own = {part.name: part.material for part in load_shaped(view.surface, view.surface_look).parts}
    wanted = [word.strip() for word in patterns.split(",") if word.strip()]
    painted: set[str] = set()
    for pattern in wanted:
        found = {name for name in own if fnmatchcase(name.casefold(), pattern.casefold())}
        if not found:
            names = ", ".join(sorted(own)[:_MOST_NAMES]) + (", …" if len(own) > _MOST_NAMES else "")
            raise ValueRangeError(
                "--paint-parts",
                f"no part is called {pattern!r}{did_you_mean(pattern, own)}; there are {names}",
            )
        painted |= found
    chosen = {name: word for name, word in view.surface_look.chosen.items() if name not in own}
    for name, material in own.items():
        worn = view.surface_look.chosen.get(name, material)
        if name in painted:
            chosen[name] = "paint"
        elif worn in ("paint", SECOND_PAINT):
            chosen[name] = "neutral"
        elif name in view.surface_look.chosen:
            chosen[name] = worn
    parts = tuple(PartMaterial(name, cast(Material, word)) for name, word in chosen.items())
    return replace(view, surface_look=replace(view.surface_look, materials=parts))


def add_environment(command: CommandParser) -> None:
    """Declare an environment, given by place, and its ``--layout``."""
    add_arguments(
        command,
        {
            "environment FILE|NAME": "an .exr, .hdr or .brdfstudio environment, or photo_studio, street, "
            "light_tunnel, booth, overcast, sunny",
        },
    )
    add_environment_layout(command)


def add_environment_layout(command: CommandParser) -> None:
    """Declare ``--layout`` of environments that are given by place."""
    add_arguments(command, _LAYOUT, layout=ENVIRONMENT_LAYOUTS)


def add_picture(command: CommandParser, *, radiance: bool = True, sheet: bool = False) -> None:
    """Declare the options read by :func:`parse_settings`; ``radiance``: EXR beside PNG; ``sheet``: with text."""
    file = command.add_argument_group("file")
    spaces = _COLOUR_SPACES if radiance else _COLOUR_SPACES[:2]
    exr = "; 16 or 32 of an EXR (default: 32)" if radiance else ""
    command.set_defaults(bits=None, transparent=False)
    if not sheet:
        bits = "{8,16,32}" if radiance else "{8,16}"
        texts = {
            f"--bits {bits}": f"bits a channel: 8 or 16 of a PNG (default: 8){exr}",
            "--transparent": "the object alone, with its share of each pixel as alpha",
        }
        add_arguments(file, texts, bits=int)
    rest = ", linear; rec2020 for EXR" if radiance else ""
    texts = {
        "--colour-space": f"colours of the file, its ICC profile within (default: srgb{rest})",
        "--samples N": "real time: samples per pixel, where the GPU has them (default: 4)",
    }
    add_arguments(file, texts, colour_space=spaces)
    command.set_defaults(exposures=None)
    if not sheet:
        text = "real time, depth of field and motion blur: pictures that are averaged (default: 64)"
        add_arguments(file, {"--exposures N": text})


def parse_settings(options: argparse.Namespace) -> PictureSettings:
    """Return the settings that the options ask for."""
    from brdf_suite.output.picture_file import PictureSettings

    picture = PictureSettings(options.bits, options.colour_space, transparent=options.transparent)
    given: dict[str, Any] = {"samples": options.samples, "exposures": options.exposures}
    return replace(picture, **{name: value for name, value in given.items() if value is not None})
