"""The lights of the start come filtered with the programs: found without filtering, and as the filter makes them."""

from __future__ import annotations

import shutil
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from brdf_suite.documents.view import View
from brdf_suite.errors import FileError
from brdf_suite.lighting import lobe_map_cache as cache
from brdf_suite.lighting.environment import SMALL_COLUMNS, Environment
from brdf_suite.lighting.filter.face_array import FaceArray
from brdf_suite.lighting.filter.lobe_maps import LobeMaps, prefilter
from brdf_suite.lighting.lobe_map_cache import MapCache, pack_maps, read_packed_maps
from brdf_suite.pipeline.lobe_fit import fit_material
from brdf_suite.pipeline.material import load_material
from brdf_suite.pipeline.picture import OffscreenScene
from brdf_suite.pipeline.scene import (
    PreparedEnvironment,
    default_view,
    in_environment,
    load_environment,
    load_surface,
)
from brdf_suite.progress import Progress
from brdf_suite.resources import resource_root

KEY = "0" * 64


def forbid_filtering(monkeypatch: pytest.MonkeyPatch) -> None:
    def prefilter(*_: object) -> LobeMaps:
        raise AssertionError("filtered again")

    monkeypatch.setattr(cache, "prefilter", prefilter)


@pytest.mark.parametrize(
    ("light", "columns"), [(View().environment, SMALL_COLUMNS), ("booth", None), ("booth", SMALL_COLUMNS)]
)
def test_the_lights_of_the_start_come_filtered_and_as_the_filter_makes_them(
    light: str, columns: int | None, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    forbid_filtering(monkeypatch)
    partial: list[object] = []
    store = MapCache(tmp_path)
    shipped = load_environment(light, columns=columns, cache=store, partial=partial.append)
    assert shipped.from_cache
    assert partial == []
    assert list(tmp_path.iterdir()) == []  # nothing is copied into the user's folder
    fresh = prefilter(shipped.environment, shipped.maps.exponents)
    mine, others = ((m.diffuse, m.through_coat, m.background, *m.lobes) for m in (shipped.maps, fresh))
    pairs = {(id(one), id(other)): (one, other) for one, other in zip(mine, others, strict=True)}
    for one, other in pairs.values():
        assert one.scale == other.scale
        # Another processor, and the compiled filter, may round a few of all texels the other way.
        bits = np.abs(np.subtract(one.faces.view(np.int16), other.faces.view(np.int16), dtype=np.int32))
        assert bits.max() <= 1
        assert bits.mean() < 1e-3
    assert [item is shipped.maps.background for item in shipped.maps.lobes] == [
        item is fresh.background for item in fresh.lobes
    ]


def test_the_default_light_is_shown_by_the_shipped_maps_while_the_whole_of_it_is_filtered(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    shown: list[PreparedEnvironment] = []

    def filtered(environment: Environment, *_: object) -> LobeMaps:
        assert len(shown) == 1  # there is a picture before the work begins
        return small_maps(grey=True)

    monkeypatch.setattr(cache, "prefilter", filtered)
    store = MapCache(tmp_path)
    prepared = load_environment(View().environment, cache=store, partial=shown.append)
    (first,) = shown
    small = load_environment(View().environment, columns=SMALL_COLUMNS, cache=store)
    assert not first.is_final
    assert np.array_equal(first.maps.background.faces, small.maps.background.faces)
    assert first.environment.content_hash == prepared.environment.content_hash
    assert prepared.is_final
    shown.clear()
    again = load_environment(View().environment, cache=store, partial=shown.append)
    assert again.from_cache
    assert shown == []


def small_maps(*, grey: bool) -> LobeMaps:
    rng = np.random.default_rng(5)
    faces = [rng.random((6, size, size, 1 if grey else 3)).astype(np.float16) for size in (64, 96)]
    one, other = (FaceArray(np.ascontiguousarray(np.broadcast_to(f, (*f.shape[:3], 3))), 0.5) for f in faces)
    return LobeMaps((1.0, 20.0, 9000.0), (one, other, other), one, one, other)


@pytest.mark.parametrize("grey", [True, False])
def test_what_was_packed_comes_back_bit_by_bit(grey: bool, tmp_path: Path) -> None:
    path = tmp_path / "a"
    maps = small_maps(grey=grey)
    path.write_bytes(pack_maps(maps, KEY, "noise"))
    found = read_packed_maps(path, KEY)
    assert found.exponents == maps.exponents
    for one, other in zip((*found.lobes, found.diffuse), (*maps.lobes, maps.diffuse), strict=True):
        assert one.scale == other.scale
        assert np.array_equal(one.faces, other.faces)
        assert not one.faces.flags.writeable
    assert found.lobes[1] is found.lobes[2] is found.background
    with pytest.raises(FileError, match="another environment"):
        read_packed_maps(path, "1" * 64)


@pytest.mark.parametrize("damage", ["empty", "cut off", "another format", "a changed byte"])
def test_a_damaged_file_is_said_and_its_maps_are_made(
    damage: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    root, work = tmp_path / "resources", []
    shutil.copytree(resource_root() / cache.PACKAGED, root / cache.PACKAGED)
    for path in (root / cache.PACKAGED).iterdir():
        data = bytearray(path.read_bytes())
        data[len(data) // 2] ^= 4
        changed = {"empty": b"", "cut off": data[:1000], "another format": b"BRDFMAPS" + data[8:]}
        path.write_bytes(changed.get(damage, bytes(data)))
    monkeypatch.setattr(cache, "resource_root", lambda: root)

    def counted(
        environment: object, exponents: tuple[float, ...], progress: Progress, ready: object
    ) -> LobeMaps:
        work.append(environment)
        return small_maps(grey=True)

    monkeypatch.setattr(cache, "prefilter", counted)
    prepared = load_environment("booth", cache=MapCache(tmp_path / "user"))
    assert len(work) == 1
    assert "packaged maps" in prepared.notices[0]
    assert "Install brdf-suite again" in prepared.notices[0]


def test_a_still_picture_uploads_only_the_maps_that_it_shows_and_looks_the_same() -> None:
    prepared = load_environment("booth")
    fit = fit_material(load_material("blue"), errors=False)
    uploads, pictures = [], []
    for only in (True, False):
        with OffscreenScene() as scene:
            scene.renderer.only_needed = only
            scene.set_environment(prepared)
            scene.set_surface(load_surface("sphere"))
            scene.set_material(fit)
            pictures.append(scene.image(View(surface="sphere"), (64, 36)))
            uploads.append(scene.renderer.counters.texture_uploads)
    assert np.array_equal(*pictures)
    assert uploads[0] <= uploads[1] - 3 * 6


def test_background_and_exposure_follow_the_light_until_they_are_chosen() -> None:
    studio = default_view()
    assert (studio.environment, studio.background, studio.surface_look.ground) == (
        "photo_studio",
        "blurred",
        True,
    )
    booth = in_environment(studio, "booth")
    assert booth == default_view("booth")
    assert (booth.background, booth.exposure_ev) == ("environment", 0.0)
    assert in_environment(booth, "photo_studio") == studio
    chosen = in_environment(replace(studio, background="grey", exposure_ev=-1.0), "street")
    assert (chosen.environment, chosen.background, chosen.exposure_ev) == ("street", "grey", -1.0)
