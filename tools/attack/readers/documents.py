"""Documents of the suite, exports that are read back, tables of instruments, stored arrays and caches."""

from __future__ import annotations

import functools
import hashlib
import json
import shutil
from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path

import numpy as np

from brdf_suite.acquisition.reconstruction.work_file import CALIBRATION, POSITION, open_work
from brdf_suite.acquisition.session.store import read_session
from brdf_suite.acquisition.session.template import write_template
from brdf_suite.documents.factor_textures import read_textures, write_textures
from brdf_suite.documents.factored import FactoredPaint, TextureFile
from brdf_suite.documents.palette_store import load_palette, save_palette
from brdf_suite.documents.project import (
    NamedView,
    Project,
    ProjectPicture,
    load_project,
    project_parts,
    save_project,
)
from brdf_suite.documents.store import load_any_paint, load_view, save_paint, save_view
from brdf_suite.documents.view import View
from brdf_suite.files.exports import json_document
from brdf_suite.files.exports.format import ExportItem
from brdf_suite.files.meshes.occlusion_cache import encode_baked, read_baked
from brdf_suite.fitting.basis_search.document import STATE_FORMAT, STATE_VERSION, load_search, load_state
from brdf_suite.fitting.cook_torrance.fit import StartsFile
from brdf_suite.fitting.lobes.basis import read_basis
from brdf_suite.lighting.filter.face_array import FaceArray
from brdf_suite.lighting.filter.lobe_maps import LobeMaps
from brdf_suite.lighting.lobe_map_cache import encode_maps, pack_maps, read_maps, read_packed_maps
from brdf_suite.paint_design.standard_files import load_standards
from brdf_suite.palettes.swatches.store import SwatchStore
from brdf_suite.pipeline.material import load_material, load_shipped_paint
from brdf_suite.regular_files import read_bytes
from brdf_suite.reports.handover import formats, read_paints
from brdf_suite.reports.paint_report import html
from brdf_suite.resources import resource
from brdf_suite.surface.mesh import Mesh, PartGeometry
from brdf_suite.surface.occlusion.rays import BakedMesh, BakedPart, GroundLight
from tools.attack.readers.measured import LOBES
from tools.attack.readers.palettes import TABLE, TREE, small_palette
from tools.attack.readers.reader import MEGABYTE, Reader, WrongValueError, text_files

KEY = "key"
_PAGES = {
    "html": (b"<!doctype html>" + html._OPEN.encode(), html._CLOSE.encode()),
    "pdf": (b"%PDF-1.4\nstream\n", b"endstream"),
}
_FACTORS = "p:wo q:h p:wi"


def maps_of(seed: int, size: int = 4) -> LobeMaps:
    """Return small maps of noise that stand for filtered ones, always the same."""
    rng = np.random.default_rng(seed)
    made = [FaceArray(rng.random((6, size, size, 3)).astype(np.float16), 0.5) for _ in range(4)]
    return LobeMaps((3.0, 40.0), (made[0], made[1]), made[2], made[2], made[3])


@functools.cache
def tetrahedron() -> Mesh:
    """Return a mesh of four triangles."""
    points = np.array([(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)])
    normals = points - points.mean(axis=0)
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    faces = np.array([(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)])
    return Mesh("made", (PartGeometry("body", "paint", points, normals, 1000.0 * points[:, :2], faces),))


def baked_mesh() -> BakedMesh:
    """Return what could have been baked for the tetrahedron."""
    part = tetrahedron().parts[0]
    values = {name: getattr(part, name) for name in ("positions", "normals", "uvs", "triangles")}
    light = np.full((4, 8), 0.5, np.float16)
    ground = GroundLight(0.0, (-1.0, -1.0), (1.0, 1.0), np.full((4, 4, 8), 0.5, np.float32))
    return BakedMesh((BakedPart(**values, light=light),), ground)


def shipped_paint() -> object:
    """Return the plainest shipped paint."""
    return load_shipped_paint("blue")


def _paints(folder: Path) -> list[Path]:
    save_paint(load_shipped_paint("coarse_silver"), folder / "flakes.brdfpaint")
    save_paint(LOBES, folder / "lobes.brdfpaint")
    return [folder / "flakes.brdfpaint", folder / "lobes.brdfpaint"]


