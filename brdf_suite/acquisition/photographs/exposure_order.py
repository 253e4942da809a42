"""Check that photographs become brighter with their exposure times, without knowing the response curve.

A longer exposure of the same scene never gives a smaller code, whatever the curve is; so the mean code of a picture
grows with the time, also where much of it is saturated. Where it falls, files or times were exchanged.
"""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from brdf_suite.acquisition.session.finding import SessionFinding, Severity
from brdf_suite.arrays import AnyArray, Floats
from brdf_suite.errors import PathLike

_MOST_PIXELS = 20_000
_FULL = 0.998
"""Of the scale of codes, from which on a pixel counts as saturated."""
_EVERYWHERE = 0.995
_FALL = 1e-4
"""Of the scale: by how much a mean may fall by noise."""
_SIGMAS = 6.0


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
    """Return what is wrong with the order and the exposure of photographs of one scene.

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
            reason = (
                f"is not as bright as an exposure of {exposures_s[k]:g} s between its neighbours: its time "
            )
            add(k, "exposure", f"{reason}is wrong, or it shows something else")
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
    full = np.zeros(len(some)) if floats else (some >= _FULL).mean(axis=1)
    # Neighbouring pixels of the sample differ by noise and by the scene: more than by noise.
    noise = np.median(np.abs(np.diff(some, axis=1)), axis=1) / np.sqrt(some.shape[1])
    return some.mean(axis=1), _FALL + _SIGMAS * noise, full
