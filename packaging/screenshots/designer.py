"""Walk the path of docs/use/designer.md through the real Designer, by keys and clicks, and take a picture at each step.

Run ``.venv/bin/python packaging/screenshots/designer.py``; pictures are written to docs/images/ as
``designer_path_1.png`` and so on. ``--theme``, ``--size``, ``--scale`` and ``--into`` make them elsewhere in another
look. Settings and cache are fresh ones. The exported files are read back and compared with what was typed.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

from screenshots import IMAGES, virtual_screen

BLUE = {15.0: (62.0, -4.0, -45.0), 45.0: (25.0, 4.0, -38.0), 110.0: (9.0, 8.0, -28.0)}
"""An invented but plausible blue; gloss 90 GU at 20°."""
GLOSS = 90.0
DARKER = 3.0
_PATIENCE_S = 120
_TURN_MS = 50


class Scripted:
    """Answers the question for a file."""

    path: Path | None = None

    def save_path(self, _suggested: Path, _filters: str) -> Path | None:
        """Return the file that the walk has named."""
        return self.path


class Walk:
    """The steps. Each is a generator of what has to be true before the next thing is done."""

    def __init__(self, designer: Any, dialogs: Scripted, folder: Path) -> None:
        self.designer, self.window, self.dialogs, self.folder = designer, designer.window, dialogs, folder

    def steps(self) -> Iterator[Callable[[], bool]]:
        """Do the steps one after the other; yield what to wait for before each picture."""
        yield self.empty()
        yield self.numbers()
        yield self.standard()
        yield self.darker()
        yield self.words()
        yield self.hand_over("cxf", "blue.cxf")
        yield self.hand_over("pdf", "blue.pdf")

    def empty(self) -> Callable[[], bool]:
        """Begin with nothing."""
        self.choose("File ▸ New")
        self.see(self.window.section("colour"))
        return lambda: self.designer.documents.front.title == "Untitled"

    def numbers(self) -> Callable[[], bool]:
        """Type the readings of the blue."""
        for editor, lab in zip(self.window.editors.editors, BLUE.values(), strict=True):
            for field, value in zip(editor.fields, lab, strict=True):
                self.type(field, f"{value:g}")
        self.type(self.window.coat.daily.fields["gloss.gu_20"], f"{GLOSS:g}")
        self.type(self.window.texts.name, "Blue")
        self.see(self.window.section("colour"))
        paint = self.designer.store.value
        assert {m.aspecular_deg: m.lab for m in paint.measurements} == BLUE, paint
        return lambda: True

    def standard(self) -> Callable[[], bool]:
        """Take it as the standard."""
        self.choose("Paint ▸ Use This State as Standard")
        self.see(self.window.section("standard"))
        return lambda: self.control("StandardControl").standard is not None

    def darker(self) -> Callable[[], bool]:
        """Make it darker at the flop."""
        self.see(self.window.section("colour"))
        self.type(self.window.editors.editors[2].fields[0], f"{BLUE[110.0][0] - DARKER:g}")
        return lambda: self.designer.store.value.lab_at(110.0)[0] == BLUE[110.0][0] - DARKER

    def words(self) -> Callable[[], bool]:
        """See how it differs."""
        self.see(self.window.section("standard"))
        return lambda: "darker" in self.control("StandardControl").section.sentence.text()

    def hand_over(self, name: str, file: str) -> Callable[[], bool]:
        """Write it in a format."""
        control = self.control("HandoverControl")
        self.choose("File ▸ Export…")
        control.section.choose(name)
        control.section.formats_chosen.emit()
        self.see(self.window.section("handover"))
        self.dialogs.path = self.folder / file
        self.wait(control.section.export.isEnabled)
        self.window.dismiss_message("handover")
        self.click(control.section.export)
        return lambda: (self.folder / file).exists() and "handover" in self.window.messages.shown()

    # The hand.

    def control(self, name: str) -> Any:
        """Return a feature of the program by its class."""
        return next(part for part in self.designer.features if type(part).__name__ == name)

    def choose(self, path: str) -> None:
        """Choose a command of the menus: a server without a window manager gives no window the keys of a shortcut."""
        from brdf_qt.window.command_palette import commands

        dict(commands(self.window))[path].trigger()

    def type(self, field: Any, text: str) -> None:
        """Type into a field, and Return."""
        from PySide6.QtCore import Qt
        from PySide6.QtTest import QTest

        field.setFocus()
        field.selectAll()
        QTest.keyClicks(field, text)
        QTest.keyClick(field, Qt.Key.Key_Return)
        # Without a window manager no field is notified that the focus has left it.
        getattr(field, "lineEdit", lambda: field)().deselect()

    def click(self, button: Any) -> None:
        """Click on it."""
        from PySide6.QtCore import Qt
        from PySide6.QtTest import QTest

        self.window.inspector.ensureWidgetVisible(button)
        self.wait(lambda: True)
        QTest.mouseClick(button, Qt.MouseButton.LeftButton)

    def see(self, section: Any) -> None:
        """Bring a section in sight, in its tab."""
        self.window.panel.bring_in_sight(section)
        self.wait(lambda: True)

    def wait(self, until: Callable[[], bool]) -> None:
        """Let the program run until it is so."""
        from time import monotonic

        from PySide6.QtTest import QTest

        end = monotonic() + _PATIENCE_S
        QTest.qWait(_TURN_MS)
        while not until():
            if monotonic() > end:
                raise SystemExit("A step was not done in time.")
            QTest.qWait(_TURN_MS)


def drive(options: argparse.Namespace) -> int:
    """Walk, in the process that has the screen."""
    from brdf_designer.assembly import Designer
    from brdf_qt.program.application import create_application

    from brdf_suite.reports.handover import read_paints

    app = create_application("Designer", theme_name=options.theme)
    dialogs = Scripted()
    designer = Designer(dialogs=lambda _window: dialogs)
    designer.window.resize(*(int(part) for part in options.size.split("x")))
    designer.window.fit_inspector()
    designer.window.show()
    with tempfile.TemporaryDirectory() as folder:
        walk = Walk(designer, dialogs, Path(folder))
        walk.wait(lambda: designer.window.plot.is_built)
        for number, there in enumerate(walk.steps(), 1):
            walk.wait(lambda there=there: there() and designer.is_idle)
            walk.wait(lambda: True)
            save(designer.window.grab().toImage(), options.into / f"designer_path_{number}.png")
        paint = designer.store.value
        for file in ("blue.cxf", "blue.pdf"):
            (back,) = read_paints(Path(folder) / file).paints
            worst = max(
                abs(a - b)
                for one, other in zip(paint.measurements, back.measurements, strict=True)
                for a, b in zip(one.lab, other.lab, strict=True)
            )
            print(f"{file}: read back to {worst:g} of every L*, a* and b*", flush=True)
    designer.close()
    app.exit(0)
    return 0


def save(image: Any, path: Path) -> None:
    """Write a picture and say so."""
    if not image.save(str(path)):
        raise SystemExit(f"{path} cannot be written.")
    print(path, flush=True)


def main() -> int:
    """Take the pictures."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--theme", default="dark")
    parser.add_argument("--size", default="1400x900")
    parser.add_argument("--scale", default="1", help="device pixels per pixel")
    parser.add_argument("--into", type=Path, default=IMAGES)
    parser.add_argument("--drive", action="store_true", help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.drive:
        return drive(options)
    options.into.mkdir(parents=True, exist_ok=True)
    with virtual_screen() as display, tempfile.TemporaryDirectory() as scratch:
        environment = {
            **os.environ,
            "DISPLAY": display,
            "QT_QPA_PLATFORM": "xcb",
            "QT_SCALE_FACTOR": options.scale,
            "LIBGL_ALWAYS_SOFTWARE": "1",
            "BRDF_SUITE_SETTINGS": f"{scratch}/settings",
            "BRDF_SUITE_CACHE": os.environ.get("BRDF_SUITE_CACHE", f"{scratch}/cache"),
            "BRDF_SUITE_LINK": f"screenshots-{os.getpid()}",
        }
        command = [sys.executable, __file__, "--drive", "--theme", options.theme, "--size", options.size]
        subprocess.run(
            [*command, "--into", str(options.into.absolute())], env=environment, check=True, timeout=900
        )
    return 0


if __name__ == "__main__":
    sys.exit(main())
