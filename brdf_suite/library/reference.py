"""Documents of the suite as Markdown: their order, and the docstrings of the library as one reads them on a page."""

from __future__ import annotations

import inspect
import re
from collections.abc import Callable
from importlib import import_module
from pathlib import Path

from brdf_suite.errors import FileError

_CONTENTS = "README.md"
_WIDE = 80
_CHAPTER = re.compile(r"^## ([^:\n]+)", re.MULTILINE)
_ROW = re.compile(r"^\| \[[^]]*\]\(([^)]+\.md)\) \| (.+?) \|$", re.MULTILINE)
_TITLE = re.compile(r"^# (.+)$", re.MULTILINE)
_ROLE = re.compile(r":(?:class|func|data|attr|meth|mod|exc):`~?(?:[\w.]*\.)?(\w+)`")
_STAR = re.compile(r"(`[^`]*`)|(?<=\w)\*")
"""A star after a letter, as in L*a*b*, which would be emphasis; and code, in which it is none."""
_FIRST_EXAMPLE = re.compile(r"^>>> ", re.MULTILINE)
_EXAMPLE = re.compile(r"^>>> .*(?:\n.+)*", re.MULTILINE)
_SECTION = re.compile(r"^(\w+)\n-{3,}\n", re.MULTILINE)
_ITEM = re.compile(r"^(\S.*)\n((?: {4}.*(?:\n|\Z))+)", re.MULTILINE)
_DIRECTIVE = re.compile(r"^::: brdf_suite\.(\w+)$", re.MULTILINE)


def list_pages(root: Path) -> dict[str, list[tuple[str, str, Path]]]:
    """Return the pages by chapter, as ``README.md`` of the folder lists them: title, content and file.

    Raises :class:`FileError` where the documents were not installed.
    """
    try:
        text = (root / _CONTENTS).read_text("utf-8")
    except OSError as error:
        raise FileError(root / _CONTENTS, f"the documents cannot be read ({error})") from error
    found: dict[str, list[tuple[str, str, Path]]] = {}
    parts = _CHAPTER.split(text)[1:]
    for chapter, body in zip(parts[::2], parts[1::2], strict=True):
        pages = [(root / name, about) for name, about in _ROW.findall(body) if (root / name).is_file()]
        if pages:
            found[chapter.strip()] = [(page_title(page), about, page) for page, about in pages]
    return found


def page_title(page: Path) -> str:
    """Return the title of a page, its file's name where it has none."""
    found = _TITLE.search(page.read_text("utf-8"))
    return found.group(1).replace("`", "") if found else page.stem


def heading_anchor(heading: str) -> str:
    """Return the anchor by which links name a heading.

    >>> heading_anchor("Lights, and `lamps`")
    'lights-and-lamps'
    """
    return re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")


def normalize_docstring(text: str) -> str:
    """Return a docstring without roles of reStructuredText, and with its examples in a section of their own.

    >>> normalize_docstring("As :func:`~brdf_suite.load`; L*.\\n\\n>>> 1 + 1\\n2")
    'As `load`; L\\\\*.\\n\\nExamples\\n--------\\n>>> 1 + 1\\n2'
    """
    first = _FIRST_EXAMPLE.search(text)
    said, shown = (text, "") if first is None else (text[: first.start()], text[first.start() :])
    said = _STAR.sub(lambda match: match[1] or "\\*", _ROLE.sub(r"`\1`", said))
    return f"{said}Examples\n--------\n{shown}" if shown and "Examples\n---" not in said else said + shown


def expand_reference(page: str) -> str:
    """Return a page with each line ``::: brdf_suite.NAME`` replaced by the signature and the docstring of that name."""
    return _DIRECTIVE.sub(lambda match: _entry(match[1]), page)


def _entry(name: str) -> str:
    value = getattr(import_module("brdf_suite"), name)
    parts = [f"### {name}", *_body(name, value)]
    if inspect.isclass(value) and not issubclass(value, Exception):
        for key, member in vars(value).items():
            if not key.startswith("_") and (callable(member) or isinstance(member, property)):
                parts += [f"#### {name}.{key}", *_body(key, member)]
    return "\n\n".join(part for part in parts if part)


def _body(name: str, value: object) -> list[str]:
    """Return the signature and the parts of the docstring."""
    if isinstance(value, str):
        return [f"`{value}`"]
    parts = []
    if callable(value) and not (inspect.isclass(value) and issubclass(value, Exception)):
        parts.append(f"```python\n{name}{_signature(value)}\n```")
    before, *sections = _SECTION.split(normalize_docstring(inspect.getdoc(value) or ""))
    parts.append(before.strip())
    for title, body in zip(sections[::2], sections[1::2], strict=True):
        if title == "Examples":
            body = _EXAMPLE.sub(lambda match: f"```pycon\n{match[0]}\n```", body)
        else:
            body = _ITEM.sub(lambda match: f"- `{match[1]}`: {' '.join(match[2].split())}\n", body)
        parts += [f"**{title}**", body.strip()]
    return parts


def _signature(value: Callable[..., object]) -> str:
    """Return the signature; one that would be wide has a line for each parameter."""
    found = inspect.signature(value)
    text = str(found)
    if len(text) > _WIDE:
        lines: list[str] = []
        for parameter in found.parameters.values():
            if parameter.kind is parameter.KEYWORD_ONLY and "*" not in lines:
                lines.append("*")
            lines.append(str(parameter))
        end = text[text.rindex(")") :]
        text = "\n".join(["(", *(f"    {line}," for line in lines), end])
    return re.sub(r"(: |-> )'([^']*)'", r"\1\2", text)
