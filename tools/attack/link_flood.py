"""The live link under a flood: how old the newest value is at its delivery, and how long the event loop stands.

    python tools/attack/link_flood.py [--seconds 10] [--kilobytes 4] [--json]

One process writes paints to the link's socket as fast as it takes them; each holds the time at which it was written.
This process is the hub that they come to. ``oldest_s`` is the largest age of a value at its delivery, ``last_s`` the
time from the end of the flood to the delivery of its last value, ``newcomer_s`` the time from the start of a link in a
third process, in the middle of the flood, to its first value, ``stall_ms`` the longest time between two turns of the
event loop: what the link costs a window, without what the window draws. ``idle_stall_ms`` is the same before the flood:
what other processes of the machine cost. Status 1 where one is over its bound.
"""

from __future__ import annotations

import argparse
import json
import math
import os
import sys
import time
import uuid
from dataclasses import replace
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))
os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

from brdf_qt.link.address import LinkAddress
from brdf_qt.link.link import LiveLink
from brdf_qt.link.messages import AHEAD_MS, HELLO, encode, next_seq
from brdf_qt.program.application import create_application
from PySide6.QtCore import QCoreApplication, QProcess, QTimer
from PySide6.QtNetwork import QLocalSocket

from brdf_suite.documents.store import paint_to_json
from brdf_suite.pipeline.material import load_shipped_paint
from tools.attack.bounds import OLDEST_S, STALL_MS

_END = "end"


def flood(name: str, seconds: float, size: int) -> int:
    """Write paints of about ``size`` bytes to the link for a time, and print how many."""
    app = QCoreApplication([])
    socket = QLocalSocket()
    socket.connectToServer(LinkAddress(name).socket_name)
    if not socket.waitForConnected(10_000):
        raise SystemExit("the link is not there")
    socket.write(encode(HELLO, {"role": "designer"}, "flood", 0).line)
    paint, filling = load_shipped_paint("blue"), "x" * size
    count, seq, end = 0, None, time.monotonic() + seconds
    while True:
        now = time.monotonic()
        notes = f"{now} {_END if now >= end else filling}"
        seq = next_seq(seq)
        while seq > time.monotonic_ns() // 1_000_000 + AHEAD_MS // 2:
            time.sleep(0.001)  # numbers far ahead of the time are refused
        socket.write(encode("paint", paint_to_json(replace(paint, notes=notes)), "flood", seq).line)
        count += 1
        while socket.bytesToWrite() > size:
            socket.waitForBytesWritten(1000)
        if now >= end:
            break
    while socket.bytesToWrite():
        socket.waitForBytesWritten(1000)
    print(count, flush=True)
    QTimer.singleShot(3000, app.quit)  # the connection stays until the last value is there
    return app.exec()


def join(name: str) -> int:
    """Connect to the link, and print how long its first value took, in seconds."""
    app = create_application("Newcomer")
    link = LiveLink("viewer", name=name)
    begin = time.monotonic()

    def received(_topic: str, _value: dict[str, Any]) -> None:
        print(time.monotonic() - begin, flush=True)
        app.quit()

    link.received.connect(received)
    link.start()
    QTimer.singleShot(10_000, app.quit)
    status = app.exec()
    link.close()
    return status


def _start(process: QProcess, *words: str) -> None:
    """Run this program with other words; what it reports as an error is passed on."""
    process.setProcessChannelMode(QProcess.ProcessChannelMode.ForwardedErrorChannel)
    process.start(sys.executable, [str(Path(__file__).resolve()), *words])


def _printed(process: QProcess) -> float:
    """Return the number that a process prints last; NaN if there is none."""
    process.waitForFinished(20_000)
    said = bytes(process.readAllStandardOutput().data()).decode().split()
    return float(said[-1]) if said else math.nan


def measure(seconds: float, size: int) -> dict[str, float]:
    """Return the figures of one flood."""
    app = create_application("Flood")
    name = f"flood-{uuid.uuid4().hex[:12]}"
    link = LiveLink("viewer", name=name)
    link.start()
    ages: list[float] = []
    last: list[float] = []
    turned = time.monotonic()
    longest = {False: 0.0, True: 0.0}

    def received(_topic: str, value: dict[str, Any]) -> None:
        sent, rest = value["notes"].split(" ", 1)
        ages.append(time.monotonic() - float(sent))
        if rest == _END:
            last.append(ages[-1])
            app.quit()

    def turn() -> None:
        nonlocal turned
        now = time.monotonic()
        longest[bool(ages)] = max(longest[bool(ages)], now - turned)
        turned = now

    link.received.connect(received)
    every = QTimer()
    every.timeout.connect(turn)
    every.start(0)
    flooding, newcomer = QProcess(), QProcess()
    length = ("--seconds", str(seconds), "--kilobytes", str(size / 1000))
    begin_ms = round(500 * seconds)
    QTimer.singleShot(begin_ms, lambda: _start(flooding, "--inside", name, *length))
    QTimer.singleShot(begin_ms + round(200 * seconds), lambda: _start(newcomer, "--newcomer", name))
    QTimer.singleShot(round(1000 * seconds) + 60_000, app.quit)
    app.exec()
    sent, served_s = _printed(flooding), _printed(newcomer)
    link.close()
    return {
        "sent": sent,
        "delivered": float(len(ages)),
        "oldest_s": max(ages, default=float("inf")),
        "last_s": last[0] if last else float("inf"),
        "newcomer_s": served_s,
        "stall_ms": 1000.0 * longest[True],
        "idle_stall_ms": 1000.0 * longest[False],
    }


def main() -> int:
    """Measure one flood and print its figures; 1 where one is over its bound."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--seconds", type=float, default=10.0)
    parser.add_argument("--kilobytes", type=float, default=4.0, help="size of each message")
    parser.add_argument("--json", action="store_true")
    parser.add_argument("--inside", help=argparse.SUPPRESS)
    parser.add_argument("--newcomer", help=argparse.SUPPRESS)
    options = parser.parse_args()
    size = round(1000 * options.kilobytes)
    if options.inside:
        return flood(options.inside, options.seconds, size)
    if options.newcomer:
        return join(options.newcomer)
    found = measure(options.seconds, size)
    print(
        json.dumps(found)
        if options.json
        else "\n".join(f"{key:10} {value:10.3f}" for key, value in found.items())
    )
    ages = (found["oldest_s"], found["last_s"], found["newcomer_s"])
    return int(not all(age <= OLDEST_S for age in ages) or found["stall_ms"] > STALL_MS)


if __name__ == "__main__":
    sys.exit(main())
