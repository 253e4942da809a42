"""Batches in this process: items, the journal, results; a thread does the work."""

from __future__ import annotations

import csv
import json
import os
import re
import sys
import threading
from collections.abc import Callable, Iterator
from concurrent.futures import Executor, Future, ThreadPoolExecutor
from contextlib import AbstractContextManager, contextmanager, nullcontext
from dataclasses import dataclass, replace
from pathlib import Path
from time import monotonic, sleep
from typing import Any, ClassVar

import numpy as np
import pyarrow.parquet
import pytest
from hypothesis import given
from hypothesis import strategies as st
from PIL import Image

import brdf_suite as bs
from brdf_suite.batches import running, worker
from brdf_suite.batches.items import JOURNAL, BatchItem, list_lights, list_paints, sources_in
from brdf_suite.batches.journal import Finished, Journal
from brdf_suite.batches.running import run_batch
from brdf_suite.batches.steps import Export, Factorize, Fit, Measure, Outcome, Prefilter, Render, Work
from brdf_suite.batches.workers import BatchWorkers
from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.errors import Cancelled, FileError, SuiteError, ValueRangeError
from brdf_suite.fitting.homomorphic.reflectance_fit import FactoringOptions
from brdf_suite.pipeline.scene import default_view
from brdf_suite.progress import Progress
from brdf_suite.release import __version__

Hire = Callable[[], AbstractContextManager[BatchWorkers]]


@pytest.fixture
def hire() -> Iterator[Hire]:
    with ThreadPoolExecutor(1) as pool:
        yield lambda: nullcontext(BatchWorkers(pool, lambda: 1))


@pytest.fixture
def paints(tmp_path: Path) -> Path:
    folder = tmp_path / "paints"
    (folder / "below").mkdir(parents=True)
    bs.save(bs.load("blue", bs.Paint), folder / "blue.brdfpaint")
    bs.save(bs.load("copper", bs.Paint), folder / "below" / "copper.brdfpaint")
    entries = (
        Entry(bs.load("fine_silver", bs.Paint), "7"),
        Entry(FlatColour("Grey", "Gray", (0.25,)), "8"),
    )
    bs.save(Palette("Two", entries), folder / "two.brdfpalette")
    return folder


def rows_of(folder: Path) -> list[dict[str, str]]:
    with (folder / "results.csv").open(encoding="utf-8", newline="") as file:
        return [*csv.DictReader(file)]


def test_items_are_the_paints_below_a_folder_and_each_counts_once(paints: Path) -> None:
    items = list_paints([paints, paints / "blue.brdfpaint", "blue"])
    assert [item.label for item in items] == [
        "copper.brdfpaint",
        "blue.brdfpaint",
        "two.brdfpalette#7",
        "two.brdfpalette#8",
        "blue",
    ]
    assert len({item.key for item in items}) == 5
    assert [item.times for item in items] == [1, 2, 1, 1, 1]
    assert [item.key for item in items] == [
        item.key for item in list_paints([paints, "blue"])
    ]  # in every run


def test_a_paint_has_another_key_once_it_has_changed(paints: Path) -> None:
    before = {item.label: item.key for item in list_paints([paints])}
    paint = bs.load("blue", bs.Paint)
    bs.save(replace(paint, notes="darker"), paints / "blue.brdfpaint")
    after = {item.label: item.key for item in list_paints([paints])}
    assert [label for label in before if before[label] != after[label]] == ["blue.brdfpaint"]


def test_the_folder_of_the_results_is_no_source(paints: Path) -> None:
    (paints / "out").mkdir()
    bs.save(bs.load("red", bs.Paint), paints / "out" / "red.brdfpaint")
    assert "red.brdfpaint" in {item.label for item in list_paints([paints])}
    assert "red.brdfpaint" not in {item.label for item in list_paints([paints], paints / "out")}


