"""Standards out of every kind of file, and batches judged against them."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from brdf_suite.appearance.difference.formulas import delta_e_2000, delta_e_cmc
from brdf_suite.appearance.difference.tolerance import Limits, Tolerances
from brdf_suite.documents.paint import Gloss, Measurement, Paint, solid_paint
from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.documents.palette_store import save_palette
from brdf_suite.documents.store import save_paint
from brdf_suite.errors import FileError, SuiteError
from brdf_suite.files.exports import FORMATS as EXPORTS
from brdf_suite.files.exports.format import ExportItem
from brdf_suite.paint_design.standard import Standard, judge_all, judge_batch, standard_of
from brdf_suite.paint_design.standard_files import load_standards
from brdf_suite.pipeline.material import load_document, load_shipped_paint

NO_LIMITS = Tolerances({})


@pytest.fixture(scope="module")
def blue() -> Paint:
    return load_shipped_paint("blue")


def darker_at(paint: Paint, angle: float, by: float) -> Paint:
    lightness, a, b = paint.lab_at(angle)
    return paint.with_lab(angle, (lightness - by, a, b))


def test_a_batch_three_units_darker_at_flop(blue: Paint) -> None:
    report = judge_batch(
        standard_of(blue), darker_at(blue, 110.0, 3.0), Tolerances({110.0: 1.5}, 1.0), ["cmc21"]
    )
    rows = {row.angle: row for row in report.rows}
    assert rows["15°"].verdict.difference == 0.0
    assert rows["110°"].verdict.lightness == pytest.approx(-3.0)
    expected = float(delta_e_2000((9.0, 8.0, -28.0), (6.0, 8.0, -28.0)))
    assert rows["110°"].differences["2000"] == pytest.approx(expected)
    assert rows["110°"].differences["cmc21"] == pytest.approx(
        float(delta_e_cmc((9.0, 8.0, -28.0), (6.0, 8.0, -28.0)))
    )
    assert [row.verdict.passes for row in report.rows] == [True, True, False]
    assert report.passes is False
    assert report.largest == pytest.approx(expected)
    assert report.mean == pytest.approx(expected / 3)
    assert report.sentence() == "darker at 110°; slightly more flop"
    assert json.loads(json.dumps(report.to_json()))["words"] == report.sentence()


def test_a_paint_stands_for_angles_that_it_was_not_read_at(blue: Paint) -> None:
    """The six-angle batch is read from the standard's own reflectance, so it passes everywhere."""
    standard = standard_of(blue)
    angles = (15.0, 25.0, 45.0, 75.0, 110.0)
    found = {angle: standard.lab_at(45.0, angle) for angle in angles}
    assert {angle: computed for angle, (_, computed) in found.items()} == {
        15.0: False,
        25.0: True,
        45.0: False,
        75.0: True,
        110.0: False,
    }
    batch = replace(blue, measurements=tuple(Measurement(45.0, a, found[a][0]) for a in angles))
    report = judge_batch(standard, batch, Tolerances({}, 0.01))
    assert report.passes is True
    assert [row.computed for row in report.rows] == [False, True, False, True, False]


def test_readings_alone_are_compared_where_both_have_them(blue: Paint) -> None:
    standard = Standard("instrument", "a.cxf", blue.measurements[:2])
    report = judge_batch(standard, blue, Tolerances({}, 1.0))
    assert [row.standard is None for row in report.rows] == [False, False, True]
    assert report.passes is True
    assert report.flop is None
    nothing = judge_batch(Standard("empty", "", ()), blue, Tolerances({}, 1.0))
    assert nothing.passes is None
    assert nothing.largest is None
    assert nothing.sentence() == "no visible difference"


def test_a_paint_that_cannot_be_built_has_its_readings(blue: Paint) -> None:
    standard = standard_of(replace(blue, gloss=Gloss(199.0)))
    assert standard.lab_at(45.0, 15.0) == ((62.0, -4.0, -45.0), False)
    assert standard.lab_at(45.0, 25.0) is None


def test_gloss_is_compared_where_both_are_known(blue: Paint) -> None:
    duller = replace(blue, gloss=Gloss(85.0, 92.0))
    standard = standard_of(replace(blue, gloss=Gloss(90.0, 95.0)))
    assert judge_batch(standard, duller, NO_LIMITS).gloss == {20: -5.0, 60: -3.0}
    assert judge_batch(standard_of(blue), replace(blue, gloss=Gloss(85.0)), NO_LIMITS).gloss.keys() == {20}


def test_several_batches(blue: Paint) -> None:
    batches = [blue, darker_at(blue, 15.0, 1.0), darker_at(blue, 45.0, 1.0)]
    limits = Limits(lightness=0.5)
    reports = judge_all(standard_of(blue), batches, Tolerances({45.0: limits}))
    assert [report.passes for report in reports] == [True, True, False]
    assert set(reports[0].rows[0].differences) == {"2000", "76", "cmc21", "cmc11", "cam02ucs"}


def test_standards_of_paint_files_and_names(blue: Paint, tmp_path: Path) -> None:
    path = tmp_path / "mine.brdfpaint"
    save_paint(blue, path)
    (from_file,), (by_name,) = load_standards(path), load_standards("blue")
    assert from_file.readings == by_name.readings == blue.measurements
    assert from_file.origin == "mine.brdfpaint"
    (fitted,) = load_standards("table1_blue")
    assert fitted.readings == ()
    assert fitted.gloss is not None
    assert fitted.lab_at(45.0, 45.0)[0] == pytest.approx((17.31, 5.42, -34.83), abs=0.01)


