"""Layout of a contact sheet on pages: where pictures, colours and texts stand, in points, y down from the upper edge.

It draws nothing: the PDF and the preview of a program put the same marks on their paper.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace

from brdf_suite.appearance.colour.flat_colours import lab_to_hex
from brdf_suite.errors import ValueRangeError
from brdf_suite.reports.sheet_text import broken

PAGE_SIZES = {"a4": (595.276, 841.89), "a3": (841.89, 1190.551), "letter": (612.0, 792.0)}
"""Width and height of upright paper, points (ISO 216, ANSI/ASME Y14.1)."""
FIELDS = ("code", "colours", "figures", "lab")
"""What may stand below a picture and a name: the code; the colours at 15, 45 and 110° as chips; flop index and gloss;
L*a*b* at these angles."""
MOST_COLUMNS = 40
MARGIN = 36.0
INK, SOFT, HAIR = "#101010", "#5a5a5a", "#c8c8c8"
_GAP, _LINE = 12.0, 1.28
_TITLE, _HEADING, _NAME, _TEXT = 20.0, 11.0, 8.0, 6.6
_CHIPS, _EDGE = 7.0, 0.4
_HEAD_FIRST, _HEAD_NEXT, _FOOT = 46.0, 22.0, 16.0
_HEADING_ROOM = 22.0
_CUT = "…"

Measure = Callable[[str, float, bool], float]
"""Width of a text, points, of a size and weight (bold)."""
Lab = tuple[float, float, float]


@dataclass(frozen=True)
class PageStyle:
    """Paper and content of the pages of a contact sheet.

    Raises :class:`ValueRangeError`: the paper, a field or the number of columns is none of the known.
    """

    page: str = "a4"
    landscape: bool = False
    columns: int = 4
    fields: tuple[str, ...] = FIELDS

    def __post_init__(self) -> None:
        if self.page not in PAGE_SIZES:
            raise ValueRangeError("page", f"{', '.join(PAGE_SIZES)} are known, not {self.page!r}")
        unknown = [name for name in self.fields if name not in FIELDS]
        if unknown:
            raise ValueRangeError("show", f"{', '.join(FIELDS)} are known, not {unknown[0]!r}")
        if not 1 <= self.columns <= MOST_COLUMNS:
            raise ValueRangeError("columns", f"1 to {MOST_COLUMNS} stand in a row, not {self.columns}")

    def for_codes(self, codes: Sequence[str]) -> PageStyle:
        """Return the style without the line of codes where none of the items has one."""
        if any(codes):
            return self
        return replace(self, fields=tuple(name for name in self.fields if name != "code"))

    @property
    def size(self) -> tuple[float, float]:
        """Width and height of the page, points."""
        width, height = PAGE_SIZES[self.page]
        return (height, width) if self.landscape else (width, height)


@dataclass(frozen=True)
class CellText:
    """Name, figures and colours of an item; ``labs`` are (aspecular angle in degrees, L*a*b*) with the light at 45°."""

    name: str
    code: str = ""
    figures: str = ""
    labs: tuple[tuple[float, Lab], ...] = ()
    problem: str = ""

    @property
    def lines(self) -> list[str]:
        """The figures and L*a*b* as lines of text."""
        # A minus that every font has.
        rows = [f"{angle:g}°: L* {lab[0]:.1f}  a* {lab[1]:.1f}  b* {lab[2]:.1f}" for angle, lab in self.labs]
        return [self.figures, *rows] if self.figures else rows


@dataclass(frozen=True)
class Label:
    """A text whose baseline is at ``y``; ``anchor`` is ``start``, ``middle`` or ``end``."""

    x: float
    y: float
    text: str
    size: float
    colour: str = INK
    bold: bool = False
    anchor: str = "start"


@dataclass(frozen=True)
class Patch:
    """A rectangle filled with a colour (``#rrggbb``); lines are narrow ones."""

    x: float
    y: float
    width: float
    height: float
    colour: str


@dataclass(frozen=True)
class Marks:
    """What is drawn: patches first, then texts."""

    patches: tuple[Patch, ...] = ()
    labels: tuple[Label, ...] = ()


@dataclass(frozen=True)
class Slot:
    """The place of an item: its page, counted from 0, and the rectangle of its picture."""

    page: int
    x: float
    y: float
    width: float
    height: float


@dataclass(frozen=True, eq=False)
class PageLayout:
    """Slots of all items and headings of their groups; see :meth:`of`.

    ``headings`` are (page, y, text).
    """

    title: str
    subtitle: str
    date: str
    style: PageStyle
    slots: tuple[Slot, ...]
    headings: tuple[tuple[int, float, str], ...]
    pages: int
    _cell_width: float = field(default=0.0)

    @staticmethod
    def of(
        title: str, subtitle: str, date: str, groups: Sequence[str], style: PageStyle, aspect: float
    ) -> PageLayout:
        """Return the layout of items, given the heading that each stands under (those of one together).

        ``aspect`` is height over width of a picture.

        >>> PageLayout.of("Blues", "", "", ["", ""], PageStyle(columns=2), 1.0).pages
        1
        """
        width, height = style.size
        cell = (width - 2.0 * MARGIN - (style.columns - 1) * _GAP) / style.columns
        text = _text_height(style.fields)
        body = height - MARGIN - _FOOT
        # A picture that is far higher than it is wide takes at most half a page.
        shrink = min(1.0, 0.5 * (height - 2.0 * MARGIN) / (cell * aspect))
        picture = (cell * shrink, cell * aspect * shrink)
        row = picture[1] + text + _GAP
        slots: list[Slot] = []
        headings: list[tuple[int, float, str]] = []
        page, y, column, group, fresh = 0, MARGIN + _HEAD_FIRST, 0, "", True
        for number, name in enumerate(groups):
            begins = number == 0 or name != group
            if begins or column == style.columns:
                if number:
                    y += row
                heading = _HEADING_ROOM if begins and name else 0.0
                if y + heading + row - _GAP > body and not fresh:
                    page, y = page + 1, MARGIN + _HEAD_NEXT
                if heading:
                    headings.append((page, y + _HEADING, name))
                    y += heading
                column, group = 0, name
            slots.append(Slot(page, MARGIN + column * (cell + _GAP), y, *picture))
            column += 1
            fresh = False
        return PageLayout(
            title, subtitle, date, style, tuple(slots), tuple(headings), page + 1 if groups else 0, cell
        )

    def frame(self, page: int, measure: Measure) -> Marks:
        """Return head, headings and foot of a page, counted from 0."""
        width, height = self.style.size
        right, room = width - MARGIN, width - 2.0 * MARGIN
        labels, patches = [], []
        if page == 0:
            free = room - measure(self.date, _NAME, False) - 12.0
            y = MARGIN + 0.8 * _TITLE
            title = _shortened(self.title, _TITLE, free, measure, bold=True)
            labels.append(Label(MARGIN, y, title, _TITLE, bold=True))
            labels.append(Label(right, y, self.date, _NAME, SOFT, anchor="end"))
            patches.append(Patch(MARGIN, y + 7.0, room, 1.2, INK))
        else:
            y = MARGIN + _NAME
            labels.append(Label(MARGIN, y, _shortened(self.title, _NAME, room, measure), _NAME, SOFT))
            patches.append(Patch(MARGIN, y + 4.0, room, 0.5, HAIR))
        for where, at, text in self.headings:
            if where == page:
                shown = _shortened(text, _HEADING, room, measure, bold=True)
                labels.append(Label(MARGIN, at, shown, _HEADING, bold=True))
                patches.append(Patch(MARGIN, at + 3.5, room, 0.5, HAIR))
        y = height - MARGIN + 6.0
        patches.append(Patch(MARGIN, y - 10.0, room, 0.5, HAIR))
        count = f"{page + 1} / {self.pages}"
        free = room - measure(count, _TEXT, False) - 12.0
        labels.append(Label(MARGIN, y, _shortened(self.subtitle, _TEXT, free, measure), _TEXT, SOFT))
        labels.append(Label(right, y, count, _TEXT, SOFT, anchor="end"))
        return Marks(tuple(patches), tuple(labels))

    def cell(self, place: int, text: CellText, measure: Measure) -> Marks:
        """Return what stands below the picture of an item, or in its place where there is a problem."""
        slot, fields, width = self.slots[place], self.style.fields, self._cell_width
        labels: list[Label] = []
        patches: list[Patch] = []
        y = slot.y + slot.height
        if text.problem:
            lines = broken(text.problem, lambda part: measure(part, _TEXT, False), width, 6)
            for number, line in enumerate(lines):
                at = slot.y + (number + 1) * _LINE * _TEXT
                labels.append(Label(slot.x, at, _shortened(line, _TEXT, width, measure), _TEXT, SOFT))
        if "colours" in fields:
            each = slot.width / max(1, len(text.labs))
            if text.labs:
                # An edge, without which white is not seen on paper.
                patches.append(Patch(slot.x, y, slot.width, _CHIPS + _EDGE, HAIR))
            for number, (_, lab) in enumerate(text.labs):
                left = slot.x + number * each + (_EDGE if number == 0 else 0.0)
                right = slot.x + (number + 1) * each - (_EDGE if number + 1 == len(text.labs) else 0.0)
                patches.append(Patch(left, y, right - left, _CHIPS, lab_to_hex(lab)))
            y += _CHIPS
        y += 3.0 + _NAME
        name = _shortened(text.name, _NAME, width, measure, bold=True)
        labels.append(Label(slot.x, y, name, _NAME, bold=True))
        for key, line in (("code", text.code), ("figures", text.figures)):
            if key in fields:
                y += _LINE * _TEXT
                labels.append(Label(slot.x, y, _shortened(line, _TEXT, width, measure), _TEXT, SOFT))
        if "lab" in fields and text.labs:
            columns = [slot.x + width * share for share in (0.0, 0.47, 0.73, 0.99)]
            rows = [("", "L*", "a*", "b*"), *(_row(angle, lab) for angle, lab in text.labs)]
            size = min(_TEXT, width / 14.0)
            for row in rows:
                y += _LINE * _TEXT
                for number, (x, word) in enumerate(zip(columns, row, strict=True)):
                    labels.append(Label(x, y, word, size, SOFT, anchor="end" if number else "start"))
        return Marks(tuple(patches), tuple(label for label in labels if label.text))


def _text_height(fields: Sequence[str]) -> float:
    """Return the height of what stands below a picture."""
    lines = sum({"code": 1, "figures": 1, "lab": 4}.get(name, 0) for name in fields)
    return (_CHIPS if "colours" in fields else 0.0) + 3.0 + _LINE * _NAME + lines * _LINE * _TEXT


def _row(angle: float, lab: Lab) -> tuple[str, str, str, str]:
    first, second, third = (f"{value:.1f}".replace("-", "−") for value in lab)
    return f"{angle:g}°", first, second, third


def _shortened(text: str, size: float, room: float, measure: Measure, *, bold: bool = False) -> str:
    """Return as much of a text as fits, cut in the middle: beginnings of names are often shared."""
    if measure(text, size, bold) <= room:
        return text
    kept = len(text) - 1
    while kept > 1 and measure(_cut(text, kept), size, bold) > room:
        kept -= 1
    return _cut(text, kept)


def _cut(text: str, kept: int) -> str:
    return text[: (kept + 1) // 2].rstrip() + _CUT + text[len(text) - kept // 2 :].lstrip()
