"""Files of a search: the resumable state, and the stored result that defines the suite's lobes.

Both are JSON, written whole or not at all. The answer is read at start-up by
:func:`brdf_suite.fitting.lobes.basis.default_basis`, which takes only the exponents from it.
"""

from __future__ import annotations

import itertools
import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from brdf_suite.documents.atomic import write_atomically
from brdf_suite.documents.parameter import describe
from brdf_suite.documents.reading import FieldReader, read_json
from brdf_suite.errors import DocumentError, FittingError
from brdf_suite.fitting.basis_search.database import Database
from brdf_suite.fitting.basis_search.error import MEANING
from brdf_suite.fitting.basis_search.search import CountResult
from brdf_suite.fitting.lobes.basis import STORED_FORMAT, STORED_VERSION, LobeBasis
from brdf_suite.regular_files import exists

STATE_FORMAT, STATE_VERSION = "lobe_basis_search", 1
#: The default is the smallest count whose equation 4 is within this factor of the lowest that the search found: each
#: lobe costs a map in the prefilter and a look-up for every pixel (docs/method/basis.md).
NEAR_BEST = 1.02


def settings_of(database: Database, starts: int) -> dict[str, object]:
    """Return what a result depends on: a state of other settings is no start."""
    return {"database_sha256": database.sha256, "paints": list(database.names), "starts": starts}


def save_state(path: Path, settings: Mapping[str, object], results: Sequence[CountResult]) -> None:
    """Keep what is found so far; raise :class:`FileError` where it cannot be written."""
    state = {"format": STATE_FORMAT, "version": STATE_VERSION, "settings": dict(settings)}
    _write(path, {**state, "results": [_result_to_json(result) for result in results]})


def load_state(path: Path, settings: Mapping[str, object]) -> list[CountResult]:
    """Return the results of an interrupted search; none where there is no file.

    Raises
    ------
    DocumentError
        It is damaged, or of another database or other settings; the message says what to do.
    FileError
        It cannot be read.
    """
    if not exists(path):
        return []
    reader = FieldReader(read_json(path), path)
    if reader.take("format") != STATE_FORMAT or reader.take("version") != STATE_VERSION:
        reader.fail(f"this is no search of version {STATE_VERSION}; remove it, or give --fresh", "format")
    if reader.take("settings") != dict(settings):
        reader.fail("this search is of other paints or other starts; remove it, or give --fresh", "settings")
    paints = settings["paints"]
    assert isinstance(paints, list)
    results = [result_from_json(item, len(paints)) for item in reader.take_objects("results")]
    reader.finish()
    if [result.count for result in results] != list(range(1, len(results) + 1)):
        reader.fail("the counts are not 1, 2, 3 …; remove it, or give --fresh", "results")
    return results


def choose_default(results: Sequence[CountResult]) -> int:
    """Return the smallest count whose equation 4 is within :data:`NEAR_BEST` of the lowest."""
    limit = NEAR_BEST * min(result.value for result in results)
    return min(result.count for result in results if result.value <= limit)


def save_basis(
    path: Path,
    names: Sequence[str],
    results: Sequence[CountResult],
    default_count: int,
    provenance: Mapping[str, object],
) -> dict[str, object]:
    """Write the stored answer and return it.

    ``names`` are the paints in the order of the errors; ``provenance`` says how, where and when it was made.

    Raises
    ------
    FittingError
        There is no result with ``default_count`` lobes.
    FileError
        It cannot be written.
    """
    if default_count not in {result.count for result in results}:
        raise FittingError(f"There is no basis of {default_count} lobes to be the default.")
    answer: dict[str, object] = {
        "format": STORED_FORMAT,
        "version": STORED_VERSION,
        "default_count": default_count,
        "error": MEANING,
        "provenance": dict(provenance),
        "paints": list(names),
        "results": [_result_to_json(result) for result in results],
    }
    _write(path, answer)
    return answer


def _result_to_json(result: CountResult) -> dict[str, object]:
    return {
        "count": result.count,
        "exponents": list(result.exponents),
        "equation_4": result.value,
        "maximum": max(result.errors),
        "mean": sum(result.errors) / len(result.errors),
        "errors": list(result.errors),
        "base_errors": list(result.base_errors),
        "coat_errors": list(result.coat_errors),
        "evaluations": result.evaluations,
        "seconds": result.seconds,
        "others": [{"exponents": list(exponents), "equation_4": value} for exponents, value in result.others],
    }


def result_from_json(reader: FieldReader, paints: int) -> CountResult:
    """Return one result of a file, with the errors of so many paints; :class:`DocumentError` where it is damaged."""

    def numbers(name: str, reader: FieldReader = reader, count: int | None = paints) -> tuple[float, ...]:
        values = reader.take(name)
        if not isinstance(values, list) or (count is not None and len(values) != count):
            reader.fail(f"expected {count or 'some'} numbers", name)
        return tuple(_number(reader, name, value) for value in values)

    def lobes(name: str, reader: FieldReader = reader) -> tuple[float, ...]:
        try:
            return LobeBasis(numbers(name, reader, None)).exponents
        except FittingError as error:
            raise DocumentError(reader.path, str(error).rstrip("."), reader.where(name)) from error

    for derived in ("count", "equation_4", "maximum", "mean"):
        reader.take(derived)
    others = tuple(
        (lobes("exponents", item), _number(item, "equation_4", item.take("equation_4")))
        for item in reader.take_objects("others")
    )
    result = CountResult(
        lobes("exponents"),
        numbers("errors"),
        numbers("base_errors"),
        numbers("coat_errors"),
        int(_number(reader, "evaluations", reader.take("evaluations"))),
        _number(reader, "seconds", reader.take("seconds")),
        others,
    )
    reader.finish()
    return result


def _number(reader: FieldReader, name: str, value: object) -> float:
    if isinstance(value, bool) or not isinstance(value, (int, float)) or not 0.0 <= value < 1e12:
        reader.fail("expected a number of at least 0", name)
    return float(value)


def _write(path: Path, value: Mapping[str, object]) -> None:
    text = json.dumps(value, indent=1, ensure_ascii=False, allow_nan=False) + "\n"
    write_atomically(path, text.encode())


@dataclass(frozen=True)
class StoredSearch:
    """Results by rising count, with the names of the paints in the order of their errors: the source of the plots.

    The answer (``search.json``) and the state of a running search (``FILE.part``, written again after each count) hold
    the same results. ``default_count`` is None while the search runs; ``date`` is empty then. ``sha256`` is that of the
    database.
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
        known = f"{STORED_FORMAT} {STORED_VERSION} or {STATE_FORMAT} {STATE_VERSION}"
        reader.fail(f"this is no search of lobes ({known})", "format")
    if not isinstance(names, list) or not all(isinstance(name, str) for name in names):
        reader.fail("expected a list of names", "paints")
    results = tuple(result_from_json(item, len(names)) for item in reader.take_objects("results"))
    if any(a.count >= b.count for a, b in itertools.pairwise(results)):
        reader.fail("the counts do not rise", "results")
    if default is not None and default not in [result.count for result in results]:  # a value of any type
        reader.fail(f"there is no basis of {describe(default)} lobes", "default_count")
    return StoredSearch(tuple(names), results, str(sha256 or ""), default, str(date or ""))