def test_a_list_names_files_from_its_own_folder_on(paints: Path) -> None:
    lines = ["# autumn", "", "blue.brdfpaint", "  two.brdfpalette#7 ", "fine_silver"]
    assert sources_in(lines, paints) == [
        str(paints / "blue.brdfpaint"),
        str(paints / "two.brdfpalette#7"),
        "fine_silver",
    ]
    (paints / "Lot #5.brdfpaint").write_bytes((paints / "blue.brdfpaint").read_bytes())
    lines = ["copper   # a remark", "Lot #5.brdfpaint", "blue.brdfpaint # the third"]
    assert sources_in(lines, paints) == [
        "copper",
        str(paints / "Lot #5.brdfpaint"),
        str(paints / "blue.brdfpaint"),
    ]


def test_other_objects_than_names_are_no_sources(tmp_path: Path) -> None:
    with pytest.raises(ValueRangeError, match="not a Paint"):
        bs.batch("measure", bs.load("blue", bs.Paint), tmp_path)  # type: ignore[arg-type]


def test_an_empty_folder_is_an_error(tmp_path: Path) -> None:
    with pytest.raises(FileError, match="holds no file"):
        list_paints([tmp_path])


def test_measuring_gives_what_the_library_reads(paints: Path, tmp_path: Path, hire: Hire) -> None:
    out = tmp_path / "out"
    done = run_batch(Measure("e2194"), list_paints([paints]), out, hire)
    assert (done.items, done.done, done.problems) == (4, 4, ())
    rows = rows_of(out)
    read = bs.measure(paints / "blue.brdfpaint", geometry="e2194")
    blue = next(row for row in rows if row["item"] == "blue.brdfpaint")
    assert [float(blue[f"{axis}_45"]) for axis in "Lab"] == pytest.approx(read.readings[1].lab, abs=1e-4)
    assert float(blue["G20"]) == pytest.approx(read.gloss[20], abs=1e-3)
    assert float(blue["graininess"]) == pytest.approx(read.texture.graininess, rel=1e-4)
    table = pyarrow.parquet.read_table(out / "results.parquet")
    assert table.num_rows == 4
    assert table["L_45"].to_pylist() == [float(row["L_45"]) for row in rows]
    names = [entry.name for entry in bs.load(out / "results.brdfpalette", bs.Palette).entries]
    assert names == ["Copper", "Blue", "Fine silver", "Grey"]
    page = (out / "summary.html").read_text(encoding="utf-8")
    assert "Batch: measure" in page
    assert "L_45" in page


def test_texture_is_left_out_where_it_is_not_wanted(tmp_path: Path, hire: Hire) -> None:
    run_batch(Measure("e2194", texture=False), list_paints(["blue"]), tmp_path, hire)
    (row,) = rows_of(tmp_path)
    assert row["graininess"] == row["sparkle_grade_45"] == ""
    assert float(row["L_45"]) == pytest.approx(
        bs.measure("blue", geometry="e2194", texture=False).lab[1, 0], abs=1e-4
    )


def test_what_is_there_twice_is_said_of_the_run_that_is_given_it(tmp_path: Path, hire: Hire) -> None:
    step = Measure("e2194", texture=False)
    twice = run_batch(step, list_paints(["blue", "blue"]), tmp_path, hire)
    assert twice.notices == ("blue is there 2 times; it is done once",)
    assert run_batch(step, list_paints(["blue"]), tmp_path, hire).notices == ()
    again = run_batch(step, list_paints(["blue", "red", "blue"]), tmp_path, hire)
    assert again.notices == twice.notices
    assert again.done_before == 1


def test_notices_of_a_palette_stay_where_its_first_paint_is_given_before(tmp_path: Path) -> None:
    path = tmp_path / "two.gpl"
    path.write_text("GIMP Palette\n1 2 3 first\n300 2 3 second\n")
    items = list_paints([path])
    assert "beyond 0 to 255" in items[0].notices[0]
    both = list_paints([items[0].label.replace("two.gpl", str(path)), path])
    assert [item.key for item in both] == [item.key for item in items]
    assert both[0].notices == items[0].notices


