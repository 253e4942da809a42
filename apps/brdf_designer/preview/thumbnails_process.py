"""Draws small pictures of paints, asked for line by line: a process of its own beside Designer.

Drawing on a software renderer takes half a second and holds the interpreter; here it does not block the window. Each
line in is a request ``{"key", "paint", "environment", "surface"}``, each line out its answer: ``{"key", "picture"}``
with the pixels as base64 (RGB, 8 bits, :data:`~brdf_designer.preview.thumbnail_scene.SIZE` squared), ``{"key",
"refused"}`` where there is no such paint, or ``{"unavailable"}`` where nothing can be drawn at all. It ends when its
input is closed.
"""

from __future__ import annotations

import base64
import json
import os
import sys
from contextlib import ExitStack
from typing import Any, TextIO

from brdf_designer.preview.scene import LIGHT_WIDTH
from brdf_designer.preview.thumbnail_scene import SIZE, ThumbnailScene
from brdf_suite.documents.store import paint_from_json
from brdf_suite.errors import GraphicsError, SuiteError
from brdf_suite.output.still import LoadedScene, loaded_scene
from brdf_suite.pipeline.lobe_fit import PATIENT_TIME_LIMIT_S, PaintFitter

_NICER = 5


class Painter:
    """Keeps the scene that was asked for last; use it with ``with``."""

    def __init__(self) -> None:
        self._stack = ExitStack()
        self._scene: ThumbnailScene | None = None
        self._loaded: LoadedScene | None = None
        self._fitter = PaintFitter(time_limit_s=PATIENT_TIME_LIMIT_S)

    def __enter__(self) -> Painter:
        return self

    def __exit__(self, *_: object) -> None:
        self._stack.close()
        self._fitter.close()

    def answer(self, request: dict[str, Any]) -> dict[str, str]:
        """Return the answer to a request; see the module."""
        key = str(request["key"])
        scene = ThumbnailScene(str(request["environment"]), str(request["surface"]))
        try:
            fit = self._fitter.fit(paint_from_json(request["paint"], "the paint"))
            pixels = self._draw(fit, scene)
        except GraphicsError as error:
            return {"unavailable": str(error)}
        except SuiteError as error:
            return {"key": key, "refused": str(error)}
        return {"key": key, "picture": base64.b64encode(pixels).decode("ascii")}

    def _draw(self, fit: Any, scene: ThumbnailScene) -> bytes:
        loaded = self._load(scene)
        loaded.scene.set_material(fit)
        size = (SIZE, SIZE)
        return loaded.scene.image(loaded.composed(scene.view(), size), size).tobytes()

    def _load(self, scene: ThumbnailScene) -> LoadedScene:
        if self._loaded is None or scene != self._scene:
            self._stack.close()
            self._loaded = None
            self._loaded = self._stack.enter_context(loaded_scene(scene.view(), columns=LIGHT_WIDTH))
            self._scene = scene
        return self._loaded


def serve(lines: TextIO, out: TextIO) -> None:
    """Answer requests until there are no more."""
    with Painter() as painter:
        for line in lines:
            answer = painter.answer(json.loads(line))
            out.write(json.dumps(answer) + "\n")
            out.flush()
            if "unavailable" in answer:
                return


def main() -> None:
    """Run the process."""
    if hasattr(os, "nice"):
        os.nice(_NICER)  # the window goes first
    # Whatever prints, the answers' channel stays clean.
    out = os.fdopen(os.dup(sys.stdout.fileno()), "w", encoding="utf-8")
    os.dup2(sys.stderr.fileno(), sys.stdout.fileno())
    serve(sys.stdin, out)


if __name__ == "__main__":
    main()
