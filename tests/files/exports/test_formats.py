"""Every format that paints are handed over in, through the same checks; and each against its own oracle."""

from __future__ import annotations

import csv
import json
import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.appearance.geometries import measured_set
from brdf_suite.documents.cook_torrance import CookTorrancePaint
from brdf_suite.documents.paint import Flakes, Gloss, Measurement, OrangePeel, Paint
from brdf_suite.documents.store import PAINT_ENDING, load_paint
from brdf_suite.errors import FileError, SuiteError, ValueRangeError
from brdf_suite.files.cxf import read_cxf
from brdf_suite.files.exports import FORMATS, read_paints
from brdf_suite.files.exports.format import ExportFormat, ExportItem, Spectra
from brdf_suite.files.measured import read_measured
from brdf_suite.pipeline.material import Material
from brdf_suite.reflectance.designed.build import build_paint, build_reflectance
from brdf_suite.reflectance.instruments.spectrophotometer import measure
from brdf_suite.reflectance.tensor.tabulate import tabulate
from brdf_suite.resources import resource, resource_names

LABS = {15.0: (86.123456789, 4.1, 44.0), 45.0: (37.8, 2.1, 23.5), 110.0: (13.6, 1.2, 14.5)}
PAINT = Paint(
    name='= gold, "fine" <&> 金',
    measurements=tuple(Measurement(45.0, angle, lab) for angle, lab in LABS.items()),
    gloss=Gloss(89.5, 97.25),
    flakes=Flakes(110.0, 21.0, 0.155, 0.02),
    notes="first line\n\tsecond; 'third'",
    source="-by hand",
    near_specular=1.25,
    orange_peel=OrangePeel(0.5, 4.0),
)
BY_NAME = {known.name: known for known in FORMATS}


@pytest.fixture(scope="module")
def subjects() -> dict[str, ExportItem]:
    """The paint as each format gets it; the table, a smaller one than usual, is made once."""
    designed = ExportItem(PAINT)
    table = tabulate(build_paint(PAINT), incidences=48, resolution=96)
    tabulated = ExportItem(PAINT, Material("whole", table, document=PAINT))
    return {known.name: tabulated if known.name == "rgl" else designed for known in FORMATS}


@pytest.fixture(params=FORMATS, ids=lambda known: known.name)
def known(request: pytest.FixtureRequest) -> ExportFormat:
    return request.param


def labs(paint: Paint) -> dict[tuple[float, float], tuple[float, float, float]]:
    return {(m.illumination_deg, m.aspecular_deg): m.lab for m in paint.measurements}


def test_what_is_lost_is_reported_in_sentences(known: ExportFormat) -> None:
    reported = known.losses(ExportItem(PAINT))
    assert all(
        (sentence[0].isupper() or sentence.startswith("glTF")) and sentence.endswith(".")
        for sentence in reported
    )
    if known.read is None:
        assert any("left out" in sentence for sentence in reported)
    if known.name in ("luxcore", "openpbr", "gltf", "usd"):
        assert any("ΔE00" in sentence for sentence in reported)
        assert any("flakes" in sentence for sentence in reported)
    if known.name in ("luxcore", "openpbr", "usd", "rgl"):
        assert any("orange peel" in sentence for sentence in reported)


def test_a_paint_comes_back_as_it_was(
    known: ExportFormat, subjects: dict[str, ExportItem], tmp_path: Path
) -> None:
    path = tmp_path / f"paint{known.ending}"
    known.write([subjects[known.name]], path, None)
    if known.name == "rgl":
        report = measure(read_measured(path), measured_set(list(labs(PAINT))))
        assert delta_e_2000(report.lab, np.array(list(LABS.values()))).max() < 0.05
    elif known.read is not None:
        found = read_paints(path)
        assert found.paints == (PAINT,)
        assert found.notes == ()


def test_several_paints_go_into_one_file_or_are_refused_before(known: ExportFormat, tmp_path: Path) -> None:
    if not known.many:
        return
    two_lights = replace(
        PAINT,
        name="another",
        measurements=(*PAINT.measurements, Measurement(20.0, 15.0, (80.0, 4.0, 40.0))),
        gloss=Gloss(88.0),
        flakes=None,
        source="",
        notes="",
    )
    path = tmp_path / f"paints{known.ending}"
    known.write([ExportItem(PAINT), ExportItem(two_lights)], path, None)
    if known.read is not None:
        first, second = read_paints(path).paints
        assert isinstance(first, Paint)
        assert isinstance(second, Paint)
        assert (labs(first), labs(second)) == (labs(PAINT), labs(two_lights))
        assert (second.name, second.gloss, second.flakes) == ("another", Gloss(88.0), None)


