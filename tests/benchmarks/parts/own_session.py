"""Surroundings of a program that a benchmark opens: no saved settings, and a link that no other program is on."""

from __future__ import annotations

import os
import tempfile
import uuid
from collections.abc import Iterator
from contextlib import contextmanager


@contextmanager
def own_session(*, offscreen: bool = False, own_cache: bool = False) -> Iterator[None]:
    """Set this process's environment variables; ``offscreen``: Qt's platform, ``own_cache``: an empty cache."""
    with tempfile.TemporaryDirectory() as folder:
        os.environ.update(BRDF_SUITE_SETTINGS=folder, BRDF_SUITE_LINK=f"bench-{uuid.uuid4().hex[:12]}")
        if offscreen:
            os.environ["QT_QPA_PLATFORM"] = "offscreen"
        if own_cache:
            os.environ["BRDF_SUITE_CACHE"] = folder
        yield
