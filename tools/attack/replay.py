"""Files that once made a fault, read again: ``FOLDER/group-kind/FILE``, or a folder with a file and its companions."""

from __future__ import annotations

import shutil
import tempfile
from pathlib import Path

from tools.attack.loop import Loop
from tools.attack.readers import READERS
from tools.attack.seeds import StoredSeed


def replay(folder: Path) -> list[str]:
    """Read every kept file in workers with the usual limits; return the faults, and folders of no reader.

    A folder with companions is named after its main file, with a dash and a number: ``made.gltf-17/made.gltf``.
    """
    readers = {reader.name.replace(":", "-"): reader for reader in READERS}
    faults: list[str] = []
    with tempfile.TemporaryDirectory(prefix="attack-") as scratch:
        seeds = []
        for own in sorted(path for path in folder.iterdir() if path.is_dir()):
            if own.name not in readers:
                faults.append(f"{own.name} is no reader")
                continue
            for number, case in enumerate(sorted(own.iterdir())):
                target = Path(scratch) / own.name / str(number)
                if case.is_dir():
                    shutil.copytree(case, target)
                    name = case.name.rpartition("-")[0] or case.name
                else:
                    target.mkdir(parents=True)
                    shutil.copy(case, target)
                    name = case.name
                seeds.append(StoredSeed(readers[own.name], target / name, label=f"{own.name}/{case.name}"))
        if not seeds:
            return [*faults, f"{folder} holds no kept file"]
        loop = Loop(seeds, 0, 1)
        loop.run()
        for name, tally in loop.tallies.items():
            faults += [f"{name}: {fault}" for fault in tally.faults]
    return faults
