"""How far the real-time picture is from the path-traced one: paints in environments on a sphere, by effect.

As in docs/method/agreement.md: object pixels only, coat and Fresnel on, exposure such that the median luminance of the
object is 0.18, ΔE00 and FLIP (67 pixels per degree) after the same tone curve. Three errors are distinguished:

- the whole: the real-time picture against the paint itself, path-traced;
- the fit: the fitted lobes, path-traced, against the paint itself;
- the look-up: the real-time picture against the fitted lobes, path-traced.

Each truth is the mean of two independent traces; the difference between the two stands beside the errors. A traced
pixel is the mean of its light, so the real-time picture is drawn larger and averaged. A surface that shadows itself is
a case of its own: what baked occlusion misses of shadows and reflections is then part of the error. Pixels of other
materials than the paint are counted for themselves.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from brdf_suite.appearance.colour.colorimetry import display_to_lab, srgb_encode
from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.arrays import Floats
from brdf_suite.documents.atomic import make_folder
from brdf_suite.documents.cook_torrance import CookTorrancePaint
from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import Sparkle
from brdf_suite.errors import ValueRangeError
from brdf_suite.extras import import_extra
from brdf_suite.fitting.lobes.settings import FitSettings
from brdf_suite.pipeline.exposure import ev_of
from brdf_suite.pipeline.lobe_fit import LobeFit, fit_material
from brdf_suite.pipeline.material import Material, load_material
from brdf_suite.pipeline.picture import OffscreenScene
from brdf_suite.pipeline.scene import PreparedEnvironment, load_environment
from brdf_suite.pipeline.surface import bake_or_explain, load_shaped
from brdf_suite.progress import Progress, report, subrange
from brdf_suite.realtime.camera import Bounds, compose
from brdf_suite.realtime.pictures.tone_curves import display_light
from brdf_suite.reference.estimate_file import read_estimate, write_estimate
from brdf_suite.reference.passes import Estimate, trace
from brdf_suite.reflectance.designed.aspecular_base import SeveralLights
from brdf_suite.reflectance.designed.paint_reflectance import PaintReflectance
from brdf_suite.reflectance.factored.model import Factored
from brdf_suite.reflectance.models.table_1 import TABLE_1
from brdf_suite.reflectance.tabulated.anisotropic import AnisotropicTable
from brdf_suite.reflectance.tabulated.isotropic import IsotropicTable
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples
from brdf_suite.reflectance.tensor.tensor_reflectance import TensorReflectance
from brdf_suite.regular_files import exists
from brdf_suite.surface.mesh import Mesh
from brdf_suite.surface.occlusion.rays import BakedMesh
from brdf_suite.tracing.agreement.forms import DEFAULT_FORM, FORMS, coarser, fit_for, settings_of
from brdf_suite.tracing.reference.scene import ReferenceScene, build_reference

PIXELS_PER_DEGREE = 67.0
LARGE_DELTA_E = 10.0
FINER = 4
"""A real-time picture is drawn so many times as large in each direction, and averaged: it shades a pixel at one place,
so that the edge of a small reflected light would else be compared with the light's share of its pixel."""

PaintClass = Literal[
    "designed",
    "two-light",
    "satin",
    "matte",
    "Table 1",
    "Cook-Torrance",
    "scattered",
    "table",
    "RGL",
    "factored",
    "model",
]
"""What a paint is to the comparison: each class is reported for itself."""
SATIN, MATTE = 0.012, 0.05
"""The least roughness of a satin and of a matte coat."""


def class_of(fit: LobeFit) -> PaintClass:
    """Return the class of a fitted paint."""
    found = fit.reflectance
    if isinstance(found, PaintReflectance):
        if isinstance(found.base, SeveralLights):
            return "two-light"
        return "designed" if found.roughness < SATIN else "satin" if found.roughness < MATTE else "matte"
    kinds: tuple[tuple[type, PaintClass], ...] = (
        (ScatteredSamples, "scattered"),
        (IsotropicTable, "table"),
        (AnisotropicTable, "table"),
        (TensorReflectance, "RGL"),
        (Factored, "factored"),
    )
    for kind, name in kinds:
        if isinstance(found, kind):
            return name
    if isinstance(fit.material.document, CookTorrancePaint):
        return "Table 1" if Path(fit.material.origin).stem in TABLE_1 else "Cook-Torrance"
    return "model"


