"""File ▸ Save Project and Collect Files: what a program has open is written, and everything else stays as it was."""

from __future__ import annotations

import errno
import os
from dataclasses import replace
from pathlib import Path

import pytest
from brdf_qt.documents.project_files import ProjectFiles
from brdf_qt.documents.projects import OpenedProject, is_project, open_project
from brdf_qt.documents.recent_files import recent_projects
from brdf_qt.window.dialogs import Overwrite
from brdf_qt.window.main_window import SuiteWindow

from brdf_suite.documents.paint import solid_paint
from brdf_suite.documents.project import NamedView, Project, load_project, project_parts, save_project
from brdf_suite.documents.studio import Sky
from brdf_suite.documents.view import View

RED, BLUE = solid_paint("Red", (40.0, 60.0, 40.0)), solid_paint("Blue", (30.0, 10.0, -50.0))


class Part:
    """A program that has one paint open."""

    def __init__(self) -> None:
        self.shown: OpenedProject | None = None
        self.saved: OpenedProject | None = None
        self.paints = (BLUE,)

    def show_project(self, opened: OpenedProject) -> None:
        self.shown = opened

    def gather_project(self, project: Project) -> Project:
        return replace(project, paints=self.paints)

    def project_saved(self, opened: OpenedProject) -> None:
        self.saved = opened


class Dialogs:
    def __init__(self) -> None:
        self.path: Path | None = None
        self.overwrite = Overwrite.CANCEL
        self.asked: list[Path] = []

    def save_path(self, suggested: Path, filters: str) -> Path | None:
        self.asked.append(suggested)
        return self.path

    def open_path(self, folder: Path, filters: str) -> Path | None:
        return self.path

    def changed_file(self, path: Path) -> Overwrite:
        return self.overwrite


@pytest.fixture
def part() -> Part:
    return Part()


@pytest.fixture
def dialogs() -> Dialogs:
    return Dialogs()


@pytest.fixture
def files(qtbot, part, dialogs) -> ProjectFiles:
    window = SuiteWindow("Tests")
    qtbot.addWidget(window)
    files = ProjectFiles(window, part, dialogs)
    window.show()
    yield files
    files.close()


@pytest.fixture
def map_file(tmp_path) -> Path:
    path = tmp_path / "elsewhere" / "street.exr"
    path.parent.mkdir()
    path.write_bytes(b"light" * 1000)
    return path


@pytest.fixture
def project(map_file) -> Project:
    view = NamedView("Day", View(environment=str(map_file)))
    return Project("Spring", (RED,), RED, (view,), (Sky("Clear", "hosek_wilkie", 2.5, 40.0),), notes="Kept")


def write(files: ProjectFiles, qtbot, key: str) -> None:
    with qtbot.waitSignal(files.saved):
        files.parent().command(key).trigger()


def open_and_wait(files: ProjectFiles, qtbot, path: Path) -> None:
    files.open(path)
    qtbot.waitUntil(lambda: files.is_idle)


def said(files: ProjectFiles) -> str:
    message = files.parent().messages.shown()["project"]
    return " ".join((message.what, message.where, message.todo))


def test_saving_replaces_what_is_open_and_keeps_the_rest(files, part, dialogs, project, tmp_path, qtbot):
    path = tmp_path / "spring.brdfproject"
    save_project(project, path)
    open_and_wait(files, qtbot, path)
    assert part.shown.project == project
    dialogs.path = path
    write(files, qtbot, "save_project")
    assert load_project(path) == replace(project, paints=(BLUE,))
    assert part.saved.project.paints == (BLUE,)
    assert recent_projects().paths() == [str(path)]
    assert not files.parent().progress.jobs


