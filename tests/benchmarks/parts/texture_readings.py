"""The part of bench texture about the virtual instrument: its ranking, its spread, and flakes from readings."""

from __future__ import annotations

import math

import numpy as np

from brdf_suite.appearance.flakes.visible import full_density
from brdf_suite.documents.paint import Flakes
from brdf_suite.inspection.texture.camera import measure_texture
from brdf_suite.inspection.texture.expectation import expected_scales
from brdf_suite.inspection.texture.inverse import find_flakes
from brdf_suite.inspection.texture.readings import paint_light
from brdf_suite.pipeline.lobe_fit import fit_material
from brdf_suite.pipeline.material import load_material, paint_names
from brdf_suite.progress import report

_COLOURS = ("fine_silver", "blue", "dark_grey", "red", "pearl", "candy_red")
_SIZES_UM = (10.0, 14.0, 20.0, 28.0, 40.0)
_DENSITIES = (20.0, 60.0, 200.0, 600.0)
_SPARSE_UM = 15.0
_SHOWN = ("fine_silver", "blue", "coarse_silver")
_SEEDS, _TARGETS = 10, 4

BOUNDS = {
    "readings_monotone": (
        ">=",
        1.0,
        "",
        "share of neighbouring paints in right order: sparkle intensity and graininess by flake size at full coverage, "
        "sparkle area and points by the density of 15 µm flakes, six colours",
    ),
    "readings_repeat": (
        "<=",
        0.03,
        "",
        "standard deviation over ten seeds over the mean, thirteen readings of each shipped paint with flakes: largest",
    ),
    "readings_expected_error": (
        "",
        None,
        "",
        "mean of these grades and graininess over their expectation without a picture, minus 1: largest",
    ),
    **{
        f"{name}_{kind}": ("", None, "", f"{name.replace('_', ' ')}: {what}, mean of ten seeds")
        for name in _SHOWN
        for kind, what in (("grade", "sparkle grade under light from 45°"), ("graininess", "graininess"))
    },
    "inverse_error": (
        "<=",
        0.05,
        "",
        "readings (of four pictures) of flakes found for the readings of random ones over these, minus 1: largest of "
        "24 paints, three grades and graininess",
    ),
}


def figures(notes: dict[str, str], progress=None) -> dict[str, float]:
    """Return the figures of :data:`BOUNDS`."""
    report(progress, 0.0, "ranking")
    found = {"readings_monotone": _monotone()}
    report(progress, 0.2, "repeating")
    found |= _repeat(notes)
    report(progress, 0.6, "inverse")
    found["inverse_error"] = _inverse(notes)
    return found


def _light(name: str):
    return paint_light(fit_material(load_material(name)).weights)


def _values(readings) -> np.ndarray:
    """Return (13,) all readings: points, area, intensity and grade of each light, and graininess."""
    each = [(one.points_per_mm2, one.area, one.intensity, one.grade) for one in readings.sparkle]
    return np.array([*np.ravel(each), readings.graininess])


def _monotone() -> float:
    steps = []
    for name in _COLOURS:
        light = _light(name)
        by_size = [measure_texture(light, Flakes(full_density(size), size, 0.16)) for size in _SIZES_UM]
        rows = [[*(one.intensity for one in r.sparkle), r.graininess] for r in by_size]
        steps.append(np.diff(rows, axis=0) > 0.0)
        by_density = [measure_texture(light, Flakes(density, _SPARSE_UM, 0.16)) for density in _DENSITIES]
        rows = [
            [*(one.area for one in r.sparkle), *(one.points_per_mm2 for one in r.sparkle)] for r in by_density
        ]
        steps.append(np.diff(rows, axis=0) > 0.0)
    return float(np.mean(np.concatenate([step.ravel() for step in steps])))


def _repeat(notes: dict[str, str]) -> dict[str, float]:
    spreads, away, shown = {}, {}, {}
    for name in paint_names():
        material = load_material(name)
        if material.flakes is None:
            continue
        light = _light(name)
        values = np.array([_values(measure_texture(light, material.flakes, seed)) for seed in range(_SEEDS)])
        mean = values.mean(axis=0)
        seen = mean > 0.0
        spreads[name] = float((values.std(axis=0, ddof=1)[seen] / mean[seen]).max())
        if name in _SHOWN:
            shown[f"{name}_grade"], shown[f"{name}_graininess"] = float(mean[7]), float(mean[12])
        expected = expected_scales(light, material.flakes)
        away[name] = float(np.abs(mean[[3, 7, 11, 12]] / expected - 1.0).max())
    worst = max(spreads, key=lambda name: spreads[name])
    notes["readings_repeat"] = f"{worst}; median of the paints {np.median(list(spreads.values())):.3f}"
    return shown | {"readings_repeat": spreads[worst], "readings_expected_error": max(away.values())}


def _inverse(notes: dict[str, str]) -> float:
    rng = np.random.default_rng(20)
    errors = []
    for name in _COLOURS:
        light = _light(name)
        for _ in range(_TARGETS):
            size = float(rng.uniform(10.0, 30.0))
            density = math.exp(rng.uniform(math.log(0.1), 0.0)) * full_density(size)
            asked = Flakes(density, size, float(rng.uniform(0.145, 0.19)))
            wanted = _scales(light, asked, range(10, 14))
            found = find_flakes(light, wanted.tolist())
            errors.append(_scales(light, found.flakes, range(4)) / wanted - 1.0)
    notes["inverse_error"] = f"root mean square {np.sqrt(np.mean(np.square(errors))):.3f}"
    return float(np.abs(errors).max())


def _scales(light, flakes: Flakes, seeds) -> np.ndarray:
    return np.mean([measure_texture(light, flakes, seed).scales() for seed in seeds], axis=0)
