"""Paints of every kind by name or by file."""

from __future__ import annotations

from pathlib import Path

import pytest

from brdf_suite.documents.cook_torrance import CookTorrancePaint
from brdf_suite.documents.paint import Gloss, Measurement, Paint
from brdf_suite.documents.store import load_paint, save_paint
from brdf_suite.errors import DocumentError, FileError
from brdf_suite.pipeline.lobe_fit import PaintFitter
from brdf_suite.pipeline.material import load_document


def test_shipped_paints_table_1_and_files(tmp_path: Path) -> None:
    assert isinstance(load_document("blue"), Paint)
    table_1 = load_document("table1_blue")
    assert isinstance(table_1, CookTorrancePaint)
    path = tmp_path / "mine.brdfpaint"
    save_paint(table_1, path)
    assert load_document(path) == table_1


def test_what_is_not_there_is_reported_with_what_is() -> None:
    with pytest.raises(FileError, match="did you mean table1_ford_f8"):
        load_document("table1_ford_f9")
    with pytest.raises(FileError, match="brdf-suite list paints"):
        load_document("nothing")


def test_where_readings_are_wanted_another_kind_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "mine.brdfpaint"
    save_paint(load_document("table1_blue"), path)
    with pytest.raises(DocumentError, match="Cook-Torrance"):
        load_paint(path)


def test_each_reading_is_compared_with_the_lobes_of_its_own_light() -> None:
    labs = {15.0: (62.0, -4.0, -45.0), 45.0: (25.0, 4.0, -38.0), 110.0: (9.0, 8.0, -28.0)}
    one = tuple(Measurement(45.0, angle, lab) for angle, lab in labs.items())
    two = (*one, Measurement(15.0, 45.0, (25.0, 12.0, -37.0)))
    fitter = PaintFitter(time_limit_s=60.0)  # exact, however busy the machine is
    assert fitter.fit(Paint("one", one, Gloss(90.0))).notices == ()
    fitted = fitter.fit(Paint("two", two, Gloss(90.0)))
    assert any("fitted with the light at 45°" in notice for notice in fitted.notices)
    assert [row.delta_e_2000 < 0.1 for row in fitted.readings] == [True] * 4
    assert list(fitted.weights_by_light) == [15.0]
