"""Prepare this machine and start BRDF Suite: ``python3 packaging/run.py [--with EXTRAS] [brdf-suite arguments]``.

``--with reference,video`` also installs these extras (comma-separated); alone it installs them and ends.
``--prepare-only`` prepares and ends.
"""

from __future__ import annotations

import os
import subprocess
import sys

from prepare import Checkout, prepare
from report import NotPrepared, report


def main(arguments: list[str]) -> int:
    """Prepare, then run ``brdf-suite`` with the arguments that are not ours."""
    extras: set[str] = set()
    only_prepare = False
    while arguments and arguments[0].split("=")[0] in ("--prepare-only", "--with"):
        option, equals, names = arguments.pop(0).partition("=")
        if option == "--prepare-only":
            only_prepare = True
            continue
        if not equals and arguments:
            names = arguments.pop(0)
        extras |= {name.strip() for name in names.split(",") if name.strip()}
        if not extras:
            raise NotPrepared(f"--with: name extras, of {', '.join(Checkout().declared_extras())}.")
    prepare("speed", *sorted(extras))
    if only_prepare or (extras and not arguments):
        report(f"Ready, with {', '.join(sorted(extras))}" if extras else "Ready")
        return 0
    program = str(Checkout().program("brdf-suite"))
    if os.name != "nt":
        os.execv(program, [program, *arguments])
    return subprocess.run([program, *arguments], check=False).returncode


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
