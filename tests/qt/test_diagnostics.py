"""The log and the text for reports name no file and hold nothing of one."""

from __future__ import annotations

import json
import logging
from pathlib import Path

import numpy as np
import pytest
from brdf_qt.program.diagnostics import PrivateFormatter, describe_error, diagnostics, log_folder, start_log
from brdf_qt.program.settings import settings
from brdf_qt.window.main_window import SuiteWindow
from PySide6.QtGui import QAction, QGuiApplication

from brdf_suite.documents.store import load_paint
from brdf_suite.errors import FileError

SECRET = "/home/anna/Project Falcon/prototype red.brdfpaint"


@pytest.fixture
def logged(own_settings: Path):
    root = logging.getLogger()
    before, level = list(root.handlers), root.level
    start_log("Color Swatch")
    (handler,) = [one for one in root.handlers if one not in before]
    yield Path(handler.baseFilename)
    root.removeHandler(handler)
    root.setLevel(level)
    handler.close()


def test_the_log_has_the_programs_words_and_numbers_alone(logged: Path) -> None:
    log = logging.getLogger("brdf_suite.files.test")
    log.warning("%s: %d of %.1f parts of %s are missing", SECRET, 3, 4.0, np.array(["prototype"]))
    log.warning(FileError(SECRET, "is damaged"))
    try:
        load_paint(SECRET)
    except FileError as error:
        log.error("%s", error, exc_info=error)
    said = logged.read_text("utf-8")
    assert "WARNING brdf_suite.files.test: …: 3 of 4.0 parts of … are missing" in said
    assert "ERROR brdf_suite.files.test: FileError (FileError < brdf_suite/regular_files.py:" in said
    assert "brdf_suite/documents/store.py:" in said
    for word in ("anna", "Falcon", "prototype", str(Path(__file__).parent)):
        assert word not in said
    assert logged.name == "color_swatch.log"


def test_the_log_stays_small_and_disturbs_nobody(logged: Path, tmp_path: Path, capfd) -> None:
    log = logging.getLogger("brdf_suite.test")
    for _ in range(30):
        log.warning("x" * 100_000)
    kept = sorted(logged.parent.iterdir())
    assert [file.name for file in kept] == [f"color_swatch.log{end}" for end in ("", ".1", ".2")]
    assert sum(file.stat().st_size for file in kept) < 3_300_000
    for file in kept:
        file.unlink()
    logged.parent.rmdir()
    for _ in range(30):
        log.warning("x" * 100_000)
    assert "Logging error" not in capfd.readouterr().err


def test_the_text_for_a_report_has_figures_and_no_paths(logged: Path, qtbot) -> None:
    kept = settings("Color Swatch")
    kept.setValue("swatch/size", 96)
    kept.setValue("theme", "dark")
    kept.setValue("export/folder", SECRET)
    kept.setValue("last/name", "falcon")
    kept.setValue("files/recent", [SECRET])
    logging.getLogger("brdf_suite.test").warning("%s cannot be read", SECRET)
    text = diagnostics("Color Swatch")
    for words in (
        "BRDF Suite Color Swatch ",
        "Python 3.",
        "numpy ",
        "swatch/size = 96",
        "theme = dark",
        "OpenGL",
        "screen ",
    ):
        assert words in text
    assert "brdf_suite.test: … cannot be read" in text
    assert "falcon" not in text.lower()
    assert "anna" not in text


def test_an_error_is_described_by_its_kind_and_places() -> None:
    with pytest.raises(ValueError) as raised:  # noqa: PT011 - its text is what is not to be shown
        json.loads(SECRET)
    assert describe_error(raised.value) == "JSONDecodeError"


def test_the_settings_in_another_place_have_the_log_with_them(own_settings: Path) -> None:
    assert log_folder().is_relative_to(own_settings)


def test_the_help_menu_copies_it(qtbot, own_settings: Path) -> None:
    window = SuiteWindow("Designer")
    qtbot.addWidget(window)
    window.findChild(QAction, "action_copy_diagnostics").trigger()
    assert QGuiApplication.clipboard().text().startswith("BRDF Suite Designer ")
    assert "diagnostics" in window.messages.shown()


def test_a_line_whose_values_do_not_fit_has_its_text() -> None:
    line = PrivateFormatter().format(logging.LogRecord("brdf_qt.a", 30, "", 1, "%d %s", (1,), None))
    assert line.endswith("brdf_qt.a: %d %s")


@pytest.mark.parametrize("name", ["trimesh", "brdf_suited", "root", "qt"])
def test_of_what_others_log_their_name_and_level_are_kept(logged: Path, name: str) -> None:
    logging.getLogger(name).error(f"no key {SECRET} in 7 parts", exc_info=ValueError(SECRET))
    said = logged.read_text("utf-8")
    assert said.endswith(f"ERROR {name}: … (ValueError)\n")
    assert "Falcon" not in said
