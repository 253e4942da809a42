"""No document states a measured time, memory or colour difference by hand.

What is looked for is how measured figures are worded; limits, sizes and tolerances that the program sets are worded
otherwise.
"""

from __future__ import annotations

import re
from pathlib import Path

import pytest

GENERATED = {"agreement.md", "measured_errors.md", "measurements.md", "table1.md"}
OF_THEIR_DAY = {"decisions.md"}
NUMBER = r"(?<![\w.,])\.?\d[\d.,]*"
UNIT = r"\s(?:ms|µs|s|seconds?|minutes?|MB|GB|MiB|GiB|kB)\b"
STATISTIC = r"\b(?:mean|median|worst|largest|average|RMS|percentile)\b"
MEASURED = re.compile(
    "|".join(
        (
            rf"\b(?:takes?|took|taking|costs?|ready after|comes? after)[^.,|;:(]{{0,30}}?{NUMBER}{UNIT}",
            rf"{NUMBER}{UNIT},? (?:in the median|at the 99th|on (?:one|two|\d+)|of (?:one|a|the) (?:core|processor))",
            rf"{STATISTIC}[^.|;:]{{0,40}}?{NUMBER}\s(?:ΔE00|%|dB|MB|ms|s)(?!\w)",
            rf"{STATISTIC} ΔE00[^|;:]{{0,30}}?{NUMBER}(?![\d.,]*°)",
            rf"\b(?:by|miss|misses|to|than) {NUMBER}(?: to {NUMBER})? ΔE00",
            r"\bload of (?:about )?\d|\bbusy cores|\bshared cores",
        )
    )
)
MARKED = re.compile(
    r"<!--figure.*?<!--/-->|<!--table.*?<!--/table-->|<!-- (\w+): begin -->.*?<!-- \1: end -->", re.DOTALL
)
CODE = re.compile(r"^```.*?^```|^    .*?$|`[^`\n]*`|\]\([^)\n]*\)", re.DOTALL | re.MULTILINE)
HEAD = re.compile(r"\b(?:mean|median|worst|largest|longest|percentile|RMS|SNR|FLIP|ms|MB)\b")
CELL = re.compile(rf"[<>≤]?\s*-?{NUMBER}(?:{UNIT}|\s(?:ΔE00|%|dB))?")
GIVEN = re.compile(r"paper|bound|lobes|number")
"""Columns that hold no measurement of ours: published values, bounds, and what a row is about."""


def hidden(match: re.Match[str]) -> str:
    """Return text of the same length and lines, in which nothing is found."""
    return re.sub(r"[^\n]", "\N{NO-BREAK SPACE}", match[0])


def unmarked(text: str) -> list[str]:
    """Return what reads like a measured figure outside markers and code, and numbers in tables of statistics."""
    text = CODE.sub(hidden, MARKED.sub(hidden, text))
    lines = text.split("\n")
    found = [match[0] for match in MEASURED.finditer(" ".join(lines))]
    for row, line in enumerate(lines[:-1]):
        if not (line.startswith("|") and re.fullmatch(r"[|:-]+", lines[row + 1]) and HEAD.search(line)):
            continue
        heads = [head.strip() for head in line.strip("|").split("|")]
        for below in lines[row + 2 :]:
            if not below.startswith("|"):
                break
            cells = [cell.strip() for cell in below.strip("|").split("|")]
            found += [
                f"{head}: {cell}"
                for head, cell in zip(heads, cells, strict=False)
                if CELL.fullmatch(cell) and not GIVEN.search(head)
            ]
    return found


def test_no_document_states_a_measured_figure_by_hand(checkout: Path) -> None:
    documents = [checkout / "README.md", checkout / "CONTRIBUTING.md", *(checkout / "docs").rglob("*.md")]
    found = [
        (path.name, words)
        for path in documents
        if path.name not in GENERATED | OF_THEIR_DAY
        for words in unmarked(path.read_text(encoding="utf-8"))
    ]
    assert found == []


@pytest.mark.parametrize(
    "text",
    [
        "Filtering takes 3.2 s on two cores.",
        "The fit takes about .2 ms.",
        "It was 12 ms in the median.",
        "a mean ΔE00 of 1.1 over all",
        "a mean\nΔE00 of 2.62",
        "the worst paint misses by 12 ΔE00",
        "the median error is 0.5 %",
        "as measured at a load of 8",
        "| paint | mean ΔE00 |\n|---|---|\n| blue | 1.1 |",
        "| file | longest |\n|---|---|\n| a.exr | 4.66 s |",
    ],
)
def test_a_measured_figure_is_found(text: str) -> None:
    assert unmarked(text)


@pytest.mark.parametrize(
    "text",
    [
        "Filtering takes <!--figure prefilter.default_1k_s-->0.37 s<!--/--> on two cores.",
        "The limit is 4 ms for a whole fit.",
        "Files over 64 MB are refused.",
        "A reading that is missed by more than ΔE00 1 is marked.",
        "the mean ΔE00 over 15°, 45° and 110°",
        "| SNR in dB | paper | ours |\n|---|---|---|\n| fitted | 13.40 | <!--figure a.b-->13.45<!--/--> |",
        "    takes 3.2 s on two cores",
    ],
)
def test_limits_bounds_and_marked_figures_are_not(text: str) -> None:
    assert not unmarked(text)
