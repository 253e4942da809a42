"""Texts from files where they leave the suite: in windows, in reports, on terminals and in tables for spreadsheets.

A name can hold characters that are not seen and change what is: controls, among them the escape that steers a terminal;
marks that turn the direction of writing, by which ``fdp.exe`` reads ``exe.pdf``; and characters without width, by which
two names look alike. They are shown by their number in Unicode. Only what is shown is changed, never what is kept. In
a table a text could be taken for a formula.
"""

from __future__ import annotations

import html
import re
import unicodedata
from collections.abc import Mapping

FORMULA = tuple("=+-@\t\r\n＝＋－＠")
"""What begins a formula in a cell; tab and ends of lines are dropped by spreadsheets, and what follows begins it."""
_BEGINS = "(\\A|;)%s(?='*[" + re.escape("".join(FORMULA)) + "])"
"""A semicolon begins a cell where a spreadsheet divides the lines of a table there, as German ones do."""
_UNGUARDED, _GUARDED = re.compile(_BEGINS % ""), re.compile(_BEGINS % "'")

_MAYBE_UNSEEN = re.compile(r"[^\t\n -~]")
# Controls; formats, which steer the direction of writing, join, or have no width; half surrogate pairs; separators of
# lines and of paragraphs.
_UNSEEN_KINDS = ("Cc", "Cf", "Cs", "Zl", "Zp")
# Fillers and joiners that Unicode counts as letters and marks, and what is reserved for further formats.
_UNSEEN = frozenset("\u034f\u115f\u1160\u17b4\u17b5\u2065\u3164\uffa0") | {
    chr(0xE0000 + k) for k in range(128)
}
# Signs that Unicode counts as formats, and that are seen around numbers and verses. Variation selectors, which choose
# between glyphs that are seen, are marks.
_SEEN = frozenset("\u0600\u0601\u0602\u0603\u0604\u0605\u06dd\u070f\u0890\u0891\u08e2\U000110bd\U000110cd")


def make_visible(text: str) -> str:
    """Return the text with each character that is not seen, but for tab and line feed, as ``[U+202E]``.

    >>> make_visible("Blue\\u202e 15°")
    'Blue[U+202E] 15°'
    """
    return _MAYBE_UNSEEN.sub(lambda found: _visible(found[0]), text)


def _visible(character: str) -> str:
    is_unseen = unicodedata.category(character) in _UNSEEN_KINDS and character not in _SEEN
    return f"[U+{ord(character):04X}]" if is_unseen or character in _UNSEEN else character


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
