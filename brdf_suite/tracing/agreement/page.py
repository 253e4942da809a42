"""The page of the agreement: figures by effect and by paint, and sheets of pictures beside it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np

from brdf_suite.arrays import Bytes, Floats
from brdf_suite.documents.atomic import check_target, make_folder, write_atomically
from brdf_suite.errors import FileError
from brdf_suite.files.images.environments import write_png
from brdf_suite.fitting.lobes.settings import FitSettings
from brdf_suite.pipeline.scene import environment_names
from brdf_suite.regular_files import exists, is_folder
from brdf_suite.tracing.agreement.comparison import (
    LARGE_DELTA_E,
    Case,
    Order,
    PaintClass,
    judged_form,
    summary,
    worst_paint,
)
from brdf_suite.tracing.agreement.flakes import BLOCK, POPULATIONS, FlakeCase
from brdf_suite.tracing.agreement.forms import FORMS, HELD_OUT_FORM

MOST_ROWS = 6
"""Of a sheet: the worst case of an environment, and the middle one, until there are so many."""
SCALE_DELTA_E = LARGE_DELTA_E
_GAP = 4
_HEADINGS: Mapping[PaintClass, str] = {
    "designed": "Designed paints",
    "two-light": "Paints read under two lights",
    "satin": "Satin paints",
    "matte": "Matte paints",
    "Table 1": "Cook-Torrance paints of Table 1",
    "Cook-Torrance": "Other Cook-Torrance paints",
    "scattered": "Scattered samples",
    "table": "Tables",
    "RGL": "RGL tensors",
    "factored": "Factored reflectances",
    "model": "Models",
}


def check_page(path: Path) -> None:
    """Raise :class:`FileError` where no page could be written at ``path``."""
    if path.suffix.lower() != ".md":
        raise FileError(path, "the page is written as Markdown; give a name that ends in .md")
    check_target(path)
    images = _images(path)
    if not is_folder(images) and (exists(images) or images.is_symlink()):
        raise FileError(images, "is no folder, and the pictures of the page go into one of this name")


def write_page(path: Path, cases: Sequence[Case], order: Order, flakes: Sequence[FlakeCase] = ()) -> None:
    """Write the page and, in ``images/`` beside it, a sheet of pictures for each of its parts."""
    images = _images(path)
    make_folder(images)
    for title, group in groups(cases):
        metadata = {"Software": "BRDF Suite", "Title": "Agreement of the renderers"}
        write_png(images / sheet_name(title), sheet(chosen(group)), metadata)
    write_atomically(path, page(cases, order, flakes).encode())


def _images(path: Path) -> Path:
    return path.absolute().parent / "images"


def groups(cases: Sequence[Case]) -> list[tuple[str, list[Case]]]:
    """Return the page's parts: each class of paints on each surface, by their headings."""
    found: dict[tuple[str, PaintClass], list[Case]] = {}
    for case in cases:
        found.setdefault((case.surface, case.kind), []).append(case)
    return [
        (f"{_HEADINGS[kind]} on the {surface.replace('_', ' ')}", group)
        for (surface, kind), group in found.items()
    ]


def drawn_forms(cases: Sequence[Case]) -> list[str]:
    """Return the forms that any of the cases was drawn in; few have all."""
    return list(dict.fromkeys(form for case in cases for form in case.errors))


def sheet_name(title: str) -> str:
    """Return the file name of the sheet under a heading.

    >>> sheet_name("Designed paints on the sphere")
    'agreement_designed_sphere.png'
    """
    words = title.lower().split(" on the ")
    return "agreement_" + "_".join(word.split()[0] for word in words) + ".png"


