"""Projects as ``.brdfproject``: paints, a standard, views, lights, a measured source and the pictures that are made.

A project is a zip file or a folder of the same content: ``project.json``, which has the documents inline, each with
its own format and version, and under ``files/`` what was collected: environments, meshes, masks and measured data
that the views and the source name by path. Without collecting they stay where they are.
"""

from __future__ import annotations

import dataclasses
import filecmp
import re
import zipfile
import zlib
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path, PurePosixPath, PureWindowsPath
from typing import IO, TypeVar

from brdf_suite.documents.atomic import encode, make_folder, replacing, write_atomically
from brdf_suite.documents.cook_torrance import CookTorrancePaint
from brdf_suite.documents.factored import FactoredPaint
from brdf_suite.documents.paint import Paint
from brdf_suite.documents.parameter import as_whole, check_items, check_text, describe
from brdf_suite.documents.reading import (
    LARGEST_FILE,
    VERSIONS,
    FieldReader,
    fill,
    json_from_bytes,
    open_envelope,
    read_json,
)
from brdf_suite.documents.store import (
    AnyPaint,
    any_paint_from_json,
    paint_to_json,
    view_from_json,
    view_to_json,
)
from brdf_suite.documents.studio import LightDocument, Sky, Studio, light_from_json, light_to_json
from brdf_suite.documents.view import View
from brdf_suite.errors import DocumentError, FileError, PathLike, ValueRangeError
from brdf_suite.progress import Progress, report
from brdf_suite.regular_files import exists, is_file, is_folder, open_regular, within_memory

PROJECT_ENDING = ".brdfproject"
FORMAT = "brdfproject"
MANIFEST = "project.json"
FILES = "files"
MOST_ITEMS = 1000
"""Paints, views, lights and pictures, of each kind."""
LARGEST_UNPACKED = 8 << 30
"""Bytes of all collected files together."""
LARGEST_SIDE = 65_536
_MOST_PARTS = 2 * MOST_ITEMS
_REFERENCE = f"project:{FILES}/"
_PART = re.compile(r"[A-Za-z0-9_\-][A-Za-z0-9._\-]{0,119}\Z")
_PATH_FIELDS = frozenset({"environment", "surface", "normal_map", "tangent_map", "mask", "paint"})
"""Fields of a view, and of the values in it, that may name a file."""
_PACKED_BY = (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)
_PAINTS = (Paint, CookTorrancePaint, FactoredPaint)
_BLOCK = 1 << 20
_DAMAGED = (
    zipfile.BadZipFile,
    zlib.error,
    EOFError,
    NotImplementedError,  # a kind of zip file that is not known
    RuntimeError,  # a password is wanted
    ValueError,
    LookupError,
)
_T = TypeVar("_T")


@dataclass(frozen=True)
class NamedView:
    """A view and what it is called."""

    name: str
    view: View

    def __post_init__(self) -> None:
        check_text(self.name, "name", longest=200, lines=False, empty=False)
        if not isinstance(self.view, View):
            raise ValueRangeError("view", f"expected a view, not {describe(self.view)}")


@dataclass(frozen=True)
class ProjectPicture:
    """Settings of a picture: the name of the view that it is of, its size in pixels, and samples per pixel."""

    name: str
    view: str
    width: int = 1920
    height: int = 1080
    samples: int = 4

    def __post_init__(self) -> None:
        for place in ("name", "view"):
            check_text(getattr(self, place), place, longest=200, lines=False, empty=False)
        for place, most in (("width", LARGEST_SIDE), ("height", LARGEST_SIDE), ("samples", 64)):
            value = as_whole(getattr(self, place))
            object.__setattr__(self, place, value)
            if isinstance(value, bool) or not isinstance(value, int) or not 1 <= value <= most:
                raise ValueRangeError(
                    place, f"expected a whole number from 1 to {most}, not {describe(value)}"
                )


