"""What the window shows of a comparison with a standard, worked out at once as frozen values; widgets only draw it."""

from __future__ import annotations

from dataclasses import dataclass

from brdf_qt.program.translation import decimal, mark, tr

from brdf_designer.colour.display import lab_to_codes
from brdf_designer.session.state import by_angle
from brdf_suite.appearance.difference.tolerance import difference_title
from brdf_suite.appearance.difference.words import words_text
from brdf_suite.documents.paint import Paint
from brdf_suite.paint_design.standard import AngleRow, BatchReport, Standard

LIMIT_NAMES = {
    "difference": "ΔE",
    "lightness": "ΔL*",
    "chroma": "ΔC*",
    "hue": "ΔH*",
    "ellipsoid": mark("ellipsoid"),
}


_COLUMNS = {
    "difference": (1,),
    "lightness": (2,),
    "chroma": (3,),
    "hue": (4,),
    "ellipsoid": (2, 3, 4),
}
"""Where in a line of the table the parts stand."""


MARKED = (
    mark("lighter"),
    mark("darker"),
    mark("cleaner"),
    mark("dirtier"),
    mark("redder"),
    mark("yellower"),
    mark("greener"),
    mark("bluer"),
    mark("more flop"),
    mark("less flop"),
    mark("slightly {word}"),
    mark("much {word}"),
    mark("{first} and {second}"),
    mark("{first}, {second}"),
    mark("{first}; {second}"),
    mark("{words} at {angles}"),
    mark("{words} at every angle"),
    mark("no visible difference"),
)
"""The words of differences: all of ``WORDS`` and ``PATTERNS`` of :mod:`brdf_suite.appearance.difference.words`."""


def say(text: str) -> str:
    """Return one of :data:`MARKED` in the user's language."""
    return tr(text)


@dataclass(frozen=True)
class ResultRow:
    """One line of the table: texts of angle, ΔE, ΔL*, ΔC*, ΔH* and verdict; ``bold`` are what fails in it."""

    cells: tuple[str, str, str, str, str, str]
    bold: frozenset[int]
    tip: str
    passes: bool | None = None


@dataclass(frozen=True)
class StandardState:
    """A comparison as the window shows it; ``patches`` and ``rows`` in the order of the patches."""

    name: str
    origin: str
    title: str
    verdict: str
    passes: bool | None
    sentence: str
    more: str
    patches: tuple[StandardPatch, ...]
    rows: tuple[ResultRow, ...]
    notices: tuple[str, ...]


def state_of(standard: Standard, paint: Paint, report: BatchReport) -> StandardState:
    """Return what is shown of ``paint`` against ``standard``."""
    title = difference_title(report.difference)
    order = by_angle(paint)
    rows = [report.rows[index] for index in order]
    return StandardState(
        name=standard.name,
        origin=standard.origin,
        title=title,
        verdict=_verdict(report, title),
        passes=report.passes,
        sentence=report.sentence(say),
        more=_more(report),
        patches=_patches(rows, title),
        rows=tuple(_row(row) for row in rows),
        notices=standard.notices,
    )


def verdict_word(passes: bool | None) -> str:
    """Return the word of a verdict."""
    if passes is None:
        return tr("not evaluated")
    return tr("pass") if passes else tr("FAIL")


def signed(value: float, decimals: int = 2) -> str:
    """Return a difference with its sign, a true minus, and no sign where it rounds to nothing."""
    text = f"{value:+.{decimals}f}"
    return decimal(text[1:] if float(text) == 0.0 else text.replace("-", "−"))


def _verdict(report: BatchReport, title: str) -> str:
    largest, mean = report.largest, report.mean
    if largest is None or mean is None:
        return tr("No comparison: no common angle")
    return tr("{verdict}: {difference} up to {largest:.2f}, mean {mean:.2f}").format(
        verdict=verdict_word(report.passes), difference=title, largest=largest, mean=mean
    )


def _more(report: BatchReport) -> str:
    parts = []
    if report.flop is not None:
        parts.append(
            tr("flop index {standard:.1f} → {batch:.1f}").format(
                standard=report.flop[0], batch=report.flop[1]
            )
        )
    parts += [
        tr("gloss {angle}° {change} GU").format(angle=angle, change=signed(value, 1))
        for angle, value in report.gloss.items()
        if abs(value) >= 0.05
    ]
    return "   ".join(parts)


def _patches(rows: list[AngleRow], title: str) -> tuple[StandardPatch, ...]:
    found = []
    for row in rows:
        verdict = row.verdict
        if verdict is None or row.standard is None:
            text = tr("standard: no reading")
            found.append(StandardPatch(None, True, (text, "–"), ("",), None, text))
            continue
        code, in_gamut = lab_to_codes(row.standard)
        value = decimal(f"{title} {verdict.difference:.2f}")
        word = "" if verdict.passes is None else verdict_word(verdict.passes)
        words = words_text(row.words, say)
        first = row.words[0].text(say) if row.words else words
        found.append(
            StandardPatch(
                (int(code[0]), int(code[1]), int(code[2])),
                bool(in_gamut),
                (f"{value}  {word}".rstrip(), decimal(f"{verdict.difference:.2f} {word}").rstrip()),
                (words, first) if first != words else (words,),
                verdict.passes,
                _tip(row, words),
            )
        )
    return tuple(found)


def _row(row: AngleRow) -> ResultRow:
    verdict = row.verdict
    if verdict is None:
        return ResultRow(
            (row.angle, "–", "–", "–", "–", ""), frozenset(), tr("The standard has no reading here.")
        )
    word = "" if verdict.passes is None else verdict_word(verdict.passes)
    cells = (
        row.angle + row.marks,
        decimal(f"{verdict.difference:.2f}"),
        signed(verdict.lightness),
        signed(verdict.chroma),
        signed(verdict.hue),
        word,
    )
    tip = _tip(row, words_text(row.words, say))
    if verdict.exceeded:
        parts = " ".join(tr(LIMIT_NAMES[name]) for name in verdict.exceeded)
        tip += "\n" + tr("Outside the tolerance: {parts}").format(parts=parts)
    bold = {column for name in verdict.exceeded for column in _COLUMNS[name]}
    return ResultRow(cells, frozenset({0, 5, *bold}) if bold else frozenset(), tip, verdict.passes)


def _tip(row: AngleRow, words: str) -> str:
    lines = [words]
    if row.standard is not None:
        lab = ", ".join(decimal(f"{value:.2f}") for value in row.standard).replace("-", "−")
        lines.append(tr("Standard L*a*b* {lab}").format(lab=lab))
    if row.computed:
        lines.append(tr("* Read from the standard's reflectance by the virtual spectrophotometer."))
    if not row.supported:
        lines.append(
            tr("† The nearest sample of the standard is {angle:.0f}° away.").format(angle=row.sample_deg)
        )
    return "\n".join(lines)


@dataclass(frozen=True)
class StandardPatch:
    """One angle against the standard.

    ``rgb`` is the standard's sRGB code, ``None`` where it has no colour at this angle. ``forms`` are the difference
    and the verdict from the longest text to the shortest, ``words`` the difference in words, likewise. ``passes`` is
    ``None`` where the angle is not judged.
    """

    rgb: tuple[int, int, int] | None
    in_gamut: bool
    forms: tuple[str, ...]
    words: tuple[str, ...]
    passes: bool | None
    tip: str = ""
