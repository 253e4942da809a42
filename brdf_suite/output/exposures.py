"""Exposures that make up a picture of a view whose lens blurs: depth of field, and the turn of the object."""

from __future__ import annotations

import math
from dataclasses import replace

from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import PARAMETERS
from brdf_suite.output.turning import turned
from brdf_suite.realtime.camera import MIDDLE, Bounds, LensPoint, matrices, resolve
from brdf_suite.realtime.pictures.exposures import Exposure
from brdf_suite.surface.mesh import Mesh
from brdf_suite.surface.picking import pick

DEFAULT_EXPOSURES = 64
MOST_EXPOSURES = 4096
_GOLDEN = 0.6180339887498949
_SILVER = math.sqrt(2.0) - 1.0


def aperture_radius(view: View) -> float:
    """Return the radius of the lens's opening, metres; 0 of a pinhole."""
    lens = view.lens
    return 0.5e-3 * view.camera.focal_length_mm / lens.f_number if lens.f_number > 0.0 else 0.0


def focused(view: View, mesh: Mesh, size: tuple[int, int]) -> View:
    """Return the view with its focus: on what of the mesh is seen in the middle of a picture of ``size``, else named.

    Where the middle shows nothing of it, the camera's target is sharp.
    """
    if view.lens.f_number <= 0.0 or view.lens.focus_distance is not None:
        return view
    bounds = Bounds.of(part.positions for part in mesh.parts)
    camera = resolve(view.camera, bounds, size)
    seen = matrices(camera, bounds, size)
    hit = pick(mesh, seen.eye, -seen.view_to_world[:, 2])
    distance = hit.distance if hit is not None else camera.distance
    assert distance is not None  # the camera is resolved
    reach = PARAMETERS["lens.focus_distance"]
    return replace(view, lens=replace(view.lens, focus_distance=min(max(distance, reach.low), reach.high)))


def moment_of(number: int) -> float:
    """Return a moment of the exposure, -0.5 to 0.5 of its time: however many are taken, they are spread evenly."""
    return (number * _SILVER + 0.5) % 1.0 - 0.5


def exposures_of(view: View, bounds: Bounds, size: tuple[int, int], count: int) -> tuple[Exposure, ...]:
    """Return ``count`` exposures, or none of a view without blur. A lens without a focus is sharp at its target.

    Places of the opening are spread evenly over its disc (Vogel 1979), moments evenly over the exposure; they go on by
    irrational steps that have no common one, so neither follows the other.
    """
    lens = view.lens
    if not lens.blurs:
        return ()
    camera = resolve(view.camera, bounds, size)
    view = replace(view, camera=camera)
    focus = camera.distance if lens.focus_distance is None else lens.focus_distance
    assert focus is not None  # the camera is resolved
    radius = aperture_radius(view)
    found = []
    for number in range(count):
        away, angle = radius * math.sqrt((number + 0.5) / count), 2.0 * math.pi * _GOLDEN * number
        place = LensPoint(away * math.cos(angle), away * math.sin(angle), focus) if radius > 0.0 else MIDDLE
        moment = moment_of(number) if radius > 0.0 else (number + 0.5) / count - 0.5
        shown = turned(view, moment * lens.turn_deg, bounds.centre) if lens.turn_deg else view
        found.append(Exposure(shown, place))
    return tuple(found)
