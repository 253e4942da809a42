"""``brdf-suite fit-cook-torrance``: a paint that opens again, starts that are kept, errors that are named."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from brdf_suite.cli.main import CANCELLED, FAILED, main
from brdf_suite.documents.store import load_any_paint
from brdf_suite.errors import Cancelled
from brdf_suite.files.measured.brdftable import read_brdftable, write_brdftable
from brdf_suite.fitting.cook_torrance import fit
from brdf_suite.geometry.directions import from_half_angle_coordinates
from brdf_suite.reflectance.models.cook_torrance import CookTorrance
from brdf_suite.reflectance.models.table_1 import TABLE_1
from brdf_suite.reflectance.tabulated.half_angle_grid import HalfAngleGrid
from brdf_suite.reflectance.tabulated.isotropic import IsotropicTable
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples

TRUTH = TABLE_1["table1_blue_matte"]
QUICK = ["--starts", "3", "--samples", "1500"]


@pytest.fixture(scope="module")
def table(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("table") / "blue matte.brdftable"
    value = IsotropicTable.from_reflectance(CookTorrance(TRUTH), HalfAngleGrid(45, 30, 40))
    write_brdftable(value, path)
    return path


def test_the_paint_of_a_table_has_its_parameters_and_opens_again(table: Path, tmp_path: Path, capsys) -> None:
    out = tmp_path / "paint.brdfpaint"
    assert main(["fit-cook-torrance", str(table), "-o", str(out), "--json", *QUICK]) == 0
    reported = json.loads(capsys.readouterr().out)
    assert reported["file"] == str(out)
    assert reported["errors"]["l1_mean"] < 0.01
    assert reported["errors"]["values"] == 3 * np.count_nonzero(read_brdftable(table).measured_mask())
    paint = load_any_paint(out)
    assert paint.name == "blue matte"
    assert [lobe.m for lobe in paint.lobes] == pytest.approx([lobe.m for lobe in TRUTH.lobes], rel=0.01)
    assert paint.kd == pytest.approx(TRUTH.kd, rel=0.01)
    assert sorted(p.name for p in tmp_path.iterdir()) == ["paint.brdfpaint"]
    assert main(["measure", str(out), "--json"]) == 0


def test_flakes_are_tilted_as_the_lobe_says(table: Path, tmp_path: Path, capsys) -> None:
    out = tmp_path / "paint.brdfpaint"
    assert main(["fit-cook-torrance", str(table), "-o", str(out), "--flake-size", "30", *QUICK]) == 0
    paint = load_any_paint(out)
    assert paint.flakes.size_um == 30.0
    assert paint.flakes.roughness in [lobe.m for lobe in paint.lobes]
    assert paint.flakes.density_per_mm2 * np.pi * 0.03**2 / 4 == pytest.approx(1.0, rel=0.01)
    assert main(["measure", str(out), "--json"]) == 0
    capsys.readouterr()
    for wrong, word in (("-1", "size_um"), ("30", "-o")):
        named = ["-o", str(tmp_path / "other.brdfpaint")] if wrong == "-1" else []
        assert main(["fit-cook-torrance", str(table), *named, "--flake-size", wrong, *QUICK]) == FAILED
        assert word in capsys.readouterr().err
    assert sorted(p.name for p in tmp_path.iterdir()) == ["paint.brdfpaint"]


def test_starts_are_kept_and_a_broken_fit_goes_on(
    table: Path, tmp_path: Path, capsys, monkeypatch: pytest.MonkeyPatch
) -> None:
    out, calls = tmp_path / "paint.brdfpaint", []
    whole = fit.search

    def search(problem, x, loss, deltas, steps, tick=None):
        calls.append(deltas)
        if len(calls) == 3:
            raise Cancelled
        return whole(problem, x, loss, deltas, steps, tick)

    monkeypatch.setattr(fit, "search", search)
    arguments = ["fit-cook-torrance", str(table), "-o", str(out), *QUICK]
    assert main(arguments) == CANCELLED
    assert [p.name for p in tmp_path.iterdir()] == ["paint.brdfpaint.starts"]
    before = len(calls)
    assert main(arguments) == 0
    # Of three starts two were done; then come those that are refined.
    assert calls[before : before + 2] == [fit.COARSE, fit.FINE]
    assert out.exists()
    assert [p.name for p in tmp_path.iterdir()] == ["paint.brdfpaint"]
    capsys.readouterr()


def test_the_models_stand_side_by_side_and_any_goes_into_a_table(tmp_path: Path, capsys) -> None:
    h, d, p = np.random.default_rng(0).random((3, 900))
    wi, wo = from_half_angle_coordinates(1.3 * h**2, 0.0, 1.3 * d, np.pi * p)
    seen = (wi[:, 2] > 0.2) & (wo[:, 2] > 0.2)
    wi, wo = wi[seen], wo[seen]
    file, out = tmp_path / "samples.brdftable", tmp_path / "lobes.brdftable"
    write_brdftable(ScatteredSamples(wi, wo, CookTorrance(TRUTH).eval(wi, wo)), file)
    arguments = ["fit-cook-torrance", str(file), "-o", str(out), "--model", "ggx", "--compare", "--json"]
    assert main([*arguments, "--lobes", "2", "--starts", "1"]) == 0
    reported = json.loads(capsys.readouterr().out)
    assert list(reported["models"]) == ["ggx", "cook-torrance", "ggx-clearcoat"]
    assert all(0.0 < row["l1_mean"] < 1.0 for row in reported["models"].values())
    assert isinstance(read_brdftable(out), IsotropicTable)


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["nothing_of_that_name"], "nothing_of_that_name"),
        (["{table}", "-o", "{folder}/a.exr"], ".brdfpaint"),
        (["{table}", "-o", "{folder}/a.brdfpaint", "--model", "ggx"], "ggx"),
        (["{table}", "-o", "{folder}/none/a.brdfpaint"], "folder"),
        (["{table}", "-o", "{table}"], "exists"),
        (["{table}", "--lobes", "0"], "lobes"),
        (["{table}", "--loss", "l9"], "loss"),
        (["{table}", "--state", "{table}"], "kept starts"),
    ],
    ids=["name", "ending", "model", "folder", "exists", "lobes", "loss", "state"],
)
def test_what_is_wrong_is_named_and_nothing_is_written(
    table: Path, tmp_path: Path, capsys, arguments: list[str], said: str
) -> None:
    before = table.read_bytes()
    filled = [word.format(table=table, folder=tmp_path) for word in arguments]
    assert main(["fit-cook-torrance", *filled, *QUICK]) == FAILED
    assert said in capsys.readouterr().err
    assert not list(tmp_path.iterdir())
    assert table.read_bytes() == before
