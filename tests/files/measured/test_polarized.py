"""Polarimetric BRDFs: intensity of files written here byte by byte, against Mitsuba's plug-in where it is installed."""

from __future__ import annotations

import itertools
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest

from brdf_suite.cli.tools.bench import load_module
from brdf_suite.errors import FileError
from brdf_suite.files.measured import read_measured, sniff
from brdf_suite.reflectance.tabulated.angle_table import AngleTable

_turned = load_module(Path(__file__).parent / "turned_pairs.py")
tensor_file = load_module(Path(__file__).parent / "tensor_files.py").tensor_file
PUBLISHED = (450, 500, 550, 600, 650)


@dataclass(frozen=True)
class Variant:
    """One way to write a file."""

    phi: tuple[float, ...] = tuple(np.linspace(0.0, 360.0, 9))
    theta_d: tuple[float, ...] = (0.0, 15.0, 30.0, 50.0, 80.0)
    theta_h: tuple[float, ...] = (0.0, 3.0, 12.0, 35.0, 60.0)
    bands: tuple[int, ...] = PUBLISHED
    order: tuple[str, ...] = ("theta_h", "theta_d", "phi_d", "wvls", "M")
    more: tuple[str, ...] = ()
    holes: str = "below"
    aligned: int = 8
    version: tuple[int, int] = (1, 0)
    polarized: bool = True

    def value(self, p: float, d: float, h: float, band: int) -> float:
        return _turned.field(*_turned.half_pair(h, 0.0, d, p)) * band / 500.0

    def fields(self) -> dict[str, np.ndarray]:
        shape = (len(self.phi), len(self.theta_d), len(self.theta_h), len(self.bands))
        matrices = np.zeros((*shape, 4, 4), np.float32)
        for at in itertools.product(*map(range, shape)):
            p, d, h = self.phi[at[0]], self.theta_d[at[1]], self.theta_h[at[2]]
            light, view = _turned.half_pair(h, 0.0, d, p)
            below = min(light[2], view[2]) < 0.0
            if below and self.holes != "none":
                matrices[at] = np.nan
                continue
            matrices[at][0, 0] = self.value(p, d, h, self.bands[at[3]])
            if self.polarized:
                matrices[at][1, 1] = 0.7 * matrices[at][0, 0]
                matrices[at][0, 1] = -0.2 * matrices[at][0, 0]
        found = {
            "theta_h": np.radians(np.array([self.theta_h], np.float32)),
            "theta_d": np.radians(np.array([self.theta_d], np.float32)),
            "phi_d": np.radians(np.array([self.phi], np.float32)),
            "wvls": np.array(self.bands, np.uint16),
            "M": matrices,
        }
        found |= {name: np.frombuffer(b"text", np.uint8) for name in self.more}
        return {name: found[name].astype(found[name].dtype) for name in (*self.more, *self.order)}

    def content(self) -> bytes:
        return tensor_file(self.fields(), aligned=self.aligned, version=self.version)


VARIANTS = {
    "as published": Variant(),
    "from -180": Variant(phi=tuple(np.linspace(-180.0, 180.0, 9))),
    "open turn": Variant(phi=tuple(np.arange(0.0, 360.0, 45.0))),
    "open turn from -180": Variant(phi=tuple(np.arange(-180.0, 180.0, 40.0))),
    "fine turn": Variant(phi=tuple(np.linspace(0.0, 360.0, 37)), bands=(500, 600)),
    "one azimuth": Variant(phi=(0.0,)),
    "whole θd": Variant(theta_d=tuple(np.linspace(0.0, 90.0, 7))),
    "whole θh": Variant(theta_h=tuple(np.linspace(0.0, 90.0, 7))),
    "one θd": Variant(theta_d=(20.0,)),
    "one θh": Variant(theta_h=(5.0,)),
    "square root of θh": Variant(theta_h=tuple(np.linspace(0.0, 8.0, 9) ** 2)),
    "one band": Variant(bands=(550,)),
    "two bands": Variant(bands=(450, 650)),
    "eleven bands": Variant(bands=tuple(range(400, 701, 30))),
    "matrices first": Variant(order=("M", "wvls", "phi_d", "theta_d", "theta_h")),
    "mixed order": Variant(order=("wvls", "M", "theta_d", "theta_h", "phi_d")),
    "a description": Variant(more=("description",)),
    "more fields": Variant(more=("description", "name", "date")),
    "no holes": Variant(holes="none"),
    "unaligned": Variant(aligned=1),
    "wide alignment": Variant(aligned=64),
    "later version": Variant(version=(1, 1)),
    "unpolarized": Variant(polarized=False),
}


