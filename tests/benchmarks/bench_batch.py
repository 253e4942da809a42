"""Batches: two workers against one, the layer against a plain loop, and a million paints by simulation.

Workers are processes of one thread each, also of the software renderer; they are started, and have their scene open,
before the time is taken. Paints are the shipped ones with small steps in L*. Measures are of colour and gloss; texture
takes most of the time of a paint with flakes, which would hide what the layer adds. The simulation
(`docs/method/scale.md`) has the measured costs of this run.
"""

from __future__ import annotations

import csv
import json
import random
import tempfile
from collections.abc import Callable, Sequence
from contextlib import nullcontext
from dataclasses import replace
from pathlib import Path
from statistics import median
from time import perf_counter

from brdf_suite.batches.items import JOURNAL, BatchItem, list_paints
from brdf_suite.batches.journal import Finished, Journal
from brdf_suite.batches.results import write_results
from brdf_suite.batches.running import run_batch
from brdf_suite.batches.steps import BatchStep, Fit, Measure, Render
from brdf_suite.batches.worker import do_items
from brdf_suite.batches.workers import BatchWorkers, local_workers
from brdf_suite.cli.tools.bench import load_module
from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.documents.palette_store import save_palette
from brdf_suite.documents.store import save_paint
from brdf_suite.inspection.measuring import measured_row, read_material
from brdf_suite.pipeline.lobe_fit import fit_material
from brdf_suite.pipeline.material import Material, load_material, load_shipped_paint, paint_names
from brdf_suite.pipeline.scene import default_view
from brdf_suite.progress import Progress, report
from brdf_suite.release import __version__

NAME = "batch"
RENDERS, MEASURES, FILES, TASKS = 1000, 10_000, 1000, 100_000
SIZE = (320, 240)
MILLION = 1_000_000
COLOUR = Measure(texture=False)

#: key: (comparison, bound, unit, meaning)
BOUNDS: dict[str, tuple[str, float | None, str, str]] = {
    "render_speedup_2": (">=", 1.7, "", f"{RENDERS:,} renders of {SIZE[0]}×{SIZE[1]}: two workers over one"),
    "measure_speedup_2": (">=", 1.8, "", f"{MEASURES:,} measures of colour and gloss: two workers over one"),
    "overhead_share": (
        "<=",
        0.10,
        "",
        f"{FILES:,} files read, fitted, measured and written by one worker: time over that of a plain loop, minus 1",
    ),
    "render_item_ms": ("", None, "ms", "a render by one worker"),
    "measure_item_ms": ("", None, "ms", "a measure of colour and gloss by one worker"),
    "fit_item_ms": ("", None, "ms", "a fit by one worker"),
    "open_s": ("", None, "s", "start of a worker to its first measure"),
    "task_ms": ("", None, "ms", f"scheduler and client for one of {TASKS:,} empty tasks"),
    "journal_ms": ("", None, "ms", "appending a group to the journal, on the disk"),
    "row_us": ("", None, "µs", "a row in the journal and in the tables"),
    "million_100_hours": ("", None, "h", "simulated: a million paints measured and fitted by 100 workers"),
    "million_1000_hours": ("", None, "h", "the same by 1,000 workers"),
}
NOTES: dict[str, str] = {}
_APPENDIX: list[str] = []


