"""Insert measured figures into the documents, and the tables that are computed from committed data.

    python packaging/documents/insert_figures.py [--check]

A figure of docs/method/measurements.json stands in README.md, CONTRIBUTING.md or docs/**/*.md between two markers:

    <!--figure edit.edit_overhead_median_ms-->1.8 ms<!--/-->

The marker names benchmark and figure; behind them may follow the number of significant digits (default 2) and a unit
that the value is converted to (``s``, ``ms``, ``%``; ``bare`` for the number alone): ``<!--figure a.b 3 ms-->``.
A table stands between ``<!--table NAME-->`` and ``<!--/table-->``; NAME is a key of ``TABLES``. A marker that begins
behind a backtick is text.
``--check`` changes nothing and fails where a document differs.
"""

from __future__ import annotations

import argparse
import json
import math
import re
import sys
from pathlib import Path
from typing import Any

from brdf_suite.errors import SuiteError

CHECKOUT = Path(__file__).resolve().parents[2]
FIGURE = re.compile(
    r"(?<!`)<!--figure\s+(?P<name>\S+?)(?P<format>(?:\s+\S+?)*?)\s*-->(?P<text>[^<\n]*)<!--/-->"
)
TABLE = re.compile(r"(?<!`)<!--table\s+(?P<name>\S+?)-->\n(?P<text>.*?)<!--/table-->", re.DOTALL)
OPENING = re.compile(r"(?<!`)<!--\s*(figure|table)\b")
FACTORS = {("s", "ms"): 1e3, ("ms", "s"): 1e-3, ("", "%"): 1e2}
DIGITS = 2


class MarkerError(SuiteError):
    """A marker that cannot be filled; the message names file and line."""


def number(value: float, digits: int) -> str:
    """Return ``value`` with so many significant digits, as the documents write numbers: 0.037, 1,400, 5.5·10⁻¹³."""
    if value == 0.0:
        return "0"
    exponent = math.floor(math.log10(abs(float(f"{value:.{digits - 1}e}"))))
    if exponent < -4:
        mantissa = f"{value / 10.0**exponent:.{digits - 1}f}"
        return f"{mantissa}·10{str(exponent).translate(str.maketrans('-0123456789', '⁻⁰¹²³⁴⁵⁶⁷⁸⁹'))}"
    return f"{round(value, digits - 1 - exponent):,.{max(0, digits - 1 - exponent)}f}"


def figure(measurements: dict[str, Any], name: str, options: list[str]) -> str:
    """Return the text for a marker; raise :class:`MarkerError` for an unknown or unmeasured figure or option."""
    bench, _, key = name.partition(".")
    row = measurements.get(bench, {}).get("figures", {}).get(key)
    if row is None:
        raise MarkerError(f"docs/method/measurements.json has no figure {name!r}")
    if row["value"] is None:
        raise MarkerError(f"the figure {name!r} was not measured")
    digits = int(options.pop(0)) if options and options[0].isdigit() else DIGITS
    value, unit = row["value"], row["unit"]
    if options:
        wanted = options.pop(0)
        if wanted not in ("bare", unit):
            if (unit, wanted) not in FACTORS:
                raise MarkerError(
                    f"the figure {name!r} is in {unit or 'no unit'}, which is not converted to {wanted}"
                )
            value *= FACTORS[unit, wanted]
        unit = "" if wanted == "bare" else wanted
    if options or digits < 1:
        raise MarkerError(f"the marker of {name!r} has options that are not digits and a unit")
    return f"{number(value, digits)} {unit}".rstrip()


def basis_table() -> str:
    """Return the search of the lobe basis, a row for each number of lobes, from resources/basis/search.json."""
    search = json.loads((CHECKOUT / "resources" / "basis" / "search.json").read_text(encoding="utf-8"))
    lines = ["| lobes | maximum | mean | equation 4 | exponents |", "|---|---|---|---|---|"]
    for row in search["results"]:
        count = f"**{row['count']}**" if row["count"] == search["default_count"] else str(row["count"])
        exponents = ", ".join(f"{e:,.0f}" if e >= 1000 else f"{e:.4g}" for e in row["exponents"])
        errors = " | ".join(f"{row[key]:.2f}" for key in ("maximum", "mean", "equation_4"))
        lines.append(f"| {count} | {errors} | {exponents} |")
    return "\n".join(lines) + "\n"


EXCHANGE_CLIENTS = {
    "blender": "glTF in Blender",
    "luxcore": "LuxCore",
    "usd": "USD in Blender",
    "openpbr": "OpenPBR in MaterialX",
    "rgl": "RGL in Mitsuba",
}
"""Formats in the programs that render them, as docs/method/exchange.json names them."""


def exchange_figures() -> dict[str, dict[str, dict[str, float]]]:
    """Return the losses, reported and seen, by paint and client, which packaging/pictures/exchange.py measured."""
    found = json.loads((CHECKOUT / "docs" / "method" / "exchange.json").read_text(encoding="utf-8"))
    return dict(sorted(found.items()))


