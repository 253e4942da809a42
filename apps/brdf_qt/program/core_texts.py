"""Finished texts of the core in the language of the program.

The core has no translator: its errors, notices and words of progress come as English sentences with their values in
them, some from another process. ``packaging/translate.py`` collects the templates of these sentences from its sources;
:func:`tr_core` finds the one that a sentence was made by and fills its translation. Values that are texts of the core
themselves, as the cause of an error, are translated in turn.
"""

from __future__ import annotations

import json
import re
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache, cached_property, lru_cache

from PySide6.QtCore import QCoreApplication

from brdf_qt.program.translation import SOURCE, decimal, group_sign, language_in_use, mark, point
from brdf_suite.regular_files import read_text
from brdf_suite.resources import resource

_PLACE = re.compile(r"\{(\d+)\}")
_PATH = re.compile(r"(\S*[/\\].*|[^:;]*\w\.[A-Za-z]\w{1,10})")
OF_THE_SYSTEM = (
    mark("No such file or directory"),
    mark("Permission denied"),
    mark("Is a directory"),
    mark("Not a directory"),
    mark("File exists"),
    mark("File name too long"),
    mark("No space left on device"),
    mark("Read-only file system"),
)
"""Causes that the operating system names, in the words of Linux and macOS."""
JOINED = (mark("{0} and {1}"), mark("{0} or {1}"))
"""What the core joins words by."""
PARTS = (mark("flakes"), mark("texture"))
"""Parts of a paint's document, which the core names by their fields."""
_AT = mark(", at {0}")
_UNITS = "GU|EV|K|[mcµn]?m|[µm]?s|min|h|px|[kM]?B|[MG]i?B|mm²|cd|k?lx|sr|ΔE00|[LCHab]|as"
_FIGURES = re.compile(
    r"((?>(?<![\d.])[-+−±]?\d+(,\d{3})*([.,]\d+)?(e[-+−]?\d+)?(?!\d))|[ ×/,;…*–-]|°|%|‰"
    rf"|(?<![A-Za-z])({_UNITS})(?![A-Za-z]))+"
)
_THOUSANDS = re.compile(r"(?<![\d.])\d{1,3}(,\d{3})+(?![\d.])")
_DECIMALS = re.compile(r"\d+\.\d+")
_SENTENCE_END = re.compile(r"(?<=[.!?]) (?=[^a-z])")
_SEPARATORS = (": ", "; ")
_TAILS = (", ", "; ")
"""What clauses begin with that the core adds to a sentence."""
_ENOUGH = 0.6
"""Share of the letters of a sentence that a template has to account for, so that no other is looked for."""
_FEW = 5
"""Letters of a template, as "{0} and {1}", that joins words or known texts alone."""
_LONGEST = 1000
"""Characters of a line beyond which no template is looked for."""


class _Template:
    """The template of sentences."""

    def __init__(self, source: str) -> None:
        self.source = source
        self._literals = _PLACE.split(source)[::2]
        self.longest = max(self._literals, key=len)
        self.letters = sum(character.isalpha() for literal in self._literals for character in literal)
        pairs = zip(self._literals, self._literals[1:], strict=False)
        self.quoted = [a.endswith(("“", '"')) and b.startswith(("”", '"')) for a, b in pairs]

    def places(self, text: str) -> tuple[str, ...] | None:
        """Return what stands in the places of a sentence; None for a sentence of another template."""
        match = self._pattern.fullmatch(text)
        return None if match is None else match.groups()

    @cached_property
    def _pattern(self) -> re.Pattern[str]:
        return re.compile("(.*?)".join(map(re.escape, self._literals)), re.DOTALL)


@dataclass(frozen=True)
class _Found:
    """A translation, and how many characters of the English text are accounted for."""

    text: str
    known: int


def tr_core(text: str) -> str:
    """Return a finished text of the core in the language of the program; what is unknown in it stays as it is.

    >>> tr_core("there is no such file")
    'there is no such file'
    """
    language = language_in_use(QCoreApplication.instance())
    return text if language == SOURCE or not text else _translated(text, language)


@lru_cache(maxsize=1000)
def _translated(text: str, language: str) -> str:
    return "\n".join(_best(line, language).text for line in text.split("\n"))


@cache
def _templates() -> tuple[_Template, ...]:
    """Return the templates, those with the most words first."""
    sources = json.loads(read_text(resource("translations", "core_templates.json")))
    return tuple(sorted(map(_Template, [*sources, *JOINED]), key=lambda one: -one.letters))


@cache
def _clauses() -> tuple[_Template, ...]:
    return tuple(one for one in _templates() if one.source.startswith(_TAILS))


