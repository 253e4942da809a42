"""What a part of Designer may offer beside its widgets; the assembly asks for it where it is there."""

from __future__ import annotations

from typing import Protocol, runtime_checkable


@runtime_checkable
class Closable(Protocol):
    """A part that has something to end when the program ends."""

    def close(self) -> object:
        """End it; called once."""


@runtime_checkable
class Unhurried(Protocol):
    """A part of which something comes later than the edit that it belongs to."""

    @property
    def is_complete(self) -> bool:
        """Whether what it shows is all there."""
