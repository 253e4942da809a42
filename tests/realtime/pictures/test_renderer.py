"""Frames: sizes, tiles, samples, targets, leaks, and refusals."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from brdf_suite.documents.view import Camera, View
from brdf_suite.errors import GraphicsError, ValueRangeError
from brdf_suite.realtime.pictures.renderer import Renderer
from brdf_suite.realtime.values import CubeFaces, EnvironmentMaps, MeshPart

pytestmark = pytest.mark.usefixtures("prepared")

VIEW = View(Camera(30, 15))


def stripes(d):
    return (0.5 + 0.5 * np.sign(np.sin(d[..., 0:1] * 9)) * np.sign(np.sin(d[..., 1:2] * 11))) * np.ones(3)


def scene(renderer, scenes):
    renderer.set_environment(scenes.from_function(stripes))
    renderer.set_mesh([scenes.sphere(), scenes.sphere("chrome", 0.05, (0.13, 0.05, 0.02))])
    renderer.set_material("paint", scenes.weights(kd=0.2, gloss=0.06, directional=0.1))


def test_tiles_are_the_whole(renderer, scenes):
    scene(renderer, scenes)
    size = (250, 171)
    whole = renderer.render_image(VIEW, size)
    assert whole.shape == (171, 250, 3)
    assert whole.dtype == np.uint8
    assert whole.std() > 20
    # Another projection rounds otherwise: a value on the edge between two codes may fall on the other side, and a
    # sample on the edge of a triangle.
    for tile in (64, 100, 128):
        difference = np.abs(renderer.render_image(VIEW, size, largest_tile=tile).astype(int) - whole)
        assert (difference > 1).mean() < 1e-4
        assert (difference > 0).mean() < 1e-3


def test_any_size(renderer, scenes):
    scene(renderer, scenes)
    for size in ((1, 1), (3, 700), (4101, 2)):
        assert renderer.render_image(VIEW, size).shape == (size[1], size[0], 3)
    for size in ((0, 10), (10, -1), (70000, 10)):
        with pytest.raises(ValueRangeError, match="65,536"):
            renderer.render_image(VIEW, size)


def test_samples_smooth_the_rim(renderer, scenes):
    renderer.set_environment(scenes.constant(0.0))
    renderer.set_mesh([scenes.sphere()])
    renderer.set_material("paint", scenes.weights(kd=0.5))
    view = replace(VIEW, background="grey")
    levels = [len(np.unique(renderer.render_image(view, (80, 80), samples)[..., 1])) for samples in (1, 4)]
    assert levels[1] >= levels[0] + 2


def test_odd_numbers_of_samples_are_taken_as_the_power_of_two_below(renderer, scenes):
    scene(renderer, scenes)
    pictures = [renderer.render_image(VIEW, (40, 30), samples) for samples in (2, 3)]
    assert np.array_equal(*pictures)


def test_samples_are_averaged_in_linear_light(renderer, scenes):
    """Half covered, black over white: a pixel of the edge is 50 % light, code 188, not code 128."""
    renderer.set_environment(scenes.constant(1.0))
    renderer.set_mesh([scenes.sheet(half=1.0, centre=(1.0, 0, 0))])
    renderer.set_material("paint", scenes.weights(kd=0.0, ior=1.0))
    camera = Camera(0, 0, distance=1.0, target=(0.0, 0.0, 0.0))
    row = renderer.render_image(View(camera, tone_curve="linear"), (33, 9))[4, :, 0]
    assert row[0] == 255
    assert row[-1] == 0
    assert 186 <= row[16] <= 190


def test_renders_into_a_given_framebuffer(renderer, scenes, context):
    """By object and by number, as a widget's; only the asked size is written; the same picture as off screen."""
    scene(renderer, scenes)
    expected = renderer.render_image(VIEW, (60, 40))
    target = context.simple_framebuffer((80, 50))
    try:
        for handle in (target, target.glo):
            target.clear(1.0, 0.0, 1.0)
            renderer.render(VIEW, handle, (60, 40))
            got = np.frombuffer(target.read(components=3, alignment=1), np.uint8).reshape(50, 80, 3)
            assert np.array_equal(got[:40, :60][::-1], expected)
            assert (got[:, 60:] == (255, 0, 255)).all()
            assert (got[40:] == (255, 0, 255)).all()
    finally:
        context.detect_framebuffer(0).use()
        target.release()


