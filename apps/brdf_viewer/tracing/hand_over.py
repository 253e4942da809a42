"""A scene from the viewer state to files that another process reads; what has been written already is named again."""

from __future__ import annotations

import contextlib
from pathlib import Path
from typing import Any

from brdf_suite.documents.store import PAINT_ENDING, AnyPaint, save_paint
from brdf_suite.progress import Progress, report
from brdf_suite.surface.mesh import Mesh
from brdf_viewer.tracing.request import TraceRequest
from brdf_viewer.tracing.scene_files import write_environment, write_surface
from brdf_viewer.tracing.trace_input import TraceInput


class HandOver:
    """Numbers what changes, for one folder: each number is one content."""

    def __init__(self) -> None:
        self._surface: tuple[Mesh | None, int] = (None, 0)
        self._paint: tuple[AnyPaint | None, int] = (None, 0)

    def numbers(self, wanted: TraceInput) -> tuple[int, int]:
        """Return the numbers of the surface and of the paint."""
        if wanted.surface is not self._surface[0]:
            self._surface = (wanted.surface, self._surface[1] + 1)
        if wanted.paint is not None and wanted.paint != self._paint[0]:
            self._paint = (wanted.paint, self._paint[1] + 1)
        return self._surface[1], self._paint[1]


def write_request(
    wanted: TraceInput, progress: Progress, *, folder: Path, numbers: tuple[int, int], **asked: Any
) -> TraceRequest:
    """Write what is not written yet and return the request; FileError where the disk does not take it.

    ``numbers`` are those of :meth:`HandOver.numbers`, ``asked`` are the other fields of the request.
    """
    report(progress, 0.0, "preparing the scene")
    environment = write_environment(wanted.environment, folder)
    surface = write_surface(wanted.surface, folder, numbers[0])
    paint = wanted.paint_key
    if wanted.paint is not None:
        file = folder / f"paint-{numbers[1]}{PAINT_ENDING}"
        if not file.exists():
            save_paint(wanted.paint, file)
        paint = str(file)
    return TraceRequest(
        renderer=wanted.renderer,
        quality=wanted.quality,
        view=wanted.view,
        size=wanted.size,
        paint=paint,
        environment=environment,
        surface=surface,
        **asked,
    )


def forget_others(request: TraceRequest) -> None:
    """Remove what older requests left in the folder; the tracer has it in memory, or asks for it no more."""
    wanted = {request.environment, request.surface, Path(request.paint)}
    for pattern in ("light-*.npz", "surface-*.npz", f"paint-*{PAINT_ENDING}"):
        for path in request.environment.parent.glob(pattern):
            if path not in wanted:
                with contextlib.suppress(OSError):  # still being read, on a system that holds such files
                    path.unlink(missing_ok=True)
