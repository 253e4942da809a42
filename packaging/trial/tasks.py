"""The twelve tasks of docs/development/usability.md, step by step through visible controls.

Each task is one or more parts; a part is what is done in one run of one program. A part gets the hand, the running
program, and the folder with the files of the start state. Afterwards ``done`` says from the written files, or from what
the program holds as its document, whether the goal was reached.
"""

from __future__ import annotations

import dataclasses
import os
import signal
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from hand import Hand, MissingError
from PySide6.QtCore import QPoint
from PySide6.QtWidgets import QAbstractItemView, QCheckBox, QWidget

from brdf_suite.documents.palette_store import load_palette
from brdf_suite.documents.store import save_paint
from brdf_suite.pipeline.material import load_shipped_paint
from brdf_suite.reports.handover import read_paints

RED = {15.0: (48.0, 52.0, 34.0), 45.0: (26.0, 42.0, 25.0), 110.0: (9.0, 24.0, 12.0)}
"""L*, a*, b* of an invented red metallic."""
LIGHTS = 3
FLOP = 110.0
OFF = 3.0
"""By how much the batch of task 2 is lighter than its standard at the flop, units of L*."""
PICKED = ("Candy red", "Champagne", "Copper")
SECOND = "Silver metallic"
LANGUAGE = "Deutsch"


@dataclass(frozen=True)
class Part:
    """What is done in one run of a program, and the files it is started with, by their names in the folder.

    With ``at_start_page`` the program stands as a new user's start without a file leaves it: under its start page.
    """

    program: str
    do: Callable[[Hand, Any, Path], None]
    files: tuple[str, ...] = ()
    at_start_page: bool = False


@dataclass(frozen=True)
class Task:
    """A task: its title, what makes its start state, its parts, and whether its goal was reached."""

    key: str
    title: str
    parts: tuple[Part, ...]
    done: Callable[[Path], bool]
    prepare: Callable[[Path], None] = lambda _folder: None


def note(folder: Path, name: str, text: str) -> None:
    """Keep what a program held as its document at the end of a part, for ``done``."""
    (folder / name).write_text(text, encoding="utf-8")


def kept(folder: Path, name: str) -> str:
    """Return what a part has kept; empty where it was not reached."""
    path = folder / name
    return path.read_text(encoding="utf-8") if path.exists() else ""


# Start states.


def batch_and_standard(folder: Path) -> None:
    """Write a blue, and the same one lighter at the flop."""
    standard = load_shipped_paint("blue")
    readings = [
        dataclasses.replace(one, lab=(one.lab[0] + OFF, *one.lab[1:])) if one.aspecular_deg == FLOP else one
        for one in standard.measurements
    ]
    save_paint(standard, folder / "standard.brdfpaint")
    batch = dataclasses.replace(standard, name="Batch 7", measurements=tuple(readings))
    save_paint(batch, folder / "batch.brdfpaint")


def one_blue(folder: Path) -> None:
    """Write a blue under another name."""
    paint = dataclasses.replace(load_shipped_paint("blue"), name="Harbour blue")
    save_paint(paint, folder / "harbour.brdfpaint")


def measured_file(folder: Path) -> None:
    """Write a measured file: the reflectance of a shipped paint in the format of RGL."""
    import subprocess
    import sys

    code = "from brdf_suite.cli.main import main; raise SystemExit(main())"
    target = str(folder / "measured.bsdf")
    subprocess.run(
        [sys.executable, "-c", code, "export", "copper", "--format", "rgl", "-o", target],
        check=True,
        capture_output=True,
    )


# Steps that tasks share.


def open_tab(hand: Hand, key: str) -> None:
    """Bring a tab of the panel to the front."""
    hand.press(f"tab_{key}")


def see_lights(hand: Hand, program: Any) -> list[str]:
    """Show the paint in three lights, and return those in which it is drawn."""
    from brdf_designer.picture.control import PictureControl

    control = program.feature(PictureControl)
    hand.press("Three Lights")
    hand.wait(lambda: control.lights.is_on and control.is_idle, 400.0)
    return hand.ask(lambda: [control.view.environment, *(pane.light for pane in control.lights.panes)])


