"""CxF3 of others: what is read of it, what is refused and where."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np
import pytest

from brdf_suite.appearance.colour.colorimetry import lab_to_xyz
from brdf_suite.appearance.colour.spaces import lab_to_lch
from brdf_suite.appearance.colour.spectra import spectrum_to_lab
from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.errors import FileError, ValueRangeError
from brdf_suite.files.cxf import read_cxf
from brdf_suite.files.hardened_xml import DEEPEST
from brdf_suite.files.palettes import read_palette, write_palette

LABS = {15: (62.0, -4.0, -45.0), 45: (25.0, 4.0, -38.0), 110: (9.0, 8.0, -28.0)}


def specification(
    name: str, angles: str, light: str = "D65", observer: str = "10_Degree", more: str = ""
) -> str:
    return (
        f'<ColorSpecification Id="{name}"><TristimulusSpec><Illuminant>{light}</Illuminant>'
        f"<Observer>{observer}</Observer><Method>E308_Table5</Method></TristimulusSpec><MeasurementSpec>"
        "<MeasurementType>Colorimetric_Reflectance</MeasurementType>"
        f"<GeometryChoice><MultiAngle>{angles}</MultiAngle></GeometryChoice>{more}</MeasurementSpec>"
        "</ColorSpecification>"
    )


def angle(aspecular: float, *, azimuth: float | None = None, light: float = 45.0) -> str:
    out = "" if azimuth is None else f"<Azimuth>{azimuth}</Azimuth>"
    return (
        f'<BRDFAngle Notation="{light:g}as{aspecular:g}"><IlluminationAngle>{light}</IlluminationAngle>'
        f"<Aspecular>{aspecular}</Aspecular>{out}</BRDFAngle>"
    )


def document(values: str, specifications: str, more: str = "") -> str:
    return (
        '<?xml version="1.0" encoding="UTF-8"?>\n<CxF xmlns="http://colorexchangeformat.com/CxF3-core">\n'
        '<Resources><ObjectCollection><Object ObjectType="Standard" Name=" 漢字\n blue " Id="o1">'
        f"<CreationDate>2026-01-01T00:00:00Z</CreationDate>\n<ColorValues>\n{values}\n</ColorValues>{more}</Object>"
        f"</ObjectCollection>\n<ColorSpecificationCollection>\n{specifications}\n</ColorSpecificationCollection>"
        "</Resources></CxF>"
    )


def lab_value(lab: tuple[float, float, float], name: str, attribute: str = "") -> str:
    return (
        f'<ColorCIELab ColorSpecification="{name}" {attribute}><L>{lab[0]}</L><A>{lab[1]}</A><B>{lab[2]}</B>'
        "</ColorCIELab>"
    )


def three(**more: str) -> str:
    values = "\n".join(lab_value(lab, f"s{at}") for at, lab in LABS.items())
    return document(values, "\n".join(specification(f"s{at}", angle(at)) for at in LABS), **more)


@pytest.fixture
def written(tmp_path: Path):
    def write(text: str | bytes) -> Path:
        path = tmp_path / "others.cxf"
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
        return path

    return write


def test_a_specification_per_angle_is_read_with_name_and_gloss(written) -> None:
    gloss = '<PhysicalAttributes><Gloss Method="GU 20°">88</Gloss><Gloss Method="60">94</Gloss></PhysicalAttributes>'
    sample = read_cxf(written(three(more=gloss))).samples[0]
    assert sample.name == "漢字 blue"
    assert {reading.aspecular_deg: reading.lab for reading in sample.readings} == LABS
    paint = sample.paint()
    assert (paint.gloss.gu_20, paint.gloss.gu_60) == (88.0, 94.0)
    assert paint.lab_at(45.0, 45.0) == LABS[45]


def test_unknown_gloss_is_reported(written) -> None:
    found = read_cxf(written(three()))
    assert found.samples[0].gloss is None
    assert "gloss" in found.notes[0]


def test_values_named_after_one_of_several_angles_are_distinguished(written) -> None:
    shared = specification("all", "".join(angle(at) for at in LABS))
    values = "".join(lab_value(lab, "all", f'Name="45as{at}"') for at, lab in LABS.items())
    assert {r.geometry: r.lab for r in read_cxf(written(document(values, shared))).samples[0].readings} == {
        f"45as{at}": lab for at, lab in LABS.items()
    }
    nameless = "".join(lab_value(lab, "all") for lab in LABS.values())
    with pytest.raises(FileError, match="no name says which"):
        read_cxf(written(document(nameless, shared)))


def test_lch_and_xyz_become_the_same_colour(written) -> None:
    lch, xyz = lab_to_lch(LABS[45]), lab_to_xyz(LABS[110])
    values = (
        lab_value(LABS[15], "s15")
        + f'<ColorCIELCh ColorSpecification="s45"><L>{lch[0]}</L><C>{lch[1]}</C><H>{lch[2]}</H></ColorCIELCh>'
        + f'<ColorCIEXYZ ColorSpecification="s110"><X>{xyz[0]}</X><Y>{xyz[1]}</Y><Z>{xyz[2]}</Z></ColorCIEXYZ>'
    )
    found = read_cxf(written(document(values, "".join(specification(f"s{at}", angle(at)) for at in LABS))))
    for reading in found.samples[0].readings:
        assert reading.lab == pytest.approx(LABS[int(reading.aspecular_deg)], abs=1e-9)
    assert any("from LCh" in note for note in found.notes)


def test_a_spectrum_replaces_the_colour_of_another_light_and_nothing_else_does(written) -> None:
    row = np.linspace(0.2, 1.4, 31)
    bands = '<WavelengthRange StartWL="400" Increment="10"/>'
    of_a = specification("a", angle(15), "A", "2_Degree", bands)
    colour = lab_value((50.0, 0.0, 0.0), "a")
    spectrum = f'<ReflectanceSpectrum ColorSpecification="a">{" ".join(map(repr, row.tolist()))}</ReflectanceSpectrum>'
    reading = read_cxf(written(document(colour + spectrum, of_a))).samples[0].readings[0]
    assert reading.lab == pytest.approx(spectrum_to_lab(row), abs=1e-12)
    assert reading.converted == "recomputed from the spectrum"
    assert reading.wavelengths_nm is not None
    assert reading.wavelengths_nm[-1] == 700.0
    with pytest.raises(FileError, match="without a spectrum it cannot become that of D65 and 10°"):
        read_cxf(written(document(colour, of_a)))


def test_a_reading_out_of_the_plane_is_left_out_and_reported(written) -> None:
    values = "".join(lab_value(lab, f"s{at}") for at, lab in LABS.items()) + lab_value((1, 2, 3), "out")
    specs = "".join(specification(f"s{at}", angle(at)) for at in LABS)
    found = read_cxf(written(document(values, specs + specification("out", angle(25, azimuth=30)))))
    assert len(found.samples[0].readings) == 3
    assert "out of the plane" in found.refused[0]


def test_two_readings_make_no_paint(written) -> None:
    specs = "".join(specification(f"s{at}", angle(at)) for at in (15, 45))
    text = document(lab_value(LABS[15], "s15") + lab_value(LABS[45], "s45"), specs)
    with pytest.raises(ValueRangeError, match="3 angles"):
        read_cxf(written(text)).samples[0].paint()


BOMB = '<!DOCTYPE CxF [<!ENTITY a "ha"><!ENTITY b "&a;&a;&a;&a;">]>\n'
FILE = '<!DOCTYPE CxF [<!ENTITY a SYSTEM "file:///etc/hostname">]>\n'


@pytest.mark.parametrize(
    ("change", "place", "reason"),
    [
        (lambda t: t.replace("<CxF", BOMB + "<CxF", 1), "line 2", "document type"),
        (lambda t: t.replace("<CxF", FILE + "<CxF", 1), "line 2", "document type"),
        (lambda t: t[: len(t) // 2], "line", "not valid XML"),
        (lambda t: t.replace("<Aspecular>110", "<Aspecular>140"), "line", "below the surface"),
        (lambda t: t.replace("CxF3-core", "CxF4"), "line 2", "not CxF3"),
        (lambda t: t.replace('Id="s45"', 'Id="s15"'), "line", "two ColorSpecifications"),
        (lambda t: t.replace("<L>62.0</L>", "<x>" * DEEPEST + "</x>" * DEEPEST), "line 6", "nested deeper"),
        (lambda t: t.replace("UTF-8", "no-such"), "", "valid XML|encoding"),
        (lambda t: "", "", "no element|valid XML"),
    ],
)
def test_hostile_and_damaged_files_are_refused_with_the_line(
    written, change, place: str, reason: str
) -> None:
    with pytest.raises(FileError, match=reason) as caught:
        read_cxf(written(change(three())))
    assert place in (caught.value.place or "")


@pytest.mark.parametrize(
    ("before", "after", "reason"),
    [
        (
            "<L>62.0</L>",
            "<L>nan</L>",
            "a colour is left out: expected a finite number for L, not 'nan' (line 6)",
        ),
        (
            "<L>62.0</L>",
            "<L>1e999</L>",
            "a colour is left out: expected a finite number for L, not '1e999' (line 6)",
        ),
        ("<L>62.0</L>", "<L>620</L>", "a colour is left out: L*: 620 is outside the range 0 to 250 (line 6)"),
        ("<L>62.0</L>", "", "a colour is left out: ColorCIELab has no L (line 6)"),
        (
            'ColorSpecification="s15"',
            'ColorSpecification="s46"',
            "a reading is left out: the ColorSpecification 's46' is not in the file (line 6)",
        ),
    ],
)
def test_a_damaged_value_leaves_the_rest(written, before: str, after: str, reason: str) -> None:
    found = read_cxf(written(three().replace(before, after)))
    assert [reading.geometry for reading in found.samples[0].readings] == ["45as45", "45as110"]
    assert found.refused == (f"漢字 blue: {reason}",)
    read = read_palette(written(three().replace(before, after)))
    assert read.palette.entries[0].content.values == LABS[45]  # two readings make no paint
    assert f"漢字 blue: {reason}." in read.notes


def multi(*objects: tuple[str, str, str]) -> str:
    """Samples at three angles: name, kind and values, in which ``{at}`` is the specification's name."""
    bands = '<WavelengthRange StartWL="400" Increment="10"/>'
    specs = "".join(specification(f"s{at}", angle(at), more=bands) for at in LABS)
    body = "".join(
        f'<Object ObjectType="{kind}" Name="{name}" Id="o{number}"><ColorValues>'
        f"{''.join(value.replace('{at}', str(at)) for at in LABS)}</ColorValues></Object>"
        for number, (name, kind, value) in enumerate(objects)
    )
    space = 'xmlns="http://colorexchangeformat.com/CxF3-core"'
    return (
        f"<CxF {space}><Resources><ObjectCollection>{body}</ObjectCollection><ColorSpecificationCollection>{specs}"
        "</ColorSpecificationCollection></Resources></CxF>"
    )


