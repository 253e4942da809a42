"""Which files the Viewer opens: by what their names end in, and the dialog that asks for one."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from brdf_qt.program.settings import settings
from brdf_qt.program.translation import mark, tr
from PySide6.QtWidgets import QFileDialog, QWidget

from brdf_suite.documents.palette_store import PALETTE_ENDING
from brdf_suite.documents.store import PAINT_ENDING, VIEW_ENDING
from brdf_suite.documents.studio import STUDIO_ENDING
from brdf_suite.files.images.relief import IMAGE_ENDINGS
from brdf_suite.files.meshes.reading import MESH_ENDINGS

ENDINGS: dict[str, tuple[str, ...]] = {
    "paint": (
        PAINT_ENDING,
        ".alta",
        ".astm",
        ".bin",
        ".binary",
        ".brdf",
        ".brdftable",
        ".bsdf",
        ".dat",
        ".json",
        ".txt",
    ),
    "palette": (PALETTE_ENDING,),
    "view": (VIEW_ENDING,),
    "environment": (".exr", ".hdr", STUDIO_ENDING),
    "surface": MESH_ENDINGS,
}
"""The measured ones among the paints stand here and are not asked of their readers, which are much to import."""

TITLES = {
    "paint": mark("Paint or Measured File"),
    "palette": mark("Palette"),
    "view": mark("View"),
    "environment": mark("Environment"),
    "surface": mark("Surface"),
    "compare": mark("Second Paint or Picture"),
    "normal_map": mark("Normal Map"),
    "tangent_map": mark("Tangent Map"),
    "mask": mark("Mask"),
}
ASKED: dict[str, tuple[str, ...]] = {
    **ENDINGS,
    "compare": (*ENDINGS["paint"], ".exr", ".png"),
    "normal_map": IMAGE_ENDINGS,
    "tangent_map": IMAGE_ENDINGS,
    "mask": IMAGE_ENDINGS,
}

AskFile = Callable[[QWidget, str], str]
AskPicture = Callable[[QWidget, str], str]
PICTURE_ENDING = ".png"


def kind_of(path: str) -> str | None:
    """Return what a file is by its name's ending; None for what the Viewer does not open."""
    ending = Path(path).suffix.lower()
    return next((kind for kind, endings in ENDINGS.items() if ending in endings), None)


def all_endings() -> str:
    """Return the endings of all kinds, for a message."""
    return ", ".join(ending for endings in ENDINGS.values() for ending in endings)


def ask_file(parent: QWidget, kind: str) -> str:
    """Ask for a file of a kind, starting where the last one was; empty where the user gives none."""
    patterns = " ".join(f"*{ending}" for ending in ASKED[kind])
    start = str(settings().value(f"folder/{kind}", ""))
    path, _ = QFileDialog.getOpenFileName(
        parent,
        tr("Open: {what}").format(what=tr(TITLES[kind])),
        start,
        f"{tr(TITLES[kind])} ({patterns});;" + tr("All files (*)"),
    )
    if path:
        settings().setValue(f"folder/{kind}", str(Path(path).parent))
    return path


def ask_picture(parent: QWidget, name: str) -> str:
    """Ask where to save a picture called ``name``, starting where the last one was; empty where nowhere."""
    start = Path(str(settings().value("folder/picture", "")))
    dialog = QFileDialog(parent, tr("Save Picture"), str(start), tr("PNG picture (*.png)"))
    dialog.setAcceptMode(QFileDialog.AcceptMode.AcceptSave)
    # Added by the dialog and not afterwards, so that it asks about the file that is really written.
    dialog.setDefaultSuffix(PICTURE_ENDING)
    dialog.selectFile(name + PICTURE_ENDING)
    accepted = dialog.exec() == QFileDialog.DialogCode.Accepted
    path = dialog.selectedFiles()[0] if accepted else ""
    dialog.deleteLater()
    if path:
        settings().setValue("folder/picture", str(Path(path).parent))
    return path
