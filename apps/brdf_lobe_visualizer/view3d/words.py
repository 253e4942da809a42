"""Names of a fit's parts and lobes."""

from __future__ import annotations

from brdf_qt.program.translation import mark, tr

from brdf_lobe_visualizer.cuts.crosshair import number
from brdf_suite.inspection.lobe_surface.parts import FitLobe, FitPart

PART_TITLES: dict[FitPart, str] = {
    "diffuse": mark("Diffuse"),
    "directional": mark("Directional diffuse"),
    "gloss": mark("Gloss"),
}


def lobe_title(lobe: FitLobe) -> str:
    """Return part and exponent of a lobe, as it is listed."""
    part = tr(PART_TITLES[lobe.part])
    if lobe.exponent is None:
        return part
    return tr("{part}, E = {exponent}").format(part=part, exponent=number(lobe.exponent))


def lobe_weight(lobe: FitLobe) -> str:
    """Return the weight of a lobe in the three channels."""
    red, green, blue = (_short(value) for value in lobe.weight)
    return tr("{red} · {green} · {blue} 1/sr").format(red=red, green=green, blue=blue)


def _short(value: float) -> str:
    """Three digits; of large numbers all before the point."""
    return f"{value:.0f}" if 1e3 <= value < 1e5 else f"{value:.3g}"
