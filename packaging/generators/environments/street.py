"""A street of town houses with trees on a clear day; the car stands in its right lane, along z."""

from __future__ import annotations

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.lighting.procedural.hosek_wilkie import HosekWilkieSky
from brdf_suite.lighting.procedural.panorama import centres, directions
from brdf_suite.lighting.procedural.sun import DIAMETER_DEG, LimbDisc, Sun
from brdf_suite.pipeline.scene import load_surface
from brdf_suite.reference.mitsuba_modules import mi
from environments.houses import House, house_front, placed
from environments.solids import Solid, bar, join, quad, revolved, srgb
from environments.stage import FACE_COLOUR, Stage, colour_of, glazed, matt, picture
from environments.textures import (
    ashlar,
    bark,
    blend,
    bricks,
    cells,
    field,
    hashed,
    places,
    plaster,
    roof_tiles,
    shaded,
)
from environments.tracing import Light, TracedScene
from environments.trees import tree

EYE = (0.0, 0.9, 0.0)
SUN = Sun(height_deg=40.0, azimuth_deg=24.0)
TURBIDITY = 4.0
_ALBEDO = 0.2
_WEST, _EAST = -7.2, 3.9  # kerbs
_WEST_FRONT, _EAST_FRONT = -14.6, 12.6  # fronts of the houses
_KERB_M = 0.12
_REACH = 76.0

_HOUSES_WEST = (
    House(13.0, "plaster_cream", "", "#e4dccb", 4, 4, ground="shop", roof="slate", balconies=True),
    House(9.5, "brick", "", "#d8d0c0", 3, 3, 3.35, "shop", "tiles"),
    House(12.0, "plaster_ochre", "", "#e9e2d2", 4, 4, 3.15, "house", "tiles", shutters="#5d7064"),
    House(10.5, "ashlar", "", "#d3c9b4", 4, 3, 3.3, "shop", "slate", balconies=True),
    House(11.5, "plaster_rose", "", "#e8e0d4", 3, 4, 3.3, "shop", "tiles", shutters="#6b7480"),
    House(14.0, "plaster_grey", "", "#e6e3dc", 4, 5, 3.2, "house", "slate"),
    House(10.0, "brick", "", "#d6cdbb", 4, 3, 3.2, "shop", "slate"),
    House(13.0, "plaster_cream", "", "#e2dac8", 3, 4, 3.3, "shop", "tiles", shutters="#7a4a3e"),
)
_HOUSES_EAST = (
    House(11.0, "plaster_grey", "", "#e8e5de", 3, 4, 3.2, "house", "tiles"),
    House(12.5, "ashlar", "", "#d8cdb6", 3, 4, 3.3, "shop", "slate", balconies=True),
    House(10.0, "plaster_rose", "", "#e6ddd0", 3, 3, 3.2, "shop", "tiles", shutters="#4f6a70"),
    House(13.0, "brick", "", "#dcd3c2", 3, 4, 3.25, "shop", "slate"),
    House(11.0, "plaster_ochre", "", "#ece4d2", 3, 4, 3.15, "house", "tiles"),
    House(12.0, "plaster_cream", "", "#e6dfd0", 4, 4, 3.2, "shop", "slate", balconies=True),
    House(10.0, "brick", "", "#d9d0bf", 4, 3, 3.3, "shop", "tiles"),
    House(12.0, "plaster_grey", "", "#e4e1da", 4, 4, 3.2, "house", "slate"),
)


