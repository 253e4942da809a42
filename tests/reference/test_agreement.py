"""The comparison of the two renderers: its figures show real differences, are kept, and become a page."""

from __future__ import annotations

import json
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from brdf_suite.cli.main import main
from brdf_suite.errors import FileError, MissingExtraError, ValueRangeError
from brdf_suite.files.images.environments import write_exr
from brdf_suite.files.measured.astm import write_astm
from brdf_suite.fitting.lobes.settings import FitSettings
from brdf_suite.geometry.directions import spherical
from brdf_suite.lighting.latlong import column_angles, direction, ring_angles
from brdf_suite.pipeline.lobe_fit import fit_material
from brdf_suite.pipeline.material import load_material
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples
from brdf_suite.tracing.agreement import comparison as agreement
from brdf_suite.tracing.agreement.comparison import (
    LOBES,
    Order,
    class_of,
    compare,
    errors_of,
    flip_of,
    summary,
)
from brdf_suite.tracing.agreement.flakes import block_means, compare_flakes
from brdf_suite.tracing.agreement.forms import DEFAULT_FORM, FORMS, HELD_OUT_FORM, fit_for
from brdf_suite.tracing.agreement.page import check_page, groups, page, write_page

SIZE = (32, 28)


@pytest.fixture(scope="module")
def light(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A soft sky over a dark ground."""
    d = direction(ring_angles(32)[:, None], column_angles(64)[None])
    path = tmp_path_factory.mktemp("light") / "soft.exr"
    write_exr(path, np.asarray(0.6 + 0.5 * d[..., 1:2] + np.array([0.1, 0.1, 0.2]) * d[..., :1], np.float32))
    return path


@pytest.fixture(scope="module")
def sun(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A small bright light in an even sky."""
    d = direction(ring_angles(64)[:, None], column_angles(128)[None])
    there = d @ (np.array([2.0, 2.0, 1.0]) / 3.0) > np.cos(np.radians(3.0))
    path = tmp_path_factory.mktemp("light") / "sun.exr"
    write_exr(path, np.where(there[..., None], 500.0, 0.3).repeat(3, axis=-1).astype(np.float32))
    return path


def test_flip_and_delta_e_of_pictures() -> None:
    pytest.importorskip("flip_evaluator", reason="the extra reference is not installed")
    rng = np.random.default_rng(1)
    first = rng.random((40, 40, 3))
    assert flip_of(first, first).max() == 0.0
    inside = np.zeros((40, 40), bool)
    inside[10:20] = True
    other = first.copy()
    other[~inside] = 0.0
    same = errors_of(other, first, inside)
    assert (same.mean, same.p99) == (0.0, 0.0)
    brighter = errors_of(np.clip(first + 0.1, 0, 1), first, inside)
    assert brighter.mean > 1.0
    assert brighter.flip > 0.02
    assert errors_of(first, first, np.zeros((40, 40), bool)) == agreement.PictureErrors(0.0, 0.0, 0.0, 0.0)


def test_without_flip_it_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "flip_evaluator", None)
    with pytest.raises(
        MissingExtraError, match=r"needs FLIP, which is not installed; `.*reference` installs it"
    ):
        flip_of(np.zeros((8, 8, 3)), np.zeros((8, 8, 3)))


@pytest.mark.usefixtures("variant")
def test_the_paint_is_judged_without_the_other_materials(light: Path) -> None:
    pytest.importorskip("flip_evaluator", reason="the extra reference is not installed")
    order = Order(["copper"], [str(light)], SIZE, 64, (DEFAULT_FORM,))
    (sphere,) = compare(order)
    assert sphere.elsewhere == {}
    (car,) = compare(replace(order, surface="car", size=(64, 40)))
    paint, other = car.errors[DEFAULT_FORM], car.elsewhere[DEFAULT_FORM]
    assert 0.0 < paint.mean < 3.0
    assert (
        other.mean > 1.5 * paint.mean
    )  # glass, grille and wheels mirror the car, which baked light cannot show
    assert car.to_json()["elsewhere"][DEFAULT_FORM]["de00_mean"] == other.mean


@pytest.mark.usefixtures("variant")
def test_a_bound_of_the_noise_is_met_by_more_samples(light: Path) -> None:
    pytest.importorskip("flip_evaluator", reason="the extra reference is not installed")
    order = Order(["copper"], [str(light)], SIZE, 16, (DEFAULT_FORM,))
    (noisy,) = compare(order)
    assert noisy.samples == 16
    bound = 0.5 * noisy.noise.mean
    (better,) = compare(replace(order, noise=bound))
    assert better.noise.mean <= bound
    assert better.samples > 32
    assert f"The two traces ({better.samples} samples)" in page([better], replace(order, noise=bound))
    (most,) = compare(replace(order, noise=1e-6))
    assert most.samples == agreement.MOST_TIMES * 16


