"""A light tunnel: a hall with parallel tubes along its walls and ceiling, for judging the form of a body."""

from __future__ import annotations

import numpy as np

from brdf_suite.appearance.light.matrix import lamp_colour
from brdf_suite.arrays import Floats
from brdf_suite.reference.mitsuba_modules import mi
from environments.solids import Solid, bar, join, quad, revolved, srgb
from environments.stage import Panel, Stage, colour_of, glazed, matt, metal, picture
from environments.textures import blend, field, places, shaded
from environments.tracing import Light, TracedScene

EYE = (0.0, 0.9, 0.0)
_HALF_LENGTH, _HALL = 10.5, 9.0
_HALF_WIDTH, _SHOULDER, _HEIGHT, _HALF_CEILING = 3.9, 2.55, 3.7, 2.75
_KELVIN = 6200.0
_LUMINANCE = 9.0  # kcd/m² of a tube's diffuser
_TUBE, _GAP = 1.5, 0.09

# Places of the rows of tubes on the cross-section (x, y), and the direction of the wall's inside there.
_SLOPE = np.array([_HALF_CEILING - _HALF_WIDTH, _HEIGHT - _SHOULDER])
_INWARD = np.array([-_SLOPE[1], _SLOPE[0]]) / np.hypot(*_SLOPE)


def _rows() -> list[tuple[float, float, float, float]]:
    """Return x, y and the inward direction (x, y) of each row of tubes."""
    rows = [(0.0, _HEIGHT, 0.0, -1.0)]
    for x in (1.05, 2.1):
        rows += [(sign * x, _HEIGHT, 0.0, -1.0) for sign in (-1.0, 1.0)]
    for share in (0.5,):
        x, y = np.array([_HALF_WIDTH, _SHOULDER]) + share * _SLOPE
        rows += [(sign * x, y, sign * _INWARD[0], _INWARD[1]) for sign in (-1.0, 1.0)]
    for y in (0.75, 1.35, 1.95):
        rows += [(sign * _HALF_WIDTH, y, -sign, 0.0) for sign in (-1.0, 1.0)]
    return rows


def _fixture(x: float, y: float, inward: tuple[float, float], start: float) -> tuple[Solid, Solid]:
    """Return the tray and the diffuser of one tube along z."""
    tray = bar((-0.11, 0.11), (0.0, 0.045), (start, start + _TUBE), srgb("#dcdcd8"), 0.006)
    sides = [
        bar((x - 0.004, x + 0.004), (0.045, 0.092), (start + 0.02, start + _TUBE - 0.02), srgb("#c9c9c6"))
        for x in (-0.069, 0.069)
    ]
    ends = [
        bar((-0.07, 0.07), (0.045, 0.094), (z, z + 0.03), srgb("#c9c9c6"), 0.004)
        for z in (start + 0.01, start + _TUBE - 0.04)
    ]
    diffuser = quad((-0.065, 0.09, start + 0.04), (0.0, 0.0, _TUBE - 0.08), (0.13, 0.0, 0.0))
    # Upright on y = 0 as built: turned so that up is the wall's inside.
    turn = np.degrees(np.arctan2(-inward[0], inward[1]))
    return (
        join([tray, *sides, *ends]).turned(float(turn), "z").moved(x, y),
        diffuser.turned(float(turn), "z").moved(x, y),
    )


def _panels() -> Floats:
    """Return white wall panels, 3 m by 3 m: sheets of 1.5 m with narrow joints and a screw here and there."""
    x, y = places(3.0, 3.0, 1024, 1024)
    tone = 1.0 + 0.012 * field(x, y, 41, 3.0, 1.4)
    u, v = x % 1.5, y % 1.5
    joint = np.minimum(np.minimum(u, 1.5 - u), np.minimum(v, 1.5 - v))
    screw = np.hypot((x % 0.5) - 0.25, np.minimum(v, 1.5 - v) - 0.04)
    tone *= np.clip(0.45 + joint / 0.008, 0.0, 1.0) * np.where(screw < 0.008, 0.7, 1.0)
    return shaded((0.74, 0.74, 0.73), tone)


