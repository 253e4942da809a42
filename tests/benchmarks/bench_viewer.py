"""Frame times of the surface shader, as ratios to a baseline shader in the same run.

The fixed scene: a sphere of 100,000 triangles that covers 58 % of 1280x720, the default basis and the
default paint, Fresnel on, the environment as background, one sample a pixel. The baseline draws
the same frame with one reflection look-up and one diffuse look-up. Frames alternate, each waited for with glFinish,
so that whatever else the machine does falls on both.
"""

from __future__ import annotations

from pathlib import Path
from statistics import median
from time import perf_counter
from types import SimpleNamespace

import numpy as np

from brdf_suite.cli.bench import load_module
from brdf_suite.documents.paint import Paint
from brdf_suite.documents.view import Camera, View
from brdf_suite.fitting.lobes.basis import default_basis
from brdf_suite.lighting.prefilter import face_size
from brdf_suite.pipeline.paint import PaintFitter
from brdf_suite.pipeline.scene import default_paint
from brdf_suite.pipeline.shading_maps import map_exponents
from brdf_suite.progress import part, report
from brdf_suite.realtime.context import create_context
from brdf_suite.realtime.renderer import Renderer
from brdf_suite.realtime.values import CubeFaces, EnvironmentMaps, MaterialWeights, MeshPart

_sparkle = load_module(Path(__file__).with_name("viewer_sparkle.py"))

NAME = "viewer"
BOUNDS = {
    "paper_ratio": ("<=", 2.2, "", "frame of the default paint over the baseline frame, 1280x720, median"),
    "all_lobes_ratio": ("", None, "", "the same with a weight on every lobe of the basis, which no fit has"),
    "weights_change_ms": ("<=", 0.5, "ms", "weights changed, next frame at 64x64: extra cost, median"),
    "baseline_frame_ms": ("", None, "ms", "the baseline's frame, median"),
} | _sparkle.BOUNDS

BASELINE = Path(__file__).with_name("baseline.frag.glsl")
SIZE = (1280, 720)
COVERAGE = 0.58
RADIUS = 0.1
EXPONENTS = default_basis().exponents
MAP_EXPONENTS = map_exponents()
LARGEST_FACE = 512  # of an environment of 1024x512
ROUNDS = 60


def run(progress=None):
    """Return the figures of :data:`BOUNDS`."""
    found = _shading(part(progress, 0.0, 0.6))
    return found | _sparkle.figures(SimpleNamespace(**globals()), part(progress, 0.6, 1.0))


def _shading(progress=None):
    context = create_context()
    ours, every_lobe, baseline = (Renderer(context), Renderer(context), Renderer(context, BASELINE))
    view = View(Camera(azimuth_deg=0, elevation_deg=0, distance=_distance(), target=(0.0, 0.0, 0.0)))
    target, small = context.simple_framebuffer(SIZE), context.simple_framebuffer((64, 64))
    for renderer in (ours, every_lobe, baseline):
        renderer.set_environment(_maps())
        renderer.set_mesh([_sphere()])
    paint = default_paint()
    first = paint.measurements[0]
    edited = paint.with_lab(first.aspecular_deg, (first.lab[0] * 0.98, *first.lab[1:]))
    materials = [_weights(p) for p in (paint, edited)]
    ours.set_material("paint", materials[0])
    every_lobe.set_material("paint", _every_lobe())

    def frame(renderer, framebuffer, size):
        start = perf_counter()
        renderer.render(view, framebuffer, size, samples=1)
        context.finish()
        return (perf_counter() - start) * 1e3

    times = {ours: [], every_lobe: [], baseline: []}
    for i in range(ROUNDS + 3):
        report(progress, 0.7 * i / (ROUNDS + 3), "drawing in turn with the baseline")
        for renderer in times:
            ms = frame(renderer, target, SIZE)
            if i >= 3:
                times[renderer].append(ms)

    # A cheap mesh, so that the change is not lost in the noise of the draw.
    ours.set_mesh([_sphere(8)])
    extra = []
    for i in range(405):
        report(progress, 0.7 + 0.3 * i / 405, "changing the weights")
        unchanged = frame(ours, small, (64, 64))
        start = perf_counter()
        ours.set_material("paint", materials[i % 2])
        changed = (perf_counter() - start) * 1e3 + frame(ours, small, (64, 64))
        if i >= 5:
            extra.append(changed - unchanged)

    figures = {
        "paper_ratio": median(a / b for a, b in zip(times[ours], times[baseline], strict=True)),
        "all_lobes_ratio": median(a / b for a, b in zip(times[every_lobe], times[baseline], strict=True)),
        "weights_change_ms": median(extra),
        "baseline_frame_ms": median(times[baseline]),
    }
    for renderer in times:
        renderer.release()
    context.release()
    return figures


def _distance() -> float:
    """Return the distance from which the ball covers :data:`COVERAGE` of the picture."""
    half_width = 36.0 / 2 / 50.0
    x, y = np.meshgrid(np.linspace(-1, 1, 1281), np.linspace(-1, 1, 721))
    off_axis = half_width * np.hypot(x, y * SIZE[1] / SIZE[0])  # tangent of the angle from the axis
    tangent = float(np.quantile(off_axis, COVERAGE))
    return RADIUS * float(np.sqrt(1 + tangent**-2))


def _sphere(rings: int = 158) -> MeshPart:
    """158 rings: 99,856 triangles."""
    v, u = np.meshgrid(
        np.linspace(0, np.pi, rings + 1), np.linspace(0, 2 * np.pi, 2 * rings + 1), indexing="ij"
    )
    n = np.stack([np.sin(v) * np.sin(u), np.cos(v), np.sin(v) * np.cos(u)], -1).reshape(-1, 3)
    row = 2 * rings + 1
    i = (np.arange(rings)[:, None] * row + np.arange(row - 1)[None]).ravel()
    triangles = np.concatenate(
        [np.stack([i, i + row, i + 1], -1), np.stack([i + 1, i + row, i + row + 1], -1)]
    )
    return MeshPart("ball", "paint", n * RADIUS, n, triangles)


def _maps() -> EnvironmentMaps:
    """Smooth waves: what a map shows does not change what it costs to read."""

    def faces(size: int) -> CubeFaces:
        s, t = np.meshgrid(*[np.linspace(-3, 3, size)] * 2)
        face = np.stack([1 + np.sin(3 * s), 1 + np.sin(4 * t), 1 + np.sin(5 * s * t)], -1)
        return CubeFaces(np.broadcast_to(face, (6, size, size, 3)).astype(np.float16))

    lobes = tuple(faces(face_size(e)) for e in MAP_EXPONENTS)
    return EnvironmentMaps(MAP_EXPONENTS, lobes, faces(face_size(1.0)), faces(LARGEST_FACE))


def _weights(paint: Paint) -> MaterialWeights:
    fitted = PaintFitter().fit(paint).weights
    return MaterialWeights(
        EXPONENTS, fitted.kd, fitted.kdd, fitted.kg, theta_fit_rad=fitted.theta_fit_rad, ior=fitted.ior
    )


def _every_lobe() -> MaterialWeights:
    per_albedo = (np.asarray(EXPONENTS)[:, None] + 1) / (2 * np.pi) * np.ones(3)
    return MaterialWeights(EXPONENTS, np.full(3, 0.02), per_albedo * 0.02, per_albedo * 0.005)
