"""Generation of a ``session.json`` template for the photographs in a folder.

Folders named after dark frames, the white reference, the flat field and the board are taken as such; each other folder
of photographs is a position of the lamp. What the files state (exposure times, bits) is filled in; what only the user
knows, distances above all, is given typical values and named in the notes.
"""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from pathlib import Path

from brdf_suite.acquisition.photographs.reading import (
    ENDINGS,
    PhotographFacts,
    photograph_facts,
    read_photograph,
)
from brdf_suite.acquisition.session.session import (
    SESSION_FILE,
    Board,
    FlatField,
    Light,
    Position,
    ResponseKind,
    Session,
    SessionCamera,
    Sphere,
    WhiteReference,
)
from brdf_suite.acquisition.session.store import write_session
from brdf_suite.documents.atomic import make_folder
from brdf_suite.errors import FileError, PathLike, ValueRangeError
from brdf_suite.regular_files import exists, is_file

EXPOSURES = 16
SHORTEST_S, LONGEST_S = 0.00025, 0.328
"""The series of Günther et al. 2005, where the files state no times."""

_SPECIAL = ("dark", "white", "flat", "board", "mask")
_NUMBER = re.compile(r"\d+(?:\.\d+)?")
_LINEAR = ("raw", "exr", "hdr")
"""Kinds of photographs that are linear by themselves."""
_SENSOR_BITS = (8, 10, 12, 14, 16)
_TO_FILL_IN = (
    "camera.distance_m, camera.height_m: level distance to the turntable's axis, height above the sphere's centre",
    "sphere.radius_m: measure it with a caliper",
    "light.distance_m, light.height_m: of the lamp, as of the camera",
    "camera.response: unknown (recovered from the exposures), linear or srgb",
)


@dataclass(frozen=True)
class Template:
    """A ``session.json`` that was written: its path, how many photographs it names, and what is to be filled in."""

    path: Path
    photographs: int
    notes: tuple[str, ...]


def write_template(folder: PathLike) -> Template:
    """Write ``session.json`` into a folder, which is made where there is none.

    Raises
    ------
    FileError
        The folder has a ``session.json`` already, a photograph in it is damaged, or it cannot be written.
    """
    target = Path(folder)
    if exists(target / SESSION_FILE):
        raise FileError(target / SESSION_FILE, "is there already, and is not overwritten")
    make_folder(target)
    try:
        session, notes = _session(target)
    except ValueRangeError as error:
        raise FileError(target, f"no session can be made of it: {error.place}: {error.reason}") from error
    notes += _TO_FILL_IN
    if session.white is None:
        notes.append(
            "light.irradiance_rgb or a white reference: without them the table has no absolute scale"
        )
    return Template(write_session(session, target), len(session.files()), tuple(notes))


