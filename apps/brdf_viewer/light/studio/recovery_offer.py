"""Unsaved studios of runs that were ended: offered back in a message, newest first; nothing is opened unasked."""

from __future__ import annotations

from collections.abc import Callable

from brdf_qt.documents.recovery import Recovered, Recovery
from brdf_qt.program.translation import moment, tr
from brdf_qt.window.message_bar import Message, MessageBar

from brdf_suite.documents.light_store import LightDocument

_KEY = "recovery"
Item = Recovered[LightDocument]


def offer_recovered(
    recovery: Recovery[LightDocument], messages: MessageBar, take: Callable[[Item], bool]
) -> None:
    """Look for unsaved studios, and offer each that there is; ``take`` opens one, False where it was not wanted."""
    _offer(recovery.found(), recovery, messages, take)


def _offer(
    items: list[Item], recovery: Recovery[LightDocument], messages: MessageBar, take: Callable[[Item], bool]
) -> None:
    if not items:
        return
    item, rest = items[0], items[1:]

    def recover() -> None:
        taken = take(item)
        _offer(rest if taken else items, recovery, messages, take)

    def drop() -> None:
        recovery.drop(item)
        _offer(rest, recovery, messages, take)

    name = item.path.name if item.path else item.value.name
    what = tr("Unsaved work on the studio “{name}” from {when} was found.").format(
        name=name, when=moment(item.when)
    )
    if rest:
        what = tr("{what} After it: {count} more.").format(what=what, count=len(rest))
    todo = tr("Viewer closed unexpectedly. Recover your unsaved work? The file on disk is unchanged.")
    actions = ((tr("Recover"), recover), (tr("Discard"), drop))
    messages.show_message(Message(_KEY, what, todo=todo, actions=actions))
