"""``measure``, ``compare`` and ``convert`` as a user calls them."""

from __future__ import annotations

import csv
import io
import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.cli.main import main
from brdf_suite.pipeline.material import load_shipped_paint, paint_names

MEASURED = (
    "bird_example.json",
    "cayman.brdf",
    "krylon_blue.brdf",
    "paper_white_rgb.bsdf",
    "retro-gray-tape.dat",
    "vch_golden_yellow_rgb.bsdf",
)
TABLE_1 = tuple(
    f"table1_{name}"
    for name in (
        "ford_f8", "polaris_silver", "opel_titan", "bmw_339", "2k_acrylack", "white", "blue", "blue_matte",
    )
)  # fmt: skip


@pytest.fixture
def asked(capsys: pytest.CaptureFixture[str]):
    """Run the command in this process; its status, standard output and standard error."""

    def run(*arguments: object) -> tuple[int, str, str]:
        capsys.readouterr()
        status = main([str(argument) for argument in arguments])
        said = capsys.readouterr()
        return status, said.out, said.err

    return run


def sensible(facts: dict) -> None:
    readings = facts["readings"]
    assert len(readings) >= 3
    for reading in readings:
        lightness = reading["lab"][0]
        assert 0.0 <= lightness < 250.0
        assert reading["reflectance_factor"] == pytest.approx(reading["xyz"][1] / 100.0)
        assert np.isfinite([*reading["lab"], *reading["xyz"], *reading["lch"], *reading["rho"]]).all()
    assert set(facts["gloss"]) == {"gu_20", "gu_60", "gu_85"}
    assert all(0.0 <= value < 200.0 for value in facts["gloss"].values())


@pytest.mark.parametrize("name", paint_names())
def test_every_shipped_paint_reads_what_its_document_says(asked, name: str) -> None:
    status, out, _err = asked("measure", name, "--json", "--geometry", "e2194")
    assert status == 0
    facts = json.loads(out)
    sensible(facts)
    paint = load_shipped_paint(name)
    wanted = {m.aspecular_deg: m.lab for m in paint.measurements if m.illumination_deg == 45.0}
    for reading in facts["readings"]:
        assert float(delta_e_2000(reading["lab"], wanted[reading["aspecular_deg"]])) < 0.05
    assert facts["gloss"]["gu_20"] == pytest.approx(paint.gloss.gu_20, abs=0.5)


@pytest.mark.parametrize("name", TABLE_1)
def test_every_table_1_paint_is_measured(asked, name: str) -> None:
    status, out, _err = asked("measure", name, "--json")
    assert status == 0
    facts = json.loads(out)
    sensible(facts)
    assert [reading["aspecular_deg"] for reading in facts["readings"]] == [-15, 15, 25, 45, 75, 110]
    lightness = [reading["lab"][0] for reading in facts["readings"][1:4]]
    assert lightness == sorted(lightness, reverse=True)


@pytest.mark.parametrize("name", MEASURED)
def test_every_measured_file_is_measured(asked, shared_data: Path, name: str) -> None:
    status, out, _err = asked("measure", shared_data / "brdf" / name, "--json")
    assert status == 0
    facts = json.loads(out)
    assert facts["name"] == name
    sensible(facts)


def test_the_table_names_what_it_shows(asked) -> None:
    status, out, _err = asked("measure", "blue", "--aperture", "1,3", "--geometry", "e2539")
    assert status == 0
    for words in ("light 1°, receptor 3°", "15as-15", "GU, coat and base", "flop index", "travel", "haze"):
        assert words in out


def test_readings_say_which_screen_can_show_them(asked) -> None:
    _status, out, _err = asked("measure", "fine_silver", "blue", "--json", "--geometry", "e2194")
    silver, blue = (
        [(r["in_srgb"], r["in_display_p3"]) for r in p["readings"]] for p in json.loads(out)["paints"]
    )
    # L* 128 is brighter than any white; the greys are in every gamut; the blue at 45° is not in sRGB.
    assert silver == [(False, False), (True, True), (True, True)]
    assert blue[1][0] is False


