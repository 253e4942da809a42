"""``judge`` and ``design`` as a user calls them."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import pytest

from brdf_suite.cli.main import main
from brdf_suite.documents.paint import TextureTargets
from brdf_suite.documents.store import load_paint, save_paint
from brdf_suite.inspection.texture.expectation import expected_scales
from brdf_suite.inspection.texture.readings import paint_light
from brdf_suite.pipeline.lobe_fit import fit_material
from brdf_suite.pipeline.material import load_shipped_paint, material_of


@pytest.fixture
def asked(capsys):
    """Run the command; its status, what it printed, and its complaint."""

    def ask(*words: object) -> tuple[int, str, str]:
        status = main([str(word) for word in words])
        reported = capsys.readouterr()
        return status, reported.out, reported.err

    return ask


@pytest.fixture
def batch(tmp_path: Path) -> Path:
    """Blue, three units darker at the flop."""
    path = tmp_path / "batch.brdfpaint"
    save_paint(load_shipped_paint("blue").with_lab(110.0, (6.0, 8.0, -28.0)), path)
    return path


def test_judge_prints_differences_verdict_and_words(asked, batch: Path) -> None:
    status, out, _err = asked("judge", "blue", batch, "blue", "--tolerance", "1", "--tolerance", "110=L2")
    assert status == 1
    assert "Blue against Blue: FAIL" in out
    assert "FAIL (ΔL ≤ 2)" in out
    assert "in words: darker at 110°; slightly more flop" in out
    assert "Blue against Blue: pass" in out
    answer = json.loads(asked("judge", "blue", batch, "--difference", "cmc21", "--json")[1])
    row = answer["batches"][0]["angles"][2]
    assert row["verdict"]["lightness"] == pytest.approx(-3.0)
    assert row["words"] == ["darker"]
    assert set(row) >= {"delta_e_2000", "delta_e_cmc21", "delta_e_cam02ucs"}
    assert answer["batches"][0]["passes"] is None


def test_judge_against_a_measured_standard_and_what_it_refuses(asked, shared_data: Path, batch: Path) -> None:
    measured = shared_data / "brdf" / "vch_golden_yellow_rgb.bsdf"
    status, out, _err = asked("judge", measured, batch)
    assert status == 0
    assert "15°*" in out
    assert "not judged" in out
    for words, reported in (
        (("judge", "blue", batch, "--name", "red"), "no standard called 'red'"),
        (("judge", "blue", batch, "--tolerance", "33=1"), "nothing is read there"),
        (("judge", "blue", "no_such_paint"), "no_such_paint"),
    ):
        status, _out, err = asked(*words)
        assert status == 1
        assert reported in err
        assert len(err.splitlines()) == 1


def test_a_design_from_a_measurement(asked, tmp_path: Path) -> None:
    target = tmp_path / "start.brdfpaint"
    status, out, _err = asked("design", "start", "table1_blue", "-o", target)
    assert status == 0
    assert "angles that were not read: mean 0.67" in out
    paint = load_paint(target)
    assert paint.lab_at(45.0) == pytest.approx((17.31, 5.42, -34.83), abs=0.01)
    answer = json.loads(asked("design", "start", "table1_blue", "--geometry", "five", "--json")[1])
    assert len(answer["paint"]["measurements"]) == 5
    assert answer["gloss_used"] is True
    assert answer["held_out"]


def test_a_step_and_a_mixture(asked, tmp_path: Path) -> None:
    target = tmp_path / "darker.brdfpaint"
    assert asked("design", "step", "blue", "darker", "--step", "3", "-o", target)[0] == 0
    assert load_paint(target).lab_at(110.0) == (6.0, 8.0, -28.0)
    status, _out, err = asked("design", "step", "blue", "darker", "--step", "12")
    assert status == 1
    assert "darker than black" in err
    assert asked("design", "between", "blue", "red", "--share", "0.25", "-o", target)[0] == 0
    assert load_paint(target).name == "Blue 25 % Red"
    status, _out, err = asked("design", "between", "blue", "red", "--share", "3")
    assert status == 1
    assert "share" in err
    status, _out, err = asked("design", "between", "blue", "red", "-o", tmp_path / "mix.json")
    assert status == 1
    assert ".brdfpaint" in err


def test_a_design_keeps_the_scattering_or_takes_the_one_that_is_asked_for(asked, tmp_path: Path) -> None:
    single, again = tmp_path / "single.brdfpaint", tmp_path / "again.brdfpaint"
    mix = ("design", "between", "blue", "blue", "--share", "0")
    assert asked(*mix, "--scattering", "single", "-o", single)[0] == 0
    assert load_paint(single).scattering == "single"
    assert asked("design", "between", single, single, "--share", "0", "-o", again)[0] == 0
    assert load_paint(again).scattering == "single"


def test_flakes_are_found_by_wanted_readings(asked, tmp_path: Path) -> None:
    path = tmp_path / "mine.brdfpaint"
    words = ("design", "flakes", "blue", "--sparkle", "45=100", "--graininess", "3.5", "-o", path, "--json")
    status, out, _err = asked(*words)
    answer = json.loads(out)
    assert status == 0
    assert answer["reached"]
    assert answer["expected"]["sparkle grade 45°"] == pytest.approx(1.0, rel=0.05)
    assert answer["expected"]["graininess"] == pytest.approx(0.035, rel=0.05)
    written, blue = load_paint(path), load_shipped_paint("blue")
    assert written.flakes != blue.flakes
    assert written.measurements == blue.measurements


def test_flakes_are_looked_for_with_the_scattering_that_is_written(asked, tmp_path: Path) -> None:
    path = tmp_path / "mine.brdfpaint"
    words = ("design", "flakes", "matte_grey", "--sparkle", "45=100", "--scattering", "single", "-o", path)
    answer = json.loads(asked(*words, "--json")[1])
    written = load_paint(path)
    assert written.scattering == "single"
    found = expected_scales(paint_light(fit_material(material_of(written)).weights), written.flakes)
    assert list(answer["expected"].values()) == pytest.approx(found.tolist(), rel=1e-6)


def test_wanted_readings_are_kept_as_targets_and_met_again(asked, tmp_path: Path) -> None:
    path, again = tmp_path / "mine.brdfpaint", tmp_path / "again.brdfpaint"
    assert asked("design", "flakes", "blue", "--sparkle", "45=100", "-o", path)[0] == 0
    assert load_paint(path).texture == TextureTargets(grade_45=1.0)
    save_paint(replace(load_paint(path), flakes=None), path)
    answer = json.loads(asked("design", "flakes", path, "-o", again, "--json")[1])
    assert answer["reached"]
    assert answer["expected"]["sparkle grade 45°"] == pytest.approx(1.0, rel=0.05)


def test_readings_that_no_flakes_have_are_said(asked) -> None:
    status, _out, err = asked("design", "flakes", "blue", "--sparkle", "15=1", "--graininess", "20")
    assert status == 0
    assert "Not reachable" in err
    status, _out, err = asked("design", "flakes", "blue")
    assert status != 0
    assert "--sparkle LIGHT=PERCENT" in err


@pytest.mark.parametrize(("text", "complaint"), [("45", "as in 45=80"), ("40=80", "one of 15, 45, 75°")])
def test_a_wanted_grade_is_checked(text: str, complaint: str, capsys) -> None:
    with pytest.raises(SystemExit):
        main(["design", "flakes", "blue", "--sparkle", text])
    assert complaint in capsys.readouterr().err