def paint_class(name: str) -> str:
    """Return the class of a shipped paint: solid without flakes, pearl by its name, else metallic."""
    paint = json.loads((CHECKOUT / "resources" / "paints" / f"{name}.brdfpaint").read_text(encoding="utf-8"))
    if paint.get("flakes") is None:
        return "solid"
    return "pearl" if name.endswith(("pearl", "_shift")) else "metallic"


def exchange_table() -> str:
    """Return the loss of every paint in every client, as reported and as seen."""
    lines = [f"| paint | {' | '.join(EXCHANGE_CLIENTS.values())} |", f"|---|{'---|' * len(EXCHANGE_CLIENTS)}"]
    for name, figures in exchange_figures().items():
        cells = (
            f"{figures[client]['reported']:.2f} / {figures[client]['seen']:.2f}" if client in figures else "–"
            for client in EXCHANGE_CLIENTS
        )
        lines.append(f"| {name.replace('_', ' ')} | {' | '.join(cells)} |")
    return "\n".join(lines) + "\n"


def exchange_summary() -> str:
    """Return the mean loss of each class in each client, the worst paint, and how many are as reported."""
    figures = exchange_figures()
    lines = [
        "| export | solid | metallic | pearl | worst paint | as reported |",
        "|---|---|---|---|---|---|",
    ]
    for client, title in EXCHANGE_CLIENTS.items():
        found = {name: row[client] for name, row in figures.items() if client in row}
        cells = []
        for kind in ("solid", "metallic", "pearl"):
            seen = [one["seen"] for name, one in found.items() if paint_class(name) == kind]
            cells.append(f"{sum(seen) / len(seen):.2f} ({len(seen)})" if seen else "–")
        worst = max(found, key=lambda name: found[name]["seen"])
        kept = sum(
            abs(one["seen"] - one["reported"]) <= max(0.5, 0.2 * one["reported"]) for one in found.values()
        )
        cells += [f"{found[worst]['seen']:.2f}, {worst.replace('_', ' ')}", f"{kept} of {len(found)}"]
        lines.append(f"| {title} | {' | '.join(cells)} |")
    return "\n".join(lines) + "\n"


TABLES = {"basis": basis_table, "exchange": exchange_table, "exchange_summary": exchange_summary}


def filled(text: str, measurements: dict[str, Any], place: str) -> str:
    """Return the document ``text`` with every marker filled; errors begin with ``place`` and the line."""

    def at(start: int) -> str:
        return f"{place}:{text.count(chr(10), 0, start) + 1}"

    def insert_figure(match: re.Match[str]) -> str:
        try:
            shown = figure(measurements, match["name"], match["format"].split())
        except MarkerError as error:
            raise MarkerError(f"{at(match.start())}: {error}") from None
        return f"<!--figure {match['name']}{match['format']}-->{shown}<!--/-->"

    def insert_table(match: re.Match[str]) -> str:
        if match["name"] not in TABLES:
            raise MarkerError(f"{at(match.start())}: there is no table {match['name']!r}")
        return f"<!--table {match['name']}-->\n{TABLES[match['name']]()}<!--/table-->"

    whole = {match.start() for pattern in (FIGURE, TABLE) for match in pattern.finditer(text)}
    for match in OPENING.finditer(text):
        if match.start() not in whole:
            raise MarkerError(f"{at(match.start())}: a marker without an end, or with more than one value")
    return TABLE.sub(insert_table, FIGURE.sub(insert_figure, text))


def documents(checkout: Path) -> list[Path]:
    """Return the documents that may hold markers."""
    return [checkout / "README.md", checkout / "CONTRIBUTING.md", *sorted((checkout / "docs").rglob("*.md"))]


def insert_into_documents(checkout: Path, *, check: bool = False) -> list[Path]:
    """Fill every document's markers from ``checkout``'s measurements; return those that differed."""
    measurements = json.loads(
        (checkout / "docs" / "method" / "measurements.json").read_text(encoding="utf-8")
    )
    different = []
    for path in documents(checkout):
        old = path.read_text(encoding="utf-8")
        new = filled(old, measurements, path.relative_to(checkout).as_posix())
        if new != old:
            different.append(path)
            if not check:
                path.write_text(new, encoding="utf-8")
    return different


def main() -> int:
    """Insert, or check; 1 where a marker cannot be filled or, with ``--check``, a document differs."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--check", action="store_true", help="change nothing; fail where a document differs")
    check = parser.parse_args().check
    try:
        different = insert_into_documents(CHECKOUT, check=check)
    except MarkerError as error:
        print(error, file=sys.stderr)
        return 1
    for path in different:
        print(
            f"{path.relative_to(CHECKOUT)}: {'differs from' if check else 'renewed from'} docs/method/measurements.json"
        )
    return 1 if check and different else 0


if __name__ == "__main__":
    sys.exit(main())
