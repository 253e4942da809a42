"""Baked occlusion is kept on disk, and whatever happens to the disk, it is there."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import SurfaceLook
from brdf_suite.pipeline import occlusion
from brdf_suite.pipeline.occlusion import baked_occlusion, occlusion_folder, occlusion_key
from brdf_suite.pipeline.surface import prepare_surface
from brdf_suite.surface.forms.panel import panel
from brdf_suite.surface.mesh import Mesh
from brdf_suite.surface.occlusion.baked import BakedMesh


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("BRDF_SUITE_CACHE", str(tmp_path))
    return occlusion_folder()


@pytest.fixture
def facet() -> Mesh:
    from brdf_suite.surface.mesh import Part

    part = Part("f", "paint", np.eye(3), np.full((3, 3), 3**-0.5), np.zeros((3, 2)), np.array([[0, 1, 2]]))
    return Mesh("facet", (part,))


def forbid_baking(monkeypatch: pytest.MonkeyPatch) -> None:
    def bake(*_: object) -> BakedMesh:
        raise AssertionError("baked again")

    monkeypatch.setattr(occlusion, "bake", bake)


def test_the_second_time_it_comes_from_disk(
    facet: Mesh, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    first = baked_occlusion(facet)
    assert [path.suffix for path in folder.iterdir()] == [".occlusion"]
    forbid_baking(monkeypatch)
    told: list[float] = []
    second = baked_occlusion(facet, lambda fraction, _: told.append(fraction))
    assert np.array_equal(first.parts[0].light, second.parts[0].light)
    assert told == [1.0]


def test_a_damaged_entry_is_baked_anew(facet: Mesh, folder: Path, caplog: pytest.LogCaptureFixture) -> None:
    baked_occlusion(facet)
    (entry,) = folder.iterdir()
    sound = entry.read_bytes()
    entry.write_bytes(sound[:100])
    assert baked_occlusion(facet).parts[0].light.shape[1] == 8
    assert entry.read_bytes() == sound
    assert "baked anew" in caplog.text


def test_a_folder_that_cannot_be_written_costs_time_only(
    facet: Mesh, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    blocked = tmp_path / "file"
    blocked.write_text("no folder")
    monkeypatch.setenv("BRDF_SUITE_CACHE", str(blocked))
    assert baked_occlusion(facet).parts[0].light.shape[1] == 8
    assert "not kept" in caplog.text


def test_old_entries_make_room(facet: Mesh, folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    folder.mkdir(parents=True)
    old = folder / f"{'0' * 64}.occlusion"
    old.write_bytes(bytes(1000))
    monkeypatch.setattr(occlusion, "LIMIT_BYTES", 500)
    baked_occlusion(facet)
    assert not old.exists()
    assert len(list(folder.iterdir())) == 1  # the newest stays, however large


def test_the_key_is_of_the_shape_alone(facet: Mesh) -> None:
    from dataclasses import replace

    (part,) = facet.parts
    renamed = Mesh("other", (replace(part, name="g", material="glass"),))
    moved = Mesh("facet", (replace(part, positions=part.positions + 1.0),))
    assert occlusion_key(facet) == occlusion_key(renamed) != occlusion_key(moved)


def test_a_surface_is_prepared_as_the_view_says(folder: Path) -> None:
    plain = View(surface="panel", surface_look=SurfaceLook(occlusion=False))
    assert prepare_surface(plain).baked is None
    assert not folder.exists()
    look = SurfaceLook(scale=2.0, occlusion=True)
    prepared = prepare_surface(View(surface="panel", surface_look=look))
    assert prepared.baked is not None
    low, high = panel().bounds()
    found_low, found_high = prepared.mesh.bounds()
    np.testing.assert_allclose(found_high - found_low, 2.0 * (high - low), rtol=1e-4)
