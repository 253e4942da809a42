"""Print what the samples of a fit cost: error against their number, for base and coat (docs/method/fit.md).

python tests/benchmarks/comparisons/compare_samples.py

The paints are taken twice, by their own rule between the measured angles and by the monotone one, whose flanks are
broader.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from compare_lobe_bases import ROUGHNESSES, coat_figures
from lobe_experiment import HELD_OUT, MEASURED, Database, Fitted, Lobes, arguments, paints, table
from numpy.typing import NDArray

from brdf_suite.fitting import LobeFitter, default_basis
from brdf_suite.fitting.lobes.samples import BASE_GAMMAS_DEG, BASE_WEIGHTS, BaseSamples, CoatSamples
from brdf_suite.reflectance.protocol import Layered

#: Angles that the greedy choice may take.
CANDIDATES = tuple(sorted(({float(g) for g in range(-30, 135, 5)} | {8.0, 92.0}) - set(HELD_OUT)))
MOST = 14
#: log-steps of the coat's rings, from 37 rings to 6.
STEPS = (0.2, 0.3, 0.4, 0.5, 0.6, 0.8, 1.0, 1.5)
FIRST_RINGS = (0.0003, 0.001, 0.003, 0.01, 0.03)


def weight(gamma_deg: float) -> float:
    """Return the fitter's weight of an aspecular angle, for any angle: by its kind."""
    if gamma_deg in MEASURED:
        return 50.0
    if gamma_deg < 0.0 or gamma_deg > MEASURED[-1]:
        return 0.3
    return 4.0 if gamma_deg >= 60.0 else 1.0


def errors(layers: Sequence[Layered], gammas_deg: Sequence[float]) -> Fitted:
    """Fit the default basis at angles, weighed by :func:`weight`."""
    chosen = sorted(gammas_deg)
    return Database.of(layers, chosen, [weight(g) for g in chosen]).errors(Lobes(default_basis().exponents))


def even(count: int) -> tuple[float, ...]:
    """Return the measured angles, 0° and ``count - 4`` more, each in the middle of the widest gap."""
    chosen = [0.0, *MEASURED]
    while len(chosen) < count:
        ordered = sorted(chosen)
        gaps = np.diff(ordered)
        widest = int(np.argmax(gaps))
        chosen.append(ordered[widest] + 0.5 * gaps[widest])
    return tuple(chosen)


def greedy(layers: Sequence[Layered], most: int = MOST) -> list[tuple[float, Fitted]]:
    """Add to the measured angles, one by one, the one that lowers equation 4 most; angle and error of each."""
    chosen: list[float] = list(MEASURED)
    steps = []
    while len(chosen) < most:
        tried = [(errors(layers, (*chosen, g)), g) for g in CANDIDATES if g not in chosen]
        best, angle = min(tried, key=lambda item: item[0].equation_4)
        chosen.append(angle)
        steps.append((angle, best))
    return steps


def own_errors(layers: Sequence[Layered]) -> Fitted:
    """Fit the default basis at the fitter's own samples."""
    return Database.of(layers).errors(Lobes(default_basis().exponents))


def both_rules(count: int | None) -> list[Layered]:
    """Return the paints by their own rule, and again by the monotone one."""
    return [*paints(count=count).values(), *paints("monotone", count).values()]


def base_table(layers: Sequence[Layered], most: int) -> None:
    """Print error against the number of base samples, and what each of the fitter's own brings."""

    def cells(name: str, fitted: Fitted) -> list[str]:
        return [name, f"{fitted.rms.mean():.2f}", f"{fitted.rms.max():.2f}", f"{fitted.measured.max():.2f}"]

    rows = [[*cells("3", errors(layers, MEASURED)), "–", "–", "–"]]
    for count, (angle, fitted) in enumerate(greedy(layers, most), start=4):
        rows.append(cells(f"{count}: + {angle:g}°", fitted) + cells("", errors(layers, even(count)))[1:])
    table(
        ["samples", "mean", "max", "15/45/110", "halved gaps: mean", "max", "15/45/110"],
        rows,
        "base: RMS ΔE00 at angles not used, over the number of samples; the next best angle each time",
    )
    lobes = Lobes(default_basis().exponents)
    rows = [cells(f"all {len(BASE_GAMMAS_DEG)}", own_errors(layers))]
    for k, gamma in enumerate(BASE_GAMMAS_DEG):
        angles = BASE_GAMMAS_DEG[:k] + BASE_GAMMAS_DEG[k + 1 :]
        weights = BASE_WEIGHTS[:k] + BASE_WEIGHTS[k + 1 :]
        rows.append(cells(f"without {gamma:g}°", Database.of(layers, angles, weights).errors(lobes)))
    ones = [1.0] * len(BASE_GAMMAS_DEG)
    rows.append(cells("all, weights 1", Database.of(layers, weights=ones).errors(lobes)))
    table(["base samples", "mean", "max", "15/45/110"], rows, "the fitter's own samples, and without each")


