"""Frames on a graphics card, by its own timer.

The default paint in the sun with occlusion and ground, 4 samples per pixel: the car, and a ball of a million triangles.
Medians of GL timer queries while the camera turns. A software renderer has no such figures: its times are those of its
processor, which the ratios of `viewer` describe. Texture reads and instructions of the default frame are counted in
what Mesa's compiler makes of its shaders, both sides of every condition, and compared with a card's published limits.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from statistics import median
from time import perf_counter

from brdf_suite.cli.tools.bench import load_module
from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import Lamp, Sparkle
from brdf_suite.errors import SuiteError
from brdf_suite.output.still import LoadedScene, loaded_scene
from brdf_suite.pipeline.lobe_fit import LobeFit, fit_material
from brdf_suite.pipeline.material import default_paint, material_of
from brdf_suite.pipeline.picture import gl_renderer_name
from brdf_suite.progress import Progress, report, subrange
from brdf_suite.realtime.camera import orbit
from brdf_suite.realtime.gl.context import create_context, draws_in_software

_ball = load_module(Path(__file__).parent / "parts" / "ball.py")
_counts = load_module(Path(__file__).parent / "parts" / "shader_counts.py")

NAME = "gpu"
_SIZES = {"720p": (1280, 720), "1440p": (2560, 1440), "4k": (3840, 2160)}
_LAMPS = (0, 1, 8)
_MILLION = 500  # rings: four times their square triangles
_FRAMES = 60
_RATE = 3840 * 2160 * 120.0
"""Pixels a second that the default frame is designed for."""
_CARD = "GeForce RTX 4070"
_CORES, _TEXTURE_UNITS, _CLOCK, _BANDWIDTH = 5888, 184, 2.475e9, 504.2e9
"""An instruction of each core and a filtered texel of each unit a clock; bytes a second. As listed on
www.thefpsreview.com/gpu-family/nvidia-geforce-rtx-4070-gpu-family-specifications."""
_SAMPLE_BYTES, _SCREEN_BYTES = 8 + 4 + 4, 4 * 8 + 4 * 8 + 4 * 4 + 4
"""Of each sample that is drawn: its half floats, and its depth read and written. Of each pixel: its four samples read
for glare and for the screen, their depth cleared, and what is shown."""

BOUNDS: dict[str, tuple[str, float | None, str, str]] = {
    "default_4k_ms": ("<=", 8.3, "ms", "the car at 3840x2160, flakes in all light, no lamp"),
    "smooth_4k_ms": ("", None, "ms", "the same without flakes"),
    "one_lamp_4k_ms": ("", None, "ms", "the same with flakes and one lamp, its shadow standing"),
    "eight_lamps_4k_ms": ("", None, "ms", "the same with eight lamps"),
    "million_4k_ms": ("", None, "ms", "a ball of a million triangles in place of the car, no lamp"),
    "edit_ms": (
        "",
        None,
        "ms",
        "from an edit of the paint to the end of the next frame at 1280x720, by the clock",
    ),
}
_COUNTED: dict[str, tuple[str, float | None, str, str]] = {
    "frame_reads": ("", None, "", "texture reads a pixel of the default frame, mean of all its pixels"),
    "frame_instructions": ("", None, "", "instructions a pixel, likewise; slow ones by what they take"),
    "paint_reads": ("", None, "", "texture reads of a pixel of the paint, flakes glinting in one light"),
    "paint_instructions": ("", None, "", "instructions of such a pixel"),
    "reads_share": (
        "<=",
        0.5,
        "",
        f"of the texels that a {_CARD} can filter, 3840x2160 at 120 frames a second",
    ),
    "instructions_share": ("<=", 0.5, "", "of the instructions that it can carry out"),
    "bytes_share": ("<=", 0.5, "", "of what its memory can move, the samples not compressed"),
}
TIMED = tuple(BOUNDS)
BOUNDS |= _COUNTED
TABLES: dict[str, dict[str, object]] = {}
NOTES: dict[str, str] = {}


def run(progress: Progress | None = None) -> dict[str, float | None]:
    """Return the figures of :data:`BOUNDS`: times are None on a software renderer, which NOTES then name."""
    context = create_context()
    software = draws_in_software(context)
    context.release()
    found = count()
    if software:
        NOTES.update(dict.fromkeys(TIMED, f"not measured: {gl_renderer_name()} is no graphics card"))
        return dict.fromkeys(TIMED) | found
    return measure(_SIZES, _FRAMES, _MILLION, progress) | found


def count() -> dict[str, float | None]:
    """Return what the default frame asks of a card: all None where the driver does not say, which NOTES then say."""
    try:
        frame, paint, samples = _counts.counts()
    except SuiteError as error:
        NOTES.update(dict.fromkeys(_COUNTED, f"not counted: {error}"))
        return dict.fromkeys(_COUNTED)
    filtered = frame.filtered * _counts.FILTERED + frame.plain
    return {
        "frame_reads": frame.reads,
        "frame_instructions": frame.instructions,
        "paint_reads": paint.reads,
        "paint_instructions": paint.instructions,
        "reads_share": filtered * _RATE / (_TEXTURE_UNITS * _CLOCK),
        "instructions_share": frame.instructions * _RATE / (_CORES * _CLOCK),
        "bytes_share": (samples * _SAMPLE_BYTES + _SCREEN_BYTES) * _RATE / _BANDWIDTH,
    }


def measure(
    sizes: dict[str, tuple[int, int]], frames: int, rings: int, progress: Progress | None = None
) -> dict[str, float | None]:
    """Return the times, the largest of ``sizes`` last, and fill :data:`TABLES` with every case, ms."""
    view = View(
        surface="car",
        environment="sunny",
        fresnel="multi_angle",
        surface_look=replace(View().surface_look, occlusion=True, ground=True),
    )
    fits = [fit_material(material_of(paint, paint.name)) for paint in _edited()]
    table: dict[str, dict[str, float]] = {}
    with loaded_scene(view, subrange(progress, 0.0, 0.2)) as loaded:
        cases = {f"{count} lamps": replace(view, lamps=_lamps(count)) for count in _LAMPS}
        cases["without flakes"] = replace(view, sparkle=Sparkle("off"))
        for step, (name, shown) in enumerate(cases.items()):
            report(progress, 0.2 + 0.15 * step, name)
            table[name] = {
                key: _frame_ms(loaded, shown, fits[0], size, frames) for key, size in sizes.items()
            }
        edit = _edit_ms(loaded, view, fits, next(iter(sizes.values())), frames)
        report(progress, 0.85, "a million triangles")
        loaded.scene.renderer.set_mesh([_ball.ball(1.0, rings)])
        table["a million triangles"] = {
            key: _frame_ms(loaded, view, fits[0], size, frames) for key, size in sizes.items()
        }
    TABLES.clear()
    TABLES.update({name: dict(row) for name, row in table.items()})
    largest = list(sizes)[-1]
    return {
        "default_4k_ms": table["0 lamps"][largest],
        "smooth_4k_ms": table["without flakes"][largest],
        "one_lamp_4k_ms": table["1 lamps"][largest],
        "eight_lamps_4k_ms": table["8 lamps"][largest],
        "million_4k_ms": table["a million triangles"][largest],
        "edit_ms": edit,
    }


def appendix() -> str:
    """Return every case as a table, with the card's name; nothing where nothing was measured."""
    if not TABLES:
        return "No frame was timed: no graphics card was at hand.\n"
    sizes = list(next(iter(TABLES.values())))
    lines = [f"### Frames on {gl_renderer_name()}, ms", "", "| case | " + " | ".join(sizes) + " |"]
    lines.append("|---" * (1 + len(sizes)) + "|")
    lines += [
        f"| {name} | " + " | ".join(f"{row[key]:.2f}" for key in sizes) + " |" for name, row in TABLES.items()
    ]
    return "\n".join(lines) + "\n"


