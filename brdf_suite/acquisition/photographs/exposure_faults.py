"""Faults of an exposure series detected from its pixels: exchanged or wrong times, clipping, no light."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from brdf_suite.acquisition.radiance.merge import MergedRadiance
from brdf_suite.arrays import Floats
from brdf_suite.errors import FileError

TIME_TOLERANCE = 0.12
"""Of the logarithm of a time of exposure: shutters stray by a few per cent, and names of times by up to 5 %."""

_FALLING = 0.5
_ALL = 0.999


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
        other = next((k for k in wrong if k != i and _exchanged(shown, times, i, k)), None)
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


def _exchanged(shown: Floats, times: Floats, i: int, k: int) -> bool:
    """Whether exposures i and k show each other's times."""
    near = np.log(np.array([shown[i] / times[k], shown[k] / times[i]]))
    return bool(np.all(np.abs(near) < TIME_TOLERANCE))
