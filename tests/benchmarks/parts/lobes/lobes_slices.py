"""Drag the incidence in the real Lobe Visualizer with six reflectances in its slice plots; a part of ``bench lobes``.

The whole window, on Qt's offscreen platform: polar plot and curves are shown, each with a line for each of six
reflectances of different kinds: a designed paint with its flop and coat, two of Cook-Torrance with three lobes, a
table of 90 × 90 × 180 bins, GGX, and brushed metal, which is anisotropic. A step is the time from the new incidence
until both plots are painted; ``both`` is the same with each one's fit as a second line. ``cpu`` is the processor's
time of the window's thread, which other programs do not lengthen.
"""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path
from time import perf_counter, thread_time

from brdf_suite.cli.tools.bench import load_module
from brdf_suite.pipeline.lobe_fit import LobeFit, fit_material
from brdf_suite.pipeline.material import Material, load_material

_session = load_module(Path(__file__).parents[1] / "own_session.py")

STEPS = 300
SIZE = (1400, 900)
FROM_DEG, TO_DEG = 5.0, 80.0


def measure() -> dict[str, float]:
    """Return medians and 99th percentiles in milliseconds, measured in a process of its own."""
    done = subprocess.run([sys.executable, __file__], check=True, capture_output=True, text=True)
    return dict(json.loads(done.stdout.splitlines()[-1]))


def main() -> None:
    with _session.own_session(offscreen=True, own_cache=True):
        sys.stdout.write(json.dumps(drag()) + "\n")


def drag() -> dict[str, float]:
    """Return ``slices_median_ms``, ``slices_p99_ms`` and ``slices_cpu_ms``, and the same with fits."""
    import numpy as np
    from brdf_lobe_visualizer.assembly import LobeVisualizer
    from brdf_lobe_visualizer.cuts.panel import Slices
    from brdf_qt.program.application import create_application

    app = create_application("Lobe Visualizer")
    program = LobeVisualizer(parts=(Slices,))
    window, session = program.window, program.session
    window.resize(*SIZE)
    for key in window.plots.plots:
        window.plots.set_shown(key, key in ("polar", "curves"))
    window.show()
    slices = program.feature(Slices)
    for subject in _subjects():
        session.add(subject)
    while not slices.is_idle or session.tasks.busy:
        app.processEvents()
    answer: dict[str, float] = {}
    angles = np.concatenate((np.linspace(FROM_DEG, TO_DEG, STEPS), np.linspace(TO_DEG, FROM_DEG, STEPS)))
    for shown, name in (("target", "slices"), ("both", "slices_both")):
        session.set_options(shown=shown)
        app.processEvents()
        took, cpu = [], []
        for angle in angles:
            begun, used = perf_counter(), thread_time()
            session.set_incidence(float(angle), 0.0)
            slices.draw_now()
            for plot in (slices.polar, slices.curves):
                plot.plot.viewport().repaint()
                plot.note.repaint()
            took.append(1e3 * (perf_counter() - begun))
            cpu.append(1e3 * (thread_time() - used))
            app.processEvents()  # what other parts do with the news is theirs
        answer |= {
            f"{name}_median_ms": float(np.median(took)),
            f"{name}_p99_ms": float(np.percentile(took, 99.0)),
            f"{name}_cpu_ms": float(np.median(cpu)),
        }
    program.close()
    return answer


def _subjects():
    from brdf_lobe_visualizer.subjects.subjects import DASHES, LINE_COLOURS, PlottedMaterial

    from brdf_suite.fitting.lobes.measured import fit_undivided
    from brdf_suite.reflectance.models.ggx import Ggx
    from brdf_suite.reflectance.models.poulin_fournier import PoulinFournier
    from brdf_suite.reflectance.tabulated.isotropic import IsotropicTable

    made = []
    for name in ("blue_metallic", "table1_ford_f8", "table1_polaris_silver"):
        fitted = fit_material(load_material(name))
        made.append((name, fitted.reflectance, fitted.weights))
    others = {
        "table": IsotropicTable.from_reflectance(made[2][1]),
        "ggx": Ggx(kd=0.1),
        "brushed": PoulinFournier(),
    }
    made += [(name, model, fit_undivided(model).weights) for name, model in others.items()]
    return [
        PlottedMaterial(
            name,
            name,
            Material(name, reflectance),
            LINE_COLOURS[number],
            DASHES[number % len(DASHES)],
            fit=LobeFit(Material("fit", weights), "measured", weights, {}, (), 0.0),
            isotropic=name != "brushed",
        )
        for number, (name, reflectance, weights) in enumerate(made)
    ]


if __name__ == "__main__":
    main()
