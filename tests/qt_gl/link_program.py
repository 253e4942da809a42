"""A program on the live link, for tests: publishes what it reads from stdin, prints what it receives.

Lines in: ``publish TOPIC JSON``, ``flood TOPIC COUNT``, ``quit``. Lines out, one JSON object each:
``{"event": "received" | "peers" | "ready", ...}``.
"""

from __future__ import annotations

import json
import os
import sys

from brdf_qt.link.link import LiveLink
from PySide6.QtCore import QCoreApplication, QSocketNotifier, QTimer


def whole_number(value: dict) -> None:
    """The check of these tests: the value is ``{"n": int}``, whatever else it holds."""
    if not isinstance(value.get("n"), int):
        raise ValueError("n is not a whole number")


def say(event: str, **more: object) -> None:
    print(json.dumps({"event": event, **more}), flush=True)


def main() -> None:
    app = QCoreApplication([])
    checks = {"paint": whole_number, "view": whole_number}
    link = LiveLink(sys.argv[1], checks=checks)
    link.received.connect(lambda topic, value: say("received", topic=topic, value=value))
    link.peers_changed.connect(lambda count: say("peers", count=count, roles=link.peers, hub=link.is_hub))
    pending = bytearray()

    def read() -> None:
        data = os.read(0, 1 << 20)
        if not data:
            app.quit()
        pending.extend(data)
        *lines, rest = pending.split(b"\n")
        pending[:] = rest
        for line in lines:
            obey(*line.decode().split(" ", 2))

    def obey(word: str, *rest: str) -> None:
        if word == "publish":
            link.publish(rest[0], json.loads(rest[1]))
        elif word == "flood":
            for n in range(int(rest[1])):
                link.publish(rest[0], {"n": n, "filling": "x" * 400})
                if n % 50 == 0:
                    app.processEvents()
        elif word == "quit":
            link.close()
            app.quit()

    notifier = QSocketNotifier(0, QSocketNotifier.Type.Read)
    notifier.activated.connect(read)
    link.start()
    QTimer.singleShot(0, lambda: say("ready", pid=os.getpid(), hub=link.is_hub))
    app.exec()
    notifier.setEnabled(False)


if __name__ == "__main__":
    main()
