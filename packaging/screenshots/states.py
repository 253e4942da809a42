"""Take a picture of every state of the windows, and list the texts that are clipped or overlap; it must list none.

Run ``.venv/bin/python packaging/screenshots/states.py --into FOLDER``. Windows are those of the four programs, of the
assistant *Acquire…*, and the start page with its tour. States are the start, each tab with *More* open, drawers and
docks, dialogs, an error, work in progress, and a window without a document; each in themes, languages and sizes.
``--program``, ``--theme``, ``--language`` and ``--size`` (``WxH``, ``WxH@2`` for 200 %) choose fewer; without
``--into`` the texts alone are measured. Settings are fresh ones. The exit status is 1 where a text is at fault.

``--sheets`` writes the sheets of small pictures in docs/development/states/: one of each window and theme, in English
at 1280×720. ``--compare`` takes the same states and lists those that look different from the sheets.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator
from dataclasses import asdict, dataclass, field
from itertools import product
from pathlib import Path
from typing import TYPE_CHECKING

from screenshots import ROOT, virtual_screen
from sheets import THRESHOLD, changes, write_sheet

if TYPE_CHECKING:
    from brdf_designer.assembly import Designer
    from brdf_qt.program.program import Program
    from PySide6.QtWidgets import QWidget

ACQUIRE, START_PAGE = "Acquire", "Start Page"
PROGRAMS = ("Designer", "Viewer", "Lobe Visualizer", "Color Swatch", ACQUIRE, START_PAGE)
"""The programs, and two windows of Designer that have states of their own."""
THEMES = ("dark", "light")
LANGUAGES = ("en", "de")
SIZES = ("1280x720", "1920x1080", "1280x720@2")
DIALOGS = (
    "Settings", "Keyboard Shortcuts", "About BRDF Suite", "Manual", "lobe_fit", "Find a Command", "sheet", "export",
    "Export Picture", "Export Turntable", "Export Contact Sheet",
)  # fmt: skip
"""Commands that open a window of our own, by the object names of their actions; each where a program has it."""
SHEETS = ROOT / "docs" / "development" / "states"
HOME = Path(tempfile.gettempdir()) / "brdf_suite_states"
"""What file dialogs and messages show: the same in every run."""
SHEET_LANGUAGE, SHEET_SIZE = "en", "1280x720"
RECENT = ("spring_collection.brdfproject", "red_metallic.brdfpaint", "polaris_silver.binary")
START_SHARE, START_MOST = (0.94, 0.92), (1140, 752)
"""Of a screen that the start page takes, and its most pixels."""
_BROKEN = "A paint with a rather long name that was cut off in the middle"
_SIMULATION_S = 600.0
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
        """Let layouts, what is drawn, and what is worked out meanwhile come to rest."""
        _run_for(_REST_S)
        _run_for(_PATIENCE_S, lambda: self.program.is_idle)

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
                self._shoot(f"dialog_{name.replace(' ', '_').lower()}", one)
                one.close()
            finished.append(True)

        QTimer.singleShot(_DIALOG_MS, meet)
        QTimer.singleShot(0, command.trigger)
        _run_for(_PATIENCE_S, lambda: bool(finished))

    def _error(self) -> None:
        broken = self._scratch / f"{_BROKEN}.brdfpaint"
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


def walk_assistant(designer: Designer, size: tuple[int, int], shoot: Callable[[str, QWidget], None]) -> None:
    """Take the assistant's pages: empty, while photographs are simulated, after all steps, and with a wrong folder."""
    from brdf_designer.acquire.control import AcquireControl
    from brdf_designer.acquire.window import KEYS

    assistant = designer.feature(AcquireControl).open()
    window, bench = assistant.window, assistant.bench
    window.resize(*size)

    def take(state: str) -> None:
        _run_for(_REST_S)
        shoot(state, window)

    for page in KEYS:
        window.show_page(page)
        take(f"empty_{page}")
    window.show_page("session")
    assistant.try_sample()
    _run_for(_PATIENCE_S, window.progress.isVisible)
    take("busy")
    _run_for(_SIMULATION_S, lambda: "fit" in bench.results and bench.is_quiet)
    if "fit" not in bench.results:
        raise SystemExit(f"A step failed: {[one.what for one in window.messages.shown().values()]}")
    for page in KEYS:
        window.show_page(page)
        _run_for(_PATIENCE_S, lambda: bench.is_quiet)
        take(page)
    window.show_page("session")
    broken = Path.home() / "photographs"
    broken.mkdir(exist_ok=True)
    (broken / "session.json").write_text('{"kind": ', encoding="utf-8")
    assistant.sessions.open(broken)
    _run_for(_PATIENCE_S, lambda: bool(window.messages.shown()) and bench.is_quiet)
    take("error")


def walk_start(designer: Designer, size: tuple[int, int], shoot: Callable[[str, QWidget], None]) -> None:
    """Take the start page at a first start, while its program is loaded, and with recent work; then the tour."""
    from brdf_qt.documents.recent_files import RecentFiles, recent_projects
    from brdf_qt.program.translation import tr
    from brdf_qt.start.page import StartWindow

    page = StartWindow("Designer")
    page.resize(*(min(round(a * b), most) for a, b, most in zip(START_SHARE, size, START_MOST, strict=True)))

    def take(state: str, window: QWidget) -> None:
        _run_for(_REST_S)
        shoot(state, window)

    page.show()
    page.show_loading(tr("Loading {program}…").format(program="Designer"))
    take("loading", page)
    page.show_loading("")
    take("first", page)
    with tempfile.TemporaryDirectory() as folder:
        for name in RECENT:
            file = Path(folder) / name
            file.touch()
            (recent_projects() if file.suffix == ".brdfproject" else RecentFiles()).add(file)
        page.refresh()
        take("recent", page)
    page.close()
    designer.window.start.start_tour()
    tour = designer.window.start.tour
    step = 0
    while tour is not None and tour.callout is not None:
        step += 1
        take(f"tour_{step}", designer.window)
        tour.callout.next.click()
        _run_for(_REST_S)


