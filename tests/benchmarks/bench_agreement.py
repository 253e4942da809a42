"""Error of the real-time picture against path tracing on shapes that shadow themselves, with single flakes, and of
measured files of which a fifth of the directions was held out of the fit.

``reference`` has the sphere, pixel by pixel. Path-traced pictures are kept as there.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np

from brdf_suite.cli.tools.bench import load_module
from brdf_suite.progress import Progress, subrange
from brdf_suite.tracing.agreement.comparison import Order, compare, summary
from brdf_suite.tracing.agreement.flakes import compare_flakes
from brdf_suite.tracing.agreement.forms import DEFAULT_FORM, HELD_OUT_FORM

_reference = load_module(Path(__file__).with_name("bench_reference.py"))

NAME = "agreement"

SURFACES = ("speed_form", "car")
#: One paint of each class.
SHOWN = (
    "red_metallic",
    "gold_green_shift",
    "satin_blue",
    "matte_grey",
    "table1_ford_f8",
    "cayman.brdf",
    "vch_golden_yellow_rgb.bsdf",
)
WITH_FLAKES = ("coarse_silver", "blue", "copper", "gunmetal")
MEASURED = _reference.CLASSES["scattered"]

#: key: (comparison, bound, unit, meaning)
BOUNDS: dict[str, tuple[str, float | None, str, str]] = {
    "speed_form_de00_mean": (
        "<=",
        0.6,
        "",
        "one paint of each class on the speed form, shipped light: mean ΔE00",
    ),
    "car_de00_mean": (
        "<=",
        1.5,
        "",
        "the same on the car, whose bonnet mirrors its windscreen: the paint's pixels",
    ),
    "car_other_de00_mean": ("", None, "", "the same, pixels with other materials: glass, lamps, tyres"),
    "held_out_de00_mean": (
        "<=",
        1.5,
        "",
        "scattered samples on a sphere, lobes of four fifths of the directions, paint of all: mean ΔE00",
    ),
    "held_out_de00_worst": ("<=", 2.0, "", "the same, the worst file's mean"),
    "held_out_change": ("", None, "", "the same over the error of lobes that know all directions"),
    "flakes_de00_mean": (
        "<=",
        0.6,
        "",
        "single flakes on a sphere of 10 mm, means over 16×16 pixels and eight populations: mean ΔE00",
    ),
    "flakes_de00_worst": ("", None, "", "the same, the worst paint and environment"),
    "flakes_traces_de00_mean": ("<=", 0.3, "", "the same between the two traces"),
    "flakes_luminance": (
        "",
        None,
        "",
        "real-time luminance with flakes over the traced one, farthest from 1",
    ),
}

NOTES: dict[str, str] = {}
TABLES: dict[str, dict[str, object]] = {}

SIZE, SAMPLES = _reference.SIZE, _reference.SAMPLES


def run(progress: Progress | None = None) -> dict[str, float | None]:
    """Trace, draw and compare."""
    shared = _reference.shared_data()
    shipped, everywhere = _reference.lights(shared)
    measured, shown = (_reference.paints_there(names, shared) for names in (MEASURED, SHOWN))
    order = Order(shown, shipped, SIZE, SAMPLES, (DEFAULT_FORM,), keep=_reference.kept_traces())
    found: dict[str, float | None] = {}
    for number, surface in enumerate(SURFACES):
        step = subrange(progress, 0.2 * number, 0.2 * (number + 1))
        shaped = list(compare(replace(order, surface=surface), step))
        found[f"{surface}_de00_mean"] = summary(shaped)["de00_mean"]
    others = [case.elsewhere[DEFAULT_FORM].mean for case in shaped]
    found["car_other_de00_mean"] = float(np.mean(others))
    held_out = replace(order, paints=measured, environments=everywhere, forms=(DEFAULT_FORM, HELD_OUT_FORM))
    compared = compare(held_out, subrange(progress, 0.4, 0.6)) if measured else []
    cases = [case for case in compared if HELD_OUT_FORM in case.errors]
    whole, part = (summary(cases, form) if cases else {} for form in held_out.forms)
    flaky = replace(order, paints=WITH_FLAKES, environments=everywhere)
    flakes = list(compare_flakes(flaky, subrange(progress, 0.6, 1.0)))
    TABLES["with_flakes"] = {f"{case.paint} in {case.environment}": case.to_json() for case in flakes}
    worst = max(flakes, key=lambda case: case.de00_mean)
    NOTES["flakes_de00_worst"] = f"{worst.paint} in {worst.environment}"
    return found | {
        "held_out_de00_mean": part.get("de00_mean"),
        "held_out_de00_worst": part.get("de00_worst"),
        "held_out_change": part["de00_mean"] / whole["de00_mean"] if cases else None,
        "flakes_de00_mean": float(np.mean([case.de00_mean for case in flakes])),
        "flakes_de00_worst": worst.de00_mean,
        "flakes_traces_de00_mean": float(np.mean([case.noise for case in flakes])),
        "flakes_luminance": max((case.luminance for case in flakes), key=lambda ratio: abs(ratio - 1.0)),
    }
