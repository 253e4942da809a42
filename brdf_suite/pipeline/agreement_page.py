"""The page of the agreement: figures by effect and by paint, and a sheet of pictures beside it."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from brdf_suite.errors import FileError
from brdf_suite.pipeline.agreement import Case, Order, Pixels, summary
from brdf_suite.pipeline.scene import environment_names

SHEET = "agreement.png"
MOST_ROWS = 6
"""Of the sheet: the worst case of an environment, and the best, until there are so many."""
SCALE_DELTA_E = 10.0
_GAP = 4

Bytes = NDArray[np.uint8]


def check_page(path: Path) -> None:
    """Raise :class:`FileError` where no page could be written at ``path``."""
    if path.suffix.lower() != ".md":
        raise FileError(path, "the page is written as Markdown; give a name that ends in .md")
    if not path.absolute().parent.is_dir():
        raise FileError(path, "its folder does not exist")


def write_page(path: Path, cases: Sequence[Case], order: Order) -> None:
    """Write the page and, in ``images/`` beside it, its sheet of pictures."""
    from brdf_suite.documents.atomic import write_atomically
    from brdf_suite.files.images import write_png

    images = path.absolute().parent / "images"
    images.mkdir(exist_ok=True)
    shown = chosen(cases)
    write_png(images / SHEET, sheet(shown), {"Software": "BRDF Suite", "Title": "Agreement of the renderers"})
    write_atomically(path, page(cases, shown, order).encode())


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
        ordered = sorted(group, key=lambda case: _first(case))
        found += [ordered[-1]] + ([ordered[len(ordered) // 2]] if len(ordered) > 1 else [])
    return found[:MOST_ROWS]


def sheet(cases: Sequence[Case]) -> Bytes:
    """Return the pictures side by side, (h, w, 3): real time, path-traced, and ΔE00 as grey, white being 10."""
    rows = []
    for case in cases:
        form = next(iter(case.errors))
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


def page(cases: Sequence[Case], shown: Sequence[Case], order: Order) -> str:
    """Return the page as Markdown."""
    environments = list(dict.fromkeys(case.environment for case in cases))
    paints = list(dict.fromkeys(case.paint for case in cases))
    lines = [
        "# Agreement of the two renderers",
        "",
        f"{len(paints)} paints in {len(environments)} environments ({', '.join(environments)}) on the "
        f"{Path(order.surface).stem}, {order.size[0]}×{order.size[1]} pixels, path-traced with {order.samples} samples "
        "a pixel. Object pixels only, coat and Fresnel on, exposure such that the object's median luminance is 0.18, "
        "ΔE00 and FLIP (67 pixels per degree) after the same tone curve. How it is measured, and what each error "
        "means: [reference.md](reference.md).",
        "",
        "## By effect",
        "",
        "Each row is one way to draw the picture, against the paint itself, path-traced.",
        "",
        "| form | mean ΔE00 | worst paint's mean | 99th percentile | FLIP |",
        "|---|---|---|---|---|",
    ]
    for form in cases[0].errors:
        s = summary(cases, form)
        lines.append(
            f"| {form} | {s['de00_mean']:.2f} | {s['de00_worst']:.2f} | {s['de00_p99']:.2f} | {s['flip']:.3f} |"
        )
    noise = float(np.mean([case.noise.mean for case in cases]))
    lines += ["", f"Noise of the path tracer alone would give a mean ΔE00 of {noise:.2f}.", ""]
    if cases[0].look_up:
        lines += [
            "Against the fitted lobes, traced, which is what the look-ups in prefiltered maps cost:",
            "",
        ]
        lines += ["| form | mean ΔE00 | 99th percentile | FLIP |", "|---|---|---|---|"]
        for form in cases[0].look_up:
            rows = [case.look_up[form] for case in cases]
            mean, p99, flip = (
                np.mean([getattr(row, name) for row in rows]) for name in ("mean", "p99", "flip")
            )
            lines.append(f"| {form} | {mean:.2f} | {p99:.2f} | {flip:.3f} |")
        lines.append("")
    lines += ["## Pictures", "", f"![Real time, path-traced, difference](images/{SHEET})", ""]
    names = "; ".join(f"{case.paint} in {case.environment} ({_first(case):.2f})" for case in shown)
    lines += [
        f"From the top, the left half first, with their mean ΔE00: {names}. Left to right: real time, path-traced, "
        f"ΔE00 with white at {SCALE_DELTA_E:g}.",
        "",
        "## By paint and environment",
        "",
        "Mean ΔE00 / 99th percentile / FLIP of the default form.",
        "",
        "| paint | " + " | ".join(environments) + " |",
        "|---|" + "---|" * len(environments),
    ]
    found = {(case.paint, case.environment): case.errors[order.forms[0]] for case in cases}
    for paint in paints:
        cells = []
        for environment in environments:
            e = found.get((paint, environment))
            cells.append("" if e is None else f"{e.mean:.2f} / {e.p99:.1f} / {e.flip:.3f}")
        lines.append(f"| {paint} | " + " | ".join(cells) + " |")
    return "\n".join([*lines, ""])


def _first(case: Case) -> float:
    return next(iter(case.errors.values())).mean


def _beside(pictures: Sequence[Pixels], axis: int) -> Pixels:
    """Put pictures of one height (or width) side by side with white gaps."""
    shape = list(pictures[0].shape)
    shape[axis] = _GAP
    gap = np.ones(shape)
    parts: list[Pixels] = []
    for picture in pictures:
        parts += [picture, gap]
    return np.concatenate(parts[:-1], axis=axis)
