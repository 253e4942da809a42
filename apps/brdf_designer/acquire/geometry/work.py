"""Sphere and lamp, found on a thread, and what their page shows of them."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
from brdf_qt.program.core_texts import tr_core
from brdf_qt.program.translation import decimal, tr
from numpy.typing import ArrayLike, NDArray

from brdf_designer.acquire.camera_response.work import open_session, response_found
from brdf_designer.acquire.plots.tone import LONGEST_SIDE, tones_of_linear
from brdf_designer.acquire.reconstruction.session import StepRequest
from brdf_designer.acquire.states import Found, GeometryState, Problem
from brdf_suite.progress import Progress, subrange

if TYPE_CHECKING:
    from brdf_suite.acquisition.reconstruction.reconstruction import Acquisition

_OUTLINE_POINTS = 361


def open_acquisition(request: StepRequest) -> Acquisition:
    """Take the road up where the request says."""
    road = open_session(request)
    if request.geometry is not None:
        road.take_calibration(request.geometry)
    elif request.response is not None:
        road.set_response(request.response.found)
    return road


def find_geometry(request: StepRequest, progress: Progress) -> dict[str, Found]:
    """Find sphere and lamp; the response first, and returned too, where it is not known."""
    road = open_acquisition(replace(request, geometry=None))
    found: dict[str, Found] = {}
    start = 0.0
    if request.response is None:
        road.calibrate_response(subrange(progress, 0.0, 0.3))
        found["response"], start = response_found(road), 0.3
    road.calibrate_intrinsics(subrange(progress, start, start + 0.05))
    road.calibrate_geometry(subrange(progress, start + 0.05, 1.0))
    return found | {"geometry": geometry_found(road)}


def geometry_found(road: Acquisition) -> Found:
    """Return what a road knows of the geometry."""
    geometry, outline, refinement, union = road.geometry, road.outline, road.refinement, road.union
    assert geometry is not None
    if union is None or outline is None:
        return Found(road.calibration, None)
    facts: list[tuple[str, str, str]] = [
        (
            tr("Outline"),
            tr("{rms:.3f} px RMS").format(rms=outline.rms_px),
            tr("Root mean square distance of the detected edge from the fitted outline"),
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
                tr("Distance of found from expected highlights after the refinement"),
            ),
            (
                tr("Before"),
                tr("{px:.3f} px, {deg:.4f}° RMS").format(px=refinement.before_px, deg=refinement.before_deg),
                tr("Residuals before the refinement, with the values of session.json"),
            ),
            (
                tr("Used"),
                tr("{used} of {count} highlights").format(
                    used=int((~refinement.outliers).sum()), count=len(refinement.outliers)
                ),
                tr("The others are outliers, such as a second reflection or the arm"),
            ),
        ]
        parameters = [_refined(row) for row in refinement.parameters if row.observed > 0.005]
    else:
        seen = np.array([angles[h.position] for h in road.highlights])
        found = np.array([h.pixel for h in road.highlights], float).reshape(-1, 2)
        off = found - geometry.highlights(seen) if len(seen) else found
    step = max(1, -(-max(union.shape) // LONGEST_SIDE))
    around = geometry.outline(np.linspace(0.0, 2.0 * np.pi, _OUTLINE_POINTS))

    def scaled(places: ArrayLike) -> NDArray[np.float64]:
        result: NDArray[np.float64] = (np.asarray(places, np.float64) + 0.5) / step - 0.5
        return result

    middle = np.mean(around[:-1], axis=0)
    rig = [
        (
            tr("Sphere"),
            tr("{column:.1f}, {row:.1f} px").format(column=middle[0], row=middle[1]),
            tr("Centre of its outline: column and row"),
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
                tr(
                    "Distance of the corners of the board from the positions that the calibrated "
                    "camera predicts"
                ),
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
    return Found(road.calibration, state)


def _refined(row: Any) -> tuple[str, str, str]:
    """A refined number with its uncertainty; metres as millimetres."""
    scale, unit, form = (1e3, " mm", "{:.2f}") if row.unit == "m" else (1.0, "°", "{:.3f}")
    found, sigma, stated = (
        decimal(form.format(scale * number)).replace("-", "−")
        for number in (row.value, row.sigma, row.stated)
    )
    if not any(digit in "123456789" for digit in stated):
        stated = stated.lstrip("−")
    value = tr("{value} ± {sigma}\nstated {stated}").format(
        value=found, sigma=sigma + unit, stated=stated + unit
    )
    share = tr("The highlights determine {share:.0f} % of it: {why}").format(
        share=100.0 * row.observed, why=tr_core(row.why)
    )
    return tr_core(row.name), value, share
