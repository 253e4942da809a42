"""Check that photographs become brighter with their exposure times, without knowing the response curve.

A longer exposure of the same scene never gives a smaller code, whatever the curve is; so the mean code of a picture
grows with the time, also where much of it is saturated. Where it falls, files or times were exchanged.
"""

from __future__ import annotations

import itertools
import os
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from brdf_suite.acquisition.session.finding import SessionFinding, Severity

_MOST_PIXELS = 20_000
_FULL = 0.998
"""Of the scale of codes, from which on a pixel counts as saturated."""
_EVERYWHERE = 0.995
_FALL = 1e-4
"""Of the scale: by how much a mean may fall by noise."""
_SIGMAS = 6.0


def check_exposures(
    codes: NDArray[Any],
    exposures_s: Sequence[float],
    names: Sequence[str],
    bit_depth: int,
    *,
    folder: str | os.PathLike[str] = ".",
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
    index = list(range(len(names))) if exposures is None else list(exposures)
    found: list[SessionFinding] = []

    def add(k: int, severity: Severity, reason: str) -> None:
        at = index[k]
        place = f"positions[{position}].photographs[{at}]" if position is not None else ""
        path = str(Path(folder) / names[k])
        found.append(
            SessionFinding(severity, path, reason, place, position, at if severity == "exposure" else None)
        )

    means, errors, full = _statistics(codes, bit_depth)
    everywhere = full >= _EVERYWHERE
    if everywhere.all():
        add(
            0,
            "position",
            "is saturated everywhere, and so are the longer exposures: there is nothing to measure",
        )
        return tuple(found)
    for k in (int(i) for i in np.flatnonzero(everywhere)):
        add(
            k,
            "exposure",
            f"is saturated in {full[k]:.0%} of its pixels, background included: other light came in, "
            f"or it was exposed longer than {exposures_s[k]:g} s",
        )
    kept = np.flatnonzero(~everywhere)
    _order(kept, means, errors, exposures_s, names, add)
    return tuple(found)


def _statistics(codes: NDArray[Any], bit_depth: int) -> tuple[NDArray[Any], NDArray[Any], NDArray[Any]]:
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


def _order(
    kept: NDArray[Any],
    means: NDArray[Any],
    errors: NDArray[Any],
    exposures_s: Sequence[float],
    names: Sequence[str],
    add: Any,
) -> None:
    """Report the simplest exchange of two photographs that explains why a longer exposure is darker."""

    def rises(order: Sequence[int]) -> bool:
        return all(means[b] >= means[a] - errors[a] - errors[b] for a, b in itertools.pairwise(order))

    order = [int(k) for k in kept]
    if len(order) < 2 or rises(order):
        return
    if len(order) > 2 and rises(order[::-1]):
        add(
            order[0],
            "position",
            "is the brightest of its position: the files are in reverse order of their times",
        )
        return
    for i in range(len(order)):
        for j in range(i + 1, len(order)):
            exchanged = list(order)
            exchanged[i], exchanged[j] = order[j], order[i]
            if rises(exchanged):
                first, second = order[i], order[j]
                reason = (
                    "{} than {}, which was exposed for {:g} s: the two files or their times were exchanged"
                )
                add(first, "exposure", "is " + reason.format("brighter", names[second], exposures_s[second]))
                add(second, "exposure", "is " + reason.format("darker", names[first], exposures_s[first]))
                return
    for i, k in enumerate(order):
        if rises(order[:i] + order[i + 1 :]):
            add(
                k,
                "exposure",
                f"is not as bright as an exposure of {exposures_s[k]:g} s between its neighbours: its time is wrong, "
                "or it shows something else",
            )
            return
    by_brightness = sorted(order, key=lambda k: float(means[k]))
    by_name = ", ".join(Path(names[k]).name for k in by_brightness)
    add(
        order[0],
        "position",
        f"and the others are not in order of their times; by brightness they are {by_name}",
    )
