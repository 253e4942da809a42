"""The readout of the pixel under the cursor: values, and their words."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from brdf_qt.program.translation import decimal, tr

from brdf_suite.appearance.colour.colorimetry import REC709_TO_WORKING, srgb_decode, working_to_lab
from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.arrays import triple
from brdf_suite.documents.view import View
from brdf_suite.pipeline.picture import PAINT_MATERIAL, SECOND_MATERIAL
from brdf_suite.realtime.pictures.comparison import ComparedPicture, divider_px, sides
from brdf_suite.realtime.pictures.probe import PixelProbe, RadianceProbe, SurfacePoint
from brdf_suite.realtime.pictures.traced_light import TracedLight
from brdf_viewer.light.dominant import DominantLight
from brdf_viewer.scene.viewer_state import RealTimePicture

_SECOND = {PAINT_MATERIAL: SECOND_MATERIAL}
Lab = tuple[float, float, float]
Size = tuple[int, int]
Pixel = tuple[int, int]


@dataclass(frozen=True)
class PixelReading:
    """One pixel of A or B (empty where nothing is compared).

    ``lab`` is of the exposed light before the tone curve, D65 and 10°, a white of radiance 1 having L* = 100;
    of a shown picture it is that of its colour, which has no ``radiance`` (linear Rec. 2020, before exposure).
    """

    which: str
    lab: Lab
    radiance: tuple[float, float, float] | None
    point: SurfacePoint | None


@dataclass(frozen=True)
class CursorReading:
    """What is under the cursor: one reading, or two and their ΔE00 where a difference is shown."""

    readings: tuple[PixelReading, ...]
    delta_e: float | None
    light: DominantLight | None

    @property
    def angles(self) -> tuple[float, float | None] | None:
        """The angle of view and the aspecular angle in degrees; None background."""
        point = self.readings[0].point
        if point is None:
            return None
        if self.light is None:
            return (point.view_angle_deg, None)
        return (point.view_angle_deg, point.aspecular_deg(self.light.seen_from(point.position)))


def parts_at(view: View, size: Size, pixel: Pixel, *, shows_second: bool) -> list[tuple[str, Size, Pixel]]:
    """Return whose picture a pixel of the window belongs to: A, B or both, the size of that picture, and where.

    >>> from brdf_suite.documents.view_settings import Compare
    >>> parts_at(View(compare=Compare("side", "b")), (800, 600), (500, 10), shows_second=False)
    [('B', (400, 600), (100, 10))]
    """
    mode = view.compare.mode
    if mode == "side":
        left, right = sides(size)
        if pixel[0] < right[0]:
            return [("A", (left[2], left[3]), pixel)]
        return [("B", (right[2], right[3]), (pixel[0] - right[0], pixel[1]))]
    if mode == "swipe":
        first = pixel[0] < divider_px(view.compare.divider, size[0])
        return [("A" if first else "B", size, pixel)]
    if mode == "difference":
        return [("A", size, pixel), ("B", size, pixel)]
    return [("B" if mode == "blink" and shows_second else "A", size, pixel)]


def read_pixel(
    probe: PixelProbe,
    view: View,
    size: Size,
    pixel: Pixel,
    second: object,
    light: DominantLight | None,
    *,
    shows_second: bool = False,
    traced: TracedLight | None = None,
) -> CursorReading:
    """Read the pixel (column, row from the top) of the window; the context must be current.

    ``view`` is at the exposure at which it is shown; ``second`` what is compared with, None for nothing. Where the
    first picture is ``traced``, its radiance is that picture's; the point is the surface's all the same.
    """
    if second is None:
        return CursorReading((_of_paint("", _first(probe, traced, view, size, pixel), view),), None, light)
    readings = []
    for which, own_size, place in parts_at(view, size, pixel, shows_second=shows_second):
        if which == "A":
            readings.append(_of_paint("A", _first(probe, traced, view, own_size, place), view))
            continue
        materials = {} if isinstance(second, RealTimePicture) else _SECOND
        there = probe.at(view, own_size, place, materials=materials)
        if isinstance(second, ComparedPicture):
            readings.append(_of_picture(second, own_size, place, view, there.point))
        else:
            readings.append(_of_paint("B", there, view))
    both = len(readings) == 2 and readings[1].radiance is not None
    delta_e = float(delta_e_2000(readings[0].lab, readings[1].lab)) if both else None
    return CursorReading(tuple(readings), delta_e, light)


def _first(
    probe: PixelProbe, traced: TracedLight | None, view: View, size: Size, pixel: Pixel
) -> RadianceProbe:
    found = probe.at(view, size, pixel)
    if traced is None or traced.size != size:
        return found
    red, green, blue, coverage = (float(value) for value in traced.pixel(view, size, pixel))
    return replace(found, radiance=(red, green, blue), coverage=coverage)


def _of_paint(which: str, found: RadianceProbe, view: View) -> PixelReading:
    exposed = np.asarray(found.radiance) * 2.0**view.exposure_ev
    return PixelReading(which, triple(working_to_lab(exposed)), found.radiance, found.point)


def _of_picture(
    picture: ComparedPicture, size: Size, pixel: Pixel, view: View, point: SurfacePoint | None
) -> PixelReading:
    """Read a picture that fits by its width, as it is shown; black above and below it."""
    rows, columns = picture.pixels.shape[:2]
    scale = columns / size[0]
    column = int((pixel[0] + 0.5) * scale)
    row = int(np.floor(0.5 * rows + (pixel[1] + 0.5 - 0.5 * size[1]) * scale))
    inside = 0 <= row < rows
    value = picture.pixels[row, min(column, columns - 1)].astype(float) if inside else np.zeros(3)
    if picture.is_light:
        lab = working_to_lab(value * 2.0**view.exposure_ev)
        return PixelReading("B", triple(lab), triple(value), point)
    lab = working_to_lab(srgb_decode(value / 255.0) @ REC709_TO_WORKING.T)
    return PixelReading("B", triple(lab), None, point)


def lab_words(lab: Lab) -> str:
    """Return L*a*b* with a true minus sign.

    >>> lab_words((45.0, -3.25, 0.0))
    'L* 45.0  a* −3.2  b* 0.0'
    """
    return "  ".join(
        decimal(f"{name} {value:.1f}".replace("-", "−").replace("−0.0", "0.0"))
        for name, value in zip(("L*", "a*", "b*"), lab, strict=True)
    )


def short_words(reading: CursorReading) -> str:
    """Return the reading for the status bar."""
    first = reading.readings[0]
    words = f"{first.which}  {lab_words(first.lab)}".strip()
    if reading.delta_e is not None:
        words = decimal(f"ΔE00 {reading.delta_e:.2f}")
    if reading.angles is None:
        return words
    view, aspecular = reading.angles
    text = tr("{words}  view {view:.0f}°  aspecular {aspecular:.0f}°")
    if aspecular is None:
        text = tr("{words}  view {view:.0f}°")
    return text.format(words=words, view=view, aspecular=aspecular)


def long_lines(reading: CursorReading) -> list[str]:
    """Return the whole reading, line by line."""
    lines = []
    for one in reading.readings:
        light = ""
        if one.radiance is not None:
            light = "   " + tr("radiance") + " " + "  ".join(f"{value:.3g}" for value in one.radiance)
        lines.append(f"{one.which}  {lab_words(one.lab)}{light}".strip())
    if reading.delta_e is not None:
        lines.append(decimal(f"ΔE00 {reading.delta_e:.2f}"))
    point = reading.readings[0].point
    if point is None or reading.angles is None:
        lines.append(tr("background"))
        return lines
    view, aspecular = reading.angles
    angles, light = tr("view {view:.1f}°   aspecular {aspecular:.1f}°"), tr("from {light}")
    if aspecular is None:
        angles, light = tr("view {view:.1f}°"), tr("facing away from {light}")
    lines.append(angles.format(view=view, aspecular=aspecular))
    if reading.light is None:
        lines.append(tr("no aspecular angle: no dominant light source"))
    else:
        lines.append(light.format(light=reading.light.words))
    x, y, z = (1e3 * value for value in point.position)
    where = tr("x {x:.1f}  y {y:.1f}  z {z:.1f} mm on {part} ({material})")
    lines.append(where.format(x=x, y=y, z=z, part=point.part, material=point.material).replace("-", "−"))
    return lines
