"""Draw docs/images/factored_grain.png and factored_ball.png: what is drawn of factored paints beside measured ones.

    python packaging/pictures/factored_grain.py [--output docs/images]

Grain: brushed steel and brass (Poulin and Fournier's cylinders, factored into p(wo) q(h) p(wi)) on a sheet under three
lamps: one alone, the same with a tangent map of polished spots, that with a normal map of dents, and both metals
blended by a mask. Ball: a factored blue's reflectance ball in eight lamps, the speed form with each lamp looked up at
each place, and by the ball. How far the last two are apart is printed, for a lens of 50 and of 400 mm.
"""

from __future__ import annotations

import argparse
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np

from brdf_suite.arrays import Bytes
from brdf_suite.documents.view import Camera, View
from brdf_suite.documents.view_settings import (
    SECOND_PAINT,
    Lamp,
    LightColour,
    Relief,
    Sparkle,
    SurfaceLook,
    TwoTone,
)
from brdf_suite.files.images.png import write_png
from brdf_suite.fitting.homomorphic.product_fit import factorize
from brdf_suite.fitting.homomorphic.samples import sample_reflectance
from brdf_suite.pipeline.lobe_fit import fit_material
from brdf_suite.pipeline.material import Material
from brdf_suite.pipeline.picture import OffscreenScene
from brdf_suite.pipeline.scene import load_environment, load_surface
from brdf_suite.realtime.camera import compose
from brdf_suite.realtime.pictures.display import LINEAR
from brdf_suite.realtime.pictures.tone_curves import to_display
from brdf_suite.realtime.relief.values import MaskImage, SlopeMap, TangentMap
from brdf_suite.reflectance.factored.model import Factored
from brdf_suite.reflectance.models.poulin_fournier import PoulinFournier

IMAGES = Path(__file__).resolve().parents[2] / "docs" / "images"
SIZE = (320, 214)
GAP = 4
TILE_MM = 320.0
FAR = (
    (-60.0, 30.0, 0.35, 6500.0),
    (30.0, 50.0, 0.28, 4500.0),
    (120.0, 15.0, 0.3, 9000.0),
)
"""Azimuth, elevation in degrees, strength, colour in kelvin of lamps from far away."""


def metal(colour: tuple[float, float, float]) -> Factored:
    """Return brushed metal as a product of maps; the grain lies along x."""
    base = np.array(colour)
    model = PoulinFournier(kd=0.04 * base, ks=0.9 * base, exponent=60.0, spacing=2.0, floor=0.9)
    samples = sample_reflectance(model)
    found = factorize(samples.wi, samples.wo, samples.values, resolution=48).product
    maps = {name: np.exp(log).astype(np.float32) for name, log in found.logs.items()}
    return Factored(maps["p"], maps["q"], found.alpha, logarithmic=True)


def gloss() -> Factored:
    """Return a blue with a highlight, as maps over radii."""
    ring = (np.arange(64) + 0.5) / 64
    lobe = 0.06 * np.array([0.1, 0.3, 1.0]) + 1.2 * np.exp(-((ring / 0.1) ** 2))[:, None]
    return Factored(np.ones((2, 3), np.float32), lobe.astype(np.float32), 1.0, logarithmic=True)


def spots(size: int = 256, across: int = 4) -> tuple[TangentMap, SlopeMap, MaskImage]:
    """Return a tile of polished spots, whose grain runs round their middles, its dents, and stripes as a mask."""
    along = (np.arange(size) + 0.5) / size * across
    u, v = np.meshgrid(along % 1.0 - 0.5, along % 1.0 - 0.5)
    radius = np.maximum(np.hypot(u, v), 1e-3)
    round_about = np.stack((-v / radius, u / radius), axis=-1)
    inside = np.clip((0.5 - radius) / 0.02, 0.0, 1.0)[..., None]
    turns = inside * round_about + (1.0 - inside) * np.array([1.0, 0.0])
    depth = np.where(radius < 0.4, 0.5 * np.sin(np.pi * radius / 0.4), 0.0)[..., None]
    slopes = depth * np.stack((u, v), axis=-1) / radius[..., None]
    stripes = np.clip(8.0 * np.sin(2.0 * np.pi * np.add.outer(along, along) / across) + 0.5, 0.0, 1.0)
    return TangentMap(turns), SlopeMap(slopes), MaskImage(stripes)


def lamps() -> tuple[Lamp, ...]:
    """Return three lamps from far away."""
    return tuple(
        Lamp("directional", azimuth_deg=a, elevation_deg=e, strength=s, temperature_k=k) for a, e, s, k in FAR
    )


