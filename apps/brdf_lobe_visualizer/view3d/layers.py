"""From the session to a scene: which surfaces stand in which panel, over one another, with which words."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np
from brdf_qt.program.translation import decimal, tr

from brdf_lobe_visualizer.session import LobeSession
from brdf_lobe_visualizer.subjects.subjects import PlottedMaterial, Srgb
from brdf_lobe_visualizer.view3d.frame import CUT, Bar, FrameOptions, Layer, Panel, Scene, Style, rings_of
from brdf_lobe_visualizer.view3d.section import BODY_DEG, SpaceOptions
from brdf_lobe_visualizer.view3d.values import Found, SpaceValues, sample_points, with_cosine
from brdf_lobe_visualizer.words import UNIT, lobe_title, lobe_weight, number, quantity
from brdf_suite.arrays import Singles
from brdf_suite.inspection.lobe_surface.colour import difference_map, scalar_of, value_map
from brdf_suite.inspection.lobe_surface.grid import LobeGrid
from brdf_suite.inspection.lobe_surface.parts import FIT_PARTS, PART_CODES, FitLobe, FitPart, fit_lobes
from brdf_suite.inspection.lobe_surface.surface import (
    Colouring,
    LobeSurface,
    RadiusKind,
    RadiusScale,
    difference_surface,
    greatest,
    lobe_surface,
)

MOST_PANELS = 16
BODY_RADIUS = 0.5
"""How long a body is at least where the radius is automatic, whatever its mirror peak."""
PEAK_SHARE = 0.02
"""Share of the hemisphere's solid angle that counts as peak where the radius is automatic: a cap of 11.5°. The value
that the rest stays below is the body's; spikes between the samples of a sparse measurement do not move it."""
_NO_BODY = 1e-8
"""Share of the peak below which there is a spike and no body."""
_LEAST = 1e-30
"""Values below are nothing: a single's inverse of them is none."""


@dataclass(frozen=True, eq=False)
class _Sheet:
    """A surface before its scale is known.

    ``line`` is a colour of its own, which counts for every colouring. ``origin`` are the arrays that it comes from: the
    same ones make the same surface.
    """

    found: Found
    style: Style = "solid"
    opacity: float = 1.0
    line: Srgb | None = None
    legend: Srgb = (0.6, 0.6, 0.6)
    signed: bool = False
    origin: tuple[Singles, ...] = ()
    ink: bool = False


@dataclass(frozen=True, eq=False)
class _Plan:
    """A panel before its scale is known."""

    title: str
    sheets: tuple[_Sheet, ...]
    caption: str = ""
    note: str = ""
    colour: Srgb | None = None
    samples: PlottedMaterial | None = None


