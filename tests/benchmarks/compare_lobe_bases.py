"""Print the tables of docs/fit.md: how well several lobe bases and sample sets fit the shipped paints.

python tests/benchmarks/compare_lobe_bases.py
"""

from __future__ import annotations

import itertools
import sys
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from brdf_suite.documents.paint import Gloss
from brdf_suite.documents.store import load_paint
from brdf_suite.errors import UnreachableError
from brdf_suite.fitting import LobeBasis, LobeFitter, log_spaced
from brdf_suite.fitting.lobes.basis import DEFAULT_EXPONENTS
from brdf_suite.fitting.lobes.samples import BASE_GAMMAS_DEG, BASE_WEIGHTS, BaseSamples, CoatSamples
from brdf_suite.fitting.metrics import aspecular_delta_e, directional_reflectance
from brdf_suite.reflectance.build import build_paint
from brdf_suite.reflectance.coat_lobe import CoatLobe
from brdf_suite.reflectance.paint_reflectance import PaintReflectance
from brdf_suite.resources import resource, resource_names

ENDING = ".brdfpaint"
MEASURED = (15.0, 45.0, 110.0)
BETWEEN = (8.0, 20.0, 25.0, 30.0, 35.0, 60.0, 75.0, 90.0)
ROUGHNESSES = np.geomspace(0.003, 0.1, 16)


def shipped(rule: str | None = None) -> dict[str, PaintReflectance]:
    """Return the reflectance of every shipped paint by its file's name; ``rule`` replaces its interpolation."""
    paints = {n: load_paint(resource("paints", n + ENDING)) for n in resource_names("paints", ENDING)}
    if rule is not None:
        paints = {name: replace(paint, interpolation=rule) for name, paint in paints.items()}
    return {name: build_paint(paint) for name, paint in paints.items()}


@dataclass(frozen=True)
class CoatFigures:
    """How one coat was fitted: energies are directional reflectances at 45°, shares are of the target's."""

    energy: float
    fitted_energy: float
    misplaced: float
    peak_ratio: float
    inside: float
    fitted_inside: float


def coat_figures(fitter: LobeFitter, roughness: float, ior: float = 1.5) -> CoatFigures:
    """Fit a coat alone and compare on rings far finer than the fit's own."""
    coat = CoatLobe(ior, roughness)
    lights = fitter.coat_samples
    rings = (coat.eval(lights.lights, lights.view) * lights.cosines[..., None]).mean(axis=1)
    black = np.zeros((fitter.base_samples.gamma_rad.size, 3))
    weights = fitter.fit_samples(black, rings, ior=ior).weights
    fine = CoatSamples(first_ring_rad=2e-4, log_step=0.05, azimuths=12)
    wanted = (coat.eval(fine.lights, fine.view) * fine.cosines[..., None]).mean(axis=1)[:, 0]
    given = fine.cosine_lobes(fitter.basis.array()) @ weights.kg[:, 0]
    energy = float(directional_reflectance(coat)[0])
    near = fine.gamma_rad <= np.radians(0.9)  # half the width of a 20° glossmeter's receptor
    return CoatFigures(
        energy=energy,
        fitted_energy=float(weights.coat_energy()[0]),
        # What is missing in one place is too much in another: the L1 error counts it twice.
        misplaced=float(0.5 * fine.solid_angle @ np.abs(wanted - given)) / energy,
        peak_ratio=float(given[0] / wanted[0]),
        inside=float((fine.solid_angle * wanted)[near].sum()) / energy,
        fitted_inside=float((fine.solid_angle * given)[near].sum()) / energy,
    )


def row(name: str, fitter: LobeFitter, paints: dict[str, PaintReflectance]) -> str:
    """Return one line of a table."""
    measured, between = [], []
    for paint in paints.values():
        weights = fitter.fit(paint).weights
        measured.append(aspecular_delta_e(paint, weights, MEASURED))
        between.append(aspecular_delta_e(paint, weights, BETWEEN))
    coats = [coat_figures(fitter, float(roughness)) for roughness in ROUGHNESSES]
    misplaced = [c.misplaced for c in coats]
    energy = max(abs(c.fitted_energy / c.energy - 1.0) for c in coats)
    return (
        f"| {name} | {np.max(measured):.2f} | {np.median(between):.2f} | {np.max(between):.2f} "
        f"| {np.mean(misplaced):.3f} | {np.max(misplaced):.3f} | {energy:.4f} |"
    )


