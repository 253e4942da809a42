"""Open a table in the real Lobe Visualizer, and print how long each opening takes; a process of ``bench lobes``.

The whole window with all its views: an X server where there is one, otherwise Qt's offscreen platform without the view
in three dimensions.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path
from time import perf_counter, process_time

from brdf_suite.cli.tools.bench import load_module

_session = load_module(Path(__file__).parents[1] / "own_session.py")

SETTLE_S = 60.0
SIZE = (1400, 900)


def main(path: str, runs: int) -> None:
    with _session.own_session():
        sys.stdout.write(json.dumps(openings(path, runs)) + "\n")


def openings(path: str, runs: int) -> dict[str, object]:
    """Return seconds of every opening, from the wish to the first picture.

    ``read_s`` is until the table is in the session, ``shown_s`` until it is painted, in three dimensions with a
    screen; ``paint_s`` that of a shipped paint. ``all_s`` is until every view is at rest, the table's fit drawn too.
    ``cpu_s`` is the processor's time of all threads until the first picture, which other programs hardly lengthen.
    """
    from brdf_lobe_visualizer.assembly import LobeVisualizer
    from brdf_lobe_visualizer.view3d.panel import Space
    from brdf_qt.program.application import create_application
    from PySide6.QtGui import QGuiApplication

    app = create_application("Lobe Visualizer")
    program = LobeVisualizer()
    program.window.resize(*SIZE)
    program.window.show()
    _until(app, lambda: program.window._painted)
    program.start()
    _until(app, lambda: program.is_idle)
    space = program.feature(Space)
    seen: dict[str, float] = {}

    def read(*_of: object) -> None:
        seen["read"] = perf_counter()

    def painted() -> None:
        if "read" in seen and space.is_idle:
            seen.setdefault("painted", perf_counter())
            seen.setdefault("cpu", process_time())

    program.sources.opened.connect(read)
    if space is not None and space.view is not None:
        space.view.frameSwapped.connect(painted)
    found: dict[str, list[float]] = {"read_s": [], "shown_s": [], "paint_s": [], "all_s": [], "cpu_s": []}
    for _ in range(runs):
        for name in ("copper", path):
            program.session.set_subjects(())
            _until(app, lambda: program.is_idle)
            seen.clear()
            start, cpu = perf_counter(), process_time()
            program.sources.open(name)
            if space is not None and space.view is not None:
                _until(app, lambda: "painted" in seen)
            else:
                _until(app, lambda: "read" in seen and _views_are_there(program))
                app.processEvents()  # what has been handed to the views is painted in the turn after
                seen["painted"], seen["cpu"] = perf_counter(), process_time()
            _until(app, lambda: program.is_idle)
            if name == path:
                found["read_s"].append(seen["read"] - start)
                found["cpu_s"].append(seen["cpu"] - cpu)
                found["all_s"].append(perf_counter() - start)
            found["shown_s" if name == path else "paint_s"].append(seen["painted"] - start)
    program.close()
    return {**found, "platform": QGuiApplication.platformName()}


def _views_are_there(program: object) -> bool:
    # Figures and fits follow; a picture does not wait for them.
    return all(part.is_idle for part in program.features if part is not program.numbers)


def _until(app: object, done: object) -> None:
    from PySide6.QtCore import QEventLoop, QTimer

    # Waiting for events and not asking for them: constant polling takes processor time from the threads.
    alarm = QTimer()
    alarm.start(2)
    begin = perf_counter()
    while not done():
        app.processEvents(QEventLoop.ProcessEventsFlag.WaitForMoreEvents)
        if perf_counter() - begin > SETTLE_S:
            raise SystemExit("The program is not ready after a minute.")


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]))
