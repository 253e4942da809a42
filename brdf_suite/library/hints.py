"""Messages about names that the library does not have, with the name that was probably meant."""

from __future__ import annotations

import difflib
from collections.abc import Iterable

_OTHER_WORDS = {
    "read": "load",
    "open": "load",
    "read_palette": "load",
    "load_palette": "load",
    "load_paint": "load",
    "load_material": "load",
    "read_measured": "load",
    "load_environment": "load",
    "read_environment": "load",
    "write": "save",
    "save_palette": "save",
    "write_palette": "save",
    "show": "plot",
    "display": "plot",
    "draw": "render",
    "render_to_file": "render",
    "list_paints": "names",
    "paints": "names",
    "environments": "names",
    "deltaE": "delta_e",
    "deltae": "delta_e",
    "nearest": "find_nearest",
    "find": "find_nearest",
    "factor": "factorize",
    "fit_lobes": "fit",
    "evaluate": "Material",
    "eval": "Material",
    "Reading": "Measurement",
    "Error": "SuiteError",
}
"""Words of other libraries and of the rooms below for what the library calls otherwise."""


def missing_name(name: str, known: Iterable[str]) -> str:
    """Return the message about a name that ``brdf_suite`` does not have, with the one that was probably meant.

    >>> missing_name("rendr", ["load", "render"])
    "module 'brdf_suite' has no attribute 'rendr'; did you mean 'render'?"
    """
    names = list(known)
    meant = _OTHER_WORDS.get(name) or _OTHER_WORDS.get(name.lower())
    if meant not in names:
        folded = {one.casefold(): one for one in names}
        near = difflib.get_close_matches(name.casefold(), folded, n=1, cutoff=0.6)
        meant = folded[near[0]] if near else None
    hint = f"; did you mean {meant!r}?" if meant else f"; there are {', '.join(names)}"
    return f"module 'brdf_suite' has no attribute {name!r}{hint}"
