"""Writing of a simulated session as a regular session folder, with the ground truth beside it."""

from __future__ import annotations

import struct
import zlib
from collections.abc import Iterator
from fractions import Fraction
from pathlib import Path

import numpy as np
from PIL.Image import Exif
from PIL.TiffImagePlugin import IFDRational
from tifffile import imwrite

from brdf_suite.acquisition.session.session import SESSION_FILE, Session
from brdf_suite.acquisition.session.store import write_session
from brdf_suite.acquisition.simulator.rig import TRUTH_FILE, Simulator
from brdf_suite.acquisition.simulator.settings import SimulatorSettings
from brdf_suite.arrays import Codes
from brdf_suite.documents.atomic import encode, make_folder, write_atomically
from brdf_suite.errors import FileError, PathLike
from brdf_suite.progress import Progress, report
from brdf_suite.reflectance.protocol import Reflectance

_EXPOSURE_TIME, _EXIF_FOLDER = 0x829A, 0x8769
_RATIONAL = 5


def simulate(
    reflectance: Reflectance,
    folder: PathLike,
    settings: SimulatorSettings | None = None,
    name: str = "paint",
    progress: Progress | None = None,
) -> Session:
    """Photograph a sphere and write session, photographs and ``truth.json`` into a new or empty folder.

    ``session.json`` comes last: a folder without one was not finished.

    Raises
    ------
    FileError
        The folder holds something, or cannot be written.
    """
    target = Path(folder)
    make_empty_folder(target)
    rig = Simulator(reflectance, settings, name)
    session = rig.session
    done, total = 0, len(session.files())
    for files, exposures_s, codes in _series(rig):
        for file, seconds, picture in zip(files, exposures_s, codes, strict=True):
            report(progress, done / total, f"photograph {done + 1:,} of {total:,}")
            path = target / file
            make_folder(path.parent)
            write_photograph(path, picture, seconds)
            done += 1
    write_atomically(target / TRUTH_FILE, encode(rig.truth))
    write_session(session, target)
    report(progress, 1.0, "written")
    return session


def make_empty_folder(folder: Path) -> None:
    """Make the folder where there is none; refuse one that holds anything."""
    make_folder(folder)
    try:
        occupied = any(folder.iterdir())
    except OSError as error:
        raise FileError(folder, f"cannot be read: {error.strerror or error}") from error
    if occupied:
        raise FileError(folder, f"is not empty; name a new folder for the photographs and {SESSION_FILE}")


def _series(rig: Simulator) -> Iterator[tuple[tuple[str, ...], tuple[float, ...], Codes]]:
    """Yield the names, times and codes (e, h, w, 3) of each series, made one after the other."""
    session = rig.session
    if session.dark:
        yield session.dark, session.exposures_s, rig.dark()
    if session.white is not None:
        yield session.white.photographs, session.exposures_s, rig.white()
    if session.flat_field is not None:
        yield session.flat_field.photographs, session.flat_field.exposures_s, rig.flat_field()
    if session.camera.board is not None:
        for i, file in enumerate(session.camera.board.photographs):
            yield (file,), (1.0,), rig.board(i)[None]
    for k, position in enumerate(session.positions):
        yield position.photographs, session.exposures_s, rig.position(k)


def write_photograph(path: PathLike, codes: Codes, exposure_s: float) -> None:
    """Write codes (h, w, 3), uint8 or uint16, as a camera's software does: as PNG or, with the ending ``.tif``, TIFF.

    The files are quick to write, not small: photographs are noise to a packer.
    """
    target = Path(path)
    try:
        # Not forced to the disk: thousands of files, and the session that makes them count comes last.
        if target.suffix == ".tif":
            _write_tiff(target, codes, exposure_s)
        else:
            target.write_bytes(_png(codes, exposure_s))
    except OSError as error:
        raise FileError(path, f"cannot be written ({error.strerror or error})") from error


def _png(codes: Codes, exposure_s: float) -> bytes:
    height, width, _ = codes.shape
    big = np.ascontiguousarray(codes.astype(codes.dtype.newbyteorder(">")))
    rows = big.view(np.uint8).reshape(height, -1)
    packed = zlib.compress(np.pad(rows, ((0, 0), (1, 0))).tobytes(), 1)
    header = struct.pack(">IIBBBBB", width, height, 8 * codes.itemsize, 2, 0, 0, 0)
    chunks = [(b"IHDR", header), (b"eXIf", exif(exposure_s)), (b"IDAT", packed), (b"IEND", b"")]
    return b"\x89PNG\r\n\x1a\n" + b"".join(
        struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
        for kind, data in chunks
    )


def exif(exposure_s: float) -> bytes:
    """Return the EXIF block (a TIFF of no picture) that holds an exposure time."""
    block = Exif()
    block[_EXIF_FOLDER] = {_EXPOSURE_TIME: IFDRational(*_fraction(exposure_s))}
    return block.tobytes().removeprefix(b"Exif\0\0")


def _fraction(seconds: float) -> tuple[int, int]:
    return Fraction(seconds).limit_denominator(10_000_000).as_integer_ratio()


def _write_tiff(target: Path, codes: Codes, exposure_s: float) -> None:
    # The time stands beside the picture's size, as TIFF/EP has it, since tifffile writes no EXIF folder.
    time = (_EXPOSURE_TIME, _RATIONAL, 1, _fraction(exposure_s), True)
    imwrite(target, codes, photometric="rgb", metadata=None, software=False, extratags=[time])
