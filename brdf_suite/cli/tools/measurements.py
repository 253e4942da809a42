"""Benchmark figures and the machine they are of: ``docs/method/measurements.json``, and the page made from it."""

from __future__ import annotations

import datetime
import json
import os
import platform
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import Any

from brdf_suite.errors import GraphicsError
from brdf_suite.pipeline.picture import gl_renderer_name

_TITLE = """\
# Measurements

Generated from `measurements.json` by `brdf-suite bench NAME --write` (`--all`: every benchmark). A figure is valid for
the machine and day named; ratios are taken within one run. `packaging/documents/insert_figures.py` copies figures to
other pages.
"""
_HEADER = "| figure | value | bound | met | description |\n|---|---|---|---|---|"
_COMPARE = {"<=": lambda value, bound: value <= bound, ">=": lambda value, bound: value >= bound}


@dataclass(frozen=True)
class Bound:
    """Bound of a figure; ``comparison`` is ``<=``, ``>=`` or ``""`` (information only)."""

    comparison: str
    bound: float | None
    unit: str
    meaning: str

    def text(self) -> str:
        """Return the bound as people write it."""
        sign = {"<=": "≤", ">=": "≥"}.get(self.comparison)
        return "–" if sign is None or self.bound is None else f"{sign} {self.bound:g} {self.unit}".rstrip()

    def holds(self, value: float | None) -> bool | None:
        """Return whether ``value`` keeps the bound; ``None`` where there is none or no value."""
        compare = _COMPARE.get(self.comparison)
        return None if compare is None or value is None or self.bound is None else compare(value, self.bound)


@dataclass
class Result:
    """The figures of one benchmark run."""

    name: str
    figures: dict[str, float | None]
    bounds: dict[str, Bound]
    notes: dict[str, str] = field(default_factory=dict)
    tables: dict[str, dict[str, object]] = field(default_factory=dict)

    def to_json(self, machine: Mapping[str, object]) -> dict[str, object]:
        """Return the one object that ``--json`` prints."""
        answer: dict[str, object] = {"bench": self.name, "machine": machine, "figures": self.figures}
        if self.notes:
            answer["notes"] = self.notes
        if self.tables:
            answer["tables"] = self.tables
        return answer

    def rows(self) -> Iterator[tuple[str, str, str, str, str]]:
        """Yield (key, value, bound, kept, meaning) for a table."""
        for key, value in self.figures.items():
            bound = self.bounds[key]
            shown = "not measured" if value is None else f"{value:.4g} {bound.unit}".rstrip()
            kept = {True: "yes", False: "NO", None: ""}[bound.holds(value)]
            meaning = bound.meaning + (f" ({self.notes[key]})" if key in self.notes else "")
            yield key, shown, bound.text(), kept, meaning


@dataclass(frozen=True)
class ReportSection:
    """One benchmark's section of the page; ``appendix`` is Markdown with headings of the third level, or empty."""

    about: str
    machine: str
    date: str
    result: Result
    appendix: str = ""

    def to_json(self) -> dict[str, object]:
        """Return what ``measurements.json`` keeps of it; values have four significant digits, as on the page."""
        result = self.result
        figures = {
            key: {
                "value": None if value is None else float(f"{value:.4g}"),
                "unit": result.bounds[key].unit,
                "comparison": result.bounds[key].comparison,
                "bound": result.bounds[key].bound,
                "meaning": result.bounds[key].meaning,
                "note": result.notes.get(key, ""),
            }
            for key, value in result.figures.items()
        }
        return {
            "about": self.about,
            "machine": self.machine,
            "date": self.date,
            "figures": figures,
            "appendix": self.appendix.strip(),
        }

    @classmethod
    def from_json(cls, name: str, kept: Mapping[str, Any]) -> ReportSection:
        """Return the section that :meth:`to_json` wrote."""
        rows = kept["figures"]
        bounds = {
            key: Bound(row["comparison"], row["bound"], row["unit"], row["meaning"])
            for key, row in rows.items()
        }
        figures = {key: row["value"] for key, row in rows.items()}
        notes = {key: row["note"] for key, row in rows.items() if row["note"]}
        result = Result(name, figures, bounds, notes)
        return cls(kept["about"], kept["machine"], kept["date"], result, kept["appendix"])

    def markdown(self) -> str:
        """Return the section as it stands on the page."""
        name = self.result.name
        rows = "\n".join(
            f"| `{key}` | {value} | {bound} | {kept} | {meaning} |"
            for key, value, bound, kept, meaning in self.result.rows()
        )
        source = f"`brdf-suite bench {name} --json` · {self.machine} · {self.date}"
        more = f"\n{self.appendix.strip()}\n" if self.appendix.strip() else ""
        return f"## {name}\n\n{self.about}\n\n{source}\n\n{_HEADER}\n{rows}\n{more}"


def today() -> str:
    """Return the date in UTC, as ISO writes it."""
    return datetime.datetime.now(datetime.UTC).date().isoformat()


def renew_section(docs: Path, section: ReportSection) -> None:
    """Replace, or add, one benchmark's figures in ``measurements.json`` and write the page; others stay."""
    path = docs / "measurements.json"
    kept = json.loads(path.read_text(encoding="utf-8")) if path.exists() else {}
    kept[section.result.name] = section.to_json()
    text = json.dumps(dict(sorted(kept.items())), ensure_ascii=False, indent=1)
    path.write_text(text + "\n", encoding="utf-8")
    (docs / "measurements.md").write_text(page(docs), encoding="utf-8")


def page(docs: Path) -> str:
    """Return the text of ``measurements.md`` for the figures in ``measurements.json``."""
    kept = json.loads((docs / "measurements.json").read_text(encoding="utf-8"))
    sections = (ReportSection.from_json(name, section).markdown() for name, section in kept.items())
    return f"{_TITLE}\n" + "\n".join(sections)


@cache
def describe_machine() -> dict[str, object]:
    """Return processor, cores that this process may use, memory in GiB, system, Python and GL renderer."""
    return {
        "processor": _processor(),
        "cores": len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count(),
        "memory_gib": _memory_gib(),
        "system": f"{platform.system()} {platform.machine()}",
        "python": platform.python_version(),
        "gl_renderer": _gl_renderer(),
    }


def machine_summary() -> str:
    """Return the machine in one short line."""
    machine = describe_machine()
    return f"{machine['processor']}, {machine['cores']} cores, {machine['gl_renderer']}"


def _processor() -> str:
    try:
        lines = Path("/proc/cpuinfo").read_text().splitlines()
    except OSError:
        return platform.processor() or platform.machine()
    names = (line.partition(":")[2].strip() for line in lines if line.startswith("model name"))
    return next(names, platform.machine())


def _memory_gib() -> float | None:
    if not hasattr(os, "sysconf") or "SC_PHYS_PAGES" not in os.sysconf_names:
        return None
    return round(os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE") / 2**30, 1)


def _gl_renderer() -> str:
    try:
        return gl_renderer_name()
    except GraphicsError as error:
        return f"none: {error}"
