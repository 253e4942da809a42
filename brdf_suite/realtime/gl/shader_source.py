"""Shader files: assembled from includes, compiled, with errors reported by file and line.

A line ``#include "name.glsl"`` is replaced by that file, once per shader. Each file has a number, and
``#line`` gives the compiler lines as 10,000 times that number plus the line in the file, so that its complaints
can be traced. (The directive's own file number is lost by some compilers, Mesa among them.)
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import moderngl

from brdf_suite.errors import GraphicsError

SHADERS = Path(__file__).resolve().parents[1] / "shaders"

_LINES_PER_FILE = 10_000

_INCLUDE = re.compile(r'^\s*#include\s+"([\w.\-]+)"\s*$')
# Mesa "1:23(4): error: ...", NVIDIA "1(23) : error C1008: ...", Intel, AMD and Apple "ERROR: 1:23: ...".
COMPILER_REPORTS = (
    re.compile(r"^\d+:(?P<line>\d+)\(\d+\): (?:preprocessor )?error: (?P<what>.*)$"),
    re.compile(r"^\d+\((?P<line>\d+)\) : error (?P<what>.*)$"),
    re.compile(r"^ERROR: \d+:(?P<line>\d+): (?P<what>.*)$"),
)
"""What lines of compilers' messages look like that name a line of the source."""


@dataclass(frozen=True)
class ShaderSource:
    """Preprocessed shader text, and the file names behind its line numbers."""

    text: str
    files: tuple[str, ...]


def compose(
    name: str, defines: dict[str, str] | None = None, folders: tuple[Path, ...] = (SHADERS,)
) -> ShaderSource:
    """Return shader file ``name`` with its includes and ``#define`` lines; ``folders`` are searched in order.

    Raises
    ------
    GraphicsError
        A file is missing; the message names it and the file and line that asks for it.
    """
    files: list[str] = []
    lines = ["#version 330 core", *(f"#define {key} {value}" for key, value in (defines or {}).items())]

    def add(name: str, asked_by: str) -> None:
        if name in files:
            return
        pieces = next((found for folder in folders if (found := _pieces(folder, name)) is not None), None)
        if pieces is None:
            raise GraphicsError(f"The shader file {name} is missing{asked_by}; install brdf-suite again.")
        start = len(files) * _LINES_PER_FILE
        files.append(name)
        row = 0
        for text, included in pieces:
            lines.append(f"#line {start + row + 1}")
            lines.extend(text)
            row += len(text) + 1
            if included:
                add(included, f", asked for by {name}, line {row}")

    add(name, "")
    return ShaderSource("\n".join(lines) + "\n", tuple(files))


_Pieces = tuple[tuple[tuple[str, ...], str], ...]
"""Lines, and the file that is included after them, empty after the last ones."""


def _pieces(folder: Path, name: str) -> _Pieces | None:
    """Return a file's pieces; None where there is none. A user's shader is read anew, since it may be edited."""
    return _shipped_pieces(name) if folder == SHADERS else _read_pieces(folder / name)


@cache
def _shipped_pieces(name: str) -> _Pieces | None:
    return _read_pieces(SHADERS / name)


def _read_pieces(path: Path) -> _Pieces | None:
    if not path.is_file():
        return None
    pieces: list[tuple[tuple[str, ...], str]] = []
    lines: list[str] = []
    # Compilers of OpenGL 3.3 read ASCII only.
    for line in path.read_text(encoding="utf-8").encode("ascii", "replace").decode("ascii").splitlines():
        include = _INCLUDE.match(line)
        if include:
            pieces.append((tuple(lines), include.group(1)))
            lines = []
        else:
            lines.append(line)
    return (*pieces, (tuple(lines), ""))


def look_up_defines(broad: int, sharp: int) -> dict[str, str]:
    """Return the defines of the numbers of look-ups, and the loop over sharp lobes written out.

    >>> look_up_defines(4, 2)["FOR_EACH_SHARP_LOBE(BODY)"]
    'BODY(0) BODY(1)'
    """
    return {
        "BROAD": str(broad),
        "SHARP": str(sharp),
        "FOR_EACH_SHARP_LOBE(BODY)": " ".join(f"BODY({i})" for i in range(sharp)),
    }


def compile_program(
    context: moderngl.Context, vertex: ShaderSource, fragment: ShaderSource
) -> moderngl.Program:
    """Compile and link; :class:`GraphicsError` names shader file, line and the compiler's words."""
    try:
        return context.program(vertex_shader=vertex.text, fragment_shader=fragment.text)
    except moderngl.Error as error:
        message = str(error)
        source = vertex if "vertex_shader" in message else fragment
        raise GraphicsError(
            _explain(message, source, f"{vertex.files[0]} with {fragment.files[0]}")
        ) from error


def _explain(message: str, source: ShaderSource, pair: str) -> str:
    for line in message.splitlines():
        for report in COMPILER_REPORTS:
            found = report.match(line.strip())
            if found and int(found["line"]) < len(source.files) * _LINES_PER_FILE:
                number, row = divmod(int(found["line"]), _LINES_PER_FILE)
                return f"The shader {source.files[number]}, line {row}, does not compile: {found['what'].strip()}."
    words = "; ".join(line.strip() for line in message.splitlines() if line.strip(" ="))
    return f"The shaders {pair} do not compile or link: {words}."
