"""Frames on a graphics card, by its own timer.

The default paint in the sun with occlusion and ground, 4 samples per pixel: the car, and a ball of a million triangles.
Medians of GL timer queries while the camera turns. A software renderer has no such figures: its times are those of its
processor, which the ratios of `viewer` describe. How many multiply-adds the card's fragment shaders carry out a second
is measured as well: with it a frame's time becomes work per pixel, which can be compared between cards.
"""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path
from statistics import median
from time import perf_counter

import moderngl

from brdf_suite.cli.tools.bench import load_module
from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import Lamp, Sparkle
from brdf_suite.output.still import LoadedScene, loaded_scene
from brdf_suite.pipeline.lobe_fit import LobeFit, fit_material
from brdf_suite.pipeline.material import default_paint, material_of
from brdf_suite.pipeline.picture import gl_renderer_name
from brdf_suite.progress import Progress, report, subrange
from brdf_suite.realtime.camera import orbit
from brdf_suite.realtime.gl.context import create_context, draws_in_software

_ball = load_module(Path(__file__).parent / "parts" / "ball.py")

NAME = "gpu"
_SIZES = {"720p": (1280, 720), "1440p": (2560, 1440), "4k": (3840, 2160)}
_LAMPS = (0, 1, 8)
_MILLION = 500  # rings: four times their square triangles
_FRAMES = 60
_ROUNDS = 4000

_FILL = """#version 330 core
void main() { gl_Position = vec4(4 * (gl_VertexID & 1) - 1, 2 * (gl_VertexID & 2) - 1, 0, 1); }
"""
_MULTIPLY_ADDS = """#version 330 core
uniform vec4 scale, shift;
uniform int rounds;
out vec4 seen;
void main()
{
    vec4 a = gl_FragCoord, b = a.yxwz, c = a.zwxy, d = a.wzyx;
    for (int i = 0; i < rounds; ++i) {
        a = a * scale + shift; b = b * scale + shift; c = c * scale + shift; d = d * scale + shift;
        a = a * scale + shift; b = b * scale + shift; c = c * scale + shift; d = d * scale + shift;
        a = a * scale + shift; b = b * scale + shift; c = c * scale + shift; d = d * scale + shift;
        a = a * scale + shift; b = b * scale + shift; c = c * scale + shift; d = d * scale + shift;
    }
    seen = a + b + c + d;
}
"""
_IN_A_ROUND = 64

BOUNDS: dict[str, tuple[str, float | None, str, str]] = {
    "default_4k_ms": ("<=", 8.3, "ms", "the car at 3840x2160, flakes in all light, no lamp"),
    "smooth_4k_ms": ("", None, "ms", "the same without flakes"),
    "one_lamp_4k_ms": ("", None, "ms", "the same with flakes and one lamp, its shadow standing"),
    "eight_lamps_4k_ms": ("", None, "ms", "the same with eight lamps"),
    "million_4k_ms": ("", None, "ms", "a ball of a million triangles in place of the car, no lamp"),
    "fragment_rate": ("", None, "10⁹/s", "multiply-adds of fragment shaders on this card, measured"),
    "frame_work": (
        "<=",
        7300.0,
        "",
        "default_4k_ms in multiply-adds a pixel: a GeForce RTX 4070 has 14,600 at 120 frames a second",
    ),
    "edit_ms": (
        "",
        None,
        "ms",
        "from an edit of the paint to the end of the next frame at 1280x720, by the clock",
    ),
}
TABLES: dict[str, dict[str, object]] = {}
NOTES: dict[str, str] = {}


def run(progress: Progress | None = None) -> dict[str, float | None]:
    """Return the figures of :data:`BOUNDS`: None on a software renderer, which NOTES then name."""
    context = create_context()
    software = draws_in_software(context)
    context.release()
    if software:
        NOTES.update(dict.fromkeys(BOUNDS, f"not measured: {gl_renderer_name()} is no graphics card"))
        return dict.fromkeys(BOUNDS)
    return measure(_SIZES, _FRAMES, _MILLION, _ROUNDS, progress)


