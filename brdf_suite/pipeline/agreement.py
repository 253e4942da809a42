"""How far the real-time picture is from the path-traced one: paints in environments on a sphere, by effect.

As docs/agreement.md has it: object pixels only, coat and Fresnel on, exposure such that the median luminance of the
object is 0.18, ΔE00 and FLIP (67 pixels per degree) after the same tone curve. Three errors are told apart:

- the whole: the real-time picture against the paint itself, path-traced;
- the fit: the fitted lobes, path-traced, against the paint itself;
- the look-up: the real-time picture against the fitted lobes, path-traced.

What the path tracer's own noise would give between two of its pictures stands beside them.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from brdf_suite.appearance.colorimetry import display_to_lab, srgb_encode
from brdf_suite.appearance.difference import delta_e_2000
from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import Sparkle
from brdf_suite.errors import ReferenceUnavailableError
from brdf_suite.pipeline.any_fit import AnyFit, fit_any
from brdf_suite.pipeline.exposure import ev_of
from brdf_suite.pipeline.picture import OffscreenScene, material_weights
from brdf_suite.pipeline.reference_scene import ReferenceScene, build_reference
from brdf_suite.pipeline.scene import PreparedEnvironment, load_environment
from brdf_suite.pipeline.surface import load_shaped
from brdf_suite.progress import Progress, part, report
from brdf_suite.realtime.tone_curves import display_light
from brdf_suite.surface.mesh import Mesh

if TYPE_CHECKING:
    from brdf_suite.reference.passes import Estimate

Pixels = NDArray[np.float64]

DEFAULT_FORM = "default"
FORMS: Mapping[str, Mapping[str, Any]] = MappingProxyType(
    {
        DEFAULT_FORM: MappingProxyType({}),
        "paper look-up": MappingProxyType({"look_up": "paper"}),
        "Fresnel off": MappingProxyType({"fresnel": "off"}),
        "weights over the angle": MappingProxyType({"fresnel": "multi_angle"}),
    }
)
"""Ways in which the real-time picture is drawn, by name, as changes of the view."""

LOBES = "the fitted lobes, traced"
PIXELS_PER_DEGREE = 67.0
_WHOLE = 0.999


@dataclass(frozen=True)
class Errors:
    """ΔE00 over the object's pixels: mean and 99th percentile; and the mean FLIP of them."""

    mean: float
    p99: float
    flip: float


@dataclass(frozen=True, eq=False)
class Case:
    """One paint in one environment.

    ``errors``: of each form against the paint itself; ``look_up``: of each form against the fitted lobes, where they
    were traced. ``noise`` is what the path tracer's noise gives. ``pictures``: encoded sRGB (h, w, 3), by form, and
    ``reference``; ``differences``: ΔE00 (h, w) of the default form.
    """

    paint: str
    environment: str
    errors: Mapping[str, Errors]
    look_up: Mapping[str, Errors]
    noise: Errors
    exposure_ev: float
    pictures: Mapping[str, Pixels] = field(repr=False)
    differences: Pixels = field(repr=False)

    def to_json(self) -> dict[str, object]:
        """Return the figures as plain values."""

        def plain(errors: Errors) -> dict[str, float]:
            return {"de00_mean": errors.mean, "de00_p99": errors.p99, "flip": errors.flip}

        return {
            "paint": self.paint,
            "environment": self.environment,
            "exposure_ev": self.exposure_ev,
            "errors": {form: plain(errors) for form, errors in self.errors.items()},
            "look_up": {form: plain(errors) for form, errors in self.look_up.items()},
            "noise": plain(self.noise),
        }


@dataclass(frozen=True)
class Order:
    """What is to be compared: names or files of paints and environments, and how well."""

    paints: Sequence[str]
    environments: Sequence[str]
    size: tuple[int, int] = (128, 128)
    samples: int = 512
    forms: Sequence[str] = tuple(FORMS)
    lobes: bool = False
    surface: str = "sphere"
    keep: Path | None = None


def compare(order: Order, progress: Progress | None = None) -> Iterator[Case]:
    """Yield the cases of an order, one environment after the other.

    Where ``keep`` names a folder, what is traced is kept there, and not traced again while scene and paint stay.

    Raises
    ------
    ReferenceUnavailableError
        Mitsuba, LLVM or FLIP is missing; the message says what to install.
    SuiteError
        A paint or an environment cannot be read.
    """
    flip_of(np.zeros((8, 8, 3)), np.zeros((8, 8, 3)))  # told before the work begins
    if order.keep is not None:
        order.keep.mkdir(parents=True, exist_ok=True)
    view = _plain(order)
    mesh = load_shaped(order.surface, view.surface_look)
    fits = {paint: fit_any(paint, errors=False) for paint in order.paints}
    done, whole = 0, max(1, len(order.paints) * len(order.environments))
    with OffscreenScene((1, 1)) as scene:
        scene.set_surface(mesh)
        for environment in order.environments:
            prepared = load_environment(environment)
            scene.set_environment(prepared)
            for paint in order.paints:
                step = part(progress, done / whole, (done + 1) / whole)
                yield _compare(order, scene, paint, fits[paint], prepared, mesh, step)
                done += 1
    report(progress, 1.0, "done")


