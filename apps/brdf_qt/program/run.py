"""The command line and the run of a program: its options, a picture of the window, times of the start, exit status."""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path

from PySide6.QtCore import QObject, QRect, Qt, QTimer
from PySide6.QtWidgets import QApplication

from brdf_qt.link.open_files import OpenFiles, hand_over
from brdf_qt.program.application import create_application, end_application, process_age_s
from brdf_qt.program.program import Program
from brdf_qt.program.suite import MEMBERS
from brdf_qt.program.theme import THEMES
from brdf_qt.program.translation import languages
from brdf_qt.start.launch import Launch
from brdf_qt.start.page import is_wanted
from brdf_qt.window.placement import WindowPlaces
from brdf_suite.command_parser import CommandParser, set_loudness
from brdf_suite.errors import SuiteError
from brdf_suite.foreign_text import make_visible
from brdf_suite.processes import prepare_streams, run_named_module

_LARGEST = 20_000
_LOOK_EVERY_MS = 50
_PAINT_MS = 200
"""Between the end of all work and a picture of the window: what has just come is painted, a fit is made exact."""


def window_size(text: str) -> tuple[int, int]:
    """Parse ``WIDTHxHEIGHT`` in pixels (an argparse type)."""
    width, _, height = text.partition("x")
    if all(n.isdecimal() and 0 < int(n) < _LARGEST for n in (width, height)):
        return int(width), int(height)
    raise argparse.ArgumentTypeError(f"{text!r} is no size; give WIDTHxHEIGHT in pixels, as in 1280x800")


def window_place(text: str) -> QRect:
    """Parse ``X,Y,WIDTH,HEIGHT`` in pixels of the screen (an argparse type)."""
    try:
        x, y, width, height = (int(n) for n in text.split(","))
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r} is no place; give X,Y,WIDTH,HEIGHT in pixels") from None
    return QRect(x, y, width, height)


def program_parser(command: str, description: str, times: str, epilog: str | None = None) -> CommandParser:
    """Return the parser of ``command`` with the options of every program.

    ``times`` completes the help of ``--report-startup``: what is printed beside the time of the painted window.
    """
    parser = CommandParser(prog=command, description=description, epilog=epilog)
    parser.examples = (f"{command} --theme light --size 1280x800", f"{command} --screenshot window.png")
    window = parser.add_argument_group("window and start")
    window.add_argument("--theme", choices=THEMES, help="theme of this run (default: the last one chosen)")
    window.add_argument(
        "--language", choices=languages(), help="language of this run (default: the last one chosen)"
    )
    window.add_argument("--size", type=window_size, metavar="WxH", help="size of the window in pixels")
    window.add_argument(
        "--place", type=window_place, metavar="X,Y,W,H", help="place of the window on the screen in pixels"
    )
    window.add_argument(
        "--screenshot",
        type=Path,
        metavar="FILE",
        help="save a picture of the window once all of it is there, and end",
    )
    window.add_argument(
        "--quit-after", type=float, metavar="S", help="end S seconds after the window is complete"
    )
    window.add_argument(
        "--report-startup",
        action="store_true",
        help='print {"ready_s": s, "complete_s": s}: seconds from the start of the process to the first painted '
        f"window, and {times}",
    )
    window.add_argument(
        "--open",
        type=Path,
        nargs="+",
        default=[],
        metavar="FILE",
        help="open these files in the window that is there already, or else in a new one: for file managers",
    )
    parser.add_argument(
        "--start-page",
        action=argparse.BooleanOptionalAction,
        default=None,
        help="show the start page first, or not (default: as chosen there, where no file is named)",
    )
    return parser


def add_actions(parser: argparse.ArgumentParser, more: str = "") -> None:
    """Add the option ``--do``; ``more`` are the options by key and value that the program knows."""
    parser.add_argument(
        "--do",
        action="append",
        default=[],
        metavar="ACTION",
        help="perform this action after startup, in the order given: a command name as in Ctrl+K"
        + (f", or {more}" if more else ""),
    )


