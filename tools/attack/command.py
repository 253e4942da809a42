"""The standing attack on the suite: damaged, changing and crossed files, kills, power losses, wrong command lines,
hostile surroundings, random events in the programs, a flood on the live link, a long day; one table.

    python tools/attack/run.py [--minutes 2] [--json]                  a slice of everything
    python tools/attack/run.py --inputs 20000 --results long.json      the long run; the same line goes on with it
    python tools/attack/run.py --parts readers --only mesh:glb --keep FOLDER     one reader, faulty files kept
    python tools/attack/run.py --replay FOLDER                         files that were kept, once more
    python tools/attack/run.py --check                                 every reader and every writer is reached
    python tools/attack/run.py --table long.json                       write the table of a run into the documents

Progress and faults go to standard error as they are met. Status 1 where a figure is over its bound.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
import tempfile
import time
from dataclasses import asdict
from pathlib import Path
from typing import Any

from brdf_suite.documents.atomic import encode, write_atomically
from tools.attack import report as tables
from tools.attack.changing import SeedChangedAtCall, SeedChangedBeside
from tools.attack.command_lines import signals, wrong
from tools.attack.hostile.cases import run_cases
from tools.attack.kills import kill_writers
from tools.attack.loop import Loop
from tools.attack.monkeys import run as monkeys
from tools.attack.power import lose_power_in_writers
from tools.attack.readers import READERS, chosen
from tools.attack.readers.coverage import missing
from tools.attack.replay import replay
from tools.attack.seeds import Seed, contents_of, crossing_seeds, seeds_of
from tools.attack.writing.coverage import missing as missing_writers

ROOT = Path(__file__).resolve().parents[2]
PARTS = (
    "readers",
    "changing",
    "crossing",
    "kills",
    "power",
    "lines",
    "surroundings",
    "monkey",
    "link",
    "session",
)
_SHARES = {"readers": 1.0, "changing": 0.05, "crossing": 0.05}
"""Of the inputs and of the time: what each loop over the readers gets."""
DOCUMENT = ROOT / "docs" / "development" / "reliability.md"


def say(text: str) -> None:
    """Report progress."""
    print(f"{time.strftime('%H:%M:%S')} {text}", file=sys.stderr, flush=True)


def parse(arguments: list[str] | None = None) -> argparse.Namespace:
    """Return the options."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument(
        "--minutes", type=float, help="time for all parts together (default: 2 without --inputs)"
    )
    parser.add_argument("--inputs", type=int, help="damaged files of each reader")
    parser.add_argument("--kills", type=int, default=1000, help="kills in all (fewer in a slice)")
    parser.add_argument(
        "--events", type=int, default=1000, help="random events of each program (fewer in a slice)"
    )
    parser.add_argument("--lines", type=int, default=300, help="command lines in all (fewer in a slice)")
    parser.add_argument(
        "--scale", type=float, help="share of the simulated day (default: 1, and 0.01 in a slice)"
    )
    parser.add_argument("--parts", nargs="+", choices=PARTS, default=PARTS)
    parser.add_argument(
        "--only", nargs="*", default=[], metavar="NAME", help="beginnings of names of readers, writers, cases"
    )
    parser.add_argument("--jobs", type=int, default=1, help="readers at once")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument(
        "--results", type=Path, help="a file of figures that is written all the time, and continued"
    )
    parser.add_argument("--keep", type=Path, help="a folder for files that made a fault")
    parser.add_argument("--json", action="store_true", help="print the figures as JSON")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--replay", type=Path, metavar="FOLDER")
    parser.add_argument("--table", type=Path, metavar="RESULTS")
    return parser.parse_args(arguments)


def script(name: str, *words: str) -> list[dict[str, Any]]:
    """Run another program of this folder, and return the JSON that it prints line by line."""
    done = subprocess.run(
        [sys.executable, str(Path(__file__).with_name(name)), "--json", *words],
        stdout=subprocess.PIPE,
        text=True,
        check=False,  # its status says that a figure is over its bound, as the table does
    )
    return [json.loads(line) for line in done.stdout.splitlines() if line.startswith("{")]


def session(scale: float) -> dict[str, Any]:
    """Run the simulated day; edits without OpenGL, whose frames would take hours, and a twentieth of them with it."""
    windows = ("--offscreen", "--program", "designer", "--program", "swatch")
    found = {one["program"]: one for one in script("long_session.py", "--scale", f"{scale:g}", *windows)}
    for program, share in (("viewer", 1.0), ("designer", 0.05)):
        (one,) = script("long_session.py", "--scale", f"{share * scale:g}", "--program", program)
        found[f"{program} with OpenGL"] = one
    return {name: {key: one[key] for key in ("found", "faults")} for name, one in found.items()}


