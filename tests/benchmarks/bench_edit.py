"""Time from an edit of the paint to the finished frame.

A slider drag: new Paint, reflectance, linear program, weights in the GL buffer, frame, glFinish. The same frame is then
drawn again unchanged; the difference is the overhead. Its pictures are of a few pixels, so that the drawing, which
varies by more than the overhead is long, does not hide it.
"""

from __future__ import annotations

from statistics import median
from time import perf_counter

import numpy as np

NAME = "edit"
BOUNDS = {
    "edit_overhead_median_ms": ("<=", 5.0, "ms", "edit to finished frame, minus drawing, median"),
    "edit_overhead_p99_ms": ("", None, "ms", "the same, 99th percentile"),
    "frame_median_ms": ("", None, "ms", "drawing, speed form in the booth, 320×180, 4× MSAA"),
}
STEPS, SMALL = 1000, (8, 8)
FRAMES, SIZE = 30, (320, 180)


def run(progress=None):
    from brdf_suite.pipeline.lobe_fit import PaintFitter
    from brdf_suite.pipeline.material import default_paint
    from brdf_suite.pipeline.picture import OffscreenScene
    from brdf_suite.pipeline.scene import default_view, load_environment, load_surface
    from brdf_suite.progress import report, subrange

    paint = default_paint()
    view = default_view()
    fitter = PaintFitter()
    with OffscreenScene() as scene:
        scene.set_environment(load_environment(view.environment, subrange(progress, 0.0, 0.5)))
        scene.set_surface(load_surface("sphere"))
        scene.set_material(fitter.fit(paint))
        context = scene.renderer.context

        def seconds_to_draw(target, size) -> float:
            start = perf_counter()
            scene.draw(view, target, size)
            context.finish()
            return perf_counter() - start

        small = context.simple_framebuffer(SMALL)
        for _ in range(5):
            seconds_to_draw(small, SMALL)
        overheads = []
        first = paint.measurements[0].lab
        for step in range(STEPS):
            report(progress, 0.5 + 0.4 * step / STEPS, "dragging a slider")
            lightness = first[0] - 20.0 * step / STEPS
            start = perf_counter()
            edited = paint.with_lab(paint.measurements[0].aspecular_deg, (lightness, *first[1:]))
            scene.set_material(fitter.fit(edited))
            seconds_to_draw(small, SMALL)
            whole = perf_counter() - start
            overheads.append(whole - seconds_to_draw(small, SMALL))

        report(progress, 0.9, "drawing")
        scene.set_surface(load_surface(view.surface))
        target = context.simple_framebuffer(SIZE)
        frames = [seconds_to_draw(target, SIZE) for _ in range(5 + FRAMES)][5:]
    return {
        "edit_overhead_median_ms": median(overheads) * 1e3,
        "edit_overhead_p99_ms": float(np.percentile(overheads, 99)) * 1e3,
        "frame_median_ms": median(frames) * 1e3,
    }
