"""How fast the ray tracer is, and how good: figures of ``bench reference``.

Times are processor time of all threads, so that they are per core and hang little on what else the machine does.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from statistics import median
from time import process_time

import numpy as np

from brdf_suite.documents.view import Camera, View
from brdf_suite.documents.view_settings import Sparkle, SurfaceLook
from brdf_suite.progress import Progress, report, subrange
from brdf_suite.tracing.raytraced.picture import Quality, RaytracedSession
from tools.evaluation.raytraced_presets import compare_presets

#: key: (comparison, bound, unit, meaning)
BOUNDS: dict[str, tuple[str, float | None, str, str]] = {
    "fast_fps_per_core": (">=", 2.0, "1/s", "ray tracer, fast (16, 1, 1), 640×480, speed form on the ground"),
    "medium_fps_per_core": (">=", 0.2, "1/s", "the same, medium (128, 16, 16)"),
    "high_core_seconds": ("<=", 250.0, "s", "the same, high (1024, 256, 64), 1280×960"),
    "mis_time_ratio": (
        "",
        None,
        "",
        "path tracing with MIS over the high preset: time to the same mean ΔE00",
    ),
    "raytraced_sparkle_ratio": (
        "",
        None,
        "",
        "ray tracer: mean radiance with flakes / without, worst of four paints",
    ),
}

TABLES: dict[str, dict[str, object]] = {}

PAINT = "copper"
VIEW = View(environment="sunny", surface="speed_form", surface_look=SurfaceLook(ground=True))
SPARKLING = ("blue", "coarse_silver", "copper", "silver_metallic")
_REPEATS = 7


def figures(progress: Progress | None = None) -> dict[str, float | None]:
    """Measure; some minutes on two cores."""
    session = RaytracedSession()
    report(progress, 0.0, "ray tracing")
    fast = _seconds(session, "fast", (640, 480), _REPEATS)
    medium = _seconds(session, "medium", (640, 480), 3)
    report(progress, 0.1, "ray tracing, high")
    high = _seconds(session, "high", (1280, 960), 1)
    presets = compare_presets(PAINT, VIEW, (160, 120), progress=subrange(progress, 0.4, 0.9))
    TABLES["presets"] = {
        one.name: {
            "core_seconds": one.seconds,
            "de00_mean": one.errors.mean,
            "de00_p99": one.errors.p99,
            "flip": one.errors.flip,
        }
        for one in presets.tried
    }
    best = presets.tried[-1]
    return {
        "fast_fps_per_core": 1.0 / fast,
        "medium_fps_per_core": 1.0 / medium,
        "high_core_seconds": high,
        "mis_time_ratio": presets.paths_as_good_as(best.errors.mean) / best.seconds,
        "raytraced_sparkle_ratio": sparkle_ratio(session, subrange(progress, 0.9, 1.0)),
    }


def _seconds(session: RaytracedSession, quality: str, size: tuple[int, int], repeats: int) -> float:
    session.show(PAINT, VIEW, size, quality)
    next(session.passes())  # compiles, and builds what is built once
    times = []
    for _ in range(repeats):
        start = process_time()
        session.frame()
        times.append(process_time() - start)
    return median(times)


def sparkle_ratio(session: RaytracedSession, progress: Progress | None = None) -> float:
    """Return the ratio that is farthest from 1, of paints with flakes on a ball from near, in the sun."""
    view = View(environment="sunny", surface="sphere", camera=Camera(35.0, 30.0, distance=0.35))
    ratios: Mapping[str, float] = {}
    for index, paint in enumerate(SPARKLING):
        report(progress, index / len(SPARKLING), "flakes, ray-traced")
        means = []
        for mode in ("texture", "off"):
            shown = replace(view, sparkle=Sparkle(mode=mode))
            session.show(paint, shown, (1000, 800), Quality(64, 1, 1, mirror=True))
            image = session.frame()
            means.append(float(image.sums.radiance[image.sums.coverage == 1.0].mean()))
        ratios = {**ratios, paint: means[0] / means[1]}
    TABLES["sparkle"] = dict(ratios)
    return max(ratios.values(), key=lambda ratio: abs(np.log(ratio)))
