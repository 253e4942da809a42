"""A photo studio: a white cyclorama on three sides, a large softbox above, light strips and their stands before it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from numpy.typing import ArrayLike

from brdf_suite.appearance.light.matrix import lamp_colour
from brdf_suite.arrays import Floats
from brdf_suite.reference.mitsuba_modules import mi
from environments.solids import Solid, bar, box, join, net, quad, revolved, srgb, tube
from environments.stage import Panel, Stage, glazed, matt, metal, picture
from environments.textures import concrete, field, places, shaded
from environments.tracing import Light, TracedScene

EYE = (0.0, 0.9, 0.0)
_KELVIN = 6300.0
_COVE_M, _CORNER_M = 1.5, 2.4
_HALF_WIDTH, _BACK, _FRONT, _TOP = 6.6, -7.6, 5.6, 6.0
_ROOM = ((-11.0, 11.0), (-10.5, 11.5), 7.4)
_BLACK = srgb("#1c1c1e")


def _cyclorama() -> tuple[Solid, Solid]:
    """Return the floor up to the cove, and cove and walls as one smooth net along the plan of the studio."""
    angle = np.linspace(0.0, 0.5 * np.pi, 13)
    r = _CORNER_M
    left = np.stack([-_HALF_WIDTH + r - r * np.cos(angle), _BACK + r - r * np.sin(angle)], axis=-1)
    right = left[::-1] * [-1.0, 1.0]
    sides = np.linspace(_FRONT, _BACK + r, 24)[:-1]
    back = np.linspace(-_HALF_WIDTH + r, _HALF_WIDTH - r, 24)[1:-1]
    plan = np.concatenate(
        [
            np.stack([np.full(len(sides), -_HALF_WIDTH), sides], axis=-1),
            left,
            np.stack([back, np.full(len(back), _BACK)], axis=-1),
            right,
            np.stack([np.full(len(sides), _HALF_WIDTH), sides[::-1]], axis=-1),
        ]
    )
    along = np.gradient(plan, axis=0)
    inward = np.stack([-along[:, 1], along[:, 0]], axis=-1)
    inward /= np.linalg.norm(inward, axis=1, keepdims=True)
    bend = np.linspace(0.0, 0.5 * np.pi, 17)
    c = _COVE_M
    # From the floor, up the quarter circle, up the wall: how far inside the wall, and how high.
    inside = np.concatenate([c - c * np.sin(bend), np.zeros(6)])
    height = np.concatenate([c - c * np.cos(bend), np.linspace(c, _TOP, 7)[1:]])
    points = np.empty((len(height), len(plan), 3))
    points[..., 0] = plan[:, 0] + inside[:, None] * inward[:, 0]
    points[..., 2] = plan[:, 1] + inside[:, None] * inward[:, 1]
    points[..., 1] = height[:, None]
    reach = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(plan, axis=0), axis=1))])
    rise = np.concatenate([[0.0], np.cumsum(np.hypot(np.diff(inside), np.diff(height)))])
    walls = net(points, np.stack(np.broadcast_arrays(reach[None, :], rise[:, None]), axis=-1))
    floor = quad((-_HALF_WIDTH, 0.0, _FRONT), (2 * _HALF_WIDTH, 0, 0), (0, 0, _BACK - _FRONT))
    return floor, walls


def _paint(seed: int, wide: float, high: float, scuffs: float) -> Floats:
    """Return white studio paint, rolled on, with scuffs and the faint tracks of wheels and shoes."""
    x, y = places(wide, high, 2048, int(2048 * high / wide))
    tone = 1.0 + 0.012 * field(x, y, seed, 5.0, 1.2) + 0.008 * field(x, y, seed + 1, 0.6, 0.4)
    worn = np.clip(field(x * 2.0, y, seed + 2, 6.0, 1.3) - 0.9, 0.0, 1.5)
    marks = np.clip(1.0 - np.abs(field(x, y * 1.7, seed + 3, 4.0, 1.5)) * 60.0, 0.0, 1.0)
    marks *= np.clip(field(x, y, seed + 4, 3.0, 1.0) - 0.4, 0.0, 1.0)
    return shaded((0.73, 0.73, 0.725), tone * (1.0 - scuffs * (0.07 * worn + 0.16 * marks)))


def _light_panel(
    stage: Stage,
    size: tuple[float, float],
    centre: ArrayLike,
    toward: ArrayLike,
    luminance: float,
    depth: float,
) -> None:
    """Add a softbox: a black case with a rim, and cloth before its lamps, brightest in the middle."""
    wide, high = size
    facing = np.asarray(toward, float) - np.asarray(centre, float)
    facing /= np.linalg.norm(facing)
    elevation = np.degrees(np.arcsin(facing[1]))
    azimuth = np.degrees(np.arctan2(facing[0], facing[2]))
    rim = 0.05
    parts = [
        bar((-wide / 2 - rim, wide / 2 + rim), (-high / 2 - rim, -high / 2), (-depth, 0.06), _BLACK, 0.008),
        bar((-wide / 2 - rim, wide / 2 + rim), (high / 2, high / 2 + rim), (-depth, 0.06), _BLACK, 0.008),
        bar((-wide / 2 - rim, -wide / 2), (-high / 2, high / 2), (-depth, 0.06), _BLACK, 0.008),
        bar((wide / 2, wide / 2 + rim), (-high / 2, high / 2), (-depth, 0.06), _BLACK, 0.008),
        bar((-wide / 2, wide / 2), (-high / 2, high / 2), (-depth, -depth + 0.02), _BLACK),
    ]
    x, y, z = (float(v) for v in np.asarray(centre, float))
    case = join(parts).turned(-float(elevation), "x").turned(float(azimuth)).moved(x, y, z)
    stage.add("gear", case)
    cloth = quad((-wide / 2, -high / 2, 0.0), (wide, 0, 0), (0, high, 0))
    cloth = replace(cloth, uv=cloth.uv / [wide, high])  # Mitsuba samples a luminous picture over 0…1
    cloth = cloth.turned(-float(elevation), "x").turned(float(azimuth)).moved(x, y, z)
    u, v = places(2.0, 2.0, 192, 192)
    u, v = u - 1.0, v - 1.0
    fall = (1.0 - 0.42 * np.abs(u) ** 2.4) * (1.0 - 0.42 * np.abs(v) ** 2.4)
    edge = np.clip((1.0 - np.maximum(np.abs(u), np.abs(v))) / 0.02, 0.35, 1.0)
    seams = 1.0 - 0.035 * np.exp(-((((u * 3.0) % 1.0 - 0.5) / 0.02) ** 2)) * (wide > 3.0)
    glow = luminance * (fall * edge * seams)[..., None] * lamp_colour(_KELVIN)
    stage.lamp(cloth, picture(glow), wide * high * luminance)
    corners = cloth.points
    first, second = 0.5 * (corners[1] - corners[0]), 0.5 * (corners[2] - corners[0])
    if high > wide:
        first, second = second, first
    stage.panels.append(Panel(corners.mean(axis=0), first, second))


def _stand(stage: Stage, x: float, z: float, height: float, turn: float = 0.0, wheels: bool = True) -> None:
    """Add a light stand: three legs, a column of three tubes with collars."""
    steel, dark = srgb("#8c9094"), srgb("#26272a")
    parts = []
    for leg in (0.0, 120.0, 240.0):
        run = tube([[0, 0.62, 0], [0.0, 0.32, 0.3], [0.0, 0.05, 0.62]], 0.014, steel)
        parts.append(run.turned(leg + turn))
        if wheels:
            wheel = tube([[-0.018, 0.035, 0.62], [0.018, 0.035, 0.62]], [0.035, 0.035], dark, 14)
            parts.append(wheel.turned(leg + turn))
    for low, high, radius in (
        (0.2, 0.45 * height, 0.022),
        (0.45 * height, 0.75 * height, 0.017),
        (0.75 * height, height, 0.013),
    ):
        parts.append(tube([[0, low, 0], [0, high, 0]], radius, steel))
        parts.append(
            revolved([(0, -0.03), (radius + 0.012, -0.028), (radius + 0.012, 0.028), (0, 0.03)], dark).moved(
                y=high
            )
        )
    stage.add("stand", join(parts).moved(x, 0.0, z))


def _flag(stage: Stage, x: float, z: float, turn: float, size: tuple[float, float], low: float) -> None:
    wide, high = size
    cloth = bar((-wide / 2, wide / 2), (low, low + high), (-0.004, 0.004), srgb("#131314"))
    frame = tube(
        [
            [-wide / 2, low, 0],
            [wide / 2, low, 0],
            [wide / 2, low + high, 0],
            [-wide / 2, low + high, 0],
            [-wide / 2, low, 0],
        ],
        0.008,
        srgb("#6f7377"),
        6,
    )
    stage.add("cloth", cloth.turned(turn).moved(x, 0, z))
    stage.add("stand", frame.turned(turn).moved(x, 0, z))
    _stand(stage, x, z, low + high + 0.1, turn, wheels=False)


def _room(stage: Stage) -> None:
    """Add the hall about the cyclorama: dark walls with panels and doors, a ceiling with its grid, a concrete floor."""
    (west, east), (north, south), top = _ROOM
    deep, wide = south - north, east - west
    stage.add("floor", quad((west, -0.06, south), (wide, 0, 0), (0, 0, -deep)))
    wall = srgb("#5a5c5f")
    stage.add("wall", quad((west, 0, south), (0, 0, -deep), (0, top, 0), wall))
    stage.add("wall", quad((east, 0, north), (0, 0, deep), (0, top, 0), wall))
    stage.add("wall", quad((west, 0, north), (wide, 0, 0), (0, top, 0), wall))
    stage.add("wall", quad((east, 0, south), (-wide, 0, 0), (0, top, 0), wall))
    stage.add("wall", quad((west, top, north), (wide, 0, 0), (0, 0, deep), srgb("#3a3b3d")))
    for i in range(9):  # pilasters along the front wall, and the sliding door between them
        x = west + 1.2 + 2.45 * i
        stage.add("gear", bar((x - 0.12, x + 0.12), (0, top), (south - 0.14, south), srgb("#37393c"), 0.01))
    for i in range(2):
        stage.add(
            "gear",
            bar((-3.6 + 3.62 * i, 3.58 * i), (-0.03, 4.3), (south - 0.3, south - 0.2), srgb("#6a6f74"), 0.02),
        )
        for k in range(4):
            stage.add(
                "gear",
                bar(
                    (-3.35 + 3.62 * i, -0.25 + 3.6 * i),
                    (0.25 + k, 1.12 + k),
                    (south - 0.32, south - 0.29),
                    srgb("#757a7f"),
                    0.012,
                ),
            )
    stage.add("gear", bar((-3.9, 3.9), (4.3, 4.5), (south - 0.36, south - 0.1), srgb("#2d2f31"), 0.01))
    for z in np.arange(north + 1.0, south, 1.9):  # the lighting grid
        stage.add("stand", tube([[west, 6.5, z], [east, 6.5, z]], 0.03, srgb("#3c3e40"), 8))
    for x in np.arange(west + 1.0, east, 2.2):
        stage.add("stand", tube([[x, 6.56, north], [x, 6.56, south]], 0.03, srgb("#3c3e40"), 8))
        stage.add("gear", bar((x - 0.14, x + 0.14), (top - 0.35, top), (north, south), srgb("#232426"), 0.01))
    stage.add("cloth", quad((4.9, 2.75, south - 0.02), (0, 0.17, 0), (-0.45, 0, 0), srgb("#3fae6b")))
    stage.add("gear", bar((4.2, 5.2), (0, 2.15), (south - 0.06, south), srgb("#5b6064"), 0.015))


def _props(stage: Stage) -> None:
    """Add what stands about in front: a table, cases, wooden boxes, a ladder, a tripod, cables, paper rolls."""
    wood, case = srgb("#a77f52"), srgb("#303337")
    for i, (x, y, z, turn) in enumerate(
        ((-3.1, -0.06, 7.1, 12.0), (-3.05, 0.14, 7.12, 20.0), (-2.5, -0.06, 7.3, -8.0))
    ):
        stage.add("wood", box((0.5, 0.2, 0.3), wood * (1.0 - 0.08 * i), 0.008).turned(turn).moved(x, y, z))
    for x, z, turn, high in ((-5.4, 8.2, 8.0, 0.45), (-4.6, 8.6, -5.0, 0.6), (5.6, 8.4, 14.0, 0.5)):
        stage.add("gear", box((0.75, high, 0.5), case, 0.03).turned(turn).moved(x, -0.06, z))
        stage.add(
            "stand",
            box((0.77, 0.03, 0.52), srgb("#9a9da0"), 0.008).turned(turn).moved(x, -0.06 + 0.7 * high, z),
        )
    # Table with a screen.
    x, z = 3.4, 8.0
    stage.add("gear", bar((x - 0.5, x + 0.5), (0.86, 0.9), (z - 0.3, z + 0.3), case, 0.01))
    for dx in (-0.46, 0.46):
        for dz in (-0.26, 0.26):
            stage.add(
                "stand", tube([[x + dx, -0.06, z + dz], [x + dx, 0.86, z + dz]], 0.015, srgb("#8c9094"), 8)
            )
    stage.add("gear", bar((x - 0.48, x + 0.48), (0.2, 0.23), (z - 0.28, z + 0.28), case, 0.005))
    screen = quad((0.3, 0.0, 0.0), (-0.6, 0, 0), (0, 0.36, 0)).turned(-12.0, "x").moved(x, 0.99, z - 0.08)
    stage.add("cloth", screen.painted(srgb("#b9c4cc")))
    stage.add(
        "gear",
        bar((-0.32, 0.32), (-0.02, 0.38), (0.005, 0.03), _BLACK, 0.006)
        .turned(-12.0, "x")
        .moved(x, 0.99, z - 0.08),
    )
    stage.add("gear", bar((x - 0.1, x + 0.1), (0.9, 1.0), (z - 0.08, z + 0.02), _BLACK, 0.006))
    # Tripod with a camera.
    for leg in (0.0, 120.0, 240.0):
        stage.add(
            "stand",
            tube([[0.0, 1.2, 0.0], [0.0, -0.06, 0.5]], [0.02, 0.013], srgb("#2b2c2f"), 10)
            .turned(leg + 25)
            .moved(1.6, 0, 7.2),
        )
    stage.add("gear", box((0.15, 0.11, 0.08), _BLACK, 0.012).moved(1.6, 1.24, 7.2))
    stage.add("gear", tube([[0.0, 0.0, 0.0], [0.0, 0.0, -0.13]], 0.042, _BLACK, 18).moved(1.6, 1.295, 7.16))
    # Ladder and rolls of paper by the wall.
    for dx in (-0.22, 0.22):
        stage.add(
            "stand", tube([[7.4 + dx, -0.06, 9.3], [7.4 + dx * 0.7, 2.6, 10.2]], 0.022, srgb("#b5b8ba"), 8)
        )
    for k in range(8):
        y, z = 0.24 + 0.3 * k, 9.4 + 0.1 * k
        stage.add("stand", tube(np.array([[7.19, y, z], [7.61, y, z]]), 0.014, srgb("#b5b8ba"), 8))
    for i, tone in enumerate(("#b9b4a8", "#5a6a70", "#8c3c33", "#3a3b3d", "#c8c2b2")):
        stage.add(
            "wood", tube([[-8.4 + 0.3 * i, -0.06, 10.7], [-8.35 + 0.3 * i, 2.75, 11.2]], 0.07, srgb(tone), 14)
        )
    random = np.random.default_rng(3)
    for start, end in (((3.4, 8.3), (4.9, 6.2)), ((-4.6, 8.3), (-5.0, 4.4)), ((-4.8, 8.6), (5.2, 9.2))):
        t = np.linspace(0.0, 1.0, 40)[:, None]
        path = np.array(start) * (1 - t) + np.array(end) * t
        wander = np.cumsum(np.cumsum(random.normal(0, 0.012, (40, 2)), axis=0), axis=0) * (t * (1 - t)) * 4
        path = path + wander
        floor = np.where(path[:, 1] > _FRONT, -0.053, 0.007)
        stage.add("gear", tube(np.stack([path[:, 0], floor, path[:, 1]], axis=-1), 0.007, _BLACK, 6))


def photo_studio() -> TracedScene:
    """Return the scene; the cyclorama opens towards +z."""
    stage = Stage()
    stage.material("white", matt(picture(_paint(61, 13.2, 13.2, 1.0), 13.2, 13.2)))
    stage.material("cove", matt(picture(_paint(71, 13.2, 13.2, 0.25), 13.2, 13.2)))
    stage.material("floor", glazed(picture(concrete(81, 0.13), 6.0, 6.0), 0.2))
    stage.material("wall", matt())
    stage.material("cloth", matt())
    stage.material("wood", matt())
    stage.material("gear", glazed(roughness=0.3))
    stage.material("stand", glazed(roughness=0.12))
    stage.material("chrome", metal((0.7, 0.7, 0.7), 0.15))
    floor, walls = _cyclorama()
    stage.add("white", floor)
    stage.add("cove", walls)
    # The platform's front edge and the backs of the walls.
    stage.add(
        "wall", quad((-_HALF_WIDTH, -0.06, _FRONT), (2 * _HALF_WIDTH, 0, 0), (0, 0.06, 0), srgb("#8a8a88"))
    )
    for sign in (-1.0, 1.0):
        x = sign * (_HALF_WIDTH + 0.09)
        stage.add(
            "wood", bar((x - 0.08, x + 0.08), (-0.06, _TOP), (_BACK - 0.1, _FRONT), srgb("#a58a66"), 0.004)
        )
    stage.add(
        "wood", bar((-_HALF_WIDTH, _HALF_WIDTH), (-0.06, _TOP), (_BACK - 0.2, _BACK - 0.06), srgb("#a58a66"))
    )
    # Above; the long one that draws the side of the car; the two that draw its front; the one that lifts its far edge.
    _light_panel(stage, (3.6, 7.2), (0.0, 5.1, -0.4), (0.0, 0.0, -0.35), 4.2, 0.5)
    for x in (-1.6, 1.6):
        for z in (-3.6, 2.8):
            stage.add("chrome", tube([[x, 5.5, z], [x * 1.1, 6.5, z]], 0.006, around=6))
    _light_panel(stage, (6.4, 0.55), (5.3, 2.25, -0.6), (0.0, 0.75, -0.4), 7.0, 0.3)
    for z in (-3.0, 1.8):
        _stand(stage, 5.62, z, 2.2, 30.0)
    _light_panel(stage, (0.5, 2.9), (4.4, 1.75, 6.6), (0.0, 0.9, 1.2), 6.0, 0.3)
    _stand(stage, 4.62, 6.95, 1.9, 10.0)
    _light_panel(stage, (0.5, 2.9), (-4.5, 1.75, 6.5), (0.0, 0.9, 1.2), 4.5, 0.3)
    _stand(stage, -4.74, 6.85, 1.9, -20.0)
    _light_panel(stage, (5.2, 0.4), (-5.2, 3.9, -1.0), (0.0, 0.9, -0.4), 5.0, 0.25)
    for z in (-3.2, 1.2):
        stage.add("chrome", tube([[-5.4, 4.0, z], [-5.4, 6.5, z]], 0.01, around=6))
    # Washes along the tops of the walls, from above the picture.
    _light_panel(stage, (9.0, 0.5), (0.0, 6.1, -5.6), (0.0, 1.2, _BACK), 7.5, 0.2)
    for sign in (-1.0, 1.0):
        _light_panel(stage, (9.0, 0.5), (sign * 4.7, 6.1, -0.6), (sign * _HALF_WIDTH, 1.2, -0.6), 6.0, 0.2)
    _flag(stage, 2.4, 7.4, 30.0, (1.1, 1.7), 0.7)
    _flag(stage, -2.1, 8.4, -20.0, (1.5, 2.0), 0.5)
    _room(stage)
    _props(stage)
    scene = mi.load_dict({"type": "scene", **stage.objects()})
    description = (
        "A photo studio: white cyclorama, a softbox of 7.2 m by 3.6 m and 4.2 kcd/m² above, strips of 4.5 to "
        "7 kcd/m² at the sides, 6,300 K; path-traced from 0.9 m above the floor."
    )
    return TracedScene(
        "photo_studio", description, (Light("panels", scene, 6, 3.0, tuple(stage.panels)),), EYE
    )
