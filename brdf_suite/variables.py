"""The environment variables that the suite reads; no other module names one of its own."""

from __future__ import annotations

from collections.abc import Mapping

CACHE = "BRDF_SUITE_CACHE"
CACHE_MB = "BRDF_SUITE_CACHE_MB"
READ_MB = "BRDF_SUITE_READ_MB"
LINK = "BRDF_SUITE_LINK"
REFERENCE_KEEP = "BRDF_SUITE_REFERENCE_KEEP"
SETTINGS = "BRDF_SUITE_SETTINGS"
LLVM = "DRJIT_LIBLLVM_PATH"

VARIABLES: Mapping[str, str] = {
    CACHE: "folder of filtered maps, baked occlusion and pictures of paints",
    CACHE_MB: "largest size of maps and of occlusion, megabytes",
    READ_MB: "most that is made of one file, megabytes; at least, and by default, 1 GiB",
    REFERENCE_KEEP: "folder of path-traced pictures that benchmarks keep",
    SETTINGS: "folder of the programs' settings, in place of the user's own",
    LINK: "name of the link by which open programs find each other",
    LLVM: "the library of LLVM that the path tracer uses",
    "NUMBA_CACHE_DIR": "folder of compiled filters, of Numba",
    "QT_QPA_PLATFORM": "the window system of the programs, of Qt; offscreen: none",
}
"""What each sets; those of other makers are named where they matter to a user of the suite."""
