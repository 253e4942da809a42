"""The view of a start: read on a thread while the program begins, and not waited for where that takes long."""

from __future__ import annotations

import threading

from brdf_suite.documents.store import load_view
from brdf_suite.documents.view import View
from brdf_suite.errors import SuiteError

_PATIENCE_S = 0.25
"""A view is read in a few milliseconds; the first picture waits no longer for it than this."""


class FirstView:
    """Reads the view in a file from now on."""

    def __init__(self, path: str) -> None:
        self._path = path
        self._found: View | SuiteError | None = None
        # A disk that hangs must not keep the program from ending.
        self._thread = threading.Thread(target=self._read, name="first view", daemon=True)
        self._thread.start()

    def wait(self, seconds: float = _PATIENCE_S) -> View | None:
        """Return the view, or None where it is not there in time; :class:`SuiteError` where it cannot be read."""
        self._thread.join(seconds)
        if isinstance(self._found, SuiteError):
            raise self._found
        return self._found

    def _read(self) -> None:
        try:
            self._found = load_view(self._path)
        except SuiteError as error:
            self._found = error
