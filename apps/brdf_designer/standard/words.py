"""The words of differences in the user's language: every text that the core makes its sentences of."""

from __future__ import annotations

from brdf_qt.program.translation import mark, tr

MARKED = (
    mark("lighter"),
    mark("darker"),
    mark("cleaner"),
    mark("dirtier"),
    mark("redder"),
    mark("yellower"),
    mark("greener"),
    mark("bluer"),
    mark("more flop"),
    mark("less flop"),
    mark("slightly {word}"),
    mark("much {word}"),
    mark("{first} and {second}"),
    mark("{first}, {second}"),
    mark("{first}; {second}"),
    mark("{words} at {angles}"),
    mark("{words} at every angle"),
    mark("no visible difference"),
)
"""A test holds that these are :data:`brdf_suite.appearance.difference.words.WORDS` and ``PATTERNS``, all of them."""


def say(text: str) -> str:
    """Return one of :data:`MARKED` in the user's language."""
    return tr(text)
