"""Texture reads and instructions per pixel of the default frame, counted in what Mesa's compiler hands to its driver.

Run as a program it draws one frame and prints, as JSON, which program shaded how many pixels (samples that passed the
depth test over those of a pixel). :func:`counts` runs it with ``ST_DEBUG=nir`` and reads the instructions of each
program from its errors' stream: scalar ones, after inlining, unrolling and removal of what is not used.

Counted are both sides of every condition; loops as often as constants say, over lights :data:`LIGHTS` times, and once
where the number is only known at the pixel: a light in which flakes glint, a flake that is found. What is only a name
for a value (a sign, a swizzle, a uniform) costs nothing; reciprocals, roots, powers, sines count :data:`SPECIAL` times,
as graphics cards work them out at a quarter of the rate.
"""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from collections.abc import Iterable
from dataclasses import replace
from typing import Any

import moderngl

from brdf_suite.documents.view_settings import Sparkle
from brdf_suite.errors import SuiteError
from brdf_suite.output.still import loaded_scene
from brdf_suite.pipeline.lobe_fit import fit_material
from brdf_suite.pipeline.material import default_paint, load_material
from brdf_suite.pipeline.scene import default_view

SIZE = (640, 360)
LIGHTS = Sparkle().light_count
SPECIAL = 4
FILTERED = 4
"""A filtered read counts as so many of the rate that makers give: two mip levels, and texels of 8 bytes in two goes."""

_SPECIALS = {
    "frcp",
    "frsq",
    "fsqrt",
    "fexp2",
    "flog2",
    "fsin",
    "fcos",
    "fdiv",
    "fpow",
    "umod",
    "idiv",
    "udiv",
}
_FREE = {"mov", "load_const", "undefined", "phi", "deref_var", "deref_array", "fneg", "fabs", "ineg", "iabs"}
_FREE_INTRINSICS = {"load_ubo", "load_uniform", "load_deref", "store_deref", "store_output", "decl_reg"}
_LINE = re.compile(r"^\s*(?:(?:con|div)\s+)?(?:vec(\d+)\s+)?\d+(?:x(\d+))?\s+(?:ssa_|%)(\d+)\s*=\s*(.*)$")
_NAME = re.compile(r"(?:ssa_|%)(\d+)")
_TEXTURE = re.compile(r"^\((?:float|int|uint)\d+\)(tex|txb|txl|txd|txf|txf_ms|tg4|txs)\b")


class Cost:
    """What a pixel costs: filtered and plain texture reads, and instructions weighed by their rate."""

    def __init__(self) -> None:
        self.filtered = self.plain = self.instructions = 0.0

    @property
    def reads(self) -> float:
        """Texture reads of either kind."""
        return self.filtered + self.plain

    def add(self, other: Cost, times: float = 1.0) -> None:
        """Add another cost so many times."""
        self.filtered += times * other.filtered
        self.plain += times * other.plain
        self.instructions += times * other.instructions


class _Scope:
    """What stands between braces: of a loop ``rounds`` is how often it runs, once that is known."""

    def __init__(self, kind: str, condition: str = "") -> None:
        self.kind, self.condition, self.cost = kind, condition, Cost()
        self.rounds: float | None = None


def cost_of(shader: Iterable[str]) -> Cost:
    """Return what one run of a shader costs, from the lines that Mesa prints of it (NIR)."""
    made: dict[str, str] = {}
    scopes = [_Scope("shader")]
    for line in shader:
        words = line.split()
        if not words:
            continue
        if words[0] in ("impl", "loop", "if", "}"):
            if words[0] == "}":
                closed = scopes.pop()
                scopes[-1].cost.add(closed.cost, (closed.rounds or 1.0) if closed.kind == "loop" else 1.0)
            if words[0] != "}" or words[1:2] == ["else"]:
                condition = _NAME.search(line)
                kind = "if" if words[0] == "}" else words[0]
                scopes.append(_Scope(kind, condition.group(1) if condition else ""))
            continue
        if words[0] == "break" and scopes[-2].kind == "loop" and scopes[-2].rounds is None:
            scopes[-2].rounds = _rounds(scopes[-1].condition, made)
        found = _LINE.match(line)
        if found:
            made[found.group(3)] = found.group(4)
            _count(found.group(4), int(found.group(1) or found.group(2) or 1), scopes[-1].cost)
    return scopes[0].cost


