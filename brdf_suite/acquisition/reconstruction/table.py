"""The last step of a reconstruction, position by position into the table, and its result: how much was measured."""

from __future__ import annotations

import contextlib
import hashlib
import json
import math
from collections.abc import Callable, Mapping
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass, field, replace
from pathlib import Path
from types import MappingProxyType
from typing import Any

import numpy as np

from brdf_suite.acquisition.reconstruction.options import covered_share
from brdf_suite.acquisition.reconstruction.photographs import Calibration
from brdf_suite.acquisition.reconstruction.reconstruction import Acquisition
from brdf_suite.acquisition.reconstruction.work_file import (
    CALIBRATION,
    POSITION,
    WorkFile,
    WorkRecord,
    open_work,
)
from brdf_suite.acquisition.session.series import PhotographSeries
from brdf_suite.acquisition.table.samples import SphereSampler
from brdf_suite.acquisition.table.sums import (
    LAYOUTS,
    Parameterization,
    PositionSums,
    TableSums,
    position_sums,
    reading_weights,
)
from brdf_suite.acquisition.table.table_from_sums import (
    ParameterizedTable,
    bin_means,
    half_angle_table,
    tabulate_means,
)
from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.errors import AcquisitionError, FileError
from brdf_suite.progress import Progress, report
from brdf_suite.reflectance.tabulated.isotropic import PIXEL_FACT, IsotropicTable
from brdf_suite.regular_files import exists

LEAST_PEAK_PIXELS = 4.0
"""Full width at half of its height at which a peak loses 3 % of its height, 7 % seen at 60°."""
_LEAST_PEAK = 3.0
_PEAK_DEG, _AROUND_DEG, _FLATTEST_DEG = 5.0, (8.0, 14.0), 45.0

ALGORITHM = 1
"""Raised whenever the same photographs would give other sums: older work is then not taken up."""


@dataclass(frozen=True)
class LeftOut:
    """A position that gave no readings, and why (a sentence's clause that names the file)."""

    position: int
    reason: str


@dataclass(frozen=True, eq=False)
class Acquired:
    """A reconstructed table and how it came to be.

    Attributes
    ----------
    table
        Half-angle bins with their coverage, working space.
    positions_done, positions_failed
        Which positions gave readings, and which gave none.
    resumed
        How many of the positions were taken up from a work file.
    readings
        How many readings the table is made of.
    calibration
        Response and geometry.
    notices
        What the user should know, each a sentence.
    seconds
        Time by step: ``read`` (decoding, in the background), ``calibrate``, ``merge``, ``samples``,
        ``table`` (readings into bins), ``finish`` (means to centres, holes).
    compared
        The other layouts by name, where they were asked for.
    """

    table: IsotropicTable
    positions_done: tuple[int, ...]
    positions_failed: tuple[LeftOut, ...]
    resumed: int
    readings: int
    calibration: Calibration
    notices: tuple[str, ...] = ()
    seconds: Mapping[str, float] = field(default_factory=lambda: MappingProxyType({}))
    compared: Mapping[str, ParameterizedTable] = field(default_factory=lambda: MappingProxyType({}))


Partial = Callable[[int, int, Callable[[], IsotropicTable]], None]
"""Called after each position with how many are done, of how many, and a function that makes the table so far."""


def figures_of(acquired: Acquired) -> dict[str, Any]:
    """Return what is known of a reconstruction as plain values, as ``brdf-suite acquire --json`` prints them."""
    coverage = acquired.table.coverage
    median = 0.0
    if coverage is not None and (coverage.samples > 0.0).any():
        median = float(np.median(coverage.deviation[coverage.samples > 0.0]))
    return {
        "positions": len(acquired.positions_done),
        "resumed": acquired.resumed,
        "left_out": [{"position": one.position, "reason": one.reason} for one in acquired.positions_failed],
        "readings": acquired.readings,
        "coverage": {
            "bins": int(np.count_nonzero(acquired.table.measured_mask())),
            "share_below_75_deg": covered_share(acquired.table, 75.0),
            "median_deviation": median,
        },
        "calibration": dict(acquired.calibration.figures),
        "notices": list(acquired.notices),
        "seconds": {name: round(value, 3) for name, value in acquired.seconds.items()},
    }


def reconstruct(
    acquisition: Acquisition,
    progress: Progress | None = None,
    work: Path | None = None,
    partial: Partial | None = None,
    restart: bool = False,
) -> Acquired:
    """Return the table of the positions of ``acquisition``, whose calibration was taken.

    Parameters
    ----------
    acquisition
        A session with its calibration.
    progress
        Called after each position; may raise :class:`~brdf_suite.errors.Cancelled`, and what is done stays in ``work``.
    work
        Where to keep what is done; what lies there of the same session, options and calibration is taken up.
    partial
        Called after each position with how many are done, of how many, and what gives the table so far.
    restart
        Whether to forget what lies in ``work``, whatever it belongs to.

    Raises
    ------
    AcquisitionError
        No position gave a reading; the message has the first one's reason.
    FileError
        ``work`` belongs to other photographs, is in use, or cannot be written.
    """
    with contextlib.nullcontext() if work is None else open_work(work) as kept:
        key = work_key(acquisition)
        done: dict[int, WorkRecord] = {}
        if kept is not None:
            if restart:
                kept.empty()
            done = _taken_up(kept, key)
            calibration = acquisition.calibration.to_json()
            if not kept.records:
                kept.add(CALIBRATION, {"key": key, "calibration": calibration}, {})
            elif json.dumps(kept.records[0].values["calibration"]) != json.dumps(calibration):
                raise FileError(kept.path, "was begun with another calibration; take that one, or begin anew")
        return _Reconstruction(acquisition, kept, done).run(progress, partial)


