"""The report as one HTML file that needs nothing beside it: pictures, plots, numbers, and the paint as data.

The data stand in a script element of the type ``application/json``, as in the JSON export; they are what is read back.
"""

from __future__ import annotations

import base64
import json
from functools import partial

from brdf_suite.appearance.texture import SCALE
from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.exports import json_document
from brdf_suite.files.exports.format import ExportFormat, ImportedPaints
from brdf_suite.foreign_text import escape_html
from brdf_suite.regular_files import read_bytes
from brdf_suite.release import __version__
from brdf_suite.reports.paint_report.document import (
    Report,
    ReportOptions,
    ReportRow,
    report_losses,
    write_report,
)
from brdf_suite.reports.paint_report.plots import STYLES, Mark, PlotLine, Stroke, plots_of

_OPEN = f'<script type="application/json" id="{json_document.NAME}">'
_CLOSE = "</script>"
_LARGEST = 64 << 20

_STYLE = """
:root { color-scheme: light; }
* { box-sizing: border-box; }
body { margin: 0; background: #b9b9b9; color: #1a1a1a; font: 13px/1.4 system-ui, "Helvetica Neue", Arial, sans-serif; }
main { max-width: 900px; margin: 24px auto; padding: 40px 44px; background: #fff; }
header { display: flex; align-items: baseline; gap: 16px; border-bottom: 2px solid #1a1a1a; padding-bottom: 8px; }
h1 { margin: 0; font-size: 30px; font-weight: 650; letter-spacing: -.01em; flex: 1; overflow-wrap: anywhere; }
h2 { margin: 0 0 4px; font-size: 12px; font-weight: 650; }
header time, .soft, figcaption { color: #5c5c5c; }
figure { margin: 0; } figcaption { font-size: 11px; margin-top: 3px; }
.pictures { display: grid; grid-template-columns: 65fr 32.5fr; gap: 12px; margin: 16px 0; }
.pictures img { width: 100%; display: block; }
.strip { height: 20px; } .patches { display: flex; gap: 8px; margin: 8px 0 16px; }
.patch { flex: 1; font-variant-numeric: tabular-nums; } .patch div { height: 64px; }
.patch b { display: block; margin-top: 4px; }
.plots { display: grid; grid-template-columns: repeat(3, 1fr); gap: 10px; margin: 14px 0 4px; }
svg { width: 100%; display: block; }
table { border-collapse: collapse; width: 100%; font-variant-numeric: tabular-nums; }
th { font-weight: 500; color: #5c5c5c; text-align: right; } td { text-align: right; }
th, td { padding: 3px 6px; border-bottom: 1px solid #e3e3e3; } th:first-child, td:first-child { text-align: left; }
.figures { display: grid; grid-template-columns: repeat(3, 1fr); gap: 24px; margin: 18px 0; }
.figures td { border: 0; padding: 1px 0; } .verdict { margin: 12px 0; font-weight: 650; }
.out { color: #5c5c5c; } .computed { font-style: italic; } .fail { font-weight: 650; }
footer { border-top: 1px solid #cfcfcf; margin-top: 14px; padding-top: 8px; color: #5c5c5c; font-size: 11px; }
@page { size: A4; margin: 11mm; }
@media print { body { background: #fff; font-size: 9.5px; } main { margin: 0; padding: 0; max-width: none; }
  * { print-color-adjust: exact; -webkit-print-color-adjust: exact; } .patch div { height: 40px; }
  h1 { font-size: 26px; } h2 { font-size: 10px; } p, .verdict { margin: 5px 0; }
  figcaption, footer { font-size: 8.5px; }
  .pictures, .plots, .figures { margin: 9px 0; } .patches { margin: 6px 0 8px; } th, td { padding: 2px 5px; } }
@media (max-width: 640px) { main { padding: 20px; margin: 0; } .figures, .plots { grid-template-columns: 1fr; }
  .patches { flex-wrap: wrap; } .patch { min-width: 28%; } table { font-size: 11px; } }
"""


def format_with(options: ReportOptions) -> ExportFormat:
    """Return the format, its reports made with these options."""
    return ExportFormat(
        name="html",
        title="Report, HTML",
        ending=".html",
        holds="One page with pictures, plots and numbers; the paint itself goes along as data.",
        losses=report_losses,
        write=partial(write_report, options, lambda made: (page(made).encode("utf-8"), ())),
        read=read,
        sniff=is_report,
    )


