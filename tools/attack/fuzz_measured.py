"""Damage real files of measured reflectance in many ways and read them: no crash, no hang, no flood of memory.

    python tools/attack/fuzz_measured.py [--mutations 10000] [--seed 0] FILE...

Each mutation of each file is read twice, through the registry and by the reader of the undamaged file's format,
and where it is accepted, evaluated. What may come out: a reflectance that is finite and not negative, or a
FileError that names a place. Each reading has 2 s and 4 times the file plus 200 MB of memory.
"""

from __future__ import annotations

import argparse
import contextlib
import hashlib
import random
import resource
import signal
import struct
import sys
import tempfile
import time
import warnings
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from types import FrameType

import numpy as np

from brdf_suite.errors import FileError
from brdf_suite.files.measured import read_measured, sniff
from brdf_suite.files.measured.format import MeasuredFormat, ReadOptions
from brdf_suite.geometry.directions import spherical

SECONDS = 2.0
MEMORY_PER_BYTE, MEMORY = 4, 200 << 20

_WORDS = [
    b"nan", b"-inf", b"1e999", b"-1", b"0", b"1e-320", b"9" * 40, b"1_0", b"0x10", b"", b"\xff\xfe", b"\0",
    b"#", b"\n", b"\r", b",", b"{", b"[" * 3000, b"true", b"null", b'"', b"1.5708", b"-3.2", b"99999999",
]  # fmt: skip
_INTEGERS = [0, 1, 2, 0x7F, 0xFF, 0xFFFF, 0x7FFFFFFF, 0xFFFFFFFF, 1 << 33, (1 << 63) - 1, (1 << 64) - 1]
_FLOATS = [np.nan, np.inf, -np.inf, -1.0, 0.0, 3e38, 1e-45, 1e30]


class TooLong(BaseException):
    """Raised into a reader by the alarm; no ``except Exception`` of a reader may catch it."""


def mutate(content: bytes, random_: random.Random) -> bytes:
    """Return ``content`` with one to four kinds of damage."""
    data = bytearray(content)
    for _ in range(random_.choice((1, 1, 1, 2, 4))):
        if not data:
            break
        # Headers are where formats break, so half of the damage goes to the first part.
        reach = len(data) if random_.random() < 0.5 else min(len(data), 2600)
        at = random_.randrange(reach)
        kind = random_.randrange(10)
        if kind == 0:
            data[at] ^= 1 << random_.randrange(8)
        elif kind == 1:
            data[at] = random_.randrange(256)
        elif kind == 2:
            del data[at:]
        elif kind == 3:
            del data[at : at + random_.choice((1, 2, 4, 8, 100))]
        elif kind == 4:
            data[at:at] = data[at : at + random_.choice((1, 8, 100, 2000))]
        elif kind == 5:
            word = random_.choice(_WORDS)
            data[at : at + random_.choice((0, 1, len(word)))] = word
        elif kind == 6:
            number = random_.choice(_INTEGERS)
            width = random_.choice((2, 4, 8))
            data[at : at + width] = struct.pack("<Q", number)[:width]
        elif kind == 7:
            aligned = at - at % 4
            data[aligned : aligned + 4] = struct.pack("<f", random_.choice(_FLOATS))
        elif kind == 8:
            # A whole word of a text replaced, so that numbers become other numbers.
            end = min((data.find(mark, at) for mark in (b" ", b",", b"\n", b"\t")), default=-1)
            data[at : end if end > at else at + 1] = random_.choice(_WORDS)
        else:
            other = random_.randrange(len(data))
            data[at : at + 16] = data[other : other + 16]
    return restamped(bytes(data)) if random_.random() < 0.8 else bytes(data)


def restamped(data: bytes) -> bytes:
    """Return a damaged ``.brdftable`` with its checksum made right, so that what lies behind the checksum is reached.

    Other content is returned as it is.
    """
    if not data.startswith(b"BRDFTABL") or len(data) < 48:
        return data
    return data[:16] + hashlib.sha256(data[48:]).digest() + data[48:]


