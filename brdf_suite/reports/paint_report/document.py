"""A one-page report of a paint: what it is made of, worked out once for every form that it is written in."""

from __future__ import annotations

import io
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from datetime import datetime

import numpy as np
from PIL import Image

from brdf_suite.appearance.clearcoat_gloss import haze_units
from brdf_suite.appearance.colour.colorimetry import lab_to_working, working_to_display, working_to_lab
from brdf_suite.appearance.colour.spaces import SRGB_SPACE, in_display_gamut, lab_to_lch
from brdf_suite.appearance.difference.tolerance import Tolerances
from brdf_suite.appearance.flop.travel import travel
from brdf_suite.appearance.geometries import Geometry
from brdf_suite.appearance.texture import TextureReadings
from brdf_suite.arrays import Floats
from brdf_suite.documents.atomic import write_atomically
from brdf_suite.documents.paint import Lab, TextureTargets
from brdf_suite.documents.view import Camera, View
from brdf_suite.errors import PathLike, ValueRangeError
from brdf_suite.files.exports.format import ExportItem
from brdf_suite.files.exports.json_document import compute_flop
from brdf_suite.geometry.directions import aspecular_view, illumination
from brdf_suite.inspection.texture.readings import texture_of
from brdf_suite.output.still import loaded_scene
from brdf_suite.paint_design.standard import AngleRow, BatchReport, Standard, judge_batch
from brdf_suite.pipeline.exposure import metered
from brdf_suite.pipeline.lobe_fit import LobeFit, fit_material, refit_under
from brdf_suite.pipeline.material import material_of
from brdf_suite.pipeline.scene import default_view
from brdf_suite.progress import Progress, report, subrange
from brdf_suite.realtime.pictures.display import Display
from brdf_suite.reflectance.designed.paint_reflectance import PaintReflectance
from brdf_suite.reflectance.instruments.glossmeter import gloss_reading
from brdf_suite.reflectance.instruments.spectrophotometer import SUPPORT_DEG, support_notice
from brdf_suite.reflectance.protocol import Reflectance

_HERO, _SMALL = (1040, 640), (520, 640)
_SAMPLES = 4
SECOND = View(camera=Camera(elevation_deg=14.0), environment="sunny", surface="sphere")
"""The scene of the second picture: flakes show in the sun."""


@dataclass(frozen=True, eq=False)
class ReportPicture:
    """A PNG and what it shows."""

    title: str
    png: bytes
    width: int
    height: int


def draw_pictures(
    fit: LobeFit, view: View | None, scale: float, progress: Progress | None = None
) -> tuple[ReportPicture, ...]:
    """Return the pictures of a fit; ``view`` is the scene of the first one, the default one where left out.

    Errors as :func:`brdf_suite.output.still.render_to_file`.
    """
    scenes = ((view or default_view(), _HERO), (SECOND, _SMALL))
    pictures = []
    for index, (scene, (width, height)) in enumerate(scenes):
        size = (max(16, round(width * scale)), max(16, round(height * scale)))
        step = subrange(progress, index / len(scenes), (index + 1) / len(scenes))
        pictures.append(_draw(fit, scene, size, step))
    return tuple(pictures)


def _draw(fit: LobeFit, view: View, size: tuple[int, int], progress: Progress | None) -> ReportPicture:
    view = replace(view, clipping_marks=False, gamut_marks=False)
    with loaded_scene(view, subrange(progress, 0.0, 0.8)) as loaded:
        loaded.scene.set_material(refit_under(fit, view.light_colour))
        report(progress, 0.8, "drawing")
        renderer = loaded.scene.renderer
        shown = metered(renderer, loaded.composed(view, size), size)
        pixels = renderer.render_image(shown, size, _SAMPLES, display=Display(SRGB_SPACE))
        title = f"{loaded.mesh.name.replace('_', ' ')}, {loaded.prepared.environment.name}"
    packed = io.BytesIO()
    Image.fromarray(pixels).save(packed, "PNG", optimize=False)
    return ReportPicture(title, packed.getvalue(), size[0], size[1])


_STEP_DEG = 1.0
_SAME_DEG = 1e-6


