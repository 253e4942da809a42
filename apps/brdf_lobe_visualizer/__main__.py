"""Lobe Visualizer: any reflectance in three dimensions. ``brdf-lobes --help`` lists its options."""

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

from brdf_lobe_visualizer.assembly import LobeVisualizer
from brdf_lobe_visualizer.script import add_options, apply_subjects, apply_view

_LOOK_EVERY_MS = 50
_LONGEST_WAIT_S = 90.0
"""A picture of the window is taken without what has not come by then."""


def main(argv: Sequence[str] | None = None) -> int:
    """Run Lobe Visualizer; return the exit status."""
    options = parser().parse_args(argv)
    app = create_application("Lobe Visualizer", theme_name=options.theme, language=options.language)
    program = LobeVisualizer()
    if options.size is not None:
        program.window.resize(*options.size)
        program.window.fit_inspector()
    apply_view(program, options)
    _when_ready(app, program, options)
    return run(app, program.window)


def parser() -> argparse.ArgumentParser:
    """Return the parser of the command line."""
    parser = argparse.ArgumentParser(
        prog="brdf-lobes",
        description="Look at any reflectance in three dimensions, in slices and in numbers, beside its fitted lobes. "
        "Follows the paint that is edited in Designer.",
        epilog="Ctrl+K finds any command by name.",
    )
    parser.add_argument(
        "reflectances",
        nargs="*",
        metavar="REFLECTANCE",
        help="a .brdfpaint, .brdfpalette or measured file, the name of a shipped paint or of one of Table 1, or of a "
        "model; any number",
    )
    parser.add_argument("--theme", choices=THEMES, help="theme of this run (default: the last one chosen)")
    add_language(parser)
    parser.add_argument("--size", type=window_size, metavar="WxH", help="size of the window in pixels")
    parser.add_argument(
        "--screenshot",
        type=Path,
        metavar="FILE",
        help="save a picture of the window once complete, then exit",
    )
    parser.add_argument(
        "--quit-after", type=float, metavar="S", help="exit S seconds after the window is complete"
    )
    parser.add_argument(
        "--report-startup",
        action="store_true",
        help='print {"ready_s": s, "shown_s": s, "complete_s": s}: seconds from the start of the process to the '
        "first painted window, to the reflectances being shown, and to all being there, fits and figures too",
    )
    add_options(parser)
    return parser


def _when_ready(app: QApplication, program: LobeVisualizer, options: argparse.Namespace) -> None:
    """Open what was asked for once the window is painted, and do what the options ask for when all is there."""
    times: dict[str, float] = {}
    look = QTimer(app)
    look.setInterval(_LOOK_EVERY_MS)

    def painted() -> None:
        times["ready_s"] = round(process_age_s(), 3)
        # Parts build what is heavy at this signal too; the files are read on threads meanwhile.
        program.start(options.reflectances)
        program.sources.idle.connect(shown)
        look.start()

    def shown() -> None:
        if "shown_s" not in times:
            apply_subjects(program, options)
            # Handed to every view; painted in the turn of the event loop that follows.
            QTimer.singleShot(0, lambda: times.setdefault("shown_s", round(process_age_s(), 3)))

    def check() -> None:
        late = process_age_s() > _LONGEST_WAIT_S
        if ("shown_s" in times and program.is_complete) or late:
            look.stop()
            times["complete_s"] = round(process_age_s(), 3)
            # What has just come is painted first.
            QTimer.singleShot(2 * _LOOK_EVERY_MS, complete)

    def complete() -> None:
        if options.report_startup:
            sys.stdout.write(json.dumps(times) + "\n")
            sys.stdout.flush()
        if options.screenshot is not None:
            saved = program.window.grab().save(str(options.screenshot))
            if not saved:
                sys.stderr.write(f"{options.screenshot}: the picture cannot be written there.\n")
            app.exit(0 if saved else 1)
        elif options.quit_after is not None:
            QTimer.singleShot(round(1000 * options.quit_after), lambda: app.exit(0))

    look.timeout.connect(check)
    program.window.first_painted.connect(painted)


if __name__ == "__main__":
    sys.exit(main())
