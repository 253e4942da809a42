"""A contact sheet: every paint of a palette or a folder on the same form in the same light, with its figures.

As PNG one tall picture, as PDF pages of A4.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from brdf_suite.appearance.colour.spaces import SRGB_SPACE, DisplaySpace
from brdf_suite.documents.atomic import write_atomically
from brdf_suite.documents.view import View
from brdf_suite.errors import FileError, ValueRangeError
from brdf_suite.files.images.environments import write_png_strips
from brdf_suite.output.picture_file import PictureSettings, check_target
from brdf_suite.palettes.swatches.look import Form
from brdf_suite.progress import Progress, report, subrange
from brdf_suite.realtime.pictures.display import Display
from brdf_suite.reports.contact_sheet.items import palette_items, sheet_items
from brdf_suite.reports.contact_sheet.layout import SheetLayout, Size
from brdf_suite.reports.contact_sheet.painter import SheetPainter
from brdf_suite.reports.contact_sheet.pictures import SheetItem, caption, item_pictures

MOST_COLUMNS = 40
PDF_ENDING = ".pdf"


@dataclass(frozen=True)
class Sheet:
    """A contact sheet that was written. ``problems`` name the paints that could not be drawn, with reasons.

    ``width`` and ``height`` are those of a PNG in pixels; a PDF has ``pages`` instead.
    """

    path: Path
    width: int
    height: int
    paints: int
    problems: tuple[str, ...]
    notices: tuple[str, ...]
    pages: int = 0


def write_sheet(
    source: Path,
    view: View,
    cell: Size,
    path: Path,
    columns: int | None = None,
    settings: PictureSettings | None = None,
    *,
    form: Form | None = None,
    progress: Progress | None = None,
) -> Sheet:
    """Draw every paint of ``source`` (:func:`sheet_items`) and write the sheet; see :func:`write_sheet_of`.

    Raises
    ------
    FileError
        As :func:`sheet_items` and :func:`~brdf_suite.output.still.render_to_file`.
    Cancelled
        The progress callback asked for it; the old file stays.
    """
    _check(path, columns, settings or PictureSettings())
    title, items = sheet_items(source)
    return write_sheet_of(title, items, view, cell, path, columns, settings, form=form, progress=progress)


def write_sheet_of(
    title: str,
    items: Sequence[SheetItem],
    view: View,
    cell: Size,
    path: Path,
    columns: int | None = None,
    settings: PictureSettings | None = None,
    *,
    form: Form | None = None,
    progress: Progress | None = None,
) -> Sheet:
    """Draw paints and write the sheet: as PNG, row by row, or where ``path`` ends in .pdf as pages of A4.

    ``cell`` is the size of one picture in pixels. Each has its name, the flop index and L*a*b* at 15, 45 and 110°
    below it: of a designed paint its readings, of any other what its reflectance gives. Automatic exposure is
    measured for the first paint, so that all stand in the same light. A paint that cannot be drawn has its reason in
    the picture's place. ``form``, ``chips`` or ``flop_strip``, shows the colours themselves instead of the surface.
    Errors as :func:`write_sheet`.
    """
    settings = settings or PictureSettings()
    space = _check(path, columns, settings)
    if not items:
        raise FileError(path, "there is no paint to draw")
    subtitle = _subtitle(view, form)
    if path.suffix.lower() == PDF_ENDING:
        return _write_pdf(title, subtitle, items, view, cell, path, columns, settings, form, progress)

    columns = min(len(items), columns or max(1, round(math.sqrt(len(items) * cell[1] * 1.3 / cell[0]))))
    layout = SheetLayout.of(title, subtitle, items, cell, columns)
    problems: list[str] = []
    with item_pictures(view, cell, settings, Display(space), form, subrange(progress, 0.0, 0.2)) as pictures:
        painter = SheetPainter(pictures, layout, problems)
        rows = painter.strips(subrange(progress, 0.2, 1.0))
        metadata = {
            "Software": "BRDF Suite",
            "Title": title,
            "Description": f"{len(items)} paints, {subtitle}",
        }
        write_png_strips(path, layout.size, rows, metadata, space)
        notices = pictures.notices
    report(progress, 1.0, "written")
    return Sheet(path, *layout.size, len(items), tuple(problems), _with_missing(notices, layout.missing))


def _write_pdf(
    title: str,
    subtitle: str,
    items: Sequence[SheetItem],
    view: View,
    cell: Size,
    path: Path,
    columns: int | None,
    settings: PictureSettings,
    form: Form | None,
    progress: Progress | None,
) -> Sheet:
    from brdf_suite.reports.contact_sheet.pdf import DEFAULT_COLUMNS, pdf_sheet  # reportlab is much to import

    problems: list[str] = []
    with item_pictures(view, cell, settings, Display(), form, subrange(progress, 0.0, 0.2)) as pictures:
        data, pages, missing = pdf_sheet(
            title,
            subtitle,
            items,
            cell,
            columns or DEFAULT_COLUMNS,
            pictures.draw,
            problems,
            subrange(progress, 0.2, 1.0),
        )
        notices = pictures.notices
    write_atomically(path, data)
    report(progress, 1.0, "written")
    return Sheet(path, 0, 0, len(items), tuple(problems), _with_missing(notices, missing), pages)


def _check(path: Path, columns: int | None, settings: PictureSettings) -> DisplaySpace:
    """Refuse what cannot be written before anything is read or drawn; return the colours of the file."""
    ending = path.suffix.lower()
    if ending not in (".png", PDF_ENDING) or settings.bits not in (None, 8):
        raise FileError(
            path, "sheets are written as PNG of 8 bits or as PDF; give a name that ends in .png or .pdf"
        )
    if columns is not None and not 1 <= columns <= MOST_COLUMNS:
        raise ValueRangeError("columns", f"1 to {MOST_COLUMNS} stand in a row, not {columns}")
    if ending == PDF_ENDING:
        if settings.colour_space not in (None, "srgb"):
            raise FileError(path, "a PDF has pictures in sRGB; leave the colour space out")
        check_target(path)
        return SRGB_SPACE
    _, space = settings.of_file(path)
    check_target(path)
    return space


def _with_missing(notices: tuple[str, ...], missing: str) -> tuple[str, ...]:
    return (*notices, f"no font of this system has the letters {missing}") if missing else notices


def _subtitle(view: View, form: Form | None) -> str:
    if form in ("chips", "flop_strip"):
        shown = "colours at 15, 45 and 110°" if form == "chips" else "colours from 15 to 110°"
        return f"{shown}; L*a*b* D65, 10°, light at 45°"
    measured = " from what is measured at the first" if view.exposure_mode == "automatic" else ""
    return (
        f"{Path(view.surface).stem} in {Path(view.environment).stem}, {view.exposure_ev:+g} EV{measured}, "
        f"tone curve {view.tone_curve}; L*a*b* D65, 10°, light at 45°"
    )


__all__ = [
    "MOST_COLUMNS",
    "Sheet",
    "SheetItem",
    "caption",
    "palette_items",
    "sheet_items",
    "write_sheet",
    "write_sheet_of",
]
