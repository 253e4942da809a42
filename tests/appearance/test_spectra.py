"""Spectra to tristimulus values against another program, the CIE's whites, and by hand."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from brdf_suite.appearance.colour.colorimetry import WHITE_D65_10, lab_to_working, working_to_lab
from brdf_suite.appearance.colour.spectra import (
    DEFAULT_WAVELENGTHS_NM,
    ILLUMINANTS,
    colour_matching,
    illuminant_power,
    spectrum_to_lab,
    spectrum_to_working,
    spectrum_to_xyz,
    spectrum_weights,
    table_wavelengths,
    white_xyz,
)
from brdf_suite.errors import ValueRangeError

OBSERVER_NAMES = {2: "CIE 1931 2 Degree Standard Observer", 10: "CIE 1964 10 Degree Standard Observer"}
ILLUMINANT_NAMES = {
    "D65": "D65",
    "A": "A",
    "F11": "FL11",
    "D50": "D50",
    "F2": "FL2",
    "LED-B3": "LED-B3",
}


def smooth_spectra(count: int, wavelengths: np.ndarray) -> np.ndarray:
    """Reflectances as paints have them: a few broad bands and a sigmoid edge, from 0 to about 1.3."""
    rng = np.random.default_rng(11)
    centre, width = rng.uniform(380, 760, (2, count, 1)), rng.uniform(30, 90, (2, count, 1))
    bells = rng.uniform(0, 0.5, (2, count, 1)) * np.exp(-(((wavelengths - centre) / width) ** 2))
    edge = rng.uniform(-0.05, 0.05, (count, 1)) * (wavelengths - rng.uniform(450, 650, (count, 1)))
    return bells.sum(axis=0) + rng.uniform(0, 0.3, (count, 1)) / (1 + np.exp(edge))


@pytest.mark.parametrize(
    ("illuminant", "observer", "white"),
    [
        # CIE 15:2004, table T.3, from sums at 5 nm.
        ("D65", 2, (95.04, 100.0, 108.88)),
        ("D65", 10, (94.81, 100.0, 107.32)),
        ("A", 2, (109.85, 100.0, 35.58)),
        ("A", 10, (111.14, 100.0, 35.20)),
        ("F11", 2, (100.95, 100.0, 64.36)),
        ("F11", 10, (103.86, 100.0, 65.62)),
        ("D50", 2, (96.42, 100.0, 82.51)),
        ("D50", 10, (96.72, 100.0, 81.43)),
        ("F2", 2, (99.19, 100.0, 67.39)),
        ("F2", 10, (103.28, 100.0, 69.03)),
    ],
)
def test_whites_are_those_of_the_cie(illuminant: str, observer: int, white: tuple) -> None:
    # The lamp's lines are joined by straight lines at 1 nm; the CIE's own sum jumps over them at 5 nm.
    tolerance = 0.12 if illuminant.startswith("F") else 0.02
    np.testing.assert_allclose(white_xyz(illuminant, observer), white, atol=tolerance)
    diffuser = spectrum_to_xyz(np.ones(31), illuminant=illuminant, observer_deg=observer)
    np.testing.assert_allclose(diffuser, white_xyz(illuminant, observer), rtol=1e-12)
    np.testing.assert_allclose(white_xyz("D65", 10), WHITE_D65_10, atol=2e-3)


@pytest.mark.parametrize("observer", [2, 10])
@pytest.mark.parametrize("illuminant", ILLUMINANTS)
def test_sums_agree_with_another_program(colour: ModuleType, illuminant: str, observer: int) -> None:
    wavelengths = table_wavelengths()
    count = 4_000
    spectra = smooth_spectra(count, wavelengths)
    shape = colour.SpectralShape(360, 780, 1)
    functions = colour.MSDS_CMFS[OBSERVER_NAMES[observer]].copy().align(shape)
    power = colour.SDS_ILLUMINANTS[ILLUMINANT_NAMES[illuminant]].copy()
    # Outside of the table the suite has 0, the other program would hold the last value.
    values = np.interp(wavelengths, power.wavelengths, power.values, left=0.0, right=0.0)
    power = colour.SpectralDistribution(values, wavelengths)
    expected = colour.msds_to_XYZ(spectra, functions, power, method="Integration", shape=shape)
    np.testing.assert_allclose(
        spectrum_to_xyz(spectra, wavelengths, illuminant, observer), expected, rtol=1e-9, atol=1e-9
    )


def test_bands_of_ten_nanometres_agree_with_astm_e308(colour: ModuleType) -> None:
    """The other program's ASTM E308 road, by Sprague interpolation, on what a spectrophotometer gives."""
    count = 300
    wavelengths = np.linspace(360.0, 780.0, 43)
    spectra = smooth_spectra(count, wavelengths)
    functions = colour.MSDS_CMFS[OBSERVER_NAMES[10]].copy().align(colour.SpectralShape(360, 780, 1))
    daylight = colour.SpectralDistribution(illuminant_power("D65"), table_wavelengths())
    expected = np.array(
        [
            colour.sd_to_XYZ(
                colour.SpectralDistribution(row, wavelengths),
                functions,
                daylight,
                method="ASTM E308",
            )
            for row in spectra
        ]
    )
    np.testing.assert_allclose(spectrum_to_xyz(spectra, wavelengths), expected, atol=0.02)


