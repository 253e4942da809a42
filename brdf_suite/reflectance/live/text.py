"""The text of a model: its language, its declared parameters, and the place of the formulas in it.

GLSL, as the BRDF Explorer of Walt Disney Animation Studios reads it::

    analytic
    ::begin parameters
    color tint .8 .2 .1
    float width .01 1 .3
    bool coated 1
    ::end parameters
    ::begin shader
    vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) { … }
    ::end shader

A ``float`` has its minimum, maximum and default, a ``color`` three channels from 0 to 1, a ``bool`` 0 or 1; ``#``
begins a comment outside of the shader.

Python's notation::

    def brdf(L, V, N, X, Y, tint=color(0.8, 0.2, 0.1), width=number(0.01, 1, 0.3), coated=switch(1)):
        …
        return …

Such a text is not run: :mod:`brdf_suite.reflectance.live.formulas` computes it.
"""

from __future__ import annotations

import ast
import math
import re
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Literal

from brdf_suite.documents.parameter import Parameter
from brdf_suite.errors import SuiteError

Language = Literal["glsl", "python"]
Kind = Literal["float", "bool", "color"]

LARGEST = 128 << 10
"""Characters of a text."""
MOST_PARAMETERS = 64
CHANNELS = ("r", "g", "b")
DIRECTIONS = ("L", "V", "N", "X", "Y")
"""Light, view, normal and the two tangents, as the function takes them."""

_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]{0,63}")
_BRDF = re.compile(r"\bvec3\s+BRDF\s*\(")
_PYTHON = re.compile(r"^def[ \t]+brdf[ \t]*\(", re.MULTILINE)
_GLSL = re.compile(r"^::begin[ \t]+shader[ \t]*$", re.MULTILINE)
_COUNTS: dict[Kind, int] = {"float": 3, "bool": 1, "color": 3}
_CALLS: dict[str, Kind] = {"number": "float", "switch": "bool", "color": "color"}
_SHAPES: dict[Kind, str] = {
    "float": "minimum, maximum and default",
    "bool": "0 or 1",
    "color": "three numbers from 0 to 1",
}


class ModelTextError(SuiteError):
    """A text that is no model; ``line`` counts from 1, None where no line is to blame."""

    def __init__(self, reason: str, line: int | None = None) -> None:
        self.reason = reason
        self.line = line
        super().__init__(f"Line {line}: {reason}." if line else f"{reason[:1].upper()}{reason[1:]}.")


@dataclass(frozen=True)
class Declared:
    """A declared parameter: of a float minimum, maximum and default, of others the default of each number."""

    name: str
    kind: Kind
    given: tuple[float, ...]

    def numbers(self) -> dict[str, Parameter]:
        """Return the numbers that it consists of, by key: three for a colour, ``tint.r`` … ``tint.b``."""
        if self.kind == "float":
            low, high, default = self.given
            return {self.name: Parameter(self.name, "", low, high, default, "")}
        if self.kind == "bool":
            return {self.name: Parameter(self.name, "", 0.0, 1.0, self.given[0], "")}
        return {
            f"{self.name}.{letter}": Parameter(self.name, "", 0.0, 1.0, default, "")
            for letter, default in zip(CHANNELS, self.given, strict=True)
        }


@dataclass(frozen=True)
class ModelText:
    """A model's text, read: ``shader`` is the GLSL between its marks, which begins at ``first_line`` of the text."""

    text: str
    language: Language
    declared: tuple[Declared, ...]
    shader: str = ""
    first_line: int = 1

    @cached_property
    def defaults(self) -> dict[str, float]:
        """The default of each number, by key."""
        return {key: one.default for declared in self.declared for key, one in declared.numbers().items()}


def language_of(text: str) -> Language | None:
    """Return which language a text is a model in, by its content; None where it is none.

    >>> language_of("def brdf(L, V, N, X, Y):\\n    return 1 / pi"), language_of("1 2 3")
    ('python', None)
    """
    if _GLSL.search(text) or text.split("\n", 1)[0].strip() == "analytic":
        return "glsl"
    return "python" if _PYTHON.search(text) else None


