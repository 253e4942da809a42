"""Where sphere and light are, from some positions of a session: the outline first, then the highlights."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
import numpy.typing as npt

from brdf_suite.acquisition.geometry.refinement.refinement import (
    Refinement,
    calibrate_geometry,
    format_movement_notice,
)
from brdf_suite.acquisition.geometry.sphere.edge import PhotographUnion
from brdf_suite.acquisition.geometry.sphere.highlight import Highlight, find_highlight
from brdf_suite.acquisition.geometry.sphere.outline import SphereOutline, find_outline
from brdf_suite.acquisition.geometry.sphere.placement import RigGeometry, nominal_geometry
from brdf_suite.acquisition.radiance.merge import MergedRadiance
from brdf_suite.acquisition.radiance.white_reference import irradiance_from_white, with_refined_white
from brdf_suite.acquisition.reconstruction.photographs import SessionPhotographs
from brdf_suite.errors import AcquisitionError
from brdf_suite.progress import Progress, report, subrange

HIGHLIGHT_STEP_DEG = 5.0
"""Between the positions whose highlights are looked for: 36 of 180 determine the geometry as well as all."""

UNION_POSITIONS = 10

_KEPT_BYTES = 600 << 20
"""Merged pictures that are kept between the rounds of the geometry; of larger ones the last are merged anew."""


@dataclass(frozen=True, eq=False)
class FoundGeometry:
    """What the geometry was found on, and how well it explains that; see
    :class:`~brdf_suite.acquisition.reconstruction.reconstruction.Acquisition`."""

    union: npt.NDArray[np.float32]
    outline: SphereOutline
    highlights: tuple[Highlight, ...]
    refinement: Refinement | None
    geometry: RigGeometry
    figures: Mapping[str, Any]
    notices: tuple[str, ...]
    left_out: Mapping[int, str] = field(default_factory=dict)


def find_geometry(photographs: SessionPhotographs, progress: Progress | None = None) -> FoundGeometry:
    """Find the sphere and, where the options say so, correct it and the light."""
    angles = tuple(position.angle_deg for position in photographs.session.positions)
    shiny = highlight_positions(angles, photographs.positions) if photographs.options.refine else ()
    wide = union_positions(angles, photographs.positions)
    union, kept = _read(photographs, wide, shiny, subrange(progress, 0.0, 0.8))
    picture = np.asarray(union.picture, np.float32)
    lens = None if photographs.intrinsics is None else photographs.intrinsics.intrinsics
    irradiance, notices = _irradiance(photographs)
    geometry = nominal_geometry(photographs.session, (picture.shape[0], picture.shape[1]), lens)
    geometry = replace(geometry, irradiance_rgb=irradiance)
    highlights: list[Highlight] = []

    def find(tried: RigGeometry, among: tuple[int, ...] = shiny) -> list[Highlight]:
        highlights.clear()
        for k in among:
            merged = kept.get(k)
            if merged is None and (stack := photographs.readable(k)) is not None:
                merged = photographs.merged_stack(stack, k)
            if merged is not None:
                clipped = merged.saturated
                seen = find_highlight(merged.radiance, tried, k, merged.good | clipped, clipped)
                if seen is not None:
                    highlights.append(seen)
        return list(highlights)

    with photographs.clock.step("calibrate"):
        outline = find_outline(union, geometry, photographs.mask(None))
        figures: dict[str, Any] = {"outline_rms_px": outline.rms_px}
        if not photographs.options.refine:
            return FoundGeometry(picture, outline, (), None, outline.geometry, figures, notices)
        try:
            refinement = calibrate_geometry(outline, find, subrange(progress, 0.8, 0.9))
        except AcquisitionError as error:
            # A matt sphere has none; what the session states of the lamp is then all there is.
            reason = "Light and sphere could not be corrected by highlights, and stand as stated"
            notices += (f"{reason}: {error}",)
            return FoundGeometry(picture, outline, (*highlights,), None, outline.geometry, figures, notices)
        if refinement.movements:
            before = list(highlights)
            try:
                union, outline, refinement = _where_it_stood(
                    photographs, refinement, geometry, shiny, find, subrange(progress, 0.9, 1.0)
                )
            except AcquisitionError as error:
                highlights[:] = before
                reason = "The sphere's outline is that of all positions, before and after it moved"
                notices += (f"{reason}: {error}",)
            else:
                picture = np.asarray(union.picture, np.float32)
                figures["outline_rms_px"] = outline.rms_px
    figures |= {
        "highlights": len(highlights),
        "highlight_rms_px": refinement.rms_px,
        "highlight_rms_deg": refinement.rms_deg,
    }
    names = [position.photographs[0] for position in photographs.session.positions]
    if refinement.movements:
        notices += (format_movement_notice(refinement, names),)
    moved = "the sphere has moved and stands elsewhere here"
    left_out = {k: f"{names[k]}: {moved}" for k in refinement.moved_positions}
    whole = with_refined_white(photographs.session, refinement.geometry)
    return FoundGeometry(picture, outline, (*highlights,), refinement, whole, figures, notices, left_out)


def _where_it_stood(
    photographs: SessionPhotographs,
    refinement: Refinement,
    geometry: RigGeometry,
    shiny: tuple[int, ...],
    find: Callable[[RigGeometry, tuple[int, ...]], list[Highlight]],
    progress: Progress | None,
) -> tuple[PhotographUnion, SphereOutline, Refinement]:
    """Refine the rig on the longest part without movement: a sum over two places has a blurred outline."""
    moved = frozenset(refinement.moved_positions)
    chosen = tuple(k for k in photographs.positions if k not in moved)
    angles = tuple(position.angle_deg for position in photographs.session.positions)
    union, _ = _read(photographs, union_positions(angles, chosen), (), subrange(progress, 0.0, 0.5))
    outline = find_outline(union, geometry, photographs.mask(None))
    among = tuple(k for k in shiny if k not in moved)
    again = calibrate_geometry(outline, lambda tried: find(tried, among), subrange(progress, 0.5, 1.0))
    movements = sorted((*refinement.movements, *again.movements), key=lambda row: row.before)
    return union, outline, replace(again, movements=tuple(movements))


def _read(
    photographs: SessionPhotographs, wide: tuple[int, ...], shiny: tuple[int, ...], progress: Progress | None
) -> tuple[PhotographUnion, dict[int, MergedRadiance]]:
    union: PhotographUnion | None = None
    kept: dict[int, MergedRadiance] = {}
    wanted = sorted({*wide, *shiny})
    for n, k in enumerate(wanted):
        report(progress, n / len(wanted), "reading for the geometry")
        stack = photographs.readable(k)
        if stack is None:
            continue
        merged = photographs.merged_stack(stack, k)
        if k in wide:
            rows, columns = merged.radiance.shape[:2]
            union = union or PhotographUnion((rows, columns))
            union.add(k, merged.radiance, merged.good)
        if k in shiny and (len(kept) + 1) * merged.radiance.nbytes <= _KEPT_BYTES:
            # The variance is not asked for: it would double what is kept.
            kept[k] = replace(merged, variance=merged.radiance)
    if union is None:
        raise AcquisitionError("None of the positions that light the sphere's outline can be read.")
    return union, kept


def _irradiance(photographs: SessionPhotographs) -> tuple[tuple[float, float, float] | None, tuple[str, ...]]:
    """Return the irradiance at the sphere, as stated or from the white reference, with notices."""
    light = photographs.session.light.irradiance_rgb
    if light is not None:
        return light, ()
    white = photographs.series("white")
    if white is None or photographs.session.white is None:
        sentence = (
            "The scale is unknown: the session states no irradiance and has no white reference, so the table is right "
            "but for one factor per channel."
        )
        return None, (sentence,)
    left, top, width, height = photographs.session.white.region
    merged = photographs.merged_stack(white, None, (slice(top, top + height), slice(left, left + width)))
    if not merged.good.any():
        raise AcquisitionError(f"The white reference ({white.names[0]} …) is saturated in all exposures.")
    seen = merged.radiance[merged.good].mean(axis=0, dtype=np.float64)
    return irradiance_from_white(photographs.session, seen), ()


def highlight_positions(angles_deg: tuple[float, ...], chosen: tuple[int, ...]) -> tuple[int, ...]:
    """Return the positions to look for highlights at: those chosen, every :data:`HIGHLIGHT_STEP_DEG`."""
    found: list[int] = []
    for k in chosen:
        if not found or angles_deg[k] - angles_deg[found[-1]] >= HIGHLIGHT_STEP_DEG - 1e-6:
            found.append(k)
    return tuple(found)


def union_positions(angles_deg: tuple[float, ...], chosen: tuple[int, ...]) -> tuple[int, ...]:
    """Return up to :data:`UNION_POSITIONS` positions that light the whole outline between them: 40° to 150°."""
    wide = [k for k in chosen if 40.0 <= angles_deg[k] <= 150.0] or list(chosen)
    places = np.linspace(0, len(wide) - 1, min(UNION_POSITIONS, len(wide)))
    return tuple(wide[round(float(place))] for place in places)
