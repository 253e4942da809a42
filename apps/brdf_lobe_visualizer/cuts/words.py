"""Names of the slices' angles and quantities, as axes and readouts have them."""

from __future__ import annotations

from brdf_qt.program.translation import mark

from brdf_lobe_visualizer.options import Options
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
    return f"{AXIS_LETTERS[axis]} {angle_deg:.{digits}f}°".replace("-", "−")
