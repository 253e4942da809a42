"""Results of a batch: tables as CSV and Parquet, a palette of the paints, and a page that sums up."""

from __future__ import annotations

import csv
import io
import json
import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from datetime import datetime
from importlib import import_module
from pathlib import Path
from statistics import median

from brdf_suite.batches.items import BatchItem
from brdf_suite.batches.journal import Finished
from brdf_suite.batches.steps import Value
from brdf_suite.documents.atomic import replacing, write_atomically
from brdf_suite.documents.palette import MOST_ENTRIES, Entry, Palette
from brdf_suite.documents.palette_store import entry_from_json, save_palette
from brdf_suite.errors import SuiteError
from brdf_suite.extras import import_extra
from brdf_suite.foreign_text import escape_html, guard_formula
from brdf_suite.pipeline.material import document_kind, load_document
from brdf_suite.regular_files import is_file
from brdf_suite.release import __version__

CSV, PARQUET, PALETTE, SUMMARY = "results.csv", "results.parquet", "results.brdfpalette", "summary.html"
_FIRST = ("item", "source", "problem", "notes")
_MOST_SHOWN = 60
_STYLE = """
body { font: 15px/1.45 system-ui, sans-serif; max-width: 60rem; margin: 2rem auto; padding: 0 1rem; color: #222 }
h1 { font-size: 1.5rem } h2 { font-size: 1.1rem; margin-top: 2rem }
table { border-collapse: collapse } th, td { padding: .2rem .8rem .2rem 0; text-align: left; vertical-align: top }
td.number { text-align: right; font-variant-numeric: tabular-nums }
.pictures { display: grid; grid-template-columns: repeat(auto-fill, minmax(10rem, 1fr)); gap: .8rem }
figure { margin: 0 } img { width: 100%; border-radius: 4px } figcaption { font-size: .85rem; color: #555 }
@media (prefers-color-scheme: dark) { body { background: #1c1c1e; color: #ddd } figcaption { color: #aaa } }
"""


def write_results(
    folder: Path, step: str, items: Sequence[BatchItem], found: Mapping[str, Finished], seconds: float
) -> None:
    """Write the tables, the palette and the page of what is finished, in the order of the items.

    Raises
    ------
    FileError
        The disk refuses.
    MissingExtraError
        There is no pyarrow, which writes Parquet.
    """
    done = [found[item.key] for item in items if item.key in found]
    columns = _columns(done)
    rows = [_row(one) for one in done]
    _write_csv(folder / CSV, columns, rows)
    _write_parquet(folder / PARQUET, columns, rows)
    if step not in ("prefilter", "factorize"):
        _write_palette(folder / PALETTE, step, items, found)
    write_atomically(folder / SUMMARY, _summary(step, items, done, columns, seconds).encode())


def _columns(done: Iterable[Finished]) -> list[str]:
    """Return the names of all columns, in the order in which the rows have them."""
    return [*_FIRST, *dict.fromkeys(column for one in done for column in one.row)]


def _write_csv(path: Path, columns: Sequence[str], rows: Iterable[Mapping[str, Value]]) -> None:
    text = io.StringIO(newline="")
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(columns)
    for row in rows:
        writer.writerow([_cell(row.get(column)) for column in columns])
    write_atomically(path, text.getvalue().encode())


def _row(one: Finished) -> dict[str, Value]:
    """Return all of a row; names of files whose bytes are no text are written so that they are."""
    row: dict[str, Value] = {
        "item": one.label,
        **one.row,
        "source": one.source,
        "problem": one.problem,
        "notes": "; ".join(one.notices),
    }
    return {
        key: value.encode("utf-8", "backslashreplace").decode() if isinstance(value, str) else value
        for key, value in row.items()
    }


def _cell(value: Value) -> str:
    if value is None:
        return ""
    if isinstance(value, str):
        return guard_formula(value)
    return json.dumps(value) if isinstance(value, list | bool) else repr(value)


def _write_parquet(path: Path, columns: Sequence[str], rows: Sequence[Mapping[str, Value]]) -> None:
    arrow = import_extra("pyarrow", purpose="a Parquet table")
    parquet = import_module("pyarrow.parquet")
    table = arrow.Table.from_pydict({column: [row.get(column) for row in rows] for column in columns})
    with replacing(path) as temporary:
        parquet.write_table(table, temporary, compression="zstd")


