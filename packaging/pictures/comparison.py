"""Draw docs/images/comparison_*.png and print the figures of docs/method/comparison.md.

    python packaging/pictures/comparison.py [--measured FILE] [--only sparkle|paints|models] [folder]

As Figures 6, 7 and 10 of Günther et al. 2005: flakes under a moving view and from near to far; the eight paints of
their Table 1 on one car; one measured paint as a table and in three models fitted to it, in one light. ``--measured``
names the table, a file of any format that the suite reads; without it the models are left out. The presets
(their Figure 8): packaging/pictures/raytraced.py.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw, ImageFont
from scipy.optimize import least_squares

from brdf_suite.appearance.colour.colorimetry import srgb_encode
from brdf_suite.documents.cook_torrance import CookTorranceLobe, CookTorrancePaint
from brdf_suite.documents.view import Camera, View
from brdf_suite.documents.view_settings import Sparkle, SurfaceLook
from brdf_suite.geometry.directions import aspecular_view, illumination
from brdf_suite.pipeline.environments import read_environment
from brdf_suite.pipeline.exposure import ev_of
from brdf_suite.pipeline.lobe_fit import PaintFitter
from brdf_suite.pipeline.material import Material, load_material, load_shipped_paint
from brdf_suite.pipeline.picture import OffscreenScene
from brdf_suite.pipeline.scene import find_environment, load_environment, load_surface
from brdf_suite.pipeline.surface import load_shaped
from brdf_suite.realtime.pictures.tone_curves import display_light
from brdf_suite.reflectance.models.cook_torrance import CookTorrance
from brdf_suite.reflectance.models.phong import CoatedPhong, Phong
from brdf_suite.reflectance.models.table_1 import TABLE_1
from brdf_suite.reflectance.protocol import Reflectance
from brdf_suite.tracing.agreement.comparison import errors_of
from brdf_suite.tracing.raytraced.picture import Quality, RaytracedSession
from brdf_suite.tracing.reference.scene import build_reference

FOLDER = Path(__file__).resolve().parents[2] / "docs" / "images"
CAPTION = 20
GAP = 4

MIDDLE = (0.0, 0.1, 0.0)  # of the ball of 0.2 m
MOVING = tuple((40.0 + turn, 0.14) for turn in (0.0, 0.5, 1.0, 1.5))  # azimuth, metres from the middle
FARTHER = tuple((40.0, far) for far in (0.14, 0.22, 0.4, 0.9))


def captioned(picture: Image.Image, text: str) -> Image.Image:
    """Return the picture with a line of text above."""
    whole = Image.new("RGB", (picture.width, picture.height + CAPTION), "white")
    whole.paste(picture, (0, CAPTION))
    ImageDraw.Draw(whole).text((2, 3), text, fill="black", font=ImageFont.load_default(12))
    return whole


def sheet(rows: list[list[Image.Image]]) -> Image.Image:
    """Return rows of pictures of one size."""
    width, height = rows[0][0].size
    columns = max(len(row) for row in rows)
    whole = Image.new("RGB", (columns * (width + GAP) - GAP, len(rows) * (height + GAP) - GAP), "white")
    for y, row in enumerate(rows):
        for x, picture in enumerate(row):
            whole.paste(picture, (x * (width + GAP), y * (height + GAP)))
    return whole


def sparkle(folder: Path) -> None:
    """Figure 6, in real time: the flakes of a coarse silver in the sun."""
    size = (240, 170)
    fitter = PaintFitter(time_limit_s=1.0)
    with OffscreenScene() as scene:
        scene.set_surface(load_surface("sphere"))
        scene.set_environment(load_environment("sunny"))
        scene.set_material(fitter.fit(load_shipped_paint("coarse_silver")))
        rows = []
        for places, title in ((MOVING, "turned by {0:g}°"), (FARTHER, "{1:.0f} cm away")):
            row = []
            for azimuth, distance in places:
                view = View(
                    Camera(azimuth, 36.0, distance, MIDDLE),
                    sparkle=Sparkle(mode="glints"),
                    exposure_ev=-2.4,
                    exposure_mode="locked",
                )
                text = title.format(azimuth - 40.0, 100.0 * (distance - 0.1))
                row.append(captioned(Image.fromarray(np.asarray(scene.image(view, size))), text))
            rows.append(row)
    fitter.close()
    sheet(rows).save(folder / "comparison_sparkle.png", optimize=True)


def paints(folder: Path) -> None:
    """Figure 10: the eight paints of Table 1, ray-traced, on a car."""
    session = RaytracedSession()
    view = View(
        Camera(38.0, 9.0),
        environment="sunny",
        surface="car",
        surface_look=SurfaceLook(ground=True),
        background="grey",
    )
    pictures = []
    for name, paint in TABLE_1.items():
        session.show(name, view, (320, 212), Quality(256, 64, 64))
        # The frame leaves room for any turn of the car; here it stands still.
        picture = Image.fromarray(session.frame().codes()).crop((22, 32, 304, 186))
        pictures.append(captioned(picture, paint.name))
        print(f"{paint.name}: drawn", flush=True)
    sheet([pictures[:4], pictures[4:]]).save(folder / "comparison_paints.png", optimize=True)


def samples(reflectance: Reflectance) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Directions (n, 3) to light and view in and beside the plane of incidence, and values (n, 3)."""
    lights, views = [], []
    for theta in (10.0, 25.0, 40.0, 55.0, 65.0, 75.0):
        gamma = np.concatenate(([0.3, 1.0, 2.0, 4.0, 6.0, 9.0, 13.0], np.arange(18.0, 120.0, 8.0)))
        gamma = gamma[np.abs(theta - gamma) < 80.0]
        view = aspecular_view(theta, gamma)
        light = np.broadcast_to(illumination(theta), view.shape)
        lights.append(light)
        views.append(view)
        # The same views turned about the normal by a part of their distance from the mirror direction.
        turn = np.radians(0.7 * gamma)
        x = np.cos(turn) * view[:, 0] - np.sin(turn) * view[:, 1]
        y = np.sin(turn) * view[:, 0] + np.cos(turn) * view[:, 1]
        lights.append(light)
        views.append(np.stack((x, y, view[:, 2]), axis=-1))
    wi, wo = np.concatenate(lights), np.concatenate(views)
    values = reflectance.eval(wi, wo)
    known = values.min(axis=-1) > 1e-6
    return wi[known], wo[known], values[known]


