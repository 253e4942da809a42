"""Paints of every kind by name or by file."""

from __future__ import annotations

from pathlib import Path

import pytest

from brdf_suite.documents.cook_torrance import CookTorrancePaint
from brdf_suite.documents.paint import Paint
from brdf_suite.documents.store import save_paint
from brdf_suite.errors import DocumentError, FileError
from brdf_suite.pipeline.scene import find_any_paint, find_paint


def test_shipped_paints_table_1_and_files(tmp_path: Path) -> None:
    assert isinstance(find_any_paint("blue"), Paint)
    table_1 = find_any_paint("table1_blue")
    assert isinstance(table_1, CookTorrancePaint)
    path = tmp_path / "mine.brdfpaint"
    save_paint(table_1, path)
    assert find_any_paint(path) == table_1


def test_what_is_not_there_is_told_with_what_is() -> None:
    with pytest.raises(FileError, match="table1_ford_f8"):
        find_any_paint("nothing")


def test_where_readings_are_wanted_another_kind_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "mine.brdfpaint"
    save_paint(find_any_paint("table1_blue"), path)
    with pytest.raises(DocumentError, match="Cook-Torrance"):
        find_paint(path)