@lru_cache(maxsize=4000)
def _best(text: str, language: str) -> _Found:
    """Return the translation that accounts for most of a text."""
    bare = text.strip()
    if bare != text and bare:
        lead = text[: len(text) - len(text.lstrip())]
        inner = _best(bare, language)
        return _Found(lead + inner.text + text[len(lead) + len(bare) :], inner.known)
    if not text or len(text) > _LONGEST:
        return _Found(text, 0)
    if _FIGURES.fullmatch(text):
        return _Found(_localized(text), 0)
    whole = _plain(text)
    if whole is not None:
        return _Found(whole, len(text) + 1)
    found, is_sure = _filled(text, language, _templates())
    if is_sure:
        return found
    others = [found, *_divided(text, language)]
    if text.endswith((".", "…")):
        inner = _best(text[:-1], language)
        others.append(_Found(inner.text + text[-1], inner.known + 1 if inner.known else 0))
    if text[0].isupper():
        inner = _best(text[0].lower() + text[1:], language)
        others.append(_Found(inner.text[:1].upper() + inner.text[1:], inner.known))
    return max(others, key=lambda one: (one.known, one.text != text))


def _plain(text: str) -> str | None:
    """Return the translation of a text without places; None where it has none."""
    translated = QCoreApplication.translate("", text)
    if translated != text and not _PLACE.search(text):
        return translated
    if text.endswith("."):
        shorter = QCoreApplication.translate("", text[:-1])
        return None if shorter == text[:-1] else f"{shorter}."
    return None


def _clause(text: str, language: str) -> _Found | None:
    """Return the translation of a clause that begins with a comma or a semicolon; None for another text."""
    whole = _plain(text)
    if whole is not None:
        return _Found(whole, len(text))
    clause, is_sure = _filled(text, language, _clauses())
    return clause if is_sure else None


def _filled(text: str, language: str, templates: Sequence[_Template]) -> tuple[_Found, bool]:
    """Return the best translation by a template that has the whole text, and whether it is certainly the one."""
    best = _Found(text, 0)
    enough = _ENOUGH * sum(map(str.isalpha, text))
    for one in templates:
        if one.longest not in text or (given := one.places(text)) is None:
            continue
        places = [
            _Found(place, 0) if quoted else _best(place, language)
            for place, quoted in zip(given, one.quoted, strict=True)
        ]
        if one.letters < _FEW and any(_is_foreign(place) for place in places):
            continue  # an "or" in a name, or in a sentence that is not the core's
        pattern = QCoreApplication.translate("", one.source)
        filled = pattern.format(*(place.text for place in places))
        known = one.letters + sum(place.known for place in places)
        if known > best.known:
            best = _Found(filled, known)
        if one.letters >= enough:
            return best, True
    return best, False


def _is_foreign(place: _Found) -> bool:
    return not place.known and _FIGURES.fullmatch(place.text or " ") is None


def _divided(text: str, language: str) -> list[_Found]:
    """Return the translations of a text by its parts: sentences, the place and the cause, members of a list."""
    found: list[_Found] = []
    sentences = _SENTENCE_END.split(text)
    if len(sentences) > 1:
        found.append(_joined(" ", [_best(one, language) for one in sentences]))
    for separator in _SEPARATORS:
        start = text.find(separator)
        while start >= 0:
            left, right = text[:start], text[start + len(separator) :]
            first = _place(left, language) if separator == ": " else _best(left, language)
            found.append(_joined(separator, [first, _best(right, language)]))
            start = text.find(separator, start + 1)
    if text.count(", ") > 1 and ": " not in text:
        names = _listed(text.split(", "))
        if names.known:
            return [*found, names]
    for tail in _TAILS:
        start = text.find(tail, 1)
        while start > 0:
            clause = _clause(text[start:], language)
            if clause is not None:
                found.append(_joined("", [_best(text[:start], language), clause]))
            start = text.find(tail, start + 1)
    if text.endswith(")") and " (" in text:
        head, _, rest = text[:-1].partition(" (")
        outer, inner = _best(head, language), _best(rest, language)
        found.append(_Found(f"{outer.text} ({inner.text})", outer.known + inner.known))
    return found


def _listed(members: list[str]) -> _Found:
    """Return a list of names, some of which have commas themselves."""
    found = _Found("", 0)
    while members:
        for count in (3, 2, 1):
            name = ", ".join(members[:count])
            known = _plain(name) if " " in name else None
            if known is not None or count == 1:
                break
        members = members[count:]
        one = _Found(name, 0) if known is None else _Found(known, len(name))
        found = _joined(", ", [found, one]) if found.text else one
    return found


def _place(text: str, language: str) -> _Found:
    """Return what stands before the colon of an error: a file, which keeps its name, and the place in it."""
    file, at, place = text.partition(", at ")
    if not at:
        return _Found(text, 0) if _PATH.fullmatch(text) else _best(text, language)
    inner = _best(place, language) if " " in place else _Found(place, 0)  # the name of a field stays
    return _Found(file + QCoreApplication.translate("", _AT).format(inner.text), inner.known + len(at))


def _joined(separator: str, parts: list[_Found]) -> _Found:
    return _Found(separator.join(one.text for one in parts), sum(one.known for one in parts))


def _localized(figures: str) -> str:
    """Return figures with the signs that the language has in numbers; members of a list are divided by semicolons."""
    if point() == ".":
        return figures
    if _DECIMALS.search(figures):
        figures = figures.replace(", ", "; ")
    figures = _THOUSANDS.sub(lambda number: number[0].replace(",", "\0"), figures)
    return _DECIMALS.sub(lambda number: decimal(number[0]), figures).replace("\0", group_sign())
