"""Open a large palette in the real Color Swatch and scroll through it; a process of ``bench palette``.

The whole window with all of its parts, on Qt's offscreen platform, and the process that draws the pictures beside it,
with no picture kept: they arrive while the grid is scrolled. Prints one JSON object.
"""

from __future__ import annotations

import json
import os
import sys
from pathlib import Path
from time import perf_counter, sleep, thread_time

from brdf_suite.cli.tools.bench import load_module

_session = load_module(Path(__file__).parents[1] / "own_session.py")

STEPS = 400
BETWEEN_S = 0.03
SIZE = (1400, 900)
NOTCH = 120
"""A wheel's notch in Qt's eighths of a degree."""
PATIENCE_S = 120.0


def main() -> None:
    with _session.own_session(offscreen=True):
        found = measure(Path(sys.argv[1]))
    sys.stdout.write(json.dumps(found) + "\n")


def measure(file: Path) -> dict[str, object]:
    from brdf_color_swatch.assembly import ColorSwatch
    from brdf_color_swatch.grid.thumbnails import VisiblePictures
    from brdf_qt.program.application import create_application
    from PySide6.QtCore import QEvent, QObject, QPoint, QPointF, Qt
    from PySide6.QtGui import QWheelEvent
    from PySide6.QtWidgets import QApplication

    app = create_application("Color Swatch")
    program = ColorSwatch()
    program.window.resize(*SIZE)
    program.session.set_look(form="sphere", size=96, as_list=False)
    program.window.show()
    wait(app, lambda: program.is_idle)
    pane = program.window.panes[0]
    viewport = pane.grid.viewport()

    class Painted(QObject):
        """Counts what the grid has painted with swatches in it."""

        count = 0

        def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: N802 - the name is Qt's
            if event.type() == QEvent.Type.Paint and pane.model.rowCount() and not pane.note:
                viewport.removeEventFilter(self)
                QApplication.sendEvent(viewport, event)
                viewport.installEventFilter(self)
                self.count += 1
                return True
            return False

    painted = Painted()
    viewport.installEventFilter(painted)
    pictures = program.feature(VisiblePictures).pictures
    arrived: list[int] = []
    pictures.arrived.connect(lambda ids: arrived.append(len(ids)))

    began = perf_counter()
    program.open(str(file))
    wait(app, lambda: painted.count > 0)
    first = perf_counter() - began
    wait(app, lambda: bool(arrived))
    first_picture = perf_counter() - began
    wait(app, lambda: not pictures.waiting)
    first_page = perf_counter() - began

    # Down by notches of the wheel, each painted; between them the event loop runs and pictures come.
    before = sum(arrived)
    times: list[float] = []
    processor: list[float] = []
    bar = pane.grid.verticalScrollBar()
    middle = QPointF(viewport.width() / 2.0, viewport.height() / 2.0)
    way = -NOTCH
    for _ in range(STEPS):
        if bar.value() >= bar.maximum():
            way = NOTCH
        event = QWheelEvent(
            middle,
            QPointF(viewport.mapToGlobal(middle.toPoint())),
            QPoint(),
            QPoint(0, way),
            Qt.MouseButton.NoButton,
            Qt.KeyboardModifier.NoModifier,
            Qt.ScrollPhase.NoScrollPhase,
            False,
        )
        place, count = bar.value(), painted.count
        start, start_cpu = perf_counter(), thread_time()
        QApplication.sendEvent(viewport, event)
        # All that waits comes before the paint, as it does for a user: pictures that have just arrived too.
        while painted.count == count and perf_counter() - start < PATIENCE_S:
            app.processEvents()
        times.append(1e3 * (perf_counter() - start))
        processor.append(1e3 * (thread_time() - start_cpu))
        assert bar.value() != place
        end = perf_counter() + BETWEEN_S
        while perf_counter() < end:
            app.processEvents()
            sleep(0.001)
    came = sum(arrived) - before
    own, drawing = os.getpid(), pictures._process.processId()
    memory = {
        "memory_mb": sum(held_kb(process, "smaps_rollup", "Pss") for process in (own, drawing)) / 1024.0,
        "window_mb": held_kb(own, "status", "VmHWM") / 1024.0,
        "drawing_mb": held_kb(drawing, "status", "VmHWM") / 1024.0,
    }
    program.close()
    program.window.close()
    return {
        "swatches": pane.model.rowCount(),
        "open_s": first,
        "first_picture_s": first_picture,
        "first_page_s": first_page,
        "scroll_ms": times,
        "scroll_cpu_ms": processor,
        "arrived": came,
        **memory,
    }


def held_kb(process: int, file: str, name: str) -> float:
    """Return a process's memory as reported by Linux, kB."""
    text = Path(f"/proc/{process}/{file}").read_text()
    return float(next(line.split()[1] for line in text.splitlines() if line.startswith(f"{name}:")))


def wait(app, is_there) -> None:
    end = perf_counter() + PATIENCE_S
    while not is_there():
        if perf_counter() > end:
            raise TimeoutError("the program did not get there")
        app.processEvents()
        # As an event loop does, it sleeps where there is nothing to do: threads that read go on meanwhile.
        sleep(0.001)


if __name__ == "__main__":
    main()
