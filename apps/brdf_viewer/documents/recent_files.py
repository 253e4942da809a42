"""The files that were opened last, newest first, remembered between runs."""

from __future__ import annotations

from pathlib import Path

from brdf_qt.program.settings import settings

MOST = 8


class RecentFiles:
    """The recent files of one kind (``environment``, ``surface``, ``paint`` …)."""

    def __init__(self, kind: str) -> None:
        self._key = f"recent/{kind}"

    def paths(self) -> list[str]:
        """Return absolute paths, newest first; files that are gone are left out."""
        stored = settings().value(self._key, [])
        stored = stored if isinstance(stored, list) else [stored]
        return [path for path in stored if isinstance(path, str) and Path(path).is_file()]

    def add(self, path: str) -> None:
        """Put ``path`` first."""
        paths = [path, *(p for p in self.paths() if p != path)]
        settings().setValue(self._key, paths[:MOST])

    def clear(self) -> None:
        """Forget them."""
        settings().remove(self._key)
