"""Small pictures of lights and forms: shipped, or made of the user's own files."""

from __future__ import annotations

import logging
from collections.abc import Sequence
from functools import partial
from pathlib import Path

from PySide6.QtGui import QImage, QPixmap

from brdf_qt.choosing.thumbnails import SHIPPED, SIZE, Thumbnails, shipped_picture
from brdf_qt.work.pictures import Pictures
from brdf_suite.documents.paint import solid_paint
from brdf_suite.lighting.thumbnail import light_thumbnail
from brdf_suite.palettes.swatches.look import Content, SwatchLook
from brdf_suite.pipeline.environments import read_environment
from brdf_suite.progress import Progress
from brdf_suite.resources import resource_names

log = logging.getLogger(__name__)

NEUTRAL = solid_paint("neutral", (60.0, 0.0, 0.0))
"""What a form is painted with in its picture."""


class SceneThumbnails(Thumbnails):
    """Pictures of lights (``environments``) or forms (``meshes``): shipped, or made of the user's own files."""

    def __init__(self, kind: str, pictures: Pictures) -> None:
        super().__init__(kind, pictures)
        self._names = resource_names(SHIPPED.format(kind=kind), ".jpg")
        self._made: dict[str, QPixmap] = {}
        self._looks: dict[str, SwatchLook] = {}

    def picture(self, key: str, _content: Content | None = None, /) -> QPixmap:
        if key in self._names and key not in self._made:
            self._made[key] = shipped_picture(self.kind, key)
        found = self._made.get(key)
        if found is None and key in self._looks:
            found = self._pictures.picture(NEUTRAL, self._looks[key])
        return self._plain() if found is None else found

    def _make(self, _owner: str, asked: Sequence[tuple[str, Content | None]], /) -> None:
        for key, _content in asked:
            if key in self._names or key in self._made or not Path(key).is_absolute():
                continue
            if self.kind == "environments":
                self._made[key] = self._plain()  # until it is there, and where it never will be
                self._tasks.submit(key, _light_picture, key, partial(self._take, key), _note)
            elif key not in self._looks:
                self._looks[key] = SwatchLook(form=key, size=SIZE)
                self._pictures.request(f"{self.kind} {key}", [NEUTRAL], self._looks[key])

    def _take(self, key: str, image: QImage) -> None:
        self._made[key] = QPixmap.fromImage(image)
        self.arrived.emit()


def _note(error: Exception) -> None:
    log.debug("No picture of a light: %s", error)


def _light_picture(path: str, progress: Progress) -> QImage:
    codes = light_thumbnail(read_environment(path, progress=progress), SIZE)
    return QImage(codes.tobytes(), SIZE, SIZE, 3 * SIZE, QImage.Format.Format_RGB888).copy()