@dataclass(frozen=True)
class PictureErrors:
    """ΔE00 over the object's pixels: mean, 99th percentile and the share above 10; and the mean FLIP of them."""

    mean: float
    p99: float
    above_10: float
    flip: float


def errors_of(test: Floats, reference: Floats, inside: NDArray[np.bool_]) -> PictureErrors:
    """Return the errors of a picture against another, both encoded sRGB (h, w, 3), where ``inside`` (h, w)."""
    away = delta_e_of(test, reference)[inside]
    if not len(away):
        return PictureErrors(0.0, 0.0, 0.0, 0.0)
    flip = flip_of(reference, test)[inside]
    above = float((away > LARGE_DELTA_E).mean())
    return PictureErrors(float(away.mean()), float(np.quantile(away, 0.99)), above, float(flip.mean()))


def flip_of(reference: Floats, test: Floats) -> Floats:
    """Return the FLIP error (h, w), 0 to 1, of encoded sRGB pictures (h, w, 3) seen at 67 pixels per degree.

    Andersson et al., "FLIP: A Difference Evaluator for Alternating Images", 2020, by its authors' own program.
    Raise :class:`ExtraError` where that is missing or cannot be loaded.
    """
    evaluate = import_extra("flip_evaluator", purpose="the comparison of pictures").evaluate
    planes = [np.ascontiguousarray(np.clip(image, 0.0, 1.0), np.float32) for image in (reference, test)]
    found, _, _ = evaluate(
        *planes, "LDR", applyMagma=False, computeMeanError=False, parameters={"ppd": PIXELS_PER_DEGREE}
    )
    return np.asarray(found, np.float64).reshape(reference.shape[:2])


def delta_e_of(first: Floats, second: Floats) -> Floats:
    """Return ΔE00 (h, w) between pictures (h, w, 3), encoded sRGB."""
    return delta_e_2000(display_to_lab(first), display_to_lab(second))


LOBES = "the fitted lobes, traced"
WHOLE = 0.999
OTHER_SEED = 100_000
MOST_TIMES = 64
"""Where the noise has a bound, at most so many times the samples that were asked for are traced."""


@dataclass(frozen=True, eq=False)
class Case:
    """One paint in one environment on one surface.

    ``errors``: of each form against the paint itself; ``look_up``: of each form against the fitted lobes, where they
    were traced. ``noise`` is the difference between two independent traces of ``samples`` per pixel each, of whose mean
    all others are. All three are of the paint's pixels; ``elsewhere`` is of those of other materials, by form, and
    empty where there are none. ``pictures``: encoded sRGB (h, w, 3), by form, and ``reference``; ``differences``: ΔE00
    (h, w) of the default form.
    """

    paint: str
    environment: str
    surface: str
    kind: PaintClass
    errors: Mapping[str, PictureErrors]
    look_up: Mapping[str, PictureErrors]
    noise: PictureErrors
    elsewhere: Mapping[str, PictureErrors]
    samples: int
    exposure_ev: float
    pictures: Mapping[str, Floats] = field(repr=False)
    differences: Floats = field(repr=False)

    def to_json(self) -> dict[str, object]:
        """Return the figures as plain values."""

        def plain(errors: PictureErrors) -> dict[str, float]:
            return {
                "de00_mean": errors.mean,
                "de00_p99": errors.p99,
                "share_above_10": errors.above_10,
                "flip": errors.flip,
            }

        return {
            "paint": self.paint,
            "class": self.kind,
            "environment": self.environment,
            "surface": self.surface,
            "samples": self.samples,
            "exposure_ev": self.exposure_ev,
            "errors": {form: plain(errors) for form, errors in self.errors.items()},
            "look_up": {form: plain(errors) for form, errors in self.look_up.items()},
            "noise": plain(self.noise),
            "elsewhere": {form: plain(errors) for form, errors in self.elsewhere.items()},
        }


