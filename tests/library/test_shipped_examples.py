"""The example scripts and notebooks run as they stand, and show what they say."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

import brdf_suite as bs

CHECKOUT = Path(__file__).resolve().parents[2]
EXAMPLES = CHECKOUT / "examples"
WRITTEN = {
    "measured_to_picture": {"measured.binary", "lobes.svg", "measured.png"},
    "design_and_hand_over": {"sea.brdfpaint", "sea.cxf", "sea.png"},
    "samples_to_factors": {"factors.brdfpaint"},
    "palette_round_trip": {"three.cxf", "three.ase"},
    "photographs_to_paint": {"session", "sphere.brdftable", "sphere.brdfpaint"},
}
SHOWN = {
    "measured_to_picture": {"html": 2, "png": 1},
    "design_and_hand_over": {"html": 1, "png": 1},
    "samples_to_factors": {"html": 2, "png": 0},
    "palette_round_trip": {"html": 1, "png": 0},
    "photographs_to_paint": {"html": 1, "png": 1},
}
SHOW_CELLS = """
import ast, json, sys

names, shown = {}, {"html": 0, "png": 0}
for cell in json.load(open(sys.argv[1], encoding="utf-8"))["cells"]:
    if cell["cell_type"] != "code":
        continue
    tree = ast.parse("".join(cell["source"]))
    last = tree.body.pop() if isinstance(tree.body[-1], ast.Expr) else None
    exec(compile(tree, "cell", "exec"), names)
    if last is None:
        continue
    value = eval(compile(ast.Expression(last.value), "cell", "eval"), names)
    for kind, start in (("html", "<svg"), ("png", b"\\x89PNG")):
        show = getattr(value, f"_repr_{kind}_", None)
        shown[kind] += show is not None and show().startswith(start)
print(json.dumps(shown))
"""


def run(arguments: list[str], folder: Path) -> str:
    done = subprocess.run(
        [sys.executable, *arguments],
        cwd=folder,
        env={**os.environ, "PYTHONIOENCODING": "utf-8"},
        capture_output=True,
        encoding="utf-8",
        timeout=840,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


def written(folder: Path) -> set[str]:
    return {path.name for path in folder.iterdir()}


@pytest.mark.parametrize("name", sorted(WRITTEN))
def test_a_script_of_at_most_ten_lines_writes_its_files(name: str, tmp_path: Path) -> None:
    script = EXAMPLES / f"{name}.py"
    assert len([line for line in script.read_text().splitlines() if line.strip()]) <= 10
    assert run([str(script)], tmp_path).strip()
    assert written(tmp_path) >= WRITTEN[name]


@pytest.mark.parametrize("name", sorted(SHOWN))
def test_a_notebook_runs_and_shows_its_drawings_and_pictures(name: str, tmp_path: Path) -> None:
    printed = run(["-c", SHOW_CELLS, str(EXAMPLES / f"{name}.ipynb")], tmp_path)
    assert json.loads(printed.splitlines()[-1]) == SHOWN[name]


@pytest.mark.parametrize("name", sorted(SHOWN))
def test_a_notebook_is_of_the_current_format_and_without_results(name: str) -> None:
    book = json.loads((EXAMPLES / f"{name}.ipynb").read_text())
    assert (book["nbformat"], book["nbformat_minor"]) == (4, 5)
    identities = [cell["id"] for cell in book["cells"]]
    assert len(set(identities)) == len(identities)
    assert not any(cell.get("outputs") for cell in book["cells"])


PAGES = [
    "README.md",
    *sorted(page.relative_to(CHECKOUT).as_posix() for page in (CHECKOUT / "docs").rglob("*.md")),
]
BLOCK = re.compile(r"^```python\n(.*?)^```", re.DOTALL | re.MULTILINE)
BLOCKS = [
    (page, number)
    for page in PAGES
    for number in range(len(BLOCK.findall((CHECKOUT / page).read_text(encoding="utf-8"))))
]


@pytest.mark.parametrize(("page", "number"), BLOCKS)
def test_the_code_of_a_page_runs(page: str, number: int, tmp_path: Path) -> None:
    code = BLOCK.findall((CHECKOUT / page).read_text(encoding="utf-8"))[number]
    assert run(["-c", code.replace("size=(640, 360)", "size=(64, 36)")], tmp_path).strip()


def test_the_page_of_names_has_all_that_the_library_has() -> None:
    text = (CHECKOUT / "docs/library/reference.md").read_text(encoding="utf-8")
    listed = re.findall(r"^::: brdf_suite\.(\w+)$", text, re.MULTILINE)
    assert sorted(listed) == sorted(set(bs.__all__) - {"__version__"})


def test_every_example_has_a_row() -> None:
    text = (CHECKOUT / "docs/library/python.md").read_text(encoding="utf-8")
    assert set(re.findall(r"^\| `(\w+)` \|", text, re.MULTILINE)) == set(WRITTEN)


def test_every_example_is_tried() -> None:
    assert {path.stem for path in EXAMPLES.glob("*.py")} == set(WRITTEN)
    assert {path.stem for path in EXAMPLES.glob("*.ipynb")} == set(SHOWN)
