"""Take a picture of every state of the four windows, and list the texts that are clipped or overlap; it must list none.

Run ``.venv/bin/python packaging/screenshots/states.py --into FOLDER``. States are the start, each tab with *More* open,
drawers and docks, dialogs, an error, work in progress, and a window without a document; each in themes, languages and
sizes. ``--program``, ``--theme``, ``--language`` and ``--size`` (``WxH``, ``WxH@2`` for 200 %) choose fewer; without
``--into`` the texts alone are measured. Settings are fresh ones. The exit status is 1 where a text is at fault.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator
from dataclasses import asdict
from itertools import product
from pathlib import Path
from typing import TYPE_CHECKING

from screenshots import virtual_screen

if TYPE_CHECKING:
    from brdf_qt.program.program import Program
    from PySide6.QtWidgets import QWidget

PROGRAMS = ("Designer", "Viewer", "Lobe Visualizer", "Color Swatch")
THEMES = ("dark", "light")
LANGUAGES = ("en", "de")
SIZES = ("1280x720", "1920x1080", "1280x720@2")
DIALOGS = (
    "Settings", "Keyboard Shortcuts", "About BRDF Suite", "Manual", "lobe_fit", "Find a Command", "sheet", "export",
    "Export Picture", "Export Turntable", "Export Contact Sheet", "acquire",
)  # fmt: skip
"""Commands that open a window of our own, by the object names of their actions; each where a program has it."""
ACQUIRE_PAGES = ("session", "exposures", "response", "geometry", "mask", "coverage", "fit")
_REST_S = 0.4
_PATIENCE_S = 60.0
_DIALOG_MS = 900


class States:
    """A running program, and the states through which it is taken."""

    def __init__(self, program: Program, scratch: Path, shoot: Callable[[str, QWidget], None]) -> None:
        self.program, self.window, self._scratch, self._shoot = program, program.window, scratch, shoot

    def all(self) -> None:
        """Go through all states; what one opens is closed before the next."""
        self._take("start")
        self._tabs()
        self._drawers()
        self._docks()
        self._three_lights()
        for name in DIALOGS:
            self._dialog(name)
        self._error()
        self._busy()

    def rest(self) -> None:
        """Let layouts and what is drawn come to rest."""
        _run_for(_REST_S)

    def _take(self, state: str) -> None:
        self.rest()
        self._shoot(state, self.window)

    def _tabs(self) -> None:
        for key, page in self.window.panel.pages.items():
            self.window.panel.show_page(key)
            self._take(f"tab_{key}")
            for section in page.all_sections:
                section.set_open(True)
            if page.more is not None:
                page.bring_in_sight(page.more)
            self._take(f"tab_{key}_more")
            if page.more is not None:
                page.more.set_open(False)
        self.window.panel.show_page(next(iter(self.window.panel.pages)))

    def _drawers(self) -> None:
        from brdf_qt.window.stage import Stage

        for stage in self.window.findChildren(Stage):
            for key, drawer in stage.drawers.items():
                drawer.set_open(True)
                _run_for(_PATIENCE_S, lambda drawer=drawer: drawer.reach == 1.0)
                self._take(f"drawer_{key}")
            for drawer in stage.drawers.values():
                drawer.set_open(False)

    def _docks(self) -> None:
        for key, dock in self.window.docks.items():
            if dock.isHidden():
                dock.show()
                self._take(f"dock_{key}")
                dock.hide()

    def _three_lights(self) -> None:
        from PySide6.QtGui import QAction

        for action in self.window.findChildren(QAction, "action_three_lights"):
            action.trigger()
            self.rest()
            _run_for(_PATIENCE_S, lambda: self.program.is_idle)
            self._take("three_lights")
            action.trigger()

    def _dialog(self, name: str) -> None:
        """Trigger a command, take the windows that it opens, and close them; a modal one is met in its own loop."""
        from PySide6.QtCore import QTimer
        from PySide6.QtWidgets import QApplication
        from shiboken6 import isValid

        command = self.window.command(name) or self.window.findChild(object, f"action_{name}")
        if command is None or not command.isEnabled():
            return
        finished = []

        def meet() -> None:
            tops = [one for one in QApplication.topLevelWidgets() if isValid(one) and one.isVisible()]
            for one in [one for one in tops if one is not self.window]:
                label = name.replace(" ", "_").lower()
                if type(one).__name__ == "AcquireWindow":
                    for page in ACQUIRE_PAGES:
                        one.show_page(page)
                        self._shoot(f"{label}_{page}", one)
                else:
                    self._shoot(f"dialog_{label}", one)
                one.close()
            finished.append(True)

        QTimer.singleShot(_DIALOG_MS, meet)
        QTimer.singleShot(0, command.trigger)
        _run_for(_PATIENCE_S, lambda: bool(finished))

    def _error(self) -> None:
        broken = self._scratch / "A paint with a rather long name that was cut off in the middle.brdfpaint"
        broken.write_text('{"kind": "paint", ', encoding="utf-8")
        self.window.files_dropped.emit([broken])
        self._take("error")
        for key in tuple(self.window.messages.shown()):
            self.window.dismiss_message(key)

    def _busy(self) -> None:
        from brdf_qt.program.translation import tr

        text = tr("Preparing the light: {name}").format(name=tr("Photo studio"))
        self.window.progress.set_job("states", 0.4, text, cancel=lambda: None)
        _run_for(_PATIENCE_S, self.window.progress.isVisible)
        self._take("busy")
        self.window.progress.end_job("states")


def _run_for(seconds: float, until: Callable[[], bool] = lambda: False) -> None:
    from time import monotonic, sleep

    from PySide6.QtCore import QCoreApplication

    end = monotonic() + seconds
    while monotonic() < end and not until():
        QCoreApplication.processEvents()
        sleep(0.01)


def open_program(name: str, *, empty: bool) -> Program:
    """Return a program, with a document that it ships or with none."""
    if name == "Designer":
        from brdf_designer.assembly import Designer

        return Designer()
    if name == "Viewer":
        from brdf_viewer.controller import ViewerController

        from brdf_suite.documents.view import View

        return ViewerController(View(environment="booth", surface="sphere"), "blue")
    if name == "Lobe Visualizer":
        from brdf_lobe_visualizer.assembly import LobeVisualizer

        return LobeVisualizer()
    from brdf_color_swatch.assembly import ColorSwatch

    program = ColorSwatch()
    if not empty:
        program.open("shipped")
    return program


def drive(options: argparse.Namespace) -> int:
    """Go through the states of one program in one look, in the process that has the screen; print faults as JSON."""
    from brdf_qt.program.application import create_application
    from texts import faults

    app = create_application(options.program[0], theme_name=options.theme[0], language=options.language[0])
    size, _, scale = options.size[0].partition("@")
    look = "_".join(
        (options.program[0].lower().replace(" ", "_"), options.theme[0], options.language[0], size)
    )
    look += f"_{scale}" if scale else ""
    seen: dict[str, str] = {}

    def shoot(state: str, window: QWidget) -> None:
        if options.into is not None:
            path = options.into / f"{look}_{state}.jpg"
            if not window.grab().toImage().save(str(path), "JPG", 88):
                raise SystemExit(f"{path} cannot be written.")
        for fault in faults(window):
            what = json.dumps({"program": options.program[0], **asdict(fault)}, ensure_ascii=False)
            if what not in seen:
                seen[what] = state
                record = {"state": f"{look}_{state}", **json.loads(what)}
                print(json.dumps(record, ensure_ascii=False), flush=True)

    with tempfile.TemporaryDirectory() as scratch:
        for empty in (True, False) if options.program[0] == "Color Swatch" else (False,):
            program = open_program(options.program[0], empty=empty)
            program.window.resize(*(int(part) for part in size.split("x")))
            program.window.fit_inspector()
            program.start_when_painted()
            program.window.show()
            _run_for(options.patience, lambda program=program: program.is_idle)
            states = States(program, Path(scratch), shoot)
            if empty:
                states.rest()
                shoot("empty", program.window)
            else:
                states.all()
            program.window.hide()
    sys.stdout.flush()
    del app
    os._exit(0)  # nothing that is on its way is awaited


def look_at(options: argparse.Namespace, environment: dict[str, str]) -> Iterator[dict[str, str]]:
    """Run each program in each look, and yield the faults of its texts."""
    for program, theme, language, size in product(
        options.program or PROGRAMS,
        options.theme or THEMES,
        options.language or LANGUAGES,
        options.size or SIZES,
    ):
        command = [sys.executable, __file__, "--drive", "--program", program, "--theme", theme]
        command += ["--language", language, "--size", size, "--patience", str(options.patience)]
        if options.into is not None:
            command += ["--into", str(options.into.absolute())]
        scale = size.partition("@")[2] or "1"
        with tempfile.TemporaryDirectory() as scratch:
            done = subprocess.run(
                command,
                env=environment | {"QT_SCALE_FACTOR": scale, "BRDF_SUITE_SETTINGS": scratch},
                stdout=subprocess.PIPE,
                text=True,
                check=True,
                timeout=900,
            )
        for line in done.stdout.splitlines():
            if line.startswith("{"):
                yield json.loads(line)


def main() -> int:
    """Go through the states, and print what is at fault."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--program", action="append", choices=PROGRAMS)
    parser.add_argument("--theme", action="append", choices=("dark", "booth", "light"))
    parser.add_argument("--language", action="append", choices=LANGUAGES)
    parser.add_argument("--size", action="append", metavar="WxH[@SCALE]")
    parser.add_argument("--into", type=Path, help="folder for the pictures (default: none are taken)")
    parser.add_argument(
        "--patience", type=float, default=_PATIENCE_S, help="seconds until a start is complete"
    )
    parser.add_argument("--drive", action="store_true", help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.drive:
        return drive(options)
    if options.into is not None:
        options.into.mkdir(parents=True, exist_ok=True)
    count = 0
    with virtual_screen((2600, 1500)) as display, tempfile.TemporaryDirectory() as cache:
        environment = {
            **os.environ,
            "DISPLAY": display,
            "LIBGL_ALWAYS_SOFTWARE": "1",
            "BRDF_SUITE_CACHE": os.environ.get("BRDF_SUITE_CACHE", cache),
            "BRDF_SUITE_LINK": f"states-{os.getpid()}",
        }
        environment.setdefault("QT_QPA_PLATFORM", "xcb")
        for fault in look_at(options, environment):
            count += 1
            print("{state}: {widget} {text!r} at {place}: {needed} in {given}".format(**fault), flush=True)
    print(f"{count} clipped or overlapping texts")
    return 1 if count else 0


if __name__ == "__main__":
    sys.exit(main())
