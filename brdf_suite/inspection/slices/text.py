"""Lines of a cut as comma-separated values: a head of two lines, then one row for each angle.

The first line names the columns with their units, as spreadsheets want it; what was shown is in the second, a comment.
Numbers have all their digits, so that they read back as the same; what is not there is empty.
"""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Sequence

from brdf_suite.geometry.directions import Floats


def slices_csv(angle: str, angle_deg: Floats, columns: Sequence[tuple[str, Floats]], told: str) -> str:
    """Return the text: ``angle`` and each of ``columns`` (name with unit, (n,)) over ``angle_deg`` (n,).

    ``told`` is the comment, one line.
    """
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow([angle, *(name for name, _ in columns)])
    out.write("# " + " ".join(told.split()) + "\n")
    for row, place in enumerate(angle_deg.tolist()):
        values = [float(value[row]) for _, value in columns]
        writer.writerow([repr(place), *(repr(v) if math.isfinite(v) else "" for v in values)])
    return out.getvalue()
