"""Formulas in Python's notation: their values, and that nothing else of Python is run."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from brdf_suite.appearance.colour.colorimetry import REC709_TO_WORKING
from brdf_suite.geometry import warps
from brdf_suite.geometry.directions import mirror
from brdf_suite.reflectance.live.formulas import FUNCTIONS, MOST_STEPS, compute_formulas
from brdf_suite.reflectance.live.model import LiveModel
from brdf_suite.reflectance.live.text import ModelTextError, read_model_text

rng = np.random.default_rng(5)
WI, WO = warps.cosine_hemisphere(rng.random((2, 300, 2)))


def values(body: str, above: str = "", **given: float) -> np.ndarray:
    """What a text with this body returns for 300 pairs, in the text's own space."""
    model = read_model_text(
        f"{above}\ndef brdf(L, V, N, X, Y, a=number(0, 9, 2), on=switch(0)):\n    {body}\n"
    )
    return compute_formulas(model, WI, WO, model.defaults | given)


def column(numbers: np.ndarray) -> np.ndarray:
    return np.repeat(np.asarray(numbers)[:, None], 3, axis=1)


H = (WI + WO) / np.linalg.norm(WI + WO, axis=1, keepdims=True)


@pytest.mark.parametrize(
    ("body", "expected"),
    [
        ("return 0.25", np.full((300, 3), 0.25)),
        ("return vec3(1, 2, a)", np.tile([1.0, 2.0, 2.0], (300, 1))),
        ("return L", WI),
        ("return V * L", WI * WO),
        ("return dot(L, V)", column(np.sum(WI * WO, axis=1))),
        ("return dot(N, L)", column(WI[:, 2])),
        ("return normalize(L + V)", H),
        ("return cross(L, V)", np.cross(WI, WO)),
        ("return length(L + V)", column(np.linalg.norm(WI + WO, axis=1))),
        ("return reflect(-L, N)", mirror(WI)),
        ("return L[2] ** a - V[0] / 3", column(WI[:, 2] ** 2 - WO[:, 0] / 3)),
        ("return where(L[0] > V[0], 1, 2)", column(np.where(WI[:, 0] > WO[:, 0], 1.0, 2.0))),
        ("return L if on else V", WO),
        ("return 1 if L[0] > 0 and not V[0] > 0 else 0", column((WI[:, 0] > 0) & ~(WO[:, 0] > 0))),
        ("return 1 if 0 < L[0] < 0.5 else 0", column((WI[:, 0] > 0) & (WI[:, 0] < 0.5))),
        ("return min(L[0], L[1], V[0])", column(np.minimum.reduce([WI[:, 0], WI[:, 1], WO[:, 0]]))),
        ("return clamp(L, 0, 0.5)", np.clip(WI, 0.0, 0.5)),
        ("return mix(L, V, 0.25)", 0.75 * WI + 0.25 * WO),
        ("return smoothstep(0, 1, L[2])", column(WI[:, 2] ** 2 * (3 - 2 * WI[:, 2]))),
        ("return atan2(L[1], L[0])", column(np.arctan2(WI[:, 1], WI[:, 0]))),
        ("return 7 % 4 + 7 // 4", np.full((300, 3), 4.0)),
        ("return pi", np.full((300, 3), np.pi)),
    ],
)
def test_values(body: str, expected: np.ndarray) -> None:
    np.testing.assert_allclose(values(body), expected, rtol=1e-13, atol=1e-13)


def test_names_constants_and_functions_of_the_text() -> None:
    above = (
        "TWO = 1 + 1\ndef square(x):\n    '''x².'''\n    y = x * x\n    return y\n"
        "def fourth(x):\n    return square(square(x))\n"
    )
    found = values("b = fourth(L[2])\n    b *= TWO\n    return b", above)
    np.testing.assert_allclose(found, column(2.0 * WI[:, 2] ** 4))


@pytest.mark.parametrize("name", FUNCTIONS)
def test_every_function_takes_numbers_and_vectors(name: str) -> None:
    for kind in ("0.5", "L", "L[0]"):
        arguments = ", ".join([kind] * FUNCTIONS[name].fewest)
        assert values(f"return {name}({arguments})").shape == (300, 3)


