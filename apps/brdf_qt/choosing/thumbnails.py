"""Small pictures of paints, lights and forms, from the service that draws the swatches of Color Swatch.

Until a picture is there a placeholder stands for it: a disc with the readings of a paint, else plain grey.
"""

from __future__ import annotations

import logging
from collections.abc import Callable, Iterable, Sequence

from PySide6.QtCore import QObject, QRectF, Qt, Signal
from PySide6.QtGui import QColor, QLinearGradient, QPainter, QPixmap, QPixmapCache

from brdf_qt.program.feature import Feature
from brdf_qt.work.pictures import Pictures
from brdf_qt.work.tasks import TaskRunner
from brdf_qt.work.timer import make_timer
from brdf_suite.appearance.colour.flat_colours import lab_to_hex, to_paint
from brdf_suite.documents.paint import Paint
from brdf_suite.errors import SuiteError
from brdf_suite.palettes.swatches.look import Content, SwatchLook
from brdf_suite.progress import Progress
from brdf_suite.resources import resource

log = logging.getLogger(__name__)

SIZE = 128
"""Width and height of a picture in pixels; sharp at 64 points on a screen of double density."""
USUAL_LOOK = SwatchLook(size=SIZE)

_GROUND = QColor(119, 119, 119)
SHIPPED = "thumbnails/{kind}"
"""Where the packaged pictures of a kind are."""
_AGAIN_MS = 400
"""A paint that is being edited is drawn again when the hand rests."""


def thumbnail(pictures: Pictures, paint: Content, look: SwatchLook = USUAL_LOOK) -> QPixmap:
    """Return the picture of a paint where it is drawn, and its placeholder where it is not."""
    found = pictures.picture(paint, look)
    if found is None:
        key, found = pictures.key(paint, look), QPixmap()
        if not QPixmapCache.find(key, found):
            found = placeholder(paint, SIZE)
            QPixmapCache.insert(key, found)
    return found


def shipped_picture(kind: str, name: str) -> QPixmap:
    """Return the packaged picture of a shipped light (``environments``) or form (``meshes``)."""
    return QPixmap(str(resource(SHIPPED.format(kind=kind), f"{name}.jpg")))


def placeholder(content: Content | None, size: int) -> QPixmap:
    """Return a disc, lit from the upper left, whose colours are the readings in the order of their angles.

    What has no readings is plain grey.
    """
    picture = QPixmap(size, size)
    picture.fill(_GROUND)
    paint = None if content is None else to_paint(content)
    if not isinstance(paint, Paint):
        return picture
    order = sorted(paint.measurements, key=lambda one: (one.illumination_deg, one.aspecular_deg))
    painter = QPainter(picture)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    edge = 0.08 * size
    disc = QRectF(edge, edge, size - 2 * edge, size - 2 * edge)
    ramp = QLinearGradient(disc.topLeft(), disc.bottomRight())
    last = max(1, len(order) - 1)
    for place, reading in enumerate(order):
        # The middle of the ramp: at its ends nothing of the disc is left.
        ramp.setColorAt(0.2 + 0.6 * place / last, QColor(lab_to_hex(reading.lab)))
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(ramp)
    painter.drawEllipse(disc)
    painter.end()
    return picture


