"""Print what fitting weights in Rec. 709 instead of Rec. 2020 would cost saturated paints (docs/method/fit.md).

python tests/benchmarks/comparisons/compare_colour_spaces.py

Outside its triangle a channel of the target is negative, and no sum of lobes with weights ≥ 0 follows it.
"""

from __future__ import annotations

import numpy as np
from lobe_experiment import (
    HELD_OUT,
    MEASURED,
    Database,
    Fitted,
    Lobes,
    arguments,
    base_values,
    l1_program,
    paints,
    table,
)

from brdf_suite.appearance.colour.colorimetry import REC709_TO_WORKING, WORKING_TO_SRGB
from brdf_suite.arrays import Floats
from brdf_suite.fitting import default_basis


def in_rec709(matrix: Floats, weights: Floats, targets: Floats) -> Floats:
    """Fit as :func:`l1_program`, in channels of Rec. 709; targets and columns in Rec. 2020."""
    return l1_program(matrix, weights, targets @ WORKING_TO_SRGB.T) @ REC709_TO_WORKING.T


def lowest(values: Floats) -> Floats:
    """Return per paint the lowest channel of ``values`` (paints, n, 3), over the largest one of its sample."""
    return np.asarray((values.min(axis=2) / values.max(axis=2)).min(axis=1))


def main() -> None:
    """Print the tables."""
    given = arguments(__doc__ or "")
    chosen = paints(count=given.paints)
    database = Database.of(list(chosen.values()))
    lobes = Lobes(default_basis().exponents)
    fits: dict[str, Fitted] = {
        "Rec. 2020": database.errors(lobes),
        "Rec. 709": database.errors(lobes, in_rec709),
    }
    values = base_values(list(chosen.values()), (*MEASURED, *HELD_OUT))
    shares = {"Rec. 2020": lowest(values), "Rec. 709": lowest(values @ WORKING_TO_SRGB.T)}
    outside = np.flatnonzero(shares["Rec. 709"] < -1e-6)
    rows = [
        [
            list(chosen)[k],
            *(f"{shares[space][k]:.3f}" for space in fits),
            *(f"{fit.measured[k].max():.2f}" for fit in fits.values()),
            *(f"{fit.rms[k]:.2f}" for fit in fits.values()),
        ]
        for k in outside[np.argsort(shares["Rec. 709"][outside])]
    ]
    columns = [
        f"{what}, {space}"
        for what in ("lowest channel over largest", "15/45/110 worst", "RMS ΔE00 elsewhere")
        for space in fits
    ]
    count = len(chosen)
    table(["paint", *columns], rows, f"the {outside.size} of {count} paints that leave Rec. 709")
    rows = [
        [
            space,
            str(int((shares[space] < -1e-6).sum())),
            f"{fit.measured.max():.2f}",
            f"{fit.rms.mean():.2f}",
            f"{fit.rms.max():.2f}",
        ]
        for space, fit in fits.items()
    ]
    table(
        ["weights in", "paints outside", "15/45/110 worst", "RMS ΔE00: mean", "max"],
        rows,
        f"all {count} paints",
    )


if __name__ == "__main__":
    main()