# The tasks.


def red_metallic(hand: Hand, program: Any, folder: Path) -> None:
    """Begin a paint on the start page, type its readings, and look at it in three lights."""
    hand.press("New Paint")
    hand.wait(lambda: program.documents.front.title == "Untitled")
    hand.type(*(f"{value:g}" for lab in RED.values() for value in lab))
    seen = see_lights(hand, program)
    save_paint(hand.ask(lambda: program.store.value), folder / "red.brdfpaint")
    note(folder, "lights", "\n".join(dict.fromkeys(seen)))


def is_red_metallic(folder: Path) -> bool:
    """Whether the paint has the readings and flakes, and was seen in three lights."""
    from brdf_suite.documents.store import load_paint

    paint = load_paint(folder / "red.brdfpaint")
    readings = {one.aspecular_deg: one.lab for one in paint.measurements}
    if readings != RED:
        raise MissingError(f"The readings are {readings}.")
    if len(kept(folder, "lights").splitlines()) < LIGHTS:
        raise MissingError(f"Seen were {kept(folder, 'lights')!r}.")
    return paint.flakes is not None


def match_standard(hand: Hand, program: Any, folder: Path) -> None:
    """Load the standard, and type its lightness where the keyboard is led: at the reading farthest from it."""
    hand.press("Load Standard")
    hand.file(folder / "standard.brdfpaint")
    hand.wait(lambda: standard_control(program).standard is not None and program.is_idle)
    lab = load_shipped_paint("blue").lab_at(FLOP)
    hand.type(f"{lab[0]:g}")
    hand.wait(lambda: program.is_idle)
    control = standard_control(program)
    try:
        hand.wait(lambda: str(control.section.verdict.text()).upper().startswith("PASS"), 120.0)
    finally:
        note(folder, "verdict", hand.ask(lambda: str(control.section.verdict.text())))


def standard_control(program: Any) -> Any:
    """Return the part of Designer that judges against a standard."""
    from brdf_designer.standard_comparison.control import StandardControl

    return program.feature(StandardControl)


def two_tone(hand: Hand, program: Any, folder: Path) -> None:
    """Put the car up, and drop the second paint on a part of it with Ctrl, as the picture says during the drag."""
    open_tab(hand, "form")
    hand.row(lambda: program.window.surface.chooser.view, "Car")
    hand.wait(lambda: program.is_idle, 300.0)
    canvas = program.window.picture.canvas
    place = hand.ask(lambda: canvas.rect().center())
    hand.drop(lambda: program.window.strip.view, SECOND, lambda: canvas, place, ctrl=True)
    hand.wait(lambda: program.is_idle, 300.0)
    note(folder, "view", hand.ask(lambda: repr(program.state.view)))


