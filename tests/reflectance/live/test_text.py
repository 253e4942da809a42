"""Reading a model's text: both notations, their declarations, errors with lines, and defaults written back."""

from __future__ import annotations

import pytest

from brdf_suite.reflectance.live.text import ModelTextError, language_of, read_model_text, write_defaults

GLSL = """analytic

# a comment
::begin parameters
color tint .8 .2 .1   # of the base
float width .01 1 .3
bool coated 1
::end parameters

::begin shader
vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y)
{
    return tint;
}
::end shader
"""
PYTHON = """def brdf(L, V, N, X, Y,
         tint=color(0.8, 0.2, 0.1),
         width=number(-1, 1, 0.3), coated=switch(1)):
    return tint
"""


@pytest.mark.parametrize(("text", "low"), [(GLSL, 0.01), (PYTHON, -1.0), (GLSL.replace("\n", "\r\n"), 0.01)])
def test_parameters_are_declared_in_their_order(text: str, low: float) -> None:
    model = read_model_text(text)
    assert [(one.name, one.kind) for one in model.declared] == [
        ("tint", "color"),
        ("width", "float"),
        ("coated", "bool"),
    ]
    assert model.defaults == {"tint.r": 0.8, "tint.g": 0.2, "tint.b": 0.1, "width": 0.3, "coated": 1.0}
    width = model.declared[1].numbers()["width"]
    assert (width.low, width.high) == (low, 1.0)


def test_the_shader_begins_where_the_text_has_it() -> None:
    model = read_model_text(GLSL)
    assert GLSL.split("\n")[model.first_line - 1] == model.shader.split("\n")[0]


@pytest.mark.parametrize("text", [GLSL, PYTHON])
def test_values_become_defaults_and_nothing_else_changes(text: str) -> None:
    model = read_model_text(text)
    assert read_model_text(write_defaults(model, {})).defaults == model.defaults
    values = {"tint.r": 0.25, "tint.b": 1.0, "width": 0.125, "coated": 0.0}
    written = write_defaults(model, values)
    assert read_model_text(written).defaults == model.defaults | values
    assert written.splitlines()[-1] == text.splitlines()[-1]
    assert ("# of the base" in written) == ("# of the base" in text)
    assert len(written.splitlines()) == len(text.splitlines())


@pytest.mark.parametrize(
    ("before", "after", "line", "words"),
    [
        ("float width .01 1 .3", "float width 1 .01 .3", 6, "minimum, maximum and default"),
        ("float width .01 1 .3", "float width 0 1 2", 6, "minimum, maximum and default"),
        ("float width .01 1 .3", "float width 0 1", 6, "expected one of"),
        ("float width .01 1 .3", "float width 0 1 nan", 6, "minimum, maximum and default"),
        ("float width .01 1 .3", "float width 0 1 wide", 6, "expected a number, not 'wide'"),
        ("float width .01 1 .3", "float tint 0 1 .3", 6, "declared twice"),
        ("float width .01 1 .3", "float N 0 1 .3", 6, "cannot be the name"),
        ("float width .01 1 .3", "float gl_Width 0 1 .3", 6, "cannot be the name"),
        ("float width .01 1 .3", "vec4 width 0 1 .3", 6, "expected one of"),
        ("bool coated 1", "bool coated 2", 7, "0 or 1"),
        ("color tint .8 .2 .1", "color tint .8 .2 1.1", 5, "three numbers from 0 to 1"),
        ("::end parameters", "::end shader", 8, "::end parameters"),
        ("::begin parameters", "::begin textures", 4, "no section 'textures'"),
        ("::end shader", "", 16, "“::end shader” is missing"),
        ("# a comment", "a comment", 3, "stands in no section"),
        ("vec3 BRDF(", "vec3 F(", 11, "no function vec3 BRDF"),
    ],
)
def test_errors_of_glsl_name_the_line(before: str, after: str, line: int, words: str) -> None:
    with pytest.raises(ModelTextError) as caught:
        read_model_text(GLSL.replace(before, after, 1))
    assert caught.value.line == line
    assert words in caught.value.reason


@pytest.mark.parametrize(
    ("before", "after", "line", "words"),
    [
        ("number(-1, 1, 0.3)", "number(1, -1, 0.3)", 3, "minimum, maximum and default"),
        ("number(-1, 1, 0.3)", "number(-1, 1, 9**9**9)", 3, "expected a number"),
        ("number(-1, 1, 0.3)", "number(-1, 1, " + "9" * 400 + ")", 3, "minimum, maximum and default"),
        ("number(-1, 1, 0.3)", "open('/etc/passwd')", 3, "expected number(…), switch(…) or color(…)"),
        ("color(0.8, 0.2, 0.1)", "color(0.8)", 2, "three numbers from 0 to 1"),
        ("L, V, N, X, Y", "V, L, N, X, Y", 1, "brdf takes L, V, N, X, Y"),
        ("tint=", "*tint, a=", 1, "brdf takes L, V, N, X, Y"),
        ("    return tint", "    return (tint", 4, "never closed"),
    ],
)
def test_errors_of_python_name_the_line(before: str, after: str, line: int, words: str) -> None:
    with pytest.raises(ModelTextError) as caught:
        read_model_text(PYTHON.replace(before, after, 1))
    assert caught.value.line == line
    assert words in caught.value.reason


def test_what_is_no_model_is_known_by_its_content() -> None:
    for text in ("", "0.1 0.2 0.3\n", "# def brdf(\n", "    def brdf(x):\n", '{"brdfpaint": 1}'):
        assert language_of(text) is None
        with pytest.raises(ModelTextError):
            read_model_text(text)


def test_long_and_deep_texts_are_refused() -> None:
    for text in (
        PYTHON + "#" * 200_000,
        PYTHON.replace("tint\n", "(" * 5000 + "1" + ")" * 5000),
        GLSL + "\0",
    ):
        with pytest.raises(ModelTextError):
            read_model_text(text)