def _write_palette(path: Path, step: str, items: Sequence[BatchItem], found: Mapping[str, Finished]) -> None:
    """Write what came through as a palette; of more paints than one takes the first ones."""
    good = (item for item in items if item.key in found and not found[item.key].problem)
    entries = []
    for item, entry in zip(range(MOST_ENTRIES), _entries(good), strict=False):
        entries.append(Entry(entry.content, str(item + 1), entry.group, entry.code, entry.tags, entry.notes))
    if entries:
        save_palette(Palette(f"batch {step}", tuple(entries)), path)


def _entries(items: Iterable[BatchItem]) -> Iterator[Entry]:
    for item in items:
        if item.entry:
            yield entry_from_json(json.loads(item.entry), item.source)
            continue
        try:
            if is_file(item.source) and document_kind(item.source) != "paint":
                continue  # a measured file
            document = load_document(item.source)
        except SuiteError:  # it has changed since
            continue
        if document is not None:
            yield Entry(document)


def _summary(
    step: str, items: Sequence[BatchItem], done: Sequence[Finished], columns: Sequence[str], seconds: float
) -> str:
    problems = [one for one in done if one.problem]
    good = [one for one in done if not one.problem]
    facts = {
        "items": f"{len(items):,}",
        "finished": f"{len(good):,}",
        "with a problem": f"{len(problems):,}",
        "time of the last run": f"{seconds:,.1f} s",
        "written": f"{datetime.now().astimezone():%Y-%m-%d %H:%M}, by release {__version__}",
    }
    parts = [
        f"<h1>Batch: {escape_html(step)}</h1>",
        _table(("", ""), list(facts.items())),
    ]
    if problems:
        rows = [(one.label, one.problem) for one in problems[:_MOST_SHOWN]]
        parts += [f"<h2>Problems</h2>{_table(('item', 'problem'), rows)}", _rest(len(problems))]
    figures = list(_figures(good, columns))
    if figures:
        parts += ["<h2>Figures</h2>", _table(("column", "least", "median", "most", "unknown"), figures)]
    pictures = [one for one in good if isinstance(one.row.get("picture"), str)]
    if pictures:
        shown = "".join(
            f'<figure><img loading="lazy" src="{escape_html(str(one.row["picture"]))}" alt="">'
            f"<figcaption>{escape_html(str(one.row.get('name', one.label)))}</figcaption></figure>"
            for one in pictures[:_MOST_SHOWN]
        )
        parts += [f'<h2>Pictures</h2><div class="pictures">{shown}</div>', _rest(len(pictures))]
    files = ", ".join(f'<a href="{name}">{name}</a>' for name in (CSV, PARQUET))
    return (
        f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><title>Batch: {escape_html(step)}</title>'
        f"<style>{_STYLE}</style></head><body>{''.join(parts)}<p>All rows: {files}.</p></body></html>\n"
    )


def _figures(good: Sequence[Finished], columns: Iterable[str]) -> Iterator[tuple[str, ...]]:
    for column in columns:
        values = [one.row.get(column) for one in good]
        numbers = [
            float(value)
            for value in values
            if isinstance(value, int | float) and not isinstance(value, bool) and math.isfinite(value)
        ]
        if numbers:
            shown = (f"{value:.5g}" for value in (min(numbers), median(numbers), max(numbers)))
            yield (column, *shown, str(len(values) - len(numbers)))


def _rest(count: int) -> str:
    return f"<p>The first {_MOST_SHOWN} of {count:,}.</p>" if count > _MOST_SHOWN else ""


def _table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    titles = "".join(f"<th>{escape_html(text)}</th>" for text in head)
    body = "".join(
        "<tr>"
        + f"<td>{escape_html(row[0])}</td>"
        + "".join(
            f'<td class="{"number" if _is_number(text) else ""}">{escape_html(text)}</td>' for text in row[1:]
        )
        + "</tr>"
        for row in rows
    )
    return f"<table><tr>{titles}</tr>{body}</table>"


def _is_number(text: str) -> bool:
    try:
        float(text.replace(",", "").removesuffix(" s"))
    except ValueError:
        return False
    return True
