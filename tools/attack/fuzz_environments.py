"""Damage real environment files in many ways and read them: no crash, no hang, no flood of memory.

    python tools/attack/fuzz_environments.py [--mutations 10000] [--seed 0] [--kinds] FILE...

Each mutation is read as ``brdf-suite render`` reads it, into a latitude-longitude map. What may come out: radiance
that is finite and not negative, or a FileError. Each reading has 5 s and 1 GiB of memory beyond what is in use;
readings happen in child processes, so that a crash or an endless loop within a library is seen as what it is.
``--kinds`` adds files of kinds that are rare: tiled, of several parts, luminance and chroma, a cube map, one channel,
and the description of a studio.
"""

from __future__ import annotations

import importlib.util
import multiprocessing
import os
import random
import resource
import signal
import sys
import tempfile
import time
import warnings
from collections import Counter
from pathlib import Path
from typing import Any

import numpy as np
from fuzz_measured import mutate, options, reported

from brdf_suite.documents.studio import (
    STUDIO_ENDING,
    Backdrop,
    Sky,
    Studio,
    StudioLamp,
    load_light,
    save_light,
)
from brdf_suite.errors import FileError
from brdf_suite.lighting.procedural import sky, studio
from brdf_suite.pipeline.environments import read_environment

SECONDS = 5.0
MEMORY = 1 << 30
# The OpenEXR library does not give back the strip that it was decoding when it fails: a megabyte or so for each
# damaged file. A child that has seen many is replaced, so that what is limited is one reading.
READINGS_PER_CHILD = 250


def outcome(path: Path) -> str:
    """Read a file; return ``read`` or ``refused``, or what went wrong, beginning with ``FAULT``."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            radiance = _radiance(path)
    except FileError as error:
        # A message that a user can read is short and of printable characters.
        text = str(error)
        return "refused" if len(text) < 700 and text.isprintable() else f"FAULT: message {text!r}"
    except MemoryError:
        return "FAULT: too much memory"
    except (Exception, RecursionError) as error:  # noqa: BLE001 - finding these is what this program is for
        return f"FAULT: {type(error).__name__}: {error}"
    return "read" if np.isfinite(radiance).all() and float(radiance.min()) >= 0.0 else "FAULT: no radiance"


def _radiance(path: Path) -> np.ndarray:
    if path.suffix != STUDIO_ENDING:
        return read_environment(path).radiance
    # At its size of 1,024 × 512 the drawing of ten thousand would take a day.
    light = load_light(path)
    made = sky(light, height=8, samples=1) if isinstance(light, Sky) else studio(light, height=8, samples=1)
    return made.radiance


def _child(path: Path, seed: int, first: int, last: int, pipe: Any) -> None:
    """Read mutations ``first`` … ``last`` - 1 and report each outcome through the pipe."""
    content = path.read_bytes()
    _radiance(path)  # imports, caches and threads are not what is limited
    silent = os.open(os.devnull, os.O_WRONLY)
    for stream in (1, 2):
        os.dup2(silent, stream)  # what a library says about damage; outcomes come through the pipe
    used = int(Path("/proc/self/statm").read_text().split()[0]) * resource.getpagesize()
    resource.setrlimit(resource.RLIMIT_AS, (used + MEMORY, resource.RLIM_INFINITY))
    folder = "/dev/shm" if Path("/dev/shm").is_dir() else None
    with tempfile.TemporaryDirectory(dir=folder) as scratch:
        damaged = Path(scratch) / f"damaged{path.suffix}"
        for index in range(first, last):
            damaged.write_bytes(mutated(content, path.name, seed, index))
            start = time.perf_counter()
            result = outcome(damaged)
            peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
            pipe.send((index, result, time.perf_counter() - start, peak))
    pipe.send(None)


def mutated(content: bytes, name: str, seed: int, index: int) -> bytes:
    """Return one mutation, the same each time."""
    return mutate(content, random.Random(f"{seed} {name} {index}"))


def fuzz(
    path: Path, mutations: int, seed: int, keep: Path | None = None
) -> tuple[Counter[str], float, float]:
    """Return the outcomes of all mutations of one file, the longest reading in seconds and the peak memory in MB."""
    counts: Counter[str] = Counter()
    longest, peak, first = 0.0, 0, 0
    while first < mutations:
        last = min(first + READINGS_PER_CHILD, mutations)
        receive, send = multiprocessing.Pipe(duplex=False)
        child = multiprocessing.Process(target=_child, args=(path, seed, first, last, send))
        child.start()
        send.close()
        fault = ""
        while True:
            try:
                # Four times the limit: the machine may be busy, and each reading reports its own time.
                message = receive.recv() if receive.poll(4.0 * SECONDS) else "hang"
            except EOFError:
                child.join()
                fault = f"FAULT: the process died ({_ending(child.exitcode)})"
                break
            if message is None:
                child.join()
                first = last
                break
            if message == "hang":
                child.kill()
                child.join()
                fault = f"FAULT: over {4.0 * SECONDS} s"
                break
            index, result, seconds, used = message
            longest, peak, first = max(longest, seconds), max(peak, used), index + 1
            if seconds > SECONDS:
                result = f"FAULT: over {SECONDS} s"
            counts[result] += 1
            if result.startswith("FAULT"):
                _keep(keep, path, seed, index)
        if fault:
            counts[fault] += 1
            _keep(keep, path, seed, first)
            first += 1
    return counts, longest, peak / 1024.0


def _ending(code: int | None) -> str:
    return signal.Signals(-code).name if code is not None and code < 0 else f"status {code}"


def _keep(folder: Path | None, path: Path, seed: int, index: int) -> None:
    if folder is not None:
        folder.mkdir(parents=True, exist_ok=True)
        damaged = mutated(path.read_bytes(), path.name, seed, index)
        (folder / f"{path.stem}-{seed}-{index}{path.suffix}").write_bytes(damaged)


def rare_kinds(folder: Path) -> list[Path]:
    """Write small files of rare kinds and return them; the last is a studio's description."""
    import OpenEXR

    rng = np.random.default_rng(1)
    shape = (32, 64)
    light = {name: (4.0 * rng.random(shape)).astype(np.float32) for name in "RGB"}
    lines = {"compression": OpenEXR.ZIP_COMPRESSION, "type": OpenEXR.scanlineimage}
    tiles = {"compression": OpenEXR.PIZ_COMPRESSION, "type": OpenEXR.tiledimage}
    tiles["tiles"] = OpenEXR.TileDescription()
    written: dict[str, Any] = {
        "tiled": OpenEXR.File(tiles, dict(light)),
        "one_channel": OpenEXR.File(dict(lines), {"Y": light["R"]}),
        "half_b44": OpenEXR.File(
            {**lines, "compression": OpenEXR.B44_COMPRESSION},
            {name: plane.astype(np.float16) for name, plane in light.items()},
        ),
        "dwaa": OpenEXR.File({**lines, "compression": OpenEXR.DWAA_COMPRESSION}, dict(light)),
        "cube": OpenEXR.File(
            {**lines, "envmap": OpenEXR.ENVMAP_CUBE},
            {name: (4.0 * rng.random((96, 16))).astype(np.float32) for name in "RGB"},
        ),
        "parts": OpenEXR.File(
            [
                OpenEXR.Part(dict(lines), {"Z": light["R"]}, name="depth"),
                OpenEXR.Part(dict(tiles), dict(light), name="beauty"),
            ]
        ),
    }
    for name, file in written.items():
        file.write(str(folder / f"{name}.exr"))
    colour = np.stack([light[name] + 0.5 for name in "RGB"], axis=2)
    chroma = _chroma_writer()(folder / "chroma.exr", colour)
    return [*(folder / f"{name}.exr" for name in written), chroma, *_described(folder)]