def chosen(cases: Sequence[Case]) -> list[Case]:
    """Return the cases that are shown: the worst and the median of each environment.

    Where there are shipped environments, of these alone: light of others is not ours to print.
    """
    shipped = [case for case in cases if case.environment in environment_names()]
    by_environment: dict[str, list[Case]] = {}
    for case in shipped or cases:
        by_environment.setdefault(case.environment, []).append(case)
    found: list[Case] = []
    for group in by_environment.values():
        ordered = sorted(group, key=_first)
        found += [ordered[-1]] + ([ordered[len(ordered) // 2]] if len(ordered) > 1 else [])
    return found[:MOST_ROWS]


def sheet(cases: Sequence[Case]) -> Bytes:
    """Return the pictures side by side, (h, w, 3): real time, path-traced, and ΔE00 as grey, white being 10."""
    rows = []
    for case in cases:
        form = judged_form(case.errors)
        grey = np.clip(case.differences / SCALE_DELTA_E, 0.0, 1.0)[..., None].repeat(3, axis=-1)
        rows.append(_beside([case.pictures[form], case.pictures["reference"], grey], axis=1))
    half = (len(rows) + 1) // 2
    columns = [_beside(rows[:half], axis=0)]
    if len(rows) > half:
        columns.append(_beside(rows[half:], axis=0))
    height = max(column.shape[0] for column in columns)
    padded = [
        np.pad(column, ((0, height - column.shape[0]), (0, 0), (0, 0)), constant_values=1.0)
        for column in columns
    ]
    return np.asarray(np.rint(255.0 * np.clip(_beside(padded, axis=1), 0.0, 1.0)), np.uint8)


def page(cases: Sequence[Case], order: Order, flakes: Sequence[FlakeCase] = ()) -> str:
    """Return the page as Markdown."""
    bound = "" if order.noise is None else f" until the two differ by a mean ΔE00 of at most {order.noise:g}"
    counts = f"{order.samples} samples" if order.noise is None else f"{order.samples} samples or more"
    lines = [
        "# Agreement of the two renderers",
        "",
        f"Paints in environments, {order.size[0]}×{order.size[1]} pixels, path-traced twice with {counts} "
        f"per pixel{bound}; the truth is the mean of the two. ΔE00 and FLIP (67 pixels per degree) cover the paint's "
        "pixels after the same tone curve, with coat and Fresnel, and the object's median luminance at 0.18. "
        "[reference.md](reference.md) defines the errors. All figures include the path tracer's noise. Generated by "
        "`brdf-suite agreement -o FILE`.",
        "",
    ]
    if order.fitting != FitSettings():
        fitting = order.fitting
        exponents = ", ".join(f"{exponent:,.4g}" for exponent in fitting.basis.exponents)
        lines += [
            f"The lobes have the exponents {exponents}; weights are {fitting.weighting}, the diffuse term is "
            f"{fitting.diffuse}.",
            "",
        ]
    for title, group in groups(cases):
        lines += _part(title, group)
    for surface in dict.fromkeys(case.surface for case in flakes):
        lines += _with_flakes(surface, [case for case in flakes if case.surface == surface])
    return "\n".join(lines)


def _part(title: str, cases: Sequence[Case]) -> list[str]:
    environments = list(dict.fromkeys(case.environment for case in cases))
    paints = list(dict.fromkeys(case.paint for case in cases))
    lines = [
        f"## {title}",
        "",
        f"{len(paints)} paint{'s' if len(paints) > 1 else ''} in {len(environments)} environments "
        f"({', '.join(environments)}).",
        "",
    ]
    if cases[0].surface != "sphere":
        lines += [
            "The surface shadows and reflects itself: the real-time picture uses baked occlusion, the path tracer "
            "all paths.",
            "",
        ]
    lines += _by_effect(cases, drawn_forms(cases))
    noise = float(np.mean([case.noise.mean for case in cases]))
    form = judged_form(cases[0].errors)
    worst, mean = worst_paint([case for case in cases if form in case.errors], form)
    above = 100.0 * summary(cases, form)["share_above_10"]
    lines += [
        "",
        f"The two traces ({_counts(cases)} samples) differ by a mean ΔE00 of {noise:.2f}. The worst paint is "
        f"{worst}, {mean:.2f} in the mean; {above:.2f} % of the pixels are above {LARGE_DELTA_E:g}."
        f"{_elsewhere(cases, form)}",
        "",
    ]
    lines += _against_lobes(cases)
    shown = chosen(cases)
    names = "; ".join(f"{case.paint} in {case.environment} ({_first(case):.2f})" for case in shown)
    lines += [
        f"![Real time, path-traced, difference](images/{sheet_name(title)})",
        "",
        f"From the top, left half first, with mean ΔE00: {names}. Left to right: real time, path-traced, ΔE00 with "
        f"white at {SCALE_DELTA_E:g}.",
        "",
        f"Mean ΔE00 / 99th percentile / FLIP of the form “{form}”:",
        "",
        "| paint | " + " | ".join(environments) + " |",
        "|---|" + "---|" * len(environments),
    ]
    found = {(case.paint, case.environment): case.errors.get(form) for case in cases}
    for paint in paints:
        cells = []
        for environment in environments:
            e = found.get((paint, environment))
            cells.append("" if e is None else f"{e.mean:.2f} / {e.p99:.1f} / {e.flip:.3f}")
        lines.append(f"| {paint} | " + " | ".join(cells) + " |")
    return [*lines, ""]


def _counts(cases: Sequence[Case]) -> str:
    """Return the samples per pixel of the cases, as a range where they differ."""
    least, most = min(case.samples for case in cases), max(case.samples for case in cases)
    return f"{least:,}" if least == most else f"{least:,} to {most:,}"


def _elsewhere(cases: Sequence[Case], form: str) -> str:
    """Return a sentence about the pixels of other materials, where the surface has such."""
    means = [case.elsewhere[form].mean for case in cases if form in case.elsewhere]
    if not means:
        return ""
    return (
        f" Pixels with other materials (glass, lamps, tyres) and their edges, which none of these figures has, differ "
        f"by a mean ΔE00 of {np.mean(means):.2f}."
    )


def _by_effect(cases: Sequence[Case], forms: Sequence[str]) -> list[str]:
    lines = [
        "Each row is one form of the real-time picture, compared with the path-traced paint.",
        "",
        "| effect | form | mean ΔE00 | worst paint's mean | 99th percentile | FLIP |",
        "|---|---|---|---|---|---|",
    ]
    for form in forms:
        s = summary(cases, form)
        effect = FORMS[form].effect if form in FORMS else "the fit alone"
        lines.append(
            f"| {effect} | {form} | {s['de00_mean']:.2f} | {s['de00_worst']:.2f} | {s['de00_p99']:.2f} | "
            f"{s['flip']:.3f} |"
        )
    if any(form in FORMS and FORMS[form].paint for form in forms):
        lines += [
            "",
            "No instrument reads below 15°. These rows draw the paint by another rule than the traced one; they show "
            "the influence of the rule and are not errors.",
        ]
    if HELD_OUT_FORM in forms:
        divided = {case.paint for case in cases if HELD_OUT_FORM in case.errors}
        lines += [
            "",
            f"“{HELD_OUT_FORM}”: the lobes know four fifths of the measured directions, and all near the steepest; the "
            f"traced paint has all. Measured directions of {', '.join(sorted(divided))} could be divided.",
        ]
    return lines


def _with_flakes(surface: str, cases: Sequence[FlakeCase]) -> list[str]:
    environments = list(dict.fromkeys(case.environment for case in cases))
    found = {(case.paint, case.environment): case for case in cases}
    mean, noise = (float(np.mean([getattr(case, name) for case in cases])) for name in ("de00_mean", "noise"))
    others = "" if surface == "sphere" else " A block holds all materials that are seen in it."
    lines = [
        f"## With flakes on the {surface.replace('_', ' ')}",
        "",
        f"Single flakes in both pictures, on a surface of a twentieth of its size, so that a pixel holds few of them; "
        f"compared by means over {BLOCK}×{BLOCK} pixels and {POPULATIONS} populations of flakes, which share the "
        f"samples: mean ΔE00 {mean:.2f}; the two traces differ by {noise:.2f}.{others} Mean ΔE00 / worst block / "
        "contrast of pixels over the populations, real time and traced:",
        "",
        "| paint | " + " | ".join(environments) + " |",
        "|---|" + "---|" * len(environments),
    ]
    for paint in dict.fromkeys(case.paint for case in cases):
        row = [found[paint, environment] for environment in environments]
        cells = (
            f"{case.de00_mean:.2f} / {case.de00_worst:.1f} / {case.contrast_drawn:.2f}, {case.contrast_traced:.2f}"
            for case in row
        )
        lines.append(f"| {paint} | " + " | ".join(cells) + " |")
    return [*lines, ""]


def _against_lobes(cases: Sequence[Case]) -> list[str]:
    if not cases[0].look_up:
        return []
    lines = [
        "Against the path-traced fitted lobes (the error of the look-ups in prefiltered maps):",
        "",
        "| form | mean ΔE00 | 99th percentile | FLIP |",
        "|---|---|---|---|",
    ]
    for form in dict.fromkeys(form for case in cases for form in case.look_up):
        if FORMS[form].effect not in ("–", "look-up", "Fresnel", "resolution"):
            continue  # other lobes than those that were traced
        rows = [case.look_up[form] for case in cases if form in case.look_up]
        mean, p99, flip = (np.mean([getattr(row, name) for row in rows]) for name in ("mean", "p99", "flip"))
        lines.append(f"| {form} | {mean:.2f} | {p99:.2f} | {flip:.3f} |")
    return [*lines, ""]


def _first(case: Case) -> float:
    return case.errors[judged_form(case.errors)].mean


def _beside(pictures: Sequence[Floats], axis: int) -> Floats:
    """Put pictures of one height (or width) side by side with white gaps."""
    shape = list(pictures[0].shape)
    shape[axis] = _GAP
    gap = np.ones(shape)
    parts: list[Floats] = []
    for picture in pictures:
        parts += [picture, gap]
    return np.concatenate(parts[:-1], axis=axis)
