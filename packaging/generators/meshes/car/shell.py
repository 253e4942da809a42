"""The body's mesh: extracted, cut along all outlines, separated into pieces, edges turned in.

Works on the half x ≥ 0. The pieces share the points on their borders until each is taken out on its own.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from brdf_suite.arrays import Floats, Integers
from meshes.car import outlines
from meshes.car.blends import Field
from meshes.car.body import ARCH_LIP, LINE, ROCKER, body, fillets
from meshes.car.cutting import PointFunction, at_points, cut, cut_all, offset, surface_distance
from meshes.car.nets import (
    Soup,
    border,
    compact,
    extract,
    find_turned_over,
    normals,
    project,
    refine,
    refine_bends,
    refine_near,
    slide_points,
)
from meshes.car.simplify import merge_points

GAP = 0.0055
"""Width of a shut line, m."""
_LIP = 0.0018
_REACH = 0.045
MERGE = 0.032


@dataclass(frozen=True)
class TrimArea:
    """An area of the body without paint: its material, its border, and whether it is an opening.

    ``border`` is a ring of that width (m) round the area, of material ``border_material``. Areas lie flush;
    an opening lies ``depth`` (m) below the surface instead, with dark walls.
    """

    name: str
    region: Field
    material: str
    border: float = 0.0
    border_material: str = "trim"
    depth: float = 0.0


# Earlier entries win where areas overlap.
AREAS: tuple[TrimArea, ...] = (
    TrimArea("daylight", outlines.daylight, "lamp"),
    TrimArea("headlamp", outlines.headlamp, "lens", 0.004),
    TrimArea("badge", outlines.badge, "chrome"),
    TrimArea("grille", outlines.grille, "cavity", 0.010, "chrome", depth=0.09),
    TrimArea("intake", outlines.intake, "cavity", depth=0.06),
    TrimArea("splitter", outlines.splitter, "trim"),
    TrimArea("tail_band", outlines.tail_band, "tail_lamp"),
    TrimArea("tail_panel", outlines.tail_panel, "lens", 0.004),
    TrimArea("plate_recess", outlines.plate_recess, "trim", depth=0.018),
    TrimArea("diffuser", outlines.diffuser, "trim"),
    TrimArea("sill", outlines.sill, "trim"),
    TrimArea("windscreen", outlines.windscreen, "glass", 0.012),
    TrimArea("cowl", outlines.cowl, "trim", depth=0.012),
    TrimArea("rear_screen", outlines.rear_screen, "glass", 0.012),
    TrimArea("side_window", outlines.side_window, "glass", 0.013, "chrome"),
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
    piece: Integers
    names: tuple[str, ...]

    def chosen(self, name: str) -> NDArray[np.bool_]:
        """Return which triangles belong to a piece."""
        result: NDArray[np.bool_] = self.piece == self.names.index(name)
        return result


def _grid() -> tuple[Floats, Floats, Floats]:
    """Return the coordinates of the first grid, m: long cells, since the body bends least along its length."""
    return np.arange(-0.045, 1.02, 0.032), np.arange(0.06, 1.45, 0.026), np.arange(-2.48, 2.40, 0.080)


def creases() -> list[tuple[PointFunction, float]]:
    """Return the lines along which the surface bends sharply, with how near (in the value) is on them.

    Edges of the mesh must follow them, or highlights along them would be ragged.
    """
    line = _within(lambda p: p[..., 1] - LINE(p[..., 2]), 0.5, -2.15, 1.9)
    lines = [offset(line, at) for at in (0.0, 0.005, -0.005, 0.016, -0.016)]
    rocker = _within(lambda p: p[..., 1] - ROCKER(p[..., 2]), 0.2, -1.2, 1.1)
    lines += [offset(rocker, at) for at in (0.0, 0.005, -0.005, 0.02, 0.05, 0.10, 0.19)]
    lines += [offset(at_points(outlines.arch), at) for at in ARCH_LIP]
    across = [offset(at_points(field), at) for field in fillets() for at in (0.25, -0.25, 0.75, -0.75)]
    return [(function, 3e-4) for function in lines] + [(function, 0.012) for function in across]


def smooth_surface() -> Soup:
    """Return the half body down to a little below the floor, fine where it bends, with edges along its creases."""
    soup = extract(body, *_grid())
    soup = Soup(project(body, soup.points), soup.triangles)
    soup = cut(soup, lambda p: p[:, 0].copy(), snap=True)
    soup = soup.keep(soup.points[soup.triangles].mean(axis=1)[:, 0] > 0.0)
    lines = [function for function, _ in creases()]
    soup = cut(soup, lines[0], snap=True)
    soup = Soup(_on_centre(project(body, soup.points)), soup.triangles)
    under = at_points(outlines.floor)(soup.points[soup.triangles].mean(axis=1))
    soup = soup.keep(under > -0.03)
    first = np.abs(lines[0](soup.points)) < 3e-4
    soup, marks = cut_all(soup, [(line, (0.0,)) for line in lines[1:]], first[:, None])
    before = project(body, soup.points, steps=2)
    points = before.copy()
    for column, function in enumerate(lines):
        alone = marks[:, column] & (marks.sum(axis=1) == 1) & (points[:, 0] > 1e-6)
        points[alone] = slide_points(body, points[alone], function)
    for _ in range(6):  # take back the moves that turned a sliver over
        turned = find_turned_over(Soup(points, soup.triangles), normals(body, points))
        moved_back = soup.triangles[turned].ravel()
        points[moved_back] = before[moved_back]
    soup = Soup(_on_centre(points), soup.triangles)
    for angle, shortest in ((10.0, 0.024), (9.0, 0.014), (9.0, 0.008)):
        soup = refine(body, soup, angle, shortest, creases())
    return Soup(_on_centre(soup.points), soup.triangles)


def _on_centre(points: Floats) -> Floats:
    points[np.abs(points[:, 0]) < 1e-5, 0] = 0.0
    return points


def _within(function: PointFunction, low_y: float, low_z: float, high_z: float) -> PointFunction:
    """Return the function on the body side between those bounds; elsewhere not a number, which is never cut."""

    def bounded(p: Floats) -> Floats:
        x, y, z = np.moveaxis(p, -1, 0)
        inside = (x > 0.5) & (y > low_y) & (z > low_z) & (z < high_z)
        return np.where(inside, function(p), np.nan)

    return bounded


def _curves() -> tuple[list[tuple[PointFunction, tuple[float, ...]]], dict[str, PointFunction]]:
    """Return which values of which functions to cut along, and the distance function of each region by name."""
    distances = {name: surface_distance(region, body, _REACH) for name, region in REGIONS.items()}
    curves: list[tuple[PointFunction, tuple[float, ...]]] = [(at_points(outlines.floor), (0.0,))]
    curves.append((distances["arch"], (0.0, _LIP)))
    for area in AREAS:
        curves.append((at_points(area.region), (0.0,)))
        rings = (area.border, area.border + _LIP) if area.border else (_LIP,)
        curves.append((distances[area.name], rings))
    for name, _ in PANELS:
        curves.append((distances[name], (GAP / 2, -GAP / 2, GAP / 2 + _LIP, -GAP / 2 - _LIP)))
    curves += [(at_points(joint), (0.0,)) for joint in outlines.JOINTS]
    return [*curves, (distances["split"], (0.006, -0.006))], distances


def _fine() -> list[tuple[Field, float, float]]:
    """Return near which borders (within how many metres) edges must be how short for the cuts to be exact."""
    narrow: list[tuple[Field, float, float]] = [
        (outlines.daylight, 0.009, 0.018),
        (outlines.tail_band, 0.013, 0.030),
        (outlines.handle, 0.015, 0.012),
        (outlines.badge, 0.015, 0.012),
    ]
    return narrow + [(region, 0.008, 0.060) for region in REGIONS.values()]


def build_shell() -> Shell:
    """Return the half body with all outlines cut."""
    soup = smooth_surface()
    for field, reach, longest in _fine():
        soup = refine_near(body, soup, at_points(field), reach, longest)
    for region in (*(area.region for area in AREAS), *(region for _, region in PANELS)):
        soup = refine_bends(body, soup, region, 0.010, 0.009)
    soup = Soup(_on_centre(soup.points), soup.triangles)
    fixed: list[tuple[PointFunction, float]] = [(lambda p: p[:, 0], 1e-6)]
    fixed += creases()
    marks = np.stack([np.abs(function(soup.points)) < near for function, near in fixed], axis=1)
    curves, distances = _curves()
    soup, marks = cut_all(soup, curves, marks)
    soup = Soup(_on_centre(project(body, soup.points, steps=1)), soup.triangles)
    normal = normals(body, soup.points)
    # Separated before merging: afterwards a triangle in a narrow bend may have its middle on the other side.
    piece = _pieces(soup, distances)
    triangles, kept = merge_points(soup.points, normal, soup.triangles, marks, MERGE, 7.5)
    return Shell(Soup(soup.points, triangles), normal, piece[kept], NAMES)


def _pieces(soup: Soup, distances: dict[str, PointFunction]) -> Integers:
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
    under = at_points(outlines.floor)(middle) < 0.0
    piece[(value["arch"] < 0.0) | under] = NAMES.index("gone")
    return piece


def across_gaps(points: Floats) -> Floats:
    """Return how far points (n, 3) lie from the middle of each panel's shut line, m, to either side: (panels, n)."""
    return np.stack([surface_distance(region, body, _REACH)(points) for _, region in PANELS])


def take(shell: Shell, chosen: NDArray[np.bool_]) -> tuple[Soup, Floats, Integers, Integers]:
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
