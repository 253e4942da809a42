"""Formulas in Python's notation, computed by numpy over arrays of directions; nothing of the text is run.

The text is parsed, and its syntax tree is walked: numbers, names, arithmetic, comparisons, conditions, the functions
of :data:`FUNCTIONS`, assignments, functions of the text that were defined above, and ``return``. Everything else is
refused with its line: attributes, imports, loops, texts. So a file of anyone can be opened. The work is bounded: there
are no loops and no recursion, and a block of directions takes at most :data:`MOST_STEPS` operations.

A number of each direction is an array (n, 1), a vector or a colour (n, 3) or (1, 3); they broadcast.
"""

from __future__ import annotations

import ast
import math
import operator
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache, reduce
from typing import Any

import numpy as np
from numpy.typing import NDArray

from brdf_suite.arrays import Floats
from brdf_suite.reflectance.live.text import DIRECTIONS, ModelText, ModelTextError, parse_python

Value = NDArray[np.float64]

MOST_STEPS = 4000
"""Operations for one block of directions."""
_MOST_NODES = 20_000
_DEEPEST = 60

CONSTANTS = {"pi": math.pi}


def _vector(*parts: Value) -> Value:
    columns = np.broadcast_arrays(*(part[..., :1] for part in parts))
    return np.concatenate(columns, axis=-1)


def _dot(a: Value, b: Value) -> Value:
    product = a * b
    if product.shape[-1] == 1:
        product = 3.0 * product
    return np.asarray(product.sum(axis=-1, keepdims=True))


def _length(a: Value) -> Value:
    return np.sqrt(_dot(a, a))


def _normalize(a: Value) -> Value:
    return np.asarray(a / _length(a))


def _cross(a: Value, b: Value) -> Value:
    (ax, ay, az), (bx, by, bz) = (np.moveaxis(_three(one), -1, 0)[..., None] for one in (a, b))
    return _vector(ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx)


def _three(a: Value) -> Value:
    return np.broadcast_to(a, (*a.shape[:-1], 3))


def _mix(a: Value, b: Value, share: Value) -> Value:
    return np.asarray(a + (b - a) * share)


def _smoothstep(low: Value, high: Value, a: Value) -> Value:
    t = np.clip((a - low) / (high - low), 0.0, 1.0)
    return np.asarray(t * t * (3.0 - 2.0 * t))


def _where(condition: Value, a: Value, b: Value) -> Value:
    return np.where(condition != 0.0, a, b)


@dataclass(frozen=True)
class Function:
    """A function of the notation: how many numbers it takes, and numpy's way to compute it."""

    fewest: int
    most: int
    compute: Callable[..., Any]


FUNCTIONS: Mapping[str, Function] = {
    **{
        name: Function(1, 1, getattr(np, name))
        for name in ("sqrt", "exp", "log", "sin", "cos", "tan", "arcsin", "arccos", "arctan", "floor", "sign")
    },
    "abs": Function(1, 1, np.abs),
    "asin": Function(1, 1, np.arcsin),
    "acos": Function(1, 1, np.arccos),
    "atan": Function(1, 1, np.arctan),
    "arctan2": Function(2, 2, np.arctan2),
    "atan2": Function(2, 2, np.arctan2),
    "pow": Function(2, 2, np.power),
    "min": Function(2, 8, lambda *given: reduce(np.minimum, given)),
    "max": Function(2, 8, lambda *given: reduce(np.maximum, given)),
    "minimum": Function(2, 2, np.minimum),
    "maximum": Function(2, 2, np.maximum),
    "clip": Function(3, 3, lambda a, low, high: np.minimum(np.maximum(a, low), high)),
    "clamp": Function(3, 3, lambda a, low, high: np.minimum(np.maximum(a, low), high)),
    "where": Function(3, 3, _where),
    "mix": Function(3, 3, _mix),
    "step": Function(2, 2, lambda edge, a: np.where(a < edge, 0.0, 1.0)),
    "smoothstep": Function(3, 3, _smoothstep),
    "vec3": Function(3, 3, _vector),
    "dot": Function(2, 2, _dot),
    "cross": Function(2, 2, _cross),
    "length": Function(1, 1, _length),
    "normalize": Function(1, 1, _normalize),
    "reflect": Function(2, 2, lambda a, n: a - 2.0 * _dot(n, a) * n),
}
"""The functions that a text may call, with the names of numpy and of GLSL."""