def grain() -> Bytes:
    """Return the four pictures of metals."""
    steel, brass = (
        fit_material(Material(n, metal(c)))
        for n, c in (("steel", (0.56, 0.57, 0.58)), ("brass", (0.85, 0.62, 0.25)))
    )
    turns, slopes, mask = spots()
    relief = Relief(normal_width_mm=TILE_MM, normal_strength=0.35)
    turned = replace(relief, tangent_map="/turns")
    dented = replace(turned, normal_map="/dents")
    two = TwoTone("/brass", "/mask", TILE_MM)
    view = dark("panel", Camera(10.0, 15.0), lamps())
    with OffscreenScene() as scene:
        scene.set_environment(load_environment("overcast"))
        scene.set_surface(load_surface("panel"))
        scene.set_material(steel)
        scene.set_material(brass, SECOND_PAINT)
        scene.renderer.relief.set_tangent_map(turns)
        scene.renderer.relief.set_normal_map(slopes)
        scene.renderer.relief.set_mask(mask)
        view = replace(view, camera=compose(view.camera, scene.renderer.bounds, SIZE))
        shown = [
            replace(view, relief=relief),
            replace(view, relief=turned),
            replace(view, relief=dented),
            replace(view, relief=turned, two_tone=two),
        ]
        return joined(
            [[scene.renderer.render_image(v, SIZE) for v in pair] for pair in (shown[:2], shown[2:])]
        )


def ball() -> tuple[Bytes, list[float]]:
    """Return ball, picture lamp by lamp and by the ball, and how the last differ with each lens (mean over mean)."""
    eight = tuple(
        Lamp(
            "directional",
            azimuth_deg=45.0 * i,
            elevation_deg=20.0 + 8.0 * i,
            strength=0.16,
            temperature_k=3500.0 + 900.0 * i,
        )
        for i in range(8)
    )
    view = dark("speed_form", Camera(35.0, 12.0), eight)
    with OffscreenScene() as scene:
        scene.set_environment(load_environment("overcast"))
        scene.set_surface(load_surface("speed_form"))
        scene.set_material(fit_material(Material("blue", gloss())))
        apart = []
        for lens in (400.0, 50.0):
            seen = replace(view, camera=replace(view.camera, focal_length_mm=lens))
            seen = replace(seen, camera=compose(seen.camera, scene.renderer.bounds, SIZE))
            each, one = (
                scene.renderer.render_image(v, SIZE, display=LINEAR)[..., :3].astype(float)
                for v in (seen, replace(seen, lamp_shading="ball"))
            )
            apart.append(float(np.abs(one - each).mean() / each.mean()))
        own = np.zeros((SIZE[1], SIZE[1], 3))
        step = scene.renderer.balls.picture("paint")
        at = np.minimum((np.arange(SIZE[1]) + 0.5) / SIZE[1] * len(step), len(step) - 1).astype(int)
        own[:] = step[at][:, at]
        y, x = np.mgrid[: SIZE[1], : SIZE[1]] * 2.0 / SIZE[1] - 1.0
        own[np.hypot(x, y) > 0.98] = 0.0
    pictures = [np.asarray(to_display(one_picture), np.uint8) for one_picture in (own, each, one)]
    return joined([pictures]), apart


def dark(surface: str, camera: Camera, lights: tuple[Lamp, ...]) -> View:
    """Return a surface in the light of lamps alone."""
    return View(
        camera=camera,
        surface=surface,
        surface_look=SurfaceLook(occlusion=False),
        light_colour=LightColour(brightness=0.0),
        lamps=lights,
        sparkle=Sparkle("off"),
        background="colour",
        background_colour=(0.0, 0.0, 0.0),
    )


def joined(rows: list[list[Bytes]]) -> Bytes:
    """Return pictures side by side and below each other, with grey gaps."""
    lines = [
        np.concatenate([np.pad(p, ((0, GAP), (0, GAP), (0, 0)), constant_values=128) for p in row], axis=1)
        for row in rows
    ]
    return np.ascontiguousarray(np.concatenate(lines)[:-GAP, :-GAP])


def main() -> int:
    """Write both pictures."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--output", type=Path, default=IMAGES)
    output = parser.parse_args().output
    balls, apart = ball()
    for name, picture in (("factored_grain", grain()), ("factored_ball", balls)):
        path = output / f"{name}.png"
        write_png(path, picture, {"Title": name})
        print(f"{path.name}: {path.stat().st_size / 1024:,.0f} KiB")
    for lens, share in zip((400, 50), apart, strict=True):
        print(f"{lens} mm: by the ball {100.0 * share:.1f} % of the mean away from each lamp at each place")
    return 0


if __name__ == "__main__":
    sys.exit(main())