@pytest.mark.usefixtures("variant")
def test_a_comparison_is_kept_and_becomes_a_page(tmp_path: Path, light: Path, monkeypatch, capsys) -> None:
    pytest.importorskip("flip_evaluator", reason="the extra reference is not installed")
    from brdf_suite.reference import passes

    keep = tmp_path / "kept"
    forms = (DEFAULT_FORM, "Fresnel off", "5 lobes", "maps of a quarter", "near-specular × 0.7")
    order = Order(["copper"], [str(light)], SIZE, 64, forms, lobes=True, keep=keep)
    (case,) = compare(order)
    assert (case.paint, case.environment) == ("Copper", "soft")
    assert case.errors[DEFAULT_FORM].mean < 2.0
    assert case.errors["Fresnel off"].mean > case.errors[DEFAULT_FORM].mean + 0.3
    assert case.errors[LOBES].mean < 3.0
    assert set(case.look_up) == set(forms)
    plain = case.pictures[DEFAULT_FORM]
    for form in forms[1:]:
        assert np.abs(case.pictures[form] - plain).max() > 1e-4, form
    assert 0.0 < case.noise.mean < 2.0
    assert summary([case])["de00_worst"] == pytest.approx(case.errors[DEFAULT_FORM].mean)
    assert 0.0 <= case.errors[DEFAULT_FORM].above_10 <= 0.02
    assert len(list(keep.glob("*.exr"))) == 3  # the paint twice, its lobes once
    # What is kept is not traced again, and the figures are the same.
    traced = passes.trace_pass
    monkeypatch.setattr("brdf_suite.reference.passes.trace_pass", None)
    (again,) = compare(order)
    assert again.errors[DEFAULT_FORM].mean == pytest.approx(case.errors[DEFAULT_FORM].mean, abs=1e-3)
    write_page(tmp_path / "page.md", [again], order)
    text = (tmp_path / "page.md").read_text()
    assert f"{again.errors[DEFAULT_FORM].mean:.2f}" in text
    assert "| Copper |" in text
    assert "| number of lobes | 5 lobes |" in text
    assert (tmp_path / "images" / "agreement_designed_sphere.png").stat().st_size > 1000
    # Where the default form was not drawn, the page judges by the first that was.
    off = {"Fresnel off": again.errors["Fresnel off"]}
    write_page(tmp_path / "off.md", [replace(again, errors=off, look_up={})], order)
    assert (
        f"The worst paint is Copper, {off['Fresnel off'].mean:.2f} in the mean"
        in (tmp_path / "off.md").read_text()
    )
    # Another surface is distinguished, and so is a paint that is not designed.
    titles = [title for title, _ in groups([again, replace(again, kind="scattered")])]
    assert titles == ["Designed paints on the sphere", "Scattered samples on the sphere"]
    roof = tmp_path / "roof.obj"
    roof.write_text("v -1 0 1\nv 1 0 1\nv 0 1 0\nv 0 0 -1\nf 1 2 3\nf 2 4 3\nf 4 1 3\n")
    monkeypatch.setattr("brdf_suite.reference.passes.trace_pass", traced)
    words = [
        "agreement",
        "--paints",
        "copper",
        "--mesh",
        "sphere",
        str(roof),
        "--forms",
        DEFAULT_FORM,
        "Fresnel off",
        "--environments",
        str(light),
        "--size",
        f"{SIZE[0]}x{SIZE[1]}",
    ]
    assert main([*words, "--spp", "64", "--keep", str(keep), "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["cases"][0]["paint"] == "Copper"
    assert set(found["summary"]) == {
        "Designed paints on the sphere",
        "Designed paints on the roof",
    }
    assert set(found["summary"]["Designed paints on the sphere"]) == {DEFAULT_FORM, "Fresnel off"}


@pytest.mark.parametrize(
    ("name", "kind"),
    [
        ("blue", "designed"),
        ("solid_yellow", "designed"),
        ("gold_green_shift", "two-light"),
        ("satin_blue", "satin"),
        ("matte_white", "matte"),
        ("table1_white", "Table 1"),
        ("cook_torrance", "model"),
    ],
)
def test_each_paint_has_a_class(name: str, kind: str) -> None:
    assert class_of(fit_material(load_material(name))) == kind


def test_a_page_that_cannot_be_is_refused_before_the_work(tmp_path: Path) -> None:
    with pytest.raises(FileError, match=r"\.md"):
        check_page(tmp_path / "a.html")
    with pytest.raises(FileError, match="does not exist"):
        check_page(tmp_path / "none" / "a.md")
    (tmp_path / "images").write_text("")
    with pytest.raises(
        FileError, match="is no folder, and the pictures of the page go into one of this name"
    ):
        check_page(tmp_path / "a.md")


@pytest.mark.parametrize("name", ["file", "x" * 300])
def test_what_is_traced_is_kept_in_a_folder(name: str, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(FileError, match="cannot be made"):
        list(compare(Order((), (), keep=tmp_path / name)))


def test_means_over_blocks_take_the_object_alone() -> None:
    light = np.zeros((40, 33, 3))
    inside = np.zeros((40, 33), bool)
    inside[:16, :20], light[:16, :16] = True, (1.0, 2.0, 3.0)
    light[:16, 16:20] = 4.0  # a quarter of its block, which just counts
    light[~inside] = 99.0
    np.testing.assert_allclose(block_means(light, inside), [[1.0, 2.0, 3.0], [4.0, 4.0, 4.0]])
    inside[0, 16] = False
    assert len(block_means(light, inside)) == 1


@pytest.mark.usefixtures("variant")
def test_flakes_of_both_renderers_have_the_same_means(tmp_path: Path, sun: Path, capsys) -> None:
    pytest.importorskip("flip_evaluator", reason="the extra reference is not installed")
    keep, page = tmp_path / "kept", tmp_path / "page.md"
    words = ["agreement", "--paints", "coarse_silver", "solid_red", "--environments", str(sun), "--flakes"]
    words += [
        "--forms",
        DEFAULT_FORM,
        "--size",
        "48x48",
        "--spp",
        "128",
        "--keep",
        str(keep),
        "-o",
        str(page),
        "--json",
    ]
    assert main(words) == 0
    (case,) = json.loads(capsys.readouterr().out)["flakes"]  # a solid paint has none
    assert (case["paint"], case["environment"], case["surface"]) == ("Coarse silver", "sun", "sphere")
    assert 0.0 < case["de00_mean"] < 1.0
    assert case["de00_mean"] <= case["de00_worst"]
    assert 0.0 < case["noise"] < 2.0
    assert case["luminance"] == pytest.approx(1.0, abs=0.05)
    text = page.read_text()
    assert "## With flakes on the sphere" in text
    assert f"| Coarse silver | {case['de00_mean']:.2f} / " in text
    # Both have the flakes, and other ones in each population.
    assert case["contrast_drawn"] > 0.05
    assert case["contrast_traced"] > 0.05


def test_other_flakes_are_drawn_on_a_baked_surface_too(sun: Path) -> None:
    pytest.importorskip("flip_evaluator", reason="the extra reference is not installed")
    (case,) = compare_flakes(Order(["coarse_silver"], [str(sun)], (48, 48), 2048, surface="panel"))
    assert case.contrast_drawn > 0.005
    assert case.contrast_traced > 0.005


def test_pictures_smaller_than_a_block_are_refused(light: Path) -> None:
    with pytest.raises(ValueRangeError, match="blocks of 16×16 pixels"):
        next(compare_flakes(Order(["coarse_silver"], [str(light)], (64, 12))))


def test_a_held_out_form_knows_a_part_of_the_measured_directions(tmp_path: Path) -> None:
    rng = np.random.default_rng(3)
    wi, wo = (spherical(rng.uniform(0.0, 1.3, 400), rng.uniform(0.0, 6.28, 400)) for _ in range(2))
    values = np.repeat(0.1 + 0.2 * rng.random((400, 1)), 3, 1)
    path = tmp_path / "measured.astm"
    write_astm(ScatteredSamples(wi, wo, values), path)
    fitted = fit_for(FORMS[HELD_OUT_FORM], str(path), FitSettings())
    assert fitted is not None
    assert isinstance(fitted.reflectance, ScatteredSamples)
    assert 320 <= len(fitted.reflectance.wi) < 400
    whole = fit_for(FORMS[DEFAULT_FORM], str(path), FitSettings())
    assert whole is not None
    assert not np.allclose(fitted.weights.kdd, whole.weights.kdd, rtol=1e-3)
    assert fit_for(FORMS[HELD_OUT_FORM], "copper", FitSettings()) is None
    write_astm(ScatteredSamples(wi[:40], wo[:40], values[:40]), path)  # too few to be divided
    assert fit_for(FORMS[HELD_OUT_FORM], str(path), FitSettings()) is None


def test_a_paint_that_has_none_of_the_forms_is_named(light: Path) -> None:
    pytest.importorskip("flip_evaluator", reason="the extra reference is not installed")
    with pytest.raises(ValueRangeError, match=f"copper cannot be drawn in any of {HELD_OUT_FORM}"):
        next(compare(Order(["copper"], [str(light)], SIZE, 64, (HELD_OUT_FORM,))))
