"""``brdf-suite fit PAINT``: the lobe weights of a paint, their errors, and the time it took."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING

from brdf_suite.cli.output import print_json

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray


def add(commands: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Declare the command."""
    command = commands.add_parser(
        "fit",
        help="fit the cosine lobes to a paint; weights, errors and time",
        description="Fit the fixed set of cosine lobes to a paint by linear programming. Weights are linear Rec. 2020, "
        "f_r·cosθ at the stated incidence: KD and KDD times N·L, KG without.",
    )
    command.add_argument("paint", metavar="PAINT", help="a .brdfpaint file, or the name of a shipped paint")
    command.add_argument("--json", action="store_true", help="print one JSON object")
    command.set_defaults(run=run)


def run(options: argparse.Namespace) -> int:
    """Fit and print."""
    from brdf_suite.pipeline.paint import fit_patiently
    from brdf_suite.pipeline.scene import find_paint

    paint = find_paint(options.paint)
    result = fit_patiently(paint, options.paint)
    facts = result.to_json()
    if options.json:
        print_json(facts)
        return 0
    weights = result.weights
    print(
        f"{paint.name}: {len(weights.exponents)} lobes, {facts['ms']:.2f} ms"
        + (", time-limited" if result.time_limited else "")
    )
    print(f"{'exponent':>17}  {'KDD r':>11}{'g':>10}{'b':>10} {'KG r':>11}{'g':>10}{'b':>10}")
    for exponent, base, gloss in zip(weights.exponents, weights.kdd, weights.kg, strict=True):
        print(f"{exponent:17,.1f}  {_triple(base)} {_triple(gloss)}")
    print(f"               KD  {_triple(weights.kd)}")
    print(" aspecular °    L* asked   fitted      ΔE00")
    for row in result.angles:
        print(
            f"{row.aspecular_deg:12.0f}  {row.asked[0]:10.2f} {row.fitted[0]:8.2f}  {row.delta_e_2000:8.3f}"
        )
    for notice in result.notices:
        print(f"note: {notice}")
    return 0


def _triple(weights: NDArray[np.float64]) -> str:
    return f"{weights[0]:11.4f}{weights[1]:10.4f}{weights[2]:10.4f}"
