"""Frame times of the surface shader, as ratios to a baseline shader in the same run.

The fixed scene is a sphere of 100,000 triangles that covers 58 % of 1280x720, with the default basis and the default
paint with weights at 16 incidences, no sparkle, the environment as background, one sample per pixel. The baseline draws
the same frame with one reflection look-up and one diffuse look-up. Frames alternate, each followed by glFinish, so
other load affects both.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from statistics import median
from time import perf_counter
from types import SimpleNamespace

import numpy as np

from brdf_suite.cli.tools.bench import load_module
from brdf_suite.documents.paint import Paint
from brdf_suite.documents.view import Camera, View
from brdf_suite.documents.view_settings import Sparkle
from brdf_suite.fitting.lobes.basis import default_basis
from brdf_suite.lighting.filter.lobe_maps import face_size
from brdf_suite.output.still import loaded_scene
from brdf_suite.pipeline.lobe_fit import PATIENT_TIME_LIMIT_S, fit_material
from brdf_suite.pipeline.material import default_paint, load_material, material_of
from brdf_suite.pipeline.paint_angles import PaintAngles, material_weights
from brdf_suite.pipeline.scene import default_view, map_exponents
from brdf_suite.progress import report, subrange
from brdf_suite.realtime.camera import orbit
from brdf_suite.realtime.gl.context import create_context
from brdf_suite.realtime.pictures.moving import Pace
from brdf_suite.realtime.pictures.renderer import Renderer
from brdf_suite.realtime.values import CubeFaces, EnvironmentMaps, MaterialWeights, MeshPart

_ball = load_module(Path(__file__).parent / "parts" / "ball.py")
_sparkle = load_module(Path(__file__).parent / "parts" / "viewer_sparkle.py")

NAME = "viewer"
BOUNDS = {
    "paper_ratio": (
        "<=",
        2.2,
        "",
        "frame of the default paint in the paper's form over the baseline frame, 1280x720, median",
    ),
    "frame_ratio": ("<=", 3.0, "", "the same with shifted look-ups, the default"),
    "all_lobes_ratio": (
        "",
        None,
        "",
        "the same with a weight on every lobe of the basis, beyond any real fit",
    ),
    "smooth_ratio": ("", None, "", "the default with 4 samples per pixel, over a baseline with as many"),
    "weights_change_ms": (
        "<=",
        0.5,
        "ms",
        "extra cost of the next frame at 64x64 after a weight change, median",
    ),
    "baseline_frame_ms": ("", None, "ms", "the baseline's frame, median"),
    "orbit_fps": (
        ">=",
        8.0,
        "1/s",
        "car in the first view of a new window, 1280x720, orbiting, smaller frames while it moves; median frame",
    ),
    "orbit_scale": ("", None, "", "the part of width and height that these frames were drawn in"),
    "still_frame_ms": ("", None, "ms", "the same at rest, in full size"),
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
    found = _shading(subrange(progress, 0.0, 0.5)) | _orbit(subrange(progress, 0.5, 0.6))
    return found | _sparkle.figures(SimpleNamespace(**globals()), subrange(progress, 0.6, 1.0))


def _shading(progress=None):
    context = create_context()
    ours, every_lobe, baseline = (Renderer(context), Renderer(context), Renderer(context, BASELINE))
    view = View(
        Camera(azimuth_deg=0, elevation_deg=0, distance=_distance(), target=(0.0, 0.0, 0.0)),
        fresnel="multi_angle",
        sparkle=Sparkle("off"),
    )
    paper = replace(view, look_up="paper")
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

    def frame(renderer, framebuffer, size, shown=view, samples=1):
        start = perf_counter()
        renderer.render(shown, framebuffer, size, samples=samples)
        context.finish()
        return (perf_counter() - start) * 1e3

    cases = {
        "paper": (ours, paper, 1),
        "default": (ours, view, 1),
        "every": (every_lobe, view, 1),
        "baseline": (baseline, view, 1),
    }
    several = {"default": (ours, view, 4), "baseline": (baseline, view, 4)}
    times = _in_turn(cases, frame, target, subrange(progress, 0.0, 0.6), ROUNDS)
    smooth = _in_turn(several, frame, target, subrange(progress, 0.6, 0.7), ROUNDS // 4)

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
        "paper_ratio": _ratio(times, "paper"),
        "frame_ratio": _ratio(times, "default"),
        "all_lobes_ratio": _ratio(times, "every"),
        "smooth_ratio": _ratio(smooth, "default"),
        "weights_change_ms": median(extra),
        "baseline_frame_ms": median(times["baseline"]),
    }
    for renderer in (ours, every_lobe, baseline):
        renderer.release()
    context.release()
    return figures


def _in_turn(cases, frame, target, progress, rounds):
    """Return the times of each case's frames, drawn in turn; the first three rounds do not count."""
    times = {name: [] for name in cases}
    for i in range(rounds + 3):
        report(progress, i / (rounds + 3), "drawing in turn with the baseline")
        for name, (renderer, shown, samples) in cases.items():
            ms = frame(renderer, target, SIZE, shown, samples)
            if i >= 3:
                times[name].append(ms)
    return times


