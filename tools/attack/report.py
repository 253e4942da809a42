"""The table of a run: text for a terminal, and Markdown between the markers of a document."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from tools.attack.bounds import (
    HANG_S,
    LEAST_INPUTS,
    LEAST_KILLS,
    LEAST_LINES,
    LEAST_OF_A_READER,
    MOST_GROWTH,
    OLDEST_S,
    SHORTEST_VERDICT,
    STALL_MS,
)

_BEGIN, _END = "<!-- attack: begin -->", "<!-- attack: end -->"
_LOOPS = {
    "readers": "damaged inputs of {} readers",
    "changing": "inputs of {} readers that change while they are read",
    "crossing": "spliced inputs, and other readers' files, of {} readers",
}

Figures = Mapping[str, Any]
Row = tuple[str, str, str, bool]


def rows(figures: Figures) -> list[Row]:
    """Return the rows: figure, value, bound, and whether the value is within it.

    Bounds from below count for a long run alone, whose figures have a true ``whole``.
    """
    found: list[Row] = []
    whole = bool(figures.get("whole"))
    for part, title in _LOOPS.items():
        readers = figures.get(part, {})
        if not readers:
            continue
        total = sum(one["inputs"] for one in readers.values())
        least = min(one["inputs"] for one in readers.values())
        faults = sum(sum(one["faults"].values()) for one in readers.values())
        slowest = max(one["longest_s"] for one in readers.values())
        died = sum(one["died"] for one in readers.values())
        found += [
            _count(title.format(len(readers)), total, LEAST_INPUTS if part == "readers" and whole else 0),
            _count(
                "the same: of each reader, at least",
                least,
                LEAST_OF_A_READER if part == "readers" and whole else 0,
            ),
            ("crashes, uncaught exceptions, hangs, over the memory bound", f"{faults:,}", "0", faults == 0),
            ("slowest input, s of processor time", f"{slowest:.2f}", f"≤ {HANG_S:g}", slowest <= HANG_S),
            ("deaths of libraries that have a process of their own", f"{died:,}", "", True),
        ]
    kills = figures.get("kills", {})
    if kills:
        total_of = {
            name: sum(one[name] for one in kills.values())
            for name in next(iter(kills.values()))
            if name != "examples"
        }
        found += [
            _count(f"kills of {len(kills)} writers", total_of["kills"], LEAST_KILLS if whole else 0),
            ("kills in the middle of a write", f"{total_of['in_a_write']:,}", "", True),
            *(
                (title, f"{total_of[name]:,}", "0", total_of[name] == 0)
                for title, name in (
                    ("damaged documents", "damaged"),
                    ("lost documents", "lost"),
                    ("leftovers after the next start", "leftovers"),
                    (f"faults on {total_of['full_disks']} full disks", "full_disk_faults"),
                )
            ),
        ]
    power = figures.get("power", {})
    if power:
        losses = sum(one["losses"] for one in power.values())
        bad = sum(len(one["faults"]) for one in power.values())
        found += [
            (f"simulated power losses of {len(power)} writers", f"{losses:,}", "", True),
            ("documents damaged or lost by them", f"{bad:,}", "0", bad == 0),
        ]
    for name, title in (("lines", "wrong command lines"), ("signals", "signals and closed pipes")):
        if name in figures:
            count, faults = figures[name]["lines"], len(figures[name]["faults"])
            found += [
                (title, f"{count:,}", "", True),
                (f"{title}: tracebacks", f"{faults}", "0", faults == 0),
            ]
    if whole and "lines" in figures and "signals" in figures:
        lines = sum(figures[name]["lines"] for name in ("lines", "signals"))
        found.append(_count("wrong command lines, signals and closed pipes together", lines, LEAST_LINES))
    if "surroundings" in figures:
        one = figures["surroundings"]
        bad = len(one["faults"])
        found += [
            ("processes in hostile surroundings", f"{one['processes']}", "", True),
            ("executions of planted files", f"{one['executions']}", "0", one["executions"] == 0),
            ("local files shown", f"{one['local_files_shown']}", "0", one["local_files_shown"] == 0),
            ("other faults in hostile surroundings", f"{bad}", "0", bad == 0),
        ]
    if figures.get("monkey"):
        found += _monkey_rows(figures["monkey"])
    if "link" in figures:
        one = figures["link"]
        oldest, stall = max(one["oldest_s"], one["last_s"]), one["stall_ms"]
        found += [
            (
                "flood on the link: oldest value at its delivery, s",
                f"{oldest:.2f}",
                f"≤ {OLDEST_S:g}",
                oldest <= OLDEST_S,
            ),
            (
                "the same: first value of a newcomer, s",
                f"{one['newcomer_s']:.2f}",
                f"≤ {OLDEST_S:g}",
                one["newcomer_s"] <= OLDEST_S,
            ),
            (
                "the same: longest stall of the event loop, ms",
                f"{stall:.0f}",
                f"≤ {STALL_MS:g}",
                stall <= STALL_MS,
            ),
        ]
    if "session" in figures:
        one = figures["session"]
        growth = max(row["found"]["memory_mb"]["growth"] for row in one["programs"].values())
        grown = sum(name != "memory_mb" for row in one["programs"].values() for name in row["faults"])
        title = f"simulated day of {len(one['programs'])} programs, {100.0 * one['scale']:.0f} %"
        # Before, histories still fill.
        shown = f"≤ {100.0 * MOST_GROWTH:.0f} %" if one["scale"] >= SHORTEST_VERDICT else ""
        found += [
            (
                f"{title}: growth of memory",
                f"{100.0 * growth:+.1f} %",
                shown,
                not shown or growth <= MOST_GROWTH,
            ),
            ("the same: growing counts of threads, files, timers, objects", f"{grown}", "0", grown == 0),
        ]
    return found


def _count(title: str, value: int, least: int) -> Row:
    """Return the row of a count, with a bound from below where ``least`` is not 0."""
    return (title, f"{value:,}", f"≥ {least:,}" if least else "", value >= least)


def _monkey_rows(programs: Mapping[str, Any]) -> list[Row]:
    """Return the rows of random events, by program what came of them."""
    every = list(programs.values())
    counts = {name: sum(len(one[name]) for one in every) for name in ("tracebacks", "deaths", "hangs")}
    slowest = max(one["longest_s"] for one in every)
    return [
        (f"random events in {len(every)} programs", f"{sum(one['events'] for one in every):,}", "", True),
        *((f"random events: {name}", f"{count}", "0", count == 0) for name, count in counts.items()),
        (
            "random events: longest turn, s of processor time",
            f"{slowest:.2f}",
            f"≤ {HANG_S:g}",
            slowest <= HANG_S,
        ),
    ]


def passed(figures: Figures) -> bool:
    """Return whether all figures are within their bounds."""
    return all(good for *_, good in rows(figures))


def reader_rows(figures: Figures) -> list[tuple[str, ...]]:
    """Return a row for each reader: inputs, read, refused, faults, milliseconds, slowest, megabytes."""
    return [
        (
            name,
            f"{one['inputs']:,}",
            f"{one['read']:,}",
            f"{one['refused']:,}",
            f"{one['died']:,}",
            f"{sum(one['faults'].values()):,}",
            f"{1000.0 * one['cpu_s'] / max(one['inputs'], 1):.2f}",
            f"{one['longest_s']:.2f}",
            f"{one['largest_mb']:.0f}",
        )
        for name, one in figures.get("readers", {}).items()
    ]


_HEAD = ("reader", "inputs", "read", "refused", "died", "faults", "ms", "slowest, s", "MB")


def text(figures: Figures) -> str:
    """Return the tables as aligned text, with the faults in words."""
    lines = [
        f"{'' if good else '! '}{title:<62} {value:>12}  {bound}"
        for title, value, bound, good in rows(figures)
    ]
    lines += (
        ["", f"{_HEAD[0]:<28}" + "".join(f"{name:>11}" for name in _HEAD[1:])]
        if figures.get("readers")
        else []
    )
    lines += [f"{row[0]:<28}" + "".join(f"{cell:>11}" for cell in row[1:]) for row in reader_rows(figures)]
    for part in _LOOPS:
        for name, one in figures.get(part, {}).items():
            lines += [f"{part} {name}: {count} × {fault}" for fault, count in one["faults"].items()]
    for one in figures.get("kills", {}).values():
        lines += one["examples"]
    for name, one in figures.get("power", {}).items():
        lines += [f"{name}: {fault}" for fault in one["faults"]]
    for name, one in figures.get("monkey", {}).items():
        for kind in ("tracebacks", "deaths", "hangs"):
            lines += [f"{place}: {fault}" for place, fault in one[kind].items()]
        lines += [f"{name}: {count} × {message}" for message, count in one["messages"].items()]
    for name in ("lines", "signals", "surroundings"):
        lines += [f"{place}: {fault}" for place, fault in figures.get(name, {}).get("faults", {}).items()]
    return "\n".join(lines)


def markdown(figures: Figures) -> str:
    """Return the tables for a document."""
    lines = ["| figure | value | bound |", "|---|---|---|"]
    lines += [f"| {title} | {value} | {bound} |" for title, value, bound, _ in rows(figures)]
    if figures.get("readers"):
        lines += ["", "| " + " | ".join(_HEAD) + " |", "|---|" + "--:|" * (len(_HEAD) - 1)]
        lines += ["| " + " | ".join(row) + " |" for row in reader_rows(figures)]
    return "\n".join(lines)


def write(document: Path, figures: Figures) -> None:
    """Write the tables between the markers of a document; :class:`ValueError` where it has none."""
    old = document.read_text(encoding="utf-8")
    pattern = re.compile(f"{re.escape(_BEGIN)}.*?{re.escape(_END)}", re.DOTALL)
    if pattern.search(old) is None:
        raise ValueError(f"{document} has no markers {_BEGIN} and {_END}")
    made = f"{_BEGIN}\n\n{markdown(figures)}\n\n{_END}"
    document.write_text(pattern.sub(lambda _: made, old), encoding="utf-8")
