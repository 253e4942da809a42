"""Text on pictures: a font of the system that has the letters, or the plain one that comes with the library."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from pathlib import Path
from typing import TYPE_CHECKING

from PIL import ImageFont

if TYPE_CHECKING:
    from PIL.ImageFont import FreeTypeFont

_FONTS = (
    "DejaVuSans.ttf",
    "NotoSans-Regular.ttf",
    "LiberationSans-Regular.ttf",
    "segoeui.ttf",
    "Arial.ttf",
    "arial.ttf",
    "Helvetica.ttc",
    "Arial Unicode.ttf",
    "NotoSansCJK-Regular.ttc",
    "PingFang.ttc",
    "msyh.ttc",
)
"""Names of fonts that systems have, the ones with many letters first; looked for where the system keeps fonts."""

_NO_LETTER = "\uffff"


def font_for(texts: Iterable[str], size: int) -> tuple[FreeTypeFont, str]:
    """Return the font of ``size`` pixels that has the most letters of ``texts``, and those that it has not."""
    letters = sorted({letter for text in texts for letter in text if not letter.isspace()})
    best: FreeTypeFont | None = None
    missing = ""
    for name in (*_FONTS, None):
        try:
            font = ImageFont.load_default(size) if name is None else _system_font(name, size)
        except OSError:
            continue  # this system has not got it
        if not isinstance(font, ImageFont.FreeTypeFont):
            continue
        box = bytes(font.getmask(_NO_LETTER))
        found = "".join(letter for letter in letters if bytes(font.getmask(letter)) == box)
        if best is None or len(found) < len(missing):
            best, missing = font, found
        if not found:
            break
    if best is None:
        raise RuntimeError("the picture library was built without fonts")
    return best, missing


def _system_font(name: str, size: int) -> FreeTypeFont:
    """Return a font of the system; :class:`OSError` where there is none of that name.

    Pillow opens a bare name in the working folder first. Of a path that is not there it looks for the last part where
    the system keeps fonts.
    """
    return ImageFont.truetype(str(Path(__file__).with_name(name)), size)


def shortened(text: str, font: FreeTypeFont, width: int) -> str:
    """Return ``text``, or as much of it as fits into ``width`` pixels with three dots after it."""
    if font.getlength(text) <= width:
        return text
    low, high = 0, len(text)
    while low < high:
        middle = (low + high + 1) // 2
        low, high = (middle, high) if font.getlength(text[:middle] + "...") <= width else (low, middle - 1)
    return text[:low].rstrip() + "..."


def broken(text: str, measure: Callable[[str], float], width: float, lines: int) -> list[str]:
    """Return a text broken into so many lines at most, all but the last no wider than ``width`` by ``measure``."""
    found = [""]
    for word in text.split():
        longer = f"{found[-1]} {word}".strip()
        if found[-1] and len(found) < lines and measure(longer) > width:
            found.append(word)
        else:
            found[-1] = longer
    return found