def fitted(
    reflectance: Reflectance,
    make: Callable[[np.ndarray], Reflectance],
    start: list[float],
    low: list[float],
    high: list[float],
) -> Reflectance:
    """Return ``make(x)`` for the x of the least |log(model/measured)|, as equation 2 of the paper, a little rounded."""
    wi, wo, values = samples(reflectance)

    def errors(x: np.ndarray) -> np.ndarray:
        return np.asarray(np.log((make(x).eval(wi, wo) + 1e-4) / (values + 1e-4))).ravel()

    found = least_squares(
        errors,
        start,
        bounds=(low, high),
        x_scale=np.maximum(np.abs(start), 1e-3),
        loss="soft_l1",
        f_scale=0.1,
        max_nfev=200,
    )
    left = float(np.abs(errors(found.x)).mean())
    print(f"  mean |log| {left:.3f}: {np.round(found.x, 4).tolist()}", flush=True)
    return make(found.x)


def phong(x: np.ndarray) -> Phong:
    """From kd, ks (3 each) and n."""
    return Phong(tuple(x[:3]), tuple(x[3:6]), float(x[6]), form="modified")


def coated_phong(x: np.ndarray) -> CoatedPhong:
    """From kd, ks, n, the coat's index and its exponent."""
    return CoatedPhong(tuple(x[:3]), tuple(x[3:6]), float(x[6]), float(x[7]), float(x[8]))