class Thumbnails(QObject):
    """Pictures of one ``kind`` of things by their keys; nothing is loaded or drawn before :meth:`start`.

    Signals: ``arrived()``, there are pictures that were not there before.
    """

    arrived = Signal()

    def __init__(self, kind: str, pictures: Pictures) -> None:
        super().__init__(pictures)
        self.kind, self._pictures = kind, pictures
        self._tasks = TaskRunner(self, threads=1)
        self._asked: dict[str, tuple[tuple[str, Content | None], ...]] = {}
        self._started = False
        self._blank = QPixmap()
        pictures.arrived.connect(lambda _keys: self.arrived.emit())

    def start(self) -> None:
        """Begin to make what is asked for: once the window has what it needs first."""
        self._started = True
        self._again()

    def close(self) -> None:
        """End the thread; no picture comes any more."""
        self._started = False
        self._tasks.stop()

    def request(self, owner: str, asked: Iterable[tuple[str, Content | None]]) -> None:
        """Have pictures made of these keys, the first ones first; the owner's earlier request is dropped."""
        self._asked[owner] = tuple(asked)
        if self._started:
            self._make(owner, self._asked[owner])

    def picture(self, key: str, content: Content | None = None, /) -> QPixmap:
        """Return the picture of a key, or what stands for it until it is there."""
        raise NotImplementedError

    def content(self, _key: str, _content: Content | None = None, /) -> Content | None:
        """Return the paint of a key where it is one and known; None for anything else."""
        return None

    def _make(self, owner: str, asked: Sequence[tuple[str, Content | None]], /) -> None:
        raise NotImplementedError

    def _again(self) -> None:
        for owner, asked in self._asked.items():
            self._make(owner, asked)

    def _plain(self) -> QPixmap:
        if self._blank.isNull():
            self._blank = placeholder(None, SIZE)
        return self._blank


class PaintThumbnails(Thumbnails):
    """Pictures of paints, measured data and models stay grey.

    ``load`` returns the document of a name or a file, None of what has none, and raises
    :class:`~brdf_suite.errors.SuiteError` where it cannot be read; it is called on a thread.
    """

    def __init__(self, pictures: Pictures, load: Callable[[str], Content | None]) -> None:
        super().__init__("paint", pictures)
        self._load = load
        self._contents: dict[str, Content | None] = {}
        self._edited = make_timer(self, self._again, _AGAIN_MS)

    def set_content(self, key: str, content: Content | None) -> None:
        """Say which paint a key stands for now, as one that is being edited."""
        self._contents[key] = content
        if self._started:
            self._edited.start()

    def forget(self, key: str) -> None:
        """Read the paint of a key again when its picture is asked for: its file may be another."""
        self._contents.pop(key, None)

    def close(self) -> None:
        self._edited.stop()
        super().close()

    def picture(self, key: str, content: Content | None = None, /) -> QPixmap:
        known = self.content(key, content)
        return self._plain() if known is None else thumbnail(self._pictures, known)

    def content(self, key: str, content: Content | None = None, /) -> Content | None:
        return content if content is not None else self._contents.get(key)

    def _make(self, owner: str, asked: Sequence[tuple[str, Content | None]], /) -> None:
        unread = [key for key, content in asked if content is None and key and key not in self._contents]
        if unread:
            self._tasks.submit(owner, self._read, unread, self._take, self._failed)
        known = (self.content(key, content) for key, content in asked)
        self._pictures.request(f"{self.kind} {owner}", [one for one in known if one is not None], USUAL_LOOK)

    def _read(self, keys: Sequence[str], progress: Progress) -> dict[str, Content | None]:
        """Return the documents of names and files; None of what is none, or cannot be read: opening it says why."""
        found: dict[str, Content | None] = {}
        for place, key in enumerate(keys):
            progress(place / len(keys), "")
            try:
                found[key] = self._load(key)
            except SuiteError as error:
                log.debug("No picture of %s: %s", key, error)
                found[key] = None
        return found

    def _take(self, read: dict[str, Content | None]) -> None:
        self._contents.update(read)
        self.arrived.emit()
        self._again()

    def _failed(self, error: Exception) -> None:
        log.error("The paints of thumbnails cannot be read.", exc_info=error)


class ThumbnailWork(Feature):
    """What makes the thumbnails of a window; its process and threads end with the program."""

    def __init__(self, pictures: Pictures, thumbnails: Sequence[Thumbnails]) -> None:
        self._pictures, self._thumbnails = pictures, thumbnails

    def begin(self) -> None:
        """Begin to make thumbnails: once the window shows what matters more."""
        for one in self._thumbnails:
            one.start()

    def close(self) -> None:
        for one in self._thumbnails:
            one.close()
        self._pictures.close()