def kept_work(acquisition: Acquisition, work: Path) -> tuple[Calibration, tuple[int, ...]] | None:
    """Return the calibration in a work file of the same session and options, and which positions are done in it.

    None where there is no such file, or nothing in it.

    Raises
    ------
    FileError
        The file belongs to other photographs or options, or is in use.
    """
    if not exists(work):
        return None
    with open_work(work) as kept:
        if not kept.records:
            return None
        positions = tuple(_taken_up(kept, work_key(acquisition)))
        return Calibration.from_json(kept.records[0].values["calibration"]), positions


def work_key(acquisition: Acquisition) -> str:
    """Return a hash of the session, the options, and the photographs that belong to no position."""
    parts = [ALGORITHM, acquisition.options.to_json(), acquisition.source.digest(None)]
    return hashlib.sha256(json.dumps(parts, sort_keys=True).encode()).hexdigest()


def _taken_up(kept: WorkFile, key: str) -> dict[int, WorkRecord]:
    """Return the positions in a work file, the newest record of each."""
    if not kept.records:
        return {}
    first = kept.records[0]
    if first.tag != CALIBRATION or first.values.get("key") != key:
        reason = "belongs to a reconstruction of other photographs or with other options; "
        raise FileError(kept.path, f"{reason}go on with those, or begin anew (--restart)")
    return {record.values["position"]: record for record in kept.records if record.tag == POSITION}


def unresolved_peak(table: IsotropicTable, pixel_rad: float) -> str | None:
    """Return a sentence where the coat's peak is narrower than photographs resolve; None where there is no such peak.

    Its width is that of the table's luminance against θh, where measured, at half of its height above what lies 8° to
    14° away; θd is below 45°. ``pixel_rad``: the angle that a pixel covers of the sphere.
    """
    theta_h, theta_d, _ = table.grid.centres()
    flat = int(np.searchsorted(theta_d, np.radians(_FLATTEST_DEG)))
    measured, grey = table.measured_mask()[:, :flat], table.values[:, :flat] @ LUMINANCE
    rings = np.flatnonzero(measured.any(axis=(1, 2)))
    angle = np.degrees(theta_h[rings])
    height = np.array([np.median(grey[ring][measured[ring]]) for ring in rings])
    near, about = angle < _PEAK_DEG, (angle > _AROUND_DEG[0]) & (angle < _AROUND_DEG[1])
    if not near.any() or not about.any():
        return None
    base, top = float(np.median(height[about])), float(height[near].max())
    half, peak = base + 0.5 * (top - base), int(np.argmax(np.where(near, height, 0.0)))
    low = peak + np.flatnonzero(height[peak:] < half)[:1]
    pixel = float(np.degrees(pixel_rad))
    if top < _LEAST_PEAK * base or not low.size:
        return None
    beside = slice(int(low[0]) - 1, int(low[0]) + 1)
    width = 2.0 * float(np.interp(-half, -height[beside], angle[beside]))
    if width >= LEAST_PEAK_PIXELS * pixel:
        return None
    # What the pixels themselves make of a line.
    narrow = max(math.sqrt(max(width**2 - pixel**2, 0.0)), 0.5 * pixel)
    return (
        f"The coat's peak is narrower than these photographs resolve: it is {width:.2g}° wide at half of its height, "
        f"and a pixel covers {pixel:.2g}° of the sphere, so its height and the sharp lobe's ks, m and r are not "
        f"reliable. Photograph the sphere about {LEAST_PEAK_PIXELS * pixel / narrow:.1f} times as large: with more "
        "pixels, a longer lens, or the camera nearer."
    )