def _road(x: Floats, z: Floats) -> Floats:
    """Return asphalt with aggregate, wheel tracks, patches, cracks and markings."""
    grain = 1.0 + 0.2 * field(x, z, 21, 1.7, 0.05) + 0.1 * field(x, z, 22, 0.9, 0.5)
    tone = 1.0 + 0.07 * field(x, z, 23, 23.0, 1.3) + 0.06 * field(x * 5, z, 24, 31.0, 1.2)
    for lane in (1.05, -3.2):
        tone -= 0.1 * np.exp(-(((np.abs(x - lane) - 0.75) / 0.3) ** 2))
    patch = (np.abs(x - 2.3) < 0.9) & (np.abs((z + 40.0) % 47.0 - 20.0) < 3.4)
    tone = np.where(patch, 0.68 * tone, tone)
    crack = np.clip(1.0 - np.abs(field(x, z, 25, 17.0, 1.6)) * 70.0, 0.0, 1.0) * (
        field(x, z, 26, 29.0, 1.4) > 0.5
    )
    colour = shaded(srgb("#6c6b69"), np.clip(grain * tone, 0.3, 2.0) * (1.0 - 0.5 * crack))
    worn = np.clip(1.25 - 0.35 * field(x, z, 27, 1.3, 0.5), 0.0, 1.0) * 0.9
    middle = (np.abs(x + 1.65) < 0.06) & (z % 9.0 < 5.0)
    parking = (np.abs(x + 5.1) < 0.05) | ((x < -5.1) & (np.abs(z % 6.0 - 0.1) < 0.05))
    crossing = (np.abs(z - 21.0) < 1.6) & (np.abs((x + 0.25) % 1.0 - 0.5) < 0.25)
    colour = blend(colour, srgb("#d6d3ca"), worn * (middle | parking | crossing))
    hole = np.hypot(x - 0.1, z - 6.4)
    iron = np.where((np.floor(x * 25) + np.floor(z * 25)) % 2 == 0, 0.9, 1.2)
    return np.where((hole < 0.33)[..., None], shaded(srgb("#4b4844"), iron * (hole < 0.3) + 0.3), colour)


def _pavement(x: Floats, z: Floats) -> Floats:
    """Return slabs, with rows of setts along the kerb and the houses, stains and gum."""
    depth, column, row = cells(x, z, 0.6, 0.4, 0.01)
    light = (
        0.88
        + 0.22 * hashed(column, row, 31)
        + 0.1 * field(x, z, 32, 11.0, 1.1)
        + 0.1 * field(x, z, 33, 1.9, 0.2)
    )
    light *= 1.0 - 0.2 * np.clip(field(x, z, 34, 13.0, 0.9) - 1.6, 0.0, 1.0)
    slabs = blend(shaded(srgb("#8f8a80"), 0.5 * np.ones_like(x)), shaded(srgb("#a8a298"), light), depth)
    depth, column, row = cells(z, x, 0.12, 0.1, 0.014, 0.5)
    round_ = np.clip(depth * 1.4, 0.0, 1.0)
    tone = 0.7 + 0.5 * hashed(column, row, 35) + 0.1 * field(x, z, 36, 1.1, 0.3)
    setts = blend(shaded(srgb("#5b564e"), 0.8 * np.ones_like(x)), shaded(srgb("#8a857c"), tone), round_)
    edge = np.minimum(np.abs(x - _WEST), np.abs(x - _EAST))
    return np.where((edge < 1.9)[..., None], setts, slabs)


def _ground(stage: Stage) -> None:
    """Add road and pavements, finer near the eye, and kerbs stone by stone."""
    bands = (("near", -11.0, 11.0, 110.0), ("front", 11.0, _REACH, 34.0), ("back", -_REACH, -11.0, 34.0))
    strips = (
        ("road", _WEST, _EAST, 0.0, _road),
        ("west", _WEST_FRONT, _WEST, _KERB_M, _pavement),
        ("east", _EAST, _EAST_FRONT, _KERB_M, _pavement),
    )
    for band, low, high, density in bands:
        for strip, west, east, level, colour in strips:
            wide, long = east - west, high - low
            x, z = places(wide, long, int(wide * density), int(long * density))
            # Seen from above, u runs along x and v against z.
            pixels = colour(x + west, high - z)
            name = f"{strip}_{band}"
            stage.material(name, matt(picture(pixels, wide, long)))
            stage.add(name, quad((west, level, high), (wide, 0, 0), (0, 0, -long)))
    random = np.random.default_rng(9)
    for metre in range(-int(_REACH), int(_REACH)):
        for kerb, side in ((_WEST, -1.0), (_EAST, 1.0)):
            tone = srgb("#b3aea3") * random.uniform(0.85, 1.08)
            inner, outer = min(kerb, kerb + side * 0.16), max(kerb, kerb + side * 0.16)
            stage.add(
                "stone",
                bar((inner, outer), (-0.05, _KERB_M + 0.004), (metre + 0.004, metre + 0.996), tone, 0.018),
            )
    stage.add("stone", quad((-400, -0.02, 400), (800, 0, 0), (0, 0, -800), srgb("#8b877c")))