def written(tmp_path: Path, content: bytes) -> Path:
    path = tmp_path / "gold.pbsdf"
    path.write_bytes(content)
    return path


@pytest.mark.parametrize("name", VARIANTS)
def test_every_variant_holds_its_intensity_at_its_nodes(tmp_path: Path, name: str) -> None:
    variant = VARIANTS[name]
    path = written(tmp_path, variant.content())
    assert sniff(path).name == "pbsdf"
    grid = read_measured(path)
    assert isinstance(grid, AngleTable)
    assert grid.isotropic
    assert grid.wavelengths_nm.tolist() == list(variant.bands)
    nodes = [
        (p, d, h)
        for p, d, h in itertools.product(variant.phi, variant.theta_d, variant.theta_h)
        if min(w[2] for w in _turned.half_pair(h, 0.0, d, p)) > 0.02 and (h > 0.0 or len(variant.phi) > 1)
    ]
    assert len(nodes) > 3
    wi, wo = (np.array([_turned.half_pair(h, 0.0, d, p)[side] for p, d, h in nodes]) for side in (0, 1))
    expected = np.array([[variant.value(*node, band) for band in variant.bands] for node in nodes])
    assert grid.eval_spectra(wi, wo) == pytest.approx(expected, rel=2e-4)
    assert any("polarization" in note for note in grid.facts["notes"])


def test_holes_do_not_darken_the_cells_across_the_horizon(tmp_path: Path) -> None:
    grid = read_measured(written(tmp_path, Variant(theta_d=(0.0, 30.0, 60.0, 90.0)).content()))
    light, view = _turned.half_pair(35.0, 0.0, 53.0, 0.0)
    assert view[2] > 0.0
    assert grid.eval_spectra(light, view).min() > 0.1


def test_the_reflectance_is_that_of_mitsuba(tmp_path: Path) -> None:
    mitsuba = pytest.importorskip("mitsuba")
    mitsuba.set_variant("scalar_rgb")
    path = written(tmp_path, Variant(holes="none", phi=tuple(np.linspace(-180.0, 180.0, 13))).content())
    grid = read_measured(path)
    bsdf = mitsuba.load_dict({"type": "measured_polarized", "filename": str(path), "wavelength": 550.0})
    context, at = mitsuba.BSDFContext(), mitsuba.SurfaceInteraction3f()
    rng = np.random.default_rng(5)
    for _ in range(200):
        light, view = (
            _turned.polar(np.degrees(np.arccos(rng.uniform(0.2, 1.0))), rng.uniform(0, 360)) for _ in (0, 1)
        )
        at.wi = view.tolist()  # of light that is traced backwards
        expected = np.array(bsdf.eval(context, at, light.tolist()))[0] / light[2]
        assert grid.eval_spectra(light, view)[2] == pytest.approx(expected, rel=1e-4)


@pytest.mark.parametrize(
    ("change", "reason", "place"),
    [
        (lambda fields: fields.pop("wvls"), "of no measured|missing", ""),
        (lambda fields: fields.pop("theta_h"), "is missing", "the list of fields"),
        (
            lambda fields: fields.update(wvls=fields["wvls"].astype(np.float32)),
            "expected uint16",
            "the field 'wvls'",
        ),
        (lambda fields: fields.update(M=fields["M"][:-1]), "expected the shape", "the field 'M'"),
        (lambda fields: fields.update(M=fields["M"].astype(np.float64)), "expected float32", "the field 'M'"),
        (lambda fields: fields.update(theta_d=-fields["theta_d"]), "rise", "the field 'theta_d'"),
        (lambda fields: fields.update(theta_h=fields["theta_h"] * 3.0), "rise", "the field 'theta_h'"),
        (lambda fields: fields.update(wvls=fields["wvls"][::-1].copy()), "rise", "the field 'wvls'"),
        (
            lambda fields: (
                fields["theta_d"].view(np.uint32).__setitem__((0, 1), 0x7F800001)
            ),  # a signalling NaN
            "rise",
            "the field 'theta_d'",
        ),
        (lambda fields: fields["M"].fill(np.nan), "NaN alone", "the field 'M'"),
        (lambda fields: fields["M"].fill(np.inf), "no finite reflectance", "the field 'M'"),
    ],
)
def test_damage_is_refused_with_the_field(tmp_path: Path, change, reason: str, place: str) -> None:
    fields = Variant().fields()
    change(fields)
    with pytest.raises(FileError, match=reason) as caught:
        read_measured(written(tmp_path, tensor_file(fields)))
    assert (caught.value.place or "").startswith(place)
