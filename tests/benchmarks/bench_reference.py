"""Error of the real-time picture against path tracing, and speed of both tracers.

The first run needs hours on two cores. Path-traced pictures are kept in the folder
BRDF_SUITE_REFERENCE_KEEP, or the user's cache. An interrupted run resumes, and a run after a change of the real-time
renderer needs a few minutes.
"""

from __future__ import annotations

import os
from pathlib import Path
from time import process_time

from brdf_suite import variables
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

#: Every class of paint, by the key of its figures; files of the shared data where they are there.
CLASSES: dict[str, tuple[str, ...]] = {
    "designed": (*DESIGNED, "solid_white", "solid_red", "solid_black"),
    "two_light": ("gold_green_shift", "teal_violet_shift", "copper_red_shift", "magenta_gold_shift"),
    "satin": ("satin_blue", "satin_graphite", "satin_white"),
    "matte": ("matte_grey", "matte_white"),
    "table1": TABLE_1,
    "scattered": ("cayman.brdf", "krylon_blue.brdf", "bird_example.json", "retro-3M-jaune.dat"),
    "rgl": ("vch_golden_yellow_rgb.bsdf", "paper_white_rgb.bsdf"),
}
_MEANINGS = {
    "designed": ("metallic, solid and pearl paints", 0.6),
    "two_light": ("interference paints read under two lights", 1.2),
    "satin": ("satin paints", None),
    "matte": ("matte paints", 1.0),
    "table1": ("the eight Cook-Torrance paints of Table 1", 1.0),
    "scattered": ("scattered samples", 1.5),
    "rgl": ("RGL tensors", 1.2),
}

#: key: (comparison, bound, unit, meaning)
BOUNDS: dict[str, tuple[str, float | None, str, str]] = {
    **_raytraced.BOUNDS,
    **_terminator.BOUNDS,
    **{
        f"{key}_de00_mean": (
            "" if bound is None else "<=",
            bound,
            "",
            f"{words} on a sphere, all available environments: mean ΔE00",
        )
        for key, (words, bound) in _MEANINGS.items()
    },
    "worst_paint_de00_mean": (
        "<=",
        2.0,
        "",
        "the largest mean over the environments of a paint of any class",
    ),
    "share_above_10": ("<=", 0.001, "", "share of all object pixels above ΔE00 10"),
    "de00_p99": ("", None, "", "mean of the pictures' 99th percentiles, all classes"),
    "flip_mean": ("", None, "", "mean FLIP at 67 pixels per degree, all classes"),
    "traces_de00_mean": ("<=", 0.3, "", "difference of the two traces of a picture, mean ΔE00"),
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

SAMPLES, SIZE = 1280, (64, 64)


def run(progress: Progress | None = None) -> dict[str, float | None]:
    """Trace, draw and compare."""
    shared = shared_data()
    _, environments = lights(shared)
    keep = kept_traces()
    found: dict[str, float | None] = dict(_terminator.run())
    found |= _raytraced.figures(subrange(progress, 0.0, 0.1))
    TABLES.update(_raytraced.TABLES)
    sparkle = sparkle_energy_ratio(subrange(progress, 0.1, 0.2))
    cases: list[Case] = []
    for number, (key, names) in enumerate(CLASSES.items()):
        step = subrange(
            progress, 0.2 + 0.79 * number / len(CLASSES), 0.2 + 0.79 * (number + 1) / len(CLASSES)
        )
        there = paints_there(names, shared)
        own = _cases(there, environments, keep, step) if there else []
        found[f"{key}_de00_mean"] = summary(own)["de00_mean"] if own else None
        cases += own
    by_paint = {
        paint: summary([case for case in cases if case.paint == paint])
        for paint in dict.fromkeys(case.paint for case in cases)
    }
    TABLES["by_paint"] = dict(by_paint)
    worst = max(by_paint, key=lambda paint: by_paint[paint]["de00_mean"])
    NOTES["worst_paint_de00_mean"] = worst
    whole = summary(cases)
    return found | {
        "worst_paint_de00_mean": by_paint[worst]["de00_mean"],
        "share_above_10": whole["share_above_10"],
        "de00_p99": whole["de00_p99"],
        "flip_mean": whole["flip"],
        "traces_de00_mean": sum(case.noise.mean for case in cases) / len(cases),
        "sparkle_energy_ratio": sparkle,
        "sparkle_energy_error": abs(sparkle - 1.0),
        "environments": float(len(environments)),
        "megasamples_per_core_s": _speed(),
    }


def _cases(paints: list[str], environments: list[str], keep: Path, progress: Progress | None) -> list[Case]:
    order = Order(paints, environments, SIZE, SAMPLES, (DEFAULT_FORM,), keep=keep)
    return list(compare(order, progress))


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


def kept_traces() -> Path:
    """Return the folder in which traces are kept between runs."""
    return Path(os.environ.get(variables.REFERENCE_KEEP, default_root() / "bench_reference"))


def lights(shared: Path) -> tuple[list[str], list[str]]:
    """Return the shipped environments, and these with the shared ones."""
    shipped = list(environment_names())
    return shipped, [*shipped, *(str(path) for path in sorted((shared / "environments").glob("*.*")))]


def paints_there(names: tuple[str, ...], shared: Path) -> list[str]:
    """Return the shipped paints among ``names``, and the paths of those files of the shared data that are there."""
    paths = [shared / "brdf" / name for name in names]
    return [
        str(path) if path.exists() else name
        for name, path in zip(names, paths, strict=True)
        if "." not in name or path.exists()
    ]


def shared_data() -> Path:
    """Return the folder of the shared data, whether it is there or not."""
    checkout = Path(__file__).resolve().parents[2]
    return Path(os.environ.get("BRDF_SUITE_SHARED", checkout.parent / "shared")) / "data"
