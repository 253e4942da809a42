"""Which functions of the suite that write a file no writer of the harness reaches."""

from __future__ import annotations

import ast
import json
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path
from types import CodeType

from tools.attack.children import be_quiet, in_child
from tools.attack.writing import WRITERS
from tools.attack.writing.writer import Writer

_ROOT = Path(__file__).resolve().parents[3]
_PLACES = ("brdf_suite", "apps")
_NAMES = ("write", "save")
_AS_DOCUMENT = "calls a writer that has a version of its own here"
_BY_A_WINDOW = "in the folder of this process and its child"
NOT_WRITERS: dict[str, str] = {
    "brdf_suite/acquisition/reconstruction/output.py write_acquired": _AS_DOCUMENT,
    "brdf_suite/acquisition/simulator/folder.py write_photograph": "photographs that count once their session is there",
    "brdf_suite/batches/results.py write_results": "calls the writers of palettes and tables, and write_atomically",
    "brdf_suite/files/exports/cxf3.py write_object": "returns a text",
    "brdf_suite/files/exports/cxf3.py write_specification": "returns a text",
    "brdf_suite/files/exports/rgl.py": "left out: 43 MB in 8 s",
    "brdf_suite/files/measured/cook_torrance.py": "calls save_paint",
    "brdf_suite/files/measured/cornell.py": "holds spectra only; as write_alta",
    "brdf_suite/files/measured/merl.py": "left out: 35 MB",
    "brdf_suite/files/measured/rgl.py": "left out: 43 MB in 8 s",
    "brdf_suite/fitting/homomorphic/reflectance_fit.py save_factored": _AS_DOCUMENT,
    "brdf_suite/inspection/figures/text.py save_figures": "a text by write_atomically",
    "brdf_suite/inspection/lobe_surface/export.py write_surface": "calls write_obj and write_ply",
    "brdf_suite/library": "calls the writers of all others",
    "brdf_suite/output": "draws, and calls the writers of pictures and videos",
    "brdf_suite/reflectance/live/text.py write_defaults": "returns a text",
    "brdf_suite/reports/contact_sheet/document.py write_sheet": "calls write_sheet_of",
    "brdf_suite/tracing": "traces, and calls the writers of pictures and videos",
    "apps/brdf_designer/acquire/mask/control.py write_session_mask": "calls write_atomically and write_session",
    "apps/brdf_designer/acquire/reconstruction/work.py save_table": "calls write_acquired",
    "apps/brdf_designer/standard_comparison/settings.py save": "by QSettings, which has its own way",
    "apps/brdf_qt/gl/items.py": "writes to the graphics card",
    "apps/brdf_viewer/tracing": _BY_A_WINDOW,
}
"""Modules, beginnings of their paths, or functions in them that need no writer here, with the reason."""


def writers_of_the_package() -> set[tuple[str, str]]:
    """Return (file, function) of the public functions that are named as those that write a file."""
    found = set()
    for top in _PLACES:
        for path in sorted((_ROOT / top).rglob("*.py")):
            place = path.relative_to(_ROOT).as_posix()
            for node in ast.parse(path.read_text(encoding="utf-8")).body:
                if isinstance(node, ast.FunctionDef) and node.name.split("_")[0] in _NAMES:
                    found.add((place, node.name))
    return found


def reached(writer: Writer) -> set[tuple[str, str]]:
    """Return the functions of the suite that ran while a writer wrote one version, in a forked child."""

    def work() -> str:
        be_quiet()
        seen: set[CodeType] = set()
        with tempfile.TemporaryDirectory(prefix="attack-") as folder:
            sys.setprofile(
                lambda frame, event, _argument: seen.add(frame.f_code) if event == "call" else None
            )
            writer.write(Path(folder), 1)
            sys.setprofile(None)
        root = f"{_ROOT}/"
        return json.dumps(
            [(code.co_filename.removeprefix(root), code.co_name) for code in seen if root in code.co_filename]
        )

    return {(place, name) for place, name in json.loads(in_child(work))}


def missing(report: Callable[[str], None] = lambda _text: None) -> list[str]:
    """Return what the harness lacks, in sentences; nothing where it is complete."""
    left = writers_of_the_package()
    reasons = {key: [one for one in left if " ".join(one).startswith(key)] for key in NOT_WRITERS}
    faults = [
        f"{key} of NOT_WRITERS names no function that writes." for key, named in reasons.items() if not named
    ]
    left -= {one for named in reasons.values() for one in named}
    for writer in WRITERS:
        if not left:
            break
        left -= reached(writer)
        report(writer.name)
    return faults + [
        f"{name} in {place} is reached by no writer of tools/attack/writing." for place, name in sorted(left)
    ]
