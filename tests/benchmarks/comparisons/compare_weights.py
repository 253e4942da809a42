"""Print what the weights of samples and the way to the diffuse term cost over the paints (docs/method/fit.md).

python tests/benchmarks/comparisons/compare_weights.py
"""

from __future__ import annotations

from typing import get_args

import numpy as np
from compare_lobe_bases import ROUGHNESSES, coat_figures
from lobe_experiment import Database, Fitted, Lobes, arguments, paints, table

from brdf_suite.fitting import LobeFitter
from brdf_suite.fitting.lobes.program import Weighting

LIMIT_S = 1.0  # quality, not speed, is compared here


def errors(database: Database, fitter: LobeFitter) -> Fitted:
    """Fit every base by the suite's fitter and compare."""
    columns = []
    for layers in database.layers:
        weights = fitter.fit(layers).weights
        columns.append(np.concatenate([weights.kd[None], weights.kdd]))
    return database.errors_of(Lobes(fitter.basis.exponents), np.stack(columns))


def base_cells(database: Database, fitter: LobeFitter) -> list[str]:
    """Return mean and largest RMS ΔE00, the worst at any angle not used, and the worst at 15, 45 and 110°."""
    found = errors(database, fitter)
    return [
        f"{v:.2f}" for v in (found.rms.mean(), found.rms.max(), found.held_out.max(), found.measured.max())
    ]


def main() -> None:
    """Print the tables."""
    given = arguments(__doc__ or "")
    roughnesses = ROUGHNESSES[:2] if given.paints else ROUGHNESSES
    databases = {
        rule: Database.of(list(paints(rule, given.paints).values())) for rule in ("flake", "monotone")
    }
    columns = [
        f"{rule}: {what}" for rule in databases for what in ("mean", "max", "worst angle", "15/45/110")
    ]
    rows = []
    for weighting in get_args(Weighting):
        fitter = LobeFitter(time_limit_s=LIMIT_S, weighting=weighting)
        coats = [coat_figures(fitter, float(roughness)) for roughness in roughnesses]
        misplaced = [coat.misplaced for coat in coats]
        cells = [cell for database in databases.values() for cell in base_cells(database, fitter)]
        rows.append([weighting, *cells, f"{np.mean(misplaced):.3f}", f"{np.max(misplaced):.3f}"])
    table(["weights", *columns, "coat misplaced: mean", "worst"], rows, "weights of the samples")
    rows = []
    for name, fitter in (
        ("jointly, in the program", LobeFitter(time_limit_s=LIMIT_S)),
        ("measured at 110°", LobeFitter(time_limit_s=LIMIT_S, diffuse="measured")),
        (
            "measured at 45°, along the normal",
            LobeFitter(time_limit_s=LIMIT_S, diffuse="measured", diffuse_gamma_deg=45.0),
        ),
    ):
        rows.append(
            [name, *(cell for database in databases.values() for cell in base_cells(database, fitter))]
        )
    table(["diffuse term", *columns], rows, "KD jointly, or measured as in the paper")


if __name__ == "__main__":
    main()
