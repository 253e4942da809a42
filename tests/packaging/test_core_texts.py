"""Texts of the core in the windows' language: collected from its sources, found again in finished sentences."""

from __future__ import annotations

import importlib.util
import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

SOURCE = '''
"""A docstring is no text."""
NAMES = {"no key": "the value of a key"}

def read(path, count, names, flag=None):
    if count == "no comparison":
        raise ValueError("a fault of the program")
    raise FileError(path, f"has {count:.2f} {'row' if count == 1 else 'rows'}, not {', '.join(names) or 'none at all'}")

def notes(collector, progress):
    collector.note("{n} empty slot[|s] skipped.")
    report(progress, 0.5, "reading")
    print("only a command prints this")
    return "Half of it; " + "the rest."
'''


@pytest.fixture(scope="module")
def core_texts(checkout: Path):
    spec = importlib.util.spec_from_file_location("core_texts", checkout / "packaging" / "core_texts.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_texts_and_templates_are_collected(core_texts, tmp_path: Path) -> None:
    (tmp_path / "a.py").write_text(SOURCE)
    assert core_texts.core_texts(tmp_path) == [
        "the value of a key",
        "has {0} row, not {1}",
        "has {0} rows, not {1}",
        "none at all",
        "{0} empty slot skipped.",
        "{0} empty slots skipped.",
        "reading",
        "Half of it; the rest.",
    ]


def test_what_only_the_command_prints_is_not_collected(core_texts, tmp_path: Path) -> None:
    (tmp_path / "cli").mkdir()
    (tmp_path / "cli" / "a.py").write_text(SOURCE)
    assert core_texts.core_texts(tmp_path) == []


def test_of_a_program_errors_and_steps_of_work_are_collected(core_texts, tmp_path: Path) -> None:
    (tmp_path / "core").mkdir()
    (tmp_path / "program").mkdir()
    (tmp_path / "program" / "a.py").write_text(SOURCE)
    found = core_texts.core_texts(tmp_path / "core", [tmp_path / "program"])
    assert "reading" in found
    assert "has {0} rows, not {1}" in found
    assert "the value of a key" not in found


@pytest.fixture(scope="module")
def german(checkout: Path, tmp_path_factory: pytest.TempPathFactory) -> dict:
    """What a German Designer shows of texts that the core has made."""
    folder = tmp_path_factory.mktemp("german")
    changed = {
        "QT_QPA_PLATFORM": "offscreen",
        "BRDF_SUITE_SETTINGS": str(folder / "settings"),
        "BRDF_SUITE_CACHE": str(folder / "cache"),
        "BRDF_SUITE_LINK": f"messages-{os.getpid()}",
    }
    command = [sys.executable, str(checkout / "tests" / "packaging" / "german_messages.py"), str(folder)]
    done = subprocess.run(command, capture_output=True, text=True, env=os.environ | changed, timeout=600)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def test_the_export_page_says_what_formats_lose(german) -> None:
    holds, losses = german["losses"]["cxf"]
    assert holds == "L*a*b* bei jedem Winkel (D65, 10°), Spektren, wo sie bekannt sind, Glanz, Name, Notizen."
    assert losses.startswith("Verluste:\n– Die Flakes, die Regel zwischen den Winkeln und der Faktor")
    assert "gleich welche der Lack hat" in german["losses"]["gltf"][1]
    assert "programs" not in german["losses"]["pdf"][1]


def test_numbers_within_have_the_comma(german) -> None:
    losses = german["losses"]["gltf"][1]
    assert "der Klarlack von glTF hat die Brechzahl 1,5" in losses.replace("Der", "der")
    assert "ΔE00 2,8" in losses
    assert "2.8" not in losses


def test_a_bad_file_is_refused_with_its_place(german) -> None:
    what, where, todo = german["message"]
    assert what == "bad.brdfpaint: das Feld „measurements“ fehlt."
    assert where == "Oberste Ebene, in FOLDER"
    assert todo.endswith("ist unverändert.")


def test_steps_of_work_are_shown_in_the_strip(german) -> None:
    assert "Umgebungsverdeckung wird angepasst" in german["progress"]
    assert not [words for words in german["progress"] if "occlusion" in words]


def test_errors_of_files_are_translated_and_names_are_not(german) -> None:
    refused = german["palettes"]
    assert refused["cut.ase"] == (
        "FOLDER/cut.ase, Byte 12: ein Block von 256 Byte reicht über das Ende der Datei hinaus."
    )
    assert refused["Light and dark.gpl"] == (
        "FOLDER/Light and dark.gpl, Zeile 2: erwartet wurden drei Zahlen und ein Name, nicht '300 0 x'."
    )
    formats = refused["hex.txt"]
    assert formats.startswith(
        "FOLDER/hex.txt, Byte 0: hat kein hier bekanntes Palettenformat (BRDF-Suite-Palette"
    )
    assert "SCSS-, Sass- und LESS-Variablen, Sketch-Palette" in formats
    assert german["foreign"] == "Ganz normaler Satz: Light and dark."
