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
NO_END = 0
"""A limit of samples that says: refine for as long as the picture is looked at."""


@dataclass(frozen=True)
class TraceRequest:
    """A scene to be traced.

    ``paint`` is a paint file, a measured one or a shipped name; ``environment`` and ``surface`` are files that
    :mod:`.scene_files` wrote. ``generation`` comes back with each picture. ``samples`` is where to stop.
    """

    generation: int
    renderer: Renderer
    quality: Quality
    view: View
    size: tuple[int, int]
    paint: str
    environment: Path
    surface: Path
    samples: int = NO_END
    denoised: bool = False

    def to_json(self) -> dict[str, Any]:
        """Return plain values; :meth:`from_json` is the inverse."""
        return {
            "do": "render",
            "generation": self.generation,
            "renderer": self.renderer,
            "quality": self.quality,
            "view": view_to_json(self.view),
            "size": list(self.size),
            "paint": self.paint,
            "environment": str(self.environment),
            "surface": str(self.surface),
            "samples": self.samples,
            "denoised": self.denoised,
        }

    @staticmethod
    def from_json(value: Mapping[str, Any]) -> TraceRequest:
        """Return the request in a message of our own; KeyError, TypeError or a DocumentError where it is none."""
        width, height = value["size"]
        return TraceRequest(
            int(value["generation"]),
            value["renderer"],
            value["quality"],
            view_from_json(value["view"]),
            (int(width), int(height)),
            str(value["paint"]),
            Path(value["environment"]),
            Path(value["surface"]),
            int(value["samples"]),
            bool(value["denoised"]),
        )
