"""What the windows write by themselves: autosaves, the tabs that are open, the standard of a paint."""

from __future__ import annotations

import importlib
import os
from pathlib import Path
from typing import Any

from brdf_suite import variables
from brdf_suite.errors import SuiteError
from tools.attack.readers.programs import _form, application
from tools.attack.writing.writer import Writer, paint, palette, version_of


def _settings_in(folder: Path) -> None:
    application()
    os.environ[variables.SETTINGS] = str(folder / "settings")


def _recovery(folder: Path) -> Any:
    _settings_in(folder)
    documents = importlib.import_module("brdf_qt.documents.open_document")
    recovery = importlib.import_module("brdf_qt.documents.recovery")
    store = documents.DocumentStore(_form().new())
    return store, recovery.Recovery(
        store, _form(), lambda error: (_ for _ in ()).throw(error), keeps_history=True
    )


def _write_autosave(folder: Path, number: int) -> None:
    """Do what a start and an edit do: earlier work is taken up, and the new version saved by itself."""
    store, recovery = _recovery(folder)
    try:
        for item in recovery.found():
            recovery.take(item)
        store.replace(paint(number), None, clean=False)
        recovery.close(keep=True)
    except SuiteError:
        recovery.close(keep=False)  # as the program does where nothing can be written: its lock goes with it
        raise


def _read_autosave(folder: Path) -> int:
    _, recovery = _recovery(folder)
    try:
        return version_of(recovery.found()[0].value.name)
    finally:
        recovery.close(keep=False)


def _swatch_recovery(folder: Path) -> Any:
    _settings_in(folder)
    documents = importlib.import_module("brdf_qt.documents.open_document")
    tasks = importlib.import_module("brdf_qt.work.tasks").TaskRunner()
    form = importlib.import_module("brdf_color_swatch.assembly").palette_format()
    store = documents.DocumentStore(palette(0))
    autosave = importlib.import_module("brdf_color_swatch.library.autosave")
    return (
        store,
        autosave.PaletteRecovery(store, form, lambda error: (_ for _ in ()).throw(error), tasks),
        tasks,
    )


def _write_swatch_autosave(folder: Path, number: int) -> None:
    store, recovery, tasks = _swatch_recovery(folder)
    try:
        for item in recovery.found():
            recovery.take(item)
        store.replace(palette(number), None, clean=False)
        recovery.close(keep=True)
    except SuiteError:
        recovery.close(keep=False)
        raise
    finally:
        tasks.stop()


def _read_swatch_autosave(folder: Path) -> int:
    _, recovery, tasks = _swatch_recovery(folder)
    try:
        return version_of(recovery.found()[0].value.name)
    finally:
        recovery.close(keep=False)
        tasks.stop()


def _tabs(folder: Path, number: int) -> Any:
    _settings_in(folder)
    tabs = importlib.import_module("brdf_qt.documents.open_tabs")
    opened = [tabs.OpenTab(None, "", f"v{number}") for _ in range(150)]
    return tabs.TabsRecord(lambda: (opened, 0))


def _write_tabs(folder: Path, number: int) -> None:
    """Do what a start and a kill do: the tabs of an earlier run are taken up, and those of this one kept."""
    record = _tabs(folder, number)
    left = record.left()
    record.close(keep=True)
    if not record.file.exists():
        raise SuiteError("the list of tabs is not kept")  # a program goes on without it
    if left is not None:
        record.drop(left)


def _read_tabs(folder: Path) -> int:
    record = _tabs(folder, 0)
    try:
        left = record.left()
        return -1 if left is None else max(version_of(tab.source) for tab in left.tabs)
    finally:
        record.close(keep=False)


def _write_record(folder: Path, number: int) -> None:
    _settings_in(folder)
    records = importlib.import_module("brdf_designer.standard_comparison.records")
    standard = importlib.import_module("brdf_suite.paint_design.standard")
    made = standard.standard_of(paint(number), "blue.brdfpaint")
    records.keep(Path("/x.brdfpaint"), records.Record(made))


def _read_record(folder: Path) -> int:
    _settings_in(folder)
    records = importlib.import_module("brdf_designer.standard_comparison.records")
    found = records.kept(Path("/x.brdfpaint"))
    if found is None:
        raise ValueError("there is no record")
    return version_of(found.standard.name)


WRITERS = (
    Writer("document:autosave", _write_autosave, _read_autosave),
    Writer("settings:swatch_autosave", _write_swatch_autosave, _read_swatch_autosave),
    Writer("settings:tabs", _write_tabs, _read_tabs, is_forced=False),
    Writer("settings:record", _write_record, _read_record),
)