def page(made: Report) -> str:
    """Return the whole page."""
    data = json.dumps(json_document.document([made.item]), allow_nan=False).replace("<", "\\u003c")
    return (
        '<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">\n'
        f'<meta name="generator" content="BRDF Suite {__version__}">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f"<title>{escape_html(made.title)}</title>\n<style>{_STYLE}</style>\n{_OPEN}{data}{_CLOSE}\n</head><body><main>\n"
        f"<header><h1>{escape_html(made.title)}</h1>"
        f'<time datetime="{made.when.isoformat(timespec="minutes")}">{made.when:%d %B %Y}</time></header>\n'
        + _pictures(made)
        + _patches(made)
        + (f'<p class="verdict">{escape_html(made.verdict)}</p>\n' if made.verdict else "")
        + _table(made)
        + _plots(made)
        + _figures(made)
        + "".join(f"<p>{escape_html(text)}</p>\n" for text in made.remarks)
        + f"<footer>{escape_html(conventions(made))}</footer>\n</main></body></html>\n"
    )


def conventions(made: Report) -> str:
    """Return the line that says what the numbers mean."""
    return (
        f"L*a*b*: CIE 1976, D65, 10° observer; light at {made.light_deg:g}° unless said otherwise, angles counted "
        "from the mirror direction. Gloss: ASTM D523. Fit: what the lobes of the picture give. Numbers in italics are "
        f"computed, not read. Sparkle and graininess: {SCALE}, computed; not a maker's index. "
        f"BRDF Suite {__version__}."
    )


def _pictures(made: Report) -> str:
    if not made.pictures:
        return ""
    figures = "".join(
        f'<figure><img width="{picture.width}" height="{picture.height}" '
        f'alt="{escape_html(made.title)} on {escape_html(picture.title)}" '
        f'src="data:image/png;base64,{base64.b64encode(picture.png).decode("ascii")}">'
        f"<figcaption>{escape_html(picture.title)}</figcaption></figure>"
        for picture in made.pictures
    )
    return f'<div class="pictures">{figures}</div>\n'


