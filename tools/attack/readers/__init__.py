"""The readers that the harness damages files for: all of the registries, and what programs read beside documents.

A new format of a registry is found by itself, and the check fails until a seed of it can be made. Readers outside the
registries are named in the modules here; :func:`missing` finds those of the package that no undamaged seed reaches.
"""

from __future__ import annotations

from tools.attack.readers import documents, measured, meshes, palettes, pictures, programs
from tools.attack.readers.reader import Reader

READERS: tuple[Reader, ...] = (
    *palettes.READERS,
    *measured.READERS,
    *meshes.READERS,
    *pictures.READERS,
    *documents.READERS,
    *programs.READERS,
)


def chosen(words: list[str]) -> list[Reader]:
    """Return the readers whose names begin with, or are, one of ``words``; all of them for none."""
    return [reader for reader in READERS if not words or any(reader.name.startswith(word) for word in words)]
