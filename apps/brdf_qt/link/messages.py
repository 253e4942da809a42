"""The envelope in which programs of the suite share what is being edited.

One message is one line of JSON in UTF-8, ended by a newline and at most :data:`MAX_BYTES` long::

    {"v": 2, "topic": "paint", "value": {...}, "from": "b3f1…", "seq": 17}

``seq`` is a hybrid logical clock: the time of publishing in milliseconds since the machine was started, and at least
one more than the largest number of that topic that the publisher has seen. That time is the same in all programs, and
setting the clock does not change it. A number that is far ahead of it is refused: it would outlive all later edits.
``(seq, from)`` therefore orders all messages of a topic in the same way in every program, whichever program relays
them and in whichever order they arrive; a message that comes again is recognised, and what was published later wins
also between programs that had not met before.

``v`` is :data:`~brdf_qt.link.address.VERSION`. Programs of another version meet elsewhere, so that suites of two
versions run side by side; a message of another version is refused all the same.

Two further topics are for the link itself: ``hello`` (a program says what it is) and ``peers`` (the relay
says who is there).
"""

from __future__ import annotations

import json
import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from brdf_qt.link.address import VERSION
from brdf_suite.documents.parameter import describe
from brdf_suite.documents.store import paint_from_json, view_from_json

MAX_BYTES = 1_000_000
HELLO = "hello"
PEERS = "peers"
OFFER = "offer"
"""A paint handed to one program, to be opened there as a document of its own."""
OFFER_LASTS_S = 120.0
"""A program that is started for an offer finds it; one that is started later is not to open it."""
_MAX_SEQ = 2**48
AHEAD_MS = 60_000
"""How far a number may be ahead of the time, milliseconds: a program that publishes in bursts runs ahead of it."""
_MAX_TIME_S = 2**40
_MAX_NAME = 64
_KEYS = {"v", "topic", "value", "from", "seq"}

Check = Callable[[dict[str, Any]], object]


class BadMessageError(ValueError):
    """A line that is not a message of ours; the text says why, for the log."""


@dataclass(frozen=True)
class Message:
    """One decoded message; ``line`` is what goes over the socket, newline included."""

    topic: str
    value: dict[str, Any]
    sender: str
    seq: int
    line: bytes

    @property
    def order(self) -> tuple[int, str]:
        """What a newer message of the same topic has more of."""
        return (self.seq, self.sender)


def encode(topic: str, value: dict[str, Any], sender: str, seq: int) -> Message:
    """Return the message, ready to send; raise :class:`BadMessageError` where it cannot be one."""
    try:
        text = json.dumps(
            {"v": VERSION, "topic": topic, "value": value, "from": sender, "seq": seq},
            allow_nan=False,
            separators=(",", ":"),
        )
    except (TypeError, ValueError, RecursionError) as error:
        raise BadMessageError(f"the value of topic {topic!r} is not plain JSON ({error})") from error
    line = text.encode("ascii") + b"\n"
    if len(line) > MAX_BYTES:
        raise BadMessageError(
            f"the value of topic {topic!r} takes {len(line)} bytes, the limit is {MAX_BYTES}"
        )
    return Message(topic, value, sender, seq, line)


def decode(line: bytes) -> Message:
    """Return the message in ``line`` (without or with its newline); raise :class:`BadMessageError`.

    Only the envelope is checked here: the value's own schema is checked when, and if, it is delivered.
    """
    try:
        data = json.loads(line, parse_constant=_no_constants)
    except (ValueError, RecursionError) as error:
        raise BadMessageError(f"not JSON ({error})"[:200]) from error
    if not isinstance(data, dict) or set(data) != _KEYS:
        raise BadMessageError("not an envelope with exactly v, topic, value, from and seq")
    if data["v"] != VERSION:
        raise BadMessageError(f"version {describe(data['v'])}, this program knows {VERSION}")
    topic, value, sender, seq = data["topic"], data["value"], data["from"], data["seq"]
    if not _is_name(topic) or not _is_name(sender) or not isinstance(value, dict):
        raise BadMessageError("topic, from or value has the wrong type")
    if isinstance(seq, bool) or not isinstance(seq, int) or not 0 <= seq <= _MAX_SEQ:
        raise BadMessageError(f"seq {describe(seq)} is not a whole number from 0 to {_MAX_SEQ}")
    return Message(topic, value, sender, seq, line.rstrip(b"\r\n") + b"\n")


def next_seq(seen: int | None) -> int:
    """Return the number of a message published now, ``seen`` being the largest of its topic so far."""
    return max(_now_ms(), -1 if seen is None else seen + 1)


def check_order(seq: int, seen: int | None) -> None:
    """Raise :class:`BadMessageError` where a number is far ahead of the time, and of ``seen``, the largest so far."""
    if seq > max(_now_ms() + AHEAD_MS, -1 if seen is None else seen + 1):
        raise BadMessageError(f"seq {seq} is more than {AHEAD_MS // 1000} s ahead of the time")


def _now_ms() -> int:
    return time.monotonic_ns() // 1_000_000


def document_checks() -> Mapping[str, Check]:
    """Return, for each topic that programs publish, the reader that raises where a value is not valid."""
    return {
        "paint": lambda value: paint_from_json(value, "live link"),
        "view": lambda value: view_from_json(value, "live link"),
        OFFER: _check_offer,
    }


def _check_offer(value: dict[str, Any]) -> None:
    """Check ``{"to": role, "time": seconds since 1970, "paint": {...}}``."""
    if set(value) != {"to", "time", "paint"} or not _is_name(value["to"]):
        raise BadMessageError("an offer has to, time and paint")
    seconds = value["time"]
    if isinstance(seconds, bool) or not isinstance(seconds, (int, float)) or not 0 <= seconds <= _MAX_TIME_S:
        raise BadMessageError(f"the time of an offer is a number of seconds from 0 to {_MAX_TIME_S}")
    paint_from_json(value["paint"], "live link")


def _is_name(value: object) -> bool:
    return isinstance(value, str) and 0 < len(value) <= _MAX_NAME


def _no_constants(name: str) -> object:
    raise ValueError(f"{name} is not a number")
