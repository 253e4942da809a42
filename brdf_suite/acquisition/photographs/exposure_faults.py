"""Faults of an exposure series detected from its codes or radiances: exchanged or wrong times, clipping, no light."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

from brdf_suite.acquisition.session.finding import SessionFinding, Severity
from brdf_suite.arrays import AnyArray, Floats
from brdf_suite.errors import FileError, PathLike

if TYPE_CHECKING:  # numba takes half a second to import, and the order is checked without it
    from brdf_suite.acquisition.radiance.merge import MergedRadiance

TIME_TOLERANCE = 0.12
"""Of the logarithm of a time of exposure: shutters stray by a few per cent, and names of times by up to 5 %."""

_FALLING = 0.5
_ALL = 0.999
_MOST_PIXELS = 20_000
_FULL_SCALE = 0.998
"""Of the scale of codes, from which on a pixel counts as saturated."""
_EVERYWHERE = 0.995
_FALL = 1e-4
"""Of the scale: by how much a mean may fall by noise."""
_SIGMAS = 6.0


@dataclass(frozen=True)
class ExposureFault:
    """One photograph that does not fit its series.

    ``name`` is the file's, ``reason`` starts in lower case without a full stop, and ``fatal`` says that radiances made
    with this photograph are wrong; a photograph without usable pixels is not fatal.
    """

    name: str
    reason: str
    fatal: bool

    def error(self) -> FileError:
        """Return the error that names the file and the reason."""
        return FileError(self.name, self.reason)


def exposure_faults(
    merged: MergedRadiance, exposures_s: npt.ArrayLike, names: Sequence[str]
) -> list[ExposureFault]:
    """Return what is wrong with the photographs ``names`` (n) of one position, merged by
    :func:`brdf_suite.acquisition.radiance.merge.merge`."""
    times = np.asarray(exposures_s, float)
    faults = _time_faults(merged, times, names)
    for i, name in enumerate(names):
        if merged.clipped_share[i] >= _ALL:
            reason = f"the photograph of {times[i]:g} s is clipped everywhere and cannot be used"
            faults.append(ExposureFault(name, reason, i == 0))
    last = len(names) - 1
    if merged.dark_share[last] >= _ALL:
        reason = f"even the longest exposure, {times[last]:g} s, shows no light; was the lamp on"
        faults.append(ExposureFault(names[last], reason, True))
    return faults


def time_errors(time_ratios: Floats, times: Floats) -> Floats:
    """Return (n,) ln(time shown / time stated) from the ratios between neighbours; NaN where no ratio is usable.

    Only ratios are seen, so the median is taken for right. A gap in the ratios parts the series: each part has its own
    median.
    """
    apart = time_ratios - np.log(times[1:] / times[:-1])
    errors = np.full(len(times), np.nan)
    start = 0
    while start < len(times):
        end = start + 1
        while end < len(times) and np.isfinite(apart[end - 1]):
            end += 1
        if end - start > 1:
            run = np.concatenate(([0.0], np.cumsum(apart[start : end - 1])))
            errors[start:end] = run - np.median(run)
        start = end
    return errors


def _time_faults(merged: MergedRadiance, times: Floats, names: Sequence[str]) -> list[ExposureFault]:
    errors = time_errors(merged.time_ratios, times)
    shown = times * np.exp(np.nan_to_num(errors))
    wrong: list[int] = np.flatnonzero(np.abs(np.nan_to_num(errors)) > TIME_TOLERANCE).tolist()
    faults = []
    reported: set[int] = set()
    for i in wrong:
        if i in reported:
            continue
        # Exposures that show each other's times.
        apart = np.maximum(np.abs(np.log(shown[i] / times)), np.abs(np.log(shown / times[i])))
        other = next((k for k in wrong if k != i and apart[k] < TIME_TOLERANCE), None)
        if other is not None:
            reported.add(other)
            reason = (
                f"it looks like the exposure of {times[other]:g} s, and {names[other]} like that of {times[i]:g} s;"
                " the two are exchanged"
            )
        else:
            falls = i > 0 and merged.falling_share[i - 1] > _FALLING
            reason = f"stated as {times[i]:g} s, but its pixels show about {shown[i]:.3g} s"
            reason += f", darker than the {times[i - 1]:g} s before it" if falls else ""
        faults.append(ExposureFault(names[i], reason, True))
    return faults


def check_exposures(
    codes: AnyArray,
    exposures_s: Sequence[float],
    names: Sequence[str],
    bit_depth: int,
    *,
    folder: PathLike = ".",
    position: int | None = None,
    exposures: Sequence[int] | None = None,
) -> tuple[SessionFinding, ...]:
    """Return what is wrong with the order and the exposure of photographs of one scene, whatever the response is.

    A longer exposure of the same scene never gives a smaller code; so the mean code of a picture grows with the time,
    also where much of it is saturated. Where it falls, files or times were exchanged.

    Parameters
    ----------
    codes
        (e, h, w, 3), shortest exposure first; floats are taken as codes whose full scale is unknown.
    exposures_s, names
        Of each photograph.
    exposures
        Their indices in the session, where some are left out; default: 0, 1, …
    """
    index = range(len(names)) if exposures is None else exposures
    found: list[SessionFinding] = []

    def add(k: int, severity: Severity, reason: str) -> None:
        place = f"positions[{position}].photographs[{index[k]}]" if position is not None else ""
        exposure = index[k] if severity == "exposure" else None
        path = str(Path(folder) / names[k])
        found.append(SessionFinding(severity, path, reason, place, position, exposure))

    means, errors, full = _statistics(codes, bit_depth)
    everywhere = full >= _EVERYWHERE
    if everywhere.all():
        reason = "is saturated everywhere, and so are the longer exposures: there is nothing to measure"
        add(0, "position", reason)
        return tuple(found)
    for k in np.flatnonzero(everywhere).tolist():
        reason = f"is saturated in {full[k]:.0%} of its pixels, background included: other light came in, "
        add(k, "exposure", f"{reason}or it was exposed longer than {exposures_s[k]:g} s")

    def rises(order: Sequence[int]) -> bool:
        return all(means[b] >= means[a] - errors[a] - errors[b] for a, b in itertools.pairwise(order))

    order: list[int] = np.flatnonzero(~everywhere).tolist()
    if len(order) < 2 or rises(order):
        return tuple(found)
    if len(order) > 2 and rises(order[::-1]):
        reason = "is the brightest of its position: the files are in reverse order of their times"
        add(order[0], "position", reason)
        return tuple(found)
    # The simplest exchange of two photographs that explains why a longer exposure is darker.
    for i, j in itertools.combinations(range(len(order)), 2):
        exchanged = list(order)
        exchanged[i], exchanged[j] = order[j], order[i]
        if rises(exchanged):
            for k, other, how in ((order[i], order[j], "brighter"), (order[j], order[i], "darker")):
                reason = f"is {how} than {names[other]}, which was exposed for {exposures_s[other]:g} s: "
                add(k, "exposure", f"{reason}the two files or their times were exchanged")
            return tuple(found)
    for i, k in enumerate(order):
        if rises(order[:i] + order[i + 1 :]):
            reason = f"is not as bright as an exposure of {exposures_s[k]:g} s between its neighbours: "
            add(k, "exposure", f"{reason}its time is wrong, or it shows something else")
            return tuple(found)
    by_name = ", ".join(Path(names[k]).name for k in sorted(order, key=lambda k: float(means[k])))
    reason = f"and the others are not in order of their times; by brightness they are {by_name}"
    add(order[0], "position", reason)
    return tuple(found)


def _statistics(codes: AnyArray, bit_depth: int) -> tuple[Floats, Floats, Floats]:
    """Return per photograph the mean code over full scale, what it may fall by noise, and the saturated share."""
    rows, columns = codes.shape[1:3]
    step = max(1, int(np.ceil(np.sqrt(rows * columns / _MOST_PIXELS))))
    some = codes[:, ::step, ::step].reshape(len(codes), -1).astype(float)
    # Of floats the largest value counts as full, but none as saturated: their scale has no end.
    floats = codes.dtype.kind == "f"
    scale = max(float(some.max()), 1e-30) if floats else float((1 << bit_depth) - 1)
    some /= scale
    full = np.zeros(len(some)) if floats else (some >= _FULL_SCALE).mean(axis=1)
    # Neighbouring pixels of the sample differ by noise and by the scene: more than by noise.
    noise = np.median(np.abs(np.diff(some, axis=1)), axis=1) / np.sqrt(some.shape[1])
    return some.mean(axis=1), _FALL + _SIGMAS * noise, full
