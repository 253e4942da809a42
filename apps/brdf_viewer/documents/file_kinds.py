"""Which files the Viewer opens: by what their names end in, and the dialog that asks for one."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

from brdf_qt.choosing.palettes import PALETTE_ENDINGS
from brdf_qt.fields.quiet import quieten
from brdf_qt.program.settings import settings
from brdf_qt.program.translation import mark, tr
from PySide6.QtWidgets import QFileDialog, QWidget

from brdf_suite.documents.palette_store import PALETTE_ENDING
from brdf_suite.documents.store import PAINT_ENDING, VIEW_ENDING
from brdf_suite.documents.studio import STUDIO_ENDING
from brdf_suite.files.images.relief import IMAGE_ENDINGS
from brdf_suite.files.meshes.reading import MESH_ENDINGS

_MEASURED = (
    *(".alta", ".astm", ".bin", ".binary", ".brdf", ".brdftable"),
    *(".bsdf", ".dat", ".json", ".mbsdf", ".merl", ".mtlx", ".pbsdf", ".py", ".ssdd", ".txt"),
)
"""They stand here and are not asked of their readers, which are much to import."""
ENDINGS: dict[str, tuple[str, ...]] = {
    "paint": (PAINT_ENDING, *_MEASURED),
    "palette": (PALETTE_ENDING,),
    "view": (VIEW_ENDING,),
    "environment": (".exr", ".hdr", STUDIO_ENDING),
    "surface": MESH_ENDINGS,
}
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
    "palette": PALETTE_ENDINGS,
    "compare": (*ENDINGS["paint"], ".exr", ".png"),
    "normal_map": IMAGE_ENDINGS,
    "tangent_map": IMAGE_ENDINGS,
    "mask": IMAGE_ENDINGS,
}

AskFile = Callable[[QWidget, str], str]
"""Asks for a file of a kind to open; empty where the user gives none."""
AskPicture = Callable[[QWidget, str], str]
"""Asks where to save a picture of that name; empty where nowhere."""
AskTarget = Callable[[QWidget, str, str, str], str]
"""Asks where to write: the window, a suggested name, what it is, the ending (empty: a folder); empty where nowhere."""


def kind_of(path: str) -> str | None:
    """Return what a file is by its name's ending; None for what the Viewer does not open."""
    ending = Path(path).suffix.lower()
    return next((kind for kind, endings in ENDINGS.items() if ending in endings), None)


def ask_file(parent: QWidget, kind: str) -> str:
    """Ask for a file of a kind, starting where the last one was; empty where the user gives none."""
    title = tr(TITLES[kind])
    patterns = " ".join(f"*{ending}" for ending in ASKED[kind])
    forms = f"{title} ({patterns});;" + tr("All files (*)")
    return ask_open(parent, tr("Open: {what}").format(what=title), forms, kind)


def ask_picture(parent: QWidget, name: str) -> str:
    """Ask where to save the picture called ``name`` as PNG; empty where nowhere."""
    return ask_save(parent, tr("Save Picture"), name, tr("PNG picture (*.png)"), ".png", "picture")


def ask_target(parent: QWidget, name: str, title: str, ending: str) -> str:
    """Ask where to export to, see :data:`AskTarget`."""
    form = f"{tr(title)} (*{ending})" if ending else tr("New folder")
    return ask_save(parent, tr("Export"), name, form, ending, "export")


def ask_open(parent: QWidget, title: str, forms: str, kind: str) -> str:
    """Ask for a file of the dialog's ``forms``, starting where the last one of that kind was; empty where none."""
    path, _ = QFileDialog.getOpenFileName(parent, title, _folder(kind), forms)
    return _remember(path, kind)


def ask_save(parent: QWidget, title: str, name: str, form: str, ending: str, kind: str) -> str:
    """Ask where to save what is called ``name``, starting where the last one of that kind was; empty where nowhere."""
    dialog = QFileDialog(parent, title, _folder(kind), form)
    dialog.setAcceptMode(QFileDialog.AcceptMode.AcceptSave)
    if ending:
        # Added by the dialog and not afterwards, so that it asks about the file that is really written.
        dialog.setDefaultSuffix(ending)
    dialog.selectFile(name + ending)
    quieten(dialog)
    accepted = dialog.exec() == QFileDialog.DialogCode.Accepted
    path = dialog.selectedFiles()[0] if accepted else ""
    dialog.deleteLater()
    return _remember(path, kind)


def file_name(name: str, other: str) -> str:
    """Return a name with what a file's name cannot hold replaced; ``other`` where nothing is left of it."""
    return re.sub(r"[^\w\- ]+", "_", name).strip(" _") or other


def with_ending(path: Path, ending: str) -> Path:
    """Return the path with ``ending`` where its name has none."""
    return path if path.suffix or not ending else path.with_name(path.name + ending)


def _folder(kind: str) -> str:
    return str(settings().value(f"folder/{kind}", ""))


def _remember(path: str, kind: str) -> str:
    if path:
        settings().setValue(f"folder/{kind}", str(Path(path).parent))
    return path
