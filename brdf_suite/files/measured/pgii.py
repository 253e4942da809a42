"""Text of the pgII gonioreflectometer (pab): ``#`` headers, then rows ``theta phi value``, in degrees.

One file holds one incident direction, named by ``#incident_angle θ φ`` or ``#intheta`` and ``#inphi``.
``#format: theta phi BSDF`` says that the values are f_r; ``DSF`` means f_r times the cosine of the view. Both
directions point away from the surface. Rows with θ over 90° are transmission.
"""

from __future__ import annotations

import math

import numpy as np

from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.bounded_reading import number_in, numbered_lines
from brdf_suite.files.measured.format import MeasuredFormat, ReadOptions
from brdf_suite.files.measured.goniometer_rows import SampleRows, directions, rgb_values, samples
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples

_LARGEST = 256 << 20

# A value that holds the view's cosine says nothing closer to the horizon than this.
_LEAST_COSINE = 1e-3


def read_pgii(path: PathLike, options: ReadOptions | None = None) -> ScatteredSamples:
    """Return the reflected samples of a pgII file, grey, isotropic.

    Raises
    ------
    FileError
        With the line of the first fault; the incident direction or the kind of value is not named.
    """
    theta_i: float | None = None
    phi_i = 0.0
    kind, name = "", ""
    rows = SampleRows(path, 3)
    transmitted = 0
    number = 0
    for number, text in numbered_lines(path, _LARGEST):
        line = text.strip()
        if not line:
            continue
        if line.startswith("#"):
            key, _, rest = line[1:].strip().partition(" ")
            words = rest.split()
            if key == "incident_angle" and len(words) >= 2:
                theta_i = number_in(path, words[0], number, "the incident angle")
                phi_i = number_in(path, words[1], number, "the incident azimuth")
            elif key == "intheta" and words:
                theta_i = number_in(path, words[0], number, "the incident angle")
            elif key == "inphi" and words:
                phi_i = number_in(path, words[0], number, "the incident azimuth")
            elif key == "format:" and words[:2] == ["theta", "phi"] and len(words) == 3:
                kind = words[2].upper()
            elif key == "sample_name":
                name = rest.strip().strip('"')[:500]
            continue
        words = line.split()
        if len(words) != 3:
            raise FileError(
                path, f"expected theta, phi and one value, not {len(words)} numbers", f"line {number}"
            )
        row = [number_in(path, word, number, "an angle or a value") for word in words]
        if 90.0 < abs(row[0]) <= 180.0:
            transmitted += 1
        else:
            rows.add(row, number)
    if theta_i is None:
        raise FileError(path, "no header names the incident angle", "the lines that begin with #")
    if kind not in {"BSDF", "BRDF", "DSF"}:
        found = f"#format names {kind[:20]}" if kind else "no header names the format"
        raise FileError(path, f"{found}; expected theta phi BSDF or DSF", "the lines that begin with #")
    table = rows.table
    n = len(table)
    # An incident angle over 90° is lit from the other side, and then everything here is transmission.
    wi = directions(rows, np.full(n, math.radians(theta_i)), np.full(n, math.radians(phi_i)))
    wo = directions(rows, np.radians(table[:, 0]), np.radians(table[:, 1]))
    values = table[:, 2:]
    if kind == "DSF":
        with np.errstate(over="ignore"):  # what becomes infinite is refused with all other values
            values = values / np.maximum(wo[:, 2:], _LEAST_COSINE)
    facts: dict[str, object] = {"format": "pgII text", "name": name, "colour": "grey"}
    facts["incidence"] = f"{theta_i:g}°"
    if transmitted:
        facts["transmitted rows left out"] = transmitted
    return samples(
        rows,
        wi,
        wo,
        rgb=rgb_values(values, "grey"),
        isotropic=True,
        observer_deg=(options or ReadOptions()).observer_deg,
        facts=facts,
    )


FORMAT = MeasuredFormat(
    name="pgii",
    title="pgII gonioreflectometer text",
    endings=(".dat", ".txt"),
    sniff=lambda head, _size: (
        head.startswith(b"#")
        and any(key in head for key in (b"#format: theta phi", b"#intheta", b"#incident_angle"))
    ),
    read=read_pgii,
)
