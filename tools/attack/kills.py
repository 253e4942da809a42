"""Writers killed at any moment: no document damaged or lost, and nothing left over after the next start.

Each writer writes one version after another to the same place, in a forked child that is killed in three ways: at a
random moment (SIGKILL by the clock), at each step that opens, renames or removes a file (:func:`sys.addaudithook`), and
within a file, after so many bytes (the kernel's limit of a file's size, whose signal kills). The last two leave nothing
to luck. After each kill what is there must be a whole version, not older than the last that was reported as written.
Then the program starts again: it writes once more, and no file may be there that was not there before. Caches, which
several programs use at once, have another writer beside the one that is killed.

The same limit of a file's size, with its signal ignored, stands for a full disk: the writer must report a
:class:`SuiteError`, and the old version must still be there.
"""

from __future__ import annotations

import contextlib
import importlib
import itertools
import json
import os
import random
import re
import resource
import shutil
import signal
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import numpy as np

from brdf_suite import variables
from brdf_suite.acquisition.reconstruction.work_file import POSITION, open_work
from brdf_suite.acquisition.session.store import read_session, write_session
from brdf_suite.acquisition.session.template import write_template
from brdf_suite.documents.factor_textures import read_textures, write_textures
from brdf_suite.documents.factored import FactoredPaint
from brdf_suite.documents.flat_colour import FlatColour
from brdf_suite.documents.palette import Entry, Palette
from brdf_suite.documents.project import Project, load_project, save_project
from brdf_suite.documents.store import load_any_paint, save_paint
from brdf_suite.errors import FileError, SuiteError
from brdf_suite.files.exports.format import ExportItem
from brdf_suite.files.images.pictures import read_rgb
from brdf_suite.files.images.png import write_png
from brdf_suite.files.measured import read_measured, write_measured
from brdf_suite.files.palettes import FORMATS as PALETTES
from brdf_suite.files.palettes import read_palette, write_palette
from brdf_suite.lighting import lobe_map_cache
from brdf_suite.lighting.environment import Environment
from brdf_suite.palettes.swatches.store import SwatchStore
from brdf_suite.pipeline.material import load_shipped_paint
from brdf_suite.reflectance.models.lambertian import Lambertian
from brdf_suite.reflectance.tabulated.half_angle_grid import HalfAngleGrid
from brdf_suite.reflectance.tabulated.isotropic import IsotropicTable
from brdf_suite.reports.handover import formats, read_paints
from tools.attack.readers.documents import maps_of
from tools.attack.readers.programs import _form, application

_STEPS = frozenset(
    (
        "open",
        "os.rename",
        "os.remove",
        "os.chmod",
        "os.mkdir",
        "os.rmdir",
        "os.link",
        "os.truncate",
        "sqlite3.connect",
    )
)
VERSIONS = 200
_MOST_STEPS = 60
_BYTES = (0, 1, 100, 4096, 20_000, 100_000)
_FILL = "x" * 60_000
"""Notes that make a document long enough for kills to hit its writing."""


@dataclass(frozen=True)
class Writer:
    """What writes one kind of file.

    ``write(folder, number)`` writes version ``number``, below :data:`VERSIONS`; ``read(folder)`` returns the version
    that is there and raises where it is damaged. ``optional``: a cache, which may lose anything and serves no wrong
    value;
    ``read`` then returns -1, and ``write`` may report with a ValueError that it cannot keep anything.
    """

    name: str
    write: Callable[[Path, int], object]
    read: Callable[[Path], int]
    optional: bool = False


@dataclass
class Figures:
    """Kills of one writer, or of all."""

    kills: int = 0
    in_a_write: int = 0
    damaged: int = 0
    lost: int = 0
    leftovers: int = 0
    full_disks: int = 0
    full_disk_faults: int = 0
    examples: list[str] = field(default_factory=list)

    def add(self, other: Figures) -> None:
        """Add the figures of another writer."""
        for name, value in vars(other).items():
            setattr(self, name, getattr(self, name) + value)

    def note(self, text: str) -> None:
        """Keep a few of the faults in words."""
        if len(self.examples) < 4:
            self.examples.append(text[:300])


def _paint(number: int) -> Any:
    return replace(load_shipped_paint("blue"), name=f"v{number}", notes=_FILL)


def _version(name: str) -> int:
    return int(name.removeprefix("v"))


def _palette(number: int) -> Palette:
    entries = tuple(Entry(FlatColour(f"v{number}", "RGB", (0.2, 0.4, 0.6))) for _ in range(300))
    return Palette(f"v{number}", entries)