def _chroma_writer() -> Any:
    """Return the writer of luminance and chroma, which the library does not write, from the tests of the reader."""
    path = Path(__file__).parents[2] / "tests" / "files" / "images" / "test_exr_kinds.py"
    spec = importlib.util.spec_from_file_location("test_images_kinds", path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module.chroma_file


def _described(folder: Path) -> list[Path]:
    """Write a studio whose drawing takes a moment only, as text; its reader is what is fuzzed, and its drawing."""
    lamp = StudioLamp("ring", (0.0, 2.0, 1.0), (1.0, 0.2), colour_temperature_k=3000.0)
    save_light(Studio("small", (lamp,), backdrop=Backdrop(0.1)), folder / "ring.brdfstudio")
    return [folder / "ring.brdfstudio"]


def main() -> int:
    """Damage the files that the arguments name, and print the faults."""
    parser = options(__doc__, "*")
    parser.add_argument("--kinds", action="store_true", help="files of rare kinds, too")
    arguments = parser.parse_args()
    faults = 0
    with tempfile.TemporaryDirectory() as made:
        rare = rare_kinds(Path(made)) if arguments.kinds else []
        for path in [*arguments.files, *rare]:
            counts, longest, peak = fuzz(path, arguments.mutations, arguments.seed, arguments.keep)
            print(
                f"{path.name}: {arguments.mutations} mutations: {counts['read']} read, {counts['refused']} refused;"
                f" the longest took {longest:.2f} s; peak {peak:,.0f} MB",
                flush=True,
            )
            faults += reported(counts)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