def test_a_solved_paint_reads_its_colours_through_the_aperture(asked) -> None:
    wanted = np.array([m.lab for m in load_shipped_paint("fine_silver").measurements])
    seen = {}
    for options in ((), ("--solve",)):
        status, out, _err = asked(
            "measure", "fine_silver", "--json", "--geometry", "e2194", "--aperture", "wide", *options
        )
        assert status == 0
        facts = json.loads(out)
        assert facts["aperture"]["receptor_half_angle_deg"] == 4.0
        seen[bool(options)] = delta_e_2000([r["lab"] for r in facts["readings"]], wanted).max()
    assert seen[False] > 0.1
    assert seen[True] < 0.05


def test_paints_that_share_a_name_are_distinguished(asked) -> None:
    status, out, _err = asked("measure", "blue", "table1_blue", "--csv")
    rows = list(csv.DictReader(io.StringIO(out)))
    assert status == 0
    assert [(row["name"], row["source"]) for row in rows] == [("Blue", "blue"), ("Blue", "table1_blue")]
    _, out, _err = asked("measure", "blue", "table1_blue")
    heads = [line for line in out.splitlines() if line.startswith("Blue")]
    assert heads[0].startswith("Blue: ")
    assert heads[1].startswith("Blue (table1_blue): ")
    _, out, _err = asked("measure", "blue", "table1_blue", "--json")
    assert [paint["source"] for paint in json.loads(out)["paints"]] == ["blue", "table1_blue"]


def test_a_grey_has_no_hue(asked, shared_data: Path) -> None:
    status, out, _err = asked("measure", str(shared_data / "brdf" / "retro-gray-tape.dat"))
    assert status == 0
    rows = [line.split() for line in out.splitlines() if line.split()[0].startswith("45as")]
    assert len(rows) == 6
    assert {tuple(row[2:6]) for row in rows} == {("0.00", "0.00", "0.00", "–")}


def test_csv_has_one_row_for_each_paint(asked) -> None:
    status, out, _err = asked(
        "measure", "blue", "table1_white", "--csv", "--geometry", "e2194", "--illuminant", "A"
    )
    assert status == 0
    rows = list(csv.DictReader(io.StringIO(out)))
    assert [row["name"] for row in rows] == ["Blue", "White"]
    assert float(rows[0]["L_15"]) == pytest.approx(62.0, abs=0.01)
    assert float(rows[0]["b_110"]) == pytest.approx(-28.0, abs=0.01)
    assert float(rows[0]["G20"]) == pytest.approx(90.0, abs=0.5)
    assert rows[0]["L_15_A"] != rows[0]["L_15"]
    status, out, _err = asked("measure", "blue", "--csv", "--geometry", "45:45;15:15")
    row = next(csv.DictReader(io.StringIO(out)))
    assert row["flop_index"] == row["travel_ab"] == ""
    assert float(row["L_15as15"]) > float(row["L_45"])


def test_several_paints_in_one_object(asked) -> None:
    _status, out, _err = asked("measure", "blue", "red", "--json")
    assert [facts["name"] for facts in json.loads(out)["paints"]] == ["Blue", "Red"]


def test_another_light_is_labelled(asked, shared_data: Path) -> None:
    _status, out, _err = asked("measure", "red", "--json", "--illuminant", "A")
    under = json.loads(out)["under"]
    assert under["recomputed"] is False
    assert "adapted from D65" in under["label"]
    _status, out, _err = asked(
        "measure", shared_data / "brdf" / "krylon_blue.brdf", "--json", "--illuminant", "A"
    )
    facts = json.loads(out)
    assert facts["under"]["recomputed"] is True
    # A blue is darker under a reddish lamp; the adapted road would keep its lightness.
    assert facts["under"]["readings"][3]["lab"][0] < facts["readings"][3]["lab"][0] - 2.0
    status, out, _err = asked("measure", shared_data / "brdf" / "krylon_blue.brdf", "--illuminant", "F11")
    assert status == 0
    assert "recomputed from the spectrum" in out


