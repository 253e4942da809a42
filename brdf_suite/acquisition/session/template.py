"""Generation of a ``session.json`` template for the photographs in a folder.

Folders named after dark frames, the white reference, the flat field and the board are taken as such; each other folder
of photographs is a position of the lamp. What the files state (exposure times, bits) is filled in; what only the user
knows, distances above all, is given typical values and named in the notes.
"""

from __future__ import annotations

import math
import os
import re
from dataclasses import dataclass, field
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
    Session,
    SessionCamera,
    Sphere,
    WhiteReference,
)
from brdf_suite.acquisition.session.store import write_session
from brdf_suite.errors import FileError, ValueRangeError

EXPOSURES = 16
SHORTEST_S, LONGEST_S = 0.00025, 0.328
"""The series of Günther et al. 2005, where the files state no times."""

_SPECIAL = ("dark", "white", "flat", "board", "mask")
_NUMBER = re.compile(r"\d+(?:\.\d+)?")
_LINEAR = ("raw", "exr", "hdr")
"""Kinds of photographs that are linear by themselves."""
_SENSOR_BITS = (8, 10, 12, 14, 16)


@dataclass(frozen=True)
class Template:
    """A ``session.json`` that was written: its path, how many photographs it names, and what is to be filled in."""

    path: Path
    photographs: int
    notes: tuple[str, ...]


@dataclass
class _Draft:
    folder: Path
    notes: list[str] = field(default_factory=list)

    def names(self, files: list[Path]) -> tuple[str, ...]:
        return tuple(file.relative_to(self.folder).as_posix() for file in files)


def write_template(folder: str | os.PathLike[str]) -> Template:
    """Write ``session.json`` into a folder, which is made where there is none.

    Raises
    ------
    FileError
        The folder has a ``session.json`` already, a photograph in it is damaged, or it cannot be written.
    """
    target = Path(folder)
    if (target / SESSION_FILE).exists():
        raise FileError(target / SESSION_FILE, "is there already, and is not overwritten")
    try:
        target.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise FileError(target, f"cannot be made ({error.strerror})") from error
    draft = _Draft(target)
    try:
        session = _session(draft)
    except ValueRangeError as error:
        raise FileError(target, f"no session can be made of it: {error.place}: {error.reason}") from error
    draft.notes += _to_fill_in(session)
    path = write_session(session, target)
    return Template(path, len(session.files()), tuple(draft.notes))


def _session(draft: _Draft) -> Session:
    groups = _groups(draft.folder)
    special = {word: files for word in _SPECIAL if (files := _taken(groups, word))}
    positions = [(name, files) for name, files in groups.items() if files]
    if not positions:
        return _example(draft)
    count = min(len(files) for _, files in positions)
    uneven = [name for name, files in positions if len(files) != count]
    if uneven:
        raise FileError(
            draft.folder / uneven[0],
            f"holds {len(dict(positions)[uneven[0]])} photographs, and other folders {count}; "
            "each position has one for each exposure",
        )
    times = _times(draft, positions[0][1])
    ordered = [(_angle_hint(name), _by_time(files)) for name, files in positions]
    angles = _angles(draft, [hint for hint, _ in ordered])
    placed = sorted(zip(angles, (files for _, files in ordered), strict=True), key=lambda pair: pair[0])
    first = _by_time(positions[0][1])
    facts = photograph_facts(first[0])
    return Session(
        draft.folder.resolve().name or "session",
        SessionCamera(
            2.0,
            0.0,
            _bits(draft, facts, first[-1]),
            "linear" if facts.kind in _LINEAR else "unknown",
            board=_board(draft, special.get("board", [])),
        ),
        Sphere(0.05),
        Light(0.7),
        times,
        tuple(Position(angle, draft.names(files)) for angle, files in placed),
        _white(draft, special.get("white", []), facts, count),
        _dark(draft, special.get("dark", []), count),
        _flat(draft, special.get("flat", [])),
    )


def _groups(folder: Path) -> dict[str, list[Path]]:
    """Return the photographs of each folder below, in the order of the numbers in their names."""
    groups: dict[str, list[Path]] = {}
    for file in sorted(folder.glob("*/*"), key=_natural):
        if file.suffix.lower() in ENDINGS and file.is_file() and not file.name.startswith("."):
            groups.setdefault(file.parent.name, []).append(file)
    if not groups and any(f.suffix.lower() in ENDINGS and f.stem != "mask" for f in folder.iterdir()):
        raise FileError(
            folder,
            "has its photographs beside each other; put those of each position of the lamp into a folder of their own",
        )
    return groups


def _natural(file: Path) -> list[tuple[int, float, str]]:
    """Return a sort key with 2 before 10."""
    parts = re.split(r"(\d+)", file.as_posix())
    return [(0, float(part), "") if part.isdigit() else (1, 0.0, part.lower()) for part in parts]


def _taken(groups: dict[str, list[Path]], word: str) -> list[Path]:
    """Take the folder named after a word out of the groups."""
    for name in list(groups):
        if name.lower().startswith(word):
            return groups.pop(name)
    return []


