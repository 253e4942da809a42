"""A mistake in a shader is reported by file and line."""

from __future__ import annotations

import pytest

from brdf_suite.errors import GraphicsError
from brdf_suite.realtime.gl.shader_source import (
    SHADERS,
    ShaderSource,
    _explain,
    compile_program,
    compose,
    look_up_defines,
)


def test_every_shader_says_what_it_provides_and_needs():
    files = sorted(SHADERS.glob("*.glsl"))
    assert len(files) >= 10
    for path in files:
        head = path.read_text(encoding="utf-8").splitlines()[:6]
        assert head[0].startswith("// Provides:"), path.name
        assert any(line.startswith("// Needs:") for line in head), path.name


def test_error_names_the_included_file_and_line(context, tmp_path):
    (tmp_path / "good.glsl").write_text("// Provides: one\nfloat one() { return 1.0; }\n")
    (tmp_path / "bad.glsl").write_text(
        '#include "good.glsl"\n// line 2\nfloat two() { return missing_name; }\n'
    )
    (tmp_path / "main.frag.glsl").write_text(
        'out vec4 c;\n#include "good.glsl"\n#include "bad.glsl"\nvoid main() { c = vec4(two()); }\n'
    )
    source = compose("main.frag.glsl", None, (tmp_path, SHADERS))
    with pytest.raises(GraphicsError, match=r"bad\.glsl, line 3, .*missing_name"):
        compile_program(context, compose("screen.vert.glsl"), source)


def test_error_after_an_include_keeps_its_line(context, tmp_path):
    (tmp_path / "main.frag.glsl").write_text(
        'out vec4 c;\n#include "tone_curve.glsl"\nvoid main() {\n  c = nonsense;\n}\n'
    )
    with pytest.raises(GraphicsError, match=r"main\.frag\.glsl, line 4, .*nonsense"):
        compile_program(
            context, compose("screen.vert.glsl"), compose("main.frag.glsl", None, (tmp_path, SHADERS))
        )


def test_link_error_is_a_message(context, tmp_path):
    (tmp_path / "a.vert.glsl").write_text(
        "out vec2 given;\nvoid main() { given = vec2(0); gl_Position = vec4(0); }\n"
    )
    (tmp_path / "a.frag.glsl").write_text("in vec3 given;\nout vec4 c;\nvoid main() { c = given.xyzz; }\n")
    # Some drivers find the difference as they compile, and have a line for it.
    with pytest.raises(GraphicsError, match=r"a\.frag\.glsl.* not compile.*given"):
        compile_program(
            context, compose("a.vert.glsl", None, (tmp_path,)), compose("a.frag.glsl", None, (tmp_path,))
        )


def test_missing_file(tmp_path):
    (tmp_path / "a.glsl").write_text('\n#include "b.glsl"\n')
    with pytest.raises(GraphicsError, match=r"b\.glsl is missing, asked for by a\.glsl, line 2"):
        compose("a.glsl", None, (tmp_path,))


@pytest.mark.parametrize(
    "words",
    [
        "0:10007(3): error: `x' undeclared",
        '0(10007) : error C1008: undefined variable "x"',
        "ERROR: 0:10007: 'x' : undeclared identifier",
    ],
)
def test_words_of_every_vendor(words):
    source = ShaderSource("", ("main.frag.glsl", "lobes.glsl"))
    assert "lobes.glsl, line 7" in _explain(
        f"GLSL Compiler failed\n\nfragment_shader\n======\n{words}\n", source, "pair"
    )


def test_lobe_loop():
    assert look_up_defines(4, 3) == {
        "BROAD": "4",
        "SHARP": "3",
        "FOR_EACH_SHARP_LOBE(BODY)": "BODY(0) BODY(1) BODY(2)",
    }