def test_few_bands_lose_little() -> None:
    fine, coarse = np.linspace(360, 780, 421), np.linspace(380, 760, 39)
    exact = spectrum_to_lab(smooth_spectra(200, fine), fine)
    np.testing.assert_allclose(spectrum_to_lab(smooth_spectra(200, coarse), coarse), exact, atol=0.04)


def test_by_hand() -> None:
    """A mirror of one nanometre reflects one term of the sum."""
    wavelengths = table_wavelengths()
    at = int(np.flatnonzero(wavelengths == 555.0)[0])
    spectrum = np.zeros(421)
    spectrum[at] = 1.0
    k = 100.0 / (illuminant_power("A") * colour_matching(2)[:, 1]).sum()
    expected = k * illuminant_power("A")[at] * np.array([0.5120501, 1.0000000, 0.0057500])
    # CIE 1931 at 555 nm: 0.5120501, 1.0000000, 0.0057500 (ISO/CIE 11664-1).
    np.testing.assert_allclose(spectrum_to_xyz(spectrum, wavelengths, "A", 2), expected, rtol=1e-6)


def test_a_grey_is_grey_in_the_working_space() -> None:
    for observer in (2, 10):
        grey = spectrum_to_working(np.full((2, 31), 0.18), observer_deg=observer)
        np.testing.assert_allclose(grey, 0.18, rtol=1e-12)
    spectra = smooth_spectra(500, DEFAULT_WAVELENGTHS_NM)
    rho = spectrum_to_working(spectra)
    # The same road as for readings: both give the L*a*b* of the 10° observer.
    np.testing.assert_allclose(working_to_lab(rho), spectrum_to_lab(spectra), atol=1e-9)
    np.testing.assert_allclose(lab_to_working(spectrum_to_lab(spectra)), rho, atol=1e-12)
    # The observers differ, but not much: less than the colours do.
    assert np.abs(spectrum_to_working(spectra, observer_deg=2) - rho).max() < 0.1


@given(
    st.lists(st.floats(300.0, 900.0), min_size=1, max_size=12, unique_by=lambda x: round(x)),
    st.floats(0.0, 3.0),
)
def test_any_bands_keep_a_flat_spectrum(bands: list, level: float) -> None:
    bands = sorted(bands)
    xyz = spectrum_to_xyz(np.full(len(bands), level), bands)
    np.testing.assert_allclose(xyz, level * white_xyz(), rtol=1e-6, atol=1e-9)
    assert spectrum_weights(bands).shape == (len(bands), 3)


@pytest.mark.parametrize(
    ("values", "bands", "kind", "words"),
    [
        (np.ones(3), [400, 500], {}, "2 values"),
        (np.ones(2), [500, 400], {}, "must rise"),
        (np.ones(2), [0.4, 0.5], {}, "expected wavelengths"),
        (np.ones(2), [400, np.nan], {}, "expected wavelengths"),
        (np.ones(0), [], {}, "list of wavelengths"),
        (np.ones(2), [400, 500], {"illuminant": "D93"}, "D65, A, F11"),
        (np.ones(2), [400, 500], {"observer_deg": 4}, "10° observer"),
    ],
)
def test_bad_spectra_are_refused(values: np.ndarray, bands: list, kind: dict, words: str) -> None:
    with pytest.raises(ValueRangeError, match=words):
        spectrum_to_xyz(values, bands, **kind)


def test_shapes_and_not_a_number() -> None:
    assert spectrum_to_xyz(np.zeros((2, 0, 31))).shape == (2, 0, 3)
    assert np.isnan(spectrum_to_working(np.full((4, 31), np.nan))).all()


def test_the_committed_command_writes_the_packaged_table(
    colour: ModuleType, checkout: Path, tmp_path: Path
) -> None:
    command = [
        sys.executable,
        str(checkout / "packaging" / "generators" / "colour_tables.py"),
        tmp_path / "cie.csv",
    ]
    subprocess.run(command, check=True, timeout=240, capture_output=True)
    packaged = (checkout / "resources" / "colour" / "cie.csv").read_bytes()
    assert (tmp_path / "cie.csv").read_bytes() == packaged


def test_the_working_space_agrees_with_another_program(colour: ModuleType) -> None:
    """2°: the primaries' matrix alone. 10°: CAT16 from the white of D65 and that observer first."""
    spectra = smooth_spectra(10_000, DEFAULT_WAVELENGTHS_NM)
    space = colour.RGB_COLOURSPACES["ITU-R BT.2020"]
    from_xyz = np.linalg.inv(colour.normalised_primary_matrix(space.primaries, space.whitepoint))
    two = spectrum_to_xyz(spectra, observer_deg=2) / 100.0
    # Rec. 2020 states its white to four digits, the tables give it to more.
    np.testing.assert_allclose(spectrum_to_working(spectra, observer_deg=2), two @ from_xyz.T, atol=4e-4)
    adapted = colour.chromatic_adaptation(
        spectrum_to_xyz(spectra) / 100.0,
        white_xyz() / 100.0,
        colour.xy_to_XYZ(space.whitepoint),
        method="Von Kries",
        transform="CAT16",
    )
    np.testing.assert_allclose(spectrum_to_working(spectra), adapted @ from_xyz.T, atol=1e-5)
