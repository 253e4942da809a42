"""Cayman and krylon blue, measured and scattered: how near factorizations come to samples that they have not seen.

Two measures. One draw of 20 % held out, as the goal has it; since a draw holds one or two of the six samples of the
mirror, in which nearly all of the square of these data lies, also five folds, in which every sample is held out once.
"""

from __future__ import annotations

import os
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np

from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.files.measured import read_measured
from brdf_suite.fitting.cook_torrance import Settings, fit_lobes
from brdf_suite.fitting.homomorphic.peak import MEASURED_SMOOTHNESS, factorize_with_peak
from brdf_suite.fitting.homomorphic.product_fit import factorize
from brdf_suite.fitting.homomorphic.samples import FactorizationSamples, sample_reflectance
from brdf_suite.fitting.lobes.measured import fit_undivided
from brdf_suite.geometry import warps
from brdf_suite.geometry.factor_words import MEASURED_FACTORS
from brdf_suite.progress import report
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples
from tools.evaluation.separable_expansion import separate

FILES = {"cayman": "cayman", "krylon": "krylon_blue"}
FOLDS = 5
AWAY_DEG = 3.0
"""Of the half vector from the normal, from which on a sample is away from the peak."""
SHARE = 0.2
MEASURED_BIAS = 1e-3
"""Over the mean of samples with their peak: values below a thousandth of it are noise."""
TERMS = (1, 2, 4, 8)

BOUNDS = {
    f"{key}_{figure}": ("<=", None, "", text.format(name=name.replace("_", " ")))
    for key, name in FILES.items()
    for figure, text in (
        ("heldout_rel_rms", "{name}, 20 % held out, radial maps with the peak apart: RMS error over RMS"),
        ("folds_rel_rms", "the same with every sample of {name} held out once, in five folds"),
        ("away_rel_rms", "the same for samples whose half vector is over 3° from the normal"),
        ("folds_median_rel", "{name}, five folds: median relative error of the luminance"),
    )
}
Evaluate = Callable[[np.ndarray, np.ndarray], np.ndarray]


def shared_file(name):
    """Return the measured file of that name, or None where it is not at hand."""
    root = Path(os.environ.get("BRDF_SUITE_SHARED", Path(__file__).resolve().parents[4] / "shared")) / "data"
    return next(iter(sorted(root.rglob(f"{name}.brdf"))), None)


def methods(measured: ScatteredSamples) -> dict[str, Callable[[FactorizationSamples], Evaluate]]:
    """Return what is compared, each from samples to something that evaluates."""

    def kept(samples: FactorizationSamples) -> ScatteredSamples:
        return replace(
            measured, wi=samples.wi, wo=samples.wo, values=samples.values, spectra=None, wavelengths_nm=None
        )

    def alone(factors: str) -> Callable[[FactorizationSamples], Evaluate]:
        settings = {"smooth": MEASURED_SMOOTHNESS, "bias": MEASURED_BIAS, "keep_mean": False}
        return lambda s: factorize(s.wi, s.wo, s.values, factors=factors, **settings).product.eval

    found = {
        "radial maps, peak apart (as the command does)": lambda s: (
            factorize_with_peak(s, factors=MEASURED_FACTORS, smooth=MEASURED_SMOOTHNESS)[0].eval
        ),
        "the same, peak as a map over the hemisphere": lambda s: (
            factorize_with_peak(s, factors=MEASURED_FACTORS, smooth=MEASURED_SMOOTHNESS, form="map")[0].eval
        ),
        "the same without a peak": alone(MEASURED_FACTORS),
        "p(|wo|) q(|h|) p(|wi|)": alone("p:|wo| q:|h| p:|wi|"),
        "p(wo) q(h) p(wi)": alone("p:wo q:h p:wi"),
        "three Cook-Torrance lobes": lambda s: (
            fit_lobes(s.wi, s.wo, s.values, settings=Settings(lobes=3, starts=4)).eval
        ),
        "cosine lobes": lambda s: fit_undivided(kept(s)).weights.eval,
    }
    for terms in TERMS:
        found[f"singular values, {terms} term{'s' if terms > 1 else ''}"] = lambda s, terms=terms: (
            separate(kept(s), terms).eval
        )
    return found


def figures(progress=None):
    """Return the figures of :data:`BOUNDS`, NaN where a file is not at hand, and the rows of all methods."""
    found, tables = {}, {}
    for number, (key, name) in enumerate(FILES.items()):
        path = shared_file(name)
        if path is None:
            found |= {bound: float("nan") for bound in BOUNDS if bound.startswith(key)}
            continue
        measured = read_measured(path)
        assert isinstance(measured, ScatteredSamples)
        samples = sample_reflectance(measured)
        rows = {}
        for place, (title, make) in enumerate(methods(measured).items()):
            report(progress, (number + place / 11) / 2, f"{name}: {title}")
            rows[title] = _row(samples, make, folds=not title.startswith("singular"))
        tables[f"{key}_heldout"] = rows
        best = next(iter(rows.values()))
        found |= {
            f"{key}_heldout_rel_rms": best["held_out"],
            f"{key}_folds_rel_rms": best["folds"],
            f"{key}_away_rel_rms": best["away"],
            f"{key}_folds_median_rel": best["median"],
        }
    return found, tables


def _row(
    samples: FactorizationSamples, make: Callable[[FactorizationSamples], Evaluate], *, folds: bool
) -> dict[str, float]:
    fit, held = samples.held_out(SHARE)
    row = {"held_out": relative_rms(held.values, make(fit)(held.wi, held.wo))}
    # An expansion over a grid takes half a minute a fold, and its place is plain from the draw.
    order = np.random.default_rng(5).permutation(len(samples))
    fold = np.arange(len(samples)) % FOLDS
    seen = np.zeros_like(samples.values)
    for one in range(FOLDS if folds else 0):
        out = order[fold == one]
        seen[out] = make(samples.part(order[fold != one]))(samples.wi[out], samples.wo[out])
    if folds:
        tilt = np.degrees(np.arccos(np.clip(warps.half_vector(samples.wi, samples.wo)[:, 2], -1.0, 1.0)))
        away = tilt > AWAY_DEG
        wanted, got = samples.values @ LUMINANCE, seen @ LUMINANCE
        lit = wanted > 0.0
        row["folds"] = relative_rms(samples.values, seen)
        row["away"] = relative_rms(samples.values[away], seen[away])
        row["median"] = float(np.median(np.abs(got[lit] / wanted[lit] - 1.0)))
    return row


def relative_rms(wanted: np.ndarray, found: np.ndarray) -> float:
    """RMS of the error over the RMS of the values: what SNR says in decibels."""
    return float(np.sqrt(np.mean((found - wanted) ** 2) / np.mean(wanted**2)))
