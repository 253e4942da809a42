"""Start :mod:`tools.attack.command`: ``python tools/attack/run.py --help``."""

from __future__ import annotations

import os
import runpy
import sys
from pathlib import Path

if __name__ == "__main__":
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # before numpy is loaded: workers are forked
    os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")
    sys.path.insert(0, str(Path(__file__).resolve().parents[2]))
    runpy.run_module("tools.attack.command", run_name="__main__", alter_sys=True)
