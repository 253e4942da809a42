"""What the window asks of the process that traces, as a frozen value and as a line of JSON."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

from brdf_suite.documents.store import view_from_json, view_to_json
from brdf_suite.documents.view import View

Renderer = Literal["realtime", "raytraced", "reference"]
Quality = Literal["fast", "medium", "high"]
RENDERERS: tuple[Renderer, ...] = ("realtime", "raytraced", "reference")
QUALITIES: tuple[Quality, ...] = ("fast", "medium", "high")


@dataclass(frozen=True)
class TraceRequest:
    """A scene to be traced.

    ``paint`` is a paint file, a measured one or a shipped name; ``environment`` and ``surface`` are files that
    :mod:`.scene_files` wrote. ``generation`` comes back with each picture. ``samples`` is where to stop, 0: nowhere.
    """

    generation: int
    renderer: Renderer
    quality: Quality
    view: View
    size: tuple[int, int]
    paint: str
    environment: Path
    surface: Path
    samples: int = 0
    denoised: bool = False

    def to_json(self) -> dict[str, Any]:
        """Return plain values; :meth:`from_json` is the inverse."""
        files = {"environment": str(self.environment), "surface": str(self.surface)}
        return {"do": "render", **vars(self), "view": view_to_json(self.view), **files}

    @staticmethod
    def from_json(value: Mapping[str, Any]) -> TraceRequest:
        """Return the request in a message of our own; KeyError, TypeError or a DocumentError where it is none."""
        fields = {key: item for key, item in value.items() if key != "do"}
        fields |= {"view": view_from_json(value["view"]), "size": tuple(value["size"])}
        fields |= {key: Path(value[key]) for key in ("environment", "surface")}
        return TraceRequest(**fields)
