"""Color Swatch: the program that manages palettes of paints. ``brdf-swatch --help`` lists its options."""

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

from brdf_color_swatch.assembly import ColorSwatch
from brdf_color_swatch.grid.tile import FORMS

_LOOK_EVERY_MS = 100
_LONGEST_WAIT_S = 180.0
"""A picture of the window is taken without what has not come by then."""


def main(argv: Sequence[str] | None = None) -> int:
    """Run Color Swatch; return the exit status."""
    options = _parser().parse_args(argv)
    app = create_application("Color Swatch", theme_name=options.theme, language=options.language)
    program = ColorSwatch()
    if options.size is not None:
        program.window.resize(*options.size)
        program.window.fit_inspector()
    look = {"form": options.form, "size": options.swatch_size, "as_list": options.list or None}
    program.session.set_look(**{key: value for key, value in look.items() if value is not None})
    for name in options.palettes:
        program.open(name)
    _when_ready(app, program, options)
    return run(app, program.window)


def _when_ready(app: QApplication, program: ColorSwatch, options: argparse.Namespace) -> None:
    """Do what the options ask for once the window is painted; link and library follow that paint."""
    times: dict[str, float] = {}

    def painted() -> None:
        times["ready_s"] = round(process_age_s(), 3)
        QTimer.singleShot(0, complete)

    def complete() -> None:
        times["complete_s"] = round(process_age_s(), 3)
        if options.report_startup:
            sys.stdout.write(json.dumps(times) + "\n")
            sys.stdout.flush()
        if options.screenshot is not None:
            _when_complete(app, program, lambda: act(0))
        elif options.quit_after is not None:
            QTimer.singleShot(round(1000 * options.quit_after), lambda: app.exit(0))
            act(0)
        else:
            act(0)

    def act(place: int) -> None:
        """Do the actions that were asked for, each after all that the one before has led to."""
        if place < len(options.do):
            if not program.do(options.do[place]):
                sys.stderr.write(f"--do {options.do[place]}: there is no such action.\n")
                app.exit(2)
                return
            _when_complete(app, program, lambda: act(place + 1))
        elif options.screenshot is not None:
            # What has just come is painted first.
            QTimer.singleShot(3 * _LOOK_EVERY_MS, lambda: screenshot(options.screenshot))

    def screenshot(path: Path) -> None:
        if not program.window.grab().save(str(path)):
            sys.stderr.write(f"{path}: the picture cannot be written there.\n")
            app.exit(1)
            return
        app.exit(0)

    program.window.first_painted.connect(painted)


def _when_complete(app: QApplication, program: ColorSwatch, then: object) -> None:
    wait = QTimer(app)
    wait.setInterval(_LOOK_EVERY_MS)

    def look() -> None:
        if program.is_complete or process_age_s() > _LONGEST_WAIT_S:
            wait.stop()
            then()  # type: ignore[operator]  # a function without arguments

    wait.timeout.connect(look)
    wait.start()


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="brdf-swatch",
        description="Organize metallic car paints as palettes: groups, tags, search by text and colour (ΔE00 at "
        "each angle, D65, 10°), flop. Programs of the suite that are open exchange paints with it.",
    )
    parser.add_argument(
        "palettes",
        nargs="*",
        metavar="FILE",
        help="palettes of any format, or `shipped` for the sample paints",
    )
    parser.add_argument(
        "--theme", choices=THEMES, help="window theme of this run (default: the last one used)"
    )
    add_language(parser)
    parser.add_argument("--size", type=window_size, metavar="WxH", help="window size in pixels")
    parser.add_argument("--form", choices=FORMS, help="form of the swatches")
    parser.add_argument("--swatch-size", type=int, metavar="PX", help="size of the swatches in pixels")
    parser.add_argument("--list", action="store_true", help="show a list instead of the grid")
    parser.add_argument(
        "--do",
        action="append",
        default=[],
        metavar="ACTION",
        help="perform this action after startup, in the order given: a command name as in Ctrl+K, or search=TEXT, "
        "select=N,N…, group=PATH, sort=KEY",
    )
    parser.add_argument(
        "--screenshot", type=Path, metavar="FILE", help="save a picture of the window and quit"
    )
    parser.add_argument(
        "--quit-after", type=float, metavar="S", help="quit S seconds after the window is complete"
    )
    parser.add_argument(
        "--report-startup",
        action="store_true",
        help='print {"ready_s": s, "complete_s": s}: seconds from the start of the process to the first painted '
        "window, and to its library being there",
    )
    return parser


if __name__ == "__main__":
    sys.exit(main())
