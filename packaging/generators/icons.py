"""Draw the icons of the suite: the suite itself, its four programs and its five kinds of documents.

    python packaging/generators/icons.py

Each is an SVG of 256 × 256 and a PNG of the same size in ``resources/icons/suite``. A program is a tile, a document a
sheet of paper with a folded corner; what is on it is the same sphere of paint, or what the program makes of it.
"""

from __future__ import annotations

import math
from pathlib import Path

from PySide6.QtCore import QByteArray, QSize, Qt
from PySide6.QtGui import QGuiApplication, QImage, QPainter
from PySide6.QtSvg import QSvgRenderer

FOLDER = Path(__file__).resolve().parents[2] / "resources" / "icons" / "suite"
SIDE = 256
_TILE = (
    '<linearGradient id="tile" x1="0" y1="0" x2="0" y2="1"><stop offset="0" stop-color="#3a4150"/>'
    '<stop offset="1" stop-color="#171a21"/></linearGradient>'
)
_PAPER = (
    '<linearGradient id="paper" x1="0" y1="0" x2="0" y2="1"><stop offset="0" stop-color="#ffffff"/>'
    '<stop offset="1" stop-color="#e3e7ee"/></linearGradient>'
)
BLUE = ("#e8f3ff", "#4f9df0", "#1656b4", "#081c46")
RED = ("#ffe9e4", "#f0604a", "#b01e1c", "#420a10")
GOLD = ("#fff6dd", "#efb84a", "#b0741a", "#432607")
TEAL = ("#e2fff8", "#3cc3ac", "#137a76", "#062f36")


def _paint(name: str, colours: tuple[str, str, str, str]) -> str:
    """A paint as its flop shows it: highlight, face, flop and rim, from the light at the upper left."""
    stops = zip((0.0, 0.28, 0.68, 1.0), colours, strict=True)
    inner = "".join(f'<stop offset="{at}" stop-color="{colour}"/>' for at, colour in stops)
    return f'<radialGradient id="{name}" cx=".36" cy=".32" r=".74">{inner}</radialGradient>'


def _sphere(x: float, y: float, radius: float, paint: str = "blue") -> str:
    shadow = (
        f'<ellipse cx="{x}" cy="{y + 1.04 * radius}" rx="{0.8 * radius}" ry="{0.14 * radius}" fill="#000" '
    )
    return f'{shadow}fill-opacity=".35"/><circle cx="{x}" cy="{y}" r="{radius}" fill="url(#{paint})"/>'


def _rays() -> str:
    """The light, and the receptors at 15, 45 and 110° from the mirror direction, over a panel."""
    at, length = (128.0, 190.0), 112.0
    lines = []
    for angle, colour in ((-45.0, "#ffd24a"), (30.0, BLUE[1]), (0.0, BLUE[1]), (65.0, BLUE[1])):
        x, y = at[0] + length * math.sin(math.radians(angle)), at[1] - length * math.cos(math.radians(angle))
        lines.append(f'<line x1="{at[0]}" y1="{at[1]}" x2="{x:.1f}" y2="{y:.1f}" stroke="{colour}"/>')
    return f'<g stroke-width="11" stroke-linecap="round">{"".join(lines)}</g>'


def _panel() -> str:
    return '<path d="M36 210 Q128 176 220 210 L220 226 Q128 194 36 226 Z" fill="url(#blue)"/>'


def _lobe() -> str:
    """A glossy lobe over a matt one, cut in the plane of incidence."""
    points = []
    for step in range(181):
        angle = math.radians(step - 90)
        length = 52.0 * max(0.0, math.cos(angle)) + 112.0 * max(0.0, math.cos(angle - math.radians(38))) ** 26
        points.append(f"{128 + length * math.sin(angle):.1f},{204 - length * math.cos(angle):.1f}")
    return (
        f'<polygon points="{" ".join(points)}" fill="url(#teal)"/>'
        '<line x1="36" y1="204" x2="220" y2="204" stroke="#c9d2de" stroke-width="8" stroke-linecap="round"/>'
        '<line x1="128" y1="204" x2="46" y2="98" stroke="#ffd24a" stroke-width="9" stroke-linecap="round"/>'
    )


