"""A paint that another program hands over: opened in a tab of its own, in front; what was open stays."""

from __future__ import annotations

import time
from typing import Any

from brdf_qt.link_messages import OFFER, OFFER_LASTS_S

from brdf_designer.tabs import Documents
from brdf_suite.documents.store import paint_from_json


class PaintOffer:
    """Takes the offers of the live link that are for Designer."""

    def __init__(self, documents: Documents) -> None:
        self._documents = documents

    def received(self, topic: str, value: dict[str, Any]) -> None:
        """Open the paint of an offer that is new; ``value`` has passed the link's check."""
        if topic == OFFER and value["to"] == "designer" and abs(time.time() - value["time"]) <= OFFER_LASTS_S:
            # It is in a palette and in no file: as unsaved work it would be asked about, which it is not.
            self._documents.add(paint_from_json(value["paint"], "the live link"))
