"""The qualities of the ray tracer side by side: how long each takes, and how far it is from the converged picture.

Converged is the path tracer with so many samples that its own noise does not count. It also has what the ray tracer
leaves out: light that goes from one place's broad part to another's.
"""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from time import process_time

import numpy as np
from numpy.typing import NDArray

from brdf_suite.appearance.colour.colorimetry import srgb_encode
from brdf_suite.arrays import Floats
from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import Sparkle, SurfaceLook
from brdf_suite.pipeline.exposure import ev_of
from brdf_suite.progress import Progress, report, subrange
from brdf_suite.realtime.pictures.tone_curves import display_light
from brdf_suite.tracing.agreement.comparison import PictureErrors, errors_of
from brdf_suite.tracing.raytraced.picture import PRESETS, Quality, RaytracedSession
from brdf_suite.tracing.reference.scene import prepare_reference
from brdf_suite.tracing.traced_picture import Size

_WHOLE = 0.999
_PATH_STEPS = (4, 12, 48, 192)
"""Samples of the path tracer's passes, one after the other, whose mean is compared."""
_TRUTH_PASS = 256


@dataclass(frozen=True, eq=False)
class Tried:
    """One quality: seconds of processor time, the errors, and the picture (h, w, 3) uint8."""

    name: str
    seconds: float
    errors: PictureErrors
    codes: NDArray[np.uint8]


@dataclass(frozen=True, eq=False)
class Presets:
    """The qualities, the converged picture, and the path tracer's own way there: (samples, seconds, mean ΔE00)."""

    tried: Sequence[Tried]
    converged: NDArray[np.uint8]
    converged_samples: int
    paths: Sequence[tuple[int, float, float]]

    def paths_as_good_as(self, mean_delta_e: float) -> float:
        """Return the processor seconds of path tracing after which its mean ΔE00 is ``mean_delta_e``.

        Between what was measured on a line through the logarithms; beyond, noise falls with the root of the time.
        """
        _, seconds, errors = (np.array(column, float) for column in zip(*self.paths, strict=True))
        x, y = np.log(errors[::-1]), np.log(seconds[::-1])
        wanted = np.log(mean_delta_e)
        if wanted < x[0]:
            return float(np.exp(y[0] + 2.0 * (x[0] - wanted)))
        if wanted > x[-1]:
            return float(np.exp(y[-1] - 2.0 * (wanted - x[-1])))
        return float(np.exp(np.interp(wanted, x, y)))


def compare_presets(
    paint: str | os.PathLike[str],
    view: View,
    size: Size,
    *,
    qualities: Mapping[str, Quality] = PRESETS,
    samples: int = 4096,
    progress: Progress | None = None,
) -> Presets:
    """Trace a paint with each quality, and with ``samples`` paths a pixel; errors are over the object's pixels.

    Flakes and the ground are left out, and the exposure is such that the object's median luminance is 0.18.
    Errors as :meth:`.RaytracedSession.show` and :func:`~brdf_suite.tracing.agreement.comparison.flip_of`.
    """
    from brdf_suite.reference.passes import Estimate, trace_pass

    view = replace(
        view,
        sparkle=Sparkle(mode="off"),
        surface_look=replace(view.surface_look, ground=SurfaceLook().ground),
        exposure_mode="locked",
    )
    scene = prepare_reference(paint, view, size, progress=subrange(progress, 0.0, 0.05))
    trace_pass(scene.traced, 1, 0)  # compiles
    estimate, paths = Estimate.nothing(size), []
    spent, steps = 0.0, []
    for number, count in enumerate(_PATH_STEPS):
        start = process_time()
        radiance, coverage = trace_pass(scene.traced, count, number)
        spent += process_time() - start
        estimate = estimate.with_pass(radiance, coverage, count, 0.0)
        steps.append((estimate.samples, spent, estimate.radiance))
    truth = Estimate.nothing(size)
    while truth.samples < samples:
        report(progress, 0.1 + 0.6 * truth.samples / samples, "tracing the converged picture")
        count = min(_TRUTH_PASS, samples - truth.samples)
        truth = truth.with_pass(*trace_pass(scene.traced, count, 1000 + truth.passes), count, 0.0)
    inside = truth.coverage >= _WHOLE
    ev = ev_of(np.concatenate((truth.radiance, truth.coverage[..., None]), axis=-1)) or 0.0
    shown = replace(view, exposure_ev=ev)
    wanted = _encoded(truth.radiance, ev, view)
    for count, seconds, light in steps:
        paths.append((count, seconds, errors_of(_encoded(light, ev, view), wanted, inside).mean))
    session, tried = RaytracedSession(), []
    for index, (name, quality) in enumerate(qualities.items()):
        report(progress, 0.7 + 0.3 * index / len(qualities), f"ray tracing, {name}")
        session.show(paint, shown, size, quality)
        next(session.passes())  # compiles
        start = process_time()
        image = session.frame()
        seconds = process_time() - start
        whole = inside & (image.sums.coverage >= _WHOLE)
        errors = errors_of(_encoded(image.sums.radiance, ev, view), wanted, whole)
        tried.append(Tried(name, seconds, errors, image.codes()))
    converged = replace(scene, view=replace(scene.view, exposure_ev=ev)).codes(truth)
    return Presets(tried, converged, truth.samples, paths)


def _encoded(radiance: Floats, ev: float, view: View) -> Floats:
    return np.asarray(srgb_encode(display_light(radiance, ev, view.tone_curve)))
