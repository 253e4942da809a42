"""Unsaved work of runs that were ended: offered back in a message, newest first; nothing is opened unasked."""

from __future__ import annotations

from brdf_qt.documents.recovery import Recovered
from brdf_qt.program.translation import moment, tr
from brdf_qt.window.message_bar import Message

from brdf_designer.documents.tabs import Documents
from brdf_designer.session.paint_session import Messages
from brdf_suite.documents.paint import Paint

_MOST_NAMED = 4


class RecoveryOffer:
    """Offers what :class:`Recovery` finds: one paint by its name, several together or one by one."""

    def __init__(self, documents: Documents, messages: Messages) -> None:
        self._documents, self._messages = documents, messages

    def show(self) -> None:
        """Look for unsaved work, and offer it where there is some."""
        items = self._documents.front.recovery.found()
        if len(items) > 1:
            self._offer_all(items)
        else:
            self._offer(items)

    def _offer_all(self, items: list[Recovered[Paint]]) -> None:
        names = [tr("“{name}”").format(name=_name(item)) for item in items]
        if len(names) > _MOST_NAMED:
            names = [*names[: _MOST_NAMED - 1], tr("{count} more").format(count=len(names) - _MOST_NAMED + 1)]
        newest = max(item.when for item in items)
        what = tr(
            "Designer closed unexpectedly. Recover unsaved work on {count} paints (newest: {when}): {names}?"
        ).format(count=len(items), when=moment(newest), names=", ".join(names))
        actions = (
            (tr("Recover All"), lambda: self._take_all(items)),
            (tr("One by One"), lambda: self._offer(items)),
        )
        todo = tr("Each paint opens in a tab. No file is changed.")
        self._messages.show_message(Message("recovery", what, todo=todo, actions=actions))

    def _take_all(self, items: list[Recovered[Paint]]) -> None:
        # The newest was worked at last: it is opened last, and so in front.
        for item in reversed(items):
            self._documents.recover(item)

    def _offer(self, items: list[Recovered[Paint]]) -> None:
        if not items:
            return
        item, rest = items[0], items[1:]

        def take() -> None:
            self._documents.recover(item)
            self._offer(rest)

        def drop() -> None:
            self._documents.front.recovery.drop(item)
            self._offer(rest)

        what = tr("Designer closed unexpectedly. Recover your unsaved work on “{name}” of {when}?").format(
            name=_name(item), when=moment(item.when)
        )
        if rest:
            what = tr("{what} {count} more will follow.").format(what=what, count=len(rest))
        todo = tr("The file on disk is not changed.")
        actions = ((tr("Recover"), take), (tr("Discard"), drop))
        self._messages.show_message(Message("recovery", what, todo=todo, actions=actions))


def _name(item: Recovered[Paint]) -> str:
    return item.path.name if item.path else item.value.name
