"""Damage mesh files of every format in many ways and read them: no crash, no hang, no flood of memory.

    python tools/attack/fuzz_meshes.py [--mutations 10000] [--seed 0] [--formats NAME...] [FILE...]

The files are those that the tests write, two variants of each format, and any that are named. What may come out: a mesh
that can be drawn, or a FileError. Each reading has 10 s and 2 GiB of memory beyond what is in use. Libraries of others
run here within the reading process, which is forked anew when it dies: with a user they run in a child whose death is
a refusal, so it is counted as ``died`` and is a fault only of formats that we read ourselves.
"""

from __future__ import annotations

import functools
import importlib
import importlib.util
import io
import multiprocessing
import os
import random
import resource
import signal
import sys
import tempfile
import time
import warnings
import zipfile
from collections import Counter
from pathlib import Path
from typing import Any

import numpy as np
from fuzz_measured import TooLong, mutate, options, reported

from brdf_suite.errors import FileError
from brdf_suite.files.meshes.kinds import OUTSIDE, kind_of
from brdf_suite.files.meshes.outside import child, worker
from brdf_suite.files.meshes.outside.values import ReadMesh, Refused
from brdf_suite.files.meshes.reading import read_mesh

SECONDS = 10.0
MEMORY = 2 << 30
READINGS_PER_CHILD = 500
_DIED = "died"


def run_here(path: Any, library: str, file: str, given: dict[str, Any]) -> Any:
    """Do what the child process does, in this one."""
    read = importlib.import_module(worker._READERS[library]).read
    try:
        with np.errstate(all="ignore"):
            found = read(Path(file), given)
    except Refused as refusal:
        found = ReadMesh([], refused=str(refusal))
    answer = Path(file).with_suffix(".answer")
    worker._write(answer, found)
    content = answer.read_bytes()
    answer.unlink()
    return child._unpacked(path, content)