def _by_time(files: list[Path]) -> list[Path]:
    """Sort by exposure time, where all files state it; else by name."""
    times = [photograph_facts(file).exposure_s for file in files]
    if any(time is None for time in times):
        return files
    return [file for _, _, file in sorted((time or 0.0, i, files[i]) for i, time in enumerate(times))]


def _times(draft: _Draft, files: list[Path]) -> tuple[float, ...]:
    times = sorted({time for file in files if (time := photograph_facts(file).exposure_s) is not None})
    if len(times) == len(files):
        draft.notes.append("exposures_s: taken from the EXIF of the first position")
        return tuple(float(f"{time:.6g}") for time in times)
    draft.notes.append(
        "exposures_s: the files state no times, or the same twice; these are those of a typical rig"
    )
    return series_s(len(files))


def series_s(count: int) -> tuple[float, ...]:
    """Return the times of a typical series, a geometric one, in seconds."""
    if count == 1:
        return (SHORTEST_S,)
    step = math.log(LONGEST_S / SHORTEST_S) / (count - 1)
    return tuple(float(f"{SHORTEST_S * math.exp(step * k):.4g}") for k in range(count))


def _angle_hint(name: str) -> float | None:
    numbers = _NUMBER.findall(name)
    return float(numbers[-1]) if numbers else None


def _angles(draft: _Draft, hints: list[float | None]) -> list[float]:
    """Take the numbers in the folders' names for degrees where they can be; else even steps."""
    known = [hint for hint in hints if hint is not None]
    if (
        len(known) == len(hints) == len(set(known))
        and max(known) <= 360.0
        and max(known) > len(known) - 1 - 1e-9
    ):
        draft.notes.append("positions: the numbers in the names of the folders are taken for degrees")
        return known
    draft.notes.append("positions: the angles are even steps from 0° to 180°; correct them")
    order = sorted(range(len(hints)), key=lambda i: (hints[i] is None, hints[i] or 0.0, i))
    angles = [0.0] * len(hints)
    for rank, i in enumerate(order):
        angles[i] = 180.0 * rank / max(1, len(hints) - 1)
    return angles


def _bits(draft: _Draft, facts: PhotographFacts, longest: Path) -> int:
    """Return the depth in use: 12-bit codes are often stored in 16-bit files."""
    if facts.bits is None or facts.bits == 8 or facts.kind == "raw":
        return 8 if facts.bits == 8 else 16
    highest = int(read_photograph(longest).codes.max())
    bits = next(bits for bits in _SENSOR_BITS if highest < 1 << bits)
    draft.notes.append(
        f"camera.bit_depth: the highest code of {longest.name} is {highest:,}, so {bits} bits are taken"
    )
    return bits


def _board(draft: _Draft, files: list[Path]) -> Board | None:
    if not files:
        return None
    draft.notes.append(
        "camera.board: state the board's inner corners (columns, rows) and the side of a square"
    )
    return Board(9, 6, 0.02, draft.names(files))


def _dark(draft: _Draft, files: list[Path], count: int) -> tuple[str, ...]:
    if files and len(files) != count:
        draft.notes.append(
            f"dark: {len(files)} photographs for {count} exposures are left out; expected one for each"
        )
        return ()
    return draft.names(_by_time(files))


def _flat(draft: _Draft, files: list[Path]) -> FlatField | None:
    if not files:
        return None
    draft.notes.append("flat_field: state its exposure time")
    exposure_s = photograph_facts(files[0]).exposure_s
    return FlatField(draft.names(files[:1]), (exposure_s or 0.1,))


def _white(draft: _Draft, files: list[Path], facts: PhotographFacts, count: int) -> WhiteReference | None:
    if not files:
        return None
    if len(files) != count:
        draft.notes.append(
            f"white: {len(files)} photographs for {count} exposures are left out; expected one for each"
        )
        return None
    draft.notes.append(
        "white: state its reflectance, the lamp's angle, and a region that shows nothing but the white"
    )
    width, height = max(1, facts.width // 8), max(1, facts.height // 8)
    region = ((facts.width - width) // 2, (facts.height - height) // 2, width, height)
    return WhiteReference(draft.names(_by_time(files)), region)


def _example(draft: _Draft) -> Session:
    draft.notes.append("the folder holds no photographs yet; the names are those that the template proposes")
    exposures = series_s(EXPOSURES)

    def series(stem: str) -> tuple[str, ...]:
        return tuple(f"{stem}/{k:02d}.tif" for k in range(EXPOSURES))

    return Session(
        draft.folder.resolve().name or "session",
        SessionCamera(2.0, 0.0, 12),
        Sphere(0.05),
        Light(0.7),
        exposures,
        tuple(Position(float(k), series(f"light_{k:03d}")) for k in range(180)),
        dark=series("dark"),
    )


def _to_fill_in(session: Session) -> tuple[str, ...]:
    scale = "light.irradiance_rgb or a white reference: without them the table has no absolute scale"
    asked = (
        "camera.distance_m, camera.height_m: level distance to the turntable's axis, height above the sphere's centre",
        "sphere.radius_m: measure it with a caliper",
        "light.distance_m, light.height_m: of the lamp, as of the camera",
        "camera.response: unknown (recovered from the exposures), linear or srgb",
    )
    return asked if session.white is not None else (*asked, scale)
