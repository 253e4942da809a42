"""Start the real Designer and drag its first slider, which is never let go, as the lines on standard input say.

``edit L`` moves the slider to L* = L and is answered by ``edited L``; ``tab NAME`` opens a shipped paint in a tab
of its own, takes the slider again and is answered by ``opened NAME``. ``ready`` comes first.
"""

from __future__ import annotations

import sys
from threading import Thread

from brdf_designer.assembly import Designer
from brdf_qt.program.application import create_application
from PySide6.QtCore import QObject, QPoint, Qt, QTimer, Signal
from PySide6.QtTest import QTest


class Hand(QObject):
    line_read = Signal(str)


app = create_application("Designer")
designer = Designer()
hand = Hand()


def grip() -> None:
    slider = designer.window.editors.editors[0].sliders[0]
    low, high = slider.positions()[[0, -1]]
    start = QPoint(round(slider.width() * (slider.amount() - low) / (high - low)), slider.height() // 2)
    QTest.mousePress(slider, Qt.MouseButton.LeftButton, pos=start)
    QTest.mouseMove(slider, start + QPoint(30, 0))


def say(text: str) -> None:
    sys.stdout.write(text + "\n")
    sys.stdout.flush()


def obey(line: str) -> None:
    word, what = line.split()
    if word == "edit":
        designer.window.editors.editors[0].sliders[0].edited.emit(float(what))
        say(f"edited {what}")
    else:
        slider = designer.window.editors.editors[0].sliders[0]
        QTest.mouseRelease(slider, Qt.MouseButton.LeftButton)
        designer.open(what)
        grip()
        say(f"opened {what}")


def listen() -> None:
    for line in sys.stdin:
        hand.line_read.emit(line)


def begin() -> None:
    grip()
    say("ready")
    Thread(target=listen, daemon=True).start()


hand.line_read.connect(obey, Qt.ConnectionType.QueuedConnection)
designer.window.first_painted.connect(lambda: QTimer.singleShot(100, begin))
designer.window.show()
sys.exit(app.exec())