def _run_for(seconds: float, until: Callable[[], bool] = lambda: False) -> None:
    from time import monotonic, sleep

    from PySide6.QtCore import QCoreApplication

    end = monotonic() + seconds
    while monotonic() < end and not until():
        QCoreApplication.processEvents()
        sleep(0.01)


def open_program(name: str, *, empty: bool) -> Program:
    """Return a program, with a document that it ships or with none."""
    if name in ("Designer", ACQUIRE, START_PAGE):
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

    name = options.program[0]
    application = "Designer" if name in (ACQUIRE, START_PAGE) else name
    app = create_application(application, theme_name=options.theme[0], language=options.language[0])
    shape, _, scale = options.size[0].partition("@")
    look = "_".join((_file_name(name), options.theme[0], options.language[0], shape))
    look += f"_{scale}" if scale else ""
    size = tuple(int(part) for part in shape.split("x"))
    seen: dict[str, str] = {}

    def shoot(state: str, window: QWidget) -> None:
        if options.into is not None:
            path = options.into / f"{look}_{state}.jpg"
            if not window.grab().toImage().save(str(path), "JPG", 88):
                raise SystemExit(f"{path} cannot be written.")
            print(json.dumps({"taken": state, "path": str(path)}), flush=True)
        for fault in faults(window):
            what = json.dumps({"program": name, **asdict(fault)}, ensure_ascii=False)
            if what not in seen:
                seen[what] = state
                record = {"state": f"{look}_{state}", **json.loads(what)}
                print(json.dumps(record, ensure_ascii=False), flush=True)

    for empty in (True, False) if name == "Color Swatch" else (False,):
        program = open_program(name, empty=empty)
        program.window.resize(*size)
        program.window.fit_inspector()
        program.start_when_painted()
        program.window.show()
        _run_for(options.patience, lambda program=program: program.is_idle)
        if empty:
            _run_for(_REST_S)
            shoot("empty", program.window)
            program.close()
        elif name == ACQUIRE:
            walk_assistant(program, size, shoot)
        elif name == START_PAGE:
            walk_start(program, size, shoot)
        else:
            States(program, Path.home(), shoot).all()
        program.window.hide()
    sys.stdout.flush()
    del app
    os._exit(0)  # nothing that is on its way is awaited


def _file_name(program: str) -> str:
    return program.lower().replace(" ", "_")


@dataclass
class Walk:
    """A walk through the states of a program in a look: the faults of its texts, and its pictures by state."""

    program: str
    theme: str
    faults: list[dict[str, str]] = field(default_factory=list)
    pictures: dict[str, Path] = field(default_factory=dict)

    @property
    def sheet(self) -> str:
        """The name of its sheet."""
        return f"{_file_name(self.program)}_{self.theme}"


def look_at(options: argparse.Namespace, environment: dict[str, str]) -> Iterator[Walk]:
    """Run each program in each look, and yield what was found."""
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
                timeout=1200,
            )
        walk = Walk(program, theme)
        for line in done.stdout.splitlines():
            record = json.loads(line) if line.startswith("{") else {}
            if "taken" in record:
                walk.pictures[record["taken"]] = Path(record["path"])
            elif record:
                walk.faults.append(record)
        yield walk


def report(walk: Walk, options: argparse.Namespace) -> bool:
    """Print the faults of a walk, and keep or compare its pictures as the options want; return whether all is well."""
    for fault in walk.faults:
        print("{state}: {widget} {text!r} at {place}: {needed} in {given}".format(**fault), flush=True)
    if options.sheets:
        path = write_sheet(SHEETS, walk.sheet, walk.pictures)
        print(f"{path} ({path.stat().st_size:,} bytes)", flush=True)
    changed = False
    if options.compare:
        for state, error in changes(SHEETS, walk.sheet, walk.pictures).items():
            if error > THRESHOLD:
                changed = True
                print(f"{walk.sheet} {state}: changed by {error:.2f}", flush=True)
    return not walk.faults and not changed


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
    kept = parser.add_mutually_exclusive_group()
    kept.add_argument("--sheets", action="store_true", help="renew the sheets in docs/development/states/")
    kept.add_argument("--compare", action="store_true", help="list the states that differ from the sheets")
    parser.add_argument("--drive", action="store_true", help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.drive:
        return drive(options)
    HOME.mkdir(exist_ok=True)
    with virtual_screen((2600, 1500)) as display, tempfile.TemporaryDirectory() as cache:
        if options.sheets or options.compare:
            options.language, options.size = [SHEET_LANGUAGE], [SHEET_SIZE]
            options.into = options.into or Path(cache) / "pictures"
        if options.into is not None:
            options.into.mkdir(parents=True, exist_ok=True)
        environment = {
            **os.environ,
            "DISPLAY": display,
            "HOME": str(HOME),
            "LIBGL_ALWAYS_SOFTWARE": "1",
            "BRDF_SUITE_CACHE": os.environ.get("BRDF_SUITE_CACHE", cache),
            "BRDF_SUITE_LINK": f"states-{os.getpid()}",
        }
        environment.setdefault("QT_QPA_PLATFORM", "xcb")
        walks = []
        well = True
        for walk in look_at(options, environment):
            walks.append(walk)
            well &= report(walk, options)
    print(f"{sum(len(walk.faults) for walk in walks)} clipped or overlapping texts")
    return 0 if well else 1


if __name__ == "__main__":
    sys.exit(main())