def run_program(
    name: str,
    parser: argparse.ArgumentParser,
    make: Callable[[argparse.Namespace], Program],
    argv: Sequence[str] | None = None,
    actions: Callable[[argparse.Namespace], Sequence[str]] = lambda _options: (),
    *,
    loads: str = "",
    is_asked: Callable[[argparse.Namespace], bool] = lambda _options: True,
) -> int:
    """Run the program ``name`` ("Designer") that ``make`` returns for the options; return the exit status.

    ``actions`` are given to :meth:`Program.do` after the start, each when all that the one before led to is there.
    ``loads`` is the module that takes long to import; the start page is shown before it, unless ``is_asked`` says that
    the options name what is to be opened.
    """
    words = list(sys.argv[1:] if argv is None else argv)
    prepare_streams()
    status = run_named_module(words)
    if status is not None:
        return status
    options = parser.parse_args(words)
    set_loudness(options)
    app = create_application(name, theme_name=options.theme, language=options.language)
    role = next(role for role, member in MEMBERS.items() if member.name == name)
    if options.open and hand_over(role, options.open):
        return 0
    run_actions = actions(options)
    launch = None
    asked = bool(options.open) or is_asked(options)
    if loads and (options.start_page or _begins_with_page(options, asked, run_actions)):
        launch = Launch(app, name)
    try:
        program = make(options) if launch is None else launch.load(loads, partial(make, options))
    except SuiteError as error:
        print(f"{parser.prog}: {make_visible(str(error))}", file=sys.stderr)
        return end_application(1)
    if program is None:
        return end_application(0)
    if options.size is not None:
        program.window.resize(*options.size)
        program.window.fit_inspector()
    places = WindowPlaces(program.window)
    if options.place is not None:
        program.window.setGeometry(options.place)
    elif options.size is None:
        places.step_aside()
    app.aboutToQuit.connect(places.close)
    program.start_when_painted()
    run = _Run(app, program, options, parser.prog, run_actions)
    open_files = OpenFiles(role, program.window)
    open_files.requested.connect(program.window.files_dropped)
    app.file_opened.connect(lambda file: open_files.open([file]))
    app.aboutToQuit.connect(open_files.close)
    if launch is None:
        program.window.show()
    else:
        run.note("start_page_s", launch.shown_s)
        program.window.setAttribute(Qt.WidgetAttribute.WA_ShowWithoutActivating)
        program.window.show()
        launch.hand_over(program.window.start)
    return end_application(app.exec())


def _begins_with_page(options: argparse.Namespace, is_asked: bool, actions: Sequence[str]) -> bool:
    """Whether a start that says nothing of the page shows it: a user's who asks for nothing yet."""
    unattended = options.screenshot is not None or options.quit_after is not None or options.report_startup
    wanted = options.start_page is None and is_wanted()
    return wanted and not (is_asked or actions or unattended or options.place is not None)


class _Run(QObject):
    """What the options ask for once the program has started."""

    def __init__(
        self,
        app: QApplication,
        program: Program,
        options: argparse.Namespace,
        command: str,
        actions: Sequence[str],
    ) -> None:
        super().__init__(program)
        self._app, self._program, self._options = app, program, options
        self._command, self._actions = command, list(actions)
        self._seen: list[str] = []
        self._times: dict[str, float] = {}
        program.reached.connect(self._reach)
        program.start_failed.connect(self._fail)

    def note(self, name: str, seconds: float) -> None:
        """Add a time to those that are reported."""
        self._times[name] = seconds

    def _reach(self, milestone: str) -> None:
        self._seen.append(milestone)
        started = "complete_s" in self._times
        if "ready" in self._seen:  # what is drawn before the window is painted is seen only then
            now = round(process_age_s(), 3)
            self._times.update({f"{one}_s": now for one in self._seen if f"{one}_s" not in self._times})
        if "complete_s" in self._times and not started:
            self._complete()

    def _complete(self) -> None:
        if self._options.open:
            self._program.window.files_dropped.emit([file.absolute() for file in self._options.open])
        if self._options.screenshot is not None:
            self._when_idle(self._finish)
            return
        self._report()
        self._act()
        self._quit_later()

    def _quit_later(self) -> None:
        if self._options.quit_after is not None:
            QTimer.singleShot(round(1000 * self._options.quit_after), self, partial(self._end, 0))

    def _fail(self, problem: str) -> None:
        if self._options.screenshot is not None:
            self._end(1, problem)
        else:
            self._quit_later()

    def _finish(self) -> None:
        if self._program.is_idle:
            self._times.setdefault("finished_s", round(process_age_s(), 3))
        self._report()
        self._act()

    def _report(self) -> None:
        if self._options.report_startup:
            print(json.dumps(self._times), flush=True)

    def _act(self) -> None:
        """Do the next action; after the last one take the picture."""
        if self._actions:
            action = self._actions.pop(0)
            if self._program.do(action):
                self._when_idle(self._act)
            else:
                self._end(2, f"{action}: there is no such action or option.")
        elif self._options.screenshot is not None:
            QTimer.singleShot(_PAINT_MS, self, self._save)

    def _save(self) -> None:
        path = self._options.screenshot
        saved = self._program.window.grab().save(str(path))
        self._end(*((0, "") if saved else (1, f"{path}: the picture cannot be written there.")))

    def _end(self, status: int, problem: str = "") -> None:
        if problem:
            print(f"{self._command}: {make_visible(problem)}", file=sys.stderr)
        self._app.exit(status)

    def _when_idle(self, then: Callable[[], None]) -> None:
        def look() -> None:
            if self._program.is_idle or process_age_s() > self._program.patience_s:
                then()
            else:
                QTimer.singleShot(_LOOK_EVERY_MS, self, look)

        QTimer.singleShot(_LOOK_EVERY_MS, self, look)
