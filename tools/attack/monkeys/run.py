"""A monkey at the four programs: random mouse, wheel, key, menu, clipboard and drop events, repeatable by their number.

Run ``python tools/attack/run.py --parts monkey``, or this module to repeat and shorten what it found::

    python -m tools.attack.monkeys.run [--program viewer] [--seed 7] [--events 300] [--screen] [--keep FOLDER] [--json]

Without ``--screen`` the programs run on Qt's offscreen platform, where there is no OpenGL; with it on a virtual screen.
Faults are tracebacks, deaths of the process, and turns of the event loop over 5 s of processor time; messages of Qt and
warnings of libraries are counted as well. Status 1 where a fault was found. A fault is named by program, seed and the
last events; ``--keep`` stores all of them.
"""

from __future__ import annotations

import argparse
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import asdict, dataclass, field
from pathlib import Path

from tools.attack.bounds import HANG_S
from tools.attack.command_lines import home
from tools.attack.hostile.file_names import odd_names
from tools.attack.hostile.scene import Scene, Surroundings
from tools.attack.readers import chosen
from tools.attack.seeds import seeds_of

ROOT = Path(__file__).resolve().parents[3]
PROGRAMS = ("designer", "viewer", "lobes", "swatch")
_STARTS = 20
"""So often a program is started again after it was closed in order."""
_LAST = 6
"""Events that a fault is reported with."""
_PER_EVENT_S = 10.0
_SEEDS = (
    "palette:gpl", "palette:ase", "palette:csv", "measured:bird", "measured:cornell", "measured:merl", "mesh:obj",
    "mesh:glb", "mesh:ply", "environment:hdr", "environment:exr", "document:",
)  # fmt: skip
_ENDINGS = (
    ".brdfpaint",
    ".brdfpalette",
    ".brdfview",
    ".brdfproject",
    ".brdfstudio",
    ".png",
    ".exr",
    ".glb",
    ".csv",
    "",
)


@dataclass
class Monkeys:
    """What came of the events at one program."""

    events: int = 0
    starts: int = 0
    tracebacks: dict[str, str] = field(default_factory=dict)
    deaths: dict[str, str] = field(default_factory=dict)
    hangs: dict[str, str] = field(default_factory=dict)
    messages: dict[str, int] = field(default_factory=dict)
    longest_s: float = 0.0
    memory_mb: float = 0.0
    growth_mb: float = 0.0

    @property
    def faults(self) -> int:
        """How many there were."""
        return len(self.tracebacks) + len(self.deaths) + len(self.hangs)


