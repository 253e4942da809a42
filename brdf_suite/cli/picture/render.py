"""``brdf-suite render PAINT -o out.png``: picture of a material on a surface in an environment."""

from __future__ import annotations

import argparse
import os

from brdf_suite.cli.arguments import PAINT, add_arguments, add_export, add_output
from brdf_suite.cli.fit_options import add_fitting, parse_fitting
from brdf_suite.cli.output import export_progress, print_written
from brdf_suite.cli.picture.reference_options import (
    add_reference,
    check_renderer,
    run_raytraced,
    run_reference,
)
from brdf_suite.cli.picture.scene_options import add_lens, add_picture, add_scene, parse_settings, parse_view
from brdf_suite.command_parser import CommandParser


def add(command: CommandParser) -> None:
    """Declare the command."""
    command.description = (
        "Render a paint of any kind, or a measured file, on a surface in an environment: to a PNG as a "
        "screen shows it, or to an EXR as radiance before exposure and tone curve. Pictures of any size are drawn in "
        "tiles. The environment is prefiltered once and kept in the cache."
    )
    command.examples = (
        "brdf-suite render blue -o blue.png",
        "brdf-suite render paint.cxf -o car.exr --mesh car --environment sunny --size 1920x1080",
        "brdf-suite render copper -o - --size 320x180 > copper.png",
    )
    add_arguments(command, {"paint PAINT": PAINT})
    add_output(command, "the picture to write (.png or .exr)", stream=".png")
    add_scene(command)
    add_lens(command, still=True)
    add_picture(command)
    add_reference(command)
    add_fitting(command)
    add_export(command)
    command.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Render and write; print a line or a JSON object."""
    if options.renderer == "realtime":
        # The light is filtered on threads of its own, which those of numpy's matrix products only hinder. Numpy reads
        # this as it is imported.
        os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

    from brdf_suite.output.still import render_to_file

    check_renderer(options)
    view = parse_view(options)
    if options.renderer == "reference":
        return run_reference(options, view)
    if options.renderer == "raytraced":
        return run_raytraced(options, view)
    with export_progress("rendering", options) as progress:
        picture = render_to_file(
            options.paint,
            view,
            options.size,
            options.output,
            parse_settings(options),
            fitting=parse_fitting(options),
            progress=progress,
        )
    fit = f"fit {picture.fit_ms:.2f} ms" + (", time-limited" if picture.time_limited else "")
    print_written(
        picture,
        f"{picture.path}: {picture.width}×{picture.height}, "
        f"{picture.paint} on {picture.surface} in {picture.environment}; "
        f"{fit}, maps {picture.maps_s:.2f} s, draw {picture.draw_ms:.0f} ms ({picture.renderer})",
        as_json=options.json,
    )
    return 0
