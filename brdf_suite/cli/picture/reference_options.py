"""``brdf-suite render --renderer reference|raytraced``: the same picture by path tracing or ray tracing."""

from __future__ import annotations

import argparse
import math
from collections.abc import Mapping, Sequence

from brdf_suite.cli.arguments import add_arguments, whole_number
from brdf_suite.cli.fit_options import FITTING
from brdf_suite.cli.output import export_progress, print_written, progress_bar
from brdf_suite.cli.picture.scene_options import parse_settings
from brdf_suite.command_parser import CommandParser
from brdf_suite.documents.view import View
from brdf_suite.errors import SuiteError

RENDERERS = ("realtime", "reference", "raytraced")
QUALITIES = ("fast", "medium", "high")
_OF_OTHER = {
    "realtime": ("spp", "time", "fresh", "denoise", "quality", "table_split"),
    "reference": ("samples", "exposures", "quality", "table_split", *FITTING),
    "raytraced": (
        "bits",
        "colour_space",
        "transparent",
        "follow",
        "samples",
        "exposures",
        "denoise",
        *FITTING,
    ),
}
_INSTEAD = {"samples": "; its samples are --spp", "spp": "; its samples are --samples"}


def add_reference(command: CommandParser) -> None:
    """Declare the choice of renderer and the budgets of those that trace."""
    renderer = command.add_argument_group("renderer")
    add_arguments(
        renderer,
        {
            f"--renderer={RENDERERS[0]}": "realtime (the default): lobes in prefiltered light; reference: path "
            "tracing with Mitsuba, an optional extra; an EXR then holds its variance too; raytraced: directional "
            "lights and sampled reflections, Mitsuba too",
            "--spp N": "samples a pixel (default: reference 256; raytraced as the quality has them)",
            "--time S": "reference and raytraced: seconds to trace at most",
            "--denoise": "reference: take the noise out with OptiX, on an NVIDIA graphics card; an EXR keeps the "
            "noisy light too",
        },
        renderer=RENDERERS,
        spp=samples,
        time=_seconds,
    )
    add_raytraced(renderer)


def add_raytraced(group: argparse._ArgumentGroup) -> None:
    """Declare the options of the ray tracer, and the restart of a traced picture."""
    add_arguments(
        group,
        {
            "--quality": "raytraced: 16 lights and one mirrored ray; 128, 16 rays and 16 samples (the default); "
            "1,024, 256 and 64",
            "--table-split {clamp,subtract}": "raytraced: how the peak is cut off a measured table (default: clamp)",
            "--fresh": "reference and raytraced: start again; else the same command resumes from what an "
            "interrupted one kept",
        },
        quality=QUALITIES,
    )


def check_renderer(
    options: argparse.Namespace,
    of_other: Mapping[str, Sequence[str]] = _OF_OTHER,
    instead: Mapping[str, str] = _INSTEAD,
) -> None:
    """Raise :class:`SuiteError` where an option is for the other renderer: left out silently, it would mislead.

    ``of_other`` has the names of the options that a renderer lacks, ``instead`` what ends the sentence about one.
    """
    given = [name for name in of_other[options.renderer] if getattr(options, name, None)]
    if given:
        name = given[0].replace("_", "-")
        raise SuiteError(
            f"With --renderer {options.renderer} there is no --{name}; leave it out{instead.get(name, '')}."
        )


def run_reference(options: argparse.Namespace, view: View) -> int:
    """Path-trace and write; print a line or a JSON object."""
    from brdf_suite.tracing.reference.picture import render_reference

    with export_progress("path tracing", options) as progress:
        picture = render_reference(
            options.paint,
            view,
            options.size,
            options.output,
            settings=parse_settings(options),
            denoise=options.denoise,
            samples=options.spp,
            seconds=options.time,
            fresh=options.fresh,
            progress=progress,
        )
    before = f", {picture.resumed_samples} of them from before" if picture.resumed_samples else ""
    noise = f"noise {100.0 * picture.noise:.1f} %" if math.isfinite(picture.noise) else "noise not known"
    print_written(
        picture,
        f"{picture.path}: {picture.width}×{picture.height}, {picture.paint} on {picture.surface} in "
        f"{picture.environment}; {picture.samples} samples a pixel{before}, {noise}, "
        f"{picture.seconds:.1f} s ({picture.renderer})",
        as_json=options.json,
        noise=picture.noise if math.isfinite(picture.noise) else None,
    )
    return 0


def run_raytraced(options: argparse.Namespace, view: View) -> int:
    """Ray-trace and write; print a line or a JSON object."""
    from brdf_suite.tracing.raytraced.file import render_raytraced

    with progress_bar("ray tracing", quiet=options.json) as progress:
        picture = render_raytraced(
            options.paint,
            view,
            options.size,
            options.output,
            quality=options.quality or "medium",
            samples=options.spp,
            seconds=options.time,
            fresh=options.fresh,
            tables=options.table_split or "clamp",
            progress=progress,
        )
    before = f", {picture.resumed_samples} of them from before" if picture.resumed_samples else ""
    rays = "one mirrored ray" if picture.reflections == 1 else f"{picture.reflections} reflected rays"
    count = "one sample" if picture.samples == 1 else f"{picture.samples} samples"
    print_written(
        picture,
        f"{picture.path}: {picture.width}×{picture.height}, {picture.paint} on {picture.surface} in "
        f"{picture.environment}; {picture.lights} lights, {rays}, {count} a pixel{before}, "
        f"{picture.seconds:.1f} s ({picture.renderer})",
        as_json=options.json,
    )
    return 0


samples = whole_number(1, 1_000_000)
"""Parses a number of samples a pixel (an argparse type)."""


def _seconds(text: str) -> float:
    try:
        seconds = float(text)
    except ValueError:
        seconds = math.nan
    if not 0.0 < seconds <= 1e6:
        raise argparse.ArgumentTypeError(
            f"{text!r} is not a time in seconds, more than 0 and at most a million"
        )
    return seconds
