"""A contact sheet: every paint of a palette or a folder on the same form in the same light, with its figures.

As PNG one tall picture, as PDF pages of A4.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from brdf_suite.appearance.colour.flat_colours import to_paint
from brdf_suite.appearance.colour.spaces import SRGB_SPACE, DisplaySpace
from brdf_suite.documents.atomic import check_target, documents_in, write_atomically
from brdf_suite.documents.palette import Palette
from brdf_suite.documents.store import PAINT_ENDING
from brdf_suite.documents.view import View
from brdf_suite.errors import FileError, ValueRangeError
from brdf_suite.files.images.environments import write_png_strips
from brdf_suite.output.picture_file import PictureSettings
from brdf_suite.paint_design.measured_start import load_paint_or_start
from brdf_suite.palettes.swatches.look import Form
from brdf_suite.pipeline.material import file_kind, load_palette_file
from brdf_suite.progress import Progress, report, subrange
from brdf_suite.realtime.pictures.display import Display
from brdf_suite.regular_files import is_file, is_folder
from brdf_suite.reports.contact_sheet.page_layout import MOST_COLUMNS, PageStyle
from brdf_suite.reports.contact_sheet.painter import SheetLayout, SheetPainter, Size
from brdf_suite.reports.contact_sheet.pictures import SheetItem, item_pictures

MOST_PAINTS = 5000


def sheet_items(source: Path, cmyk_profile: Path | None = None) -> tuple[str, list[SheetItem]]:
    """Return the title and the paints of a palette of any format, a folder of paints, or a single material.

    Colours in CMYK of a palette, where they bring no profile of their own, are seen through the ICC profile
    ``cmyk_profile``. Of measured data and models the sheet shows the design that is started from their readings.

    A paint of a folder that cannot be read is an item with its problem.

    Raises :class:`FileError`: there is no such file or folder, or nothing in it.
    """
    if is_folder(source):
        files = sorted(documents_in(source, PAINT_ENDING), key=lambda path: (path.name.casefold(), path.name))
        if not files:
            raise FileError(source, f"holds no {PAINT_ENDING} file")
        if len(files) > MOST_PAINTS:
            raise FileError(source, f"holds {len(files)} paints; a sheet takes {MOST_PAINTS}")
        return source.absolute().name, [_item_of(file) for file in files]
    if is_file(source) and file_kind(source) == "palette":
        palette = load_palette_file(source, cmyk_profile=cmyk_profile).palette
        items = palette_items(palette)
        if not items:
            raise FileError(source, "holds no paint")
        if len(items) > MOST_PAINTS:
            raise FileError(source, f"holds {len(items):,} paints; a sheet takes {MOST_PAINTS:,}")
        return palette.name, items
    paint = load_paint_or_start(source, cmyk_profile=cmyk_profile)
    return paint.name, [SheetItem(paint.name, "", paint)]


def palette_items(palette: Palette) -> list[SheetItem]:
    """Return the entries of a palette under the headings of their groups; a flat colour counts as a solid paint."""
    items = []
    for group, entries in palette.sections():
        title = "" if group is None else ", ".join(group.path)
        paints = ((entry, to_paint(entry.content)) for entry in entries)
        items += [SheetItem(paint.name, title, paint, code=entry.code) for entry, paint in paints]
    return items


def _item_of(file: Path) -> SheetItem:
    try:
        paint = load_paint_or_start(file)
    except FileError as error:
        return SheetItem(file.stem, "", None, error.reason)
    return SheetItem(paint.name, "", paint)


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
    sources: Sequence[Path],
    view: View,
    cell: Size,
    path: Path,
    columns: int | None = None,
    settings: PictureSettings | None = None,
    *,
    form: Form | None = None,
    style: PageStyle | None = None,
    cmyk_profile: Path | None = None,
    progress: Progress | None = None,
) -> Sheet:
    """Draw every paint of the sources (:func:`sheet_items`) and write the sheet; see :func:`write_sheet_of`.

    Raises
    ------
    FileError
        As :func:`sheet_items` and :func:`~brdf_suite.output.still.render_to_file`.
    Cancelled
        The progress callback asked for it; the old file stays.
    """
    _check(path, columns, settings or PictureSettings())
    found = [sheet_items(source, cmyk_profile) for source in sources]
    title = ", ".join(dict.fromkeys(title for title, _ in found))
    items = [item for _, some in found for item in some]
    return write_sheet_of(
        title, items, view, cell, path, columns, settings, form=form, style=style, progress=progress
    )


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
    style: PageStyle | None = None,
    progress: Progress | None = None,
) -> Sheet:
    """Draw paints and write the sheet: as PNG, row by row, or where ``path`` ends in .pdf as pages of paper.

    ``cell`` is the size of one picture in pixels; ``columns`` stand in a row, and ``style`` says the paper of a PDF
    and what stands below its pictures. Each has its name, the flop index and L*a*b* at 15, 45 and 110° below it: of a
    designed paint its readings, of any other what its reflectance gives. Automatic exposure is measured for the first
    paint, so that all stand in the same light. A paint that cannot be drawn has its reason in the picture's place.
    ``form``, ``chips`` or ``flop_strip``, shows the colours themselves instead of the surface.
    Errors as :func:`write_sheet`.
    """
    settings = settings or PictureSettings()
    space = _check(path, columns, settings)
    if not items:
        raise FileError(path, "there is no paint to draw")
    subtitle = _subtitle(view, form)
    problems: list[str] = []
    drawing = subrange(progress, 0.2, 1.0)
    with item_pictures(view, cell, settings, Display(space), form, subrange(progress, 0.0, 0.2)) as pictures:
        if path.suffix.lower() == PDF_ENDING:
            # reportlab is much to import.
            from brdf_suite.reports.contact_sheet.pdf import pdf_sheet

            style = style or PageStyle()
            style = style if columns is None else replace(style, columns=columns)
            data, pages, missing = pdf_sheet(
                title, subtitle, items, cell, style, pictures.draw, problems, drawing
            )
            write_atomically(path, data)
            size = (0, 0)
        else:
            best = max(1, round(math.sqrt(len(items) * cell[1] * 1.3 / cell[0])))
            layout = SheetLayout.of(title, subtitle, items, cell, min(len(items), columns or best))
            size, pages, missing = layout.size, 0, layout.missing
            strips = SheetPainter(pictures, layout, problems).strips(drawing)
            metadata = {
                "Software": "BRDF Suite",
                "Title": title,
                "Description": f"{len(items)} paints, {subtitle}",
            }
            write_png_strips(path, size, strips, metadata, space)
        notices = pictures.notices
    report(progress, 1.0, "written")
    if missing:
        notices = (*notices, f"no font of this system has the letters {missing}")
    return Sheet(path, *size, len(items), tuple(problems), notices, pages)


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


def _subtitle(view: View, form: Form | None) -> str:
    if form in ("chips", "flop_strip"):
        shown = "colours at 15, 45 and 110°" if form == "chips" else "colours from 15 to 110°"
        return f"{shown}; L*a*b* D65, 10°, light at 45°"
    measured = " from what is measured at the first" if view.exposure_mode == "automatic" else ""
    return (
        f"{Path(view.surface).stem} in {Path(view.environment).stem}, {view.exposure_ev:+g} EV{measured}, "
        f"tone curve {view.tone_curve}; L*a*b* D65, 10°, light at 45°"
    )
