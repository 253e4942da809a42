"""The forms of the look-up against direct integration: the base of designed paints, on a sphere, in real environments.

    python tests/benchmarks/comparisons/compare_look_ups.py [ENVIRONMENT ...]

Environments: the shipped ones and those given (files), at full size. The truth is the sum of the aspecular model over
all texels, in float64, with the rule of the flakes below 15°; forms are what the shader draws, pixel by pixel, of the
base alone (KD and KDD): where a form is not one of the Viewer's, the shader has another table. ΔE00 after the tone
curve "faithful", exposed for a median luminance of 0.18. Paints read under two lights are left out: their truth does
not depend on γ alone.
"""

from __future__ import annotations

import sys
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

import numpy as np

from brdf_suite.appearance.colour.colorimetry import LUMINANCE, display_to_lab, srgb_encode
from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.cli.tools.bench import load_module
from brdf_suite.documents.view import Camera, View
from brdf_suite.fitting.lobes.angles import AngleFitter
from brdf_suite.geometry.fresnel import fresnel_dielectric
from brdf_suite.lighting.latlong import column_angles, direction, fejer_weights, ring_angles
from brdf_suite.pipeline.lobe_fit import PaintFitter
from brdf_suite.pipeline.material import load_shipped_paint, paint_names
from brdf_suite.pipeline.paint_angles import at_ramp, material_weights
from brdf_suite.pipeline.picture import OffscreenScene
from brdf_suite.pipeline.scene import environment_names, load_environment
from brdf_suite.realtime.environment.look_up_table import RAMP_COSINES, LookUp, constant_light, look_up_table
from brdf_suite.realtime.material import ramp as material_ramp
from brdf_suite.realtime.pictures.tone_curves import display_light
from brdf_suite.realtime.values import MeshPart
from brdf_suite.reflectance.designed.aspecular_base import AspecularBase

_ball = load_module(Path(__file__).resolve().parents[1] / "parts" / "ball.py")

BINS = 4096
SIZE = (384, 384)
VIEW = View(
    Camera(azimuth_deg=35, elevation_deg=7, distance=10.0, target=(0.0, 0.0, 0.0), focal_length_mm=1200),
    background="grey",
)
RADIUS = 0.13
T_FIT = 1.0 - float(fresnel_dielectric(np.cos(np.pi / 4), 1.5))


class Points(NamedTuple):
    """Pixels of the sphere (n, 2), and there the normal and mirror direction (n, 3) and N·V (n,)."""

    pixels: np.ndarray
    normal: np.ndarray
    mirror: np.ndarray
    cosine: np.ndarray


def sphere(rings: int = 158) -> MeshPart:
    return _ball.ball(RADIUS, rings)


def points_of(scene: OffscreenScene, count: int, view: View = VIEW) -> Points:
    """Spread ``count`` pixels evenly over the sphere's disc in the picture."""
    camera = scene.renderer.camera_matrices(view, SIZE)
    k = np.arange(count) + 0.5
    radius, turn = np.sqrt(k / count) * 0.993, k * np.pi * (1 + 5**0.5)
    half = RADIUS / np.sqrt(camera.eye @ camera.eye - RADIUS**2)
    x, y = radius * np.cos(turn) * half, radius * np.sin(turn) * half
    column = np.rint((x / camera.half_tangents[0] + 1) / 2 * SIZE[0] - 0.5).astype(int)
    row = np.rint((1 - y / camera.half_tangents[1]) / 2 * SIZE[1] - 0.5).astype(int)
    gx = ((column + 0.5) / SIZE[0] * 2 - 1) * camera.half_tangents[0]
    gy = (1 - (row + 0.5) / SIZE[1] * 2) * camera.half_tangents[1]
    rays = np.stack([gx, gy, -np.ones_like(gx)], -1) @ camera.view_to_world.T
    rays /= np.linalg.norm(rays, axis=-1, keepdims=True)
    along = rays @ camera.eye
    t = -along - np.sqrt(along**2 - (camera.eye @ camera.eye - RADIUS**2))
    normal = (camera.eye + t[:, None] * rays) / RADIUS
    cosine = -(normal * rays).sum(-1)
    return Points(np.stack([row, column], 1), normal, rays + 2 * cosine[:, None] * normal, cosine)


