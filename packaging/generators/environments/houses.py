"""Town houses: storeys with windows, sills and frames, doors and shops, cornices, roofs with dormers and chimneys.

A front stands along x about the origin and looks towards +z; its ground line is y = 0.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from brdf_suite.arrays import Floats
from environments.solids import Solid, bar, join, net, quad, srgb, swept
from environments.stage import Stage

_REVEAL = 0.22
_CORNICE = (
    (0.0, 0.0),
    (0.05, 0.0),
    (0.07, 0.05),
    (0.13, 0.09),
    (0.15, 0.15),
    (0.21, 0.17),
    (0.22, 0.24),
    (0.0, 0.26),
)


@dataclass(frozen=True)
class House:
    """A front ``width`` metres wide: its wall's material and colour, storeys, windows in a row, and ground floor."""

    width: float
    wall: str
    colour: str
    trim: str = "#d9d4c8"
    storeys: int = 4
    bays: int = 4
    storey_m: float = 3.25
    ground: str = "shop"
    roof: str = "slate"
    shutters: str = ""
    balconies: bool = False

    @property
    def eaves_m(self) -> float:
        """Height of the eaves."""
        return 4.1 + self.storeys * self.storey_m


def _window(
    stage: Stage, x: float, y: float, wide: float, high: float, trim: Floats, random: np.random.Generator
) -> None:
    """Add frame, panes, curtains, sill and surround of a window whose lower left corner is given."""
    frame = srgb(str(random.choice(["#e9e7e0", "#e9e7e0", "#dcd8cc", "#4c4a44"])))
    z = -_REVEAL
    dark = srgb(str(random.choice(["#0d0f11", "#121314", "#191817", "#0e1113"])))
    stage.add("pane", quad((x, y, z + 0.01), (wide, 0, 0), (0, high, 0), dark))
    if random.random() < 0.6:  # curtains behind the panes, seen as part of them
        tone = srgb(str(random.choice(["#8f8a80", "#a39c8c", "#77726c", "#96857a"]))) * random.uniform(
            0.35, 0.8
        )
        part = random.uniform(0.12, 0.3) * wide
        for start in (x, x + wide - part):
            stage.add("pane", quad((start, y, z + 0.012), (part, 0, 0), (0, high, 0), tone))
    if random.random() < 0.25:
        drop = random.uniform(0.2, 0.6) * high
        stage.add(
            "pane", quad((x, y + high - drop, z + 0.014), (wide, 0, 0), (0, drop, 0), srgb("#b6b0a2") * 0.7)
        )
    t = 0.06
    for x0, x1, y0, y1 in (
        (x, x + t, y, y + high),
        (x + wide - t, x + wide, y, y + high),
        (x, x + wide, y, y + t),
        (x, x + wide, y + high - t, y + high),
        (x + wide / 2 - 0.035, x + wide / 2 + 0.035, y, y + high),
        (x, x + wide, y + 0.68 * high, y + 0.68 * high + 0.045),
    ):
        stage.add("paint", bar((x0, x1), (y0, y1), (z + 0.012, z + 0.07), frame, 0.008))
    for corner, along, up in (
        ((x, y, 0), (0, 0, -_REVEAL), (0, high, 0)),
        ((x + wide, y, -_REVEAL), (0, 0, _REVEAL), (0, high, 0)),
        ((x, y + high, -_REVEAL), (wide, 0, 0), (0, 0, _REVEAL)),
        ((x, y, 0), (wide, 0, 0), (0, 0, -_REVEAL)),
    ):
        stage.add("stone", quad(corner, along, up, trim * 0.85))
    stage.add("stone", bar((x - 0.12, x + wide + 0.12), (y - 0.09, y), (-_REVEAL, 0.1), trim * 0.95, 0.015))
    for x0, x1, y0, y1 in (
        (x - 0.13, x, y, y + high + 0.13),
        (x + wide, x + wide + 0.13, y, y + high + 0.13),
        (x - 0.13, x + wide + 0.13, y + high, y + high + 0.15),
    ):
        stage.add("stone", bar((x0, x1), (y0, y1), (-0.02, 0.045), trim, 0.012))
    stage.add(
        "stone", bar((x - 0.2, x + wide + 0.2), (y + high + 0.17, y + high + 0.25), (-0.02, 0.13), trim, 0.02)
    )


