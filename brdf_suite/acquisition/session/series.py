"""Reading of the photographs of a position or calibration, and of masks, as named in the session."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Literal

import numpy as np

from brdf_suite.acquisition.photographs.exposure_faults import check_exposures
from brdf_suite.acquisition.photographs.reading import Photograph, read_photograph
from brdf_suite.acquisition.session.finding import SessionFinding
from brdf_suite.acquisition.session.session import Session
from brdf_suite.arrays import AnyArray, Bools
from brdf_suite.errors import FileError, PathLike
from brdf_suite.regular_files import is_file

SeriesKind = Literal["dark", "white", "flat_field"]

MASK_FILE = "mask.png"
"""Taken as the session's mask where the session names none and the folder holds it."""


@dataclass(frozen=True, eq=False)
class PhotographSeries:
    """Photographs of one thing at several exposures, shortest first.

    Attributes
    ----------
    codes
        (e, h, w, 3) uint8, uint16, or float32 for photographs that are linear already.
    exposures_s, names
        Of each: the time, and the file as the session names it.
    exposures
        Of each: its index among those asked for; empty where these are all.
    findings
        What could not be read, and is not among them.
    """

    codes: AnyArray
    exposures_s: tuple[float, ...]
    names: tuple[str, ...]
    exposures: tuple[int, ...] = ()
    findings: tuple[SessionFinding, ...] = ()

    def part(self, kept: list[int]) -> PhotographSeries:
        """Return the photographs at the places ``kept``."""
        return PhotographSeries(
            self.codes[kept],
            tuple(self.exposures_s[i] for i in kept),
            tuple(self.names[i] for i in kept),
            tuple(self.exposures[i] for i in kept if self.exposures),
            self.findings,
        )


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
    bits, place = session.camera.bit_depth, f"positions[{position}].photographs"
    series = read_series(
        folder, names, session.exposures_s, bits, place=place, position=position, leave_out=leave_out
    )
    shown = (series.codes, series.exposures_s, series.names, bits)
    found = check_exposures(*shown, folder=folder, position=position, exposures=series.exposures)
    for finding in found:
        if finding.severity == "position":
            raise finding.error()
    if not found:
        return series
    dropped = {finding.exposure for finding in found}
    kept = [i for i, exposure in enumerate(series.exposures) if exposure not in dropped]
    if not kept:
        raise found[0].error()
    return replace(series.part(kept), findings=(*series.findings, *found))


def read_calibration(folder: PathLike, session: Session, kind: SeriesKind) -> PhotographSeries | None:
    """Read a calibration's photographs; None where the session names none. Errors as :func:`read_position`."""
    part = session.white if kind == "white" else session.flat_field
    names, times, place = session.dark, session.exposures_s, "dark"
    if kind != "dark":
        names, place = () if part is None else part.photographs, f"{kind}.photographs"
        times = (part and part.exposures_s) or times
    return read_series(folder, names, times, session.camera.bit_depth, place=place) if names else None


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
    stack: AnyArray | None = None
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


def check_codes(photograph: Photograph, bit_depth: int, path: PathLike) -> AnyArray:
    """Return a photograph's codes where they fit the session's depth; :class:`FileError` where they do not."""
    codes, bits = photograph.codes, photograph.facts.bits
    if bits is None:
        return codes
    if bits < bit_depth:
        reason = f"has {bits} bits a channel, and session.json says {bit_depth}; correct camera.bit_depth"
        raise FileError(path, reason)
    highest = int(codes.max())
    if highest >= 1 << bit_depth:
        reason = f"holds the code {highest:,}, beyond the {(1 << bit_depth) - 1:,} of {bit_depth} bits; "
        raise FileError(path, f"{reason}correct camera.bit_depth in session.json")
    return codes


def read_mask(folder: PathLike, session: Session, position: int | None = None) -> Bools | None:
    """Return the pixels (h, w) that may be used, or None where all may be.

    The session's mask, or ``mask.png`` where it names none, together with the position's own; white is used.

    Raises
    ------
    FileError
        A mask that is named cannot be read, or the two have different sizes.
    """
    names = [session.mask or (MASK_FILE if is_file(Path(folder) / MASK_FILE) else None)]
    if position is not None:
        names.append(session.positions[position].mask)
    used: Bools | None = None
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


def _size(picture: AnyArray) -> str:
    height, width = picture.shape[:2]
    depth = {"uint8": ", 8 bits", "uint16": ", 16 bits", "float32": ", floats"}.get(str(picture.dtype), "")
    return f"{width} × {height} pixels{depth}"