def test_a_fit_writes_the_weights(tmp_path: Path, hire: Hire) -> None:
    run_batch(Fit(), list_paints(["blue"]), tmp_path / "out", hire)
    row = pyarrow.parquet.read_table(tmp_path / "out" / "results.parquet").to_pylist()[0]
    fitted = bs.fit("blue")
    assert np.reshape(row["kg"], (-1, 3)) == pytest.approx(fitted.weights.kg)
    assert row["worst_delta_e_2000"] == pytest.approx(fitted.worst_delta_e)


def test_pictures_are_those_that_render_makes(tmp_path: Path, hire: Hire) -> None:
    view = replace(default_view("overcast"), surface="sphere")
    done = run_batch(Render(view, (48, 32)), list_paints(["blue", "red"]), tmp_path / "out", hire)
    assert done.problems == ()
    for row in rows_of(tmp_path / "out"):
        made = np.asarray(Image.open(tmp_path / "out" / row["picture"]).convert("RGB"), int)
        alone = bs.render(row["item"], size=(48, 32), view=view).pixels
        assert np.abs(made - alone).max() <= 1
    assert "<figure>" in (tmp_path / "out" / "summary.html").read_text(encoding="utf-8")


def test_environments_are_filtered_into_the_cache(tmp_path: Path, hire: Hire) -> None:
    light = tmp_path / "lights" / "even.exr"
    light.parent.mkdir()
    bs.save(bs.Environment("even", np.ones((64, 128, 3), np.float32)), light)
    done = run_batch(Prefilter(), list_lights([light.parent]), tmp_path / "out", hire)
    assert done.problems == ()
    assert [(row["columns"], row["rows"]) for row in rows_of(tmp_path / "out")] == [("128", "64")]


def test_factors_are_paints(tmp_path: Path, hire: Hire) -> None:
    step = Factorize(FactoringOptions(resolution=8, pairs=2000))
    run_batch(step, list_paints(["blue"]), tmp_path / "out", hire)
    row = rows_of(tmp_path / "out")[0]
    assert bs.load(tmp_path / "out" / row["paint"]).name == "Blue"


def test_an_export_is_a_file_each(paints: Path, tmp_path: Path, hire: Hire) -> None:
    run_batch(Export("json"), list_paints([paints]), tmp_path / "out", hire)
    files = [tmp_path / "out" / row["file"] for row in rows_of(tmp_path / "out")]
    assert [json.loads(file.read_text(encoding="utf-8"))["format"] for file in files]
    assert len({*files}) == 4


def test_a_bad_item_is_reported_and_the_rest_done(paints: Path, tmp_path: Path, hire: Hire) -> None:
    (paints / "bad.brdfpaint").write_text('{"format": "brdfpaint", "version": 99', encoding="utf-8")
    (paints / "torn.ase").write_bytes(b"ASEF\x00\x01\x00\x00\x00\x00\x00\x09")
    done = run_batch(Measure(), list_paints([paints, "no such paint"]), tmp_path / "out", hire)
    problems = {Path(source).name: problem for source, problem in done.problems}
    assert {*problems} == {"bad.brdfpaint", "torn.ase", "no such paint"}
    assert "bad.brdfpaint" in problems["bad.brdfpaint"]
    assert [row["item"] for row in rows_of(tmp_path / "out") if not row["problem"]] == [
        "copper.brdfpaint",
        "blue.brdfpaint",
        "two.brdfpalette#7",
        "two.brdfpalette#8",
    ]


def test_formulas_in_names_stay_text_in_the_table(tmp_path: Path, hire: Hire) -> None:
    paint = replace(bs.load("blue", bs.Paint), name='=HYPERLINK("x")<img src=y>')
    bs.save(paint, tmp_path / "a.brdfpaint")
    run_batch(Measure(), list_paints([tmp_path / "a.brdfpaint"]), tmp_path / "out", hire)
    assert rows_of(tmp_path / "out")[0]["name"].startswith("'=")
    view = replace(default_view("overcast"), surface="sphere")
    run_batch(Render(view, (16, 16)), list_paints([tmp_path / "a.brdfpaint"]), tmp_path / "drawn", hire)
    assert "<img src=y>" not in (tmp_path / "drawn" / "summary.html").read_text(encoding="utf-8")


