"""The translations that the windows load: complete, of today's texts, and shown."""

from __future__ import annotations

import ast
import importlib.util
import json
import os
import re
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree

import pytest
from brdf_qt.window.shortcuts import SHORTCUTS
from PySide6.QtGui import QKeySequence

from brdf_suite.pipeline.material import paint_names
from brdf_suite.reflectance.registry import MODELS

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


ALL = ("Designer", "Lobe Visualizer", "Color Swatch", "Viewer")
ENGLISH = re.compile(
    r"\b(the|of|and|with|for|to|from|open|save|show|is|are|not|this|light|paint|file|picture|edit|close|remove|add|new|"
    r"by|or|no|all|other|one|two|colours?|angles?|be|its?)\b",
    re.IGNORECASE,
)
"""Common words of the interface that are not German ones too."""


@pytest.fixture(scope="module")
def german(checkout: Path, tmp_path_factory: pytest.TempPathFactory) -> dict[str, dict]:
    """What each program shows after German was chosen in the menu of one of them."""
    settings = tmp_path_factory.mktemp("settings")
    changed = {
        "QT_QPA_PLATFORM": "offscreen",
        "BRDF_SUITE_SETTINGS": str(settings),
        "BRDF_SUITE_CACHE": str(settings / "cache"),
        "BRDF_SUITE_LINK": f"german-{os.getpid()}",
        "LC_ALL": "C.UTF-8",
    }

    def walk(*arguments: str) -> dict:
        command = [sys.executable, str(checkout / "tests" / "packaging" / "window_texts.py"), *arguments]
        done = subprocess.run(command, capture_output=True, text=True, env=os.environ | changed, timeout=600)
        assert done.returncode == 0, done.stderr
        return json.loads(done.stdout)

    assert walk("Color Swatch", "de")["language"] == "en"
    return {program: walk(program) for program in ALL}


@pytest.mark.parametrize("program", ALL)
def test_a_language_is_chosen_for_all_programs(german, program) -> None:
    assert german[program]["language"] == "de"


@pytest.mark.parametrize("program", ALL)
def test_no_english_is_left_in_a_german_window(german, checkout, program) -> None:
    """Names of paints are those of their documents."""
    found = ElementTree.parse(checkout / "packaging" / "translations" / "de.ts").iter("message")
    translated = {message.findtext("source"): message.findtext("translation") for message in found}
    names = {*paint_names(), *MODELS, *(model.title for model in MODELS.values())}
    names |= {name.replace("_", " ").capitalize() for name in names} | set(translated.values())
    shown = {(place, re.sub("<[^>]*>", " ", text)) for place, text in german[program]["texts"]}
    shown |= {("menu", text) for text in german[program]["entries"]}
    assert len(shown) > 300
    left = [
        (place, text)
        for place, text in sorted(shown)
        if text not in names and (text in translated or ENGLISH.search(text))
    ]
    assert left == []


@pytest.mark.parametrize("program", ALL)
def test_nothing_is_cut_off_in_a_german_window(german, program) -> None:
    assert german[program]["cut"] == []


@pytest.mark.parametrize("program", ALL)
def test_numbers_have_the_decimal_comma_in_a_german_window(german, program) -> None:
    numbers = german[program]["numbers"]
    assert not [text for text in numbers if "." in text]
    assert any("," in text for text in numbers)


IN_THE_PICTURE = ["Tab"]
"""Keys that a widget takes by itself, where it has the focus."""
IN_THE_STUDIO = ["Ctrl+S", "Ctrl+Shift+S", "Ctrl+Z", "Ctrl+Shift+Z", "Ctrl+Y"]
"""Those of Viewer's panel Studio: they mean there what they mean elsewhere."""


def test_no_key_means_two_things_and_no_command_has_two_keys(german) -> None:
    meanings: dict[str, set[str]] = {}
    for program in ALL:
        used = german[program]["keys"]
        assert len(used) > 15
        for command, keys in used:
            if command == "QShortcut":
                assert set(keys) <= {*IN_THE_PICTURE, *IN_THE_STUDIO}, program
                continue
            assert command in SHORTCUTS, (program, keys)
            assert tuple(keys) == tuple(QKeySequence(one).toString() for one in SHORTCUTS[command].keys), (
                command
            )
            for key in keys:
                meanings.setdefault(key, set()).add(command)
        # In one window a key is one command's.
        assert len({key for _, keys in used for key in keys}) == sum(len(keys) for _, keys in used), program
    assert {key: commands for key, commands in meanings.items() if len(commands) > 1} == {}


def test_every_command_of_the_table_is_in_a_program(german) -> None:
    used = {command for program in ALL for command, _ in german[program]["keys"]}
    # Fields are counted to nine; a window has as many as it has angles and views.
    unused = {name for name in SHORTCUTS if name not in used and not re.fullmatch(r"(pick|preset)_\d", name)}
    assert unused == {"panels_of_picture"}


@pytest.mark.parametrize(
    "command", ["export", "find_command", "settings", "manual", "shortcuts", "panels", "quit"]
)
def test_what_all_programs_have_is_on_the_same_key(german, command: str) -> None:
    for program in ALL:
        assert command in {name for name, _ in german[program]["keys"]}, program


def test_no_text_is_translated_inside_an_f_string(checkout: Path) -> None:
    """The tool that collects the texts does not find it there."""
    wrong = [
        f"{path.name}:{call.lineno}"
        for path in (checkout / "apps").rglob("*.py")
        for text in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(text, ast.JoinedStr)
        for call in ast.walk(text)
        if isinstance(call, ast.Call)
        and isinstance(call.func, ast.Name)
        and call.func.id in ("tr", "mark")
        and isinstance(call.args[0], ast.Constant)
    ]
    assert wrong == []
