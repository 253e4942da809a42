"""The figures and rules of the project's structure, on small checkouts and on this one."""

from __future__ import annotations

from pathlib import Path

import pytest

from tools import house

UNWANTED = "t" + "old"

CLEAN = {
    "brdf_suite/__init__.py": "",
    "brdf_suite/errors.py": "class SuiteError(Exception): ...\n",
    "brdf_suite/pipeline/__init__.py": "",
    "brdf_suite/pipeline/fit.py": "from brdf_suite.errors import SuiteError\n\nERROR = SuiteError()\n",
    "brdf_suite/cli/main.py": "def run() -> None:\n    from brdf_suite.pipeline.fit import fit\n\n    fit()\n",
    "brdf_suite/pipeline/compiled.py": "def make() -> None:\n    import numba\n\n    numba.njit()\n",
    "apps/brdf_viewer/__main__.py": "import os\n\ncores = getattr(os, 'cpu_count')\n",
    "tests/test_fit.py": "class TestFit:\n    def test(self):\n        self._fit = 1\n",
    "docs/fit.md": "The fit is exact.\n",
}


def written(folder: Path, files: dict[str, str]) -> Path:
    for name, text in files.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)
    return folder


def test_a_clean_checkout_breaks_no_rule(tmp_path: Path) -> None:
    assert house.check(house.House(written(tmp_path, CLEAN)), {}) == []


@pytest.mark.parametrize(
    ("rule", "files", "place"),
    [
        (
            "full folders",
            {f"brdf_suite/pipeline/{letter}.py": "" for letter in "abcdefghijklmnopqrstuvwxyz"},
            "brdf_suite/pipeline: holds 28 modules",
        ),
        ("full folders", {f"tests/test_{n}.py": "" for n in range(20)}, "tests: holds 21 modules"),
        (
            "families of names",
            {f"apps/brdf_viewer/{name}.py": "" for name in ("map", "map_plane", "map_points", "map_space")},
            "apps/brdf_viewer/map_*: map, map_plane, map_points, map_space",
        ),
        (
            "import circles",
            {
                "brdf_suite/geometry/a.py": "from brdf_suite.geometry import b\n",
                "brdf_suite/geometry/b.py": "if True:\n    from brdf_suite.geometry.a import c\n",
            },
            "brdf_suite.geometry.a: in a circle with brdf_suite.geometry.b",
        ),
        (
            "imports inside functions",
            {"brdf_suite/files/exr.py": "def read() -> None:\n    import json\n\n    json.loads('')\n"},
            "brdf_suite/files/exr.py:2: import json",
        ),
        (
            "class names in several rooms",
            {
                f"brdf_suite/{room}/rows.py": "".join(f"class Row{n}: ...\n" for n in range(21))
                for room in ("files", "surface")
            },
            "Row20: defined in brdf_suite.files, brdf_suite.surface",
        ),
        (
            "attributes by text",
            {"apps/brdf_viewer/part.py": "def close(part):\n    getattr(part, 'close_part')()\n"},
            "apps/brdf_viewer/part.py:2: asks for “close_part” by text",
        ),
        (
            "direct access",
            {"brdf_suite/files/exr.py": "from pathlib import Path\n\nPath('a').open('rb')\n"},
            "brdf_suite/files/exr.py:3: calls Path('a').open",
        ),
        (
            "direct access",
            {"apps/brdf_viewer/part.py": "import subprocess\n\nsubprocess.run(['ls'])\n"},
            "apps/brdf_viewer/part.py:3: calls subprocess.run",
        ),
        (
            "private accesses in tests",
            {"tests/test_more.py": "import fit\n\n" + "fit._state\n" * 61},
            "tests/test_more.py:63: takes _state",
        ),
        ("unwanted words", {"docs/fit.md": f"The user is {UNWANTED}.\n"}, f"docs/fit.md:1: has “{UNWANTED}”"),
    ],
)
def test_a_breach_is_named_with_its_place(
    tmp_path: Path, rule: str, files: dict[str, str], place: str
) -> None:
    checkout = written(tmp_path, CLEAN | files)
    head, *places = house.check(house.House(checkout), {})
    assert head.startswith(f"{rule}: ")
    assert any(line.strip().startswith(place) for line in places), places
    amount = int(head.removeprefix(f"{rule}: ").partition(",")[0])
    assert house.check(house.House(checkout), {rule: amount}) == []
    assert house.check(house.House(checkout), {rule: amount - 1})


