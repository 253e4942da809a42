"""The writers of the suite as the harness calls them: each writes one version after another to the same place."""

from __future__ import annotations

from collections.abc import Iterable

from tools.attack.writing import documents, files, programs, registries
from tools.attack.writing.writer import Writer

WRITERS = (*documents.WRITERS, *registries.WRITERS, *files.WRITERS, *programs.WRITERS)


def chosen(words: Iterable[str] = (), *, in_slices: bool = False) -> list[Writer]:
    """Return the writers whose names begin with one of ``words``; without words all, or those of slices."""
    begins = tuple(words)
    if begins:
        return [one for one in WRITERS if one.name.startswith(begins)]
    return [one for one in WRITERS if one.in_slices or not in_slices]