def _read_one(names: Iterable[str]) -> int:
    found = set(names)
    if len(found) != 1:
        raise ValueError(f"versions are mixed: {sorted(found)[:4]}")
    return _version(found.pop())


def _textures(folder: Path, number: int) -> None:
    path = folder / "f.brdfpaint"
    maps = {name: np.full((16, 16, 3), 0.1 + number % 2, np.float32) for name in "pq"}
    save_paint(
        FactoredPaint(f"v{number}", write_textures(maps, path), "p:wo q:h p:wi", (1.0, 1.0, 1.0)), path
    )


def _read_textures(folder: Path) -> int:
    paint = load_any_paint(folder / "f.brdfpaint")
    assert isinstance(paint, FactoredPaint)
    number = _version(paint.name)
    if not np.allclose(read_textures(paint)["p"], 0.1 + number % 2):
        raise ValueError("the maps are of another version")
    return number


def _export_writer(name: str) -> Writer:
    known = next(one for one in formats() if one.name == name)

    def write(folder: Path, number: int) -> None:
        known.write([ExportItem(_paint(number))], folder / f"e{known.ending}", None)

    return Writer(
        f"export:{name}",
        write,
        lambda folder: _read_one(p.name for p in read_paints(folder / f"e{known.ending}").paints),
    )


def _palette_writer(name: str) -> Writer:
    known = next(one for one in PALETTES if one.name == name)
    path = f"p{known.endings[0]}"

    def read(folder: Path) -> int:
        return _read_one(
            entry.content.name.split(" (")[0] for entry in read_palette(folder / path).palette.entries
        )

    return Writer(
        f"palette:{name}", lambda folder, number: write_palette(_palette(number), folder / path, known), read
    )


def _table(folder: Path, number: int) -> None:
    write_measured(
        IsotropicTable.from_reflectance(Lambertian((number % 1000) / 1000.0), HalfAngleGrid(8, 8, 16)),
        folder / "t.brdftable",
    )


def _read_table(folder: Path) -> int:
    up = [[0.0, 0.0, 1.0]]
    value = float(read_measured(folder / "t.brdftable").eval(up, up)[0, 0]) * np.pi
    number = round(1000.0 * value)
    if abs(1000.0 * value - number) > 0.01:
        raise ValueError(f"no version has the value {value}")
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


def _recovery(folder: Path) -> Any:
    application()
    os.environ[variables.SETTINGS] = str(folder / "settings")
    documents = importlib.import_module("brdf_qt.documents.open_document")
    recovery = importlib.import_module("brdf_qt.documents.recovery")
    store = documents.DocumentStore(_form().new())
    return store, recovery.Recovery(
        store, _form(), lambda error: (_ for _ in ()).throw(error), keeps_history=True
    )


def _write_autosave(folder: Path, number: int) -> None:
    """Do what a start and an edit do: earlier work is taken up, and the new version saved by itself."""
    store, recovery = _recovery(folder)
    try:
        for item in recovery.found():
            recovery.take(item)
        store.replace(_paint(number), None, clean=False)
        recovery.close(keep=True)
    except SuiteError:
        recovery.close(keep=False)  # as the program does where nothing can be written: its lock goes with it
        raise


def _read_autosave(folder: Path) -> int:
    _, recovery = _recovery(folder)
    try:
        return _version(recovery.found()[0].value.name)
    finally:
        recovery.close(keep=False)


WRITERS: tuple[Writer, ...] = (
    Writer(
        "document:paint",
        lambda folder, number: save_paint(_paint(number), folder / "p.brdfpaint"),
        lambda folder: _version(load_any_paint(folder / "p.brdfpaint").name),
    ),
    Writer("document:factored", _textures, _read_textures),
    Writer(
        "document:project",
        lambda folder, number: save_project(
            Project(f"v{number}", (_paint(number),)), folder / "p.brdfproject"
        ),
        lambda folder: _version(load_project(folder / "p.brdfproject").name),
    ),
    Writer(
        "document:project_folder",
        lambda folder, number: save_project(
            Project(f"v{number}", (_paint(number),)), folder / "p.brdfproject", folder=True
        ),
        lambda folder: _version(load_project(folder / "p.brdfproject").name),
    ),
    Writer("document:session", _session, lambda folder: _version(read_session(folder / "photographs").notes)),
    Writer("document:work", _work, _read_work),
    Writer("document:autosave", _write_autosave, _read_autosave),
    *(_palette_writer(name) for name in ("brdfpalette", "ase", "sbz")),
    *(_export_writer(name) for name in ("json", "csv", "cxf")),
    Writer("export:table", _table, _read_table),
    Writer("export:picture", _picture, _read_picture),
    Writer("cache:maps", _write_maps, _read_maps, optional=True),
    Writer("cache:swatches", _write_swatches, _read_swatches, optional=True),
)