def _maps_file(document: Path) -> TextureFile:
    rng = np.random.default_rng(5)
    maps = {name: rng.random((8, 8, 3)).astype(np.float32) + 0.1 for name in ("p", "q")}
    return write_textures(maps, document)


def _factored_paint(textures: TextureFile) -> FactoredPaint:
    return FactoredPaint("F", textures, _FACTORS, (0.5, 0.6, 0.7))


def _factored(folder: Path) -> list[Path]:
    path = folder / "factored.brdfpaint"
    save_paint(_factored_paint(_maps_file(path)), path)
    return [path]


def _read_factored(path: Path) -> None:
    load_any_paint(path)
    load_material(path)


def _textures(folder: Path) -> list[Path]:
    return [Path(_maps_file(folder / "factored.brdfpaint").path)]


def _read_textures(path: Path) -> None:
    """Read maps by a paint that names the damaged file's own checksum."""
    digest = hashlib.sha256(read_bytes(path)).hexdigest()
    read_textures(_factored_paint(TextureFile(str(path), digest)))


def _projects(folder: Path) -> list[Path]:
    project = Project(
        "P",
        (load_shipped_paint("blue"), LOBES),
        load_shipped_paint("copper"),
        (NamedView("front", View()),),
        pictures=(ProjectPicture("p", "front"),),
    )
    save_project(project, folder / "packed.brdfproject")
    return [folder / "packed.brdfproject"]


def _read_project(path: Path) -> None:
    project_parts(path)
    target = path.with_name("unpacked")
    try:
        load_project(path, target)
        found = [one for one in target.rglob("*") if one.is_file()]
        if any(target not in one.resolve().parents for one in found):
            raise WrongValueError("a file outside the folder")
    finally:
        shutil.rmtree(target, ignore_errors=True)


def _read_folder_project(path: Path) -> None:
    load_project(path.parent)


def _session(folder: Path) -> list[Path]:
    return [write_template(folder / "photographs").path]


def _work(folder: Path) -> list[Path]:
    with open_work(folder / "a.work") as work:
        work.add(CALIBRATION, {"key": "k", "times": [0.1, 1e-300]}, {})
        arrays = {"places": np.arange(5, dtype=np.int32), "sums": np.ones((5, 3), np.float32)}
        work.add(POSITION, {"position": 0}, arrays)
        work.add(POSITION, {"position": 1}, arrays)
    return [folder / "a.work"]


def _read_work(path: Path) -> None:
    with open_work(path) as work:
        for record in work.records:
            work.arrays(record)


def _basis(folder: Path) -> list[Path]:
    value = json.loads(resource("basis", "search.json").read_text())
    value["results"] = value["results"][:3]
    value["default_count"] = 2
    return text_files(search__json=json.dumps(value))(folder)


def _read_basis(path: Path) -> None:
    read_basis(path)
    load_search(path)


_SETTINGS = {"database_sha256": "0", "paints": ["a", "b"], "starts": 2}


def _search_state(folder: Path) -> list[Path]:
    results = json.loads(resource("basis", "search.json").read_text())["results"][:2]
    for result in results:
        for name in ("errors", "base_errors", "coat_errors"):
            result[name] = result[name][:2]
    value = {"format": STATE_FORMAT, "version": STATE_VERSION, "settings": _SETTINGS, "results": results}
    return text_files(state__json=json.dumps(value))(folder)


def _starts(folder: Path) -> list[Path]:
    StartsFile(folder / "starts.json").save(KEY, {0: [1.0, 2.0], 1: [0.5]})
    return [folder / "starts.json"]


def _swatches(folder: Path) -> list[Path]:
    store = SwatchStore(folder)
    rng = np.random.default_rng(1)
    store.put({f"{key:064x}": rng.integers(0, 255, (8, 8, 3), dtype=np.uint8) for key in range(3)})
    store.close()
    path = folder / "pictures.sqlite"
    path.write_bytes(store.path.read_bytes())
    shutil.rmtree(store.folder)
    return [path]