def measure(
    sizes: dict[str, tuple[int, int]],
    frames: int,
    rings: int,
    rounds: int,
    progress: Progress | None = None,
) -> dict[str, float | None]:
    """Return the figures, the largest of ``sizes`` last, and fill :data:`TABLES` with every case, ms.

    ``frames`` of each case count, ``rings`` are those of the ball, ``rounds`` those of the loop of multiply-adds.
    """
    view = View(
        surface="car",
        environment="sunny",
        fresnel="multi_angle",
        surface_look=replace(View().surface_look, occlusion=True, ground=True),
    )
    fits = [fit_material(material_of(paint, paint.name)) for paint in _edited()]
    table: dict[str, dict[str, float]] = {}
    with loaded_scene(view, subrange(progress, 0.0, 0.2)) as loaded:
        cases = {f"{count} lamps": replace(view, lamps=_lamps(count)) for count in _LAMPS}
        cases["without flakes"] = replace(view, sparkle=Sparkle("off"))
        for step, (name, shown) in enumerate(cases.items()):
            report(progress, 0.2 + 0.15 * step, name)
            table[name] = {
                key: _frame_ms(loaded, shown, fits[0], size, frames) for key, size in sizes.items()
            }
        edit = _edit_ms(loaded, view, fits, next(iter(sizes.values())), frames)
        report(progress, 0.85, "a million triangles")
        rate = fragment_rate(loaded.scene.renderer.context, rounds)
        loaded.scene.renderer.set_mesh([_ball.ball(1.0, rings)])
        table["a million triangles"] = {
            key: _frame_ms(loaded, view, fits[0], size, frames) for key, size in sizes.items()
        }
    TABLES.clear()
    TABLES.update({name: dict(row) for name, row in table.items()})
    largest = list(sizes)[-1]
    return {
        "default_4k_ms": table["0 lamps"][largest],
        "smooth_4k_ms": table["without flakes"][largest],
        "one_lamp_4k_ms": table["1 lamps"][largest],
        "eight_lamps_4k_ms": table["8 lamps"][largest],
        "million_4k_ms": table["a million triangles"][largest],
        "fragment_rate": 1e-9 * rate,
        "frame_work": 1e-3 * table["0 lamps"][largest] * rate / math.prod(sizes[largest]),
        "edit_ms": edit,
    }


def appendix() -> str:
    """Return every case as a table, with the card's name; nothing where nothing was measured."""
    if not TABLES:
        return "No frame was timed: no graphics card was at hand.\n"
    sizes = list(next(iter(TABLES.values())))
    lines = [f"### Frames on {gl_renderer_name()}, ms", "", "| case | " + " | ".join(sizes) + " |"]
    lines.append("|---" * (1 + len(sizes)) + "|")
    lines += [
        f"| {name} | " + " | ".join(f"{row[key]:.2f}" for key in sizes) + " |" for name, row in TABLES.items()
    ]
    return "\n".join(lines) + "\n"


def _edited() -> tuple[object, object]:
    paint = default_paint()
    first = paint.measurements[0]
    return paint, paint.with_lab(first.aspecular_deg, (first.lab[0] * 0.98, *first.lab[1:]))


def _lamps(count: int) -> tuple[Lamp, ...]:
    return tuple(
        Lamp("directional", azimuth_deg=45.0 * k, elevation_deg=30.0 + 5.0 * (k % 3), strength=0.3)
        for k in range(count)
    )


def fragment_rate(context: moderngl.Context, rounds: int) -> float:
    """Return the scalar multiply-adds that fragment shaders carry out a second: more rounds against fewer."""
    program = context.program(vertex_shader=_FILL, fragment_shader=_MULTIPLY_ADDS)
    program["scale"], program["shift"] = (0.999,) * 4, (0.001,) * 4
    size = (1024, 256)
    target, triangle = context.simple_framebuffer(size), context.vertex_array(program, [])
    target.use()
    query = context.query(time=True)

    def seconds(count: int) -> float:
        program["rounds"] = count
        times = []
        for _ in range(5):
            with query:
                triangle.render(moderngl.TRIANGLES, vertices=3)
            times.append(1e-9 * query.elapsed)
        # Whatever else runs only adds: the fastest draw is nearest to what the loop itself takes.
        return float(min(times))

    few = max(rounds // 4, 1)
    short = seconds(few)
    longer = seconds(rounds + few) - short
    for _ in range(6):
        if longer > short:
            break
        rounds *= 2  # what else runs has hidden the loop
        longer = seconds(rounds + few) - short
    for one in (triangle, target, program):
        one.release()
    return math.prod(size) * _IN_A_ROUND * rounds / longer


def _frame_ms(loaded: LoadedScene, view: View, fit: LobeFit, size: tuple[int, int], frames: int) -> float:
    scene = loaded.scene
    scene.set_material(fit, view=view)
    shown, target = loaded.composed(view, size), scene.renderer.context.simple_framebuffer(size)
    query = scene.renderer.context.query(time=True)
    times = []
    for i in range(frames + 5):
        with query:
            scene.draw(replace(shown, camera=orbit(shown.camera, 0.5 * i, 0.0)), target, size)
        times.append(1e-6 * query.elapsed)
    target.release()
    return float(median(times[5:]))


def _edit_ms(
    loaded: LoadedScene, view: View, fits: list[LobeFit], size: tuple[int, int], frames: int
) -> float:
    scene = loaded.scene
    shown, target = loaded.composed(view, size), scene.renderer.context.simple_framebuffer(size)
    times = []
    for i in range(frames + 5):
        start = perf_counter()
        scene.set_material(fits[i % 2], view=shown)
        scene.draw(shown, target, size)
        scene.renderer.context.finish()
        times.append(1e3 * (perf_counter() - start))
    target.release()
    return float(median(times[5:]))