def run(progress: Progress | None) -> dict[str, float | None]:
    """Measure all figures; the two arms of a ratio one after the other."""
    figures: dict[str, float | None] = {}
    with tempfile.TemporaryDirectory() as folder:
        place = Path(folder)
        paints = _paints(place, MEASURES)
        drawn = paints[:RENDERS]
        render = Render(replace(default_view("photo_studio"), surface="speed_form"), SIZE)
        times: dict[tuple[str, int], float] = {}
        start = perf_counter()
        with local_workers(1) as one:
            do(one, COLOUR, paints[-1:], place / "first")
            figures["open_s"] = perf_counter() - start
            report(progress, 0.05, "one worker: overhead")
            figures["overhead_share"], figures["fit_item_ms"] = _overhead(one, place)
            report(progress, 0.3, "one worker: measures and renders")
            times["measure", 1] = do(one, COLOUR, paints, place / "measure_1")
            do(one, render, paints[-2:], place / "warm_1")
            times["render", 1] = do(one, render, drawn, place / "render_1")
            report(progress, 0.6, "empty tasks")
            figures["task_ms"] = _empty_tasks(one, place)
        with local_workers(2) as two:
            do(two, COLOUR, paints[-8:], place / "first_2", group=1)
            report(progress, 0.7, "two workers: measures and renders")
            times["measure", 2] = do(two, COLOUR, paints, place / "measure_2")
            do(two, render, paints[-8:], place / "warm_2", group=1)
            times["render", 2] = do(two, render, drawn, place / "render_2")
        figures["render_speedup_2"] = times["render", 1] / times["render", 2]
        figures["measure_speedup_2"] = times["measure", 1] / times["measure", 2]
        figures["render_item_ms"] = 1e3 * times["render", 1] / RENDERS
        figures["measure_item_ms"] = 1e3 * times["measure", 1] / MEASURES
        report(progress, 0.95, "simulating")
        figures["journal_ms"], figures["row_us"], row_bytes = _client_costs(place / "measure_1", paints)
        item_bytes = sum(len(item.entry) for item in paints) / len(paints)
        figures |= _simulated(figures, row_bytes, item_bytes)
    return figures


def do(
    workers: BatchWorkers, step: BatchStep, items: Sequence[BatchItem], folder: Path, group: int | None = None
) -> float:
    """Run a batch on workers that are there; return its seconds."""
    start = perf_counter()
    done = run_batch(step, items, folder, lambda: nullcontext(workers), group=group)
    assert not done.problems
    return perf_counter() - start


