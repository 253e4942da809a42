"""Text of Cornell's light measurement laboratory: spectra at scattered directions.

Comments begin with ``#``. Then the number of wavelengths, the wavelengths in nanometres (over several lines if
need be), and one row per sample: θi φi θs φs in radians and one f_r (1/sr) per wavelength. Both directions
point away from the surface, so the mirror lies at φs = φi + π.
"""

from __future__ import annotations

import numpy as np

from brdf_suite.documents.atomic import write_atomically
from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.bounded_reading import MOST_BANDS, number_in, numbered_lines
from brdf_suite.files.measured.format import MeasuredFormat, ReadOptions
from brdf_suite.files.measured.goniometer_rows import (
    SampleRows,
    angles,
    as_samples,
    check_bands,
    columns,
    directions,
    one_azimuth,
    one_line,
    samples,
    sampling_notes,
)
from brdf_suite.reflectance.protocol import Reflectance
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples

_LARGEST = 256 << 20
_MOST_COMMENTS = 20


def read_cornell(path: PathLike, options: ReadOptions | None = None) -> ScatteredSamples:
    """Return the spectra of a Cornell file; raise :class:`FileError` with the line of the first fault."""
    count = 0
    bands: list[float] = []
    comments: list[str] = []
    rows: SampleRows | None = None
    wavelengths = np.empty(0)
    number = 0
    for number, text in numbered_lines(path, _LARGEST):
        if text.lstrip().startswith("#"):
            if rows is None and len(comments) < _MOST_COMMENTS:
                comments.append(text.lstrip("# \t").strip())
            continue
        words = text.split()
        if not words:
            continue
        if not count:
            count = _count(path, words, number)
        elif rows is None:
            bands += [number_in(path, word, number, "a wavelength") for word in words]
            if len(bands) > count:
                reason = f"{len(bands)} wavelengths are named where {count} were announced"
                raise FileError(path, reason, f"line {number}")
            if len(bands) == count:
                wavelengths = check_bands(path, bands, f"line {number}")
                rows = SampleRows(path, 4 + count)
        else:
            if len(words) != rows.width:
                reason = f"expected {rows.width} numbers (four angles, {count} values), not {len(words)}"
                raise FileError(path, reason, f"line {number}")
            rows.add([number_in(path, word, number, "an angle or a value") for word in words], number)
    if rows is None:
        raise FileError(path, "the file ends before the first sample", f"line {number}")
    table = rows.table
    # The title: the lines before the first blank comment or the counts.
    title = [line for line in comments if line and not line.startswith(("num wls", "wls", "theta"))]
    return samples(
        rows,
        directions(rows, table[:, 0], table[:, 1]),
        directions(rows, table[:, 2], table[:, 3]),
        spectra=table[:, 4:],
        wavelengths_nm=wavelengths,
        isotropic=not len(table) or one_azimuth(table[:, 1]),
        observer_deg=(options or ReadOptions()).observer_deg,
        facts={"format": "Cornell text", "name": "; ".join(title)[:500]},
    )


def _count(path: PathLike, words: list[str], number: int) -> int:
    if len(words) != 1 or not words[0].isascii() or not words[0].isdigit() or len(words[0]) > 6:
        raise FileError(path, "expected the number of wavelengths, alone on its line", f"line {number}")
    count = int(words[0])
    if not 1 <= count <= MOST_BANDS:
        raise FileError(path, f"{count} wavelengths; expected 1 to {MOST_BANDS}", f"line {number}")
    return count


def write_cornell(value: Reflectance, path: PathLike) -> tuple[str, ...]:
    """Write spectral samples, and return notes for the user; numbers are written so that they read back unchanged.

    Raises :class:`FileError`: the value holds colours only, or the file cannot be written.
    """
    scattered = as_samples(value)
    if scattered.spectra is None or scattered.wavelengths_nm is None:
        raise FileError(path, "this format holds spectra, and the reflectance has colours only")
    theta_i, phi_i = angles(scattered.wi)
    theta_s, phi_s = angles(scattered.wo)
    table = np.column_stack((theta_i, phi_i, theta_s, phi_s, scattered.spectra))
    wavelengths = columns([scattered.wavelengths_nm], " ")
    name = one_line(scattered.facts.get("name", "")) or "BRDF"
    header = (
        f"# {name}\n\n# num wls\n{len(scattered.wavelengths_nm)}\n\n# wls\n{wavelengths}\n"
        "# theta i  phi i  theta s  phi_s  spectral sample values\n\n"
    )
    write_atomically(path, (header + columns(table, " ")).encode())
    return sampling_notes(value, scattered)


def _looks(head: bytes, _size: int) -> bool:
    lines = [line.split() for line in head.split(b"\n")[:200] if not line.lstrip().startswith(b"#")]
    lines = [words for words in lines if words]
    if len(lines) < 2 or len(lines[0]) != 1 or not lines[0][0].isdigit():
        return False
    first = lines[1][0]
    return first.replace(b".", b"", 1).isdigit() and b"\0" not in head[:1024]


FORMAT = MeasuredFormat(
    name="cornell",
    title="Cornell text (spectral, scattered)",
    endings=(".brdf",),
    sniff=_looks,
    read=read_cornell,
    write=write_cornell,
)