@contextlib.contextmanager
def limits(size: int) -> Iterator[None]:
    """Give the block :data:`SECONDS` and the memory that a file of ``size`` bytes may take beyond what is in use."""

    def ring(_number: int, _frame: FrameType | None) -> None:
        raise TooLong

    with Path("/proc/self/statm").open() as statm:
        used = int(statm.read().split()[0]) * resource.getpagesize()
    _, most = resource.getrlimit(resource.RLIMIT_AS)
    resource.setrlimit(resource.RLIMIT_AS, (used + MEMORY_PER_BYTE * size + MEMORY, most))
    before = signal.signal(signal.SIGALRM, ring)
    signal.setitimer(signal.ITIMER_REAL, SECONDS)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, before)
        resource.setrlimit(resource.RLIMIT_AS, (resource.RLIM_INFINITY, most))


def directions() -> tuple[np.ndarray, np.ndarray]:
    """A few pairs (n, 3), the mirror, grazing ones and one below the horizon among them."""
    theta_i = np.array([0.0, 0.8, 0.8, 1.5, 1.57, 0.3, 0.8])
    theta_o = np.array([0.0, 0.8, 0.3, 1.5, 0.2, 1.2, 2.0])
    phi = np.array([0.0, np.pi, 1.0, np.pi, 2.0, 4.0, 1.0])
    return spherical(theta_i, 0.3 * phi), spherical(theta_o, phi)


def outcome(path: Path, reader: MeasuredFormat | None) -> str:
    """Read and evaluate; return ``read`` or ``refused``, or what went wrong, beginning with ``FAULT``."""
    size = path.stat().st_size
    try:
        with limits(size), warnings.catch_warnings():
            warnings.simplefilter("error")
            value = read_measured(path) if reader is None else reader.read(path, ReadOptions())
            found = value.eval(*directions())
    except FileError as error:
        # An empty file has no place; nor has one that cannot hold the format at all.
        return "refused" if error.place else f"FAULT: no place in {error}"
    except TooLong:
        return f"FAULT: over {SECONDS} s"
    except MemoryError:
        return "FAULT: too much memory"
    except (Exception, RecursionError) as error:  # noqa: BLE001 - finding these is what this program is for
        return f"FAULT: {type(error).__name__}: {error}"
    if not np.isfinite(found).all() or (found < 0.0).any():
        return "FAULT: values that are no reflectance"
    return "read"


def fuzz(path: Path, mutations: int, seed: int, keep: Path | None = None) -> tuple[Counter[str], float]:
    """Return the outcomes of all mutations of one file, and the longest reading in seconds.

    Faulty files are kept in ``keep``.
    """
    content, own = path.read_bytes(), sniff(path)
    counts: Counter[str] = Counter()
    longest = 0.0
    # Imports, caches and the threads of linear algebra are not what is limited.
    read_measured(path).eval(*directions())
    folder = "/dev/shm" if Path("/dev/shm").is_dir() else None
    with tempfile.TemporaryDirectory(dir=folder) as scratch:
        damaged = Path(scratch) / f"damaged{path.suffix}"
        for index in range(mutations):
            damaged.write_bytes(mutate(content, random.Random(f"{seed} {path.name} {index}")))
            for reader in (None, own):
                start = time.perf_counter()
                result = outcome(damaged, reader)
                longest = max(longest, time.perf_counter() - start)
                counts[result] += 1
                if result.startswith("FAULT") and keep is not None:
                    keep.mkdir(parents=True, exist_ok=True)
                    (keep / f"{path.stem}-{seed}-{index}{path.suffix}").write_bytes(damaged.read_bytes())
    return counts, longest


def options(description: str | None, how_many: str) -> argparse.ArgumentParser:
    """Return the options of a program that damages files; ``how_many`` files as argparse counts them."""
    parser = argparse.ArgumentParser(
        description=description, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("files", nargs=how_many, type=Path)
    parser.add_argument("--mutations", type=int, default=10_000)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--keep", type=Path, help="folder for the files that made a fault")
    return parser


def reported(counts: Counter[str]) -> int:
    """Print the faults among the outcomes, and return how many there are."""
    faults = {result: count for result, count in counts.items() if result.startswith("FAULT")}
    for result, count in faults.items():
        print(f"  {count} x {result}", flush=True)
    return sum(faults.values())


def main() -> int:
    """Damage the files that the arguments name, and print the faults."""
    arguments = options(__doc__, "+").parse_args()
    faults = 0
    for path in arguments.files:
        counts, longest = fuzz(path, arguments.mutations, arguments.seed, arguments.keep)
        print(
            f"{path.name}: {arguments.mutations} mutations, each read twice: {counts['read']} read,"
            f" {counts['refused']} refused; the longest took {longest:.2f} s",
            flush=True,
        )
        faults += reported(counts)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
