"""Stands for Designer in tests: a process of its own that publishes paints on the live link on request.

Lines in: ``lab L a b`` (a paint of that colour at all angles), ``gloss GU``, ``drag COUNT`` (that many paints, as
a slider gives them), ``quit``.
"""

from __future__ import annotations

import os
import sys
from dataclasses import replace

from brdf_qt.link.link import LiveLink
from PySide6.QtCore import QCoreApplication, QSocketNotifier

from brdf_suite.documents.paint import Gloss, solid_paint
from brdf_suite.documents.store import paint_to_json


def main() -> None:
    app = QCoreApplication([])
    link = LiveLink("designer")
    paint = [solid_paint("test paint", (50.0, 0.0, 0.0))]
    pending = bytearray()

    def publish(changed: object) -> None:
        paint[0] = changed
        link.publish("paint", paint_to_json(changed))

    def read() -> None:
        data = os.read(0, 1 << 16)
        if not data:
            app.quit()
        pending.extend(data)
        *lines, rest = pending.split(b"\n")
        pending[:] = rest
        for line in lines:
            obey(*line.decode().split())

    def obey(word: str, *numbers: str) -> None:
        if word == "lab":
            lab = tuple(float(n) for n in numbers)
            publish(replace(solid_paint("test paint", lab), gloss=paint[0].gloss))
        elif word == "gloss":
            publish(replace(paint[0], gloss=Gloss(float(numbers[0]))))
        elif word == "drag":
            for step in range(int(numbers[0])):
                publish(solid_paint("test paint", (20.0 + 60.0 * step / int(numbers[0]), 0.0, 0.0)))
                app.processEvents()

    notifier = QSocketNotifier(0, QSocketNotifier.Type.Read)
    notifier.activated.connect(read)
    link.start()
    print("ready", flush=True)
    sys.exit(app.exec())


if __name__ == "__main__":
    main()
