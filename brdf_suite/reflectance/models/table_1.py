"""The eight car paints of Table 1 of Günther et al. 2005, with the printed numbers.

Metallic (figure 9): Ford F8, Polaris Silver, Opel Titan, BMW 339. Solid: 2K Acrylack, White, Blue, Blue Matte. The
paper fits kd and ks per channel of its camera and names no primaries; they are taken here as the working space's. The
metallic ones have flakes tilted as their lobes say, of a size and density that are assumed.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from types import MappingProxyType

from brdf_suite.appearance.flakes.lobes import flakes_of_lobes
from brdf_suite.documents.cook_torrance import CookTorranceLobe, CookTorrancePaint, Rgb

SOURCE = (
    "Table 1 of Günther, Chen, Goesele, Wald and Seidel, Efficient Acquisition and Realistic Rendering of Car "
    "Paint, VMV 2005: three Cook-Torrance lobes fitted to measurements. The paper's own numbers; the colour "
    "channels of its camera are taken as linear Rec. 2020."
)


def _paint(name: str, kd: Rgb, *lobes: tuple[Rgb, float, float]) -> CookTorrancePaint:
    return CookTorrancePaint(name, kd, tuple(CookTorranceLobe(ks, m, r) for ks, m, r in lobes), source=SOURCE)


def _metallic(name: str, kd: Rgb, *lobes: tuple[Rgb, float, float]) -> CookTorrancePaint:
    paint = _paint(name, kd, *lobes)
    return replace(paint, flakes=flakes_of_lobes(paint))


TABLE_1: Mapping[str, CookTorrancePaint] = MappingProxyType(
    {
        "table1_ford_f8": _metallic(
            "Ford F8",
            (0.0012, 0.0015, 0.0018),
            ((0.0049, 0.0076, 0.012), 0.32, 0.15),
            ((0.01, 0.013, 0.018), 0.11, 0.087),
            ((0.007, 0.0065, 0.0077), 0.013, 0.9),
        ),
        "table1_polaris_silver": _metallic(
            "Polaris Silver",
            (0.055, 0.063, 0.071),
            ((0.065, 0.082, 0.088), 0.38, 1.0),
            ((0.11, 0.13, 0.13), 0.17, 0.92),
            ((0.008, 0.013, 0.015), 0.013, 0.9),
        ),
        "table1_opel_titan": _metallic(
            "Opel Titan",
            (0.011, 0.013, 0.015),
            ((0.057, 0.066, 0.078), 0.38, 0.85),
            ((0.1, 0.12, 0.13), 0.17, 0.86),
            ((0.0095, 0.014, 0.016), 0.014, 0.9),
        ),
        "table1_bmw_339": _metallic(
            "BMW 339",
            (0.012, 0.015, 0.016),
            ((0.062, 0.076, 0.08), 0.39, 0.92),
            ((0.11, 0.12, 0.12), 0.17, 0.87),
            ((0.0083, 0.015, 0.016), 0.013, 0.9),
        ),
        "table1_2k_acrylack": _paint(
            "2K Acrylack",
            (0.42, 0.32, 0.1),
            ((0.0, 0.0, 0.0), 0.88, 1.0),
            ((0.028, 0.026, 0.006), 0.8, 0.9),
            ((0.017, 0.0075, 0.0041), 0.015, 0.17),
        ),
        "table1_white": _paint(
            "White",
            (0.61, 0.63, 0.55),
            ((2.6e-06, 0.00031, 3.1e-08), 1.0, 0.049),
            ((0.013, 0.011, 0.0083), 0.15, 0.45),
            ((0.049, 0.042, 0.037), 0.015, 0.17),
        ),
        "table1_blue": _paint(
            "Blue",
            (0.0079, 0.023, 0.1),
            ((0.0011, 0.0015, 0.0019), 0.15, 1.0),
            ((0.025, 0.03, 0.043), 0.043, 0.094),
            ((0.059, 0.074, 0.082), 0.02, 0.17),
        ),
        "table1_blue_matte": _paint(
            "Blue Matte",
            (0.0099, 0.036, 0.12),
            ((0.0032, 0.0045, 0.0059), 0.16, 1.0),
            ((0.18, 0.23, 0.28), 0.075, 0.046),
            ((0.04, 0.049, 0.051), 0.034, 0.17),
        ),
    }
)
"""By name: a prefix distinguishes them from the shipped paints, one of which is called ``blue`` too."""
