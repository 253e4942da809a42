"""Searches read back from files, ended or still running, and the hash by which they know their paints."""

from __future__ import annotations

import json
import shutil
from pathlib import Path

import pytest

from brdf_suite.errors import DocumentError
from brdf_suite.fitting.basis_search.database import Database, database_sha256
from brdf_suite.fitting.basis_search.document import load_search, save_state
from brdf_suite.fitting.lobes.basis import STORED_NAME, default_basis
from brdf_suite.resources import resource


def test_the_packaged_search_and_a_running_one_are_read(tmp_path: Path) -> None:
    path = Path(str(resource("basis", STORED_NAME)))
    search, plain = load_search(path), json.loads(path.read_text())
    assert search.default_count == plain["default_count"]
    assert search.results[search.default_count - 1].exponents == default_basis().exponents
    assert list(search.paints) == plain["paints"]
    assert [result.errors for result in search.results] == [tuple(row["errors"]) for row in plain["results"]]
    assert (search.sha256, search.date) == (
        plain["provenance"]["database_sha256"],
        plain["provenance"]["date"],
    )
    state = tmp_path / "basis.json.part"
    settings = {"database_sha256": "abc", "paints": list(search.paints), "starts": 4}
    save_state(state, settings, search.results[:3])
    running = load_search(state)
    assert running.results == search.results[:3]
    assert (running.default_count, running.date, running.sha256) == (None, "", "abc")


def test_the_hash_of_a_folder_is_that_of_its_database(few_paints: Path, few: Database) -> None:
    assert database_sha256(few_paints) == few.sha256


def test_a_paint_is_the_same_in_another_version_of_its_file_and_not_with_another_name(
    few_paints: Path, tmp_path: Path
) -> None:
    copy = tmp_path / "copy"
    shutil.copytree(few_paints, copy)
    path = next(copy.rglob("*.brdfpaint"))
    paint = json.loads(path.read_text())
    path.write_text(json.dumps({**paint, "version": paint["version"] + 1}))
    assert database_sha256(copy) == database_sha256(few_paints)
    path.write_text(json.dumps({**paint, "notes": "another"}))
    assert database_sha256(copy) != database_sha256(few_paints)
    path.write_bytes(b"\xff no paint")
    assert len(database_sha256(copy)) == 64  # reported by its reader


@pytest.mark.parametrize(
    ("change", "place"),
    [
        ({"format": "lobe_weights"}, "format"),
        ({"paints": "blue"}, "paints"),
        ({"default_count": 99}, "default_count"),
        ({"default_count": [3]}, "default_count"),
        ({"results": []}, "default_count"),
    ],
)
def test_what_is_no_search_is_reported_with_its_place(
    tmp_path: Path, change: dict[str, object], place: str
) -> None:
    plain = json.loads(resource("basis", STORED_NAME).read_text())
    path = tmp_path / "search.json"
    path.write_text(json.dumps(plain | change))
    with pytest.raises(DocumentError) as reported:
        load_search(path)
    assert reported.value.place == place


def test_counts_out_of_order_are_reported(tmp_path: Path) -> None:
    plain = json.loads(resource("basis", STORED_NAME).read_text())
    path = tmp_path / "search.json"
    path.write_text(json.dumps(plain | {"results": plain["results"][::-1]}))
    with pytest.raises(DocumentError, match="counts"):
        load_search(path)