def test_where_nothing_can_be_written_the_error_says_so(
    known: ExportFormat, subjects: dict[str, ExportItem], tmp_path: Path
) -> None:
    for path in (tmp_path / "no folder" / f"paint{known.ending}", tmp_path):
        with pytest.raises(FileError, match=r"cannot be written|names no format"):
            known.write([subjects[known.name]], path, None)


def test_a_full_disk_leaves_the_old_file(
    known: ExportFormat, subjects: dict[str, ExportItem], tmp_path: Path, full_disk: None
) -> None:
    path = tmp_path / f"paint{known.ending}"
    path.write_bytes(b"old")
    with pytest.raises(FileError, match="No space left"):
        known.write([subjects[known.name]], path, None)
    assert path.read_bytes() == b"old"
    assert [item.name for item in tmp_path.iterdir()] == [path.name]


class _NotANumber:
    def eval(self, wi, wo):
        return np.full(np.broadcast_shapes(np.shape(wi), np.shape(wo)), math.nan)


def test_what_is_not_a_number_is_refused(tmp_path: Path) -> None:
    with pytest.raises(SuiteError):
        BY_NAME["rgl"].write(
            [ExportItem(PAINT, Material("whole", _NotANumber()))], tmp_path / "nan.bsdf", None
        )
    assert not list(tmp_path.iterdir())
    with pytest.raises(ValueRangeError, match="finite"):
        Spectra((400.0, 500.0), ((0.1, math.nan),))
    with pytest.raises(ValueRangeError, match="finite"):
        replace(PAINT, near_specular=math.nan)


def test_cxf_is_valid_against_the_schema(shared_data: Path, tmp_path: Path) -> None:
    import xmlschema

    row = np.linspace(0.05, 2.0, 31)
    spectra = Spectra(
        tuple(np.linspace(400.0, 700.0, 31).tolist()), tuple((row * k).tolist() for k in (1.0, 0.5, 9.0))
    )
    spectral = ExportItem(
        replace(PAINT, name="spectral\ufffe"), Material("whole", build_paint(PAINT)), spectra
    )
    losses = " ".join(BY_NAME["cxf"].losses(spectral))
    assert "1 of 3 spectra are left out" in losses
    assert "�" in losses
    path = tmp_path / "paints.cxf"
    BY_NAME["cxf"].write([ExportItem(PAINT), spectral], path, None)
    xmlschema.XMLSchema(shared_data / "palettes" / "cxf" / "CxF3_Core.xsd").validate(path)
    plain, measured = read_cxf(path).samples
    assert plain.paint() == PAINT
    assert [reading.reflectance is not None for reading in measured.readings] == [True, True, False]
    assert measured.readings[0].reflectance == pytest.approx(row, rel=1e-6)
    # One specification per angle: those with a spectrum have their own.
    assert path.read_text().count("<cc:BRDFAngle") == 5


def test_uneven_spectra_are_read_off_and_reported(tmp_path: Path) -> None:
    bands = (380.5, 450.0, 600.0, 750.0)
    subject = ExportItem(
        PAINT, Material("whole", build_paint(PAINT)), Spectra(bands, ((0.1, 0.2, 0.3, 0.4),) * 3)
    )
    assert any("every 10 nm" in sentence for sentence in BY_NAME["cxf"].losses(subject))
    BY_NAME["cxf"].write([subject], tmp_path / "a.cxf", None)
    found = read_cxf(tmp_path / "a.cxf").samples[0].readings[0]
    assert found.wavelengths_nm == tuple(np.linspace(400.0, 700.0, 31))
    assert found.reflectance == pytest.approx(
        np.interp(found.wavelengths_nm, bands, (0.1, 0.2, 0.3, 0.4)), rel=1e-6
    )


def test_a_paint_that_is_not_designed_says_that_readings_go_in(tmp_path: Path) -> None:
    document = CookTorrancePaint("grey", (0.2, 0.2, 0.2))
    subject = ExportItem(PAINT, Material("whole", build_reflectance(document), document=document))
    for name in ("cxf", "csv"):
        assert any("virtual instruments" in sentence for sentence in BY_NAME[name].losses(subject))
    assert BY_NAME["json"].losses(subject) == ()
    BY_NAME["json"].write([subject], tmp_path / "a.json", None)
    assert read_paints(tmp_path / "a.json").paints == (document,)


