"""Which value has radius 1: the greatest, that of the bodies, a number that is held, or one by which both are seen."""

from __future__ import annotations

import numpy as np

from brdf_lobe_visualizer.view3d.options import BODY_DEG, SpaceOptions
from brdf_suite.arrays import Singles
from brdf_suite.inspection.lobe_surface.grid import LobeGrid
from brdf_suite.inspection.lobe_surface.scale import RadiusKind, RadiusScale
from brdf_suite.inspection.lobe_surface.surface import greatest

BODY_RADIUS = 0.5
"""How long a body is at least where the radius is automatic, whatever its mirror peak."""
_NO_BODY = 1e-8
"""Share of the peak below which there is a spike and no body."""
_LEAST = 1e-30
"""Values below are nothing: a single's inverse of them is none."""


def tops_of(grid: LobeGrid, shown: Singles) -> tuple[float, float]:
    """Return the greatest of values (rows, columns) on a grid, and the greatest off the mirror direction."""
    body = np.where(grid.gamma > np.radians(BODY_DEG), shown, np.float32(0.0))
    return greatest(shown), greatest(body)


def full_of(peak: float, body: float, kind: RadiusKind, options: SpaceOptions) -> float:
    """Return the value of radius 1, above 0, for the greatest values that are shown.

    The automatic one is the peak as long as the body is :data:`BODY_RADIUS` long then; of a higher peak, as a coat
    has it, the rest is cut off. It moves evenly with both, so that nothing jumps while the light is dragged.
    """
    if options.fill == "value":
        return options.full
    top = body if options.fill == "body" else peak
    if options.fill == "auto" and body > _NO_BODY * peak:
        top = min(peak, body / RadiusScale(kind, 1.0, options.decades).value(BODY_RADIUS))
    return top if top > _LEAST else 1.0
