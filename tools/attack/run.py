"""The standing attack on the suite: damaged files, kills, wrong command lines, hostile surroundings; one table.

    python tools/attack/run.py [--minutes 2] [--json]                 a slice of everything
    python tools/attack/run.py --inputs 20000 --results long.json     the long run; call it again to go on
    python tools/attack/run.py --only mesh:glb palette --keep FOLDER  some readers, faulty files kept
    python tools/attack/run.py --check                                every reader has seeds that it reads

Progress and faults go to standard error as they are met. Status 1 where a figure is over its bound.
"""

from __future__ import annotations

import os

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # before numpy is loaded: workers are forked
os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

import argparse
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2]))

from tools.attack.loop import Loop, Seed, seeds_of
from tools.attack.readers import chosen
