"""What the windows read beside documents: messages of the link, settings, autosaves, records, the clipboard, fields."""

from __future__ import annotations

import contextlib
import functools
import importlib
import json
import os
import shutil
from collections.abc import Callable
from pathlib import Path
from typing import Any

from brdf_suite import variables
from brdf_suite.documents.store import paint_to_json, view_to_json
from brdf_suite.documents.view import View
from brdf_suite.geometry.factor_words import parse_factors
from brdf_suite.pipeline.material import load_shipped_paint
from brdf_suite.regular_files import read_bytes
from tools.attack.readers.palettes import small_palette
from tools.attack.readers.reader import REFUSALS, Reader, WrongValueError, text_files

PROGRAM = "BRDF Designer"


@functools.cache
def application() -> Any:
    """Return a Qt application without a screen, its settings in a folder of this process."""
    os.environ["QT_QPA_PLATFORM"] = "offscreen"
    qt = importlib.import_module("PySide6.QtWidgets")
    made = qt.QApplication.instance() or qt.QApplication(["attack"])
    made.setApplicationName(PROGRAM)
    return made


@contextlib.contextmanager
def _settings_in(folder: Path) -> Any:
    """Keep settings and states in ``folder`` for the block, and remove what it left."""
    application()
    own = folder / "settings"
    before = os.environ.get(variables.SETTINGS)
    os.environ[variables.SETTINGS] = str(own)
    try:
        yield own
    finally:
        shutil.rmtree(own, ignore_errors=True)
        if before is None:
            del os.environ[variables.SETTINGS]
        else:
            os.environ[variables.SETTINGS] = before


def _paint() -> dict[str, object]:
    return paint_to_json(load_shipped_paint("blue"))


def _messages(folder: Path) -> list[Path]:
    link = importlib.import_module("brdf_qt.link.messages")
    offer = {"to": "designer", "time": 1.0, "paint": _paint()}
    values = {
        "paint": _paint(),
        "view": view_to_json(View()),
        link.OFFER: offer,
        link.HELLO: {"role": "viewer"},
    }
    lines = {f"{topic}__json": link.encode(topic, value, "a1", 17).line for topic, value in values.items()}
    return text_files(**lines)(folder)


def _read_message(path: Path) -> None:
    link = importlib.import_module("brdf_qt.link.messages")
    message = link.decode(read_bytes(path))
    check = link.document_checks().get(message.topic)
    if check is not None:
        check(message.value)
    if message.topic == link.OFFER:
        _offers().received(message.topic, message.value)
    if link.next_seq(message.seq) > link._MAX_SEQ:
        raise WrongValueError("a number after which no message can follow")


@functools.cache
def _offers() -> Any:
    """Return what takes offers in Designer, its tabs being left out."""

    class Tabs:
        def add(self, paint: Any) -> None:
            """Take a paint, and drop it."""

    return importlib.import_module("brdf_designer.documents.paint_offer").PaintOffer(Tabs())


def _link_refusals() -> tuple[type[Exception], ...]:
    return (*REFUSALS, importlib.import_module("brdf_qt.link.messages").BadMessageError)


def _record_text() -> str:
    records = importlib.import_module("brdf_designer.standard_comparison.records")
    standard = importlib.import_module("brdf_suite.paint_design.standard")
    made = standard.standard_of(load_shipped_paint("blue"), "blue.brdfpaint")
    return json.dumps({"file": "/x.brdfpaint", **records.Record(made).to_json()})


def _read_record(path: Path) -> None:
    records = importlib.import_module("brdf_designer.standard_comparison.records")
    with _settings_in(path.parent):
        target = records._file(Path("/x.brdfpaint"))
        target.write_bytes(read_bytes(path))
        records.kept(Path("/x.brdfpaint"))


_LIMITS = {"difference": 1.0, "lightness": None, "chroma": 0.5, "hue": None, "ellipsoid": False}
_STORED: dict[str, tuple[str, str, Any, str, str]] = {
    "tolerances": (
        "",
        "standard/tolerances",
        {"difference": "2000", "everywhere": _LIMITS, "by_angle": {"15": _LIMITS}, "ellipsoid": True},
        "brdf_designer.standard_comparison.settings",
        "load",
    ),
    "view": ("", "", view_to_json(View()), "brdf_designer.picture.contents", "recall"),
    "fit": (
        "shared",
        "",
        {"basis": "", "count": 0, "weighting": "plain", "diffuse": "own"},
        "brdf_qt.window.fit_choice",
        "stored_choice",
    ),
    "sheet": ("", "", {"layout": "grid", "columns": 4}, "brdf_color_swatch.export.sheet_dialog", "_recall"),
}
"""What settings keep as JSON: program, key ("": the module's own), value, module and the function that reads it."""


