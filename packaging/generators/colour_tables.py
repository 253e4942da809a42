"""Write ``resources/colour/cie.csv``: the CIE observers and illuminants that spectra are weighted with.

Run in a development environment (it needs colour-science, which the suite itself does not)::

    python packaging/generators/colour_tables.py [FILE]

One row for each nanometre from 360 to 780. The observers are tabulated at 1 nm by the CIE (ISO/CIE 11664-1). The
illuminants are tabulated at 5 nm and joined by straight lines, as the CIE does for D65 (ISO/CIE 11664-2);
outside of its table (those of lamps begin at 380 nm) an illuminant is 0.
"""

from __future__ import annotations

import sys
import warnings
from pathlib import Path

import numpy as np

FIRST_NM, LAST_NM = 360, 780
OBSERVERS = (
    ("2", "CIE 1931 2 Degree Standard Observer"),
    ("10", "CIE 1964 10 Degree Standard Observer"),
)
ILLUMINANTS = (
    ("D65", "D65"),
    ("A", "A"),
    ("F11", "FL11"),
    ("D50", "D50"),
    ("F2", "FL2"),
    ("LED-B3", "LED-B3"),
)

HEAD = """\
# CIE standard observers 1931 (2 degrees) and 1964 (10 degrees): x, y, z; relative power of illuminants D65, A, F11,
# D50, F2, LED-B3.
# Written by packaging/generators/colour_tables.py from the tables of colour-science {version}.
"""


def table() -> tuple[list[str], np.ndarray, str]:
    """Return the names of the columns, their numbers (421, 13), and the version of the source."""
    with warnings.catch_warnings():
        # It says that it will not plot without Matplotlib; nothing is plotted here.
        warnings.filterwarnings("ignore", message='"Matplotlib" related API features are not available')
        import colour
    wavelengths = np.arange(FIRST_NM, LAST_NM + 1, dtype=float)
    names, columns = ["nm"], [wavelengths]
    for degrees, name in OBSERVERS:
        functions = colour.MSDS_CMFS[name]
        inside = (functions.wavelengths >= FIRST_NM) & (functions.wavelengths <= LAST_NM)
        if not np.array_equal(functions.wavelengths[inside], wavelengths):
            raise SystemExit(f"{name} is not tabulated at every nanometre")
        names += [f"{axis}{degrees}" for axis in "xyz"]
        columns += list(functions.values[inside].T)
    for name, key in ILLUMINANTS:
        source = colour.SDS_ILLUMINANTS[key]
        names.append(name)
        columns.append(np.interp(wavelengths, source.wavelengths, source.values, left=0.0, right=0.0))
    return names, np.column_stack(columns), colour.__version__


def main() -> int:
    """Write to the file named on the command line, or into the resources."""
    default = Path(__file__).resolve().parents[2] / "resources" / "colour" / "cie.csv"
    path = Path(sys.argv[1]) if len(sys.argv) > 1 else default
    names, numbers, version = table()
    lines = [",".join(f"{value:.10g}" for value in row) for row in numbers]
    path.parent.mkdir(parents=True, exist_ok=True)
    text = HEAD.format(version=version) + ",".join(names) + "\n" + "\n".join(lines) + "\n"
    path.write_text(text, encoding="ascii", newline="\n")
    print(path)
    return 0


if __name__ == "__main__":
    sys.exit(main())