def _rows_of_houses(stage: Stage) -> None:
    for houses, front, turn, start in (
        (_HOUSES_WEST, _WEST_FRONT, 90.0, -46.0),
        (_HOUSES_EAST, _EAST_FRONT, -90.0, -42.0),
    ):
        z = start
        for number, house in enumerate(houses):
            built = Stage()
            house_front(built, house, 100 + number + int(turn))
            placed(stage, built, front, z + house.width / 2, turn)
            z += house.width
    # Both ends of the street.
    for z, turn, seed in ((58.0, 180.0, 7), (-60.0, 0.0, 8)):
        for number, (x, wall) in enumerate(
            ((-13.0, "plaster_ochre"), (0.0, "ashlar"), (13.0, "plaster_rose"))
        ):
            built = Stage()
            house = House(
                13.0,
                wall,
                "",
                "#e4ddce",
                4,
                4,
                3.25,
                "shop",
                "slate" if number == 1 else "tiles",
                balconies=number == 1,
            )
            house_front(built, house, 300 + 10 * seed + number)
            placed(stage, built, x, z, turn)


def _trees(stage: Stage) -> None:
    models = [tree(seed, height) for seed, height in ((11, 10.0), (12, 9.0), (13, 8.2))]
    spots = [(_WEST - 1.1, z) for z in (-38.0, -28.5, -19.0, -9.0, 3.5, 14.0, 26.0, 36.0)]
    spots += [(_EAST + 1.2, z) for z in (-36.0, -26.0, -16.0, -7.5, 17.5, 27.5, 38.0)]
    for number, (x, z) in enumerate(spots):
        wood, leaves = models[number % 3]
        turn = 137.5 * number
        stage.add("wood", wood.turned(turn).moved(x, _KERB_M, z))
        stage.add("leaves", leaves.turned(turn).moved(x, _KERB_M, z))
        stage.add(
            "stone", bar((x - 0.7, x + 0.7), (_KERB_M, _KERB_M + 0.015), (z - 0.7, z + 0.7), srgb("#5d5346"))
        )
        for a, b, c, d in (
            (-0.75, 0.75, -0.75, -0.69),
            (-0.75, 0.75, 0.69, 0.75),
            (-0.75, -0.69, -0.69, 0.69),
            (0.69, 0.75, -0.69, 0.69),
        ):
            stage.add(
                "metal",
                bar((x + a, x + b), (_KERB_M, _KERB_M + 0.035), (z + c, z + d), srgb("#33312e"), 0.006),
            )


