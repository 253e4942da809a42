"""BiRD's JSON: its example, units and groups, and what a damaged file is reported."""

from __future__ import annotations

import copy
import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from brdf_suite.errors import FileError
from brdf_suite.files.measured import read_measured, write_measured
from brdf_suite.geometry.directions import spherical


def test_polarizations_are_averaged_and_wavelengths_become_a_spectrum(shared_data: Path) -> None:
    value = read_measured(shared_data / "brdf" / "bird_example.json")
    assert value.facts["samples"] == 1
    np.testing.assert_array_equal(value.wavelengths_nm, [550.0, 650.0, 750.0, 850.0])
    np.testing.assert_allclose(value.spectra, [[0.2585, 0.27, 0.288, 0.2985]])
    assert "550 to 850 nm only" in value.facts["notes"][0]
    np.testing.assert_allclose(value.wo[0], spherical(np.radians(10.0), np.radians(60.0)))


def written(tmp_path: Path, name: str, document: dict[str, Any] | str) -> Path:
    path = tmp_path / name
    path.write_text(document if isinstance(document, str) else json.dumps(document))
    return path


def bird(**axes: Any) -> dict[str, Any]:
    lists: dict[str, Any] = {
        "theta_i": {"unit": "deg", "values": [10, 10, 20, 20]},
        "phi_i": {"unit": "deg", "values": [0, 0, 0, 0]},
        "theta_r": {"unit": "rad", "values": [0.5, 0.5, 0.6, 0.6]},
        "phi_r": {"unit": "deg", "values": [180, 180, 180, 180]},
        "wavelength_i": {"unit": "µm", "values": [0.5, 0.6, 0.5, 0.6]},
        "BRDF": {"unit": "1/sr", "values": [0.1, 0.2, 0.3, 0.4]},
    }
    lists.update(copy.deepcopy(axes))
    return {"metadata": {"type": "BRDF"}, "data": {k: v for k, v in lists.items() if v is not None}}


def test_units_and_groups_of_bird(tmp_path: Path) -> None:
    value = read_measured(written(tmp_path, "a.json", bird()))
    np.testing.assert_allclose(value.spectra, [[0.1, 0.2], [0.3, 0.4]])
    np.testing.assert_allclose(value.wavelengths_nm, [500.0, 600.0])
    grey = read_measured(written(tmp_path, "b.json", bird(wavelength_i=None)))
    np.testing.assert_allclose(grey.values, [[0.15] * 3, [0.35] * 3])  # readings of one geometry averaged
    write_measured(grey, tmp_path / "c.json")
    np.testing.assert_allclose(read_measured(tmp_path / "c.json").values, grey.values)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"theta_i": {"unit": "grad", "values": [1]}}, "data.theta_i.unit"),
        ({"theta_i": {"unit": ["deg"], "values": [1]}}, "data.theta_i.unit"),
        ({"theta_i": {"unit": "deg", "values": 3}}, "data.theta_i.values"),
        ({"theta_i": {"unit": "deg", "values": []}}, "data.theta_i.values"),
        ({"theta_i": {"values": [1]}}, "data.theta_i: does not follow the BRDF schema: 'unit'"),
        ({"theta_i": [1, 2]}, "data.theta_i: "),
        ({"theta_i": None}, "'theta_i' is a required property"),
        ({"polarization_i": {"notation": "x", "values": ["s"]}}, "data.polarization_i.notation"),
        ({"polarization_i": {"notation": "sp"}}, "'values' is a required property"),
        ({"phi_r": {"unit": "deg", "values": [1, 2]}}, "data.phi_r.values: has 2 entries where BRDF has 4"),
        ({"BRDF": {"unit": "1/sr", "values": [1, 2, "x", 4]}}, "data.BRDF.values[2]"),
        ({"BRDF": {"unit": "1/sr", "values": [1, 2, float("nan"), 4]}}, "data.BRDF.values[2]"),
        ({"BRDF": {"unit": "1/sr", "values": [1, 10**400, 3, 4]}}, "data.BRDF.values[1]"),
        ({"theta_i": {"unit": "deg", "values": [10, 10, 95, 95]}}, "data, entry 1: the direction"),
        ({"wavelength_i": {"unit": "nm", "values": [500, 600, 500, 700]}}, "not every geometry"),
        ({"wavelength_i": {"unit": "nm", "values": [1, 2, 1, 2]}}, "the wavelengths do not rise"),
    ],
)
def test_bad_bird_files_name_the_field(tmp_path: Path, change: dict[str, Any], words: str) -> None:
    with pytest.raises(FileError) as caught:
        read_measured(written(tmp_path, "a.json", bird(**change)))
    assert words in str(caught.value)


@pytest.mark.parametrize(
    "document", [[], {"data": {}}, {"metadata": 1, "data": {}}, {"metadata": {}, "data": []}]
)
def test_a_document_of_another_shape_is_refused(tmp_path: Path, document: Any) -> None:
    with pytest.raises(FileError, match=r"does not follow the BRDF schema|format"):
        read_measured(
            written(tmp_path, "a.json", document if isinstance(document, str) else json.dumps(document))
        )


def test_json_that_is_none_names_the_line(tmp_path: Path) -> None:
    with pytest.raises(FileError, match=r"line 2, column \d+"):
        read_measured(written(tmp_path, "a.json", '{"metadata": {},\n "data" 1}'))
    deep = '{"metadata": ' + "[" * 100_000
    with pytest.raises(FileError, match="nested too deep"):
        read_measured(written(tmp_path, "b.json", deep))
