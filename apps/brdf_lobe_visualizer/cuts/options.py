"""How the slices are shown: which angle, at which others, log axes, the light of the images; remembered."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from PySide6.QtCore import QObject

from brdf_lobe_visualizer.options import OptionState
from brdf_suite.inspection.slices.cuts import AXES, Axis
from brdf_suite.inspection.slices.images import SEED_INCIDENCES_DEG, TONES, Tone

Polar = Literal["range", "linear", "cbrt", "log"]
POLARS: tuple[Polar, ...] = ("range", "linear", "cbrt", "log")

EV_RANGE = (-10.0, 10.0)


@dataclass(frozen=True)
class SliceOptions:
    """The options; the defaults are what a reset goes back to. Angles are degrees.

    - ``axis``: the angle under the curves.
    - ``log_value``, ``log_angle``: logarithmic axes of the curves.
    - ``follow``: the cut over θh is at the θd of the mirror configuration, which is the incidence; else at
      ``theta_d_deg``.
    - ``theta_d_deg``, ``theta_h_deg``, ``phi_d_deg``: where the cuts over θh and θd, and the half-angle image, are.
    - ``incidences_deg``: those of the unrolled hemispheres.
    - ``tone``, ``ev``: how images become codes, and stops above the exposure that fits their values.
    - ``by_root``: θh of the half-angle image by its root, as measured tables have it.
    - ``polar``: the radius of the polar plot: ``"range"`` is that of the views, but logarithmic where values lie so
      far apart that nothing but their peak would be seen.
    - ``samples``: measured samples are drawn.
    """

    axis: Axis = "gamma"
    log_value: bool = True
    log_angle: bool = False
    follow: bool = True
    theta_d_deg: float = 45.0
    theta_h_deg: float = 0.0
    phi_d_deg: float = 90.0
    incidences_deg: tuple[float, float, float] = SEED_INCIDENCES_DEG
    tone: Tone = "log"
    ev: float = 0.0
    by_root: bool = True
    polar: Polar = "range"
    samples: bool = True


_CHOICES: dict[str, tuple[str, ...]] = {"axis": AXES, "tone": TONES, "polar": POLARS}
_RANGES = {
    "theta_d_deg": (0.0, 89.9),
    "theta_h_deg": (0.0, 89.9),
    "phi_d_deg": (0.0, 180.0),
    "incidences_deg": (0.0, 89.0),
    "ev": EV_RANGE,
}


class SliceState(OptionState[SliceOptions]):
    """Holds the options and remembers them."""

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__("lobes/slices", SliceOptions(), _CHOICES, _RANGES, parent)
