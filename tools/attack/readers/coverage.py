"""Which readers the harness lacks: formats without a seed, seeds that are not read, readers that no seed reaches."""

from __future__ import annotations

import ast
import json
import os
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path
from types import CodeType

from brdf_suite.files.meshes.kinds import MESH_ENDINGS
from tools.attack.readers import READERS
from tools.attack.readers.reader import outcome

_ROOT = Path(__file__).resolve().parents[3]
_PLACES = ("brdf_suite", "apps")
_NAMES = ("read", "load", "decode", "import", "parse")
_GIVEN = ("path", "content", "data", "stream", "file", "line")
NOT_READERS = {
    "apps/brdf_qt/choosing/palettes.py": "calls the readers of palettes, for a list",
    "apps/brdf_color_swatch/library/loading.py": "calls the readers of palettes, on a thread",
    "apps/brdf_viewer/tracing/scene_files.py": "reads what its own parent process has just written",
    "brdf_suite/realtime": "reads back from the graphics card, or shaders that are packaged",
    "brdf_suite/cli": "parses arguments; command lines are attacked as such",
    "brdf_suite/inspection": "reads values, no files",
    "brdf_suite/library": "calls the readers of all others",
    "brdf_suite/tracing": "calls the readers of all others",
    "brdf_suite/regular_files.py": "opens files for the readers",
    "brdf_suite/output/still.py": "calls the readers of all others",
    "brdf_suite/output/compared.py": "calls the readers of all others",
    "brdf_suite/pipeline/material.py": "calls the readers of all others",
    "brdf_suite/reference/variant.py": "parses the name of a library of the system",
    "brdf_suite/pipeline/scene.py": "calls the readers of all others",
    "brdf_suite/pipeline/surface.py": "calls the readers of all others",
    "brdf_suite/pipeline/surface_images.py": "calls the readers of all others",
    "brdf_suite/acquisition/session/series.py": "calls the readers of photographs",
    "brdf_suite/acquisition/session/check.py": "calls the readers of photographs",
    "brdf_suite/acquisition/table": "reads arrays, no files",
    "brdf_suite/fitting/basis_search/database.py": "calls the reader of paints",
    "brdf_suite/paint_design/measured_start.py": "calls the readers of materials",
}
"""Modules, or beginnings of their paths, whose functions have a reader's name and are none, with the reason."""


def missing(report: Callable[[str], None] = lambda _text: None) -> list[str]:
    """Return what the harness lacks, in sentences; nothing where it is complete."""
    faults = []
    endings = {f".{reader.name.partition(':')[2]}" for reader in READERS if reader.name.startswith("mesh:")}
    others = {".usd", ".stp", ".igs"}  # other endings of kinds that are there
    faults += [
        f"No reader of meshes is called {ending}."
        for ending in set(MESH_ENDINGS) - endings - others - {".iges"}
    ]
    reached: set[tuple[str, str]] = set()
    with tempfile.TemporaryDirectory(prefix="attack-") as folder:
        for reader in READERS:
            own = Path(folder) / reader.name.replace(":", "_")
            own.mkdir()
            seeds = reader.make(own)
            if not seeds:
                faults.append(f"{reader.name} has no seed; add one in tools/attack/readers.")
            for seed in seeds:
                found, calls = _traced(reader.name, seed)
                reached |= calls
                if found != "read":
                    faults.append(f"{reader.name}: the undamaged {seed.name} is not read: {found}.")
            report(reader.name)
    for place, name in sorted(readers_of_the_package() - reached):
        faults.append(f"{name} in {place} is reached by no seed of tools/attack/readers.")
    return faults


def readers_of_the_package() -> set[tuple[str, str]]:
    """Return (file, function) of the public functions that by name and first argument read a file or its content."""
    found = set()
    for top in _PLACES:
        for path in sorted((_ROOT / top).rglob("*.py")):
            place = path.relative_to(_ROOT).as_posix()
            if any(place.startswith(start) for start in NOT_READERS):
                continue
            for node in ast.parse(path.read_text(encoding="utf-8")).body:
                if not isinstance(node, ast.FunctionDef) or node.name.startswith("_") or not node.args.args:
                    continue
                first = node.args.args[0].arg
                by_name = node.name.split("_")[0] in _NAMES or "_from_" in node.name
                if by_name and any(word in first for word in _GIVEN):
                    found.add((place, node.name))
    return found


def _traced(name: str, seed: Path) -> tuple[str, set[tuple[str, str]]]:
    """Read an undamaged seed in a forked child; return what came out, and the functions of the suite that ran."""
    receive, send = os.pipe()
    pid = os.fork()
    if pid == 0:
        seen: set[CodeType] = set()
        try:
            os.close(receive)
            for stream in (1, 2):
                os.dup2(os.open(os.devnull, os.O_WRONLY), stream)
            reader = next(one for one in READERS if one.name == name)
            sys.setprofile(
                lambda frame, event, _argument: seen.add(frame.f_code) if event == "call" else None
            )
            answer = outcome(reader, seed)
            sys.setprofile(None)
            root = f"{_ROOT}{os.sep}"
            calls = [
                (code.co_filename.removeprefix(root), code.co_name)
                for code in seen
                if code.co_filename.startswith(root)
            ]
            with os.fdopen(send, "w") as pipe:
                json.dump([answer, calls], pipe)
        finally:
            os._exit(0)
    os.close(send)
    with os.fdopen(receive) as pipe:
        said = pipe.read()
    os.waitpid(pid, 0)
    answer, calls = json.loads(said or '["the process died", []]')
    return answer, {(place, function) for place, function in calls}
