"""A save that fails leaves the old file whole and nothing beside it."""

from __future__ import annotations

import errno
import os
import signal
import stat
import subprocess
import sys
import tempfile
from contextlib import nullcontext
from functools import partial
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import OpenEXR
import pytest

from brdf_suite.documents.atomic import (
    check_target,
    documents_in,
    is_unfinished,
    make_folder,
    remove_unfinished,
    replacing,
)
from brdf_suite.documents.exr_writing import write_by_library
from brdf_suite.documents.paint import solid_paint
from brdf_suite.documents.store import load_paint, save_paint
from brdf_suite.errors import FileError

OLD = solid_paint("old", (50.0, 0.0, 0.0))

SAVE_NEW = """
import dataclasses, sys
from brdf_suite.documents.paint import solid_paint
from brdf_suite.documents.store import save_paint
from brdf_suite.errors import FileError
new = dataclasses.replace(solid_paint("new", (60.0, 0.0, 0.0)), notes="n" * 90_000)
try:
    save_paint(new, sys.argv[1])
except FileError as error:
    print(error)
    sys.exit(3)
"""


def run(prelude: str, path: Path) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-c", prelude + SAVE_NEW, str(path)]
    return subprocess.run(command, capture_output=True, text=True, timeout=240, check=False)


@pytest.fixture
def path(tmp_path: Path) -> Path:
    path = tmp_path / "paint.brdfpaint"
    save_paint(OLD, path)
    return path


@pytest.mark.parametrize("step", ["os.fsync", "os.replace"])
def test_a_kill_before_the_last_step_keeps_the_old_file(path: Path, step: str) -> None:
    kill = f"import os, signal\n{step} = lambda *a: os.kill(os.getpid(), signal.SIGKILL)\n"
    assert run(kill, path).returncode == -signal.SIGKILL
    assert load_paint(path) == OLD
    assert len(list(path.parent.iterdir())) == 2, "the process died in the middle of a save"
    assert run("", path).returncode == 0
    assert load_paint(path).name == "new", "what the dead one left is no obstacle"


def test_a_full_disk_keeps_the_old_file(path: Path) -> None:
    # The limit makes the system refuse to let a file grow past 20,000 bytes, in the middle of the writing.
    full = "import resource\nresource.setrlimit(resource.RLIMIT_FSIZE, (20_000, 20_000))\n"
    result = run(full, path)
    assert (result.returncode, result.stderr) == (3, "")
    assert f"{path}: cannot be written: File too large." in result.stdout
    assert load_paint(path) == OLD
    assert list(path.parent.iterdir()) == [path]


@pytest.mark.skipif(not hasattr(os, "seteuid"), reason="needs the rights of POSIX")
def test_a_folder_that_may_be_written_and_not_read_takes_a_save() -> None:
    with tempfile.TemporaryDirectory() as shared:  # the folder of the test is closed to other users
        folder = Path(shared, "kept")
        folder.mkdir()
        user = os.geteuid()
        try:
            if user == 0:
                Path(shared).chmod(0o755)
                os.chown(folder, 65534, -1)
                os.seteuid(65534)
            folder.chmod(0o300)
            for paint in (OLD, solid_paint("new", (60.0, 0.0, 0.0))):
                save_paint(paint, folder / "paint.brdfpaint")
            with pytest.raises(PermissionError):
                list(folder.iterdir())
        finally:
            os.seteuid(user)
            folder.chmod(0o700)
        assert load_paint(folder / "paint.brdfpaint").name == "new"


@pytest.mark.parametrize(
    ("code", "is_saved"), [(errno.EINVAL, True), (errno.EBADF, True), (errno.EIO, False)]
)
def test_a_file_system_that_flushes_no_folders_takes_a_save(
    path: Path, monkeypatch: pytest.MonkeyPatch, code: int, is_saved: bool
) -> None:
    flush = os.fsync

    def flush_files(descriptor: int) -> None:
        if stat.S_ISDIR(os.fstat(descriptor).st_mode):
            raise OSError(code, os.strerror(code))
        flush(descriptor)

    monkeypatch.setattr(os, "fsync", flush_files)
    with nullcontext() if is_saved else pytest.raises(FileError, match="cannot be written"):
        save_paint(solid_paint("new", (60.0, 0.0, 0.0)), path)


def test_a_failing_replace_keeps_the_old_file(path: Path, full_disk: None) -> None:
    with pytest.raises(FileError, match="No space left on device"):
        save_paint(solid_paint("new", (60.0, 0.0, 0.0)), path)
    assert load_paint(path) == OLD
    assert list(path.parent.iterdir()) == [path]


def test_places_that_cannot_be_written_are_named(tmp_path: Path) -> None:
    with pytest.raises(FileError, match=r"none.*cannot be written: No such file"):
        save_paint(OLD, tmp_path / "none" / "a.brdfpaint")
    with pytest.raises(FileError, match="not a plain file"):
        save_paint(OLD, tmp_path)


def test_what_a_killed_writer_left_goes_with_the_next_save(path: Path) -> None:
    kill = "import os, signal\nos.fsync = lambda *a: os.kill(os.getpid(), signal.SIGKILL)\n"
    assert run(kill, path).returncode == -signal.SIGKILL
    other = path.with_name(".paint.brdfpaint")  # a document whose name is a hidden one
    save_paint(OLD, other)
    (left,) = [file for file in path.parent.iterdir() if is_unfinished(file)]
    assert list(documents_in(path.parent, ".brdfpaint")) != []
    assert left not in documents_in(path.parent, ".brdfpaint")
    save_paint(OLD, path)
    assert sorted(path.parent.iterdir()) == sorted([path, other])