def test_state_left_by_others_does_not_matter(renderer, scenes, context):
    """A toolkit may leave blending, culling, scissor and an error behind."""
    import moderngl

    scene(renderer, scenes)
    expected = renderer.render_image(VIEW, (40, 40))
    target = context.simple_framebuffer((40, 40))
    target.use()
    context.enable(moderngl.BLEND | moderngl.CULL_FACE)
    context.front_face, context.cull_face = "cw", "front"
    context.scissor = (3, 3, 5, 5)
    context.depth_func = ">"
    context.enable_direct(0x1234)  # GL_INVALID_ENUM
    got = renderer.render_image(VIEW, (40, 40))
    context.scissor = None
    context.detect_framebuffer(0).use()
    target.release()
    assert np.array_equal(got, expected)


def test_exposure_rotation_and_background_upload_nothing(renderer, scenes):
    scene(renderer, scenes)
    first = renderer.render_image(VIEW, (60, 60))
    counters = renderer.counters
    before = (counters.total_created, counters.texture_uploads, counters.buffer_writes)
    changes = (
        {"exposure_ev": 1.0},
        {"rotation_deg": 40.0},
        {"background": "grey"},
        {"tone_curve": "characteristic"},
    )
    for change in changes:
        assert not np.array_equal(renderer.render_image(replace(VIEW, **change), (60, 60)), first)
    assert (counters.total_created, counters.texture_uploads, counters.buffer_writes) == before


def test_a_mode_is_compiled_once(renderer, scenes):
    scene(renderer, scenes)
    counters = renderer.counters
    first = renderer.render_image(VIEW, (60, 60))
    off = renderer.render_image(replace(VIEW, fresnel="off"), (60, 60))
    before = (counters.total_created, counters.texture_uploads)
    assert np.array_equal(renderer.render_image(VIEW, (60, 60)), first)
    assert np.array_equal(renderer.render_image(replace(VIEW, fresnel="off"), (60, 60)), off)
    assert not np.array_equal(first, off)
    assert (counters.total_created, counters.texture_uploads) == before


def test_a_map_that_serves_twice_is_uploaded_once(renderer, scenes):
    """The sharpest lobe looks up the background's map: one texture, and the picture of two."""
    rng = np.random.default_rng(8)
    apart = scenes.constant()
    sharp = scenes.cube(rng.random((6, 8, 8, 3)), 0.25)
    copy = CubeFaces(sharp.faces.copy(), sharp.scale)
    lobes = apart.lobes[:-1]
    two = EnvironmentMaps(apart.exponents, (*lobes, copy), apart.diffuse, apart.through_coat, sharp)
    one = EnvironmentMaps(apart.exponents, (*lobes, sharp), apart.diffuse, apart.through_coat, sharp)
    renderer.set_mesh([scenes.sphere()])
    renderer.set_material("paint", scenes.weights(kd=0.2, gloss=0.5, directional=0.2))
    pictures = []
    uploads = []
    for maps in (two, one):
        before = renderer.counters.texture_uploads
        renderer.set_environment(maps)
        uploads.append(renderer.counters.texture_uploads - before)
        pictures.append(renderer.render_image(VIEW, (60, 60)))
    assert np.array_equal(*pictures)
    assert uploads[0] - uploads[1] == 6
    renderer.set_environment(scenes.constant())
    assert not np.array_equal(renderer.render_image(VIEW, (60, 60)), pictures[0])


def test_grey_background_does_not_follow_the_exposure(renderer, scenes):
    renderer.set_environment(scenes.constant())
    corner = [
        renderer.render_image(View(background="grey", exposure_ev=ev), (9, 9))[0, 0] for ev in (-3, 0, 3)
    ]
    assert np.abs(np.diff(np.asarray(corner, int), axis=0)).max() <= 1


