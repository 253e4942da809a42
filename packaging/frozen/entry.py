"""What a frozen suite starts: the command, of which the four programs are commands too."""

from __future__ import annotations

import multiprocessing
import sys
from pathlib import Path

from brdf_suite.interrupts import end_at_interrupt
from brdf_suite.processes import MODULE_OPTION

PROGRAMS = {
    "brdf-designer": "designer",
    "brdf-viewer": "viewer",
    "brdf-lobes": "lobes",
    "brdf-swatch": "swatch",
}

OPENED_BY = {
    ".brdfpaint": "designer",
    ".brdfpalette": "swatch",
    ".brdfview": "viewer",
    ".brdfstudio": "viewer",
    ".brdfproject": "viewer",
}
"""Which program opens a document that is the first word, as of an AppImage or a macOS bundle."""


def command_words(called: str, words: list[str]) -> list[str]:
    """Return the words of the command ``brdf-suite`` for ``words`` given to an executable ``called`` so.

    A link with a program's name opens that program; a document as the first word opens the program of its kind. A macOS
    bundle that is opened without a document shows Designer.
    """
    if words[:1] == [MODULE_OPTION]:  # a child process
        return words
    if (program := PROGRAMS.get(Path(called).stem)) is not None:
        return [program, *words]
    if words and (program := OPENED_BY.get(Path(words[0]).suffix.lower())) is not None:
        return [program, "--open", *words]
    return words or (["designer"] if ".app/Contents/MacOS/" in called else [])


if __name__ == "__main__":
    multiprocessing.freeze_support()
    end_at_interrupt()
    from brdf_suite.cli.main import main

    sys.exit(main(command_words(sys.argv[0], sys.argv[1:])))