@dataclass(frozen=True)
class Project:
    """Everything that belongs to one design.

    Attributes
    ----------
    paints
        The designs, the main one first.
    standard
        What they are judged against.
    views, lights
        Scenes without their paints, each with a name of its own; studios and skies.
    source
        Absolute path of the measured file that the design started from; empty where there is none.
    pictures
        Each of a view of this project.
    """

    name: str
    paints: tuple[AnyPaint, ...] = ()
    standard: AnyPaint | None = None
    views: tuple[NamedView, ...] = ()
    lights: tuple[LightDocument, ...] = ()
    source: str = ""
    pictures: tuple[ProjectPicture, ...] = ()
    notes: str = field(default="")

    def __post_init__(self) -> None:
        check_text(self.name, "name", longest=200, lines=False, empty=False)
        check_text(self.notes, "notes", longest=100_000, lines=True, empty=True)
        kinds: Mapping[str, type | tuple[type, ...]] = {
            "paints": _PAINTS,
            "views": NamedView,
            "lights": (Studio, Sky),
            "pictures": ProjectPicture,
        }
        for place, kind in kinds.items():
            object.__setattr__(self, place, check_items(getattr(self, place), place, kind, MOST_ITEMS))
        if self.standard is not None and not isinstance(self.standard, _PAINTS):
            raise ValueRangeError("standard", f"expected a paint, not {describe(self.standard)}")
        check_text(self.source, "source", longest=4096, lines=False, empty=True)
        if self.source and not _is_absolute(self.source):
            raise ValueRangeError("source", f"expected an absolute path, not {describe(self.source)}")
        names = [item.name for item in self.views]
        for number, name in enumerate(names):
            if name in names[:number]:
                raise ValueRangeError(
                    f"views[{number}].name", f"{describe(name)} is the name of another view"
                )
        for number, picture in enumerate(self.pictures):
            if picture.view not in names:
                raise ValueRangeError(
                    f"pictures[{number}].view", f"no view of the project is called {picture.view!r}"
                )


def project_references(project: Project) -> tuple[str, ...]:
    """Return the absolute paths of files that views and source name, each once."""
    found: dict[str, None] = {}

    def note(path: str) -> str:
        found[path] = None
        return path

    for item in project.views:
        _with_paths(view_to_json(item.view), note)
    if project.source:
        note(project.source)
    return tuple(found)


def save_project(
    project: Project,
    path: PathLike,
    *,
    collect: bool = False,
    folder: bool = False,
    unpacked: PathLike | None = None,
    progress: Progress | None = None,
) -> tuple[str, ...]:
    """Write a project as a zip file, or with ``folder`` as a folder; ``collect`` copies the files that it names.

    Returns the names of collected files. Files that lie in the folder of a project already stay its own, also those
    below ``unpacked``, a folder into which :func:`load_project` has unpacked projects. A zip file is written whole or
    not at all. In a folder each file is, ``project.json`` comes last, and no file that the old one names is written
    over by another.

    Raises
    ------
    FileError
        A file that is named is missing or cannot be read, or the project cannot be written.
    Cancelled
        The progress callback asked for it; the old project is as it was.
    """
    references = project_references(project)
    target = Path(path).absolute()
    homes = [] if unpacked is None else [Path(unpacked).absolute()]
    if folder:
        homes.append(target / FILES)
    wanted = [file for file in references if collect or any(home in Path(file).parents for home in homes)]
    parts = _part_names(wanted, target / FILES if folder else None)
    content = encode(project_to_json(project, {path: _REFERENCE + name for path, name in parts.items()}))
    copying = _Copying(parts, progress)
    if folder:
        _write_folder(Path(path), content, parts, copying)
    else:
        _write_zip(path, content, parts, copying)
    report(progress, 1.0, "written")
    return tuple(parts.values())


@within_memory
def load_project(path: PathLike, unpack_into: PathLike | None = None) -> Project:
    """Read a project; collected files of a zip file are unpacked into the folder ``unpack_into``, which is made.

    Without such a folder they stay packed, and the project names them as parts of the zip file: it can be looked at and
    not drawn.

    Raises
    ------
    DocumentError
        A field is missing, unknown, of the wrong type or out of range; ``place`` names it.
    FileError
        It is no project, is damaged, or cannot be unpacked.
    """
    source = Path(path)
    if is_folder(source):
        if not is_file(source / MANIFEST):
            raise FileError(path, f"is a folder without {MANIFEST}")
        names = {file.name for file in _collected(source)}
        return project_from_json(read_json(source / MANIFEST), source / MANIFEST, source, names)
    with _opened(path) as archive:
        names = _checked_parts(archive, path)
        value = json_from_bytes(_read_part(archive, MANIFEST, path), path)
        folder = source if unpack_into is None else Path(unpack_into)
        project = project_from_json(value, path, folder, names)
        if unpack_into is not None:
            _unpack(archive, names, folder, path)
    return project


