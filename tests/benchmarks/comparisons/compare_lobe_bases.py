"""Print how well several lobe bases fit the shipped paints, with their coats (docs/method/fit.md).

python tests/benchmarks/comparisons/compare_lobe_bases.py
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from lobe_experiment import ENDING, HELD_OUT, MEASURED, arguments, paints, table

from brdf_suite.arrays import Floats
from brdf_suite.documents.paint import Gloss, Paint
from brdf_suite.documents.store import load_paint
from brdf_suite.errors import UnreachableError
from brdf_suite.fitting import LobeBasis, LobeFitter, LobeWeights, default_basis, log_spaced
from brdf_suite.fitting.lobes.basis import STORED_NAME, stored_bases
from brdf_suite.fitting.lobes.samples import CoatSamples
from brdf_suite.fitting.metrics import aspecular_delta_e
from brdf_suite.reflectance.designed.build import build_paint
from brdf_suite.reflectance.designed.coat_lobe import CoatLobe
from brdf_suite.reflectance.protocol import Layered
from brdf_suite.resources import resource, resource_names

LIMIT_S = 1.0  # quality, not speed, is compared here
BETWEEN = tuple(gamma for gamma in HELD_OUT if gamma > MEASURED[0])
ROUGHNESSES = np.geomspace(0.003, 0.1, 16)
#: What a search by hand found before there was one by machine: octaves for the flop, fives for the coats.
BY_HAND = (1.0, 2.0, 4.0, 8.0, 16.0, 80.0, 400.0, 2_000.0, 10_000.0, 50_000.0)
#: What the search found for the shipped paints before it had edits of them.
PAINTS_ALONE = (1.9399, 5.7547, 8.5066, 19.085, 81.802, 548.91, 3_601.5, 21_827.0, 116_000.0)
RULES = ("flake", "monotone", "polynomial")
#: L* at 45° of the edits, as shares of the way from the reading at 110° to that at 15°.
EDIT_SHARES = (0.2, 0.35, 0.5, 0.65, 0.8)
#: Coats less glossy than this at 20° are not edited: in the plane of incidence they are what limits the fit.
EDITED_FROM_GU = 20.0
#: Where edits are judged between the measured angles; no sample of the fit has base and coat together there.
EDIT_BETWEEN = (8.0, 20.0, 25.0, 30.0, 35.0, 60.0, 75.0, 90.0)
#: A measured angle is missed by more than this: it is seen beside the paint.
SEEN = 1.0


@dataclass(frozen=True)
class Whole:
    """Base and coat together, as an instrument sees a paint."""

    layers: Layered

    def eval(self, wi: Floats, wo: Floats) -> Floats:
        """Return f_r (..., 3)."""
        return np.asarray(self.layers.base.eval(wi, wo) + self.layers.coat.eval(wi, wo))


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
    energy = float(fine.solid_angle @ wanted)
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


def fits(fitter: LobeFitter, chosen: dict[str, Layered]) -> dict[str, tuple[Whole, LobeWeights]]:
    """Return each paint and its lobes."""
    return {name: (Whole(layers), fitter.fit(layers).weights) for name, layers in chosen.items()}


def per_basis(chosen: dict[str, Layered], roughnesses: Sequence[float]) -> None:
    """Print one line per basis."""
    found = default_basis()
    bases = {
        f"the default ({found.count})": found,
        "by hand: 1, 2, 4, 8, 16, then × 5 (10)": LobeBasis(BY_HAND),
        **{f"{n} log-spaced from 2": log_spaced(n, 2.0, 50_000.0) for n in (7, 8, 9, 10, 11)},
        "10 log-spaced from 1": log_spaced(10, 1.0, 50_000.0),
        "10 log-spaced from 4": log_spaced(10, 4.0, 50_000.0),
    }
    rows = []
    for name, basis in bases.items():
        fitter = LobeFitter(basis, time_limit_s=LIMIT_S)
        pairs = fits(fitter, chosen).values()
        measured = np.array([aspecular_delta_e(p, w, MEASURED) for p, w in pairs])
        between = np.array([aspecular_delta_e(p, w, BETWEEN) for p, w in pairs])
        coats = [coat_figures(fitter, float(roughness)) for roughness in roughnesses]
        misplaced = [c.misplaced for c in coats]
        energy = max(abs(c.fitted_energy / c.energy - 1.0) for c in coats)
        rows.append(
            [
                name,
                *(
                    f"{v:.2f}"
                    for v in (np.median(measured), measured.max(), np.median(between), between.max())
                ),
                *(f"{v:.3f}" for v in (np.mean(misplaced), np.max(misplaced))),
                f"{energy:.4f}",
            ]
        )
    header = ["basis", "ΔE00 at 15/45/110: median", "worst", "between: median", "worst"]
    table(
        [*header, "coat energy misplaced: mean", "worst", "coat energy error"], rows, f"{len(chosen)} paints"
    )


def read_paints(count: int | None) -> list[Paint]:
    """Return the shipped paints of readings at the three angles; ``count`` at most, spread over them."""
    names = resource_names("paints", ENDING)
    if count is not None:
        names = names[:: max(1, len(names) // count)][:count]
    found = (load_paint(resource("paints", name + ENDING)) for name in names)
    return [paint for paint in found if tuple(m.aspecular_deg for m in paint.measurements) == MEASURED]


def edits(chosen: Sequence[Paint]) -> list[Layered]:
    """Return the paints with L* at 45° moved, each to every one of :data:`EDIT_SHARES` that can be built."""
    found = []
    for paint in chosen:
        if paint.gloss.gu_20 < EDITED_FROM_GU:
            continue
        bright, middle, dark = (paint.lab_at(angle) for angle in MEASURED)
        for share in EDIT_SHARES:
            lightness = dark[0] + share * (bright[0] - dark[0])
            try:
                found.append(build_paint(paint.with_lab(MEASURED[1], (lightness, *middle[1:]))))
            except UnreachableError:  # the edit is one that Designer refuses
                continue
    return found


def per_edit(count: int | None) -> None:
    """Print what each basis makes of edited paints, of the paints themselves and of another rule between angles."""
    chosen = read_paints(count)
    groups = {
        "edits": edits(chosen),
        "paints": [build_paint(paint) for paint in chosen],
        "monotone": [build_paint(replace(paint, interpolation="monotone")) for paint in chosen],
    }
    found, default = stored_bases(resource("basis", STORED_NAME))
    bases = {
        f"found ({basis.count})" + (", the default" if basis.count == default else ""): basis
        for basis in found.values()
        if basis.count >= default - 2
    }
    bases[f"found for the paints alone ({len(PAINTS_ALONE)})"] = LobeBasis(PAINTS_ALONE)
    bases[f"by hand ({len(BY_HAND)})"] = LobeBasis(BY_HAND)
    rows = []
    for name, basis in bases.items():
        fitter = LobeFitter(basis, time_limit_s=LIMIT_S)
        cells = [name]
        for group, layers in groups.items():
            pairs = [(Whole(item), fitter.fit(item).weights) for item in layers]
            if group == "edits":
                worst = np.array([aspecular_delta_e(p, w, MEASURED).max() for p, w in pairs])
                cells += [str(int((worst > SEEN).sum())), f"{worst.max():.1f}"]
            between = np.array([aspecular_delta_e(p, w, EDIT_BETWEEN) for p, w in pairs])
            cells.append(f"{np.median(between):.2f} / {between.mean():.2f} / {between.max():.1f}")
        rows.append(cells)
    table(
        ["basis", f"edits missed by > {SEEN:g} at 15/45/110", "worst", *(f"{g}, between" for g in groups)],
        rows,
        f"edits: {len(groups['edits'])} of {len(chosen)} paints, but those below {EDITED_FROM_GU:g} GU; between: "
        f"median / mean / worst ΔE00 at {', '.join(f'{angle:g}' for angle in EDIT_BETWEEN)}°",
    )


def per_coat(fitter: LobeFitter) -> None:
    """Print the default fit of coats of n = 1.5 over their roughness."""
    rows = []
    for roughness in (0.002, 0.003, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2):
        c = coat_figures(fitter, roughness)
        shares = (c.peak_ratio, c.inside, c.fitted_inside, c.misplaced)
        rows.append(
            [f"{roughness:g}", f"{c.energy:.4f}", f"{c.fitted_energy:.4f}", *(f"{s:.3f}" for s in shares)]
        )
    table(
        ["α", "energy", "fitted", "peak, fitted / target", "within 0.9°", "fitted", "misplaced"],
        rows,
        "coats",
    )


def per_rule(fitter: LobeFitter, count: int | None) -> None:
    """Print the worst ΔE00 over the designed paints under each rule between the measured angles."""
    angles = (28.0, 57.0, 72.0, 88.0)
    rows = []
    for rule in RULES:
        pairs = fits(fitter, paints(rule, count)).values()
        worst = np.max([aspecular_delta_e(p, w, (*MEASURED, *angles)) for p, w in pairs], axis=0)
        rows.append([rule, f"{worst[:3].max():.2f}", *(f"{e:.1f}" for e in worst[3:])])
    table(
        ["rule", "15/45/110°", *(f"{a:g}°" for a in angles)],
        rows,
        "worst ΔE00 by the rule between the angles",
    )


def per_gloss(fitter: LobeFitter) -> None:
    """Print ΔE00 at 15° over the gloss for four shipped paints."""
    names = ("fine_silver", "blue", "dark_grey", "copper")
    rows = []
    for gu in (88.0, 50.0, 15.0, 8.0, 5.0):
        cells = [f"{gu:g}"]
        for name in names:
            paint = replace(load_paint(resource("paints", name + ENDING)), gloss=Gloss(gu))
            try:
                built = build_paint(paint)
            except UnreachableError:
                cells.append("unreachable")
                continue
            error = aspecular_delta_e(built, fitter.fit(built).weights, (MEASURED[0],))[0]
            cells.append(f"{error:.2f} (α = {built.roughness:.3f})")
        rows.append(cells)
    table(["20° gloss, GU", *names], rows, "ΔE00 at 15°, the whole paint, over gloss")


def per_paint(fitter: LobeFitter, chosen: dict[str, Layered], most: int = 12) -> None:
    """Print ΔE00 of the default fit for the paints that it fits worst."""
    angles = (*MEASURED, *BETWEEN, -15.0)
    errors = {n: aspecular_delta_e(p, w, angles) for n, (p, w) in fits(fitter, chosen).items()}
    ordered = sorted(errors, key=lambda name: -float(errors[name][:-1].max()))[:most]
    rows = [
        [
            name,
            *(f"{e:.2f}" for e in errors[name][:3]),
            f"{errors[name][3:-1].max():.2f}",
            f"{errors[name][-1]:.2f}",
        ]
        for name in ordered
    ]
    table(["paint", "15°", "45°", "110°", "between, worst", "-15°"], rows, "the paints that are fitted worst")


def main() -> None:
    """Print all tables."""
    given = arguments(__doc__ or "")
    chosen = paints(count=given.paints)
    per_basis(chosen, ROUGHNESSES[:2] if given.paints else ROUGHNESSES)
    per_edit(given.paints)
    fitter = LobeFitter(time_limit_s=LIMIT_S)
    per_coat(fitter)
    per_rule(fitter, given.paints)
    per_gloss(fitter)
    per_paint(fitter, chosen)


if __name__ == "__main__":
    main()
