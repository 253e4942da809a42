"""The part of bench texture about grain: its mean, contrast and spectrum, drawn and traced, and whether it holds still.

Coarse silver on a sphere, in the shipped light; in the sun the surface is seen 25° from the mirror direction. What is
measured is the picture with flakes over that without, minus 1. Populations differ by where they lie on the sphere.
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np

from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.appearance.flakes.visible import full_density
from brdf_suite.documents.view import SENSOR_WIDTH_MM, Camera, View
from brdf_suite.documents.view_settings import Sparkle, SurfaceLook
from brdf_suite.pipeline.lobe_fit import fit_material
from brdf_suite.pipeline.material import load_material
from brdf_suite.pipeline.picture import OffscreenScene
from brdf_suite.pipeline.scene import load_environment
from brdf_suite.pipeline.surface import load_shaped
from brdf_suite.progress import report
from brdf_suite.reference.passes import trace
from brdf_suite.tracing.agreement.flakes import with_population
from brdf_suite.tracing.reference.scene import build_reference

PAINT = "coarse_silver"
LIGHTS = ("sunny", "booth", "overcast")
RADIUS, MIDDLE = 0.1, (0.0, 0.1, 0.0)
_AWAY_DEG = 25.0
#: Of the views beside the one to the sun: places in booth and overcast.
_PLACES = ((35.0, 20.0), (60.0, 30.0), (200.0, 40.0), (0.0, 10.0))
_DISTANCES_M = (0.1, 0.2, 0.35, 0.5, 1.0, 2.0, 4.0)
_PIXELS_AT_10_CM_MM = 0.075
_SEEDS = 64
_FIELD_MM, _LONGEST_MM = 80.0, 1200.0
_BANDS = ((1.0, 2.5), (2.5, 5.0), (5.0, 10.0), (10.0, 20.0))
_TRACED_MM, _TRACED_SIZE, _SAMPLES, _POPULATIONS = 0.02, 160, 32, 4

BOUNDS = {
    "mean_error": (
        "<=",
        0.003,
        "",
        "mean of the picture with texture over that without, minus 1: three lights, 10 cm to 1 m, 64 populations",
    ),
    "mean_standard_error": ("<=", 0.001, "", "the largest standard error of such a mean"),
    "grain_sun": (
        ">=",
        0.3,
        "",
        "standard deviation over mean of the pixels below their 99th percentile, at 10 cm in the sun",
    ),
    "grain_booth": (">=", 0.1, "", "the same in the booth"),
    "grain_overcast": (">=", 0.04, "", "the same under the overcast sky"),
    "contrast_law_error": (
        "<=",
        0.15,
        "",
        "contrast times the root of flakes per pixel, booth and overcast, 10 cm to 4 m: from its median, largest",
    ),
    "traced_variance_error": (
        "<=",
        0.15,
        "",
        "variance in real time over traced, minus 1, four places of each light at .02 mm a pixel: the worst light",
    ),
    "traced_spectrum_error": (
        "<=",
        0.15,
        "",
        "the same of the radial spectrum in four bands of 1 to 20 cycles/mm, over all lights: the worst band",
    ),
    "coherence": (
        ">=",
        0.97,
        "",
        "correlation of the grain moved by a tenth of a pixel, and by one and back: the least of three lights",
    ),
}


class _Scene(NamedTuple):
    scene: OffscreenScene
    fit: Any
    mesh: Any
    environments: dict[str, Any]


def figures(notes: dict[str, str], progress=None) -> dict[str, float]:
    """Return the figures of :data:`BOUNDS`."""
    fit = fit_material(load_material(PAINT))
    mesh = load_shaped("sphere", SurfaceLook())
    with OffscreenScene() as scene:
        known = _Scene(scene, fit, mesh, {name: load_environment(name) for name in LIGHTS})
        scene.set_surface(mesh, None)
        found = _means(known, notes, progress)
        found |= _contrasts(known, progress)
        found["coherence"] = min(_coherence(known, light) for light in LIGHTS)
        found |= _against_traced(known, notes, progress)
    return found


def _view(known: _Scene, light: str, place: int, distance: float, focal_mm: float) -> View:
    """Return a view of a place: in the sun 25° beside its mirror direction, to one side or another."""
    azimuth, elevation = _PLACES[place]
    if light == "sunny":
        sun = known.environments[light].glint_lights.directions[0]
        azimuth = math.degrees(math.atan2(sun[0], sun[2]))
        elevation = math.degrees(math.asin(sun[1]))
        turn = math.radians(90.0 * place + 20.0)
        azimuth += _AWAY_DEG * math.cos(turn) / math.cos(math.radians(elevation))
        elevation += _AWAY_DEG * math.sin(turn)
    camera = Camera(azimuth, elevation, RADIUS + distance, MIDDLE, focal_mm)
    return View(surface="sphere", environment=light, camera=camera)


def _relative(known: _Scene, view: View, size: int) -> np.ndarray:
    """Return the picture with flakes over that without (size, size), minus 1."""
    known.scene.set_material(known.fit, view=view)
    plain = replace(view, sparkle=Sparkle(mode="off"))
    one, other = (
        known.scene.renderer.linear_image(v, (size, size))[..., :3] @ LUMINANCE for v in (view, plain)
    )
    return np.asarray(one, np.float64) / np.asarray(other, np.float64) - 1.0


def _focal(distance: float, pixel_mm: float, size: int) -> float:
    return SENSOR_WIDTH_MM * 1e3 * distance / (pixel_mm * size)


def _means(known: _Scene, notes: dict[str, str], progress) -> dict[str, float]:
    errors: dict[str, tuple[float, float]] = {}
    for i, light in enumerate(LIGHTS):
        known.scene.set_environment(known.environments[light])
        for j, distance in enumerate((0.1, 0.35, 1.0)):
            report(progress, 0.05 * (3 * i + j), f"{light}, populations")
            size = 384 if light == "sunny" else 96
            # A field so small that the light is even over it.
            pixel = _PIXELS_AT_10_CM_MM * distance / 0.1
            view = _view(known, light, 0, distance, _focal(distance, pixel, size))
            means = []
            for seed in range(_SEEDS):
                known.scene.set_surface(*with_population(known.mesh, None, seed))
                means.append(float(_relative(known, view, size).mean()))
            errors[f"{light} at {distance:g} m"] = (
                abs(float(np.mean(means))),
                float(np.std(means, ddof=1) / math.sqrt(_SEEDS)),
            )
    known.scene.set_surface(known.mesh, None)
    worst = max(errors, key=lambda name: errors[name][0])
    notes["mean_error"] = worst
    return {
        "mean_error": errors[worst][0],
        "mean_standard_error": max(error for _, error in errors.values()),
    }


def _contrasts(known: _Scene, progress) -> dict[str, float]:
    found = {}
    laws = []
    for light, key in zip(LIGHTS, ("grain_sun", "grain_booth", "grain_overcast"), strict=True):
        report(progress, 0.5, f"{light}, contrast")
        known.scene.set_environment(known.environments[light])
        grain = 1.0 + _relative(
            known, _view(known, light, 0, 0.1, _focal(0.1, _PIXELS_AT_10_CM_MM, 320)), 320
        )
        seen = grain[grain < np.quantile(grain, 0.99)]
        found[key] = float(seen.std() / seen.mean())
        if light == "sunny":
            continue
        scaled = []
        for distance in _DISTANCES_M:
            pixel = _PIXELS_AT_10_CM_MM * distance / 0.1
            # The sphere leans beyond a field, and a camera's focal length ends.
            field = min(320, int(_FIELD_MM / pixel))
            size = max(field, math.ceil(SENSOR_WIDTH_MM * 1e3 * distance / (pixel * _LONGEST_MM)))
            change = _relative(known, _view(known, light, 0, distance, _focal(distance, pixel, size)), size)
            edge = (size - field) // 2
            change = change[edge : edge + field, edge : edge + field]
            scaled.append(change.std() * pixel * math.sqrt(full_density(known.fit.flakes.size_um)))
        laws.append(np.abs(np.asarray(scaled) / np.median(scaled) - 1.0).max())
    return found | {"contrast_law_error": float(max(laws))}


def _coherence(known: _Scene, light: str) -> float:
    known.scene.set_environment(known.environments[light])
    size, pixel = 256, _PIXELS_AT_10_CM_MM
    view = _view(known, light, 0, 0.1, _focal(0.1, pixel, size))
    azimuth = math.radians(view.camera.azimuth_deg)
    aside = np.array([math.cos(azimuth), 0.0, -math.sin(azimuth)]) * pixel * 1e-3

    def moved(pixels: float) -> np.ndarray:
        target = tuple(float(x) for x in np.asarray(MIDDLE) + pixels * aside)
        return _relative(known, replace(view, camera=replace(view.camera, target=target)), size)

    def correlation(one: np.ndarray, other: np.ndarray) -> float:
        return float(np.corrcoef(one.ravel(), other.ravel())[0, 1])

    first, tenth, whole = moved(0.0), moved(0.1), moved(1.0)
    # The picture moves the other way.
    shifted = max(correlation(first[:, 4:-4], np.roll(whole, step, axis=1)[:, 4:-4]) for step in (-1, 1))
    return min(correlation(first, tenth), shifted)


def _against_traced(known: _Scene, notes: dict[str, str], progress) -> dict[str, float]:
    size = _TRACED_SIZE
    frequency = np.hypot(*np.meshgrid(*(np.fft.fftfreq(size, _TRACED_MM),) * 2))
    bands = [(frequency >= low) & (frequency < high) for low, high in _BANDS]
    errors, spectra = {}, []
    for i, light in enumerate(LIGHTS):
        known.scene.set_environment(known.environments[light])
        drawn_variances, traced_variances = [], []
        for place in range(len(_PLACES)):
            report(progress, 0.6 + 0.13 * i + 0.03 * place, f"{light}, traced")
            view = _view(known, light, place, 0.06, _focal(0.06, _TRACED_MM, size))
            for population in range(_POPULATIONS):
                mesh, _ = with_population(known.mesh, None, population)
                known.scene.set_surface(mesh, None)
                drawn = _relative(known, view, size)
                one, other = (traced - 1.0 for traced in _traced(known, mesh, light, view))
                drawn_variances.append(drawn.var())
                # Two traces have no noise in common.
                traced_variances.append(((one - one.mean()) * (other - other.mean())).mean())
                transforms = [np.fft.fft2(x - x.mean()) for x in (drawn, one, other)]
                power = np.abs(transforms[0]) ** 2, (transforms[1] * np.conj(transforms[2])).real
                spectra.append([[p[band].mean() / power[1].mean() for band in bands] for p in power])
        errors[light] = float(np.mean(drawn_variances) / np.mean(traced_variances) - 1.0)
    known.scene.set_surface(known.mesh, None)
    worst = max(errors, key=lambda light: abs(errors[light]))
    notes["traced_variance_error"] = ", ".join(f"{light} {error:+.2f}" for light, error in errors.items())
    ours, theirs = np.mean(spectra, axis=0)
    away = ours / theirs - 1.0
    notes["traced_spectrum_error"] = ", ".join(f"{error:+.2f}" for error in away)
    return {"traced_variance_error": abs(errors[worst]), "traced_spectrum_error": float(np.abs(away).max())}


def _traced(known: _Scene, mesh: Any, light: str, view: View) -> list[np.ndarray]:
    """Return two independent traces (h, w) of luminance with flakes, over the smooth drawn one in its mean."""
    size = (_TRACED_SIZE, _TRACED_SIZE)
    environment = known.environments[light].environment
    plain = replace(view, sparkle=Sparkle(mode="off"))
    scenes = [build_reference(known.fit.material, v, size, environment, mesh) for v in (view, plain)]
    smooth = trace(scenes[1].traced, samples=_SAMPLES).radiance @ LUMINANCE
    shape = known.scene.renderer.linear_image(plain, size)[..., :3] @ LUMINANCE
    even = shape * (smooth.mean() / shape.mean())
    return [
        trace(scenes[0].traced, samples=_SAMPLES, samples_per_pass=16, first_seed=seed).radiance
        @ LUMINANCE
        / even
        for seed in (0, 1000)
    ]
