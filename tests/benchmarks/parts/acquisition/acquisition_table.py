"""The table of a simulated rig: how near it is to the paint, and what the reconstruction takes.

Called by bench_acquisition.py. The error is the median over the table's measured bins with θi and θo below 75°, the
channels' mean against the paint at the bins' centres.
"""

from __future__ import annotations

import json
import subprocess
import sys

import numpy as np

from brdf_suite.acquisition.reconstruction.geometry import highlight_positions, union_positions
from brdf_suite.acquisition.reconstruction.options import AcquireOptions, covered_share, within
from brdf_suite.acquisition.reconstruction.reconstruction import RESPONSE_POSITIONS, Acquisition
from brdf_suite.acquisition.reconstruction.table import Acquired, reconstruct
from brdf_suite.acquisition.simulator import Simulator, SimulatorSettings
from brdf_suite.errors import SuiteError
from brdf_suite.progress import Progress, report, subrange
from brdf_suite.reflectance.models.cook_torrance import CookTorrance
from brdf_suite.reflectance.models.table_1 import TABLE_1
from brdf_suite.reflectance.protocol import Reflectance
from tools.evaluation.simulated_source import SimulatorSource

#: key: (comparison, bound, unit, meaning)
BOUNDS: dict[str, tuple[str, float | None, str, str]] = {
    "table_median_error": (
        "<=",
        0.03,
        "",
        "simulated rig, 180 positions × 16 exposures, 12 bit, noise, unknown response: median relative error of "
        "measured bins below 75°",
    ),
    "table_p95_error": ("<=", None, "", "the same, 95th percentile"),
    "table_filled_error": ("<=", None, "", "median relative error of filled bins, below 75°"),
    "table_covered": (">=", None, "", "share of measured bins below 75°"),
    "table_linear_error": ("<=", None, "", "θh < 3°, filled and interpolated: median error of linear θh"),
    "table_traditional_error": ("<=", None, "", "the same for θi, θo, Δφ"),
    "table_half_angle_error": ("<=", None, "", "the same for the stored layout"),
    "reconstruct_s": ("<=", 300.0, "s", "1024 × 1024 × 16 × 180, after decoding"),
    "reconstruct_memory_mb": (
        "<=",
        3072.0,
        "MB",
        "peak resident size of that process, including the simulator",
    ),
}
NOTES: dict[str, str] = {}

PAINT = "table1_polaris_silver"
SIZE = (320, 320)
POSITIONS = 180
LIMIT_DEG = 75.0
LARGE = (1024, 1024)
TIMED_POSITIONS = 12


def figures(progress: Progress | None = None) -> dict[str, float | None]:
    """Measure; two minutes on two quiet cores, most of it the simulator's."""
    truth = CookTorrance(TABLE_1[PAINT])
    rig = Simulator(truth, SimulatorSettings(size=SIZE, positions=POSITIONS, board=False), PAINT)
    road = Acquisition(SimulatorSource(rig), AcquireOptions(compare=True))
    road.calibrate(subrange(progress, 0.0, 0.2))
    found = reconstruct(road, subrange(progress, 0.2, 0.7))
    errors, holes = bin_errors(found, truth), np.asarray(found.table.holes)
    there = ~np.isnan(errors)
    answer: dict[str, float | None] = {
        "table_median_error": float(np.median(errors[there & ~holes])),
        "table_p95_error": float(np.percentile(errors[there & ~holes], 95)),
        "table_filled_error": float(np.median(errors[there & holes])),
        "table_covered": covered_share(found.table, LIMIT_DEG),
    }
    NOTES["table_median_error"] = f"{SIZE[0]} × {SIZE[1]} pixels, {found.readings:,} readings"
    answer |= _peak_errors(found, truth)
    report(progress, 0.7, "1024 × 1024")
    answer |= _timed()
    return answer


def bin_errors(found: Acquired, truth: Reflectance) -> np.ndarray:
    """Return relative errors (θh, θd, φd), channels' mean; NaN beyond the limit."""
    table = found.table
    errors = np.full(table.values.shape[:3], np.nan)
    there = within(table, LIMIT_DEG)
    for h in range(table.grid.theta_h):
        wi, wo = table.grid.pairs(h)
        wanted = truth.eval(wi[there[h]], wo[there[h]])
        errors[h][there[h]] = np.abs(table.values[h][there[h]] / wanted - 1.0).mean(axis=1)
    return errors


def _peak_errors(found: Acquired, truth: Reflectance) -> dict[str, float]:
    """Return how near each layout of Figure 4 is about the highlight, between its bins as a picture sees it."""
    rng = np.random.default_rng(1)
    n = 20_000
    polar, turn = np.radians(rng.uniform(10.0, 60.0, n)), rng.uniform(0.0, 2.0 * np.pi, n)
    wi = np.stack((np.sin(polar), np.zeros(n), np.cos(polar)), axis=1)
    off = np.radians(3.0) * np.sqrt(rng.random(n))
    half = np.stack((np.sin(off) * np.cos(turn), np.sin(off) * np.sin(turn), np.cos(off)), axis=1)
    wo = 2.0 * (wi * half).sum(axis=1)[:, None] * half - wi
    wanted = truth.eval(wi, wo)
    tables = {"half_angle": found.table, **found.compared}
    return {
        f"table_{name}_error": float(np.median(np.abs(table.eval(wi, wo) / wanted - 1.0)))
        for name, table in tables.items()
    }


def _timed() -> dict[str, float | None]:
    """Run :func:`timed` in a process of its own, whose memory is its own."""
    done = subprocess.run([sys.executable, __file__], capture_output=True, text=True, check=False)
    if done.returncode:
        raise SuiteError(f"The timed reconstruction failed: {done.stderr.strip().splitlines()[-1:]}")
    timings = json.loads(done.stdout)
    NOTES["reconstruct_s"] = (
        f"{TIMED_POSITIONS} positions measured, scaled to 180 and the {timings['before']} that the calibration reads"
    )
    NOTES["reconstruct_memory_mb"] = (
        f"{TIMED_POSITIONS} positions; only sums of positions are kept, and at most 600 MB for calibration"
    )
    return {"reconstruct_s": timings["seconds"], "reconstruct_memory_mb": timings["memory_mb"]}


def timed() -> dict[str, float]:
    """Reconstruct :data:`TIMED_POSITIONS` positions of 1024 × 1024 and reckon the time of 180."""
    import resource

    truth = CookTorrance(TABLE_1[PAINT])
    rig = Simulator(truth, SimulatorSettings(size=LARGE, positions=TIMED_POSITIONS, board=False), PAINT)
    road = Acquisition(SimulatorSource(rig))
    road.calibrate()
    calibrated = dict(road.clock.seconds)
    road.clock.seconds.clear()
    found = reconstruct(road)
    steps = found.seconds
    angles = tuple(180.0 * k / POSITIONS for k in range(POSITIONS))
    every = tuple(range(POSITIONS))
    before = len({*highlight_positions(angles, every), *union_positions(angles, every)})
    merge = steps["merge"] / TIMED_POSITIONS
    seconds = calibrated["calibrate"] + merge * (POSITIONS + before)
    seconds += steps["samples"] / TIMED_POSITIONS * POSITIONS
    seconds += steps["finish"] + steps["table"] / TIMED_POSITIONS * POSITIONS
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024.0
    return {
        "seconds": seconds,
        "memory_mb": memory,
        "before": before + RESPONSE_POSITIONS,
    }


if __name__ == "__main__":
    print(json.dumps(timed()))
