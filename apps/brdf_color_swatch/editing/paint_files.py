"""What is dropped or pasted, with the paints in its files, which are read on a thread."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path

from brdf_qt.documents.file_reading import FileReading
from PySide6.QtCore import QMimeData

from brdf_color_swatch.editing.transfer import Carried, read_data
from brdf_suite.documents.palette import Entry, new_id
from brdf_suite.documents.store import load_any_paint
from brdf_suite.errors import SuiteError
from brdf_suite.progress import Progress, report


def take_data(
    data: QMimeData | None,
    reading: FileReading,
    take: Callable[[Carried], None],
    failed: Callable[[Exception], None],
    open_file: Callable[[Path], None] = lambda _path: None,
) -> None:
    """Call ``take`` with what a drag or the clipboard holds: at once, or once the paints in its files are read.

    ``failed`` is called where something in it cannot be read, and neither where the user cancels. ``open_file`` is
    called for each other file, which is then read after the paints.
    """
    try:
        carried = read_data(data)
    except SuiteError as error:
        failed(error)
        return

    def work(_first: Path, progress: Progress) -> tuple[Entry, ...]:
        return _read(carried.paints, progress)

    def done(entries: tuple[Entry, ...]) -> None:
        take(replace(carried, entries=entries, paints=()))

    if carried.paints:
        reading.begin(carried.paints[0], work, done, failed)
    else:
        take(carried)
    for path in carried.files:
        open_file(path)


def _read(paths: Sequence[Path], progress: Progress) -> tuple[Entry, ...]:
    entries = []
    for place, path in enumerate(paths):
        report(progress, place / len(paths), path.name)
        entries.append(Entry(load_any_paint(path), id=new_id()))
    return tuple(entries)
