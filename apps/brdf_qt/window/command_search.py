"""Which commands a typed text means, best first: whole words before parts of words before scattered letters."""

from __future__ import annotations

import re
from collections.abc import Sequence

WORD, PART, SCATTERED = 0, 1, 2
Score = tuple[int, int, float, str]


def search(query: str, texts: Sequence[str]) -> list[int]:
    """Return the indices of the ``texts`` that fit ``query``, best first; all as they are where it is empty.

    Scattered letters count only where no text has the words themselves: a list of chance finds hides the one
    that was meant.
    """
    if not query.strip():
        return list(range(len(texts)))
    found = [(score, index) for index, text in enumerate(texts) if (score := score_of(query, text))]
    found.sort()
    best = found[0][0][0] if found else SCATTERED
    return [index for score, index in found if score[0] < SCATTERED or best == SCATTERED]


def score_of(query: str, text: str) -> Score | None:
    """Return how well ``query`` fits a command such as ``"File ▸ Open…"``, less is better; ``None``: not at all.

    The first number is :data:`WORD` where every word of the query begins a word of the text, :data:`PART`
    where every one is in it somewhere, :data:`SCATTERED` where only its letters are, in their order. Among
    equals the command's own name comes before the menus that lead to it, and short before long.
    """
    words, whole = query.lower().split(), text.lower()
    name, phrase = whole.rpartition("▸")[2].strip(" …"), " ".join(words)
    if all(_begins_word(word, whole) for word in words):
        return (WORD, _place(words, phrase, name), float(len(whole)), whole)
    if all(word in whole for word in words):
        return (PART, 0 if all(word in name for word in words) else 1, float(len(whole)), whole)
    gaps = _gaps("".join(words), whole)
    return None if gaps is None else (SCATTERED, 0, gaps + 0.01 * len(whole), whole)


def _begins_word(word: str, text: str) -> bool:
    return re.search(rf"(?<!\w){re.escape(word)}", text) is not None


def _place(words: list[str], phrase: str, name: str) -> int:
    if name == phrase:
        return 0
    if name.startswith(phrase):
        return 1
    return 2 if all(_begins_word(word, name) for word in words) else 3


def _gaps(letters: str, text: str) -> float | None:
    """Return how scattered the letters are in the text; ``None`` where they are not in it in their order."""
    at, gaps, last = 0, 0.0, -1
    for letter in letters:
        at = text.find(letter, at)
        if at < 0:
            return None
        if at != last + 1 or last < 0:
            starts_word = at == 0 or text[at - 1] in " ▸("
            gaps += (0.0 if last < 0 else 1.0) if starts_word else (2.0 if last < 0 else 3.0)
        last, at = at, at + 1
    return gaps
