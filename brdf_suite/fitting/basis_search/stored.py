"""Stored search, finished or running: the source of the basis plots.

The answer (``search.json``) and the state of a running search (``FILE.part``, written again after each count) hold the
same results; the state knows no default yet.
"""

from __future__ import annotations

import itertools
from dataclasses import dataclass
from pathlib import Path

from brdf_suite.documents.reading import FieldReader, read_json
from brdf_suite.fitting.basis_search.document import STATE_FORMAT, STATE_VERSION, result_from_json
from brdf_suite.fitting.basis_search.search import CountResult
from brdf_suite.fitting.lobes.basis import STORED_FORMAT, STORED_VERSION


@dataclass(frozen=True)
class StoredSearch:
    """Results by rising count, with the names of the paints in the order of their errors.

    ``default_count`` is None while the search runs; ``date`` is empty then. ``sha256`` is that of the database.
    """

    paints: tuple[str, ...]
    results: tuple[CountResult, ...]
    sha256: str
    default_count: int | None = None
    date: str = ""


def load_search(path: Path) -> StoredSearch:
    """Return the search in a file.

    Raises
    ------
    DocumentError
        It is no search, of another version, or damaged; the message says where.
    FileError
        It cannot be read.
    """
    reader = FieldReader(read_json(path), path)
    kind = reader.take("format"), reader.take("version")
    if kind == (STORED_FORMAT, STORED_VERSION):
        names, default = reader.take("paints"), reader.take("default_count")
        record = reader.take("provenance")
        sha256 = record.get("database_sha256") if isinstance(record, dict) else None
        date = record.get("date") if isinstance(record, dict) else None
    elif kind == (STATE_FORMAT, STATE_VERSION):
        settings = reader.take("settings")
        names = settings.get("paints") if isinstance(settings, dict) else None
        sha256 = settings.get("database_sha256") if isinstance(settings, dict) else None
        default, date = None, ""
    else:
        reader.fail(
            f"this is no search of lobes ({STORED_FORMAT} {STORED_VERSION} or {STATE_FORMAT} {STATE_VERSION})",
            "format",
        )
    if not isinstance(names, list) or not all(isinstance(name, str) for name in names):
        reader.fail("expected a list of names", "paints")
    results = tuple(result_from_json(item, len(names)) for item in reader.take_objects("results"))
    if any(a.count >= b.count for a, b in itertools.pairwise(results)):
        reader.fail("the counts do not rise", "results")
    if default is not None and default not in {result.count for result in results}:
        reader.fail(f"there is no basis of {default!r} lobes", "default_count")
    return StoredSearch(tuple(names), results, str(sha256 or ""), default, str(date or ""))