def _read_swatches(path: Path) -> None:
    """Put the damaged file in the store's place: what is served is what was kept, or nothing."""
    store = SwatchStore(path.parent / "cache", limit_bytes=1 << 24)
    store.folder.mkdir(parents=True, exist_ok=True)
    store.path.write_bytes(read_bytes(path))
    rng = np.random.default_rng(1)
    kept = {f"{key:064x}": rng.integers(0, 255, (8, 8, 3), dtype=np.uint8) for key in range(3)}
    try:
        for key, found in store.get(kept).items():
            if not np.array_equal(found, kept[key]):
                raise WrongValueError("another picture under this key")
        store.verify(remove=True)
        store.put(kept)
        store.size()
    finally:
        store.close()
        shutil.rmtree(store.folder, ignore_errors=True)


def _array_file(parts: Callable[[], list[bytes | memoryview] | bytes]) -> Callable[[Path], list[Path]]:
    def make(folder: Path) -> list[Path]:
        made = parts()
        return text_files(entry=made if isinstance(made, bytes) else b"".join(bytes(part) for part in made))(
            folder
        )

    return make


def _export(name: str) -> Callable[[Path], list[Path]]:
    def make(folder: Path) -> list[Path]:
        known = next(one for one in formats() if one.name == name)
        items = [ExportItem(load_shipped_paint("coarse_silver"))]
        if known.many:
            items.append(ExportItem(replace(load_shipped_paint("blue"), name="=1+1, <b>")))
        path = folder / f"made{known.ending}"
        if name in ("html", "pdf"):  # a page takes seconds to draw, and only the paint in it is read
            items = [ExportItem(load_shipped_paint("blue"))]
            json_document.FORMAT.write(items, path, None)
            content = json.dumps(json.loads(path.read_bytes())).encode()
            path.write_bytes(_PAGES[name][0] + content + _PAGES[name][1])
        else:
            known.write(items, path, None)
        return [path]

    return make


def _exports() -> Mapping[str, Callable[[Path], list[Path]]]:
    return {known.name: _export(known.name) for known in formats() if known.read is not None}


def _read_standards(path: Path) -> None:
    if not load_standards(path):
        raise WrongValueError("no standard")


def _instrument_seeds(folder: Path) -> list[Path]:
    comma = TABLE.replace(",", ".").replace(";", ",")
    text_files(table__csv=TABLE, comma__csv=comma, tabs__txt=comma.replace(",", "\t"), tree__xml=TREE)(folder)
    cxf = next(known for known in formats() if known.ending == ".cxf")
    cxf.write([ExportItem(load_shipped_paint("blue"))], folder / "made.cxf", None)
    return sorted(folder.iterdir())


def _view(folder: Path) -> list[Path]:
    save_view(View(), folder / "v.brdfview")
    return [folder / "v.brdfview"]


def _palette(folder: Path) -> list[Path]:
    save_palette(small_palette(), folder / "p.brdfpalette")
    return [folder / "p.brdfpalette"]


def _folder_project(folder: Path) -> list[Path]:
    own = folder / "p.brdfproject"
    save_project(Project("P", (load_shipped_paint("blue"),)), own, folder=True)
    return [own / "project.json"]


READERS = [
    Reader("document:paint", load_any_paint, _paints),
    Reader("document:factored", _read_factored, _factored),
    Reader("document:textures", _read_textures, _textures, memory=1024 * MEGABYTE),
    Reader("document:view", load_view, _view),
    Reader("document:palette", load_palette, _palette, has_place=True),
    Reader("document:project", _read_project, _projects),
    Reader("document:project_folder", _read_folder_project, _folder_project),
    Reader("document:session", read_session, _session),
    Reader("document:work", _read_work, _work),
    Reader("document:basis", _read_basis, _basis),
    Reader("document:search_state", lambda path: load_state(path, _SETTINGS), _search_state),
    Reader("document:starts", lambda path: StartsFile(path).load(KEY), _starts),
    Reader(
        "cache:maps", lambda path: read_maps(path, KEY), _array_file(lambda: encode_maps(maps_of(1), KEY))
    ),
    Reader(
        "cache:packed",
        lambda path: read_packed_maps(path, KEY),
        _array_file(lambda: pack_maps(maps_of(1), KEY, "")),
    ),
    Reader(
        "cache:occlusion",
        lambda path: read_baked(path, tetrahedron()),
        _array_file(lambda: encode_baked(tetrahedron(), baked_mesh())),
    ),
    Reader("cache:swatches", _read_swatches, _swatches),
    Reader("instrument:any", _read_standards, _instrument_seeds),
    *(Reader(f"export:{name}", read_paints, make) for name, make in _exports().items()),
]
