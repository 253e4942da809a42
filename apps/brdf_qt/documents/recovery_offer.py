"""Unsaved work of runs that were ended: offered in a message, newest first; nothing is opened unasked."""

from __future__ import annotations

from collections.abc import Callable
from typing import Generic, Protocol, TypeVar

from brdf_qt.documents.recovery import Recovered
from brdf_qt.program.translation import moment, tr
from brdf_qt.window.message_bar import Message

_MOST_NAMED = 4
_KEY = "recovery"


class Named(Protocol):
    """A document with a name."""

    @property
    def name(self) -> str:
        """Its name."""


T = TypeVar("T", bound=Named)


class RecoveryOffer(Generic[T]):
    """Offers what ``find`` returns: one document by its name, several together or one by one.

    ``take`` opens one and returns False where the user kept the open document instead; ``drop`` gives one up. ``one``
    and ``several`` are the questions in the language of the program, with the places ``{name}``, ``{when}`` and
    ``{count}``, ``{when}``, ``{names}``; without ``several`` the documents are always offered one by one.
    """

    def __init__(
        self,
        show_message: Callable[[Message], object],
        find: Callable[[], list[Recovered[T]]],
        take: Callable[[Recovered[T]], object],
        drop: Callable[[Recovered[T]], object],
        one: str,
        several: str = "",
    ) -> None:
        self._show_message = show_message
        self._find, self._take, self._drop = find, take, drop
        self._one, self._several = one, several

    def show(self) -> None:
        """Look for unsaved work, and offer it where there is some."""
        items = self._find()
        if len(items) > 1 and self._several:
            self._offer_all(items)
        else:
            self._offer(items)

    def _offer_all(self, items: list[Recovered[T]]) -> None:
        names = [tr("“{name}”").format(name=_name(item)) for item in items]
        if len(names) > _MOST_NAMED:
            names = [*names[: _MOST_NAMED - 1], tr("{count} more").format(count=len(names) - _MOST_NAMED + 1)]
        newest = max(item.when for item in items)
        what = self._several.format(count=len(items), when=moment(newest), names=", ".join(names))
        actions = (
            (tr("Recover All"), lambda: self._take_all(items)),
            (tr("One by One"), lambda: self._offer(items)),
        )
        todo = tr("No file is changed.")
        self._show_message(Message(_KEY, what, todo=todo, actions=actions))

    def _take_all(self, items: list[Recovered[T]]) -> None:
        # The newest was worked at last: it is opened last, and so in front.
        for item in reversed(items):
            self._take(item)

    def _offer(self, items: list[Recovered[T]]) -> None:
        if not items:
            return
        item, rest = items[0], items[1:]

        def take() -> None:
            self._offer(items if self._take(item) is False else rest)

        def drop() -> None:
            self._drop(item)
            self._offer(rest)

        what = self._one.format(name=_name(item), when=moment(item.when))
        if rest:
            what = tr("{what} {count} more will follow.").format(what=what, count=len(rest))
        todo = tr("The file on disk is not changed.")
        actions = ((tr("Recover"), take), (tr("Discard"), drop))
        self._show_message(Message(_KEY, what, todo=todo, actions=actions))


def _name(item: Recovered[T]) -> str:
    return item.path.name if item.path else item.value.name
