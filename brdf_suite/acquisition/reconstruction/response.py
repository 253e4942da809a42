"""The camera's response, from some positions of a session."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from brdf_suite.acquisition.radiance.dark_frame import black_codes
from brdf_suite.acquisition.reconstruction.photographs import SessionPhotographs
from brdf_suite.acquisition.reconstruction.source import first_readable
from brdf_suite.acquisition.response.fit import ResponseFit, calibrate_response
from brdf_suite.acquisition.response.response import Response, srgb_response
from brdf_suite.acquisition.response.samples import ResponseSamples, spread
from brdf_suite.progress import Progress, report, subrange

POSITIONS = 8
"""Spread over the arc; each holds millions of pixels, and all codes are seen in a few."""


@dataclass(frozen=True, eq=False)
class FoundResponse:
    """A response (None: the photographs are linear), how it was recovered, where it was, and figures of it."""

    response: Response | None
    fit: ResponseFit | None
    figures: Mapping[str, Any]


def find_response(photographs: SessionPhotographs, progress: Progress | None = None) -> FoundResponse:
    """Recover the response as the session and the options of ``photographs`` ask."""
    camera = photographs.session.camera
    kind = "linear" if photographs.options.response == "linear" else camera.response
    dark = photographs.series("dark")
    mask = photographs.mask(None)
    chosen = photographs.positions
    places = [chosen[place] for place in spread(len(chosen), POSITIONS)]
    # Codes of one exposure stand in one column, so positions that lack different photographs may not be mixed.
    by_times: dict[tuple[float, ...], ResponseSamples] = {}
    positions: Counter[tuple[float, ...]] = Counter()
    for n, k in enumerate(places):
        report(progress, 0.6 * n / len(places), "reading for the response")
        stack = photographs.readable(k)
        if stack is None and not by_times and n == len(places) - 1:
            stack = first_readable(photographs.stack, chosen)
        if stack is None:
            continue
        if stack.codes.dtype == np.float32:
            return FoundResponse(None, None, {"response": "photographs are linear (float files)"})
        times = tuple(float(time) for time in stack.exposures_s)
        if times not in by_times:
            by_times[times] = ResponseSamples(times, camera.bit_depth)
        by_times[times].add(stack.codes, mask)
        positions[times] += 1
    samples = by_times[max(by_times, key=lambda times: (positions[times], len(times)))]
    with photographs.clock.step("calibrate"):
        fit = calibrate_response(
            samples,
            None if dark is None else black_codes(dark.codes),
            linear=kind == "linear",
            known=srgb_response(camera.bit_depth) if kind == "srgb" else None,
            progress=subrange(progress, 0.6, 1.0),
        )
    found = "linear" if fit.response.linear else "recovered"
    figures = {
        "response": "sRGB, as the session states" if kind == "srgb" else found,
        "response_pixels": int(fit.pixels.min()),
        "largest_time_error": float(np.abs(np.expm1(fit.time_residuals)).max()),
    }
    return FoundResponse(fit.response, fit, figures)
