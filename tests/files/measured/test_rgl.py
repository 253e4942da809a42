"""RGL .bsdf files: read, evaluated, written again, refused where they are damaged."""

from __future__ import annotations

import struct
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from brdf_suite.appearance.colour.colorimetry import WORKING_TO_SRGB
from brdf_suite.cli.tools.bench import load_module
from brdf_suite.errors import FileError, ValueRangeError
from brdf_suite.files.measured import read_measured, sniff, write_measured
from brdf_suite.files.measured.rgl import pack, read_rgl, unpack
from brdf_suite.geometry.directions import spherical

_directions = load_module(Path(__file__).parent / "direction_pairs.py")
hemisphere, pairs = _directions.hemisphere, _directions.pairs
REAL = ("paper_white_rgb.bsdf", "vch_golden_yellow_rgb.bsdf")


@pytest.mark.parametrize("name", REAL)
def test_eval_is_in_the_working_space_and_never_negative(shared_data: Path, name: str) -> None:
    value = read_rgl(shared_data / "brdf" / name)
    wi, wo = pairs(20_000)
    found = value.eval(wi, wo)
    channels = value.eval_channels(wi, wo)
    inside = (channels > 1e-6).all(axis=1)
    assert found.min() == 0.0  # views below the horizon are among the pairs
    np.testing.assert_allclose(found[inside] @ WORKING_TO_SRGB.T, channels[inside], rtol=1e-9, atol=1e-12)
    assert (value.eval(wi, wo * (1.0, 1.0, -1.0)) == 0.0)[wo[:, 2] > 0.0].all()
    assert value.eval(np.array([0.0, 0.0, 1.0]), np.array([[[0.0, 0.0, 1.0]]])).shape == (1, 1, 3)
    assert value.eval(np.zeros((0, 3)), np.zeros((0, 3))).shape == (0, 3)


def test_the_paper_is_white_and_the_vinyl_golden(shared_data: Path) -> None:
    from brdf_suite.fitting.metrics import aspecular_lab

    paper = aspecular_lab(read_measured(shared_data / "brdf" / REAL[0]), 45.0)
    gold = aspecular_lab(read_measured(shared_data / "brdf" / REAL[1]), [15.0, 45.0])
    assert 90.0 < paper[0] < 102.0
    assert abs(paper[1]) < 6.0
    assert gold[0, 0] > gold[1, 0] + 30.0  # a metallic film: much brighter near the mirror
    assert gold[0, 2] > 25.0


def test_samples_of_the_stored_density_follow_it(shared_data: Path) -> None:
    value = read_rgl(shared_data / "brdf" / REAL[1])
    view = spherical(0.6, 0.4)
    rng = np.random.default_rng(0)
    wi = value.sample_stored(view, rng.random((200_000, 2)))
    assert wi.shape == (200_000, 3)
    np.testing.assert_allclose(np.linalg.norm(wi, axis=1), 1.0, atol=1e-9)
    # Counts in cells of the sphere of directions against the integral of the density over the cells.
    z_edges, phi_edges = np.linspace(0.3, 1.0, 8), np.linspace(-np.pi, np.pi, 9)
    counts, _, _ = np.histogram2d(wi[:, 2], np.arctan2(wi[:, 1], wi[:, 0]), bins=(z_edges, phi_edges))
    inner = 64
    steps = (np.arange(inner) + 0.5) / inner
    z = (z_edges[:-1, None] + np.diff(z_edges)[:, None] * steps).ravel()
    phi = (phi_edges[:-1, None] + np.diff(phi_edges)[:, None] * steps).ravel()
    grid = spherical(np.arccos(z)[:, None], phi[None, :])
    density = value.pdf_stored(grid, view).reshape(7, inner, 8, inner).mean(axis=(1, 3))
    expected = density * np.diff(z_edges)[:, None] * np.diff(phi_edges)[None, :] * 200_000
    large = expected > 50.0
    assert large.sum() > 20
    score = (counts[large] - expected[large]) / np.sqrt(expected[large])
    assert np.abs(score).max() < 5.0


@pytest.mark.parametrize("name", REAL)
def test_reading_and_writing_again_changes_nothing(shared_data: Path, tmp_path: Path, name: str) -> None:
    first = read_rgl(shared_data / "brdf" / name)
    copy = tmp_path / "copy.bsdf"
    assert write_measured(first, copy).notes == ()
    before = unpack((shared_data / "brdf" / name).read_bytes(), name)
    after = unpack(copy.read_bytes(), copy)
    assert before.keys() == after.keys()
    for key, array in before.items():
        assert array.dtype == after[key].dtype
        np.testing.assert_array_equal(array, after[key])