_BINARY: dict[type, Callable[[Any, Any], Any]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: np.divide,
    ast.Pow: np.power,
    ast.Mod: np.mod,
    ast.FloorDiv: np.floor_divide,
}
_UNARY: dict[type, Callable[[Any], Any]] = {
    ast.USub: operator.neg,
    ast.UAdd: operator.pos,
    ast.Not: lambda a: (a == 0.0).astype(np.float64),
}
_COMPARED: dict[type, Callable[[Any, Any], Any]] = {
    ast.Lt: operator.lt,
    ast.LtE: operator.le,
    ast.Gt: operator.gt,
    ast.GtE: operator.ge,
    ast.Eq: operator.eq,
    ast.NotEq: operator.ne,
}
_WORDS: dict[type, str] = {
    ast.Attribute: "attributes are not allowed",
    ast.Import: "imports are not allowed",
    ast.ImportFrom: "imports are not allowed",
    ast.For: "loops are not allowed",
    ast.While: "loops are not allowed",
    ast.If: "write “a if condition else b” or where(condition, a, b)",
    ast.Lambda: "write a function by def",
}


def compute_formulas(model: ModelText, wi: Floats, wo: Floats, values: Mapping[str, float]) -> Floats:
    """Return what ``brdf`` of the text returns (n, 3), for directions (n, 3) and a value for each number.

    Not a number and infinity are returned where the formulas give them.

    Raises
    ------
    ModelTextError
        The text holds something that is not allowed, or takes too many operations; with the line.
    """
    try:
        return _Run(_checked(model.text), len(wi)).brdf(model, wi, wo, values)
    except RecursionError as error:
        raise ModelTextError("functions call each other too deeply") from error


def check_formulas(model: ModelText) -> None:
    """Raise :class:`ModelTextError` where something in the text is not allowed."""
    _checked(model.text)


@dataclass(frozen=True)
class _Parsed:
    constants: tuple[ast.Assign, ...]
    functions: Mapping[str, ast.FunctionDef]


@lru_cache(maxsize=16)
def _checked(text: str) -> _Parsed:
    tree = parse_python(text)
    if sum(1 for _ in ast.walk(tree)) > _MOST_NODES:
        raise ModelTextError("the text has too many formulas")
    constants: list[ast.Assign] = []
    functions: dict[str, ast.FunctionDef] = {}
    names = {*CONSTANTS}
    for node in tree.body:
        if _is_text(node):
            continue
        if isinstance(node, ast.Assign):
            names.add(_check_assignment(node, names, functions))
            constants.append(node)
        elif isinstance(node, ast.FunctionDef):
            _check_function(node, names, functions)
            functions[node.name] = node
        else:
            raise _refused(node)
    return _Parsed(tuple(constants), functions)


def _check_function(node: ast.FunctionDef, names: set[str], functions: Mapping[str, ast.FunctionDef]) -> None:
    taken = node.args
    if node.decorator_list or node.returns or any(one.annotation for one in taken.args):
        raise ModelTextError("decorators and annotations are not allowed", node.lineno)
    if node.name in functions or node.name in FUNCTIONS:
        raise ModelTextError(f"the function {node.name} is there already", node.lineno)
    is_main = node.name == "brdf"
    if (
        taken.vararg
        or taken.kwarg
        or taken.kwonlyargs
        or taken.posonlyargs
        or (taken.defaults and not is_main)
    ):
        raise ModelTextError("a function takes plain names", node.lineno)
    known = names | {one.arg for one in taken.args}
    for place, statement in enumerate(node.body):
        if isinstance(statement, ast.Return):
            if statement.value is None or place != len(node.body) - 1:
                raise ModelTextError("return stands at the end, with a value", statement.lineno)
            _check_expression(statement.value, known, functions, 0)
        elif isinstance(statement, ast.Assign):
            known.add(_check_assignment(statement, known, functions))
        elif isinstance(statement, ast.AugAssign) and isinstance(statement.target, ast.Name):
            _check_expression(
                ast.copy_location(ast.Name(statement.target.id), statement), known, functions, 0
            )
            if type(statement.op) not in _BINARY:
                raise _refused(statement.op, statement.lineno)
            _check_expression(statement.value, known, functions, 0)
        elif not _is_text(statement):
            raise _refused(statement)
    if not isinstance(node.body[-1], ast.Return):
        raise ModelTextError(f"{node.name} returns nothing", node.lineno)