@dataclass(frozen=True, eq=False)
class ReportOptions:
    """What goes into a report beside the paint.

    ``standard`` is what the paint is compared with, by ``tolerances``; ``view`` the scene of the first picture, the
    default one where left out. ``scale`` of the pictures: 1 is about 200 pixels an inch on paper.
    """

    standard: Standard | None = None
    tolerances: Tolerances = field(default_factory=lambda: Tolerances({}))
    view: View | None = None
    pictures: bool = True
    scale: float = 1.0


@dataclass(frozen=True)
class ReportRow:
    """One reading: what was asked, what the lobes of the fit give, and the standard there.

    ``sample_deg`` is the angle to the nearest sample, degrees, where it was read from scattered samples.
    """

    geometry: Geometry
    lab: Lab
    lch: tuple[float, float, float]
    code: str
    in_gamut: bool
    fitted: Lab | None
    fit_delta_e: float | None
    standard: AngleRow | None
    sample_deg: float

    @property
    def label(self) -> str:
        """The angle, with a sign where no sample lies near."""
        return self.geometry.label + ("" if self.sample_deg <= SUPPORT_DEG else "†")


@dataclass(frozen=True, eq=False)
class AngleCurve:
    """L*, C*, h (n, 3) over aspecular angles (n,), degrees."""

    title: str
    angles_deg: Floats
    lch: Floats


@dataclass(frozen=True, eq=False)
class Report:
    """Everything that a report shows; ``figures`` are groups of (name, value)."""

    item: ExportItem
    when: datetime
    rows: tuple[ReportRow, ...]
    light_deg: float
    strip: tuple[tuple[float, str], ...]
    curves: tuple[AngleCurve, ...]
    figures: tuple[tuple[str, tuple[tuple[str, str], ...]], ...]
    pictures: tuple[ReportPicture, ...]
    batch: BatchReport | None
    standard_name: str
    remarks: tuple[str, ...]

    @property
    def title(self) -> str:
        """The paint's name."""
        return self.item.name

    @property
    def verdict(self) -> str:
        """What is said of the paint against the standard; empty without one."""
        if self.batch is None:
            return ""
        passes = {True: "passes", False: "does not pass", None: "not judged by tolerances"}[self.batch.passes]
        words = self.batch.sentence()
        return f"Against {self.standard_name}: {words}; {passes}."


def build_report(item: ExportItem, options: ReportOptions, progress: Progress | None = None) -> Report:
    """Return the report of a paint.

    Raises
    ------
    UnreachableError, FittingError
        There is no such paint, or no lobes can be fitted to it.
    SuiteError
        The scene of the pictures cannot be had; the message says why.
    """
    report(progress, 0.0, "fitting")
    material = item.material or material_of(item.paint, item.paint.name)
    fit = fit_material(material)
    item = replace(item, texture=item.texture or texture_of(material))
    lights = [m.illumination_deg for m in item.paint.measurements]
    light = max(sorted(set(lights)), key=lights.count)  # with the most readings
    batch = None
    if options.standard is not None:
        batch = judge_batch(options.standard, item.paint, options.tolerances, ("2000",))
    pictures: tuple[ReportPicture, ...] = ()
    if options.pictures:
        pictures = draw_pictures(fit, options.view, options.scale, subrange(progress, 0.1, 0.9))
    used = [m.aspecular_deg for m in item.paint.measurements if m.illumination_deg == light]
    angles = np.arange(min(used), max(used) + 0.5 * _STEP_DEG, _STEP_DEG)
    model = _lab_over(fit.reflectance, light, angles)
    curves = [
        AngleCurve("paint", angles, lab_to_lch(model)),
        AngleCurve("fitted lobes", angles, lab_to_lch(_lab_over(fit.weights, light, angles))),
    ]
    if options.standard is not None and options.standard.seen is not None:
        curves.append(
            AngleCurve("standard", angles, lab_to_lch(_lab_over(options.standard.seen, light, angles)))
        )
    rows = _rows(item, fit, batch)
    return Report(
        item=item,
        when=datetime.now().astimezone(),
        rows=rows,
        light_deg=light,
        strip=tuple(zip(angles.tolist(), map(hex_code, model), strict=True)),
        curves=tuple(curves),
        figures=_figures(item, fit, rows, batch),
        pictures=pictures,
        batch=batch,
        standard_name="" if options.standard is None else options.standard.name,
        remarks=(*_support(rows, options.standard), *_remarks(item, fit)),
    )


