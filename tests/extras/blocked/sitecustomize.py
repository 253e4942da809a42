"""Python starts with this where ``PYTHONPATH`` names its folder: no optional package can be found, as if not installed.

Processes that are started from there inherit it. ``BRDF_SUITE_TEST_KEPT`` names packages that stay.
"""

from __future__ import annotations

import os
import sys
from importlib.machinery import ModuleSpec

from brdf_suite.extras import PACKAGES

KEPT = os.environ.get("BRDF_SUITE_TEST_KEPT", "").split(",")


class Blocked:
    """A finder that goes first and refuses what is optional."""

    @staticmethod
    def find_spec(name: str, *_: object) -> ModuleSpec | None:
        """Return nothing, or raise as the import system does for a module that is missing."""
        package = name.partition(".")[0]
        if package in PACKAGES and package not in KEPT:
            raise ModuleNotFoundError(f"No module named {name!r}", name=name)
        return None


sys.meta_path.insert(0, Blocked)
