"""The part of bench viewer about flakes: what they cost a frame, whether they keep the mean, and hold still.

Frames are those of the fixed scene, whose ball has millimetres as texture coordinates, in eight small lights over the
half of the sphere that the eye is in. Means and correlations are taken of the shader itself.
"""

from __future__ import annotations

import tempfile
from dataclasses import replace
from pathlib import Path
from statistics import median
from time import perf_counter

import moderngl
import numpy as np

from brdf_suite.appearance.flakes.visible import FLAKE_WAVINESS
from brdf_suite.documents.view_settings import Sparkle
from brdf_suite.pipeline.material import default_paint
from brdf_suite.progress import report
from brdf_suite.realtime.gl.context import create_context
from brdf_suite.realtime.gl.shader_source import SHADERS, compile_program, compose
from brdf_suite.realtime.lights.block import DistantLights
from brdf_suite.realtime.pictures.renderer import Renderer
from brdf_suite.realtime.values import MeshPart

BOUNDS = {
    "flake_ratio": (
        "<=",
        4.5,
        "",
        "frame with the flake texture in 8 lights over the baseline frame, median",
    ),
    "texture_eight_lamps_ratio": (
        "<=",
        10.0,
        "",
        "the same with glints in 8 lights and grain in all other light",
    ),
    "texture_one_light_ratio": ("<=", 4.5, "", "the same with one light"),
    "sparkle_bias": (
        "<=",
        0.02,
        "",
        "mean of the glints over the smooth light, minus 1: largest, 4 to 10,000 flakes per footprint",
    ),
    "sparkle_bias_sparse": ("<=", 0.05, "", "the same, 0.25 to 4"),
    "sparkle_contrast_spread": (
        "",
        None,
        "",
        "largest over smallest of contrast times root of count, 0.25 to 10,000",
    ),
    "sparkle_correlation": (">=", 0.95, "", "correlation of the glints in two frames 0.1 pixels apart"),
    "sparkle_turn_correlation": ("", None, "", "the same, the light rotated by 0.1 degrees"),
}

ROUNDS = 30
DENSE = (4.0, 10.0, 32.0, 100.0, 320.0, 1000.0, 10_000.0)
SPARSE = (0.25, 0.5, 1.0, 2.0, 4.0)
SAMPLES = 2048  # squared


def figures(scene, progress=None):
    """Return the figures of :data:`BOUNDS`; ``scene`` is the module bench_viewer."""
    context = create_context()
    try:
        found = _frames(context, scene, progress)
        found |= _means(context, progress)
        found |= _correlations(context, scene)
    finally:
        context.release()
    return found


def eight_lights():
    """Small lights, evenly over the half of the sphere about +z."""
    k = np.arange(8)
    z = 1.0 - (2 * k + 1) / 16
    turn = k * np.pi * (3 - np.sqrt(5))
    level = np.sqrt(1 - z * z)
    directions = np.stack([level * np.cos(turn), level * np.sin(turn), z], -1)
    return DistantLights(directions, np.full((8, 3), 2.0), np.full(8, 0.005))


def flaked(context, scene, lights):
    """Return a renderer with the fixed scene and the default paint's flakes."""
    renderer = Renderer(context)
    renderer.set_environment(scene._maps(), lambda: lights)
    renderer.set_mesh([_with_millimetres(scene._sphere(), scene.RADIUS)])
    renderer.set_material("paint", scene._weights(default_paint()))
    renderer.set_flakes("paint", default_paint().flakes)
    return renderer


def _frames(context, scene, progress):
    renderer, baseline = flaked(context, scene, eight_lights()), Renderer(context, scene.BASELINE)
    baseline.set_environment(scene._maps())
    baseline.set_mesh([scene._sphere()])
    target = context.simple_framebuffer(scene.SIZE)
    plain = fixed_view(scene)
    views = {
        "flake_ratio": replace(plain, sparkle=Sparkle("texture", 8)),
        "texture_eight_lamps_ratio": replace(plain, sparkle=Sparkle("glints", 8)),
        "texture_one_light_ratio": replace(plain, sparkle=Sparkle("glints", 1)),
    }

    def frame(which, view):
        start = perf_counter()
        which.render(view, target, scene.SIZE, samples=1)
        context.finish()
        return perf_counter() - start

    ratios = {key: [] for key in views}
    for i in range(ROUNDS + 2):
        report(progress, 0.5 * i / (ROUNDS + 2), "drawing flakes in turn with the baseline")
        base = frame(baseline, plain)
        for key, view in views.items():
            ratio = frame(renderer, view) / base
            if i >= 2:
                ratios[key].append(ratio)
    for item in (renderer, baseline):
        item.release()
    return {key: median(values) for key, values in ratios.items()}


def fixed_view(scene):
    """Return the view of the fixed scene."""
    return scene.View(
        scene.Camera(azimuth_deg=0, elevation_deg=0, distance=scene._distance(), target=(0.0, 0.0, 0.0)),
        sparkle=Sparkle("off"),
    )