def _check_assignment(node: ast.Assign, names: set[str], functions: Mapping[str, ast.FunctionDef]) -> str:
    target = node.targets[0]
    if len(node.targets) != 1 or not isinstance(target, ast.Name):
        raise ModelTextError("assign to one name at a time", node.lineno)
    _check_expression(node.value, names, functions, 0)
    return target.id


def _check_expression(
    node: ast.expr, names: set[str], functions: Mapping[str, ast.FunctionDef], depth: int
) -> None:
    if depth > _DEEPEST:
        raise ModelTextError("the formula is nested too deeply; assign parts of it to names", node.lineno)
    inner: list[ast.expr] = []
    if isinstance(node, ast.Constant):
        if not isinstance(node.value, int | float):
            raise ModelTextError("expected a number", node.lineno)
    elif isinstance(node, ast.Name):
        if node.id not in names:
            raise ModelTextError(f"there is no {node.id[:40]}", node.lineno)
    elif isinstance(node, ast.BinOp) and type(node.op) in _BINARY:
        inner = [node.left, node.right]
    elif isinstance(node, ast.UnaryOp) and type(node.op) in _UNARY:
        inner = [node.operand]
    elif isinstance(node, ast.BoolOp):
        inner = node.values
    elif isinstance(node, ast.Compare) and all(type(one) in _COMPARED for one in node.ops):
        inner = [node.left, *node.comparators]
    elif isinstance(node, ast.IfExp):
        inner = [node.test, node.body, node.orelse]
    elif isinstance(node, ast.Subscript):
        index = node.slice
        if not isinstance(index, ast.Constant) or type(index.value) is not int or not 0 <= index.value <= 2:
            raise ModelTextError("a component is [0], [1] or [2]", node.lineno)
        inner = [node.value]
    elif isinstance(node, ast.Call):
        _check_call(node, functions)
        inner = node.args
    else:
        raise _refused(node)
    for one in inner:
        _check_expression(one, names, functions, depth + 1)


def _check_call(node: ast.Call, functions: Mapping[str, ast.FunctionDef]) -> None:
    if not isinstance(node.func, ast.Name) or node.keywords:
        raise ModelTextError("only functions are called, with values in their order", node.lineno)
    name, count = node.func.id, len(node.args)
    if name in FUNCTIONS:
        fewest, most = FUNCTIONS[name].fewest, FUNCTIONS[name].most
    elif name in functions and name != "brdf":
        fewest = most = len(functions[name].args.args)
    else:
        raise ModelTextError(f"there is no function {name[:40]} above this line", node.lineno)
    if not fewest <= count <= most:
        wanted = str(fewest) if fewest == most else f"{fewest} to {most}"
        raise ModelTextError(f"{name} takes {wanted} values, not {count}", node.lineno)


def _is_text(node: ast.stmt) -> bool:
    """Whether a statement is a docstring or ``pass``."""
    if isinstance(node, ast.Pass):
        return True
    return (
        isinstance(node, ast.Expr)
        and isinstance(node.value, ast.Constant)
        and isinstance(node.value.value, str)
    )


def _refused(node: ast.AST, line: int | None = None) -> ModelTextError:
    if isinstance(node, ast.Expr):
        node = node.value
    words = _WORDS.get(type(node), f"{type(node).__name__} is not allowed in formulas")
    return ModelTextError(words, line or int(vars(node).get("lineno", 0)) or None)