def _paints(place: Path, count: int) -> list[BatchItem]:
    """Return paints in a random order, so that no worker gets the slow ones alone."""
    shipped = [load_shipped_paint(name) for name in paint_names()]
    entries = []
    for number in range(count):
        paint = shipped[number % len(shipped)]
        first = paint.measurements[-1]
        step = -0.2 * (number // len(shipped)) / max(1, count // len(shipped))
        entries.append(Entry(paint.with_lab(first.aspecular_deg, (first.lab[0] + step, *first.lab[1:]))))
    save_palette(Palette("batch", tuple(entries)), place / "batch.brdfpalette")
    items = list_paints([place / "batch.brdfpalette"])
    random.Random(0).shuffle(items)
    return items


def _overhead(one: BatchWorkers, place: Path) -> tuple[float, float]:
    """Return the share that the layer adds to a loop in the same process, and the time of a fit in ms."""
    folder = place / "files"
    folder.mkdir()
    shipped = [load_shipped_paint(name) for name in paint_names()]
    for number in range(FILES):
        paint = replace(shipped[number % len(shipped)], notes=str(number))
        save_paint(paint, folder / f"{number:04}.brdfpaint")
    files = sorted(map(str, folder.iterdir()))
    loops, layers, fits = [], [], []
    for turn in range(2):
        loops.append(one.executor.submit(_plain_loop, files, str(place / f"loop_{turn}.csv")).result())
        start = perf_counter()
        items = list_paints([folder])
        fits.append(do(one, Fit(), items, place / f"fit_{turn}"))
        do(one, COLOUR, items, place / f"measured_{turn}")
        layers.append(perf_counter() - start)
    NOTES["overhead_share"] = f"{median(layers):.1f} s against {median(loops):.1f} s, two turns by turns"
    return median(layers) / median(loops) - 1.0, 1e3 * median(fits) / FILES


def _weights(item: Material) -> dict[str, object]:
    found = fit_material(item).weights
    return {"kd": found.kd.tolist(), "kdd": found.kdd.tolist(), "kg": found.kg.tolist()}


def _plain_loop(files: Sequence[str], table: str) -> float:
    """Read, fit and measure every file and write what the batch writes, as one would by hand; return the seconds."""
    start = perf_counter()
    for columns in (
        _weights,
        lambda item: measured_row(item, read_material(item, texture=False)),
    ):
        with Path(table).open("w", encoding="utf-8", newline="") as file:
            writer = csv.writer(file)
            for name in files:
                row = columns(load_material(name))
                writer.writerow([name, *row.values()])
    return perf_counter() - start


def _empty_tasks(one: BatchWorkers, place: Path) -> float:
    """Return ms for a group without items, many of them in flight."""
    Journal(place, "none").append(())
    start = perf_counter()
    ahead = 200
    for _ in range(TASKS // ahead):
        sent = [one.executor.submit(do_items, COLOUR, "", [], str(place), __version__) for _ in range(ahead)]
        for future in sent:
            future.result()
    return 1e3 * (perf_counter() - start) / TASKS


def _client_costs(folder: Path, items: Sequence[BatchItem]) -> tuple[float, float, float]:
    """Return ms for appending a group, µs for a row (journal and tables), and the bytes of a row."""
    lines = (folder / JOURNAL).read_bytes().splitlines()
    rows = []
    for line in lines:
        value = json.loads(line)
        del value["step"]
        rows.append(Finished(**value | {"files": (), "notices": tuple(value["notices"])}))
    with tempfile.TemporaryDirectory() as other:
        journal = Journal(Path(other), "costs")
        waits = [_seconds(lambda: journal.append(())) for _ in range(100)]
        written = _seconds(lambda: journal.append(rows))
        found = {one.key: one for one in rows}
        tables = _seconds(lambda: write_results(Path(other), "measure", items, found, 1.0))
    row_bytes = sum(map(len, lines)) / len(lines)
    return 1e3 * median(waits), 1e6 * (written + tables) / len(rows), row_bytes


def _seconds(what: Callable[[], object]) -> float:
    start = perf_counter()
    what()
    return perf_counter() - start


def _simulated(figures: dict[str, float | None], row_bytes: float, item_bytes: float) -> dict[str, float]:
    parts = load_module(Path(__file__).parent / "parts" / "batch" / "simulation.py")
    named = {key: value for key, value in figures.items() if value is not None}
    mean = 1e-3 * (named["measure_item_ms"] + named["fit_item_ms"])
    costs = parts.Costs(
        # Two thirds to four thirds of the mean: the spread over the shipped paints.
        item_s=tuple(mean * share for share in (2 / 3, 1.0, 4 / 3)),
        open_s=named["open_s"],
        task_s=1e-3 * named["task_ms"],
        append_s=1e-3 * named["journal_ms"],
        row_s=2e-6 * named["row_us"],
        item_bytes=2 * item_bytes,
        row_bytes=2 * row_bytes,
    )
    usual = max(1, min(1024, round(2.0 / mean)))
    lines = [
        "### A million paints measured and fitted, simulated",
        "",
        "| workers | items in a group | hours | workers busy | client busy | MB/s | first limit |",
        "|---|---|---|---|---|---|---|",
    ]
    hours: dict[int, float] = {}
    for workers in (1, 10, 100, 1000):
        for group in sorted({1, 10, usual, 1024}):
            found = parts.simulate(costs, MILLION, workers, group)
            if group == usual:
                hours[workers] = found.hours
            lines.append(
                f"| {workers:,} | {group:,} | {found.hours:.2f} | {found.workers_busy:.0%} | {found.client_busy:.0%} | "
                f"{found.megabytes_per_s:.2f} | {found.bottleneck} |"
            )
    _APPENDIX[:] = [*lines, "", f"Groups of {usual} are what a batch chooses by itself: about 2 s of work."]
    NOTES["million_100_hours"] = json.dumps(
        {key: value for key, value in costs._asdict().items() if key != "item_s"}
    )
    return {"million_100_hours": hours[100], "million_1000_hours": hours[1000]}


def appendix() -> str:
    """Return the table of the simulation."""
    return "\n".join(_APPENDIX) + "\n"