def _wall(
    stage: Stage, house: House, y: float, high: float, holes: list[tuple[float, float, float, float]]
) -> None:
    """Add a strip of wall with rectangular holes (x0, x1, y0, y1), side by side and of one height."""
    left = -house.width / 2
    low, top = holes[0][2], holes[0][3]
    pieces = [(left, house.width / 2, y, low), (left, house.width / 2, top, y + high)]
    for hole in holes:
        pieces.append((left, hole[0], low, top))
        left = hole[1]
    pieces.append((left, house.width / 2, low, top))
    for x0, x1, y0, y1 in pieces:
        if x1 - x0 > 1e-3 and y1 - y0 > 1e-3:
            part = quad((x0, y0, 0), (x1 - x0, 0, 0), (0, y1 - y0, 0))
            stage.add(
                house.wall, Solid(part.points, part.faces, part.uv + np.array([x0 + 50.0, y0]), part.colours)
            )


def _ground_floor(stage: Stage, house: House, trim: Floats, random: np.random.Generator) -> None:
    """Add shop windows with a sign and an awning, or windows, and the door of the house."""
    width, high = house.width, 4.0
    sign = srgb(str(random.choice(["#26382f", "#3a2a2a", "#1f2b3a", "#56302a", "#2e2e2e", "#6b5a3a"])))
    count = max(2, round(width / 3.2))
    pitch = width / count
    door = int(random.integers(count))
    holes = []
    for i in range(count):
        middle = -width / 2 + (i + 0.5) * pitch
        half = 0.62 if i == door else min(1.28, 0.42 * pitch)
        holes.append((middle - half, middle + half, 0.0, 2.95))
    _wall(stage, house, 0.0, high, holes)
    for i, (x0, x1, _, top) in enumerate(holes):
        for corner, along, up in (
            ((x0, 0, 0), (0, 0, -0.35), (0, top, 0)),
            ((x1, 0, -0.35), (0, 0, 0.35), (0, top, 0)),
            ((x0, top, -0.35), (x1 - x0, 0, 0), (0, 0, 0.35)),
        ):
            stage.add("stone", quad(corner, along, up, trim * 0.8))
        if i == door:
            stage.add("paint", bar((x0, x1), (0.12, 2.3), (-0.33, -0.27), sign * 1.4, 0.01))
            for px in (x0 + 0.12, (x0 + x1) / 2 + 0.06):
                for py, ph in ((0.3, 0.7), (1.15, 0.95)):
                    stage.add("paint", bar((px, px + 0.44), (py, py + ph), (-0.29, -0.245), sign * 1.1, 0.02))
            stage.add(
                "pane", quad((x0 + 0.06, 2.4, -0.29), (x1 - x0 - 0.12, 0, 0), (0, 0.5, 0), srgb("#141618"))
            )
            stage.add("stone", bar((x0 - 0.1, x1 + 0.1), (0, 0.12), (-0.35, 0.28), srgb("#8d8a84"), 0.02))
            stage.add("metal", bar((x1 - 0.5, x1 - 0.47), (1.05, 1.3), (-0.25, -0.2), srgb("#c0a050"), 0.01))
            continue
        shop = house.ground == "shop"
        base = 0.45 if shop else 0.95
        stage.add("stone", bar((x0, x1), (0, base), (-0.33, -0.05), (sign if shop else trim) * 0.9, 0.015))
        stage.add("pane", quad((x0, base, -0.27), (x1 - x0, 0, 0), (0, top - base, 0), srgb("#16181a")))
        if shop:  # a display behind the glass
            for _ in range(7):
                px, pw = random.uniform(x0 + 0.05, x1 - 0.4), random.uniform(0.12, 0.4)
                ph = random.uniform(0.2, 1.2)
                tone = np.clip(random.uniform(0.06, 0.4, 3) * random.uniform(0.5, 1.0), 0, 1)
                stage.add(
                    "pane",
                    quad(
                        (px, base + 0.02, -0.268 + 0.0003 * random.random()),
                        (min(pw, x1 - px), 0, 0),
                        (0, ph, 0),
                        tone,
                    ),
                )
        for x in (x0, (x0 + x1) / 2 - 0.03, x1 - 0.06):
            stage.add(
                "paint",
                bar(
                    (x, x + 0.06), (base, top), (-0.27, -0.2), sign * 1.2 if shop else srgb("#e5e2da"), 0.008
                ),
            )
        stage.add(
            "paint",
            bar((x0, x1), (2.35, 2.42), (-0.27, -0.2), sign * 1.2 if shop else srgb("#e5e2da"), 0.008),
        )
    if house.ground == "shop":
        stage.add("paint", bar((-width / 2 + 0.3, width / 2 - 0.3), (3.1, 3.62), (-0.02, 0.1), sign, 0.02))
        letters = random.integers(6, 11)
        x = -0.16 * letters
        for _ in range(letters):
            stage.add(
                "paint",
                bar(
                    (x, x + random.uniform(0.12, 0.24)),
                    (3.22, 3.22 + random.uniform(0.2, 0.28)),
                    (0.1, 0.125),
                    srgb("#d8cda8"),
                    0.006,
                ),
            )
            x += 0.33
        if random.random() < 0.65:
            first, second = (
                srgb(str(random.choice(["#7c2f2a", "#2f4a3c", "#31456a", "#8a6a2f"]))),
                srgb("#cfc8b8"),
            )
            stripes = int(width * 0.7 / 0.3)
            for i in range(stripes):
                x = -0.15 * stripes + 0.3 * i
                tone = first if i % 2 else second
                stage.add("cloth", quad((x, 2.65, 1.3), (0.3, 0, 0), (0, 0.5, -1.25), tone))
                stage.add("cloth", quad((x, 2.45, 1.31), (0.3, 0, 0), (0, 0.2, 0), tone))
    profile = np.array([[0.0, 0.0], [0.09, 0.02], [0.14, 0.1], [0.16, 0.2], [0.0, 0.24]])
    stage.add("stone", swept(profile, width, trim).moved(y=high - 0.12))