def _floor() -> Floats:
    """Return the floor, 21 m long and 7.8 m wide: sealed concrete with joints, lines and the marks of tyres."""
    wide, high = 2 * _HALF_WIDTH, 2 * _HALF_LENGTH
    x, z = places(wide, high, 1560, 4200)
    x, z = x - 0.5 * wide, z - 0.5 * high
    cloud = 1.0 + 0.08 * field(x, z, 7, 8.0, 1.3) + 0.05 * field(x, z, 8, 1.7, 0.9)
    fine = 0.04 * field(x, z, 9, 0.7, 0.4) - 0.25 * np.clip(field(x, z, 10, 3.0, 0.9) - 2.2, 0.0, 1.0)
    colour = shaded((0.235, 0.232, 0.222), cloud + fine)
    joint = np.minimum(np.abs(z % 3.0 - 1.5), np.abs(np.abs(x) - 3.1))
    colour = shaded(colour, np.where(joint < 0.005, 0.35, 1.0))
    track = np.exp(-(((np.abs(x) - 0.78) / 0.12) ** 2)) * np.clip(
        0.5 + 0.5 * field(x * 6, z, 12, 9.0, 1.2), 0, 1
    )
    colour = shaded(colour, 1.0 - 0.28 * track)
    line = np.clip((0.05 - np.abs(np.abs(x) - 1.75)) / 0.004, 0.0, 1.0) * (field(x, z, 13, 2.0, 0.7) < 1.6)
    return blend(colour, srgb("#c9a227"), 0.9 * line)


def _hall(stage: Stage) -> None:
    """Add what is seen past the open end: a dark hall with columns and high lamps."""
    near, far = -_HALF_LENGTH, -_HALF_LENGTH - _HALL
    stage.add("hall", quad((-9, 0, far), (18, 0, 0), (0, 6, 0), srgb("#6a7075")))
    stage.add("hall", quad((-9, 0, near), (0, 0, -_HALL), (0, 6, 0), srgb("#74797c")))
    stage.add("hall", quad((9, 0, far), (0, 0, _HALL), (0, 6, 0), srgb("#74797c")))
    stage.add("hall", quad((-9, 6, far), (18, 0, 0), (0, 0, _HALL), srgb("#4a4e52")))
    stage.add("hall", quad((-9, -0.001, near), (18, 0, 0), (0, 0, -_HALL), srgb("#73726d")))
    stage.add(
        "hall", quad((9, 0, near), (9 - _HALF_WIDTH, 0, 0) * np.array([-1, 1, 1]), (0, 6, 0), srgb("#8b8f92"))
    )
    stage.add("hall", quad((-_HALF_WIDTH, 0, near), (-9 + _HALF_WIDTH, 0, 0), (0, 6, 0), srgb("#8b8f92")))
    stage.add(
        "hall",
        quad((_HALF_WIDTH, _HEIGHT, near), (-2 * _HALF_WIDTH, 0, 0), (0, 6 - _HEIGHT, 0), srgb("#8b8f92")),
    )
    for x in (-5.5, -1.8, 1.9, 5.6):
        stage.add("steel", bar((x - 0.12, x + 0.12), (0, 6), (far + 1.2, far + 1.44), srgb("#3d5a73"), 0.01))
        stage.add("steel", bar((x - 0.15, x + 0.15), (5.55, 5.8), (far, near), srgb("#54585c"), 0.01))
    # A roller door at the back, shelves and a trolley beside it.
    for i in range(17):
        y = 0.2 * i
        stage.add(
            "steel", bar((-1.6, 2.2), (y + 0.006, y + 0.2), (far + 0.02, far + 0.07), srgb("#a5adb2"), 0.012)
        )
    for x, colour in (
        (-4.9, "#96552c"),
        (-4.2, "#3b6b8a"),
        (-3.5, "#8b8780"),
        (4.0, "#b08d3e"),
        (4.8, "#57705c"),
    ):
        stage.add("steel", bar((x, x + 0.55), (0.12, 0.62), (far + 0.3, far + 0.8), srgb(colour), 0.02))
        stage.add("steel", bar((x, x + 0.5), (1.12, 1.5), (far + 0.3, far + 0.75), srgb(colour), 0.02))
    for y in (0.08, 1.06, 2.0):
        for x in (-5.1, 3.8):
            stage.add(
                "steel", bar((x, x + 2.3), (y, y + 0.04), (far + 0.2, far + 0.9), srgb("#63676b"), 0.006)
            )
    lamps = [
        quad((x - 0.6, 5.4, z - 0.12), (1.2, 0, 0), (0, 0, 0.24))
        for x in (-3.7, 0.0, 3.7)
        for z in (far + 2.5, far + 6.0)
    ]
    stage.lamp(join(lamps), colour_of(5.0 * lamp_colour(4000.0)), 0.05)