def _edited() -> tuple[object, object]:
    paint = default_paint()
    first = paint.measurements[0]
    return paint, paint.with_lab(first.aspecular_deg, (first.lab[0] * 0.98, *first.lab[1:]))


def _lamps(count: int) -> tuple[Lamp, ...]:
    return tuple(
        Lamp("directional", azimuth_deg=45.0 * k, elevation_deg=30.0 + 5.0 * (k % 3), strength=0.3)
        for k in range(count)
    )


def _frame_ms(loaded: LoadedScene, view: View, fit: LobeFit, size: tuple[int, int], frames: int) -> float:
    scene = loaded.scene
    scene.set_material(fit, view=view)
    shown, target = loaded.composed(view, size), scene.renderer.context.simple_framebuffer(size)
    query = scene.renderer.context.query(time=True)
    times = []
    for i in range(frames + 5):
        with query:
            scene.draw(replace(shown, camera=orbit(shown.camera, 0.5 * i, 0.0)), target, size)
        times.append(1e-6 * query.elapsed)
    target.release()
    return float(median(times[5:]))


def _edit_ms(
    loaded: LoadedScene, view: View, fits: list[LobeFit], size: tuple[int, int], frames: int
) -> float:
    scene = loaded.scene
    shown, target = loaded.composed(view, size), scene.renderer.context.simple_framebuffer(size)
    times = []
    for i in range(frames + 5):
        start = perf_counter()
        scene.set_material(fits[i % 2], view=shown)
        scene.draw(shown, target, size)
        scene.renderer.context.finish()
        times.append(1e3 * (perf_counter() - start))
    target.release()
    return float(median(times[5:]))
