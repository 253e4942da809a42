"""The view as vector paths: what the card draws by depth is painted here from back to front.

Surfaces become quadrilaterals in flat colours, fewer than on the screen where the grid is fine; lines of fits, of the
frame and of arrows become strokes, words become text. Everything is sorted by its distance from the eye, so a path
that pierces another is wholly before or behind it.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt
from brdf_qt.gl.segments import Segments
from brdf_qt.gl.space import project
from PySide6.QtCore import QRectF, QSize

from brdf_lobe_visualizer.view3d.camera import Camera
from brdf_lobe_visualizer.view3d.frame import Bar, Frame, Label, Layer, Panel, Scene
from brdf_suite.arrays import Floats
from brdf_suite.foreign_text import escape_html
from brdf_suite.inspection.lobe_surface.occlusion import hidden

_ROW_STEP, _COLUMN_STEP = 2, 4
_TO_LIGHT = np.array([-0.36, 0.48, 0.80]) / np.linalg.norm([-0.36, 0.48, 0.80])
_FONT = "font-family='sans-serif'"


@dataclass(frozen=True)
class Look:
    """Colours of text and ground, as ``#rrggbb``, and the size of text in pixels."""

    ink: str = "#1a1a1a"
    paper: str = "#ffffff"
    text_px: float = 12.0


def svg_of(
    scene: Scene, frame: Frame, camera: Camera, rooms: Sequence[QRectF], size: QSize, look: Look
) -> str:
    """Return the picture of ``size`` pixels with its panels in ``rooms``."""
    parts = [
        f"<svg xmlns='http://www.w3.org/2000/svg' width='{size.width()}' height='{size.height()}' "
        f"viewBox='0 0 {size.width()} {size.height()}'>",
        f"<title>{escape_html(scene.quantity)}</title>",
        f"<rect width='100%' height='100%' fill='{look.paper}'/>",
    ]
    for number, (panel, room) in enumerate(zip(scene.panels, rooms, strict=False)):
        parts += _panel(panel, room, frame, camera, look, number)
    if scene.bar is not None:
        parts += _bar(scene.bar, size, look)
    return "\n".join([*parts, "</svg>", ""])


class _Sight:
    """Projects points of the local frame into a panel."""

    def __init__(self, camera: Camera, room: QRectF) -> None:
        self.to_eye = np.array(camera.to_eye().copyDataTo()).reshape(4, 4)
        self._to_clip, self._room = camera.to_clip(room), room

    def __call__(self, points: npt.ArrayLike) -> tuple[Floats, Floats]:
        """Places (..., 2) in pixels, and depths (...): the distance before the eye, 0 and less behind it."""
        return project(self._to_clip, points, self._room)


def _panel(
    panel: Panel, room: QRectF, frame: Frame, camera: Camera, look: Look, number: int
) -> Iterator[str]:
    sight = _Sight(camera, room)
    drawn: list[tuple[float, str]] = []
    for layer in panel.layers:
        drawn += _lines(layer, sight, look) if layer.style == "lines" else _faces(layer, sight, look)
    for rows in (frame.behind, frame.before):
        drawn += _segments(rows, sight)
    if frame.handle is not None and len(frame.before):
        handle = np.asarray(frame.before[0]["colour"], float)[None]
        drawn += _points(frame.handle[None], handle, sight, look, 0.45 * look.text_px)
    if panel.points is not None:
        drawn += _points(panel.points.places.astype(float), panel.points.colours.astype(float), sight, look)
    drawn.sort(key=lambda row: -row[0])
    clip = f"panel{number}"
    yield (
        f"<clipPath id='{clip}'><rect x='{room.left():.1f}' y='{room.top():.1f}' width='{room.width():.1f}' "
        f"height='{room.height():.1f}'/></clipPath>"
    )
    yield f"<g clip-path='url(#{clip})'>"
    for _, text in drawn:
        yield text
    behind = np.zeros(len(frame.labels), bool)
    for layer in panel.layers:
        if layer.style == "solid" and layer.grid is not None and len(behind):
            behind |= hidden(layer.surface, layer.grid, camera.eye(), [label.place for label in frame.labels])
    for label, covered in zip(frame.labels, behind, strict=True):
        if label.strong or not covered:
            yield from _label(label, sight, look)
    y = room.top() + 8.0 + look.text_px
    indent = 0.0
    if panel.colour is not None and panel.title:
        indent = 1.4 * look.text_px
        fill = _hex(255.0 * np.array(panel.colour))
        size = 0.9 * look.text_px
        left, top = room.left() + 12.0, y - size
        yield f"<rect x='{left:.1f}' y='{top:.1f}' width='{size:.1f}' height='{size:.1f}' fill='{fill}'/>"
    for line, weight in ((panel.title, "bold"), *((text, "normal") for text in panel.caption.splitlines())):
        if line:
            yield _text(line, room.left() + 12.0 + indent, y, look, anchor="start", weight=weight)
        indent = 0.0
        y += 1.3 * look.text_px
    y = room.bottom() - 8.0
    for line in reversed(panel.note.splitlines()):
        yield _text(line, room.center().x(), y, look)
        y -= 1.3 * look.text_px
    yield "</g>"


