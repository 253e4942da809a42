"""Words of the windows in the user's language: ``tr`` where a text is shown, ``mark`` where it is kept.

Sources are the English texts themselves; ``packaging/translate.py`` collects them and makes the ``.qm`` files.
A text is a literal with named places (``tr("Saved in {folder}").format(folder=name)``), never an f-string: the
tool that collects them reads the source.
"""

from __future__ import annotations

from PySide6.QtCore import QCoreApplication


def tr(text: str, comment: str | None = None) -> str:
    """Return ``text`` in the language of the program; as it is where no translation is installed.

    ``comment`` tells two meanings of one English word apart.
    """
    return QCoreApplication.translate("", text, comment)


def mark(text: str) -> str:
    """Return ``text`` itself: a constant that is handed to :func:`tr` later, when a translator is there."""
    return text
