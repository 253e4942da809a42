"""``brdf-viewer``: see a paint on a surface in an environment, linked with Designer."""

from __future__ import annotations

import argparse
import dataclasses
from collections.abc import Sequence
from functools import partial
from typing import Any

from brdf_qt.program.run import program_parser, run_program
from brdf_qt.program.settings import settings

from brdf_suite.documents.view import ENVIRONMENT_LAYOUTS, View
from brdf_suite.pipeline.material import default_paint_name
from brdf_suite.pipeline.scene import environment_names, in_environment, name_in_view, surface_names
from brdf_viewer.controller import ViewerController
from brdf_viewer.documents.first_view import FirstView
from brdf_viewer.documents.remembered import recall
from brdf_viewer.tracing.request import QUALITIES, RENDERERS


def parser() -> argparse.ArgumentParser:
    """Return the parser of the command line."""
    parser = program_parser(
        "brdf-viewer",
        "See a paint on a surface in an environment. Follows Designer while it is open.",
        'to the first complete picture; with --screenshot "finished_s" too, to the first picture that nothing on its '
        "way will change",
        epilog="Left drag orbits, middle or Shift drag pans, the wheel zooms, Alt drag turns the light. "
        "F frames, 1-4 are presets, space is the turntable, Tab hides the panels, Ctrl+K finds any command.",
    )
    parser.add_argument(
        "paint",
        nargs="?",
        metavar="PAINT",
        help="a .brdfpaint file, a measured file, a .brdfpalette or a shipped paint's name; it stays until Designer "
        "is followed by hand",
    )
    parser.add_argument(
        "--follow", action="store_true", help="show PAINT only until Designer has one, and follow it"
    )
    parser.add_argument(
        "--environment",
        metavar="NAME|FILE",
        help="a shipped environment, or an .exr, .hdr or .brdfstudio file",
    )
    parser.add_argument(
        "--layout",
        choices=ENVIRONMENT_LAYOUTS,
        default="auto",
        metavar="LAYOUT",
        help=f"how the environment's image is laid out: {', '.join(ENVIRONMENT_LAYOUTS)}",
    )
    parser.add_argument("--surface", metavar="NAME|FILE", help="a shipped surface, or a mesh file")
    parser.add_argument("--view", metavar="FILE", help="a .brdfview file: camera, light and all settings")
    parser.add_argument(
        "--renderer",
        choices=RENDERERS,
        default="realtime",
        help="renderer of the picture; a screenshot is taken when the picture is finished",
    )
    parser.add_argument("--quality", choices=QUALITIES, help="preset of the ray tracer; remembered")
    parser.add_argument(
        "--spp", metavar="N", type=int, help="samples per pixel at which the path tracer stops; remembered"
    )
    return parser


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the Viewer; return the exit status."""
    return run_program("Viewer", parser(), make_viewer, arguments)


def make_viewer(options: argparse.Namespace) -> ViewerController:
    """Return the Viewer that the options ask for.

    Raises :class:`~brdf_suite.errors.SuiteError`: the view cannot be read.
    """
    follow = options.follow or options.paint is None
    reading = FirstView(options.view) if options.view else None
    adapt = partial(_adapt, options)
    remembered = recall(settings())
    view = None if reading is None else reading.wait()
    first = adapt(remembered if view is None else view)
    controller = ViewerController(first, options.paint or default_paint_name(), follow=follow)
    if options.view and view is None:
        controller.views.open(options.view, adapt)
    if options.spp is not None:
        controller.traced.set_samples(options.spp)
    if options.quality is not None:
        controller.traced.set_quality(options.quality)
    if options.renderer != "realtime" or options.quality is not None:
        controller.traced.set_renderer(options.renderer)
    return controller


def _adapt(options: argparse.Namespace, view: View) -> View:
    """Return a view with what other options of the command line ask for."""
    wanted: dict[str, Any] = {
        "environment": options.environment and name_in_view(options.environment, environment_names()),
        "surface": options.surface and name_in_view(options.surface, surface_names()),
    }
    if wanted["environment"]:
        wanted["environment_layout"] = options.layout
    if wanted["environment"]:
        view = in_environment(view, wanted["environment"])
    return dataclasses.replace(view, **{k: v for k, v in wanted.items() if v})
