"""The response of a simulated camera recovered from its photographs, and its exposures merged: figures of both.

Called by bench_acquisition.py. Free values by turns, as Robertson, Borman and Stevenson (2003) give it, and OpenCV's
``CalibrateRobertson`` stand beside ours: what they lack is measured here.
"""

from __future__ import annotations

from dataclasses import dataclass
from time import perf_counter

import numpy as np

from brdf_suite.acquisition.radiance.merge import CLIPPED, GOOD, merge
from brdf_suite.acquisition.radiance.sensor_maps import black_codes, dark_model
from brdf_suite.acquisition.response.fit import ResponseFit, calibrate_response
from brdf_suite.acquisition.response.response import middle_code
from brdf_suite.acquisition.response.samples import ResponseSamples, spread
from brdf_suite.acquisition.simulator import Simulator, SimulatorSettings
from brdf_suite.progress import Progress, report
from brdf_suite.reflectance.models.cook_torrance import CookTorrance
from brdf_suite.reflectance.models.table_1 import TABLE_1

#: key: (comparison, bound, unit, meaning)
BOUNDS: dict[str, tuple[str, float | None, str, str]] = {
    "response_rms": (
        "<=",
        0.02,
        "",
        "simulated rig: camera response, RMS of ln exposure over codes 1 … 98 % of full scale, worst channel",
    ),
    "response_8_bit_rms": ("<=", None, "", "the same for 8-bit photographs"),
    "response_8_bit_opencv_rms": ("<=", None, "", "OpenCV's CalibrateRobertson on the same 8-bit pixels"),
    "response_by_turns_rms": (
        "<=",
        None,
        "",
        "12-bit pixels by Robertson's iteration, one free value per code",
    ),
    "merge_s": ("<=", None, "s", "merging 16 exposures of 1024 × 1024 RGB, 16-bit files, best of 5"),
    "merge_variance_ratio": (
        "<=",
        None,
        "",
        "mean square error of merged radiances over their stated variance",
    ),
}
NOTES: dict[str, str] = {}

PAINT = "table1_polaris_silver"
SIZE = (256, 256)
POSITIONS = 8
LOW, HIGH = 0.01, 0.98
_MERGED = 1024
_TURNS = 60
_OPENCV_PIXELS = 40_000


@dataclass
class Recovered:
    """One recovery beside the truth: exposures (3, codes) of both, at the gauge."""

    fit: ResponseFit
    samples: ResponseSamples
    truth: np.ndarray
    black: float

    def rms(self, exposure: np.ndarray) -> float:
        """Return the worst channel's RMS of ln(exposure / truth), scale left out, codes LOW … HIGH."""
        scale = exposure.shape[1] - 1 - self.black
        run = slice(int(self.black + LOW * scale), int(self.black + HIGH * scale))
        apart = np.log(np.maximum(exposure[:, run], 1e-12) / self.truth[:, run])
        return float(np.sqrt(np.mean((apart - apart.mean(axis=1, keepdims=True)) ** 2, axis=1)).max())


def recovered(bits: int, curve: str = "film", paint: str = PAINT) -> Recovered:
    """Recover the response of a simulated rig of the stated curve from 8 of its 180 positions."""
    settings = SimulatorSettings(size=SIZE, curve=curve, bit_depth=bits)  # type: ignore[arg-type] # one of its words
    rig = Simulator(CookTorrance(TABLE_1[paint]), settings, paint)
    samples = ResponseSamples(settings.exposures_s(), bits)
    for k in spread(180, POSITIONS):
        samples.add(rig.position(k))
    fit = calibrate_response(samples, black_codes(rig.dark()))
    return Recovered(fit, samples, true_exposures(rig), float(rig.sensor.black))


def true_exposures(rig: Simulator) -> np.ndarray:
    """Return (3, codes) the exposure of each code, at the gauge, from the simulated camera's own curve."""
    from brdf_suite.acquisition.simulator.sensor import curve_table

    codes = 1 << rig.settings.bit_depth
    share = (np.arange(codes) - rig.sensor.black) / (codes - 1 - rig.sensor.black)
    filling = np.linspace(0.0, 1.0, curve_table(rig.settings.curve).shape[1])
    table = np.stack([np.interp(share, row, filling) for row in curve_table(rig.settings.curve)])
    return table * (0.5 / table[:, [middle_code(rig.settings.bit_depth)]])


