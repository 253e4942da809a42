"""Error of the real-time picture against path tracing, and speed of both tracers.

The first run needs some twenty minutes on two cores. Path-traced pictures are kept in the folder
BRDF_SUITE_REFERENCE_KEEP, or the user's cache. An interrupted run resumes, and a run after a change of the real-time
renderer needs a few minutes.
"""

from __future__ import annotations

import math
import os
from pathlib import Path
from time import process_time

from brdf_suite.cli.tools.bench import load_module
from brdf_suite.documents.view import View
from brdf_suite.files.cache.disk_cache import default_root
from brdf_suite.pipeline.scene import environment_names
from brdf_suite.progress import Progress, subrange
from brdf_suite.reflectance.models.table_1 import TABLE_1
from brdf_suite.tracing.agreement.comparison import Case, Order, compare, summary
from brdf_suite.tracing.agreement.forms import DEFAULT_FORM
from brdf_suite.tracing.reference.scene import prepare_reference
from tools.evaluation.reference_flakes import sparkle_energy_ratio

NAME = "reference"


_raytraced = load_module(Path(__file__).parent / "parts" / "raytraced_figures.py")
_terminator = load_module(Path(__file__).parent / "parts" / "terminator.py")

#: The sixteen of docs/method/reference.md: from analytic fits of measured paints, and invented.
DESIGNED = (
    "silver_metallic",
    "silver_metallic_2",
    "blue_metallic",
    "gold_metallic",
    "gold_metallic_3",
    "green_metallic",
    "red_metallic",
    "pearl",
    "fine_silver",
    "champagne",
    "dark_grey",
    "blue",
    "red",
    "copper",
    "white_pearl",
    "violet_shift",
)

#: key: (comparison, bound, unit, meaning)
BOUNDS: dict[str, tuple[str, float | None, str, str]] = {
    **_raytraced.BOUNDS,
    **_terminator.BOUNDS,
    "designed_de00_mean": (
        "<=",
        1.2,
        "",
        "16 designed paints on a sphere, all available environments: mean ΔE00",
    ),
    "designed_de00_worst": ("<=", 4.0, "", "the same, the worst paint's mean"),
    "designed_de00_p99": ("<=", 6.0, "", "the same, mean of the pictures' 99th percentiles"),
    "designed_flip": ("<=", 0.05, "", "the same, mean FLIP at 67 pixels per degree"),
    "designed_noise_de00": ("", None, "", "error of the path tracer's noise alone, mean ΔE00"),
    "designed_less_noise_de00": (
        "",
        None,
        "",
        "mean ΔE00 without noise: per picture, root of the squared error minus that of noise",
    ),
    "measured_de00_mean": ("<=", 3.0, "", "the eight paints of Table 1 and a measured yellow: mean ΔE00"),
    "measured_de00_worst": ("", None, "", "the same, the worst paint's mean"),
    "measured_de00_p99": ("", None, "", "the same, mean of the pictures' 99th percentiles"),
    "measured_flip": ("<=", 0.10, "", "the same, mean FLIP"),
    "measured_noise_de00": ("", None, "", "the same, error of the path tracer's noise alone"),
    "measured_less_noise_de00": ("", None, "", "the same, mean ΔE00 without noise"),
    "sparkle_energy_ratio": ("", None, "", "path tracer: mean radiance with single flakes / without"),
    "sparkle_energy_error": ("<=", 0.02, "", "its distance from 1"),
    "environments": (
        "",
        None,
        "",
        "number of environments: shipped, and shared ones if available",
    ),
    "megasamples_per_core_s": (
        "",
        None,
        "1/µs",
        "paths of a designed paint on the speed form, sunny, 320×240, by processor time",
    ),
}

NOTES: dict[str, str] = {}
TABLES: dict[str, dict[str, object]] = {}

SAMPLES = 128
KEEP = "BRDF_SUITE_REFERENCE_KEEP"
"""A folder, named by this environment variable, where what is traced is kept between runs."""


def run(progress: Progress | None = None) -> dict[str, float | None]:
    """Trace, draw and compare."""
    shared = _shared()
    environments = [
        *environment_names(),
        *(str(path) for path in sorted((shared / "environments").glob("*.*"))),
    ]
    yellow = shared / "brdf" / "vch_golden_yellow_rgb.bsdf"
    keep = Path(os.environ[KEEP]) if KEEP in os.environ else default_root() / "bench_reference"
    terminator = _terminator.run()
    raytraced = _raytraced.figures(subrange(progress, 0.0, 0.3))
    TABLES.update(_raytraced.TABLES)
    sparkle = sparkle_energy_ratio(subrange(progress, 0.3, 0.4))
    designed = _cases(DESIGNED, environments, keep, subrange(progress, 0.4, 0.8))
    measured_paints = (*TABLE_1, *([str(yellow)] if yellow.exists() else []))
    measured = _cases(measured_paints, environments, keep, subrange(progress, 0.8, 0.99))
    of_designed, of_measured = summary(designed), summary(measured)
    for name, cases in (("designed", designed), ("measured", measured)):
        TABLES[f"{name}_by_paint"] = {
            paint: summary([case for case in cases if case.paint == paint])
            for paint in dict.fromkeys(case.paint for case in cases)
        }
    return {
        **raytraced,
        **terminator,
        "designed_de00_mean": of_designed["de00_mean"],
        "designed_de00_worst": of_designed["de00_worst"],
        "designed_de00_p99": of_designed["de00_p99"],
        "designed_flip": of_designed["flip"],
        "designed_noise_de00": _noise(designed),
        "designed_less_noise_de00": _less_noise(designed),
        "measured_de00_mean": of_measured["de00_mean"],
        "measured_de00_worst": of_measured["de00_worst"],
        "measured_de00_p99": of_measured["de00_p99"],
        "measured_flip": of_measured["flip"],
        "measured_noise_de00": _noise(measured),
        "measured_less_noise_de00": _less_noise(measured),
        "sparkle_energy_ratio": sparkle,
        "sparkle_energy_error": abs(sparkle - 1.0),
        "environments": float(len(environments)),
        "megasamples_per_core_s": _speed(),
    }


def _cases(
    paints: tuple[str, ...], environments: list[str], keep: Path, progress: Progress | None
) -> list[Case]:
    order = Order(paints, environments, samples=SAMPLES, forms=(DEFAULT_FORM,), keep=keep)
    return list(compare(order, progress))


def _noise(cases: list[Case]) -> float:
    return sum(case.noise.mean for case in cases) / len(cases)


def _less_noise(cases: list[Case]) -> float:
    """Errors of the picture and of the noise have nothing to do with each other, so their squares add up."""
    found = [max(case.errors[DEFAULT_FORM].mean ** 2 - case.noise.mean**2, 0.0) for case in cases]
    return sum(math.sqrt(square) for square in found) / len(found)


def _speed() -> float:
    from brdf_suite.reference.passes import trace_pass

    size, samples = (320, 240), 64
    scene = prepare_reference("red", View(environment="sunny", surface="speed_form"), size)
    trace_pass(scene.traced, samples, 0)  # compiles
    start = process_time()
    trace_pass(scene.traced, samples, 1)
    traced = size[0] * size[1] * samples
    seconds: float = process_time() - start
    return traced / seconds / 1e6


def _shared() -> Path:
    checkout = Path(__file__).resolve().parents[2]
    return Path(os.environ.get("BRDF_SUITE_SHARED", checkout.parent / "shared")) / "data"