def read_model_text(text: str) -> ModelText:
    """Return the model of a text; its formulas are checked when they are first computed.

    Raises :class:`ModelTextError`: it is no model, or a declaration is wrong.
    """
    if len(text) > LARGEST:
        raise ModelTextError(f"the text has {len(text):,} characters, more than the {LARGEST:,} allowed")
    if "\0" in text:
        raise ModelTextError("the text has a null character", text[: text.index("\0")].count("\n") + 1)
    text = text.removeprefix("\ufeff").replace("\r\n", "\n").replace("\r", "\n")
    language = language_of(text)
    if language is None:
        raise ModelTextError(
            "a model has “::begin shader” (GLSL) or “def brdf(” (Python’s notation) at the start of a line"
        )
    return _read_glsl(text) if language == "glsl" else _read_python(text)


def _read_glsl(text: str) -> ModelText:
    sections: dict[str, tuple[int, list[str]]] = {}
    inside = ""
    for number, line in enumerate(text.split("\n"), 1):
        words = line.split()
        if words[:1] == ["::begin"]:
            if inside or len(words) != 2 or words[1] in sections:
                raise ModelTextError("expected “::begin parameters” or “::begin shader”, each once", number)
            if words[1] not in ("parameters", "shader"):
                raise ModelTextError(f"there is no section {words[1][:40]!r}", number)
            inside = words[1]
            sections[inside] = (number + 1, [])
        elif words[:1] == ["::end"]:
            if not inside or words[1:] != [inside]:
                raise ModelTextError(f"expected “::end {inside}”" if inside else "nothing has begun", number)
            inside = ""
        elif inside:
            sections[inside][1].append(line)
        elif words and words != ["analytic"] and not words[0].startswith("#"):
            raise ModelTextError(f"{line.strip()[:40]!r} stands in no section", number)
    if inside:
        raise ModelTextError(f"“::end {inside}” is missing", text.count("\n") + 1)
    first, shader = sections.get("shader", (1, []))
    code = "\n".join(shader)
    if not _BRDF.search(code):
        raise ModelTextError(
            "the shader has no function vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y)", first
        )
    start, lines = sections.get("parameters", (1, []))
    declared: list[Declared] = []
    for number, line in enumerate(lines, start):
        words = line.split("#", 1)[0].split()
        if not words:
            continue
        kind = next((known for known in _COUNTS if known == words[0]), None)
        if kind is None or len(words) != 2 + _COUNTS[kind]:
            shapes = "; ".join(f"{known} NAME with {shape}" for known, shape in _SHAPES.items())
            raise ModelTextError(f"expected one of: {shapes}", number)
        numbers = []
        for word in words[2:]:
            try:
                numbers.append(float(word))
            except ValueError:
                raise ModelTextError(f"expected a number, not {word[:40]!r}", number) from None
        declared.append(_declared(words[1], kind, numbers, declared, number))
    return ModelText(text, "glsl", tuple(declared), code, first)


def _declared(name: str, kind: Kind, numbers: list[float], before: list[Declared], line: int) -> Declared:
    if not _NAME.fullmatch(name) or name.startswith(("gl_", "brdf_suite")) or name in DIRECTIONS:
        raise ModelTextError(f"{name[:40]!r} cannot be the name of a parameter", line)
    if any(one.name == name for one in before):
        raise ModelTextError(f"the parameter {name} is declared twice", line)
    if len(before) == MOST_PARAMETERS:
        raise ModelTextError(f"more than {MOST_PARAMETERS} parameters", line)
    right = len(numbers) == _COUNTS[kind] and all(math.isfinite(one) and abs(one) < 1e30 for one in numbers)
    if right and kind == "float":
        low, high, default = numbers
        right = low < high and low <= default <= high
    elif right:
        right = all(0.0 <= one <= 1.0 for one in numbers) and (kind == "color" or numbers[0] in (0.0, 1.0))
    if not right:
        raise ModelTextError(f"the parameter {name} needs {_SHAPES[kind]}", line)
    return Declared(name, kind, tuple(numbers))


def _shortest(value: float, number: Parameter) -> str:
    """Return a number in six digits, in all of them where six are outside of the parameter's range."""
    short = f"{value:.6g}"
    return short if number.low <= float(short) <= number.high else repr(value)