def _patches(made: Report) -> str:
    angles = [angle for angle, _ in made.strip]
    span = max(angles[-1] - angles[0], 1e-9)
    stops = ", ".join(
        f"{code} {100.0 * (angle - angles[0]) / span:.1f}%"
        for angle, code in made.strip[:: max(1, len(angles) // 48)]
    )
    patches = "".join(
        f'<div class="patch"><div style="background:{row.code}"></div><b>{row.label}</b>'
        f"{row.lab[0]:.1f} · {row.lab[1]:.1f} · {row.lab[2]:.1f}"
        + ("" if row.in_gamut else '<br><span class="out">outside sRGB</span>')
        + "</div>"
        for row in made.rows
    )
    return (
        f'<div class="strip" role="img" aria-label="flop from {angles[0]:g} to {angles[-1]:g} degrees" '
        f'style="background:linear-gradient(90deg, {stops})"></div>\n<div class="patches">{patches}</div>\n'
    )


HEADINGS = ("Angle", "L*", "a*", "b*", "C*", "h", "Fit ΔE00")
_STANDARD_HEADINGS = ("ΔE00", "ΔL*", "ΔC*", "ΔH*")


def standard_headings(made: Report) -> tuple[str, ...]:
    """Return the headings of what a standard adds; the last one is of pass or fail, where that is judged."""
    judged = made.batch is not None and made.batch.passes is not None
    return (*_STANDARD_HEADINGS, "Tolerance") if judged else _STANDARD_HEADINGS


def cells(row: ReportRow) -> list[tuple[str, bool]]:
    """Return the numbers of a row of the table, and whether each is computed."""
    numbers: list[tuple[str, bool]] = [(row.label, False)]
    numbers += [(f"{value:.2f}", False) for value in (*row.lab, row.lch[1])]
    numbers.append((f"{row.lch[2]:.1f}°" if row.lch[1] >= 0.05 else "–", False))
    numbers.append(("–" if row.fit_delta_e is None else f"{row.fit_delta_e:.2f}", True))
    return numbers


def standard_cells(row: ReportRow) -> list[tuple[str, bool]]:
    """Return the numbers of a row against the standard, and whether the standard there is computed."""
    found = row.standard
    if found is None or found.verdict is None:
        return [("–", False)] * len(_STANDARD_HEADINGS) + [("", False)]
    verdict = found.verdict
    passes = {True: "pass", False: "fail", None: ""}[verdict.passes]
    numbers = (
        found.differences.get("2000", verdict.difference),
        verdict.lightness,
        verdict.chroma,
        verdict.hue,
    )
    texts = [
        f"{numbers[0]:.2f}" + ("" if found.supported else "†"),
        *(f"{value:+.2f}" for value in numbers[1:]),
    ]
    return [*((text, found.computed) for text in texts), (passes, False)]


def _table(made: Report) -> str:
    headings = [*HEADINGS, *(standard_headings(made) if made.batch is not None else ())]
    head = "".join(f"<th>{heading}</th>" for heading in headings)
    rows = []
    for row in made.rows:
        found = [*cells(row), *(standard_cells(row) if made.batch is not None else ())][: len(headings)]
        texts = (
            f"<td{' class=computed' if computed else ' class=fail' if text == 'fail' else ''}>{text}</td>"
            for text, computed in found
        )
        rows.append(f"<tr>{''.join(texts)}</tr>")
    return f"<table><thead><tr>{head}</tr></thead><tbody>{''.join(rows)}</tbody></table>\n"


def _plots(made: Report) -> str:
    plots = "".join(
        f'<svg viewBox="0 0 {plot.width:g} {plot.height:g}" role="img" aria-label="{escape_html(plot.title)}">'
        f"{''.join(map(stroke_svg, plot.strokes))}</svg>"
        for plot in plots_of(made, 200.0, 140.0)
    )
    key = " &nbsp; ".join(
        '<svg viewBox="0 0 26 6" style="width:26px;display:inline" aria-hidden="true">'
        f"{stroke_svg(PlotLine(((0.0, 3.0), (26.0, 3.0)), *STYLES[curve.title]))}</svg> {curve.title}"
        for curve in made.curves
    )
    marks = " &nbsp; ● readings" + (" &nbsp; □ standard" if made.batch is not None else "")
    return f'<div class="plots">{plots}</div>\n<p class="soft">{key}{marks}</p>\n'


def stroke_svg(stroke: Stroke) -> str:
    """Return a stroke of a plot as an SVG element."""
    if isinstance(stroke, PlotLine):
        points = " ".join(f"{x:.2f},{y:.2f}" for x, y in stroke.points)
        dashes = (
            f' stroke-dasharray="{" ".join(f"{dash:g}" for dash in stroke.dashes)}"' if stroke.dashes else ""
        )
        return (
            f'<polyline points="{points}" fill="none" stroke="{stroke.colour}" stroke-width="{stroke.width:g}"{dashes} '
            'stroke-linejoin="round"/>'
        )
    if isinstance(stroke, Mark):
        if stroke.filled:
            return f'<circle cx="{stroke.x:.2f}" cy="{stroke.y:.2f}" r="2.3" fill="{stroke.colour}"/>'
        return (
            f'<rect x="{stroke.x - 2.4:.2f}" y="{stroke.y - 2.4:.2f}" width="4.8" height="4.8" fill="#fff" '
            f'stroke="{stroke.colour}" stroke-width="1"/>'
        )
    weight = ' font-weight="650"' if stroke.bold else ""
    return (
        f'<text x="{stroke.x:.2f}" y="{stroke.y:.2f}" font-size="{stroke.size:g}" text-anchor="{stroke.anchor}" '
        f'fill="{stroke.colour}"{weight}>{escape_html(stroke.text)}</text>'
    )


def _figures(made: Report) -> str:
    groups = []
    for title, figures in made.figures:
        rows = "".join(
            f"<tr><td>{escape_html(name)}</td><td>{escape_html(value)}</td></tr>" for name, value in figures
        )
        groups.append(f"<section><h2>{escape_html(title)}</h2><table>{rows}</table></section>")
    return f'<div class="figures">{"".join(groups)}</div>\n'


def is_report(head: bytes) -> bool:
    """Return whether the first bytes of a file are those of a page of ours."""
    return head.lstrip(b"\xef\xbb\xbf \t\r\n")[:15].lower() == b"<!doctype html>" and _OPEN.encode() in head


def read(path: PathLike) -> ImportedPaints:
    """Return the paint in the data of a page; raise :class:`FileError` where they are damaged."""
    content = read_bytes(path, _LARGEST)
    start = content.find(_OPEN.encode())
    end = content.find(_CLOSE.encode(), start)
    if start < 0 or end < 0:
        raise FileError(path, "holds no paint of this suite")
    return json_document.import_text(content[start + len(_OPEN) : end], path)
