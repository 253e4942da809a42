"""What stands on a contact sheet: the paints of a palette, a folder or one file, and under which headings."""

from __future__ import annotations

from pathlib import Path

from brdf_suite.appearance.colour.flat_colours import to_paint
from brdf_suite.documents.palette import Palette
from brdf_suite.documents.store import PAINT_ENDING
from brdf_suite.errors import FileError
from brdf_suite.paint_design.measured_start import load_paint_or_start
from brdf_suite.pipeline.material import file_kind, is_file, load_palette_file
from brdf_suite.reports.contact_sheet.pictures import SheetItem

MOST_PAINTS = 5000


def sheet_items(source: Path) -> tuple[str, list[SheetItem]]:
    """Return the title and the paints of a palette of any format, a folder of paints, or a single material.

    Of measured data and models the sheet shows the design that is started from their readings.

    A paint of a folder that cannot be read is an item with its problem.

    Raises
    ------
    FileError
        There is no such file or folder, or nothing in it.
    """
    if source.is_dir():
        files = sorted(source.glob(f"*{PAINT_ENDING}"), key=lambda path: path.name.casefold())
        if not files:
            raise FileError(source, f"holds no {PAINT_ENDING} file")
        if len(files) > MOST_PAINTS:
            raise FileError(source, f"holds {len(files)} paints; a sheet takes {MOST_PAINTS}")
        return source.absolute().name, [_item_of(file) for file in files]
    if is_file(str(source)) and file_kind(source) == "palette":
        palette = load_palette_file(source).palette
        items = palette_items(palette)
        if not items:
            raise FileError(source, "holds no paint")
        if len(items) > MOST_PAINTS:
            raise FileError(source, f"holds {len(items):,} paints; a sheet takes {MOST_PAINTS:,}")
        return palette.name, items
    paint = load_paint_or_start(source)
    return paint.name, [SheetItem(paint.name, "", paint)]


def palette_items(palette: Palette) -> list[SheetItem]:
    """Return the entries of a palette under the headings of their groups; a flat colour counts as a solid paint."""
    items = []
    for group, entries in palette.sections():
        title = "" if group is None else ", ".join(group.path)
        items += [SheetItem(paint.name, title, paint) for paint in (to_paint(e.content) for e in entries)]
    return items


def _item_of(file: Path) -> SheetItem:
    try:
        paint = load_paint_or_start(file)
    except FileError as error:
        return SheetItem(file.stem, "", None, error.reason)
    return SheetItem(paint.name, "", paint)
