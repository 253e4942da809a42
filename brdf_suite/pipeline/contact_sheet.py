"""A contact sheet: every paint of a palette or a folder on the same form in the same light, with its figures.

As PNG one tall picture, as PDF pages of A4.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from brdf_suite.appearance.display_space import SRGB_SPACE, DisplaySpace
from brdf_suite.appearance.flat_colours import paint_of
from brdf_suite.documents.palette import Palette
from brdf_suite.documents.store import PAINT_ENDING, load_any_paint
from brdf_suite.documents.view import View
from brdf_suite.errors import FileError, SuiteError, ValueRangeError
from brdf_suite.files.palettes import read_palette
from brdf_suite.pipeline.contact_sheet_pictures import ItemPictures, SheetItem, caption, item_pictures
from brdf_suite.pipeline.picture_file import PictureSettings, check_target
from brdf_suite.pipeline.sheet_text import font_for, shortened
from brdf_suite.pipeline.swatch_look import Form
from brdf_suite.progress import Progress, part, report
from brdf_suite.realtime.display import Display

Size = tuple[int, int]
MOST_PAINTS = 5000
MOST_COLUMNS = 40
PDF_ENDING = ".pdf"

_GREY = 119
"""L* 50, the grey against which paint is judged."""
_BLACK, _SOFT = 0, 40
_MARGIN = 16


@dataclass(frozen=True)
class Sheet:
    """What was written. ``problems`` tell of the paints that could not be drawn, by name.

    ``width`` and ``height`` are those of a PNG in pixels; a PDF has ``pages`` instead.
    """

    path: Path
    width: int
    height: int
    paints: int
    problems: tuple[str, ...]
    notices: tuple[str, ...]
    pages: int = 0


def sheet_items(source: Path) -> tuple[str, list[SheetItem]]:
    """Return the title and the paints of a palette of any format, a paint file, or a folder of paints, by name.

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
    if source.suffix.lower() != PAINT_ENDING:
        palette = read_palette(source).palette
        items = palette_items(palette)
        if not items:
            raise FileError(source, "holds no paint")
        if len(items) > MOST_PAINTS:
            raise FileError(source, f"holds {len(items):,} paints; a sheet takes {MOST_PAINTS:,}")
        return palette.name, items
    paint = load_any_paint(source)
    return paint.name, [SheetItem(paint.name, "", paint)]


def palette_items(palette: Palette) -> list[SheetItem]:
    """Return the entries of a palette under the headings of their groups; a flat colour counts as a solid paint."""
    items = []
    for group, entries in palette.sections():
        title = "" if group is None else ", ".join(group.path)
        items += [SheetItem(paint.name, title, paint) for paint in (paint_of(e.content) for e in entries)]
    return items


