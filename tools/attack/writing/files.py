"""Views, lights, pictures, renders, sheets, videos, meshes and other files that are in no registry."""

from __future__ import annotations

import json
import re
import subprocess
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from PIL import Image

from brdf_suite.documents.store import load_view, save_view
from brdf_suite.documents.studio import Sky, load_light, save_light
from brdf_suite.documents.view import View
from brdf_suite.errors import FileError
from brdf_suite.files.cache.disk_cache import DiskCache
from brdf_suite.files.images.exr.image import read_exr, write_exr, write_exr_strips
from brdf_suite.files.images.primaries import REC2020
from brdf_suite.files.meshes.glb import write_mesh_glb
from brdf_suite.files.meshes.occlusion_cache import ENDING, LAYOUT, encode_baked, read_baked
from brdf_suite.files.meshes.reading import read_mesh
from brdf_suite.files.meshes.writing import PointMesh, write_obj, write_ply
from brdf_suite.fitting.basis_search.document import load_search, load_state, save_basis, save_state
from brdf_suite.output.video import ffmpeg, writing_video
from brdf_suite.reference.estimate_file import read_estimate, write_estimate
from brdf_suite.reference.passes import Estimate
from brdf_suite.reference.raytraced.picture import Sums, read_sums, write_sums
from brdf_suite.regular_files import read_bytes
from brdf_suite.reports.contact_sheet.document import write_sheet_of
from brdf_suite.reports.contact_sheet.pictures import SheetItem
from brdf_suite.resources import resource
from tools.attack.readers.documents import baked_mesh, tetrahedron
from tools.attack.writing.writer import VERSIONS, Writer, paint, read_one, version_of

_SIZE = (48, 32)
_COPIES = 500
_CACHED = 4


def _one_value(values: Any) -> int:
    """Return the version that all numbers of a picture stand for."""
    found = np.unique(np.round(np.asarray(values, float), 2))
    if len(found) != 1:
        raise ValueError(f"versions are mixed: {found[:4]}")
    return round(float(found[0]))


def _full(number: int) -> Any:
    return np.full((_SIZE[1], _SIZE[0], 3), float(number))


def _strips(folder: Path, number: int) -> None:
    rows = np.split(_full(number).astype(np.float32), 8)
    write_exr_strips(folder / "p.exr", _SIZE, rows, REC2020)


def _estimate(folder: Path, number: int) -> None:
    light = _full(number)
    write_estimate(folder / "e.exr", Estimate(light, light[..., 0], light, 8, 2), light, "key")


def _read_estimate(folder: Path) -> int:
    found = read_estimate(folder / "e.exr", "key")
    assert found is not None
    return _one_value(np.concatenate([found.radiance.ravel(), found.squares.ravel()]))


def _sums(folder: Path, number: int) -> None:
    values = np.full((_SIZE[1], _SIZE[0], 7), float(number))
    write_sums(folder / "s.exr", Sums(values, 1), values[..., :3], "key")


def _read_sums(folder: Path) -> int:
    found = read_sums(folder / "s.exr", "key")
    assert found is not None
    return _one_value(found.values)


def _sheet(ending: str) -> Writer:
    def write(folder: Path, number: int) -> None:
        items = [SheetItem(f"v{number}", "", paint(number))]
        write_sheet_of(f"v{number}", items, View(), _SIZE, folder / f"s{ending}", form="chips")

    def read(folder: Path) -> int:
        content = read_bytes(folder / f"s{ending}")
        if ending == ".png":
            with Image.open(folder / "s.png") as picture:
                picture.load()
                return version_of(str(picture.info["Title"]))
        if not content.rstrip().endswith(b"%%EOF"):
            raise ValueError("it is cut off")
        return read_one(found.decode() for found in re.findall(rb"\bTitle\W+(v\d+)\W", content))

    return Writer(f"export:sheet_{ending[1:]}", write, read)


def _video(folder: Path, number: int) -> None:
    with writing_video(folder / "v.mp4", _SIZE, 25.0, {"Title": f"v{number}"}) as add:
        for _ in range(8):
            add(np.full((_SIZE[1], _SIZE[0], 3), number, np.uint8))


def _read_video(folder: Path) -> int:
    path = folder / "v.mp4"
    line = [ffmpeg(), "-v", "error", "-i", str(path), "-f", "rawvideo", "-pix_fmt", "rgb24", "-"]
    done = subprocess.run(line, capture_output=True, check=False)
    if done.stderr or len(done.stdout) != 8 * 3 * _SIZE[0] * _SIZE[1]:
        raise ValueError(f"{len(done.stdout)} bytes {done.stderr[-200:]!r}")
    number = read_one(found.decode() for found in re.findall(rb"\0(v\d+)\0", read_bytes(path) + b"\0"))
    if abs(float(np.frombuffer(done.stdout, np.uint8).mean()) - number) > 3.0:
        raise ValueError("frames of another version")
    return number