def _read_stored(name: str) -> Callable[[Path], None]:
    program, key, _, module, function = _STORED[name]

    def read(path: Path) -> None:
        loaded = importlib.import_module(module)
        settings = importlib.import_module("brdf_qt.program.settings").settings
        place = key or getattr(loaded, "_KEY", None) or loaded._STORED
        with _settings_in(path.parent):
            text = read_bytes(path).decode("utf-8", "replace")
            settings(program).setValue(place, text)
            getattr(loaded, function)()

    return read


def _form() -> Any:
    files = importlib.import_module("brdf_qt.documents.files")
    store = importlib.import_module("brdf_suite.documents.store")
    return files.DocumentFormat(
        kind="paint",
        ending=".brdfpaint",
        new=lambda: load_shipped_paint("blue"),
        load=store.load_paint,
        save=store.save_paint,
        to_json=store.paint_to_json,
        from_json=store.paint_from_json,
        name_of=lambda paint: paint.name,
    )


def _autosave(folder: Path) -> list[Path]:
    states = [["first", _paint()], ["second", _paint()]]
    content = {
        "path": "/x.brdfpaint",
        "time": "2026-01-01T00:00:00+00:00",
        "stamp": None,
        "beside": {"paint": "blue"},
        "document": _paint(),
        "history": {"place": 1, "saved": 0, "states": states},
    }
    return text_files(work__json=json.dumps(content))(folder)


def _read_autosave(path: Path) -> None:
    """Start as after a crash, with a damaged autosave and a damaged history of a saved document."""
    documents = importlib.import_module("brdf_qt.documents.open_document")
    recovery = importlib.import_module("brdf_qt.documents.recovery")
    with _settings_in(path.parent):
        faults: list[BaseException] = []
        form = _form()
        store = documents.DocumentStore(form.new())
        made = recovery.Recovery(store, form, faults.append, keeps_history=True)
        for ending in (recovery._ENDING, recovery._SAVED_ENDING):
            (made.folder / f"old{ending}").write_bytes(read_bytes(path))
        try:
            made.found_saved()
            for item in made.found():
                made.take(item)
            made.sweep()
        finally:
            made.close(keep=False)
        if any(not isinstance(fault, REFUSALS) for fault in faults):
            raise WrongValueError(f"reported {faults[0]!r}")


def _read_tabs(path: Path) -> None:
    importlib.import_module("brdf_qt.documents.open_tabs")._read_record(path)


def _texts(folder: Path) -> list[Path]:
    palette = importlib.import_module("brdf_suite.documents.palette_store").encode_palette(small_palette())
    return text_files(
        colours__txt="#ff8800 Sunset\nrgb(1, 2, 3) Night\n50 -20 30 Leaf\nhsl(20, 10%, 30%)\n",
        paint__json=json.dumps(_paint()),
        palette__json=palette,
        factors__txt="p:wo q:h p:wi",
        numbers__txt="1,5e3 °",
    )(folder)


def _read_text(path: Path) -> None:
    """Read a text as the clipboard's, as a list of factors, and as a number that is typed."""
    text = read_bytes(path).decode("utf-8", "replace")
    transfer = importlib.import_module("brdf_color_swatch.editing.transfer")
    application()
    for kind in ("text/plain", transfer.MIME, transfer.PAINT_MIME):
        carried = importlib.import_module("PySide6.QtCore").QMimeData()
        carried.setData(kind, read_bytes(path))
        with contextlib.suppress(*REFUSALS):
            transfer.read_data(carried)
    importlib.import_module("brdf_qt.fields.number").parse_number(text)
    with contextlib.suppress(ValueError):
        importlib.import_module("brdf_lobe_visualizer.view3d.camera").parse_camera(text)
    with contextlib.suppress(*REFUSALS):
        parse_factors(text)


def _json_file(value: Callable[[], str]) -> Callable[[Path], list[Path]]:
    return lambda folder: text_files(stored__json=value())(folder)


READERS = [
    Reader("link:message", _read_message, _messages, refusals=_link_refusals()),
    Reader("settings:record", _read_record, _json_file(_record_text)),
    *(
        Reader(f"settings:{name}", _read_stored(name), _json_file(lambda value=stored[2]: json.dumps(value)))  # type: ignore[misc]  # bound early
        for name, stored in _STORED.items()
    ),
    Reader("settings:autosave", _read_autosave, _autosave),
    Reader(
        "settings:tabs",
        _read_tabs,
        _json_file(lambda: json.dumps({"tabs": [{"path": "/x", "autosave": "a", "source": ""}], "front": 0})),
    ),
    Reader("text:typed", _read_text, _texts),
]