def _seeds(part: str, only: list[str], folder: Path) -> list[Seed]:
    """Return what the loop of a part reads: damaged files, files that change, or files that are crossed."""
    readers = chosen(only)
    if part == "crossing":
        return list(crossing_seeds(readers, folder, contents_of(READERS, folder / "others")))
    if part == "changing":
        at_call = seeds_of(readers, folder, SeedChangedAtCall)
        return [*at_call, *seeds_of(readers, folder / "again", SeedChangedBeside)]
    return list(seeds_of(readers, folder))


def run(options: argparse.Namespace) -> dict[str, object]:
    """Run the parts and return their figures; those of an earlier run in ``--results`` are kept."""
    whole = options.minutes is None and options.inputs is not None
    minutes: float = options.minutes or (float("inf") if whole else 2.0)
    figures: dict[str, object] = {}
    store = options.results
    if store is not None and store.exists():
        figures = json.loads(store.read_text())
    figures["seed"] = options.seed
    if whole and not options.only:
        figures["whole"] = True

    def keep() -> None:
        if store is not None:
            write_atomically(store, encode(figures))

    share = min(1.0, minutes / 30.0)
    brief = minutes < 10.0
    long_enough = not brief or len(options.parts) == 1
    with tempfile.TemporaryDirectory(prefix="attack-", ignore_cleanup_errors=True) as scratch:
        folder = Path(scratch)
        folder.chmod(0o755)
        if "kills" in options.parts:
            say("kills")
            kills = max(60, round(options.kills * share))
            found = kill_writers(kills, options.seed, options.only, say, in_slices=brief)
            figures["kills"] = {name: asdict(one) for name, one in found.items()}
            keep()
        if "power" in options.parts:
            say("power losses")
            figures["power"] = {
                name: asdict(one)
                for name, one in lose_power_in_writers(options.only, say, in_slices=brief).items()
            }
            keep()
        if "lines" in options.parts:
            say("command lines")
            count = max(10, round(options.lines * share))
            figures["lines"] = asdict(wrong(count - count // 5, options.seed, say))
            figures["signals"] = asdict(signals(count // 5, options.seed, say))
            keep()
        if "surroundings" in options.parts:
            say("surroundings")
            (folder / "cases").mkdir()
            figures["surroundings"] = asdict(
                run_cases(folder / "cases", options.only, say, brief=not (long_enough or options.only))
            )
            keep()
        if "monkey" in options.parts and long_enough:
            say("monkey")
            count = round(options.events * share)
            figures["monkey"] = {
                name: asdict(monkeys.run_program(name, options.seed, count, say, keep=options.keep))
                for name in monkeys.PROGRAMS
            }
            keep()
        if "link" in options.parts:
            say("link")
            (figures["link"],) = script("link_flood.py", "--seconds", "6" if long_enough else "1")
            keep()
        if "session" in options.parts and long_enough:
            scale = options.scale or (1.0 if whole else 0.01)
            say(f"session of scale {scale:g}")
            figures["session"] = {"scale": scale, "programs": session(scale)}
            keep()
        for part in [name for name in _SHARES if name in options.parts]:
            say(part)
            progress = None if store is None else store.with_suffix(f".{part}.json")
            if progress is not None and part in figures and not progress.exists():
                write_atomically(progress, encode({"run": options.seed, "readers": figures[part]}))
            loop = Loop(
                _seeds(part, options.only, folder / part),
                options.seed,
                round(_SHARES[part] * (options.inputs or 1 << 40)),
                results=progress,
                keep=options.keep,
                report=say,
            )
            try:
                loop.run(options.jobs, 60.0 * minutes * max(_SHARES[part], 0.25))
            finally:
                figures[part] = {name: asdict(tally) for name, tally in sorted(loop.tallies.items())}
                keep()
                if progress is not None:
                    progress.unlink(missing_ok=True)
    return figures


def main(arguments: list[str] | None = None) -> int:
    """Do what the options ask for."""
    options = parse(arguments)
    if options.check:
        faults = [*missing(say), *missing_writers(say)]
        print("\n".join(faults) or "Every reader has seeds, and reads them; every writer is reached.")
        return 1 if faults else 0
    if options.replay is not None:
        faults = replay(options.replay)
        print("\n".join(faults) or "No fault.")
        return 1 if faults else 0
    if options.table is not None:
        tables.write(DOCUMENT, json.loads(options.table.read_text()))
        return 0
    figures = run(options)
    print(json.dumps(figures, indent=1) if options.json else tables.text(figures))
    return 0 if tables.passed(figures) else 1


if __name__ == "__main__":
    sys.exit(main())