def furnish(folder: Path) -> None:
    """Write the files that are opened and dropped: good ones, damaged ones, and what is no file."""
    scene = Scene("monkey", folder, Surroundings())
    scene.documents("plain")
    files = scene.work / "files"
    (scene.work / "saved").mkdir()
    files.mkdir()
    for name in ("p.brdfpaint", "p.brdfpalette", "p.gpl"):
        shutil.copy(scene.work / name, files / name)
    for seed in seeds_of(chosen(list(_SEEDS)), folder / "seeds"):
        (files / seed.name).write_bytes(seed.content)
        seed.restore(files)
    content = (files / "p.brdfpaint").read_bytes()
    for name in odd_names(".brdfpaint")[::3]:
        (files / name).write_bytes(content)
    for number, ending in enumerate(_ENDINGS):
        (files / f"noise{ending}").write_bytes(bytes((31 * n * n + number) % 256 for n in range(3000)))
        (files / f"empty{ending}").touch()
    (files / "half.brdfpaint").write_bytes(content[: len(content) // 2])
    (files / "folder.brdfpaint").mkdir()
    (files / "loop.brdfpaint").symlink_to("loop.brdfpaint")
    (files / "nothing.brdfpalette").symlink_to("missing")
    (files / "zero.png").symlink_to("/dev/zero")
    os.mkfifo(files / "pipe.brdfpaint")


def run_program(
    name: str,
    seed: int,
    events: int,
    report: Callable[[str], None],
    *,
    display: str | None = None,
    keep: Path | None = None,
) -> Monkeys:
    """Send random events to a program; ``display`` is that of an X server, None: offscreen."""
    found = Monkeys()
    while found.events < events and found.starts < _STARTS:
        with tempfile.TemporaryDirectory(prefix="attack-", ignore_cleanup_errors=True) as scratch:
            folder = Path(scratch)
            furnish(folder)
            place = f"{name}, seed {seed}.{found.starts}"
            count = len(found.tracebacks) + len(found.deaths) + len(found.hangs)
            _run_once(found, name, f"{seed}.{found.starts}", place, events - found.events, folder, display)
            if keep is not None:
                keep.mkdir(parents=True, exist_ok=True)
                for part in ("trace", "stderr"):
                    shutil.copy(folder / "work" / part, keep / f"{place}.{part}")
            for text in _faults(found)[count:]:
                report(text[:3000])
    return found


def _faults(found: Monkeys) -> list[str]:
    every = (found.tracebacks, found.deaths, found.hangs)
    return [f"{place}: {text}" for some in every for place, text in some.items()]


def _run_once(
    found: Monkeys, name: str, seed: str, place: str, events: int, folder: Path, display: str | None
) -> None:
    """Start the program once, and add what came of it."""
    work = folder / "work"
    path = os.pathsep.join(filter(None, (str(ROOT), os.environ.get("PYTHONPATH"))))
    environment = {**home(folder), "PYTHONPATH": path, "PYTHONUNBUFFERED": "1", "PYTHONHASHSEED": "0"}
    if display is not None:
        environment |= {"QT_QPA_PLATFORM": "xcb", "DISPLAY": display}
    command = [sys.executable, "-P", "-m", "tools.attack.monkeys.events", name, seed, str(events), str(work)]
    found.starts += 1
    with (work / "stderr").open("wb") as errors:
        process = subprocess.Popen(
            command, cwd=work, env=environment, stdin=subprocess.DEVNULL, stdout=errors, stderr=errors
        )
        try:
            status = process.wait(300.0 + _PER_EVENT_S * events)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
            status = -signal.SIGALRM
    said = (work / "stderr").read_text(errors="replace")
    trace = (work / "trace").read_text().splitlines() if (work / "trace").exists() else []
    last = "; ".join(trace[-_LAST:])
    answer = work / "found.json"
    figures = json.loads(answer.read_text()) if answer.exists() else {}
    found.events += max(1, figures.get("events", len(trace)))
    found.longest_s = max(found.longest_s, figures.get("longest_s", 0.0))
    memory = figures.get("memory_mb") or [0.0]
    found.memory_mb = max(found.memory_mb, *memory)
    found.growth_mb = max(found.growth_mb, memory[-1] - memory[len(memory) // 4])
    for text, times in figures.get("messages", {}).items():
        found.messages[text] = found.messages.get(text, 0) + times
    for line in said.splitlines():
        if re.search(r"\w+Warning: ", line):
            found.messages[line[:200]] = found.messages.get(line[:200], 0) + 1
    for number, text in enumerate(_tracebacks(said)):
        found.tracebacks[f"{place}, traceback {number}"] = f"{text}\nafter {last}"
    if "Timeout (" in said or status == -signal.SIGALRM:
        found.hangs[place] = f"{said[-1500:]}\nafter {last}"
    elif status != 0:
        found.deaths[place] = f"status {status}: {said[-1500:]}\nafter {last}"
    for what, took in figures.get("slow", {}).items():
        if took > HANG_S:
            found.hangs[f"{place}, {what}"] = f"{took:.1f} s of processor time"


def _tracebacks(said: str) -> list[str]:
    """Return the different tracebacks in an output, each by its last lines."""
    parts = said.split("Traceback (most recent call last)")[1:]
    found: dict[str, str] = {}
    for part in parts:
        lines = part.splitlines()
        end = next(
            (n for n, line in enumerate(lines[1:], 1) if line and not line.startswith(" ")), len(lines) - 1
        )
        places = [line for line in lines[:end] if line.lstrip().startswith("File ")]
        found.setdefault(
            f"{places[-1:]} {lines[end][:120]}", "\n".join([*lines[max(0, end - 12) : end], lines[end][:300]])
        )
    return list(found.values())


@contextmanager
def _screen() -> Iterator[str]:
    sys.path.insert(0, str(ROOT / "packaging" / "screenshots"))
    from screenshots import virtual_screen  # type: ignore[import-not-found]  # a script, by its folder

    with virtual_screen() as display:
        yield display


def main() -> int:
    """Run the programs that the options name; 1 where a fault was found."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--program", choices=PROGRAMS, action="append", help="this program alone")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--events", type=int, default=300, help="of each program (300)")
    parser.add_argument("--screen", action="store_true", help="on a virtual screen, with OpenGL")
    parser.add_argument("--keep", type=Path, metavar="FOLDER", help="store events and standard error here")
    parser.add_argument("--json", action="store_true", help="print the figures as JSON")
    options = parser.parse_args()
    wrong = 0
    for name in options.program or PROGRAMS:
        say = lambda text: print(text, file=sys.stderr, flush=True)  # noqa: E731
        if options.screen:
            with _screen() as display:
                found = run_program(
                    name, options.seed, options.events, say, display=display, keep=options.keep
                )
        else:
            found = run_program(name, options.seed, options.events, say, keep=options.keep)
        wrong += found.faults
        if options.json:
            print(json.dumps({"program": name, **asdict(found)}), flush=True)
            continue
        print(
            f"{name}: {found.events} events, {found.starts} starts, {found.faults} faults, longest turn "
            f"{found.longest_s:.2f} s, {found.memory_mb:.0f} MB, growth {found.growth_mb:.0f} MB"
        )
        for text, times in sorted(found.messages.items()):
            print(f"  {times} × {text}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
