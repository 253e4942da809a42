"""A working day in minutes: edits, file openings, light changes and both themes in the real programs.

Designer edits paints, undoes and redoes, opens and closes files; Color Swatch opens palettes and edits them; Viewer
changes lights and paints. Each runs as a process of its own on a virtual screen, with OpenGL, and is looked at when it
is at rest: resident memory, threads, open files, timers, objects of Qt, objects of OpenGL. What a program keeps by
design (the last 1,000 steps of a history, 20 closed tabs, filtered lights on disk) is full after the first half, with
which the end is compared: memory may have grown by 10 %, no count beyond what it was in the first half. Threads of
Qt's pools, which start and end as there is work, are not counted, nor are descriptors of events: each of Qt's
threads has one.

Run ``python tools/attack/long_session.py [--scale 1] [--program designer] [--offscreen] [--json]``. At scale 1 that is
30,000 edits, 500 file openings and 200 light changes; ``--scale .01`` is a slice, too short for a verdict on memory
and threads, whose first half fills histories and pools. Status 1 where something grows.
"""

from __future__ import annotations

import argparse
import gc
import json
import os
import subprocess
import sys
import tempfile
from collections import Counter
from collections.abc import Callable
from contextlib import ExitStack, suppress
from dataclasses import replace
from pathlib import Path
from statistics import median
from time import perf_counter, sleep
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from tools.attack.bounds import MOST_GROWTH, SHORTEST_VERDICT

ROOT = Path(__file__).resolve().parents[2]
EDITS, OPENINGS, LIGHTS = 30_000, 500, 200
ROUNDS = 20
"""So often a program is looked at."""
_PATIENCE_S = 900.0

Sample = dict[str, float]


def sample() -> Sample:
    """Return what this process holds now."""
    import moderngl
    from PySide6.QtCore import QObject, QTimer
    from PySide6.QtWidgets import QApplication

    gc.collect()
    status = Path("/proc/self/status").read_text(encoding="ascii")
    memory = next(line.split()[1] for line in status.splitlines() if line.startswith("VmRSS:"))
    threads = [task.read_text().strip() for task in Path("/proc/self/task").glob("*/comm")]
    roots: list[QObject] = list(QApplication.topLevelWidgets())
    kinds = (
        moderngl.Buffer,
        moderngl.Texture,
        moderngl.TextureCube,
        moderngl.VertexArray,
        moderngl.Program,
        moderngl.Framebuffer,
    )
    return {
        "memory_mb": float(memory) / 1024.0,
        "threads": sum(name != "Thread (pooled)" for name in threads),
        "files": _open_files(),
        "timers": sum(len(root.findChildren(QTimer)) for root in roots),
        "qt_objects": sum(len(root.findChildren(QObject)) for root in roots),
        "gl_objects": sum(isinstance(one, kinds) for one in gc.get_objects()),
    }


def _open_files() -> int:
    """Return how many files are open; descriptors of events are not counted, since each thread of Qt has one."""
    count = 0
    for file in Path("/proc/self/fd").iterdir():
        with suppress(OSError):  # it was closed meanwhile
            count += "[eventfd]" not in str(file.readlink())
    return count


def kinds_held() -> dict[str, int]:
    """Return how many Qt objects of each class the windows hold, for the search of a leak."""
    from PySide6.QtCore import QObject
    from PySide6.QtWidgets import QApplication

    held = (one for root in QApplication.topLevelWidgets() for one in root.findChildren(QObject))
    return dict(Counter(one.metaObject().className() for one in held))


def settle(is_idle: Callable[[], bool]) -> None:
    """Run the event loop until a program is at rest."""
    from PySide6.QtCore import QCoreApplication, QEvent

    end = perf_counter() + _PATIENCE_S
    quiet = 0
    while quiet < 3:
        QCoreApplication.processEvents()
        QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
        quiet = quiet + 1 if is_idle() else 0
        if perf_counter() > end:
            raise SystemExit("the program does not come to rest")
        sleep(0.001)