def project_parts(path: PathLike) -> tuple[tuple[str, int], ...]:
    """Return name and size in bytes of each collected file, unread; errors as :func:`load_project`."""
    source = Path(path)
    if is_folder(source):
        try:
            return tuple((file.name, file.stat().st_size) for file in _collected(source))
        except OSError as error:
            raise FileError(path, f"cannot be read: {error.strerror or error}") from error
    with _opened(path) as archive:
        names = _checked_parts(archive, path)
        return tuple((name, archive.getinfo(f"{FILES}/{name}").file_size) for name in sorted(names))


def _collected(folder: Path) -> list[Path]:
    """Return the collected files of a project that is a folder, by their names."""
    files = folder / FILES
    try:
        return sorted(files.iterdir()) if is_folder(files) else []
    except OSError as error:
        raise FileError(files, f"cannot be read: {error.strerror or error}") from error


def project_to_json(project: Project, replaced: Mapping[str, str] | None = None) -> dict[str, object]:
    """Return the JSON object of a project, with ``replaced`` for paths; :func:`project_from_json` is its inverse."""
    kept = replaced or {}

    def change(path: str) -> str:
        return kept.get(path, path)

    views = [
        {"name": item.name, "view": _with_paths(view_to_json(item.view), change)} for item in project.views
    ]
    return {
        "format": FORMAT,
        "version": VERSIONS[FORMAT],
        "name": project.name,
        "notes": project.notes,
        "paints": [paint_to_json(paint) for paint in project.paints],
        "standard": None if project.standard is None else paint_to_json(project.standard),
        "views": views,
        "lights": [light_to_json(light) for light in project.lights],
        "source": change(project.source),
        "pictures": [dataclasses.asdict(picture) for picture in project.pictures],
    }


def project_from_json(value: object, path: PathLike, folder: Path, parts: set[str]) -> Project:
    """Return the project in a JSON value; references to ``parts`` become paths of ``folder``.

    Raises :class:`DocumentError`: a field is missing, unknown, of the wrong type or out of range.
    """
    reader = open_envelope(value, FORMAT, path)

    def resolve(text: str) -> str:
        if not text.startswith("project:"):
            return text
        name = text.removeprefix(_REFERENCE)
        if name not in parts:
            raise DocumentError(path, f"{describe(text)} is no collected file of the project")
        return str(folder.absolute() / FILES / name)

    def read_view(item: object, _path: PathLike) -> View:
        return view_from_json(_with_paths(item, resolve), path)

    def item_list(name: str, read: Callable[[object, PathLike], _T]) -> tuple[_T, ...]:
        items = reader.take(name)
        if not isinstance(items, list):
            reader.fail(f"expected a list, not {describe(items)}", name)
        if len(items) > MOST_ITEMS:
            reader.fail(f"{len(items)} are more than the {MOST_ITEMS} allowed", name)
        return tuple(_read_at(f"{name}[{i}]", read, item, path) for i, item in enumerate(items))

    def read_named(item: object, _path: PathLike) -> NamedView:
        inner = FieldReader(item, path)
        name, view = inner.take("name"), _read_at("view", read_view, inner.take("view"), path)
        inner.finish()
        with inner.naming():
            return NamedView(name, view)  # type: ignore[arg-type]  # it checks it

    def read_picture(item: object, _path: PathLike) -> ProjectPicture:
        return fill(FieldReader(item, path), ProjectPicture, required=("name", "view"))

    standard, source = reader.take_or("standard", None), reader.take_or("source", "")
    taken: dict[str, object] = {
        "paints": item_list("paints", any_paint_from_json),
        "standard": None if standard is None else _read_at("standard", any_paint_from_json, standard, path),
        "views": item_list("views", read_named),
        "lights": item_list("lights", light_from_json),
        "pictures": item_list("pictures", read_picture),
        "source": _read_at(
            "source", lambda text, _: resolve(text) if isinstance(text, str) else text, source, path
        ),
    }
    return fill(reader, Project, required=("name",), taken=taken)