def test_the_page_of_a_batch_shows_what_is_not_seen_in_a_name(tmp_path: Path, hire: Hire) -> None:
    (tmp_path / "gpj.\u202ea.brdfpaint").write_text("{}")
    run_batch(Measure(), list_paints([tmp_path / "gpj.\u202ea.brdfpaint"]), tmp_path / "out", hire)
    page = (tmp_path / "out" / "summary.html").read_text(encoding="utf-8")
    assert "gpj.[U+202E]a.brdfpaint" in page
    assert "\u202e" not in page


def test_a_cancelled_batch_goes_on_where_it_was(tmp_path: Path, hire: Hire) -> None:
    names = ["blue", "red", "copper", "fine_silver", "solid_black"]  # more than the worker has at once
    whole, parts = tmp_path / "whole", tmp_path / "parts"
    run_batch(Measure(), list_paints(names), whole, hire)

    def stop(_share: float, words: str) -> None:
        if re.match(r"measure: [1-9]", words):
            raise Cancelled

    with pytest.raises(Cancelled):
        run_batch(Measure(), list_paints(names), parts, hire, group=1, progress=stop)
    done = run_batch(Measure(), list_paints(names), parts, hire)
    assert 1 <= done.done_before < 5
    assert done.done == 5 - done.done_before
    assert (parts / "results.csv").read_bytes() == (whole / "results.csv").read_bytes()


def test_what_is_done_needs_no_workers(tmp_path: Path, hire: Hire) -> None:
    run_batch(Measure(), list_paints(["blue"]), tmp_path, hire)

    def never() -> AbstractContextManager[BatchWorkers]:
        raise AssertionError("workers were started")

    assert run_batch(Measure(), list_paints(["blue"]), tmp_path, never).done_before == 1


@pytest.mark.parametrize(("list_items", "step"), [(list_paints, Measure()), (list_lights, Prefilter())])
def test_a_source_without_a_name_is_not_the_working_folder(
    list_items: Callable[..., list[BatchItem]],
    step: Any,
    paints: Path,
    monkeypatch: pytest.MonkeyPatch,
    hire: Hire,
) -> None:
    monkeypatch.chdir(paints)
    items = list_items([""])
    assert len(items) == 1
    ((source, problem),) = run_batch(step, items, paints.parent / "out", hire).problems
    assert source == ""
    assert "is empty" in problem


def test_what_cannot_be_loaded_needs_no_worker(tmp_path: Path) -> None:
    (tmp_path / "bad.brdfpalette").write_text("{}")

    def never() -> AbstractContextManager[BatchWorkers]:
        raise AssertionError("workers were started")

    done = run_batch(Measure(), list_paints([tmp_path / "bad.brdfpalette"]), tmp_path / "out", never)
    assert (done.items, done.done, len(done.problems)) == (1, 1, 1)


def test_a_source_that_is_no_paint_is_one_items_problem(tmp_path: Path, hire: Hire) -> None:
    other = tmp_path / "other.txt"
    other.write_text("no paint")
    done = run_batch(Measure(), list_paints([str(other), "blue"]), tmp_path / "out", hire)
    ((source, problem),) = done.problems
    assert source == str(other)
    assert problem.startswith(f"{other}, at byte 0: is neither a paint nor a palette")
    assert [row["name"] for row in rows_of(tmp_path / "out") if row["name"]] == ["Blue"]


def test_other_options_are_another_batch(tmp_path: Path, hire: Hire) -> None:
    run_batch(Measure("six"), list_paints(["blue"]), tmp_path, hire)
    done = run_batch(Measure("e2194"), list_paints(["blue"]), tmp_path, hire)
    assert done.done_before == 0
    assert "L_25" not in rows_of(tmp_path)[0]


def test_an_item_whose_picture_is_gone_is_done_again(tmp_path: Path, hire: Hire) -> None:
    step = Render(replace(default_view("overcast"), surface="sphere"), (16, 16))
    run_batch(step, list_paints(["blue"]), tmp_path, hire)
    picture = tmp_path / rows_of(tmp_path)[0]["picture"]
    picture.unlink()
    assert run_batch(step, list_paints(["blue"]), tmp_path, hire).done == 1
    assert picture.is_file()


