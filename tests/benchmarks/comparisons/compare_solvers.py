"""Print what three ways to weigh lobes cost over the number of lobes (docs/method/fit.md).

python tests/benchmarks/comparisons/compare_solvers.py

The linear program of the least absolute error, non-negative least squares, and least squares whose negative weights
are set to 0, over 1 to 11 lobes. The same weights of samples, the same paints and coats.
"""

from __future__ import annotations

import numpy as np
from lobe_experiment import (
    Database,
    Lobes,
    Solver,
    arguments,
    clamped_least_squares,
    l1_program,
    non_negative_least_squares,
    paints,
    table,
)

from brdf_suite.fitting import log_spaced
from brdf_suite.fitting.lobes.basis import STORED_NAME, stored_bases
from brdf_suite.fitting.lobes.program import ENERGY_WEIGHT
from brdf_suite.fitting.lobes.samples import CoatSamples
from brdf_suite.reflectance.designed.coat_lobe import CoatLobe
from brdf_suite.resources import resource

SOLVERS: dict[str, Solver] = {
    "L1 program": l1_program,
    "NNLS": non_negative_least_squares,
    "clamped": clamped_least_squares,
}
COUNTS = tuple(range(1, 12))
#: The whole range of a paint's lobes; and that of the flop alone, where neighbours are alike and least squares
#: answers with large weights of both signs.
RANGES = {"2 to 50,000": (2.0, 50_000.0), "2 to 64": (2.0, 64.0)}
ROUGHNESSES = np.geomspace(0.003, 0.1, 16)


def base_errors(database: Database, lobes: Lobes) -> dict[str, tuple[float, ...]]:
    """Return by solver: mean and largest RMS ΔE00 over the paints at angles not used in the fit, worst at used ones.

    "Used" are the three at which paints are measured.
    """
    fits = {name: database.errors(lobes, solver) for name, solver in SOLVERS.items()}
    return {
        name: (float(fit.rms.mean()), float(fit.rms.max()), float(fit.measured.max()))
        for name, fit in fits.items()
    }


def coat_errors(lobes: Lobes) -> dict[str, tuple[float, ...]]:
    """Return mean and largest share of a coat's energy that the fit puts at another angle, by solver."""
    samples, fine = CoatSamples(), CoatSamples(first_ring_rad=2e-4, log_step=0.05, azimuths=12)
    coats = [CoatLobe(1.5, float(roughness)) for roughness in ROUGHNESSES]

    def rings(of: CoatSamples) -> np.ndarray:
        values = [(c.eval(of.lights, of.view) * of.cosines[..., None]).mean(axis=1)[:, :1] for c in coats]
        return np.stack(values)

    exponents = np.array(lobes.cosine)
    target = rings(samples)
    energy = np.einsum("r,crk->ck", samples.solid_angle, target)
    matrix = np.concatenate([samples.cosine_lobes(exponents), samples.lobe_energy(exponents)[None]])
    weights = np.concatenate([samples.solid_angle, [ENERGY_WEIGHT]])
    wanted = rings(fine)
    whole = np.einsum("r,crk->c", fine.solid_angle, wanted)
    errors = {}
    for name, solver in SOLVERS.items():
        given = fine.cosine_lobes(exponents) @ solver(
            matrix, weights, np.concatenate([target, energy[:, None]], axis=1)
        )
        # What is missing in one place is too much in another: the L1 error counts it twice.
        shares = 0.5 * np.einsum("r,crk->c", fine.solid_angle, np.abs(wanted - given)) / whole
        errors[name] = (float(shares.mean()), float(shares.max()))
    return errors


def sets() -> dict[str, dict[int, Lobes]]:
    """Return the lobes of each count: log-spaced over :data:`RANGES`, and what the search found."""
    named = {
        f"log-spaced from {title}": {n: Lobes(log_spaced(n, low, high).exponents) for n in COUNTS}
        for title, (low, high) in RANGES.items()
    }
    bases, _ = stored_bases(resource("basis", STORED_NAME))
    named["found by the search"] = {count: Lobes(bases[count].exponents) for count in COUNTS}
    return named


def curves(database: Database) -> dict[str, dict[str, list[tuple[float, ...]]]]:
    """Return the errors over :data:`COUNTS` by set and solver; what begins with "coats" holds misplaced shares."""
    found: dict[str, dict[str, list[tuple[float, ...]]]] = {}
    for title, by_count in sets().items():
        found[f"bases: {title}"] = _by_solver([base_errors(database, by_count[n]) for n in COUNTS])
        if title != "log-spaced from 2 to 64":  # no lobe of a coat among them
            found[f"coats: {title}"] = _by_solver([coat_errors(by_count[n]) for n in COUNTS])
    return found


def _by_solver(errors: list[dict[str, tuple[float, ...]]]) -> dict[str, list[tuple[float, ...]]]:
    return {name: [item[name] for item in errors] for name in SOLVERS}


def main() -> None:
    """Print the tables."""
    given = arguments(__doc__ or "")
    database = Database.of(list(paints(count=given.paints).values()))
    print(f"{len(database.layers)} paints, {len(ROUGHNESSES)} coats")
    for title, by_solver in curves(database).items():
        coat = title.startswith("coats")
        digits, kinds = (3, ("mean", "max")) if coat else (2, ("mean", "max", "15/45/110"))
        header = ["lobes", *(f"{name}: {what}" for name in SOLVERS for what in kinds)]
        rows = [
            [str(count), *(f"{e:.{digits}f}" for name in SOLVERS for e in by_solver[name][k])]
            for k, count in enumerate(COUNTS)
        ]
        table(header, rows, title)


if __name__ == "__main__":
    main()
