"""``docs/measurements.md``: one section for each benchmark, rewritten by ``brdf-suite bench --write``."""

from __future__ import annotations

import datetime
from collections.abc import Sequence
from pathlib import Path

from brdf_suite.cli.machine import summary

_TITLE = """\
# Measurements

Written by `brdf-suite bench --all --write`; the text of a section is its benchmark's own. A figure says what
it was on the machine and day named; ratios are taken within one run.
"""
_HEADER = "| figure | value | bound | kept | what it is |\n|---|---|---|---|---|"


def write_section(
    path: Path, name: str, about: str, rows: Sequence[tuple[str, str, str, str, str]], appendix: str = ""
) -> None:
    """Replace, or add, the section of benchmark ``name``; the others stay as they are.

    ``appendix`` is Markdown that follows the table; a heading of the second level in it would begin a section.
    """
    sections = _read(path)
    table = "\n".join(
        f"| `{key}` | {value} | {bound} | {kept} | {meaning} |" for key, value, bound, kept, meaning in rows
    )
    today = datetime.datetime.now(datetime.UTC).date().isoformat()
    source = f"`brdf-suite bench {name} --json` · {summary()} · {today}"
    more = f"\n{appendix.strip()}\n" if appendix.strip() else ""
    sections[name] = f"{about}\n\n{source}\n\n{_HEADER}\n{table}\n{more}"
    body = "\n".join(f"## {key}\n\n{text}" for key, text in sorted(sections.items()))
    path.write_text(f"{_TITLE}\n{body}", encoding="utf-8")


def _read(path: Path) -> dict[str, str]:
    if not path.exists():
        return {}
    _head, *sections = path.read_text(encoding="utf-8").split("\n## ")
    parts = (section.partition("\n") for section in sections)
    return {name.strip(): text.strip() + "\n" for name, _newline, text in parts}
