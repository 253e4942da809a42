"""Unsaved work of runs that were ended: offered in a message, newest first; nothing is opened unasked."""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol, TypeVar

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


def offer_recovery(
    show_message: Callable[[Message], object],
    items: list[Recovered[T]],
    take: Callable[[Recovered[T]], object],
    drop: Callable[[Recovered[T]], object],
    one: str,
    several: str = "",
    finish: Callable[[bool], object] = lambda _taken: None,
) -> None:
    """Offer unsaved work: one document by its name, several together or one by one; nothing where there is none.

    ``take`` opens one and returns False where the user kept the open document instead; ``drop`` gives one up. ``one``
    and ``several`` are the questions in the language of the program, with the places ``{name}``, ``{when}`` and
    ``{count}``, ``{when}``, ``{names}``; without ``several`` the documents are always offered one by one. ``finish`` is
    called once each is taken or given up, with whether one was taken.
    """

    def take_all() -> None:
        # The newest was worked at last: it is opened last, and so in front.
        for item in reversed(items):
            take(item)
        finish(True)

    taken: list[Recovered[T]] = []

    def take_one(item: Recovered[T]) -> bool:
        if take(item) is False:
            return False
        taken.append(item)
        return True

    def offer(left: list[Recovered[T]]) -> None:
        if not left:
            finish(bool(taken))
            return
        item, rest = left[0], left[1:]

        def give_up() -> None:
            drop(item)
            offer(rest)

        what = one.format(name=_name(item), when=moment(item.when))
        if rest:
            what = tr("{what} {count} more will follow.").format(what=what, count=len(rest))
        actions = (
            (tr("Recover"), lambda: offer(rest if take_one(item) else left)),
            (tr("Discard"), give_up),
        )
        todo = tr("The file on disk is not changed.")
        show_message(Message(_KEY, what, todo=todo, actions=actions))

    if not items:
        return
    if len(items) < 2 or not several:
        offer(items)
        return
    names = [tr("“{name}”").format(name=_name(item)) for item in items]
    if len(names) > _MOST_NAMED:
        names = [*names[: _MOST_NAMED - 1], tr("{count} more").format(count=len(names) - _MOST_NAMED + 1)]
    newest = max(item.when for item in items)
    what = several.format(count=len(items), when=moment(newest), names=", ".join(names))
    actions = ((tr("Recover All"), take_all), (tr("One by One"), lambda: offer(items)))
    show_message(Message(_KEY, what, todo=tr("No file is changed."), actions=actions))


def _name(item: Recovered[T]) -> str:
    return item.path.name if item.path else item.value.name
