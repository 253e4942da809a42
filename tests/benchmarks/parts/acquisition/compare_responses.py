"""Print how well a simulated camera response is recovered from shorter and poorer series (docs/method/acquisition.md).

python tests/benchmarks/parts/acquisition/compare_responses.py [--cases N]
"""

from __future__ import annotations

import argparse
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from acquisition_response import Recovered, by_turns, true_exposures

from brdf_suite.acquisition.radiance.sensor_maps import black_codes
from brdf_suite.acquisition.response.fit import calibrate_response
from brdf_suite.acquisition.response.samples import ResponseSamples, spread
from brdf_suite.acquisition.simulator import Simulator, SimulatorSettings
from brdf_suite.reflectance.models.cook_torrance import CookTorrance
from brdf_suite.reflectance.models.table_1 import TABLE_1


@dataclass(frozen=True)
class Case:
    """A rig, and how it is called in the table."""

    name: str
    paint: str = "table1_polaris_silver"
    settings: dict[str, Any] = field(default_factory=dict)


CASES = (
    Case("48 × 48 pixels, 6 exposures", settings={"size": (48, 48), "exposures": 6}),
    Case("16 exposures, 12 bit"),
    Case("the same, Ford F8 (dark)", "table1_ford_f8"),
    Case("the same, 8 bit", settings={"bit_depth": 8}),
    Case("the same, 16 bit", settings={"bit_depth": 16}),
    Case("the same, linear", settings={"curve": "linear"}),
    Case("the same, sRGB", settings={"curve": "srgb"}),
    Case("the same, sRGB, 8 bit", settings={"curve": "srgb", "bit_depth": 8}),
    Case("8 exposures", settings={"exposures": 8}),
    Case("4 exposures", settings={"exposures": 4}),
    Case("3 exposures, 2 to 100 ms", settings={"exposures": 3, "shortest_s": 0.002, "longest_s": 0.1}),
)
POSITIONS = 8


def row(case: Case) -> list[str]:
    """Return the cells of one case."""
    settings = SimulatorSettings(**{"size": (128, 128), "board": False, **case.settings})
    rig = Simulator(CookTorrance(TABLE_1[case.paint]), settings, case.paint)
    samples = ResponseSamples(settings.exposures_s(), settings.bit_depth)
    for k in spread(180, POSITIONS):
        samples.add(rig.position(k))
    fit = calibrate_response(samples, black_codes(rig.dark()))
    found = Recovered(fit, samples, true_exposures(rig), float(rig.sensor.black))
    kind = "line" if fit.response.linear else "curve"
    apart = float(np.abs(np.expm1(fit.time_residuals)).max())
    return [
        case.name,
        kind,
        f"{found.rms(fit.response.exposure):.5f}",
        f"{found.rms(by_turns(samples)):.4f}",
        f"{100.0 * apart:.1f} %",
        f"{int(fit.pixels.min()):,}",
    ]


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--cases", type=int, default=len(CASES), help="only so many of them")
    given = parser.parse_args()
    print("| series | found | RMS, ours | RMS, by turns | largest error of a time | pixels a channel |")
    print("|---|---|---|---|---|---|")
    for case in CASES[: given.cases]:
        print("| " + " | ".join(row(case)) + " |", flush=True)


if __name__ == "__main__":
    main()