def house_front(stage: Stage, house: House, seed: int) -> None:
    """Add a house to a stage of its own, which is then turned and moved as a whole."""
    random = np.random.default_rng(seed)
    trim = srgb(house.trim)
    _ground_floor(stage, house, trim, random)
    pitch = house.width / house.bays
    wide = min(1.25, 0.44 * pitch)
    for storey in range(house.storeys):
        y = 4.0 + storey * house.storey_m
        sill, high = 0.75, house.storey_m - 1.25
        if house.balconies and storey < house.storeys - 1:
            sill, high = 0.12, house.storey_m - 0.62
        centres = [-house.width / 2 + (i + 0.5) * pitch for i in range(house.bays)]
        holes = [(x - wide / 2, x + wide / 2, y + sill, y + sill + high) for x in centres]
        _wall(stage, house, y, house.storey_m, holes)
        for x in centres:
            _window(stage, x - wide / 2, y + sill, wide, high, trim, random)
            if house.shutters and random.random() < 0.9:
                for side in (x - wide / 2 - 0.12 - 0.5 * wide, x + wide / 2 + 0.12):
                    stage.add(
                        "paint",
                        bar(
                            (side, side + 0.5 * wide),
                            (y + sill, y + sill + high),
                            (0.0, 0.05),
                            srgb(house.shutters),
                            0.01,
                        ),
                    )
                    for k in range(int(high / 0.12)):
                        low = y + sill + 0.05 + 0.12 * k
                        stage.add(
                            "paint",
                            bar(
                                (side + 0.05, side + 0.5 * wide - 0.05),
                                (low, low + 0.07),
                                (0.045, 0.07),
                                srgb(house.shutters) * 0.9,
                                0.01,
                            ),
                        )
            if house.balconies and storey < house.storeys - 1:
                stage.add("stone", bar((x - 0.9, x + 0.9), (y - 0.02, y + 0.1), (-0.1, 0.62), trim, 0.02))
                for px in np.arange(x - 0.86, x + 0.87, 0.11):
                    stage.add(
                        "metal",
                        bar((px - 0.01, px + 0.01), (y + 0.1, y + 1.05), (0.56, 0.58), srgb("#1d1f20")),
                    )
                stage.add(
                    "metal", bar((x - 0.9, x + 0.9), (y + 1.05, y + 1.1), (0.54, 0.6), srgb("#1d1f20"), 0.008)
                )
        if storey and storey % 2 == 1:
            stage.add("stone", swept(np.array(_CORNICE) * 0.6, house.width, trim).moved(y=y - 0.08))
    eaves = house.eaves_m
    stage.add("stone", bar((-house.width / 2, house.width / 2), (eaves - 0.1, eaves), (-0.1, 0.01), trim))
    stage.add("stone", swept(np.array(_CORNICE) * 1.9, house.width, trim).moved(y=eaves - 0.02))
    for x in np.arange(-house.width / 2 + 0.25, house.width / 2, 0.5):
        stage.add(
            "stone", bar((x - 0.07, x + 0.07), (eaves - 0.02, eaves + 0.2), (0.0, 0.28), trim * 0.97, 0.015)
        )
    # The corners: long and short stones in turn, and the rain pipe.
    for side in (-1.0, 1.0):
        for k in range(int((eaves - 4.2) / 0.4)):
            length = 0.5 if k % 2 else 0.32
            edge = side * house.width / 2
            stage.add(
                "stone",
                bar(
                    (min(edge, edge - side * length), max(edge, edge - side * length)),
                    (4.15 + 0.4 * k + 0.01, 4.53 + 0.4 * k),
                    (-0.05, 0.03),
                    trim,
                    0.012,
                ),
            )
    stage.add(
        "metal",
        bar(
            (house.width / 2 - 0.12, house.width / 2 - 0.02),
            (0.1, eaves),
            (0.04, 0.14),
            srgb("#6d7272"),
            0.04,
        ),
    )
    _roof(stage, house, random)


