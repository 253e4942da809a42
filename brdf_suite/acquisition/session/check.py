"""Check of a folder against its session: missing, truncated or inconsistent files.

Every file is opened once: that it is there and whole, its size and depth, and the exposure time in its EXIF data.
Then one photograph of each position is unpacked, to see that the highlight goes the way of the lamp.
"""

from __future__ import annotations

import math
import re
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path

from brdf_suite.acquisition.photographs.reading import PhotographFacts, photograph_facts
from brdf_suite.acquisition.session.finding import SessionFinding, Severity
from brdf_suite.acquisition.session.position_order import check_positions
from brdf_suite.acquisition.session.series import MASK_FILE
from brdf_suite.acquisition.session.session import Session
from brdf_suite.errors import FileError, PathLike
from brdf_suite.progress import Progress, report, subrange

LEAST_EXPOSURES = 4
"""Of a position, from which a response curve can be recovered."""

_SAME_TIME = 0.20
"""Cameras record nominal times: 1/3 s is 0.3 s, and 1/60 s is 1/64 s."""
_OTHER_TIME = 0.01
"""Within this share EXIF's time is another exposure's of the session, so that the files were exchanged."""

_PLACE = re.compile(r"positions\[(\d+)\]\.photographs\[(\d+)\]")


@dataclass
class _Seen:
    """The properties of the files read so far."""

    facts: dict[str, tuple[str, PhotographFacts]] = field(default_factory=dict)
    findings: list[SessionFinding] = field(default_factory=list)


def check_session(
    folder: PathLike, session: Session, progress: Progress | None = None, *, pictures: bool = True
) -> tuple[SessionFinding, ...]:
    """Return what is wrong with the files of a session; nothing is raised but :class:`Cancelled`.

    A position without any usable photograph is reported, and a folder without any position is fatal. ``pictures``:
    whether photographs are unpacked to check the order of the positions.
    """
    seen = _Seen()
    files = session.files()
    if session.mask is None and (Path(folder) / MASK_FILE).is_file():
        files += (("mask", MASK_FILE),)
    by_header = subrange(progress, 0.0, 0.5) if pictures else progress
    for i, (place, name) in enumerate(files):
        if i % 16 == 0:
            report(by_header, i / len(files), f"file {i + 1:,} of {len(files):,}")
        try:
            seen.facts[place] = (name, photograph_facts(Path(folder) / name))
        except FileError as error:
            position, exposure = _indices(place)
            severity = _severity_of_loss(place)
            seen.findings.append(
                SessionFinding(severity, error.path, error.reason, place, position, exposure)
            )
    _sizes(folder, seen)
    _depths(folder, session, seen)
    _floats(folder, seen)
    _calibrations(folder, session, seen)
    _times(folder, session, seen)
    _curve(folder, session, seen)
    if pictures:
        lost = {
            (f.position, f.exposure)
            for f in seen.findings
            if f.position is not None and f.exposure is not None
        }
        seen.findings += check_positions(folder, session, lost, subrange(progress, 0.5, 1.0))
    _what_is_left(folder, session, seen)
    report(progress, 1.0, "checked")
    return tuple(seen.findings)


def _indices(place: str) -> tuple[int | None, int | None]:
    found = _PLACE.fullmatch(place)
    if found is not None:
        return int(found[1]), int(found[2])
    of_mask = re.fullmatch(r"positions\[(\d+)\]\.mask", place)
    return (int(of_mask[1]) if of_mask else None), None


def _severity_of_loss(place: str) -> Severity:
    """Return the extent of a loss at a file: a photograph alone, its position, a minor part, or everything."""
    if place.endswith("].mask"):
        return "position"
    if place == "mask":
        return "fatal"
    return "exposure" if place.startswith("positions[") else "warning"


def _add(seen: _Seen, folder: PathLike, severity: Severity, place: str, reason: str) -> None:
    position, exposure = _indices(place)
    path = str(Path(folder) / seen.facts[place][0])
    seen.findings.append(SessionFinding(severity, path, reason, place, position, exposure))


def _sizes(folder: PathLike, seen: _Seen) -> None:
    """Check that all photographs of the sphere, and those compared pixel by pixel, have one size."""
    compared = {
        place: facts for place, (_, facts) in seen.facts.items() if not place.startswith("camera.board")
    }
    sizes = Counter((facts.width, facts.height) for facts in compared.values())
    if len(sizes) < 2:
        return
    (width, height), _ = sizes.most_common(1)[0]
    for place, facts in compared.items():
        if (facts.width, facts.height) != (width, height):
            reason = f"is {facts.width} × {facts.height} pixels, and the others are {width} × {height}"
            _add(seen, folder, _severity_of_loss(place), place, reason)
            del seen.facts[place]


def _depths(folder: PathLike, session: Session, seen: _Seen) -> None:
    for place, (_, facts) in list(seen.facts.items()):
        if facts.bits is not None and facts.bits < session.camera.bit_depth and not place.endswith("mask"):
            reason = (
                f"has {facts.bits} bits a channel, and session.json says {session.camera.bit_depth}; "
                "correct camera.bit_depth"
            )
            _add(seen, folder, _severity_of_loss(place), place, reason)
            del seen.facts[place]


