"""The steps of the road on a thread: response, geometry, table; what each found, and what its page shows of it."""

from __future__ import annotations

import contextlib
import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from brdf_qt.translation import tr

from brdf_designer.acquire.picture_tone import tones_of_linear
from brdf_designer.acquire.states import CoverageState, GeometryState, Problem, ResponseState
from brdf_designer.acquire.work_series import LONGEST_SIDE
from brdf_designer.acquire.workbench import WORK_FILE, RoadRequest
from brdf_suite.errors import FileError, SuiteError
from brdf_suite.progress import Progress, part, report

if TYPE_CHECKING:
    from brdf_suite.pipeline.acquiring import Acquisition
    from brdf_suite.reflectance.tabulated.isotropic import IsotropicTable

_PARTIAL_S = 2.0
_PARTIAL_SHARE = 0.1
"""Maps of what is covered so far: how long before the first, and the share of the time that they may take."""
_OUTLINE_POINTS = 361


@dataclass(frozen=True, eq=False)
class ResponseFound:
    """A response and what is shown of it; ``found`` is None for photographs that are linear files.

    ``kept``: taken from a work file, with the figures of the run that found it.
    """

    found: Any
    state: ResponseState | None
    kept: bool = False


@dataclass(frozen=True, eq=False)
class GeometryFound:
    """A calibration with its geometry, and what is shown of it; no ``state`` where it was taken from a work file."""

    found: Any
    state: GeometryState | None


@dataclass(frozen=True, eq=False)
class TableFound:
    """A table, what is shown of it, and what was calibrated on the way to it."""

    acquired: Any
    state: CoverageState
    response: ResponseFound | None
    geometry: GeometryFound | None


@dataclass(frozen=True)
class KeptWork:
    """What lies in the work file of a session: how many positions are done, and what they were calibrated with.

    ``reason`` says why what lies there cannot be gone on with; empty where it can.
    """

    done: int = 0
    response: ResponseFound | None = None
    geometry: GeometryFound | None = None
    reason: str = ""


def road_of(request: RoadRequest) -> Acquisition:
    """Take the road up where the request says."""
    from brdf_suite.pipeline.acquiring import Acquisition

    road = Acquisition.open(request.folder, request.options)
    if request.geometry is not None:
        road.take_calibration(request.geometry)
    elif request.response is not None:
        road.set_response(request.response.found)
    return road


def find_kept(request: RoadRequest, _progress: Progress) -> KeptWork:
    """Look what an earlier run has left."""
    from brdf_suite.pipeline.acquiring import Acquisition
    from brdf_suite.pipeline.acquiring_table import kept_calibration
    from brdf_suite.pipeline.acquiring_work import POSITION, open_work

    work = request.folder / WORK_FILE
    if not work.exists():
        return KeptWork()
    try:
        road = Acquisition.open(request.folder, request.options)
        calibration = kept_calibration(road, work)
        with open_work(work) as kept:
            done = {record.values["position"] for record in kept.records if record.tag == POSITION}
        if calibration is None:
            return KeptWork()
        road.take_calibration(calibration)
    except FileError as error:
        return KeptWork(reason=str(error))
    return KeptWork(len(done), replace(response_found(road), kept=True), GeometryFound(calibration, None))


def find_response(request: RoadRequest, progress: Progress) -> ResponseFound:
    """Find the response of the camera."""
    from brdf_suite.pipeline.acquiring import Acquisition

    road = Acquisition.open(request.folder, request.options)
    road.calibrate_response(progress)
    return response_found(road)


def response_found(road: Acquisition) -> ResponseFound:
    """Return what a road knows of the response."""
    response, fit = road.response, road.response_fit
    if response is None:
        return ResponseFound(None, None)
    facts = [
        (tr("Bits"), f"{response.bit_depth}", tr("Of a code")),
        (tr("Black"), _each(response.black, "{:.1f}"), tr("The code without light, per channel")),
        (
            tr("Trusted"),
            tr("codes {low} to {high}").format(
                low=int(response.lowest.max()), high=int(response.highest.min())
            ),
            tr("Codes between which the response was measured in every channel"),
        ),
        (
            tr("Read noise"),
            _each(100.0 * response.read, "{:.3f}", " %"),
            tr("Standard deviation in the dark, of the full scale of a linear camera"),
        ),
    ]
    times: tuple[tuple[float, float], ...] = ()
    if fit is not None:
        off = np.expm1(np.asarray(fit.time_residuals, float))
        stated = np.asarray(road.session.exposures_s[: len(off)], float)
        times = tuple(zip(stated.tolist(), off.tolist(), strict=True))
        facts += [
            (
                tr("Times"),
                tr("within {worst:.2f} %").format(worst=100.0 * float(np.abs(off).max())),
                tr("Largest difference between a stated exposure time and what the photographs say"),
            ),
            (
                tr("From linear"),
                _each(100.0 * np.asarray(fit.linear_rms), "{:.1f}", " %"),
                tr("RMS distance of the curve from a straight line, in the logarithm of the exposure"),
            ),
            (tr("Pixels"), _thousands(int(np.sum(fit.pixels))), tr("That took part")),
            (tr("Iterations"), str(fit.iterations), tr("Until nothing changed any more")),
        ]
    state = ResponseState(
        np.asarray(response.exposure, float),
        np.asarray(response.lowest),
        np.asarray(response.highest),
        tuple(facts),
        times,
        bool(response.linear),
    )
    return ResponseFound(response, state)