def test_every_paint_of_a_palette(blue: Paint, tmp_path: Path) -> None:
    path = tmp_path / "season.brdfpalette"
    metallics = [Entry(paint, group=("metallics",)) for paint in (blue, load_document("table1_blue"))]
    save_palette(Palette("Season", (Entry(solid_paint("white", (95.0, 0.0, 1.0))), *metallics)), path)
    found = load_standards(path)
    assert [standard.name for standard in found] == ["white", blue.name, "Blue"]
    assert found[1].origin == "season.brdfpalette, metallics"
    save_palette(Palette("Empty"), path)
    with pytest.raises(FileError, match="no paint"):
        load_standards(path)


@pytest.mark.parametrize("ending", [".cxf", ".csv", ".json"])
def test_what_was_handed_over_is_a_standard(blue: Paint, tmp_path: Path, ending: str) -> None:
    """Each keeps the readings; a batch that is the very paint passes to the last digit that is written."""
    path = tmp_path / f"handed{ending}"
    form = next(known for known in EXPORTS if known.ending == ending)
    form.write([ExportItem(blue), ExportItem(load_shipped_paint("red"))], path, None)
    found = load_standards(path)
    assert [standard.name for standard in found] == ["Blue", "Red"]
    assert found[0].origin == path.name
    assert judge_batch(found[0], blue, Tolerances({}, 0.01)).passes is True
    assert judge_batch(found[1], blue, Tolerances({}, 0.01)).passes is False
    # Known by what is in it, whatever it is called.
    other = tmp_path / "renamed.dat"
    other.write_bytes(path.read_bytes())
    assert load_standards(other)[0].readings == found[0].readings


def test_a_cxf_sample_of_two_angles_is_judged_there(shared_data: Path, blue: Paint, tmp_path: Path) -> None:
    with pytest.raises(FileError, match="line 15"):
        load_standards(shared_data / "palettes" / "cxf" / "geometry_edge_cases.cxf")
    path = tmp_path / "handed.cxf"
    form = next(known for known in EXPORTS if known.ending == ".cxf")
    form.write([ExportItem(blue)], path, None)
    text = path.read_text("utf-8")
    start = text.index("<cc:ColorCIELab" if "<cc:ColorCIELab" in text else "<ColorCIELab")
    end = text.index("ColorCIELab>", start) + len("ColorCIELab>")
    path.write_text(text[:start] + text[end:], "utf-8")
    (standard,) = load_standards(path)
    assert len(standard.readings) == 2
    report = judge_batch(standard, blue, Tolerances({}, 0.01))
    assert [row.standard is not None for row in report.rows].count(True) == 2
    assert report.passes is True


def test_a_measured_file_is_read_at_any_angle(shared_data: Path, blue: Paint) -> None:
    (standard,) = load_standards(shared_data / "brdf" / "vch_golden_yellow_rgb.bsdf")
    report = judge_batch(standard, blue, NO_LIMITS)
    assert all(row.computed for row in report.rows)
    assert report.rows[0].standard == pytest.approx((101.13, 8.09, 76.7), abs=0.01)
    assert standard.gloss is not None


@pytest.mark.parametrize("name", ["no_such_paint", "missing.cxf", "missing.brdfpalette", "missing.bsdf"])
def test_what_is_not_there_is_reported(name: str, tmp_path: Path) -> None:
    with pytest.raises(SuiteError, match=r"missing|no_such_paint"):
        load_standards(tmp_path / name if "." in name else name)


@settings(max_examples=settings.default.max_examples // 2)
@given(st.lists(st.tuples(*[st.floats(5.0, 60.0)] * 3), min_size=3, max_size=3), st.floats(0.0, 5.0))
def test_a_paint_passes_against_itself_and_limits_only_widen(labs: list, limit: float) -> None:
    angles = (15.0, 45.0, 110.0)
    paint = Paint(
        "p", tuple(Measurement(45.0, a, lab) for a, lab in zip(angles, labs, strict=True)), Gloss(90.0)
    )
    standard = standard_of(paint)
    assert judge_batch(standard, paint, Tolerances({}, 0.0)).passes is True
    other = paint.with_lab(15.0, (labs[0][0] + 1.0, labs[0][1], labs[0][2]))
    tight, wide = (
        judge_batch(standard, other, Tolerances({}, value)).passes for value in (limit, limit + 1.0)
    )
    assert wide or not tight


def test_a_standard_without_samples_near_the_angle_is_marked(blue: Paint, shared_data: Path) -> None:
    (single,) = load_standards(shared_data / "brdf" / "bird_example.json")
    report = judge_batch(single, blue, NO_LIMITS)
    assert [row.marks for row in report.rows] == ["*†"] * 3
    assert report.to_json()["angles"][0]["standard_nearest_sample_deg"] == pytest.approx(46.8, abs=0.1)
    (table,) = load_standards(shared_data / "brdf" / "vch_golden_yellow_rgb.bsdf")
    assert [row.marks for row in judge_batch(table, blue, NO_LIMITS).rows] == ["*"] * 3
    assert [row.marks for row in judge_batch(standard_of(blue), blue, NO_LIMITS).rows] == [""] * 3