def _roof(stage: Stage, house: House, random: np.random.Generator) -> None:
    """Add a steep roof with dormers and chimneys behind the eaves."""
    low, rise, run = house.eaves_m + 0.45, 2.9, 1.9
    half = house.width / 2
    stage.add(house.roof, quad((-half, low, -0.1), (house.width, 0, 0), (0, rise, -run)))
    stage.add(house.roof, quad((-half, low + rise, -0.1 - run), (house.width, 0, 0), (0, 1.4, -3.5)))
    for side in (-half, half):
        up = net(
            np.array(
                [
                    [[side, 0, -0.1], [side, 0, -6.0]],
                    [[side, low + rise, -0.1 - run], [side, low + rise + 1.4, -6.0]],
                ]
            ),
            np.array([[[0.0, 0.0], [6.0, 0.0]], [[0.0, 8.0], [6.0, 8.0]]]),
            smooth=False,
        )
        stage.add("gable", up.painted(srgb("#a89f90")))
    metal = srgb("#767d80")
    for i in range(0, house.bays):
        if house.bays > 3 and i % 2 == 0:
            continue
        x = -half + (i + 0.5) * house.width / house.bays
        stage.add(
            "paint", bar((x - 0.75, x + 0.75), (low + 0.25, low + 1.9), (-1.5, -0.25), srgb("#d6d2c8"), 0.02)
        )
        stage.add("paint", bar((x - 0.9, x + 0.9), (low + 1.9, low + 2.05), (-1.9, -0.12), metal, 0.03))
        stage.add("pane", quad((x - 0.5, low + 0.45, -0.24), (1.0, 0, 0), (0, 1.25, 0), srgb("#101214")))
        for px in (x - 0.52, x - 0.03, x + 0.46):
            stage.add(
                "paint", bar((px, px + 0.06), (low + 0.4, low + 1.72), (-0.25, -0.19), srgb("#ecebe6"), 0.008)
            )
    for _ in range(2):
        x = random.uniform(-half + 0.6, half - 0.6)
        stage.add("brick", bar((x - 0.55, x + 0.55), (low + rise - 0.6, low + rise + 2.1), (-3.9, -3.2)))
        stage.add(
            "stone",
            bar(
                (x - 0.62, x + 0.62),
                (low + rise + 2.1, low + rise + 2.22),
                (-3.97, -3.13),
                srgb("#9a948a"),
                0.02,
            ),
        )
        for px in (x - 0.35, x, x + 0.35):
            stage.add(
                "paint",
                bar(
                    (px - 0.1, px + 0.1),
                    (low + rise + 2.2, low + rise + 2.65),
                    (-3.65, -3.45),
                    srgb("#9c5a3f"),
                    0.04,
                ),
            )


def placed(stage: Stage, built: Stage, x: float, z: float, turn: float) -> None:
    """Add a house that was built on a stage of its own, its front at (x, z) and turned about y."""
    for name, solids in built.solids.items():
        stage.add(name, join(solids).turned(turn).moved(x, 0.0, z))
