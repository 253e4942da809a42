"""Parts take their materials; an edit writes one buffer and makes nothing."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from brdf_suite.documents.view import Camera, View
from brdf_suite.errors import GraphicsError
from brdf_suite.geometry.fresnel import fresnel_dielectric, sheet_reflectance
from brdf_suite.realtime.environment.ladder import Ladder
from brdf_suite.realtime.gl.programs import LookUps
from brdf_suite.realtime.material.material_set import BLOCK_SIZE, pack
from brdf_suite.realtime.material.ramp import MAX_SHARP, make_ramp
from brdf_suite.realtime.material.stock_materials import lobe_mix, stock_materials
from brdf_suite.realtime.values import MaterialWeights

pytestmark = pytest.mark.usefixtures("prepared")

FACTORIES = (
    "buffer", "texture", "texture_cube", "texture_array", "framebuffer", "renderbuffer", "depth_renderbuffer",
    "program", "vertex_array", "sampler", "detect_framebuffer",
)  # fmt: skip


def reflected(weights):
    """Directional albedo of gloss and base for constant surroundings at θ_fit, as the shader sums it."""
    solid = 2 * np.pi / (np.asarray(weights.exponents) + 1)
    return (weights.kg * solid[:, None]).sum(0), np.pi * weights.kd + (weights.kdd * solid[:, None]).sum(0)


def test_parts_have_their_materials(renderer, scenes):
    parts = [scenes.sheet(m, 0.1, (0.2 * i, 0, 0)) for i, m in enumerate(("red", "paint", "blue"))]
    renderer.set_environment(scenes.constant())
    renderer.set_mesh(parts)
    for name, channel in (("red", 0), ("blue", 2), ("paint", 1)):
        weights = scenes.weights(kd=0.0, coat="none")
        kd = np.zeros(3)
        kd[channel] = 0.5 / np.pi
        renderer.set_material(
            name, type(weights)(weights.exponents, kd, weights.kdd, weights.kg, coat="none")
        )
    image = renderer.render_image(View(Camera(0, 0), tone_curve="linear"), (300, 120))
    strongest = [int(image[60, column].argmax()) for column in (60, 150, 240)]
    assert strongest == [0, 1, 2]


def test_unknown_material_is_the_neutral_grey(renderer, scenes):
    renderer.set_environment(scenes.constant())
    pictures = []
    for name in ("neutral", "a material of another program"):
        renderer.set_mesh([scenes.sphere(name)])
        pictures.append(renderer.render_image(View(), (64, 64)))
    assert np.array_equal(*pictures)


def test_weights_of_other_lobes_are_refused(renderer, scenes):
    renderer.set_environment(scenes.constant(exponents=(4.0, 100.0)))
    renderer.set_mesh([scenes.sphere()])
    renderer.set_material("paint", scenes.weights(kd=0.5, gloss=0.04))
    with pytest.raises(GraphicsError, match=r"paint was fitted to 3 lobes .* filtered for 2 lobes"):
        renderer.render_image(View(), (16, 16))
    renderer.set_environment(scenes.constant())
    renderer.render_image(View(), (16, 16))


def test_no_environment(renderer, scenes):
    renderer.set_mesh([scenes.sphere()])
    with pytest.raises(GraphicsError, match="choose one"):
        renderer.render_image(View(), (16, 16))


def test_edits_make_nothing(renderer, scenes, context, monkeypatch):
    """100 edits, each drawn: no OpenGL object made, no texture written, one buffer write each, and all seen."""
    renderer.set_environment(scenes.constant())
    renderer.set_mesh([scenes.sphere()])
    target = context.simple_framebuffer((32, 32))
    renderer.set_material("paint", scenes.weights(kd=0.1))
    renderer.render(View(), target, (32, 32))
    made, uploads, writes = (
        renderer.counters.total_created, renderer.counters.texture_uploads, renderer.counters.buffer_writes,
    )  # fmt: skip
    for name in FACTORIES:
        monkeypatch.setattr(context, name, lambda *_, _name=name, **__: pytest.fail(f"{_name} was called"))
    seen = set()
    for i in range(100):
        renderer.set_material("paint", scenes.weights(kd=0.05 + 0.009 * i))
        renderer.render(View(), target, (32, 32))
        seen.add(target.read(components=3)[3 * (16 * 32 + 16)])
    monkeypatch.undo()
    context.detect_framebuffer(0).use()
    target.release()
    assert renderer.counters.total_created == made
    assert renderer.counters.texture_uploads == uploads
    assert renderer.counters.buffer_writes == writes + 100
    assert len(seen) > 60


@pytest.mark.parametrize(
    "exponents", [(5.0,), (1.0, 50000.0), (2.0, 9.0, 40.0, 300.0, 2000.0, 9000.0, 50000.0)]
)
def test_stock_materials(exponents):
    stock = stock_materials(exponents)
    assert set(stock) >= {
        "glass",
        "lens",
        "gap",
        "rubber",
        "chrome",
        "lamp",
        "tail_lamp",
        "trim",
        "cavity",
        "neutral",
    }
    for name, weights in stock.items():
        gloss, base = reflected(weights)
        assert (gloss + base < 1).all(), name
    gloss, base = reflected(stock["glass"])
    assert gloss == pytest.approx(np.full(3, float(sheet_reflectance(np.cos(np.pi / 4), 1.52))))
    assert base == pytest.approx(np.zeros(3))
    assert 0.3 < stock["glass"].transmittance < stock["lens"].transmittance < 1.0
    assert max(sum(reflected(stock["cavity"]))) < 0.005
    gloss, base = reflected(stock["tail_lamp"])
    assert base[0] > 10 * base[2]
    assert reflected(stock["chrome"])[0] == pytest.approx([0.56, 0.57, 0.58])
    assert stock["chrome"].coat == "metal"
    assert reflected(stock["neutral"])[1] == pytest.approx(np.full(3, 0.18))


def test_lobe_mix_keeps_the_albedo_and_lies_between_neighbours():
    exponents = (5.0, 50.0, 500.0)
    solid = 2 * np.pi / (np.asarray(exponents) + 1)
    for exponent in (1.0, 5.0, 20.0, 50.0, 499.0, np.inf):
        weights = lobe_mix(exponents, exponent, 0.3)
        assert (weights * solid[:, None]).sum(0) == pytest.approx(np.full(3, 0.3))
        assert (weights >= 0).all()
    assert (lobe_mix(exponents, np.sqrt(5 * 50), 1.0) * solid[:, None])[:, 0] == pytest.approx([0.5, 0.5, 0])


def test_block(scenes):
    """Layout of the uniform block, as material.glsl declares it."""
    weights = scenes.weights(kd=0.3, gloss=0.04, directional=0.2, ior=1.6)
    ramp = make_ramp(weights, "raised", "shifted", Ladder((1.0, 8.0, 64.0)))
    block = np.frombuffer(pack(weights, ramp), np.float32).reshape(-1, 4)
    assert block.nbytes == BLOCK_SIZE
    f = float(fresnel_dielectric(np.cos(np.pi / 4), 1.6))
    assert block[0].view(np.int32).tolist() == [1, 1, 1, 0]
    assert block[1] == pytest.approx([1, 1.6, 1 / f, 1 / (1 - f) ** 2])
    assert block[2] == pytest.approx([0.04, 0.04, 0.04, 25])
    assert block[3, 3] == 8.0
    assert 0.3 < block[3, 0] < 0.6
    assert ramp.sharp == (20000.0,)
    bare = scenes.weights(ior=1.0)
    packed = np.frombuffer(pack(bare, make_ramp(bare, "raised", "shifted", Ladder((1.0,)))), np.float32)
    assert packed[4] == 0


def test_programs_for_few_look_ups():
    assert LookUps.enough_for(0, 0) == LookUps(1, 1)
    assert LookUps.enough_for(5, 2) == LookUps(6, 2)
    assert LookUps.enough_for(7, 1) == LookUps(8, 1)
    assert LookUps.enough_for(9, MAX_SHARP) == LookUps(0, MAX_SHARP)


def test_every_number_of_weighted_lobes(renderer, scenes):
    """With k of ten lobes weighted, and each map another constant, the sum is right for every k and any lobes."""
    exponents = tuple(2.0**i for i in range(1, 11))
    levels = 0.2 + 0.08 * np.arange(10)
    maps = [scenes.cube(np.full((6, 4, 4, 3), level), 0.3 + i) for i, level in enumerate(levels)]
    constant = scenes.constant(1.0, exponents=exponents)
    renderer.set_environment(replace(constant, lobes=tuple(maps)))
    renderer.set_mesh([scenes.sheet()])
    view = View(Camera(0, 0), tone_curve="linear", look_up="paper")
    rng = np.random.default_rng(1)
    for k in range(11):
        kg = np.zeros((10, 3))
        chosen = rng.choice(10, k, replace=False)
        kg[chosen] = (np.asarray(exponents)[chosen, None] + 1) / (2 * np.pi) * 0.09
        weights = MaterialWeights(exponents, np.zeros(3), np.zeros((10, 3)), kg, coat="none")
        renderer.set_material("paint", weights)
        image = renderer.render_image(view, (8, 8)) / 255.0
        light = np.where(image <= 0.04045, image / 12.92, ((image + 0.055) / 1.055) ** 2.4)
        assert light[4, 4] == pytest.approx(np.full(3, 0.09 * levels[chosen].sum()), abs=0.006)
