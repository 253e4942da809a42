"""Probe whether a Mitsuba variant works; run in a process of its own, because old LLVM versions abort the process.

``python -m brdf_suite.reference.probe llvm_ad_rgb`` compiles and runs a loop with a look-up and a virtual call, as path
tracing does, and prints one line of JSON: the library's version.
"""

from __future__ import annotations

import json
import sys

from brdf_suite.errors import ExtraError
from brdf_suite.extras import import_extra
from brdf_suite.reference.variant import NOT_LOADED


def main() -> int:
    """Run the variant named on the command line."""
    try:
        mi, dr = (import_extra(name, purpose="path tracing") for name in ("mitsuba", "drjit"))
    except ExtraError as error:
        print(json.dumps({"reason": error.reason}))
        return NOT_LOADED

    variant = sys.argv[1]
    mi.set_variant(variant)
    scene = mi.load_dict(
        {
            "type": "scene",
            "integrator": {"type": "path", "max_depth": 3},
            "sensor": {"type": "perspective", "film": {"type": "hdrfilm", "width": 4, "height": 4}},
            "light": {"type": "constant"},
            "ball": {"type": "sphere", "center": [0.0, 0.0, 3.0], "bsdf": {"type": "roughconductor"}},
        }
    )
    image = mi.render(scene, spp=2)
    dr.eval(image)
    finite = bool(dr.all(dr.isfinite(image.array)))
    version = dr.detail.llvm_version() if variant.startswith("llvm") else ()
    print(json.dumps({"llvm": ".".join(str(number) for number in version), "finite": finite}))
    return 0 if finite else 1


if __name__ == "__main__":
    sys.exit(main())
