"""Lobes looked up in OpenGL itself, about the edges and corners of the cube, against their own formula."""

from collections.abc import Iterator

import moderngl
import numpy as np
import pytest

from brdf_suite.geometry.cube_map import texel_directions
from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.filter.face_array import FaceArray, pack_faces
from brdf_suite.lighting.filter.lobe_filter import LobeFilter
from brdf_suite.lighting.filter.lobe_maps import face_size, prefilter
from brdf_suite.lighting.filter.texel_values import balance_edges, pack_lobe
from brdf_suite.realtime.gl.context import create_context, release_context

SEAMLESS = 0x884F
SIZE = 64
EXPONENT = (SIZE / 9.2) ** 2  # the sharpest lobe that gets faces of 64

VERTEX = """
#version 330
in vec3 direction;
out vec3 radiance;
uniform samplerCube map;
void main() { radiance = textureLod(map, direction, 0.0).rgb; }
"""


@pytest.fixture
def context() -> Iterator[moderngl.Context]:
    made = create_context()
    yield made
    release_context(made)


def looked_up(context: moderngl.Context, packed: FaceArray, wanted: np.ndarray) -> np.ndarray:
    """Return radiance (n, 3) along directions (n, 3), from the graphics card."""
    context.enable_direct(SEAMLESS)
    context.simple_framebuffer((4, 4)).use()  # nothing is drawn to it, but drawing asks for one
    texture = context.texture_cube((packed.size, packed.size), 3, dtype="f2")
    for face in range(6):
        texture.write(face, packed.faces[face])
    texture.filter = (moderngl.LINEAR, moderngl.LINEAR)
    texture.use(0)
    program = context.program(vertex_shader=VERTEX, varyings=["radiance"])
    target = context.buffer(reserve=12 * len(wanted))
    source = context.buffer(wanted.astype(np.float32).tobytes())
    context.vertex_array(program, [(source, "3f", "direction")]).transform(target, moderngl.POINTS)
    return np.frombuffer(target.read(), np.float32).reshape(-1, 3) * packed.scale


def lobe(wanted: np.ndarray, peak: np.ndarray) -> np.ndarray:
    towards = wanted / np.linalg.norm(wanted, axis=-1, keepdims=True)
    return np.maximum(towards @ (peak / np.linalg.norm(peak)), 0.0) ** EXPONENT


def about(peak: np.ndarray, rng: np.random.Generator, count: int = 8000) -> np.ndarray:
    """Directions about one, as far as its lobe reaches; a third of them on an edge where one is near."""
    wanted = peak / np.linalg.norm(peak) + rng.normal(scale=EXPONENT**-0.5, size=(count, 3))
    share = wanted[: count // 3]
    largest = np.abs(share).max(axis=1, keepdims=True)
    share[:] = np.where(np.abs(share) > 0.93 * largest, np.copysign(largest, share), share)
    return wanted.astype(np.float32).astype(np.float64)


def test_look_ups_in_opengl_err_by_less_than_a_hundredth_of_the_peak(context: moderngl.Context) -> None:
    rng = np.random.default_rng(6)
    peaks = [np.array([1.0, t, 1.0]) for t in (0.0, 0.5, 0.8, 0.9, 1.0)]
    corners = rng.choice([-1.0, 1.0], size=(20, 3))
    peaks += list(corners + rng.normal(scale=1.5 * EXPONENT**-0.5, size=corners.shape))
    peaks += list(rng.normal(size=(5, 3)))
    plain, balanced = [], []
    for peak in peaks:
        faces = np.repeat(lobe(texel_directions(SIZE), peak)[..., None], 3, axis=-1)
        wanted = about(peak, rng)
        truth = lobe(wanted, peak)[:, None]
        plain.append(np.abs(looked_up(context, pack_faces(faces), wanted) - truth).max())
        balanced.append(np.abs(looked_up(context, pack_lobe(faces.copy()), wanted) - truth).max())
    assert max(plain) > 0.013  # what the balance is there for
    assert max(balanced) <= 0.01


def test_constant_light_and_the_inside_of_faces_stay_as_they_are() -> None:
    white = np.full((6, 16, 16, 3), 0.7, dtype=np.float32)
    balance_edges(white)
    assert np.abs(white - 0.7).max() <= 1e-6
    faces = np.random.default_rng(2).random((6, 16, 16, 3))
    before = faces.copy()
    balance_edges(faces)
    assert np.array_equal(faces[:, 1:-1, 1:-1], before[:, 1:-1, 1:-1])
    assert (faces[:, 0] != before[:, 0]).all()


@pytest.mark.usefixtures("kernels_compiled")
def test_filtered_lobes_are_balanced_and_the_environment_itself_is_not(rough_map: np.ndarray) -> None:
    maps = prefilter(Environment("rough", rough_map), [300.0, 50000.0])
    lobe_filter = LobeFilter(rough_map)
    expected = pack_lobe(lobe_filter.lobe(300.0, face_size(300.0)))
    assert np.array_equal(maps.lobes[0].faces, expected.faces)
    unbalanced = pack_faces(lobe_filter.background(maps.background.size))
    assert np.array_equal(maps.background.faces, unbalanced.faces)