def test_figures_of_a_small_checkout(tmp_path: Path) -> None:
    long = '"""A table.\n\nThis file is long because the standard\'s table is.\n"""\n' + "\n" * 500
    more = {"brdf_suite/pipeline/table.py": long, "apps/brdf_viewer/fit.py": "class SuiteError: ...\n"}
    figures = house.measure(house.House(written(tmp_path, CLEAN | more)))
    assert figures["largest_folder"] == "brdf_suite/pipeline"
    assert figures["pipeline_modules"] == 3
    assert figures["imports_inside_functions"] == 2
    # cli, errors and pipeline; then compiled, fit and table.
    assert figures["names_passed_largest"] == 6
    assert figures["class_names_in_several_rooms"] == 1
    assert figures["files_over_500_lines"] == {"brdf_suite/pipeline/table.py": "the standard's table is"}


@pytest.mark.parametrize(
    ("text", "call"),
    [
        ("import sqlite3\n\nsqlite3.connect('a')\n", "sqlite3.connect"),
        ("import OpenEXR\n\nOpenEXR.File('a')\n", "OpenEXR.File"),
        ("import rawpy\n\nrawpy.imread('a')\n", "rawpy.imread"),
        ("from os import open as o\n\no('a', 0)\n", "o"),
        ("import subprocess as s\n\ns.Popen(['ls'])\n", "s.Popen"),
        ("from functools import partial\n\npartial(open, 'a')\n", "open"),
        ("import os\n\nreader = os.fdopen\n", "os.fdopen"),
        ("from numpy import load\n\nload('a')\n", "load"),
        ("from distributed import LocalCluster\n\nLocalCluster()\n", "LocalCluster"),
        ("from PySide6.QtGui import QPixmap\n\nQPixmap(str(path))\n", "QPixmap"),
        ("from PySide6 import QtGui\n\nQtGui.QImage(f'{folder}/a.png')\n", "QtGui.QImage"),
        ("from PySide6.QtGui import QImage\n\nQImage().load(str(path))\n", "QImage().load"),
        ("from pathlib import Path\n\nPath('a').open()\n", "Path('a').open"),
        ("from pathlib import Path\n\nPath('a').open(mode='rb')\n", "Path('a').open"),
        ("from PIL import ImageFont\n\nImageFont.truetype('a')\n", "ImageFont.truetype"),
        ("from PIL import ImageCms\n\nImageCms.getOpenProfile('a')\n", "ImageCms.getOpenProfile"),
        ("import filecmp\n\nfilecmp.cmp('a', 'b')\n", "filecmp.cmp"),
        ("import ctypes.util\n\nctypes.util.find_library('a')\n", "ctypes.util.find_library"),
        ("import trimesh\n\ntrimesh.load_scene('a')\n", "trimesh.load_scene"),
        ("from lxml import etree\n\netree.parse('a')\n", "etree.parse"),
        ("from xml.etree import ElementTree as ET\n\nET.parse('a')\n", "ET.parse"),
        ("from configparser import ConfigParser\n\nConfigParser().read('a')\n", "ConfigParser"),
        ("import cv2\n\ncv2.imread('a')\n", "cv2.imread"),
        ("import mitsuba as mi\n\nmi.load_file('a')\n", "mi.load_file"),
        ("from reportlab.pdfbase.ttfonts import TTFont\n\nTTFont('a', 'a')\n", "TTFont"),
        (
            "import multiprocessing as m\n\nm.get_context('spawn').Process()\n",
            "m.get_context('spawn').Process",
        ),
        ("import shutil\n\nshutil.make_archive('a', 'zip')\n", "shutil.make_archive"),
    ],
)
def test_direct_accesses_are_seen_under_any_name(tmp_path: Path, text: str, call: str) -> None:
    made = house.House(written(tmp_path, {"brdf_suite/__init__.py": "", "brdf_suite/a.py": text}))
    assert f"calls {call}" in {breach.reason for breach in house.find_direct_accesses(made.product)}


def test_what_only_looks_like_a_direct_access_is_none(tmp_path: Path) -> None:
    text = """
from subprocess import Popen
from PySide6.QtGui import QImage, QPixmap

def use(process: Popen[str], codes: bytes, size: int) -> None:
    QImage(codes, size, size, QImage.Format.Format_RGB888)
    QPixmap(size)
    open_all(codes)
    viewer.open(codes)
    model.load(codes)
"""
    made = house.House(written(tmp_path, {"brdf_suite/__init__.py": "", "brdf_suite/a.py": text}))
    assert house.find_direct_accesses(made.product) == []


def test_every_exception_for_direct_access_is_needed(checkout: Path) -> None:
    found = house.find_direct_accesses(house.House(checkout).product)
    assert set(house.DIRECT_ACCESS) == {
        breach.place.rpartition(":")[0]
        for breach in found
        if breach.place.rpartition(":")[0] in house.DIRECT_ACCESS
    }