def _item_of(file: Path) -> SheetItem:
    try:
        paint = load_any_paint(file)
    except FileError as error:
        return SheetItem(file.stem, "", None, error.reason)
    return SheetItem(paint.name, "", paint)


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
        As :func:`sheet_items` and :func:`~brdf_suite.pipeline.still.render_to_file`.
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
    from brdf_suite.files.images import write_png_strips

    columns = min(len(items), columns or max(1, round(math.sqrt(len(items) * cell[1] * 1.3 / cell[0]))))
    layout = _Layout.of(title, subtitle, items, cell, columns)
    problems: list[str] = []
    with item_pictures(view, cell, settings, Display(space), form, part(progress, 0.0, 0.2)) as pictures:
        painter = _Painter(pictures, layout, problems)
        rows = painter.strips(part(progress, 0.2, 1.0))
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
    # With the writer of pages, which pictures do not need.
    from brdf_suite.documents.atomic import write_atomically
    from brdf_suite.pipeline.contact_sheet_pdf import DEFAULT_COLUMNS, pdf_sheet

    problems: list[str] = []
    with item_pictures(view, cell, settings, Display(), form, part(progress, 0.0, 0.2)) as pictures:
        data, pages, missing = pdf_sheet(
            title,
            subtitle,
            items,
            cell,
            columns or DEFAULT_COLUMNS,
            pictures.draw,
            problems,
            part(progress, 0.2, 1.0),
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


@dataclass(frozen=True, eq=False)
class _Layout:
    """Where everything stands, in pixels; rows are headings and lines of cells."""

    title: str
    subtitle: str
    cell: Size
    columns: int
    rows: tuple[str | tuple[SheetItem, ...], ...]
    fonts: dict[str, Any]
    missing: str

    @staticmethod
    def of(title: str, subtitle: str, items: Sequence[SheetItem], cell: Size, columns: int) -> _Layout:
        text_px = int(min(22, max(10, cell[0] / 18)))
        texts = [
            title,
            subtitle,
            *(text for item in items for text in (item.name, item.group, item.problem)),
            _FIGURES,
        ]
        font, missing = font_for(texts, text_px)
        fonts = {
            "text": font,
            "name": font_for(texts, round(1.2 * text_px))[0],
            "title": font_for(texts, round(1.8 * text_px))[0],
        }
        rows: list[str | tuple[SheetItem, ...]] = []
        for group in dict.fromkeys(item.group for item in items):
            members = [item for item in items if item.group == group]
            if group:
                rows.append(group)
            rows += [tuple(members[i : i + columns]) for i in range(0, len(members), columns)]
        return _Layout(title, subtitle, cell, columns, tuple(rows), fonts, missing)

    def line(self, kind: str) -> int:
        """Return the height of a line of text."""
        return round(1.35 * float(self.fonts[kind].size))

    @property
    def head_lines(self) -> list[tuple[str, str, int]]:
        """Title and subtitle, each on as many lines as it takes: text, kind and height from the top."""
        width, y = self.width - 2 * _MARGIN, _MARGIN
        found = []
        for text, kind in ((self.title, "title"), (self.subtitle, "text")):
            for line in _wrapped(text, self.fonts[kind], width, _MOST_HEAD_LINES):
                found.append((line, kind, y))
                y += self.line(kind)
        return found

    @property
    def head(self) -> int:
        """Height of title and subtitle."""
        _, kind, y = self.head_lines[-1]
        return y + self.line(kind) + _MARGIN

    def height(self, row: str | tuple[SheetItem, ...]) -> int:
        """Return the height of a heading or of a line of cells, with the room below."""
        if isinstance(row, str):
            return self.line("name") + _MARGIN // 2
        return self.cell[1] + 4 + self.line("name") + 4 * self.line("text") + _MARGIN

    @property
    def width(self) -> int:
        """Of the whole sheet."""
        return _MARGIN + self.columns * (self.cell[0] + _MARGIN)

    @property
    def size(self) -> Size:
        """Of the whole sheet."""
        return self.width, self.head + sum(self.height(row) for row in self.rows)


_MOST_HEAD_LINES = 8
_FIGURES = "flop L*a*b* 0123456789.,-+°: ()"


class _Painter:
    """Draws the sheet's strips; one paint after the other is shown in the one scene."""

    def __init__(self, pictures: ItemPictures, layout: _Layout, problems: list[str]) -> None:
        self._pictures, self._layout, self._problems = pictures, layout, problems
        self._done = 0

    def strips(self, progress: Progress | None) -> Iterator[NDArray[np.uint8]]:
        """Yield the head, then a strip for each heading and each line of cells."""
        layout = self._layout
        yield self._text_strip(layout.head, layout.head_lines)
        paints = sum(len(row) for row in layout.rows if not isinstance(row, str))
        for row in layout.rows:
            if isinstance(row, str):
                yield self._text_strip(layout.height(row), [(row, "name", 0)])
            else:
                yield self._cells(row, paints, progress)

    def _text_strip(self, height: int, lines: list[tuple[str, str, int]]) -> NDArray[np.uint8]:
        from PIL import Image, ImageDraw

        width = self._layout.size[0]
        image = Image.new("RGB", (width, height), (_GREY,) * 3)
        draw = ImageDraw.Draw(image)
        for text, kind, y in lines:
            font = self._layout.fonts[kind]
            draw.text((_MARGIN, y), shortened(text, font, width - 2 * _MARGIN), (_BLACK,) * 3, font)
        return np.asarray(image)

    def _cells(self, row: tuple[SheetItem, ...], paints: int, progress: Progress | None) -> NDArray[np.uint8]:
        from PIL import Image, ImageDraw

        layout = self._layout
        image = Image.new("RGB", (layout.size[0], layout.height(row)), (_GREY,) * 3)
        draw = ImageDraw.Draw(image)
        for column, item in enumerate(row):
            report(progress, self._done / paints, f"{item.name}, {self._done + 1} of {paints}")
            left = _MARGIN + column * (layout.cell[0] + _MARGIN)
            lines = self._draw_item(item, image, left)
            y = layout.cell[1] + 4
            for number, text in enumerate([item.name, *lines]):
                kind, shade = ("name", _BLACK) if number == 0 else ("text", _SOFT)
                font = layout.fonts[kind]
                draw.text((left, y), shortened(text, font, layout.cell[0]), (shade,) * 3, font)
                y += layout.line(kind)
            self._done += 1
        return np.asarray(image)

    def _draw_item(self, item: SheetItem, image: Any, left: int) -> list[str]:
        """Put the paint's picture into the sheet and return the lines below its name."""
        from PIL import Image

        try:
            pixels, lines = self._pictures.draw(item)
        except SuiteError as error:
            self._problems.append(str(error))
            return [
                "could not be drawn:",
                *_wrapped(str(error), self._layout.fonts["text"], self._layout.cell[0], 3),
            ]
        image.paste(Image.fromarray(pixels), (left, 0))
        return lines


def _wrapped(text: str, font: Any, width: int, lines: int) -> list[str]:
    """Return a text broken into so many lines at most, the last one shortened."""
    words, wrapped = text.split(), [""]
    for word in words:
        longer = f"{wrapped[-1]} {word}".strip()
        if wrapped[-1] and font.getlength(longer) > width and len(wrapped) < lines:
            wrapped.append(word)
        else:
            wrapped[-1] = longer
    return [shortened(line, font, width) for line in wrapped]


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
