"""Letters by which the entries of a menu are chosen, none of them twice: also where parts and translations add some."""

from __future__ import annotations

from collections.abc import Iterable

from PySide6.QtWidgets import QMenu


def give_letters(menus: Iterable[QMenu]) -> None:
    """Give every entry of each menu a letter of its own: the one that it has, or where that is taken its first free."""
    for menu in menus:
        actions = [action for action in menu.actions() if not action.isSeparator()]
        texts = with_letters([action.text() for action in actions])
        for action, text in zip(actions, texts, strict=True):
            if action.text() != text:
                action.setText(text)


def with_letters(texts: list[str]) -> list[str]:
    """Return the texts with one ``&`` each, before a letter that no other has; an entry may be left without one.

    >>> with_letters(["&Open", "&Order", "Oo"])
    ['&Open', 'O&rder', 'Oo']
    """
    taken: set[str] = set()
    result = []
    for text in texts:
        place = _marked(text)
        plain = text if place is None else text[: place - 1] + text[place:]
        wished = [] if place is None else [place - 1]
        free = next(
            (
                at
                for at in (*wished, *range(len(plain)))
                if plain[at].isalnum() and plain[at].lower() not in taken
            ),
            None,
        )
        if free is None:
            result.append(plain)
        else:
            taken.add(plain[free].lower())
            result.append(plain[:free] + "&" + plain[free:])
    return result


def _marked(text: str) -> int | None:
    """Return the place of the letter after a single ``&``; ``&&`` is a written one."""
    at = 0
    while at < len(text) - 1:
        if text[at] == "&":
            if text[at + 1] != "&":
                return at + 1
            at += 1
        at += 1
    return None
