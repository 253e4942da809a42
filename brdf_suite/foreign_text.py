"""Texts from files where they leave the suite: in windows, in reports, on terminals and in tables for spreadsheets.

A name can hold characters that are not seen and change what is: controls, among them the escape that steers a terminal;
marks that turn the direction of writing, by which ``fdp.exe`` reads ``exe.pdf``; and characters without width, by which
two names look alike. They are shown by their number in Unicode. Only what is shown is changed, never what is kept. In
a table a text could be taken for a formula.
"""

from __future__ import annotations

import html
import re
from collections.abc import Mapping

FORMULA = tuple("=+-@\t\r\n＝＋－＠")
"""What begins a formula in a cell; tab and ends of lines are dropped by spreadsheets, and what follows begins it."""
_BEGINS = "((?:\\A|[;\r\n])\"*)%s(?='*[" + re.escape("".join(FORMULA)) + "])"
"""Semicolons and ends of lines begin cells where a spreadsheet divides a table at semicolons, as German ones do."""
_UNGUARDED, _GUARDED = re.compile(_BEGINS % ""), re.compile(_BEGINS % "'")

# Controls but for tab and line feed; half surrogate pairs; separators of lines and paragraphs; the marks, embeddings,
# overrides and isolates of bidirectional text (Unicode Standard Annex 9); soft hyphen, joiners and fillers without
# width; formats of hieroglyphs, shorthand and music; and tags. Variation selectors stay: they choose between glyphs
# that are seen.
_UNSEEN = re.compile(
    "[\x00-\x08\x0b-\x1f\x7f-\x9f\ud800-\udfff\u2028\u2029\u061c\u200e\u200f\u202a-\u202e\u2066-\u2069"
    "\u00ad\u034f\u115f\u1160\u17b4\u17b5\u180e\u200b-\u200d\u2060-\u2065\u206a-\u206f\u3164\ufeff\uffa0\ufff9-\ufffb"
    "\U00013430-\U0001343f\U0001bca0-\U0001bca3\U0001d173-\U0001d17a\U000e0000-\U000e007f]"
)


def make_visible(text: str) -> str:
    """Return the text with each character that is not seen, but for tab and line feed, as ``[U+202E]``.

    >>> make_visible("Blue\\u202e 15°")
    'Blue[U+202E] 15°'
    """
    return _UNSEEN.sub(lambda found: f"[U+{ord(found[0]):04X}]", text)


def file_title(name: str) -> str:
    """Return the name of a file as one line of text, as documents take it; its bytes may be no text.

    >>> file_title("caf\\udce9\\n15.json")
    'caf  15.json'
    """
    return "".join(character if character.isprintable() else " " for character in name)


def escape_html(text: str) -> str:
    """Return the text as HTML and SVG show it, in an element or in an attribute between quotes.

    >>> escape_html('<b>"Blue"</b>')
    '&lt;b&gt;&quot;Blue&quot;&lt;/b&gt;'
    """
    return html.escape(make_visible(text))


def guard_formula(text: str) -> str:
    """Return a text that no spreadsheet takes for a formula; :func:`unguard_formula` is the way back.

    >>> guard_formula("=1+1"), guard_formula("Blue"), unguard_formula("'=1+1")
    ("'=1+1", 'Blue', '=1+1')
    >>> guard_formula("Blue;=1+1")
    "Blue;'=1+1"
    """
    return _UNGUARDED.sub(r"\1'", text)


def unguard_formula(text: str) -> str:
    """Return the text that :func:`guard_formula` was given."""
    return _GUARDED.sub(r"\1", text)


def guard_cells(row: Mapping[str, object]) -> dict[str, object]:
    """Return a row whose texts are no formulas to a spreadsheet; numbers, also those in texts, stay as they are."""
    return {name: guard_cell(value) if isinstance(value, str) else value for name, value in row.items()}


def guard_cell(text: str) -> str:
    """Return a cell's text that is no formula to a spreadsheet; a number stays as it is.

    >>> guard_cell("-1.5"), guard_cell("-1+1")
    ('-1.5', "'-1+1")
    """
    try:
        float(text)
    except ValueError:
        return guard_formula(text)
    return text
