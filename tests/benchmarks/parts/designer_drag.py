"""Drag a slider of the real Designer by mouse events, and print how long each takes; a process of ``bench designer``.

The whole window with all of its parts, on Qt's offscreen platform: the figures are the program's own and no X server's,
and no picture is drawn there; its place is measured all the same.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path
from time import perf_counter, thread_time
from typing import TYPE_CHECKING

from brdf_suite.cli.tools.bench import load_module

if TYPE_CHECKING:
    from brdf_designer.window.window import DesignerWindow

_session = load_module(Path(__file__).with_name("own_session.py"))

STEPS = 600
SETTLE_S = 4.0
BETWEEN_S = 0.004
"""What the event loop gets between two events: a mouse sends events some 125 to 1,000 times a second."""
SIZE = (1400, 900)
SWING_PX = 60
WHOLE_SCREEN = (1920, 1080)


def main() -> None:
    with _session.own_session(offscreen=True):
        sys.stdout.write(json.dumps(drag()) + "\n")


def drag() -> dict[str, list[float] | float]:
    """Return, in milliseconds, ``update`` and ``values`` of every event, and ``idle`` of every piece of idle work.

    ``followed`` is the time from the event until the fit, strip, curves and status bar are painted too. ``cpu`` is
    the processor's time of each update on the thread of the window, which other programs hardly lengthen, and
    ``followed_cpu`` that of all of ``followed``.
    """
    from brdf_designer.assembly import Designer
    from brdf_designer.session.paint_session import IdleWork
    from brdf_qt.program.application import create_application
    from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
    from PySide6.QtGui import QMouseEvent
    from PySide6.QtTest import QTest
    from PySide6.QtWidgets import QApplication

    app = create_application("Designer")
    designer = Designer()
    designer.window.resize(*WHOLE_SCREEN)
    designer.window.fit_inspector()
    designer.window.show()
    _let_run(app, SETTLE_S)
    share = picture_share(designer.window)
    designer.window.resize(*SIZE)
    _let_run(app, SETTLE_S)
    idle: list[float] = []
    run_one = IdleWork._run_one

    def timed(self: IdleWork) -> None:
        start = perf_counter()
        run_one(self)
        idle.append(1e3 * (perf_counter() - start))

    designer.session._idle._timer.timeout.disconnect()
    designer.session._idle._timer.timeout.connect(lambda: timed(designer.session._idle))
    slider = designer.window.editors.plane.slider
    start = QPoint(round(slider._x(slider.amount())), slider.height() // 2)
    QTest.mousePress(slider, Qt.MouseButton.LeftButton, pos=start)
    values, update, cpu, followed, followed_cpu = [], [], [], [], []
    before = slider.amount()
    for step in range(STEPS):
        # To and fro, a pixel a step, and never twice the same place in a row.
        place = abs((step + SWING_PX // 2) % (2 * SWING_PX) - SWING_PX) - SWING_PX // 2
        point = start + QPoint(place, 0)
        event = QMouseEvent(
            QEvent.Type.MouseMove,
            QPointF(point),
            QPointF(slider.mapToGlobal(point)),
            Qt.MouseButton.NoButton,
            Qt.MouseButton.LeftButton,
            Qt.KeyboardModifier.NoModifier,
        )
        began, began_cpu = perf_counter(), thread_time()
        QApplication.sendEvent(slider, event)
        set_at = perf_counter()
        # What has changed is painted: numbers, tracks, and the target colours of the patches.
        QApplication.sendPostedEvents(designer.window, QEvent.Type.UpdateRequest)
        ended, ended_cpu = perf_counter(), thread_time()
        values.append(1e3 * (set_at - began))
        update.append(1e3 * (ended - began))
        cpu.append(1e3 * (ended_cpu - began_cpu))
        # The fit, with strip, curves and what patches and status bar say of it, comes in the next turn of the loop.
        while not designer.controller.is_idle:
            app.processEvents()
        QApplication.sendPostedEvents(designer.window, QEvent.Type.UpdateRequest)
        followed.append(1e3 * (perf_counter() - began))
        followed_cpu.append(1e3 * (thread_time() - began_cpu))
        assert slider.amount() != before or step == 0
        before = slider.amount()
        _let_run(app, BETWEEN_S)
    QTest.mouseRelease(slider, Qt.MouseButton.LeftButton, pos=start)
    assert designer.store.stack.count() == 1
    designer.close()
    times = {"values": values, "update": update, "cpu": cpu, "followed": followed, "idle": idle}
    return {**times, "followed_cpu": followed_cpu, "picture_share": share}


def picture_share(window: DesignerWindow) -> float:
    """Return the share of the window's area that shows the picture: what drawers cover is not counted."""
    from PySide6.QtGui import QRegion

    stage = window.stage
    seen = QRegion(stage.rect())
    for drawer in stage.drawers.values():
        if drawer.isVisible():
            seen -= QRegion(drawer.geometry())
    area = sum(rect.width() * rect.height() for rect in seen)
    return area / (window.width() * window.height())


def _let_run(app: object, seconds: float) -> None:
    end = perf_counter() + seconds
    while perf_counter() < end:
        app.processEvents()


if __name__ == "__main__":
    main()
