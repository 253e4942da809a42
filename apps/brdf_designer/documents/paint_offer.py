"""A paint that another program hands over: opened in a tab of its own, in front; what was open stays."""

from __future__ import annotations

import time
from typing import Any

from brdf_qt.link.messages import OFFER, OFFER_LASTS_S
from PySide6.QtCore import QTimer

from brdf_designer.documents.tabs import Documents
from brdf_designer.session.paint_session import PaintSession
from brdf_suite.documents.paint import Paint
from brdf_suite.documents.store import paint_from_json


class PaintOffer:
    """Takes the offers of the live link that are for Designer.

    With a ``session``, a paint that comes in the midst of a drag waits for its end: the hand keeps what it holds.
    """

    def __init__(self, documents: Documents, session: PaintSession | None = None) -> None:
        self._documents, self._session = documents, session
        self._waiting: list[Paint] = []
        if session is not None:
            # A gesture may end because the next begins at once: that is seen after both.
            session.gesture_ended.connect(lambda: QTimer.singleShot(0, self._open))

    def received(self, topic: str, value: dict[str, Any]) -> None:
        """Open the paint of an offer that is new; ``value`` has passed the link's check."""
        if topic == OFFER and value["to"] == "designer" and abs(time.time() - value["time"]) <= OFFER_LASTS_S:
            self._waiting.append(paint_from_json(value["paint"], "the live link"))
            self._open()

    def _open(self) -> None:
        if self._session is not None and self._session.in_gesture:
            return
        while self._waiting:
            # It is in a palette and in no file: as unsaved work it would be asked about, which it is not.
            self._documents.add(self._waiting.pop(0))
