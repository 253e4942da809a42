"""A paint that is dropped on a picture, from any program of the suite, its palettes, or the desktop, as a file or name.

What is dropped without a file, a swatch, gets one of its own in the program's state folder: a view names its paints.
"""

from __future__ import annotations

import hashlib
import json
from pathlib import Path

from PySide6.QtCore import QMimeData

from brdf_qt.choosing.drag import MIME, PAINT_MIME
from brdf_qt.program.settings import state_folder
from brdf_qt.program.translation import tr
from brdf_suite.appearance.colour.flat_colours import to_paint
from brdf_suite.documents.palette_store import palette_from_json
from brdf_suite.documents.store import (
    PAINT_ENDING,
    AnyPaint,
    any_paint_from_json,
    paint_to_json,
    save_paint,
)
from brdf_suite.errors import SuiteError
from brdf_suite.pipeline.material import load_document, paint_names, paint_titles

_FOLDER = "dropped"


def holds_paint(data: QMimeData) -> bool:
    """Whether there may be a paint in what is dragged; quick enough for every move."""
    return data.hasFormat(PAINT_MIME) or data.hasFormat(MIME) or _paint_file(data) is not None


def dropped_paint(data: QMimeData) -> str:
    """Return the shipped name or the absolute path of the paint in what was dropped; of several swatches the first.

    Raises :class:`SuiteError`: there is none, it is no paint, or it cannot be written.
    """
    file = _paint_file(data)
    if file is not None:
        return str(file.absolute())
    try:
        if data.hasFormat(PAINT_MIME):
            return _kept(any_paint_from_json(_json(data, PAINT_MIME), tr("what was dropped")))
        whole = _json(data, MIME)
        palette = palette_from_json(whole["palette"], tr("what was dropped"))  # type: ignore[index]  # caught below
        return _kept(to_paint(palette.entries[0].content))
    except (ValueError, LookupError, TypeError, RecursionError) as error:
        raise SuiteError(tr("What was dropped is no paint.")) from error


def _paint_file(data: QMimeData) -> Path | None:
    files = (Path(url.toLocalFile()) for url in data.urls() if url.isLocalFile())
    return next((file for file in files if file.suffix.lower() == PAINT_ENDING), None)


def _json(data: QMimeData, kind: str) -> object:
    return json.loads(bytes(data.data(kind).data()).decode("utf-8"))


def _kept(paint: AnyPaint) -> str:
    """Return the name of a shipped paint, or the file that another one is kept in: one for each content."""
    titles = paint_titles()
    for name in paint_names():
        if titles.get(name) == paint.name and load_document(name) == paint:
            return name
    content = json.dumps(paint_to_json(paint), sort_keys=True).encode()
    plain = "".join(c if c.isalnum() or c in " -" else "_" for c in paint.name).strip()[:80]
    path = state_folder(_FOLDER) / f"{plain} {hashlib.sha256(content).hexdigest()[:8]}{PAINT_ENDING}"
    if not path.exists():
        save_paint(paint, path)
    return str(path)