class _Reconstruction:
    """The sums as they grow."""

    def __init__(self, acquisition: Acquisition, kept: WorkFile | None, done: dict[int, WorkRecord]) -> None:
        self.acquisition = acquisition
        self.kept = kept
        self.done = done
        self.calibration = acquisition.calibration
        self.colour = acquisition.session.camera.to_working
        layouts, bins = LAYOUTS if acquisition.options.compare else LAYOUTS[:1], acquisition.options.bins
        self.sums = {layout: TableSums(Parameterization(layout, bins)) for layout in layouts}
        self.succeeded: list[int] = []
        self.failed: list[LeftOut] = []
        self.findings: list[str] = []
        self.unresolved: tuple[str, ...] = ()
        self.resumed = 0
        self.readings = 0

    def run(self, progress: Progress | None, partial: Partial | None) -> Acquired:
        positions = self.acquisition.positions
        sampler: SphereSampler | None = None
        # The next position is read while this one is reckoned: both take about as long.
        with ThreadPoolExecutor(1, "photographs") as pool:
            ahead: Future[PhotographSeries] | None = None
            for n, k in enumerate(positions):
                report(progress, 0.97 * n / len(positions), f"position {n + 1} of {len(positions)}")
                record = self.done.get(k)
                if record is not None and record.values["digest"] != self.acquisition.source.digest(k):
                    record = None
                if k in self.calibration.left_out:
                    self.failed.append(LeftOut(k, self.calibration.left_out[k]))
                elif record is not None:
                    self._add_kept(k, record)
                else:
                    reading = ahead or pool.submit(self.acquisition.stack, k)
                    ahead = None
                    following = positions[n + 1] if n + 1 < len(positions) else None
                    sampler = sampler or self.acquisition.sampler()
                    try:
                        stack = reading.result()
                        known = {*self.done, *self.calibration.left_out}
                        if following is not None and following not in known:
                            ahead = pool.submit(self.acquisition.stack, following)
                        self._add_new(k, stack, sampler)
                    except FileError as error:
                        self.failed.append(LeftOut(k, str(error)))
                if partial is not None:
                    partial(n + 1, len(positions), self._table_so_far)
        if not self.succeeded:
            reason = f" The first: {self.failed[0].reason}" if self.failed else ""
            raise AcquisitionError(f"No position gave a reading.{reason}")
        report(progress, 0.97, "filling holes")
        with self.acquisition.clock.step("finish"):
            table = self._table()
            others: dict[str, TableSums] = {k: sums for k, sums in self.sums.items() if k != "half-angle"}
            compared = {
                layout: tabulate_means(bin_means(sums, self.colour)) for layout, sums in others.items()
            }
        return Acquired(
            table,
            tuple(self.succeeded),
            tuple(self.failed),
            self.resumed,
            self.readings,
            self.calibration,
            (*self.calibration.notices, *self.unresolved, *self.findings),
            dict(self.acquisition.clock.seconds),
            compared,
        )

    def _add_kept(self, k: int, record: WorkRecord) -> None:
        assert self.kept is not None
        arrays = self.kept.arrays(record)
        self.resumed += 1
        position = {
            layout: PositionSums(arrays[f"{layout} places"], arrays[f"{layout} sums"]) for layout in self.sums
        }
        self._take(k, position, record.values["readings"], record.values["findings"])

    def _add_new(self, k: int, stack: PhotographSeries, sampler: SphereSampler) -> None:
        found, findings = self.acquisition.checked_samples(k, sampler, stack)
        position: dict[Any, PositionSums] = {}
        with self.acquisition.clock.step("table"):
            weights = reading_weights(found.wi, found.wo, found.value, found.variance) * found.weight
            wi, wo = found.wi.astype(np.float64), found.wo.astype(np.float64)
            for layout, sums in self.sums.items():
                places = sums.parameterization.index_of(wi, wo)
                binned = position_sums(sums.parameterization, places, found.value, weights, found.variance)
                position[layout] = binned
        readings = int(next(iter(position.values())).sums[:, 0].sum(dtype=np.float64))
        if self.kept is not None:
            arrays: dict[str, Any] = {}
            for layout, binned in position.items():
                arrays |= {f"{layout} places": binned.places, f"{layout} sums": binned.sums}
            values = {
                "position": k,
                "digest": self.acquisition.source.digest(k),
                "readings": readings,
                "findings": list(findings),
            }
            self.kept.add(POSITION, values, arrays)
        self._take(k, position, readings, findings)

    def _take(self, k: int, position: dict[Any, PositionSums], readings: int, findings: Any) -> None:
        for layout, sums in position.items():
            self.sums[layout].add(sums)
        self.succeeded.append(k)
        self.readings += readings
        self.findings += [f"{finding}." for finding in findings]

    def _table_so_far(self) -> IsotropicTable:
        # Without the rounds of centring: this one is for a plot while the work goes on.
        return half_angle_table(bin_means(self.sums["half-angle"], self.colour, centre=False))

    def _table(self) -> IsotropicTable:
        session = self.acquisition.session
        facts = {
            "format": "acquired",
            "session": session.name,
            "date": session.date,
            "positions": len(self.succeeded),
            "positions_left_out": len(self.failed),
            "exposures": len(session.exposures_s),
            "readings": self.readings,
            "grazing_deg": self.acquisition.options.grazing_deg,
            PIXEL_FACT: math.degrees(self.calibration.geometry.pixel_rad),
            **{f"calibration_{name}": value for name, value in self.calibration.figures.items()},
        }
        table = half_angle_table(bin_means(self.sums["half-angle"], self.colour), session.name, facts)
        unresolved = unresolved_peak(table, self.calibration.geometry.pixel_rad)
        self.unresolved = () if unresolved is None else (unresolved,)
        reasons = (one.reason for one in self.failed)
        notes = (*self.calibration.notices, *self.unresolved, *self.findings, *reasons)
        return replace(table, facts={**table.facts, "notes": notes})
