"""``brdf-suite render FILE|PAINT -o out.png``: what reflects, on a surface in an environment, as a picture."""

from __future__ import annotations

import argparse
from pathlib import Path

from brdf_suite.cli.layout import add_layout
from brdf_suite.cli.output import print_json, progress_bar, size
from brdf_suite.documents.view import FRESNEL_MODES, TONE_CURVES, View


def add(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Declare the command."""
    command = commands.add_parser(
        "render",
        help="render a paint or a measured file to a PNG",
        description="Render a paint of any kind, or a measured file, on a surface in an environment. "
        "The environment is prefiltered once and kept in the cache.",
    )
    command.add_argument(
        "paint",
        metavar="FILE|PAINT",
        help="a .brdfpaint or measured file, or the name of a shipped or Table 1 paint (blue, table1_white, …)",
    )
    command.add_argument(
        "-o", "--output", type=Path, required=True, metavar="FILE", help="the picture to write (.png)"
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
    command.add_argument(
        "--size", type=size, default=(1280, 720), metavar="WxH", help="pixels (default: 1280x720)"
    )
    command.add_argument(
        "--exposure",
        type=float,
        default=None,
        metavar="EV",
        help="exposure in EV; +1 doubles the light (default: 0)",
    )
    command.add_argument(
        "--rotation",
        type=float,
        default=0.0,
        metavar="DEG",
        help="turn the light by degrees about the vertical, counter-clockwise seen from above",
    )
    command.add_argument(
        "--azimuth", type=float, default=None, metavar="DEG", help="camera azimuth in degrees"
    )
    command.add_argument(
        "--elevation", type=float, default=None, metavar="DEG", help="camera elevation in degrees, -89 to 89"
    )
    command.add_argument(
        "--tone",
        choices=TONE_CURVES,
        default=View().tone_curve,
        help="tone curve: faithful (one to one up to 0.8, then a shoulder; the default), "
        "neutral (Khronos PBR Neutral), characteristic (film), linear (clipped)",
    )
    command.add_argument(
        "--fresnel",
        choices=FRESNEL_MODES,
        default=View().fresnel,
        help="how coat and base follow the angle: off (as fitted), raised (sharp lobes by F(θ)/F(θ fit)), "
        f"multi_angle (weights fitted at several incidences); default: {View().fresnel}",
    )
    command.add_argument("--json", action="store_true", help="print what was done as one JSON object")
    command.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Render and write; print a line or a JSON object."""
    from dataclasses import asdict, replace

    from brdf_suite.pipeline.picture import render_to_file
    from brdf_suite.pipeline.scene import (
        check_environment,
        check_surface,
        default_view,
        environment_names,
        name_in_view,
        surface_names,
    )

    view = default_view()
    environment = view.environment if options.environment is None else options.environment
    surface = view.surface if options.mesh is None else options.mesh
    check_environment(environment)
    check_surface(surface)
    camera = replace(
        view.camera,
        azimuth_deg=view.camera.azimuth_deg if options.azimuth is None else options.azimuth,
        elevation_deg=view.camera.elevation_deg if options.elevation is None else options.elevation,
    )
    view = replace(
        view,
        camera=camera,
        environment=name_in_view(environment, environment_names()),
        surface=name_in_view(surface, surface_names()),
        rotation_deg=options.rotation,
        exposure_ev=view.exposure_ev if options.exposure is None else options.exposure,
        tone_curve=options.tone,
        fresnel=options.fresnel,
        environment_layout=options.layout,
    )
    with progress_bar("rendering", quiet=options.json) as progress:
        picture = render_to_file(options.paint, view, options.size, options.output, progress=progress)
    if options.json:
        facts = asdict(picture)
        facts["output"] = str(facts.pop("path"))
        print_json(facts)
        return 0
    for notice in picture.notices:
        print(f"note: {notice}")
    fit = f"fit {picture.fit_ms:.2f} ms" + (", time-limited" if picture.time_limited else "")
    print(
        f"{picture.path}: {picture.width}×{picture.height}, "
        f"{picture.paint} on {picture.surface} in {picture.environment}; "
        f"{fit}, maps {picture.maps_s:.2f} s, draw {picture.draw_ms:.0f} ms ({picture.renderer})"
    )
    return 0