def flat_spectrum(value: str) -> str:
    return f'<ReflectanceSpectrum ColorSpecification="s{{at}}">{" ".join([value] * 31)}</ReflectanceSpectrum>'


@pytest.mark.parametrize(
    "bad", [flat_spectrum("50"), flat_spectrum("-5"), lab_value((900.0, 0.0, 0.0), "s{at}")]
)
def test_a_sample_out_of_range_leaves_the_others(written, bad: str) -> None:
    path = written(multi(("Good", "Target", flat_spectrum("0.5")), ("Bad", "Target", bad)))
    found = read_cxf(path)
    assert [sample.name for sample in found.samples] == ["Good"]
    assert all(reason.startswith("Bad: ") for reason in found.refused)
    read = read_palette(path)
    assert [entry.name for entry in read.palette] == ["Good"]
    assert any(note.startswith("The sample 'Bad' is left out: ") for note in read.notes)
    alone = written(multi(("Bad", "Target", bad)))
    for reader in (read_cxf, read_palette):
        with pytest.raises(FileError, match=r"beyond any|outside the range"):
            reader(alone)


def test_samples_of_one_name_and_kind_are_averaged_where_they_agree(written) -> None:
    values = [lab_value((level, 0.0, 0.0), "s{at}") for level in (50.0, 51.0, 80.0)]
    path = written(multi(*(("Blue", "Target", value) for value in values[:2])))
    assert [(s.measurements, s.readings[0].lab) for s in read_cxf(path).samples] == [(2, (50.5, 0.0, 0.0))]
    entries = read_palette(path).palette.entries
    assert [entry.content.lab_at(45.0) for entry in entries] == [(50.5, 0.0, 0.0)]
    path = written(re.sub(r' Name="" Id="o\d"', "", multi(*(("", "Target", value) for value in values[:2]))))
    assert len(read_cxf(path).samples) == len(read_palette(path).palette.entries) == 2
    path = written(multi(("Blue", "Standard", values[0]), ("Blue", "Sample", values[1])))
    assert len(read_cxf(path).samples) == len(read_palette(path).palette.entries) == 2
    path = written(multi(("Blue", "Target", values[0]), ("Blue", "Target", values[2])))
    assert len(read_cxf(path).samples) == len(read_palette(path).palette.entries) == 2


def test_paints_of_one_name_that_this_suite_wrote_stay_apart(written, tmp_path: Path) -> None:
    paint = read_cxf(written(three())).samples[0].paint()
    write_palette(Palette("p", (Entry(paint), Entry(paint))), tmp_path / "a.cxf")
    assert len(read_cxf(tmp_path / "a.cxf").samples) == 2
    assert len(read_palette(tmp_path / "a.cxf").palette.entries) == 2


def test_the_files_of_others_are_read_or_refused_by_name(shared_data: Path) -> None:
    files = sorted((shared_data / "palettes" / "cxf").glob("*.cxf"))
    assert files
    for path in files:
        with pytest.raises(FileError, match="holds no sample"):
            read_cxf(path)