@dataclass(frozen=True)
class Order:
    """What is to be compared: names or files of paints and environments, and how well; how the lobes are fitted.

    ``samples``: per pixel in each of the two traces; more where these would differ by more than ``noise``, a mean
    ΔE00, up to :data:`MOST_TIMES` as many.
    """

    paints: Sequence[str]
    environments: Sequence[str]
    size: tuple[int, int] = (128, 128)
    samples: int = 512
    forms: Sequence[str] = tuple(FORMS)
    lobes: bool = False
    surface: str = "sphere"
    keep: Path | None = None
    fitting: FitSettings = field(default_factory=FitSettings)
    noise: float | None = None


@dataclass(frozen=True, eq=False)
class _Truth:
    """A paint, path-traced twice: the light of the whole pictures (h, w, 3) and what is known of them.

    ``covered`` (h, w): pixels without background; ``inside``: those of them that are the paint's alone.
    """

    fit: LobeFit
    scene: ReferenceScene
    traces: tuple[Floats, Floats]
    samples: int
    covered: NDArray[np.bool_]
    inside: NDArray[np.bool_]
    view: View
    name: str

    @property
    def noise(self) -> PictureErrors:
        """The difference between the two traces, over the paint's pixels."""
        one, other = (displayed(trace, self.view) for trace in self.traces)
        return errors_of(one, other, self.inside)


def compare(order: Order, progress: Progress | None = None) -> Iterator[Case]:
    """Yield the cases of an order, one environment after the other.

    Where ``keep`` names a folder, what is traced is kept there, and not traced again while scene and paint stay.

    Raises
    ------
    ExtraError
        Mitsuba or FLIP is missing or cannot be loaded; the message says how to install it.
    ReferenceUnavailableError
        LLVM is missing; the message says what to install.
    ValueRangeError
        A paint has none of the forms.
    SuiteError
        A paint or an environment cannot be read.
    """
    flip_of(np.zeros((8, 8, 3)), np.zeros((8, 8, 3)))  # a missing package is reported before the work begins
    if order.keep is not None:
        make_folder(order.keep)
    view = _plain(order)
    mesh, baked = load_baked(view)
    fits = {
        form: {paint: fit_for(FORMS[form], paint, order.fitting) for paint in order.paints}
        for form in dict.fromkeys((DEFAULT_FORM, *order.forms))
    }
    for paint in order.paints:
        if all(fits[form][paint] is None for form in order.forms):
            raise ValueRangeError("forms", f"{paint} cannot be drawn in any of {', '.join(order.forms)}")
    count = max(1, len(order.environments))
    with OffscreenScene() as scene:
        scene.set_surface(mesh, baked)
        for number, environment in enumerate(order.environments):
            step = subrange(progress, number / count, (number + 1) / count)
            yield from _compare(order, scene, environment, fits, mesh, step)
    report(progress, 1.0, "done")


def _compare(
    order: Order,
    scene: OffscreenScene,
    environment: str,
    fits: Mapping[str, Mapping[str, LobeFit | None]],
    mesh: Mesh,
    progress: Progress | None,
) -> Iterator[Case]:
    prepared = load_environment(environment, basis=order.fitting.basis)
    truths: dict[str, _Truth] = {}
    scene.set_environment(prepared)
    painted = _painted(order, scene, mesh)
    share = 0.5 if order.lobes else 0.9
    for number, paint in enumerate(order.paints):
        fit = fits[DEFAULT_FORM][paint]
        assert fit is not None  # what is not drawn otherwise is drawn as it is
        step = subrange(
            progress, share * number / len(order.paints), share * (number + 1) / len(order.paints)
        )
        truths[paint] = _truth(order, fit, paint, prepared, mesh, painted, step)
    drawn = _drawn(order, scene, environment, prepared, fits, truths)
    for number, (paint, truth) in enumerate(truths.items()):
        step = subrange(progress, share + (1.0 - share) * number / len(order.paints), 1.0)
        yield _case(order, truth, prepared, mesh, drawn[paint], step)