def test_the_observer_is_the_users_choice(asked, shared_data: Path) -> None:
    seen = []
    for observer in (2, 10):
        _status, out, _err = asked(
            "measure", shared_data / "brdf" / "krylon_blue.brdf", "--json", "--observer", observer
        )
        facts = json.loads(out)
        assert facts["spectra_observer_deg"] == observer
        assert any("2° observer" in notice for notice in facts["notices"]) is (observer == 2)
        seen.append(facts["readings"][3]["lab"])
    assert 0.5 < float(delta_e_2000(*seen)) < 10.0


def test_a_paint_equals_itself(asked) -> None:
    status, out, _err = asked("compare", "blue", "blue", "--json")
    assert status == 0
    facts = json.loads(out)
    assert (facts["cosine_rms"], facts["cube_root_rms"], facts["log_rms"]) == (0.0, 0.0, 0.0)
    for row in facts["angles"]:
        assert [row[f"delta_e_{n}"] for n in ("2000", "76", "cmc21", "cmc11", "cam02ucs")] == [0.0] * 5
    assert facts["gloss_difference"] == {"gu_20": 0.0, "gu_60": 0.0, "gu_85": 0.0}
    assert "verdict" not in facts


def test_two_paints_differ_by_their_documents_colours(asked) -> None:
    _status, out, _err = asked("compare", "blue", "red", "--json", "--geometry", "e2194")
    facts = json.loads(out)
    blue, red = (np.array([m.lab for m in load_shipped_paint(n).measurements]) for n in ("blue", "red"))
    np.testing.assert_allclose(
        [row["delta_e_2000"] for row in facts["angles"]], delta_e_2000(blue, red), atol=0.05
    )
    assert facts["cosine_rms"] > 0.0
    assert facts["away_from_mirror"]["left_out_deg"] == 5.0
    assert "solid angle" in facts["angle_set"]


def test_tolerances_decide_the_status(asked) -> None:
    passing = asked("compare", "blue", "blue", "--tolerance", "0.1", "--json")
    assert passing[0] == 0
    assert json.loads(passing[1])["verdict"]["passes"] is True
    failing = asked(
        "compare", "blue", "red", "--tolerance", "15=500", "--tolerance", "1", "--difference", "76"
    )
    assert failing[0] == 1
    assert "pass (≤ 500)" in failing[1]
    assert "FAIL (≤ 1)" in failing[1]
    only = asked("compare", "blue", "red", "--tolerance", "15=500", "--difference", "76", "--json")
    assert only[0] == 0
    assert [row["passes"] for row in json.loads(only[1])["verdict"]["angles"]].count(True) == 1


def test_compare_says_it_in_words(asked) -> None:
    _status, out, _err = asked("compare", "blue", "midnight_blue", "--geometry", "e2194")
    assert "in words: much darker and much redder at 15°" in out
    assert "; more flop" in out
    answer = json.loads(asked("compare", "blue", "midnight_blue", "--geometry", "e2194", "--json")[1])
    assert answer["words"].endswith("; more flop")
    assert answer["angles"][0]["words"] == ["much darker", "much redder"]
    assert "in words: no visible difference" in asked("compare", "blue", "blue")[1]


def test_compare_judges_the_parts_of_a_difference(asked) -> None:
    tight = ("compare", "blue", "midnight_blue", "--geometry", "e2194", "--tolerance")
    status, out, _err = asked(*tight, "15=E99,L1", "--tolerance", "99")
    assert status == 1
    assert "FAIL (ΔL ≤ 1)" in out
    assert out.count("pass (≤ 99)") == 2
    assert asked(*tight, "L99,C99,H99")[0] == 0
    row = json.loads(asked(*tight, "L99,C8,H99", "--ellipsoid", "--json")[1])["verdict"]["angles"][2]
    assert row["exceeded"] == ["ellipsoid"]
    status, out, _err = asked(*tight, "99", "--difference", "cmc:1.4:0.7")
    assert status == 0
    assert "CMC(1.4:0.7)" in out