def _compare(
    order: Order,
    scene: OffscreenScene,
    paint: str,
    fit: AnyFit,
    prepared: PreparedEnvironment,
    mesh: Mesh,
    progress: Progress | None,
) -> Case:
    view = _plain(order)
    truth = build_reference(fit.name, fit.reflectance, view, order.size, prepared.environment, mesh)
    kept_as = f"{Path(paint).stem}__{Path(prepared.name).stem}"
    traced = _traced(order, truth, kept_as, progress)
    seen = np.concatenate((traced.radiance, traced.coverage[..., None]), axis=-1)
    ev = ev_of(seen) or 0.0
    view = replace(truth.view, exposure_ev=ev)
    inside = traced.coverage >= _WHOLE
    whole = truth.whole(traced)

    scene.set_paint_fit(fit)
    pictures = {"reference": _shown(whole, view)}
    light: dict[str, Pixels] = {}
    for form in order.forms:
        drawn = scene.renderer.linear_image(replace(view, **FORMS[form]), order.size)
        light[form] = np.asarray(drawn[..., :3], np.float64)
        pictures[form] = _shown(light[form], view)
    errors = {form: errors_of(pictures[form], pictures["reference"], inside) for form in order.forms}
    look_up: dict[str, Errors] = {}
    if order.lobes:
        weights = material_weights(fit.weights)
        lobes = build_reference(fit.name, weights, truth.view, order.size, prepared.environment, mesh)
        found = _traced(order, lobes, f"{kept_as}__lobes", progress)
        pictures[LOBES] = _shown(lobes.whole(found), view)
        errors[LOBES] = errors_of(pictures[LOBES], pictures["reference"], inside)
        look_up = {form: errors_of(pictures[form], pictures[LOBES], inside) for form in order.forms}
    # What noise of this size would do to a picture of the same light.
    rng = np.random.default_rng(1)
    spread = np.sqrt(np.where(np.isfinite(traced.variance), traced.variance, 0.0))
    noisy = whole + spread * rng.normal(size=whole.shape[:2])[..., None]
    noise = errors_of(_shown(np.maximum(noisy, 0.0), view), pictures["reference"], inside)
    first = order.forms[0]
    return Case(
        paint=fit.name,
        environment=Path(prepared.name).stem,
        errors=errors,
        look_up=look_up,
        noise=noise,
        exposure_ev=ev,
        pictures=pictures,
        differences=np.where(inside, _delta_e(pictures[first], pictures["reference"]), 0.0),
    )


def errors_of(test: Pixels, reference: Pixels, inside: NDArray[np.bool_]) -> Errors:
    """Return the errors of a picture against another, both encoded sRGB (h, w, 3), where ``inside`` (h, w)."""
    away = _delta_e(test, reference)[inside]
    if not len(away):
        return Errors(0.0, 0.0, 0.0)
    flip = flip_of(reference, test)[inside]
    return Errors(float(away.mean()), float(np.quantile(away, 0.99)), float(flip.mean()))


def flip_of(reference: Pixels, test: Pixels) -> Pixels:
    """Return the FLIP error (h, w), 0 to 1, of encoded sRGB pictures (h, w, 3) seen at 67 pixels per degree.

    Andersson et al., "FLIP: A Difference Evaluator for Alternating Images", 2020, by its authors' own program.
    """
    try:
        from flip_evaluator import evaluate
    except ImportError as error:
        raise ReferenceUnavailableError(
            "The comparison needs FLIP, which is not installed: pip install 'brdf-suite[reference]'."
        ) from error
    planes = [np.ascontiguousarray(np.clip(image, 0.0, 1.0), np.float32) for image in (reference, test)]
    found, _, _ = evaluate(
        *planes, "LDR", applyMagma=False, computeMeanError=False, parameters={"ppd": PIXELS_PER_DEGREE}
    )
    return np.asarray(found, np.float64).reshape(reference.shape[:2])


def summary(cases: Sequence[Case], form: str = DEFAULT_FORM) -> dict[str, float]:
    """Return mean ΔE00, the worst paint's mean, the mean of the 99th percentiles, and mean FLIP of a form."""
    by_paint: dict[str, list[float]] = {}
    for case in cases:
        by_paint.setdefault(case.paint, []).append(case.errors[form].mean)
    return {
        "de00_mean": float(np.mean([case.errors[form].mean for case in cases])),
        "de00_worst": float(max(np.mean(values) for values in by_paint.values())),
        "de00_p99": float(np.mean([case.errors[form].p99 for case in cases])),
        "flip": float(np.mean([case.errors[form].flip for case in cases])),
    }


def _plain(order: Order) -> View:
    """The view of a comparison: what the paint's readings tell, without single flakes."""
    return View(surface=order.surface, sparkle=Sparkle(mode="off"))


def _traced(order: Order, scene: ReferenceScene, name: str, progress: Progress | None) -> Estimate:
    from brdf_suite.reference.estimate_file import read_estimate, write_estimate
    from brdf_suite.reference.passes import trace

    kept = None
    path = None if order.keep is None else order.keep / f"{_file_name(name)}.exr"
    if path is not None and path.exists():
        kept = read_estimate(path, scene.key)
    if kept is not None and kept.samples >= order.samples:
        return kept
    # Well-spread samples converge faster the more of them there are in a pass; two passes tell the noise.
    each = max(4, min(256, order.samples // 2))
    found = trace(
        scene.traced, samples=order.samples, samples_per_pass=each, estimate=kept, progress=progress
    )
    if path is not None:
        write_estimate(path, found, scene.whole(found), scene.key)
    return found


def _file_name(name: str) -> str:
    return "".join(c if c.isalnum() or c in "-_" else "_" for c in name)[:160]


def _shown(radiance: Pixels, view: View) -> Pixels:
    return srgb_encode(display_light(radiance, view.exposure_ev, view.tone_curve))


def _delta_e(first: Pixels, second: Pixels) -> Pixels:
    return delta_e_2000(display_to_lab(first), display_to_lab(second))
