"""Lobes for anything by name or by file, and how far they are from it."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from brdf_suite.cli.main import main
from brdf_suite.documents.cook_torrance import Clearcoat, CookTorrancePaint
from brdf_suite.documents.store import save_paint
from brdf_suite.errors import Cancelled, FileError, FittingError, UnreachableError
from brdf_suite.files.measured import FORMATS, write_measured
from brdf_suite.fitting.lobes.basis import LobeBasis
from brdf_suite.fitting.lobes.fitter import LobeFitter
from brdf_suite.fitting.lobes.settings import FitSettings
from brdf_suite.geometry.directions import aspecular_view, illumination
from brdf_suite.pipeline.fit_errors import held_out_errors
from brdf_suite.pipeline.lobe_fit import EXPONENTS_ALONE, PaintFitter, fit_material
from brdf_suite.pipeline.material import Material, load_material, load_shipped_paint
from brdf_suite.reflectance.designed.build import build_paint
from brdf_suite.reflectance.designed.layers import split_layers
from brdf_suite.reflectance.models.coated import Coated
from brdf_suite.reflectance.models.cook_torrance import CookTorrance
from brdf_suite.reflectance.models.lambertian import Lambertian
from brdf_suite.reflectance.models.table_1 import TABLE_1
from brdf_suite.reflectance.tabulated.half_angle_grid import HalfAngleGrid
from brdf_suite.reflectance.tabulated.isotropic import IsotropicTable
from brdf_suite.reflectance.tensor.tabulate import tabulate


def test_a_designed_paint_keeps_its_fit() -> None:
    found = fit_material(load_material("blue"), errors=True)
    assert found.kind == "designed"
    edited = PaintFitter(time_limit_s=1.0).fit(load_shipped_paint("blue"))
    np.testing.assert_array_equal(found.weights.kdd, edited.weights.kdd)
    assert found.worst_delta_e == edited.worst_delta_e < 0.2
    assert found.weights.base_under_coat
    assert found.held_out is not None
    assert found.held_out.relative_rms < 0.2


@pytest.mark.parametrize("name", TABLE_1)
def test_the_paints_of_table_1_meet_their_readings(name: str) -> None:
    found = fit_material(load_material(name), errors=True)
    assert found.kind == "cook_torrance"
    assert not found.weights.base_under_coat
    # Round lobes cannot be narrower across the plane than in it, which a lobe of slope .075 is (Blue Matte).
    limit = 2.0 if name == "table1_blue_matte" else 1.0
    assert max(row.delta_e_2000 for row in found.angles if row.fitted) < limit
    assert [row.aspecular_deg for row in found.angles if row.fitted] == [15.0, 45.0, 110.0]
    # A sharp lobe reflects about 4 ks F at any angle.
    light = float(found.weights.coat_energy()[1])
    sharp = [lobe for lobe in TABLE_1[name].lobes if lobe.m <= 0.1]
    assert 0.6 < light / sum(4.0 * lobe.ks[1] * lobe.r for lobe in sharp) < 1.6


def test_layers_are_called_what_they_are_and_keep_their_notices() -> None:
    paint = build_paint(load_shipped_paint("blue"))
    fit = fit_material(Material("blue", replace(paint, notices=("made up",)), notices=("made up",)))
    assert fit.kind == "designed"
    assert fit.notices == ("made up",)
    coated = fit_material(Material("coated", Coated(Lambertian((0.4, 0.2, 0.1))), notices=("before",)))
    assert coated.kind == "layered"
    assert coated.notices == ("before",)
    assert (
        fit_material(Material("coated", Coated(CookTorrance(TABLE_1["table1_white"])))).kind
        == "cook_torrance"
    )


def test_a_fit_of_measured_data_can_be_cancelled_while_it_works(shared_data: Path) -> None:
    steps: list[str] = []

    def cancel(_fraction: float, what: str) -> None:
        steps.append(what)
        if steps.count("fitting") == 3:
            raise Cancelled

    with pytest.raises(Cancelled):
        fit_material(
            load_material(shared_data / "brdf" / "vch_golden_yellow_rgb.bsdf"), errors=True, progress=cancel
        )
    assert steps == ["fitting", "fitting", "fitting"]


def test_a_clearcoat_of_its_own_is_the_coat(tmp_path: Path) -> None:
    path = tmp_path / "coated.brdfpaint"
    save_paint(replace(TABLE_1["table1_white"], clearcoat=Clearcoat(1.6, 0.005)), path)
    found = fit_material(load_material(path), errors=True)
    assert found.weights.ior == 1.6
    assert found.weights.base_under_coat


def test_without_a_sharp_lobe_there_is_no_coat() -> None:
    paint = CookTorrancePaint("matt", (0.1, 0.2, 0.3))
    found = fit_material(Material("matt", CookTorrance(paint)))
    assert found.weights.ior == 1.0
    assert not found.weights.kg.any()
    assert any("no sharp lobe" in notice for notice in found.notices)


def test_a_table_is_fitted_undivided(tmp_path: Path) -> None:
    """Every format that can hold a table: what is read back is fitted, and near to what was written."""
    paint = CookTorrance(TABLE_1["table1_white"])
    table = IsotropicTable.from_reflectance(paint, HalfAngleGrid(90, 45, 60))
    found = {}
    for known in FORMATS:
        if known.write is None or known.name not in ("brdftable", "merl", "rgl"):
            continue
        path = tmp_path / ("table" + known.endings[0])
        stored = {"brdftable": table, "rgl": tabulate(paint, incidences=36, resolution=96)}
        write_measured(stored.get(known.name, paint), path)
        found[known.name] = fit_material(load_material(path), errors=True)
    assert len(found) == 3
    for fit in found.values():
        assert fit.kind == "measured"
        assert fit.split_determined
        assert fit.held_out is not None
        assert fit.held_out.relative_rms < 0.15
        wi, wo = illumination(45.0), aspecular_view(45.0, 60.0)
        np.testing.assert_allclose(fit.weights.eval(wi, wo), paint.eval(wi, wo), rtol=0.05)


def test_measured_files_are_judged_where_the_fit_did_not_look(shared_data: Path) -> None:
    for name, relative, cube_root in (
        ("paper_white_rgb.bsdf", 0.4, 0.05),
        ("vch_golden_yellow_rgb.bsdf", 0.7, 0.06),
        ("krylon_blue.brdf", 1.1, 0.05),
    ):
        found = fit_material(load_material(shared_data / "brdf" / name), errors=True)
        assert found.held_out is not None
        assert 0.0 < found.held_out.relative_rms < relative
        assert 0.0 < found.held_out.figures.cube_root_rms < cube_root
        assert found.angles
        assert max(row.delta_e_2000 for row in found.angles if 30.0 < row.aspecular_deg < 100.0) < 3.0


def test_scattered_angles_are_those_of_samples(shared_data: Path) -> None:
    """No colour is interpolated: every judged geometry is a measured one, with its own angles."""
    found = fit_material(load_material(shared_data / "brdf" / "cayman.brdf"))
    samples = found.reflectance
    assert {round(row.illumination_deg) for row in found.angles} == {40}
    for row in found.angles:
        at = aspecular_view(row.illumination_deg, row.aspecular_deg)
        cosine = (
            samples.wo[np.abs(samples.wi[:, 2] - np.cos(np.radians(row.illumination_deg))) < 1e-6][:, 2]
            - at[2]
        )
        assert np.abs(cosine).min() < 0.1
    assert not any("interpolated" in notice for notice in found.notices)


def test_the_folds_never_see_what_they_are_judged_on(shared_data: Path) -> None:
    """A sample of nonsense worsens the held-out error and is not followed."""
    samples = fit_material(load_material(shared_data / "brdf" / "krylon_blue.brdf"))
    before = held_out_errors(samples.reflectance, samples.weights)
    values = np.array(samples.reflectance.values)
    values[700] = 1_000.0
    after = held_out_errors(replace(samples.reflectance, values=values), samples.weights)
    assert before is not None
    assert after is not None
    assert after.figures.cosine_rms > 5.0 * before.figures.cosine_rms


def test_of_very_many_samples_a_share_judges(shared_data: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    found = fit_material(load_material(shared_data / "brdf" / "krylon_blue.brdf"), errors=True)
    monkeypatch.setattr("brdf_suite.pipeline.fit_errors._MOST_IN_A_FOLD", 400)
    fewer = held_out_errors(found.reflectance, found.weights)
    assert found.held_out is not None
    assert fewer is not None
    assert fewer.pairs == found.held_out.pairs
    assert fewer.figures.cube_root_rms == pytest.approx(found.held_out.figures.cube_root_rms, rel=0.5)
    assert fewer.figures.cube_root_rms != found.held_out.figures.cube_root_rms


def test_few_samples_have_no_held_out_error(shared_data: Path) -> None:
    found = fit_material(load_material(shared_data / "brdf" / "bird_example.json"), errors=True)
    assert found.held_out is None
    assert found.angles == ()
    assert found.worst_delta_e is None
    assert not found.split_determined


def test_another_basis() -> None:
    settings = FitSettings(LobeBasis((2.0, 20.0, 2_000.0)))
    for name in ("blue", "table1_white"):
        found = fit_material(load_material(name), settings)
        assert found.weights.exponents.tolist() == [2.0, 20.0, 2_000.0]
        assert found.settings == settings


def test_weighting_and_diffuse_term_are_those_of_the_settings() -> None:
    settings = FitSettings(LobeBasis((2.0, 20.0, 2_000.0)), "solid angle", "measured")
    fitter = LobeFitter(settings.basis, weighting="solid angle", diffuse="measured", time_limit_s=1.0)
    material = load_material("blue")
    expected = fitter.fit(split_layers(material.reflectance)).weights
    fitter.close()
    found = fit_material(material, settings)
    np.testing.assert_allclose(found.weights.kdd, expected.kdd, rtol=1e-9)
    np.testing.assert_allclose(found.weights.kg, expected.kg, rtol=1e-9)
    for other in (replace(settings, diffuse="joint"), replace(settings, weighting="absolute")):
        assert not np.allclose(fit_material(material, other).weights.kdd, expected.kdd, rtol=1e-3, atol=0.0)


def test_data_without_layers_take_the_exponents_alone_and_say_so(shared_data: Path) -> None:
    basis = LobeBasis((2.0, 20.0, 2_000.0))
    material = load_material(shared_data / "brdf" / "bird_example.json")
    plain, chosen = (
        fit_material(material, FitSettings(basis, weighting)) for weighting in ("absolute", "relative")
    )
    np.testing.assert_array_equal(plain.weights.kdd, chosen.weights.kdd)
    assert EXPONENTS_ALONE not in plain.notices
    assert EXPONENTS_ALONE in chosen.notices


@pytest.mark.parametrize("bad", [np.nan, -1.0])
def test_bad_values_are_refused_by_name(bad: float) -> None:
    class Bad:
        def eval(self, wi: np.ndarray, wo: np.ndarray) -> np.ndarray:
            return np.full(np.broadcast_shapes(wi.shape, wo.shape), bad)

    with pytest.raises(FittingError, match="cannot be fitted"):
        fit_material(Material("bad", Bad()))


def test_what_is_not_there_or_no_paint_is_reported(tmp_path: Path) -> None:
    with pytest.raises(FileError, match="did you mean table1_white"):
        fit_material(load_material("table1_whit"), errors=True)
    noise = tmp_path / "noise.binary"
    noise.write_bytes(bytes(range(256)) * 20)
    with pytest.raises(FileError, match=r"noise\.binary"):
        fit_material(load_material(noise), errors=True)
    path = tmp_path / "dull.brdfpaint"
    path.write_text(json.dumps(_unreachable()))
    with pytest.raises(UnreachableError, match=r"dull\.brdfpaint"):
        fit_material(load_material(path), errors=True)


def _unreachable() -> dict[str, object]:
    angles = {15.0: (62.0, -4.0, -45.0), 45.0: (25.0, 4.0, -38.0), 110.0: (9.0, 8.0, -28.0)}
    return {
        "format": "brdfpaint",
        "version": 1,
        "kind": "aspecular",
        "name": "dull",
        "measurements": [
            {"illumination_deg": 45.0, "aspecular_deg": angle, "lab": list(lab)}
            for angle, lab in angles.items()
        ],
        "gloss": {"gu_20": 199.0},
    }


def test_the_fit_as_json_is_whole(shared_data: Path, capsys: pytest.CaptureFixture[str]) -> None:
    for name in ("blue", "table1_blue", str(shared_data / "brdf" / "cayman.brdf")):
        assert main(["fit", name, "--json"]) == 0
        facts = json.loads(capsys.readouterr().out)
        count = len(facts["exponents"])
        assert np.shape(facts["kdd"]) == np.shape(facts["kg"]) == (count, 3)
        assert facts["held_out"]["figures"]["cube_root_rms"] > 0.0
        assert facts["l1_relative"]
        assert facts["kind"] in ("designed", "cook_torrance", "measured")


def test_the_fit_as_text(shared_data: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["fit", str(shared_data / "brdf" / "bird_example.json")]) == 0
    assert "undetermined" in capsys.readouterr().err  # a notice, beside the result
    assert main(["fit", "table1_white"]) == 0
    text = capsys.readouterr().out
    for words in ("KDD", "L1 error, coat", "where the fit did not look", "ΔE00", "(not fitted)"):
        assert words in text


@pytest.mark.usefixtures("shared_cache")
def test_measured_and_cook_torrance_paints_render(
    shared_data: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    from PIL import Image

    pixels = {}
    measured = [str(shared_data / "brdf" / name) for name in ("krylon_blue.brdf", "paper_white_rgb.bsdf")]
    for name in ("table1_blue", *measured):
        out = tmp_path / f"{Path(name).name}.png"
        assert main(["render", name, "-o", str(out), "--size", "96x54", "--json"]) == 0
        assert json.loads(capsys.readouterr().out)["paint"]
        with Image.open(out) as image:
            pixels[Path(name).stem] = np.asarray(image.convert("RGB"), float)[20:40, 30:66].mean(axis=(0, 1))
    for blue in ("table1_blue", "krylon_blue"):
        assert pixels[blue][2] > 1.5 * pixels[blue][0]
    assert pixels["paper_white_rgb"].min() > pixels["krylon_blue"].max()