class SceneMaker:
    """Makes scenes of a session; what stays the same stays the same object, so that nothing is handed over twice."""

    def __init__(self, session: LobeSession, values: SpaceValues) -> None:
        self._session, self._values = session, values
        # With the arrays that they come from: while those are held, nothing else has their identities.
        self._made: dict[tuple[object, ...], tuple[tuple[Singles, ...], LobeSurface]] = {}
        self._shown: dict[tuple[object, ...], tuple[tuple[Singles, ...], LobeSurface]] = {}

    def scene(self, options: SpaceOptions) -> Scene:
        session = self._session
        shared = session.options
        self._values.forget_others({s.key for s in session.subjects})
        difference = shared.shown == "difference"
        plans = self._plans(options)[:MOST_PANELS]
        numbers = {
            id(sheet): with_cosine(sheet.found, shared.cosine) for plan in plans for sheet in plan.sheets
        }
        tops = [self._tops(plan, numbers) for plan in plans]
        common = common_full(tops, shared.radius, options)
        scales = []
        for top in tops:
            full = full_of(top, shared.radius, options) if options.own_scale else common
            scales.append(RadiusScale(shared.radius, full, options.decades))
        self._shown = {}
        panels = tuple(
            self._panel(plan, scale, numbers, options) for plan, scale in zip(plans, scales, strict=True)
        )
        self._made = self._shown
        scale = scales[0] if scales else RadiusScale(shared.radius, 1.0, options.decades)
        frame = FrameOptions(options.hemisphere, options.labels, options.arrows, options.rings)
        bar = None
        mapped = options.colouring == "values" and any(s.line is None for plan in plans for s in plan.sheets)
        if panels and (difference or mapped):
            bar = _bar(scale, quantity(shared), signed=difference)
        return Scene(panels, session.light, scale, bar, quantity(shared), frame)

    def _tops(self, plan: _Plan, numbers: dict[int, Singles]) -> Tops:
        channel = self._session.options.channel
        sheets = plan.sheets
        return Tops.most([tops_of(one.found.grid, scalar_of(numbers[id(one)], channel)) for one in sheets])

    def _plans(self, options: SpaceOptions) -> list[_Plan]:
        visible = self._session.visible
        if not visible:
            return []
        shown = self._session.options.shown
        if shown == "difference":
            return self._differences()
        if shown == "side by side":
            both = ([self._target_plan(s), *self._fit_plans(s, options)] for s in self._ordered())
            return [plan for plans in both for plan in plans]
        if shown == "fit" and options.lobes in ("apart", "parts", "stacked"):
            several = visible if options.arrangement == "panels" else self._ordered()[:1]
            return [plan for subject in several for plan in self._fit_plans(subject, options)]
        if options.arrangement == "panels" and len(visible) > 1:
            return [self._overlay((subject,), options) for subject in visible]
        return [self._overlay(self._ordered(), options)]

    def _ordered(self) -> tuple[PlottedMaterial, ...]:
        front = self._session.front
        return tuple(sorted(self._session.visible, key=lambda s: s is not front))

    def _overlay(self, subjects: tuple[PlottedMaterial, ...], options: SpaceOptions) -> _Plan:
        """Targets, fits or both over one another: the first solid, the others like glass, fits over their targets."""
        shown = self._session.options.shown
        sheets: list[_Sheet] = []
        notes: list[str] = []
        for place, subject in enumerate(subjects):
            legend = subject.colour if len(subjects) > 1 else None
            if shown in ("target", "both"):
                target = self._values.target(subject)
                if target is None:
                    notes.append(_coming())
                else:
                    style: Style = "solid" if place == 0 else "glass"
                    sheets.append(_sheet(target, style, subject, line=legend if place else None))
            if shown in ("fit", "both"):
                fit = self._values.fit(subject, self._lobes_on(subject))
                if fit is None:
                    notes.append(_no_fit(subject))
                    continue
                over = shown == "both" or place > 0
                style = options.fit_style if over else "solid"
                # Lines over a surface of their own colour would not be seen.
                ink = over and style == "lines" and legend is None
                sheets.append(_sheet(fit, style, subject, line=subject.colour if over else None, ink=ink))
        first, title = subjects[0], subjects[0].title
        if len(subjects) > 1:
            title = tr("{title} and {count} more").format(title=title, count=len(subjects) - 1)
        notes += [note for sheet in sheets for note in _notes(sheet)]
        return _Plan(
            title, tuple(sheets), _WORDS[shown](), "\n".join(dict.fromkeys(notes)), first.colour, first
        )

    def _target_plan(self, subject: PlottedMaterial) -> _Plan:
        target = self._values.target(subject)
        if target is None:
            return _plan(subject, tr("Target"), note=_coming(), samples=subject)
        sheet = _sheet(target, "solid", subject)
        return _plan(subject, tr("Target"), sheet, note="\n".join(_notes(sheet)), samples=subject)

    def _lobes_on(self, subject: PlottedMaterial) -> tuple[FitLobe, ...]:
        if subject.fit is None:
            return ()
        off = self._session.lobes_off(subject)
        return tuple(lobe for lobe in fit_lobes(subject.fit.weights) if lobe.key not in off)

    def _fit_plans(self, subject: PlottedMaterial, options: SpaceOptions) -> list[_Plan]:
        """A fit as it is wanted: whole, its parts, its lobes stacked, or each alone."""
        lobes = self._lobes_on(subject)
        whole = self._values.fit(subject, lobes)
        if whole is None:
            return [_plan(subject, tr("Fit"), note=_no_fit(subject))]
        sheet = _sheet(whole, "solid", subject)
        if not lobes:
            return [_plan(subject, tr("Fit"), sheet, note=tr("All lobes are switched off."))]
        if options.lobes == "apart":
            alone = [(lobe, self._part(subject, (lobe,), "solid")) for lobe in lobes]
            return [
                _Plan(lobe_title(lobe), (part,), lobe_weight(lobe), "", subject.colour)
                for lobe, part in alone
            ]
        if options.lobes == "parts":
            groups = [tuple(lobe for lobe in lobes if lobe.part == part) for part in FIT_PARTS]
            sheets = [
                self._part(subject, group, style)
                for group, style in zip(groups, _PART_STYLES, strict=True)
                if group
            ]
            return [_plan(subject, tr("Diffuse, directional diffuse and gloss, separately"), *sheets)]
        if options.lobes == "stacked":
            # Each shell holds all lobes within it: the last is the whole fit. The more shells, the clearer each: the
            # innermost is to be seen through all.
            glass = min(0.30, 0.9 / len(lobes))
            shells = [
                self._part(
                    subject, lobes[:count], "solid" if count == 1 else "glass", lobes[count - 1].part, glass
                )
                for count in range(1, len(lobes) + 1)
            ]
            words = tr("{count} lobes stacked, widest innermost").format(count=len(lobes))
            return [_plan(subject, words, *shells)]
        return [_plan(subject, tr("Fit: {count} lobes").format(count=len(lobes)), sheet)]

    def _part(
        self,
        subject: PlottedMaterial,
        lobes: tuple[FitLobe, ...],
        style: Style,
        part: FitPart | None = None,
        glass: float = 0.30,
    ) -> _Sheet:
        found = self._values.fit(subject, lobes)
        assert found is not None, "asked only where there is a fit"
        red, green, blue = PART_CODES[part or lobes[0].part]
        opacity = {"solid": 1.0, "glass": glass, "lines": 0.9}[style]
        return _Sheet(found, style, opacity, (red / 255.0, green / 255.0, blue / 255.0), subject.colour)

    def _differences(self) -> list[_Plan]:
        """Against the reference where one is chosen, else fit minus target."""
        reference = self._session.reference
        plans = []
        base = None if reference is None else self._values.target(reference)
        for subject in self._ordered():
            target = self._values.target(subject)
            if reference is not None and subject is not reference:
                words = tr("minus {title}").format(title=reference.title)
                plans.append(self._difference(subject, target, base, words))
            elif reference is None:
                fit = self._values.fit(subject, self._lobes_on(subject))
                if fit is None:
                    plans.append(_plan(subject, "", note=_no_fit(subject)))
                else:
                    plans.append(self._difference(subject, fit, target, tr("fit minus target")))
        if not plans and reference is not None:
            note = tr("Only the reference is shown. Show another reflectance to see its difference.")
            plans.append(_plan(reference, "", note=note))
        return plans

    def _difference(
        self, subject: PlottedMaterial, found: Found | None, base: Found | None, words: str
    ) -> _Plan:
        if found is None or base is None or found.grid is not base.grid:
            return _plan(subject, words, note=_coming())
        difference = Found(found.grid, found.values - base.values)
        origin = (found.values, base.values)
        sheet = _Sheet(difference, legend=subject.colour, signed=True, origin=origin)
        return _plan(subject, words, sheet, note="\n".join(_notes(sheet)))

    def _panel(
        self, plan: _Plan, scale: RadiusScale, numbers: dict[int, Singles], options: SpaceOptions
    ) -> Panel:
        surfaces = (self._surface(sheet, scale, numbers[id(sheet)], options) for sheet in plan.sheets)
        layers = tuple(
            Layer(surface, sheet.style, sheet.opacity, sheet.ink, sheet.found.grid)
            for surface, sheet in zip(surfaces, plan.sheets, strict=True)
        )
        notes = [plan.note] if plan.note else []
        if layers and all(layer.surface.dark for layer in layers):
            notes.append(tr("The reflectance is zero in every direction."))
        points = None
        if plan.samples is not None and options.samples and not any(s.signed for s in plan.sheets):
            points, words = sample_points(plan.samples, self._session, scale, options)
            if words:
                notes.append(words)
        caption = "\n".join(line for line in (plan.caption, self._peak(layers)) if line)
        return Panel(plan.title, caption, layers, points, "\n".join(notes), plan.colour)

    def _peak(self, layers: tuple[Layer, ...]) -> str:
        if all(layer.surface.dark for layer in layers):
            return ""
        most = max(greatest(layer.surface.values) for layer in layers)
        text = tr("maximum {value} {unit}").format(value=number(most), unit=UNIT)
        if float(layers[0].surface.scale.radius(most)) > CUT:
            text = tr("{text}, cut off in the picture").format(text=text)
        return text

    def _surface(
        self, sheet: _Sheet, scale: RadiusScale, values: Singles, options: SpaceOptions
    ) -> LobeSurface:
        shared = self._session.options
        colouring: Colouring = "line" if sheet.line is not None else options.colouring
        line = sheet.line or sheet.legend
        origin = sheet.origin or (sheet.found.values,)
        key = (tuple(map(id, origin)), sheet.signed, scale, shared.channel, shared.cosine, colouring, line)
        if key not in self._shown:
            kept = self._made.get(key)
            self._shown[key] = kept or (origin, self._make(sheet, scale, values, colouring, line))
        return self._shown[key][1]

    def _make(
        self, sheet: _Sheet, scale: RadiusScale, values: Singles, colouring: Colouring, line: Srgb
    ) -> LobeSurface:
        channel = self._session.options.channel
        if sheet.signed:
            return difference_surface(sheet.found.grid, scalar_of(values, channel), scale, CUT)
        return lobe_surface(
            sheet.found.grid, values, scale, channel=channel, colouring=colouring, line=line, most_radius=CUT
        )