@dataclass(frozen=True, eq=False)
class GeometryAnswer:
    """A geometry, and the response where that had to be found first."""

    geometry: GeometryFound
    response: ResponseFound | None


def find_geometry(request: RoadRequest, progress: Progress) -> GeometryAnswer:
    """Find sphere and lamp; the response first, where it is not known."""
    road = road_of(replace(request, geometry=None))
    response = None
    start = 0.0
    if request.response is None:
        road.calibrate_response(part(progress, 0.0, 0.3))
        response, start = response_found(road), 0.3
    road.calibrate_intrinsics(part(progress, start, start + 0.05))
    road.calibrate_geometry(part(progress, start + 0.05, 1.0))
    return GeometryAnswer(geometry_found(road), response)


def geometry_found(road: Acquisition) -> GeometryFound:
    """Return what a road knows of the geometry."""
    geometry, outline, refinement, union = road.geometry, road.outline, road.refinement, road.union
    assert geometry is not None
    if union is None or outline is None:
        return GeometryFound(road.calibration, None)
    facts: list[tuple[str, str, str]] = [
        (
            tr("Outline"),
            tr("{rms:.3f} px RMS").format(rms=outline.rms_px),
            tr("Root mean square distance of the edge that was seen from the outline that was fitted"),
        )
    ]
    parameters: list[tuple[str, str, str]] = []
    angles = np.asarray(geometry.angles_deg)
    if refinement is not None:
        found, off = refinement.pixels, refinement.residuals_px
        seen = angles[refinement.positions]
        facts += [
            (
                tr("Highlights"),
                tr("{px:.3f} px, {deg:.4f}° RMS").format(px=refinement.rms_px, deg=refinement.rms_deg),
                tr("What is left between found and expected highlights after the refinement"),
            ),
            (
                tr("Before"),
                tr("{px:.3f} px, {deg:.4f}° RMS").format(px=refinement.before_px, deg=refinement.before_deg),
                tr("The same with the numbers of session.json"),
            ),
            (
                tr("Used"),
                tr("{used} of {count} highlights").format(
                    used=int((~refinement.outliers).sum()), count=len(refinement.outliers)
                ),
                tr("The others do not belong: a second reflection, or the arm"),
            ),
        ]
        parameters = [_refined(row) for row in refinement.parameters if row.observed > 0.005]
    else:
        seen = np.array([angles[h.position] for h in road.highlights])
        found = np.array([h.pixel for h in road.highlights], float).reshape(-1, 2)
        off = found - geometry.highlights(seen) if len(seen) else found
    step = max(1, -(-max(union.shape) // LONGEST_SIDE))
    around = geometry.outline(np.linspace(0.0, 2.0 * np.pi, _OUTLINE_POINTS))
    scaled = lambda places: (np.asarray(places, float) + 0.5) / step - 0.5  # noqa: E731 - one line, used four times
    rig = [
        (
            tr("Sphere"),
            "{:.1f}, {:.1f} px".format(*np.mean(around[:-1], axis=0)),
            tr("Middle of its outline, column and row"),
        ),
        (
            tr("Distance"),
            tr("{distance:.1f} mm").format(distance=1e3 * float(np.linalg.norm(geometry.centre_m))),
            tr("From the camera to the centre of the sphere"),
        ),
    ]
    lens_rms = road.calibration.figures.get("lens_rms_px")
    if lens_rms is not None:
        rig.append(
            (
                tr("Lens"),
                tr("{rms:.3f} px RMS").format(rms=float(lens_rms)),
                tr("Distance of the board's corners from where the calibrated camera expects them"),
            )
        )
    state = GeometryState(
        tones_of_linear(np.asarray(union)[::step, ::step]),
        scaled(outline.points),
        np.asarray(outline.used),
        scaled(around),
        scaled(found),
        scaled(found - off),
        seen,
        np.hypot(off[:, 0], off[:, 1]),
        np.zeros(len(seen)) if refinement is None else np.asarray(refinement.residuals_deg),
        np.zeros(len(seen), bool) if refinement is None else np.asarray(refinement.outliers),
        (*facts, *rig),
        tuple(parameters),
        tuple(Problem("warning", "", notice) for notice in road.notices),
    )
    return GeometryFound(road.calibration, state)


def _refined(row: Any) -> tuple[str, str, str]:
    """A refined number with its uncertainty; metres as millimetres."""
    scale, unit, form = (1e3, " mm", "{:.2f}") if row.unit == "m" else (1.0, "°", "{:.3f}")
    found, sigma, stated = (
        form.format(scale * number).replace("-", "−") for number in (row.value, row.sigma, row.stated)
    )
    if not any(digit in "123456789" for digit in stated):
        stated = stated.lstrip("−")
    value = tr("{value} ± {sigma}\nstated {stated}").format(
        value=found, sigma=sigma + unit, stated=stated + unit
    )
    told = tr("The highlights tell {share:.0f} % of it: {why}").format(
        share=100.0 * row.observed, why=row.why
    )
    return row.name, value, told


@dataclass(frozen=True)
class TableRequest:
    """The road, whether to begin anew, and who hears of what is covered so far (from the thread)."""

    road: RoadRequest
    restart: bool
    partial: Callable[[int, int, CoverageState | None], None]


def find_table(request: TableRequest, progress: Progress) -> TableFound:
    """Make the table; response and geometry first, where they are not known. What is done is kept in the folder."""
    from brdf_suite.pipeline.acquiring_table import kept_calibration

    road = road_of(request.road)
    work = request.road.folder / WORK_FILE
    response = geometry = None
    start = 0.0
    if request.road.geometry is None:
        kept = None if request.restart else kept_calibration(road, work)
        if kept is not None:
            road.take_calibration(kept)
            response, geometry = replace(response_found(road), kept=True), GeometryFound(kept, None)
        else:
            start = 0.25
            if request.road.response is None:
                road.calibrate_response(part(progress, 0.0, 0.08))
                response = response_found(road)
            road.calibrate_intrinsics(part(progress, 0.08, 0.1))
            road.calibrate_geometry(part(progress, 0.1, start))
            geometry = geometry_found(road)
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

    acquired = road.table(part(progress, start, 0.98), work, partial, request.restart)
    report(progress, 0.99, tr("drawing the coverage"))
    return TableFound(acquired, coverage_state(acquired.table, acquired), response, geometry)


def coverage_state(table: IsotropicTable, acquired: Any = None) -> CoverageState:
    """Return how a table is covered."""
    from brdf_suite.pipeline.acquiring_coverage import coverage_map, covered_share, deviation_map

    theta_h, theta_d, _ = table.grid.centres()
    coverage = table.coverage
    share = coverage_map(table)
    pixels = np.zeros_like(share) if coverage is None else np.asarray(coverage.samples.sum(axis=2).T, float)
    facts: list[tuple[str, str, str]] = []
    if acquired is not None:
        facts = [
            (
                tr("Measured"),
                tr("{share:.1f} %").format(share=100.0 * covered_share(table, 75.0)),
                tr(
                    "Of the bins with light and view up to 75° from the normal; the others are filled from neighbours"
                ),
            ),
            (tr("Readings"), _thousands(int(acquired.readings)), tr("Pixels that went into the table")),
            (
                tr("Positions"),
                tr("{done} of {total}").format(
                    done=len(acquired.positions_done),
                    total=len(acquired.positions_done) + len(acquired.positions_failed),
                ),
                tr("Of the lamp"),
            ),
            *(("", notice, "") for notice in acquired.notices),
        ]
    return CoverageState(
        share,
        pixels,
        deviation_map(table),
        np.degrees(theta_h),
        np.degrees(theta_d),
        tuple(facts),
    )


@dataclass(frozen=True, eq=False)
class SaveTable:
    """A table, and where it is to be."""

    acquired: Any
    path: Path


def save_table(request: SaveTable, _progress: Progress) -> tuple[str, ...]:
    """Write the table; that the file may be overwritten was asked before."""
    from brdf_suite.pipeline.acquiring_output import write_acquired

    return write_acquired(request.acquired, request.path, overwrite=True)


def _each(values: Any, form: str, unit: str = "") -> str:
    """Return numbers per channel, one where they read the same."""
    texts = [form.format(float(value)) for value in np.atleast_1d(values)]
    return (texts[0] if len(set(texts)) == 1 else ", ".join(texts)) + unit


def _thousands(count: int) -> str:
    return f"{count:,}".replace(",", "\u202f")
