"""A traced picture that was written: the fields that both tracing renderers fill."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from brdf_suite.tracing.raytraced.picture import RaytracedScene
    from brdf_suite.tracing.reference.scene import ReferenceScene


@dataclass(frozen=True, kw_only=True)
class TracedFile:
    """A picture that was written; ``samples`` a pixel, ``resumed_samples`` of them from before."""

    path: Path
    width: int
    height: int
    paint: str
    environment: str
    surface: str
    renderer: str
    samples: int
    seconds: float
    resumed_samples: int
    notices: tuple[str, ...]


def scene_facts(scene: ReferenceScene | RaytracedScene, path: Path) -> dict[str, Any]:
    """Return what a :class:`TracedFile` takes from its scene."""
    return {
        "path": path,
        "width": scene.size[0],
        "height": scene.size[1],
        "paint": scene.name,
        "environment": scene.environment,
        "surface": scene.surface,
        "renderer": scene.renderer,
        "notices": scene.notices,
    }