def _lab_over(reflectance: Reflectance, light: float, angles: Floats) -> Floats:
    wi, wo = illumination(light), aspecular_view(light, angles)
    lab = working_to_lab(math.pi * reflectance.eval(np.broadcast_to(wi, wo.shape), wo))
    # Within the coat's own lobe no instrument of these angles looks, and its peak would hide the flop.
    return np.where((np.abs(angles) < 8.0)[:, None], np.nan, lab)


def hex_code(lab: Sequence[float] | Floats) -> str:
    """Return L*a*b* as sRGB, clipped, in the way of web pages."""
    if not np.all(np.isfinite(lab)):
        return "#ffffff"
    codes = np.clip(np.round(255.0 * working_to_display(lab_to_working(lab))), 0, 255).astype(int)
    return "#" + "".join(f"{code:02x}" for code in codes.tolist())


def _rows(item: ExportItem, fit: LobeFit, batch: BatchReport | None) -> tuple[ReportRow, ...]:
    fitted: dict[tuple[float, float], tuple[Lab, float]] = {}
    for row in fit.readings or fit.angles:
        fitted[row.illumination_deg, row.aspecular_deg] = (row.lab_fitted, row.delta_e_2000)
    rows = []
    for index, m in enumerate(item.paint.measurements):
        lightness, chroma, hue = lab_to_lch(m.lab).tolist()
        found = fitted.get((m.illumination_deg, m.aspecular_deg))
        geometry = Geometry(m.illumination_deg, m.aspecular_deg)
        rows.append(
            ReportRow(
                geometry,
                m.lab,
                (lightness, chroma, hue),
                hex_code(m.lab),
                bool(in_display_gamut(m.lab)),
                None if found is None else found[0],
                None if found is None else found[1],
                None if batch is None else batch.rows[index],
                item.nearest_sample_deg(geometry),
            )
        )
    return tuple(rows)


def _support(rows: tuple[ReportRow, ...], standard: Standard | None) -> tuple[str, ...]:
    """Return remarks that explain the sign † behind an angle, and behind a standard's difference."""
    own = support_notice((row.geometry, row.sample_deg) for row in rows)
    other = support_notice(
        (row.geometry, row.standard.sample_deg) for row in rows if row.standard is not None
    )
    name = "" if standard is None else standard.name
    return (*(f"† {text}" for text in own), *(f"† {name}: {text}" for text in other))


def _figures(
    item: ExportItem, fit: LobeFit, rows: tuple[ReportRow, ...], batch: BatchReport | None
) -> tuple[tuple[str, tuple[tuple[str, str], ...]], ...]:
    paint = item.paint
    flop = compute_flop(paint)
    shape = [("Flop index", "–" if flop is None else f"{flop:.1f}")]
    if batch is not None and batch.flop is not None:
        shape.append(("Flop of the standard", f"{batch.flop[0]:.1f}"))
    used = [m for m in paint.measurements if m.illumination_deg == 45.0]
    try:
        path = travel([m.aspecular_deg for m in used], [m.lab for m in used])
    except ValueRangeError:
        pass  # it has no readings at 15 and 110°, between which travel is defined
    else:
        shape += [
            ("Travel in a*b*", f"{path.length:.1f}"),
            ("Lightness travel", f"{path.lightness:+.1f}"),
            ("Chroma travel", f"{path.chroma:+.1f}"),
            ("Hue travel", f"{path.hue_deg:+.0f}°"),
        ]
    known = [row.fit_delta_e for row in rows if row.fit_delta_e is not None]
    worst = max(known) if known else fit.worst_delta_e
    shape.append(("Fit, worst ΔE00", "–" if worst is None else f"{worst:.2f}"))
    gloss = {angle: gloss_reading(fit.reflectance, angle) for angle in (20, 60)}
    stated = paint.gloss.gu_60 is not None
    gu_60 = gloss[60] if paint.gloss.gu_60 is None else paint.gloss.gu_60
    coat = [
        ("Gloss 20°", f"{paint.gloss.gu_20:.1f} GU"),
        ("Gloss 60°" + ("" if stated else ", computed"), f"{gu_60:.1f} GU"),
        ("Haze, G60 − G20", f"{haze_units(paint.gloss.gu_20, gu_60):.1f} GU"),
        ("Coat, index n", f"{fit.weights.ior:.3f}"),
    ]
    if isinstance(fit.reflectance, PaintReflectance):
        coat.append(("Coat, roughness α", f"{fit.reflectance.roughness:.4f}"))
    peel = paint.orange_peel
    if peel is not None:
        coat.append(("Orange peel", f"{peel.amplitude_um:.2g} µm, {peel.wavelength_mm:.2g} mm"))
    groups = [("Colour over the angle", tuple(shape)), ("Coat", tuple(coat))]
    groups.append(("Flakes", _flake_figures(fit, item.texture, paint.texture or TextureTargets())))
    return tuple(groups)


