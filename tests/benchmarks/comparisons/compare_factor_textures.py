"""Parabolic or cube maps for the factors of a paint, and of what numbers: how near each comes, and what it costs.

    python tests/benchmarks/comparisons/compare_factor_textures.py

The reflectance is Poulin and Fournier's brushed metal, factored at 32x32. What is shaded is a ball in one lamp; the
truth is the product of the maps in numpy at the very places. Errors are over all lit pixels, relative to the mean;
times are of the frame, over that of plain diffuse, in processor seconds.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from statistics import median
from time import process_time

import numpy as np

from brdf_suite.cli.tools.bench import load_module
from brdf_suite.documents.view import Camera, View
from brdf_suite.documents.view_settings import Lamp, Sparkle
from brdf_suite.fitting.homomorphic.product_fit import factorize
from brdf_suite.fitting.homomorphic.samples import sample_reflectance
from brdf_suite.pipeline.factored_maps import factored_maps
from brdf_suite.realtime.gl.context import create_context
from brdf_suite.realtime.pictures.display import LINEAR
from brdf_suite.realtime.pictures.probe import geometry_picture
from brdf_suite.realtime.pictures.renderer import Renderer
from brdf_suite.reflectance.factored.model import Factored
from brdf_suite.reflectance.models.poulin_fournier import PoulinFournier
from tools.evaluation.direct_lamps import lamp_radiance

_ball = load_module(Path(__file__).parents[1] / "parts" / "ball.py")
_shading = load_module(Path(__file__).parents[1] / "parts" / "factorization_shading.py")
SIZE = (640, 360)
VIEW = View(
    Camera(0, 0, 0.2915, (0.0, 0.0, 0.0)), sparkle=Sparkle("off"), lamps=(Lamp(position=(0.3, 0.4, 0.5)),)
)
ROUNDS = 12


def main() -> None:
    """Print the table."""
    samples = sample_reflectance(PoulinFournier(), 20_000)
    found = factorize(samples.wi, samples.wo, samples.values, resolution=32).product
    maps = {name: np.exp(log).astype(np.float32) for name, log in found.logs.items()}
    value = Factored(maps["p"], maps["q"], found.alpha, logarithmic=True)
    context = create_context()
    target = context.simple_framebuffer(_shading.SIZE)
    plain = _renderer(context, _shading.PLAIN)
    print("layout     numbers   mean error   99th percentile   time over plain diffuse")
    for layout in ("parabolic", "cube"):
        for store in ("8-bit", "half", "float"):
            renderer = _renderer(context)
            renderer.factors.layout, renderer.factors.store = layout, store
            renderer.factors.set("paint", factored_maps(value))
            off = _errors(renderer, value)
            times = {"plain": [], "own": []}
            for i in range(ROUNDS + 2):
                for name, one in (("plain", plain), ("own", renderer)):
                    start = process_time()
                    one.render(VIEW, target, _shading.SIZE, samples=1)
                    context.finish()
                    if i >= 2:
                        times[name].append(process_time() - start)
            ratio = median(a / b for a, b in zip(times["own"], times["plain"], strict=True))
            print(
                f"{layout:10} {store:8} {100 * off.mean():8.2f} % {100 * np.quantile(off, 0.99):14.2f} % {ratio:14.2f}"
            )
            renderer.release()
    plain.release()
    context.release()


def _renderer(context, *shader):
    renderer = Renderer(context, *shader)
    renderer.set_environment(_shading.dark())
    # Without texture coordinates the tangents are those of the comparison in numpy.
    renderer.set_mesh([_ball.ball(0.1, 158)])
    return renderer


def _errors(renderer, value):
    drawn = renderer.render_image(VIEW, SIZE, 1, display=LINEAR)[..., :3].astype(np.float64)
    seen = geometry_picture(renderer, replace(VIEW, lamps=()), SIZE)
    truth = lamp_radiance(value, seen, VIEW.lamps)
    lit = truth.max(axis=-1) > 0.0
    return np.abs(drawn - truth)[lit] / truth[lit].mean()


if __name__ == "__main__":
    main()
