"""RGL .bsdf files against Mitsuba's ``measured`` plug-in, the oracle: what it reads, and what we write, are the same.

Mitsuba works in single precision. It takes a pair to a place on the unit square with a rounding of a few 2⁻²⁴, as its
own warp, which Python can call, shows. Where the stored values fall to 0 at the edge of the square, 10⁻⁵ away from
it, such a step changes the value by percents. So a pair agrees where the error is below 1e-3 of the value, or below
what a step of ``STEPS`` 2⁻²⁴ changes; how few pairs need the second is tested too.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from brdf_suite.appearance.colour.colorimetry import WORKING_TO_SRGB
from brdf_suite.cli.tools.bench import load_module
from brdf_suite.documents.store import load_paint
from brdf_suite.files.measured import write_measured
from brdf_suite.files.measured.rgl import read_rgl, write_rgl
from brdf_suite.geometry.directions import spherical
from brdf_suite.reflectance.designed.build import build_paint
from brdf_suite.reflectance.tensor.tabulate import tabulate
from brdf_suite.reflectance.tensor.tensor_reflectance import TensorReflectance

_directions = load_module(Path(__file__).parent / "direction_pairs.py")
hemisphere, pairs = _directions.hemisphere, _directions.pairs
tensor_file = load_module(Path(__file__).parent / "tensor_files.py").tensor_file
REAL = ("paper_white_rgb.bsdf", "vch_golden_yellow_rgb.bsdf")
PAIRS = 20_000
STEPS = 8
STEP = 2.0**-24


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
        for i, o in zip(wi.tolist(), wo.tolist(), strict=True):  # lists are converted faster than arrays
            self.at.wi = i
            found.append([*self.bsdf.eval(self.context, self.at, o)])
        return np.array(found, np.float32)

    def pdf(self, wi: np.ndarray, wo: np.ndarray) -> np.ndarray:
        found = []
        for i, o in zip(wi.tolist(), wo.tolist(), strict=True):
            self.at.wi = i
            found.append(self.bsdf.pdf(self.context, self.at, o))
        return np.array(found)


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


def places(value: TensorReflectance, wi: np.ndarray, wo: np.ndarray) -> tuple[np.ndarray, ...]:
    """Where pairs above the horizon fall on the square, before the warp and after it, and the blend of grids."""
    wi, wo, _ = value._reduce(wi, wo)
    _, before, blend, _ = value._coordinates(wi, wo)
    after, _ = value._visible.invert(before, blend)
    return before, after, blend


def room(value: TensorReflectance, wi: np.ndarray, wo: np.ndarray, channels: np.ndarray) -> np.ndarray:
    """How much f cosθo (n, c) changes when its place moves by ``STEPS`` steps along either axis."""
    _, place, blend = places(value, wi, wo)
    here = value._values_at(place, blend)
    largest = np.zeros_like(here)
    for move in ((1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)):
        there = np.clip(place + STEPS * STEP * np.array(move), 0.0, 1.0)
        largest = np.maximum(largest, np.abs(value._values_at(there, blend) - here))
    # The factor D/(4σ) is what turns the stored values into f cosθo.
    return np.divide(largest * np.abs(channels), np.abs(here), out=np.zeros_like(here), where=here != 0.0)


def disagreement(
    value: TensorReflectance, truth: Mitsuba, bands: list[int] | None = None
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The relative error of each of ``PAIRS`` pairs, the same beyond the room of single precision, and that room."""
    wi, wo = pairs(PAIRS)
    theirs = truth.eval(wi, wo)
    above = (wi[:, 2] > 0.0) & (wo[:, 2] > 0.0)
    assert above.mean() > 0.9
    assert (theirs[~above] == 0.0).all()
    assert (value.eval_channels(wi[~above], wo[~above]) == 0.0).all()
    wi, wo, theirs = wi[above], wo[above], theirs[above]
    own = value.eval_channels(wi, wo) * wo[:, 2:]
    allowed = room(value, wi, wo, own)
    if bands is not None:
        own, allowed = own[:, bands], allowed[:, bands]
    assert theirs.max() > 0.1
    # Relative to the value, or to a thousandth of the pair's largest channel where that is more.
    size = np.maximum(np.abs(theirs), 1e-3 * np.abs(theirs).max(1, keepdims=True)) + 1e-7
    error = np.abs(own - theirs)
    return (
        (error / size).max(axis=1),
        (np.maximum(error - allowed, 0.0) / size).max(axis=1),
        (allowed / size).max(axis=1),
    )


