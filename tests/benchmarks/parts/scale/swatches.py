"""Open, scroll, search, order and edit a palette of many paints in the real Color Swatch; a process of ``bench scale``.

On Qt's offscreen platform with chips, which need no pictures. Prints one JSON object.
"""

from __future__ import annotations

import json
import subprocess
import sys
import tempfile
from dataclasses import replace
from pathlib import Path
from time import process_time

from brdf_suite.cli.tools.bench import load_module

_PARTS = Path(__file__).parents[1]
_session = load_module(_PARTS / "own_session.py")
_turns = load_module(Path(__file__).with_name("turns.py"))
_paints = load_module(_PARTS / "palette" / "paints.py")

SIZE = (1400, 900)


_MAKE = """
import sys
from pathlib import Path
from brdf_suite.cli.tools.bench import load_module
from brdf_suite.documents.palette_store import save_palette
save_palette(load_module(Path(sys.argv[1])).palette(int(sys.argv[2])), Path(sys.argv[3]))
"""


def main(count: int) -> None:
    with _session.own_session(offscreen=True), tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "many.brdfpalette"
        # In a process of its own, whose memory is not the window's.
        made = [sys.executable, "-c", _MAKE, str(_PARTS / "palette" / "paints.py"), str(count), str(file)]
        subprocess.run(made, check=True)
        found = measure(file, count)
    sys.stdout.write(json.dumps(found) + "\n")


def measure(file: Path, count: int) -> dict[str, object]:
    from brdf_color_swatch.assembly import ColorSwatch
    from brdf_qt.program.application import create_application

    create_application("Color Swatch")
    program = ColorSwatch()
    program.window.resize(*SIZE)
    program.session.set_look(form="chips", size=96, as_list=False)
    program.window.show()
    turns = _turns.Turns()
    turns.until("start", lambda: program.is_idle)
    before = _turns.resident_mb()
    pane, session = program.window.panes[0], program.session
    cpu = process_time()
    turns.call("open", lambda: program.open(str(file)))
    open_s = turns.until("open", lambda: pane.model.rowCount() == count and not pane.note)
    turns.until("open", lambda: program.is_idle)
    open_cpu_s = process_time() - cpu
    bar = pane.grid.verticalScrollBar()
    for step in range(20):
        turns.call("scroll", lambda step=step: bar.setValue(bar.maximum() * step // 19))
        turns.until("scroll", _count(2))
    turns.call("search", lambda: session.set_state(replace(session.state, text="blue")))
    turns.until("search", _count(3))
    turns.until("search", lambda: program.is_idle)
    turns.call("search", lambda: session.set_state(replace(session.state, text="")))
    turns.until("search", _count(3))
    turns.until("search", lambda: program.is_idle)
    for sort in ("lightness", "name", "L_45", "own"):
        turns.call("order", lambda sort=sort: session.set_state(replace(session.state, sort=sort)))
        turns.until("order", _count(3))
        turns.until("order", lambda: program.is_idle)
    turns.call("select", pane.grid.selectAll)
    turns.until("select", _count(5))
    turns.until("select", lambda: program.is_idle)
    turns.call("select", lambda: pane.grid.select_rows([3]))
    turns.until("select", _count(5))
    turns.call("edit", lambda: pane.model.setData(pane.model.index(3, 0), "Another name"))
    turns.until("edit", _count(5))
    turns.until("edit", lambda: program.is_idle)
    turns.call("edit", program.library.history.undo)
    turns.until("edit", _count(5))
    turns.until("edit", lambda: program.is_idle)
    found = {
        "open_s": open_s,
        "open_cpu_s": open_cpu_s,
        "turns_s": turns.longest_s,
        "turns_cpu_s": turns.processor_s,
        "memory_mb": _turns.resident_mb(),
        "memory_peak_mb": _turns.resident_mb("VmHWM"),
        "memory_before_mb": before,
    }
    program.close()
    program.window.close()
    return found


def _count(turns: int):
    left = [turns]

    def done() -> bool:
        left[0] -= 1
        return left[0] < 0

    return done


if __name__ == "__main__":
    main(int(sys.argv[1]))
