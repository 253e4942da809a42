"""Only regular files of a bounded size are opened, by every reader: nothing waits for a pipe or a device."""

from __future__ import annotations

import os
import socket
import threading
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from brdf_suite.acquisition.photographs.reading import read_photograph
from brdf_suite.documents.palette_store import load_palette
from brdf_suite.documents.project import load_project
from brdf_suite.documents.store import load_any_paint, load_paint, load_view
from brdf_suite.documents.studio import load_light
from brdf_suite.errors import FileError
from brdf_suite.files.array_file import Layout, read_arrays
from brdf_suite.files.cxf import read_cxf
from brdf_suite.files.exports import read_paints
from brdf_suite.files.images.environments import read_environment_image
from brdf_suite.files.images.pictures import read_picture
from brdf_suite.files.images.relief import read_mask, read_normal_map
from brdf_suite.files.instruments import read_instrument
from brdf_suite.files.measured import read_measured
from brdf_suite.files.meshes.reading import read_mesh
from brdf_suite.files.palettes import read_palette
from brdf_suite.files.palettes.cmyk_profile import read_profile
from brdf_suite.fitting.cook_torrance.fit import StartsFile
from brdf_suite.pipeline.material import load_material
from brdf_suite.reference.state_file import reading_state
from brdf_suite.regular_files import (
    check_regular,
    exists,
    is_file,
    is_folder,
    open_regular,
    read_bytes,
    read_text,
)

pytestmark = pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="needs named pipes")


def read_state(path: Path) -> None:
    with reading_state(path, "state"):
        pass


READERS: dict[str, Callable[[Path], Any]] = {
    "array": lambda path: read_arrays(Layout(b"TEST", 1, "a test", ("<f4",)), path),
    "cmyk": read_profile,
    "cxf": read_cxf,
    "environment": read_environment_image,
    "exchanged": read_paints,
    "instrument": read_instrument,
    "light": load_light,
    "mask": read_mask,
    "material": load_material,
    "measured": read_measured,
    "mesh": read_mesh,
    "normals": read_normal_map,
    "paint": load_paint,
    "any paint": load_any_paint,
    "palette": load_palette,
    "foreign palette": read_palette,
    "photograph": read_photograph,
    "picture": read_picture,
    "project": load_project,
    "starts": lambda path: StartsFile(path).load("key"),
    "state": read_state,
    "view": load_view,
}


def pipe(path: Path) -> None:
    os.mkfifo(path)


def device(path: Path) -> None:
    path.symlink_to("/dev/zero")


def folder(path: Path) -> None:
    path.mkdir()


def listening(path: Path) -> None:
    with socket.socket(socket.AF_UNIX) as server:
        server.bind(str(path))


def dangling(path: Path) -> None:
    path.symlink_to(path.with_name("not there"))


@pytest.mark.parametrize("reader", READERS)
@pytest.mark.parametrize("make", [pipe, device, folder, listening, dangling], ids=lambda make: make.__name__)
def test_every_reader_refuses_what_is_no_file(
    reader: str, make: Callable[[Path], None], tmp_path: Path
) -> None:
    path = tmp_path / "a"
    make(path)
    if (reader, make) == ("project", folder):
        pytest.skip("a project may be a folder")
    with pytest.raises(FileError):
        READERS[reader](path)