def table(title: str, rows: Sequence[tuple[str, LobeFitter]], paints: dict[str, PaintReflectance]) -> None:
    """Print one table."""
    print(f"\n| {title} | ΔE00 at 15/45/110, worst | between: median | worst ", end="")
    print("| coat energy misplaced: mean | worst | coat energy error |\n|---|---|---|---|---|---|---|")
    for name, fitter in rows:
        print(row(name, fitter, paints))


def per_coat(fitter: LobeFitter) -> None:
    """Print the default fit of coats of n = 1.5 over their roughness."""
    print("\n| α | energy | fitted | peak, fitted / target | within 0.9° | fitted | misplaced |")
    print("|---|---|---|---|---|---|---|")
    for roughness in (0.002, 0.003, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2):
        c = coat_figures(fitter, roughness)
        print(
            f"| {roughness:g} | {c.energy:.4f} | {c.fitted_energy:.4f} | {c.peak_ratio:.2f} "
            f"| {c.inside:.3f} | {c.fitted_inside:.3f} | {c.misplaced:.3f} |"
        )


def per_rule(fitter: LobeFitter) -> None:
    """Print the worst ΔE00 over the shipped paints under each rule between the measured angles."""
    angles = (25.0, 60.0, 75.0, 90.0)
    print("\n| rule | 15/45/110° | 25° | 60° | 75° | 90° |\n|---|---|---|---|---|---|")
    for rule in ("flake", "monotone", "polynomial"):
        fits = [(p, fitter.fit(p).weights) for p in shipped(rule).values()]
        measured = max(aspecular_delta_e(p, w, MEASURED).max() for p, w in fits)
        worst = np.max([aspecular_delta_e(p, w, angles) for p, w in fits], axis=0)
        print(f"| {rule} | {measured:.2f} | " + " | ".join(f"{e:.1f}" for e in worst) + " |")


def per_gloss(fitter: LobeFitter) -> None:
    """Print ΔE00 at 15° over the gloss for four shipped paints."""
    names = ("fine_silver", "blue", "dark_grey", "copper")
    print("\n| 20° gloss, GU | " + " | ".join(names) + " |\n|---" + "|---" * len(names) + "|")
    for gu in (88.0, 50.0, 15.0, 8.0, 5.0):
        cells = []
        for name in names:
            paint = replace(load_paint(resource("paints", name + ENDING)), gloss=Gloss(gu))
            try:
                built = build_paint(paint)
            except UnreachableError:
                cells.append("unreachable")
                continue
            error = aspecular_delta_e(built, fitter.fit(built).weights, (15.0,))[0]
            cells.append(f"{error:.2f} (α = {built.roughness:.3f})")
        print(f"| {gu:g} | " + " | ".join(cells) + " |")


def scan() -> None:
    """Search bases of two ratios, low and high; print the best ten of all counts and the best of each."""
    flake, monotone = shipped("flake"), shipped("monotone")
    found = []
    sets = itertools.product(
        (8, 9, 10), (3, 4, 5), (1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0), (1.35, 1.5, 1.7, 2.0, 2.5)
    )
    for count, low_count, first, ratio in sets:
        low = [first * ratio**k for k in range(low_count)]
        step = (50_000.0 / low[-1]) ** (1.0 / (count - low_count))
        if step > 6.0:
            continue
        basis = LobeBasis((*low, *(low[-1] * step**k for k in range(1, count - low_count + 1))))
        fitter = LobeFitter(basis, time_limit_s=1.0)
        score = 0.0
        for paints, share in ((flake, 1.0), (monotone, 0.25)):
            fits = [(p, fitter.fit(p).weights) for p in paints.values()]
            errors = np.array([aspecular_delta_e(p, w, (*MEASURED, *BETWEEN[:-1])).max() for p, w in fits])
            score += share * float(errors.max() + errors.mean())
        found.append((score, count, low_count, first, ratio, step))
    found.sort()
    print(
        f"{len(found)} sets; score = worst + mean over paints of the worst ΔE00 below 90°, flake + monotone/4"
    )
    for line in found[:10] + [next(f for f in found if f[1] == n) for n in (8, 9)]:
        print("score {:5.2f}  {} lobes: {} from {:g} in ratio {:g}, then in ratio {:.2f}".format(*line))