def cook_torrance(x: np.ndarray) -> CookTorrance:
    """From kd and lobes of ks, m, r."""
    lobes = tuple(
        CookTorranceLobe(tuple(row[:3].tolist()), float(row[3]), float(row[4]))
        for row in x[3:].reshape(-1, 5)
    )
    return CookTorrance(CookTorrancePaint("fitted", tuple(x[:3].tolist()), lobes))


def models(folder: Path, measured: Path) -> None:
    """Figure 7: Phong, a Phong with clearcoat, the table, and Cook-Torrance, path-traced in one light."""
    from brdf_suite.reference.passes import trace

    table = load_material(measured).reflectance
    flat, flat_start, third = [0.0] * 3, [0.02, 0.02, 0.01], [0.05] * 3
    one = [1.0] * 3
    found: dict[str, Reflectance] = {
        "Phong": fitted(table, phong, [*third, 0.3, 0.2, 0.05, 60.0], [*flat, *flat, 1.0], [*one, *one, 5e3]),
        "Phong with clearcoat": fitted(
            table,
            coated_phong,
            [*third, 0.3, 0.2, 0.05, 60.0, 1.4, 300.0],
            [*flat, *flat, 1.0, 1.01, 10.0],
            [*one, *one, 5e3, 2.5, 5e4],
        ),
        "measured table": table,
        "fitted Cook-Torrance": fitted(
            table,
            cook_torrance,
            [*flat_start, 0.08, 0.06, 0.01, 0.09, 0.5, 0.02, 0.02, 0.01, 0.3, 0.3, *third, 0.07, 0.03],
            [*flat, *(*flat, 0.01, 0.001) * 3],
            [*one, *(*one, 0.99, 0.99) * 3],
        ),
    }
    size, tiles = (340, 226), []
    view = View(
        Camera(42.0, 10.0), environment="booth", surface="car", exposure_mode="locked", background="grey"
    )
    surroundings = read_environment(find_environment(view.environment)[1])
    mesh = load_shaped(view.surface, view.surface_look)
    light, scenes = {}, {}
    for name, reflectance in found.items():
        scene = build_reference(Material(name, reflectance), view, size, surroundings, mesh)
        scenes[name] = (scene, trace(scene.traced, samples=512, samples_per_pass=128))
        light[name] = scenes[name][1].radiance
        print(f"{name}: traced, {', '.join(scene.notices) or 'as it is'}", flush=True)
    scene, estimate = scenes["measured table"]
    ev = ev_of(np.concatenate((estimate.radiance, estimate.coverage[..., None]), axis=-1)) or 0.0
    inside = estimate.coverage >= 0.999
    shown = {key: srgb_encode(display_light(value, ev, view.tone_curve)) for key, value in light.items()}
    for name, (scene, estimate) in scenes.items():
        errors = errors_of(shown[name], shown["measured table"], inside)
        caption = (
            name if name == "measured table" else f"{name}: dE00 {errors.mean:.1f}, FLIP {errors.flip:.2f}"
        )
        print(f"| {name} | {errors.mean:.2f} | {errors.p99:.1f} | {errors.flip:.3f} |", flush=True)
        exposed = replace(scene, view=replace(scene.view, exposure_ev=ev))
        tiles.append(captioned(Image.fromarray(exposed.codes(estimate)).crop((22, 34, 326, 200)), caption))
    sheet([tiles[:2], tiles[2:]]).save(folder / "comparison_models.png", optimize=True)


def main() -> None:
    """Draw what is asked for."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("folder", nargs="?", type=Path, default=FOLDER)
    parser.add_argument("--measured", type=Path, default=None, metavar="FILE")
    parser.add_argument("--only", choices=("sparkle", "paints", "models"), default=None)
    options = parser.parse_args()
    if options.only in (None, "sparkle"):
        sparkle(options.folder)
    if options.only in (None, "paints"):
        paints(options.folder)
    if options.measured is not None and options.only in (None, "models"):
        models(options.folder, options.measured)


if __name__ == "__main__":
    main()
