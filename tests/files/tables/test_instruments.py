"""Samples of multi-angle instruments: means, spread, what is left out and why; each as standard, paint and palette."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from brdf_suite.appearance.colour.spectra import spectrum_to_lab
from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.cli.main import main
from brdf_suite.documents.paint import Paint
from brdf_suite.errors import FileError
from brdf_suite.files.instruments import read_instrument
from brdf_suite.files.palettes import find_format, read_content, read_palette, write_palette
from brdf_suite.files.palettes.sample_entries import kept_effects
from brdf_suite.files.samples import SampleFile
from brdf_suite.paint_design.standard_files import load_standards
from brdf_suite.pipeline.material import load_material

HEAD = "Name;45as15 L*;45as15 a*;45as15 b*;45as45 L*;45as45 a*;45as45 b*;45as110 L*;45as110 a*;45as110 b*"
SILVER = "Silver;120;0,5;-1;62;0;-1,5;38;-0,5;-2"


def written(tmp_path: Path, text: str, name: str = "export.csv") -> Path:
    path = tmp_path / name
    path.write_text(text, "utf-8")
    return path


def samples(tmp_path: Path, text: str) -> SampleFile:
    found = read_instrument(written(tmp_path, text))
    assert found is not None
    return found


def test_measurements_of_one_sample_are_averaged_with_their_spread(tmp_path: Path) -> None:
    second = "Silver;122;0,5;-1;62;0;-1,5;38;-0,5;-2"
    found = samples(tmp_path, "\n".join((HEAD, SILVER, "Blue;40;1;-30;25;2;-28;10;3;-20", second)))
    assert [sample.name for sample in found.samples] == ["Silver", "Blue"]
    silver = found.samples[0]
    assert silver.measurements == 2
    assert silver.readings[0].lab == (121.0, 0.5, -1.0)
    assert silver.spread == pytest.approx(
        float(delta_e_2000((120.0, 0.5, -1.0), (121.0, 0.5, -1.0))), rel=1e-9
    )
    assert "Mean of 2 measurements" in silver.notes
    assert any("mean of 2" in note for note in found.notes)


def test_different_samples_of_one_name_stay_apart(tmp_path: Path) -> None:
    other = "Silver;90;0,5;-1;50;0;-1,5;30;-0,5;-2"
    found = samples(tmp_path, "\n".join((HEAD, SILVER, other)))
    assert [sample.readings[0].lab[0] for sample in found.samples] == [120.0, 90.0]
    assert any("stay apart" in note for note in found.notes)


def test_statistics_and_damaged_readings_are_left_out_with_their_line(tmp_path: Path) -> None:
    rows = (HEAD, SILVER, "Blue;40;x;-30;25;2;-28;10;3;-20", "Std. dev.;0,1;0,1;0,1;0,1;0,1;0,1;0,1;0,1;0,1")
    found = samples(tmp_path, "\n".join(rows))
    assert [len(sample.readings) for sample in found.samples] == [3, 2]
    assert found.refused == (
        "line 3: the colour at 45as15 is left out: 'x' stands in the place of a number",
        "line 4: 'Std. dev.' is a difference, tolerance or statistic, no measurement",
    )


@pytest.mark.parametrize(
    "word",
    ["Delta", "ΔE", "Difference", "Differenz", "Tolerance +", "Toleranz -", "Upper limit", "Grenze oben", "SD", "Sigma",
     "Mittelwert", "Mean value", "Average 2", "Mean of 3 measurements", "ΔE00", "Delta E 2000"],
)  # fmt: skip
def test_differences_tolerances_and_statistics_are_no_samples(tmp_path: Path, word: str) -> None:
    found = samples(tmp_path, "\n".join((HEAD, f"{word};1;1;1;1;1;1;1;1;1", SILVER)))
    assert [sample.name for sample in found.samples] == ["Silver"]
    assert found.refused == (f"line 2: {word!r} is a difference, tolerance or statistic, no measurement",)


@pytest.mark.parametrize(
    "name",
    ["Delta Blue", "Limit Red", "Range Rover", "Standard", "Maximal Orange", "SD-101", "Range 7", "Max 2"],
)
def test_a_paint_may_be_called_as_a_statistic_with_another_word(tmp_path: Path, name: str) -> None:
    found = samples(tmp_path, f"{HEAD}\n{SILVER.replace('Silver', name)}")
    assert [sample.name for sample in found.samples] == [name]


def by_angle(*rows: tuple[str, str, float]) -> str:
    """A row per angle: name, type and lightness."""
    lines = [f"{name};{kind};{angle};{value};0;0" for name, kind, value in rows for angle in (15, 45, 110)]
    return "\n".join(("Sample;Type;Angle;L*;a*;b*", *lines))


def test_a_type_or_a_name_once_says_that_rows_are_no_measurement(tmp_path: Path) -> None:
    found = samples(
        tmp_path, by_angle(("Blue", "Trial", 50.0), ("Blue", "Delta", 1.0), ("Red", "Mean", 40.0))
    )
    assert [(one.name, one.kind) for one in found.samples] == [("Blue", "Trial"), ("Red", "Mean")]
    rows = by_angle(("Blue", "", 50.0), ("Tolerance", "", 1.0), ("Red", "", 40.0)).splitlines()
    text = "\n".join(
        row if row.split(";")[2] in ("15", "Angle") else f";{row.partition(';')[2]}" for row in rows
    )
    found = samples(tmp_path, text)
    assert [(one.name, one.readings[2].lab[0]) for one in found.samples] == [("Blue", 50.0), ("Red", 40.0)]


@pytest.mark.parametrize("around", ["Tolerance", "Deltas", "UpperLimit", "StdDev", "Mean"])
def test_elements_of_tolerances_and_differences_are_left_out(tmp_path: Path, around: str) -> None:
    def tree(value: float) -> str:
        return "".join(
            f'<Reading Geometry="45as{at}"><L>{value}</L><a>0</a><b>0</b></Reading>' for at in (15, 45, 110)
        )

    text = f'<Export><Sample Name="Blue"><{around}>{tree(1.0)}</{around}>{tree(50.0)}</Sample></Export>'
    found = samples(tmp_path, text)
    assert [[reading.lab[0] for reading in sample.readings] for sample in found.samples] == [[50.0] * 3]
    note = "Elements of differences, tolerances or statistics are left out: 1."
    assert note in found.notes
    assert note in read_content(text.encode(), "a.xml").notes


def test_means_are_read_where_there_is_nothing_else(tmp_path: Path) -> None:
    tree = "".join(f'<R Geometry="45as{at}"><L>50</L><a>0</a><b>0</b></R>' for at in (15, 45, 110))
    found = samples(tmp_path, f'<Export><Sample Name="Blue"><Mean>{tree}</Mean></Sample></Export>')
    assert len(found.samples[0].readings) == 3
    red = f'<Sample Name="Red"><Reading1>{tree}</Reading1><Average1>{tree}</Average1></Sample>'
    found = samples(tmp_path, f'<Export>{red}<Sample Name="Blue"><Average>{tree}</Average></Sample></Export>')
    assert [(one.name, one.measurements) for one in found.samples] == [("Red", 1), ("Blue", 1)]
    assert "Elements of differences, tolerances or statistics are left out: 1." in found.notes


def test_rows_may_be_ordered_by_angle(tmp_path: Path) -> None:
    rows = [(name, at, lightness) for at in (15, 45, 110) for name, lightness in (("Blue", 50), ("Red", 40))]
    text = "\n".join(("Sample;Angle;L*;a*;b*", *(f"{name};{at};{l_star};0;0" for name, at, l_star in rows)))
    found = samples(tmp_path, text)
    assert [(one.name, one.measurements, len(one.readings)) for one in found.samples] == [
        ("Blue", 1, 3), ("Red", 1, 3),
    ]  # fmt: skip
    assert not any("mean of" in note for note in found.notes)
    again = [f"{name};{at};{l_star + 0.5};0;0" for name, at, l_star in rows]
    found = samples(tmp_path, "\n".join((text, *again)))
    assert [one.measurements for one in found.samples] == [2, 2]


def test_other_lights_and_other_planes_are_left_out(tmp_path: Path) -> None:
    read = {"45as15": "D65/10", "45as45": "A/10", "45as60az125.3": "D65/10", "45as110": "D65"}
    rows = "Name,Geometry,Illuminant,L,a,b\n" + "".join(
        f"S,{at},{light},50,0,0\n" for at, light in read.items()
    )
    found = samples(tmp_path, rows)
    assert [reading.geometry for reading in found.samples[0].readings] == ["45as15", "45as110"]
    assert "it is of A and the 10° observer" in found.refused[0]
    assert "out of the plane" in found.refused[1]
    none = rows.replace("D65/10", "D50/2").replace("D65", "D50")
    with pytest.raises(FileError, match="D50 and the 2° observer"):
        read_instrument(written(tmp_path, none))


def spectral(values: tuple[float, float, float], percent: str = "") -> str:
    rows = [",".join(("Name", "Geometry", *(f"{nm}{percent}" for nm in range(400, 701, 10))))]
    for geometry, value in zip(("45as15", "45as45", "45as110"), values, strict=True):
        rows.append(",".join(("S", geometry, *[repr(value)] * 31)))
    return "\n".join(rows)


@pytest.mark.parametrize(
    ("values", "percent", "factor"),
    [((1.2, 0.3, 0.1), "", 1), ((120, 30, 10), "", 100), ((5, 3, 1), " %", 100)],
)
def test_spectra_are_fractions_or_per_cent(
    tmp_path: Path, values: tuple[float, float, float], percent: str, factor: int
) -> None:
    found = samples(tmp_path, spectral(values, percent))
    bands = np.arange(400.0, 701.0, 10.0)
    for reading, value in zip(found.samples[0].readings, values, strict=True):
        assert reading.reflectance == pytest.approx([value / factor] * 31)
        assert reading.lab == pytest.approx(spectrum_to_lab(np.full(31, value / factor), bands))


@pytest.mark.parametrize("heading", ["Wavelength", "nm", "Wavelength (nm)", "λ [nm]", "Wellenlänge", ""])
@pytest.mark.parametrize("notation", ["{}", "{}°", "45as{}"])
def test_wavelengths_may_go_down_and_angles_across(tmp_path: Path, heading: str, notation: str) -> None:
    rows = [";".join((heading, *(notation.format(angle) for angle in (15, 45, 110))))]
    rows += [f"{nm};0,9;0,3;0,1" for nm in range(400, 701, 10)]
    sample = samples(tmp_path, "\n".join(rows)).samples[0]
    assert sample.name == "unnamed"
    assert [reading.reflectance for reading in sample.readings] == [(0.9,) * 31, (0.3,) * 31, (0.1,) * 31]


def test_spectra_that_may_be_either_are_refused_with_what_to_do(tmp_path: Path) -> None:
    with pytest.raises(FileError, match=r"may be per cent or fractions.*write % into a heading"):
        read_instrument(written(tmp_path, spectral((5.0, 0.8, 0.4))))


def test_one_bad_spectrum_leaves_the_rest(tmp_path: Path) -> None:
    rows = spectral((1.2, 0.3, 0.1)).splitlines()
    rows[2] = rows[2].replace("0.3", "?", 1)
    found = samples(tmp_path, "\n".join(rows))
    assert [reading.geometry for reading in found.samples[0].readings] == ["45as15", "45as110"]
    assert found.refused == ("line 3: a spectrum with '?' in the place of a number is left out",)


def test_a_table_names_what_it_has_and_what_is_wanted(tmp_path: Path) -> None:
    with pytest.raises(
        FileError, match=r"has the columns 'part', 'price'; wanted are name.*hex, or R G B"
    ) as caught:
        read_palette(written(tmp_path, "part,price\nbolt,3\n"))
    assert caught.value.place == "line 1"
    with pytest.raises(FileError, match="there twice, and no heading says"):
        read_palette(written(tmp_path, "name,L,a,b,L,a,b\nx,1,2,3,4,5,6\n"))


@pytest.mark.parametrize(
    ("text", "place", "reason"),
    [
        ("name,R,G,B\na,1,2,3\nb,1,2,999\n", "line 3", "from 0 to 255"),
        ("name,R,G,B\na,1,two,3\n", "line 2", "expected 3 numbers of RGB"),
        ("name,hex\na,#12345\n", "line 2", "expected a hex code"),
        ("name,hex\na,#d4000080\nb,#80d400ff\n", "the codes", "nothing says whether the first or the last"),
        ("name,hex\na,#ffd400ff\n", "the codes", "nothing says whether the first or the last"),
        ("name,C,M,Y,K\na,0,0,0,150\n", "line 2", "from 0 to 100"),
        ("name,L,a,b\na,43,25,66,5,54,75\n", "line 2", "7 cells under 4 headings"),
        ("name,L1,a1,b1,L2,a2,b2\na,1,2,3,4,5,6\n", "the header", "number readings 1, 2"),
    ],
)
def test_a_cell_that_is_no_colour_is_named(text: str, place: str, reason: str) -> None:
    with pytest.raises(FileError, match=reason) as caught:
        read_content(text.encode(), "a.csv")
    assert caught.value.place == place


def test_zeros_that_a_spreadsheet_took_away_come_back() -> None:
    read = read_content(b"name,hex\nblack,0\nnight,1122\nred,d40000\n", "a.csv")
    assert [entry.content.values for entry in read.palette] == [
        (0.0, 0.0, 0.0), (0.0, 0x11 / 255, 0x22 / 255), (0xD4 / 255, 0.0, 0.0),
    ]  # fmt: skip
    assert any("2 hex codes had lost their zeros" in note for note in read.notes)
    read = read_content(b"name,hex\na,255\nb,128\n", "a.csv")
    assert read.palette.entries[0].content.values == (0x22 / 255, 0x55 / 255, 0x55 / 255)
    assert any("2 hex codes of three digits are taken for short ones" in note for note in read.notes)
    assert read_content(b"name,hex\na,255\nb,12f\n", "a.csv").notes == ()


@pytest.mark.parametrize("heading", ["L,a,b", "L,C,h"])
def test_lightness_of_at_most_1_is_pointed_out(heading: str) -> None:
    read = read_content(f"name,{heading}\na,0.6,0.2,0.1\nb,0.4,0.1,0.3\n".encode(), "a.csv")
    assert any("No L* is above 1" in note for note in read.notes)
    read = read_content(f"name,{heading}\na,0.6,0.2,0.1\nb,40,0.1,0.3\n".encode(), "a.csv")
    assert not any("No L* is above 1" in note for note in read.notes)


def test_hues_in_shares_of_the_circle_are_pointed_out() -> None:
    read = read_content(b"name,H,S,L\na,0.5,0.2,0.1\n", "a.csv")
    assert any("shares of the circle" in note for note in read.notes)
    assert read_content(b"name,H,S,L\na,0.5,20,10\n", "a.csv").palette.entries[0].content.values[0] == 0.5


def test_numbers_of_colours_stay_names_beside_codes_alone() -> None:
    read = read_content(b"100020,d40000\n100120,0000d4\n", "a.csv")
    assert [entry.name for entry in read.palette] == ["100020", "100120"]
    assert len(read_content(b"100020 300040\n100120 200020\n", "a.txt").palette.entries) == 4


@pytest.mark.parametrize("heading", ["Color Code", "Colour Code", "Farbcode"])
def test_a_column_called_code_has_numbers_of_articles_beside_colours(heading: str) -> None:
    text = f"Name,{heading},Color\nA,100123,#ff0000\nB,A00223,#00ff00\n"
    entries = read_content(text.encode(), "a.csv").palette.entries
    assert [entry.code for entry in entries] == ["100123", "A00223"]
    assert [entry.content.values for entry in entries] == [(1.0, 0.0, 0.0), (0.0, 1.0, 0.0)]
    text = f"Name,{heading},R,G,B\nA,100123,255,0,0\nB,A00223,0,255,0\n"
    assert [entry.code for entry in read_content(text.encode(), "a.csv").palette] == ["100123", "A00223"]
    text = f"Name,{heading}\nA,100123\nB,#00ff00\n"
    assert len(read_content(text.encode(), "a.csv").palette.entries) == 2
    with pytest.raises(FileError):
        read_content(text.replace("#00ff00", "200223").encode(), "a.csv", find_format("table"))


def test_marks_between_numbers_in_one_cell_and_small_tristimulus_values() -> None:
    read = read_content(b"RAL,RGB,CMYK\nRAL 1000,205-186-136,0-9-34-20\n", "a.csv")
    colour = read.palette.entries[0].content
    assert colour.name == "RAL 1000"
    assert colour.values == (205 / 255, 186 / 255, 136 / 255)
    assert colour.others[0].values == (0.0, 0.09, 0.34, 0.2)
    read = read_content(b"name,X,Y,Z\na,0.4,0.5,0.6\nb,0.9,1,1.08\n", "a.csv")
    assert read.palette.entries[0].content.values == pytest.approx((40.0, 50.0, 60.0))
    assert any("white of 1" in note for note in read.notes)


@pytest.fixture(params=["export.csv", "export.xml", "export.cxf"])
def file(request: pytest.FixtureRequest, tmp_path: Path) -> Path:
    """A sample in each kind of file."""
    text = "\n".join((HEAD + ";Si15;G", SILVER + ";4,2;3,1"))
    path = written(tmp_path, text)
    if request.param.endswith(".cxf"):
        read = read_palette(path).palette
        path = tmp_path / request.param
        write_palette(read, path)
    elif request.param.endswith(".xml"):
        readings = "".join(
            f'<Reading Geometry="45as{angle}"><L>{lab[0]}</L><a>{lab[1]}</a><b>{lab[2]}</b></Reading>'
            for angle, lab in ((15, (120, 0.5, -1)), (45, (62, 0, -1.5)), (110, (38, -0.5, -2)))
        )
        effects = '<Sparkle Angle="15"><Si>4.2</Si></Sparkle><Graininess>3.1</Graininess>'
        text = f'<Export><Sample Name="Silver">{readings}{effects}</Sample></Export>'
        path = written(tmp_path, text, request.param)
    return path


def test_a_sample_is_a_standard_a_paint_and_a_palette(file: Path) -> None:
    standard = load_standards(file)[0]
    assert standard.name == "Silver"
    assert [reading.lab for reading in standard.readings] == [
        (120.0, 0.5, -1.0),
        (62.0, 0.0, -1.5),
        (38.0, -0.5, -2.0),
    ]
    assert any("graininess 3.1" in notice for notice in standard.notices)
    material = load_material(file)
    assert isinstance(material.document, Paint)
    assert material.document.lab_at(45.0) == (62.0, 0.0, -1.5)
    assert "sparkle intensity 15° 4.2" in material.document.notes
    # A paint that was written has a gloss.
    assert file.suffix == ".cxf" or any("90 GU" in notice for notice in material.notices)
    entry = read_palette(file).palette.entries[0]
    assert json.loads(dict(entry.foreign)["instrument.effects"]) == {
        "sparkle intensity 15°": 4.2,
        "graininess": 3.1,
    }


def test_commands_take_it(file: Path, capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    assert main(["measure", str(file), "--json"]) == 0
    assert main(["judge", str(file), str(file)]) == 0
    assert main(["design", "start", str(file), "-o", str(tmp_path / "out.brdfpaint")]) == 0
    assert main(["export", str(file), "-o", str(tmp_path / "out.csv")]) == 0
    assert main(["palette", "find", "fine_silver", "--in", str(file)]) == 0
    assert "Silver" in capsys.readouterr().out


def test_commands_say_that_the_layout_is_not_published(
    file: Path, capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    for words in (
        ["palette", "info", str(file)],
        ["palette", "convert", str(file), "-o", str(tmp_path / "out.gpl")],
        ["convert", str(file), "-o", str(tmp_path / "out.merl")],
        ["design", "start", str(file), "-o", str(tmp_path / "out.brdfpaint")],
    ):
        assert main(words) == 0
        # CxF3 is published.
        said = "The layout of the table is not published" in "".join(capsys.readouterr())
        assert said == (file.suffix != ".cxf"), words


def test_effects_go_into_cxf_and_come_back_once(file: Path, tmp_path: Path) -> None:
    first = read_palette(file).palette
    again = tmp_path / "again.cxf"
    write_palette(first, again)
    back = read_palette(again).palette
    assert back.entries[0].content == first.entries[0].content
    assert (
        dict(back.entries[0].foreign)["instrument.effects"]
        == dict(first.entries[0].foreign)["instrument.effects"]
    )


def test_effects_that_are_no_numbers_are_left_out(file: Path, tmp_path: Path) -> None:
    palette = read_palette(file).palette
    effects = f'{{"graininess": 3.1, "sparkle": {10**400}, "area": NaN, "grade": "4"}}'
    entry = replace(palette.entries[0], foreign=(("instrument.effects", effects),))
    assert kept_effects(entry) == {"graininess": 3.1}
    write_palette(replace(palette, entries=(entry,)), tmp_path / "again.cxf")


def test_files_of_other_kinds_are_no_instrument(tmp_path: Path) -> None:
    assert read_instrument(written(tmp_path, "name,hex\na,#010203\n")) is None
    assert read_instrument(written(tmp_path, '{"a": "#010203"}', "a.json")) is None
    assert read_instrument(written(tmp_path, "some words\nand more\n", "a.txt")) is None