def _front(stage: Stage) -> None:
    """Add the closed end: a folding door with panes, its frame, a sign and an extinguisher."""
    end = _HALF_LENGTH
    stage.add(
        "plain",
        quad((_HALF_WIDTH, 0, end + 0.08), (-2 * _HALF_WIDTH, 0, 0), (0, _HEIGHT, 0), srgb("#c9cac6")),
    )
    for i in range(6):
        x = -2.4 + 0.8 * i
        stage.add(
            "steel",
            bar((x + 0.012, x + 0.788), (0.02, 2.95), (end - 0.02, end + 0.05), srgb("#b9bec1"), 0.012),
        )
        stage.add(
            "pane", bar((x + 0.16, x + 0.64), (1.35, 2.35), (end - 0.028, end - 0.01), srgb("#20262b"), 0.004)
        )
        stage.add(
            "steel", bar((x + 0.1, x + 0.7), (0.25, 1.1), (end - 0.034, end - 0.01), srgb("#adb3b6"), 0.015)
        )
    for x in (-2.56, 2.4):
        stage.add("steel", bar((x, x + 0.16), (0, 3.1), (end - 0.09, end + 0.08), srgb("#4f565b"), 0.012))
    stage.add("steel", bar((-2.56, 2.56), (2.95, 3.14), (end - 0.09, end + 0.08), srgb("#4f565b"), 0.012))
    stage.add(
        "steel",
        revolved(
            [
                (0, 0),
                (0.08, 0.01),
                (0.085, 0.05),
                (0.085, 0.42),
                (0.06, 0.5),
                (0.02, 0.53),
                (0.02, 0.6),
                (0, 0.6),
            ],
            srgb("#b02a22"),
        ).moved(3.25, 0.75, end - 0.14),
    )
    stage.add("steel", bar((2.9, 3.6), (1.55, 2.15), (end - 0.2, end), srgb("#80878b"), 0.012))
    stage.lamp(
        quad((-0.3, 3.26, end - 0.02), (0, 0.16, 0), (0.6, 0, 0)),
        colour_of(0.25 * np.array([0.15, 1.2, 0.45])),
        0.001,
    )