def _furniture(stage: Stage) -> None:
    """Add lamps, bollards, benches and litter bins."""
    iron = srgb("#23282a")
    post = revolved(
        [
            (0.0, 0.0),
            (0.19, 0.0),
            (0.19, 0.12),
            (0.13, 0.18),
            (0.12, 0.75),
            (0.085, 0.85),
            (0.06, 1.0),
            (0.05, 3.9),
            (0.08, 3.95),
            (0.08, 4.05),
            (0.03, 4.1),
        ],
        iron,
        20,
    )
    lantern = revolved(
        [(0.03, 4.1), (0.2, 4.2), (0.25, 4.75), (0.29, 4.78), (0.12, 5.0), (0.03, 5.1), (0.0, 5.15)], iron, 8
    )
    glass = revolved([(0.17, 4.24), (0.235, 4.74)], srgb("#c9c4b4"), 8).scaled(1.06, 1.0, 1.06)
    bollard = revolved(
        [
            (0.0, 0.0),
            (0.09, 0.0),
            (0.09, 0.1),
            (0.06, 0.14),
            (0.05, 0.8),
            (0.075, 0.84),
            (0.075, 0.9),
            (0.04, 0.98),
            (0.0, 1.0),
        ],
        iron,
        16,
    )
    for x, spots in (
        (_WEST - 0.75, (-33.0, -14.0, 8.8, 20.0, 31.0)),
        (_EAST + 0.75, (-31.0, -11.5, 5.5, 22.5, 33.0)),
    ):
        for z in spots:
            for part in (post, lantern):
                stage.add("iron", part.moved(x, _KERB_M, z))
            stage.add("paint", glass.moved(x, _KERB_M, z))
    for z in np.arange(-20.0, 20.0, 2.4):
        stage.add("iron", bollard.moved(_EAST + 0.42, _KERB_M, float(z)))
    wood = srgb("#8a5f3a")
    for x, z, turn in ((_EAST + 3.2, -1.5, 180.0), (_WEST - 3.0, -4.0, 0.0), (_WEST - 3.0, 10.0, 0.0)):
        parts = [
            bar((-0.9, 0.9), (0.44, 0.475), (0.1 * k - 0.2, 0.1 * k - 0.11), wood, 0.008) for k in range(5)
        ]
        parts += [
            bar(
                (-0.9, 0.9),
                (0.58 + 0.12 * k, 0.67 + 0.12 * k),
                (-0.28 - 0.03 * k, -0.25 - 0.03 * k),
                wood,
                0.008,
            )
            for k in range(3)
        ]
        legs = [
            bar((a, a + 0.06), (0.0, 0.44 if k else 0.9), (-0.3 + 0.5 * k, -0.24 + 0.5 * k), iron, 0.01)
            for a in (-0.8, 0.74)
            for k in (0, 1)
        ]
        stage.add("paint", join(parts).turned(90.0 + turn).moved(x, _KERB_M, z))
        stage.add("metal", join(legs).turned(90.0 + turn).moved(x, _KERB_M, z))
    for x, z in ((_EAST + 0.9, 3.2), (_WEST - 0.9, -13.0)):
        stage.add(
            "iron",
            revolved(
                [(0, 0), (0.22, 0.0), (0.25, 0.05), (0.25, 0.75), (0.29, 0.78), (0.25, 0.84), (0.0, 0.95)],
                srgb("#2d4a3b"),
                20,
            ).moved(x, _KERB_M, z),
        )


_CAR_TONES = {
    "glass": "#0e1113",
    "chrome": "#b9bcbe",
    "rubber": "#1b1b1b",
    "tyre": "#1b1b1b",
    "rim": "#8f9294",
    "wheel": "#8f9294",
    "lamp": "#c9c9c4",
}


def _parked_cars(stage: Stage) -> None:
    """Add the packaged car, in plain colours, along the western kerb."""
    parts = load_surface("car").parts
    for z, paint, turn in (
        (9.2, "#8f969c", 0.0),
        (15.4, "#22324d", 0.0),
        (-9.6, "#7e2420", 0.0),
        (-15.8, "#d4d2cc", 0.0),
        (-27.6, "#30363a", 180.0),
        (33.4, "#9aa3a0", 0.0),
    ):
        for part in parts:
            tone = next((code for word, code in _CAR_TONES.items() if word in part.material), None)
            if tone is None:
                tone = paint if "paint" in part.material or "body" in part.material else "#1a1b1c"
            faces = part.triangles.astype(np.int64)
            solid = Solid(
                part.positions.astype(float),
                faces,
                np.zeros((len(part.positions), 2)),
                np.ones((len(faces), 3)),
                True,
            )
            name = "metal_smooth" if tone in ("#b9bcbe", "#8f9294") else "lacquer"
            stage.add(name, solid.painted(srgb(tone)).turned(turn).moved(_WEST + 1.1, 0.0, z))


