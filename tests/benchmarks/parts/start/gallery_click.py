"""Click paints of the start page over a real Designer, and print how long each takes to its first picture.

A process of ``bench startup``, on the display of its environment. Light and form are there already, as they are once a
start is over; the first paint, which pays for what is done once, is left out.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path
from time import perf_counter

from brdf_suite.cli.tools.bench import load_module

_session = load_module(Path(__file__).parent.parent / "own_session.py")

PAINTS = ("pearl", "candy_red", "racing_green", "lime_green")
SIZE = (1280, 720)
_PATIENCE_S = 120.0


def main() -> None:
    with _session.own_session():
        sys.stdout.write(json.dumps(clicks()) + "\n")


def clicks() -> list[float]:
    """Return the milliseconds from the click to the frame with the paint, of each but the first."""
    from brdf_designer.assembly import Designer
    from brdf_designer.picture.control import PictureControl
    from brdf_qt.program.application import create_application
    from brdf_qt.program.settings import settings
    from PySide6.QtCore import Qt
    from PySide6.QtTest import QTest

    from brdf_suite.pipeline.material import paint_titles

    app = create_application("Designer")
    settings().setValue("tour/seen", True)
    designer = Designer()
    designer.window.resize(*SIZE)
    designer.window.show()
    control, titles = designer.feature(PictureControl), paint_titles()

    def wait(until) -> None:
        end = perf_counter() + _PATIENCE_S
        while not until():
            if perf_counter() > end:
                raise SystemExit("the picture did not come")
            app.processEvents()

    wait(lambda: control.drawn is not None and designer.is_idle)
    times = []
    for name in PAINTS:
        designer.window.start.show()
        page = designer.window.start.page
        wait(page.isVisible)
        start = perf_counter()
        QTest.mouseClick(page.gallery.tiles[name], Qt.MouseButton.LeftButton)
        wait(lambda title=titles[name]: control.drawn.name == title)
        times.append(1e3 * (perf_counter() - start))
        wait(lambda: designer.is_idle)
    designer.close()
    return times[1:]


if __name__ == "__main__":
    main()