@pytest.mark.parametrize(
    "reader", [name for name in READERS if name != "starts"]
)  # they have a few kilobytes
def test_every_reader_reports_that_memory_ran_out(
    reader: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def run_out(*_: object) -> None:
        raise MemoryError

    path = tmp_path / "a"
    path.write_bytes(b"content")
    with monkeypatch.context() as patched:
        patched.setattr(os, "fstat", run_out)
        with pytest.raises(FileError, match=r"not enough memory|too many pixels|no render to resume"):
            READERS[reader](path)


def test_the_reason_is_named(tmp_path: Path) -> None:
    for make, words in (
        (pipe, "is not a plain file"),
        (folder, r"is not a plain file \(it is a folder\)"),
        (dangling, "it is a link to a file that is not there"),
    ):
        path = tmp_path / make.__name__
        make(path)
        with pytest.raises(FileError, match=words):
            check_regular(path)
    with pytest.raises(FileError, match="No such file"):
        check_regular(tmp_path / "none")
    with pytest.raises(FileError, match="NUL character"):
        check_regular("a\0b")


def test_the_size_is_bounded_and_the_content_whole(tmp_path: Path) -> None:
    path = tmp_path / "a"
    path.write_bytes("Ä".encode() * 50)
    assert read_bytes(path, 100) == path.read_bytes()
    assert read_text(path) == "Ä" * 50
    with pytest.raises(FileError, match="has 100 bytes, more than the 99"):
        read_bytes(path, 99)
    path.write_bytes(b"abc\xff")
    with pytest.raises(FileError, match="is not text in UTF-8"):
        read_text(path)
    link = tmp_path / "link"
    link.symlink_to(path)
    assert read_bytes(link) == b"abc\xff"


def test_a_pipe_that_takes_the_place_of_a_file_is_not_waited_for(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Between the look at the file and its opening another program may exchange it."""
    path, other = tmp_path / "a", tmp_path / "b"
    path.write_bytes(b"abc")
    os.mkfifo(other)
    opened = os.open

    def exchange(name: Any, flags: int, *more: Any, **options: Any) -> int:
        if Path(name) == path:
            other.replace(path)
        return opened(name, flags, *more, **options)

    monkeypatch.setattr(os, "open", exchange)
    with pytest.raises(FileError, match="is not a plain file"), open_regular(path):
        pass


OBJ = "mtllib {library}\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl one\nf 1 2 3\n"


@pytest.mark.parametrize("library", ["lib.mtl", "sub/lib.mtl"])
def test_a_mesh_whose_material_library_is_a_pipe_is_read_without_it(library: str, tmp_path: Path) -> None:
    place = tmp_path / library
    place.parent.mkdir(exist_ok=True)
    os.mkfifo(place)
    mesh = tmp_path / "a.obj"
    mesh.write_text(OBJ.format(library=library))
    assert read_mesh(mesh, unit="m").triangle_count == 1


@pytest.mark.parametrize("outside", ["../secret.mtl", "{folder}/secret.mtl", "..\\secret.mtl"])
def test_a_mesh_takes_no_material_library_of_another_folder(outside: str, tmp_path: Path) -> None:
    """With it, as with the same one beside the mesh, the part would be of glass."""
    (tmp_path / "secret.mtl").write_text("newmtl one\nKd 1 1 1\nd 0.3\n")
    inside = tmp_path / "in"
    inside.mkdir()
    mesh = inside / "a.obj"
    large = "v 9 0 0\nv 9 9 0\nv 0 9 0\nusemtl other\no large\nf 4 5 6\n"
    for library, material in ((outside.format(folder=tmp_path), "paint"), ("secret.mtl", "glass")):
        mesh.write_text(OBJ.format(library=library) + large)
        assert [part.material for part in read_mesh(mesh, unit="m").parts][::-1] == [material, "paint"]
        (inside / "secret.mtl").write_text((tmp_path / "secret.mtl").read_text())


def test_no_picture_of_a_material_is_opened(tmp_path: Path) -> None:
    """A pipe as a colour map would be waited for; PostScript there would reach Ghostscript."""
    (tmp_path / "lib.mtl").write_text("newmtl one\nmap_Kd picture.png\n")
    os.mkfifo(tmp_path / "picture.png")
    mesh = tmp_path / "a.obj"
    mesh.write_text(OBJ.format(library="lib.mtl"))
    assert read_mesh(mesh, unit="m").triangle_count == 1


def test_a_gltf_whose_buffer_is_a_pipe_is_refused(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "a.bin")
    path = tmp_path / "a.gltf"
    path.write_text(
        '{"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"meshes":[{"primitives":'
        '[{"attributes":{"POSITION":0}}]}],"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3",'
        '"count":3}],"bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":"a.bin"}]}'
    )
    with pytest.raises(FileError, match=r"needs a\.bin beside it, which is not a plain file"):
        read_mesh(path)
    (tmp_path / "a.bin").unlink()
    (tmp_path / "a.bin").write_bytes(np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]], "<f4").tobytes())
    assert read_mesh(path, unit="m").triangle_count == 1


def test_the_pipes_of_these_tests_would_hang(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "a")
    waiting = threading.Thread(target=(tmp_path / "a").read_bytes, daemon=True)
    waiting.start()
    waiting.join(0.2)
    assert waiting.is_alive()
    with (tmp_path / "a").open("wb"):
        pass
    waiting.join()


@pytest.mark.parametrize(
    ("name", "answers"),
    [
        ("file", (True, True, False)),
        ("folder", (True, False, True)),
        ("pipe", (True, False, False)),
        ("link", (True, True, False)),
        ("dangling", (False, False, False)),
        ("loop", (False, False, False)),
        ("none", (False, False, False)),
        ("file/below", (False, False, False)),
        ("nul\0", (False, False, False)),
    ],
)
def test_whether_a_file_is_there(name: str, answers: tuple[bool, ...], tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    (tmp_path / "folder").mkdir()
    os.mkfifo(tmp_path / "pipe")
    (tmp_path / "link").symlink_to("file")
    (tmp_path / "dangling").symlink_to("none")
    (tmp_path / "loop").symlink_to("loop")
    assert tuple(ask(tmp_path / name) for ask in (exists, is_file, is_folder)) == answers
    assert exists(str(tmp_path / name)) == answers[0]


@pytest.mark.parametrize("name", ["x" * 300, "x" * 300 + "/y", "d/" * 3000 + "x"])
def test_a_name_that_no_file_system_takes_is_an_error_and_no_file(name: str, tmp_path: Path) -> None:
    with pytest.raises(FileError, match="cannot be read: File name too long"):
        exists(tmp_path / name)
    assert not is_file(tmp_path / name)
    assert not is_folder(tmp_path / name)
