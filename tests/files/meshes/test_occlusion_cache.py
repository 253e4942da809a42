"""Baked occlusion is kept on disk, and whatever happens to the disk, it is there."""

from __future__ import annotations

import os
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from meshes.forms.panel import panel

from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import SurfaceLook
from brdf_suite.files.meshes import occlusion_cache as occlusion
from brdf_suite.files.meshes.occlusion_cache import baked_occlusion, occlusion_cache, occlusion_key
from brdf_suite.output.still import loaded_scene
from brdf_suite.pipeline.lobe_fit import PaintFitter
from brdf_suite.pipeline.material import default_paint
from brdf_suite.pipeline.scene import load_surface
from brdf_suite.pipeline.surface import baked_where_wanted, load_shaped
from brdf_suite.surface.mesh import Mesh, PartGeometry
from brdf_suite.surface.occlusion import bake as baking
from brdf_suite.surface.occlusion import floor
from brdf_suite.surface.occlusion.bake import bake
from brdf_suite.surface.occlusion.rays import BakedMesh


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("BRDF_SUITE_CACHE", str(tmp_path))
    return occlusion_cache().folder


@pytest.fixture
def coarse(monkeypatch: pytest.MonkeyPatch) -> None:
    """Bake in a moment: from few places, over a coarse floor."""
    monkeypatch.setattr(baking, "_FEWEST_PLACES", 400)
    monkeypatch.setattr(baking, "_ROUNDS", 1)
    monkeypatch.setattr(floor, "_LONG_SIDE", 24)


@pytest.fixture
def facet(coarse: None) -> Mesh:
    part = PartGeometry(
        "f", "paint", np.eye(3), np.full((3, 3), 3**-0.5), np.zeros((3, 2)), np.array([[0, 1, 2]])
    )
    return Mesh("facet", (part,))


def kept(folder: Path) -> list[Path]:
    """The files of a folder without those of its locks."""
    return [path for path in folder.iterdir() if not path.name.startswith(".")]


def forbid_baking(monkeypatch: pytest.MonkeyPatch) -> None:
    def bake(*_: object) -> BakedMesh:
        raise AssertionError("baked again")

    monkeypatch.setattr(occlusion, "bake", bake)


def test_the_second_time_it_comes_from_disk(
    facet: Mesh, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    first = baked_occlusion(facet)
    assert [path.suffix for path in kept(folder)] == [".occlusion"]
    forbid_baking(monkeypatch)
    fractions: list[float] = []
    second = baked_occlusion(facet, lambda fraction, _: fractions.append(fraction))
    assert np.array_equal(first.parts[0].light, second.parts[0].light)
    assert fractions == [1.0]


def test_the_first_surface_comes_baked_and_as_baking_gives_it(
    folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    mesh = load_surface(View().surface)
    fresh = bake(mesh)
    forbid_baking(monkeypatch)
    packaged = baked_occlusion(mesh)
    assert not folder.exists()  # nothing is copied into the user's cache
    for one, other in zip(packaged.parts, fresh.parts, strict=True):
        assert np.array_equal(one.triangles, other.triangles)
        # Other processors may see a few of all rays pass an edge on the other side.
        assert np.abs(one.light.astype(float) - other.light.astype(float)).mean() < 1e-4
    np.testing.assert_allclose(packaged.ground.transfer, fresh.ground.transfer, atol=2e-3)


def test_a_damaged_entry_is_baked_anew(facet: Mesh, folder: Path, caplog: pytest.LogCaptureFixture) -> None:
    baked_occlusion(facet)
    (entry,) = kept(folder)
    sound = entry.read_bytes()
    entry.write_bytes(sound[:100])
    assert baked_occlusion(facet).parts[0].light.shape[1] == 16
    assert entry.read_bytes() == sound
    assert "made again" in caplog.text


def test_a_folder_that_cannot_be_written_costs_time_only(
    facet: Mesh, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    blocked = tmp_path / "file"
    blocked.write_text("no folder")
    monkeypatch.setenv("BRDF_SUITE_CACHE", str(blocked))
    assert baked_occlusion(facet).parts[0].light.shape[1] == 16
    assert "not kept" in caplog.text


def test_old_entries_make_room(facet: Mesh, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    folder.mkdir(parents=True)
    old = folder / f"{'0' * 64}.occlusion"
    old.write_bytes(bytes(4_000_000))
    monkeypatch.setenv("BRDF_SUITE_CACHE_MB", "4")
    baked_occlusion(facet)
    assert not old.exists()
    assert len(kept(folder)) == 1


def test_entries_of_all_kinds_share_one_limit(
    facet: Mesh, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    maps = folder.parent / "lobe_maps"
    maps.mkdir(parents=True)
    old, other = maps / f"{'0' * 64}.v5.lobemaps", maps / "a letter.lobemaps"
    for path in (old, other):
        path.write_bytes(bytes(4_000_000))
    monkeypatch.setenv("BRDF_SUITE_CACHE_MB", "4")
    baked_occlusion(facet)
    assert not old.exists()
    assert other.exists()  # no entry
    assert len(kept(folder)) == 1


def test_the_key_is_of_the_shape_and_of_what_is_seen_through(facet: Mesh) -> None:
    (part,) = facet.parts
    renamed = Mesh("other", (replace(part, name="g", material="rubber"),))
    pane = Mesh("facet", (replace(part, material="glass"),))
    moved = Mesh("facet", (replace(part, positions=part.positions + 1.0),))
    assert occlusion_key(facet) == occlusion_key(renamed)
    assert len({occlusion_key(mesh) for mesh in (facet, moved, pane)}) == 3


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="named pipes are of POSIX")
def test_a_pipe_in_the_place_of_an_entry_is_removed_and_not_waited_for(
    facet: Mesh, folder: Path, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    first = baked_occlusion(facet)
    (entry,) = kept(folder)
    entry.unlink()
    os.mkfifo(entry)
    again = baked_occlusion(facet)
    assert "is not a plain file" in caplog.text
    assert np.array_equal(first.parts[0].light, again.parts[0].light)
    assert entry.is_file()
    forbid_baking(monkeypatch)
    baked_occlusion(facet)


def test_a_surface_is_shaped_and_baked_as_the_view_says(folder: Path, coarse: None) -> None:
    mesh = load_shaped("panel", SurfaceLook(scale=2.0))
    (low, high), (plain_low, plain_high) = mesh.bounds(), panel().bounds()
    np.testing.assert_allclose(high - low, 2.0 * (plain_high - plain_low), rtol=1e-4)
    assert baked_where_wanted(mesh, SurfaceLook(occlusion=False)) is None
    assert not folder.exists()
    for look in (SurfaceLook(occlusion=True), SurfaceLook(occlusion=False, ground=True)):
        baked = baked_where_wanted(mesh, look)
        assert baked is not None
        assert len(baked.parts) == len(mesh.parts)


def test_a_picture_from_the_command_has_the_ground(shared_cache: Path) -> None:
    view = View(
        environment="booth", surface="sphere", background="grey", surface_look=SurfaceLook(ground=True)
    )
    plain = replace(view, surface_look=SurfaceLook(occlusion=False))
    with loaded_scene(view) as loaded:
        loaded.scene.set_material(PaintFitter(time_limit_s=60.0).fit(default_paint()))
        pictures = [loaded.scene.image(v, (96, 64)).astype(int) for v in (view, plain)]
    darker = (pictures[1] - pictures[0]).max(axis=2)
    assert darker[54:].max() > 20  # under the sphere
    assert abs(darker[:10]).max() <= 1