def test_one_batch_in_a_folder_at_a_time(tmp_path: Path, hire: Hire) -> None:
    def second(_share: float, _words: str) -> None:
        with pytest.raises(FileError, match="another batch"):
            run_batch(Measure(), list_paints(["red"]), tmp_path, hire)

    run_batch(Measure(), list_paints(["blue"]), tmp_path, hire, progress=second)


def test_a_batch_that_cannot_begin_says_why(tmp_path: Path, hire: Hire) -> None:
    with pytest.raises(SuiteError, match="geometr"):
        run_batch(Measure("nonsense"), list_paints(["blue"]), tmp_path, hire)
    with pytest.raises(SuiteError, match="There is no format"):
        run_batch(Export("nonsense"), list_paints(["blue"]), tmp_path, hire)
    with pytest.raises(ValueRangeError, match="group"):
        run_batch(Measure(), list_paints(["blue"]), tmp_path, hire, group=0)
    (tmp_path / "file").write_bytes(b"")
    with pytest.raises(FileError):
        run_batch(Measure(), list_paints(["blue"]), tmp_path / "file", hire)


class Broken(Executor):
    """As a pool of processes whose workers have died."""

    def submit(self, *_: object, **__: object) -> object:  # type: ignore[override]
        raise RuntimeError("the pool is broken")


def test_lost_workers_are_reported_and_nothing_is_lost(tmp_path: Path, hire: Hire) -> None:
    run_batch(Measure(), list_paints(["blue"]), tmp_path, hire)
    lost = BatchWorkers(Broken(), lambda: 1)
    with pytest.raises(SuiteError, match="goes on where it was"):
        run_batch(Measure(), list_paints(["blue", "red"]), tmp_path, lambda: nullcontext(lost))
    assert run_batch(Measure(), list_paints(["blue", "red"]), tmp_path, hire).done_before == 1


class Queued(Executor):
    """As a cluster whose worker waits for its turn."""

    def __init__(self, pool: Executor) -> None:
        self.turn = threading.Event()
        self._pool = pool

    def submit(self, function: Callable[..., object], *arguments: object) -> Future[object]:  # type: ignore[override]
        def wait_and_do() -> object:
            self.turn.wait()
            return function(*arguments)

        return self._pool.submit(wait_and_do)


@pytest.fixture
def queued() -> Iterator[Queued]:
    with ThreadPoolExecutor(1) as pool:
        made = Queued(pool)
        yield made
        made.turn.set()


def test_a_batch_waits_for_workers_and_says_so(tmp_path: Path, queued: Queued) -> None:
    looked: list[bool] = []
    waiting = BatchWorkers(
        queued, lambda: int(queued.turn.is_set()), replace_lost=lambda: looked.append(queued.turn.is_set())
    )

    def begin(_share: float, words: str) -> None:
        if words == "measure: 0 of 1, waiting for a worker":
            queued.turn.set()

    paints = list_paints(["blue"])
    done = run_batch(Measure(), paints, tmp_path, lambda: nullcontext(waiting), progress=begin)
    assert done.done == 1
    assert looked[0] is False


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> list[float]:
    """Have a batch read its time, s, from here."""
    now = [0.0]
    monkeypatch.setattr(running, "monotonic", lambda: now[0])
    return now


@pytest.mark.parametrize(
    ("steps", "problem"),
    [
        # Seconds, whether the workers are reached, and how many are there; at the last step the batch ends.
        ([(50.0, False, 1), (81.0, False, 1)], "The workers are lost"),
        (
            [(50.0, True, 0), (60.0, False, 0), (149.0, True, 0), (151.0, True, 0)],
            "No worker was there for 100 s",
        ),
        (
            [(90.0, True, 0), (95.0, True, 1), (100.0, True, 0), (201.0, True, 0)],
            "No worker was there for 100 s",
        ),
    ],
)
def test_a_batch_ends_where_workers_stay_away(
    steps: list[tuple[float, bool, int]], problem: str, tmp_path: Path, queued: Queued, clock: list[float]
) -> None:
    left = [(0.0, True, 1), *steps]

    def go_on(_share: float, words: str) -> None:
        if words.startswith("measure"):
            del left[0]
            clock[0] = left[0][0]

    workers = BatchWorkers(queued, lambda: left[0][2], lambda: left[0][1], patience_s=100.0)
    with pytest.raises(SuiteError, match=f"{problem}; .* goes on where it was"):
        run_batch(Measure(), list_paints(["blue"]), tmp_path, lambda: nullcontext(workers), progress=go_on)
    assert left == steps[-1:]


