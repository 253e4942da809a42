"""Opens Designer in German, lets the core speak in it, and prints what the window shows as JSON.

Its argument: an empty folder. Run as a process of its own: a translation belongs to the whole application.
"""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Callable
from pathlib import Path

from brdf_designer.assembly import Designer
from brdf_designer.export.control import HandoverControl
from brdf_qt.fields.labels import ElidedLabel
from brdf_qt.program.application import create_application
from brdf_qt.program.core_texts import tr_core
from PySide6.QtTest import QTest

from brdf_suite.documents.view import SurfaceLook
from brdf_suite.errors import FileError, SuiteError
from brdf_suite.files.palettes import read_palette
from brdf_suite.pipeline.surface import load_shaped
from brdf_suite.surface.occlusion.bake import bake

BROKEN = {
    "cut.ase": b"ASEF\0\1\0\0\0\0\0\1\0\1\0\0\1\0",
    "hex.txt": b"#33669\n",
    "Light and dark.gpl": b"GIMP Palette\n300 0 x\n",
    "a.aco": b"\0\1\0\2\0\0",
}


def main() -> int:
    """Open, ask, print."""
    folder = Path(sys.argv[1])
    create_application("Designer", language="de")
    designer = Designer()
    window = designer.window
    window.resize(1280, 720)
    window.show()

    def wait(until: Callable[[], bool]) -> None:
        while not until():
            QTest.qWait(10)

    export = window.findChild(HandoverControl)
    export.open()
    losses = {}
    for name in ("cxf", "gltf", "pdf"):
        export.section.choose(name)
        export.section.formats_chosen.emit()
        wait(lambda: export.section.losses.text().startswith(("Verluste:", "Keine Verluste")))
        losses[name] = [export.section.holds.text(), export.section.losses.text()]

    bad = folder / "bad.brdfpaint"
    bad.write_text('{"format": "brdfpaint", "version": 1, "kind": "aspecular", "name": 3}', encoding="utf-8")
    designer.documents.open(bad)
    wait(lambda: "open" in window.messages.shown())
    message = window.messages.shown()["open"]

    words: list[str] = []

    def follow(fraction: float, what: str) -> None:
        window.progress.set_job("bake", fraction, what)
        words.extend(label.text() for label in window.progress.findChildren(ElidedLabel))

    bake(load_shaped("sphere", SurfaceLook()), follow)
    found = {
        "losses": losses,
        "message": [message.what, message.where.replace(str(folder), "FOLDER"), message.todo],
        "progress": list(dict.fromkeys(words)),
        "palettes": {name: _refusal(folder / name, content) for name, content in BROKEN.items()},
        "foreign": tr_core("Ganz normaler Satz: Light and dark."),
    }
    print(json.dumps(found))
    sys.stdout.flush()
    os._exit(0)  # nothing that is on its way is awaited


def _refusal(path: Path, content: bytes) -> str:
    path.write_bytes(content)
    try:
        read_palette(path)
    except (FileError, SuiteError) as error:
        return tr_core(str(error)).replace(str(path.parent), "FOLDER")
    return ""


if __name__ == "__main__":
    sys.exit(main())