def _points(number: int) -> PointMesh:
    part = tetrahedron().parts[0]
    points = np.tile(np.asarray(part.positions), (_COPIES, 1)) + number
    normals = np.tile(np.asarray(part.normals), (_COPIES, 1))
    faces = np.concatenate([np.asarray(part.triangles) + 4 * index for index in range(_COPIES)])
    return PointMesh(points, normals, np.zeros((len(points), 3), np.uint8), faces)


def _glb(folder: Path, number: int) -> None:
    mesh = tetrahedron()
    part = mesh.parts[0]
    write_mesh_glb(replace(mesh, parts=(replace(part, positions=part.positions + number),)), folder / "m.glb")


def _corner(name: str, triangles: int) -> Callable[[Path], int]:
    """Return what reads a mesh, whose corner nearest to the origin names the version."""

    def read(folder: Path) -> int:
        found = read_mesh(folder / name, up="y").parts
        if sum(len(part.triangles) for part in found) != triangles:
            raise ValueError("triangles are missing")
        return round(float(np.concatenate([part.positions for part in found]).min()))

    return read


def _occlusion_cache(folder: Path) -> DiskCache:
    size = sum(len(part) for part in encode_baked(tetrahedron(), baked_mesh()))
    limit = (_CACHED - 1) * size + size // 2  # room for all but one: some have to go all the time
    return DiskCache("occlusion", "baked surfaces", LAYOUT, ENDING, folder / "cache", limit_bytes=limit)


def _occlusion(folder: Path, number: int) -> None:
    cache, mesh = _occlusion_cache(folder), tetrahedron()
    cache.get_or_make(
        f"{number:064x}",
        lambda path: read_baked(path, mesh),
        lambda _progress: baked_mesh(),
        lambda baked: encode_baked(mesh, baked),
        None,
    )
    if cache.notices:
        raise ValueError(cache.notices[0])


def _read_occlusion(folder: Path) -> int:
    cache = _occlusion_cache(folder)
    for number in range(VERSIONS):
        try:
            read_baked(cache.path(f"{number:064x}"), tetrahedron())
        except FileError as error:
            if not isinstance(error.__cause__, FileNotFoundError):
                raise
    return -1


def _stored_search() -> Any:
    return load_search(resource("basis", "search.json"))


def _basis(folder: Path, number: int) -> None:
    known = _stored_search()
    save_basis(folder / "b.json", known.paints, known.results, known.default_count, {"by": f"v{number}"})


def _read_basis(folder: Path) -> int:
    load_search(folder / "b.json")
    return version_of(json.loads(read_bytes(folder / "b.json"))["provenance"]["by"])


def _state(folder: Path, number: int) -> None:
    known = _stored_search()
    settings = {"database_sha256": "0", "paints": list(known.paints), "starts": number}
    save_state(folder / "s.json", settings, known.results[:3])


def _read_state(folder: Path) -> int:
    settings = json.loads(read_bytes(folder / "s.json"))["settings"]
    load_state(folder / "s.json", settings)
    return int(settings["starts"])


WRITERS = (
    Writer(
        "document:view",
        lambda folder, number: save_view(replace(View(), rotation_deg=float(number)), folder / "v.brdfview"),
        lambda folder: round(load_view(folder / "v.brdfview").rotation_deg) % 360,
    ),
    Writer(
        "document:studio",
        lambda folder, number: save_light(Sky(f"v{number}"), folder / "s.brdfstudio"),
        lambda folder: version_of(load_light(folder / "s.brdfstudio").name),
    ),
    Writer("document:basis", _basis, _read_basis),
    Writer("document:search_state", _state, _read_state),
    Writer(
        "export:exr",
        lambda folder, number: write_exr(folder / "p.exr", _full(number).astype(np.float32)),
        lambda folder: _one_value(read_exr(folder / "p.exr").pixels),
    ),
    Writer("export:exr_strips", _strips, lambda folder: _one_value(read_exr(folder / "p.exr").pixels)),
    Writer("render:estimate", _estimate, _read_estimate),
    Writer("render:sums", _sums, _read_sums),
    _sheet(".png"),
    _sheet(".pdf"),
    Writer("export:video", _video, _read_video),
    Writer(
        "export:obj",
        lambda folder, number: write_obj(folder / "m.obj", _points(number)),
        _corner("m.obj", 4 * _COPIES),
    ),
    Writer(
        "export:ply",
        lambda folder, number: write_ply(folder / "m.ply", _points(number)),
        _corner("m.ply", 4 * _COPIES),
    ),
    Writer("export:glb", _glb, _corner("m.glb", 4)),
    Writer("cache:occlusion", _occlusion, _read_occlusion, optional=True),
)
