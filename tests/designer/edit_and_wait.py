"""Start the real Designer, drag its first slider without letting go, say so, and wait to be killed."""

from __future__ import annotations

import sys

from brdf_designer.assembly import Designer
from brdf_qt.application import create_application, run
from PySide6.QtCore import QPoint, Qt, QTimer
from PySide6.QtTest import QTest

app = create_application("Designer")
designer = Designer()


def drag() -> None:
    slider = designer.window.editors.editors[0].sliders[0]
    start = QPoint(round(slider._x(slider.amount())), slider.height() // 2)
    QTest.mousePress(slider, Qt.MouseButton.LeftButton, pos=start)
    QTest.mouseMove(slider, start + QPoint(30, 0))
    slider.edited.emit(77.5)
    sys.stdout.write("dragging\n")
    sys.stdout.flush()


designer.window.first_painted.connect(lambda: QTimer.singleShot(100, drag))
sys.exit(run(app, designer.window))