def _flake_figures(
    fit: LobeFit, texture: TextureReadings | None, targets: TextureTargets
) -> tuple[tuple[str, str], ...]:
    *wanted, wanted_graininess = targets.wanted
    flakes = fit.flakes
    if flakes is None:
        none = "none" if targets == TextureTargets() else "none, but the paint has targets"
        return (("Flakes", "none that can be seen"), ("Sparkle, graininess", none))

    rows = [
        ("Density", f"{flakes.density_per_mm2:.0f} /mm²"),
        ("Size", f"{flakes.size_um:.1f} µm"),
        ("Tilt, spread of slopes", f"{flakes.roughness:.3f}"),
        ("Colour spread", f"{flakes.colour_spread:.2f}"),
    ]
    if texture is not None:
        for one, target in zip(texture.sparkle, wanted, strict=True):
            value = f"{100.0 * one.grade:.0f} %, area {100.0 * one.area:.1f} %"
            rows.append((f"Sparkle {one.light_deg:g}°", value + _target(target, 0)))
        rows.append(("Graininess", f"{100.0 * texture.graininess:.2f} %{_target(wanted_graininess, 2)}"))
    return tuple(rows)


def _target(wanted: float | None, digits: int) -> str:
    return "" if wanted is None else f", target {100.0 * wanted:.{digits}f} %"


def _remarks(item: ExportItem, fit: LobeFit) -> tuple[str, ...]:
    paint = item.paint
    remarks = []
    if paint.notes.strip():
        remarks.append(f"Notes: {' '.join(paint.notes.split())}")
    if paint.source.strip():
        remarks.append(f"Source: {' '.join(paint.source.split())}")
    if item.computed:
        remarks.append("The readings are those of virtual instruments.")
    outside = [f"{m.aspecular_deg:g}°" for m in paint.measurements if not in_display_gamut(m.lab)]
    if outside:
        remarks.append(f"Outside sRGB, so that patch and picture are clipped: {', '.join(outside)}.")
    return (*remarks, *fit.notices)


Draw = Callable[[Report], tuple[bytes, tuple[str, ...]]]
"""Turns a report into the content of a file, and notes for the user."""


def write_report(
    options: ReportOptions,
    draw: Draw,
    items: Sequence[ExportItem],
    path: PathLike,
    progress: Progress | None = None,
) -> tuple[str, ...]:
    """Write the report of one paint; errors as :func:`build_report`, and :class:`FileError` where the disk refuses."""
    (item,) = items
    made = build_report(item, options, progress)
    report(progress, 0.95, "writing")
    content, notes = draw(made)
    write_atomically(path, content)
    return notes


def report_losses(item: ExportItem) -> tuple[str, ...]:
    """Return notices for the user before a report is written."""
    return (
        "Page and pictures are for people; programs read the paint from the data that goes along with it.",
        *(
            ("The measured table itself is left out: what the virtual instruments read of it goes in.",)
            if item.computed and item.document is None
            else ()
        ),
    )