def assert_same(value: TensorReflectance, truth: Mitsuba, bands: list[int] | None = None) -> None:
    """Every pair within 1e-3, or within the rounding of the oracle; few need the latter."""
    error, beyond, allowed = disagreement(value, truth, bands)
    assert np.median(error) < 2e-6
    assert (error > 1e-3).mean() < 2e-3
    assert beyond.max() < 1e-3
    # The room is no way out: it exceeds 1e-3 for a few pairs only.
    assert (allowed > 1e-3).mean() < 0.015


@pytest.fixture(scope="module")
def silver(checkout: Path, tmp_path_factory: pytest.TempPathFactory) -> tuple[Path, tuple[str, ...]]:
    """A file of silver_metallic, and what was noted as it was written; to tabulate the paint takes seconds."""
    path = tmp_path_factory.mktemp("silver") / "paint.bsdf"
    paint = build_paint(load_paint(checkout / "resources" / "paints" / "silver_metallic.brdfpaint"))
    return path, tuple(write_measured(paint, path).notes)


@pytest.mark.parametrize("name", REAL)
def test_the_rounding_of_the_oracle_is_a_few_steps(shared_data: Path, name: str) -> None:
    """Mitsuba's own warp in single precision, on the same points, is off by less than the room allows."""
    value = read_rgl(shared_data / "brdf" / name)
    mi = Mitsuba(shared_data / "brdf" / name).mi
    axes = [value.phi_i.tolist(), value.theta_i.tolist()]
    warp = mi.MarginalContinuous2D2(np.array(value.vndf, np.float32), axes, True, True)
    rng = np.random.default_rng(5)
    points = rng.random((20_000, 2)).astype(np.float32)
    theta = rng.uniform(0.0, 1.5, len(points)).astype(np.float32)
    theirs = np.array(
        [
            np.array(warp.invert(mi.Point2f(*point.tolist()), [0.0, float(t)])[0])
            for point, t in zip(points, theta, strict=True)
        ]
    )
    blend = value._blend(np.zeros(len(points)), theta.astype(float))
    own, _ = value._visible.invert(points.astype(float), blend)
    off = np.abs(own - theirs).max(axis=1) / STEP
    assert off.max() < STEPS
    # It is rounding, and not a few grid cells that differ.
    assert 0.1 < np.median(off) < 2.0


@pytest.mark.parametrize("name", REAL)
def test_values_are_those_of_mitsuba(shared_data: Path, tmp_path: Path, name: str) -> None:
    path, again = shared_data / "brdf" / name, tmp_path / "again.bsdf"
    value = read_rgl(path)
    assert_same(value, Mitsuba(path))
    write_measured(value, again)
    assert_same(read_rgl(again), Mitsuba(again))


@pytest.mark.parametrize("name", REAL)
def test_densities_are_those_of_mitsuba(shared_data: Path, name: str) -> None:
    path = shared_data / "brdf" / name
    value, truth = read_rgl(path), Mitsuba(path)
    wi, wo = pairs(20_000)
    theirs = truth.pdf(wi, wo)
    own = value.pdf_stored(wo, wi)  # our pdf is of the light for a view; theirs the other way
    assert (np.abs(own - theirs) / (np.abs(theirs) + 1e-3)).max() < 1e-3


def test_mitsuba_reads_the_table_of_a_metallic_paint_as_we_do(silver: tuple[Path, tuple[str, ...]]) -> None:
    path, _ = silver
    assert_same(read_rgl(path), Mitsuba(path))


def test_mitsuba_reads_the_table_of_a_solid_paint_as_we_do(checkout: Path, tmp_path: Path) -> None:
    path = tmp_path / "paint.bsdf"
    paint = build_paint(load_paint(checkout / "resources" / "paints" / "solid_white.brdfpaint"))
    write_rgl(tabulate(paint, incidences=36, resolution=96), path)
    assert_same(read_rgl(path), Mitsuba(path))


