"""Print what stands behind docs/method/incidence.md: what Fresnel's two ways cost and give, by measurement.

Run ``python tests/benchmarks/parts/compare_incidences.py`` from the repository. ΔE00 is between the whole paint and its
fit, in the plane of incidence, at γ = -15, 15, 25, 45, 75 and 110° as far as the view stands no lower than 85°,
unless a table says otherwise.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import fit_angles
import numpy as np

from brdf_suite.fitting import LobeFitter
from brdf_suite.fitting.lobes.angles import AngleFitter, AngleGrid, AngleWeights
from brdf_suite.fitting.lobes.angles import program as angle_samples
from brdf_suite.fitting.lobes.angles.weights import gloss_brdf
from brdf_suite.fitting.lobes.weights import RaisedWeights
from brdf_suite.fitting.metrics import aspecular_delta_e
from brdf_suite.geometry.fresnel import fresnel_dielectric
from brdf_suite.pipeline.material import load_document
from brdf_suite.reflectance.designed.build import build_reflectance
from brdf_suite.reflectance.designed.layers import depends_on_halfway, split_layers
from brdf_suite.reflectance.designed.paint_reflectance import PaintReflectance
from brdf_suite.reflectance.models.table_1 import TABLE_1
from brdf_suite.reflectance.protocol import Reflectance

INCIDENCES = (10.0, 20.0, 30.0, 45.0, 55.0, 65.0, 70.0, 75.0, 80.0)
GAMMAS = (-15.0, 15.0, 25.0, 45.0, 75.0, 110.0)
PAINTS = fit_angles.designed()
MATTE = {name for name, paint in PAINTS.items() if paint.coat.roughness > fit_angles.MATTE}
SHIFT = {name for name, paint in PAINTS.items() if not hasattr(paint.base, "rule")}
USUAL = [name for name in PAINTS if name not in MATTE | SHIFT]
LIMIT_S = 10.0


def seen(theta: float) -> tuple[float, ...]:
    """Return the aspecular angles with a view no lower than 85°."""
    return tuple(g for g in GAMMAS if abs(theta - g) <= fit_angles.LOWEST_VIEW_DEG)


def table(head: Sequence[str], rows: Sequence[Sequence[object]]) -> None:
    """Print a Markdown table."""
    print("| " + " | ".join(head) + " |\n|" + "---|" * len(head))
    for row in rows:
        print("| " + " | ".join(f"{v:.2f}" if isinstance(v, float) else str(v) for v in row) + " |")
    print(flush=True)


def there_and_back(weights: AngleWeights) -> tuple[float, float]:
    """Return how much base and gloss lobes rise and fall beyond going from first to last, over the mean sum.

    Weights count by the light they hold, 2π/(E+1), and without what Fresnel's equations do to all of them.
    """
    holds = 2.0 * np.pi / (weights.exponents + 1.0)
    passed = (1.0 - fresnel_dielectric(weights.cosines, weights.ior)) ** 2
    base = np.concatenate([np.pi * weights.kd[:, None], weights.kdd * holds[:, None]], axis=1)
    gloss = weights.kg * holds[:, None] / np.maximum(weights.coat_energy(), 1e-12)[:, None]
    found = []
    for part in (base / passed[:, None, None], gloss):
        change = np.diff(part, axis=0)
        extra = np.abs(change).sum(axis=0) - np.abs(change.sum(axis=0))
        found.append(float((extra.sum(axis=0) / np.maximum(part.sum(axis=1).mean(axis=0), 1e-12)).max()))
    return found[0], found[1]


def misplaced(fitter: AngleFitter, paint: PaintReflectance, weights: AngleWeights) -> float:
    """Return the share of a coat's energy that its lobes put on another ring, mean over the incidences."""
    rings = fitter.coat_samples
    wanted = fitter.sample(paint).rings[..., 0]
    given = np.einsum("knm,km->kn", rings.cosine_lobes(weights.exponents), weights.kg[..., 0])
    moved = (np.abs(wanted - given) * rings.solid_angle).sum(axis=1)
    return float((0.5 * moved / (wanted * rings.solid_angle).sum(axis=1)).mean())


