"""Open and close so many tabs in the real Designer; a process of ``bench scale``.

On Qt's offscreen platform, with a turn of the event loop after each. Prints one JSON object.
"""

from __future__ import annotations

import json
import sys
from dataclasses import replace
from pathlib import Path
from time import perf_counter, process_time

from brdf_suite.cli.tools.bench import load_module

_session = load_module(Path(__file__).parents[1] / "own_session.py")
_turns = load_module(Path(__file__).with_name("turns.py"))


def main(count: int) -> None:
    with _session.own_session(offscreen=True):
        sys.stdout.write(json.dumps(measure(count)) + "\n")


def measure(count: int) -> dict[str, object]:
    from brdf_designer.assembly import Designer
    from brdf_qt.program.application import create_application
    from PySide6.QtGui import QAction

    from brdf_suite.pipeline.material import load_shipped_paint

    create_application("Designer")
    program = Designer()
    program.window.resize(1400, 900)
    program.window.show()
    turns = _turns.Turns()
    turns.until("start", lambda: program.is_idle)
    documents = program.documents
    paint = load_shipped_paint("blue")
    begun, cpu = perf_counter(), process_time()
    for number in range(count):
        turns.call("open", lambda number=number: documents.add(replace(paint, name=f"Paint {number}")))
        turns.turn("open")
    turns.until("open", lambda: program.is_idle)
    opened, opened_cpu = perf_counter() - begun, process_time() - cpu
    singly, few = perf_counter(), min(20, count - 1)
    for _ in range(few):
        turns.call("close one", lambda: documents.close(documents.front))
        turns.turn("close one")
    turns.until("close one", lambda: program.is_idle)
    singly = (perf_counter() - singly) / few
    for _ in range(few):
        documents.reopen()
        turns.turn("open")
    turns.until("open", lambda: program.is_idle)
    begun, cpu = perf_counter(), process_time()
    turns.call("close", program.window.findChild(QAction, "action_Close All Tabs").trigger)
    turns.until("close", lambda: program.is_idle)
    closed, closed_cpu = perf_counter() - begun, process_time() - cpu
    found = {
        "open_s": opened,
        "open_cpu_s": opened_cpu,
        "close_s": closed,
        "close_one_s": singly,
        "close_cpu_s": closed_cpu,
        "left": len(documents.row),
        "turns_s": turns.longest_s,
        "turns_cpu_s": turns.processor_s,
        "memory_mb": _turns.resident_mb(),
    }
    program.close()
    program.window.close()
    return found


if __name__ == "__main__":
    main(int(sys.argv[1]))
