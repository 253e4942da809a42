"""What a small picture of a paint shows, and the key by which it is known again."""

from __future__ import annotations

import hashlib
import json
from dataclasses import dataclass
from functools import lru_cache

from brdf_suite.documents.paint import Paint
from brdf_suite.documents.store import paint_to_json
from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import SurfaceLook

SIZE = 128
"""Width and height of a picture in pixels; sharp at 64 points on a screen of double density."""

_UNSEEN = ("name", "notes", "source")
_GROUND = (0.46, 0.46, 0.46)
"""The mid grey against which paint is judged, L* 50, encoded sRGB."""


@dataclass(frozen=True)
class ThumbnailScene:
    """The light and the form: names of packaged ones, or absolute paths of files."""

    environment: str = "booth"
    surface: str = "sphere"

    def view(self) -> View:
        """Return the view that is drawn. Its exposure is locked: a darker paint shall look darker."""
        return View(
            environment=self.environment,
            surface=self.surface,
            background="colour",
            background_colour=_GROUND,
            # Nothing shades a sphere, and baking that would keep the first picture back.
            surface_look=SurfaceLook(occlusion=self.surface != "sphere"),
        )


USUAL_SCENE = ThumbnailScene()


@lru_cache(maxsize=1024)
def paint_key(paint: Paint, scene: ThumbnailScene = USUAL_SCENE) -> str:
    """Return the same text for the same picture: of all that is seen of a paint, and not of its name.

    Every repaint of the history asks it of every state that is seen, so it is worked out once for each.
    """
    seen = {name: value for name, value in paint_to_json(paint).items() if name not in _UNSEEN}
    text = json.dumps([seen, scene.environment, scene.surface], sort_keys=True)
    return hashlib.blake2b(text.encode("utf-8"), digest_size=16).hexdigest()