def test_spectra_are_compared_under_other_lights(asked, shared_data: Path) -> None:
    folder = shared_data / "brdf"
    _status, out, _err = asked("compare", folder / "krylon_blue.brdf", folder / "cayman.brdf", "--json")
    index = json.loads(out)["metamerism_index"]
    assert set(index) == {"A", "F11"}
    assert min(index["A"]) > 0.5
    _status, out, _err = asked("compare", folder / "krylon_blue.brdf", "blue", "--json")
    assert "metamerism_index" not in json.loads(out)


def test_convert_keeps_the_spectra(asked, shared_data: Path, tmp_path: Path) -> None:
    source, target = shared_data / "brdf" / "krylon_blue.brdf", tmp_path / "blue.brdftable"
    status, out, err = asked("convert", source, target, "--json")
    assert status == 0, err
    assert json.loads(out)["bytes"] == target.stat().st_size
    before, after = (
        json.loads(asked("measure", path, "--json", "--illuminant", "A")[1]) for path in (source, target)
    )
    assert after["under"]["recomputed"] is True
    np.testing.assert_allclose(
        [r["lab"] for r in after["under"]["readings"]],
        [r["lab"] for r in before["under"]["readings"]],
        atol=1e-6,
    )


def test_convert_tabulates_a_paint(asked, tmp_path: Path) -> None:
    target = tmp_path / "copper.brdftable"
    status, out, err = asked("convert", "copper", target)
    assert status == 0, err
    assert "tabulated" in err
    status, out, _err = asked("compare", "copper", target, "--json")
    facts = json.loads(out)
    # The paint's colours are kept; its clearcoat's lobe is narrower than the table's finest bin.
    assert max(row["delta_e_2000"] for row in facts["angles"]) < 0.1
    assert facts["away_from_mirror"]["cosine_rms"] < 1e-3
    text = asked("compare", "copper", target)[1]
    assert "gloss (GU): 89.0 and" in text


def test_bad_requests_are_refused_in_one_line(asked, shared_data: Path, tmp_path: Path) -> None:
    blue = shared_data / "brdf" / "krylon_blue.brdf"
    broken = tmp_path / "broken.brdf"
    broken.write_bytes(b"this is not a measurement\n")
    document = tmp_path / "broken.brdfpaint"
    document.write_text("{")
    for arguments, words in (
        (("measure", "no_such_paint"), "brdf-suite list paints"),
        (("measure", "two\nlines"), "two lines"),
        (("measure", "blue", "--geometry", "45:160"), "below the surface"),
        (("measure", "blue", "--aperture", "huge"), "point, narrow, wide"),
        (("measure", broken), "broken.brdf"),
        (("measure", document), "broken.brdfpaint"),
        (("compare", "blue", "no_such_paint"), "no_such_paint"),
        (("compare", "blue", "blue", "--tolerance", "-1"), "a number from 0"),
        (("compare", "blue", "blue", "--tolerance", "L-1"), "a number from 0"),
        (("compare", "blue", "blue", "--difference", "cmc:0:1"), "two positive weights"),
        (("compare", "blue", "red", "--tolerance", "33=1"), "nothing is read there"),
        (("compare", "blue", "red", "--tolerance", "nan=1"), "-15, 15, 25, 45, 75, 110"),
        (("convert", blue, tmp_path / "out.nothing"), ".nothing"),
        (("convert", tmp_path / "missing.brdf", tmp_path / "out.dat"), "missing.brdf"),
        (("convert", blue, blue), "the source itself"),
    ):
        status, out, err = asked(*arguments)
        assert status == 1, arguments
        assert out == ""
        assert words in err
        assert len(err.strip().splitlines()) == 1
    assert not (tmp_path / "out.nothing").exists()


def test_wrong_arguments_are_a_usage_error(capsys: pytest.CaptureFixture[str]) -> None:
    for arguments in (
        ["measure"],
        ["compare", "blue", "red", "--tolerance", "15=x"],
        ["measure", "blue", "--json", "--csv"],
    ):
        with pytest.raises(SystemExit) as stopped:
            main(arguments)
        assert stopped.value.code == 2
    assert capsys.readouterr().err