def light_tunnel() -> TracedScene:
    """Return the scene; the tunnel runs along z, as a car stands in it."""
    stage = Stage()
    stage.material("panels", matt(picture(_panels(), 3.0, 3.0)))
    stage.material("floor", glazed(picture(_floor(), 2 * _HALF_WIDTH, 2 * _HALF_LENGTH), 0.22))
    stage.material("plain", matt())
    stage.material("hall", matt())
    stage.material("steel", glazed(roughness=0.18))
    stage.material("pane", glazed())
    stage.material("rail", metal((0.72, 0.72, 0.72), 0.25))
    length = 2 * _HALF_LENGTH
    stage.add("floor", quad((-_HALF_WIDTH, 0, _HALF_LENGTH), (2 * _HALF_WIDTH, 0, 0), (0, 0, -length)))
    for sign in (-1.0, 1.0):
        along = np.array([0.0, 0.0, sign * length])
        z = -sign * _HALF_LENGTH
        stage.add("panels", quad((sign * _HALF_WIDTH, 0, z), along, (0, _SHOULDER, 0)))
        stage.add(
            "panels", quad((sign * _HALF_WIDTH, _SHOULDER, z), along, (-sign * -_SLOPE[0], _SLOPE[1], 0))
        )
        stage.add(
            "plain",
            bar(
                (sign * _HALF_WIDTH - 0.02, sign * _HALF_WIDTH + 0.02),
                (0, 0.14),
                (-_HALF_LENGTH, _HALF_LENGTH),
                srgb("#50555a"),
                0.008,
            ),
        )
        stage.add(
            "rail",
            bar(
                (sign * 3.72 - 0.025, sign * 3.72 + 0.025),
                (0.3, 0.36),
                (-_HALF_LENGTH, _HALF_LENGTH),
                bevel=0.02,
            ),
        )
        for post in np.arange(-9.0, 9.1, 3.0):
            stage.add(
                "rail",
                bar(
                    (sign * 3.78 - 0.04, sign * 3.78 + 0.04),
                    (0, 0.36),
                    (post - 0.03, post + 0.03),
                    bevel=0.008,
                ),
            )
    stage.add(
        "panels", quad((-_HALF_CEILING, _HEIGHT, -_HALF_LENGTH), (2 * _HALF_CEILING, 0, 0), (0, 0, length))
    )
    # Ribs between the bays.
    for z in np.arange(-_HALF_LENGTH, _HALF_LENGTH + 0.1, 3.0):
        for sign in (-1.0, 1.0):
            stage.add(
                "plain",
                bar(
                    (sign * _HALF_WIDTH - 0.03, sign * _HALF_WIDTH + 0.03),
                    (0, _SHOULDER),
                    (z - 0.04, z + 0.04),
                    srgb("#d6d6d2"),
                    0.008,
                ),
            )
        stage.add(
            "plain",
            bar(
                (-_HALF_CEILING, _HALF_CEILING),
                (_HEIGHT - 0.03, _HEIGHT + 0.03),
                (z - 0.04, z + 0.04),
                srgb("#d6d6d2"),
                0.008,
            ),
        )
    diffusers = []
    for x, y, inward_x, inward_y in _rows():
        inward = np.array([inward_x, inward_y, 0.0])
        middle = np.array([x, y, 0.0]) + 0.09 * inward
        side = 0.065 * np.cross([0.0, 0.0, 1.0], inward)
        stage.panels.append(Panel(middle, np.array([0.0, 0.0, _HALF_LENGTH - 0.1]), side))
        start = -_HALF_LENGTH + 0.12
        while start + _TUBE < _HALF_LENGTH:
            tray, diffuser = _fixture(x, y, (inward_x, inward_y), start)
            stage.add("steel", tray)
            diffusers.append(diffuser)
            start += _TUBE + _GAP
    stage.lamp(join(diffusers), colour_of(_LUMINANCE * lamp_colour(_KELVIN)))
    _hall(stage)
    _front(stage)
    scene = mi.load_dict({"type": "scene", **stage.objects()})
    description = (
        "A light tunnel, 21 m long: rows of diffused tubes of 9 kcd/m² and 6,200 K along walls, shoulders and ceiling "
        "over sealed concrete; path-traced from 0.9 m above the floor."
    )
    return TracedScene(
        "light_tunnel", description, (Light("tubes", scene, 6, 3.0, tuple(stage.panels)),), EYE
    )