@dataclass(frozen=True)
class Odd:
    """Fails as no step of ours should."""

    name: ClassVar[str] = "odd"

    def prepare(self, _progress: Progress | None) -> None:
        """There is nothing to prepare."""

    def open(self) -> AbstractContextManager[Work]:
        def work(item: BatchItem, _folder: Path) -> Outcome:
            if item.label == "red":
                raise ZeroDivisionError("by nothing")
            return Outcome({"name": item.label})

        return nullcontext(work)


def test_an_error_of_the_program_is_one_items_problem(tmp_path: Path, hire: Hire) -> None:
    done = run_batch(Odd(), list_paints(["blue", "red"]), tmp_path, hire)
    assert done.problems == (("red", "ZeroDivisionError: by nothing"),)


class Shown:
    """A step that says when it is opened and closed, in this process."""

    name: ClassVar[str] = "shown"
    __dataclass_fields__: ClassVar[dict[str, Any]] = {}

    def __init__(self, said: list[str]) -> None:
        self._said = said

    def prepare(self, _progress: Progress | None) -> None:
        """There is nothing to prepare."""

    @contextmanager
    def open(self) -> Iterator[Work]:
        self._said.append("opened")
        yield lambda item, _folder: Outcome({"name": item.label})
        self._said.append("closed")