def by_incidence() -> None:
    """Single weights, raised by Fresnel, and fitted at several angles."""
    single = LobeFitter(time_limit_s=LIMIT_S)
    several = [AngleFitter(halfway=halfway, time_limit_s=LIMIT_S) for halfway in (False, True)]
    one = {name: single.fit(paint).weights for name, paint in PAINTS.items()}
    ways: dict[str, dict[str, Reflectance]] = {
        "one incidence": dict(one),
        "raised, θ of the light": {name: RaisedWeights(w) for name, w in one.items()},
        "raised, θ of the view": {name: RaisedWeights(w, "view") for name, w in one.items()},
        "several incidences": {
            name: several[depends_on_halfway(paint)].fit(paint).weights for name, paint in PAINTS.items()
        },
    }
    bare = {}
    for name, paint in PAINTS.items():
        bare[name] = several[0].fit_samples(replace(several[0].sample(paint), base_under_coat=False)).weights
    ways["16, lobes even in γ (t = 1)"] = dict(bare)
    for label, names in (("usual", USUAL), ("matte", sorted(MATTE)), ("two lights", sorted(SHIFT))):
        print(f"{label}: {len(names)} paints, median / worst")
        rows = []
        for way, fits in ways.items():
            cells = [way]
            for theta in INCIDENCES:
                e = np.concatenate([aspecular_delta_e(PAINTS[n], fits[n], seen(theta), theta) for n in names])
                cells.append(f"{np.median(e):.2f} / {e.max():.1f}")
            rows.append(cells)
        table(["", *(f"{theta:.0f}°" for theta in INCIDENCES)], rows)


def score(fitter: AngleFitter) -> list[object]:
    """Return the columns that the choices of a multi-angle fit are judged by."""
    fits = {name: fitter.fit(PAINTS[name]).weights for name in PAINTS}
    measured = max(aspecular_delta_e(PAINTS[n], fits[n], fit_angles.MEASURED_DEG).max() for n in USUAL)
    held = np.concatenate([fit_angles.errors(PAINTS[n], fits[n]) for n in USUAL])
    low = np.concatenate(
        [
            aspecular_delta_e(PAINTS[n], fits[n], (15.0, 25.0, 45.0, 75.0, 110.0), theta)
            for n in USUAL
            for theta in (72.0, 77.0, 80.0, 83.0)
        ]
    )
    turning = np.array([there_and_back(fits[n]) for n in USUAL])
    moved = np.mean([misplaced(fitter, PAINTS[n], fits[n]) for n in PAINTS])
    fitter.close()
    return [
        f"{measured:.3f}",
        f"{np.median(held):.3f} / {held.max():.2f}",
        f"{np.median(low):.3f} / {low.max():.2f}",
        f"{turning[:, 0].mean():.3f} / {turning[:, 0].max():.2f}",
        f"{turning[:, 1].mean():.3f} / {turning[:, 1].max():.2f}",
        f"{moved:.3f}",
    ]


HEAD = (
    "at 15/45/110, worst",
    "γ = -15, 25, 75; 20°, 65°",
    "72–83°",
    "base there and back: mean / worst",
    "gloss there and back",
    "coat misplaced",
)