def _ratio(times, name):
    return median(a / b for a, b in zip(times[name], times["baseline"], strict=True))


def _orbit(progress=None, size=SIZE, frames=40):
    """Drag around the car as the Viewer does: the pace of the frames chooses how large the next ones are."""
    view = replace(default_view(), surface="car")
    with loaded_scene(view, progress) as loaded:
        scene = loaded.scene
        scene.set_material(fit_material(load_material(default_paint().name)))
        shown, target = loaded.composed(view, size), scene.renderer.context.simple_framebuffer(size)
        pace = Pace()

        def frame(degrees: float) -> float:
            turned = replace(shown, camera=orbit(shown.camera, degrees, 0.0))
            start = perf_counter()
            scene.draw(turned, target, size, pace.begin_frame())
            scene.renderer.context.finish()
            spent = (perf_counter() - start) * 1e3
            pace.end_frame(spent)
            return spent

        still = [frame(0.0) for _ in range(5)]
        pace.move()
        moving = [frame(2.0 * i) for i in range(frames + 5)]
        target.release()
    return {
        "orbit_fps": 1e3 / median(moving[5:]),
        "orbit_scale": pace.coarseness.scale,
        "still_frame_ms": median(still[1:]),
    }


def _distance() -> float:
    """Return the distance from which the ball covers :data:`COVERAGE` of the picture."""
    half_width = 36.0 / 2 / 50.0
    x, y = np.meshgrid(np.linspace(-1, 1, 1281), np.linspace(-1, 1, 721))
    off_axis = half_width * np.hypot(x, y * SIZE[1] / SIZE[0])  # tangent of the angle from the axis
    tangent = float(np.quantile(off_axis, COVERAGE))
    return RADIUS * float(np.sqrt(1 + tangent**-2))


def _sphere(rings: int = 158) -> MeshPart:
    """158 rings: 99,856 triangles."""
    return _ball.ball(RADIUS, rings)


def _maps() -> EnvironmentMaps:
    """Smooth waves: what a map shows does not change what it costs to read."""

    def faces(size: int) -> CubeFaces:
        s, t = np.meshgrid(*[np.linspace(-3, 3, size)] * 2)
        face = np.stack([1 + np.sin(3 * s), 1 + np.sin(4 * t), 1 + np.sin(5 * s * t)], -1)
        return CubeFaces(np.broadcast_to(face, (6, size, size, 3)).astype(np.float16))

    lobes = tuple(faces(face_size(e)) for e in MAP_EXPONENTS)
    diffuse = (faces(face_size(1.0)), faces(face_size(1.0)))
    return EnvironmentMaps(MAP_EXPONENTS, lobes, *diffuse, faces(LARGEST_FACE))


def _weights(paint: Paint) -> MaterialWeights:
    fitted = fit_material(material_of(paint, paint.name))
    over_angle = PaintAngles(time_limit_s=PATIENT_TIME_LIMIT_S).of(fitted)
    return material_weights(fitted.weights, None if over_angle is None else over_angle.weights())


def _every_lobe() -> MaterialWeights:
    per_albedo = (np.asarray(EXPONENTS)[:, None] + 1) / (2 * np.pi) * np.ones(3)
    return MaterialWeights(EXPONENTS, np.full(3, 0.02), per_albedo * 0.02, per_albedo * 0.005)
