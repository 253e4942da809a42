"""The table of measurements and the benchmark runner."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace

import pytest

from brdf_suite.cli.bench import Bound, appendix, measure
from brdf_suite.cli.measurements import write_section
from brdf_suite.errors import SuiteError


def module(**figures: float | None) -> SimpleNamespace:
    bounds = {"fast_ms": ("<=", 5.0, "ms", "how fast"), "info": ("", None, "", "only told")}
    return SimpleNamespace(
        NAME="demo", BOUNDS=bounds, NOTES={"info": "a reason"}, run=lambda progress: figures
    )


def test_a_section_is_replaced_and_others_stay(tmp_path: Path) -> None:
    path = tmp_path / "measurements.md"
    write_section(path, "b", "About b.", [("x", "1 ms", "≤ 2 ms", "yes", "what x is")])
    write_section(path, "a", "About a.", [("y", "3", "–", "", "what y is")])
    write_section(path, "b", "About b.", [("x", "9 ms", "≤ 2 ms", "NO", "what x is")])
    text = path.read_text()
    assert text.count("\n## ") == 2
    assert text.index("## a") < text.index("## b")
    assert "| `x` | 9 ms | ≤ 2 ms | NO | what x is |" in text
    assert "1 ms |" not in text
    assert "| `y` | 3 | – |  | what y is |" in text


def test_an_appendix_follows_its_table_and_is_replaced_with_it(tmp_path: Path) -> None:
    path = tmp_path / "measurements.md"
    row = ("x", "1 ms", "≤ 2 ms", "yes", "what x is")
    bench = module()
    bench.appendix = lambda: "### More\n\n| a |\n|---|\n| 5 |\n"
    write_section(path, "b", "About b.", [row], appendix(bench))
    write_section(path, "c", "About c.", [row], appendix(module()))
    text = path.read_text()
    assert text.index("what x is") < text.index("### More") < text.index("| 5 |") < text.index("## c")
    assert text.endswith("| what x is |\n")
    bench.appendix = lambda: "### More\n\nNothing."
    write_section(path, "b", "About b.", [row], appendix(bench))
    text = path.read_text()
    assert text.count("### More") == 1
    assert "| 5 |" not in text


def test_figures_are_held_against_their_bounds() -> None:
    result = measure(module(fast_ms=4.0, info=None), None)
    rows = {row[0]: row for row in result.rows()}
    assert rows["fast_ms"][1:4] == ("4 ms", "≤ 5 ms", "yes")
    assert rows["info"][1:] == ("not measured", "–", "", "only told (a reason)")
    assert {row[0]: row[3] for row in measure(module(fast_ms=6.0, info=1), None).rows()}["fast_ms"] == "NO"
    answer = result.to_json()
    assert list(answer) == ["bench", "machine", "figures", "notes"]
    assert answer["figures"] == {"fast_ms": 4.0, "info": None}


def test_tables_go_into_the_object_that_json_prints() -> None:
    bench = module(fast_ms=4.0, info=None)
    bench.TABLES = {"info": {"matt": {"albedo": [[0.5, 0.5, 0.5]]}}}
    answer = measure(bench, None).to_json()
    assert answer["tables"] == {"info": {"matt": {"albedo": [[0.5, 0.5, 0.5]]}}}


def test_undeclared_or_infinite_figures_are_a_fault() -> None:
    with pytest.raises(SuiteError, match="declares"):
        measure(module(fast_ms=1.0), None)
    with pytest.raises(SuiteError, match="inf"):
        measure(module(fast_ms=float("inf"), info=None), None)


def test_bounds_compare_both_ways() -> None:
    assert Bound(">=", 60.0, "", "").holds(61.0) is True
    assert Bound(">=", 60.0, "", "").holds(59.0) is False
    assert Bound("<=", 1.0, "", "").holds(None) is None