def write_defaults(model: ModelText, values: Mapping[str, float]) -> str:
    """Return the text with these values as the defaults of its parameters; all else stays as it is.

    >>> model = read_model_text("def brdf(L, V, N, X, Y, a=number(0, 1, 0.5)):\\n    return a / pi")
    >>> write_defaults(model, {"a": 0.25}).splitlines()[0]
    'def brdf(L, V, N, X, Y, a=number(0, 1, 0.25)):'
    """
    wanted = {
        one.name: [
            _shortest(values.get(key, number.default), number) for key, number in one.numbers().items()
        ]
        for one in model.declared
    }
    lines = model.text.split("\n")
    if model.language == "glsl":
        inside = False
        for place, line in enumerate(lines):
            words = line.split("#", 1)[0].split()
            inside = words == ["::begin", "parameters"] or (inside and words[:1] != ["::end"])
            if inside and len(words) > 2 and words[1] in wanted:
                kept = words[:4] if words[0] == "float" else words[:2]
                comment = "  #" + line.split("#", 1)[1] if "#" in line else ""
                lines[place] = " ".join((*kept, *wanted[words[1]])) + comment
        return "\n".join(lines)
    (function,) = (
        node
        for node in parse_python(model.text).body
        if isinstance(node, ast.FunctionDef) and node.name == "brdf"
    )
    names = [one.arg for one in function.args.args[len(DIRECTIONS) :]]
    calls = [(name, node) for name, node in zip(names, function.args.defaults, strict=True)]
    for name, call in reversed(calls):  # the last first, so that the places of the others stay
        assert isinstance(call, ast.Call)  # as read
        numbers = wanted[name]
        changed = call.args[-1:] if call.args and len(numbers) == 1 else call.args
        for node, number in reversed(list(zip(changed, numbers, strict=True))):
            raw = lines[node.lineno - 1].encode()
            lines[node.lineno - 1] = (
                raw[: node.col_offset] + number.encode() + raw[node.end_col_offset :]
            ).decode()
    return "\n".join(lines)


def parse_python(text: str) -> ast.Module:
    """Return the parsed text; :class:`ModelTextError` with the line where Python's notation does not allow it."""
    try:
        return ast.parse(text)
    except SyntaxError as error:
        raise ModelTextError(f"{error.msg}", error.lineno) from None
    except (RecursionError, MemoryError, ValueError) as error:
        raise ModelTextError(f"the formulas are nested too deeply ({type(error).__name__})") from None


def _read_python(text: str) -> ModelText:
    tree = parse_python(text)
    functions = [node for node in tree.body if isinstance(node, ast.FunctionDef) and node.name == "brdf"]
    if len(functions) != 1:
        raise ModelTextError("expected one function brdf(L, V, N, X, Y, …)")
    function = functions[0]
    taken = function.args
    names = [one.arg for one in taken.args]
    if (
        names[: len(DIRECTIONS)] != list(DIRECTIONS)
        or taken.vararg
        or taken.kwarg
        or taken.kwonlyargs
        or taken.posonlyargs
    ):
        raise ModelTextError("brdf takes L, V, N, X, Y, and then the parameters", function.lineno)
    if len(taken.defaults) != len(names) - len(DIRECTIONS):
        raise ModelTextError("a parameter needs number(…), switch(…) or color(…)", function.lineno)
    declared: list[Declared] = []
    for one, value in zip(taken.args[len(DIRECTIONS) :], taken.defaults, strict=True):
        kind = None
        if isinstance(value, ast.Call) and isinstance(value.func, ast.Name) and not value.keywords:
            kind = _CALLS.get(value.func.id)
        if kind is None or not isinstance(value, ast.Call):
            raise ModelTextError(f"{one.arg}: expected number(…), switch(…) or color(…)", value.lineno)
        numbers = [_number(given, one.arg) for given in value.args]
        declared.append(_declared(one.arg, kind, numbers, declared, value.lineno))
    return ModelText(text, "python", tuple(declared))


def _number(node: ast.expr, name: str) -> float:
    sign = 1.0
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
        sign, node = -1.0, node.operand
    if isinstance(node, ast.Constant) and isinstance(node.value, int | float):
        try:
            return sign * float(node.value)
        except OverflowError:
            return math.inf
    raise ModelTextError(f"{name}: expected a number", node.lineno)