class _Run:
    """One computation: the names of the text and the steps that are left."""

    def __init__(self, parsed: _Parsed, count: int) -> None:
        self._functions = parsed.functions
        self._constants = parsed.constants
        self._steps = MOST_STEPS
        self._count = count

    def brdf(self, model: ModelText, wi: Floats, wo: Floats, values: Mapping[str, float]) -> Floats:
        axes = np.eye(3)[:, None]
        names: dict[str, Value] = {name: _number(value) for name, value in CONSTANTS.items()}
        given = (wi, wo, axes[2], axes[0], axes[1])
        with np.errstate(all="ignore"):  # a pole is no fault: its direction is counted, and black
            for one in self._constants:
                self._assign(one, names)
            constants = dict(names)
            names |= dict(zip(DIRECTIONS, given, strict=True))
            for declared in model.declared:
                numbers = [values[key] for key in declared.numbers()]
                names[declared.name] = np.array([numbers], np.float64)
            found = self._body(self._functions["brdf"].body, names, constants)
        return np.array(np.broadcast_to(found, (self._count, 3)))

    def _body(
        self, body: Sequence[ast.stmt], names: dict[str, Value], constants: Mapping[str, Value]
    ) -> Value:
        for statement in body:
            if isinstance(statement, ast.Assign):
                self._assign(statement, names, constants)
            elif isinstance(statement, ast.AugAssign) and isinstance(statement.target, ast.Name):
                value = self._value(statement.value, names, constants)
                name = statement.target.id
                names[name] = np.asarray(_BINARY[type(statement.op)](names[name], value), np.float64)
            elif isinstance(statement, ast.Return) and statement.value is not None:
                return self._value(statement.value, names, constants)
        raise ModelTextError("a function returns nothing")

    def _assign(
        self, statement: ast.Assign, names: dict[str, Value], constants: Mapping[str, Value] | None = None
    ) -> None:
        target = statement.targets[0]
        assert isinstance(target, ast.Name)  # as checked
        names[target.id] = self._value(statement.value, names, names if constants is None else constants)

    def _value(self, node: ast.expr, names: Mapping[str, Value], constants: Mapping[str, Value]) -> Value:
        return np.asarray(self._compute(node, names, constants), np.float64)

    def _compute(self, node: ast.expr, names: Mapping[str, Value], constants: Mapping[str, Value]) -> Any:
        self._steps -= 1
        if self._steps < 0:
            raise ModelTextError(f"the formulas take more than {MOST_STEPS:,} operations", node.lineno)

        def of(inner: ast.expr) -> Value:
            return self._value(inner, names, constants)

        if isinstance(node, ast.Constant) and isinstance(node.value, int | float):
            return _number(node.value)
        if isinstance(node, ast.Name):
            return names[node.id]
        if isinstance(node, ast.BinOp):
            return _BINARY[type(node.op)](of(node.left), of(node.right))
        if isinstance(node, ast.UnaryOp):
            return _UNARY[type(node.op)](of(node.operand))
        if isinstance(node, ast.BoolOp):
            every = [of(one) != 0.0 for one in node.values]
            return reduce(np.logical_and if isinstance(node.op, ast.And) else np.logical_or, every)
        if isinstance(node, ast.Compare):
            sides = [of(one) for one in (node.left, *node.comparators)]
            pairs = zip(node.ops, sides, sides[1:], strict=False)
            return reduce(np.logical_and, [_COMPARED[type(one)](a, b) for one, a, b in pairs])
        if isinstance(node, ast.IfExp):
            return _where(of(node.test), of(node.body), of(node.orelse))
        if isinstance(node, ast.Subscript) and isinstance(node.slice, ast.Constant):
            index = int(str(node.slice.value))
            return _three(of(node.value))[..., index : index + 1]
        assert isinstance(node, ast.Call)  # as checked
        assert isinstance(node.func, ast.Name)
        given = [of(one) for one in node.args]
        known = FUNCTIONS.get(node.func.id)
        if known is not None:
            return known.compute(*given)
        function = self._functions[node.func.id]
        inside = {**constants, **dict(zip((one.arg for one in function.args.args), given, strict=True))}
        return self._body(function.body, inside, constants)


def _number(value: float) -> Value:
    try:
        return np.array([[float(value)]])
    except OverflowError:
        return np.array([[math.inf]])
