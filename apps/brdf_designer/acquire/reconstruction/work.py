"""Builds and resumes the table on a thread, and prepares what its pages show."""

from __future__ import annotations

import contextlib
import time
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from brdf_qt.program.core_texts import tr_core
from brdf_qt.program.translation import tr

from brdf_designer.acquire.camera_response.work import open_session, response_found, thousands
from brdf_designer.acquire.geometry.work import geometry_found, open_acquisition
from brdf_designer.acquire.reconstruction.session import WORK_FILE, StepRequest
from brdf_designer.acquire.states import CoverageState, Found
from brdf_suite.acquisition.reconstruction.options import coverage_map, covered_share, deviation_map
from brdf_suite.errors import FileError, SuiteError
from brdf_suite.progress import Progress, report, subrange
from brdf_suite.reflectance.tabulated.isotropic import IsotropicTable

if TYPE_CHECKING:
    from brdf_suite.acquisition.reconstruction.reconstruction import Acquisition

_PARTIAL_S = 2.0
_PARTIAL_SHARE = 0.1
"""Maps of what is covered so far: how long before the first, and the share of the time that they may take."""


@dataclass(frozen=True, eq=False)
class TableFound:
    """A table, what is shown of it, and what was calibrated on the way to it."""

    acquired: Any
    state: CoverageState
    calibrated: dict[str, Found]


@dataclass(frozen=True)
class KeptWork:
    """What lies in the work file of a session: how many positions are done, and what they were calibrated with.

    ``reason`` says why the earlier work cannot be resumed; empty where it can.
    """

    done: int = 0
    calibrated: dict[str, Found] = field(default_factory=dict)
    reason: str = ""


@dataclass(frozen=True)
class TableRequest:
    """The road, whether to begin anew, and who hears of what is covered so far (from the thread)."""

    road: StepRequest
    restart: bool
    partial: Callable[[int, int, CoverageState | None], None]


def find_kept(request: StepRequest, _progress: Progress) -> KeptWork:
    """Look what an earlier run has left."""
    from brdf_suite.acquisition.reconstruction.table import kept_work

    work = request.folder / WORK_FILE
    if not work.exists():
        return KeptWork()
    try:
        road = open_session(request)
        kept = kept_work(road, work)
        if kept is None:
            return KeptWork()
        calibration, done = kept
        road.take_calibration(calibration)
    except FileError as error:
        return KeptWork(reason=str(error))
    return KeptWork(len(done), _known(road, calibration))


def _known(road: Acquisition, calibration: Any) -> dict[str, Found]:
    """Return what is known from the calibration in a work file."""
    return {"response": replace(response_found(road), kept=True), "geometry": Found(calibration, None)}


def find_table(request: TableRequest, progress: Progress) -> TableFound:
    """Make the table; response and geometry first, where they are not known. What is done is kept in the folder."""
    from brdf_suite.acquisition.reconstruction.table import kept_work, reconstruct

    road = open_acquisition(request.road)
    work = request.road.folder / WORK_FILE
    calibrated: dict[str, Found] = {}
    start = 0.0
    if request.road.geometry is None:
        kept = None if request.restart else kept_work(road, work)
        if kept is not None:
            road.take_calibration(kept[0])
            calibrated = _known(road, kept[0])
        else:
            start = 0.25
            if request.road.response is None:
                road.calibrate_response(subrange(progress, 0.0, 0.08))
                calibrated["response"] = response_found(road)
            road.calibrate_intrinsics(subrange(progress, 0.08, 0.1))
            road.calibrate_geometry(subrange(progress, 0.1, start))
            calibrated["geometry"] = geometry_found(road)
    due = time.monotonic() + _PARTIAL_S

    def partial(done: int, total: int, table: Callable[[], IsotropicTable]) -> None:
        nonlocal due
        begun = time.monotonic()
        state = None
        if begun >= due and done < total:
            # The first positions may see nothing that can be measured, so that there is no table yet.
            with contextlib.suppress(SuiteError):
                state = coverage_state(table())
            ended = time.monotonic()
            due = ended + max(_PARTIAL_S, (ended - begun) / _PARTIAL_SHARE)
        request.partial(done, total, state)

    acquired = reconstruct(road, subrange(progress, start, 0.98), work, partial, request.restart)
    report(progress, 0.99, tr("drawing the coverage"))
    return TableFound(acquired, coverage_state(acquired.table, acquired), calibrated)


def coverage_state(table: IsotropicTable, acquired: Any = None) -> CoverageState:
    """Return how a table is covered."""
    theta_h, theta_d, _ = table.grid.centres()
    coverage = table.coverage
    share = coverage_map(table)
    pixels = np.zeros_like(share) if coverage is None else np.asarray(coverage.samples.sum(axis=2).T, float)
    facts: tuple[tuple[str, str, str], ...] = ()
    if acquired is not None:
        measured = tr("{share:.1f} %").format(share=100.0 * covered_share(table, 75.0))
        tip = tr(
            "Share of the bins with light and view up to 75° from the normal; the others "
            "are filled from neighbours"
        )
        done, failed = len(acquired.positions_done), len(acquired.positions_failed)
        positions = tr("{done} of {total}").format(done=done, total=done + failed)
        facts = (
            (tr("Measured"), measured, tip),
            (tr("Readings"), thousands(int(acquired.readings)), tr("Pixels used for the table")),
            (tr("Positions"), positions, tr("Lamp positions")),
            *(("", tr_core(notice), "") for notice in acquired.notices),
        )
    return CoverageState(share, pixels, deviation_map(table), np.degrees(theta_h), np.degrees(theta_d), facts)


def save_table(request: tuple[Any, Path], _progress: Progress) -> tuple[str, ...]:
    """Write what was acquired to a file; that it may be overwritten was asked before."""
    from brdf_suite.acquisition.reconstruction.output import write_acquired

    return write_acquired(*request, overwrite=True)
