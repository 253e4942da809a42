"""The child process that computes models written in GLSL: a program over arrays of directions.

Requests and answers as :mod:`brdf_suite.reflectance.live.shader` describes them, on standard input and output. The
first request is empty and answered once there is a context. On POSIX systems the process ends itself by an alarm when
a request takes longer than :data:`LONGEST_S`, also where its parent has gone.
"""

from __future__ import annotations

import contextlib
import importlib
import json
import os
import sys
from collections import OrderedDict
from typing import IO, Any

import moderngl
import numpy as np
from numpy.typing import NDArray

from brdf_suite.errors import GraphicsError
from brdf_suite.realtime.gl.context import create_context
from brdf_suite.realtime.gl.shader_source import COMPILER_REPORTS, compose

LONGEST_S = 60
_MEMORY = 4 << 30
_ROW = 256
_KEPT = 8

_TYPES = {"float": "float", "bool": "bool", "color": "vec3"}


class Shaders:
    """Compiled models of one context, the last few of them kept."""

    def __init__(self, context: moderngl.Context) -> None:
        self._context = context
        self._programs: OrderedDict[str, moderngl.Program] = OrderedDict()
        self._vertex = compose("screen.vert.glsl").text
        head, _, tail = compose("model_text.frag.glsl").text.partition("\nMODEL\n")
        self._around = f"{head}\n", tail

    def compute(self, request: dict[str, Any], pairs: NDArray[np.float32]) -> NDArray[np.float32]:
        """Return f_r (n, 3) of directions (n, 6); :class:`moderngl.Error` with the driver's words."""
        program = self._program(request)
        for name, kind, numbers in request["uniforms"]:
            uniform = program.get(name, None)
            if isinstance(uniform, moderngl.Uniform):
                uniform.value = (
                    tuple(numbers) if kind == "color" else numbers[0] if kind == "float" else bool(numbers[0])
                )
        count = len(pairs)
        rows = -(-count // _ROW)
        filled = np.zeros((rows * _ROW, 6), np.float32)
        filled[:count] = pairs
        filled[count:, (2, 5)] = 1.0
        made: list[Any] = []
        try:
            for unit, name in enumerate(("brdf_suite_light", "brdf_suite_view")):
                side = np.ascontiguousarray(filled[:, 3 * unit : 3 * unit + 3])
                texture = self._context.texture((_ROW, rows), 3, side.tobytes(), dtype="f4")
                texture.filter = (moderngl.NEAREST, moderngl.NEAREST)
                made.append(texture)
                texture.use(unit)
                sampler = program.get(name, None)
                if isinstance(sampler, moderngl.Uniform):
                    sampler.value = unit
            target = self._context.texture((_ROW, rows), 4, dtype="f4")
            made.append(target)
            framebuffer = self._context.framebuffer([target])
            made.append(framebuffer)
            vertices = self._context.vertex_array(program, [])
            made.append(vertices)
            framebuffer.use()
            self._context.viewport = (0, 0, _ROW, rows)
            vertices.render(moderngl.TRIANGLES, 3)
            found = np.frombuffer(framebuffer.read(components=4, dtype="f4"), np.float32)
        finally:
            for one in reversed(made):
                one.release()
        return np.ascontiguousarray(found.reshape(-1, 4)[:count, :3])

    def _program(self, request: dict[str, Any]) -> moderngl.Program:
        uniforms = "".join(f"uniform {_TYPES[kind]} {name};\n" for name, kind, _ in request["uniforms"])
        model = f"{uniforms}#line {int(request['line'])}\n{request['shader']}\n"
        head, tail = self._around
        text = f"{head}{model}{tail}"
        # Compilers of OpenGL 3.3 read ASCII only.
        text = text.encode("ascii", "replace").decode("ascii")
        program = self._programs.pop(text, None)
        if program is None:
            program = self._context.program(vertex_shader=self._vertex, fragment_shader=text)
        self._programs[text] = program
        while len(self._programs) > _KEPT:
            self._programs.popitem(last=False)[1].release()
        return program


def explain(message: str, last_line: int) -> dict[str, Any]:
    """Return the answer for a text that does not compile: the compiler's words, and the line where it names one."""
    for line in message.splitlines():
        for report in COMPILER_REPORTS:
            found = report.match(line.strip())
            if found is not None:
                row = int(found["line"])
                return {"error": found["what"].strip().rstrip("."), "line": min(row, last_line)}
    words = "; ".join(line.strip() for line in message.splitlines() if line.strip(" ="))
    return {"error": words or "the driver gives no reason"}


def main() -> int:
    """Answer requests until standard input ends."""
    if "--help" in sys.argv[1:]:
        print(__doc__, flush=True)
        return 0
    _limit_memory()
    # What a driver prints is no answer.
    answers = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)
    requests = sys.stdin.buffer
    shaders: Shaders | None = None
    while True:
        line = requests.readline()
        if not line:
            return 0
        _alarm(LONGEST_S)
        request = json.loads(line)
        try:
            if shaders is None:
                shaders = Shaders(create_context())
            if not request:
                _answer(answers, {})
                continue
            pairs = np.frombuffer(requests.read(24 * request["pairs"]), "<f4").reshape(-1, 6)
            found = shaders.compute(request, pairs)
        except GraphicsError as error:
            _answer(answers, {"error": str(error)})
        except moderngl.Error as error:
            last = int(request["line"]) + str(request["shader"]).count("\n")
            _answer(answers, explain(str(error), last))
        else:
            _answer(answers, {}, found.astype("<f4").tobytes())
        finally:
            _alarm(0)


def _answer(stream: IO[bytes], header: dict[str, Any], content: bytes = b"") -> None:
    stream.write(json.dumps(header).encode() + b"\n" + content)
    stream.flush()


def _limit_memory() -> None:
    """Limit the memory that a compiler may fill, where the system can; address space that is only reserved is free."""
    with contextlib.suppress(ImportError):  # Windows has none
        resource = importlib.import_module("resource")
        for what, most in ((resource.RLIMIT_DATA, _MEMORY), (resource.RLIMIT_CORE, 0)):
            with contextlib.suppress(ValueError, OSError):
                resource.setrlimit(what, (most, most))


def _alarm(seconds: int) -> None:
    """End this process in so many seconds, 0 for never; the driver need not let Python run for it."""
    if os.name == "posix":
        importlib.import_module("signal").alarm(seconds)


if __name__ == "__main__":
    status = main()
    # Without the driver's destructors, which may hang.
    sys.stdout.flush()
    os._exit(status)
