"""The maps of a factored reflectance side by side, with a scale, and the value and the direction under the mouse."""

from __future__ import annotations

import numpy as np
from brdf_qt.program.translation import mark, tr

from brdf_lobe_visualizer.cuts.image_view import SliceImageView
from brdf_lobe_visualizer.cuts.images import Grid, Picture, ScaleBar
from brdf_lobe_visualizer.words import plain
from brdf_suite.inspection.factor_pictures import FactorPicture, angles_at
from brdf_suite.inspection.slices.images import DECADES, Tone, colour_codes, mapped_codes, share_of
from brdf_suite.inspection.slices.values import Channel, channel_of

_BAR_STEPS = 128
_GREYS = np.repeat(np.arange(256, dtype=np.uint8)[:, None], 3, axis=1)
CHANNELS = {
    "colour": mark("colour"),
    "luminance": mark("luminance"),
    "red": mark("red"),
    "green": mark("green"),
    "blue": mark("blue"),
}
_CODES: dict[str, Channel] = {"luminance": "luminance", "red": "r", "green": "g", "blue": "b"}
TONES = {"gamma": mark("perceptual"), "log": mark("logarithmic")}
_READS = {
    "wi": "ωi",
    "wo": "ωo",
    "h": "h",
    "|wi|": "|ωi|",
    "|wo|": "|ωo|",
    "|h|": "|h|",
    "sqrt|h|": "√|h|",
    "w.h": "ω·h",
    "wi.wo": "ωi·ωo",
    "w.h,h.n": "ω·h, h·n",
    "wi.n,wo.n": "ωi·n, ωo·n",
}
"""How the paper writes what a map is read by."""


def title_of(picture: FactorPicture) -> str:
    """Return the factors as the paper writes them: p(ωi) p(ωo)."""
    name = picture.name or "?"
    return " ".join(f"{name}({_READS[read]})" for read in picture.reads)


def grid_of(pictures: tuple[FactorPicture, ...], channel: str, tone: Tone) -> Grid:
    """Return the pictures in one row, each over its largest value."""
    drawn, columns = {}, []
    for number, picture in enumerate(pictures):
        if channel == "colour":
            codes, value = colour_codes(picture.values, tone, 1.0), channel_of(picture.values, "luminance")
        else:
            value = channel_of(picture.values, _CODES[channel])
            codes = mapped_codes(share_of(value, tone, 1.0), _GREYS)
        notes = (tr("added peak"), tr("peak")) if picture.part == "peak" else ()
        drawn[0, number] = Picture(codes, value, nothing=picture.outside, notes=notes)
        columns.append(title_of(picture))
    return Grid(("",), tuple(columns), drawn, _bar(tone))


def _bar(tone: Tone) -> ScaleBar:
    values = (
        (1.0, 0.5, 0.2, 0.1, 0.02) if tone == "gamma" else tuple(10.0**-k for k in range(int(DECADES) + 1))
    )
    ticks = tuple((float(share_of(value, tone, 1.0)), plain(value)) for value in values)
    return ScaleBar(mapped_codes(np.linspace(0.0, 1.0, _BAR_STEPS), _GREYS), ticks, tr("relative to maximum"))


class FactorsView(SliceImageView):
    """Draws the maps of one reflectance."""

    def __init__(self) -> None:
        super().__init__("factor_maps", tr("Maps of the factors"))
        self._pictures: tuple[FactorPicture, ...] = ()

    def show_pictures(self, pictures: tuple[FactorPicture, ...], channel: str, tone: Tone, why: str) -> None:
        """Show maps, or ``why`` there are none."""
        self._pictures = pictures
        self.empty.setText(why)
        self.show_grid(grid_of(pictures, channel, tone) if pictures else None)

    def head_at(self, column: int, x: float, y: float) -> str:
        """Return the map, and where in it the mouse is: a direction, or the numbers that it is over."""
        picture = self._pictures[column]
        title = title_of(picture)
        if picture.form == "disc":
            angles = angles_at(x, y)
            if angles is None:
                return title
            return tr("{map}: θ {theta}°, φ {phi}°").format(
                map=title, theta=f"{angles[0]:.1f}", phi=f"{angles[1]:.0f}"
            )
        if picture.form == "band":
            return tr("{map}: at {x}").format(map=title, x=f"{x:.2f}")
        return tr("{map}: at {x}, {y}").format(map=title, x=f"{x:.2f}", y=f"{1.0 - y:.2f}")
