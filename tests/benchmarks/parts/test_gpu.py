"""The benchmark of graphics cards, small, on whatever draws here; that a software renderer has no times; the counts."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

from brdf_suite.cli.tools.bench import load_module
from brdf_suite.pipeline.picture import gl_renderer_name

gpu = load_module(Path(__file__).parents[1] / "bench_gpu.py")
shader = load_module(Path(__file__).parents[1] / "bench_shader.py")
counts = load_module(Path(__file__).parent / "shader_counts.py")


def test_every_case_is_timed() -> None:
    found = gpu.measure({"small": (48, 27), "wide": (64, 36)}, 1, 12, 120)
    assert set(found) == set(gpu.BOUNDS)
    assert all(value is not None and value > 0.0 for value in found.values())
    assert {tuple(row) for row in gpu.TABLES.values()} == {("small", "wide")}
    assert gl_renderer_name() in gpu.appendix()


def test_a_software_renderer_has_counts_and_no_times() -> None:
    if "llvmpipe" not in gl_renderer_name():
        pytest.skip("a graphics card draws here")
    assert gpu.run() == dict.fromkeys(gpu.BOUNDS)
    assert all("no graphics card" in gpu.NOTES[key] for key in gpu.BOUNDS)
    found = shader.run()
    assert set(found) == set(shader.BOUNDS)
    # A pixel of the paint: a look-up of weights and one of light for each lobe, and the flakes' on top.
    assert 10 < found["paint_reads"] < 60
    assert found["paint_instructions"] > 500
    assert all(0.0 < found[key] < 1.0 for key in ("reads_share", "instructions_share", "bytes_share"))


DRAWN = """
import moderngl
from brdf_suite.realtime.gl.context import create_context
context = create_context()
program = context.program(
    vertex_shader="#version 330 core\\nvoid main() {{ gl_Position = vec4(gl_VertexID - 1, gl_VertexID & 1, 0, 1); }}",
    fragment_shader='''{fragment}''',
)
context.simple_framebuffer((8, 8)).use()
context.texture((4, 4), 4).use(0)
context.vertex_array(program, []).render(moderngl.TRIANGLES, vertices=3)
context.finish()
"""

FRAGMENT = """#version 330 core
uniform sampler2D map;
uniform float bright;
uniform int rounds;
out vec4 seen;
void main()
{{
    vec4 sum = vec4(0.0);
    for (int i = 0; i < {rounds}; ++i)
        sum += {read} * bright;
    seen = sum + {more};
}}
"""


def cost(rounds: str, read: str, more: str = "0.0") -> Any:
    """What Mesa makes of a shader that reads a texture in a loop."""
    text = DRAWN.format(fragment=FRAGMENT.format(rounds=rounds, read=read, more=more))
    environment = os.environ | {"ST_DEBUG": "nir", "MESA_SHADER_CACHE_DISABLE": "1"}
    done = subprocess.run([sys.executable, "-c", text], capture_output=True, text=True, env=environment)
    assert done.returncode == 0, done.stderr[-2000:]
    found = counts.programs(done.stderr)
    if not found:
        pytest.skip("this driver does not print its instructions")
    (one,) = found.values()
    return one


def test_reads_and_instructions_are_those_of_the_compiled_shader() -> None:
    fetched = "texelFetch(map, ivec2(gl_FragCoord.xy) + i, 0)"
    three, four = cost("3", fetched), cost("4", fetched)
    assert (three.plain, four.plain) == (3, 4)
    assert three.filtered == 0
    # A sum of each component, the place, and the read.
    assert 5 <= four.instructions - three.instructions <= 12
    sampled = cost("1", "texture(map, gl_FragCoord.xy * float(i + 1))")
    assert (sampled.filtered, sampled.plain) == (1, 0)
    root = cost("1", fetched, "sqrt(bright)")
    assert root.instructions == cost("1", fetched, "bright").instructions + counts.SPECIAL


def test_a_loop_of_unknown_length_counts_once_and_one_with_a_choice_by_the_larger() -> None:
    fetched = "texelFetch(map, ivec2(i), 0)"
    assert cost("rounds", fetched).plain == 1
    assert cost("(bright > 0.5 ? 40 : 0)", fetched).plain == 40
