"""``brdf-suite`` without a command, ``designer``, ``viewer``…: start of the programs, each in its own process."""

from __future__ import annotations

import argparse
import signal
import subprocess
import sys
import time
from collections.abc import Mapping, Sequence
from pathlib import Path

from brdf_suite.cli.arguments import PAINT
from brdf_suite.cli.output import print_done, print_notes, progress_bar
from brdf_suite.command_parser import CommandParser
from brdf_suite.errors import SuiteError
from brdf_suite.processes import child_command
from brdf_suite.screen import screen_missing

PROGRAMS = {
    "designer": ("brdf_designer", "edit a paint"),
    "viewer": ("brdf_viewer", "show a paint on a surface"),
    "lobes": ("brdf_lobe_visualizer", "look at reflectances in three dimensions"),
    "swatch": ("brdf_color_swatch", "organize paints as palettes"),
}
_OPENED = ("designer", "viewer")
"""What opens where no program is named."""
_FALLBACK_PICTURE = "brdf-suite.png"
_FALLBACK_SIZE = (1280, 720)
_PATIENCE_S = 20.0
_POLL_S = 0.1


def add(commands: argparse._SubParsersAction[CommandParser]) -> None:
    """Declare one command for each program, and ``open`` for both."""
    both = commands.add_parser(
        "open",
        help="open Designer and Viewer, linked (the default)",
        description="Open Designer and Viewer beside each other; the Viewer follows Designer. The options of one "
        "program are those of the command that opens it alone: `brdf-suite designer --help`. Without a screen the "
        "default scene is rendered to brdf-suite.png instead.",
    )
    both.examples = ("brdf-suite open copper",)
    both.add_argument("paint", nargs="?", metavar="PAINT", help=PAINT)
    both.set_defaults(run=open_both)
    for name, (_package, what) in PROGRAMS.items():
        commands.add_parser(name, help=f"{what} (options: {name} --help)")


def open_both(options: argparse.Namespace) -> int:
    """Open Designer and Viewer, linked, and wait for both; without a screen, render the default scene."""
    paint = getattr(options, "paint", None)
    if paint == "":
        raise SuiteError("The name of the paint is empty; give a .brdfpaint file or a shipped paint.")
    missing = screen_missing()
    if missing is not None:
        return _render_instead(missing, paint)
    arguments = [paint] if paint else []
    # Both show the requested paint; a Viewer that has received one by name would otherwise keep it.
    own = {"viewer": ["--follow"]}
    commands = {name: child_command(PROGRAMS[name][0], *arguments, *own.get(name, [])) for name in _OPENED}
    return 1 if any(_run(commands).values()) else 0


def _run(commands: Mapping[str, list[str]]) -> dict[str, int]:
    """Run programs beside each other, wait for all of them, and return their exit statuses; end them on a signal."""
    # A flag and not an exception: wherever a signal arrives, no program is left behind. Asked to end, the command takes
    # its windows with it; each keeps its unsaved work for the next start.
    received: list[int] = []
    before = {
        number: signal.signal(number, lambda number, _frame: received.append(number))
        for number in (signal.SIGINT, signal.SIGTERM)
    }
    running: dict[str, subprocess.Popen[bytes]] = {}
    statuses: dict[str, int] = {}
    try:
        for name, command in commands.items():
            running[name] = subprocess.Popen(command)  # noqa: S603 - a module of ours
        while running and not received:
            for name, process in list(running.items()):
                code = process.poll()
                if code is None:
                    continue
                statuses[name] = code
                del running[name]
                if code != 0 and len(commands) > 1:
                    print(f"brdf-suite: {name} ended with status {code}", file=sys.stderr)
            if running:
                time.sleep(_POLL_S)
    finally:
        _end(running)
        for number, handler in before.items():
            signal.signal(number, handler)
    if received:
        raise KeyboardInterrupt
    return statuses


def _end(running: dict[str, subprocess.Popen[bytes]]) -> None:
    """End the programs: asked first, and where one does not in time, by force."""
    for process in running.values():
        process.terminate()
    for process in running.values():
        try:
            process.wait(_PATIENCE_S)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()


def open_one(name: str, arguments: Sequence[str]) -> int:
    """Open one program with its own ``arguments``, wait for it, and return its exit status."""
    missing = screen_missing()
    if missing is not None and not {"-h", "--help", "--version"} & set(arguments):
        raise SuiteError(f"The program cannot open a window: {missing}. `brdf-suite render` needs none.")
    package, _what = PROGRAMS[name]
    return _run({name: child_command(package, *arguments)})[name]


def _render_instead(missing: str, paint: str | None) -> int:
    from brdf_suite.output.still import render_to_file
    from brdf_suite.pipeline.material import default_paint_name
    from brdf_suite.pipeline.scene import default_view

    print_notes([f"{missing}; rendering the default scene to {_FALLBACK_PICTURE} instead"])
    with progress_bar("rendering") as progress:
        picture = render_to_file(
            paint or default_paint_name(),
            default_view(),
            _FALLBACK_SIZE,
            Path(_FALLBACK_PICTURE),
            progress=progress,
        )
    print_done(f"wrote {picture.path} ({picture.width}×{picture.height} pixels, {picture.renderer})")
    return 0
