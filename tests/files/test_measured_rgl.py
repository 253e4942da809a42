"""RGL .bsdf files: read, evaluated as Mitsuba evaluates them, and written so that Mitsuba loads them."""

from __future__ import annotations

import struct
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from brdf_suite.appearance.colorimetry import WORKING_TO_SRGB
from brdf_suite.documents.store import load_paint
from brdf_suite.errors import FileError, ValueRangeError
from brdf_suite.files.measured import read_measured, sniff, write_measured
from brdf_suite.files.measured.rgl import read_rgl, write_rgl
from brdf_suite.files.measured.tensor_file import pack, unpack
from brdf_suite.geometry.directions import spherical
from brdf_suite.reflectance.build import build_paint
from brdf_suite.reflectance.tensor import TensorReflectance
from brdf_suite.reflectance.tensor.tabulate import tabulate

REAL = ("paper_white_rgb.bsdf", "vch_golden_yellow_rgb.bsdf")


def hemisphere(n: int, seed: int = 1) -> np.ndarray:
    rng = np.random.default_rng(seed)
    return spherical(np.arccos(rng.random(n)), rng.uniform(0.0, 2.0 * np.pi, n))


def pairs(n: int) -> tuple[np.ndarray, np.ndarray]:
    """Random directions above the horizon; half of the views near the mirror direction."""
    wi, wo = hemisphere(n), hemisphere(n, 2)
    near = wi[: n // 2] * (-1.0, -1.0, 1.0) + 0.1 * np.random.default_rng(3).normal(size=(n // 2, 3))
    wo[: n // 2] = near / np.linalg.norm(near, axis=1)[:, None]
    # In single precision, as the renderer sees them: near the horizon the rounding of a direction counts.
    return wi.astype(np.float32).astype(float), wo.astype(np.float32).astype(float)


class Mitsuba:
    """Mitsuba's plug-in, one pair after the other (its scalar variant)."""

    def __init__(self, path: Path, variant: str = "scalar_rgb") -> None:
        self.mi = pytest.importorskip("mitsuba")
        self.mi.set_variant(variant)
        self.bsdf = self.mi.load_dict({"type": "measured", "filename": str(path)})
        self.context = self.mi.BSDFContext()
        self.at = self.mi.SurfaceInteraction3f()

    def eval(self, wi: np.ndarray, wo: np.ndarray) -> np.ndarray:
        found = []
        for i, o in zip(wi, wo, strict=True):
            self.at.wi = self.mi.Vector3f(*i)
            found.append(np.array(self.bsdf.eval(self.context, self.at, self.mi.Vector3f(*o))).reshape(-1))
        return np.array(found)

    def pdf(self, wi: np.ndarray, wo: np.ndarray) -> np.ndarray:
        found = []
        for i, o in zip(wi, wo, strict=True):
            self.at.wi = self.mi.Vector3f(*i)
            found.append(self.bsdf.pdf(self.context, self.at, self.mi.Vector3f(*o)))
        return np.array(found)


def relative(own: np.ndarray, truth: np.ndarray) -> np.ndarray:
    """Error relative to the value, or to a thousandth of the pair's largest channel where that is more."""
    return np.abs(own - truth) / (
        np.maximum(np.abs(truth), 1e-3 * np.abs(truth).max(1, keepdims=True)) + 1e-7
    )


@pytest.mark.parametrize("name", REAL)
def test_values_and_densities_are_those_of_mitsuba(shared_data: Path, name: str) -> None:
    path = shared_data / "brdf" / name
    value, truth = read_rgl(path), Mitsuba(path)
    wi, wo = pairs(100_000)
    own = value.eval_channels(wi, wo) * np.maximum(wo[:, 2:], 0.0)
    theirs = truth.eval(wi, wo)
    assert theirs.max() > 0.3
    error = relative(own, theirs)
    assert np.quantile(error, 0.998) < 1e-3
    # The rest are values a thousandth of these and less, at half vectors near the horizon, where their single
    # precision cannot resolve the cumulative distributions.
    assert error[theirs.max(axis=1) > 1e-4].max() < 1e-3
    theirs_pdf = truth.pdf(wi[:20_000], wo[:20_000])
    own_pdf = value.pdf(wo[:20_000], wi[:20_000])  # our pdf is of the light for a view; theirs the other way
    assert (np.abs(own_pdf - theirs_pdf) / (np.abs(theirs_pdf) + 1e-3)).max() < 1e-3


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
    from brdf_suite.reflectance import measure_lab

    paper = measure_lab(read_measured(shared_data / "brdf" / REAL[0]), 45.0, 45.0)
    gold = measure_lab(read_measured(shared_data / "brdf" / REAL[1]), 45.0, [15.0, 45.0])
    assert 90.0 < paper[0] < 102.0
    assert abs(paper[1]) < 6.0
    assert gold[0, 0] > gold[1, 0] + 30.0  # a metallic film: much brighter near the mirror
    assert gold[0, 2] > 25.0


def test_samples_follow_the_pdf(shared_data: Path) -> None:
    value = read_rgl(shared_data / "brdf" / REAL[1])
    view = spherical(0.6, 0.4)
    rng = np.random.default_rng(0)
    wi = value.sample(view, rng.random((200_000, 2)))
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
    density = value.pdf(grid, view).reshape(7, inner, 8, inner).mean(axis=(1, 3))
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


def test_a_paint_written_is_the_paint_in_mitsuba(checkout: Path, tmp_path: Path) -> None:
    """Linear interpolation is what limits this; the figures are those that docs/measurements.md states."""
    paint = build_paint(load_paint(checkout / "resources" / "paints" / "silver_metallic.brdfpaint"))
    path = tmp_path / "paint.bsdf"
    notes = write_measured(paint, path).notes
    assert len(notes) == 1
    assert "Tabulated" in notes[0]
    truth = Mitsuba(path)
    wi, wo = hemisphere(20_000, 5), hemisphere(20_000, 6)
    above = (wi[:, 2] > 0.2) & (wo[:, 2] > 0.2)
    wi, wo = wi[above], wo[above]
    own = paint.eval(wi, wo) @ WORKING_TO_SRGB.T * wo[:, 2:]
    error = np.abs(truth.eval(wi, wo) - own).max(axis=1) / np.abs(own).max(axis=1)
    assert np.median(error) < 4e-4
    assert np.quantile(error, 0.9) < 2e-3
    assert np.quantile(error, 0.99) < 1e-2


def test_mitsuba_samples_a_written_paint_well(checkout: Path, tmp_path: Path) -> None:
    # The base alone: the coat's peak is too narrow for the even directions that give the truth here.
    paint = build_paint(load_paint(checkout / "resources" / "paints" / "silver_metallic.brdfpaint")).base
    path = tmp_path / "paint.bsdf"
    write_rgl(tabulate(paint, incidences=24, resolution=64), path)
    truth = Mitsuba(path)
    view = spherical(0.7, 0.0)
    truth.at.wi = truth.mi.Vector3f(*view)
    rng = np.random.default_rng(0)
    weights = np.array(
        [
            np.array(truth.bsdf.sample(truth.context, truth.at, 0.0, truth.mi.Point2f(*u), True)[1]).mean()
            for u in rng.random((4000, 2))
        ]
    )
    light = hemisphere(200_000)
    albedo = (paint.eval(light, view) @ WORKING_TO_SRGB.T * light[:, 2:]).mean() * 2.0 * np.pi
    spread = weights.std() / np.sqrt(len(weights))
    assert abs(weights.mean() - albedo) < 5.0 * spread + 0.01 * albedo
    assert weights.std() < 0.6 * weights.mean()  # sampled as the reflectance is, colour and horizon aside


class Spectral:
    """A dielectric-like lobe over a coloured base, given as spectra."""

    wavelengths_nm = np.linspace(400.0, 700.0, 7)
    facts = {"name": "Spectral test", "observer_deg": 2}  # noqa: RUF012 - read only

    def eval_spectra(self, wi: Any, wo: Any) -> np.ndarray:
        wi, wo = np.broadcast_arrays(np.asarray(wi, float), np.asarray(wo, float))
        half = wi + wo
        half = half / np.linalg.norm(half, axis=-1, keepdims=True)
        base = np.linspace(0.05, 0.3, 7)
        lobe = np.exp(-((half[..., :2] ** 2).sum(-1)) / 0.02)[..., None]
        return np.where((wi[..., 2:] > 0) & (wo[..., 2:] > 0), base + lobe, 0.0)

    def eval(self, wi: Any, wo: Any) -> np.ndarray:
        return self.eval_spectra(wi, wo)[..., [6, 3, 0]]


def test_spectra_are_kept_and_mitsuba_reads_them(tmp_path: Path) -> None:
    path, again = tmp_path / "spectral.bsdf", tmp_path / "again.bsdf"
    write_measured(Spectral(), path)
    first = read_rgl(path)
    write_measured(first, again)
    second = read_rgl(again)
    np.testing.assert_array_equal(first.values, second.values)
    np.testing.assert_array_equal(second.wavelengths_nm, Spectral.wavelengths_nm)
    wi, wo = hemisphere(4000, 7), hemisphere(4000, 8)
    above = (wi[:, 2] > 0.3) & (wo[:, 2] > 0.3)
    wi, wo = wi[above], wo[above]
    own = Spectral().eval_spectra(wi, wo)
    np.testing.assert_allclose(second.eval_spectra(wi, wo), own, rtol=0.05)

    truth = Mitsuba(again, "scalar_spectral")
    truth.at.wavelengths = [450.0, 500.0, 550.0, 650.0]
    theirs = truth.eval(wi[:2000], wo[:2000])
    bands = [1, 2, 3, 5]
    mine = (second.eval_spectra(wi, wo) * wo[:, 2:])[:2000, bands]
    np.testing.assert_allclose(theirs, mine, rtol=1e-3, atol=1e-6)
    assert second.eval(wi, wo).shape == (len(wi), 3)
    assert "7 bands" in str(second.facts["colour"])


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


def anisotropic() -> TensorReflectance:
    """An anisotropic material over half a turn of azimuths, of arbitrary smooth numbers."""
    rng = np.random.default_rng(4)
    phi = np.linspace(-np.pi, 0.0, 5).astype(np.float32)
    theta = np.linspace(0.0, 1.5, 4).astype(np.float32)
    rough = rng.random((5, 4, 16, 16)).astype(np.float32) + 0.2
    return TensorReflectance(
        phi,
        theta,
        (rng.random((9, 9)) + 0.5).astype(np.float32),
        (rng.random((9, 9)) + 0.5).astype(np.float32),
        rough,
        rng.random((5, 4, 8, 8)).astype(np.float32) + 0.1,
        rng.random((5, 4, 3, 8, 8)).astype(np.float32),
        description="brushed",
    )


def test_an_anisotropic_material_is_read_as_mitsuba_reads_it(tmp_path: Path) -> None:
    path = tmp_path / "brushed.bsdf"
    write_measured(anisotropic(), path)
    value, truth = read_rgl(path), Mitsuba(path)
    assert not value.isotropic
    wi, wo = hemisphere(20_000, 9), hemisphere(20_000, 10)
    own = value.eval_channels(wi, wo) * wo[:, 2:]
    theirs = truth.eval(wi, wo)
    assert np.quantile(relative(own, theirs), 0.999) < 1e-3
    light = value.sample(wi[:1000], np.random.default_rng(0).random((1000, 2)))
    seen = light[:, 2] > 0.01
    assert (value.pdf(light[seen], wi[:1000][seen]) > 0.0).all()


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
        "type": ({"ndf": good["ndf"].astype(np.float64)}, "'ndf': float32"),
        "zero density": ({"vndf": vndf}, "'vndf': the density of an incident direction is zero"),
        "negative density": ({"vndf": -good["vndf"]}, "'vndf': a density is negative"),
        "nan": ({"rgb": rgb}, "'rgb': holds a number that is not finite"),
        "falling": ({"theta_i": good["theta_i"][::-1].copy()}, "'theta_i': numbers rising"),
        "directions": ({"luminance": good["luminance"][:, :5].copy()}, "'luminance': the shape"),
        "channels": ({"rgb": good["rgb"][:, :, :2].copy()}, "'rgb': 2 channels"),
        "thin": ({"sigma": good["sigma"][:1].copy()}, "'sigma': grids of at least 2 x 2"),
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