def _truth(
    order: Order,
    fit: LobeFit,
    paint: str,
    prepared: PreparedEnvironment,
    mesh: Mesh,
    painted: NDArray[np.bool_],
    progress: Progress | None,
) -> _Truth:
    plain = Material(fit.name, fit.reflectance)
    traced = build_reference(plain, _plain(order), order.size, prepared.environment, mesh)
    name = f"{Path(paint).stem}__{Path(prepared.name).stem}"
    if order.surface != "sphere":
        name += f"__{Path(order.surface).stem}"
    samples = order.samples
    while True:
        wanted = replace(order, samples=samples)
        one = trace_kept(wanted, traced, name, subrange(progress, 0.0, 0.5))
        other = trace_kept(wanted, traced, f"{name}__2", subrange(progress, 0.5, 1.0), OTHER_SEED)
        coverage = 0.5 * (one.coverage + other.coverage)
        seen = np.concatenate((0.5 * (one.radiance + other.radiance), coverage[..., None]), axis=-1)
        covered = coverage >= WHOLE
        truth = _Truth(
            fit,
            traced,
            (traced.whole(one), traced.whole(other)),
            min(one.samples, other.samples),
            covered,
            covered & painted,
            replace(traced.view, exposure_ev=ev_of(seen) or 0.0),
            name,
        )
        more = _samples_for(order, truth)
        if more <= truth.samples:
            return truth
        samples = more


def _samples_for(order: Order, truth: _Truth) -> int:
    """Return how many samples keep the noise of a truth within that of the order."""
    if order.noise is None or (times := truth.noise.mean / order.noise) <= 1.0:
        return truth.samples
    # The error falls as one over the root of the samples, or faster.
    return min(math.ceil(1.05 * times * times * truth.samples), MOST_TIMES * order.samples)


def _drawn(
    order: Order,
    scene: OffscreenScene,
    environment: str,
    prepared: PreparedEnvironment,
    fits: Mapping[str, Mapping[str, LobeFit | None]],
    truths: Mapping[str, _Truth],
) -> dict[str, dict[str, Floats]]:
    """Return the real-time pictures (h, w, 3), encoded sRGB, by paint and form."""
    drawn: dict[str, dict[str, Floats]] = {paint: {} for paint in truths}
    for light in dict.fromkeys(FORMS[form].light for form in order.forms):
        forms = [form for form in order.forms if FORMS[form].light == light]
        basis = settings_of(FORMS[forms[0]], order.fitting).basis
        maps = prepared if basis is order.fitting.basis else load_environment(environment, basis=basis)
        scene.set_environment(coarser(maps, light[1]))
        for form in forms:
            for paint, truth in truths.items():
                fit = fits[form][paint]
                if fit is None:
                    continue
                view = replace(truth.view, **FORMS[form].view)
                scene.set_material(fit, view=view)
                drawn[paint][form] = displayed(pixel_means(scene, view, order.size), view)
    return {paint: {form: of[form] for form in order.forms if form in of} for paint, of in drawn.items()}


def pixel_means(scene: OffscreenScene, view: View, size: tuple[int, int]) -> Floats:
    """Return the mean radiance (h, w, 3) of each pixel, which is what a path-traced pixel is."""
    width, height = size
    fine = scene.renderer.linear_image(view, (FINER * width, FINER * height))
    light = np.asarray(fine[..., :3], np.float64).reshape(height, FINER, width, FINER, 3)
    return np.asarray(light.mean(axis=(1, 3)))


def _painted(order: Order, scene: OffscreenScene, mesh: Mesh) -> NDArray[np.bool_]:
    """Return the pixels (h, w) that show nothing but the paint: all of each changes with it."""
    width, height = order.size
    view = _plain(order)
    view = replace(view, camera=compose(view.camera, Bounds.of(p.positions for p in mesh.parts), order.size))
    pictures = []
    for paint in ("solid_white", "solid_black"):
        scene.set_material(fit_material(load_material(paint), order.fitting), view=view)
        pictures.append(scene.renderer.linear_image(view, (FINER * width, FINER * height))[..., :3])
    changed = (pictures[0] != pictures[1]).any(axis=-1)
    return np.asarray(changed.reshape(height, FINER, width, FINER).all(axis=(1, 3)))


