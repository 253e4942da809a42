"""Without LLVM and without a graphics card: tables in Mitsuba's own plug-in, and what is said about it."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from brdf_suite.documents.view import Camera, View
from brdf_suite.documents.view_settings import TRANSMITTANCE, Lamp
from brdf_suite.errors import ReferenceUnavailableError
from brdf_suite.files.images.environments import write_exr
from brdf_suite.files.images.exr.image import read_exr
from brdf_suite.geometry.directions import spherical
from brdf_suite.geometry.fresnel import sheet_reflectance
from brdf_suite.lighting.environment import Environment
from brdf_suite.pipeline.material import load_shipped_paint
from brdf_suite.reference import variant as variants
from brdf_suite.reflectance.designed.build import build_paint
from brdf_suite.reflectance.material import Material
from brdf_suite.reflectance.models.lambertian import Lambertian
from brdf_suite.reflectance.registry import MODELS
from brdf_suite.surface.mesh import Mesh, PartGeometry

SIZE = (24, 20)


@pytest.fixture
def without_llvm(monkeypatch: pytest.MonkeyPatch):
    """A machine with Mitsuba and nothing that it compiles with."""
    pytest.importorskip("mitsuba", reason="the extra reference is not installed")
    # What was found on this machine stays known: trying it out again takes seconds.
    monkeypatch.setattr(variants, "choose_variant", lambda: variants.choose(False, [], variants.probe))


@pytest.fixture
def light(tmp_path: Path) -> Path:
    path = tmp_path / "soft.exr"
    rng = np.random.default_rng(1)
    write_exr(path, np.repeat(np.repeat(0.2 + rng.random((4, 8, 3)), 8, 0), 8, 1).astype(np.float32))
    return path


def test_the_scalar_variant_is_chosen_only_by_who_can_use_it(without_llvm) -> None:
    with pytest.raises(ReferenceUnavailableError, match="libllvm19"):
        variants.start()
    found = variants.start(scalar=True)
    assert found.is_scalar
    assert "libllvm19" in found.instead
    import mitsuba as mi

    assert mi.variant() == "scalar_rgb"


@pytest.mark.parametrize("name", ["copper", "phong_original"])
def test_a_table_in_the_plug_in_is_the_paint(without_llvm, name: str) -> None:
    """Also of a model that is not the same with light and view exchanged."""
    variants.start(scalar=True)
    import mitsuba as mi

    from brdf_suite.reference.scalar import table_bsdf

    paint = build_paint(load_shipped_paint("copper")) if name == "copper" else MODELS[name].default
    bsdf = table_bsdf(paint, incidences=48, resolution=96)
    rng = np.random.default_rng(2)
    wi, wo = (spherical(np.arccos(0.3 + 0.7 * rng.random(300)), rng.uniform(0, 6.28, 300)) for _ in "ab")
    wanted = paint.eval(wi, wo) * wi[:, 2:]
    found = []
    for light, view in zip(wi.tolist(), wo.tolist(), strict=True):
        si = mi.SurfaceInteraction3f()
        si.wi = mi.Vector3f(*view)
        found.append(np.array(bsdf.eval(mi.BSDFContext(), si, mi.Vector3f(*light))))
    error = np.abs(np.array(found) / wanted - 1.0)
    assert np.quantile(error, 0.99) < 0.01
    assert np.median(error) < 0.001


def test_what_is_not_isotropic_is_refused_with_what_to_install(without_llvm) -> None:
    variants.start(scalar=True)
    from brdf_suite.reference.scalar import working_table

    with pytest.raises(ReferenceUnavailableError, match="libllvm19"):
        working_table(MODELS["poulin_fournier"].default)


def test_the_command_renders_the_same_picture_and_says_how(
    without_llvm, light, tmp_path: Path, monkeypatch, capsys
) -> None:
    from brdf_suite.cli.main import main

    words = [
        "--renderer",
        "reference",
        "--environment",
        str(light),
        "--mesh",
        "sphere",
        "--background",
        "grey",
        "--no-ground",  # which the scalar variant leaves out
    ]
    words += ["--size", f"{SIZE[0]}x{SIZE[1]}", "--spp", "64"]
    assert main(["render", "copper", "-o", str(tmp_path / "scalar.exr"), *words]) == 0
    reported = capsys.readouterr()
    assert "libllvm19" in reported.err  # notices, beside the result
    assert "table" in reported.out + reported.err
    assert "no single flakes" in reported.out + reported.err
    monkeypatch.undo()
    try:
        variants.start()
    except ReferenceUnavailableError as error:
        pytest.skip(str(error))
    smooth = [*words, "--sparkle", "off"]
    assert main(["render", "copper", "-o", str(tmp_path / "llvm.exr"), *smooth]) == 0
    one, two = (read_exr(tmp_path / name).pixels for name in ("scalar.exr", "llvm.exr"))
    inside = np.abs(one - one[0, 0]).sum(-1) > 1e-6
    difference = (one - two)[inside]
    # A z-test of the means: the two are independent estimates of one picture.
    assert np.all(np.abs(difference.mean(0)) < 4.5 * difference.std(0) / np.sqrt(len(difference)) + 0.002)


@pytest.mark.parametrize(
    ("lamp", "off"),
    [
        (Lamp("directional", azimuth_deg=0.0, elevation_deg=0.0, angle_deg=2.0), 0.0),
        (Lamp("point", (0.0, 0.0, 5.0), strength=25.0, diameter=0.3), 5.2),
    ],
)
def test_lamps_with_an_extent_shine_through_panes(without_llvm, lamp: Lamp, off: float) -> None:
    found = variants.start(scalar=True)
    from brdf_suite.reference.passes import trace
    from brdf_suite.tracing.reference.scene import build_reference

    def board(name: str, material: str, right: float, z: float) -> PartGeometry:
        corners = np.array([[-1.0, -1, z], [right, -1, z], [right, 1, z], [-1.0, 1, z]])
        facing = np.tile([0.0, 0.0, 1.0], (4, 1))
        return PartGeometry(name, material, corners, facing, corners[:, :2], [[0, 1, 2], [0, 2, 3]])

    mesh = Mesh("lit", (board("wall", "paint", 1.0, -0.2), board("pane", "glass", 0.0, 0.1)))
    view = View(Camera(60.0, 0.0, 3.0, (0.0, 0.0, -0.2)), background="grey", lamps=(lamp,))
    # So dark that what it and the pane mirror to each other is next to nothing.
    dark = Material("dark", Lambertian(np.full(3, 0.02)))
    night = Environment("night", np.zeros((8, 16, 3), np.float32))
    made = build_reference(dark, view, (48, 32), night, mesh, variant=found)
    seen = trace(made.traced, samples=64, samples_per_pass=64).radiance[16, :, 1]
    # In the middle row: the pane's shade is seen past its edge, left of the middle of the wall; right of it is none.
    columns = {x: round(24 + 48 * _across(x) / (36.0 / 50.0)) for x in (-0.15, 0.3)}
    passed = TRANSMITTANCE["glass"] * (1.0 - float(sheet_reflectance(1.0, 1.52)))
    distance = 1.0 if off == 0.0 else off**2 / 25.0
    assert seen[columns[0.3]] == pytest.approx(0.02 / distance, rel=0.02)
    assert seen[columns[-0.15]] / seen[columns[0.3]] == pytest.approx(passed, rel=0.03)


def _across(x: float) -> float:
    """Return where a place of the wall is seen from 60° aside, at 3 m: the tangent to the right."""
    turn = math.radians(60.0)
    return x * math.cos(turn) / (3.0 - x * math.sin(turn))