def outcome(path: Path) -> str:
    """Read a file; return ``read`` or ``refused``, or what went wrong, beginning with ``FAULT``."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            mesh = read_mesh(path)
    except FileError as error:
        text = str(error)
        return "refused" if len(text) < 700 and text.isprintable() else f"FAULT: message {text!r}"
    except MemoryError:
        return "FAULT: too much memory"
    except TooLong:
        return f"FAULT: over {SECONDS} s"
    except Exception as error:  # noqa: BLE001 - finding these is what this program is for
        return f"FAULT: {type(error).__name__}: {error}"
    low, high = mesh.bounds()
    return "read" if np.isfinite([low, high]).all() and mesh.triangle_count else "FAULT: no mesh"


def mutated(content: bytes, name: str, seed: int, index: int) -> bytes:
    """Return one mutation, the same each time; of an archive half of them damage a file in it."""
    random_ = random.Random(f"{seed} {name} {index}")
    if content.startswith(b"PK") and index % 2:
        made = io.BytesIO()
        with zipfile.ZipFile(io.BytesIO(content)) as old, zipfile.ZipFile(made, "w") as new:
            for member in old.namelist():
                inside = old.read(member)
                new.writestr(member, mutate(inside, random_) if member == old.namelist()[-1] else inside)
        return made.getvalue()
    return mutate(content, random_)


def _child(path: Path, seed: int, first: int, last: int, pipe: Any) -> None:
    content = path.read_bytes()
    child._run = run_here  # type: ignore[assignment]
    os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
    os.dup2(os.open(os.devnull, os.O_WRONLY), 2)
    used = int(Path("/proc/self/statm").read_text().split()[0]) * resource.getpagesize()
    resource.setrlimit(resource.RLIMIT_AS, (used + MEMORY, resource.RLIM_INFINITY))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    folder = "/dev/shm" if Path("/dev/shm").is_dir() else None
    with tempfile.TemporaryDirectory(dir=folder) as scratch:
        os.chdir(scratch)
        damaged = Path(scratch) / f"damaged{path.suffix}"
        for index in range(first, last):
            damaged.write_bytes(mutated(content, path.name, seed, index))
            start = time.perf_counter()
            result = outcome(damaged)
            peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
            pipe.send((index, result, time.perf_counter() - start, peak))
    pipe.send(None)
    pipe.close()
    os._exit(0)


def fuzz(path: Path, mutations: int, seed: int, keep: Path | None) -> tuple[Counter[str], float, float]:
    """Return the outcomes of all mutations of one file, the longest reading in seconds and the peak memory in MB."""
    counts: Counter[str] = Counter()
    longest, peak, first = 0.0, 0, 0
    outside = kind_of(path, path.read_bytes()) in OUTSIDE or "draco" in path.name
    while first < mutations:
        last = min(first + READINGS_PER_CHILD, mutations)
        receive, send = multiprocessing.Pipe(duplex=False)
        process = multiprocessing.Process(target=_child, args=(path, seed, first, last, send))
        process.start()
        send.close()
        fault = ""
        while True:
            try:
                message = receive.recv() if receive.poll(4.0 * SECONDS) else "hang"
            except EOFError:
                process.join()
                code = process.exitcode or 0
                how = signal.Signals(-code).name if code < 0 else f"status {code}"
                fault = _DIED if outside else f"FAULT: the process died ({how})"
                break
            if message is None:
                first = last
                process.join()
                break
            if message == "hang":
                process.kill()
                process.join()
                fault = "too long" if outside else f"FAULT: over {4.0 * SECONDS} s"
                break
            index, result, seconds, used = message
            longest, peak, first = max(longest, seconds), max(peak, used), index + 1
            if seconds > SECONDS and not outside:
                result = f"FAULT: over {SECONDS} s"
            counts[result] += 1
            if result.startswith("FAULT"):
                _keep(keep, path, seed, index)
        if fault:
            counts[fault] += 1
            _keep(keep, path, seed, first)
            first += 1
    return counts, longest, peak / 1024.0


def _keep(folder: Path | None, path: Path, seed: int, index: int) -> None:
    if folder is not None:
        folder.mkdir(parents=True, exist_ok=True)
        damaged = mutated(path.read_bytes(), path.name, seed, index)
        (folder / f"{path.stem}-{seed}-{index}{path.suffix}").write_bytes(damaged)


@functools.cache
def writers() -> Any:
    """Return the tests' writers of meshes."""
    path = Path(__file__).parents[2] / "tests" / "mesh_writers.py"
    spec = importlib.util.spec_from_file_location("mesh_writers", path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    sys.modules["mesh_writers"] = module
    spec.loader.exec_module(module)
    return module


def written(folder: Path, formats: list[str]) -> list[Path]:
    """Write two variants of each format and return them, small ones: damage is to reach every part of a file."""
    files = []
    for name in formats:
        for number in (1, 6):
            own = folder / f"{name}{number}"
            own.mkdir()
            made = writers().VARIANTS[name](number, own).path
            files.append(made.rename(own / f"{name}{number}{made.suffix}"))
    return files


def main() -> int:
    """Damage the files, and print the faults."""
    parser = options(__doc__, "*")
    parser.add_argument("--formats", nargs="*", help="of the tests' formats (default: all)")
    arguments = parser.parse_args()
    faults = 0
    with tempfile.TemporaryDirectory() as made:
        chosen = arguments.formats if arguments.formats is not None else [*writers().VARIANTS]
        for path in [*arguments.files, *written(Path(made), chosen)]:
            # Imports are not what is limited.
            importlib.import_module("scipy.sparse.csgraph")
            read_mesh(path)
            kind = kind_of(path, path.read_bytes())
            if kind in OUTSIDE or "draco" in path.name:
                importlib.import_module(worker._READERS[OUTSIDE.get(kind, "draco")])
            counts, longest, peak = fuzz(path, arguments.mutations, arguments.seed, arguments.keep)
            deaths = counts.pop(_DIED, 0) + counts.pop("too long", 0)
            print(
                f"{path.name}: {arguments.mutations} mutations: {counts['read']} read, {counts['refused']} refused,"
                f" {deaths} died; the longest took {longest:.2f} s; peak {peak:,.0f} MB",
                flush=True,
            )
            faults += reported(counts)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