def test_a_file_with_colours_and_spectra_keeps_both(shared_data: Path, tmp_path: Path) -> None:
    good = unpack((shared_data / "brdf" / REAL[0]).read_bytes(), "x")
    both, again = tmp_path / "both.bsdf", tmp_path / "again.bsdf"
    bands = np.array([450.0, 550.0, 650.0], np.float32)
    both.write_bytes(changed(shared_data, spectra=good["rgb"][:, :, ::-1].copy(), wavelengths=bands))
    value = read_rgl(both)
    np.testing.assert_array_equal(value.wavelengths_nm, bands)
    write_measured(value, again)
    np.testing.assert_array_equal(unpack(again.read_bytes(), again)["rgb"], good["rgb"])
    with pytest.raises(ValueRangeError, match="measured in RGB"):
        read_rgl(shared_data / "brdf" / REAL[0]).eval_spectra([0.0, 0.0, 1.0], [0.0, 0.0, 1.0])


def test_an_anisotropic_reflectance_is_not_tabulated_as_isotropic(tmp_path: Path) -> None:
    class Turned:
        def eval(self, wi: Any, wo: Any) -> np.ndarray:
            return np.broadcast_to(1.0 + np.asarray(wi)[..., :1], np.broadcast(wi, wo).shape)

    path = tmp_path / "turned.bsdf"
    with pytest.raises(FileError, match="when the sample is turned"):
        write_measured(Turned(), path)
    assert not path.exists()


def changed(shared_data: Path, **fields: Any) -> bytes:
    arrays = dict(unpack((shared_data / "brdf" / REAL[0]).read_bytes(), "x"))
    for name, array in fields.items():
        if array is None:
            del arrays[name]
        else:
            arrays[name] = array
    return pack(arrays)


def test_bad_arrays_are_refused_by_name(shared_data: Path, tmp_path: Path) -> None:
    good = unpack((shared_data / "brdf" / REAL[0]).read_bytes(), "x")
    vndf, rgb = good["vndf"].copy(), good["rgb"].copy()
    vndf[0, 3] = 0.0
    rgb[0, 0, 0, 0, 0] = np.nan
    cases: dict[str, tuple[dict[str, Any], str]] = {
        "missing": ({"sigma": None}, "'sigma' is missing"),
        "type": ({"ndf": good["ndf"].astype(np.float64)}, "'ndf': expected float32"),
        "zero density": ({"vndf": vndf}, "'vndf': the density of an incident direction is zero"),
        "negative density": ({"vndf": -good["vndf"]}, "'vndf': a density is negative"),
        "nan": ({"rgb": rgb}, "'rgb': holds a number that is not finite"),
        "falling": ({"theta_i": good["theta_i"][::-1].copy()}, "'theta_i': expected numbers rising"),
        "directions": ({"luminance": good["luminance"][:, :5].copy()}, "'luminance': the shape"),
        "channels": ({"rgb": good["rgb"][:, :, :2].copy()}, "'rgb': 2 channels"),
        "thin": ({"sigma": good["sigma"][:1].copy()}, "'sigma': expected grids of at least 2 x 2"),
    }
    for name, (fields, words) in cases.items():
        path = tmp_path / f"{name}.bsdf"
        path.write_bytes(changed(shared_data, **fields))
        with pytest.raises(FileError) as caught:
            read_measured(path)
        assert words in str(caught.value), name


def test_damaged_containers_are_refused_with_the_byte(shared_data: Path, tmp_path: Path) -> None:
    good = (shared_data / "brdf" / REAL[0]).read_bytes()
    cases = {
        "cut header": good[:60],
        "cut data": good[:-5000],
        "version": good[:12] + b"\x07\x00" + good[14:],
        "many fields": good[:14] + struct.pack("<I", 1 << 31) + good[18:],
        "huge shape": good.replace(struct.pack("<Q", 128), struct.pack("<Q", 1 << 62), 1),
    }
    for name, content in cases.items():
        path = tmp_path / f"{name}.bsdf"
        path.write_bytes(content)
        with pytest.raises(FileError, match=r"at byte \d+"):
            read_measured(path)


def test_the_registry_knows_it_by_content(shared_data: Path, tmp_path: Path) -> None:
    path = tmp_path / "odd.name"
    path.write_bytes((shared_data / "brdf" / REAL[0]).read_bytes())
    assert sniff(path).name == "rgl"
