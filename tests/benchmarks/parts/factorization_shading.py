"""What lamps on a factored paint cost: its frame over that of a matt grey in the same lamps, drawn in turn.

The scene of bench_viewer: a sphere of 100,000 triangles that covers 58 % of 1280x720, one sample a pixel, in the dark,
with the same two passes. The factored paint is p(wo) q(h) p(wi) of 32x32 texels, anisotropic, so with a tangent frame,
and a separate peak over the half vector; four look-ups a light, as the paper counts them (section 4.1).
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from statistics import median
from time import perf_counter

import numpy as np

from brdf_suite.cli.tools.bench import load_module
from brdf_suite.documents.view import Camera, View
from brdf_suite.documents.view_settings import Lamp, Sparkle
from brdf_suite.progress import report
from brdf_suite.realtime.factors.values import FactoredMaps, FactorMap, FactorTerm
from brdf_suite.realtime.gl.context import create_context
from brdf_suite.realtime.pictures.renderer import Renderer
from brdf_suite.realtime.values import CubeFaces, EnvironmentMaps

_ball = load_module(Path(__file__).parent / "ball.py")

BOUNDS = {
    "shading_ratio": (
        "<=",
        2.3,
        "",
        "frame of a factored paint over that of plain diffuse, one lamp, 1280x720, median (the paper: about 2)",
    ),
    "shading_ratio_radial": ("", None, "", "the same with radial maps, as in isotropic paints"),
    "shading_ratio_cube": ("", None, "", "the same with cube maps instead of parabolic ones"),
    "shading_ratio_8_lamps": ("", None, "", "the same with eight lamps in both frames, in one pass"),
}
PLAIN = Path(__file__).parents[1] / "plain_diffuse.frag.glsl"
SIZE = (1280, 720)
ROUNDS = 20
RADIUS, DISTANCE = 0.1, 0.2915
"""From there the ball covers 58 % of the picture."""


def figures(progress=None):
    """Return the figures of :data:`BOUNDS`."""
    context = create_context()
    one = View(
        Camera(0, 0, DISTANCE, (0.0, 0.0, 0.0)),
        sparkle=Sparkle("off"),
        lamps=(Lamp(position=(0.3, 0.4, 0.5)),),
    )
    eight = replace(one, lamps=tuple(Lamp(position=(0.1 * i - 0.4, 0.4, 0.5)) for i in range(8)))
    target = context.simple_framebuffer(SIZE)
    cases = {"plain": Renderer(context, PLAIN)}
    for name, maps, layout in (
        ("factored", factors(radial=False), "parabolic"),
        ("radial", factors(radial=True), "parabolic"),
        ("cube", factors(radial=False), "cube"),
    ):
        cases[name] = Renderer(context)
        cases[name].factors.layout = layout
        cases[name].factors.set("paint", maps)
    for renderer in cases.values():
        renderer.set_environment(dark())
        renderer.set_mesh([_ball.ball(RADIUS, 158, with_uvs=True)])
    times = _in_turn(context, cases, one, target, progress)
    many = _in_turn(context, {name: cases[name] for name in ("plain", "factored")}, eight, target, progress)
    for renderer in cases.values():
        renderer.release()
    target.release()
    context.release()
    return {
        "shading_ratio": _ratio(times, "factored"),
        "shading_ratio_radial": _ratio(times, "radial"),
        "shading_ratio_cube": _ratio(times, "cube"),
        "shading_ratio_8_lamps": _ratio(many, "factored"),
    }


def factors(*, radial: bool) -> FactoredMaps:
    """Return smooth maps: what they show does not change what they cost."""
    along = (np.arange(32) + 0.5) / 32
    shape = np.sin(3.0 * along) if radial else np.add.outer(np.sin(3.0 * along), np.cos(4.0 * along))
    log = FactorMap(np.repeat(shape[..., None], 3, axis=-1))
    peak = FactorMap(np.repeat(-40.0 * along[:, None], 3, axis=-1))
    of_light, of_view, of_half = ("|wi|", "|wo|", "|h|") if radial else ("wi", "wo", "h")
    return FactoredMaps(
        {"p": log, "q": FactorMap(log.values), "s": peak},
        (
            FactorTerm(np.full(3, 0.1), (("p", of_view), ("q", of_half), ("p", of_light))),
            FactorTerm(np.full(3, 2.0), (("s", "sqrt|h|"),)),
        ),
    )


def dark() -> EnvironmentMaps:
    """Return an environment without light."""
    none = CubeFaces(np.zeros((6, 8, 8, 3), np.float16))
    return EnvironmentMaps((8.0, 20000.0), (none, none), none, none, none)


def _in_turn(context, cases, view, target, progress):
    times = {name: [] for name in cases}
    for i in range(ROUNDS + 3):
        report(progress, i / (ROUNDS + 3), "drawing in turn with plain diffuse")
        for name, renderer in cases.items():
            start = perf_counter()
            renderer.render(view, target, SIZE, samples=1)
            context.finish()
            if i >= 3:
                times[name].append(perf_counter() - start)
    return times


def _ratio(times, name):
    return median(a / b for a, b in zip(times[name], times["plain"], strict=True))


if __name__ == "__main__":
    print(figures())