def _materials(stage: Stage) -> None:
    white = plaster(51)
    for name, tint in (("cream", "#dccfae"), ("ochre", "#cfa567"), ("rose", "#c99f8b"), ("grey", "#bdbbb3")):
        stage.material(
            f"plaster_{name}", matt(picture(np.clip(white * srgb(tint) / 0.86, 0.01, 0.9), 8.0, 8.0))
        )
    stage.material("brick", matt(picture(bricks(52), 4.0, 3.0)))
    stage.material("ashlar", matt(picture(ashlar(53), 6.4, 3.2)))
    stage.material("tiles", matt(picture(roof_tiles(54), 4.0, 4.0)))
    stage.material("slate", matt(picture(roof_tiles(55, "#5a5f66"), 4.0, 4.0)))
    stage.material("wood", matt(picture(bark(56), 1.0, 1.0)))
    for name in ("stone", "cloth", "gable"):
        stage.material(name, matt())
    stage.material(
        "leaves",
        {
            "type": "principledthin",
            "base_color": FACE_COLOUR,
            "diff_trans": 0.85,
            "roughness": 0.55,
            "spec_trans": 0.0,
            "eta": 1.4,
        },
    )
    stage.material("pane", glazed())
    for name, roughness in (("paint", 0.25), ("metal", 0.2), ("iron", 0.2), ("metal_smooth", 0.1)):
        stage.material(name, glazed(roughness=roughness))
    stage.material("lacquer", glazed())


def _move_sun(scene: object, number: int) -> None:
    """Let the sun of a pass be a place on its disc, so that shadows get their soft edges."""
    radius = np.radians(0.5 * DIAMETER_DEG) * np.sqrt((0.7548776662 * number) % 1.0)
    angle = 2.0 * np.pi * ((0.5698402910 * number) % 1.0)
    side = np.cross(SUN.direction, [0.0, 1.0, 0.0])
    side /= np.linalg.norm(side)
    place = SUN.direction + radius * (np.cos(angle) * side + np.sin(angle) * np.cross(side, SUN.direction))
    values = mi.traverse(scene)
    values["sun.to_world"] = mi.Transform4f().look_at(
        origin=[0, 0, 0], target=(-place).tolist(), up=[0, 1, 0]
    )
    values.update()


def street() -> TracedScene:
    """Return the scene; the street runs along z, as a car stands in it."""
    stage = Stage()
    _materials(stage)
    _ground(stage)
    _rows_of_houses(stage)
    _trees(stage)
    _furniture(stage)
    _parked_cars(stage)
    objects = stage.objects()
    sky = HosekWilkieSky(SUN.direction, TURBIDITY, _ALBEDO)
    rows = 512
    toward = directions(centres(rows), centres(2 * rows))
    dome = sky.radiance(toward) * (toward[..., 1:2] > -0.01)
    disc = LimbDisc(SUN, TURBIDITY)
    by_sky = mi.load_dict(
        {"type": "scene", **objects, "sky": {"type": "envmap", "bitmap": mi.Bitmap(dome.astype(np.float32))}}
    )
    by_sun = mi.load_dict(
        {
            "type": "scene",
            **objects,
            "sun": {
                "type": "directional",
                "direction": (-SUN.direction).tolist(),
                "irradiance": colour_of(disc.illuminance()),
            },
        }
    )
    description = (
        f"A street of town houses with trees under the sky and sun of Hošek and Wilkie (2012, 2013), turbidity "
        f"{TURBIDITY:g}, sun {SUN.height_deg:g}° high, {DIAMETER_DEG:g}° across; path-traced from 0.9 m above the road."
    )
    lights = (
        Light("sky", by_sky, 5, 40.0, directions=3),
        Light("sun", by_sun, 5, 40.0, prepare=_move_sun, directions=1),
    )
    return TracedScene("street", description, lights, EYE, disc.add_to)
