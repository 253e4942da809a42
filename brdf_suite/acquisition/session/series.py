"""Reading of the photographs of a position or calibration, and of masks, as named in the session."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from brdf_suite.acquisition.photographs.exposure_order import check_exposures
from brdf_suite.acquisition.photographs.reading import Photograph, read_photograph
from brdf_suite.acquisition.session.finding import SessionFinding
from brdf_suite.acquisition.session.session import Session
from brdf_suite.errors import FileError, PathLike

MASK_FILE = "mask.png"
"""Taken as the session's mask where the session names none and the folder holds it."""


@dataclass(frozen=True, eq=False)
class PhotographSeries:
    """Photographs of one thing at several exposures, shortest first.

    Attributes
    ----------
    codes
        (e, h, w, 3) uint8, uint16 or float32.
    exposures_s, names, exposures
        Of each: the time, the file as the session names it, and its index among those asked for.
    findings
        What could not be read, and is not among them.
    """

    codes: NDArray[Any]
    exposures_s: tuple[float, ...]
    names: tuple[str, ...]
    exposures: tuple[int, ...]
    findings: tuple[SessionFinding, ...] = ()


def read_position(
    folder: PathLike, session: Session, position: int, leave_out: Collection[int] = ()
) -> PhotographSeries:
    """Read the photographs of a position but for the exposures in ``leave_out``.

    What is missing, cut off, of another size, saturated everywhere, or brighter than a longer exposure is left out and
    listed in ``findings``.

    Raises
    ------
    FileError
        None of them can be read, or they are in no order that could be right.
    """
    names = session.positions[position].photographs
    series = read_series(
        folder,
        names,
        session.exposures_s,
        session.camera.bit_depth,
        place=f"positions[{position}].photographs",
        position=position,
        leave_out=leave_out,
    )
    found = check_exposures(
        series.codes,
        series.exposures_s,
        series.names,
        session.camera.bit_depth,
        folder=folder,
        position=position,
        exposures=series.exposures,
    )
    for finding in found:
        if finding.severity == "position":
            raise finding.error()
    return _without(series, found) if found else series


def _without(series: PhotographSeries, found: tuple[SessionFinding, ...]) -> PhotographSeries:
    """Return the series less the exposures that have findings."""
    dropped = {finding.exposure for finding in found}
    kept = [i for i, exposure in enumerate(series.exposures) if exposure not in dropped]
    if not kept:
        raise found[0].error()
    return PhotographSeries(
        series.codes[kept],
        tuple(series.exposures_s[i] for i in kept),
        tuple(series.names[i] for i in kept),
        tuple(series.exposures[i] for i in kept),
        (*series.findings, *found),
    )


def read_dark(folder: PathLike, session: Session) -> PhotographSeries | None:
    """Read the dark frames, or return None where the session names none; errors as :func:`read_position`."""
    if not session.dark:
        return None
    return read_series(folder, session.dark, session.exposures_s, session.camera.bit_depth, place="dark")


def read_white(folder: PathLike, session: Session) -> PhotographSeries | None:
    """Read the white reference, or return None where the session has none; errors as :func:`read_position`."""
    white = session.white
    if white is None:
        return None
    times = white.exposures_s or session.exposures_s
    return read_series(folder, white.photographs, times, session.camera.bit_depth, place="white.photographs")


def read_flat_field(folder: PathLike, session: Session) -> PhotographSeries | None:
    """Read the flat field, or return None where the session has none; errors as :func:`read_position`."""
    flat = session.flat_field
    if flat is None:
        return None
    times = flat.exposures_s or session.exposures_s
    return read_series(
        folder, flat.photographs, times, session.camera.bit_depth, place="flat_field.photographs"
    )


def read_series(
    folder: PathLike,
    names: Sequence[str],
    exposures_s: Sequence[float],
    bit_depth: int,
    *,
    place: str = "",
    position: int | None = None,
    leave_out: Collection[int] = (),
) -> PhotographSeries:
    """Read files of a folder, one for each time; errors and findings as :func:`read_position`."""
    stack: NDArray[Any] | None = None
    kept: list[int] = []
    findings: list[SessionFinding] = []
    wanted = [k for k in range(len(names)) if k not in leave_out]
    for k in wanted:
        path = Path(folder) / names[k]
        try:
            codes = check_codes(read_photograph(path), bit_depth, path)
            if stack is None:
                # One block for all: a list of pictures and its stack would be twice as large.
                stack = np.empty((len(wanted), *codes.shape), codes.dtype)
            if codes.shape != stack.shape[1:] or codes.dtype != stack.dtype:
                size, other = _size(codes), _size(stack[0])
                raise FileError(path, f"is {size}, and the photographs before it are {other}")
        except FileError as error:
            where = f"{place}[{k}]" if place else ""
            findings.append(SessionFinding("exposure", error.path, error.reason, where, position, k))
            continue
        stack[len(kept)] = codes
        kept.append(k)
    if stack is None:
        if findings:
            raise findings[0].error()
        raise FileError(folder, "names no photograph that could be read", place or None)
    return PhotographSeries(
        stack[: len(kept)],
        tuple(float(exposures_s[k]) for k in kept),
        tuple(names[k] for k in kept),
        tuple(kept),
        tuple(findings),
    )


def check_codes(photograph: Photograph, bit_depth: int, path: PathLike) -> NDArray[Any]:
    """Return a photograph's codes where they fit the session's depth; :class:`FileError` where they do not."""
    codes, bits = photograph.codes, photograph.facts.bits
    if bits is None:
        return codes
    if bits < bit_depth:
        raise FileError(
            path, f"has {bits} bits a channel, and session.json says {bit_depth}; correct camera.bit_depth"
        )
    highest = int(codes.max())
    if highest >= 1 << bit_depth:
        raise FileError(
            path,
            f"holds the code {highest:,}, beyond the {(1 << bit_depth) - 1:,} of {bit_depth} bits; "
            "correct camera.bit_depth in session.json",
        )
    return codes


def read_mask(folder: PathLike, session: Session, position: int | None = None) -> NDArray[np.bool_] | None:
    """Return the pixels (h, w) that may be used, or None where all may be.

    The session's mask, or ``mask.png`` where it names none, together with the position's own; white is used.

    Raises
    ------
    FileError
        A mask that is named cannot be read, or the two have different sizes.
    """
    names = [session.mask or (MASK_FILE if (Path(folder) / MASK_FILE).is_file() else None)]
    if position is not None:
        names.append(session.positions[position].mask)
    used: NDArray[np.bool_] | None = None
    for name in names:
        if name is None:
            continue
        path = Path(folder) / name
        photograph = read_photograph(path)
        full = 1.0 if photograph.facts.bits is None else float((1 << photograph.facts.bits) - 1)
        own = photograph.codes.mean(axis=-1) > 0.5 * full
        if used is not None and own.shape != used.shape:
            raise FileError(path, f"is {_size(own)}, and the session's mask is {_size(used)}")
        used = own if used is None else used & own
    return used


def _size(picture: NDArray[Any]) -> str:
    height, width = picture.shape[:2]
    depth = {"uint8": ", 8 bits", "uint16": ", 16 bits", "float32": ", floats"}.get(str(picture.dtype), "")
    return f"{width} × {height} pixels{depth}"