def _case(
    order: Order,
    truth: _Truth,
    prepared: PreparedEnvironment,
    mesh: Mesh,
    drawn: Mapping[str, Floats],
    progress: Progress | None,
) -> Case:
    view, inside, rest = truth.view, truth.inside, truth.covered & ~truth.inside
    one, other = truth.traces
    pictures = {"reference": displayed(0.5 * (one + other), view), **drawn}
    errors = {form: errors_of(picture, pictures["reference"], inside) for form, picture in drawn.items()}
    look_up: dict[str, PictureErrors] = {}
    if order.lobes:
        material = Material(truth.fit.name, truth.fit.weights)
        lobes = build_reference(material, truth.scene.view, order.size, prepared.environment, mesh)
        found = trace_kept(order, lobes, f"{truth.name}__lobes", progress)
        pictures[LOBES] = displayed(lobes.whole(found), view)
        errors[LOBES] = errors_of(pictures[LOBES], pictures["reference"], inside)
        look_up = {form: errors_of(drawn[form], pictures[LOBES], inside) for form in drawn}
    elsewhere = {form: errors_of(picture, pictures["reference"], rest) for form, picture in drawn.items()}
    first = judged_form(drawn)
    return Case(
        paint=truth.fit.name,
        environment=Path(prepared.name).stem,
        surface=Path(order.surface).stem,
        kind=class_of(truth.fit),
        errors=errors,
        look_up=look_up,
        noise=truth.noise,
        elsewhere=elsewhere if rest.any() else {},
        samples=truth.samples,
        exposure_ev=view.exposure_ev,
        pictures=pictures,
        differences=np.where(truth.covered, delta_e_of(pictures[first], pictures["reference"]), 0.0),
    )


def summary(cases: Sequence[Case], form: str = DEFAULT_FORM) -> dict[str, float]:
    """Return mean ΔE00, the worst paint's mean, the mean of the 99th percentiles, the share above 10, and mean FLIP."""
    drawn = [case for case in cases if form in case.errors]
    return {
        "de00_mean": float(np.mean([case.errors[form].mean for case in drawn])),
        "de00_worst": worst_paint(drawn, form)[1],
        "de00_p99": float(np.mean([case.errors[form].p99 for case in drawn])),
        "share_above_10": float(np.mean([case.errors[form].above_10 for case in drawn])),
        "flip": float(np.mean([case.errors[form].flip for case in drawn])),
    }


def judged_form(drawn: Iterable[str]) -> str:
    """Return that of the ``drawn`` forms by which a case is judged: the default one, or else the first."""
    forms = tuple(drawn)
    return DEFAULT_FORM if DEFAULT_FORM in forms else forms[0]


def worst_paint(cases: Sequence[Case], form: str = DEFAULT_FORM) -> tuple[str, float]:
    """Return the paint whose mean ΔE00 over its cases is largest, and that mean; every case was drawn in ``form``."""
    by_paint: dict[str, list[float]] = {}
    for case in cases:
        by_paint.setdefault(case.paint, []).append(case.errors[form].mean)
    mean, name = max((float(np.mean(values)), name) for name, values in by_paint.items())
    return name, mean


def load_baked(view: View) -> tuple[Mesh, BakedMesh | None]:
    """Return the surface of ``view`` and what is baked for it; a sphere does not shadow itself."""
    mesh = load_shaped(view.surface, view.surface_look)
    return (mesh, None) if view.surface == "sphere" else bake_or_explain(mesh, view.surface_look)


def _plain(order: Order) -> View:
    """The view of a comparison: the paint as its readings give it, without single flakes."""
    return View(surface=order.surface, sparkle=Sparkle(mode="off"))


def trace_kept(
    order: Order, scene: ReferenceScene, name: str, progress: Progress | None, first_seed: int = 0
) -> Estimate:
    """Return a trace of a scene, from the order's folder where it lies there, and kept there afterwards."""
    kept = None
    stem = "".join(c if c.isalnum() or c in "-_" else "_" for c in name)[:160]
    path = None if order.keep is None else order.keep / f"{stem}.exr"
    if path is not None and exists(path):
        kept = read_estimate(path, scene.key)
    if kept is not None and kept.samples >= order.samples:
        return kept
    # Well-spread samples converge faster the more of them there are in a pass; two passes give the noise.
    each = max(4, min(256, order.samples // 2))
    found = trace(
        scene.traced,
        samples=order.samples,
        samples_per_pass=each,
        estimate=kept,
        first_seed=first_seed,
        progress=progress,
    )
    if path is not None:
        write_estimate(path, found, scene.whole(found), scene.key)
    return found


def displayed(radiance: Floats, view: View) -> Floats:
    """Return radiance (..., 3) as it is shown in ``view``, encoded sRGB."""
    return srgb_encode(display_light(radiance, view.exposure_ev, view.tone_curve))
