"""White paints where a hard light grazes them, drawn and integrated directly; of ``bench reference``.

A sphere in the sunny sky, seen from two sides of the sun, at pixels with N·sun between .02 and .2. The truth is the sum
of the aspecular model over all texels in float64; both are of the base alone, whose light crosses the coat.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np

from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.cli.tools.bench import load_module
from brdf_suite.lighting.lights.glinting import glint_lights
from brdf_suite.pipeline.lobe_fit import PATIENT_TIME_LIMIT_S, PaintFitter
from brdf_suite.pipeline.material import load_shipped_paint
from brdf_suite.pipeline.paint_angles import material_weights
from brdf_suite.pipeline.picture import OffscreenScene
from brdf_suite.pipeline.scene import load_environment

_direct = load_module(Path(__file__).resolve().parents[1] / "comparisons" / "compare_look_ups.py")

PAINTS = ("solid_white", "white_pearl", "satin_white", "matte_white")
LOWEST, HIGHEST = 0.02, 0.2
SIDES_DEG = (60.0, 100.0)
LEAST_COSINE = 0.15

BOUNDS = {
    "terminator_median": (
        "<=",
        0.01,
        "",
        "bases of four white paints in the sunny sky, N·sun .02 to .2: relative error of the luminance, median",
    ),
    "terminator_worst": ("<=", 0.03, "", "the same, the worst pixel"),
}


def run(progress=None, paints=PAINTS, count=150):
    """Return the figures of :data:`BOUNDS`."""
    found = np.abs(errors(paints, count))
    return {"terminator_median": float(np.median(found)), "terminator_worst": float(found.max())}


def errors(paints, count):
    """Return the relative errors of the luminance (n,) at ``count`` pixels a side of each paint."""
    fitter = PaintFitter(time_limit_s=PATIENT_TIME_LIMIT_S)
    fits = [fitter.fit(load_shipped_paint(name)) for name in paints]
    gamma = np.linspace(0.0, np.pi, _direct.BINS)
    found = []
    with OffscreenScene() as scene:
        scene.renderer.set_mesh([_direct.sphere(400)])
        prepared = load_environment("sunny")
        scene.set_environment(prepared)
        sun = glint_lights(prepared.environment, 1).directions[0]
        azimuth = float(np.degrees(np.arctan2(sun[0], sun[2])))
        for side in SIDES_DEG:
            camera = replace(_direct.VIEW.camera, azimuth_deg=(azimuth + side) % 360.0)
            view = replace(_direct.VIEW, camera=camera, fresnel="raised")
            points = _grazed(_direct.points_of(scene, 6000, view), sun, count)
            light = _direct.histograms(prepared.environment.radiance, points)
            for fit in fits:
                truth = _direct.direct(fit.reflectance.base, light, points, gamma) @ LUMINANCE
                bare = replace(material_weights(fit.weights), kg=np.zeros_like(fit.weights.kg))
                scene.renderer.set_material("paint", bare)
                picture = scene.renderer.linear_image(view, _direct.SIZE, 1)
                drawn = picture[points.pixels[:, 0], points.pixels[:, 1], :3] @ LUMINANCE
                found.append(drawn / truth - 1.0)
    fitter.close()
    return np.concatenate(found)


def _grazed(points, sun, count):
    """Return ``count`` of the points at which the sun stands low and which are not seen edge-on."""
    cosine = points.normal @ sun
    low = np.flatnonzero((cosine > LOWEST) & (cosine < HIGHEST) & (points.cosine > LEAST_COSINE))
    chosen = low[np.linspace(0, len(low) - 1, count).astype(int)]
    return _direct.Points(*(values[chosen] for values in points))
