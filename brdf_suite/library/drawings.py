"""Drawings of values as SVG: the flop strip of what reflects, the curves of a fit, the colours of a palette."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import cast

import numpy as np

from brdf_suite.appearance.colour.colorimetry import LUMINANCE, working_to_lab
from brdf_suite.appearance.colour.flat_colours import lab_to_hex, to_paint
from brdf_suite.arrays import Floats
from brdf_suite.documents.atomic import write_atomically
from brdf_suite.documents.palette import Palette
from brdf_suite.errors import FileError, PathLike
from brdf_suite.files.palettes.conversions import face_lab
from brdf_suite.fitting.cook_torrance.reflectance_fit import FileFit
from brdf_suite.foreign_text import escape_html
from brdf_suite.geometry.directions import aspecular_view, illumination
from brdf_suite.library.subjects import Subject, material_for
from brdf_suite.palettes.swatches.look import colours_at
from brdf_suite.pipeline.lobe_fit import LobeFit
from brdf_suite.reflectance.material import Material
from brdf_suite.reflectance.protocol import Reflectance
from brdf_suite.reports.paint_report.html import stroke_svg
from brdf_suite.reports.paint_report.plots import GRID, INK, SOFT, STYLES, PlotLine, Stroke, Text

_ANGLES = np.linspace(15.0, 110.0, 96)
_MARKED_DEG = (15, 25, 45, 75, 110)
_LIGHT_DEG = 45.0
_NEAR_DEG = 2.0
_CHIPS = 96
_IN_A_ROW = 16


@dataclass(frozen=True)
class Drawing:
    """A drawing as SVG, which notebooks show.

    Attributes
    ----------
    title
        What it shows.
    svg
        The drawing, complete.

    >>> import brdf_suite as bs
    >>> bs.plot("blue").title
    'Blue, aspecular angles from 15 to 110°, light at 45°'
    """

    title: str
    svg: str

    def save(self, path: PathLike) -> None:
        """Write ``path``, an ``.svg``, whole or not at all.

        Raises :class:`FileError`: it has another ending, or the disk refuses.

        >>> import brdf_suite as bs, tempfile, pathlib
        >>> file = pathlib.Path(tempfile.mkdtemp()) / "blue.svg"
        >>> bs.plot("blue").save(file)
        >>> file.read_text(encoding="utf-8")[:4]
        '<svg'
        """
        if Path(path).suffix.lower() != ".svg":
            raise FileError(path, "a drawing is written as SVG; give a name that ends in .svg")
        write_atomically(path, self.svg.encode())

    def _repr_html_(self) -> str:
        return self.svg


def plot(subject: Subject | Palette) -> Drawing:
    """Draw a subject: a fit's curves beside those that it was fitted to, a palette's colours, else the flop strip.

    The flop strip has the colours from 15 to 110° from the mirror direction, light at 45°. Curves are of the luminous
    reflectance factor over the same angles, beside the mirror direction too.

    Parameters
    ----------
    subject
        A name, a file, a paint, a material, a fit, a palette, or anything with ``eval``.

    Raises
    ------
    SuiteError
        As :func:`load`.

    >>> import brdf_suite as bs
    >>> bs.plot(bs.fit("blue")).svg.count("<polyline") > 2
    True
    """
    return drawing_of(subject)


def drawing_of(value: object) -> Drawing:
    """Return the drawing of a subject or a palette."""
    if isinstance(value, Palette):
        return _chips(value)
    if isinstance(value, LobeFit):
        return _curves(value.name, value.reflectance, value.weights, "lobes")
    if isinstance(value, FileFit):
        return _curves(value.name, value.reflectance, value.fit, "Cook-Torrance lobes")
    return _strip(material_for(cast(Subject, value)))


def _strip(material: Material) -> Drawing:
    labs = working_to_lab(colours_at(material.reflectance, _ANGLES))
    step, height = 5.0, 64.0
    width = step * len(_ANGLES)
    bands = "".join(
        f'<rect x="{step * k:g}" y="0" width="{step + 0.5:g}" height="{height:g}" fill="{lab_to_hex(lab)}"/>'
        for k, lab in enumerate(labs.tolist())
    )
    texts: list[Stroke] = [Text(0.0, height + 30.0, material.name, 12.0, colour=INK, bold=True)]
    for angle in _MARKED_DEG:
        x = width * (angle - _ANGLES[0]) / (_ANGLES[-1] - _ANGLES[0])
        anchor = "start" if angle == _MARKED_DEG[0] else "end" if angle == _MARKED_DEG[-1] else "middle"
        texts.append(Text(float(x), height + 13.0, f"{angle}°", 10.0, anchor))  # type: ignore[arg-type]
    title = f"{material.name}, aspecular angles from 15 to 110°, light at 45°"
    return _drawing(title, width, height + 36.0, bands, texts)


def _curves(name: str, target: Reflectance, fitted: Reflectance, what: str) -> Drawing:
    angles = np.concatenate((np.linspace(-30.0, -_NEAR_DEG, 29), np.linspace(_NEAR_DEG, 110.0, 109)))
    light = illumination(np.full(len(angles), _LIGHT_DEG))
    view = aspecular_view(_LIGHT_DEG, angles)
    lines = [
        np.maximum(np.pi * np.asarray(one.eval(light, view)) @ LUMINANCE, 0.0) for one in (target, fitted)
    ]
    positive = np.concatenate([line[np.isfinite(line) & (line > 0.0)] for line in lines])
    low, high = _decades(positive)
    left, top, width, height = 40.0, 22.0, 440.0, 200.0

    def place(angle: float, value: float) -> tuple[float, float]:
        share = (np.log10(value) - low) / (high - low)
        return left + width * (angle + 30.0) / 140.0, float(top + height * (1.0 - share))

    strokes: list[Stroke] = [Text(left, 13.0, name, 12.0, colour=INK, bold=True)]
    for decade in range(low, high + 1):
        x, y = place(-30.0, 10.0**decade)
        strokes += [
            PlotLine(((x, y), (x + width, y)), GRID, 0.5),
            Text(x - 4.0, y + 3.0, f"{10.0**decade:g}", 9.0, "end"),
        ]
    for angle in (-30, 0, 15, 45, 75, 110):
        x, y = place(angle, 10.0**low)
        strokes += [PlotLine(((x, y), (x, y + 4.0)), SOFT, 0.6), Text(x, y + 14.0, f"{angle}", 9.0, "middle")]
    for style, line in zip(("paint", "fitted lobes"), lines, strict=True):
        for side in (angles < 0.0, angles > 0.0):
            known = side & np.isfinite(line) & (line >= 10.0**low)
            points = tuple(
                place(a, v) for a, v in zip(angles[known].tolist(), line[known].tolist(), strict=True)
            )
            if len(points) > 1:
                strokes.append(PlotLine(points, *STYLES[style]))
    strokes.append(
        Text(left + width, top + height + 28.0, "aspecular angle, degrees; light at 45°", 9.0, "end")
    )
    strokes.append(Text(left, top + height + 28.0, "luminous reflectance factor", 9.0))
    for row, (style, label) in enumerate((("paint", "given"), ("fitted lobes", what))):
        y = top + 12.0 + 14.0 * row
        strokes.append(
            PlotLine(((left + width - 130.0, y - 3.0), (left + width - 104.0, y - 3.0)), *STYLES[style])
        )
        strokes.append(Text(left + width - 98.0, y, label, 10.0))
    return _drawing(
        f"{name}: given, and fitted {what}", left + width + 12.0, top + height + 36.0, "", strokes
    )


def _decades(values: Floats) -> tuple[int, int]:
    """Return the powers of ten that hold what is positive, at least one and at most six decades."""
    if not values.size:
        return -2, 0
    high = int(np.ceil(np.log10(values.max())))
    low = int(np.floor(np.log10(values.min())))
    return max(min(low, high - 1), high - 6), high


def _chips(palette: Palette) -> Drawing:
    shown = palette.entries[:_CHIPS]
    side = 30.0
    rows = max(1, -(-len(shown) // _IN_A_ROW))
    chips = "".join(
        f'<rect x="{side * (k % _IN_A_ROW):g}" y="{side * (k // _IN_A_ROW):g}" width="{side - 2:g}" '
        f'height="{side - 2:g}" rx="2" fill="{lab_to_hex(face_lab(to_paint(entry.content)))}">'
        f"<title>{escape_html(entry.name or entry.id)}</title></rect>"
        for k, entry in enumerate(shown)
    )
    more = f", of which {len(shown)} are shown" if len(palette) > len(shown) else ""
    title = f"{palette.name}: {len(palette):,} {'entry' if len(palette) == 1 else 'entries'}{more}"
    return _drawing(
        title, side * _IN_A_ROW, side * rows + 20.0, chips, [Text(0.0, side * rows + 13.0, title, 11.0)]
    )


def _drawing(title: str, width: float, height: float, shapes: str, strokes: Sequence[Stroke]) -> Drawing:
    return Drawing(
        title,
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:g}" height="{height:g}" '
        f'viewBox="0 0 {width:g} {height:g}" font-family="sans-serif" role="img" aria-label="{escape_html(title)}">'
        f'<rect width="{width:g}" height="{height:g}" fill="#ffffff"/>'
        f"{shapes}{''.join(map(stroke_svg, strokes))}</svg>",
    )