def test_the_process_itself() -> None:
    done = subprocess.run(
        [sys.executable, "-W", "error", "-m", "brdf_suite", "measure", "table1_bmw_339"],
        capture_output=True,
        text=True,
        timeout=240,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert "BMW 339" in done.stdout
    assert done.stderr == ""


def test_compare_prints_the_facts_of_each(asked, shared_data: Path) -> None:
    bird = shared_data / "brdf" / "bird_example.json"
    status, out, err = asked("compare", "blue", bird)
    assert status == 0
    assert "note: bird_example.json: " in err
    assert "verdict" not in out
    answer = json.loads(asked("compare", "blue", bird, "--json")[1])
    assert answer["notices"]["a"] == []
    assert answer["notices"]["b"]


def test_paints_of_one_name_are_distinguished(asked) -> None:
    assert "Blue (table1_blue) against Blue (blue)" in asked("compare", "blue", "table1_blue")[1]


def test_readings_without_a_sample_near_them_are_marked(asked, shared_data: Path) -> None:
    folder = shared_data / "brdf"
    _status, out, _err = asked("measure", folder / "bird_example.json")
    rows = [line for line in out.splitlines() if line.split()[0].startswith("45as")]
    assert [row.split()[-1] for row in rows] == ["69.5°*", "46.8°*", "40.6°*", "35.0°*", "46.8°*", "73.7°*"]
    assert "* at 20°" in out
    _status, out, _err = asked("measure", folder / "cayman.brdf")
    assert "3.6°" in out
    assert "3.6°*" not in out
    assert "nearest sample" not in asked("measure", "blue")[1]
    facts = json.loads(asked("measure", folder / "cayman.brdf", "--json")[1])
    assert [reading["supported"] for reading in facts["readings"]] == [True] * 6
    assert facts["gloss_supported"] == {"gu_20": False, "gu_60": True, "gu_85": False}
    row = next(csv.DictReader(io.StringIO(asked("measure", folder / "cayman.brdf", "--csv")[1])))
    assert float(row["nearest_sample_deg_45"]) == pytest.approx(5.0, abs=0.01)
    assert float(row["nearest_sample_deg_G20"]) == pytest.approx(3.74, abs=0.01)
    _status, out, _err = asked("compare", folder / "bird_example.json", "blue")
    assert sum(line.endswith("  *") for line in out.splitlines()) == 6


def test_texture_is_printed_and_exported(asked) -> None:
    status, out, _ = asked("measure", "blue", "solid_red")
    assert status == 0
    assert "sparkle 45°" in out
    assert "graininess" in out
    assert "texture: none, it has no flakes" in out
    _, out, _ = asked("measure", "blue", "--json")
    texture = json.loads(out)["texture"]
    assert [one["light_deg"] for one in texture["sparkle"]] == [15.0, 45.0, 75.0]
    _, out, _ = asked("measure", "blue", "solid_red", "--csv")
    rows = list(csv.DictReader(io.StringIO(out)))
    assert float(rows[0]["sparkle_grade_45"]) == pytest.approx(texture["sparkle"][1]["grade"], rel=1e-4)
    assert float(rows[0]["graininess"]) == pytest.approx(texture["graininess"], rel=1e-4)
    assert float(rows[1]["graininess"]) == 0.0


def test_texture_is_left_out_where_it_is_not_wanted(asked) -> None:
    status, out, _ = asked("measure", "blue", "--no-texture")
    assert status == 0
    assert "texture" not in out
    read = json.loads(asked("measure", "blue", "--no-texture", "--json")[1])
    assert read["texture"] is None
    rows = [
        next(csv.DictReader(io.StringIO(asked("measure", "blue", "--csv", *more)[1])))
        for more in ((), ("--no-texture",))
    ]
    left_out = {name for name in rows[0] if name.startswith("sparkle_")} | {"graininess"}
    assert rows[1] == {name: "" if name in left_out else value for name, value in rows[0].items()}