def test_a_table_that_a_spreadsheet_saved_again_is_read(tmp_path: Path) -> None:
    path = tmp_path / "table.csv"
    path.write_text(
        "name;L_15;a_15;b_15;L_45;a_45;b_45;L_110;a_110;b_110;G20;batch\n"
        "silver;108,6;0,3;1,5;40,9;0,4;0,3;8,7;1,2;-2,1;88,5;7\n;;;;;;;;;;;\n"
    )
    found = read_paints(path)
    (paint,) = found.paints
    assert isinstance(paint, Paint)
    assert paint.lab_at(110.0) == (8.7, 1.2, -2.1)
    assert paint.gloss.gu_20 == 88.5
    assert any("'batch'" in note for note in found.notes)


@pytest.mark.parametrize(
    ("text", "place", "reason"),
    [
        ("name,L_15,a_15,b_15\nx,1,2,nan\n", "line 2, column b_15", "finite number"),
        ("name,L_15,a_15,b_15\nx,1,2\n", "line 2, column b_15", "finite number"),
        ("name,L_15,a_15,b_15\nx,1,2,3\n", "line 2, measurements", "expected 3 to"),
        ("name,L_15,a_15,b_15\nx,1,2,3,4\n", "line 2", "more than 4 cells"),
        ("name,L_15,L_15\nx,1,2\n", "line 1", "twice"),
        ("name,illuminant,L_15,a_15,b_15\nx,A,1,2,3\n", "line 2", "without a spectrum"),
        ("name,L_15,a_15,b_15\n", "line 2", "no paint"),
        ('name,L_15,a_15,b_15\n"x,1,2,3\n', "line", "not valid CSV"),
        ('name,L_15,a_15,"b_15\nx,1,2,3\n', "line", "not valid CSV"),
    ],
)
def test_damaged_tables_are_refused_with_the_line(tmp_path: Path, text: str, place: str, reason: str) -> None:
    path = tmp_path / "table.csv"
    path.write_text(text)
    with pytest.raises(FileError, match=reason) as caught:
        read_paints(path)
    assert place in (caught.value.place or "")


def test_texts_are_no_formulas_to_a_spreadsheet(tmp_path: Path) -> None:
    BY_NAME["csv"].write([ExportItem(PAINT)], tmp_path / "a.csv", None)
    row = next(csv.DictReader((tmp_path / "a.csv").read_text(encoding="utf-8-sig").splitlines(keepends=True)))
    assert row["name"].startswith("'=")
    assert row["source"].startswith("'-")


def test_json_holds_what_follows_from_the_readings(tmp_path: Path) -> None:
    path = tmp_path / "a.json"
    BY_NAME["json"].write([ExportItem(PAINT)], path, None)
    (item,) = json.loads(path.read_text())["paints"]
    assert item["readings"][1]["geometry"] == "45as45"
    assert item["readings"][1]["lch"][1] == pytest.approx(math.hypot(2.1, 23.5))
    assert item["flop_index"] == pytest.approx(2.69 * (86.123456789 - 13.6) ** 1.11 / 37.8**0.86)
    broken = json.loads(path.read_text())
    broken["paints"][0]["paint"]["gloss"]["gu_20"] = "high"
    path.write_text(json.dumps(broken))
    with pytest.raises(FileError) as caught:
        read_paints(path)
    assert caught.value.place == "paints[0].paint.gloss.gu_20"


def test_a_file_of_no_such_format_is_refused(tmp_path: Path) -> None:
    (tmp_path / "a.txt").write_text("L_15 without commas")
    with pytest.raises(FileError, match="holds no paints"):
        read_paints(tmp_path / "a.txt")


@pytest.mark.parametrize("name", ["cxf", "csv", "json"])
def test_every_shipped_paint_comes_back_to_the_last_bit(name: str, tmp_path: Path) -> None:
    paints = [
        load_paint(resource("paints", known + PAINT_ENDING))
        for known in resource_names("paints", PAINT_ENDING)
    ]
    path = tmp_path / f"all{BY_NAME[name].ending}"
    BY_NAME[name].write([ExportItem(paint) for paint in paints], path, None)
    assert read_paints(path).paints == tuple(paints)
