"""Text files of scattered measurements: read by hand-worked values, written and read again; and what goes into them."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from brdf_suite.appearance.colour.spectra import spectrum_to_working
from brdf_suite.documents.cook_torrance import CookTorranceLobe, CookTorrancePaint
from brdf_suite.documents.store import save_paint
from brdf_suite.errors import FileError
from brdf_suite.files.measured import read_measured, sniff, write_measured
from brdf_suite.files.measured.format import ReadOptions
from brdf_suite.files.measured.goniometer_rows import as_samples
from brdf_suite.fitting.metrics import aspecular_lab
from brdf_suite.geometry.directions import spherical

SPECTRAL = ("cayman.brdf", "krylon_blue.brdf")


def written(tmp_path: Path, name: str, text: str) -> Path:
    path = tmp_path / name
    path.write_bytes(text.encode())
    return path


@pytest.mark.parametrize(
    ("name", "known"),
    [
        ("cayman.brdf", "cornell"),
        ("krylon_blue.brdf", "cornell"),
        ("retro-gray-tape.dat", "alta"),
        ("bird_example.json", "bird"),
        ("paper_white_rgb.bsdf", "rgl"),
    ],
)
def test_real_files_are_known_by_content_whatever_their_name(
    shared_data: Path, tmp_path: Path, name: str, known: str
) -> None:
    path = tmp_path / "unnamed"
    path.write_bytes((shared_data / "brdf" / name).read_bytes())
    assert sniff(path).name == known
    assert read_measured(path).facts["name"]


def test_what_is_no_measurement_is_refused(shared_data: Path, tmp_path: Path) -> None:
    with pytest.raises(FileError, match="no measured format"):
        read_measured(shared_data / "brdf" / "merl_sha256.txt")
    with pytest.raises(FileError, match="is empty"):
        read_measured(written(tmp_path, "a.brdf", ""))
    with pytest.raises(FileError, match="cannot be read"):
        read_measured(tmp_path / "missing.brdf")
    with pytest.raises(FileError, match="is a folder"):
        read_measured(tmp_path)
    with pytest.raises(FileError, match=r"the ending \.xyz names no format"):
        write_measured(read_measured(shared_data / "brdf" / "cayman.brdf"), tmp_path / "a.xyz")


# --- Cornell ---------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("name", "content"), [("a.axf", b"anything"), ("b.dat", b"\x89HDF\r\n\x1a\n" + bytes(90))]
)
def test_axf_is_refused_with_the_way_through_cxf3(tmp_path: Path, name: str, content: bytes) -> None:
    (tmp_path / name).write_bytes(content)
    with pytest.raises(FileError, match="export its measurements as CxF3"):
        read_measured(tmp_path / name)


def test_the_first_row_of_cayman_is_what_the_file_says(shared_data: Path) -> None:
    value = read_measured(shared_data / "brdf" / "cayman.brdf")
    assert value.facts["samples"] == 1439
    assert "Cayman" in str(value.facts["name"])
    np.testing.assert_allclose(value.wi[0], spherical(0.872665, 0.0), atol=1e-15)
    np.testing.assert_allclose(value.wo[0], spherical(0.573513, 0.0), atol=1e-15)
    np.testing.assert_array_equal(value.spectra[0, :3], [0.000874, 0.001991, 0.003068])
    np.testing.assert_array_equal(value.wavelengths_nm, np.arange(400.0, 701.0, 10.0))
    colour = np.maximum(spectrum_to_working(value.spectra, value.wavelengths_nm, 10), 0.0)
    np.testing.assert_allclose(value.values, colour, rtol=1e-12)


def test_the_colours_are_those_of_the_names(shared_data: Path) -> None:
    blue = aspecular_lab(read_measured(shared_data / "brdf" / "krylon_blue.brdf"), 45.0)
    assert blue[2] < -30.0
    assert abs(blue[1]) < 15.0
    cayman = aspecular_lab(read_measured(shared_data / "brdf" / "cayman.brdf"), 45.0)
    assert cayman[1] < -20.0  # a bluish green


@pytest.mark.parametrize("name", SPECTRAL)
@pytest.mark.parametrize("ending", [".brdf", ".astm", ".json"])
def test_spectra_survive_load_save_load(shared_data: Path, tmp_path: Path, name: str, ending: str) -> None:
    first = read_measured(shared_data / "brdf" / name)
    copy_ = tmp_path / f"copy{ending}"
    assert write_measured(first, copy_).format == sniff(copy_)
    second = read_measured(copy_)
    np.testing.assert_array_equal(second.spectra, first.spectra)
    np.testing.assert_array_equal(second.wavelengths_nm, first.wavelengths_nm)
    np.testing.assert_allclose(second.wi, first.wi, atol=1e-14)
    np.testing.assert_allclose(second.wo, first.wo, atol=1e-14)
    np.testing.assert_array_equal(second.values, first.values)


def test_the_observer_is_the_one_asked_for_and_reported(shared_data: Path) -> None:
    path = shared_data / "brdf" / "krylon_blue.brdf"
    ten, two = read_measured(path), read_measured(path, options=ReadOptions(observer_deg=2))
    assert ten.facts["observer_deg"] == 10
    assert two.facts["observer_deg"] == 2
    assert np.abs(ten.values - two.values).max() > 1e-4
    np.testing.assert_array_equal(ten.spectra, two.spectra)


CORNELL = "# a\n2\n500 600\n0.5 0 0.5 3.14159265358979 0.25 0.5\n0.1 0 0.2 1.0 0.125 -0.5\n"


def test_a_small_cornell_file_by_hand(tmp_path: Path) -> None:
    value = read_measured(written(tmp_path, "a.brdf", CORNELL))
    np.testing.assert_array_equal(value.spectra, [[0.25, 0.5], [0.125, 0.0]])
    assert value.facts["negative values raised to 0"] == 1
    assert value.isotropic
    np.testing.assert_allclose(value.wo[0], value.wi[0] * (-1.0, -1.0, 1.0), atol=1e-12)  # the mirror


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (CORNELL.replace("0.25 0.5\n", "0.25\n"), "line 4: expected 6 numbers"),
        (CORNELL.replace("0.125", "nan"), "line 5: expected a finite number"),
        (CORNELL.replace("0.125", "1e999"), "line 5: expected a finite number"),
        (CORNELL.replace("0.125", "1_0"), "line 5: expected a finite number"),
        (CORNELL.replace("0.1 0", "1.9 0"), "line 5: the direction"),
        (CORNELL.replace("0.125", "1e13"), "line 5: a value is too large"),
        (CORNELL.replace("500 600", "600 500"), "line 3: the wavelengths do not rise"),
        (CORNELL.replace("500 600", "500 600 700"), "line 3: 3 wavelengths are named where 2"),
        ("2\n500 600\n", "the end of the file: holds no samples"),
        ("2\n500\n", "line 2: the file ends before the first sample"),
        (CORNELL.replace("2\n", "2\0\n"), "NUL byte"),
    ],
)
def test_damaged_cornell_files_name_the_line(tmp_path: Path, text: str, words: str) -> None:
    from brdf_suite.files.measured.cornell import read_cornell

    with pytest.raises(FileError) as caught:
        read_cornell(written(tmp_path, "a.brdf", text))
    assert words in str(caught.value)


def test_colours_without_spectra_are_not_written_as_spectra(tmp_path: Path, shared_data: Path) -> None:
    tape = read_measured(shared_data / "brdf" / "retro-gray-tape.dat")
    with pytest.raises(FileError, match="holds spectra"):
        write_measured(tape, tmp_path / "a.brdf")
    assert not (tmp_path / "a.brdf").exists()


# --- ALTA ------------------------------------------------------------------------------------------------


def test_the_tape_sends_light_back_to_the_light(shared_data: Path) -> None:
    tape = read_measured(shared_data / "brdf" / "retro-gray-tape.dat")
    assert tape.facts["samples"] == 7405
    wi = spherical(np.radians(15.0), 0.0)
    back = tape.eval(wi, wi)
    np.testing.assert_allclose(back, 72.45680592991914, rtol=1e-6)  # the largest number of the file, grey
    assert tape.eval(wi, wi * (-1.0, -1.0, 1.0)).max() < 0.1 * back.max()


def alta(parameters: str, rows: str, outputs: int = 1, more: str = "") -> str:
    count = len(rows.splitlines()[0].split()) - outputs - (1 if "#VS 1" in more else 0)
    return f"#DIM {count} {outputs}\n{more}#PARAM_IN {parameters}\n{rows}"


@pytest.mark.parametrize(
    ("parameters", "row"),
    [
        ("ISOTROPIC_TL_TV_PROJ_DPHI", "0.3 {x} {y} 2.0"),
        ("ISOTROPIC_TV_TL_DPHI", "0.7 0.3 2.0 2.0"),
        ("SPHERICAL_TL_PL_TV_PV", "0.3 0 0.7 2.0 2.0"),
        ("CARTESIAN", "{v} {l} 2.0"),
    ],
)
def test_every_way_to_name_a_pair_gives_that_pair(tmp_path: Path, parameters: str, row: str) -> None:
    light, view = spherical(0.3, 0.0), spherical(0.7, 2.0)
    text = row.format(
        x=0.7 * math.cos(2.0),
        y=0.7 * math.sin(2.0),
        v=" ".join(map(repr, view.tolist())),
        l=" ".join(map(repr, light.tolist())),
    )
    value = read_measured(written(tmp_path, "a.alta", alta(parameters, text + "\n")))
    np.testing.assert_allclose(value.wi[0] @ value.wo[0], light @ view, atol=1e-12)
    np.testing.assert_allclose([value.wi[0, 2], value.wo[0, 2]], [light[2], view[2]], atol=1e-12)
    np.testing.assert_array_equal(value.values, 2.0)


def test_half_angles_of_alta(tmp_path: Path) -> None:
    value = read_measured(written(tmp_path, "a.alta", alta("RUSIN_TH_TD_PD", "0.2 0.4 1.5 1.0\n")))
    half = value.wi[0] + value.wo[0]
    half /= np.linalg.norm(half)
    assert half[2] == pytest.approx(math.cos(0.2))
    assert half @ value.wi[0] == pytest.approx(math.cos(0.4))


def test_intervals_are_passed_over_and_cosines_taken_out(tmp_path: Path) -> None:
    more = "#VS 1\n#PARAM_OUT INV_STERADIAN_COSINE_FACTOR\n"
    value = read_measured(written(tmp_path, "a.alta", alta("ISOTROPIC_TV_TL", "0.2 1.0 3.0 0.1\n", 1, more)))
    np.testing.assert_allclose(value.values, 3.0 / math.cos(0.2))  # of the view, the first column


def test_the_cosine_of_alta_is_that_of_the_view(shared_data: Path, tmp_path: Path) -> None:
    """With it a measured retro-reflector is reciprocal: the same pairs were measured in both directions."""
    value = read_measured(shared_data / "brdf" / "retro-3M-jaune.dat")
    at_light, at_view = (np.degrees(np.arccos(w[:, 2])).round(1) for w in (value.wi, value.wo))
    apart = np.degrees(np.arccos(np.einsum("ni,ni->n", value.wi, value.wo).clip(-1.0, 1.0))).round(1)
    means: dict[tuple[float, float, float], list[float]] = {}
    for key, found in zip(zip(at_light, at_view, apart, strict=True), value.values[:, 0], strict=True):
        means.setdefault(key, []).append(found)
    ratios = [
        np.mean(found) / np.mean(means[view, light, angle])
        for (light, view, angle), found in means.items()
        if light < view and (view, light, angle) in means
    ]
    assert len(ratios) > 50
    assert np.median(np.abs(np.log(ratios))) < 0.03  # 1.1 with the cosine of the light
    # A value times a cosine of 0 says nothing of the value; such rows must not become peaks.
    assert value.facts["rows with the view on the horizon left out"] == 86
    assert value.wo[:, 2].min() > 0.01
    write_measured(value, tmp_path / "again.alta")
    again = read_measured(tmp_path / "again.alta")
    np.testing.assert_allclose(again.values, value.values, rtol=1e-12)
    np.testing.assert_allclose(again.wi, value.wi, atol=1e-14)
    np.testing.assert_allclose(again.wo, value.wo, atol=1e-14)


def test_alta_with_all_views_on_the_horizon_holds_no_samples(tmp_path: Path) -> None:
    text = alta("ISOTROPIC_TV_TL", f"{math.pi / 2} 1.0 3.0\n", 1, "#PARAM_OUT INV_STERADIAN_COSINE_FACTOR\n")
    with pytest.raises(FileError, match="holds no samples"):
        read_measured(written(tmp_path, "a.alta", text))


def test_rgb_of_alta_is_rec_709(tmp_path: Path) -> None:
    text = alta("ISOTROPIC_TV_TL", "0.2 1.0 0.5 0.25 0.125\n", 3, "#PARAM_OUT RGB_COLOR\n")
    path, again = written(tmp_path, "a.alta", text), tmp_path / "b.alta"
    value = read_measured(path)
    from brdf_suite.appearance.colour.colorimetry import WORKING_TO_SRGB

    np.testing.assert_allclose(value.values[0] @ WORKING_TO_SRGB.T, [0.5, 0.25, 0.125])
    write_measured(value, again)
    np.testing.assert_allclose(read_measured(again).values, value.values, rtol=1e-12)


def test_spectra_that_a_format_cannot_hold_are_left_out_aloud(shared_data: Path, tmp_path: Path) -> None:
    cayman = read_measured(shared_data / "brdf" / "cayman.brdf")
    done = write_measured(cayman, tmp_path / "a.alta")
    assert "spectra were left out" in done.notes[0]
    np.testing.assert_allclose(read_measured(tmp_path / "a.alta").values, cayman.values, atol=1e-12)


def test_alta_written_again_is_the_same(shared_data: Path, tmp_path: Path) -> None:
    first = read_measured(shared_data / "brdf" / "retro-gray-tape.dat")
    write_measured(first, tmp_path / "copy.dat")
    second = read_measured(tmp_path / "copy.dat")
    np.testing.assert_array_equal(second.values, first.values)
    np.testing.assert_allclose(second.wi, first.wi, atol=1e-14)
    np.testing.assert_allclose(second.wo, first.wo, atol=1e-14)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (alta("NEUMANN_9D", "0 0 1\n"), "PARAM_IN is NEUMANN_9D"),
        ("#DIM 3 1\n#PARAM_IN ISOTROPIC_TV_TL\n0 0 0 1\n", "has 2 inputs; DIM says 3"),
        (alta("ISOTROPIC_TV_TL", "0 0 1\n0 0\n"), "line 4: expected 3 numbers"),
        (alta("ISOTROPIC_TV_TL", "0 0 1\n", 1, "#PARAM_OUT ENERGY\n"), "PARAM_OUT is ENERGY"),
        ("#DIM 99 x\n#PARAM_IN ISOTROPIC_TV_TL\n", "line 1"),
        ("#DIM 2 1\n#PARAM_IN ISOTROPIC_TV_TL\n", "before the first row"),
    ],
)
def test_damaged_alta_files_name_the_place(tmp_path: Path, text: str, words: str) -> None:
    with pytest.raises(FileError) as caught:
        read_measured(written(tmp_path, "a.alta", text))
    assert words in str(caught.value)


# --- ASTM ------------------------------------------------------------------------------------------------

ASTM = (
    'LAB_NAME x\nSAMPLE_NAME "Chip"\nNUM_POINTS 2\nVARS theta_i,phi_i,theta_r,phi_r,R,G,B\n'
    "0.1,0,0.2,3.0,0.5,0.25,0.125\n0.3,0,0.4,1.0,1,1,1\n"
)


def test_a_small_astm_file_by_hand(tmp_path: Path) -> None:
    value = read_measured(written(tmp_path, "a.astm", ASTM))
    np.testing.assert_allclose(value.wo[0], spherical(0.2, 3.0))
    np.testing.assert_allclose(value.values[1], 1.0, rtol=1e-12)  # the same white in both spaces
    assert value.facts["name"] == "Chip"
    spectral = ASTM.replace("R,G,B", "465nm,525nm,630nm")
    value = read_measured(written(tmp_path, "b.astm", spectral))
    np.testing.assert_array_equal(value.wavelengths_nm, [465.0, 525.0, 630.0])
    xyz = read_measured(written(tmp_path, "c.astm", ASTM.replace("R,G,B", "X,Y,Z")))
    assert xyz.values[0].argmax() == 0


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("NUM_POINTS 2", "NUM_POINTS 3", "announces 3 samples, the file holds 2"),
        ("R,G,B", "R,G", "line 4: the value columns"),
        (",phi_r", "", "line 4: VARS must name"),
        ("0.25,", "", "line 5: expected 7 numbers"),
        ("0.25", "inf", "line 5: expected a finite number"),
    ],
)
def test_damaged_astm_files_name_the_place(tmp_path: Path, old: str, new: str, words: str) -> None:
    with pytest.raises(FileError) as caught:
        read_measured(written(tmp_path, "a.astm", ASTM.replace(old, new)))
    assert words in str(caught.value)


# --- pgII ------------------------------------------------------------------------------------------------

PGII = '#sample_name "Foil"\n#format: theta phi BSDF\n#incident_angle 30 0\n60 180 0.5\n30 180 4.0\n150 0 9\n'


def test_a_small_pgii_file_by_hand(tmp_path: Path) -> None:
    value = read_measured(written(tmp_path, "a.dat", PGII))
    assert sniff(tmp_path / "a.dat").name == "pgii"
    np.testing.assert_array_equal(value.values[:, 0], [0.5, 4.0])
    assert value.facts["transmitted rows left out"] == 1
    np.testing.assert_allclose(value.wo[1], value.wi[1] * (-1.0, -1.0, 1.0), atol=1e-12)
    scaled = read_measured(written(tmp_path, "b.dat", PGII.replace("BSDF", "DSF")))
    np.testing.assert_allclose(scaled.values[0], 1.0)  # 0.5 over the cosine of 60°


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("#incident_angle 30 0\n", "", "no header names the incident angle"),
        ("BSDF", "XYZ", "#format names XYZ"),
        ("60 180 0.5", "60 180", "line 4: expected theta, phi and one value"),
        ("60 180 0.5", "260 180 1", "line 4: the direction"),
        ("30 0\n", "x 0\n", "line 3: expected a finite number"),
    ],
)
def test_damaged_pgii_files_name_the_place(tmp_path: Path, old: str, new: str, words: str) -> None:
    with pytest.raises(FileError) as caught:
        read_measured(written(tmp_path, "a.dat", PGII.replace(old, new)))
    assert words in str(caught.value)


# --- Cook-Torrance parameters and conversions -------------------------------------------------------------


def lobes() -> CookTorrancePaint:
    lobe = CookTorranceLobe((0.2, 0.3, 0.4), 0.3, 0.05)
    return CookTorrancePaint("Lobes", (0.1, 0.05, 0.02), (lobe,))


def test_cook_torrance_parameters_are_read_evaluated_and_written(tmp_path: Path) -> None:
    from brdf_suite.reflectance.designed.build import build_reflectance

    path, again = tmp_path / "a.brdfpaint", tmp_path / "b.brdfpaint"
    save_paint(lobes(), path)
    value = read_measured(path)
    assert value.facts["name"] == "Lobes"
    wi, wo = spherical(0.4, 0.0), spherical([0.1, 0.9, 2.0], 3.0)
    np.testing.assert_array_equal(value.eval(wi, wo), build_reflectance(lobes()).eval(wi, wo))
    assert value.eval(wi, wo)[0].min() > 0.0
    write_measured(value, again)
    assert again.read_bytes() == path.read_bytes()


def test_a_table_is_not_made_of_lobes(shared_data: Path, tmp_path: Path) -> None:
    with pytest.raises(FileError, match="Cook-Torrance lobes"):
        write_measured(read_measured(shared_data / "brdf" / "cayman.brdf"), tmp_path / "a.brdfpaint")


@pytest.mark.parametrize("ending", [".astm", ".alta"])
def test_any_reflectance_can_be_written_as_scattered_samples(tmp_path: Path, ending: str) -> None:
    from brdf_suite.reflectance.designed.build import build_reflectance

    paint = build_reflectance(lobes())
    path = tmp_path / f"a{ending}"
    notes = write_measured(paint, path).notes
    value = read_measured(path)
    assert len(value.wi) == len(as_samples(paint).wi) > 3000
    assert "pairs of directions" in notes[0]
    np.testing.assert_allclose(value.values, paint.eval(value.wi, value.wo), rtol=1e-6, atol=1e-9)


def test_spectral_samples_go_into_a_tensor_and_keep_their_bands(shared_data: Path, tmp_path: Path) -> None:
    first = read_measured(shared_data / "brdf" / "krylon_blue.brdf")
    from brdf_suite.files.measured.rgl import read_rgl, write_rgl
    from brdf_suite.reflectance.tensor.tabulate import tabulate

    write_rgl(tabulate(first, incidences=12, resolution=24), tmp_path / "a.bsdf")
    value = read_rgl(tmp_path / "a.bsdf")
    np.testing.assert_array_equal(value.wavelengths_nm, first.wavelengths_nm)
    here, there = aspecular_lab(first, 45.0), aspecular_lab(value, 45.0)
    assert np.abs(here - there).max() < 3.0
    assert "of 216 colours on a test grid lie outside the working space" in value.facts["notes"][0]


def test_colours_outside_the_working_space_are_counted(shared_data: Path, tmp_path: Path) -> None:
    def notes(name: str) -> str:
        return " ".join(read_measured(shared_data / "brdf" / name).facts.get("notes", ()))

    assert notes("krylon_blue.brdf").startswith("189 of 1,439 colours lie outside the working space")
    assert "at most ΔE00 2.87" in notes("krylon_blue.brdf")
    assert notes("retro-gray-tape.dat") == ""
    # XYZ of a monochromatic green: its red channel is negative in Rec. 2020.
    green = alta("ISOTROPIC_TV_TL", "0.1 0.2 0.0633 0.71 0.2987\n", 3, "#PARAM_OUT XYZ_COLOR\n")
    path = written(tmp_path, "green.alta", green)
    value = read_measured(path)
    assert "1 of 1 colours lie outside" in value.facts["notes"][0]
    assert value.values.min() == 0.0
