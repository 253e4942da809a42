"""Generated forms for judging paints: speed form, sphere, curved panel. All stand on the plane y = 0."""

from brdf_suite.surface.forms.panel import panel
from brdf_suite.surface.forms.speed_form import speed_form
from brdf_suite.surface.forms.sphere import sphere

__all__ = ["panel", "speed_form", "sphere"]
