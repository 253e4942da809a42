"""Generated forms for judging paints: speed form, sphere, curved panel. All stand on the plane y = 0."""

from meshes.forms.panel import panel
from meshes.forms.speed_form import speed_form
from meshes.forms.sphere import sphere

__all__ = ["panel", "speed_form", "sphere"]
