"""Names of the slices' angles and quantities, as axes and readouts have them."""

from __future__ import annotations

from brdf_qt.translation import mark, tr

from brdf_lobe_visualizer.options import Cosine, Options
from brdf_suite.pipeline.slices import Axis

AXIS_TITLES: dict[Axis, str] = {
    "gamma": mark("Aspecular angle γ (°)"),
    "theta_o": mark("Angle of view θo (°)"),
    "theta_h": mark("Half angle θh (°)"),
    "theta_d": mark("Difference angle θd (°)"),
}
AXIS_LETTERS: dict[Axis, str] = {"gamma": "γ", "theta_o": "θo", "theta_h": "θh", "theta_d": "θd"}
AXIS_TIPS: dict[Axis, str] = {
    "gamma": mark(
        "In the plane of incidence, over the angle from the mirror direction; positive towards the normal."
    ),
    "theta_o": mark(
        "In the plane of incidence, over the view's angle from the normal; positive on the mirror direction's side."
    ),
    "theta_h": mark("Over the angle between half vector and normal, at the θd and φd of the section Slices."),
    "theta_d": mark("Over the angle between light and half vector, at the θh and φd of the section Slices."),
}
_QUANTITIES: dict[tuple[Cosine, str], str] = {
    ("none", "y"): mark("luminance of f_r"),
    ("none", "r"): mark("red of f_r"),
    ("none", "g"): mark("green of f_r"),
    ("none", "b"): mark("blue of f_r"),
    ("light", "y"): mark("luminance of f_r·cosθi"),
    ("light", "r"): mark("red of f_r·cosθi"),
    ("light", "g"): mark("green of f_r·cosθi"),
    ("light", "b"): mark("blue of f_r·cosθi"),
    ("both", "y"): mark("luminance of f_r·cosθi·cosθo"),
    ("both", "r"): mark("red of f_r·cosθi·cosθo"),
    ("both", "g"): mark("green of f_r·cosθi·cosθo"),
    ("both", "b"): mark("blue of f_r·cosθi·cosθo"),
}
UNIT = "1/sr"


def quantity(options: Options) -> str:
    """Return what is drawn, with its unit: ``luminance of f_r·cosθi (1/sr)``."""
    channel = options.channel if options.channel in ("r", "g", "b") else "y"
    words = tr(_QUANTITIES[options.cosine, channel])
    if options.shown == "difference":
        return tr("Δ {quantity} ({unit})").format(quantity=words, unit=UNIT)
    return tr("{quantity} ({unit})").format(quantity=words, unit=UNIT)


def degrees(axis: Axis, angle_deg: float) -> str:
    """Return an angle as a readout has it: ``γ 12.50°``."""
    size = abs(angle_deg)
    digits = 3 if size < 1.0 else 2 if size < 10.0 else 1
    return f"{AXIS_LETTERS[axis]} {angle_deg:.{digits}f}°".replace("-", "−")
