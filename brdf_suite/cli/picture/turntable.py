"""``brdf-suite turntable PAINT -o out.mp4``: turntable of the object as a video or a folder of pictures."""

from __future__ import annotations

import argparse

from brdf_suite.cli.arguments import PAINT, add_arguments, add_export, add_output
from brdf_suite.cli.fit_options import FITTING, add_fitting, parse_fitting
from brdf_suite.cli.output import export_progress, print_written
from brdf_suite.cli.picture.reference_options import RENDERERS, add_raytraced, check_renderer, samples
from brdf_suite.cli.picture.scene_options import add_lens, add_picture, add_scene, parse_settings, parse_view
from brdf_suite.command_parser import CommandParser
from brdf_suite.output.turntable import Turn, write_turntable
from brdf_suite.tracing.turntable import Budget, write_traced_turntable


def add(command: CommandParser) -> None:
    """Declare the command."""
    command.description = (
        "Render one turn of the object before a camera and a light that stand still: to an .mp4 or .webm "
        "(needs the extra “video”), or to a new folder of PNG pictures."
    )
    command.examples = (
        "brdf-suite turntable blue -o blue.mp4",
        "brdf-suite turntable copper -o frames --frames 36 --size 640x360",
    )
    add_arguments(command, {"paint PAINT": PAINT})
    add_output(command, "an .mp4, a .webm, or a new folder")
    turn = command.add_argument_group("turn")
    add_arguments(
        turn,
        {
            "--frames N=120": "of the turn (default: 120)",
            "--fps N=30.0": "frames a second of a video (default: 30)",
            "--clockwise": "seen from above",
            "--shutter-angle DEG=0.0": "motion blur: how long the shutter is open, 360 for the whole time of a frame "
            "(default: 0, sharp)",
        },
        fps=float,
        shutter_angle=float,
    )
    renderer = command.add_argument_group("renderer")
    add_arguments(
        renderer,
        {
            f"--renderer={RENDERERS[0]}": "realtime (the default), reference (path tracing) or raytraced; the last "
            "two with Mitsuba, an optional extra; their finished frames are kept in FILE.part, and the same command "
            "resumes from there",
            "--spp N": "samples a pixel of each frame (default: reference 64; raytraced as the quality has them)",
        },
        renderer=RENDERERS,
        spp=samples,
    )
    add_raytraced(renderer)
    add_fitting(command)
    add_scene(command)
    add_lens(command, still=False)
    add_picture(command, radiance=False)
    add_export(command)
    command.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Render and write; print a line or a JSON object."""
    check_renderer(options, _OF_OTHER, {})
    view = parse_view(options)
    turn = Turn(options.frames, options.fps, options.clockwise, options.shutter_angle)
    with export_progress("turntable", options) as progress:
        if options.renderer == "realtime":
            made = write_turntable(
                options.paint,
                view,
                options.size,
                options.output,
                turn,
                parse_settings(options),
                fitting=parse_fitting(options),
                progress=progress,
            )
        else:
            made = write_traced_turntable(
                options.renderer,
                options.paint,
                view,
                options.size,
                options.output,
                turn,
                Budget(options.quality or "medium", options.spp, options.table_split or "clamp"),
                fresh=options.fresh,
                progress=progress,
            )
    print_written(
        made,
        f"{made.path}: {made.frames} frames of {made.width}×{made.height}, {made.paint}",
        as_json=options.json,
    )
    return 0


_OF_OTHER = {
    "realtime": ("spp", "quality", "table_split", "fresh"),
    "reference": ("quality", "table_split", "exposures", "bits", "colour_space", "transparent", *FITTING),
    "raytraced": ("exposures", "bits", "colour_space", "transparent", *FITTING),
}