def _read_at(place: str, read: Callable[[object, PathLike], _T], item: object, path: PathLike) -> _T:
    """Read a value and name where in the project it is where that fails."""
    try:
        return read(item, path)
    except DocumentError as error:
        inner = "" if error.place in (None, "", "the top level") else f".{error.place}"
        raise DocumentError(path, error.reason, f"{place}{inner}") from error


def _with_paths(value: object, change: Callable[[str], str], name: str = "") -> dict[str, object]:
    """Return the JSON value of a view with its paths changed; what is of another kind is left to its reader."""

    def walk(item: object, key: str) -> object:
        if isinstance(item, dict):
            return {inner: walk(part, inner) for inner, part in item.items()}
        if isinstance(item, list):
            return [walk(part, key) for part in item]
        if (
            isinstance(item, str)
            and key in _PATH_FIELDS
            and (_is_absolute(item) or item.startswith("project:"))
        ):
            return change(item)
        return item

    return walk(value, name)  # type: ignore[return-value]  # an object stays one


def _is_absolute(text: str) -> bool:
    return PurePosixPath(text).is_absolute() or PureWindowsPath(text).is_absolute()


def _part_names(paths: Sequence[str], home: Path | None) -> dict[str, str]:
    """Return the name in the project of each file, none twice.

    In a folder ``home`` of collected files what is there keeps its name, and no other file gets that.
    """
    names: dict[str, str] = {}
    for path in paths:
        if not is_file(path):
            raise FileError(path, "is named in the project and is not there; it cannot be collected")
        if home is not None and Path(path).parent == home:
            names[path] = Path(path).name
    for path in paths:
        if path in names:
            continue
        clean = re.sub(r"[^A-Za-z0-9._\-]", "_", Path(path).name).lstrip(".")[-100:] or "file"
        name, number = clean, 1
        # Where upper and lower case are one, two files would become one.
        while name.casefold() in {other.casefold() for other in names.values()} or _holds_other(
            home, name, path
        ):
            number += 1
            name = f"{Path(clean).stem}-{number}{Path(clean).suffix}"
        names[path] = name
    return names


def _holds_other(home: Path | None, name: str, path: str) -> bool:
    """Whether a folder of collected files has something else under a name."""
    if home is None or not exists(home / name):
        return False
    try:
        return not filecmp.cmp(home / name, path, shallow=False)
    except OSError as error:
        raise FileError(path, f"cannot be collected: {error.strerror or error}") from error


class _Copying:
    """Copies files and reports how many of all bytes are done."""

    def __init__(self, parts: Mapping[str, str], progress: Progress | None) -> None:
        try:
            self._all = sum(Path(file).stat().st_size for file in parts) or 1
        except OSError as error:
            reason = f"a file that it names cannot be collected: {error.strerror or error}"
            raise FileError(error.filename, reason) from error
        self._done, self._progress = 0, progress

    def copy(self, file: str, target: IO[bytes]) -> None:
        name = Path(file).name
        report(self._progress, self._done / self._all, name)
        for block in _blocks(file):
            target.write(block)
            self._done += len(block)
            report(self._progress, self._done / self._all, name)


def _blocks(file: str) -> Iterator[bytes]:
    """Yield the content of a file that is collected; what cannot be read is an error that names it."""
    try:
        with open_regular(file) as source:
            while block := source.read(_BLOCK):
                yield block
    except FileError as error:
        raise FileError(file, f"cannot be collected: it {error.reason}") from error