def _faces(layer: Layer, sight: _Sight, look: Look) -> Iterator[tuple[float, str]]:
    surface = layer.surface
    # Both ends are drawn; the last column is the first again.
    rows, columns = (
        np.unique(np.append(np.arange(0, count, step), count - 1))
        for count, step in zip(surface.shape, (_ROW_STEP, _COLUMN_STEP), strict=True)
    )
    grid = np.ix_(rows, columns)
    points, normals = surface.points[grid].astype(float), surface.normals[grid].astype(float)
    known = np.isfinite(surface.values)[grid]
    places, depths = sight(points)
    colours = (
        np.array([*bytes.fromhex(look.ink[1:])], float) if layer.ink else surface.colours[grid].astype(float)
    )
    lit = _lit(np.broadcast_to(colours, points.shape), points, normals, sight)
    fill = f" fill-opacity='{layer.opacity:.2f}'" if layer.style == "glass" else ""
    for j in range(len(rows) - 1):
        for k in range(len(columns) - 1):
            corner = (slice(j, j + 2), slice(k, k + 2))
            if not known[corner].all() or depths[corner].min() <= 0.0:
                continue
            four = places[corner].reshape(4, 2)[[0, 2, 3, 1]]
            colour = _hex(lit[corner].reshape(4, 3).mean(axis=0))
            path = " ".join(f"{x:.1f},{y:.1f}" for x, y in four)
            # A hair's stroke of the same colour closes the seams between neighbours.
            stroke = "" if fill else f" stroke='{colour}' stroke-width='0.6'"
            yield float(depths[corner].mean()), f"<polygon points='{path}' fill='{colour}'{fill}{stroke}/>"


def _lines(layer: Layer, sight: _Sight, look: Look) -> Iterator[tuple[float, str]]:
    surface = layer.surface
    places, depths = sight(surface.points)
    known = np.isfinite(surface.values) & (depths > 0.0)
    rows, columns = surface.shape
    every = [((j, k), (j, k + 2)) for j in range(6, rows, 6) for k in range(0, columns - 2, 2)]
    every += [((j, k), (j + 1, k)) for k in range(0, columns - 1, 16) for j in range(rows - 1)]
    for a, b in every:
        if not (known[a] and known[b]):
            continue
        colour = look.ink if layer.ink else _hex(surface.colours[a])
        (x1, y1), (x2, y2) = places[a], places[b]
        if abs(x1 - x2) + abs(y1 - y2) < 0.02:
            continue
        text = (
            f"<path d='M{x1:.1f} {y1:.1f}L{x2:.1f} {y2:.1f}' stroke='{colour}' stroke-width='1' "
            f"stroke-opacity='{layer.opacity:.2f}'/>"
        )
        # A little nearer, as on the screen: lines of a fit that lies on its target are seen.
        yield float(min(depths[a], depths[b])) - 0.01, text


def _segments(rows: Segments, sight: _Sight) -> Iterator[tuple[float, str]]:
    places, depths = sight(rows["ends"])
    for ((x1, y1), (x2, y2)), (d1, d2), row in zip(places, depths, rows, strict=True):
        if min(d1, d2) <= 0.0:
            continue
        w1, w2 = (float(width) for width in row["widths"])
        colour, alpha = _hex(255.0 * row["colour"][:3]), float(row["colour"][3])
        if w1 == w2:
            text = (
                f"<path d='M{x1:.1f} {y1:.1f}L{x2:.1f} {y2:.1f}' stroke='{colour}' "
                f"stroke-opacity='{alpha:.2f}' stroke-width='{w1:.1f}'/>"
            )
        else:  # the head of an arrow
            along = np.array([x2 - x1, y2 - y1])
            side = np.array([-along[1], along[0]]) / max(float(np.hypot(*along)), 1e-6)
            a, b = np.array([x1, y1]) + 0.5 * w1 * side, np.array([x1, y1]) - 0.5 * w1 * side
            corners = f"{a[0]:.1f},{a[1]:.1f} {b[0]:.1f},{b[1]:.1f} {x2:.1f},{y2:.1f}"
            text = f"<polygon points='{corners}' fill='{colour}' fill-opacity='{alpha:.2f}'/>"
        yield 0.5 * float(d1 + d2), text


