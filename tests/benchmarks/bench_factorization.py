"""Homomorphic factorization: accuracy (Table 1 of McCool, Ang and Ahmad 2001) and time."""

from __future__ import annotations

import resource
from dataclasses import asdict
from pathlib import Path
from statistics import median
from time import perf_counter

import numpy as np

from brdf_suite.cli.tools.bench import load_module
from brdf_suite.fitting.homomorphic.factorization import Factorization, accuracy, normalize_maps
from brdf_suite.fitting.homomorphic.product_fit import BIAS, average_samples, factorize
from brdf_suite.fitting.homomorphic.samples import FactorizationSamples, sample_reflectance
from brdf_suite.fitting.homomorphic.solve import MapLayout, constraints
from brdf_suite.geometry.factor_words import DEFAULT_FACTORS, parse_factors
from brdf_suite.progress import Progress, report, subrange
from brdf_suite.reflectance.models.cook_torrance import CookTorrance
from brdf_suite.reflectance.models.table_1 import TABLE_1
from brdf_suite.reflectance.tabulated.isotropic import IsotropicTable
from tools.evaluation.factor_storage import STORES, compression, quantize_maps
from tools.evaluation.separable_expansion import separate

_held_out = load_module(Path(__file__).parent / "parts" / "factorization_held_out.py")
_samples = load_module(Path(__file__).parent / "parts" / "factorization_samples.py")
_shading = load_module(Path(__file__).parent / "parts" / "factorization_shading.py")

NAME = "factorization"

#: key: (comparison, bound, unit, meaning)
BOUNDS: dict[str, tuple[str, float | None, str, str]] = {
    "snr_db": (">=", 13.4, "dB", "Poulin-Fournier cylinders, 57,600 pairs, p(wo) q(h) p(wi) at 32×32"),
    "snr_iterative_db": (
        ">=",
        None,
        "dB",
        "the same by LSMR from coarse to fine; within .2 dB of the direct solution",
    ),
    "snr_16_db": (">=", None, "dB", "the same at 16×16 (the paper: 13.30)"),
    "snr_naive_db": (">=", None, "dB", "averaged projection at 16×16 (the paper: 9.08)"),
    "time_32_s": ("<=", 0.5, "s", "57,600 samples, 32×32, RGB, median of 5"),
    "merl_64_s": ("<=", 30.0, "s", "every bin of a 90 × 90 × 180 table of Polaris Silver, 64×64, RGB"),
    "memory_mb": ("<=", 1536.0, "MB", "peak resident size of the process after that"),
    "snr_gap_db": ("<=", 0.2, "dB", "loss of LSMR against the direct solution"),
    **_held_out.BOUNDS,
    **_shading.BOUNDS,
}
NOTES: dict[str, str] = {}
TABLES: dict[str, dict[str, object]] = {}
REPEATS = 5


def naive(samples: FactorizationSamples, resolution: int) -> np.ndarray:
    """Return the approximation by averaged projection at the samples."""
    factors = parse_factors(DEFAULT_FACTORS)
    layout = MapLayout.of(factors, resolution)
    scale = samples.values.mean(axis=0)
    wanted = np.log(samples.values / scale + BIAS)
    found = average_samples(constraints(layout, samples.wi, samples.wo), layout, wanted)
    return normalize_maps(factors, layout.maps(found), scale).eval(samples.wi, samples.wo)


