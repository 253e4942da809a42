"""GLSL of a model, computed by OpenGL in a child process.

A driver that breaks down or hangs on a text costs the child and nothing else. One child serves this process, for as
long as it lives; requests are answered one after the other. A request is a line of JSON and then the directions as
float32 (n, 6); the answer is a line of JSON and then f_r as float32 (n, 3), or an error.

What is promised: a computation that takes longer than :data:`SECONDS` ends with an error and the child with it; the
same text with the same values is refused at once then. What is not: a graphics card that a text keeps busy may stop
drawing the desktop until the driver ends its work, which drivers do after some seconds.
"""

from __future__ import annotations

import atexit
import json
import subprocess
import sys
from collections.abc import Mapping
from functools import lru_cache
from threading import Lock, Timer
from typing import IO, Any

import numpy as np

from brdf_suite.arrays import Floats, Singles
from brdf_suite.errors import GraphicsError
from brdf_suite.processes import child_command
from brdf_suite.reflectance.live.text import ModelText, ModelTextError

WORKER = "brdf_suite.realtime.model_shader"
SECONDS = 15.0
"""Of a computation of up to :data:`BATCH` pairs of directions, compilation included."""
START_SECONDS = 60.0
"""Until the child has a context of OpenGL; its first start may compile caches."""
BATCH = 1 << 16
_MOST_REFUSED = 256
_NO_WINDOW = 0x08000000


def compute_shader(model: ModelText, wi: Floats, wo: Floats, values: Mapping[str, float]) -> Floats:
    """Return what ``BRDF`` of the text returns (n, 3), for directions (n, 3) and a value for each number.

    Raises
    ------
    ModelTextError
        It does not compile; with the line.
    GraphicsError
        There is no OpenGL, the driver broke down, or it takes too long.
    """
    out = np.empty((len(wi), 3))
    for start in range(0, len(wi), BATCH):
        part = slice(start, start + BATCH)
        pairs = np.concatenate((wi[part], wo[part]), axis=1).astype("<f4")
        with np.errstate(invalid="ignore"):  # what a driver makes of 1 / 0 may be a signalling NaN
            out[part] = child_process().compute(model, pairs, values)
    return out


class ShaderProcess:
    """The child process, started at the first request."""

    def __init__(self) -> None:
        self._lock = Lock()
        self.process: subprocess.Popen[bytes] | None = None
        """The process, where one runs."""
        self._refused: dict[tuple[str, tuple[tuple[str, float], ...]], str] = {}

    def compute(self, model: ModelText, pairs: Singles, values: Mapping[str, float]) -> Singles:
        """Return f_r (n, 3) of directions (n, 6), light and view; errors as of :func:`compute_shader`."""
        key = (model.text, tuple(sorted(values.items())))
        with self._lock:
            if key in self._refused:
                raise GraphicsError(self._refused[key])
            request = {
                "shader": model.shader,
                "line": model.first_line,
                "uniforms": [
                    [one.name, one.kind, [values[number] for number in one.numbers()]]
                    for one in model.declared
                ],
                "pairs": len(pairs),
            }
            try:
                process = self._started()
                answer, content, late = _ask(process, request, pairs.tobytes(), SECONDS)
            except BaseException:  # an interrupt: an answer that is still to come belongs to no later request
                self.end()
                raise
            if answer is None:
                self.end()
                if late:
                    reason = (
                        f"The model takes longer than {SECONDS:g} s for {len(pairs):,} pairs of directions."
                    )
                else:
                    reason = "The graphics driver broke down on this model."
                if len(self._refused) < _MOST_REFUSED:
                    self._refused[key] = reason
                raise GraphicsError(reason)
        if "error" in answer:
            line = answer.get("line")
            raise ModelTextError(
                str(answer["error"])[:500], line if isinstance(line, int) and line > 0 else None
            )
        return np.frombuffer(content, "<f4").reshape(-1, 3)

    def _started(self) -> subprocess.Popen[bytes]:
        if self.process is not None and self.process.poll() is None:
            return self.process
        self.end()
        try:
            process = subprocess.Popen(  # noqa: S603 - a module of the suite
                child_command(WORKER),
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=subprocess.DEVNULL,
                creationflags=_NO_WINDOW if sys.platform == "win32" else 0,
            )
        except OSError as error:
            raise GraphicsError(
                f"No process could be started for the model ({error.strerror or error})."
            ) from error
        self.process = process
        ready, _, _ = _ask(process, {}, b"", START_SECONDS)
        if ready is None or "error" in ready:
            self.end()
            raise GraphicsError(str((ready or {}).get("error", "The process for model texts did not start.")))
        return process

    def end(self) -> None:
        """End the child, where there is one."""
        process, self.process = self.process, None
        if process is None:
            return
        process.kill()
        for stream in (process.stdin, process.stdout):
            if stream is not None:
                _close(stream)
        process.wait()


def _ask(
    process: subprocess.Popen[bytes], request: dict[str, Any], content: bytes, seconds: float
) -> tuple[dict[str, Any] | None, bytes, bool]:
    """Return the answer, None where the child has ended, its content, and whether it was ended for being late."""
    assert process.stdin is not None
    assert process.stdout is not None
    late = False

    def stop() -> None:
        nonlocal late
        late = True
        process.kill()

    timer = Timer(seconds, stop)
    timer.daemon = True
    timer.start()
    try:
        process.stdin.write(json.dumps(request).encode() + b"\n" + content)
        process.stdin.flush()
        line = process.stdout.readline()
        answer = json.loads(line) if line.endswith(b"\n") else None
        size = 12 * int(request.get("pairs", 0)) if answer is not None and "error" not in answer else 0
        found = process.stdout.read(size)
        return (answer if len(found) == size else None), found, late
    except (OSError, ValueError):  # a closed pipe; an answer that is cut off
        return None, b"", late
    finally:
        timer.cancel()


def _close(stream: IO[bytes]) -> None:
    try:
        stream.close()
    except OSError:  # what was to be flushed has no reader
        return


@lru_cache(maxsize=1)
def child_process() -> ShaderProcess:
    """Return the child of this process, which is started when it is first asked."""
    child = ShaderProcess()
    atexit.register(child.end)
    return child
