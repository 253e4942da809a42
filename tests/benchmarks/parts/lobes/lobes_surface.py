"""Move the light in the real Lobe Visualizer, and time each surface from the incidence to the card; of ``bench lobes``.

A step is all that a drag does before it is drawn: directions, values at 128 × 256 points, radius, normals, colours,
notes and scale, and the upload of the buffers, waited for with glFinish. Two reflectances, each alone: Cook-Torrance of
three lobes (Polaris Silver), and a half-angle table of 90 × 90 × 180 bins, as MERL's are, made of it. ``cpu`` is the
processor's time of the thread, which other programs do not lengthen. Needs an X server; where there is none, one is
started, and where that fails too the figures are left out.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path
from time import perf_counter, thread_time

from brdf_suite.cli.tools.bench import load_module
from brdf_suite.pipeline.material import Material

_session = load_module(Path(__file__).parents[1] / "own_session.py")

STEPS = 200
WARM_UP = 10
SIZE = (1400, 900)

BOUNDS = {
    "surface_median_ms": (
        "<=",
        12.0,
        "ms",
        "128x256 lobe surface recomputed and uploaded, median, the slower of the two below",
    ),
    "surface_cook_torrance_ms": ("", None, "ms", "three Cook-Torrance lobes, median"),
    "surface_table_ms": ("", None, "ms", "a table of 90x90x180 bins, median"),
    "surface_cpu_ms": ("", None, "ms", "processor time of the slower one, median"),
    "surface_p99_ms": ("", None, "ms", "the slower one, 99th percentile"),
    "surface_draw_ms": ("", None, "ms", "drawing a frame after that, 1400x900 window, median"),
}
NOTES = {"surface_draw_ms": "a software renderer draws on the same two cores"}


def run(progress=None):
    from brdf_suite.progress import report

    report(progress, 0.0, "moving the light over lobes in three dimensions")
    command = [sys.executable, __file__]
    if sys.platform.startswith("linux") and not (
        os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")
    ):
        starter = shutil.which("xvfb-run")
        if starter is None:
            return dict.fromkeys(BOUNDS)
        command = [starter, "-a", "-s", "-screen 0 1600x1200x24", *command]
    done = subprocess.run(command, capture_output=True, text=True, check=True, timeout=600)
    return dict(json.loads(done.stdout.splitlines()[-1]))


def main() -> None:
    with _session.own_session(own_cache=True):
        sys.stdout.write(json.dumps(figures()) + "\n")


def figures() -> dict[str, float]:
    import numpy as np
    from brdf_lobe_visualizer.assembly import LobeVisualizer
    from brdf_lobe_visualizer.subjects.subjects import PlottedMaterial
    from brdf_lobe_visualizer.view3d.panel import Space
    from brdf_qt.program.application import create_application

    from brdf_suite.reflectance.registry import MODELS
    from brdf_suite.reflectance.tabulated.isotropic import IsotropicTable

    app = create_application("Lobe Visualizer")
    program = LobeVisualizer(parts=(Space,))
    program.window.resize(*SIZE)
    program.window.show()
    space = program.feature(Space)
    _until(app, lambda: space.view is not None and space.view.isValid())
    from OpenGL import GL

    model = MODELS["cook_torrance"].default
    subjects = {"cook_torrance": model, "table": IsotropicTable.from_reflectance(model)}
    found = {}
    for name, reflectance in subjects.items():
        program.session.set_subjects((PlottedMaterial(name, name, Material(name, reflectance)),))
        _until(app, lambda: space.is_idle)
        found[name] = _steps(app, program, space, GL)
    program.close()
    slower = max(found, key=lambda name: np.median(found[name]["wall"]))
    return {
        "surface_median_ms": float(np.median(found[slower]["wall"])),
        "surface_cook_torrance_ms": float(np.median(found["cook_torrance"]["wall"])),
        "surface_table_ms": float(np.median(found["table"]["wall"])),
        "surface_cpu_ms": float(np.median(found[slower]["cpu"])),
        "surface_p99_ms": float(np.percentile(found[slower]["wall"], 99.0)),
        "surface_draw_ms": float(np.median(found[slower]["draw"])),
    }


def _steps(app, program, space, gl) -> dict[str, list[float]]:
    import numpy as np

    view = space.view
    drawn: list[float] = []
    view.drawn.connect(drawn.append)
    times: dict[str, list[float]] = {"wall": [], "cpu": [], "draw": []}
    for step, theta in enumerate(np.linspace(5.0, 80.0, STEPS + WARM_UP)):
        program.session.blockSignals(True)  # the rest of the window is timed elsewhere
        program.session.set_incidence(float(theta), 0.0)
        program.session.blockSignals(False)
        wall, cpu = perf_counter(), thread_time()
        space.draw_now()
        view.makeCurrent()
        gl.glFinish()
        view.doneCurrent()
        wall, cpu = perf_counter() - wall, thread_time() - cpu
        drawn.clear()
        if step % 10 == 0:  # a software renderer takes longer to draw than all of the rest
            view.repaint()
            app.processEvents()
        if step >= WARM_UP:
            times["wall"].append(1e3 * wall)
            times["cpu"].append(1e3 * cpu)
            times["draw"] += drawn[:1]
    view.drawn.disconnect(drawn.append)
    return times


def _until(app, holds) -> None:
    end = perf_counter() + 120.0
    while not holds():
        app.processEvents()
        if perf_counter() > end:
            raise SystemExit("the view did not come")


if __name__ == "__main__":
    main()
