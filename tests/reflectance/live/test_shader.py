"""GLSL of a model in a real context of OpenGL: values, errors with lines, and texts that hang or break the driver."""

from __future__ import annotations

import signal

import numpy as np
import pytest

from brdf_suite.errors import GraphicsError
from brdf_suite.geometry import warps
from brdf_suite.reflectance.live import shader
from brdf_suite.reflectance.live.model import LiveModel
from brdf_suite.reflectance.live.text import ModelTextError, read_model_text

rng = np.random.default_rng(6)
WI, WO = warps.cosine_hemisphere(rng.random((2, 70_000, 2)))


def text(body: str, parameters: str = "", before: str = "") -> str:
    """A text whose function's first line is the 8th with one parameter."""
    return f"""analytic
::begin parameters
{parameters}
::end parameters
::begin shader
{before}
vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) {{
{body}
}}
::end shader
"""


GOOD = text("return vec3(0.1, 0.2, 0.3);")


def test_values_are_those_of_the_same_formulas() -> None:
    glsl = LiveModel.of(
        text(
            "vec3 H = normalize(L + V); float c = pow(max(dot(N, H), 0.0), n);\n"
            "return tint / 3.0 + (on ? c : 0.0) + abs(dot(X, L)) * 0.1 + abs(L.y - dot(Y, V)) * 0.2;",
            "color tint .2 .4 .6\nfloat n 1 99 20\nbool on 1",
        )
    )
    python = LiveModel.of(
        "def brdf(L, V, N, X, Y, tint=color(0.2, 0.4, 0.6), n=number(1, 99, 20), on=switch(1)):\n"
        "    c = max(dot(N, normalize(L + V)), 0) ** n\n"
        "    return tint / 3 + (c if on else 0) + abs(dot(X, L)) * 0.1 + abs(L[1] - dot(Y, V)) * 0.2\n"
    )
    for values in ({}, {"n": 3.0, "on": 0.0, "tint.g": 1.0}, {"n": 80.0, "tint.b": 0.0}):
        pair = [LiveModel(one.model, values) for one in (glsl, python)]
        np.testing.assert_allclose(pair[0].eval(WI, WO), pair[1].eval(WI, WO), rtol=2e-4, atol=1e-6)
    assert glsl.isotropic is python.isotropic is False


def test_what_is_no_number_is_black() -> None:
    signalling = LiveModel.of(text("return vec3(uintBitsToFloat(0x7fa00000u));"))
    assert not signalling.eval(WI[:100], WO[:100]).any()


@pytest.mark.parametrize(
    ("wrong", "line", "words"),
    [
        (text("float a = 1.0;\nreturn vec3(b);"), 9, "b"),
        (text("return vec3(1.0)"), 9, "syntax error"),
        (text("return 1.0;"), 8, "return"),
        (text("return vec3(1.0);", before="#error no"), 6, "no"),
    ],
)
def test_compilers_errors_name_the_line_of_the_text(wrong: str, line: int, words: str) -> None:
    with pytest.raises(ModelTextError) as caught:
        LiveModel.of(wrong)
    assert caught.value.line == line
    assert words in caught.value.reason


def test_a_text_that_takes_too_long_ends_and_the_next_one_works(monkeypatch: pytest.MonkeyPatch) -> None:
    assert LiveModel.of(GOOD).eval([0.0, 0.0, 1.0], [0.0, 0.0, 1.0]).shape == (3,)  # the child is there
    doubling = "\n".join(f"#define M{k + 1}(x) M{k}(x)+M{k}(x)" for k in range(30))
    bomb = text("return vec3(M30(L.x));", before=f"#define M0(x) sin(x)\n{doubling}")
    monkeypatch.setattr(shader, "SECONDS", 1.0)
    for _ in range(2):  # the second is refused without being computed
        with pytest.raises(GraphicsError, match=r"takes longer than|broke down"):
            LiveModel.of(bomb)
    monkeypatch.undo()
    assert LiveModel.of(GOOD).eval([0.0, 0.0, 1.0], [0.0, 0.0, 1.0]).all()


def test_a_child_that_was_killed_is_replaced() -> None:
    model = LiveModel.of(GOOD)
    child = shader.child_process()
    assert child.process is not None
    child.process.kill()
    child.process.wait()
    assert model.eval([0.0, 0.0, 1.0], [0.0, 0.6, 0.8]).all()


@pytest.mark.skipif(not hasattr(signal, "SIGALRM"), reason="the alarm is one of POSIX systems")
def test_an_interrupt_leaves_no_answer_for_the_next_request() -> None:
    doubling = "\n".join(f"#define M{k + 1}(x) M{k}(x)+M{k}(x)" for k in range(29))
    long = LiveModel(
        read_model_text(text("return vec3(M29(L.x));", before=f"#define M0(x) sin(x)\n{doubling}"))
    )
    LiveModel.of(GOOD)

    def interrupt(_number: int, _frame: object) -> None:
        raise KeyboardInterrupt

    before = signal.signal(signal.SIGALRM, interrupt)
    signal.setitimer(signal.ITIMER_REAL, 0.5)
    try:
        with pytest.raises(KeyboardInterrupt):
            long.eval([0.0, 0.0, 1.0], [0.0, 0.0, 1.0])
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, before)
    assert LiveModel.of(GOOD).eval([0.0, 0.0, 1.0], [0.0, 0.0, 1.0]).all()


def test_without_opengl_it_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    shader.child_process().end()
    monkeypatch.setattr(shader, "WORKER", "brdf_suite.no_such_module")
    with pytest.raises(GraphicsError, match="did not start"):
        LiveModel.of(GOOD)