@pytest.mark.parametrize(
    ("body", "words"),
    [
        ("import os; return 1", "imports are not allowed"),
        ("return L.ctypes", "attributes are not allowed"),
        ("return ().__class__", "attributes are not allowed"),
        ("return __import__('os')", "there is no function __import__"),
        ("return open('x')", "there is no function open"),
        ("return eval('1')", "there is no function eval"),
        ("return 'text'", "expected a number"),
        ("return [1, 2, 3]", "List is not allowed"),
        ("return f'{a}'", "JoinedStr is not allowed"),
        ("return L[a]", "a component is [0], [1] or [2]"),
        ("return L[3]", "a component is [0], [1] or [2]"),
        ("return (lambda: 1)()", "only functions are called"),
        ("return lambda: 1", "write a function by def"),
        ("return (b := 1)", "NamedExpr is not allowed"),
        ("return brdf(L, V, N, X, Y)", "there is no function brdf"),
        ("return max(*L)", "max takes 2 to 8 values, not 1"),
        ("return max(L, key=1)", "only functions are called, with values in their order"),
        ("return sin(1, 2)", "sin takes 1 values, not 2"),
        ("return b", "there is no b"),
        ("return 1j", "expected a number"),
        ("return 1 @ 2", "BinOp is not allowed"),
        ("return 1 << 2", "BinOp is not allowed"),
        ("return ~1", "UnaryOp is not allowed"),
        ("return", "return stands at the end, with a value"),
        ("while True: pass", "loops are not allowed"),
        ("for i in L: pass", "loops are not allowed"),
        ("if a > 1: return 1", "write “a if condition else b”"),
        ("L[0] = 1; return L", "assign to one name at a time"),
        ("global a; return a", "Global is not allowed"),
        ("del a; return 1", "Delete is not allowed"),
        ("yield 1", "Yield is not allowed"),
        ("return await_(1)", "there is no function await_"),
    ],
)
def test_nothing_else_of_python_is_run(body: str, words: str) -> None:
    with pytest.raises(ModelTextError) as caught:
        values(body)
    assert words in str(caught.value)
    assert caught.value.line == 3


@pytest.mark.parametrize(
    "above",
    [
        "@open\ndef f(x):\n    return x",
        "def f(x: open('a')):\n    return x",
        "def f(x) -> open('a'):\n    return x",
        "def f(x=open('a')):\n    return x",
        "class A: pass",
        "def sin(x):\n    return x",
        "def f(x):\n    return f(x)",
        "def f(x):\n    return g(x)\ndef g(x):\n    return x",
        "A = open('a')",
        "def f(x):\n    y = x",
    ],
)
def test_nothing_around_the_function_is_run(above: str) -> None:
    with pytest.raises(ModelTextError):
        values("return 1", above)


def test_an_opened_file_leaves_no_trace(tmp_path: Path) -> None:
    mark = tmp_path / "mark"
    text = f"open({str(mark)!r}, 'w').close()\ndef brdf(L, V, N, X, Y):\n    return 1\n"
    with pytest.raises(ModelTextError):
        LiveModel.of(text)
    assert not mark.exists()


def test_the_work_is_bounded() -> None:
    doubling = "def f0(x):\n    return x + 1\n" + "".join(
        f"def f{k + 1}(x):\n    return f{k}(x) + f{k}(x)\n" for k in range(40)
    )
    with pytest.raises(ModelTextError, match=f"more than {MOST_STEPS:,} operations"):
        values("return f40(1)", doubling)
    assert np.isinf(values("return 9 ** 9 ** 9")).all()
    assert np.isinf(values("return " + "9" * 400)).all()
    with pytest.raises(ModelTextError, match="nested too deeply"):
        values("return " + "-" * 90 + "1")


def test_poles_are_no_faults() -> None:
    assert np.isnan(values("return sqrt(-1)")).all()
    assert np.isinf(values("return 1 / 0")).all()


def test_what_is_no_number_is_black_and_said() -> None:
    model = LiveModel.of("def brdf(L, V, N, X, Y):\n    return 0.5 + sqrt(L[0])\n")
    assert not model.eval([-0.6, 0.0, 0.8], [0.0, 0.0, 1.0]).any()
    (note,) = model.facts["notes"]
    assert note.startswith("The text gives no finite value for ")
    assert 45.0 < float(note.split()[7]) < 55.0
    assert LiveModel.of("def brdf(L, V, N, X, Y):\n    return 1\n").notes == ()


def test_a_model_is_in_the_working_space_and_black_below_the_horizon() -> None:
    model = LiveModel.of("def brdf(L, V, N, X, Y):\n    return vec3(0.1, -0.2, 0.3)\n")
    found = model.eval([[0.0, 0.0, 1.0], [0.0, 0.0, -1.0], [0.6, 0.0, 0.8]], [0.0, 0.6, 0.8])
    np.testing.assert_allclose(found[0], REC709_TO_WORKING @ [0.1, 0.0, 0.3])
    assert not found[1].any()
    assert model.eval(np.zeros((0, 3)), [0.0, 0.0, 1.0]).shape == (0, 3)
    assert model.eval(np.full((2, 1, 3), [0.0, 0.0, 1.0]), np.full((5, 3), [0.0, 0.6, 0.8])).shape == (
        2,
        5,
        3,
    )


def test_directions_are_drawn_with_their_density(chi_square) -> None:
    model = LiveModel.of("def brdf(L, V, N, X, Y):\n    return 0.1 + 3 * dot(N, normalize(L + V)) ** 40\n")
    view = np.array([0.6, 0.0, 0.8])
    drawn = model.sample(view, np.random.default_rng(7).random((60_000, 3)))
    assert chi_square(drawn, lambda w: model.pdf(w, view), np.arccos(0.8)) > 0.01