@dataclass(frozen=True)
class Tops:
    """The greatest value, the greatest off the mirror direction, and what the body stays below (PEAK_SHARE)."""

    peak: float = 0.0
    off_mirror: float = 0.0
    body: float = 0.0

    @staticmethod
    def most(several: Sequence[Tops]) -> Tops:
        """Return the greatest of each."""
        return Tops(
            max((one.peak for one in several), default=0.0),
            max((one.off_mirror for one in several), default=0.0),
            max((one.body for one in several), default=0.0),
        )


def tops_of(grid: LobeGrid, shown: Singles) -> Tops:
    """Return what a scale is made of for values (rows, columns) on a grid."""
    off = np.where(grid.gamma > np.radians(BODY_DEG), shown, np.float32(0.0))
    return Tops(greatest(shown), greatest(off), _body(grid, shown))


def _body(grid: LobeGrid, shown: Singles) -> float:
    """Return the size of values that :data:`PEAK_SHARE` of the solid angle exceeds; holes count for nothing.

    A point of the grid stands for sin γ dγ dψ.
    """
    step = np.gradient(grid.gamma, axis=0) * np.gradient(grid.psi)
    weights = (np.sin(grid.gamma) * step)[:, :-1].ravel()
    sizes = np.abs(shown[:, :-1]).ravel()
    known = np.isfinite(sizes)
    if not known.any():
        return 0.0
    sizes, weights = sizes[known], weights[known]
    order = np.argsort(sizes)[::-1]
    above = np.cumsum(weights[order])
    place = int(np.searchsorted(above, PEAK_SHARE * above[-1]))
    return float(sizes[order[min(place, len(order) - 1)]])