def run(progress: Progress | None = None) -> dict[str, float]:
    """Measure everything; ``TABLES`` holds the rows of Table 1 and of textures."""
    report(progress, 0.0, "cylinders")
    samples = _samples.cylinders()
    figures, rows = {}, {}
    for key, name, resolution, solver in (
        ("snr_db", "homomorphic, 32×32", 32, "auto"),
        ("snr_iterative_db", "the same by LSMR", 32, "iterative"),
        ("snr_16_db", "homomorphic, 16×16", 16, "auto"),
    ):
        found = factorize(samples.wi, samples.wo, samples.values, resolution=resolution, solver=solver)
        near = accuracy(samples.values, found.product.eval(samples.wi, samples.wo))
        rows[name] = {"compression": round(compression(found.product, len(samples)), 1), **asdict(near)}
        figures[key] = near.snr_db
        if key == "snr_db":
            TABLES["textures"] = _textures(found.product, samples)
            TABLES["mean"] = _mean(samples, resolution)
    figures["snr_gap_db"] = figures["snr_db"] - figures["snr_iterative_db"]
    near = accuracy(samples.values, naive(samples, 16))
    rows["averaged projection, 16×16"] = {"compression": round(len(samples) / 512, 1), **asdict(near)}
    figures["snr_naive_db"] = near.snr_db
    TABLES["table_1"] = rows
    TABLES["singular_values"] = _singular(samples)
    report(progress, 0.15, "time")
    times = []
    for _ in range(REPEATS):
        start = perf_counter()
        factorize(samples.wi, samples.wo, samples.values, resolution=32)
        times.append(perf_counter() - start)
    figures["time_32_s"] = median(times)
    report(progress, 0.25, "a full table")
    table = sample_reflectance(
        IsotropicTable.from_reflectance(CookTorrance(TABLE_1["table1_polaris_silver"]))
    )
    NOTES["merl_64_s"] = f"{len(table):,} samples"
    start = perf_counter()
    factorize(table.wi, table.wo, table.values, resolution=64, progress=subrange(progress, 0.25, 0.6))
    figures["merl_64_s"] = perf_counter() - start
    figures["memory_mb"] = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024.0
    measured, tables = _held_out.figures(subrange(progress, 0.6, 0.85))
    TABLES.update(tables)
    if not tables:
        NOTES.update(dict.fromkeys(_held_out.BOUNDS, "no measured file at hand"))
    figures |= {key: value if np.isfinite(value) else None for key, value in measured.items()}
    return figures | _shading.figures(subrange(progress, 0.85, 1.0))


def _mean(samples: FactorizationSamples, resolution: int) -> dict[str, object]:
    """What the correction of the mean does, on the samples themselves."""
    rows: dict[str, object] = {}
    for name, keep in (("corrected", True), ("as fitted", False)):
        found = factorize(samples.wi, samples.wo, samples.values, resolution=resolution, keep_mean=keep)
        rows[name] = {
            "alpha_times": found.mean_correction.tolist(),
            **asdict(accuracy(samples.values, found.product.eval(samples.wi, samples.wo))),
        }
    return rows


def _singular(samples: FactorizationSamples) -> dict[str, object]:
    """The expansion of the cylinders in 1 to 16 terms, at the same samples; at 32×32 and 16×16 texels, signed."""
    rows: dict[str, object] = {}
    whole = separate(_samples.Cylinders(), 16, half_size=32, difference_size=16)
    for terms in (1, 2, 4, 8, 16):
        found = whole.first(terms).eval(samples.wi, samples.wo)
        rows[f"{terms}"] = {
            "negative": float((found < 0.0).mean()),
            "compression": round(len(samples) / (terms * (32 * 32 + 16 * 16)), 1),
            **asdict(accuracy(samples.values, found)),
        }
    return rows


def _textures(product: Factorization, samples: FactorizationSamples) -> dict[str, object]:
    rows: dict[str, object] = {}
    for logarithmic in (False, True):
        for store in STORES:
            kept = quantize_maps(product, store, logarithmic=logarithmic)
            near = accuracy(samples.values, kept.product.eval(samples.wi, samples.wo))
            name = f"{store}, {'logarithms' if logarithmic else 'factors'}"
            rows[name] = {
                "bytes": kept.texture_bytes,
                "compression": round(samples.values.size * 4 / kept.texture_bytes, 1),
                "snr_db": near.snr_db,
                "mean_relative": near.mean_relative,
            }
    return rows