def designer(scale: float, folder: Path) -> list[Sample]:
    """Edit paints in turn, and open and close files."""
    from brdf_designer.assembly import Designer
    from brdf_designer.documents.tabs import MOST_CLOSED
    from brdf_designer.session.edits import SetLab
    from brdf_qt.program import theme
    from brdf_qt.program.application import create_application

    from brdf_suite.documents.store import save_paint
    from brdf_suite.pipeline.material import load_shipped_paint, paint_names

    app = create_application("Designer")
    program = Designer()
    program.window.resize(1280, 720)
    program.window.show()
    settle(lambda: program.is_idle)
    files = []
    for name in paint_names():
        files.append(folder / f"{name}.brdfpaint")
        save_paint(load_shipped_paint(name), files[-1])
    session, found = program.session, []
    for number in range(MOST_CLOSED + 1):  # so many are kept when they are closed
        program.documents.open(files[number % len(files)])
        settle(lambda: program.reading.is_idle and not session.is_fitting)
        program.documents.close(program.documents.front)
    edits, openings = round(EDITS * scale / ROUNDS), max(1, round(OPENINGS * scale / 2 / ROUNDS))
    for turn in range(ROUNDS):
        theme.apply(app, ("dark", "light")[turn % 2], remember=False)
        for number in range(openings):
            program.documents.open(files[(turn + number) % len(files)])
            settle(lambda: program.reading.is_idle and not session.is_fitting)
            for step in range(max(1, edits // openings)):
                lightness = session.paint.measurements[0].lab[0]
                session.edit(SetLab(0, 0, lightness + (0.5, -0.5)[step % 2]))
                if step % 10 == 9:
                    session.undo()
                    session.redo()
                app.processEvents()
            front = program.documents.front
            path = front.store.path
            assert path is not None  # it was opened from a file
            front.store.mark_clean(path)
            program.documents.close(front)
        settle(lambda: program.is_idle)
        found.append(sample())
    program.close()
    program.window.close()
    return found


def swatch(scale: float, folder: Path) -> list[Sample]:
    """Open palettes, edit and search them, and take them out of the library."""
    from brdf_color_swatch.assembly import ColorSwatch
    from brdf_qt.program import theme
    from brdf_qt.program.application import create_application

    from brdf_suite.documents.palette import Entry, Palette
    from brdf_suite.documents.palette_store import save_palette
    from brdf_suite.pipeline.material import load_shipped_paint, paint_names

    app = create_application("Color Swatch")
    program = ColorSwatch()
    program.session.set_look(form="chips")
    program.window.resize(1280, 720)
    program.window.show()
    settle(lambda: program.is_idle)
    paints = [load_shipped_paint(name) for name in paint_names()]
    entries = tuple(Entry(paints[n % len(paints)], id=str(n), code=f"C-{n}") for n in range(200))
    for number in range(4):
        save_palette(Palette(f"Palette {number}", entries), folder / f"{number}.brdfpalette")
    session, found = program.session, []
    edits, openings = round(EDITS * scale / 10 / ROUNDS), max(1, round(OPENINGS * scale / 4 / ROUNDS))
    for turn in range(ROUNDS):
        theme.apply(app, ("dark", "light")[turn % 2], remember=False)
        for number in range(openings):
            program.open(str(folder / f"{number % 4}.brdfpalette"))
            settle(lambda: session.palette is not None and program.is_idle)
            key = session.state.scope.palette
            for step in range(max(1, edits // openings)):
                model = program.window.panes[0].model
                model.setData(model.index(step % model.rowCount(), 1), f"D-{turn}-{step}")
                app.processEvents()
            session.set_state(replace(session.state, text="C-1"))
            settle(lambda: program.is_idle)
            item = program.library.item(key)
            assert item is not None
            assert item.palette is not None
            store = item.palette.store
            assert store.path is not None  # it was opened from a file
            store.mark_clean(store.path)
            program.library.close(key)
        settle(lambda: program.is_idle)
        found.append(sample())
    program.close()
    program.window.close()
    return found


def viewer(scale: float, _folder: Path) -> list[Sample]:
    """Change lights, forms and paints."""
    from brdf_qt.program import theme
    from brdf_qt.program.application import create_application
    from brdf_viewer.controller import ViewerController

    from brdf_suite.documents.view import View
    from brdf_suite.pipeline.material import default_paint_name, paint_names

    app = create_application("Viewer")
    program = ViewerController(View(), default_paint_name())
    program.window.resize(640, 400)
    program.window.show()
    settle(lambda: program.is_idle)
    lights = ("booth", "photo_studio", "street")
    found = []
    changes = max(1, round(LIGHTS * scale / ROUNDS))
    for turn in range(ROUNDS):
        theme.apply(app, ("dark", "light")[turn % 2], remember=False)
        for number in range(changes):
            program.state.change_view(environment=lights[(turn + number) % len(lights)])
            settle(lambda: program.is_idle)
            program.state.change_view(surface=("sphere", "panel")[number % 2])
            settle(lambda: program.is_idle)
            program.paint.open(paint_names()[(turn * changes + number) % len(paint_names())])
            settle(lambda: program.is_idle)
        found.append(sample())
    program.close()
    program.window.close()
    return found


PROGRAMS: dict[str, Callable[[float, Path], list[Sample]]] = {
    "designer": designer,
    "swatch": swatch,
    "viewer": viewer,
}


def verdict(samples: list[Sample]) -> dict[str, dict[str, Any]]:
    """Return by name what was held: at most before, in the middle and at the end (medians of three looks), growth."""
    middle, end = samples[len(samples) // 2 - 1 : len(samples) // 2 + 2], samples[-3:]
    result = {}
    for name in samples[0]:
        before, after = (median(one[name] for one in some) for some in (middle, end))
        result[name] = {
            "most_before": max(one[name] for one in samples[: len(samples) // 2 + 1]),
            "middle": before,
            "end": after,
            "growth": after / before - 1.0 if before else after,
        }
    return result


def faults(found: dict[str, dict[str, Any]], scale: float) -> list[str]:
    """Return what has grown beyond what it may."""
    # Memory, and pools of a few threads, are full after a while.
    late = ("memory_mb", "threads") if scale < SHORTEST_VERDICT else ("memory_mb",)
    wrong = [name for name, row in found.items() if name not in late and row["end"] > row["most_before"]]
    if scale >= SHORTEST_VERDICT and found["memory_mb"]["growth"] > MOST_GROWTH:
        wrong.append("memory_mb")
    return wrong


def run_program(name: str, scale: float, *, offscreen: bool = False) -> list[Sample]:
    """Run one program's session in a process of its own, and return its samples; ``offscreen``: without OpenGL."""
    with ExitStack() as stack:
        folder = stack.enter_context(tempfile.TemporaryDirectory())
        own = {"BRDF_SUITE_SETTINGS": folder, "BRDF_SUITE_LINK": f"long-{os.getpid()}-{name}"}
        if offscreen:
            own["QT_QPA_PLATFORM"] = "offscreen"
        else:
            sys.path.insert(0, str(ROOT / "packaging" / "screenshots"))
            from screenshots import virtual_screen  # type: ignore[import-not-found]  # a script, by its folder

            own |= {"DISPLAY": stack.enter_context(virtual_screen()), "QT_QPA_PLATFORM": "xcb"}
        command = [sys.executable, str(Path(__file__).resolve()), "--inside", name, "--scale", str(scale)]
        done = subprocess.run(
            command, env={**os.environ, **own}, stdout=subprocess.PIPE, text=True, check=True
        )
    return list(json.loads(done.stdout.splitlines()[-1]))


def main() -> int:
    """Run the sessions asked for; 1 where something grows."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--scale", type=float, default=1.0, help="the share of a day (1)")
    parser.add_argument("--program", choices=PROGRAMS, action="append", help="this program alone")
    parser.add_argument("--offscreen", action="store_true", help="without a screen, and so without OpenGL")
    parser.add_argument("--json", action="store_true", help="print the samples too, as JSON")
    parser.add_argument("--inside", choices=PROGRAMS, help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.inside:
        with tempfile.TemporaryDirectory() as folder:
            samples = PROGRAMS[options.inside](options.scale, Path(folder))
        sys.stdout.write(json.dumps(samples) + "\n")
        return 0
    wrong = False
    for name in options.program or PROGRAMS:
        samples = run_program(name, options.scale, offscreen=options.offscreen)
        found = verdict(samples)
        bad = faults(found, options.scale)
        wrong |= bool(bad)
        if options.json:
            print(json.dumps({"program": name, "found": found, "faults": bad, "samples": samples}))
            continue
        print(f"{name}: {'grows: ' + ', '.join(bad) if bad else 'nothing grows'}")
        for key, row in found.items():
            print(f"  {key:12} {row['middle']:10.1f} {row['end']:10.1f}  {100.0 * row['growth']:+.1f} %")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
