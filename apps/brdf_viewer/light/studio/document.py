"""The open studio as a document: how it is made, read and written, and where it is saved."""

from __future__ import annotations

from pathlib import Path

from brdf_qt.documents.files import DocumentFiles, DocumentFormat
from brdf_qt.documents.open_document import DocumentStore
from brdf_qt.window.dialogs import Dialogs
from PySide6.QtCore import QObject

from brdf_suite.documents.studio import (
    STUDIO_ENDING,
    LightDocument,
    light_from_json,
    light_to_json,
    load_light,
    save_light,
)
from brdf_viewer.light.studio.templates import TEMPLATES

FORMAT: DocumentFormat[LightDocument] = DocumentFormat(
    kind="studio",
    ending=STUDIO_ENDING,
    new=lambda: TEMPLATES["empty"][1],
    load=load_light,
    save=save_light,
    to_json=light_to_json,
    from_json=light_from_json,
    name_of=lambda light: light.name,
)


class StudioFiles(DocumentFiles[LightDocument]):
    """Files of studios. Which were opened last is the Viewer's list of environments, so none is kept here."""

    def __init__(
        self, store: DocumentStore[LightDocument], dialogs: Dialogs, parent: QObject | None = None
    ) -> None:
        super().__init__(store, FORMAT, dialogs, parent)

    def recent(self) -> list[Path]:
        """Return none."""
        return []

    def remember(self, path: Path) -> None:
        """Keep none."""