def _points(
    places: Floats, colours: Floats, sight: _Sight, look: Look, radius: float = 2.5
) -> Iterator[tuple[float, str]]:
    at, depths = sight(places)
    for (x, y), depth, colour in zip(at, depths, colours, strict=True):
        if depth > 0.0:
            fill = _hex(255.0 * colour[:3])
            rim = f"stroke='{look.paper}' stroke-width='0.8'"
            disc = f"<circle cx='{x:.1f}' cy='{y:.1f}' r='{radius:.1f}' fill='{fill}' {rim}/>"
            yield float(depth) - 0.01, disc


def _label(label: Label, sight: _Sight, look: Look) -> Iterator[str]:
    (x, y), depth = sight(label.place)
    if depth > 0.0:
        weight = "bold" if label.strong else "normal"
        yield _text(label.text, float(x), float(y) + 0.35 * look.text_px, look, weight=weight)


def _text(
    text: str, x: float, y: float, look: Look, *, anchor: str = "middle", weight: str = "normal"
) -> str:
    # Strokes of the ground's colour lie under the letters.
    return (
        f"<text x='{x:.1f}' y='{y:.1f}' {_FONT} font-size='{look.text_px:.1f}' font-weight='{weight}' "
        f"text-anchor='{anchor}' fill='{look.ink}' stroke='{look.paper}' stroke-width='2.5' "
        f"stroke-linejoin='round' paint-order='stroke'>{escape_html(text)}</text>"
    )


def _bar(bar: Bar, size: QSize, look: Look) -> Iterator[str]:
    high = min(240.0, 0.5 * size.height())
    left, top = size.width() - 28.0, size.height() - high - 18.0
    shares = np.linspace(1.0, 0.0, 33)
    places = np.round(shares * (len(bar.codes) - 1)).astype(int)
    stops = "".join(
        f"<stop offset='{1.0 - share:.4f}' stop-color='{_hex(bar.codes[place])}'/>"
        for share, place in zip(shares, places, strict=True)
    )
    yield f"<linearGradient id='bar' x1='0' y1='0' x2='0' y2='1'>{stops}</linearGradient>"
    yield f"<rect x='{left:.1f}' y='{top:.1f}' width='14' height='{high:.1f}' fill='url(#bar)' stroke='{look.ink}'/>"
    for share, text in bar.ticks:
        y = top + (1.0 - share) * high
        yield f"<path d='M{left - 4:.1f} {y:.1f}h4' stroke='{look.ink}'/>"
        yield _text(text, left - 7.0, y + 0.35 * look.text_px, look, anchor="end")
    yield _text(bar.title, left + 14.0, top - 0.9 * look.text_px, look, anchor="end")


def _lit(codes: Floats, points: Floats, normals: Floats, sight: _Sight) -> Floats:
    """Codes (..., 3) shaded as the view shades them."""
    turn = sight.to_eye[:3, :3]
    eye_normal = normals @ turn.T
    to_eye = -(points @ turn.T + sight.to_eye[:3, 3])
    to_eye /= np.maximum(np.linalg.norm(to_eye, axis=-1, keepdims=True), 1e-9)
    facing = np.einsum("...i,...i", eye_normal, to_eye)
    inside = facing < 0.0
    eye_normal = np.where(inside[..., None], -eye_normal, eye_normal)
    rim = (1.0 - np.abs(facing)) ** 3
    shade = 0.30 + 0.10 * eye_normal[..., 1] + 0.68 * np.maximum(eye_normal @ _TO_LIGHT, 0.0)
    shade *= np.where(inside, 0.55, 1.0) * (1.0 - 0.25 * rim)
    # The transfer curve is near enough to a power for flat faces.
    return np.asarray(np.clip(codes * np.clip(shade, 0.0, 1.0)[..., None] ** (1.0 / 2.2), 0.0, 255.0))


def _hex(codes: npt.ArrayLike) -> str:
    red, green, blue = (round(float(c)) for c in np.clip(np.asarray(codes, float), 0.0, 255.0))
    return f"#{red:02x}{green:02x}{blue:02x}"
