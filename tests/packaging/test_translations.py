"""The translations that the windows load: complete, of today's texts, and shown."""

from __future__ import annotations

import importlib.util
import subprocess
import sys
from pathlib import Path

import pytest

PROGRAM = """
import sys
from brdf_qt.program.application import create_application
app = create_application("Designer", language="de")
from brdf_designer.assembly import Designer
window = Designer().window
print([action.text() for action in window.menuBar().actions()])
print(window.findChild(type(window.undo_action), "action_Undo").text(), window.undo_action.objectName())
from datetime import datetime
from brdf_qt.program.translation import moment
print(moment(datetime(2026, 12, 1, 16, 32)))
"""


@pytest.fixture(scope="module")
def translate(checkout: Path):
    spec = importlib.util.spec_from_file_location("translate", checkout / "packaging" / "translate.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_every_text_of_today_is_translated(checkout: Path) -> None:
    done = subprocess.run(
        [sys.executable, "packaging/translate.py", "--check"], cwd=checkout, capture_output=True, text=True
    )
    assert done.returncode == 0, done.stdout + done.stderr


def test_what_is_shipped_is_what_the_texts_give(checkout: Path, translate, tmp_path: Path) -> None:
    translate.release(translate.SOURCES / "de.ts", tmp_path / "de.qm")
    assert (tmp_path / "de.qm").read_bytes() == (translate.RELEASED / "de.qm").read_bytes()


def test_faults_of_a_translation_are_reported(translate, tmp_path: Path) -> None:
    path = tmp_path / "x.ts"
    path.write_text(
        "<TS><context><name/>"
        "<message><source>Save {name}</source><translation>Sichern</translation></message>"
        '<message><source>Open</source><translation type="unfinished"/></message>'
        "<message><source>&amp;File</source><translation>Datei</translation></message>"
        "<message><source>Good {x}</source><translation>Gut {x}</translation></message></context></TS>"
    )
    places, missing, key = translate.faults(path)
    assert "other places" in places
    assert "not translated" in missing
    assert "access key" in key


def test_designer_speaks_german(tmp_path: Path, monkeypatch) -> None:
    monkeypatch.setenv("QT_QPA_PLATFORM", "offscreen")
    monkeypatch.setenv("BRDF_SUITE_SETTINGS", str(tmp_path))
    done = subprocess.run([sys.executable, "-c", PROGRAM], capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stderr
    menus, undo, date = done.stdout.splitlines()[:3]
    assert "&Datei" in menus
    # Names of objects stay English: tests and style do not follow the language.
    assert undo.startswith("&Rückgängig")
    assert undo.endswith("action_Undo")
    assert date == "1. Dezember 2026, 16:32"
