"""Homomorphic factorization: how near it comes (Table 1 of McCool, Ang and Ahmad 2001), and how long it takes."""

from __future__ import annotations

import importlib.util
import os
import resource
import sys
from dataclasses import replace
from pathlib import Path
from statistics import median
from time import perf_counter
from types import ModuleType

import numpy as np

from brdf_suite.files.measured.registry import read_measured
from brdf_suite.fitting.homomorphic.accuracy import accuracy
from brdf_suite.fitting.homomorphic.constraints import Layout, constraints
from brdf_suite.fitting.homomorphic.factorization import normalized
from brdf_suite.fitting.homomorphic.factorize import BIAS, factorize
from brdf_suite.fitting.homomorphic.peak import factorize_with_peak
from brdf_suite.fitting.homomorphic.projected import averaged
from brdf_suite.fitting.homomorphic.samples import Samples, samples_of
from brdf_suite.fitting.homomorphic.separable import separate
from brdf_suite.fitting.homomorphic.storage import compression, stored
from brdf_suite.fitting.lobes.undivided import fit_undivided
from brdf_suite.geometry.factor_words import DEFAULT_FACTORS, parse_factors
from brdf_suite.progress import Progress, part, report
from brdf_suite.reflectance.models.cook_torrance import CookTorrance
from brdf_suite.reflectance.models.table_1 import TABLE_1
from brdf_suite.reflectance.tabulated.isotropic import IsotropicTable
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples

NAME = "factorization"

#: key: (comparison, bound, unit, meaning)
BOUNDS: dict[str, tuple[str, float | None, str, str]] = {
    "snr_db": (">=", 13.4, "dB", "Poulin-Fournier cylinders, 57,600 pairs, p(wo) q(h) p(wi) at 32×32"),
    "snr_iterative_db": (
        ">=",
        None,
        "dB",
        "the same by LSMR from coarse to fine; within .2 dB of the direct answer",
    ),
    "snr_16_db": (">=", None, "dB", "the same at 16×16 (the paper: 13.30)"),
    "snr_naive_db": (">=", None, "dB", "averaged projection at 16×16 (the paper: 9.08)"),
    "time_32_s": ("<=", 0.5, "s", "57,600 samples, 32×32, RGB, median of 5"),
    "merl_64_s": ("<=", 30.0, "s", "every bin of a 90 × 90 × 180 table of Polaris Silver, 64×64, RGB"),
    "memory_mb": ("<=", 1536.0, "MB", "largest resident size of the process after that"),
    "cayman_heldout_rel_rms": (
        "<=",
        None,
        "",
        "cayman, 20 % of the samples held out, radial maps: RMS of the error over RMS",
    ),
    "krylon_heldout_rel_rms": ("<=", None, "", "krylon blue, as cayman"),
}
NOTES: dict[str, str] = {}
TABLES: dict[str, dict[str, object]] = {}
REPEATS = 5
MEASURED_FACTORS = "p:|wo| q:|h| p:|wi| d:w.h"
"""Of isotropic measurements: radial maps, and one over the angle of Fresnel's formulas."""
MEASURED_BIAS = 1e-3
"""Values below a thousandth of the mean are noise."""