_PROBE = """#include "sparkle_glints.glsl"
uniform float edge;       // mm of a square footprint
uniform int seed;
uniform vec4 grain;       // density, size, roughness, waviness
out vec4 fragment;
void main()
{
    uint word = scrambled(uint(gl_FragCoord.x) + scrambled(uint(gl_FragCoord.y) + scrambled(uint(seed))));
    vec2 a = halves(word), b = halves(scrambled(word + 1u)), c = halves(scrambled(word + 2u));
    vec2 at = 4000.0 * a - 2000.0;
    float longer = sqrt(1.0 + 2.0 * b.x), turn = 6.2831853 * b.y;
    vec2 across = edge * longer * vec2(cos(turn), sin(turn)), down = edge / longer * vec2(-sin(turn), cos(turn));
    // Tilts as the lobe has them, out to 1.8 times the roughness.
    float tilt = 1.8 * grain.z * sqrt(c.x), way = 6.2831853 * c.y;
    GlintField field = glint_field(at, across, down, grain.x, grain.y, grain.z, grain.w, 0.0);
    vec2 slope = tilt * vec2(cos(way), sin(way));
    fragment = vec4(glint_ratio(field, tilt_place(slope, grain.z), grain.w), 1.0);
}
"""


def _means(context, progress):
    """Mean and contrast of the ratio for footprints of some numbers of flakes."""
    flakes = default_paint().flakes
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "probe.frag.glsl").write_text(_PROBE)
        program = compile_program(
            context, compose("screen.vert.glsl"), compose("probe.frag.glsl", None, (Path(folder), SHADERS))
        )
    framebuffer = context.framebuffer([context.texture((SAMPLES, SAMPLES), 1, dtype="f4")])
    framebuffer.use()
    context.enable_only(moderngl.NOTHING)
    array = context.vertex_array(program, [])
    program["grain"] = (flakes.density_per_mm2, flakes.size_um * 1e-3, flakes.roughness, FLAKE_WAVINESS)
    mean, contrast = {}, {}
    for i, count in enumerate(sorted({*DENSE, *SPARSE})):
        report(progress, 0.5 + 0.4 * i / 11, f"{count:g} flakes a footprint")
        program["edge"] = float(np.sqrt(count / flakes.density_per_mm2))
        sums = np.zeros(3)
        for seed in range(4 if count < 4 else 1):  # the fewer flakes, the more chance
            program["seed"] = seed
            array.render(moderngl.TRIANGLES, vertices=3)
            ratio = np.frombuffer(framebuffer.read(components=1, dtype="f4"), np.float32).astype(np.float64)
            sums += (ratio.size, ratio.sum(), (ratio * ratio).sum())
        mean[count] = float(sums[1] / sums[0])
        contrast[count] = float(np.sqrt((sums[2] / sums[0] - mean[count] ** 2) * count))
    return {
        "sparkle_bias": max(abs(mean[count] - 1) for count in DENSE),
        "sparkle_bias_sparse": max(abs(mean[count] - 1) for count in SPARSE),
        "sparkle_contrast_spread": max(contrast.values()) / min(contrast.values()),
    }


def _correlations(context, scene):
    """Two frames of the ball, seen from as far as its flakes sparkle, moved and with the light turned a little."""
    size = (640, 480)
    lights = DistantLights(np.array([[0.3, 0.5, 0.81]]), np.full((1, 3), 6.0), np.array([0.0047]))
    renderer = flaked(context, scene, lights)
    near = replace(fixed_view(scene), sparkle=Sparkle("glints", 1))
    pixel = 36.0 / 50.0 * (near.camera.distance - scene.RADIUS) / size[0]

    def glints(view):
        smooth = renderer.linear_image(replace(view, sparkle=Sparkle("off")), size, samples=1)
        return (renderer.linear_image(view, size, samples=1) - smooth)[..., 1]

    first = glints(near)
    object_ = np.abs(first) > 0
    moved = glints(replace(near, camera=replace(near.camera, target=(0.1 * pixel, 0.0, 0.0))))
    turned = glints(replace(near, rotation_deg=0.1))
    renderer.release()
    return {
        "sparkle_correlation": float(np.corrcoef(first[object_], moved[object_])[0, 1]),
        "sparkle_turn_correlation": float(np.corrcoef(first[object_], turned[object_])[0, 1]),
    }


def _with_millimetres(part, radius):
    """The ball with lengths along its rings and meridians as texture coordinates, true at the equator."""
    n = np.asarray(part.normals, np.float64)
    rings = round(np.sqrt(len(n) / 2))  # a row has one vertex more than twice as many
    azimuth = np.tile(np.linspace(0, 2 * np.pi, len(n) // rings), rings)[: len(n)]
    uvs = 1e3 * radius * np.stack([azimuth, np.arccos(np.clip(n[:, 1], -1, 1))], -1)
    return MeshPart(part.name, part.material, part.positions, part.normals, part.triangles, uvs)
