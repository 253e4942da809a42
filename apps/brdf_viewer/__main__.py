"""``brdf-viewer``: see a paint on a surface in an environment, linked with Designer."""

from __future__ import annotations

import argparse
import dataclasses
import json
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from brdf_qt.program.application import create_application, process_age_s, run
from brdf_qt.program.arguments import add_language, window_size
from brdf_qt.program.settings import settings
from brdf_qt.program.theme import THEMES
from PySide6.QtCore import Qt, QTimer

if TYPE_CHECKING:
    from brdf_viewer.controller import ViewerController

from brdf_suite.documents.store import load_view
from brdf_suite.documents.view import ENVIRONMENT_LAYOUTS, View
from brdf_suite.errors import SuiteError
from brdf_suite.pipeline.material import default_paint_name
from brdf_suite.pipeline.scene import environment_names, name_in_view, surface_names
from brdf_viewer.traced.request import QUALITIES, RENDERERS

_SETTLE_MS = 200
"""Between the first measured frame and a screenshot: a fit that ran into its time limit is done again by then."""


def parser() -> argparse.ArgumentParser:
    """Return the parser of the command line."""
    parser = argparse.ArgumentParser(
        prog="brdf-viewer",
        description="See a paint on a surface in an environment. Follows Designer while it is open.",
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
    parser.add_argument("--theme", choices=THEMES, help="grey of the window, for this run")
    add_language(parser)
    parser.add_argument("--size", metavar="WxH", type=window_size, help="size of the window in pixels")
    parser.add_argument("--screenshot", metavar="FILE", help="save the window as PNG once complete, and end")
    parser.add_argument("--quit-after", metavar="SECONDS", type=float, help="end after so many seconds")
    parser.add_argument(
        "--report-startup",
        action="store_true",
        help='print {"ready_s": s, "complete_s": s}: seconds from the start of the process to the first painted '
        'window, and to the first complete picture; with --screenshot "finished_s" too, to the first picture that '
        "nothing on its way will change",
    )
    return parser


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the Viewer; return the exit status."""
    options = parser().parse_args(arguments)
    app = create_application("Viewer", theme_name=options.theme, language=options.language)
    from brdf_viewer.controller import ViewerController

    follow = options.follow or options.paint is None
    try:
        view = _first_view(options)
    except SuiteError as error:
        print(f"brdf-viewer: {error}", file=sys.stderr)
        return 1
    controller = ViewerController(view, options.paint or default_paint_name(), follow=follow)
    window = controller.window
    if options.size:
        window.resize(*options.size)
    _choose_renderer(controller, options)
    if options.report_startup:
        _report_startup(controller, until_finished=bool(options.screenshot))
    outcome = _screenshot(controller, Path(options.screenshot)) if options.screenshot else Outcome()
    if options.quit_after is not None:
        QTimer.singleShot(round(1000 * options.quit_after), window.close)
    return run(app, window) or outcome.status


def _first_view(options: argparse.Namespace) -> View:
    from brdf_viewer.documents.remembered import recall

    wanted: dict[str, Any] = {
        "environment": options.environment and name_in_view(options.environment, environment_names()),
        "surface": options.surface and name_in_view(options.surface, surface_names()),
    }
    if wanted["environment"]:
        wanted["environment_layout"] = options.layout
    start = load_view(options.view) if options.view else recall(settings())
    return dataclasses.replace(start, **{k: v for k, v in wanted.items() if v})


def _choose_renderer(controller: ViewerController, options: argparse.Namespace) -> None:
    if options.spp is not None:
        controller.traced.set_samples(options.spp)
    if options.quality is not None:
        controller.traced.set_quality(options.quality)
    if options.renderer != "realtime" or options.quality is not None:
        controller.traced.set_renderer(options.renderer)


def _report_startup(controller: ViewerController, *, until_finished: bool) -> None:
    """Print one line of JSON at the first complete picture, or at the first finished one."""
    done: set[str] = set()
    times: dict[str, float] = {}

    def reached(what: str) -> None:
        # With maps from the cache the picture may be complete before the window is painted: it is seen only then.
        done.add(what)
        if "painted" in done and not times:
            times["ready_s"] = round(process_age_s(), 3)
        for key, wanted in (("complete_s", {"painted", "complete"}), ("finished_s", {"painted", "finished"})):
            if wanted <= done and key not in times:
                times[key] = round(process_age_s(), 3)
                if (key == "finished_s") == until_finished:
                    print(json.dumps(times), flush=True)

    def painted() -> None:
        reached("painted")

    def complete() -> None:
        reached("complete")

    controller.window.first_painted.connect(painted)
    controller.picture_complete.connect(complete)
    controller.picture_finished.connect(lambda: reached("finished"))


@dataclasses.dataclass
class Outcome:
    """What a run without a user came to; ``status`` is the exit status."""

    status: int = 0


def _screenshot(controller: ViewerController, path: Path) -> Outcome:
    """Save the window once its picture is complete, and close it; the outcome is 1 until that is done."""
    window = controller.window
    outcome = Outcome(1)

    def save() -> None:
        if window.grab().save(str(path)):
            outcome.status = 0
        else:
            print(f"brdf-viewer: {path}: the picture could not be written.", file=sys.stderr)
        window.close()

    def failed(kind: str, text: str) -> None:
        print(f"brdf-viewer: {text}", file=sys.stderr)
        if kind == "picture" or not controller.state.is_complete:
            window.close()

    single_shot = Qt.ConnectionType.SingleShotConnection

    def settled() -> None:
        if controller.traced.is_settled:
            QTimer.singleShot(_SETTLE_MS, save)
        else:
            controller.traced.settled.connect(lambda: QTimer.singleShot(_SETTLE_MS, save), single_shot)

    controller.settled.connect(settled, single_shot)
    controller.failed.connect(failed)
    return outcome


if __name__ == "__main__":
    sys.exit(main())
