"""What a frozen suite starts: the command, of which the four programs are commands too."""

from __future__ import annotations

import multiprocessing
import sys
from pathlib import Path

from brdf_suite.cli.main import main
from brdf_suite.processes import MODULE_OPTION

PROGRAMS = {
    "brdf-designer": "designer",
    "brdf-viewer": "viewer",
    "brdf-lobes": "lobes",
    "brdf-swatch": "swatch",
}

if __name__ == "__main__":
    multiprocessing.freeze_support()
    # A link to the executable, called as a program is, opens that program.
    is_child = sys.argv[1:2] == [MODULE_OPTION]
    program = None if is_child else PROGRAMS.get(Path(sys.argv[0]).stem)
    sys.exit(main(sys.argv[1:] if program is None else [program, *sys.argv[1:]]))
