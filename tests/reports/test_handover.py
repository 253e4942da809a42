"""Hand-over as the programs and the command call it: any paint, any format, reports that are read back."""

from __future__ import annotations

import base64
import io
import json
import re
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.appearance.difference.tolerance import Tolerances
from brdf_suite.appearance.texture import NO_TEXTURE
from brdf_suite.documents.paint import Gloss, Measurement, Paint, TextureTargets
from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import SurfaceLook
from brdf_suite.errors import Cancelled, FileError, SuiteError, UnreachableError, ValueRangeError
from brdf_suite.files.cxf import read_cxf
from brdf_suite.inspection.texture.readings import texture_of
from brdf_suite.paint_design.standard import standard_of
from brdf_suite.paint_design.standard_files import load_standards
from brdf_suite.pipeline.material import load_shipped_paint, material_of
from brdf_suite.reports.handover import (
    export,
    export_losses,
    format_named,
    format_of,
    formats,
    item_of,
    item_of_paint,
    read_paints,
)
from brdf_suite.reports.paint_report import document as report_document
from brdf_suite.reports.paint_report.document import ReportOptions, build_report

pytestmark = pytest.mark.usefixtures("shared_cache")
PLAIN = ReportOptions(pictures=False)


@pytest.fixture(scope="module")
def blue() -> Paint:
    return load_shipped_paint("blue")


def test_every_format_has_a_name_and_an_ending_of_its_own() -> None:
    names = [known.name for known in formats()]
    assert names == ["cxf", "csv", "json", "luxcore", "openpbr", "gltf", "usd", "rgl", "html", "pdf"]
    assert len({known.ending for known in formats()}) == len(names)
    assert format_of("a.PDF").name == "pdf"
    with pytest.raises(FileError, match="names no format"):
        format_of("a.doc")
    with pytest.raises(SuiteError, match="there are cxf"):
        format_named("dxf")


@pytest.mark.parametrize("name", ["html", "pdf"])
def test_a_report_carries_the_paint(name: str, blue: Paint, tmp_path: Path) -> None:
    path = tmp_path / f"report.{name}"
    done = export(format_named(name, PLAIN), [item_of_paint(blue)], path)
    assert done.losses
    assert done.losses[0].endswith(".")
    assert read_paints(path).paints == (blue,)
    damaged = path.read_bytes().replace(b'"lab"', b'"lap"', 1)
    path.write_bytes(damaged)
    with pytest.raises(FileError) as caught:
        read_paints(path)
    assert "paints[0].paint" in (caught.value.place or "")


@pytest.mark.parametrize("name", ["html", "pdf"])
def test_a_report_leaves_the_old_file_on_a_full_disk(
    name: str, blue: Paint, tmp_path: Path, full_disk: None
) -> None:
    path = tmp_path / f"report.{name}"
    path.write_bytes(b"old")
    with pytest.raises(FileError, match="No space left"):
        export(format_named(name, PLAIN), [item_of_paint(blue)], path)
    assert path.read_bytes() == b"old"
    with pytest.raises(FileError, match="cannot be written"):
        export(format_named(name, PLAIN), [item_of_paint(blue)], tmp_path / "none" / path.name)


class _Page(HTMLParser):
    """Collects the cells of tables, pictures, and what the page would fetch."""

    def __init__(self) -> None:
        super().__init__()
        self.rows: list[list[str]] = []
        self.pictures: list[str] = []
        self.fetched: list[str] = []
        self._cell = False

    def handle_starttag(self, tag, attrs) -> None:
        values = dict(attrs)
        if tag == "tr":
            self.rows.append([])
        self._cell = tag in ("td", "th")
        if self._cell:
            self.rows[-1].append("")
        if tag == "img":
            self.pictures.append(values["src"])
        self.fetched += [v for k, v in attrs if k in ("src", "href") and not v.startswith("data:")]

    def handle_endtag(self, tag) -> None:
        self._cell = False

    def handle_data(self, data) -> None:
        if self._cell:
            self.rows[-1][-1] += data


