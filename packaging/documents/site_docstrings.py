"""Extension of Griffe: docstrings of the library as mkdocstrings reads them."""

from __future__ import annotations

from typing import Any

import griffe

from brdf_suite.library.reference import normalize_docstring


class Docstrings(griffe.Extension):
    """Puts examples into a section of their own, and roles of reStructuredText into Markdown."""

    def on_object(self, *, obj: griffe.Object, **_: Any) -> None:
        """Change the docstring of an object that was read."""
        if obj.docstring is not None:
            obj.docstring.value = normalize_docstring(obj.docstring.value)