def histograms(radiance: np.ndarray, points: Points) -> np.ndarray:
    """Return (n, 2, BINS, 3): light times N·L by γ, without and with the coat's T(N·L)."""
    rings, columns = radiance.shape[:2]
    towards = direction(ring_angles(rings)[:, None], column_angles(columns)[None]).reshape(-1, 3)
    weights = (fejer_weights(rings)[:, None] * np.full(columns, 2 * np.pi / columns)).ravel()
    light = radiance.reshape(-1, 3).astype(np.float64) * weights[:, None]
    grid = np.linspace(0.0, 1.0, 4001)
    crossing = 1.0 - fresnel_dielectric(grid, 1.5)
    found = np.zeros((len(points.normal), 2, BINS, 3))
    for i, (n, r) in enumerate(zip(points.normal, points.mirror, strict=True)):
        cosine = towards @ n
        above = cosine > 0
        cosine = cosine[above]
        place = np.arccos(np.clip(towards[above] @ r, -1, 1)) * ((BINS - 1) / np.pi)
        low = np.minimum(place.astype(int), BINS - 2)
        share = place - low
        arriving = light[above] * cosine[:, None]
        for coat, gain in enumerate((1.0, np.interp(cosine, grid, crossing))):
            for c in range(3):
                value = arriving[:, c] * gain
                found[i, coat, :, c] = np.bincount(low, value * (1 - share), BINS) + np.bincount(
                    low + 1, value * share, BINS
                )
    return found


@contextmanager
def table_of(find):
    """Draw with other look-ups than the table's: ``find(target, exponent) -> LookUp``."""
    kept = material_ramp.look_up_table
    known = look_up_table()

    class Other:
        diffuse_amplitude = known.diffuse_amplitude

        @staticmethod
        def find(_target, exponent):
            return find(exponent)

    material_ramp.look_up_table = lambda: Other
    try:
        yield
    finally:
        material_ramp.look_up_table = kept


def at_mirror(exponent):
    amplitude = 2 * np.pi / (exponent + 1) * constant_light(exponent, RAMP_COSINES)[0]
    return LookUp(np.zeros(3), np.full(len(RAMP_COSINES), exponent), amplitude)


def next_exponent(exponent):
    found = look_up_table().find("plain", exponent)
    return LookUp(
        np.array([1 / exponent, 0.0, 0.0]), np.full(len(RAMP_COSINES), exponent + 1), found.amplitude
    )


def lab(radiance, ev):
    return display_to_lab(srgb_encode(display_light(radiance, ev, "faithful")))


def compare(environments, names=None, count=300):
    """Return ``{form: (paints, 2)}``, mean and 99th percentile of ΔE00 by paint, and the paints' names."""
    single = PaintFitter(time_limit_s=1.0)
    several = AngleFitter(time_limit_s=1.0)
    paints = {}
    for name in names or paint_names():
        fit = single.fit(load_shipped_paint(name))
        if isinstance(fit.reflectance.base, AspecularBase):
            paints[name] = (fit.reflectance, fit.weights, several.fit(fit.reflectance).weights)
    gamma = np.linspace(0, np.pi, BINS)
    errors = {}
    with OffscreenScene() as scene:
        scene.renderer.set_mesh([sphere()])
        first = True
        for environment in environments:
            prepared = load_environment(environment)
            scene.set_environment(prepared)
            if first:
                points, first = points_of(scene, count), False
            light = histograms(prepared.environment.radiance, points)
            for name, (reflectance, weights, over_angle) in paints.items():
                truth = direct(reflectance.base, light, points, gamma)
                ev = np.log2(0.18 / np.median(truth @ LUMINANCE))
                wanted = lab(truth, ev)
                for form, drawn in forms(scene, weights, over_angle, light, points, gamma):
                    errors.setdefault(form, {}).setdefault(name, []).append(
                        delta_e_2000(wanted, lab(drawn, ev))
                    )
    single.close()
    several.close()
    return {
        form: np.array([(np.mean(d), np.percentile(d, 99)) for d in by_paint.values()])
        for form, by_paint in errors.items()
    }, list(paints)