def test_the_page_shows_pictures_and_numbers_and_fetches_nothing(
    blue: Paint, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # One light for both pictures, and nothing baked: what costs time here is not of the report.
    bare = SurfaceLook(occlusion=False)
    monkeypatch.setattr(report_document, "SECOND", View(surface="sphere", surface_look=bare))
    path = tmp_path / "report.html"
    darker = replace(blue, name="<b>darker</b> & 金")
    darker = darker.with_lab(110.0, (6.0, 8.0, -28.0))
    options = ReportOptions(
        standard=standard_of(blue),
        tolerances=Tolerances({110.0: 1.0}, 1.0),
        view=View(surface_look=bare),
        scale=0.08,
    )
    export(format_named("html", options), [item_of_paint(darker)], path)
    text = path.read_text(encoding="utf-8")
    page = _Page()
    page.feed(text)
    assert page.fetched == []
    assert not re.search(r"@import|url\(", text)
    assert "&lt;b&gt;darker&lt;/b&gt; &amp; 金" in text
    assert len(page.pictures) == 2
    for picture in page.pictures:
        pixels = np.asarray(Image.open(io.BytesIO(base64.b64decode(picture.partition(",")[2]))))
        assert pixels.std() > 5.0
    heads, *rows = page.rows[:4]
    assert [row[0] for row in rows] == ["15°", "45°", "110°"]
    for row, measurement in zip(rows, darker.measurements, strict=True):
        assert [float(cell) for cell in row[1:4]] == list(measurement.lab)
    assert heads[-1] == "Tolerance"
    assert [row[-1] for row in rows] == ["pass", "pass", "fail"]
    expected = float(delta_e_2000(blue.lab_at(110.0), darker.lab_at(110.0)))
    assert float(rows[2][heads.index("ΔE00")]) == pytest.approx(expected, abs=0.005)
    assert "darker" in text
    assert "does not pass" in text
    assert text.count("<polyline") > 9
    assert read_paints(path).paints == (darker,)


def test_the_pdf_is_one_page_with_the_paint_attached(blue: Paint, tmp_path: Path) -> None:
    pypdf = pytest.importorskip("pypdf")
    path = tmp_path / "report.pdf"
    many = replace(
        blue,
        name="金 " + "long name " * 12,
        measurements=tuple(
            Measurement(45.0, float(angle), (50.0 - angle / 5.0, 1.0, -20.0)) for angle in range(15, 111, 5)
        ),
        notes="a long note, " * 400,
        flakes=None,
    )
    export(format_named("pdf", replace(PLAIN, standard=standard_of(blue))), [item_of_paint(many)], path)
    reader = pypdf.PdfReader(path)
    assert len(reader.pages) == 1
    assert reader.metadata is not None
    assert reader.metadata.title == many.name
    (content,) = reader.attachments["paint.json"]
    assert len(json.loads(content)["paints"][0]["readings"]) == 20
    text = reader.pages[0].extract_text()
    assert "Flop index" in text
    assert "12 more readings are in the attached data." in text
    assert read_paints(path).paints == (many,)


def test_the_report_says_what_the_fit_gives(blue: Paint) -> None:
    made = build_report(item_of_paint(blue), PLAIN)
    figures = {name: value for _, group in made.figures for name, value in group}
    assert figures["Flop index"] == "13.9"
    assert figures["Gloss 20°"] == "90.0 GU"
    assert [row.fit_delta_e is not None for row in made.rows] == [True] * 3
    paint, lobes = made.curves
    assert paint.lch[0, 0] == pytest.approx(62.0, abs=1e-6)
    assert np.abs(paint.lch[:, 0] - lobes.lch[:, 0]).max() < 1.0
    assert any("Invented to be plausible" in remark for remark in made.remarks)


def test_a_cook_torrance_paint_is_read_by_instruments_and_handed_over(tmp_path: Path) -> None:
    subject = item_of("table1_white")
    assert subject.computed
    assert len(subject.paint.measurements) == 5
    export(format_named("csv"), [subject], tmp_path / "a.csv")
    (back,) = read_paints(tmp_path / "a.csv").paints
    assert isinstance(back, Paint)
    assert [m.lab for m in back.measurements] == [m.lab for m in subject.paint.measurements]


def test_spectra_of_a_measured_file_go_into_cxf(shared_data: Path, tmp_path: Path) -> None:
    path = shared_data / "brdf" / "cayman.brdf"
    subject = item_of(path)
    assert subject.spectra is not None
    export(format_named("cxf"), [subject], tmp_path / "a.cxf")
    readings = read_cxf(tmp_path / "a.cxf").samples[0].readings
    assert all(reading.reflectance for reading in readings)
    assert [reading.lab for reading in readings] == [m.lab for m in subject.paint.measurements]


def test_too_many_and_impossible_paints_are_refused_before_anything_is_written(
    blue: Paint, tmp_path: Path
) -> None:
    path = tmp_path / "a.gltf"
    with pytest.raises(ValueRangeError, match="takes one paint, not 2"):
        export(format_named("gltf"), [item_of_paint(blue)] * 2, path)
    with pytest.raises(ValueRangeError, match="at least one"):
        export(format_named("gltf"), [], path)
    impossible = replace(blue, gloss=Gloss(150.0))
    with pytest.raises(UnreachableError, match="Blue: "):
        export(format_named("gltf"), [item_of_paint(impossible)], path)
    with pytest.raises(UnreachableError):
        export(format_named("pdf", PLAIN), [item_of_paint(impossible)], path)
    assert not path.exists()
    # What only holds readings takes it all the same.
    assert export_losses(format_named("csv"), item_of_paint(impossible)) == ()
    export(format_named("csv"), [item_of_paint(impossible)], tmp_path / "a.csv")


def test_a_cancelled_report_leaves_nothing(blue: Paint, tmp_path: Path) -> None:
    def stop(fraction: float, _what: str) -> None:
        if fraction > 0.5:
            raise Cancelled

    with pytest.raises(Cancelled):
        export(format_named("pdf", PLAIN), [item_of_paint(blue)], tmp_path / "a.pdf", progress=stop)
    assert not list(tmp_path.iterdir())


def test_readings_without_a_sample_near_them_are_marked_in_reports(shared_data: Path, tmp_path: Path) -> None:
    sparse = item_of(shared_data / "brdf" / "bird_example.json")
    made = build_report(sparse, PLAIN)
    assert all(row.label.endswith("†") for row in made.rows)
    assert made.remarks[0].startswith("† No sample lies within 10° of the readings at 15° (nearest 47°)")
    export(format_named("html", PLAIN), [sparse], tmp_path / "sparse.html")
    assert "15°†" in (tmp_path / "sparse.html").read_text(encoding="utf-8")
    export(format_named("json"), [sparse], tmp_path / "sparse.json")
    read = json.loads((tmp_path / "sparse.json").read_text(encoding="utf-8"))["paints"][0]["readings"]
    assert read[0]["nearest_sample_deg"] == pytest.approx(46.8, abs=0.1)


def test_cxf_and_json_carry_the_texture(blue: Paint, tmp_path: Path) -> None:
    expected = texture_of(material_of(blue))
    export(format_named("cxf"), [item_of_paint(blue)], tmp_path / "blue.cxf")
    assert read_cxf(tmp_path / "blue.cxf").samples[0].texture == expected.by_name()
    export(format_named("json"), [item_of_paint(blue)], tmp_path / "blue.json")
    kept = json.loads((tmp_path / "blue.json").read_text())["paints"][0]["texture"]
    assert kept == expected.to_json()
    plain = replace(blue, flakes=None)
    export(format_named("cxf"), [item_of_paint(plain)], tmp_path / "plain.cxf")
    assert read_cxf(tmp_path / "plain.cxf").samples[0].texture == NO_TEXTURE.by_name()


def test_a_report_says_the_texture(blue: Paint) -> None:
    figures = dict(dict(build_report(item_of_paint(blue), PLAIN).figures)["Flakes"])
    grain = texture_of(material_of(blue)).graininess
    assert figures["Graininess"] == f"{100 * grain:.2f} %"
    assert {f"Sparkle {angle}°" for angle in (15, 45, 75)} <= set(figures)
    plain = build_report(item_of_paint(replace(blue, flakes=None)), PLAIN)
    assert dict(dict(plain.figures)["Flakes"])["Sparkle, graininess"] == "none"


def test_a_texture_is_read_with_what_is_there_and_wrong_values_are_refused(
    blue: Paint, tmp_path: Path
) -> None:
    path = tmp_path / "blue.cxf"
    export(format_named("cxf"), [item_of_paint(blue)], path)
    whole = path.read_text()
    path.write_text(whole.replace("BRDF Suite texture 1", "Another texture 2"))
    found = read_cxf(path)
    assert found.samples[0].texture == {}
    assert any("Another texture 2" in text for text in found.refused)
    every = texture_of(material_of(blue)).by_name()
    for gone in every:
        path.write_text(re.sub(rf'<cc:Tag Name="texture\.{re.escape(gone)}"[^>]*/>', "", whole))
        found = read_cxf(path)
        assert found.samples[0].texture == {name: value for name, value in every.items() if name != gone}
        assert found.refused == ()
    path.write_text(re.sub(r'<cc:Tag Name="texture.scale"[^>]*/>', "", whole))
    found = read_cxf(path)
    assert found.samples[0].texture == {}
    assert any("scale that is not named" in text for text in found.refused)
    line = next(k for k, text in enumerate(whole.splitlines(), 1) if "texture.graininess" in text)
    path.write_text(re.sub(r'(Name="texture.graininess" Value=")', r"\1-", whole))
    with pytest.raises(FileError, match=rf"(?s)blue\.cxf.*line {line}.*must not be negative"):
        read_cxf(path)
    path.write_text(re.sub(r'(Name="texture.graininess" Value=")', r"\1about ", whole))
    with pytest.raises(FileError, match=rf"(?s)blue\.cxf.*line {line}.*texture.graininess"):
        read_cxf(path)


def test_targets_of_texture_go_through_files_and_into_the_report(blue: Paint, tmp_path: Path) -> None:
    paint = replace(blue, texture=TextureTargets(grade_45=0.8, graininess=0.035))
    for name in ("cxf", "csv", "json"):
        path = tmp_path / f"blue.{name}"
        export(format_named(name), [item_of_paint(paint)], path)
        (standard,) = load_standards(path)[0:1]
        assert standard.paint is not None
        assert standard.paint.texture == paint.texture, name
    figures = dict(dict(build_report(item_of_paint(paint), PLAIN).figures)["Flakes"])
    assert figures["Sparkle 45°"].endswith(", target 80 %")
    assert figures["Graininess"].endswith(", target 3.50 %")
    assert "target" not in figures["Sparkle 15°"]
    none = build_report(item_of_paint(replace(paint, flakes=None)), PLAIN)
    assert dict(dict(none.figures)["Flakes"])["Sparkle, graininess"] == "none, but the paint has targets"