def test_what_another_writer_is_writing_stays(path: Path) -> None:
    with replacing(path) as first:
        first.write_bytes(b"half")
        remove_unfinished(path)
        assert first.exists()
        save_paint(OLD, path)
        assert first.exists()
        first.write_bytes(path.read_bytes())
    assert list(path.parent.iterdir()) == [path]


def test_an_empty_one_goes_too(path: Path) -> None:
    path.with_name(".paint.0123456789abcdef.brdfpaint").touch()
    remove_unfinished(path)
    assert list(path.parent.iterdir()) == [path]


@pytest.mark.skipif(sys.platform == "win32", reason="sets a limit of Unix")
@pytest.mark.parametrize("size", [0, 1, 100, 900])
def test_small_maps_on_a_full_disk_are_an_error(tmp_path: Path, size: int) -> None:
    script = (
        "import resource, signal, sys\n"
        "import numpy as np\n"
        "from brdf_suite.documents.factor_textures import write_textures\n"
        "from brdf_suite.errors import FileError\n"
        "signal.signal(signal.SIGXFSZ, signal.SIG_IGN)\n"
        f"resource.setrlimit(resource.RLIMIT_FSIZE, ({size}, {size}))\n"
        "try:\n"
        "    write_textures({name: np.full((16, 16, 3), 0.5, np.float32) for name in 'pq'}, sys.argv[1])\n"
        "except FileError as error:\n"
        "    print(error)\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", script, str(tmp_path / "a.brdfpaint")],
        capture_output=True,
        text=True,
        timeout=240,
        check=False,
    )
    assert "cannot be written" in done.stdout, done.stderr
    assert list(tmp_path.iterdir()) == []


def write_content(content: bytes, name: str) -> None:
    Path(name).write_bytes(content)


@pytest.mark.parametrize("shape", [(1, 1), (5, 3), (40, 7), (300, 2)])
@pytest.mark.parametrize("parts", [1, 3])
def test_whole_files_of_any_height_are_whole_and_none_that_is_cut_off(
    tmp_path: Path, shape: tuple[int, int], parts: int
) -> None:
    rng = np.random.default_rng(1)
    planes = {name: rng.random(shape).astype(np.float32) for name in "RGB"}
    path = tmp_path / "a.exr"
    for compression in (OpenEXR.ZIP_COMPRESSION, OpenEXR.PIZ_COMPRESSION, OpenEXR.DWAB_COMPRESSION):
        header = {"compression": compression, "type": OpenEXR.scanlineimage}
        made = [OpenEXR.Part({**header, "name": f"p{k}"}, dict(planes), f"p{k}") for k in range(parts)]
        write_by_library(OpenEXR.File(made) if parts > 1 else OpenEXR.File(header, planes), path, path)
        content = path.read_bytes()
        for size in (0, 7, 60, len(content) // 2, len(content) - 1):
            cut = SimpleNamespace(write=partial(write_content, content[:size]))
            with pytest.raises(FileError, match="cannot be written"):
                write_by_library(cut, path, path)


@pytest.mark.parametrize("name", ["file", "file/below", "x" * 300, "a\0b"])
def test_a_folder_that_cannot_be_made_is_named(name: str, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(FileError, match=r": cannot be made: \w") as found:
        make_folder(tmp_path / name)
    assert found.value.path == str(tmp_path / name)


def test_a_folder_is_made_with_those_that_it_lies_in(tmp_path: Path) -> None:
    folder = tmp_path / "new" / "and" / "below"
    make_folder(folder)
    make_folder(folder)
    assert folder.is_dir()


@pytest.mark.parametrize(
    ("name", "reason"),
    [
        ("none/new", "its folder does not exist"),
        ("file/new", "its folder does not exist"),
        (f"{'x' * 300}/new", "its folder cannot be used"),
        ("x" * 300, "cannot be written"),
        ("a\0b", "cannot be written"),
        ("folder", "cannot be written: it is not a plain file"),
        ("link", "link: its folder does not exist"),
    ],
)
def test_a_name_under_which_nothing_can_be_written_is_refused(name: str, reason: str, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    (tmp_path / "folder").mkdir()
    (tmp_path / "link").symlink_to(tmp_path / "none" / "new")
    with pytest.raises(FileError, match=reason):
        check_target(tmp_path / name)


def test_a_file_is_replaced_only_where_that_was_asked_for(tmp_path: Path) -> None:
    file = tmp_path / "file"
    file.write_text("")
    check_target(tmp_path / "new", overwrite=False)
    check_target(file)
    with pytest.raises(FileError, match=r"exists already.*--overwrite"):
        check_target(file, overwrite=False)


def test_a_folder_that_may_not_be_written_is_found_before_the_work(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked = []

    def access(folder: Path, mode: int) -> bool:
        asked.append((folder, mode))
        return False  # root, who runs these tests here and there, may write anywhere

    (tmp_path / "other").mkdir()
    (tmp_path / "link").symlink_to(tmp_path / "other" / "new")
    monkeypatch.setattr(os, "access", access)
    for name in ("new", "link"):
        with pytest.raises(FileError, match=f"{name}: its folder cannot be written"):
            check_target(tmp_path / name)
    assert asked == [(tmp_path, os.W_OK), (tmp_path / "other", os.W_OK)]