def full_of(tops: Tops, kind: RadiusKind, options: SpaceOptions) -> float:
    """Return the value of radius 1, above 0, for what is shown.

    The automatic one is the peak as long as the body is :data:`BODY_RADIUS` long then; of a higher peak, as a coat or
    a spike of a measurement has it, the rest is cut off. It moves evenly with both, so that nothing jumps while the
    light is dragged.
    """
    if options.fill == "value":
        return options.full
    top = tops.off_mirror if options.fill == "body" else tops.peak
    if options.fill == "auto" and tops.body > _NO_BODY * tops.peak:
        top = min(tops.peak, tops.body / RadiusScale(kind, 1.0, options.decades).value(BODY_RADIUS))
    return top if top > _LEAST else 1.0


def common_full(tops: Sequence[Tops], kind: RadiusKind, options: SpaceOptions) -> float:
    """Return the value of radius 1 for several panels together.

    The automatic one is that of the panel in the middle, or where the longest body would be cut off then, that body:
    one that is far brighter or has spikes does not shrink the others to dots. Of two the darker one counts.
    """
    most = Tops.most(tops)
    if options.fill != "auto" or len(tops) < 2:
        return full_of(most, kind, options)
    fulls = sorted(full_of(one, kind, options) for one in tops if one.peak > _LEAST)
    middle = fulls[(len(fulls) - 1) // 2] if fulls else 1.0
    return min(max(middle, most.body), full_of(most, kind, options))


_PART_STYLES: tuple[Style, ...] = ("solid", "glass", "lines")
_WORDS: dict[str, Callable[[], str]] = {
    "target": lambda: "",
    "fit": lambda: tr("Fit"),
    "both": lambda: tr("Target with its fit overlaid"),
}


def _sheet(
    found: Found, style: Style, subject: PlottedMaterial, line: Srgb | None = None, *, ink: bool = False
) -> _Sheet:
    opacity = {"solid": 1.0, "glass": 0.45, "lines": 0.9}[style]
    return _Sheet(found, style, opacity, line, subject.colour, ink=ink)


def _plan(
    subject: PlottedMaterial,
    caption: str,
    *sheets: _Sheet,
    note: str = "",
    samples: PlottedMaterial | None = None,
) -> _Plan:
    return _Plan(subject.title, sheets, caption, note, subject.colour, samples)


def _coming() -> str:
    return tr("Computing the values…")


def _no_fit(subject: PlottedMaterial) -> str:
    return tr("{title} has no fit.").format(title=subject.title)


def _notes(sheet: _Sheet) -> list[str]:
    notes = []
    if sheet.found.stale:
        notes.append(tr("Outdated: computing the new values…"))
    holes = int(np.isnan(sheet.found.values[:, :-1]).any(axis=-1).sum())
    if holes:
        rows, columns = sheet.found.grid.shape
        share = holes / (rows * (columns - 1))
        text = tr("No values in {share} of the directions (holes).").format(share=f"{share:.1%}")
        notes.append(text if share < 1.0 else tr("No values in any direction."))
    return notes


def _bar(scale: RadiusScale, title: str, *, signed: bool) -> Bar:
    rounds = [(radius, text) for radius, text in rings_of(scale) if radius < 0.93]
    rows = [(1.0, decimal(f"{scale.full:.3g}")), *rounds]
    if not signed:
        least = decimal(f"≤ {scale.value(0.0):.2g}") if scale.kind == "log" else "0"
        return Bar(value_map(), (*rows, (0.0, least)), title)
    signs = [(0.5 + 0.5 * share, f"+{text}") for share, text in rows]
    signs += [(0.5 - 0.5 * share, f"−{text}") for share, text in rows]
    return Bar(difference_map(), (*signs, (0.5, "0")), title)
