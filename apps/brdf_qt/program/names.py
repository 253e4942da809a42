"""What shipped lights, surfaces and paints are called: the one spelling, in every program."""

from __future__ import annotations

from pathlib import Path

from brdf_qt.program.translation import mark, tr
from brdf_suite.pipeline.material import paint_titles

ENVIRONMENTS = {
    "booth": mark("Light booth"),
    "photo_studio": mark("Photo studio"),
    "street": mark("Street"),
    "light_tunnel": mark("Light tunnel"),
    "overcast": mark("Overcast sky"),
    "sunny": mark("Sunny sky"),
}
SURFACES = {
    "car": mark("Car"),
    "speed_form": mark("Speed form"),
    "panel": mark("Curved panel"),
    "sphere": mark("Sphere"),
}


def title_of(key: str) -> str:
    """Return what a light, a surface or a paint is called: a shipped one by its title, a file by its name."""
    known = ENVIRONMENTS.get(key) or SURFACES.get(key)
    if known is not None:
        return tr(known)
    if "/" in key or "\\" in key:
        return Path(key).name
    words = key.replace("_", " ")
    return paint_titles().get(key, words[:1].upper() + words[1:])