def _count(instruction: str, components: int, cost: Cost) -> None:
    texture = _TEXTURE.match(instruction)
    word = instruction.split()[0]
    if texture:
        cost.plain += texture.group(1) in ("txf", "txf_ms")
        cost.filtered += texture.group(1) not in ("txf", "txf_ms", "txs")
        cost.instructions += 1
    elif word == "intrinsic":
        name = instruction.split()[1].strip("@")
        cost.instructions += 0 if name in _FREE_INTRINSICS else components
    elif word not in _FREE and not word.startswith("vec"):
        cost.instructions += components * (SPECIAL if word in _SPECIALS else 1)


def _rounds(condition: str, made: dict[str, str]) -> float:
    """Return how often a loop runs that ends by a comparison."""
    for name in _NAME.findall(made.get(condition, "")):
        limit = made.get(name, "")
        # Of a choice, as of 4 places or none, the largest number.
        chosen = _NAME.findall(limit)[1:] if limit.startswith("b32csel") else [name]
        constants = [re.match(r"load_const \((0x[0-9a-f]+)", made.get(number, "")) for number in chosen]
        if all(constants):
            return float(max(1, *(int(found.group(1), 16) for found in constants if found)))
        source = _NAME.search(limit)
        if limit.startswith("f2i32") and source and "load_ubo" in made.get(source.group(1), ""):
            return float(LIGHTS)
    return 1.0


def programs(printed: str) -> dict[int, Cost]:
    """Return the costs of the fragment shaders that Mesa printed, by the numbers of their programs."""
    found: dict[int, Cost] = {}
    for text in printed.split("NIR before handing off to driver:")[1:]:
        name = re.search(r"^name: GLSL(\d+)$", text, re.MULTILINE)
        if name and "shader: MESA_SHADER_FRAGMENT" in text:
            found[int(name.group(1))] = cost_of(text.splitlines())
    return found


def counts() -> tuple[Cost, Cost, float]:
    """Return the mean cost of the default frame's pixels, that of one of the paint, and the samples drawn per pixel.

    Raises :class:`SuiteError`: the driver prints no instructions, as others than Mesa's do.
    """
    environment = os.environ | {"ST_DEBUG": "nir", "MESA_SHADER_CACHE_DISABLE": "1"}
    done = subprocess.run(
        [sys.executable, __file__], capture_output=True, text=True, env=environment, check=True
    )
    each = programs(done.stderr)
    if not each:
        raise SuiteError("this driver does not print its instructions")
    frame, paint, samples = Cost(), Cost(), 0.0
    for draw in json.loads(done.stdout):
        cost = each[draw["program"]]
        frame.add(cost, draw["pixels"] / (SIZE[0] * SIZE[1]))
        if draw["paint"]:
            paint = cost
        if draw["samples"] > 1:
            samples += draw["pixels"] * draw["samples"] / (SIZE[0] * SIZE[1])
    return frame, paint, samples


def _draw() -> list[dict[str, Any]]:
    """Draw the default frame of the car; return of each draw its program, pixels, samples, whether it is the paint."""
    drawn: list[dict[str, Any]] = []
    render = moderngl.VertexArray.render
    view = replace(default_view(), surface="car")
    with loaded_scene(view) as loaded:
        scene = loaded.scene
        context = scene.renderer.context
        scene.set_material(fit_material(load_material(default_paint().name)))
        shown, target = loaded.composed(view, SIZE), context.simple_framebuffer(SIZE)
        query = context.query(samples=True)

        def counted(self: moderngl.VertexArray, *options: Any, **more: Any) -> None:
            with query:
                render(self, *options, **more)
            samples = max(1, context.fbo.samples)
            pixels = query.samples / samples
            paint = "flake_mosaic" in self.program
            drawn.append({"program": self.program.glo, "pixels": pixels, "samples": samples, "paint": paint})

        scene.draw(shown, target, SIZE)
        moderngl.VertexArray.render = counted  # type: ignore[method-assign]
        scene.draw(shown, target, SIZE)
        context.finish()
    return drawn


if __name__ == "__main__":
    print(json.dumps(_draw()))
