"""Find the texts of the core that a window can show: errors, notices, losses, words of progress, names, meanings.

They are literals and f-strings. An f-string gives a template, in which the values are numbered places
(``"{0}: no such column {1}"``); a choice between literals within it gives a template for each of them. The windows
find the template of a finished text again (``brdf_qt.program.core_texts``).
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterable, Iterator, Sequence
from itertools import product
from pathlib import Path

UNSEEN = (
    "batches",
    "cli",
    "command_parser.py",
    "library",
    "notebook.py",
    "testing.py",
    "variables.py",
    "tracing/agreement",
    "files/tables/columns.py",
)
"""Parts of the core whose texts no window shows: those of the command, of notebooks, of checks of plug-ins."""
DOCUMENTS = ("reports/paint_report", "reports/contact_sheet", "reports/pdf_pen.py", "reports/sheet_text.py")
"""Texts of documents for others, which are English; errors and progress of their making are shown."""
_FAULTS = (
    "ArgumentTypeError AssertionError AttributeError IndexError KeyError NotImplementedError RuntimeError TypeError "
    "ValueError"
)
_PLUMBING = (
    "add_argument add_arguments Call cast child_command compile debug endswith error exception execute "
    "executescript find fullmatch get getLogger index info Literal match namedtuple partition print removeprefix "
    "removesuffix replace search split startswith strptime Struct sub TypeVar warn warning while_loop"
)
_NOT_SHOWN = {*_FAULTS.split(), *_PLUMBING.split()}
"""Calls that take no text for a user of a window; a ``Call`` says to the author of a plug-in what it has to return."""
_SENTENCES = {
    *(
        "AcquisitionError",
        "FittingError",
        "GraphicsError",
        "SuiteError",
        "UnreachableError",
        "note",
        "report",
    ),
    *("stage", "Parameter", "RefinedParameter", "ModelEntry"),
}
"""Calls whose literals are shown also where they are single words."""
_SHOWN = _SENTENCES | {
    "DocumentError",
    "FileError",
    "ExportFormat",
    "ReferenceUnavailableError",
    "ValueRangeError",
    "fail",
}
"""Calls that take texts for a user."""
_LOSSES = "losses"
"""Functions that return what a format does not hold."""
_FORMAT_PLACE = re.compile(r"\{[^{}]*\}")
_PLURAL = re.compile(r"\[([^\[\]|]*)\|([^\[\]|]*)\]")
_CODE = re.compile(
    r"[<>{}=\\@]|^#|;$|^\s|^--|^brdf-suite |\w\(|^[A-Z_]+$|://|\n|\t|^(SELECT|DELETE|INSERT|CREATE)\b"
)
_FIELD = re.compile(r"[\0\w]*([.\[][\0\w*\]]+)+(\.\w+)*")
"""The name of a field or of a file, as ``measurements[1].lab``."""
_MOST = 24
_PLACE = object()
_Pieces = tuple[object, ...]


def core_texts(core: Path, programs: Iterable[Path] = ()) -> list[str]:
    """Return the texts and templates of the modules below ``core``, each once, in the order of the files.

    Of ``programs``, the packages of the windows, those of errors and progress that are raised or reported without
    :func:`tr`, as the core does.
    """
    found: dict[str, None] = {}
    for path in sorted(core.rglob("*.py")):
        part = path.relative_to(core).as_posix()
        if not _is_in(part, UNSEEN):
            found |= dict.fromkeys(_texts(path, only_shown=_is_in(part, DOCUMENTS)))
    for program in programs:
        for path in sorted(program.rglob("*.py")):
            found |= dict.fromkeys(_texts(path, only_shown=True))
    return list(found)


def _is_in(part: str, parts: Sequence[str]) -> bool:
    return any(part == one or part.startswith(f"{one}/") for one in parts)


def _texts(path: Path, *, only_shown: bool) -> Iterator[str]:
    tree = ast.parse(path.read_text(encoding="utf-8"))
    waiting: list[tuple[ast.AST, str]] = [(tree, "")]
    while waiting:
        node, call = waiting.pop()
        if _is_text(node):
            assert isinstance(node, ast.expr)
            if call in _SHOWN or call == _LOSSES or not only_shown:
                yield from _templates(node, single=call in _SENTENCES)
            waiting += [(inner, call) for inner in _inner(node)]
            continue
        waiting += reversed([(child, _call_of(child, call)) for child in _children(node)])


def _children(node: ast.AST) -> Iterable[ast.AST]:
    """Return what can hold a text: no docstrings, annotations, keys, indices, comparisons."""
    if isinstance(node, ast.Call):
        name = _name(node.func)
        if name in _NOT_SHOWN or name in ("tr", "mark"):
            return ()
        return [node.func, *node.args, *(one.value for one in node.keywords)]
    if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant):
        return ()
    if isinstance(node, ast.Dict):
        return node.values
    if isinstance(node, ast.Compare | ast.Subscript | ast.MatchValue):
        return ()
    if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
        return [*node.body, *node.args.defaults, *filter(None, node.args.kw_defaults)]
    if isinstance(node, ast.AnnAssign):
        return () if node.value is None else (node.value,)
    return ast.iter_child_nodes(node)


def _call_of(node: ast.AST, outer: str) -> str:
    if isinstance(node, ast.Call):
        name = _name(node.func)
        return outer if outer in {*_SHOWN, _LOSSES} and name not in _SHOWN else name
    if isinstance(node, ast.FunctionDef) and node.name.endswith(_LOSSES):
        return _LOSSES
    return outer if outer == _LOSSES or not isinstance(node, ast.stmt) else ""


def _name(function: ast.expr) -> str:
    if isinstance(function, ast.Attribute):
        return function.attr
    return function.id if isinstance(function, ast.Name) else ""


def _is_text(node: ast.AST) -> bool:
    """Whether an expression is a text by its form."""
    if isinstance(node, ast.Constant):
        return isinstance(node.value, str)
    if isinstance(node, ast.JoinedStr):
        return True
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add):
        return _is_text(node.left) or _is_text(node.right)
    if isinstance(node, ast.Call):
        function = node.func
        return isinstance(function, ast.Attribute) and function.attr == "format" and _is_text(function.value)
    return False


def _inner(node: ast.AST) -> list[ast.AST]:
    """Return the expressions in the places of a text."""
    if isinstance(node, ast.JoinedStr):
        return [one.value for one in node.values if isinstance(one, ast.FormattedValue)]
    if isinstance(node, ast.BinOp):
        return [
            inner for one in (node.left, node.right) for inner in (_inner(one) if _is_text(one) else [one])
        ]
    if isinstance(node, ast.Call):
        return [*node.args, *(one.value for one in node.keywords)]
    return []


def _variants(node: ast.expr) -> list[_Pieces]:
    """Return the texts that an expression can be, as literals and places."""
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        return [(node.value,)]
    if isinstance(node, ast.JoinedStr):
        return _joined([_variants(one) for one in node.values])
    if isinstance(node, ast.FormattedValue):
        return _variants(node.value)
    if isinstance(node, ast.BinOp) and _is_text(node):
        return _joined([_variants(node.left), _variants(node.right)])
    if isinstance(node, ast.IfExp):
        return [*_variants(node.body), *_variants(node.orelse)]
    if isinstance(node, ast.Call) and _is_text(node):
        assert isinstance(node.func, ast.Attribute)
        found = []
        for pieces in _variants(node.func.value):
            text = "".join(one for one in pieces if isinstance(one, str))
            parts = _FORMAT_PLACE.split(text)
            found.append(tuple(one for part in parts for one in (part, _PLACE))[:-1])
        return found
    return [(_PLACE,)]


def _joined(parts: list[list[_Pieces]]) -> list[_Pieces]:
    count = 1
    for part in parts:
        count *= len(part)
    if count > _MOST:
        parts = [part if len(part) == 1 else [(_PLACE,)] for part in parts]
    return [tuple(one for pieces in chosen for one in pieces) for chosen in product(*parts)]


def _templates(node: ast.expr, *, single: bool) -> Iterator[str]:
    for pieces in _variants(node):
        literal = "".join(one if isinstance(one, str) else "\0" for one in pieces).replace("{n}", "\0")
        literal = re.sub(r"\b(byte|line|field) \d+$", r"\1 \0", literal)
        for text in _numbers(literal):
            bare = _PLURAL.sub("", text.replace("\0", " "))
            words = re.findall(r"[^\W\d_]{2,}", bare)
            if " " not in text and "_" in text:
                continue
            if not words or _CODE.search(text.replace("\0", "x").strip()) or _FIELD.fullmatch(text):
                continue
            if not single and not any(word.islower() for word in words):
                continue
            if single or " " in text.strip():
                first, *others = text.split("\0")
                yield "".join([first, *(f"{{{n}}}{part}" for n, part in enumerate(others))]).strip()


def _numbers(text: str) -> list[str]:
    """Return a text for one and for several where it names both: ``{n} colour[|s]``."""
    if not _PLURAL.search(text):
        return [text]
    return [_PLURAL.sub(lambda found, form=form: found[form], text) for form in (1, 2)]