def per_paint(fitter: LobeFitter, paints: dict[str, PaintReflectance]) -> None:
    """Print ΔE00 of the default fit for each paint."""
    print("\n| paint | 15° | 45° | 110° | 25° | 75° | -15° |\n|---|---|---|---|---|---|---|")
    for name, paint in paints.items():
        errors = aspecular_delta_e(paint, fitter.fit(paint).weights, (*MEASURED, 25.0, 75.0, -15.0))
        print(f"| {name} | " + " | ".join(f"{e:.2f}" for e in errors) + " |")


def main() -> None:
    """Print all tables."""
    paints = shipped()
    limit = 1.0  # quality, not speed, is compared here
    bases = [
        ("1, 2, 4, 8, 16, then × 5 (default)", LobeBasis(DEFAULT_EXPONENTS)),
        ("10 log-spaced from 1", log_spaced(10, 1.0, 50_000.0)),
        ("10 log-spaced from 2", log_spaced(10, 2.0, 50_000.0)),
        ("10 log-spaced from 4", log_spaced(10, 4.0, 50_000.0)),
        ("8 log-spaced from 2", log_spaced(8, 2.0, 50_000.0)),
        ("7 log-spaced from 2", log_spaced(7, 2.0, 50_000.0)),
        ("9: 1, 2, 4, 8, 16, then × 7.5", LobeBasis((1, 2, 4, 8, 16, 120, 894, 6690, 50_000))),
        ("9: 1, 2, 4, 8, then × 5.7", LobeBasis((1, 2, 4, 8, 46, 264, 1516, 8706, 50_000))),
    ]
    rows = [(name, LobeFitter(basis, time_limit_s=limit)) for name, basis in bases]
    table("basis", rows, paints)
    weights = np.array(BASE_WEIGHTS)
    keep = [k for k, g in enumerate(BASE_GAMMAS_DEG) if g in (0.0, 15.0, 25.0, 45.0, 75.0, 110.0)]
    bases_of_samples = [
        ("14 angles (default)", BaseSamples()),
        ("the same, all weights 1", BaseSamples(raw_weights=tuple(np.ones_like(weights)))),
        (
            "0, 15, 25, 45, 75, 110",
            BaseSamples(gammas_deg=(0, 15, 25, 45, 75, 110), raw_weights=tuple(weights[keep])),
        ),
        ("15, 45, 110 alone", BaseSamples(gammas_deg=(15, 45, 110), raw_weights=(1.0, 1.0, 1.0))),
        ("every 5° from -30 to 130", _dense()),
    ]
    rows = [
        (name, LobeFitter(time_limit_s=limit, base_samples=samples)) for name, samples in bases_of_samples
    ]
    table("base samples", rows, paints)
    rows = [
        (
            f"rings every {step:g} in ln γ",
            LobeFitter(time_limit_s=limit, coat_samples=CoatSamples(log_step=step)),
        )
        for step in (0.2, 0.4, 0.6, 0.8)
    ]
    rows.append(("step .4, 2 azimuths", LobeFitter(time_limit_s=limit, coat_samples=CoatSamples(azimuths=2))))
    rows.append(
        ("step .4, 16 azimuths", LobeFitter(time_limit_s=limit, coat_samples=CoatSamples(azimuths=16)))
    )
    table("coat samples", rows, paints)
    fitter = LobeFitter(time_limit_s=limit)
    per_coat(fitter)
    per_paint(fitter, paints)
    per_rule(fitter)
    per_gloss(fitter)


def _dense() -> BaseSamples:
    gammas = tuple(float(g) for g in range(-30, 135, 5))
    weights = tuple(float(np.interp(g, BASE_GAMMAS_DEG, BASE_WEIGHTS)) for g in gammas)
    return BaseSamples(gammas_deg=gammas, raw_weights=weights)


if __name__ == "__main__":
    scan() if "--scan" in sys.argv[1:] else main()