def test_a_step_stays_open_between_groups_and_is_closed_when_idle(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(worker, "IDLE_S", 0.5)
    Journal(tmp_path, "x").append(())
    said: list[str] = []
    before = threading.active_count()
    for _ in range(300):
        worker.do_items(Shown(said), "x", list_paints(["blue"]), str(tmp_path), __version__)
        assert threading.active_count() <= before + 2  # the one that works, and a timer
    assert len(said) < 10  # once, but where this machine stood still meanwhile
    end = monotonic() + 60.0
    while said[-1] != "closed":
        assert monotonic() < end, said
        sleep(0.05)


_DONE = [
    Finished(f"{index:064x}", f"item {index}", "", {"value": index / 3, "name": "ä=,\n"})
    for index in range(5)
]


@given(cut=st.integers(0, 2000), damage=st.binary(max_size=3))
def test_a_journal_that_was_cut_off_anywhere_gives_whole_items(
    tmp_path_factory: pytest.TempPathFactory, cut: int, damage: bytes
) -> None:
    tmp_path = tmp_path_factory.mktemp("journal")
    path = tmp_path / JOURNAL
    Journal(tmp_path, "step").append(_DONE)
    content = path.read_bytes()
    path.write_bytes(content[:cut] + damage.replace(b"\n", b""))
    again = Journal(tmp_path, "step")
    whole = content[:cut].count(b"\n")
    kept = [*again.finished.values()]
    assert kept == _DONE[: len(kept)]
    assert len(kept) >= whole - 1
    again.append(_DONE)
    assert [*Journal(tmp_path, "step").finished.values()] == _DONE


def test_problems_of_files_with_one_name_are_all_reported(tmp_path: Path, hire: Hire) -> None:
    for name in ("a", "b"):
        (tmp_path / "paints" / name).mkdir(parents=True)
        (tmp_path / "paints" / name / "same.ase").write_bytes(b"ASEF\x00\x01\x00\x00\x00\x00\x00\x09")
    done = run_batch(Measure(), list_paints([tmp_path / "paints"]), tmp_path / "out", hire)
    assert len({source for source, _ in done.problems}) == 2
    assert len(rows_of(tmp_path / "out")) == 2


def test_one_entry_of_a_palette_is_known_by_its_content(paints: Path, tmp_path: Path, hire: Hire) -> None:
    source = f"{paints / 'two.brdfpalette'}#7"
    (before,) = list_paints([source])
    assert (before.label, before.entry != b"") == ("two.brdfpalette#7", True)
    bs.save(Palette("Two", (Entry(bs.load("copper", bs.Paint), "7"),)), paints / "two.brdfpalette")
    (after,) = list_paints([source])
    assert before.key != after.key
    run_batch(Measure(), [after], tmp_path / "out", hire)
    assert rows_of(tmp_path / "out")[0]["name"] == "Copper"
    done = run_batch(Measure(), list_paints([f"{source[:-1]}Copper", "blue"]), tmp_path / "more", hire)
    ((_, problem),) = done.problems
    assert "has no paint with the id 'Copper'; did you mean #7?" in problem
    assert done.done == 2


def test_notes_and_sources_stand_beside_the_results(paints: Path, tmp_path: Path, hire: Hire) -> None:
    table = paints / "read.csv"
    table.write_text("name,L15,a15,b15,L45,a45,b45,L110,a110,b110\nHuge,1e9,0,0,1e300,0,0,5,0,0\n")
    done = run_batch(Measure(), list_paints([table]), tmp_path / "out", hire)
    assert any("beyond what a paint can have" in text for text in done.notices)
    (row,) = rows_of(tmp_path / "out")
    assert row["source"] == str(table)
    assert "beyond what a paint can have" in row["notes"]


def test_results_of_other_batches_are_no_sources_and_are_named(
    paints: Path, tmp_path: Path, hire: Hire
) -> None:
    before = len(list_paints([paints]))
    out = paints / "out"
    run_batch(Export("csv"), list_paints([paints]), out, hire)
    assert len(list_paints([paints])) == before
    done = run_batch(Fit(), list_paints(["blue"]), out, hire)
    assert (done.others, done.items) == (before, 1)


def test_a_changed_environment_draws_all_anew(tmp_path: Path, hire: Hire) -> None:
    light = tmp_path / "even.exr"
    bs.save(bs.Environment("even", np.ones((32, 64, 3), np.float32)), light)
    view = replace(default_view(), environment=str(light), surface="sphere")
    step = Render(view, (16, 16))
    run_batch(step, list_paints(["blue"]), tmp_path / "out", hire)
    assert run_batch(step, list_paints(["blue"]), tmp_path / "out", hire).done == 0
    bs.save(bs.Environment("red", np.ones((32, 64, 3), np.float32) * (1.0, 0.1, 0.1)), light)
    before = np.asarray(Image.open(tmp_path / "out" / rows_of(tmp_path / "out")[0]["picture"]), int)
    assert run_batch(step, list_paints(["blue"]), tmp_path / "out", hire).done == 1
    after = np.asarray(Image.open(tmp_path / "out" / rows_of(tmp_path / "out")[0]["picture"]), int)
    assert np.abs(before - after).max() > 20


@pytest.mark.skipif(sys.platform != "linux", reason="names of files are bytes on Linux")
def test_a_name_that_is_no_text_is_an_item_like_others(tmp_path: Path, hire: Hire) -> None:
    folder = tmp_path / "paints"
    folder.mkdir()
    bs.save(bs.load("blue", bs.Paint), folder / "a.brdfpaint")
    os.rename(os.fsencode(folder / "a.brdfpaint"), os.fsencode(folder) + b"/gr\xfcn.brdfpaint")  # noqa: PTH104
    done = run_batch(Measure(), list_paints([folder]), tmp_path / "out", hire)
    assert done.problems == ()
    assert rows_of(tmp_path / "out")[0]["item"] == "gr\\xfcn.brdfpaint"


def test_names_that_no_file_system_takes_are_items_that_fail(tmp_path: Path, hire: Hire) -> None:
    sources = sources_in(["x" * 300, "blue"], tmp_path)
    done = run_batch(Measure(), list_paints(sources), tmp_path / "out", hire)
    assert [source for source, _ in done.problems] == ["x" * 300]
