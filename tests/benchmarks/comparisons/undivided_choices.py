"""Compare choices of the undivided fit (docs/method/measured_fits.md, "The samples and weights").

    python tests/benchmarks/comparisons/undivided_choices.py [DATA]

Over ten reflectances that can be evaluated everywhere (two measured, four of Table 1, two designed paints, two
models), each fitted as one. "energy" is the error of the directional reflectance at a view angle that no fit uses.
"""

from __future__ import annotations

import argparse
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path
from unittest import mock

import numpy as np

from brdf_suite.files.measured import read_measured
from brdf_suite.fitting.lobes import measured, measured_samples
from brdf_suite.fitting.lobes.measured import fit_rows
from brdf_suite.fitting.lobes.measured_samples import INCIDENCES_DEG, reflectance_rows
from brdf_suite.fitting.lobes.samples import CoatSamples
from brdf_suite.fitting.lobes.weights import LobeWeights
from brdf_suite.fitting.metrics import aspecular_delta_e, error_figures
from brdf_suite.pipeline.fit_errors import hemisphere_pairs
from brdf_suite.pipeline.material import load_shipped_paint
from brdf_suite.reflectance.designed.build import build_paint
from brdf_suite.reflectance.models.cook_torrance import CookTorrance
from brdf_suite.reflectance.models.table_1 import TABLE_1
from brdf_suite.reflectance.protocol import Reflectance
from brdf_suite.reflectance.registry import MODELS

VIEWS_DEG = (15.0, 37.0, 52.0, 68.0)
UNUSED_GAMMAS_DEG = (-15.0, 25.0, 75.0)
FITTED_GAMMAS_DEG = (15.0, 45.0, 110.0)
VARIANTS: tuple[tuple[str, dict[str, object]], ...] = (
    ("default", {}),
    ("power 0", {"POWER": 0.0}),
    ("power .33", {"POWER": 0.33}),
    ("power .67, floor .02", {"FLOOR": 0.02}),
    ("power .67, floor .5", {"FLOOR": 0.5}),
    ("power 1", {"POWER": 1.0}),
    ("plane weighs 1", {"PLANE_WEIGHT": 1.0}),
    ("plane weighs 20", {"PLANE_WEIGHT": 20.0}),
    ("no energy row", {"ENERGY_WEIGHT": 1e-9}),
    ("energy row weighs 8", {"ENERGY_WEIGHT": 8.0}),
    ("30, 60° (undetermined)", {"incidences": (30.0, 60.0)}),
    ("20, 45, 65°", {"incidences": (20.0, 45.0, 65.0)}),
    ("10, 45, 75°", {"incidences": (10.0, 45.0, 75.0)}),
    ("5, 15 … 75°", {"incidences": tuple(5.0 + 10.0 * k for k in range(8))}),
    ("rings every .2 in ln γ", {"LOG_STEP": 0.2}),
    ("rings every .8", {"LOG_STEP": 0.8}),
    ("rings at most 20° apart", {"WIDEST_STEP_RAD": np.radians(20.0)}),
    ("3 azimuths", {"AZIMUTHS": 3}),
    ("12 azimuths", {"AZIMUTHS": 12}),
)


@dataclass(frozen=True, eq=False)
class Judge:
    """A reflectance with what it gives on the held-out directions, worked out once."""

    reflectance: Reflectance
    rings: tuple[CoatSamples, ...]
    energies: tuple[np.ndarray, ...]

    @classmethod
    def of(cls, reflectance: Reflectance) -> Judge:
        """Prepare."""
        rings = tuple(
            CoatSamples(theta_rad=float(np.radians(v)), first_ring_rad=2e-4, log_step=0.1, azimuths=16)
            for v in VIEWS_DEG
        )
        energies = tuple(
            r.solid_angle @ (reflectance.eval(r.lights, r.view) * r.cosines[..., None]).mean(axis=1)
            for r in rings
        )
        return cls(reflectance, rings, energies)

    def score(self, weights: LobeWeights) -> np.ndarray:
        """Cosine-weighted RMS over the data's, cube-root RMS, ΔE00 fitted (mean) and not (mean), energy errors."""
        wi, wo, solid = hemisphere_pairs()
        figures = error_figures(self.reflectance, weights, wi, wo, solid)
        black = LobeWeights(weights.exponents, np.zeros(3), 0 * weights.kdd, 0 * weights.kg, 0.0, 1.0)
        whole = error_figures(self.reflectance, black, wi, wo, solid).cosine_rms
        energy = []
        for rings, wanted in zip(self.rings, self.energies, strict=True):
            given = weights.reflected(rings.lights, np.broadcast_to(rings.view, rings.lights.shape))
            energy.append(np.abs(rings.solid_angle @ given.mean(axis=1) / wanted - 1.0).max())
        fitted, unused = (
            aspecular_delta_e(self.reflectance, weights, gammas).mean()
            for gammas in (FITTED_GAMMAS_DEG, UNUSED_GAMMAS_DEG)
        )
        return np.array([figures.cosine_rms / whole, figures.cube_root_rms, fitted, unused, *energy])


def reflectances(data: Path) -> list[Reflectance]:
    """The ten."""
    found: list[Reflectance] = [
        read_measured(data / name) for name in ("paper_white_rgb.bsdf", "vch_golden_yellow_rgb.bsdf")
    ]
    found += [
        CookTorrance(TABLE_1[f"table1_{n}"]) for n in ("ford_f8", "polaris_silver", "white", "blue_matte")
    ]
    found += [build_paint(load_shipped_paint(name)) for name in ("blue", "fine_silver")]
    return found + [MODELS[name].default for name in ("ggx", "ggx_clearcoat")]


def compare(judges: list[Judge], changed: dict[str, object]) -> tuple[float, float, np.ndarray]:
    """Rows, milliseconds and mean scores of a fit with some constants changed."""
    settings = dict(changed)
    incidences = settings.pop("incidences", INCIDENCES_DEG)
    scores, rows_used, seconds = [], [], []
    for judge in judges:
        with ExitStack() as changes:
            for name, value in settings.items():
                module = measured if hasattr(measured, name) else measured_samples
                changes.enter_context(mock.patch.object(module, name, value))
            rows = reflectance_rows(judge.reflectance, incidences)  # type: ignore[arg-type]  # of the table above
            fit = fit_rows(rows, judge.reflectance.eval(rows.wi, rows.wo))
        scores.append(judge.score(fit.weights))
        rows_used.append(fit.rows)
        seconds.append(fit.seconds)
    return float(np.mean(rows_used)), 1e3 * float(np.median(seconds)), np.mean(scores, axis=0)


def main() -> None:
    """Print the table."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("data", nargs="?", type=Path, default=Path("../shared/data/brdf"))
    judges = [Judge.of(reflectance) for reflectance in reflectances(parser.parse_args().data)]
    views = " | ".join(f"energy {v:.0f}°" for v in VIEWS_DEG)
    print(f"| | rows | ms | RMS, of the data's | cube-root | ΔE00 15/45/110 | ΔE00 -15/25/75 | {views} |")
    print("|---|---|---|---|---|---|---|---|---|---|---|")
    for name, changed in VARIANTS:
        rows, ms, score = compare(judges, changed)
        cells = " | ".join(f"{value:.2f}" if k in (2, 3) else f"{value:.3f}" for k, value in enumerate(score))
        print(f"| {name} | {rows:.0f} | {ms:.1f} | {cells} |", flush=True)


if __name__ == "__main__":
    main()
