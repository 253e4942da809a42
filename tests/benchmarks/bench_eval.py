"""Speed of loading and evaluating reflectances, and albedo of the models; 10⁶ direction pairs."""

from __future__ import annotations

import tempfile
from pathlib import Path
from statistics import median
from time import perf_counter

import numpy as np

from brdf_suite.files.measured.merl import read_merl, write_merl
from brdf_suite.geometry.directions import illumination
from brdf_suite.progress import Progress, report, subrange
from brdf_suite.reflectance.albedo import directional_albedo
from brdf_suite.reflectance.checks import check_model
from brdf_suite.reflectance.designed.coat_lobe import CoatLobe
from brdf_suite.reflectance.models.coated import Coated
from brdf_suite.reflectance.models.cook_torrance import CookTorrance
from brdf_suite.reflectance.models.ggx import Ggx
from brdf_suite.reflectance.models.lambertian import Lambertian
from brdf_suite.reflectance.models.table_1 import TABLE_1
from brdf_suite.reflectance.protocol import Reflectance
from brdf_suite.reflectance.registry import MODELS
from brdf_suite.reflectance.tabulated.isotropic import IsotropicTable

NAME = "eval"

#: key: (comparison, bound, unit, meaning)
BOUNDS: dict[str, tuple[str, float | None, str, str]] = {
    "merl_load_s": (
        "<=",
        0.3,
        "s",
        "35 MB MERL file, a tenth of it holes above the horizon, to a table: conversion and filling, median of 5",
    ),
    "table_eval_1e6_s": ("<=", 0.3, "s", "eval of that table on 10⁶ pairs, median of 5"),
    "ct3_eval_1e6_s": ("<=", 0.15, "s", "eval of Cook-Torrance with three lobes on 10⁶ pairs, median of 5"),
    "check": ("<=", 1.005, "", "largest albedo of any model that claims to conserve energy"),
    "furnace_low": (
        ">=",
        0.995,
        "",
        "white furnace by evaluation: least albedo of what loses no light, 40 values of α to 0.6, 6 angles to 85°",
    ),
    "furnace_high": ("<=", 1.005, "", "the largest of them"),
}

NOTES: dict[str, str] = {}
TABLES: dict[str, dict[str, object]] = {}

FURNACE_ALPHAS = np.geomspace(0.002, 0.6, 40)
FURNACE_DEG = (0.0, 30.0, 60.0, 75.0, 81.0, 85.0)

PAIRS = 1_000_000
PAINT = "table1_polaris_silver"
REPEATS = 5


def random_pairs() -> tuple[np.ndarray, np.ndarray]:
    """Return two (10⁶, 3) arrays of directions, even over the hemisphere."""
    rng = np.random.default_rng(2005)
    z, phi = rng.random((2, PAIRS)), rng.uniform(0.0, 2.0 * np.pi, (2, PAIRS))
    s = np.sqrt(1.0 - z * z)
    wi, wo = np.stack((s * np.cos(phi), s * np.sin(phi), z), axis=-1)
    return wi, wo


def write_measured_like(path: Path) -> None:
    """Write a paint as MERL's layout with gaps as measurements have: blocks of bins, and bins at random."""
    table = IsotropicTable.from_reflectance(CookTorrance(TABLE_1[PAINT]))
    rng = np.random.default_rng(1)
    holes = np.array(table.holes)
    holes |= rng.random(holes.shape) < 0.05
    for at in rng.integers(0, np.array(holes.shape) - 6, size=(400, 3)):
        holes[tuple(slice(start, start + 6) for start in at)] = True
    write_merl(IsotropicTable(table.values, holes), path)


def seconds(reflectance: Reflectance, wi: np.ndarray, wo: np.ndarray) -> float:
    """Return the median time of one evaluation."""
    times = []
    for _ in range(REPEATS):
        start = perf_counter()
        reflectance.eval(wi, wo)
        times.append(perf_counter() - start)
    return median(times)


def largest_albedo(progress: Progress | None) -> float:
    """Return the largest albedo among claimants, and note the table of all models."""
    shown, largest = [], 0.0
    for index, (name, entry) in enumerate(MODELS.items()):
        report(progress, index / len(MODELS), f"albedo of {name}")
        checked = check_model(entry)
        TABLES.setdefault("check", {})[name] = {
            "claims_energy": entry.energy_conserving,
            "polar_deg": list(checked.incidence_deg),
            "albedo": checked.albedo.tolist(),
            "white_furnace": checked.furnace.tolist(),
        }
        albedo = float(max(checked.albedo.max(), checked.furnace.max()))
        shown.append(f"{name} {albedo:.3f}" + ("" if entry.energy_conserving else " (no claim)"))
        if entry.energy_conserving:
            largest = max(largest, albedo)
    NOTES["check"] = "largest directional albedo or white furnace of each: " + ", ".join(shown)
    return largest


def white_bodies(alpha: float) -> dict[str, Reflectance]:
    """Return reflectances of roughness ``alpha`` that lose no light."""
    found: dict[str, Reflectance] = {
        "GGX, F = 1": Ggx(0.0, 1.0, alpha),
        "GGX over a white body": Ggx(1.0, (0.04, 0.3, 0.9), alpha),
        "coat, F = 1": CoatLobe(1e9, alpha),
    }
    for ior in (1.3, 1.5, 1.7):
        found[f"coat of n = {ior:g} over a white body"] = Coated(Lambertian(1.0), ior, alpha)
    return found


def furnaces(progress: Progress | None) -> tuple[float, float]:
    """Return the least and the largest albedo of white bodies, and note where they are."""
    views, seen = illumination(np.array(FURNACE_DEG)), []
    for index, alpha in enumerate(FURNACE_ALPHAS.tolist()):
        report(progress, index / len(FURNACE_ALPHAS), f"white furnaces at α = {alpha:.3g}")
        for name, body in white_bodies(alpha).items():
            for angle, albedo in zip(FURNACE_DEG, directional_albedo(body, views, 32), strict=True):
                place = f"{name}, α = {alpha:.3g}, {angle:g}°"
                seen += [(float(value), place) for value in (albedo.min(), albedo.max())]
    (low, NOTES["furnace_low"]), (high, NOTES["furnace_high"]) = min(seen), max(seen)
    return low, high


def run(progress: Progress | None = None) -> dict[str, float | None]:
    """Measure and return the figures named in ``BOUNDS``."""
    wi, wo = random_pairs()
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "measured.binary"
        report(progress, 0.0, "writing a MERL table")
        write_measured_like(path)
        table = read_merl(path)  # imports and the file's first read stay out of the figures
        loads = []
        for repeat in range(REPEATS):
            report(progress, 0.1 + 0.02 * repeat, "loading a MERL table")
            start = perf_counter()
            read_merl(path)
            loads.append(perf_counter() - start)
    NOTES["merl_load_s"] = f"{table.facts['bins_filled']:,} bins filled"
    report(progress, 0.2, "evaluating")
    table_s = seconds(table, wi, wo)
    cook_torrance_s = seconds(CookTorrance(TABLE_1[PAINT]), wi, wo)
    albedo = largest_albedo(subrange(progress, 0.4, 0.8))
    low, high = furnaces(subrange(progress, 0.8, 1.0))
    report(progress, 1.0, "done")
    return {
        "merl_load_s": median(loads),
        "table_eval_1e6_s": table_s,
        "ct3_eval_1e6_s": cook_torrance_s,
        "check": albedo,
        "furnace_low": low,
        "furnace_high": high,
    }