def test_a_coloured_background_is_its_colour_at_any_exposure(renderer, scenes):
    renderer.set_environment(scenes.constant())
    for ev in (-3, 3):
        view = View(
            background="colour", background_colour=(0.2, 0.6, 0.4), exposure_ev=ev, tone_curve="linear"
        )
        assert np.abs(renderer.render_image(view, (9, 9))[0, 0] - np.array((51, 153, 102))).max() <= 1


def test_a_blurred_background_is_seen_through_a_broad_lobe(renderer, scenes):
    """Each lobe's map is another constant: what is seen lies between those of the neighbours of exponent 60."""
    exponents, levels = (1.0, 50.0, 80.0, 500.0), (0.1, 0.3, 0.4, 0.8)
    lobes = tuple(scenes.cube(np.full((6, 4, 4, 3), level), 0.5) for level in levels)
    constant = scenes.constant(1.0, exponents=exponents)
    renderer.set_environment(replace(constant, lobes=lobes, diffuse=lobes[0]))
    seen = renderer.linear_image(View(background="blurred"), (9, 9))[0, 0, :3]
    assert seen == pytest.approx(np.full(3, 0.3 + 0.1 * (60 - 50) / (80 - 50)), abs=2e-3)


def test_one_lobe_and_the_most_lobes(renderer, scenes):
    for m in (1, 24):
        e = tuple(1.8 ** (i + 1) for i in range(m))
        renderer.set_environment(scenes.constant(0.5, exponents=e))
        renderer.set_mesh([scenes.sphere("chrome")])
        assert renderer.render_image(View(tone_curve="linear"), (32, 32))[16, 16].min() > 90


def resident_pages() -> int:
    return int(Path("/proc/self/statm").read_text().split()[1])


@pytest.mark.skipif(not Path("/proc/self/statm").exists(), reason="memory is read from /proc")
def test_no_leak_over_200_environments(renderer, scenes):
    """Of two kinds of sizes in turn: objects and memory stay flat."""
    small, large = scenes.constant(0.4, 32), scenes.from_function(stripes, 128)
    renderer.set_mesh([scenes.sphere()])
    renderer.set_material("paint", scenes.weights(kd=0.5))

    def change(times: int) -> None:
        for i in range(times):
            renderer.set_environment(small if i % 2 else large)
            renderer.render_image(VIEW, (24, 24))

    change(20)
    live, pages = renderer.counters.live, resident_pages()
    change(180)
    assert renderer.counters.live == live
    assert (resident_pages() - pages) * 4096 < 8e6  # one leaked set of maps each time would be 170 MB


def test_same_sizes_reuse_the_textures(renderer, scenes):
    renderer.set_environment(scenes.constant(0.4))
    made = renderer.counters.total_created
    renderer.set_environment(scenes.constant(0.9))
    assert renderer.counters.total_created == made


def test_mesh_changes_give_buffers_back(renderer, scenes):
    renderer.set_environment(scenes.constant())
    renderer.set_mesh([scenes.sphere(rings=8)])
    renderer.render_image(VIEW, (8, 8))
    live = renderer.counters.live
    for _ in range(20):
        renderer.set_mesh([scenes.sphere(rings=8)])
        renderer.render_image(VIEW, (8, 8))
    assert renderer.counters.live == live


def test_too_large_a_map_is_a_message(context):
    renderer = Renderer(context)
    limit = context.info["GL_MAX_CUBE_MAP_TEXTURE_SIZE"]
    with pytest.raises(GraphicsError, match="cube map"):
        renderer.objects.cube(limit * 2)
    renderer.release()
    context.clear_errors()


