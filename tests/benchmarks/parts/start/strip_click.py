"""Click paints of the paint strip of a real Viewer or Designer, and print how long each takes to its first picture.

A process of ``bench startup``, on the display of its environment; its argument is ``viewer`` or ``designer``. Light and
form are there already, as they are once a start is over; the first paint, which pays for what is done once, is left
out.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Callable
from pathlib import Path
from time import perf_counter
from typing import TYPE_CHECKING

from brdf_suite.cli.tools.bench import load_module

if TYPE_CHECKING:
    from brdf_qt.choosing.strip import PaintStrip
    from brdf_qt.program.program import Program

_session = load_module(Path(__file__).parent.parent / "own_session.py")

PAINTS = ("pearl", "candy_red", "racing_green", "lime_green")
SIZE = (1280, 720)
_PATIENCE_S = 500.0


def main() -> None:
    with _session.own_session():
        sys.stdout.write(json.dumps(clicks(sys.argv[1])) + "\n")


def clicks(name: str) -> list[float]:
    """Return the milliseconds from the click to the frame with the paint, of each but the first."""
    from brdf_qt.program.application import create_application
    from brdf_qt.program.settings import settings
    from PySide6.QtCore import Qt
    from PySide6.QtTest import QTest

    from brdf_suite.pipeline.material import paint_titles

    app = create_application(name.capitalize())
    settings().setValue("tour/seen", True)
    program, strip, drawn = {"viewer": _viewer, "designer": _designer}[name]()
    titles = paint_titles()

    def wait(until: Callable[[], object]) -> None:
        end = perf_counter() + _PATIENCE_S
        while not until():
            if perf_counter() > end:
                raise SystemExit("the picture did not come")
            app.processEvents()

    wait(lambda: drawn() is not None and program.is_idle and strip.view.isVisible())
    times = []
    for paint in PAINTS:
        index = strip.sources.index(strip.sources.row_of(paint), 0)
        strip.view.scrollTo(index)
        place = strip.view.visualRect(index).center()
        start = perf_counter()
        QTest.mouseClick(strip.view.viewport(), Qt.MouseButton.LeftButton, pos=place)
        wait(lambda title=titles[paint]: drawn() == title)
        times.append(1e3 * (perf_counter() - start))
        wait(lambda: program.is_idle)
    program.close()
    return times[1:]


def _viewer() -> tuple[Program, PaintStrip, Callable[[], str | None]]:
    from brdf_viewer.controller import ViewerController

    from brdf_suite.documents.view import View
    from brdf_suite.pipeline.material import default_paint_name

    viewer = ViewerController(View(), default_paint_name())
    viewer.window.resize(*SIZE)
    viewer.window.show()
    frames: list[str] = []

    def note(_milliseconds: float, _typical: bool) -> None:
        if viewer.state.is_complete and viewer.state.fit is not None:
            frames.append(viewer.state.fit.name)

    viewer.window.picture.frame_drawn.connect(note)
    return viewer, viewer.window.strip, lambda: frames[-1] if frames else None


def _designer() -> tuple[Program, PaintStrip, Callable[[], str | None]]:
    from brdf_designer.assembly import Designer
    from brdf_designer.documents.paint_drawer import PaintDrawer
    from brdf_designer.picture.control import PictureControl

    designer = Designer()
    designer.window.resize(*SIZE)
    designer.window.show()
    designer.window.stage.drawers["paints"].set_open(True)
    control = designer.feature(PictureControl)

    def drawn() -> str | None:
        return None if control.drawn is None else control.drawn.name

    return designer, designer.feature(PaintDrawer).strip, drawn


if __name__ == "__main__":
    main()