def light_highlight(hand: Hand, program: Any, folder: Path) -> None:
    """Press where the highlight is to be with the right button: at the upper left of the sphere."""
    canvas = program.window.picture.canvas
    middle, side = hand.ask(lambda: (canvas.rect().center(), canvas.height() // 8))
    hand.in_menu_of(lambda: canvas, middle - QPoint(side, side), "Put the Highlight Here")
    hand.wait(lambda: program.is_idle and bool(program.state.view.lamps))
    x, y, _z = hand.ask(lambda: program.state.view.lamps[0].position)
    note(folder, "lamps", "upper left" if x < 0.0 < y else f"at {x}, {y}")


def compare_paints(hand: Hand, program: Any, folder: Path) -> None:
    """Press the mark that a paint of the strip has under the pointer; it is shown beside the first."""
    view = program.window.strip.view
    hand.row(lambda: view, SECOND, where=lambda tile: view.mark_box(tile).center())
    hand.wait(lambda: program.is_idle)
    note(folder, "compare", hand.ask(lambda: repr(program.state.view.compare)))


def palette_and_sheet(hand: Hand, program: Any, folder: Path) -> None:
    """Copy three sample paints into a new palette in a file of its own, and save its contact sheet."""
    hand.press("note_shipped")
    hand.wait(lambda: program.is_idle)
    for number, name in enumerate(PICKED):
        hand.row(lambda: _grid(program), name, ctrl=number > 0)
    hand.press("New Palette from Selection")
    hand.file(folder / "spring.brdfpalette")
    hand.wait(lambda: program.is_idle)
    hand.press("Contact Sheet")
    hand.press("sheet_save")
    hand.wait(lambda: (folder / "spring.pdf").exists() and program.is_idle)


def _grid(program: Any) -> QAbstractItemView | None:
    grids: list[QAbstractItemView] = program.window.findChildren(QAbstractItemView, "grid")
    return next((one for one in grids if one.isVisible()), None)


def has_palette(folder: Path) -> bool:
    """Whether the palette has the three paints, and the sheet is a document."""
    names = {entry.content.name for entry in load_palette(folder / "spring.brdfpalette").entries}
    return len(names) == len(PICKED) and (folder / "spring.pdf").read_bytes().startswith(b"%PDF")


def judge_measurement(hand: Hand, program: Any, folder: Path) -> None:
    """Open a measured file on the start page as a design, and read how far it is from the original."""
    hand.press("Open a Measurement")
    hand.file(folder / "measured.bsdf")
    hand.wait(lambda: program.window.section("measured").isVisible())
    hand.wait(lambda: program.is_idle)
    from brdf_designer.from_measurement.control import MeasuredControl

    text = hand.ask(lambda: str(program.feature(MeasuredControl).section.summary.text()))
    if hand.reads(text):
        note(folder, "summary", text)


def acquire(hand: Hand, program: Any, folder: Path) -> None:
    """Try the simulated acquisition on the start page, and take the paint that it ends with."""
    from brdf_designer.acquire.control import AcquireControl

    hand.press("Try a Simulated Acquisition")
    hand.wait(lambda: program.feature(AcquireControl).assistant is not None)
    assistant = program.feature(AcquireControl).assistant
    hand.wait(lambda: "fit" in assistant.bench.results or bool(assistant.window.messages.shown()), 1200.0)
    said = hand.ask(lambda: "; ".join(one.what for one in assistant.window.messages.shown().values()))
    if said:
        raise MissingError(said)
    hand.wait(lambda: assistant.bench.is_quiet)
    hand.press("Open as New Paint")
    hand.wait(lambda: assistant.bench.is_quiet and program.is_idle)
    save_paint(hand.ask(lambda: program.store.value), folder / "acquired.brdfpaint")


def hand_over(hand: Hand, program: Any, folder: Path) -> None:
    """Tick the report beside CxF3, and export both to a folder."""
    from brdf_designer.export.control import HandoverControl

    open_tab(hand, "export")
    section = program.feature(HandoverControl).section
    for name in ("cxf", "pdf"):
        if not hand.ask(section.formats[name].isChecked):
            hand.press(f"format_{name}", QCheckBox)
    hand.wait(section.export.isEnabled)
    hand.click(lambda: section.export, "Export…")
    hand.file(folder)
    hand.wait(lambda: len(exported(folder)) == 2 and program.is_idle)


def exported(folder: Path) -> list[Path]:
    """Return what a paint was exported to."""
    return [file for file in folder.iterdir() if file.suffix in (".cxf", ".pdf")]


def is_handed_over(folder: Path) -> bool:
    """Whether both files give the readings back."""
    wanted = load_shipped_paint("blue").measurements
    files = exported(folder)
    for file in files:
        (back,) = read_paints(file).paints
        pairs = zip(wanted, back.measurements, strict=True)
        if max(abs(a - b) for one, other in pairs for a, b in zip(one.lab, other.lab, strict=True)) > 0.01:
            return False
    return sorted(file.suffix for file in files) == [".cxf", ".pdf"]


def edit_and_die(hand: Hand, program: Any, folder: Path) -> None:
    """Change a number; the program is then killed."""
    hand.press("field_gloss.gu_20", QWidget)
    hand.type("80")
    hand.wait(lambda: program.store.value.gloss.gu_20 == 80.0)
    time.sleep(6.0)  # the autosave of a user who goes on looking
    note(folder, "count", f"{hand.count.clicks} {hand.count.keys} {hand.count.scrolls}")
    os.kill(os.getpid(), signal.SIGKILL)


def recover(hand: Hand, program: Any, folder: Path) -> None:
    """Take the unsaved work back."""
    hand.press("Recover")
    hand.wait(lambda: program.is_idle)
    note(folder, "gloss", f"{hand.ask(lambda: program.store.value.gloss.gu_20)}")


def by_keyboard(hand: Hand, program: Any, folder: Path) -> None:
    """Task 1 and an export without the mouse, with the keys that Help names."""
    hand.keys("Ctrl+N")
    hand.wait(lambda: program.documents.front.title == "Untitled")
    hand.type(*(f"{value:g}" for lab in RED.values() for value in lab))
    hand.keys("Ctrl+S")
    hand.file(folder / "keyboard.brdfpaint")
    hand.wait(lambda: (folder / "keyboard.brdfpaint").exists())


def is_typed(folder: Path) -> bool:
    """Whether the saved paint has the readings."""
    from brdf_suite.documents.store import load_paint

    return {
        one.aspecular_deg: one.lab for one in load_paint(folder / "keyboard.brdfpaint").measurements
    } == RED


def choose_german(hand: Hand, program: Any, _folder: Path) -> None:
    """Choose the language on the start page; the program starts again in it, which is the next part."""
    again: list[str] = []
    program.window.start.again = again.append
    hand.press(LANGUAGE)
    hand.wait(lambda: bool(again))


def save_in_german(hand: Hand, program: Any, folder: Path) -> None:
    """Make a paint and save it by the German words."""
    hand.press("Neuer Lack")
    hand.wait(lambda: program.is_idle)
    hand.type(*(f"{value:g}".replace(".", ",") for lab in RED.values() for value in lab))
    hand.press("Speichern")
    hand.file(folder / "keyboard.brdfpaint")
    hand.wait(lambda: (folder / "keyboard.brdfpaint").exists())


TASKS = (
    Task(
        "red_metallic",
        "Design a red metallic from nothing and see it in three lights",
        (Part("Designer", red_metallic, at_start_page=True),),
        is_red_metallic,
    ),
    Task(
        "match_standard",
        "Match a standard",
        (Part("Designer", match_standard, ("batch.brdfpaint",)),),
        lambda folder: kept(folder, "verdict").upper().startswith("PASS"),
        batch_and_standard,
    ),
    Task(
        "two_tone",
        "Two-tone a car",
        (Part("Viewer", two_tone),),
        lambda folder: "second" in kept(folder, "view") and "'car'" in kept(folder, "view"),
    ),
    Task(
        "highlight",
        "Light a highlight",
        (Part("Viewer", light_highlight),),
        lambda folder: kept(folder, "lamps") == "upper left",
    ),
    Task(
        "compare",
        "Compare two paints",
        (Part("Viewer", compare_paints),),
        lambda folder: "'side'" in kept(folder, "compare") and "silver_metallic" in kept(folder, "compare"),
    ),
    Task(
        "palette",
        "Build a palette and its sheet",
        (Part("Color Swatch", palette_and_sheet),),
        has_palette,
    ),
    Task(
        "measurement",
        "Open a measurement and say how good the fit is",
        (Part("Designer", judge_measurement, at_start_page=True),),
        lambda folder: "ΔE00" in kept(folder, "summary"),
        measured_file,
    ),
    Task(
        "acquire",
        "Acquire from a sample session",
        (Part("Designer", acquire, at_start_page=True),),
        lambda folder: (folder / "acquired.brdfpaint").exists(),
    ),
    Task("hand_over", "Hand over CxF3 and a report", (Part("Designer", hand_over),), is_handed_over),
    Task(
        "recover",
        "Recover after a kill",
        (Part("Designer", edit_and_die), Part("Designer", recover)),
        lambda folder: kept(folder, "gloss") == "80.0",
    ),
    Task("keyboard", "Do it all by keyboard", (Part("Designer", by_keyboard, at_start_page=True),), is_typed),
    Task(
        "german",
        "Do it in German",
        (
            Part("Designer", choose_german, at_start_page=True),
            Part("Designer", save_in_german, at_start_page=True),
        ),
        is_typed,
    ),
)
