"""``brdf-suite cache``: what it says of an empty, a sound and a damaged cache."""

import json
import sqlite3
from pathlib import Path

import numpy as np
import pytest

from brdf_suite.cli.main import main
from brdf_suite.files.meshes.occlusion_cache import baked_occlusion, occlusion_cache
from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.lobe_map_cache import MapCache
from brdf_suite.palettes.swatches.store import SwatchStore
from brdf_suite.surface.mesh import Mesh, PartGeometry


@pytest.fixture
def filled() -> MapCache:
    cache = MapCache()
    for index, exponent in enumerate((3.0, 4.0)):
        pixels = np.random.default_rng(index).random((8, 16, 3)).astype(np.float32)
        cache.get_or_compute(Environment(f"yard {index}", pixels), [exponent])
    return cache


def answer(capsys: pytest.CaptureFixture[str], *arguments: str) -> tuple[int, dict[str, object]]:
    status = main(["cache", *arguments, "--json"])
    return status, json.loads(capsys.readouterr().out)


def test_a_cache_whose_name_no_file_system_takes(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setenv("BRDF_SUITE_CACHE", str(tmp_path / ("x/" * 2100)))
    for action in ("info", "clear", "verify"):
        assert answer(capsys, action)[0] == 0


def test_an_empty_cache(capsys: pytest.CaptureFixture[str]) -> None:
    assert answer(capsys, "info")[1]["entries"] == []
    assert answer(capsys, "verify") == (
        0,
        {
            "folder": str(MapCache().folder),
            "passed": True,
            "sound": 0,
            "damaged": [],
            "outdated": 0,
            "unfinished": 0,
            "removed": False,
            "occlusion": {
                "folder": str(occlusion_cache().folder),
                "sound": 0,
                "damaged": [],
                "removed": False,
            },
            "swatches": {"file": str(SwatchStore().path), "sound": 0, "damaged": 0, "removed": False},
        },
    )
    assert not SwatchStore().path.exists()
    assert answer(capsys, "clear")[1]["removed"] == 0


def test_info_lists_what_is_there(filled: MapCache, capsys: pytest.CaptureFixture[str]) -> None:
    status, facts = answer(capsys, "info")
    assert status == 0
    assert facts["bytes"] == sum(entry.size for entry in filled.entries())
    rows = facts["entries"]
    assert isinstance(rows, list)
    assert {row["environment"]: row["exponents"] for row in rows} == {"yard 0": [3.0], "yard 1": [4.0]}
    assert main(["cache", "info"]) == 0
    assert "2 entries" in capsys.readouterr().out


def test_verify_names_a_damaged_entry_and_removes_it_when_asked(
    filled: MapCache, capsys: pytest.CaptureFixture[str]
) -> None:
    victim = filled.entries()[0].path
    victim.write_bytes(victim.read_bytes()[:-1])
    (filled.folder / f".{'0' * 64}-x.part").write_bytes(b"left by a killed program")
    (filled.folder / f"{'1' * 64}.lobemaps").write_bytes(b"of an older version")
    status, found = answer(capsys, "verify")
    assert (status, found["passed"], found["sound"], found["unfinished"], found["outdated"]) == (
        1,
        False,
        1,
        1,
        1,
    )
    assert [row["entry"] for row in found["damaged"]] == [victim.name]  # type: ignore[attr-defined, index] # JSON
    assert victim.exists()
    assert main(["cache", "verify", "--remove"]) == 1
    assert victim.name in capsys.readouterr().out
    assert not victim.exists()
    status, found = answer(capsys, "verify")
    assert (status, found["sound"], found["unfinished"]) == (0, 1, 0)


def test_clear_removes_all(filled: MapCache, capsys: pytest.CaptureFixture[str]) -> None:
    old = filled.folder / f"{'1' * 64}.lobemaps"
    old.write_bytes(b"of an older version")
    status, done = answer(capsys, "clear")
    assert (status, done["removed"]) == (0, 3)
    assert int(str(done["freed_bytes"])) > 0
    assert filled.entries() == []
    assert not old.exists()


def test_baked_occlusion_is_listed_checked_and_removed_too(capsys: pytest.CaptureFixture[str]) -> None:
    part = PartGeometry(
        "f", "paint", np.eye(3), np.full((3, 3), 3**-0.5), np.zeros((3, 2)), np.array([[0, 1, 2]])
    )
    baked_occlusion(Mesh("facet", (part,)))
    (entry,) = occlusion_cache().entries()
    path, size = entry.path, entry.size
    reported = answer(capsys, "info")[1]["occlusion"]
    assert (reported["bytes"], reported["entries"]) == (size, [{"entry": path.name, "bytes": size}])  # type: ignore[index] # JSON
    assert main(["cache", "info"]) == 0
    assert f"{occlusion_cache().folder}: 1 surface" in capsys.readouterr().out
    assert answer(capsys, "verify")[1]["occlusion"]["sound"] == 1  # type: ignore[index] # JSON

    path.write_bytes(path.read_bytes()[:-1])
    status, found = answer(capsys, "verify")
    assert (status, found["passed"]) == (1, False)
    assert path.exists()
    assert main(["cache", "verify", "--remove"]) == 1
    assert "removed" in capsys.readouterr().out
    assert not path.exists()

    baked_occlusion(Mesh("facet", (part,)))
    assert answer(capsys, "clear")[1]["occlusion"]["removed"] == 1  # type: ignore[index] # JSON
    assert occlusion_cache().entries() == []


def test_an_action_is_needed(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    with pytest.raises(SystemExit) as stopped:
        main(["cache"])
    assert stopped.value.code == 2
    assert "info" in capsys.readouterr().err


def test_pictures_of_paints_are_reported_checked_and_removed(capsys: pytest.CaptureFixture[str]) -> None:
    store = SwatchStore()
    store.put({f"{index:064d}": np.full((8, 8, 3), index, np.uint8) for index in range(3)})
    assert answer(capsys, "info")[1]["swatches"]["pictures"] == 3  # type: ignore[index] # JSON
    with sqlite3.connect(store.path) as file:
        file.execute("UPDATE pictures SET checksum = checksum + 1 WHERE key = ?", (f"{1:064d}",))
    file.close()
    status, facts = answer(capsys, "verify")
    assert status == 1
    assert (facts["swatches"]["sound"], facts["swatches"]["damaged"]) == (2, 1)  # type: ignore[index] # JSON
    assert answer(capsys, "verify", "--remove")[0] == 1
    assert answer(capsys, "verify")[0] == 0
    assert answer(capsys, "clear")[1]["swatches"]["removed"] == 2  # type: ignore[index] # JSON
    assert store.get([f"{0:064d}"]) == {}
    assert main(["cache", "info"]) == 0
    assert "0 pictures" in capsys.readouterr().out