def choices() -> None:
    """Smoothness, placement, number and horizon."""
    held = [
        ("μ " + f"{mu:g}", AngleFitter(smoothness=mu, time_limit_s=LIMIT_S))
        for mu in (0.0, 0.003, 0.01, 0.03, 0.1, 0.3)
    ]
    rows = []
    for label, fitter in held:
        two = [
            aspecular_delta_e(PAINTS[n], fitter.fit(PAINTS[n]).weights, seen(45.0), 45.0).max()
            for n in sorted(SHIFT)
        ]
        rows.append([label, *score(fitter), f"{max(two):.1f}"])
    table(["smoothness", *HEAD, "two lights at 45°, worst"], rows)
    grids = [AngleGrid(16, p, low) for p in (0.9, 1.2, 1.6, 2.5) for low in (0.01, 0.03, 0.06)]
    grids = list({(g.power, g.lowest_cosine): g for g in grids}.values())
    rows = []
    for grid in grids:
        label = f"p {grid.power:.2f}, from {np.degrees(np.arccos(grid.lowest_cosine)):.1f}°"
        rows.append([label, *score(AngleFitter(grid=grid, time_limit_s=LIMIT_S))])
    table(["placement", *HEAD], rows)
    table(
        ["angles", *HEAD],
        [
            [str(k), *score(AngleFitter(grid=AngleGrid(k), time_limit_s=LIMIT_S))]
            for k in (4, 6, 8, 12, 16, 24, 32)
        ],
    )
    usual = angle_samples.HORIZON_DEG
    rows = []
    for horizon in (60.0, 70.0, 75.0, 80.0, 85.0):
        angle_samples.HORIZON_DEG = horizon
        rows.append([f"{horizon:.0f}°", *score(AngleFitter(time_limit_s=LIMIT_S))])
    angle_samples.HORIZON_DEG = usual
    table(["lowest view", *HEAD], rows)


def coats() -> None:
    """How much a base with its coat's rest in the plane reflects more than one without."""
    fitter = AngleFitter(time_limit_s=LIMIT_S)
    rows = []
    for name in sorted(PAINTS, key=lambda n: -PAINTS[n].coat.roughness)[:6]:
        paint = PAINTS[name]
        samples = fitter.sample(paint)
        with_rest = fitter.fit_samples(samples).weights
        flat = fitter.base_samples
        fitted = gloss_brdf(fitter.grid, with_rest.exponents, with_rest.kg, flat.lights, flat.views)
        without = fitter.fit_samples(replace(samples, coat=fitted)).weights
        share = []
        for theta in (20.0, 45.0, 65.0):
            cosine = float(np.cos(np.radians(theta)))
            sums = []
            for weights in (with_rest, without):
                at = weights.at(cosine)
                lobes = 2.0 * np.pi / (at.exponents + 1.0) * cosine
                sums.append(float((np.pi * at.kd + lobes @ at.kdd).mean()))
            whole = sums[1] + float(fresnel_dielectric(cosine, paint.ior))
            share.append(f"{100.0 * (sums[0] - sums[1]) / whole:.1f} %")
        e = [aspecular_delta_e(paint, w, fit_angles.MEASURED_DEG).max() for w in (without, with_rest)]
        rows.append([name, f"{paint.coat.roughness:.3f}", *(float(v) for v in e), *share])
    table(["paint", "α", "15/45/110 without", "with", "light added at 20°", "45°", "65°"], rows)


def cook_torrance() -> None:
    """Table 1's paints, whole, in their two layers."""
    for halfway in (False, True):
        fitter = AngleFitter(halfway=halfway, time_limit_s=LIMIT_S)
        rows = []
        for name in TABLE_1:
            model = build_reflectance(load_document(name))
            layers = split_layers(model)
            assert layers is not None
            weights = fitter.fit(layers).weights
            cells: list[object] = [
                name,
                float(aspecular_delta_e(model, weights, fit_angles.MEASURED_DEG).max()),
            ]
            for theta in (20.0, 45.0, 65.0):
                gammas = seen(theta)
                e = aspecular_delta_e(model, weights, gammas, theta)
                normal = max(v for g, v in zip(gammas, e, strict=True) if g > 0.0)
                cells += [float(normal), float(e[0])]
            rows.append(cells)
        print("base looked up at θd" if halfway else "base looked up at the light's angle")
        table(
            ["paint", "15/45/110", "20°, γ > 0", "γ = -15", "45°, γ > 0", "γ = -15", "65°, γ > 0", "γ = -15"],
            rows,
        )


if __name__ == "__main__":
    by_incidence()
    choices()
    coats()
    cook_torrance()