@dataclass(frozen=True)
class CoatErrors:
    """Number of rings; misplaced share of energy per roughness; largest relative error of the energy."""

    rings: int
    misplaced: NDArray[np.float64]
    energy: float


def coat_errors(samples: CoatSamples, count: int | None) -> CoatErrors:
    """Fit coats of :data:`ROUGHNESSES` (``count`` of them)."""
    fitter = LobeFitter(time_limit_s=1.0, coat_samples=samples)
    chosen = ROUGHNESSES if count is None else ROUGHNESSES[:: max(1, ROUGHNESSES.size // count)]
    figures = [coat_figures(fitter, float(roughness)) for roughness in chosen]
    energy = max(abs(f.fitted_energy / f.energy - 1.0) for f in figures)
    return CoatErrors(samples.gamma_rad.size, np.array([f.misplaced for f in figures]), energy)


def coat_table(count: int | None) -> None:
    """Print error against the number of rings, their azimuths and the first ring."""
    sets = {f"every {s:g} in ln γ": CoatSamples(log_step=s) for s in STEPS}
    sets |= {f"first ring {f:g} rad": CoatSamples(first_ring_rad=f) for f in FIRST_RINGS}
    sets |= {f"{n} azimuth{'s' if n > 1 else ''}": CoatSamples(azimuths=n) for n in (1, 2, 4, 6, 16)}
    rows = []
    for name, samples in sets.items():
        e = coat_errors(samples, count)
        rows.append(
            [name, str(e.rings), f"{e.misplaced.mean():.3f}", f"{e.misplaced.max():.3f}", f"{e.energy:.4f}"]
        )
    table(["coat samples", "rings", "misplaced: mean", "worst", "energy error"], rows, "coat")


def time_table(layers: Sequence[Layered], repeats: int) -> None:
    """Print the median time of a whole fit over unrelated paints by the number of samples."""
    fitters = {}
    for angles in (8, len(BASE_GAMMAS_DEG), 33):
        chosen = (
            BASE_GAMMAS_DEG if angles == len(BASE_GAMMAS_DEG) else tuple(np.linspace(-30.0, 130.0, angles))
        )
        base = BaseSamples(gammas_deg=chosen, raw_weights=tuple(weight(g) for g in chosen))
        for step in (0.8, 0.4, 0.2):
            coat = CoatSamples(log_step=step)
            fitters[angles, coat.gamma_rad.size] = LobeFitter(
                time_limit_s=1.0, base_samples=base, coat_samples=coat
            )
    times: dict[tuple[int, int], list[float]] = {key: [] for key in fitters}
    for _ in range(repeats):
        for key, fitter in fitters.items():  # by turns, so that other work on the machine meets all alike
            times[key] += [fitter.fit(item).seconds for item in layers]
    rings = sorted({key[1] for key in fitters})
    rows = [
        [str(angles), *(f"{1e3 * np.median(times[angles, count]):.2f}" for count in rings)]
        for angles in sorted({key[0] for key in fitters})
    ]
    table(
        ["base samples", *(f"{count} rings" for count in rings)], rows, "ms for a whole fit, unrelated paints"
    )


def main() -> None:
    """Print the tables."""
    given = arguments(__doc__ or "")
    base_table(both_rules(given.paints), 5 if given.paints else MOST)
    coat_table(given.paints)
    time_table(list(paints(count=given.paints).values()), 1 if given.paints else 9)


if __name__ == "__main__":
    main()
