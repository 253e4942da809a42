"""Draw pictures as the process beside Color Swatch does; a process of ``bench palette``. Prints one JSON object."""

from __future__ import annotations

import json
import sys
import tempfile
from pathlib import Path
from time import perf_counter, process_time

from brdf_suite.cli.tools.bench import load_module


def main() -> None:
    made = load_module(Path(__file__).with_name("paints.py"))
    with tempfile.TemporaryDirectory() as folder:
        figures, notes = rates(made.paints(int(sys.argv[1]), seed=11), Path(folder))
    sys.stdout.write(json.dumps({"figures": figures, "notes": notes}) + "\n")


def rates(some, folder):
    """Pictures a second, after the first have loaded light, form and shaders."""
    from brdf_suite.palettes.swatches.look import SwatchLook
    from brdf_suite.palettes.swatches.pictures import SwatchPainter
    from brdf_suite.palettes.swatches.store import SwatchStore

    found, notes = {}, {}
    with SwatchPainter() as painter:
        for form, key in (
            ("sphere", "thumbnails_per_s"),
            ("panel", "panels_per_s"),
            ("flop_strip", "strips_per_s"),
        ):
            look = SwatchLook(form)
            # Every kind of paint once: each number of look-ups has a program that is compiled.
            painter.draw(some[:40], look)
            passes = []
            began_cpu = process_time()
            for _ in range(3):
                began = perf_counter()
                pictures = painter.draw(some, look)
                passes.append(len(some) / (perf_counter() - began))
            assert all(picture.pixels is not None for picture in pictures)
            found[key] = max(passes)
            if form == "sphere":
                found["thumbnail_cpu_ms"] = 1e3 * (process_time() - began_cpu) / (3 * len(some))
            notes[key] = "best of three passes: " + ", ".join(f"{rate:.0f}" for rate in passes)
    store = SwatchStore(folder)
    store.put({picture.key: picture.pixels for picture in pictures})
    began = perf_counter()
    assert len(store.get([picture.key for picture in pictures])) == len(pictures)
    found["kept_ms"] = 1e3 * (perf_counter() - began) / len(pictures)
    store.close()
    return found, notes


if __name__ == "__main__":
    main()
