"""Future of two chained background tasks, the second of which needs the result of the first."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import Future, InvalidStateError
from contextlib import suppress
from typing import TYPE_CHECKING, TypeVar

if TYPE_CHECKING:
    from concurrent.futures import Future  # deferred, see answers.py

First = TypeVar("First")
Second = TypeVar("Second")


def chain_futures(
    first: Future[First], begin: Callable[[First, Future[Second]], Future[Second] | None]
) -> Future[Second]:
    """Return a future of what ``begin`` begins with the result of ``first``.

    ``begin`` is called on the thread that ends ``first``, and is given the whole's future too: it returns None where
    that was cancelled meanwhile. Cancelling the whole cancels what is in work of it; where one of the two is
    cancelled or fails, so does the whole.
    """
    whole: Future[Second] = Future()

    def stop(_: Future[Second]) -> None:
        if whole.cancelled():
            whole.set_running_or_notify_cancel()  # or concurrent.futures.wait would go on waiting
            first.cancel()

    def go_on(done: Future[First]) -> None:
        if done.cancelled():
            whole.cancel()
            return
        try:
            second = begin(done.result(), whole)
        except Exception as error:  # noqa: BLE001 - carried to the waiting caller; a future left alone hangs
            _settle(whole, error=error)
            return
        if second is None:
            return
        whole.add_done_callback(lambda _: second.cancel() if whole.cancelled() else None)
        second.add_done_callback(finish)

    def finish(done: Future[Second]) -> None:
        if done.cancelled():
            whole.cancel()
        elif (error := done.exception()) is not None:
            _settle(whole, error=error)
        else:
            _settle(whole, done.result())

    whole.add_done_callback(stop)
    first.add_done_callback(go_on)
    return whole


def _settle(future: Future[Second], value: Second | None = None, error: BaseException | None = None) -> None:
    """Give ``future`` a value or an error, unless it was cancelled meanwhile."""
    with suppress(InvalidStateError):
        if error is not None:
            future.set_exception(error)
        else:
            future.set_result(value)  # type: ignore[arg-type]  # None may be what Second is
