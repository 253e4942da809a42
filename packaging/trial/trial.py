"""Do the twelve tasks of docs/development/usability.md with mouse and keyboard, and count what they take.

Run ``.venv/bin/python packaging/trial/trial.py [TASK …]``. The windows are real ones, on an X server without a screen,
with fresh settings for each task. Written are packaging/trial/counts.json and the table of the page; ``--into`` writes
the counts elsewhere and leaves the page. A task whose goal is not reached counts as such, with what it has taken.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tempfile
import time
import traceback
from collections.abc import Iterator
from pathlib import Path
from threading import Thread
from typing import Any

_HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(_HERE.parent / "screenshots"))

COUNTS = _HERE / "counts.json"
PAGE = _HERE.parents[1] / "docs" / "development" / "usability.md"
START, END = "<!--trial-->", "<!--/trial-->"
SIZE = (1280, 720)
BOUND = 0.6
_PATIENCE_S = 3000


def drive(options: argparse.Namespace) -> int:
    """Do one part of a task in its program; print the counts."""
    from brdf_qt.program.application import create_application
    from hand import Hand
    from states import open_program
    from tasks import TASKS

    key, number = options.drive.split(":")
    part = next(task for task in TASKS if task.key == key).parts[int(number)]
    app = create_application(part.program)
    program = open_program(part.program, empty=True)
    for file in part.files:
        program.open(str(options.folder / file))
    program.window.resize(*SIZE)
    program.start_when_painted()
    program.window.show()
    program.window.activateWindow()
    if part.at_start_page:
        program.window.start.show()
    hand = Hand()
    found: dict[str, Any] = {"problem": ""}

    def work() -> None:
        begun = time.monotonic()
        try:
            hand.wait(lambda: program.is_idle, _PATIENCE_S / 2)
            begun = time.monotonic()
            part.do(hand, program, options.folder)
        except Exception as error:  # noqa: BLE001 - a task that cannot be done is a result
            found["problem"] = f"{type(error).__name__}: {error}"
            traceback.print_exc()
        found["seconds"] = round(time.monotonic() - begun, 1)
        found.update(vars(hand.count), steps=hand.log)
        print(json.dumps(found, ensure_ascii=False), flush=True)
        os._exit(0)

    Thread(target=work, daemon=True).start()
    return app.exec()


def do(task: Any, environment: dict[str, str]) -> dict[str, Any]:
    """Do a task in programs of its own; return what it took, and whether its goal was reached."""
    total: dict[str, Any] = {"clicks": 0, "keys": 0, "scrolls": 0, "seconds": 0.0, "steps": [], "problem": ""}
    with tempfile.TemporaryDirectory() as scratch:
        folder = Path(scratch) / "files"
        folder.mkdir()
        task.prepare(folder)
        own = environment | {
            "BRDF_SUITE_SETTINGS": f"{scratch}/settings",
            "BRDF_SUITE_LINK": f"trial-{os.getpid()}-{task.key}",
        }
        for number in range(len(task.parts)):
            command = [sys.executable, __file__, "--drive", f"{task.key}:{number}", "--folder", str(folder)]
            begun = time.monotonic()
            done = subprocess.run(
                command, env=own, stdout=subprocess.PIPE, text=True, timeout=_PATIENCE_S, check=False
            )
            lines = [line for line in done.stdout.splitlines() if line.startswith("{")]
            if lines:
                answer = json.loads(lines[-1])
            else:  # it was killed, as task "recover" has it
                counts = (
                    (folder / "count").read_text("utf-8").split() if (folder / "count").exists() else "000"
                )
                answer = dict(zip(("clicks", "keys", "scrolls"), map(int, counts), strict=True))
                answer |= {"seconds": round(time.monotonic() - begun, 1), "steps": ["killed"], "problem": ""}
            for key, value in answer.items():
                total[key] += value
        try:
            total["done"] = not total["problem"] and bool(task.done(folder))
            if not total["done"]:
                written = ", ".join(sorted(one.name for one in folder.iterdir()))
                total["problem"] = total["problem"] or f"the goal is not in what was written: {written}"
        except Exception as error:  # noqa: BLE001 - no file, no goal
            total["done"] = False
            total["problem"] = total["problem"] or f"{type(error).__name__}: {error}"
    total["seconds"] = round(total["seconds"], 1)
    return total


def table(counts: dict[str, Any], titles: dict[str, str]) -> str:
    """Return the table of the page: each task before and after, and the sums."""
    before, after = counts["before"]["tasks"], counts["after"]["tasks"]
    lines = [
        "| task | clicks before | clicks after | typed before | typed after | hesitations before | after | "
        "seconds before | after | done before | after |",
        "|---|---|---|---|---|---|---|---|---|---|---|",
    ]

    def cells(key: str) -> Iterator[str]:
        for name in ("clicks", "keys", "hesitations", "seconds"):
            for side in (before, after):
                yield str(side[key].get(name, "–")) if key in side else "–"
        for side in (before, after):
            yield ("yes" if side[key]["done"] else "no") if key in side else "–"

    for key, title in titles.items():
        lines.append(f"| {title} | {' | '.join(cells(key))} |")
    sums = [sum(side[key]["clicks"] for key in titles if key in side) for side in (before, after)]
    done = [sum(bool(side[key]["done"]) for key in titles if key in side) for side in (before, after)]
    share = f"{sums[1] / sums[0]:.0%}" if sums[0] else "–"
    lines.append("")
    lines.append(
        f"Together: {sums[0]} clicks before (commit {counts['before']['commit']}), {sums[1]} after: {share}; the bound "
        f"is {BOUND:.0%}. Done: {done[0]} of {len(titles)} before, {done[1]} of {len(titles)} after."
    )
    return "\n".join(lines)


def main() -> int:
    """Do the tasks named in the arguments, or all."""
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("tasks", nargs="*", metavar="TASK")
    parser.add_argument("--into", type=Path, help="file for the counts alone")
    parser.add_argument("--drive", help=argparse.SUPPRESS)
    parser.add_argument("--folder", type=Path, help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.drive:
        return drive(options)
    from screenshots import virtual_screen
    from tasks import TASKS

    unknown = set(options.tasks) - {task.key for task in TASKS}
    if unknown:
        raise SystemExit(f"There is no task {', '.join(sorted(unknown))}.")
    found: dict[str, Any] = {}
    titles = {task.key: task.title for task in TASKS}
    with virtual_screen() as display, tempfile.TemporaryDirectory() as cache:
        environment = {
            **os.environ,
            "DISPLAY": display,
            "QT_QPA_PLATFORM": "xcb",
            "LIBGL_ALWAYS_SOFTWARE": "1",
            "LC_ALL": "C.UTF-8",
            "BRDF_SUITE_CACHE": os.environ.get("BRDF_SUITE_CACHE", cache),
        }
        for task in TASKS:
            if not options.tasks or task.key in options.tasks:
                found[task.key] = one = do(task, environment)
                print(f"{task.key}: {one['clicks']} clicks, {one['keys']} keys, {one['seconds']} s, ", end="")
                print("done" if one["done"] else f"not done: {one['problem']}", flush=True)
                keep(found, titles, options.into)  # what has been counted stays where a later task hangs
    return 0


def keep(found: dict[str, Any], titles: dict[str, str], into: Path | None) -> None:
    """Write counts to a file of their own, or into the counts of this version and the table of the page."""
    if into is not None:
        into.write_text(json.dumps(found, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
        return
    counts = json.loads(COUNTS.read_text(encoding="utf-8"))
    for key, one in found.items():
        known = counts["after"]["tasks"].get(key, {})
        counts["after"]["tasks"][key] = one | {"hesitations": known.get("hesitations", 0)}
    COUNTS.write_text(json.dumps(counts, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
    page = PAGE.read_text(encoding="utf-8")
    head, _, rest = page.partition(START)
    PAGE.write_text(
        f"{head}{START}\n{table(counts, titles)}\n{END}{rest.partition(END)[2]}", encoding="utf-8"
    )


if __name__ == "__main__":
    sys.exit(main())