def test_values_are_checked(scenes):
    ok = scenes.sheet()
    with pytest.raises(ValueRangeError, match=r"'door': triangles.*0 to 3"):
        MeshPart("door", "paint", ok.positions, ok.normals, ok.triangles + 2)
    with pytest.raises(ValueRangeError, match="not every number is finite"):
        MeshPart("door", "paint", ok.positions * np.nan, ok.normals, ok.triangles)
    with pytest.raises(ValueRangeError, match="normals"):
        MeshPart("door", "paint", ok.positions, ok.normals[:2], ok.triangles)
    with pytest.raises(ValueRangeError, match="six square faces"):
        CubeFaces(np.zeros((6, 4, 3, 3)))
    with pytest.raises(ValueRangeError, match="finite"):
        CubeFaces(np.full((6, 2, 2, 3), np.inf))
    for bits in (0x7C00, 0x7E00, 0xFC00, 0xFFFF):  # infinity, not a number, and both below 0
        faces = np.ones((6, 2, 2, 3), np.float16)
        faces.view(np.uint16)[5, 1, 1, 2] = bits
        with pytest.raises(ValueRangeError, match="finite"):
            CubeFaces(faces)
    assert CubeFaces(np.full((6, 2, 2, 3), -2.0)).faces.min() == -2.0
    with pytest.raises(ValueRangeError, match="1 to 64 lobes"):
        scenes.constant(exponents=tuple(range(2, 70)))
    with pytest.raises(ValueRangeError, match="negative"):
        scenes.weights(kd=-0.1)
    with pytest.raises(ValueRangeError, match="ior"):
        scenes.weights(ior=0.9)


def test_a_region_is_drawn_and_nothing_beside_it(renderer, scenes, context):
    renderer.set_environment(scenes.constant(1.0))
    renderer.set_mesh([scenes.sphere()])
    renderer.set_material("paint", scenes.weights(kd=0.8))
    renderer.set_material("paint_b", scenes.weights(kd=0.2))
    size = (60, 40)
    first = renderer.render_image(View(), size)
    target = context.simple_framebuffer(size, 4)

    def drawn() -> np.ndarray:
        return np.frombuffer(target.read(components=3, alignment=1), np.uint8).reshape(40, 60, 3)[::-1]

    renderer.render(View(), target, size, materials={"paint": "paint_b"})
    second = drawn().copy()
    target.clear(0.0, 0.0, 0.0)
    renderer.render(View(), target, size, region=(0, 0, 25, 40))
    left = drawn()
    assert (left[:, :25] == first[:, :25]).all()
    assert (left[:, 25:] == 0).all()
    renderer.render(View(), target, size, materials={"paint": "paint_b"}, region=(25, 0, 35, 40))
    both = drawn()
    assert (both[:, :25] == first[:, :25]).all()
    assert (both[:, 25:] == second[:, 25:]).all()
    assert np.abs(first.astype(int) - second).max() > 60
    renderer.render(View(), target, size)
    assert (drawn() == first).all()
    target.release()


def turned_inside_out(part):
    return replace(part, triangles=part.triangles[:, ::-1])


@pytest.mark.parametrize("samples", [1, 4])
def test_the_winding_of_a_solid_does_not_matter(renderer, scenes, samples):
    scene(renderer, scenes)
    assert renderer.mesh.closed == (True, True)
    expected = renderer.render_image(VIEW, (120, 80), samples)
    renderer.set_mesh([turned_inside_out(scenes.sphere()), scenes.sphere("chrome", 0.05, (0.13, 0.05, 0.02))])
    assert renderer.mesh.closed == (False, True)
    difference = np.abs(renderer.render_image(VIEW, (120, 80), samples).astype(int) - expected)
    assert (difference > 1).mean() < 1e-3


def test_a_solid_is_seen_from_inside_too(renderer, scenes):
    renderer.set_environment(scenes.constant(1.0))
    renderer.set_material("paint", scenes.weights(kd=0.2))
    inside = View(Camera(30, 15, distance=0.02, target=(0.0, 0.0, 0.0)), background="grey")
    pictures = []
    for part in (scenes.sphere(), turned_inside_out(scenes.sphere())):
        renderer.set_mesh([part])
        pictures.append(renderer.render_image(inside, (60, 40)).astype(int))
    assert np.abs(pictures[0] - pictures[1]).max() <= 1
    renderer.set_mesh([])
    assert (renderer.render_image(inside, (60, 40)) != pictures[0]).any(axis=-1).all()