def test_mitsuba_reads_a_table_of_spectra_as_we_do(tmp_path: Path) -> None:
    path = tmp_path / "spectral.bsdf"
    write_measured(Spectral(), path)
    value, truth = read_rgl(path), Mitsuba(path, "scalar_spectral")
    truth.at.wavelengths = [450.0, 500.0, 550.0, 650.0]
    assert_same(value, truth, [1, 2, 3, 5])


def test_spectra_are_kept_to_the_last_bit(tmp_path: Path) -> None:
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
    assert second.eval(wi, wo).shape == (len(wi), 3)
    assert "7 bands" in str(second.facts["colour"])


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
    assert_same(value, truth)
    wi = hemisphere(1000, 9)
    light = value.sample_stored(wi, np.random.default_rng(0).random((1000, 2)))
    seen = light[:, 2] > 0.01
    assert (value.pdf_stored(light[seen], wi[seen]) > 0.0).all()


def test_a_paint_written_is_the_paint_in_mitsuba(
    checkout: Path, silver: tuple[Path, tuple[str, ...]]
) -> None:
    """Linear interpolation is what limits this; the figures are those that docs/method/measurements.md states."""
    paint = build_paint(load_paint(checkout / "resources" / "paints" / "silver_metallic.brdfpaint"))
    path, notes = silver
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


TURNS = {"whole": (-np.pi, np.pi), "half": (-np.pi, 0.0), "quarter": (-np.pi, -0.5 * np.pi)}
VARIANTS = {
    f"{name} turn, {colour}, {jacobian} jacobian, {size}": (turn, colour, jacobian == "with", size)
    for name, turn in TURNS.items()
    for colour in ("rgb", "spectra")
    for jacobian in ("with", "without")
    for size in ("few nodes", "more nodes")
}


def anisotropic_file(turn: tuple[float, float], colour: str, jacobian: bool, size: str) -> bytes:
    """A smooth material that turns with the sample, written by no code of the suite."""
    rng = np.random.default_rng(len(size) + int(jacobian))
    p, t, m = (4, 3, 6) if size == "few nodes" else (7, 5, 11)
    channels = 3 if colour == "rgb" else 4
    fields = {
        "description": np.frombuffer(b"brushed", np.uint8),
        "phi_i": np.linspace(*turn, p, dtype=np.float32),
        "theta_i": np.linspace(0.0, 1.5, t, dtype=np.float32),
        "sigma": rng.uniform(0.5, 1.0, (5, 6)).astype(np.float32),
        "ndf": rng.uniform(0.5, 1.5, (7, 8)).astype(np.float32),
        "vndf": rng.uniform(0.2, 1.0, (p, t, m, m)).astype(np.float32),
        "luminance": rng.uniform(0.2, 1.0, (p, t, m, m)).astype(np.float32),
        colour: rng.uniform(0.1, 0.9, (p, t, channels, m, m)).astype(np.float32),
        "jacobian": np.array([jacobian], np.uint8),
    }
    if colour == "spectra":
        fields["wavelengths"] = np.array([400.0, 500.0, 600.0, 700.0], np.float32)
    return tensor_file(fields)


@pytest.mark.parametrize("name", VARIANTS)
def test_every_kind_of_anisotropic_file_is_read_as_mitsuba_reads_it(tmp_path: Path, name: str) -> None:
    turn, colour, jacobian, size = VARIANTS[name]
    path = tmp_path / "brushed.bsdf"
    path.write_bytes(anisotropic_file(turn, colour, jacobian, size))
    value = read_rgl(path)
    assert not value.isotropic
    wi, wo = pairs(300)
    seen = (wi[:, 2] > 0.15) & (wo[:, 2] > 0.15)
    wi, wo = wi[seen], wo[seen]
    truth = Mitsuba(path, "scalar_rgb" if colour == "rgb" else "scalar_spectral")
    if colour == "spectra":
        truth.at.wavelengths = [400.0, 500.0, 600.0, 700.0]
    ours = value.eval_channels(wi, wo) * wo[:, 2:]
    error = np.abs(ours - truth.eval(wi, wo)) / np.maximum(np.abs(ours), 1e-3 * np.abs(ours).max())
    # Single precision moves a half vector between two of the few nodes of these rough tables.
    assert np.quantile(error, 0.98) < 2e-3