def direct(base, light, points, gamma):
    """Return the model's radiance (n, 3)."""
    held = np.minimum(gamma, base.farthest)
    out = 1.0 - fresnel_dielectric(np.cos(base.illumination - held), base.ior)
    at_fit = 1.0 - float(fresnel_dielectric(np.cos(base.illumination), base.ior))
    factor = base.reflectance_factor(gamma) / (np.pi * at_fit * out)[:, None]
    crossed = np.einsum("nbc,bc->nc", light[:, 1], factor)
    return crossed * (1.0 - fresnel_dielectric(points.cosine, base.ior))[:, None]


def forms(scene, weights, over_angle, light, points, gamma):
    """Yield each form's name and radiance (n, 3)."""
    bare = replace(material_weights(weights), kg=np.zeros_like(weights.kg))
    plain = replace(bare, coat="none")
    passed = ((1.0 - fresnel_dielectric(points.cosine, weights.ior)) / T_FIT)[:, None]
    table = at_ramp(over_angle)
    several = replace(bare, over_angle=replace(table, kg=np.zeros_like(table.kg)))

    def drawn(material, **modes):
        scene.renderer.set_material("paint", material)
        picture = scene.renderer.linear_image(replace(VIEW, **modes), SIZE, 1)
        return picture[points.pixels[:, 0], points.pixels[:, 1], :3].astype(np.float64)

    yield "paper: map E at R, times N·R", drawn(bare, look_up="paper", fresnel="raised")
    with table_of(at_mirror):
        yield "map E at R, times C(E, N·R)", drawn(replace(plain)) * passed**2
    with table_of(next_exponent):
        yield "map E+1 at E·R + N, exact for constant light", drawn(replace(plain)) * passed**2
    yield "least-squares table, light as if it crossed no coat", drawn(replace(plain)) * passed**2
    yield "**least-squares table (default)**", drawn(bare, fresnel="raised")
    yield "the same, weights at 16 incidences", drawn(several, fresnel="multi_angle")
    lobes = np.cos(np.minimum(gamma, np.pi / 2))[:, None] ** weights.exponents
    lobes[gamma >= np.pi / 2] = 0.0
    factor = weights.kd + np.einsum("bm,mc->bc", lobes, weights.kdd)
    yield "the lobes integrated exactly", np.einsum("nbc,bc->nc", light[:, 0], factor) * passed**2
    crossed = np.einsum("nbc,bc->nc", light[:, 1], factor) / T_FIT
    yield "the same, each light crossing the coat (what the fit alone costs)", crossed * passed


def show(title, errors, names):
    print(f"\n{title}\n")
    print("| look-up | mean | worst paint's mean | 99th percentile, mean over paints |\n|---|---|---|---|")
    for form, values in errors.items():
        worst = names[int(values[:, 0].argmax())]
        print(
            f"| {form} | {values[:, 0].mean():.2f} | {values[:, 0].max():.1f} ({worst}) | {values[:, 1].mean():.1f} |"
        )


def main(arguments):
    environments = [*environment_names(), *(Path(a) for a in arguments)]
    errors, names = compare(environments)
    show(f"{len(names)} paints, {len(environments)} environments, 300 normals", errors, names)


if __name__ == "__main__":
    main(sys.argv[1:])
