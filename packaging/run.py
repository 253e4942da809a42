"""Prepare this machine and start BRDF Suite: ``python3 packaging/run.py [brdf-suite arguments]``."""

from __future__ import annotations

import os
import subprocess
import sys

from prepare import ENVIRONMENT, prepare


def main() -> int:
    """Prepare, then become ``brdf-suite`` with the arguments given."""
    prepare()
    program = str(ENVIRONMENT / ("Scripts/brdf-suite.exe" if os.name == "nt" else "bin/brdf-suite"))
    if os.name != "nt":
        os.execv(program, [program, *sys.argv[1:]])
    return subprocess.run([program, *sys.argv[1:]], check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