@pytest.mark.parametrize("folder", [False, True])
def test_collected_files_stay_in_the_project_when_it_is_saved_again(
    files, dialogs, project, map_file, tmp_path, qtbot, folder
):
    path = tmp_path / "spring.brdfproject"
    save_project(project, path, folder=folder)
    assert is_project(path)
    open_and_wait(files, qtbot, path)
    dialogs.path = path
    write(files, qtbot, "collect_files")
    assert [name for name, _size in project_parts(path)] == ["street.exr"]
    map_file.unlink()
    write(files, qtbot, "save_project")
    assert [name for name, _size in project_parts(path)] == ["street.exr"]
    light = Path(open_project(path).project.views[0].view.environment)
    assert light.read_bytes() == b"light" * 1000
    assert bool(dialogs.asked) is not folder


def test_a_new_project_is_called_like_its_file(files, dialogs, tmp_path, qtbot):
    dialogs.path = tmp_path / "autumn"
    write(files, qtbot, "save_project")
    found = load_project(tmp_path / "autumn.brdfproject")
    assert (found.name, found.paints) == ("autumn", (BLUE,))


@pytest.mark.parametrize("name", ["x" * 230, "autumn\nwinter"])
def test_a_new_project_whose_file_has_no_name_for_it_keeps_its_own(files, dialogs, tmp_path, qtbot, name):
    dialogs.path = tmp_path / name
    write(files, qtbot, "save_project")
    assert load_project(tmp_path / f"{name}.brdfproject").name == "Untitled"


def test_a_missing_file_is_named_and_the_old_project_stays(
    files, dialogs, project, map_file, tmp_path, qtbot
):
    path = tmp_path / "spring.brdfproject"
    save_project(project, path)
    before = path.read_bytes()
    open_and_wait(files, qtbot, path)
    map_file.unlink()
    dialogs.path = path
    files.collect()
    qtbot.waitUntil(lambda: "project" in files.parent().messages.shown())
    assert "street.exr" in said(files)
    assert path.read_bytes() == before


def test_a_full_disk_leaves_the_old_project_and_is_reported(
    files, dialogs, project, tmp_path, qtbot, monkeypatch
):
    path = tmp_path / "spring.brdfproject"
    save_project(project, path)
    before = path.read_bytes()
    open_and_wait(files, qtbot, path)
    dialogs.path = path

    def full(_source: object, _target: object) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr("os.replace", full)
    files.save()
    qtbot.waitUntil(lambda: "project" in files.parent().messages.shown())
    assert "No space left" in said(files)
    assert path.read_bytes() == before
    assert [one.name for one in tmp_path.glob(".spring*")] == []


def test_what_another_program_has_written_meanwhile_is_asked_about(files, dialogs, project, tmp_path, qtbot):
    path = tmp_path / "spring.brdfproject"
    save_project(project, path)
    open_and_wait(files, qtbot, path)
    save_project(replace(project, notes="Theirs"), path)
    dialogs.path = path
    files.save()
    assert load_project(path).notes == "Theirs"
    dialogs.overwrite = Overwrite.OVERWRITE
    write(files, qtbot, "save_project")
    assert load_project(path).notes == "Kept"


def test_a_folder_that_another_program_has_changed_is_saved_elsewhere(
    files, dialogs, project, tmp_path, qtbot
):
    folder = tmp_path / "spring"
    save_project(project, folder)
    open_and_wait(files, qtbot, folder)
    save_project(replace(project, notes="Theirs"), folder)
    dialogs.path, dialogs.overwrite = tmp_path / "mine.brdfproject", Overwrite.SAVE_AS
    write(files, qtbot, "save_project")
    assert (load_project(folder).notes, load_project(dialogs.path).notes) == ("Theirs", "Kept")


def test_a_damaged_project_is_named_with_its_place(files, part, tmp_path, qtbot):
    path = tmp_path / "broken.brdfproject"
    path.mkdir()
    (path / "project.json").write_text('{"format": "brdfproject", "version": 1, "name": "x", "paints": 3}')
    open_and_wait(files, qtbot, path)
    assert "paints" in said(files)
    assert "project.json" in said(files)
    assert part.shown is None
