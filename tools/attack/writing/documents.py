"""Documents, files of the acquisition and of batches, and caches as the harness writes them."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np

from brdf_suite.acquisition.reconstruction.work_file import POSITION, open_work
from brdf_suite.acquisition.session.store import read_session, write_session
from brdf_suite.acquisition.session.template import write_template
from brdf_suite.batches.journal import Finished, journal_of
from brdf_suite.documents.factor_textures import read_textures, write_textures
from brdf_suite.documents.factored import FactoredPaint
from brdf_suite.documents.palette_store import load_palette, save_palette
from brdf_suite.documents.project import Project, load_project, save_project
from brdf_suite.documents.store import load_any_paint, save_paint
from brdf_suite.errors import FileError
from brdf_suite.files.images.pictures import read_rgb
from brdf_suite.files.images.png import write_png
from brdf_suite.lighting import lobe_map_cache
from brdf_suite.lighting.environment import Environment
from brdf_suite.palettes.swatches.store import SwatchStore
from tools.attack.readers.documents import maps_of
from tools.attack.writing.writer import FILL, Writer, paint, palette, version_of


def _textures(folder: Path, number: int) -> None:
    path = folder / "f.brdfpaint"
    maps = {name: np.full((16, 16, 3), 0.1 + number % 2, np.float32) for name in "pq"}
    save_paint(
        FactoredPaint(f"v{number}", write_textures(maps, path), "p:wo q:h p:wi", (1.0, 1.0, 1.0)), path
    )


def _read_textures(folder: Path) -> int:
    paint = load_any_paint(folder / "f.brdfpaint")
    assert isinstance(paint, FactoredPaint)
    number = version_of(paint.name)
    if not np.allclose(read_textures(paint)["p"], 0.1 + number % 2):
        raise ValueError("the maps are of another version")
    return number


def _picture(folder: Path, number: int) -> None:
    write_png(folder / "p.png", np.full((200, 300, 3), number % 256, np.uint8))


def _read_picture(folder: Path) -> int:
    found = np.unique(read_rgb(folder / "p.png", ("PNG",)))
    if len(found) != 1:
        raise ValueError("versions are mixed")
    return int(found[0])


def _session(folder: Path, number: int) -> None:
    photographs = folder / "photographs"
    if not (photographs / "session.json").exists():
        write_template(photographs)
    write_session(replace(read_session(photographs), notes=f"v{number}"), photographs)


def _work(folder: Path, number: int) -> None:
    with open_work(folder / "a.work") as work:
        if len(work.records) > 30:
            work.empty()
        work.add(POSITION, {"position": number}, {"sums": np.full((5000, 3), number, np.float32)})


def _read_work(folder: Path) -> int:
    with open_work(folder / "a.work") as work:
        for record in work.records:
            if not np.all(work.arrays(record)["sums"] == record.values["position"]):
                raise ValueError("a record of another position")
        return int(work.records[-1].values["position"]) if work.records else -1


def _journal(folder: Path, number: int) -> None:
    with journal_of(folder / "results", "step") as journal:
        journal.append([Finished("key", f"v{number}", FILL, {})])


def _read_journal(folder: Path) -> int:
    with journal_of(folder / "results", "step") as journal:
        return version_of(journal.finished["key"].label)


_CACHED = 4


def _environment(index: int) -> Environment:
    pixels = np.random.default_rng(index).random((8, 16, 3)).astype(np.float32)
    return Environment(f"environment {index}", pixels)


def _map_cache(folder: Path) -> lobe_map_cache.MapCache:
    # Filtering is not what is killed.
    lobe_map_cache.__dict__["prefilter"] = lambda environment, *_: maps_of(
        int(environment.name.split()[1]), 96
    )
    size = sum(len(part) for part in lobe_map_cache.encode_maps(maps_of(0, 96), "k"))
    # Room for all but one: some have to go all the time.
    return lobe_map_cache.MapCache(folder / "cache", limit_bytes=(_CACHED - 1) * size + size // 2)


def _write_maps(folder: Path, number: int) -> None:
    cache = _map_cache(folder)
    cache.get_or_compute(_environment(number % _CACHED), (3.0, 40.0))
    if cache.notices:
        raise ValueError(cache.notices[0])


def _read_maps(folder: Path) -> int:
    """Check all entries by their checksums and against what was written."""
    cache = _map_cache(folder)
    if not (cache.folder).exists():
        return -1
    for index in range(_CACHED):
        key = lobe_map_cache.cache_key(_environment(index), (3.0, 40.0))
        try:
            found = lobe_map_cache.read_maps(cache.path(key), key)
        except FileError as error:
            if isinstance(error.__cause__, FileNotFoundError):
                continue  # it was never made, or another program made room
            raise
        if not np.array_equal(found.diffuse.faces, maps_of(index, 96).diffuse.faces):
            raise ValueError("the maps of another environment")
    return -1


def _swatch(number: int) -> np.ndarray:
    return np.full((32, 32, 3), number % 251, np.uint8)


def _write_swatches(folder: Path, number: int) -> None:
    store = SwatchStore(folder / "cache", limit_bytes=1 << 20)
    store.put({f"{key:064x}": _swatch(key) for key in range(number % 40, number % 40 + 20)})
    store.close()
    if store.notices:
        raise ValueError(store.notices[0])


def _read_swatches(folder: Path) -> int:
    store = SwatchStore(folder / "cache", limit_bytes=1 << 20)
    try:
        for key, found in store.get([f"{key:064x}" for key in range(60)]).items():
            if not np.array_equal(found, _swatch(int(key, 16))):
                raise ValueError("another picture under this key")
        damaged = store.verify()[1]
        if damaged or store.notices:
            raise ValueError(f"{damaged} damaged pictures {store.notices}")
        return -1
    finally:
        store.close()


WRITERS: tuple[Writer, ...] = (
    Writer(
        "document:paint",
        lambda folder, number: save_paint(paint(number), folder / "p.brdfpaint"),
        lambda folder: version_of(load_any_paint(folder / "p.brdfpaint").name),
    ),
    Writer(
        "document:palette",
        lambda folder, number: save_palette(palette(number), folder / "p.brdfpalette"),
        lambda folder: version_of(load_palette(folder / "p.brdfpalette").name),
    ),
    Writer("document:factored", _textures, _read_textures),
    Writer(
        "document:project",
        lambda folder, number: save_project(
            Project(f"v{number}", (paint(number),)), folder / "p.brdfproject"
        ),
        lambda folder: version_of(load_project(folder / "p.brdfproject").name),
    ),
    Writer(
        "document:project_folder",
        lambda folder, number: save_project(
            Project(f"v{number}", (paint(number),)), folder / "p.brdfproject", folder=True
        ),
        lambda folder: version_of(load_project(folder / "p.brdfproject").name),
    ),
    Writer(
        "document:session", _session, lambda folder: version_of(read_session(folder / "photographs").notes)
    ),
    Writer("document:work", _work, _read_work),
    Writer("document:journal", _journal, _read_journal),
    Writer("export:picture", _picture, _read_picture),
    Writer("cache:maps", _write_maps, _read_maps, optional=True),
    Writer("cache:swatches", _write_swatches, _read_swatches, optional=True),
)