def _write_zip(path: PathLike, content: bytes, parts: Mapping[str, str], copying: _Copying) -> None:
    with replacing(path) as temporary, zipfile.ZipFile(temporary, "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr(zipfile.ZipInfo(MANIFEST, (1980, 1, 1, 0, 0, 0)), content, zipfile.ZIP_DEFLATED)
        for file, name in parts.items():
            info = zipfile.ZipInfo(f"{FILES}/{name}", (1980, 1, 1, 0, 0, 0))
            info.compress_type = zipfile.ZIP_DEFLATED
            with archive.open(info, "w", force_zip64=True) as target:
                copying.copy(file, target)


def _write_folder(folder: Path, content: bytes, parts: Mapping[str, str], copying: _Copying) -> None:
    try:
        make_folder(folder)
        others = {entry.name for entry in folder.iterdir()} - {FILES}  # which may have been unpacked just now
        if others and not is_file(folder / MANIFEST):
            raise FileError(folder, "is not empty and holds no project; name another folder")
        for file, name in parts.items():
            target = folder / FILES / name
            make_folder(target.parent)
            if exists(target):
                continue  # the same content, as its name says
            with replacing(target) as temporary, temporary.open("wb") as out:
                copying.copy(file, out)
    except OSError as error:
        raise FileError(folder, f"cannot be written: {error.strerror or error}") from error
    write_atomically(folder / MANIFEST, content)


@contextmanager
def _opened(path: PathLike) -> Iterator[zipfile.ZipFile]:
    """Open a zip file; what is wrong with it, also later, is a :class:`FileError`."""
    try:
        with open_regular(path) as stream, zipfile.ZipFile(stream) as archive:
            yield archive
    except FileError:
        raise
    except OSError as error:
        raise FileError(path, f"cannot be read: {error.strerror or error}") from error
    except (
        zipfile.BadZipFile,
        zlib.error,
        EOFError,
        NotImplementedError,
        RuntimeError,
        ValueError,
        LookupError,
    ) as error:
        raise FileError(path, f"is a damaged project ({str(error)[:120].rstrip('.')})") from error


def _checked_parts(archive: zipfile.ZipFile, path: PathLike) -> set[str]:
    """Return the names of collected files; refuse everything that a project does not have."""
    infos = archive.infolist()
    if len(infos) > _MOST_PARTS:
        raise FileError(path, f"has {len(infos):,} parts, more than the {_MOST_PARTS:,} allowed")
    names: set[str] = set()
    seen: set[str] = set()
    for info in infos:
        place = f"part {info.filename[:80]!r}"
        if info.filename.casefold() in seen:
            raise FileError(path, "the part is there twice", place)
        seen.add(info.filename.casefold())
        if info.flag_bits & 1 or info.compress_type not in _PACKED_BY:
            raise FileError(path, "is encrypted or packed by a method that projects do not have", place)
        name = info.filename.removeprefix(f"{FILES}/")
        if info.filename == MANIFEST:
            continue
        if not info.filename.startswith(f"{FILES}/") or not _PART.match(name):
            raise FileError(path, f"expected {MANIFEST} and plain files in {FILES}/", place)
        names.add(name)
    if MANIFEST not in archive.namelist():
        raise FileError(path, f"is a zip file without {MANIFEST}")
    return names


def _read_part(archive: zipfile.ZipFile, name: str, path: PathLike) -> bytes:
    with archive.open(name) as stream:
        content = stream.read(LARGEST_FILE + 1)
    if len(content) > LARGEST_FILE:
        raise FileError(path, f"{MANIFEST} is larger than {LARGEST_FILE >> 20} MB")
    return content


def _unpack(archive: zipfile.ZipFile, names: set[str], folder: Path, path: PathLike) -> None:
    """Write collected files into ``files/`` of a folder; the stated sizes may be wrong, so bytes are counted."""
    left = LARGEST_UNPACKED
    target = folder / FILES
    make_folder(target)
    for name in sorted(names):
        with (
            archive.open(f"{FILES}/{name}") as stream,
            replacing(target / name) as temporary,
            temporary.open("wb") as out,
        ):
            while block := stream.read(_BLOCK):
                left -= len(block)
                if left < 0:
                    raise FileError(
                        path, f"unpacks to more than {LARGEST_UNPACKED >> 30} GB", f"part {name!r}"
                    )
                out.write(block)