def _session(folder: Path) -> tuple[Session, list[str]]:
    """Return the session that a folder's files show, and notes on what was taken from where."""
    notes: list[str] = []
    groups = _groups(folder)
    # The folder named after a word is no position.
    found = {word: next((name for name in groups if name.lower().startswith(word)), "") for word in _SPECIAL}
    special = {word: groups.pop(name, []) for word, name in found.items()}
    positions = {name: files for name, files in groups.items() if files}
    if not positions:
        return _example(folder)
    count = min(map(len, positions.values()))
    uneven = [name for name, files in positions.items() if len(files) != count]
    if uneven:
        reason = f"holds {len(positions[uneven[0]])} photographs, and other folders {count}; "
        raise FileError(folder / uneven[0], f"{reason}each position has one for each exposure")

    def names(files: list[Path]) -> tuple[str, ...]:
        return tuple(file.relative_to(folder).as_posix() for file in files)

    first = next(iter(positions.values()))
    times = _times(notes, first)
    angles = _angles(notes, list(positions))
    ordered = [_by_time(files) for files in positions.values()]
    placed = sorted(zip(angles, ordered, strict=True), key=lambda pair: pair[0])
    first = _by_time(first)
    facts = photograph_facts(first[0])
    bits = _bits(notes, facts, first[-1])
    board = flat = white = None
    if special["board"]:
        notes.append("camera.board: state the board's inner corners (columns, rows) and the side of a square")
        board = Board(9, 6, 0.02, names(special["board"]))
    for word in ("white", "dark"):
        if special[word] and len(special[word]) != count:
            lost = f"{word}: {len(special[word])} photographs for {count} exposures are left out"
            notes.append(f"{lost}; expected one for each")
            special[word] = []
    if special["white"]:
        asked = "a region that shows nothing but the white"
        notes.append(f"white: state its reflectance, the lamp's angle, and {asked}")
        width, height = max(1, facts.width // 8), max(1, facts.height // 8)
        region = ((facts.width - width) // 2, (facts.height - height) // 2, width, height)
        white = WhiteReference(names(_by_time(special["white"])), region)
    if special["flat"]:
        notes.append("flat_field: state its exposure time")
        exposure_s = photograph_facts(special["flat"][0]).exposure_s
        flat = FlatField(names(special["flat"][:1]), (exposure_s or 0.1,))
    response: ResponseKind = "linear" if facts.kind in _LINEAR else "unknown"
    return Session(
        folder.resolve().name or "session",
        SessionCamera(2.0, 0.0, bits, response, board=board),
        Sphere(0.05),
        Light(0.7),
        times,
        tuple(Position(angle, names(files)) for angle, files in placed),
        white,
        names(_by_time(special["dark"])),
        flat,
    ), notes


def _groups(folder: Path) -> dict[str, list[Path]]:
    """Return the photographs of each folder below, in the order of the numbers in their names."""
    groups: dict[str, list[Path]] = {}
    for file in sorted(folder.glob("*/*"), key=_natural):
        if file.suffix.lower() in ENDINGS and is_file(file) and not file.name.startswith("."):
            groups.setdefault(file.parent.name, []).append(file)
    if not groups and any(f.suffix.lower() in ENDINGS and f.stem != "mask" for f in folder.iterdir()):
        advice = "put those of each position of the lamp into a folder of their own"
        raise FileError(folder, f"has its photographs beside each other; {advice}")
    return groups


def _natural(file: Path) -> list[tuple[int, float, str]]:
    """Return a sort key with 2 before 10."""
    parts = re.split(r"(\d+)", file.as_posix())
    return [(0, float(part), "") if part.isdigit() else (1, 0.0, part.lower()) for part in parts]


def _by_time(files: list[Path]) -> list[Path]:
    """Sort by exposure time, where all files state it; else by name."""
    times = [photograph_facts(file).exposure_s for file in files]
    if any(time is None for time in times):
        return files
    return [file for _, _, file in sorted((time or 0.0, i, files[i]) for i, time in enumerate(times))]


def _times(notes: list[str], files: list[Path]) -> tuple[float, ...]:
    times = sorted({time for file in files if (time := photograph_facts(file).exposure_s) is not None})
    if len(times) == len(files):
        notes.append("exposures_s: taken from the EXIF of the first position")
        return tuple(float(f"{time:.6g}") for time in times)
    notes.append("exposures_s: the files state no times, or the same twice; these are those of a typical rig")
    return series_s(len(files))


def series_s(count: int) -> tuple[float, ...]:
    """Return the times of a typical series, a geometric one, in seconds."""
    if count == 1:
        return (SHORTEST_S,)
    step = math.log(LONGEST_S / SHORTEST_S) / (count - 1)
    return tuple(float(f"{SHORTEST_S * math.exp(step * k):.4g}") for k in range(count))


def _angles(notes: list[str], names: list[str]) -> list[float]:
    """Take the last numbers in the folders' names for degrees where they can be; else even steps."""
    hints = [float(found[-1]) if (found := _NUMBER.findall(name)) else None for name in names]
    known = [hint for hint in hints if hint is not None]
    distinct = len(known) == len(hints) == len(set(known))
    if distinct and len(known) - 1 - 1e-9 < max(known) <= 360.0:
        notes.append("positions: the numbers in the names of the folders are taken for degrees")
        return known
    notes.append("positions: the angles are even steps from 0° to 180°; correct them")
    order = sorted(range(len(hints)), key=lambda i: (hints[i] is None, hints[i] or 0.0, i))
    angles = [0.0] * len(hints)
    for rank, i in enumerate(order):
        angles[i] = 180.0 * rank / max(1, len(hints) - 1)
    return angles


def _bits(notes: list[str], facts: PhotographFacts, longest: Path) -> int:
    """Return the depth in use: 12-bit codes are often stored in 16-bit files."""
    if facts.bits is None or facts.bits == 8 or facts.kind == "raw":
        return 8 if facts.bits == 8 else 16
    highest = int(read_photograph(longest).codes.max())
    bits = next(bits for bits in _SENSOR_BITS if highest < 1 << bits)
    seen = f"camera.bit_depth: the highest code of {longest.name} is {highest:,}"
    notes.append(f"{seen}, so {bits} bits are taken")
    return bits


def _example(folder: Path) -> tuple[Session, list[str]]:
    def series(stem: str) -> tuple[str, ...]:
        return tuple(f"{stem}/{k:02d}.tif" for k in range(EXPOSURES))

    session = Session(
        folder.resolve().name or "session",
        SessionCamera(2.0, 0.0, 12),
        Sphere(0.05),
        Light(0.7),
        series_s(EXPOSURES),
        tuple(Position(float(k), series(f"light_{k:03d}")) for k in range(180)),
        dark=series("dark"),
    )
    return session, ["the folder holds no photographs yet; the names are those that the template proposes"]
