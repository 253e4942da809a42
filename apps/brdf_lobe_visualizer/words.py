"""Names of angles, quantities and parts of a fit, and numbers, as all views write them."""

from __future__ import annotations

import math

from brdf_qt.program.translation import decimal, mark, tr

from brdf_lobe_visualizer.options import Options
from brdf_suite.inspection.lobe_surface.parts import FitLobe, FitPart
from brdf_suite.inspection.slices.cuts import Axis
from brdf_suite.inspection.slices.values import Cosine

AXIS_TITLES: dict[Axis, str] = {
    "gamma": mark("Aspecular angle γ (°)"),
    "theta_o": mark("View angle θo (°)"),
    "theta_h": mark("Half angle θh (°)"),
    "theta_d": mark("Difference angle θd (°)"),
}
AXIS_LETTERS: dict[Axis, str] = {"gamma": "γ", "theta_o": "θo", "theta_h": "θh", "theta_d": "θd"}
AXIS_TIPS: dict[Axis, str] = {
    "gamma": mark(
        "In the plane of incidence, over the angle from the mirror direction (positive towards the normal)"
    ),
    "theta_o": mark(
        "In the plane of incidence, over the view angle from the normal (positive on the side of the mirror direction)"
    ),
    "theta_h": mark("Over the angle between half vector and normal, at the θd and φd set in Slices"),
    "theta_d": mark("Over the angle between light and half vector, at the θh and φd set in Slices"),
}
_FACTORS: dict[Cosine, str] = {"none": "f_r", "light": "f_r·cosθi", "both": "f_r·cosθi·cosθo"}
PART_TITLES: dict[FitPart, str] = {
    "diffuse": mark("Diffuse"),
    "directional": mark("Directional diffuse"),
    "gloss": mark("Gloss"),
}
UNIT = "1/sr"


def quantity(options: Options) -> str:
    """Return what is drawn, with its unit: ``Y  f_r·cosθi (1/sr)``, luminance Y or a channel."""
    channel = options.channel.upper() if options.channel in ("r", "g", "b") else "Y"
    sign = "Δ " if options.shown == "difference" else ""
    return f"{sign}{channel}  {_FACTORS[options.cosine]} ({UNIT})"


def degrees(axis: Axis, angle_deg: float) -> str:
    """Return an angle as a readout has it: ``γ 12.50°``."""
    size = abs(angle_deg)
    digits = 3 if size < 1.0 else 2 if size < 10.0 else 1
    return decimal(f"{AXIS_LETTERS[axis]} {angle_deg:.{digits}f}°").replace("-", "−")


def lobe_title(lobe: FitLobe) -> str:
    """Return part and exponent of a lobe, as it is listed."""
    part = tr(PART_TITLES[lobe.part])
    text = tr("{part}, E = {exponent}")
    return part if lobe.exponent is None else text.format(part=part, exponent=number(lobe.exponent))


def lobe_weight(lobe: FitLobe) -> str:
    """Return the weight of a lobe in the three channels."""
    red, green, blue = (
        decimal(f"{value:.0f}") if 1e3 <= value < 1e5 else decimal(f"{value:.3g}") for value in lobe.weight
    )
    return tr("{red} · {green} · {blue} 1/sr").format(red=red, green=green, blue=blue)


def number(value: float) -> str:
    """Return ``value`` with four digits, which keep their width; a dash where there is none.

    >>> number(0.123456), number(1234567.0), number(float("nan"))
    ('0.1235', '1.235e6', '–')
    """
    if not math.isfinite(value):
        return "–"
    if value == 0.0:
        return "0"
    size = abs(value)
    if 1e-3 <= size < 1e5:
        text = decimal(f"{value:.{max(0, 3 - math.floor(math.log10(size)))}f}")
    else:
        digits, power = f"{value:.3e}".split("e")
        text = decimal(f"{digits}e{int(power)}")
    return text.replace("-", "−")


def plain(value: float) -> str:
    """Return a round ``value`` as an axis has it: no exponent between a thousandth and a hundred thousand.

    >>> plain(2000.0), plain(0.015), plain(1.5e-7)
    ('2000', '0.015', '1.5e−7')
    """
    if value == 0.0 or 1e-3 <= abs(value) < 1e5:
        return decimal(f"{float(f'{value:.3g}'):g}").replace("-", "−")
    digits, power = f"{value:.2e}".split("e")
    return decimal(f"{float(digits):g}e{int(power)}").replace("-", "−")