def _samples() -> ModuleType:
    """Return the module beside this one that makes the paper's sample set."""
    path = Path(__file__).with_name("factorization_samples.py")
    spec = importlib.util.spec_from_file_location("factorization_samples", path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    return module


def naive(samples: Samples, resolution: int) -> np.ndarray:
    """Return the approximation by averaged projection at the samples."""
    factors = parse_factors(DEFAULT_FACTORS)
    layout = Layout.of(factors, resolution)
    scale = samples.values.mean(axis=0)
    wanted = np.log(samples.values / scale + BIAS)
    found = averaged(constraints(layout, samples.wi, samples.wo), layout, wanted)
    return normalized(factors, layout.maps(found), scale).eval(samples.wi, samples.wo)


def run(progress: Progress | None = None) -> dict[str, float]:
    """Measure everything; ``TABLES`` holds the rows of Table 1 and of textures."""
    report(progress, 0.0, "cylinders")
    samples = _samples().cylinders()
    figures, rows = {}, {}
    for key, name, resolution, solver in (
        ("snr_db", "homomorphic, 32×32", 32, "auto"),
        ("snr_iterative_db", "the same by LSMR", 32, "iterative"),
        ("snr_16_db", "homomorphic, 16×16", 16, "auto"),
    ):
        found = factorize(samples.wi, samples.wo, samples.values, resolution=resolution, solver=solver)
        near = accuracy(samples.values, found.product.eval(samples.wi, samples.wo))
        rows[name] = {"compression": round(compression(found.product, len(samples)), 1), **near.to_json()}
        figures[key] = near.snr_db
        if key == "snr_db":
            TABLES["textures"] = _textures(found.product, samples)
    near = accuracy(samples.values, naive(samples, 16))
    rows["averaged projection, 16×16"] = near.to_json()
    figures["snr_naive_db"] = near.snr_db
    TABLES["table_1"] = rows
    report(progress, 0.15, "time")
    times = []
    for _ in range(REPEATS):
        start = perf_counter()
        factorize(samples.wi, samples.wo, samples.values, resolution=32)
        times.append(perf_counter() - start)
    figures["time_32_s"] = median(times)
    report(progress, 0.25, "a full table")
    table = samples_of(IsotropicTable.from_reflectance(CookTorrance(TABLE_1["table1_polaris_silver"])))
    NOTES["merl_64_s"] = f"{len(table):,} samples"
    start = perf_counter()
    factorize(table.wi, table.wo, table.values, resolution=64, progress=part(progress, 0.25, 0.9))
    figures["merl_64_s"] = perf_counter() - start
    figures["memory_mb"] = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024.0
    for key in ("cayman", "krylon"):
        found_error = _held_out(key)
        if found_error is not None:
            figures[f"{key}_heldout_rel_rms"] = found_error
    return figures


def _textures(product: object, samples: Samples) -> dict[str, object]:
    rows: dict[str, object] = {}
    for logarithmic in (False, True):
        for store in ("8-bit", "half", "float"):
            kept = stored(product, store, logarithmic=logarithmic)  # type: ignore[arg-type] # a literal of the three
            near = accuracy(samples.values, kept.product.eval(samples.wi, samples.wo))
            name = f"{store}, {'logarithms' if logarithmic else 'factors'}"
            rows[name] = {
                "bytes": kept.texture_bytes,
                "snr_db": near.snr_db,
                "mean_relative": near.mean_relative,
            }
    return rows


def _held_out(key: str) -> float | None:
    root = Path(os.environ.get("BRDF_SUITE_SHARED", Path(__file__).resolve().parents[3] / "shared")) / "data"
    files = sorted(root.rglob(f"{key}*.brdf"))
    if not files:
        NOTES[f"{key}_heldout_rel_rms"] = "no measured file at hand"
        return None
    measured = read_measured(files[0])
    assert isinstance(measured, ScatteredSamples)
    samples = samples_of(measured)
    fit, held = samples.held_out(0.2)
    rows: dict[str, object] = {}
    kept = replace(measured, wi=fit.wi, wo=fit.wo, values=fit.values, spectra=None, wavelengths_nm=None)
    radial = factorize(
        fit.wi, fit.wo, fit.values, factors=MEASURED_FACTORS, bias=MEASURED_BIAS, keep_mean=False
    )
    for name, model in (
        ("homomorphic, p(wo) q(h) p(wi)", factorize(fit.wi, fit.wo, fit.values, bias=MEASURED_BIAS).product),
        ("homomorphic, radial, with w.h", radial.product),
        ("homomorphic, peak apart", factorize_with_peak(fit, bias=MEASURED_BIAS)[0]),
        *((f"singular values, {terms}", separate(kept, terms)) for terms in (1, 4)),
        ("lobes", fit_undivided(kept).weights),
    ):
        found = model.eval(held.wi, held.wo)
        rows[name] = {
            "relative_rms": relative_rms(held.values, found),
            "median_relative": accuracy(held.values, found).median_relative,
        }
    TABLES[f"{key}_heldout"] = rows
    return relative_rms(held.values, radial.product.eval(held.wi, held.wo))


def relative_rms(wanted: np.ndarray, found: np.ndarray) -> float:
    """RMS of the error over the RMS of the values: what SNR says in decibels."""
    return float(np.sqrt(np.mean((found - wanted) ** 2) / np.mean(wanted**2)))
