"""The fit of lobes to what files hold: tables with their coverage, samples, materials; its errors, plot and state."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from brdf_suite.cli.main import main
from brdf_suite.errors import FileError
from brdf_suite.files.measured.brdftable import write_brdftable
from brdf_suite.fitting.cook_torrance import Settings
from brdf_suite.fitting.cook_torrance.fit import StartsFile
from brdf_suite.fitting.cook_torrance.reflectance_fit import FileFit, fit_cook_torrance, fit_plot
from brdf_suite.geometry.directions import spherical
from brdf_suite.pipeline.material import load_material
from brdf_suite.reflectance.models.cook_torrance import CookTorrance
from brdf_suite.reflectance.models.table_1 import TABLE_1
from brdf_suite.reflectance.tabulated.half_angle_grid import HalfAngleGrid
from brdf_suite.reflectance.tabulated.isotropic import Coverage, IsotropicTable

TRUTH = TABLE_1["table1_blue"]
GRID = HalfAngleGrid(45, 30, 40)
QUICK = Settings(starts=3, samples=1500)


@pytest.fixture(scope="module")
def table() -> IsotropicTable:
    return IsotropicTable.from_reflectance(CookTorrance(TRUTH), GRID)


@pytest.fixture(scope="module")
def found(table: IsotropicTable) -> FileFit:
    return fit_cook_torrance("blue", table, QUICK)


def test_errors_are_over_every_measured_bin(found: FileFit, table: IsotropicTable) -> None:
    mask = table.measured_mask()
    assert found.errors.values == 3 * np.count_nonzero(mask)
    assert found.errors_within.values < found.errors.values
    data, fitted = [], []
    for h in range(GRID.theta_h):
        wi, wo = (w[mask[h]] for w in GRID.pairs(h))
        data.append(table.values[h][mask[h]])
        fitted.append(found.fit.eval(wi, wo))
    logs = np.log(np.concatenate(fitted) / np.concatenate(data))
    assert found.errors.l1_mean == pytest.approx(np.abs(logs).mean())
    assert found.errors.log_rms == pytest.approx(np.sqrt((logs**2).mean()))
    assert found.errors.l1_mean < 1e-3


def test_the_plot_lies_on_the_table_and_has_its_holes(found: FileFit, table: IsotropicTable) -> None:
    plot = found.plot
    known = np.isfinite(plot.measured)
    assert plot.measured.shape == (len(plot.theta_d_deg), len(plot.theta_h_deg), 3)
    assert known.any(axis=(1, 2)).all()
    assert np.allclose(plot.fitted[known], plot.measured[known], rtol=2e-3)
    whole = np.isfinite(plot.fitted)
    assert np.allclose(plot.parts.sum(axis=0)[whole], plot.fitted[whole])
    # With every second row of θd and most of φd gone, there still are dots.
    holes = np.ones(GRID.shape, np.bool_)
    holes[:, ::2, 3::7] = False
    sparse = replace(table, holes=holes)
    dots = np.isfinite(fit_plot(sparse, found.fit).measured).all(axis=2)
    assert dots.sum(axis=1).min() > 10


def test_bins_that_are_hardly_known_count_little() -> None:
    exact = IsotropicTable.from_reflectance(CookTorrance(TRUTH), GRID)
    wrong = np.arange(GRID.phi_d) % 4 != 0
    values = exact.values.copy()
    values[:, :, wrong] *= 3.0
    deviation = np.where(wrong, np.float32(30.0), np.float32(0.01))
    shape = np.broadcast_to(deviation, GRID.shape).astype(np.float32)
    coverage = Coverage(np.ones(GRID.shape, np.float32), shape)
    fit = fit_cook_torrance("blue", replace(exact, values=values, coverage=coverage), QUICK).fit
    assert fit.kd == pytest.approx(TRUTH.kd, rel=0.02)
    blind = fit_cook_torrance("blue", replace(exact, values=values), QUICK).fit
    assert blind.kd == pytest.approx(3.0 * np.array(TRUTH.kd), rel=0.05)


def test_lobes_that_send_back_more_than_they_get_are_reported(table: IsotropicTable, found: FileFit) -> None:
    assert not any("times the light" in notice for notice in found.notices)
    bright = replace(table, values=table.values * 20.0)
    notices = fit_cook_torrance("bright", bright, replace(QUICK, starts=1)).notices
    assert any("times the light" in notice for notice in notices)


@pytest.mark.parametrize("name", ["krylon_blue.brdf", "vch_golden_yellow_rgb.bsdf"])
def test_real_files_become_paints(name: str, shared_data: Path) -> None:
    found = fit_cook_torrance(Path(name).stem, load_material(shared_data / "brdf" / name).reflectance, QUICK)
    assert found.paint is not None
    assert found.paint.name == Path(name).stem
    assert 0.05 < found.errors_within.l1_mean < 0.4
    wi, wo = spherical(0.7, np.pi), spherical(np.array([0.2, 0.68, 1.0]), 0.0)
    colours = CookTorrance(found.paint).eval(wi, wo)
    blue = name.startswith("krylon")
    assert np.all(colours[[0, 2], 2] > colours[[0, 2], 0]) == blue
    plot = found.plot
    assert np.isfinite(plot.measured).any()
    assert np.array_equal(np.isfinite(plot.measured), np.isfinite(plot.fitted))


def test_a_table_of_too_little_is_named_with_its_file(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    holes = np.ones(GRID.shape, np.bool_)
    holes[3, 2, :2] = False
    path = tmp_path / "little.brdftable"
    write_brdftable(IsotropicTable(np.ones((*GRID.shape, 3), np.float32), holes), path)
    assert main(["fit-cook-torrance", str(path)]) != 0
    assert re.search(r"little\.brdftable.*cannot determine", capsys.readouterr().err)
    write_brdftable(IsotropicTable(np.zeros((*GRID.shape, 3), np.float32)), path)
    assert main(["fit-cook-torrance", str(path)]) != 0
    assert re.search(r"little\.brdftable.*black", capsys.readouterr().err)


def test_kept_starts_are_found_by_their_fit_alone_and_no_other_file_is_touched(tmp_path: Path) -> None:
    kept = StartsFile(tmp_path / "a.starts")
    assert kept.load("one") == {}
    kept.save("one", {0: [1.0, 2.0], 3: [0.5]})
    assert kept.load("one") == {0: [1.0, 2.0], 3: [0.5]}
    assert kept.load("other") == {}
    other = tmp_path / "b.starts"
    for content in (b'{"format": "mine"}', b"\xff\xfe", b"[1"):
        other.write_bytes(content)
        with pytest.raises(FileError, match="kept starts"):
            StartsFile(other).load("one")
        assert other.read_bytes() == content
    kept.remove()
    assert kept.load("one") == {}
