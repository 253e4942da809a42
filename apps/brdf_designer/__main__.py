"""Designer: the program that designs paints. ``brdf-designer --help`` lists its options."""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Sequence
from pathlib import Path

from brdf_qt.program.application import create_application, process_age_s, run
from brdf_qt.program.arguments import add_language, window_size
from brdf_qt.program.theme import THEMES
from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication

from brdf_designer.assembly import Designer

_LOOK_EVERY_MS = 100
_LONGEST_WAIT_S = 60.0
"""A picture of the window is taken without what has not come by then."""


def main(argv: Sequence[str] | None = None) -> int:
    """Run Designer; return the exit status."""
    options = _parser().parse_args(argv)
    app = create_application("Designer", theme_name=options.theme, language=options.language)
    designer = Designer()
    if options.paint is not None:
        designer.open(options.paint)
    if options.size is not None:
        designer.window.resize(*options.size)
        designer.window.fit_inspector()
    _when_ready(app, designer, options)
    return run(app, designer.window)


def _when_ready(app: QApplication, designer: Designer, options: argparse.Namespace) -> None:
    """Do what the options ask for once the window is painted; the plot and the link follow that paint."""
    times: dict[str, float] = {}

    def painted() -> None:
        times["ready_s"] = round(process_age_s(), 3)
        QTimer.singleShot(0, complete)

    def complete() -> None:
        times["complete_s"] = round(process_age_s(), 3)
        if options.screenshot is not None:
            wait = QTimer(app)
            wait.setInterval(_LOOK_EVERY_MS)
            wait.timeout.connect(lambda: take(wait))
            wait.start()
            return
        report()
        if options.quit_after is not None:
            QTimer.singleShot(round(1000 * options.quit_after), lambda: app.exit(0))

    def report() -> None:
        if options.report_startup:
            sys.stdout.write(json.dumps(times) + "\n")
            sys.stdout.flush()

    def take(wait: QTimer) -> None:
        finished = designer.is_complete
        if finished or process_age_s() > _LONGEST_WAIT_S:
            wait.stop()
            if finished:
                times["finished_s"] = round(process_age_s(), 3)
            report()
            # What has just come is painted first.
            QTimer.singleShot(_LOOK_EVERY_MS, lambda: screenshot(options.screenshot))

    def screenshot(path: Path) -> None:
        if not designer.window.grab().save(str(path)):
            sys.stderr.write(f"{path}: the picture cannot be written there.\n")
            app.exit(1)
            return
        app.exit(0)

    designer.window.first_painted.connect(painted)


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="brdf-designer",
        description="Edit a metallic car paint: L*a*b* (D65, 10°) at its aspecular angles in degrees, gloss in "
        "gloss units (GU), flakes. Programs of the suite that are open follow every change.",
    )
    parser.add_argument("paint", nargs="?", help="a .brdfpaint file, or the name of a shipped paint")
    parser.add_argument("--theme", choices=THEMES, help="surround of this run (default: the one chosen last)")
    add_language(parser)
    parser.add_argument("--size", type=window_size, metavar="WxH", help="size of the window in pixels")
    parser.add_argument(
        "--screenshot", type=Path, metavar="FILE", help="save a picture of the window, and end"
    )
    parser.add_argument(
        "--quit-after", type=float, metavar="S", help="end S seconds after the window is complete"
    )
    parser.add_argument(
        "--report-startup",
        action="store_true",
        help='print {"ready_s": s, "complete_s": s}: seconds from the start of the process to the first painted '
        'window, and to its plot being there; with --screenshot "finished_s" too, to all pictures being drawn',
    )
    return parser


if __name__ == "__main__":
    sys.exit(main())
