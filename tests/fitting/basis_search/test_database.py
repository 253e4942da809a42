"""What a basis is searched for: the shipped paints, sampled."""

from __future__ import annotations

import os
import shutil
import sys
from pathlib import Path

import numpy as np
import pytest

from brdf_suite.documents.cook_torrance import CookTorrancePaint
from brdf_suite.errors import FileError, FittingError
from brdf_suite.fitting.basis_search.database import (
    BETWEEN_DEG,
    COAT_FROM_DEG,
    EDITS,
    Database,
    load_database,
    reflectances,
)
from brdf_suite.fitting.lobes.samples import BASE_GAMMAS_DEG
from brdf_suite.pipeline.material import load_shipped_paint
from brdf_suite.reflectance.designed.coat_lobe import CoatLobe
from brdf_suite.reflectance.designed.layers import Layers
from brdf_suite.reflectance.models.cook_torrance import CookTorrance


def test_it_holds_every_shipped_paint_and_those_of_table_1(whole: Database) -> None:
    assert len(whole.paints) >= 30
    assert len(set(whole.names)) == len(whole.names)
    assert sum(name.startswith("table1_") for name in whole.names) == 8
    assert {"blue", "matte_grey", "gold_green_shift"} <= set(whole.names)


def test_colours_are_compared_where_the_fit_has_no_sample_of_them() -> None:
    # At the measured angles the fit has the base alone, here it is the whole paint.
    assert {g for g in BETWEEN_DEG if g in BASE_GAMMAS_DEG} == {15.0, 45.0}
    assert COAT_FROM_DEG < 15.0


def test_the_energy_within_a_radius_is_that_of_the_coat() -> None:
    """A sharp coat's energy is F(45°), within a radius r it is 1 - exp(-(tilt/α)²), to the roundness of the ring."""
    black = CookTorrance(CookTorrancePaint("black", (0.0, 0.0, 0.0)))
    database = reflectances({"coat": Layers(black, CoatLobe(1.5, 0.01), 1.5)})
    [paint] = database.paints
    assert paint.energy == pytest.approx(0.0502, rel=0.01)
    assert (np.diff(paint.inside[:, 0]) >= 0.0).all()
    assert paint.inside[-1, 0] == pytest.approx(1.0, abs=1e-3)
    assert paint.inside[0, 0] < 0.02
    assert (paint.lab[:3, 0] == 0.0).all(), "nearer than the coat counts it is the black base"


def test_the_hash_is_of_names_and_bytes(few_paints: Path, few: Database, tmp_path: Path) -> None:
    copy = tmp_path / "copy"
    shutil.copytree(few_paints, copy)
    assert load_database(copy).sha256 == few.sha256
    (copy / "solid_red.brdfpaint").rename(copy / "solid_rot.brdfpaint")
    renamed = load_database(copy).sha256
    assert renamed != few.sha256
    text = (copy / "blue.brdfpaint").read_text()
    (copy / "blue.brdfpaint").write_text(text.replace('"Blue"', '"Blau"'))
    assert load_database(copy).sha256 not in (few.sha256, renamed)


@pytest.mark.skipif(sys.platform != "linux", reason="other systems take text alone as names of files")
def test_the_name_of_a_paints_file_may_be_no_text(few_paints: Path, few: Database, tmp_path: Path) -> None:
    copy = tmp_path / "copy"
    shutil.copytree(few_paints, copy)
    (copy / "blue.brdfpaint").rename(copy / os.fsdecode(b"blau \xff.brdfpaint"))
    found = load_database(copy)
    assert len(found.paints) == len(few.paints)
    assert found.sha256 != few.sha256


def test_what_is_no_database_is_reported(tmp_path: Path, few_paints: Path) -> None:
    with pytest.raises(FileError, match="there is no paint"):
        load_database(tmp_path)
    shutil.copytree(few_paints, tmp_path / "db")
    (tmp_path / "db" / "broken.brdfpaint").write_text("{")
    with pytest.raises(FileError, match=r"broken\.brdfpaint"):
        load_database(tmp_path / "db")
    text = (few_paints / "blue.brdfpaint").read_text().replace('"gu_20": 90.0', '"gu_20": 180.0')
    (tmp_path / "db" / "broken.brdfpaint").write_text(text)
    with pytest.raises(FileError, match=r"cannot be part of the database.*180"):
        load_database(tmp_path / "db")


class Negative:
    def eval(self, wi: np.ndarray, wo: np.ndarray) -> np.ndarray:
        return np.full((*np.broadcast_shapes(np.shape(wi), np.shape(wo))[:-1], 3), -0.1)


def test_a_negative_reflectance_is_refused_by_name() -> None:
    with pytest.raises(FittingError, match=r"odd: .* negative"):
        reflectances({"odd": Layers(Negative(), CoatLobe(1.5, 0.01), 1.5)})


def test_paints_of_three_readings_have_an_edit_of_the_middle_one(whole: Database) -> None:
    edited = [name.removesuffix(", edited") for name in whole.names if name.endswith(", edited")]
    assert len(edited) >= 20
    assert not any(name.startswith("table1_") for name in edited)
    assert not set(edited) & {"gold_green_shift", "teal_violet_shift", "solid_red"}
    middle = BETWEEN_DEG.index(45.0)
    seen = set()
    for name in edited:
        bright, own, dark = (load_shipped_paint(name).lab_at(angle)[0] for angle in (15.0, 45.0, 110.0))
        found = whole.paints[whole.names.index(f"{name}, edited")].lab[middle, 0]
        # The whole paint is read, so that what was asked comes back to the rounding of the coat's mean.
        share = min(EDITS, key=lambda one: abs(dark + one * (bright - dark) - found))
        assert found == pytest.approx(dark + share * (bright - dark), abs=0.5), name
        assert abs(found - own) > 4.0
        seen.add(share)
    assert seen == set(EDITS)