def by_turns(samples: ResponseSamples, turns: int = _TURNS) -> np.ndarray:
    """Return (3, codes) Robertson's response: radiances and one value for each code, by turns, from a line on."""
    size = 1 << samples.bit_depth
    weight = np.exp(-16.0 * (np.arange(size) / (size - 1) - 0.5) ** 2)
    weight[[0, size - 1]] = 0.0
    answer = np.empty((samples.channels, size))
    for c in range(samples.channels):
        codes = samples.codes(c)
        curve = np.arange(size) / size
        counts = np.bincount(codes.ravel(), minlength=size)
        for _ in range(turns):
            part = weight[codes]
            radiance = (part * samples.times * curve[codes]).sum(axis=1) / (part * samples.times**2).sum(
                axis=1
            )
            sums = np.bincount(codes.ravel(), (samples.times * radiance[:, None]).ravel(), minlength=size)
            curve = np.divide(sums, counts, out=curve.copy(), where=counts > 0)
            curve *= 0.5 / curve[size // 2]
        answer[c] = curve
    return answer


def by_opencv(samples: ResponseSamples) -> np.ndarray | None:
    """Return (3, 256) what OpenCV's CalibrateRobertson finds, None where OpenCV is not installed."""
    try:
        import cv2
    except ImportError:
        return None
    count = min(_OPENCV_PIXELS, *(len(samples.codes(c)) for c in range(samples.channels)))
    random = np.random.default_rng(0)
    chosen = [samples.codes(c)[random.choice(len(samples.codes(c)), count, replace=False)] for c in range(3)]
    stack = np.stack(chosen, axis=-1).astype(np.uint8)  # (p, n, 3)
    pictures = [np.ascontiguousarray(stack[:, None, i]) for i in range(len(samples.times))]
    found = cv2.createCalibrateRobertson().process(pictures, times=samples.times.astype(np.float32))
    curve = np.asarray(found, float).reshape(256, 3).T
    return curve * (0.5 / curve[:, [128]])


def figures(progress: Progress | None = None) -> dict[str, float]:
    """Measure everything of the module."""
    report(progress, 0.0, "response, 12 bit")
    twelve = recovered(12)
    found = {"response_rms": twelve.rms(twelve.fit.response.exposure)}
    NOTES["response_rms"] = (
        f"{int(twelve.fit.pixels.min()):,} pixels a channel of {POSITIONS} positions, {twelve.fit.iterations} steps"
    )
    found["response_by_turns_rms"] = twelve.rms(by_turns(twelve.samples))
    NOTES["response_by_turns_rms"] = f"{_TURNS} turns"
    report(progress, 0.4, "response, 8 bit")
    eight = recovered(8)
    found["response_8_bit_rms"] = eight.rms(eight.fit.response.exposure)
    opencv = by_opencv(eight.samples)
    if opencv is None:
        NOTES["response_8_bit_opencv_rms"] = "OpenCV is not installed"
    else:
        found["response_8_bit_opencv_rms"] = eight.rms(opencv)
        NOTES["response_8_bit_opencv_rms"] = "supports 8 bits only"
    report(progress, 0.7, "merge")
    found |= merging()
    return found


def merging() -> dict[str, float]:
    """Measure the merge of a large position, and whether its variances are true."""
    settings = SimulatorSettings(size=(_MERGED, _MERGED), gain_spread=0.0, vignetting=0.0, curve="linear")
    rig = Simulator(CookTorrance(TABLE_1[PAINT]), settings, PAINT)
    times = settings.exposures_s()
    samples = ResponseSamples(times, 12)
    stack, dark_stack = rig.position(60), rig.dark()
    samples.add(stack)
    response = calibrate_response(samples, black_codes(dark_stack)).response
    dark = dark_model(dark_stack, times, response)
    taken = []
    for _ in range(6):
        start = perf_counter()
        merged = merge(stack, times, response, dark=dark)
        taken.append(perf_counter() - start)
    truth = rig.radiance(60)
    measured = (merged.state == GOOD) & (truth > 0.0)
    error = (merged.radiance - truth)[measured].astype(float) ** 2 / merged.variance[measured]
    NOTES["merge_variance_ratio"] = (
        f"{int(measured.sum()):,} values, {int((merged.state == CLIPPED).sum())} clipped in all exposures"
    )
    # The first one also compiles.
    return {"merge_s": min(taken[1:]), "merge_variance_ratio": float(error.mean())}
