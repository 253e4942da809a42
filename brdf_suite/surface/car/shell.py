"""The body's mesh: extracted, cut along all outlines, told apart into pieces, edges turned in.

Works on the half x ≥ 0. The pieces share the points on their borders until each is taken out on its own.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from brdf_suite.surface.car import outlines
from brdf_suite.surface.car.blends import Field, Floats
from brdf_suite.surface.car.body import ARCH_LIP, LINE, body
from brdf_suite.surface.car.cutting import PointFunction, at_points, cut, cut_all, surface_distance
from brdf_suite.surface.car.nets import (
    Ints,
    Soup,
    border,
    compact,
    extract,
    normals,
    project,
    refine,
    refine_near,
)
from brdf_suite.surface.car.simplify import merged

GAP = 0.005
"""Width of a shut line, m."""
_LIP = 0.0022
_REACH = 0.045


@dataclass(frozen=True)
class Area:
    """An area that is not paint: its material, how deep it lies below the surface (m), its border.

    ``border`` is a ring of that width (m) round the area, of material ``border_material``.
    """

    name: str
    region: Field
    material: str
    depth: float = 0.0
    border: float = 0.0
    border_material: str = "trim"


# Earlier entries win where areas overlap.
AREAS: tuple[Area, ...] = (
    Area("daylight", outlines.daylight, "lamp", 0.0015),
    Area("headlamp", outlines.headlamp, "glass", 0.0025, 0.004),
    Area("badge", outlines.badge, "chrome", 0.001),
    Area("grille", outlines.grille, "trim", 0.09, 0.010, "chrome"),
    Area("intake", outlines.intake, "trim", 0.06),
    Area("splitter", outlines.splitter, "trim", 0.004),
    Area("tail_band", outlines.tail_band, "lamp", 0.0015),
    Area("tail_panel", outlines.tail_panel, "glass", 0.0025, 0.004),
    Area("plate_recess", outlines.plate_recess, "trim", 0.018),
    Area("diffuser", outlines.diffuser, "trim", 0.012),
    Area("sill", outlines.sill, "trim", 0.004),
    Area("windscreen", outlines.windscreen, "glass", 0.0025, 0.010),
    Area("cowl", outlines.cowl, "trim", 0.012),
    Area("rear_screen", outlines.rear_screen, "glass", 0.0025, 0.010),
    Area("side_window", outlines.side_window, "glass", 0.004, 0.013, "chrome"),
)
PANELS: tuple[tuple[str, Field], ...] = (
    ("handle", outlines.handle),
    ("door", outlines.door),
    ("bonnet", outlines.bonnet),
    ("tailgate", outlines.tailgate),
    ("front_bumper", outlines.front_bumper),
    ("rear_bumper", outlines.rear_bumper),
)
REGIONS: dict[str, Field] = {
    "arch": outlines.arch,
    "split": outlines.window_split,
    **{area.name: area.region for area in AREAS},
    **dict(PANELS),
}
NAMES: tuple[str, ...] = (
    "paint",
    "gone",
    "groove",
    "split",
    *(name for name, _ in PANELS),
    *(area.name for area in AREAS),
    *(f"{area.name}_border" for area in AREAS if area.border),
)
"""What a triangle of the shell may belong to."""


@dataclass(frozen=True)
class Shell:
    """The cut surface: soup, unit normals (n, 3), and for each triangle the index of its piece."""

    soup: Soup
    normals: Floats
    piece: Ints
    names: tuple[str, ...]

    def chosen(self, name: str) -> NDArray[np.bool_]:
        """Return which triangles belong to a piece."""
        result: NDArray[np.bool_] = self.piece == self.names.index(name)
        return result


def _grid() -> tuple[Floats, Floats, Floats]:
    step = 0.032
    return np.arange(-step * 1.5, 1.02, step), np.arange(0.06, 1.45, 0.028), np.arange(-2.45, 2.40, 0.040)


def creases() -> list[PointFunction]:
    """Return the lines along which the surface bends sharply; edges of the mesh must follow them."""
    line = _on_side(lambda p: p[:, 1] - LINE(p[:, 2]))
    lips = [_offset(at_points(outlines.arch), at) for at in ARCH_LIP]
    return [line, _offset(line, 0.008), _offset(line, -0.008), *lips]


def smooth_surface() -> Soup:
    """Return the half body down to the floor, fine where it bends, with edges along its creases."""
    soup = extract(body, *_grid())
    soup = Soup(project(body, soup.points), soup.triangles)
    soup = cut(soup, lambda p: p[:, 0].copy(), snap=True)
    soup = soup.keep(soup.points[soup.triangles].mean(axis=1)[:, 0] > 0.0)
    first, *others = creases()
    soup = cut(soup, first, snap=True)
    soup = Soup(_on_centre(project(body, soup.points)), soup.triangles)
    under = at_points(outlines.floor)
    soup = cut(soup, under)
    soup = soup.keep(under(soup.points[soup.triangles].mean(axis=1)) > 0.0)
    for function in others:
        soup = cut(soup, function)
    for angle, shortest in ((9.0, 0.016), (8.0, 0.010), (9.0, 0.006)):
        soup = refine(body, soup, angle, shortest)
    return Soup(_on_centre(soup.points), soup.triangles)


def _on_centre(points: Floats) -> Floats:
    points[np.abs(points[:, 0]) < 1e-5, 0] = 0.0
    return points


def _on_side(function: PointFunction) -> PointFunction:
    """Return the function where a point is on the body side, elsewhere a value that does not change sign."""
    return lambda p: np.where((p[:, 0] > 0.6) & (np.abs(p[:, 2]) < 2.3), function(p), 1.0)


def _curves() -> tuple[list[PointFunction], dict[str, PointFunction]]:
    """Return what to cut along, and the distance function of each region by name."""
    distances = {name: surface_distance(region, body, _REACH) for name, region in REGIONS.items()}
    curves = [_offset(distances["arch"], 0.0), _offset(distances["arch"], _LIP)]
    for area in AREAS:
        distance = distances[area.name]
        curves.append(at_points(area.region))
        if area.border:
            curves.append(_offset(distance, area.border))
        if area.depth:
            curves.append(_offset(distance, area.border + _LIP))
    for name, _ in PANELS:
        curves += [
            _offset(distances[name], at) for at in (GAP / 2, -GAP / 2, GAP / 2 + _LIP, -GAP / 2 - _LIP)
        ]
    curves += [_offset(distances["split"], at) for at in (0.006, -0.006)]
    return curves, distances


def _fine() -> list[tuple[Field, float, float]]:
    """Return near which borders (within how many metres) edges must be how short for the cuts to be exact."""
    narrow: list[tuple[Field, float, float]] = [
        (outlines.daylight, 0.010, 0.010),
        (outlines.tail_band, 0.013, 0.014),
        (outlines.handle, 0.015, 0.012),
        (outlines.badge, 0.015, 0.012),
    ]
    return narrow + [(region, 0.008, 0.022) for region in REGIONS.values()]


def build_shell() -> Shell:
    """Return the half body with all outlines cut."""
    soup = smooth_surface()
    for field, reach, longest in _fine():
        soup = refine_near(body, soup, at_points(field), reach, longest)
    soup = Soup(_on_centre(soup.points), soup.triangles)
    fixed = [lambda p: p[:, 0], at_points(outlines.floor), *creases()]
    marks = np.stack([np.abs(function(soup.points)) < 3e-4 for function in fixed], axis=1)
    curves, distances = _curves()
    soup, marks = cut_all(soup, curves, marks)
    normal = normals(body, soup.points)
    soup = Soup(soup.points, merged(soup.points, normal, soup.triangles, marks, 0.009, 5.0))
    return Shell(soup, normal, _pieces(soup, distances), NAMES)


def _pieces(soup: Soup, distances: dict[str, PointFunction]) -> Ints:
    """Return the index in :data:`NAMES` of each triangle's piece; later assignments win."""
    middle = soup.points[soup.triangles].mean(axis=1)
    value = {name: distance(middle) for name, distance in distances.items()}
    piece = np.zeros(len(middle), dtype=np.int64)
    for name, _ in reversed(PANELS):
        piece[value[name] < 0.0] = NAMES.index(name)
    for name, _ in PANELS:
        piece[np.abs(value[name]) < GAP / 2] = NAMES.index("groove")
    for area in reversed(AREAS):
        if area.border:
            piece[value[area.name] < area.border] = NAMES.index(f"{area.name}_border")
        piece[value[area.name] < 0.0] = NAMES.index(area.name)
    on_split = (np.abs(value["split"]) < 0.006) & (piece == NAMES.index("side_window"))
    piece[on_split] = NAMES.index("split")
    piece[value["arch"] < 0.0] = NAMES.index("gone")
    return piece


def _offset(distance: PointFunction, at: float) -> PointFunction:
    return lambda points: distance(points) - at


def take(shell: Shell, chosen: NDArray[np.bool_]) -> tuple[Soup, Floats, Ints, Ints]:
    """Return the chosen triangles as a soup of their own, its normals, and two kinds of edges (e, 2).

    First the edges shared with other pieces, then those on wheel openings; they run as the chosen triangles
    do. Edges on the floor and in the middle are in neither.
    """
    kept = shell.soup.triangles[~shell.chosen("gone")]
    soup, index = compact(shell.soup.points, shell.soup.triangles[chosen])
    edge = border(soup.triangles)
    size = len(shell.soup.points)
    open_keys = np.sort(border(kept), axis=1) @ np.array([size, 1])
    is_open = np.isin(np.sort(index[edge], axis=1) @ np.array([size, 1]), open_keys)
    middle = soup.points[edge].mean(axis=1)
    on_arch = (
        is_open
        & (np.abs(at_points(outlines.arch)(middle)) < 2e-3)
        & (at_points(outlines.floor)(middle) > 1e-4)
    )
    return soup, shell.normals[index], edge[~is_open], edge[on_arch]