def _swatches(x: float, y: float, side: float, gap: float) -> str:
    """Four paints, as a palette has them."""
    places = ((0, 0, "blue"), (1, 0, "red"), (0, 1, "gold"), (1, 1, "teal"))
    return "".join(
        f'<rect x="{x + column * (side + gap)}" y="{y + row * (side + gap)}" width="{side}" height="{side}" '
        f'rx="{0.16 * side}" fill="url(#{paint})"/>'
        for column, row, paint in places
    )


def _car(x: float, y: float, scale: float) -> str:
    body = (
        "M6 62 C6 46 22 42 40 40 C56 24 70 16 96 16 C126 16 140 26 154 40 C178 42 194 48 194 62 L194 70 L178 70 "
        "A20 20 0 0 0 138 70 L62 70 A20 20 0 0 0 22 70 L6 70 Z"
    )
    wheels = "".join(f'<circle cx="{at}" cy="70" r="15" fill="#0d0f13"/>' for at in (42, 158))
    glass = '<path d="M56 40 C66 28 78 24 94 24 L94 40 Z M102 24 C120 24 132 30 140 40 L102 40 Z" fill="#10233f"/>'
    return f'<g transform="translate({x} {y}) scale({scale})"><path d="{body}" fill="url(#red)"/>{glass}{wheels}</g>'


def _lamp(x: float, y: float, scale: float) -> str:
    return (
        f'<g transform="translate({x} {y}) scale({scale})"><path d="M30 0 L90 0 L112 44 L8 44 Z" fill="#4a5568"/>'
        '<rect x="8" y="44" width="104" height="12" rx="4" fill="#ffd24a"/>'
        '<path d="M8 60 L112 60 L150 150 L-30 150 Z" fill="#ffd24a" fill-opacity=".35"/></g>'
    )


def _picture(content: str, ground: str) -> str:
    paints = (("blue", BLUE), ("red", RED), ("gold", GOLD), ("teal", TEAL))
    gradients = "".join(_paint(name, colours) for name, colours in paints)
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{SIDE}" height="{SIDE}" viewBox="0 0 {SIDE} {SIDE}"><defs>'
        f"{_TILE}{_PAPER}{gradients}</defs>{ground}{content}</svg>\n"
    )


def program(content: str) -> str:
    """Return the icon of a program: a dark tile with something on it."""
    return _picture(content, '<rect x="8" y="8" width="240" height="240" rx="52" fill="url(#tile)"/>')


def document(content: str) -> str:
    """Return the icon of a kind of document: a sheet of paper with something on it."""
    paper = (
        '<path d="M44 8 L164 8 L220 64 L220 236 A12 12 0 0 1 208 248 L44 248 A12 12 0 0 1 32 236 L32 20 A12 12 0 0 1 '
        '44 8 Z" fill="url(#paper)" stroke="#9aa5b5" stroke-width="4"/>'
        '<path d="M164 8 L164 52 A12 12 0 0 0 176 64 L220 64 Z" fill="#c4ccd8"/>'
    )
    return _picture(content, paper)


ICONS = {
    "brdf-suite": program(_sphere(128, 122, 82)),
    "brdf-designer": program(_rays() + _panel()),
    "brdf-viewer": program(_car(28, 92, 1.0)),
    "brdf-lobes": program(_lobe()),
    "brdf-swatch": program(_swatches(48, 48, 74, 12)),
    "brdfpaint": document(_sphere(126, 150, 62)),
    "brdfpalette": document(_swatches(68, 94, 54, 10)),
    "brdfview": document(_car(52, 118, 0.75)),
    "brdfstudio": document(_lamp(76, 90, 0.85)),
    "brdfproject": document(_swatches(64, 84, 28, 7) + _sphere(150, 178, 44, "gold")),
}
"""The icons by the names of their files."""


def rendered(svg: str, side: int) -> QImage:
    """Return an icon as pixels of ``side`` × ``side``."""
    image = QImage(QSize(side, side), QImage.Format.Format_ARGB32)
    image.fill(Qt.GlobalColor.transparent)
    painter = QPainter(image)
    QSvgRenderer(QByteArray(svg.encode())).render(painter)
    painter.end()
    return image


def main() -> None:
    """Write every icon."""
    app = QGuiApplication.instance() or QGuiApplication(["icons", "-platform", "offscreen"])
    FOLDER.mkdir(parents=True, exist_ok=True)
    for name, svg in ICONS.items():
        (FOLDER / f"{name}.svg").write_text(svg, encoding="utf-8")
        rendered(svg, SIDE).save(str(FOLDER / f"{name}.png"))
    del app


if __name__ == "__main__":
    main()
