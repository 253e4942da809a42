"""The response of the camera, found on a thread, and what its page shows of it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from brdf_qt.program.translation import decimal, point, tr

from brdf_designer.acquire.reconstruction.session import StepRequest
from brdf_designer.acquire.states import Found, ResponseState
from brdf_suite.progress import Progress

if TYPE_CHECKING:
    from brdf_suite.acquisition.reconstruction.reconstruction import Acquisition


def open_session(request: StepRequest) -> Acquisition:
    """Begin the reconstruction, without what earlier steps found."""
    from brdf_suite.acquisition.reconstruction.reconstruction import Acquisition

    return Acquisition.open(request.folder, request.options)


def find_response(request: StepRequest, progress: Progress) -> Found:
    """Find the response of the camera."""
    road = open_session(request)
    road.calibrate_response(progress)
    return response_found(road)


def response_found(road: Acquisition) -> Found:
    """Return what a road knows of the response."""
    response, fit = road.response, road.response_fit
    if response is None:
        return Found(None, None)
    facts = [
        (tr("Bits"), f"{response.bit_depth}", tr("Bits per code")),
        (tr("Black"), _each(response.black, "{:.1f}"), tr("Code without light, per channel")),
        (
            tr("Reliable"),
            tr("codes {low} to {high}").format(
                low=int(response.lowest.max()), high=int(response.highest.min())
            ),
            tr("Codes between which the response was measured in every channel"),
        ),
        (
            tr("Read noise"),
            _each(100.0 * response.read, "{:.3f}", " %"),
            tr("Standard deviation in the dark, relative to the full scale of a linear camera"),
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
                tr("Largest difference between a stated exposure time and its estimate from the photographs"),
            ),
            (
                tr("Nonlinearity"),
                _each(100.0 * np.asarray(fit.linear_rms), "{:.1f}", " %"),
                tr("RMS distance of the curve from a straight line, in the logarithm of the exposure"),
            ),
            (tr("Pixels"), thousands(int(np.sum(fit.pixels))), tr("Photographs that were used")),
            (tr("Iterations"), str(fit.iterations), tr("Iterations until convergence")),
        ]
    state = ResponseState(
        np.asarray(response.exposure, float),
        np.asarray(response.lowest),
        np.asarray(response.highest),
        tuple(facts),
        times,
        bool(response.linear),
    )
    return Found(response, state)


def _each(values: Any, form: str, unit: str = "") -> str:
    """Return numbers per channel, one where they read the same."""
    texts = [decimal(form.format(float(value))) for value in np.atleast_1d(values)]
    between = ", " if point() == "." else "; "
    return (texts[0] if len(set(texts)) == 1 else between.join(texts)) + unit


def thousands(count: int) -> str:
    """Return a count in groups of three digits."""
    return decimal(f"{count:,}")