class Trial:
    """Kills of one writer in a folder of its own."""

    def __init__(self, writer: Writer, folder: Path, seed: int) -> None:
        self._writer, self._folder = writer, folder
        self._rng = random.Random(f"{seed} {writer.name}")
        self._usual: Counter[str] = Counter()
        self._version = 0
        self._beside = False
        self.figures = Figures()

    def run(self, kills: int) -> Figures:
        """Kill at every step and after some bytes, then at random moments until there are ``kills``."""
        seconds = self._undisturbed()
        for step in range(1, _MOST_STEPS):
            if not self._one(lambda step=step: _kill_at_step(step)):  # type: ignore[misc]  # bound early
                break
            if self.figures.kills >= kills // 2:
                break
        for size in _BYTES:
            self._one(lambda size=size: _kill_at_size(size))  # type: ignore[misc]  # bound early
        with self._companion():
            while self.figures.kills < kills:
                self._one(None, self._rng.uniform(0.0, 3.0 * seconds))
        for size in _BYTES:
            self._full_disk(size)
        return self.figures

    @contextlib.contextmanager
    def _companion(self) -> Iterator[None]:
        """Let another process write beside the one that is killed, where several may; it must live to the end."""
        if not self._writer.optional:
            yield
            return
        pid = os.fork()
        if pid == 0:
            try:
                _be_quiet()
                for number in itertools.count(VERSIONS // 2):
                    self._writer.write(self._folder, number % VERSIONS)
            finally:
                os._exit(1)
        self._beside = True
        try:
            yield
        finally:
            self._beside = False
            ended, _ = os.waitpid(pid, os.WNOHANG)
            if ended:
                self.figures.damaged += 1
                self.figures.note(f"{self._writer.name}: the program beside it ended")
            else:
                os.kill(pid, signal.SIGKILL)
                os.waitpid(pid, 0)
                self.figures.kills += 1
                self._judge(self._version, "killed beside the other")

    def _undisturbed(self) -> float:
        """Write some versions without a kill; return the seconds that one takes."""

        def work() -> str:
            begin = time.monotonic()
            for number in range(1, 10):
                self._writer.write(self._folder, number)
                usual = self._listed()
                for name, count in usual.items():
                    self._usual[name] = max(self._usual[name], count)
            return json.dumps([(time.monotonic() - begin) / 9.0, self._usual])

        seconds, usual = json.loads(_in_child(work))
        self._usual = Counter(usual)
        self._version = 9
        return float(seconds)

    def _one(self, prepare: Callable[[], object] | None, after_s: float = 0.0) -> bool:
        """Kill one child, and see what it left; False where it lived on by itself."""
        receive, send = os.pipe()
        base = self._version
        pid = os.fork()
        if pid == 0:
            try:
                os.close(receive)
                _be_quiet()
                if prepare is not None:
                    prepare()
                for number in itertools.count(base + 1):
                    os.write(send, b"<")
                    self._writer.write(self._folder, number % VERSIONS)
                    os.write(send, b">")
                    if prepare is not None:
                        break
            finally:
                os._exit(0)
        os.close(send)
        said = os.read(receive, 1)  # it has begun
        if prepare is None:
            time.sleep(after_s)
            os.kill(pid, signal.SIGKILL)
        _, status = os.waitpid(pid, 0)
        while more := os.read(receive, 1 << 16):
            said += more
        os.close(receive)
        if not os.WIFSIGNALED(status):
            self._version = base + said.count(b">")
            return False
        self.figures.kills += 1
        self.figures.in_a_write += said.endswith(b"<")
        self._judge(
            base + said.count(b">"), f"{'killed' if prepare is None else 'cut off'} after {said!r}"[:80]
        )
        return True

    def _judge(self, reported: int, how: str) -> None:
        """Count what a kill damaged, lost and left over; ``reported`` is the last version that was written."""

        def work() -> str:
            try:
                found = self._writer.read(self._folder)
            except Exception as error:  # noqa: BLE001 - whatever a reader says of a document that a kill damaged
                return json.dumps(["damaged", f"{type(error).__name__}: {error}", []])
            again = reported + 2
            self._writer.write(self._folder, again % VERSIONS)
            # What the program beside it is writing just now is no leftover.
            more = [
                name
                for name, count in self._listed().items()
                if count > self._usual[name] and not self._beside
            ]
            return json.dumps(["read", found, more])

        word, found, more = json.loads(_in_child(work))
        allowed = (-1,) if self._writer.optional else (reported % VERSIONS, (reported + 1) % VERSIONS)
        if word == "damaged":
            self.figures.damaged += 1
            self.figures.note(f"{self._writer.name}: {how}: {found}")
        elif found not in allowed:
            self.figures.lost += 1
            self.figures.note(f"{self._writer.name}: {how}: version {found}, not {allowed}")
        if more:
            self.figures.leftovers += 1
            self.figures.note(f"{self._writer.name}: {how}: left over {more}")
        if word == "damaged" or more:
            shutil.rmtree(self._folder)
            self._folder.mkdir()
            self._undisturbed()
        else:
            self._version = reported + 2

    def _full_disk(self, size: int) -> None:
        """Write to a disk that takes no more than ``size`` bytes of a file."""
        base = self._version

        def work() -> str:
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (size, resource.RLIM_INFINITY))
            said, written = "", False
            try:
                self._writer.write(self._folder, (base + 1) % VERSIONS)
                written = True
            except SuiteError:
                pass
            except Exception as error:  # noqa: BLE001 - finding these is what this program is for
                if not (self._writer.optional and isinstance(error, ValueError)):
                    said = f"{type(error).__name__}: {error}"
            resource.setrlimit(resource.RLIMIT_FSIZE, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
            try:
                found = self._writer.read(self._folder)
            except Exception as error:  # noqa: BLE001 - as above
                return json.dumps([f"{said} then {type(error).__name__}: {error}", written])
            if not self._writer.optional and found != (base + written) % VERSIONS:
                said = f"{said} version {found} instead of {base + written}"
            more = [name for name, count in self._listed().items() if count > self._usual[name]]
            return json.dumps([f"{said} left over {more}" if more else said, written])

        said, written = json.loads(_in_child(work))
        self._version = base + written
        self.figures.full_disks += 1
        if said:
            self.figures.full_disk_faults += 1
            self.figures.note(f"{self._writer.name}: full disk at {size} bytes: {said}")
            shutil.rmtree(self._folder)
            self._folder.mkdir()
            self._undisturbed()

    def _listed(self) -> Counter[str]:
        """Return the files that there are, hashes and numbers made alike."""
        files = (str(path.relative_to(self._folder)) for path in self._folder.rglob("*") if path.is_file())
        return Counter(re.sub(r"[0-9a-f]{8,}|-\w{8}(?=\.)", "#", name) for name in files)


def _kill_at_step(step: int) -> None:
    """Die at the ``step``-th operation on a file's name."""
    count = 0

    def hook(event: str, _arguments: object) -> None:
        nonlocal count
        if event in _STEPS:
            count += 1
            if count == step:
                os.kill(os.getpid(), signal.SIGKILL)

    sys.addaudithook(hook)


def _kill_at_size(size: int) -> None:
    """Die when a file grows over ``size`` bytes."""
    signal.signal(signal.SIGXFSZ, signal.SIG_DFL)
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    resource.setrlimit(resource.RLIMIT_FSIZE, (size, size))


def _be_quiet() -> None:
    for stream in (1, 2):
        os.dup2(os.open(os.devnull, os.O_WRONLY), stream)


def _in_child(work: Callable[[], str]) -> str:
    """Return what ``work`` returns in a forked child: nothing of it stays in this process."""
    receive, send = os.pipe()
    pid = os.fork()
    if pid == 0:
        try:
            os.close(receive)
            answer = work()
        except BaseException as error:  # noqa: BLE001 - the parent raises it
            answer = f"!{type(error).__name__}: {error}"
        with os.fdopen(send, "w") as stream:
            stream.write(answer)
        os._exit(0)
    os.close(send)
    with os.fdopen(receive) as stream:
        answer = stream.read()
    os.waitpid(pid, 0)
    if not answer or answer.startswith("!"):
        raise RuntimeError(f"a child failed: {answer[1:] or 'it died'}")
    return answer


def kill_writers(
    kills: int, seed: int, words: Iterable[str] = (), report: Callable[[str], None] = print
) -> dict[str, Figures]:
    """Return the figures of each writer whose name begins with one of ``words``, with ``kills`` in all."""
    chosen = [one for one in WRITERS if not words or any(one.name.startswith(word) for word in words)]
    found: dict[str, Figures] = {}
    for writer in chosen:
        with tempfile.TemporaryDirectory(prefix="attack-") as folder:
            found[writer.name] = Trial(writer, Path(folder), seed).run(-(-kills // len(chosen)))
        for text in found[writer.name].examples:
            report(text)
    return found
