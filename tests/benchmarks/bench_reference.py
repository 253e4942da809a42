"""How far the real-time picture is from the path-traced one, and how fast paths are traced."""

from __future__ import annotations

import os
from pathlib import Path
from time import perf_counter

from brdf_suite.documents.view import View
from brdf_suite.pipeline.agreement import Case, Order, compare, summary
from brdf_suite.pipeline.reference_scene import prepare_reference
from brdf_suite.pipeline.scene import environment_names
from brdf_suite.progress import Progress, part
from brdf_suite.reflectance.models.table_1 import TABLE_1

NAME = "reference"

#: The sixteen of docs/reference.md: from analytic fits of measured paints, and invented.
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
    "designed_de00_mean": (
        "<=",
        1.2,
        "",
        "16 designed paints on a sphere, all environments at hand: mean ΔE00",
    ),
    "designed_de00_worst": ("<=", 4.0, "", "the same, the worst paint's mean"),
    "designed_de00_p99": ("<=", 6.0, "", "the same, mean of the pictures' 99th percentiles"),
    "designed_flip": ("<=", 0.05, "", "the same, mean FLIP at 67 pixels per degree"),
    "designed_noise_de00": ("", None, "", "what the path tracer's own noise gives, mean ΔE00"),
    "measured_de00_mean": ("<=", 3.0, "", "the eight of Table 1 and a measured yellow: mean ΔE00"),
    "measured_flip": ("<=", 0.10, "", "the same, mean FLIP"),
    "environments": (
        "",
        None,
        "",
        "how many there were: those shipped, and the shared ones where there are any",
    ),
    "megasamples_per_s": ("", None, "1/µs", "paths of a designed paint on the speed form, sunny, 320×240"),
}

NOTES: dict[str, str] = {}
TABLES: dict[str, dict[str, object]] = {}

SAMPLES = 256
KEEP = "BRDF_SUITE_REFERENCE_KEEP"
"""A folder, named by this environment variable, where what is traced is kept between runs."""


def run(progress: Progress | None = None) -> dict[str, float | None]:
    """Trace, draw and compare; an hour on two cores where nothing is kept."""
    shared = _shared()
    environments = [
        *environment_names(),
        *(str(path) for path in sorted((shared / "environments").glob("*.*"))),
    ]
    yellow = shared / "brdf" / "vch_golden_yellow_rgb.bsdf"
    keep = Path(os.environ[KEEP]) if KEEP in os.environ else None
    designed = _cases(DESIGNED, environments, keep, part(progress, 0.0, 0.6))
    measured_paints = [*TABLE_1, *([str(yellow)] if yellow.exists() else [])]
    measured = _cases(measured_paints, environments, keep, part(progress, 0.6, 0.95))
    of_designed, of_measured = summary(designed), summary(measured)
    TABLES["by_paint"] = {
        paint: {
            form: sum(case.errors[form].mean for case in designed if case.paint == paint)
            / sum(case.paint == paint for case in designed)
            for form in designed[0].errors
        }
        for paint in dict.fromkeys(case.paint for case in designed)
    }
    for form in designed[0].errors:
        s = summary(designed, form)
        NOTES[form] = f"ΔE00 {s['de00_mean']:.2f}, worst paint {s['de00_worst']:.2f}, FLIP {s['flip']:.3f}"
    return {
        "designed_de00_mean": of_designed["de00_mean"],
        "designed_de00_worst": of_designed["de00_worst"],
        "designed_de00_p99": of_designed["de00_p99"],
        "designed_flip": of_designed["flip"],
        "designed_noise_de00": sum(case.noise.mean for case in designed) / len(designed),
        "measured_de00_mean": of_measured["de00_mean"],
        "measured_flip": of_measured["flip"],
        "environments": float(len(environments)),
        "megasamples_per_s": _speed(),
    }


def _cases(
    paints: tuple[str, ...] | list[str], environments: list[str], keep: Path | None, progress: Progress
) -> list[Case]:
    return list(compare(Order(paints, environments, samples=SAMPLES, keep=keep), progress))


def _speed() -> float:
    from brdf_suite.reference.passes import trace_pass

    size, samples = (320, 240), 64
    scene = prepare_reference("red", View(environment="sunny", surface="speed_form"), size)
    trace_pass(scene.traced, samples, 0)  # compiles
    start = perf_counter()
    trace_pass(scene.traced, samples, 1)
    return size[0] * size[1] * samples / (perf_counter() - start) / 1e6


def _shared() -> Path:
    checkout = Path(__file__).resolve().parents[2]
    return Path(os.environ.get("BRDF_SUITE_SHARED", checkout.parent / "shared")) / "data"
