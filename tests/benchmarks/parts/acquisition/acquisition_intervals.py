"""Coverage of the stated 95 % intervals of Cook-Torrance fits, on tables that a simulated rig acquires.

Called by bench_acquisition.py. Each table is a paint of Table 1, photographed by a simulated rig with noise and an
unknown response, reconstructed and fitted; an interval holds where the paint's own parameter lies within 1.96 standard
errors of the fitted one. Two hours on two quiet cores; a few tables, with what was found of each, by

    python tests/benchmarks/parts/acquisition/acquisition_intervals.py --tables 3
"""

from __future__ import annotations

import argparse
import itertools
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from brdf_suite.acquisition.reconstruction.reconstruction import Acquisition
from brdf_suite.acquisition.reconstruction.table import reconstruct
from brdf_suite.acquisition.simulator import Simulator, SimulatorSettings
from brdf_suite.documents.cook_torrance import CookTorrancePaint
from brdf_suite.fitting.cook_torrance import CookTorranceFit, Settings, fit_checked_samples
from brdf_suite.fitting.cook_torrance.samples import samples_of
from brdf_suite.fitting.cook_torrance.uncertainty import SIGMAS
from brdf_suite.progress import Progress, report
from brdf_suite.reflectance.models.cook_torrance import CookTorrance
from brdf_suite.reflectance.models.table_1 import TABLE_1
from tools.evaluation.simulated_source import SimulatorSource

COUNT = 200
SIZES = (128, 160, 192, 256, 320)
POSITIONS = 60
LEAST_HEIGHT = 0.002
"""Lobes of less ks·4r, in their brightest channel, are not judged."""
FEWEST = 20
"""Stated intervals of one parameter below which its own share says nothing."""

#: key: (comparison, bound, unit, meaning)
BOUNDS: dict[str, tuple[str, float | None, str, str]] = {
    "interval_coverage": (
        ">=",
        0.90,
        "",
        f"{COUNT} tables of simulated rigs, 128² to 320² pixels: share of the stated 95 % intervals of Cook-Torrance "
        "fits that hold the truth, all parameters together",
    ),
    "interval_coverage_worst": (">=", 0.80, "", "the same, of the parameter with the lowest share"),
}
NOTES: dict[str, str] = {}
SHARES: dict[str, object] = {}
"""Of each parameter."""
TABLES: dict[str, dict[str, object]] = {"interval_coverage": SHARES}


@dataclass(frozen=True)
class Interval:
    """A parameter's value and standard error, NaN where the fit states none, beside the truth."""

    parameter: str
    value: float
    error: float
    truth: float

    @property
    def holds(self) -> bool | None:
        """Whether the stated interval holds the truth; None where none is stated."""
        return abs(self.value - self.truth) <= SIGMAS * self.error if np.isfinite(self.error) else None


def cases(count: int) -> Iterator[tuple[str, int, int]]:
    """Yield paints, sizes of the photographs and seeds of the noise: all paints and sizes, then with another seed."""
    every = ((name, size, seed) for seed in itertools.count() for size in SIZES for name in TABLE_1)
    return itertools.islice(every, count)


def fit_of_rig(name: str, size: int, seed: int) -> CookTorranceFit:
    """Return the fit to the table of a simulated rig."""
    settings = SimulatorSettings(size=(size, size), positions=POSITIONS, board=False, seed=seed)
    road = Acquisition(SimulatorSource(Simulator(CookTorrance(TABLE_1[name]), settings, name)))
    road.calibrate()
    chosen = Settings(lobes=len(TABLE_1[name].lobes))
    return fit_checked_samples(samples_of(reconstruct(road).table, chosen), chosen)


def intervals(truth: CookTorrancePaint, fit: CookTorranceFit) -> list[Interval]:
    """Return the intervals of a fit, each true lobe beside the fitted one of the nearest m."""
    errors, found = fit.standard_errors, []
    for c, channel in enumerate("rgb"):
        found.append(Interval(f"kd {channel}", float(fit.kd[c]), float(errors.kd[c]), truth.kd[c]))
    alive = [k for k in range(len(fit.m)) if k not in fit.dropped]
    for number, lobe in enumerate(truth.lobes, start=1):
        if not alive or max(lobe.ks) * 4.0 * lobe.r <= LEAST_HEIGHT:
            continue
        mine = min(alive, key=lambda k: abs(np.log(fit.m[k] / lobe.m)))
        for c, channel in enumerate("rgb"):
            name = f"ks{number} {channel}"
            found.append(Interval(name, float(fit.ks[mine, c]), float(errors.ks[mine, c]), lobe.ks[c]))
        found.append(Interval(f"m{number}", float(fit.m[mine]), float(errors.m[mine]), lobe.m))
        found.append(Interval(f"r{number}", float(fit.r[mine]), float(errors.r[mine]), lobe.r))
    return found


def figures(progress: Progress | None = None, count: int = COUNT) -> dict[str, float | None]:
    """Measure; ``TABLES`` gets the share of each parameter."""
    NOTES.clear()
    SHARES.clear()
    held, stated, unstated = Counter[str](), Counter[str](), 0
    for number, (name, size, seed) in enumerate(cases(count)):
        report(progress, number / count, f"{name} {size}")
        for one in intervals(TABLE_1[name], fit_of_rig(name, size, seed)):
            unstated += one.holds is None
            if one.holds is not None:
                stated[one.parameter] += 1
                held[one.parameter] += one.holds
    shares = {name: held[name] / stated[name] for name in sorted(stated)}
    judged = {name: share for name, share in shares.items() if stated[name] >= min(FEWEST, count)}
    worst = min(judged, key=lambda name: judged[name])
    NOTES["interval_coverage"] = (
        f"{count} tables, {POSITIONS} positions; {stated.total():,} intervals are stated, {unstated:,} parameters are "
        "reported as undetermined or at the end of their range"
    )
    NOTES["interval_coverage_worst"] = f"{worst}, {stated[worst]} intervals"
    SHARES.update(shares)
    return {
        "interval_coverage": held.total() / stated.total(),
        "interval_coverage_worst": judged[worst],
    }


def main() -> None:
    """Print every interval of a few tables."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--tables", type=int, default=3)
    parser.add_argument("--paint", choices=TABLE_1, help="this paint alone")
    parser.add_argument("--size", type=int, help="this size alone")
    options = parser.parse_args()
    given = (
        case
        for case in cases(1_000_000)
        if options.paint in (None, case[0]) and options.size in (None, case[1])
    )
    for name, size, seed in itertools.islice(given, options.tables):
        fit = fit_of_rig(name, size, seed)
        print(f"{name} {size} px, seed {seed}: misfit {fit.energy_mean:.4f}")
        for one in intervals(TABLE_1[name], fit):
            mark = {True: "", False: "  OUTSIDE", None: "  not stated"}[one.holds]
            print(
                f"  {one.parameter:6} {one.value:9.4g} ± {SIGMAS * one.error:8.2g}  truth {one.truth:9.4g}{mark}"
            )
        for notice in fit.notices:
            print(f"  {notice}")


if __name__ == "__main__":
    main()