def _floats(folder: PathLike, seen: _Seen) -> None:
    """Check for mixed units: floats and codes differ, so files unlike most positions are left out."""
    kinds = {
        place: facts.bits is None
        for place, (_, facts) in seen.facts.items()
        if not place.endswith("mask") and not place.startswith("camera.board")
    }
    counts = Counter(kind for place, kind in kinds.items() if place.startswith("positions["))
    if not counts:
        return
    (most, _), *_ = counts.most_common(1)
    for place, floats in kinds.items():
        if floats != most:
            own, others = ("floats", "whole codes") if floats else ("whole codes", "floats")
            reason = f"holds {own}, and the other photographs hold {others}, in another unit"
            _add(seen, folder, _severity_of_loss(place), place, reason)
            del seen.facts[place]
    if most and "dark[0]" in seen.facts:
        _add(seen, folder, "warning", "dark[0]", "is not taken off: of floats black is taken to be 0")


def _calibrations(folder: PathLike, session: Session, seen: _Seen) -> None:
    """Check that the calibration files named in session.json exist, at least in part, and are suitable."""
    fields = {
        "dark": session.dark,
        "white": session.white.photographs if session.white else (),
        "flat_field": session.flat_field.photographs if session.flat_field else (),
        "camera.board": session.camera.board.photographs if session.camera.board else (),
    }
    for name, files in fields.items():
        start = f"{name}[" if name == "dark" else f"{name}.photographs["
        if not files or any(place.startswith(start) for place in seen.facts):
            continue
        own = [finding for finding in seen.findings if finding.place.startswith(start)]
        seen.findings = [finding for finding in seen.findings if finding not in own]
        reason = (
            f"{own[0].reason}; none of the {len(files)} photographs of {name} can be used: "
            f"bring them, or take {name} out of session.json"
        )
        seen.findings.append(SessionFinding("fatal", own[0].path, reason, own[0].place))
    white = next((facts for place, facts in seen.facts.items() if place.startswith("white.")), None)
    if session.white is not None and white is not None:
        left, top, width, height = session.white.region
        file, facts = white
        if left + width > facts.width or top + height > facts.height:
            reason = (
                f"has {facts.width} × {facts.height} pixels, and the region {left}, {top}, {width}, {height} "
                "(left, top, width, height) goes beyond them"
            )
            seen.findings.append(SessionFinding("fatal", str(Path(folder) / file), reason, "white.region"))


def _times(folder: PathLike, session: Session, seen: _Seen) -> None:
    """Compare EXIF with the session: nominal times may differ a little, another exposure's time may not."""
    for place, (_, facts) in list(seen.facts.items()):
        position, exposure = _indices(place)
        if exposure is None and place.startswith("dark["):
            exposure = int(place[5:-1])
        if exposure is None or facts.exposure_s is None:
            continue
        stated, recorded = session.exposures_s[exposure], facts.exposure_s
        if (
            abs(math.log(recorded / stated)) <= math.log1p(_SAME_TIME)
            and _nearest(session, recorded) == exposure
        ):
            continue
        reason = f"was exposed for {recorded:g} s as its EXIF says, and session.json says {stated:g} s"
        other = _nearest(session, recorded)
        if other != exposure and abs(math.log(recorded / session.exposures_s[other])) <= _OTHER_TIME:
            reason += f"; that is the time of exposure {other}, so that files may have been exchanged"
        else:
            reason += "; correct exposures_s"
        _add(seen, folder, "exposure" if position is not None else "warning", place, reason)


def _nearest(session: Session, seconds: float) -> int:
    return min(range(len(session.exposures_s)), key=lambda k: abs(math.log(seconds / session.exposures_s[k])))


def _curve(folder: PathLike, session: Session, seen: _Seen) -> None:
    """Check the curve: a JPEG picture is never linear, so its curve must be stated or recovered."""
    jpegs = [
        place
        for place, (_, facts) in seen.facts.items()
        if facts.kind == "jpeg" and place.startswith("positions[") and not place.endswith("mask")
    ]
    if not jpegs:
        return
    response, count = session.camera.response, len(session.exposures_s)
    if response == "linear":
        reason = (
            "is a JPEG, whose codes are never linear; set camera.response to unknown, or write linear TIFF from the "
            "raw files"
        )
        _add(seen, folder, "fatal", jpegs[0], reason)
    elif response == "unknown" and count < LEAST_EXPOSURES:
        reason = (
            f"is a JPEG with an unknown curve, and {count} exposures do not determine it; "
            f"take {LEAST_EXPOSURES} or more, or set camera.response to srgb where the camera applies just that"
        )
        _add(seen, folder, "fatal", jpegs[0], reason)
    elif response == "unknown":
        reason = (
            "is a JPEG with an unknown curve: it is recovered from the exposures, to 8 bits, and holds only if the "
            "camera treated all photographs alike (no automatic contrast)"
        )
        _add(seen, folder, "warning", jpegs[0], reason)


def _what_is_left(folder: PathLike, session: Session, seen: _Seen) -> None:
    """Report a position that is lost as a whole once instead of each of its photographs."""
    reasons = {(f.position, f.exposure): f.reason for f in seen.findings if f.severity == "exposure"}
    lost = {f.position for f in seen.findings if f.severity == "position"}
    for i, position in enumerate(session.positions):
        count = len(position.photographs)
        if i in lost or not all((i, k) in reasons for k in range(count)):
            continue
        lost.add(i)
        path = str(Path(folder) / position.photographs[0])
        reason = f"{reasons[i, 0]}; none of the {count} photographs at {position.angle_deg:g}° can be used"
        seen.findings = [f for f in seen.findings if (f.severity, f.position) != ("exposure", i)]
        seen.findings.append(SessionFinding("position", path, reason, f"positions[{i}]", i))
    if len(lost) == len(session.positions):
        reason = "none of its photographs can be used; see the files named before"
        seen.findings.append(SessionFinding("fatal", str(Path(folder)), reason))
