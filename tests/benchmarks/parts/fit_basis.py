"""What the search for the exponents gained, and what it took; a part of ``bench fit``."""

from __future__ import annotations

import json

import numpy as np

from brdf_suite.errors import SuiteError
from brdf_suite.fitting import LobeBasis, default_basis, log_spaced
from brdf_suite.fitting.basis_search.database import load_database
from brdf_suite.fitting.basis_search.document import choose_default, load_search
from brdf_suite.fitting.basis_search.error import BasisError, equation_4
from brdf_suite.fitting.lobes.basis import STORED_NAME, shipped_basis
from brdf_suite.progress import Progress, report
from brdf_suite.resources import resource, resource_root

#: The progress message.
TITLE = "the exponents"
#: key: (comparison, bound, unit, meaning)
BOUNDS: dict[str, tuple[str, float | None, str, str]] = {
    "basis_vs_log": (
        "<=",
        0.8,
        "",
        "maximum + mean error at the count that the search's own rule chooses, found exponents over log-spaced ones "
        "between the same ends",
    ),
    "basis_vs_best_log": ("", None, "", "the same over the best log-spaced set with any ends"),
    "basis_error": ("", None, "", "maximum + mean error of the default exponents (1: just noticeable)"),
    "basis_search_s": ("<=", 900.0, "s", "whole basis search, 1 to 11 lobes, two workers; of the stored run"),
    "database_paints": ("", None, "", "paints in the database of the search, including 25 edits"),
}
NOTES: dict[str, str] = {}
#: Ends that the best log-spaced set is sought over.
FIRST = np.geomspace(1.0, 8.0, 19)
LAST = np.geomspace(20_000.0, 116_000.0, 11)


def run(progress: Progress | None = None) -> dict[str, float | None]:
    """Return the figures of :data:`BOUNDS`; the errors are computed anew."""
    stored = json.loads(resource("basis", STORED_NAME).read_text(encoding="utf-8"))
    database = load_database(resource_root() / "paints")
    if stored["provenance"]["database_sha256"] != database.sha256:
        raise SuiteError("The stored basis is of other paints than the shipped ones; run brdf-suite basis.")
    errors = BasisError(database)

    def value(basis: LobeBasis) -> float:
        return equation_4(errors(basis.array()))

    found = shipped_basis(choose_default(load_search(resource("basis", STORED_NAME)).results))
    ours = value(found)
    same_ends = value(log_spaced(found.count, found.exponents[0], found.exponents[-1]))
    best, ends = np.inf, (0.0, 0.0)
    for step, low in enumerate(FIRST):
        report(progress, step / FIRST.size, "log-spaced sets")
        for high in LAST:
            other = value(log_spaced(found.count, float(low), float(high)))
            if other < best:
                best, ends = other, (float(low), float(high))
    provenance = stored["provenance"]
    NOTES["basis_vs_log"] = (
        f"{found.count} lobes, {ours:.2f} against {same_ends:.2f} from {found.exponents[0]:g} to "
        f"{found.exponents[-1]:,.0f}"
    )
    NOTES["basis_vs_best_log"] = (
        f"{best:.2f} from {ends[0]:.2f} to {ends[1]:,.0f}, of {FIRST.size * LAST.size} sets"
    )
    NOTES["basis_search_s"] = f"{provenance['date']}, {provenance['processor']}"
    return {
        "basis_vs_log": ours / same_ends,
        "basis_vs_best_log": ours / best,
        "basis_error": value(default_basis()),
        "basis_search_s": float(provenance["seconds"]),
        "database_paints": float(len(database.paints)),
    }
